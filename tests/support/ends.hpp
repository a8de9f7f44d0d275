// The nearest times that are outside a curve: those within 4 ulps of the larger end count as the end beside them.
#ifndef QTRAJ_TESTS_ENDS_HPP
#define QTRAJ_TESTS_ENDS_HPP

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace test {

inline double reach_of(double first, double last) {
  const double larger = std::max(std::abs(first), std::abs(last));
  return 4 * (larger - std::nextafter(larger, 0.0));
}
inline double before_all(double first, double last) { return std::nextafter(first - reach_of(first, last), -DBL_MAX); }
inline double after_all(double first, double last) { return std::nextafter(last + reach_of(first, last), DBL_MAX); }

}  // namespace test

#endif

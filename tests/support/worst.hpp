// The worst of many errors. Not a number counts as infinite: std::max would lose it.
#ifndef QTRAJ_TESTS_WORST_HPP
#define QTRAJ_TESTS_WORST_HPP

#include <cmath>
#include <limits>

namespace test {

// Raises `worst` to an error.
template <class Error>
void raise_to(double& worst, Error error) {
  if (error <= static_cast<Error>(worst)) return;
  worst = std::isnan(error) ? std::numeric_limits<double>::infinity() : static_cast<double>(error);
}

}  // namespace test

#endif

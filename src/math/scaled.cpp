#include "math/scaled.hpp"

#include <cfloat>
#include <limits>

namespace qtraj {

double unscale(double x, int steps) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (; steps > 0; --steps) {
    if (std::abs(x) > DBL_MAX * 0x1p-600) return x < 0 ? -kInfinity : kInfinity;
    x *= 0x1p600;
  }
  // no double rounding: the first step that rounds leaves a subnormal number, which the next step makes 0
  for (; steps < 0 && x != 0; ++steps) x *= 0x1p-600;
  return x;
}

}  // namespace qtraj

#include "math/trigonometry.hpp"

namespace qtraj {

SinCos sin_cos(double x) {
  const SinCosOf<double> at = sin_cos_of(x);
  return {at.sin, at.cos};
}

double atan2(double y, double x) { return atan2_of(y, x); }

}  // namespace qtraj

#include "diagnostics/common_unit.hpp"

#include <algorithm>
#include <climits>
#include <cmath>

#include "diagnostics/rate_bounds.hpp"
#include "math/product.hpp"

namespace qtraj {
namespace {

// x = mantissa 2^exponent, the mantissa in [1/2, 1), or 0
int exponent_of(double x) {
  int exponent;
  std::frexp(x, &exponent);
  return exponent;
}

// Twice the power of 1/h in the quantity.
int twice_power(Quantity quantity) {
  switch (quantity) {
    case Quantity::omega:
      return 2;
    case Quantity::alpha:
      return 4;
    case Quantity::energy:
      return 3;
    case Quantity::angle:
      break;
  }
  return 0;
}

}  // namespace

CommonUnit::CommonUnit(const Trajectory& trajectory, Quantity quantity) : trajectory_(trajectory), quantity_(quantity) {
  int largest = INT_MIN;
  for (size_t segment = 0; segment + 1 < trajectory.timeline.key_count; ++segment) {
    const double size = size_of_rates(trajectory, segment), h = duration(trajectory, segment);
    if (size == 0) continue;
    const int exponent = 2 * exponent_of(size) - twice_power(quantity) * exponent_of(h);
    if (exponent <= largest) continue;
    largest = exponent;
    duration_ = h;
    unit_ = std::ldexp(1.0, std::min(-exponent_of(size), 1000));
  }
}

CommonUnit::Weight CommonUnit::weight(size_t segment) const {
  constexpr double kLargest = 0x1p1000;
  const double h = duration(trajectory_, segment);
  // beyond the limit the segment is at rest
  const double ratio = h >= 1.0 || duration_ <= kLargest * h ? duration_ / h : kLargest;
  Weight weight;
  weight.unit_ = unit_;
  if (quantity_ != Quantity::angle) weight.first_ = ratio;
  if (quantity_ == Quantity::alpha) weight.second_ = ratio;
  if (quantity_ == Quantity::energy) weight.second_ = std::sqrt(ratio);
  return weight;
}

bool CommonUnit::in_seconds(double value, bool squared, double& result) const {
  Product quotient(value);
  const int times = squared ? 2 : 1;
  for (int k = 0; k < times; ++k) quotient /= unit_;
  for (int k = 0; k < times * twice_power(quantity_) / 2; ++k) quotient /= 0.5 * duration_;
  return quotient.value(result);
}

}  // namespace qtraj

// A product whose factors may leave the range of doubles where the whole does not.
#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace qtraj {
namespace {

// mantissa 2^exponent, the mantissa in [1/2, 1), or 0: each step is rounded as one of doubles is.
class Product {
 public:
  explicit Product(double value) { mantissa_ = std::frexp(value, &exponent_); }
  Product& operator*=(double factor) {
    int exponent;
    const double mantissa = std::frexp(factor, &exponent);
    return renew(mantissa_ * mantissa, exponent);
  }
  Product& operator/=(double divisor) {
    int exponent;
    const double mantissa = std::frexp(divisor, &exponent);
    return renew(mantissa_ / mantissa, -exponent);
  }
  // False where it overflows. Not by ldexp, which writes errno.
  bool value(double& result) const {
    if (mantissa_ != 0 && exponent_ > DBL_MAX_EXP) return false;
    result = mantissa_;
    int exponent = std::max(exponent_, -2000);
    for (; exponent < -500; exponent += 500) result *= 0x1p-500;
    for (; exponent > 500; exponent -= 500) result *= 0x1p500;
    result *= std::ldexp(1.0, exponent);
    return true;
  }

 private:
  Product& renew(double mantissa, int exponent) {
    int shift;
    mantissa_ = std::frexp(mantissa, &shift);
    exponent_ += exponent + shift;
    return *this;
  }

  double mantissa_;
  int exponent_;
};

}  // namespace
}  // namespace qtraj

// Sizes of rates of all segments in one unit, whatever their lengths in time: 1 is about the largest that occurs. Sizes
// per unit of s can then be compared, squared and summed; the result in seconds is formed last.
#pragma once

#include <cmath>

#include "base/times.hpp"
#include "diagnostics/segment_rates.hpp"
#include "math/quaternion.hpp"

namespace qtraj {

// What is compared or summed: |omega|, |alpha|, |omega| h, |alpha| h^(1/2). In seconds each is (2/h)^p times its value
// per unit of s.
enum class Quantity { omega, alpha, angle, energy };

// Accelerations below this part of the largest |omega|/h are rounding noise.
constexpr double kNoise = 1e-12;

class CommonUnit {
 public:
  CommonUnit(const Trajectory& trajectory, Quantity quantity);

  // Of a size per unit of s in a segment. Sizes far below the largest may vanish.
  class Weight {
   public:
    double operator()(double size) const { return size * first_ * second_ * unit_; }
    double length_of(const Vector3& rate) const {
      return length(Vector3((*this)(rate[0]), (*this)(rate[1]), (*this)(rate[2])));
    }

   private:
    friend class CommonUnit;
    double first_ = 1.0, second_ = 1.0, unit_ = 1.0;
  };
  Weight weight(size_t segment) const;

  // A size, or the sum of squares of sizes, in seconds; false where it overflows.
  bool in_seconds(double value, bool squared, double& result) const;

 private:
  const Trajectory& trajectory_;
  Quantity quantity_;
  double duration_ = 1.0;  // of the segment whose rates are the largest
  double unit_ = 1.0;      // a power of two
};

}  // namespace qtraj

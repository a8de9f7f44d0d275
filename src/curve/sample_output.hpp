// One row of samples: its rates converted to time and to the frame asked for, and the row written.
#pragma once

#include "curve/sample_call.hpp"
#include "math/vector_algebra.hpp"

namespace qtraj {
namespace {

template <class Real>
struct SampleRow {
  Real q[4], omega[3], alpha[3];
};

template <class From, class Real, size_t Size>
void write(const From (&from)[Size], Real* to, size_t row) {
  if (to) each_of<Size>([&](size_t k) { to[Size * row + k] = static_cast<Real>(from[k]); });
}

template <bool kWithRates, class From, class Real>
void write_row(const SampleRow<From>& from, const SampleOutputs<Real>& outputs, size_t row) {
  write(from.q, outputs.q, row);
  if constexpr (kWithRates) {
    write(from.omega, outputs.omega, row);
    write(from.alpha, outputs.alpha, row);
  }
}

template <class Real>
SampleRow<Real> nan_row() {
  constexpr Real kNaN = static_cast<Real>(__builtin_nan(""));
  return {{kNaN, kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}};
}

template <class Real>
constexpr double largest_of() {
  return sizeof(Real) == sizeof(double) ? kLargest : 0x1.fffffep+127;
}

// value * factor; false, without raising FE_OVERFLOW, where the product or its rounding to Real would overflow.
template <class Real>
bool scaled(double value, double factor, double& product) {
  constexpr double kSafe = 0x1p500;
  if ((magnitude(value) > kSafe || factor > kSafe) && factor > 1 && magnitude(value) > kLargest / factor) return false;
  product = value * factor;
  return magnitude(product) <= largest_of<Real>();
}

// Converts body rates per unit of x to rates in time and in the frame asked for; false where one that is wanted
// overflows.
template <class Arithmetic, class Real>
bool finish_rates(const Real (&q)[4], Rates<Real>& rates, double scale, const RateRequest& request,
                  SampleRow<Real>& row) {
  if (request.frame == Frame::world) {
    rotate_to_world<Arithmetic>(q, rates.omega);
    if (request.alpha) rotate_to_world<Arithmetic>(q, rates.alpha);
  }
  for (size_t k = 0; k < 3; ++k) {
    double value;
    if (request.omega) {
      if (!scaled<Real>(static_cast<double>(rates.omega[k]), scale, value)) return false;
      row.omega[k] = static_cast<Real>(value);
    }
    if (request.alpha) {
      if (!scaled<double>(static_cast<double>(rates.alpha[k]), scale, value)) return false;
      if (!scaled<Real>(value, scale, value)) return false;
      row.alpha[k] = static_cast<Real>(value);
    }
  }
  return true;
}

// Writes the constant rate of an extrapolated turn and alpha = 0; false where omega is past the range of Real.
template <class Real>
bool extrapolated_rates(const double (&omega)[3], const RateRequest& request, SampleRow<Real>& row) {
  for (size_t k = 0; k < 3; ++k) {
    row.alpha[k] = 0;
    if (!request.omega) continue;
    if (magnitude(omega[k]) > largest_of<Real>()) return false;
    row.omega[k] = static_cast<Real>(omega[k]);
  }
  return true;
}

}  // namespace
}  // namespace qtraj

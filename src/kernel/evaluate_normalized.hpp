// Polynomials in R^4, normalised.
#pragma once

#include <type_traits>

#include "motion.hpp"
#include "qtraj/segment.hpp"

namespace qtraj {
namespace {

// Square of the norm below which the polynomial counts as 0: its direction is nobody's intent, and 2/N could overflow.
template <class Real>
constexpr Real zero_norm_squared() {
  return sizeof(Real) == sizeof(double) ? static_cast<Real>(0x1p-1000) : static_cast<Real>(0x1p-120);
}

// Curves of any range are worked out in double for float samples too: coefficients may be past the range of float.
template <class Arithmetic, size_t Degree, ExponentRange Range>
struct NormalizedEvaluator {
  using Segment = NormalizedSegment<Degree>;
  template <class Real>
  using Working = std::conditional_t<Range == ExponentRange::any, double, Real>;

  // The identity where the polynomial passes through 0.
  template <class Real>
  static void sample(const Segment& segment, double elapsed, Real (&q)[4]) {
    using Work = Working<Real>;
    Work p[4];
    vector_horner<Arithmetic>(segment.c, static_cast<Work>(position<Arithmetic>(elapsed, segment.scale)), p);
    const Work norm_squared = dot<Arithmetic>(p, p);
    const bool zero = norm_squared < zero_norm_squared<Work>();
    const Work inverse_norm = Work(1) / square_root(zero ? Work(1) : norm_squared);
    for (size_t k = 0; k < 4; ++k) q[k] = static_cast<Real>(zero ? (k == 0 ? Work(1) : Work(0)) : p[k] * inverse_norm);
  }

  static double scale(const Segment& segment) { return segment.scale; }

  // With N = |p|^2: omega_body = (2/N) Im(p* p'), alpha_body = (2/N) Im(p* p'') - omega_body N'/N; 0 where p is.
  template <class Work>
  static void sample_rates(const Segment& segment, double elapsed, Rates<Work>& rates) {
    const Work s = static_cast<Work>(position<Arithmetic>(elapsed, segment.scale));
    Work p[4], dp[4], ddp[4], bend[3];
    polynomial_jet<Arithmetic>(segment.c, s, p, dp, ddp);
    relative_vector_part<Arithmetic>(p, dp, rates.omega);
    relative_vector_part<Arithmetic>(p, ddp, bend);
    const Work norm_squared = dot<Arithmetic>(p, p);
    const bool zero = norm_squared < zero_norm_squared<Work>();
    const Work twice_inverse = zero ? Work(0) : Work(2) / (zero ? Work(1) : norm_squared);
    const Work norm_change = twice_inverse * dot<Arithmetic>(p, dp);  // N'/N
    for (size_t k = 0; k < 3; ++k) {
      rates.omega[k] *= twice_inverse;
      rates.alpha[k] = Arithmetic::multiply_add(-norm_change, rates.omega[k], twice_inverse * bend[k]);
    }
  }
};

}  // namespace
}  // namespace qtraj

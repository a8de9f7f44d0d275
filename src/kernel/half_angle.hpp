// The functions of a half-angle vector p that rotations and their rates are made of, as functions of y = |p|^2:
//   C = cos |p|,  K = sin |p| / |p|,  D = (K - C)/y,  E = (3 D - K)/y,
// and with them exp p, Jr and beta of the rotation vector r = 2 p:
//   omega_body = Jr(r) r' = 2 [p' - K^2 p x p' + (K^2 - C D) p x (p x p')]
//   alpha_body = Jr(r) r'' + 4 K D (p.p') p x p' + 2 (C E - K D)(p.p') p x (p x p') + 2 (K^2 - C D) p' x (p x p').
// None of it is 0/0 at p = 0, as the textbook forms are. Derived from G. Chirikjian, "Stochastic Models, Information
// Theory, and Lie Groups", vol. 2 (2012), eq. 10.86.
#pragma once

#include "motion.hpp"
#include "qtraj/elementary.hpp"
#include "qtraj/segment.hpp"

namespace qtraj {
namespace {

template <class Real>
struct CosSinc {
  Real c, k;
};
template <class Real>
struct RateFactors {
  Real d, e;
};

// For |p| <= 2^Doublings pi/2: the polynomials at a fraction of the angle, then cos 2x = 1 - 2 sin^2 x and
// sinc 2x = cos x sinc x. No square root, no division, no branch.
template <class Arithmetic, int Doublings, class Real>
CosSinc<Real> cos_sinc(Real y) {
  constexpr Real kFraction = Real(1) / Real(1 << (2 * Doublings));
  Real z = y * kFraction;
  CosSinc<Real> f = {evaluate<Arithmetic, CosHalf>(z), evaluate<Arithmetic, SincHalf>(z)};
  for (int step = 0; step < Doublings; ++step) {
    const Real k = f.c * f.k;
    f.c = Arithmetic::multiply_add(Real(-2) * z * f.k, f.k, Real(1));
    f.k = k;
    z *= Real(4);
  }
  return f;
}

// D and E the same way: D' = (C D + K^2)/4, E' = (C E + 3 D K)/16.
template <class Arithmetic, int Doublings, class Real>
RateFactors<Real> rate_factors(Real y) {
  constexpr Real kFraction = Real(1) / Real(1 << (2 * Doublings));
  Real z = y * kFraction;
  CosSinc<Real> f = {evaluate<Arithmetic, CosHalf>(z), evaluate<Arithmetic, SincHalf>(z)};
  RateFactors<Real> g = {evaluate<Arithmetic, DHalf>(z), evaluate<Arithmetic, EHalf>(z)};
  for (int step = 0; step < Doublings; ++step) {
    const Real d = Real(0.25) * Arithmetic::multiply_add(f.c, g.d, f.k * f.k);
    g.e = Real(0.0625) * Arithmetic::multiply_add(f.c, g.e, Real(3) * g.d * f.k);
    g.d = d;
    const Real k = f.c * f.k;
    f.c = Arithmetic::multiply_add(Real(-2) * z * f.k, f.k, Real(1));
    f.k = k;
    z *= Real(4);
  }
  return g;
}

constexpr double kPolynomialLimit = 2.4674;  // (pi/2)^2

// For any |p| below 2^500.
template <class Arithmetic>
CosSinc<double> cos_sinc_any(double y) {
  if (y <= kPolynomialLimit) return cos_sinc<Arithmetic, 0>(y);
  const double angle = square_root(y);
  const SinCos at = sin_cos(angle);
  return {at.cos, at.sin / angle};
}

// base (c, k p), the Hamilton product.
template <class Arithmetic, class Real>
void turn(const Real (&base)[4], const CosSinc<Real>& f, const Real (&p)[3], Real (&q)[4]) {
  const Real w = base[0], x = base[1], y = base[2], z = base[3];
  const Real vx = f.k * p[0], vy = f.k * p[1], vz = f.k * p[2];
  const auto add = [](Real a, Real b, Real c) { return Arithmetic::multiply_add(a, b, c); };
  q[0] = add(-z, vz, add(-y, vy, add(-x, vx, w * f.c)));
  q[1] = add(-z, vy, add(y, vz, add(x, f.c, w * vx)));
  q[2] = add(-x, vz, add(z, vx, add(y, f.c, w * vy)));
  q[3] = add(-y, vx, add(x, vy, add(z, f.c, w * vz)));
}

// A half-angle vector with its derivatives.
template <class Real>
struct HalfAngleJet {
  Real p[3], dp[3], ddp[3];
};

// Weights of the cross products in the formulas above, p there a vector of any length. A vector of many turns is passed
// as its unit vector, the powers of its length in the weights: no product then overflows.
template <class Real>
struct RateWeights {
  Real once, twice;              // p x p' and p x (p x p'), and the same with p''
  Real sideways;                 // p' x (p x p')
  Real along_once, along_twice;  // (p.p') p x p' and (p.p') p x (p x p')
};

template <class Arithmetic, class Real>
void weigh_rates(const HalfAngleJet<Real>& jet, const Real (&p)[3], const RateWeights<Real>& weights,
                 Rates<Real>& rates) {
  Real once[3], twice[3], ddp_once[3], ddp_twice[3], sideways[3];
  cross<Arithmetic>(p, jet.dp, once);
  cross<Arithmetic>(p, once, twice);
  cross<Arithmetic>(p, jet.ddp, ddp_once);
  cross<Arithmetic>(p, ddp_once, ddp_twice);
  cross<Arithmetic>(jet.dp, once, sideways);
  const Real along = dot<Arithmetic>(p, jet.dp);
  const Real along_once = weights.along_once * along, along_twice = weights.along_twice * along;
  const auto add = [](Real a, Real b, Real c) { return Arithmetic::multiply_add(a, b, c); };
  for (size_t k = 0; k < 3; ++k) {
    rates.omega[k] = Real(2) * add(weights.twice, twice[k], add(weights.once, once[k], jet.dp[k]));
    const Real direct = add(weights.twice, ddp_twice[k], add(weights.once, ddp_once[k], jet.ddp[k]));
    const Real turning = add(weights.sideways, sideways[k], add(along_twice, twice[k], along_once * once[k]));
    rates.alpha[k] = Real(2) * (direct + turning);
  }
}

// Body rates of exp p for |p| <= 2^Doublings pi/2.
template <class Arithmetic, int Doublings, class Real>
void exponential_rates(const HalfAngleJet<Real>& jet, Rates<Real>& rates) {
  const Real y = dot<Arithmetic>(jet.p, jet.p);
  const CosSinc<Real> f = cos_sinc<Arithmetic, Doublings>(y);
  const RateFactors<Real> g = rate_factors<Arithmetic, Doublings>(y);
  const Real twice = Arithmetic::multiply_add(f.k, f.k, -(f.c * g.d));
  weigh_rates<Arithmetic>(
      jet, jet.p, {-(f.k * f.k), twice, twice, Real(2) * f.k * g.d, Arithmetic::multiply_add(f.c, g.e, -(f.k * g.d))},
      rates);
}

// For any |p| below 2^500.
template <class Arithmetic>
void exponential_rates_any(const HalfAngleJet<double>& jet, Rates<double>& rates) {
  const double y = dot<Arithmetic>(jet.p, jet.p);
  if (y <= kPolynomialLimit) return exponential_rates<Arithmetic, 0>(jet, rates);
  const double length = square_root(y);
  const double axis[3] = {jet.p[0] / length, jet.p[1] / length, jet.p[2] / length};
  const SinCos at = sin_cos(length);
  const double k = at.sin / length, twice = 1.0 - at.cos * k;
  const double along_twice = (3.0 * at.cos * (k - at.cos) - at.sin * at.sin) / length;
  weigh_rates<Arithmetic>(jet, axis, {-(at.sin * k), twice, twice / length, 2.0 * k * (k - at.cos), along_twice},
                          rates);
}

}  // namespace
}  // namespace qtraj

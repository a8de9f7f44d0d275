// The exponential of a half-angle vector p and its rates, from four functions of y = |p|^2:
//   C = cos |p|,  K = sin |p| / |p|,  D = (K - C)/y,  E = (3 D - K)/y.
// They give exp p = (C, K p) and, for the rotation vector r = 2 p, Jr and beta:
//   omega_body = Jr(r) r' = 2 [p' - K^2 p x p' + (K^2 - C D) p x (p x p')]
//   alpha_body = Jr(r) r'' + 4 K D (p.p') p x p' + 2 (C E - K D)(p.p') p x (p x p') + 2 (K^2 - C D) p' x (p x p').
// Unlike the textbook forms, none of this is 0/0 at p = 0. Derived from G. Chirikjian, "Stochastic Models, Information
// Theory, and Lie Groups", vol. 2 (2012), eq. 10.86.
#pragma once

#include "math/trigonometry.hpp"
#include "math/vector_algebra.hpp"

namespace qtraj {
namespace {

template <class Number>
struct CosSinc {
  Number c, k;
};
template <class Number>
struct RateFactors {
  Number c, k, d, e;
};

// 4^-doublings.
template <class Real>
constexpr Real kQuarterPower[] = {Real(1), Real(0.25), Real(0.0625)};

// From x with z = x^2 to 2x: cos 2x = 1 - 2 z sinc^2 x, sinc 2x = cos x sinc x.
template <class Arithmetic, class Number>
QTRAJ_INLINE void double_angle(Number sinc_squared, Number& c, Number& k, Number& minus_two_z) {
  using Real = Element<Number>;
  k = c * k;
  c = Arithmetic::multiply_add(minus_two_z, sinc_squared, Number(Real(1)));
  minus_two_z = Number(Real(4)) * minus_two_z;
}
// One Newton step towards c^2 + y k^2 = 1, whose error doubles with each doubling of the angle.
template <class Arithmetic, class Number>
QTRAJ_INLINE void normalize_doubled(Number y, CosSinc<Number>& f) {
  using Real = Element<Number>;
  const Number square = Arithmetic::multiply_add(y * f.k, f.k, f.c * f.c);
  const Number factor = Arithmetic::multiply_add(Number(Real(-0.5)), square, Number(Real(1.5)));
  f.c = f.c * factor;
  f.k = f.k * factor;
}

// C and K for |p| <= 2^doublings pi/2, doublings <= 2: the polynomials are evaluated at |p| / 2^doublings, then the
// angle is doubled. No square root, no division, and all samples of a trajectory take the same branches.
template <class Arithmetic, class Number>
QTRAJ_INLINE void cos_sinc(Number y, int doublings, CosSinc<Number>& f) {
  using Real = Element<Number>;
  const Number z = y * Number(kQuarterPower<Real>[doublings]);
  Number c = evaluate<Arithmetic, CosHalf>(z), k = evaluate<Arithmetic, SincHalf>(z);
  Number minus_two_z = Number(Real(-2)) * z;
  for (int step = 0; step < doublings; ++step) double_angle<Arithmetic>(k * k, c, k, minus_two_z);
  f.c = c;
  f.k = k;
}

// C, K, D and E in the same way; doubling the angle takes D to (C D + K^2)/4 and E to (C E + 3 D K)/16. E is 0 unless
// it is wanted.
template <class Arithmetic, class Number>
QTRAJ_INLINE void rate_factors(Number y, int doublings, bool wants_e, RateFactors<Number>& f) {
  using Real = Element<Number>;
  const Number z = y * Number(kQuarterPower<Real>[doublings]);
  Number c = evaluate<Arithmetic, CosHalf>(z), k = evaluate<Arithmetic, SincHalf>(z);
  Number d = evaluate<Arithmetic, DHalf>(z), e = Number(Real(0));
  if (wants_e) e = evaluate<Arithmetic, EHalf>(z);
  Number minus_two_z = Number(Real(-2)) * z;
  for (int step = 0; step < doublings; ++step) {
    const Number sinc_squared = k * k;
    if (wants_e) e = Number(Real(0.0625)) * Arithmetic::multiply_add(c, e, Number(Real(3)) * d * k);
    d = Number(Real(0.25)) * Arithmetic::multiply_add(c, d, sinc_squared);
    double_angle<Arithmetic>(sinc_squared, c, k, minus_two_z);
  }
  f.c = c;
  f.k = k;
  f.d = d;
  f.e = e;
}

// C and K for any |p| below 2^500; Number of double. Both forms are computed and one is selected: where the polynomials
// do not hold they are given y = 0, and where the angle may be 0 the quotients are given the angle 1.
constexpr double kPolynomialLimit = 2.4674;  // (pi/2)^2

template <class Arithmetic, class Number>
QTRAJ_INLINE CosSinc<Number> cos_sinc_any(Number y) {
  const auto is_short = y <= Number(kPolynomialLimit);
  CosSinc<Number> near;
  cos_sinc<Arithmetic>(select(is_short, y, Number(0.0)), 0, near);
  const Number angle = select(is_short, Number(1.0), square_root(y));
  const SinCosOf<Number> at = sin_cos_of(angle);
  return {select(is_short, near.c, at.cos), select(is_short, near.k, at.sin / angle)};
}

// q = base (c, k p), the Hamilton product.
template <class Arithmetic, class Number>
QTRAJ_INLINE void turn(const Number (&base)[4], const CosSinc<Number>& f, const Number (&p)[3], Number (&q)[4]) {
  const Number w = base[0], x = base[1], y = base[2], z = base[3];
  const Number vx = f.k * p[0], vy = f.k * p[1], vz = f.k * p[2];
  const auto add = [](Number a, Number b, Number c) { return Arithmetic::multiply_add(a, b, c); };
  q[0] = add(-z, vz, add(-y, vy, add(-x, vx, w * f.c)));
  q[1] = add(-z, vy, add(y, vz, add(x, f.c, w * vx)));
  q[2] = add(-x, vz, add(z, vx, add(y, f.c, w * vy)));
  q[3] = add(-y, vx, add(x, vy, add(z, f.c, w * vz)));
}

// A half-angle vector with its first and second derivative.
template <class Number>
struct HalfAngleJet {
  Number p[3], dp[3], ddp[3];
};
// The jet of the polynomial with coefficients c, at x.
template <class Arithmetic, class Number, size_t Terms>
QTRAJ_INLINE HalfAngleJet<Number> half_angle_jet(const Number (&c)[Terms][3], Number x) {
  HalfAngleJet<Number> jet;
  horner<Arithmetic>(c, x, jet.p);
  first_derivative<Arithmetic>(c, x, jet.dp);
  second_derivative<Arithmetic>(c, x, jet.ddp);
  return jet;
}

// Weights of the cross products in the formulas above. For a vector of many turns p/|p| takes the place of p, and the
// weights contain the powers of |p|, so that no product overflows.
template <class Number>
struct RateWeights {
  Number once, twice;              // of p x p' and p x (p x p'), and of the same with p''
  Number sideways;                 // of p' x (p x p')
  Number along_once, along_twice;  // of (p.p') p x p' and (p.p') p x (p x p')
};

template <class Arithmetic, class Number>
QTRAJ_INLINE void weigh_rates(const HalfAngleJet<Number>& jet, const Number (&p)[3], const RateWeights<Number>& weights,
                              bool wants_alpha, Rates<Number>& rates) {
  const auto add = [](Number a, Number b, Number c) { return Arithmetic::multiply_add(a, b, c); };
  const Number two = Number(Element<Number>(2));
  Number once[3], twice[3];
  cross_product<Arithmetic>(p, jet.dp, once);
  cross_product<Arithmetic>(p, once, twice);
  for (size_t k = 0; k < 3; ++k)
    rates.omega[k] = two * add(weights.twice, twice[k], add(weights.once, once[k], jet.dp[k]));
  if (!wants_alpha) return;

  Number ddp_once[3], ddp_twice[3], sideways[3];
  cross_product<Arithmetic>(p, jet.ddp, ddp_once);
  cross_product<Arithmetic>(p, ddp_once, ddp_twice);
  cross_product<Arithmetic>(jet.dp, once, sideways);
  const Number along = dot_product<Arithmetic>(p, jet.dp);
  const Number along_once = weights.along_once * along, along_twice = weights.along_twice * along;
  for (size_t k = 0; k < 3; ++k) {
    const Number direct = add(weights.twice, ddp_twice[k], add(weights.once, ddp_once[k], jet.ddp[k]));
    const Number turning = add(weights.sideways, sideways[k], add(along_twice, twice[k], along_once * once[k]));
    rates.alpha[k] = two * (direct + turning);
  }
}

template <class Arithmetic, class Number>
QTRAJ_INLINE RateWeights<Number> rate_weights(const RateFactors<Number>& f) {
  const Number twice = Arithmetic::multiply_add(f.k, f.k, -(f.c * f.d));
  return {-(f.k * f.k), twice, twice, Number(Element<Number>(2)) * f.k * f.d,
          Arithmetic::multiply_add(f.c, f.e, -(f.k * f.d))};
}

// Body rates of exp p for |p| <= pi/2.
template <class Arithmetic, class Number>
QTRAJ_INLINE void exponential_rates(const HalfAngleJet<Number>& jet, bool wants_alpha, Rates<Number>& rates) {
  RateFactors<Number> f;
  rate_factors<Arithmetic>(dot_product<Arithmetic>(jet.p, jet.p), 0, wants_alpha, f);
  weigh_rates<Arithmetic>(jet, jet.p, rate_weights<Arithmetic>(f), wants_alpha, rates);
}

// Body rates of exp p for any |p| below 2^500; Number of double.
template <class Arithmetic, class Number>
QTRAJ_INLINE void exponential_rates_any(const HalfAngleJet<Number>& jet, bool wants_alpha, Rates<Number>& rates) {
  const Number zero(0.0), one(1.0), two(2.0), three(3.0);
  const Number y = dot_product<Arithmetic>(jet.p, jet.p);
  const auto is_short = y <= Number(kPolynomialLimit);
  RateFactors<Number> f;
  rate_factors<Arithmetic>(select(is_short, y, zero), 0, wants_alpha, f);
  const RateWeights<Number> near = rate_weights<Arithmetic>(f);

  const Number length = select(is_short, one, square_root(y));
  const SinCosOf<Number> at = sin_cos_of(length);
  const Number k = at.sin / length, twice = one - at.cos * k;
  const Number along_twice = (three * at.cos * (k - at.cos) - at.sin * at.sin) / length;
  const RateWeights<Number> weights = {select(is_short, near.once, -(at.sin * k)), select(is_short, near.twice, twice),
                                       select(is_short, near.sideways, twice / length),
                                       select(is_short, near.along_once, two * k * (k - at.cos)),
                                       select(is_short, near.along_twice, along_twice)};
  const Number direction[3] = {jet.p[0] / length, jet.p[1] / length, jet.p[2] / length};
  weigh_rates<Arithmetic>(jet, direction, weights, wants_alpha, rates);
}

// ---- Jr(r) and the factors of beta from C, K, D and E; so3.hpp states the formulas. Plain arithmetic: the same bits
// in the core and in kernels of either arithmetic.

// C, K, D and E of the half angle sqrt(y), y <= kPolynomialLimit, by Horner's scheme as in the core.
template <class Number>
QTRAJ_INLINE RateFactors<Number> polynomial_factors(Number y) {
  return {terms_from(CosHalf::kDouble, 0, y), terms_from(SincHalf::kDouble, 0, y), terms_from(DHalf::kDouble, 0, y),
          terms_from(EHalf::kDouble, 0, y)};
}

// The factors of beta.
template <class Number>
struct TurningFactorsOf {
  Number along_once, along_twice, sideways;
};
template <class Number>
QTRAJ_INLINE TurningFactorsOf<Number> turning_factors_of(const RateFactors<Number>& f) {
  return {Number(0.25) * f.k * f.d, Number(0.0625) * (f.c * f.e - f.k * f.d), Number(0.25) * (f.k * f.k - f.c * f.d)};
}

// Jr(r) = 1 - (K^2/2) [r x] + sideways [r x]^2 with [r x]^2 = r r^T - |r|^2, stored column by column.
template <class Number>
QTRAJ_INLINE void jacobian_of(const RateFactors<Number>& f, Number sideways, const Number (&r)[3],
                              Number (&jacobian)[9]) {
  const Number once = Number(0.5) * f.k * f.k, square = sideways * dot_product<Plain>(r, r);
  for (size_t column = 0; column < 3; ++column) {
    const size_t next = (column + 1) % 3, last = (column + 2) % 3;
    jacobian[3 * column + column] = (Number(1.0) + r[column] * (sideways * r[column])) - square;
    jacobian[3 * column + next] = r[column] * (sideways * r[next]) - once * r[last];
    jacobian[3 * column + last] = r[column] * (sideways * r[last]) + once * r[next];
  }
}

// Jr^-1(r) w, of the same factors.
template <class Number>
QTRAJ_INLINE void inverse_jacobian_times(const RateFactors<Number>& f, const Number (&r)[3], const Number (&w)[3],
                                         Number (&derivative)[3]) {
  Number once[3], twice[3];
  cross_product<Plain>(r, w, once);
  cross_product<Plain>(r, once, twice);
  const Number weight = Number(0.25) * f.d / f.k;
  for (size_t k = 0; k < 3; ++k) derivative[k] = w[k] + Number(0.5) * once[k] + weight * twice[k];
}

// The Hamilton product a b, in any arithmetic. The terms are added in the order in which they are written; a component
// is within 4 units of rounding, 2 eps, of |a| |b|, because sum |a_i b_j| is at most that.
template <class Arithmetic, class Number>
QTRAJ_INLINE void hamilton_product(const Number (&a)[4], const Number (&b)[4], Number (&product)[4]) {
  const auto add = [](Number x, Number y, Number sum) { return Arithmetic::multiply_add(x, y, sum); };
  product[0] = add(-a[3], b[3], add(-a[2], b[2], add(-a[1], b[1], a[0] * b[0])));
  product[1] = add(-a[3], b[2], add(a[2], b[3], add(a[1], b[0], a[0] * b[1])));
  product[2] = add(a[3], b[1], add(a[2], b[0], add(-a[1], b[3], a[0] * b[2])));
  product[3] = add(a[3], b[0], add(-a[2], b[1], add(a[1], b[2], a[0] * b[3])));
}

// exp v - 1 (math/so3.hpp). sin_cos(angle) is of angles from 0 on.
template <class Number, class SinCosFunction>
QTRAJ_INLINE void exponential_minus_one(const Number (&v)[3], const SinCosFunction& sin_cos, Number (&result)[4]) {
  const Number zero(0.0), two(2.0);
  const Number angle = square_root(dot_product<Plain>(v, v));
  const auto turns = zero < angle;
  const SinCosOf<Number> half = sin_cos(Number(0.5) * angle);
  const Number factor = two * half.sin * half.cos / select(turns, angle, Number(1.0));
  result[0] = select(turns, -two * half.sin * half.sin, zero);
  for (size_t k = 0; k < 3; ++k) result[k + 1] = select(turns, factor * v[k], v[k]);
}

}  // namespace
}  // namespace qtraj

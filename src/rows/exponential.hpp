// Exponentials of half-angle vectors, row by row: cosine and sinc as polynomials in the square of the angle, without
// square root or division, in double or in float. functions/exponential.hpp states what they promise.
#pragma once

#include "math/half_angle.hpp"
#include "rows/angles.hpp"
#include "simd/prefetch.hpp"

namespace qtraj {
namespace {

// C and K (math/half_angle.hpp) of y, the square of the angle x in a pair of numbers. Its error part counts in C, by
// dC/dy = -K/2; in K it is less than half a rounding.

// c0 + c1 x + ..., its first two terms added without rounding.
template <class Arithmetic, class Polynomial, class Number>
QTRAJ_INLINE Number evaluate_precisely(Number x) {
  const DoubleDoubleOf<Number> second = exact_product<Arithmetic>(Number(coefficients<Number>(Polynomial{})[1]), x);
  const DoubleDoubleOf<Number> sum = two_sum(Number(coefficients<Number>(Polynomial{})[0]), second.value);
  const Number rest = Arithmetic::multiply_add(evaluate_from<Arithmetic, Polynomial, 2>(x), x * x, second.error);
  return sum.value + (sum.error + rest);
}

// Below this square C and K are 1 when rounded. It stands for smaller ones: its powers do not underflow, which would
// take a hundred cycles.
template <class Real>
constexpr Real kLeastAngleSquare = sizeof(Real) == sizeof(float) ? Real(0x1p-30) : Real(0x1p-60);

// Up to pi/2 they are polynomials in y.
template <class Arithmetic, class Number>
QTRAJ_INLINE CosSinc<Number> cos_sinc_near(const DoubleDoubleOf<Number>& y) {
  using Real = Element<Number>;
  const Number square = maximum(y.value, Number(kLeastAngleSquare<Real>));
  const Number c = evaluate<Arithmetic, CosHalf>(square), k = evaluate<Arithmetic, SincHalf>(square);
  return {Arithmetic::multiply_add(Number(Real(-0.5)) * k, y.error, c), k};
}

// Beyond, up to a bit more than pi, in t = y - kFarCentre.
constexpr double kFarCentre = 6.197265625, kFarthestSquare = 9.927;
template <class Arithmetic, class Number>
QTRAJ_INLINE CosSinc<Number> cos_sinc_far(const DoubleDoubleOf<Number>& y) {
  using Real = Element<Number>;
  const DoubleDoubleOf<Number> t = two_sum(y.value - Number(Real(kFarCentre)), y.error);
  const Number c = evaluate_precisely<Arithmetic, CosFar>(t.value);
  const Number k = evaluate_precisely<Arithmetic, SincFar>(t.value);
  return {Arithmetic::multiply_add(Number(Real(-0.5)) * k, t.error, c), k};
}

// Both forms, one selected lane by lane. False past them.
template <class Arithmetic, class Number>
QTRAJ_INLINE bool cos_sinc_of(const DoubleDoubleOf<Number>& y, CosSinc<Number>& f) {
  const auto is_near = y.value <= Number(Element<Number>(kPolynomialLimit));
  f = cos_sinc_near<Arithmetic>(y);
  if (all(is_near)) return true;
  if (!all(y.value <= Number(Element<Number>(kFarthestSquare)))) return false;
  const CosSinc<Number> far = cos_sinc_far<Arithmetic>(y);
  f = {select(is_near, f.c, far.c), select(is_near, f.k, far.k)};
  return true;
}

template <class Arithmetic, class Number>
QTRAJ_INLINE bool exp_rows(const ExpRows& rows, size_t row, size_t count) {
  using Real = Element<Number>;
  Real* const out = static_cast<Real*>(rows.q.data);
  Number v[3];
  CosSinc<Number> f;
  prefetch_output<Real, 4, kLanesOf<Number>>(out, row, count);
  if (!load_numbers<Real>(rows.v, row, v) || !all(is_below(v, static_cast<Real>(4 / rows.scale)))) return false;
  for (Number& component : v) component = Number(static_cast<Real>(rows.scale)) * component;
  if (!cos_sinc_of<Arithmetic>(precise_square<Arithmetic>(v), f)) return false;
  const Number q[4] = {f.c, f.k * v[0], f.k * v[1], f.k * v[2]};
  store_rows(q, out, row);
  return true;
}

template <class Arithmetic, class Number, class FloatNumber>
size_t exp(const ExpRows& rows, size_t first, size_t count) {
  const auto exp_in = [&](auto number) {
    using In = decltype(number);
    return do_rows<In>(first, count, [&](size_t row) { return exp_rows<Arithmetic, In>(rows, row, count); });
  };
  return rows.q.is_float ? exp_in(FloatNumber()) : exp_in(Number());
}

}  // namespace
}  // namespace qtraj

// Powers of quaternions, row by row: exp of a multiple of the log, which stays in double-double up to the polynomials.
// functions/exponential.hpp states what they promise.
#pragma once

#include "rows/exponential.hpp"
#include "rows/logarithm.hpp"

namespace qtraj {
namespace {

// Larger exponents go back to the core: times a tiny angle they may be anything.
constexpr double kLeastFarExponent = 0x1p50;

// exp(exponent factor v), given |v|^2: the cosine, and what v is multiplied by. False past the polynomials.
template <class Arithmetic, class Number>
QTRAJ_INLINE bool power_of(Number exponent, const DoubleDoubleOf<Number>& factor, const DoubleDoubleOf<Number>& square,
                           Number& cosine, DoubleDoubleOf<Number>& scale) {
  const auto add = [](Number a, Number b, Number c) { return Arithmetic::multiply_add(a, b, c); };
  // m = exponent factor and y = m^2 |v|^2 to 2^-100
  const DoubleDoubleOf<Number> ratio = fast_two_sum(factor.value, factor.error);
  DoubleDoubleOf<Number> m = exact_product<Arithmetic>(exponent, ratio.value);
  m.error = add(exponent, ratio.error, m.error);
  const DoubleDoubleOf<Number> m_square = exact_product<Arithmetic>(m.value, m.value);
  const Number m_square_error = add(Number(2.0) * m.value, m.error, m_square.error);
  DoubleDoubleOf<Number> y = exact_product<Arithmetic>(m_square.value, square.value);
  y.error = y.error + add(m_square.value, square.error, m_square_error * square.value);

  CosSinc<Number> f;
  if (!cos_sinc_of<Arithmetic>(y, f)) return false;
  cosine = f.c;
  scale = exact_product<Arithmetic>(f.k, m.value);
  scale.error = add(f.k, m.error, scale.error);
  return true;
}

// angle/|v|. Vectors of nearly unit rows alone take one of its forms only.
template <class Arithmetic, class Number>
QTRAJ_INLINE bool find_angle_over_sine(const Number (&q)[4], const DoubleDoubleOf<Number>& square,
                                       DoubleDoubleOf<Number>& factor) {
  if constexpr (kIsFused<Arithmetic>) {
    const SquaresOf<Number> squares = squares_near_one<Arithmetic>(q);
    if (all(LogOf::is_near<Arithmetic>(q, squares))) {
      factor = factor_of_near<LogOf, Arithmetic>(q[0], squares);
      return true;
    }
  }
  return find_factor<LogOf, Arithmetic>(q, square, factor);
}

template <class Arithmetic, class Number>
QTRAJ_INLINE bool pow_rows(const BinaryRows<4, 1, 4>& rows, size_t row, size_t count) {
  using Real = Element<Number>;
  Real* const out = static_cast<Real*>(rows.out.data);
  Number q[4], exponent[1];
  prefetch_output<Real, 4, kLanesOf<Number>>(out, row, count);
  if (!load_rows<Real>(rows.a, row, q) || !load_numbers<Real>(rows.b, row, exponent)) return false;
  if (!all(is_below(exponent, kLeastFarExponent))) return false;
  const Number vector[3] = {q[1], q[2], q[3]};
  const DoubleDoubleOf<Number> square = precise_square<Arithmetic>(vector);
  DoubleDoubleOf<Number> factor, scale;
  if (!find_angle_over_sine<Arithmetic>(q, square, factor)) return false;
  Number power[4];
  if (!power_of<Arithmetic>(exponent[0], factor, square, power[0], scale)) return false;
  for (size_t k = 0; k < 3; ++k) power[k + 1] = rounded_product<Arithmetic>(scale, vector[k]);
  store_rows(power, out, row);
  return true;
}

template <class Arithmetic, class Number>
size_t powers(const BinaryRows<4, 1, 4>& rows, size_t first, size_t count) {
  return do_rows<Number>(first, count, [&](size_t row) { return pow_rows<Arithmetic, Number>(rows, row, count); });
}

}  // namespace
}  // namespace qtraj

// Angles in double-double, for results that are rounded once: the vector forms of math/trigonometry.hpp's precise_atan2
// and of the lengths that it is given. Bounds are derived with u = 2^-53.
#pragma once

#include <type_traits>

#include "math/trigonometry.hpp"
#include "rows/row_loop.hpp"

namespace qtraj {
namespace {

// ---- Exact products: where multiply-adds are fused one instruction gives the error, elsewhere Dekker's product ----

template <class Arithmetic>
constexpr bool kIsFused = std::is_same_v<Arithmetic, Fused>;

template <class Arithmetic, class Number>
QTRAJ_INLINE DoubleDoubleOf<Number> exact_product(Number a, Number b) {
  if constexpr (kIsFused<Arithmetic>) {
    const Number product = a * b;
    return {product, Arithmetic::multiply_add(a, b, -product)};
  } else if constexpr (sizeof(Element<Number>) == sizeof(float)) {
    return two_product(a, b, Number(4097.0f));
  } else {
    return two_product(a, b);
  }
}

// c - a b, a b within a few units of rounding of c: exact but for the last bit of a difference of that size.
template <class Arithmetic, class Number>
QTRAJ_INLINE Number residual(Number c, Number a, Number b) {
  if constexpr (kIsFused<Arithmetic>) return Arithmetic::multiply_add(-a, b, c);
  const DoubleDoubleOf<Number> product = two_product(a, b);
  return (c - product.value) - product.error;
}

// (a.value + a.error) b, rounded once.
template <class Arithmetic, class Number>
QTRAJ_INLINE Number rounded_product(const DoubleDoubleOf<Number>& a, Number b) {
  if constexpr (kIsFused<Arithmetic>) return Arithmetic::multiply_add(a.value, b, a.error * b);
  const DoubleDoubleOf<Number> leading = two_product(a.value, b);
  return leading.value + (leading.error + a.error * b);
}

// a + b for |a| >= |b| or a = 0.
template <class Number>
QTRAJ_INLINE DoubleDoubleOf<Number> fast_two_sum(Number a, Number b) {
  const Number sum = a + b;
  return {sum, b - (sum - a)};
}

// |v|^2 to 2^-100. Fused, the largest component comes first: a sum of squares is then at most twice the one before, so
// that the difference of the two is exact and one more multiply-add gives the error.
template <class Arithmetic, class Number>
QTRAJ_INLINE DoubleDoubleOf<Number> precise_square(const Number (&v)[3]) {
  if constexpr (kIsFused<Arithmetic>) {
    const Number x = absolute(v[0]), y = absolute(v[1]), z = absolute(v[2]);
    const Number larger = maximum(x, y), second = minimum(x, y), first = maximum(larger, z), third = minimum(larger, z);
    const DoubleDoubleOf<Number> one = exact_product<Arithmetic>(first, first);
    const Number two = Arithmetic::multiply_add(second, second, one.value);
    const Number two_error = Arithmetic::multiply_add(second, second, one.value - two);
    const Number three = Arithmetic::multiply_add(third, third, two);
    const Number three_error = Arithmetic::multiply_add(third, third, two - three);
    return {three, one.error + (two_error + three_error)};
  } else {
    const DoubleDoubleOf<Number> x = exact_product<Arithmetic>(v[0], v[0]), y = exact_product<Arithmetic>(v[1], v[1]),
                                 z = exact_product<Arithmetic>(v[2], v[2]);
    const DoubleDoubleOf<Number> two = two_sum(x.value, y.value), three = two_sum(two.value, z.value);
    return {three.value, ((x.error + y.error) + z.error) + (two.error + three.error)};
  }
}

// The sum of a_k b_k to 2^-98 of the product of the norms, in double-double. `shifter` is 3/2 times a power of two,
// which is at least twice that product: added to it, products are rounded to multiples of its last bit, whose sums are
// exact; what is cut off is added apart. Pairs of opposite products cancel without a trace if they are the first two,
// or the last two.
template <class Arithmetic, class Number>
QTRAJ_INLINE DoubleDoubleOf<Number> precise_dot_product(const Number (&a)[4], const Number (&b)[4], Number shifter) {
  const auto add = [](Number x, Number y, Number sum) { return Arithmetic::multiply_add(x, y, sum); };
  const Number one = add(a[0], b[0], shifter), two = add(a[1], b[1], one), three = add(a[2], b[2], two),
               four = add(a[3], b[3], three);
  const Number rest = (add(a[0], b[0], shifter - one) + add(a[1], b[1], one - two)) +
                      (add(a[2], b[2], two - three) + add(a[3], b[3], three - four));
  return fast_two_sum(four - shifter, rest);
}

// The root of a square in double-double, above 2^-450: value^2 + residual is the square.
template <class Number>
struct RootOf {
  Number value, residual;
};
template <class Arithmetic, class Number>
QTRAJ_INLINE RootOf<Number> root_of(const DoubleDoubleOf<Number>& square) {
  const Number value = square_root(square.value);
  return {value, residual<Arithmetic>(square.value, value, value) + square.error};
}
// One Newton step: the root is value (1 + this), to 2^-100.
template <class Number>
QTRAJ_INLINE Number relative_error_of(const RootOf<Number>& root, Number inverse) {
  return (Number(0.5) * inverse) * (root.residual * inverse);
}

// ---- The angle of a point ----

// Below this length a vector part is taken to have it, where that makes no difference.
constexpr double kLeastSine = 0x1p-200, kLeastSineSquare = 0x1p-400;

// Angle, rad, of the point (x + x_error, s (1 + s_error)), s > 0, in [0, pi]: to 0.1 u relative but for rounding, which
// the caller does: the error part may be 1/18 of the value.
//
// The point is turned to the nearest multiple c pi/4 + k pi/2 of an eighth of a turn, all without rounding: its angle
// is that and t + t_error = numerator / denominator, |t| <= tan(pi/8), the arctangent of which is t + t a rest(a), a =
// t^2. The errors of t, x and s are first-order terms, of which a few bits are enough: they multiply 1/(1 + a), to
// 0.3 %. The tail t a rest(a), at most 0.054 t, adds 3 roundings of that, 0.16 u t.
template <class Arithmetic, class Number>
QTRAJ_INLINE DoubleDoubleOf<Number> precise_angle(Number s, Number s_error, Number x, Number x_error) {
  const auto add = [](Number a, Number b, Number c) { return Arithmetic::multiply_add(a, b, c); };
  const Number zero(0.0), one(1.0), two(2.0), four(4.0);
  const Number across = absolute(x);
  const auto is_steep = across < s;
  const Number p = select(is_steep, -x, with_sign_of(x, s)), q = maximum(s, across);
  const auto is_wide = Number(0.41421356237309503) * q < minimum(s, across);
  const Number c = select(is_wide, with_sign_of(p, one), zero);

  // c is -1, 0 or 1, so that products with it are exact, and |c p| <= q
  const Number numerator = add(-c, q, p), denominator = add(c, p, q);
  const Number numerator_error = p - add(c, q, numerator), denominator_error = add(c, p, -(denominator - q));
  const Number inverse = one / denominator, t = numerator * inverse;
  const Number t_remainder = residual<Arithmetic>(numerator, t, denominator) + numerator_error;
  const Number t_error = add(-t, denominator_error, t_remainder) * inverse;

  const Number a = t * t, slope = add(Number(-0.854), a, Number(0.997));
  const Number tail = (t * a) * evaluate_from<Arithmetic, AtanRatio, 1>(a);
  // d angle = (x ds - s dx)/(x^2 + s^2), and x^2 + s^2 = denominator^2 (1 + a)/(1 + c^2)
  const Number turned = (s * inverse) * ((add(s_error, x, -x_error) * inverse) * add(c, c, one));

  // a multiple of pi/4 in double-double; its value is exact
  const Number eighths = select(is_steep, two, select(x < zero, four, zero)) + c;
  const Number base = eighths * Number(0x1.921fb54442d18p-1), base_error = eighths * Number(0x1.1a62633145c07p-55);
  const DoubleDoubleOf<Number> sum = fast_two_sum(base, t);
  return {sum.value, sum.error + (tail + add(t_error + turned, slope, base_error))};
}

// The same angle by plain sums, s >= 0 and not both 0: to 2^-31 and 5 u relative, u that of the type, if s and x are
// exact. The square of a small t stands for 2^-30, which makes no difference to float, and whose powers do not
// underflow: that would take a hundred cycles.
template <class Arithmetic, class Number>
QTRAJ_INLINE Number angle_of_point(Number s, Number x) {
  using Real = Element<Number>;
  const auto add = [](Number a, Number b, Number c) { return Arithmetic::multiply_add(a, b, c); };
  const Number zero(Real(0)), one(Real(1)), two(Real(2)), four(Real(4));
  const Number across = absolute(x);
  const auto is_steep = across < s;
  const Number p = select(is_steep, -x, with_sign_of(x, s)), q = maximum(s, across);
  const auto is_wide = Number(Real(0.41421356237309503)) * q < minimum(s, across);
  const Number c = select(is_wide, with_sign_of(p, one), zero);
  const Number t = add(-c, q, p) / add(c, p, q);
  const Number least = maximum(absolute(t), Number(Real(0x1p-15))), a = least * least;
  const Number eighths = select(is_steep, two, select(x < zero, four, zero)) + c;
  return add(t * a, evaluate_from<Arithmetic, AtanRatio, 1>(a), add(eighths, Number(Real(0x1.921fb54442d18p-1)), t));
}

// ---- Angles between quaternions, which need not be unit ----

// The point (w, |v|) of w + v = a* b, its angle being that between a and b in R^4.
template <class Number>
struct PointOf {
  DoubleDoubleOf<Number> w;
  RootOf<Number> sine;  // |v|; kLeastSine where that is 0
};
// False where v is tiny, but not 0.
template <class Arithmetic, class Number>
QTRAJ_INLINE bool find_point(const Number (&a)[4], const Number (&b)[4], PointOf<Number>& point) {
  // 3/2 of 32 times the product of powers of two: norms are below 4 times these
  const Number shifter = Number(48.0) * (power_of_largest(a) * power_of_largest(b)), zero(0.0);
  point.w = precise_dot_product<Arithmetic>(a, b, shifter);
  const DoubleDoubleOf<Number> v[3] = {
      precise_dot_product<Arithmetic>({a[0], -a[1], -a[2], a[3]}, {b[1], b[0], b[3], b[2]}, shifter),
      precise_dot_product<Arithmetic>({a[0], -a[2], a[1], -a[3]}, {b[2], b[0], b[3], b[1]}, shifter),
      precise_dot_product<Arithmetic>({a[0], -a[3], -a[1], a[2]}, {b[3], b[0], b[2], b[1]}, shifter)};
  const Number vector[3] = {v[0].value, v[1].value, v[2].value}, errors[3] = {v[0].error, v[1].error, v[2].error};
  DoubleDoubleOf<Number> square = precise_square<Arithmetic>(vector);
  square.error = Arithmetic::multiply_add(Number(2.0), dot_product<Arithmetic>(vector, errors), square.error);
  const auto is_zero = maximum(maximum(absolute(vector[0]), absolute(vector[1])), absolute(vector[2])) <= zero;
  const Number least(kLeastSineSquare);
  if (!all(is_zero | (least < square.value))) return false;
  square.value = maximum(square.value, least);
  point.sine = root_of<Arithmetic>(square);
  return true;
}

// The angle of a point, rounded once.
template <class Arithmetic, class Number>
QTRAJ_INLINE Number angle_of(const PointOf<Number>& point) {
  const Number sine_error = relative_error_of(point.sine, Number(1.0) / point.sine.value);
  const Number sine = select(Number(kLeastSine) < point.sine.value, point.sine.value, Number(0.0));
  const DoubleDoubleOf<Number> angle = precise_angle<Arithmetic>(sine, sine_error, point.w.value, point.w.error);
  return angle.value + angle.error;
}

}  // namespace
}  // namespace qtraj

// Logarithms of quaternions, the half-angle vectors, and rotation vectors, row by row. functions/exponential.hpp states
// what they promise; u = 2^-53 is half of the eps there.
//
// A result is the vector part v times angle/|v|, a factor that is found in double-double, so that the product is
// rounded once. It has two forms. Of any quaternion it is the angle of the point (w, |v|) over |v|. Where multiply-adds
// are fused, of nearly unit quaternions, as nearly all are, it is acos w / sqrt(1 - w^2), a polynomial in 1 - w,
// without square root or division. Which one is taken depends on the row alone.
#pragma once

#include "math/unit_quaternion.hpp"
#include "rows/angles.hpp"
#include "simd/prefetch.hpp"

namespace qtraj {
namespace {

// ---- Any quaternion ----

// A vector part shorter than 2^-200 (kLeastSineSquare) is taken for that long: beside it |w| >= 2^-120, and the angle
// over the sine, which is all that counts, is 1/w to 2^-160 wherever it is that short and w > 0.
//
// Of the point (w, sine). To 0.3 u: a relative error d of the sine enters as d (1 - sin(2 angle)/(2 angle)),
// and here d is of second order.
// (Not inlined: logarithms, rotation vectors and powers share one copy.)
template <class Arithmetic, class Number>
QTRAJ_NOINLINE DoubleDoubleOf<Number> angle_over_sine(const DoubleDoubleOf<Number>& square, Number w) {
  const RootOf<Number> sine =
      root_of<Arithmetic>(DoubleDoubleOf<Number>{maximum(square.value, Number(kLeastSineSquare)), square.error});
  const Number inverse = Number(1.0) / sine.value, sine_error = relative_error_of(sine, inverse);
  const DoubleDoubleOf<Number> angle = precise_angle<Arithmetic>(sine.value, sine_error, w, Number(0.0));
  const Number ratio = angle.value * inverse;
  const Number left = Arithmetic::multiply_add(-angle.value, sine_error, angle.error);
  return {ratio, (residual<Arithmetic>(angle.value, ratio, sine.value) + left) * inverse};
}

// ---- Nearly unit quaternions ----

// |v|^2 and |q|^2 - 1 of a quaternion (w, v), to 2^-101 absolute where |q| is close to 1. Squares are added to 2, which
// rounds them to multiples of 2^-51 whose sums are exact; what is cut off is added apart.
template <class Number>
struct SquaresOf {
  DoubleDoubleOf<Number> vector;
  Number excess;
};
template <class Arithmetic, class Number>
QTRAJ_INLINE SquaresOf<Number> squares_near_one(const Number (&q)[4]) {
  const auto add = [](Number a, Number b, Number c) { return Arithmetic::multiply_add(a, b, c); };
  const Number two(2.0), three(3.0);
  const Number x = add(q[1], q[1], two), xy = add(q[2], q[2], x), xyz = add(q[3], q[3], xy), all = add(q[0], q[0], xyz);
  const Number vector = xyz - two;
  const Number x_rest = add(q[1], q[1], two - x), y_rest = add(q[2], q[2], x - xy), z_rest = add(q[3], q[3], xy - xyz);
  const Number rest = (x_rest + y_rest) + z_rest, w_rest = add(q[0], q[0], xyz - all);
  return {{vector, rest}, (all - three) + (rest + w_rest)};
}

// acos(1 - z) / sqrt(z (2 - z)), z in [0, 1] in double-double, to 0.25 u: the first two terms are added without
// rounding, and the rest of the polynomial is at most 0.24. Its slope, for the error of z, is 1/3 to 1.
template <class Arithmetic, class Number>
QTRAJ_INLINE DoubleDoubleOf<Number> precise_acos_ratio(const DoubleDoubleOf<Number>& z) {
  const auto add = [](Number a, Number b, Number c) { return Arithmetic::multiply_add(a, b, c); };
  const DoubleDoubleOf<Number> second = exact_product<Arithmetic>(Number(AcosRatio::kDouble[1]), z.value);
  const DoubleDoubleOf<Number> sum = fast_two_sum(Number(1.0), second.value);
  const Number rest = add(z.value * z.value, evaluate_from<Arithmetic, AcosRatio, 2>(z.value), second.error);
  const Number slope = add(Number(0.62), z.value, Number(0.31));
  return {sum.value, sum.error + add(slope, z.error, rest)};
}

// angle/|v| of the nearer way for |q|^2 = 1 + excess: with 1/|q| = 1 + r it is (1 + r) times the above of
// z = 1 - |w| (1 + r).
template <class Arithmetic, class Number>
QTRAJ_INLINE DoubleDoubleOf<Number> near_factor(Number w, Number excess) {
  const auto add = [](Number a, Number b, Number c) { return Arithmetic::multiply_add(a, b, c); };
  const Number r = excess * add(Number(0.375), excess, Number(-0.5)), above = absolute(w);
  const DoubleDoubleOf<Number> below_one = fast_two_sum(Number(1.0), -above);
  const DoubleDoubleOf<Number> z = fast_two_sum(below_one.value, add(-above, r, below_one.error));
  const DoubleDoubleOf<Number> ratio = precise_acos_ratio<Arithmetic>(z);
  return {ratio.value, add(ratio.value + ratio.error, r, ratio.error)};
}

// The same of the way round the other side, pi/|v| less; |v| is given with 1/|v|.
template <class Arithmetic, class Number>
QTRAJ_INLINE DoubleDoubleOf<Number> far_factor(const DoubleDoubleOf<Number>& near, const RootOf<Number>& sine,
                                               Number inverse) {
  const Number pi(0x1.921fb54442d18p+1), pi_error(0x1.1a62633145c07p-53);
  const Number quotient = pi * inverse, left = residual<Arithmetic>(pi, quotient, sine.value) + pi_error;
  const Number error = Arithmetic::multiply_add(-quotient, relative_error_of(sine, inverse), left * inverse);
  const DoubleDoubleOf<Number> difference = fast_two_sum(quotient, -near.value);
  return {difference.value, difference.error + (error - near.error)};
}

// That of the side on which w is.
template <class Arithmetic, class Number>
QTRAJ_INLINE DoubleDoubleOf<Number> nearer_or_far(const DoubleDoubleOf<Number>& near, Number w,
                                                  const RootOf<Number>& sine, Number inverse) {
  const DoubleDoubleOf<Number> far = far_factor<Arithmetic>(near, sine, inverse);
  const auto is_far = w < Number(0.0);
  return {select(is_far, far.value, near.value), select(is_far, far.error, near.error)};
}

// A vector part this short beside w < 0 goes the way of any quaternion.
constexpr double kLeastFarSquare = 0x1p-40;

// |v|, or that least one where it is shorter.
template <class Arithmetic, class Number>
QTRAJ_INLINE RootOf<Number> near_sine(const SquaresOf<Number>& squares) {
  const DoubleDoubleOf<Number> square = fast_two_sum(squares.vector.value, squares.vector.error);
  return root_of<Arithmetic>(DoubleDoubleOf<Number>{maximum(square.value, Number(kLeastFarSquare)), square.error});
}

// ---- The two functions ----

// The half-angle vector of q.
struct LogOf {
  static constexpr bool kGoesFar = true;  // to angles past pi/2, for which near rows need |v|

  // The angle is that of the point (side, |v|), and what is wanted `turns` of it.
  template <class Number>
  QTRAJ_INLINE static Number side(Number w) {
    return w;
  }
  template <class Number>
  QTRAJ_INLINE static Number turns(Number) {
    return Number(Element<Number>(1));
  }
  template <class Arithmetic, class Number>
  QTRAJ_INLINE static auto is_near(const Number (&q)[4], const SquaresOf<Number>& squares) {
    return is_near_one(squares.excess) & ((Number(0.0) <= q[0]) | (Number(kLeastFarSquare) <= squares.vector.value));
  }
};

// The rotation vector of the shorter way, twice the log of q or -q.
struct RotationVectorOf {
  static constexpr bool kGoesFar = false;

  template <class Number>
  QTRAJ_INLINE static Number side(Number w) {
    return absolute(w);
  }
  template <class Number>
  QTRAJ_INLINE static Number turns(Number w) {
    using Real = Element<Number>;
    return select(w < Number(Real(0)), Number(Real(-2)), Number(Real(2)));
  }
  template <class Arithmetic, class Number>
  QTRAJ_INLINE static auto is_near(const Number (&)[4], const SquaresOf<Number>& squares) {
    return is_near_one(squares.excess);
  }
};

template <class Function, class Number>
QTRAJ_INLINE DoubleDoubleOf<Number> times_turns(const DoubleDoubleOf<Number>& factor, Number w) {
  const Number turns = Function::turns(w);
  return {turns * factor.value, turns * factor.error};
}

template <class Function, class Arithmetic, class Number>
QTRAJ_INLINE DoubleDoubleOf<Number> factor_of_near(Number w, const SquaresOf<Number>& squares) {
  DoubleDoubleOf<Number> factor = near_factor<Arithmetic>(w, squares.excess);
  if constexpr (Function::kGoesFar) {
    const RootOf<Number> sine = near_sine<Arithmetic>(squares);
    factor = nearer_or_far<Arithmetic>(factor, w, sine, Number(1.0) / sine.value);
  }
  return times_turns<Function>(factor, w);
}

// The factor of rows of any kind; false where one is singular: beside -1 the axis of a log must be found from a tiny
// vector part, or there is none. |v|^2 is given.
template <class Function, class Arithmetic, class Number>
QTRAJ_INLINE bool find_factor(const Number (&q)[4], const DoubleDoubleOf<Number>& square,
                              DoubleDoubleOf<Number>& factor) {
  if (Function::kGoesFar && any((q[0] < Number(0.0)) & (square.value < Number(kLeastSineSquare)))) return false;
  factor = times_turns<Function>(angle_over_sine<Arithmetic>(square, Function::side(q[0])), q[0]);
  if constexpr (!kIsFused<Arithmetic>) return true;
  const auto is_near = Function::template is_near<Arithmetic>(q, squares_near_one<Arithmetic>(q));
  if (!any(is_near)) return true;
  // the other lanes stand for 1, so that nothing overflows
  const Number zero(0.0), near[4] = {select(is_near, q[0], Number(1.0)), select(is_near, q[1], zero),
                                     select(is_near, q[2], zero), select(is_near, q[3], zero)};
  const DoubleDoubleOf<Number> of_near =
      factor_of_near<Function, Arithmetic>(near[0], squares_near_one<Arithmetic>(near));
  factor = {select(is_near, of_near.value, factor.value), select(is_near, of_near.error, factor.error)};
  return true;
}

// One vector of rows of any kind. False where a row is not ordinary, or singular.
template <class Function, class Arithmetic, class Number>
QTRAJ_INLINE bool log_of_any(const UnaryRows<4, 3>& rows, size_t row) {
  using Real = Element<Number>;
  Number q[4], v[3];
  DoubleDoubleOf<Number> factor;
  if (!load_rows<Real>(rows.in, row, q)) return false;
  const Number vector[3] = {q[1], q[2], q[3]};
  if (!find_factor<Function, Arithmetic>(q, precise_square<Arithmetic>(vector), factor)) return false;
  for (size_t k = 0; k < 3; ++k) v[k] = rounded_product<Arithmetic>(factor, vector[k]);
  store_rows(v, static_cast<Real*>(rows.out.data), row);
  return true;
}

// What one loop over a tile of nearly unit rows leaves for the next. A log is one long dependency chain, and the
// out-of-order window is too small to overlap it with those of other rows; short loops are bound by throughput instead
// of latency.
template <class Number>
struct LogTile {
  static constexpr size_t kVectors = 4;
  Number w[kVectors], vector[kVectors][3];
  Number excess[kVectors];                                       // of squares
  Number sine[kVectors], residual[kVectors], inverse[kVectors];  // near_sine and 1/sine, where they are needed
  Number factor[kVectors], factor_error[kVectors];
};

// How many rows from `row` on, up to a tile, were done before one that is not nearly unit.
template <class Function, class Arithmetic, class Number>
QTRAJ_INLINE size_t log_near_rows(const UnaryRows<4, 3>& rows, size_t row, size_t count) {
  using Real = Element<Number>;
  Real* const out = static_cast<Real*>(rows.out.data);
  constexpr size_t kLanes = kLanesOf<Number>;
  const size_t most = (count - row) / kLanes;
  LogTile<Number> tile;
  size_t done = 0;
  for (; done < most && done < tile.kVectors; ++done) {
    Number q[4];
    if (!load_numbers<Real>(rows.in, row + done * kLanes, q) || any(reaches_two(q))) break;
    const SquaresOf<Number> squares = squares_near_one<Arithmetic>(q);
    if (!all(Function::template is_near<Arithmetic>(q, squares))) break;
    tile.w[done] = q[0];
    for (size_t i = 0; i < 3; ++i) tile.vector[done][i] = q[i + 1];
    tile.excess[done] = squares.excess;
    if constexpr (Function::kGoesFar) {
      const RootOf<Number> sine = near_sine<Arithmetic>(squares);
      tile.sine[done] = sine.value;
      tile.residual[done] = sine.residual;
    }
  }
  for (size_t k = 0; k < done; ++k) {
    const DoubleDoubleOf<Number> factor = near_factor<Arithmetic>(tile.w[k], tile.excess[k]);
    tile.factor[k] = factor.value;
    tile.factor_error[k] = factor.error;
    if constexpr (Function::kGoesFar) tile.inverse[k] = Number(1.0) / tile.sine[k];
  }
  for (size_t k = 0; k < done; ++k) {
    DoubleDoubleOf<Number> factor = {tile.factor[k], tile.factor_error[k]};
    if constexpr (Function::kGoesFar)
      factor = nearer_or_far<Arithmetic>(factor, tile.w[k], {tile.sine[k], tile.residual[k]}, tile.inverse[k]);
    factor = times_turns<Function>(factor, tile.w[k]);
    Number v[3];
    prefetch_output<Real, 3, kLanes>(out, row + k * kLanes, count);
    for (size_t i = 0; i < 3; ++i) v[i] = rounded_product<Arithmetic>(factor, tile.vector[k][i]);
    store_rows(v, out, row + k * kLanes);
  }
  return done * kLanes;
}

// ---- In float ----

// A vector part shorter than 2^-50 is taken for that long, as above: beside it |w| >= 2^-30.
constexpr float kLeastSineSquareInFloat = 0x1p-100f;

// To 4 eps of float: the length of the vector part is good to 2.5 u, u = eps/2, and enters with at most 1.22 of that,
// the angle adds 2.5 u, the quotient and the product one u each.
template <class Function, class Arithmetic, class FloatNumber>
QTRAJ_INLINE bool log_float_rows(const UnaryRows<4, 3>& rows, size_t row, size_t count) {
  float* const out = static_cast<float*>(rows.out.data);
  FloatNumber q[4], v[3];
  prefetch_output<float, 3, kLanesOf<FloatNumber>>(out, row, count);
  if (!load_rows<float>(rows.in, row, q)) return false;
  const FloatNumber vector[3] = {q[1], q[2], q[3]}, least(kLeastSineSquareInFloat);
  const FloatNumber square = dot_product<Arithmetic>(vector, vector);
  if (Function::kGoesFar && any((q[0] < FloatNumber(0.0f)) & (square < least))) return false;
  const FloatNumber sine = square_root(maximum(square, least));
  const FloatNumber factor = Function::turns(q[0]) * angle_of_point<Arithmetic>(sine, Function::side(q[0])) / sine;
  for (size_t k = 0; k < 3; ++k) v[k] = factor * vector[k];
  store_rows(v, out, row);
  return true;
}

template <class Function, class Arithmetic, class Number, class FloatNumber>
size_t logs(const UnaryRows<4, 3>& rows, size_t first, size_t count) {
  if (rows.out.is_float)
    return do_rows<FloatNumber>(
        first, count, [&](size_t row) { return log_float_rows<Function, Arithmetic, FloatNumber>(rows, row, count); });
  size_t row = first;
  while (count - row >= kLanesOf<Number>) {
    if constexpr (kIsFused<Arithmetic>) {
      const size_t near = log_near_rows<Function, Arithmetic, Number>(rows, row, count);
      row += near;
      if (near > 0) continue;
    }
    if (!log_of_any<Function, Arithmetic, Number>(rows, row)) break;
    row += kLanesOf<Number>;
  }
  return row - first;
}

}  // namespace
}  // namespace qtraj

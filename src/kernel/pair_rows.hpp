// Slerp and nlerp, pair by pair, where nothing is singular: fractions between 0 and 1, angles of at most a quarter turn
// of S^3. The rest is done by pair.cpp.
#pragma once

#include "array_rows.hpp"
#include "near_one.hpp"

namespace qtraj {
namespace {

// Cosine of the angle between a and +-b below which a pair is none of ours.
constexpr double kLeastPairCosine = 0x1p-20;

// q = from_a a + from_b b, where a and b may have any length.
template <class Number>
struct PairWeights {
  Number from_a, from_b;
};

// Weights that make unit vectors of a and b, b with the sign that the path asks for; and the cosine between these.
template <class Number>
struct UnitWeights {
  Number from_a, from_b, cosine;
};
template <class Arithmetic, class Number>
QTRAJ_INLINE UnitWeights<Number> unit_weights(const Number (&a)[4], const Number (&b)[4], bool is_shortest) {
  const Number one(1.0), aa = dot<Arithmetic>(a, a), bb = dot<Arithmetic>(b, b);
  const Number a_excess = aa - one, b_excess = bb - one;
  UnitWeights<Number> unit;
  unit.from_a = inverse_root_near_one<Arithmetic>(a_excess);
  unit.from_b = inverse_root_near_one<Arithmetic>(b_excess);
  const auto a_is_near = is_near_one(a_excess), b_is_near = is_near_one(b_excess);
  const auto is_near = a_is_near & b_is_near;
  if (!all(is_near)) {
    // one division for both: the square root of |b|^2 / (|a|^2 |b|^2), and the other way round
    const Number inverse = one / (aa * bb);
    unit.from_a = select(is_near, unit.from_a, square_root(bb * inverse));
    unit.from_b = select(is_near, unit.from_b, square_root(aa * inverse));
  }
  unit.cosine = dot<Arithmetic>(a, b) * unit.from_a * unit.from_b;
  if (is_shortest) {
    const auto is_opposed = unit.cosine < Number(0.0);
    unit.from_b = select(is_opposed, -unit.from_b, unit.from_b);
    unit.cosine = select(is_opposed, -unit.cosine, unit.cosine);
  }
  return unit;
}

// sin((1 - f) theta)/sin theta and sin(f theta)/sin theta (K. Shoemake, "Animating rotation with quaternion curves",
// SIGGRAPH 1985, section 3.3) without theta: z = 1 - cos theta, g = theta/sin theta a polynomial in z,
// theta^2 = g^2 z (2 - z), sin(f theta)/sin theta = f g sinc(f theta).
template <class Arithmetic, class Number>
QTRAJ_INLINE PairWeights<Number> slerp_weights(Number cosine, Number fraction) {
  const Number one(1.0), two(2.0);
  const Number z = one - cosine, rest = one - fraction;
  const Number g = evaluate<Arithmetic, AcosRatio>(z);
  const Number angle_squared = (g * g) * (z * (two - z));
  const auto weight = [&](Number part) {
    return (part * g) * evaluate<Arithmetic, SincHalf>(part * part * angle_squared);
  };
  return {weight(rest), weight(fraction)};
}

struct SlerpRow {
  template <class Arithmetic, class Number>
  QTRAJ_INLINE static PairWeights<Number> weights(Number cosine, Number fraction) {
    return slerp_weights<Arithmetic>(cosine, fraction);
  }
  // Of a length that is 1 to a few eps.
  template <class Arithmetic, class Number>
  QTRAJ_INLINE static void normalize(Number (&q)[4]) {
    newton_normalize<Arithmetic>(q);
  }
};

struct NlerpRow {
  template <class Arithmetic, class Number>
  QTRAJ_INLINE static PairWeights<Number> weights(Number, Number fraction) {
    return {Number(1.0) - fraction, fraction};
  }
  template <class Arithmetic, class Number>
  QTRAJ_INLINE static void normalize(Number (&q)[4]) {
    const Number scale = Number(1.0) / square_root(dot<Arithmetic>(q, q));
    for (Number& component : q) component = component * scale;
    newton_normalize<Arithmetic>(q);
  }
};

template <class Curve, class Arithmetic, class Real, class Number>
QTRAJ_INLINE bool interpolate_rows(const PairArrays& arrays, size_t row) {
  Number a[4], b[4], fraction[1];
  if (!load_rows<Real>(arrays.a, row, a) || !load_rows<Real>(arrays.b, row, b)) return false;
  if (!load_fractions<Real>(arrays.fraction, row, fraction)) return false;

  const UnitWeights<Number> unit = unit_weights<Arithmetic>(a, b, arrays.path == Path::shortest);
  if (!all(Number(kLeastPairCosine) <= unit.cosine)) return false;
  const PairWeights<Number> weights = Curve::template weights<Arithmetic>(unit.cosine, fraction[0]);
  const Number from_a = weights.from_a * unit.from_a, from_b = weights.from_b * unit.from_b;
  Number q[4];
  for (size_t k = 0; k < 4; ++k) q[k] = Arithmetic::multiply_add(from_b, b[k], from_a * a[k]);
  Curve::template normalize<Arithmetic>(q);
  store_rows(q, static_cast<Real*>(arrays.q), row);
  return true;
}

template <class Curve, class Arithmetic, class Vector>
size_t interpolate(const PairArrays& arrays, size_t first, size_t count) {
  return do_rows<Vector>(arrays.single, first, count, [&](size_t row, auto number, auto real) {
    return interpolate_rows<Curve, Arithmetic, decltype(real), decltype(number)>(arrays, row);
  });
}

}  // namespace
}  // namespace qtraj

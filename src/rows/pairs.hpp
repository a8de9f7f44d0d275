// Slerp and nlerp of pairs where nothing is singular: fractions between 0 and 1, ends of ordinary norm and less than a
// quarter turn of S^3 apart. All other rows go back to the core, functions/pairs.cpp.
#pragma once

#include "math/unit_quaternion.hpp"
#include "rows/row_loop.hpp"
#include "simd/prefetch.hpp"

namespace qtraj {
namespace {

// Pairs with a smaller cosine between a and +-b go back to the core.
constexpr double kLeastPairCosine = 0x1p-20;

// q = from_a a + from_b b, where a and b may have any length.
template <class Number>
struct PairWeights {
  Number from_a, from_b;
};

// Factors that make a and b unit, b with the sign that the path asks for, and the cosine between the two unit vectors.
template <class Number>
struct UnitWeights {
  Number from_a, from_b, cosine;
};
// False where an a or a b is not ordinary. The caller has already excluded those with a component of magnitude 2 or
// more (reaches_two), whose squares might overflow.
template <class Arithmetic, class Number>
QTRAJ_INLINE bool find_unit_weights(const Number (&a)[4], const Number (&b)[4], bool is_shortest,
                                    UnitWeights<Number>& unit) {
  const Number one(1.0), aa = dot_product<Arithmetic>(a, a), bb = dot_product<Arithmetic>(b, b);
  const Number a_excess = aa - one, b_excess = bb - one;
  unit.from_a = inverse_root_near_one<Arithmetic>(a_excess);
  unit.from_b = inverse_root_near_one<Arithmetic>(b_excess);
  const auto a_is_near = is_near_one(a_excess), b_is_near = is_near_one(b_excess);
  const auto is_near = a_is_near & b_is_near;
  if (!all(is_near)) {
    if (!all(is_ordinary(a)) || !all(is_ordinary(b))) return false;
    // one division serves both: 1/|a| is the square root of |b|^2 / (|a|^2 |b|^2), 1/|b| that of |a|^2 / (|a|^2 |b|^2)
    const Number inverse = one / (aa * bb);
    unit.from_a = select(is_near, unit.from_a, square_root(bb * inverse));
    unit.from_b = select(is_near, unit.from_b, square_root(aa * inverse));
  }
  unit.cosine = dot_product<Arithmetic>(a, b) * unit.from_a * unit.from_b;
  if (is_shortest) {
    const auto is_opposed = unit.cosine < Number(0.0);
    unit.from_b = select(is_opposed, -unit.from_b, unit.from_b);
    unit.cosine = select(is_opposed, -unit.cosine, unit.cosine);
  }
  return true;
}

// sin((1 - f) theta)/sin theta and sin(f theta)/sin theta (K. Shoemake, "Animating rotation with quaternion curves",
// SIGGRAPH 1985, section 3.3) without theta: z = 1 - cos theta, g = theta/sin theta a polynomial in z,
// theta^2 = g^2 z (2 - z), sin(f theta)/sin theta = f g sinc(f theta).
template <class Arithmetic, class Number>
QTRAJ_INLINE PairWeights<Number> slerp_weights(Number cosine, Number fraction) {
  const Number one(1.0), two(2.0);
  const Number z = one - cosine, complement = one - fraction;
  const Number g = evaluate<Arithmetic, AcosRatio>(z);
  const Number angle_squared = (g * g) * (z * (two - z));
  const auto weight = [&](Number part) {
    return (part * g) * evaluate<Arithmetic, SincHalf>(part * part * angle_squared);
  };
  return {weight(complement), weight(fraction)};
}

struct SlerpBlend {
  template <class Arithmetic, class Number>
  QTRAJ_INLINE static PairWeights<Number> weights(Number cosine, Number fraction) {
    return slerp_weights<Arithmetic>(cosine, fraction);
  }
  // q is unit to a few eps already.
  template <class Arithmetic, class Number>
  QTRAJ_INLINE static void normalize(Number (&q)[4]) {
    newton_normalize<Arithmetic>(q);
  }
};

struct NlerpBlend {
  template <class Arithmetic, class Number>
  QTRAJ_INLINE static PairWeights<Number> weights(Number, Number fraction) {
    return {Number(1.0) - fraction, fraction};
  }
  template <class Arithmetic, class Number>
  QTRAJ_INLINE static void normalize(Number (&q)[4]) {
    const Number scale = Number(1.0) / square_root(dot_product<Arithmetic>(q, q));
    for (Number& component : q) component = component * scale;
    newton_normalize<Arithmetic>(q);
  }
};

// ---- Tiles of pairs: three short loops go over each tile ----

// What one loop over a tile leaves for the next. A slerp is one long dependency chain, and the out-of-order window is
// too small to overlap it with those of other rows; short loops are bound by throughput instead of latency.
struct PairTile {
  static constexpr size_t kRows = 32;
  double fraction[kRows], cosine[kRows], unit_a[kRows], unit_b[kRows];  // of the first loop: fractions and UnitWeights
  double from_a[kRows], from_b[kRows];                                  // of the second loop: PairWeights
};

template <class Arithmetic, class Real, class Number>
QTRAJ_INLINE bool relate_rows(const PairRows& pairs, size_t row, Number& fraction, UnitWeights<Number>& unit) {
  Number a[4], b[4], given[1];
  if (!load_numbers<Real>(pairs.a, row, a) || !load_numbers<Real>(pairs.b, row, b)) return false;
  const Number both[] = {a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]};
  if (any(reaches_two(both)) && !(all(is_ordinary(a)) && all(is_ordinary(b)))) return false;
  if (!load_fractions<Real>(pairs.fraction, row, given)) return false;
  fraction = given[0];
  return find_unit_weights<Arithmetic>(a, b, pairs.path == Path::shortest, unit) &&
         all(Number(kLeastPairCosine) <= unit.cosine);
}

// The first loop. How many rows from `first` on, up to `rows`, come before one that goes back to the core.
template <class Arithmetic, class Real, class Number>
QTRAJ_INLINE size_t relate_pairs(const PairRows& pairs, size_t first, size_t rows, PairTile& tile) {
  size_t row = 0;
  for (; row < rows; row += kLanesOf<Number>) {
    Number fraction;
    UnitWeights<Number> unit;
    if (!relate_rows<Arithmetic, Real>(pairs, first + row, fraction, unit)) break;
    store_lanes(fraction, &tile.fraction[row]);
    store_lanes(unit.cosine, &tile.cosine[row]);
    store_lanes(unit.from_a, &tile.unit_a[row]);
    store_lanes(unit.from_b, &tile.unit_b[row]);
  }
  return row;
}

// The second loop.
template <class Blend, class Arithmetic, class Number>
QTRAJ_INLINE void weigh_pairs(size_t rows, PairTile& tile) {
  for (size_t row = 0; row < rows; row += kLanesOf<Number>) {
    const auto load = [&](const double(&numbers)[PairTile::kRows]) { return load_lanes(&numbers[row], Number()); };
    const PairWeights<Number> weights = Blend::template weights<Arithmetic>(load(tile.cosine), load(tile.fraction));
    store_lanes(weights.from_a * load(tile.unit_a), &tile.from_a[row]);
    store_lanes(weights.from_b * load(tile.unit_b), &tile.from_b[row]);
  }
}

// The third loop; the pairs have `count` rows.
template <class Blend, class Arithmetic, class Real, class Number>
QTRAJ_INLINE void combine_pairs(const PairRows& pairs, size_t first, size_t rows, size_t count, const PairTile& tile) {
  Real* const out = static_cast<Real*>(pairs.q.data);
  for (size_t row = 0; row < rows; row += kLanesOf<Number>) {
    Number a[4], b[4], q[4];
    prefetch_output<Real, 4, kLanesOf<Number>>(out, first + row, count);
    read_numbers<Real>(pairs.a, first + row, a);
    read_numbers<Real>(pairs.b, first + row, b);
    const Number from_a = load_lanes(&tile.from_a[row], Number()), from_b = load_lanes(&tile.from_b[row], Number());
    for (size_t k = 0; k < 4; ++k) q[k] = Arithmetic::multiply_add(from_b, b[k], from_a * a[k]);
    Blend::template normalize<Arithmetic>(q);
    store_rows(q, out, first + row);
  }
}

// Does one tile of up to `rows` rows from `first` on and tells how many; the pairs have `count` rows.
template <class Blend, class Arithmetic, class Real, class Number>
size_t blend_tile(const PairRows& pairs, size_t first, size_t rows, size_t count) {
  PairTile tile;
  const size_t done = relate_pairs<Arithmetic, Real, Number>(pairs, first, rows, tile);
  weigh_pairs<Blend, Arithmetic, Number>(done, tile);
  combine_pairs<Blend, Arithmetic, Real, Number>(pairs, first, done, count, tile);
  return done;
}

template <class Blend, class Arithmetic, class Number>
size_t blend_pairs(const PairRows& pairs, size_t first, size_t count) {
  const auto blend_all = [&](auto real) {
    size_t row = first;
    while (count - row >= kLanesOf<Number>) {
      const size_t left = count - row, rows = left < PairTile::kRows ? left - left % kLanesOf<Number> : PairTile::kRows;
      const size_t done = blend_tile<Blend, Arithmetic, decltype(real), Number>(pairs, row, rows, count);
      row += done;
      if (done < rows) break;
    }
    return row - first;
  };
  return pairs.q.is_float ? blend_all(float()) : blend_all(double());
}

}  // namespace
}  // namespace qtraj

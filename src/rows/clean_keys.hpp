// The kernel that cleans keyframes (methods/keyframes.hpp): keys made unit in double-double and continuous in sign.
// Plain arithmetic: the same bits in the core and in kernels of either arithmetic.
#pragma once

#include "math/unit_quaternion.hpp"
#include "rows/padded_rows.hpp"

namespace qtraj {
namespace {

// Whether a component is not 0 but so small that two_product with it may not be exact. Vectors then get another error
// than single rows, because they compute it by FMA where there is one and single rows never do.
template <class Number>
QTRAJ_INLINE bool has_tiny(const Number (&q)[4]) {
  const Number zero(0.0), least(0x1p-440);
  const auto is_tiny = [&](Number component) {
    const Number magnitude = absolute(component);
    return (zero < magnitude) & (magnitude < least);
  };
  return any((is_tiny(q[0]) | is_tiny(q[1])) | (is_tiny(q[2]) | is_tiny(q[3])));
}

// What is found in keys, lane by lane.
template <class Number>
struct KeyExtremes {
  Number worst_norm_error, least_dot;
};

// The cosines between keys and those before them; 1 of the first key.
template <class Number>
QTRAJ_INLINE Number cosines(const CleanRows& rows, size_t row, const Number (&q)[4]) {
  Number before[4];
  for (size_t k = 0; k < 4; ++k) before[k] = preceded_by(row == 0 ? 0.0 : rows.unit[row - 1][k], q[k]);
  const Number cosine = dot_product<Plain>(before, q);
  return row == 0 ? select(lanes_of(1u, Number()), Number(1.0), cosine) : cosine;
}

template <class Number>
QTRAJ_INLINE size_t clean_vector(const CleanRows& rows, size_t row, size_t lanes, KeyExtremes<Number>& found) {
  Number q[4];
  if (!load_padded(rows.q, row, lanes, q) || !all(is_ordinary(q)) || has_tiny(q)) return 0;
  UnitOf<Number> unit = unit_of(q);

  // A key is negated where the number of opposed neighbours up to it is odd: products of negated keys are negated
  // products. Where two keys are half a turn apart the core looks at the sign of a zero.
  const Number zero(0.0), one(1.0), cosine = cosines(rows, row, unit.value);
  const size_t done = lanes_before(absolute(cosine) < Number(0x1p-40), lanes);
  const unsigned done_bits = first_lanes(done);
  const unsigned flipped = rows.keeps_signs ? 0 : parities(lane_bits(cosine < zero)) & done_bits;
  const auto is_flipped = lanes_of(flipped, Number()), is_done = lanes_of(done_bits, Number());
  for (size_t k = 0; k < 4; ++k) {
    unit.value[k] = select(is_flipped, -unit.value[k], unit.value[k]);
    unit.error[k] = select(is_flipped, -unit.error[k], unit.error[k]);
  }
  store_padded(unit.value, rows.unit[row], done);
  store_padded(unit.error, rows.unit_error[row], done);

  rows.report->sign_flips += static_cast<size_t>(__builtin_popcount(flipped));
  found.worst_norm_error = maximum(found.worst_norm_error, absolute(unit.length.value - one));
  found.least_dot = minimum(found.least_dot, select(is_done, absolute(cosine), one));
  return done;
}

template <class Number>
size_t clean_keys(const CleanRows& rows, size_t first, size_t count) {
  KeyExtremes<Number> found = {Number(rows.report->worst_norm_error), Number(rows.report->least_dot)};
  const size_t done =
      do_padded<Number>(first, count, [&](size_t row, size_t lanes) { return clean_vector(rows, row, lanes, found); });
  rows.report->worst_norm_error = largest_lane(found.worst_norm_error);
  rows.report->least_dot = -largest_lane(-found.least_dot);
  return done;
}

}  // namespace
}  // namespace qtraj

// Preparation of arrays of keys: normalisation, continuity of signs, component order.
#pragma once

#include "functions/for_each_row.hpp"
#include "rows/arguments.hpp"

namespace qtraj {

// Whether <a, b> < 0, both finite and not 0. The sign is that of the exact dot product as long as no product of two
// components is below 1e-270 |a| |b|; such products may be lost.
bool is_opposed(const Quaternion& a, const Quaternion& b);

// q / |q|; signs are kept, also those of zeros. Each component is within 0.51 ulp of the output's type, plus 1e-200, so
// that the norm is within 1.1 eps of 1.
Outcome normalize_keys(const NormalizeRows& rows, size_t count);

// Negates keys such that neighbours have <q_{i-1}, q_i> >= 0, in each of several series of `length` keys that follow
// each other. The first key of a series keeps its sign, and so does a key in a tie; nothing but signs is changed. A
// faulty key becomes NaN, and the one after it is compared with the last good one. *rows.flips: how many keys were
// negated.
Outcome make_continuous(const ContinuousRows& rows, size_t series, size_t length);

// The same for series along any axis: key k of series s is row s * series_stride + k * key_stride of both arrays, and
// no two keys share a row. The index of an outcome is s * length + k.
struct SeriesLayout {
  size_t series, series_stride, length, key_stride;

  // Rows from the first key to the last, of at least one key; SIZE_MAX where there are that many or more.
  size_t extent() const;
  // Whether keys are apart: the keys of one series lie before those of the next, or all first keys before all second.
  bool is_apart() const;
};
Outcome make_continuous(const ContinuousRows& rows, const SeriesLayout& layout);

// Change of component order. Numbers of element_bytes, 4 or 8, are moved as they are, whatever their bits; the output
// may be the input.
void wxyz_from_xyzw(const void* q_xyzw, size_t element_bytes, size_t count, void* q_out);
void xyzw_from_wxyz(const void* q, size_t element_bytes, size_t count, void* q_xyzw_out);

}  // namespace qtraj

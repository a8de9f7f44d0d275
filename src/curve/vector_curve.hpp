// The handle of a curve of vectors, such as positions: one block of memory, this record first, then knots, their guide,
// scales, keys and shapes, found by offsets so that the block can be copied. Immutable once built
// (methods/vector_builder.hpp). Kernels include this header: it holds plain data, and functions of internal linkage.
#pragma once

#include "curve/timeline.hpp"

namespace qtraj {

struct VectorCurve {
  static constexpr uint64_t kTag = 0x6365766a61727471;  // "qtrajvec"
  uint64_t tag;  // kTag from the end of construction until the handle is destroyed
  Timeline timeline;
  Method method;
  size_t dim;
  size_t terms;     // rows of shape for each segment: 0 where the curve is made of lines or of keys, 2 cubic, 4 quintic
  bool holds_keys;  // STEP
  bool is_ordinary;  // no scales, and nothing that is made of its numbers can overflow: all are below 2^300, and
                     // intervals above 2^-200 s
  bool on_heap;
  size_t scales_offset, keys_offset, shapes_offset;  // bytes from here
};

// [dim], powers of two: components of extreme size are kept as multiples of 1/scale.
static inline const double* scales_of(const VectorCurve& curve) {
  return at_offset<double>(curve, curve.scales_offset);
}
// [key_count][dim]
static inline const double* vector_keys_of(const VectorCurve& curve) {
  return at_offset<double>(curve, curve.keys_offset);
}
// [key_count - 1][terms][dim]
static inline const double* shapes_of(const VectorCurve& curve) {
  return at_offset<double>(curve, curve.shapes_offset);
}

// One segment: rows of `dim` numbers. Where keys are held, both ends are the first.
struct VectorSegment {
  const double *left, *right, *shape;
  double h;  // s
};
static inline VectorSegment vector_segment(const VectorCurve& curve, size_t segment) {
  const double* knots = knots_of(curve.timeline);
  const double* left = vector_keys_of(curve) + segment * curve.dim;
  return {left, curve.holds_keys ? left : left + curve.dim, shapes_of(curve) + segment * curve.terms * curve.dim,
          knots[segment + 1] - knots[segment]};
}

}  // namespace qtraj

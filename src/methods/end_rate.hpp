#pragma once

#include "methods/keyframes.hpp"

namespace qtraj {

enum class Side { start, end };

// Body rate of the slerp over a segment, rad/s.
Vector3 chord_rate(const Keyframes& keys, size_t segment);

// Body rate at an end of the keys, rad/s, by the Lagrange derivative there of the rotation vectors from the end key to
// its `most` neighbours, unwrapped outwards: order `most` in the spacing. Fewer neighbours where there are fewer keys
// or where the weights, in units of the end interval, would sum to more than 20 (uniform knots, three neighbours: 4.8):
// on ragged knots larger weights spin the end segment.
Vector3 estimated_end_rate(const Keyframes& keys, Side side, size_t most, double epsilon);

}  // namespace qtraj

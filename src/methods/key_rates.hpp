// Rates of a curve at its keys, for builders: given by the caller, of the chord, or estimated at an end.
#pragma once

#include "methods/method.hpp"

namespace qtraj {

// ---- Given ----

// Rates given at a key, for a segment of length h that begins or ends there, in the body frame of the key and in units
// of the segment: h omega and h^2 alpha. False where a component is past `limit`.
bool given_scaled_omega(const Construction& construction, size_t key, double h, double limit, Vector3& scaled);
bool given_scaled_alpha(const Construction& construction, size_t key, double h, double limit, Vector3& scaled);

// h v in the body frame of q_wb; v in `frame`.
bool scaled_to_body(const Vector3& v, Frame frame, const Quaternion& q_wb, double h, double limit, Vector3& scaled);

// ---- From the keys ----

enum class Side { start, end };

// Body rate of the slerp over a segment, rad/s.
Vector3 chord_rate(const Keyframes& keys, size_t segment);

// Body rate at an end of the keys, rad/s, by the Lagrange derivative there of the rotation vectors from the end key to
// its `most` neighbours, unwrapped outwards: order `most` in the spacing. Fewer neighbours where there are fewer keys
// or where the weights, in units of the end interval, would sum to more than 20 (uniform knots, three neighbours: 4.8):
// on ragged knots larger weights spin the end segment. `steps`, the half-angle vectors of the steps from the end
// inwards, say how often these turn; null where each is the shorter turn.
constexpr size_t kMostNeighbours = 3;
Vector3 estimated_end_rate(const Keyframes& keys, Side side, size_t most, double epsilon,
                           const Vector3* steps = nullptr);

}  // namespace qtraj

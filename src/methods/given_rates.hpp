#pragma once

#include "methods/method.hpp"

namespace qtraj {

// Rates given at a key, for a segment of length h that begins or ends there, in the body frame of the key and in units
// of the segment: h omega and h^2 alpha. False where a component is past `limit`.
bool given_scaled_omega(const Construction& construction, size_t key, double h, double limit, Vector3& scaled);
bool given_scaled_alpha(const Construction& construction, size_t key, double h, double limit, Vector3& scaled);

// h v in the body frame of q_wb; v in `frame`.
bool scaled_to_body(const Vector3& v, Frame frame, const Quaternion& q_wb, double h, double limit, Vector3& scaled);

}  // namespace qtraj

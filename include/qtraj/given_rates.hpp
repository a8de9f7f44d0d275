#pragma once

#include "qtraj/method.hpp"

namespace qtraj {

// Rates given at a key, for a segment of length h that begins or ends there, in the body frame of the key and in units
// of the segment: rise = h omega, bend = h^2 alpha. False where a component is past `limit`.
bool given_rise(const Construction& construction, size_t key, double h, double limit, Vector3& rise);
bool given_bend(const Construction& construction, size_t key, double h, double limit, Vector3& bend);

// h v in the body frame of q_wb; v in `frame`.
bool scaled_to_body(const Vector3& v, Frame frame, const Quaternion& q_wb, double h, double limit, Vector3& scaled);

}  // namespace qtraj

#include "methods/given_rates.hpp"

#include "math/so3.hpp"

namespace qtraj {
namespace {

// h v, component by component; false where one is past the limit, before any product can overflow.
bool scale(const Vector3& v, double h, double limit, Vector3& scaled) {
  if (h > 1.0 && largest_component(v) > limit / h) return false;
  scaled = h * v;
  return largest_component(scaled) <= limit;
}

Vector3 in_body(const Vector3& v, Frame frame, const Quaternion& q_wb) {
  return frame == Frame::world ? to_body(q_wb, v) : v;
}

}  // namespace

bool scaled_to_body(const Vector3& v, Frame frame, const Quaternion& q_wb, double h, double limit, Vector3& scaled) {
  if (!scale(v, h, limit, scaled)) return false;
  scaled = in_body(scaled, frame, q_wb);
  return true;
}

bool given_scaled_omega(const Construction& construction, size_t key, double h, double limit, Vector3& scaled) {
  return scaled_to_body(row_of(construction.input.omega, key), construction.rate_frame, construction.keys[key].value, h,
                        limit, scaled);
}

bool given_scaled_alpha(const Construction& construction, size_t key, double h, double limit, Vector3& scaled) {
  const Vector3 alpha = row_of(construction.input.alpha, key);
  // h alpha may be past the limit where h^2 alpha is not, and the other way round
  Vector3 once;
  constexpr double kAnything = 0x1p1020;
  const double first_limit = h > 1.0 ? limit / h : kAnything;
  if (!scale(alpha, h, first_limit, once) || !scale(once, h, limit, scaled)) return false;
  scaled = in_body(scaled, construction.rate_frame, construction.keys[key].value);
  return true;
}

}  // namespace qtraj

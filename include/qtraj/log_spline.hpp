#pragma once

#include "qtraj/method.hpp"

namespace qtraj {

constexpr size_t kLogSplineWorkspacePerKey = 8;

// LOG_SPLINE: q_ref exp(p(t)), p the C2 cubic spline through p_i = unwrap(log(q_ref* q_i)). One chart for the whole
// curve: smooth and cheap near q_ref and for turns about one axis; singular at -q_ref, and after a full turn at q_ref.
//
// not_finite with a key's index where uneven knots throw p so far (beyond 2^500 rad) that its square would overflow;
// not_closed where the ends are periodic and the unwrapped p does not come back.
Outcome build_log_spline(Construction& construction);

}  // namespace qtraj

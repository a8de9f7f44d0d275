// Slerp and nlerp of pairs whose ends have times, at any times, also before and after them.
#pragma once

#include "base/settings.hpp"
#include "functions/for_each_row.hpp"

namespace qtraj {

// Times are of double; quaternions are of double, or all of float.
struct TimedPairRows {
  Input<4> a;
  Input<1> time_a;
  Input<4> b;
  Input<1> time_b;
  Input<1> times;
  Path path;
  Output<4> q;
};

// The fraction is (time - time_a) / (time_b - time_a), clamped to +-2^1022, to 1.5 eps relative; what that makes of the
// result adds to the bounds of functions/pairs.hpp. With theta the angle turned on S^3, slerps are within
// 6e-16 + 1e-15 |theta|; nlerps within 7e-16 + 4e-16 |fraction| |b - a| / |p|, p the point before it is normalised.
// Statuses of a row: not_finite of any of its numbers; zero_norm; those of knots for the two times: time_order where
// time_b does not come after time_a, or so soon after it that 1/h^2 overflows, time_span where their distance
// overflows; those of the pair at the fraction. Float rows are computed in double and rounded once.
Outcome slerp_between(const TimedPairRows& pairs, size_t count);
Outcome nlerp_between(const TimedPairRows& pairs, size_t count);

}  // namespace qtraj

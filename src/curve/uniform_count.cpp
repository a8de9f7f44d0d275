#include "curve/uniform_count.hpp"

#include <cmath>

#include "curve/sample_call.hpp"

namespace qtraj {

Status uniform_count(const Trajectory& trajectory, double start, double step, size_t& count) {
  if (!is_finite(start) || !is_finite(step)) return Status::not_finite;
  if (step == 0) return Status::value;
  const double first = trajectory.before.reach, last = trajectory.after.reach;
  if (start < first || start > last) return Status::time_range;

  constexpr double kMost = 0x1p53;
  const double end = step > 0 ? last : first;
  // halved first: the difference may overflow; a step so small that the quotient would do so is caught before
  const double half_way = 0.5 * end - 0.5 * start;
  if (std::abs(half_way) / kMost >= 0.5 * std::abs(step)) return Status::size;
  const TimeSource source = {nullptr, start, step};
  const auto is_inside = [&](double row) {
    const double time = uniform_time_guarded(source, row);
    return step > 0 ? time <= end : time >= end;
  };
  // the quotient is off by a rounding error
  double row = std::floor(half_way / (0.5 * step));
  while (!is_inside(row)) row -= 1.0;
  while (is_inside(row + 1.0)) row += 1.0;
  count = static_cast<size_t>(row) + 1;
  return Status::ok;
}

}  // namespace qtraj

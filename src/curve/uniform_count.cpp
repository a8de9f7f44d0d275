#include "curve/uniform_count.hpp"

#include <cmath>
#include <initializer_list>

#include "curve/sample_call.hpp"

namespace qtraj {

Status uniform_count(const Timeline& timeline, double start, double step, size_t& count) {
  return uniform_count({timeline.before.reach, timeline.after.reach}, start, step, count);
}

Status uniform_count(const TimeSpan& span, double start, double step, size_t& count) {
  if (step == 0) return Status::value;
  if (!is_finite(start) || !is_finite(step)) return Status::not_finite;
  if (start < span.first || start > span.last) return Status::time_range;

  const TimeSource source = {nullptr, start, step};
  const auto is_inside = [&](double row) {
    const double time = uniform_time_guarded(source, row);
    return is_finite(time) && time >= span.first && time <= span.last;
  };
  // rounded times never turn back: the last row inside is found by halving, first beside where the quotient puts it,
  // which is a row off or two
  double inside = 0, outside = 0x1p53;
  if (is_inside(outside)) return Status::size;
  const double end = step > 0 ? span.last : span.first;
  const double quotient = std::floor((0.5 * end - 0.5 * start) / (0.5 * step));
  for (const double row : {quotient - 2.0, quotient + 2.0})
    if (row > inside && row < outside) (is_inside(row) ? inside : outside) = row;
  while (outside - inside > 1.0) {
    const double middle = std::floor(0.5 * (inside + outside));
    (is_inside(middle) ? inside : outside) = middle;
  }
  count = static_cast<size_t>(inside) + 1;
  return Status::ok;
}

}  // namespace qtraj

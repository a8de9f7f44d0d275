#include "methods/timeline_builder.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "base/times.hpp"

namespace qtraj {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Member by member: bytes between them stay 0, so that a handle is the same bytes wherever it is built.
void set_side(Extrapolate rule, double knot, double reach, Timeline::Side& side) {
  side.rule = rule;
  side.knot = knot;
  side.reach = reach;
}

void set_sides(const Options& options, double first, double last, Timeline& timeline) {
  const TimeSpan reached = reached_span(first, last);
  set_side(options.start.extrapolate, first, reached.first, timeline.before);
  set_side(options.end.extrapolate, last, reached.last, timeline.after);
}

double longest_interval(const double* knots, size_t count) {
  double longest = 0;
  for (size_t i = 1; i < count; ++i) longest = std::max(longest, knots[i] - knots[i - 1]);
  return longest;
}

}  // namespace

void place_knots(size_t count, size_t offset, Timeline& timeline) {
  timeline.key_count = count;
  timeline.knots_offset = offset;
  timeline.guide_offset = offset + count * sizeof(double);
}

void build_timeline(const Options& options, bool holds_keys, Timeline& timeline) {
  const double* knots = knots_of(timeline);
  const size_t count = timeline.key_count;
  const double first = knots[0], last = knots[count - 1];
  set_sides(options, first, last, timeline);
  // beside 0 a normal number: a subnormal one is 0 where a processor was told so, and the C library tells errno of it
  const double before_last = std::abs(last) <= DBL_MIN ? last - 2.0 * DBL_MIN : std::nextafter(last, first);
  timeline.last_inside = options.wraps() || holds_keys ? before_last : last;
  timeline.half_period =
      options.period > 0 ? DoubleDouble{0.5 * options.period, 0.0} : two_sum(0.5 * last, -0.5 * first);
  const bool has_gaps = options.longest_gap < kInfinity && longest_interval(knots, count) > options.longest_gap;
  timeline.longest_gap = has_gaps ? options.longest_gap : kInfinity;
  auto* guide = reinterpret_cast<uint64_t*>(reinterpret_cast<char*>(&timeline) + timeline.guide_offset);
  build_guide(knots, count, guide, timeline.guide_scale, timeline.guide_candidates);
}

}  // namespace qtraj

// Golden-section search for a maximum.
#pragma once

namespace qtraj {

struct Interval {
  double from, to;
  double width() const { return to - from; }
  double middle() const { return from + 0.5 * (to - from); }
};

// Raises `best` to the maximum of a unimodal function, to 1e-9 of the interval. value(x, y) sets y, or is false where
// the curve overflows; the result then is false too.
template <class Value>
bool narrow_maximum(Interval interval, const Value& value, double& best, double& best_at) {
  constexpr double kGolden = 0.6180339887498949;
  double a = interval.to - kGolden * interval.width(), b = interval.from + kGolden * interval.width(), at_a, at_b;
  if (!value(a, at_a) || !value(b, at_b)) return false;
  for (int section = 0; section < 43; ++section) {
    if (at_a > at_b) {
      interval.to = b;
      b = a;
      at_b = at_a;
      a = interval.to - kGolden * interval.width();
      if (!value(a, at_a)) return false;
    } else {
      interval.from = a;
      a = b;
      at_a = at_b;
      b = interval.from + kGolden * interval.width();
      if (!value(b, at_b)) return false;
    }
    const bool first = at_a > at_b;
    if ((first ? at_a : at_b) > best) {
      best = first ? at_a : at_b;
      best_at = first ? a : b;
    }
  }
  return true;
}

}  // namespace qtraj

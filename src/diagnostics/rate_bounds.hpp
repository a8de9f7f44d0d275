// Proven bounds of |omega| and |alpha| over a piece of a segment, and of their analytic continuations over discs around
// it: from the latter follows how far a polynomial through samples, or Gauss's rule, is off (analytic.hpp). Per unit of
// s, like the rates of segment_rates.hpp. Derived in docs/mathematics.md, section 12.
#pragma once

#include "curve/trajectory.hpp"

namespace qtraj {

// The part |s - middle| <= half_width of a segment.
struct Piece {
  double middle, half_width;
};

struct RateBounds {
  double omega, alpha;
};
// Where nothing is proven; larger than what is, and with a square that does not overflow.
constexpr double kNoBound = 1e150;

// Ellipses with foci at the ends of the piece, by the sum of their half axes in half widths, and the discs around them.
constexpr double kEllipses[] = {3.0, 4.0, 6.0, 10.0, 20.0, 50.0};
constexpr size_t kDiscCount = sizeof kEllipses / sizeof kEllipses[0];
constexpr double disc_radius(size_t disc) { return 0.5 * (kEllipses[disc] + 1.0 / kEllipses[disc]); }

struct PieceBounds {
  RateBounds real;              // over the piece
  RateBounds disc[kDiscCount];  // over the discs, s complex: lengths of complex vectors
  RateBounds rounding;          // how far samples of the piece are off by rounding, about
};
PieceBounds piece_bounds(const Trajectory& trajectory, size_t segment, const Piece& piece);

// The size of a segment's rates: 0 only where it is at rest, and not below |omega| by more than a norm makes it.
// kNoBound or more where coefficients are so large that samples have no digits.
double size_of_rates(const Trajectory& trajectory, size_t segment);

}  // namespace qtraj

// Peaks by branch and bound. A piece is done with when it is proven to exceed the best sample by nothing that counts:
// by the bound over the piece; or by a polynomial through samples, whose error follows from the bound over a disc.
#include <algorithm>
#include <cfloat>

#include "curve/unnormalized.hpp"
#include "diagnostics/analytic.hpp"
#include "diagnostics/budget.hpp"
#include "diagnostics/common_unit.hpp"
#include "diagnostics/curve.hpp"
#include "diagnostics/dyadic.hpp"
#include "diagnostics/golden_section.hpp"
#include "math/quaternion.hpp"

namespace qtraj {
namespace {

// How far the curve may exceed the peak, relative, for the search to end.
constexpr double kTolerance = 1e-10;
// Samples are off by at most kRoundings units of PieceBounds::rounding, a polynomial through them by a few more. Where
// that is more than the tolerance, it takes the place of it, up to here; bounds then exceed the peak by twice as much.
constexpr double kLargestTolerance = 4.5e-7, kRoundings = 12.0;

class PeakSearch {
 public:
  PeakSearch(const Trajectory& trajectory, Quantity quantity)
      : trajectory_(trajectory), quantity_(quantity), unit_(trajectory, quantity), budget_(segments()) {}

  Outcome run(Peak& peak) {
    for (size_t i = 0; i < segments(); ++i)
      if (!begin_segment(i)) return {Status::no_convergence, i};
    for (size_t i = 0; i < segments(); ++i) {
      enter(i);
      if (!search_segment()) return {Status::no_convergence, i};
    }
    refine();
    peak.time = time_in_segment(trajectory_, best_segment_, best_at_);
    const double bound = std::max(best_ * (1.0 + 2.0 * kTolerance), best_ + excess_);
    if (!unit_.in_seconds(best_, false, peak.value) || !unit_.in_seconds(bound, false, peak.bound))
      return {Status::not_finite, best_segment_};
    return {};
  }

 private:
  size_t segments() const { return trajectory_.timeline.key_count - 1; }
  bool is_omega() const { return quantity_ == Quantity::omega; }
  double of(const RateBounds& bounds) const { return is_omega() ? bounds.omega : bounds.alpha; }
  double weighted(double size) const { return size >= kNoBound ? kNoBound : weight_(size); }

  void enter(size_t segment) {
    segment_ = segment;
    weight_ = unit_.weight(segment);
  }

  // The size at s, which raises the best so far; `reach` is the half width of the piece it is of.
  bool sample(double s, double reach, double& size) {
    RatesInSegment rates;
    if (!rates_in_segment(trajectory_, segment_, s, !is_omega(), rates)) return false;
    size = weight_.length_of(is_omega() ? rates.omega : rates.alpha);
    if (size > best_) best_ = size, best_segment_ = segment_, best_at_ = s, reach_ = reach;
    return true;
  }

  // A few samples, so that most pieces of the other segments need none.
  bool begin_segment(size_t segment) {
    enter(segment);
    const double size_of_all = size_of_rates(trajectory_, segment);
    if (size_of_all >= kNoBound) return false;
    // where little but the norm changes, rates are rounding errors of that
    if (!has_unit_keys(trajectory_)) noise_ = std::max(noise_, kNoise * weight_(size_of_all));
    for (const double s : {-1.0, 0.0, 1.0}) {
      double size;
      if (!sample(s, 1.0, size)) return false;
      RatesInSegment rates;
      if (is_omega() || !rates_in_segment(trajectory_, segment_, s, false, rates)) continue;
      noise_ = std::max(noise_, kNoise * weight_.length_of(rates.omega));
    }
    return true;
  }

  bool search_segment() {
    constexpr int kDeepest = 50;
    for (DyadicPieces pieces(kDeepest); !pieces.done();) {
      if (!budget_.take()) return false;
      const Piece piece = pieces.piece();
      const PieceBounds bounds = piece_bounds(trajectory_, segment_, piece);
      bool settled = is_below(weighted(of(bounds.real)));
      if (!settled && !settle_by_polynomial(piece, bounds, settled)) return false;
      if (settled) {
        pieces.next();
        continue;
      }
      double size;
      if (!pieces.halve() || !sample(piece.middle, piece.half_width, size)) return false;
    }
    return true;
  }

  // Whether a bound shows nothing above the best sample that counts.
  bool is_below(double bound) {
    if (bound <= best_ * (1.0 + kTolerance)) return true;
    if (bound > noise_) return false;
    excess_ = std::max(excess_, bound - best_);
    return true;
  }
  // The same where samples are off by `rounding`, and that is not too much.
  bool is_below(double bound, double rounding) {
    if (is_below(bound)) return true;
    if (rounding > std::max(kLargestTolerance * best_, 0.5 * noise_)) return false;
    if (bound > best_ * (1.0 + kTolerance) + 2.0 * rounding) return false;
    excess_ = std::max(excess_, bound - best_);
    return true;
  }

  // The least error of the square of the size by a polynomial through samples.
  double least_error(const PieceBounds& bounds) const {
    double least = kNoBound;
    for (size_t disc = 0; disc < kDiscCount; ++disc) {
      if (of(bounds.disc[disc]) >= kNoBound) break;
      const double bound = weighted(of(bounds.disc[disc]));
      least = std::min(least, bound * bound * polynomial_error(disc));
    }
    return least;
  }

  // Leaves `settled` false where the piece must be halved; false where that is of no use.
  bool settle_by_polynomial(const Piece& piece, const PieceBounds& bounds, bool& settled) {
    const double error = least_error(bounds);
    if (error > std::max(0.5 * kTolerance * best_ * best_, 0.25 * noise_ * noise_)) return true;
    LocalPolynomial square;
    const auto sample_square = [&](double x, double& value) {
      if (!sample(piece.middle + x * piece.half_width, piece.half_width, value)) return false;
      value *= value;
      return true;
    };
    if (!polynomial_through(sample_square, square)) return false;
    const double rounding = kRoundings * weighted(of(bounds.rounding));

    constexpr int kDeepest = 24;
    for (DyadicPieces parts(kDeepest); !parts.done();) {
      if (!budget_.take()) return false;
      const PolynomialMaximum maximum = maximum_over(square, parts.piece());
      const double bound = std::sqrt(std::max(maximum.bound + error, 0.0)) + rounding;
      double size = 0;
      if (!is_below(bound, rounding) &&
          !sample(piece.middle + maximum.at * piece.half_width, piece.half_width * parts.piece().half_width, size))
        return false;
      if (is_below(bound, rounding))
        parts.next();
      else if (!parts.halve())
        return true;
    }
    settled = true;
    return true;
  }

  // The peak is known to lie within a part of the piece that its best sample is of.
  void refine() {
    enter(best_segment_);
    const double reach = 0x1p-8 * reach_;
    const Interval around = {std::max(best_at_ - reach, -1.0), std::min(best_at_ + reach, 1.0)};
    const auto size = [&](double s, double& value) { return sample(s, reach_, value); };
    double best = best_, best_at = best_at_;
    narrow_maximum(around, size, best, best_at);
  }

  const Trajectory& trajectory_;
  const Quantity quantity_;
  const CommonUnit unit_;
  Budget budget_;
  size_t segment_ = 0;
  CommonUnit::Weight weight_;

  double best_ = 0, best_at_ = -1.0, reach_ = 1.0;
  size_t best_segment_ = 0;
  double noise_ = 0;   // rates below it count as 0
  double excess_ = 0;  // by how much bounds within rounding exceed the best
};

}  // namespace

Outcome peak_omega(const Trajectory& trajectory, Peak& peak) {
  return PeakSearch(trajectory, Quantity::omega).run(peak);
}

Outcome peak_alpha(const Trajectory& trajectory, Peak& peak) {
  return PeakSearch(trajectory, Quantity::alpha).run(peak);
}

}  // namespace qtraj

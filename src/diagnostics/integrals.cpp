// Integrals by Gauss's rule over pieces that are halved until its error is proven to be small.
#include <algorithm>
#include <cfloat>

#include "curve/unnormalized.hpp"
#include "diagnostics/analytic.hpp"
#include "diagnostics/budget.hpp"
#include "diagnostics/common_unit.hpp"
#include "diagnostics/curve.hpp"
#include "diagnostics/dyadic.hpp"
#include "math/quaternion.hpp"

namespace qtraj {
namespace {

// Largest error of the whole, relative; and what a piece may have: this part of its own integral, or, by its width, of
// the larger of the integrals over its segment and over the mean segment. Where |omega| may be 0 inside, which happens
// in few pieces, a part of that whatever the width.
constexpr double kTolerance = 1e-9, kOfPiece = 2e-10, kOfSegment = 1e-10, kOfCusp = 2e-12;

// Both kinds of integral: of |alpha|^2, and of |omega|, which is not analytic where it is 0.
class Integration {
 public:
  Integration(const Trajectory& trajectory, Quantity quantity)
      : trajectory_(trajectory), quantity_(quantity), unit_(trajectory, quantity), budget_(segments()) {}

  Outcome run(double& result) {
    double total = 0, integral;
    for (size_t i = 0; i < segments(); ++i) {
      enter(i);
      if (size_of_rates(trajectory_, i) >= kNoBound || !over(kWhole, integral)) return {Status::no_convergence, i};
      total += integral;
      if (!raise_noise()) return {Status::no_convergence, i};
    }
    share_ = total / static_cast<double>(segments());
    for (size_t i = 0; i < segments(); ++i) {
      enter(i);
      if (!over(kWhole, integral)) return {Status::no_convergence, i};
      allowed_ = std::max(integral, share_);
      if (!integrate_segment()) return {Status::no_convergence, i};
    }
    if (error_ > kTolerance * sum_ + noise_floor() * 2.0 * static_cast<double>(segments()))
      return {Status::no_convergence, kNoIndex};
    if (!unit_.in_seconds(sum_, !is_angle(), result)) return {Status::not_finite, kNoIndex};
    return {};
  }

 private:
  static constexpr Piece kWhole = {0.0, 1.0};

  size_t segments() const { return trajectory_.timeline.key_count - 1; }
  bool is_angle() const { return quantity_ == Quantity::angle; }

  void enter(size_t segment) {
    segment_ = segment;
    weight_ = unit_.weight(segment);
  }

  bool raise_noise() {
    // where little but the norm changes, rates are rounding errors of that
    if (!has_unit_keys(trajectory_)) noise_ = std::max(noise_, kNoise * weight_(size_of_rates(trajectory_, segment_)));
    if (is_angle()) return true;
    for (const double s : {-1.0, 0.0, 1.0}) {
      RatesInSegment rates;
      if (!rates_in_segment(trajectory_, segment_, s, false, rates)) return false;
      noise_ = std::max(noise_, kNoise * weight_.length_of(rates.omega));
    }
    return true;
  }

  // The integral over a piece by Gauss's rule.
  bool over(const Piece& piece, double& integral) const {
    const auto sample = [&](double x, double& value) {
      RatesInSegment rates;
      if (!rates_in_segment(trajectory_, segment_, piece.middle + x * piece.half_width, !is_angle(), rates))
        return false;
      const double size = weight_.length_of(is_angle() ? rates.omega : rates.alpha);
      value = is_angle() ? size : size * size;
      return true;
    };
    if (!gauss(sample, integral)) return false;
    integral *= piece.half_width;
    return true;
  }

  // The error of Gauss's rule, in half widths of the piece; kNoBound where nothing is known.
  struct PieceError {
    double error;
    bool is_cusp;  // nothing is known but bounds of the integrand, which may have a kink
  };
  // |alpha|^2 is analytic wherever alpha is.
  PieceError error_of_squares(const PieceBounds& bounds) const {
    double least = kNoBound;
    for (size_t disc = 0; disc < kDiscCount && bounds.disc[disc].alpha < kNoBound; ++disc) {
      const double bound = weight_(bounds.disc[disc].alpha);
      least = std::min(least, bound * bound * gauss_error(disc));
    }
    return {least, false};
  }
  // |omega| is analytic where omega differs from its value in the middle by less than 0.41 of that: then the square of
  // |omega| differs from that in the middle by less than itself.
  PieceError error_of_lengths(const Piece& piece, const PieceBounds& bounds, double omega, double alpha) const {
    double least = kNoBound;
    for (size_t disc = 0; disc < kDiscCount; ++disc) {
      const double change = change_of_omega(piece, bounds, alpha, disc_radius(disc));
      if (change >= 0.41 * omega) break;
      least = std::min(least, (omega + change) * gauss_error(disc));
    }
    if (least < kNoBound) return {least, false};
    const double largest = omega + change_of_omega(piece, bounds, alpha, 1.0);
    return {2.0 * (bounds.real.omega < kNoBound ? std::min(weight_(bounds.real.omega), largest) : largest), true};
  }
  // How far omega may be from its value in the middle within `radius` half widths. omega' = alpha, which by Schwarz's
  // lemma is within (M + |alpha|) x/R of its value in the middle if M bounds it in the disc of radius R.
  double change_of_omega(const Piece& piece, const PieceBounds& bounds, double alpha, double radius) const {
    double least = kNoBound;
    for (size_t disc = 0; disc < kDiscCount && bounds.disc[disc].alpha < kNoBound; ++disc) {
      const double larger = disc_radius(disc);
      if (larger < radius) continue;
      const double most = weight_(bounds.disc[disc].alpha);
      least = std::min({least, radius * most, radius * (alpha + 0.5 * radius / larger * (alpha + most))});
    }
    return least < kNoBound ? piece.half_width * least : kNoBound;
  }

  bool integrate_segment() {
    constexpr int kDeepest = 50;
    for (DyadicPieces pieces(kDeepest); !pieces.done();) {
      if (!budget_.take()) return false;
      const Piece piece = pieces.piece();
      const PieceBounds bounds = piece_bounds(trajectory_, segment_, piece);
      bool is_done = false;
      if (!integrate_piece(piece, bounds, is_done)) return false;
      if (is_done)
        pieces.next();
      else if (!pieces.halve())
        return false;
    }
    return true;
  }

  // False where a sample has no digits.
  bool integrate_piece(const Piece& piece, const PieceBounds& bounds, bool& is_done) {
    RatesInSegment rates;
    if (!rates_in_segment(trajectory_, segment_, piece.middle, true, rates)) return false;
    const double omega = weight_.length_of(rates.omega), alpha = weight_.length_of(rates.alpha);
    const PieceError found = is_angle() ? error_of_lengths(piece, bounds, omega, alpha) : error_of_squares(bounds);
    const double error = piece.half_width * found.error;
    const double of_width = std::max(kOfSegment * allowed_, noise_floor()) * piece.half_width;
    const double floor = found.is_cusp ? std::max(kOfCusp * allowed_, of_width) : of_width;
    const double value = is_angle() ? omega : alpha * alpha;
    if (error > std::max(floor, 10.0 * kOfPiece * value * piece.half_width)) return true;
    double integral;
    if (!over(piece, integral)) return false;
    if (error > std::max(floor, kOfPiece * integral)) return true;
    is_done = true;
    sum_ += integral;
    error_ += error + rounding(piece, bounds, integral);
    return true;
  }

  // What may be rounding errors of a segment's integral, per half width.
  double noise_floor() const { return is_angle() ? noise_ : noise_ * noise_; }

  // What rounding errors of the samples make of an integral.
  double rounding(const Piece& piece, const PieceBounds& bounds, double integral) const {
    const double width = 2.0 * piece.half_width;
    if (is_angle()) return weight_(bounds.rounding.omega) * width;
    const double of_alpha = weight_(bounds.rounding.alpha);
    return of_alpha * (2.0 * std::sqrt(integral * width) + of_alpha * width);
  }

  const Trajectory& trajectory_;
  const Quantity quantity_;
  const CommonUnit unit_;
  Budget budget_;
  size_t segment_ = 0;
  CommonUnit::Weight weight_;
  double share_ = 0, allowed_ = 0;  // the mean segment's integral, and the error that any piece may have
  double noise_ = 0;
  double sum_ = 0, error_ = 0;
};

}  // namespace

Outcome energy(const Trajectory& trajectory, double& result) {
  return Integration(trajectory, Quantity::energy).run(result);
}

Outcome total_angle(const Trajectory& trajectory, double& result) {
  return Integration(trajectory, Quantity::angle).run(result);
}

}  // namespace qtraj

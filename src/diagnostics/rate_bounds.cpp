#include "diagnostics/rate_bounds.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "curve/nested_arcs_rates.hpp"
#include "diagnostics/polynomial_bounds.hpp"
#include "math/quaternion.hpp"

namespace qtraj {
namespace {

constexpr double kSqrt2 = 0x1.6a09e667f3bcdp+0;
RateBounds operator+(const RateBounds& a, const RateBounds& b) { return {a.omega + b.omega, a.alpha + b.alpha}; }

PieceBounds no_bounds() {
  PieceBounds bounds;
  bounds.real = bounds.rounding = {kNoBound, kNoBound};
  for (RateBounds& disc : bounds.disc) disc = {kNoBound, kNoBound};
  return bounds;
}

// At least e^x, x >= 0, and less than 1.01 times it for x <= 1: e^(-x/64) >= 1 - x/64. kNoBound from 16 on.
double exponential_bound(double x) {
  if (!(x < 16.0)) return kNoBound;
  double result = 1.0 / (1.0 - x / 64.0);
  for (int k = 0; k < 6; ++k) result *= result;
  return result;
}

// ---- The exponential ----

// Bounds of a rotation vector r, of r' and r'', of r x r', and of the imaginary part of r; `least` is one of
// abs(r.r)^(1/2) from below.
struct RotationVectorBounds {
  double r, first, second, moment, imaginary, least;
};
// A bound of beta where r is long: its three terms fall with the length.
double long_turning(const RotationVectorBounds& bounds, double growth) {
  const double ratio = bounds.r / bounds.least, inverse = 1.0 / bounds.least;
  const double terms = 1.0 + growth * ratio + (4.0 + growth) * ratio * ratio +
                       inverse * (growth + 2.0 * (1.0 + growth) * ratio + 3.0 * growth * ratio * ratio);
  return terms * inverse * inverse * bounds.first * bounds.moment;
}
// omega = Jr(r) r' and alpha = Jr(r) r'' + beta(r, r'):
//   |omega| <= g |r'|,  |alpha| <= g |r''| + |beta|,  |beta| <= g min(|r'| |r x r'|/6, c |r'|^2),
// for real r with g = 1 and c = 1/pi, for complex r with g = e^|Im r| and c = 1/2.
RateBounds exponential_bounds(const RotationVectorBounds& bounds) {
  constexpr double kInversePi = 0.3183098861837907;
  const bool is_real = bounds.imaginary == 0;
  const double growth = is_real ? 1.0 : exponential_bound(bounds.imaginary);
  if (growth >= kNoBound) return {kNoBound, kNoBound};
  double turning =
      growth * std::min(bounds.first * bounds.moment / 6.0, (is_real ? kInversePi : 0.5) * bounds.first * bounds.first);
  if (bounds.least > 8.0) turning = std::min(turning, long_turning(bounds, growth));
  return {growth * bounds.first, growth * bounds.second + turning};
}

// ---- Rotation-vector polynomials ----

template <size_t Degree>
PieceBounds bounds_of(const RotationVectorSegment<Degree>& segment, const Piece& piece) {
  const PolynomialSums sums = polynomial_sums(segment.c);
  if (sums.value >= kNoBound) return no_bounds();
  const ShiftedPolynomial<Degree + 1, 3> p(segment.c, piece.middle);
  const MomentBound<Degree + 1, 3> moment(p.c);
  const auto over = [&](double radius, bool complex) {
    const PolynomialBounds of_p = polynomial_bounds(p.size, radius);
    const double least_square = p.size[0] * (p.size[0] - 2.0 * of_p.change) - of_p.change * of_p.change;
    return exponential_bounds({2.0 * (p.size[0] + of_p.change), 2.0 * of_p.first, 2.0 * of_p.second,
                               4.0 * moment(radius).first, complex ? 2.0 * of_p.change : 0.0,
                               least_square > 0 ? 2.0 * std::sqrt(least_square) : 0.0});
  };
  PieceBounds bounds;
  const PolynomialBounds local = polynomial_bounds(p.size, piece.half_width);
  const double unit = 4.0 * DBL_EPSILON, first = 2.0 * local.first, second = 2.0 * local.second;
  bounds.rounding = {unit * (2.0 * sums.first + sums.value * first),
                     unit * (2.0 * sums.second + 2.0 * sums.first * first + sums.value * (second + first * first))};
  bounds.real = over(piece.half_width, false) + bounds.rounding;
  for (size_t disc = 0; disc < kDiscCount; ++disc)
    bounds.disc[disc] = over(disc_radius(disc) * piece.half_width, true) + bounds.rounding;
  return bounds;
}

// ---- Arcs ----

PieceBounds bounds_of(const ArcSegment& segment, const Piece&) {
  PieceBounds bounds;
  bounds.rounding = {16.0 * DBL_EPSILON * segment.half_angle, 0.0};
  bounds.real = RateBounds{2.0 * segment.half_angle, 0.0} + bounds.rounding;
  for (RateBounds& disc : bounds.disc) disc = bounds.real;
  return bounds;
}

// ---- Nested arcs ----

// A function with its first two derivatives at the middle of a disc, and a bound of the third over the disc: bounds of
// how far the function is from its value there, and of the derivatives.
struct JetBounds {
  double change, first, second;
};
JetBounds jet_bounds(double first, double second, double third, double radius) {
  return {radius * (first + radius * (second / 2.0 + radius * third / 6.0)),
          first + radius * (second + radius * third / 2.0), second + radius * third};
}

// Bounds of H(d) = theta/sin theta, d = cos theta, and its first two derivatives where Re d >= 2 z^2 - 1, z = cos of
// half the angle. H is the integral of 1/(t^2 + 2 t d + 1) over t > 0, whose denominator is no shorter than its real
// part; H(2 z^2 - 1) = g(z)/z with a convex g that falls from pi/2 to 1.
struct AngleOverSine {
  double value, first, second;
};
AngleOverSine angle_over_sine_bounds(double z_squared) {
  const double z = std::sqrt(z_squared);
  const double value = (0.5 * kPi - (0.5 * kPi - 1.0) * z) / z;
  return {value, 0.5 * value / z_squared, 0.5 * value / (z_squared * z_squared)};
}

// The values of segment.relative and of the cosine at the middle of a piece.
struct NestedArcsJet {
  Jet<double> cosine;
  double relative[3];  // lengths of v = Im(P* C) and of its derivatives
};
NestedArcsJet nested_arcs_jet(const NestedArcsSegment& segment, double s) {
  ArcPair<double> arcs;
  if (segment.near > 0.5)
    arc_pair<Plain, true>(segment, s, arcs);
  else
    arc_pair<Plain, false>(segment, s, arcs);
  NestedArcsJet jet;
  const auto &m = segment.keys.m, &e = segment.keys.e, &control_m = segment.controls.m, &control_e = segment.controls.e;
  jet.cosine = product_sum<Plain>(segment, arcs, dot_product<Plain>(m, control_m), dot_product<Plain>(m, control_e),
                                  dot_product<Plain>(e, control_m), dot_product<Plain>(e, control_e));
  Vector3 value, first, second;
  for (int k = 0; k < 3; ++k) {
    const Jet<double> v = product_sum<Plain>(segment, arcs, segment.relative[0][k], segment.relative[1][k],
                                             segment.relative[2][k], segment.relative[3][k]);
    value[k] = v.value, first[k] = v.first, second[k] = v.second;
  }
  jet.relative[0] = length_bound(value), jet.relative[1] = length_bound(first), jet.relative[2] = length_bound(second);
  return jet;
}

// Of q = P exp p, p = f H v: |omega| <= g (|omega_P| + |r'|), |alpha| <= that of exp p + g^2 |r'| |omega_P|, r = 2 p.
RateBounds nested_arcs_bounds(const NestedArcsSegment& segment, const NestedArcsJet& jet, double middle, double radius,
                              bool complex) {
  const double angles = segment.keys.half_angle + segment.controls.half_angle;
  const double growth_of_arcs = complex ? exponential_bound(angles * radius) : 1.0;
  if (growth_of_arcs >= kNoBound) return {kNoBound, kNoBound};
  const double third = growth_of_arcs * angles * angles * angles;
  const JetBounds d = jet_bounds(std::abs(jet.cosine.first), std::abs(jet.cosine.second), third, radius);
  const JetBounds v = jet_bounds(jet.relative[1], jet.relative[2], third, radius);
  const double z_squared = std::min(1.0, 0.5 * (1.0 + jet.cosine.value - d.change) - 8.0 * DBL_EPSILON);
  if (!(z_squared > 0x1p-40)) return {kNoBound, kNoBound};

  const AngleOverSine h_of_d = angle_over_sine_bounds(z_squared);
  const double h[] = {h_of_d.value, h_of_d.first * d.first,
                      h_of_d.second * d.first * d.first + h_of_d.first * d.second};
  const double s = std::abs(middle);
  const double f[] = {0.5 * (1.0 - s * s) + s * radius + (complex ? 0.5 * radius * radius : 0.0), s + radius, 1.0};
  const double fh[] = {f[0] * h[0], f[1] * h[0] + f[0] * h[1], f[2] * h[0] + 2.0 * f[1] * h[1] + f[0] * h[2]};
  const double size = jet.relative[0] + v.change;
  const double r = 2.0 * fh[0] * size, first = 2.0 * (fh[1] * size + fh[0] * v.first),
               second = 2.0 * (fh[2] * size + 2.0 * fh[1] * v.first + fh[0] * v.second);
  // the imaginary part grows from 0 on the real axis by r' times the distance
  const double imaginary = complex ? first * radius : 0.0;
  const RateBounds inner = exponential_bounds({r, first, second, r * first, imaginary, 0.0});
  if (inner.omega >= kNoBound) return inner;
  const double growth = complex ? exponential_bound(imaginary) : 1.0;
  const double outer = growth * 2.0 * segment.keys.half_angle;
  return {outer + inner.omega, inner.alpha + outer * inner.omega};
}

PieceBounds bounds_of(const NestedArcsSegment& segment, const Piece& piece) {
  const NestedArcsJet jet = nested_arcs_jet(segment, piece.middle);
  PieceBounds bounds;
  bounds.real = nested_arcs_bounds(segment, jet, piece.middle, piece.half_width, false);
  const double z_squared = std::max(0.5 * (1.0 + jet.cosine.value), 0x1p-60);
  const double unit = 4.0 * DBL_EPSILON * (1.0 + 1.0 / z_squared);
  const double omega = std::min(bounds.real.omega, 1e50), alpha = std::min(bounds.real.alpha, 1e50);
  bounds.rounding = {unit * omega, unit * (1.0 + 0.25 / std::sqrt(z_squared)) * (alpha + omega)};
  if (bounds.real.omega < kNoBound) bounds.real = bounds.real + bounds.rounding;
  for (size_t disc = 0; disc < kDiscCount; ++disc) {
    bounds.disc[disc] = nested_arcs_bounds(segment, jet, piece.middle, disc_radius(disc) * piece.half_width, true);
    if (bounds.disc[disc].omega < kNoBound) bounds.disc[disc] = bounds.disc[disc] + bounds.rounding;
  }
  return bounds;
}

// ---- Normalised polynomials ----

// The size of the larger end: about 1 of unit keys, that of the keys where they are as given (QUATERNION_HERMITE).
// A key far below the coefficients has no digits (has_digits in segment_rates.cpp).
constexpr double kLargestOfEnds = 0x1p40;
template <size_t Degree>
double size_of_ends(const NormalizedSegment<Degree>& segment) {
  Quaternion even = Quaternion::Zero(), odd = Quaternion::Zero();
  for (size_t term = 0; term <= Degree; term += 2) {
    even += load(segment.c[term]);
    odd += load(segment.c[term + 1]);
  }
  return std::max(largest_component(Quaternion(even + odd)), largest_component(Quaternion(even - odd)));
}

// Of q = P/|P|, N = P.P: omega = (2/N) Im(P* P'), alpha = (2/N) Im(P* P'') - omega N'/N, |N'| <= 2 |P| |P'|. For
// complex a and b, |Im(a* b)| <= sqrt(2) |a| |b|, and |N| >= |P_0|^2 - 2 |P_0| change - change^2. The moments, which
// may be closer, are sums of products that are rounded. The norm in the middle is known to lie between `norm` and
// `largest_norm`.
RateBounds normalized_bounds(double norm, double largest_norm, const PolynomialBounds& p, const Moments& moments,
                             bool complex) {
  const double largest = largest_norm + p.change;
  const double least = norm - p.change,
               least_square = complex ? norm * (norm - 2.0 * p.change) - p.change * p.change : least * least;
  if (least <= 0 || least_square <= 1e-24 * largest * largest) return {kNoBound, kNoBound};
  // real: |Im(P* P')|/N <= |P'|/|P|
  const double inverse = complex ? largest / least_square : 1.0 / least;
  const double factor = 2.0 * (complex ? kSqrt2 : 1.0) * inverse, of_moments = 2.0 / least_square;
  constexpr double kRounded = 8.0 * DBL_EPSILON;
  const double omega = std::min(factor * p.first, of_moments * (moments.first + kRounded * largest * p.first));
  const double bend = std::min(factor * p.second, of_moments * (moments.second + kRounded * largest * p.second));
  return {omega, bend + omega * 2.0 * inverse * p.first};
}

template <size_t Degree>
PieceBounds bounds_of(const NormalizedSegment<Degree>& segment, const Piece& piece) {
  const PolynomialSums sums = polynomial_sums(segment.c, kLargestOfEnds * size_of_ends(segment));
  if (sums.value >= kNoBound) return no_bounds();
  const ShiftedPolynomial<Degree + 1, 4> p(segment.c, piece.middle);
  const double off = 8.0 * DBL_EPSILON * sums.value, norm = p.size[0] - off;
  if (norm <= 1e-9 * sums.value) return no_bounds();
  PieceBounds bounds;
  const double unit = 4.0 * DBL_EPSILON, value = sums.value / norm, first = sums.first / norm,
               second = sums.second / norm, speed = p.size[1] / norm,
               bend = Degree > 1 ? 2.0 * p.size[2 % (Degree + 1)] / norm : 0.0;
  bounds.rounding = {unit * (first + value * speed),
                     unit * (second + value * bend + 4.0 * speed * (first + value * speed))};
  const MomentBound<Degree + 1, 4> moments(p.c);
  const auto over = [&](double radius, bool complex) {
    const RateBounds found =
        normalized_bounds(norm, p.size[0] + off, polynomial_bounds(p.size, radius), moments(radius), complex);
    return found.omega >= kNoBound ? found : found + bounds.rounding;
  };
  bounds.real = over(piece.half_width, false);
  for (size_t disc = 0; disc < kDiscCount; ++disc) bounds.disc[disc] = over(disc_radius(disc) * piece.half_width, true);
  return bounds;
}

// ---- Sizes ----

template <size_t Degree>
double size_of(const RotationVectorSegment<Degree>& segment) {
  return 2.0 * polynomial_sums(segment.c).first;
}
template <size_t Degree>
double size_of(const NormalizedSegment<Degree>& segment) {
  const double size = size_of_ends(segment), first = polynomial_sums(segment.c, kLargestOfEnds * size).first;
  return first >= kNoBound ? kNoBound : 2.0 * first / size;
}
double size_of(const ArcSegment& segment) { return 2.0 * segment.half_angle; }
double size_of(const NestedArcsSegment& segment) {
  double sum = segment.keys.half_angle + segment.controls.half_angle;
  for (const auto& row : segment.relative) sum += largest_component(load(row));
  return 2.0 * sum;
}

// Calls `with` with the segment as a record of its kind.
template <class With>
auto with_segment(const Trajectory& trajectory, size_t segment, const With& with) {
  switch (trajectory.kind) {
    case SegmentKind::arc:
      return with(segments_of<ArcSegment>(trajectory)[segment]);
    case SegmentKind::nested_arcs:
      return with(segments_of<NestedArcsSegment>(trajectory)[segment]);
    case SegmentKind::normalized:
      return with(segments_of<NormalizedSegment<1>>(trajectory)[segment]);
    case SegmentKind::normalized_quintic:
      return with(segments_of<NormalizedSegment<5>>(trajectory)[segment]);
    case SegmentKind::rotation_vector_quintic:
      return with(segments_of<RotationVectorSegment<5>>(trajectory)[segment]);
    case SegmentKind::rotation_vector:
      break;
  }
  return with(segments_of<RotationVectorSegment<3>>(trajectory)[segment]);
}

}  // namespace

PieceBounds piece_bounds(const Trajectory& trajectory, size_t segment, const Piece& piece) {
  return with_segment(trajectory, segment, [&](const auto& record) { return bounds_of(record, piece); });
}

double size_of_rates(const Trajectory& trajectory, size_t segment) {
  return with_segment(trajectory, segment, [](const auto& record) { return size_of(record); });
}

}  // namespace qtraj

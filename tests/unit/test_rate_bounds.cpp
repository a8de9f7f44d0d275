// The bounds of rates over pieces, and over discs in the complex plane of s, against the rates themselves: formulas in
// complex numbers, written for this test, that are checked against the evaluators on the real axis.
#include <cmath>
#include <complex>
#include <vector>

#include "diagnostics/rate_bounds.hpp"
#include "diagnostics/segment_rates.hpp"
#include "support/catch.hpp"
#include "support/kernel_curves.hpp"
#include "support/random.hpp"

namespace {

using Complex = std::complex<double>;
struct ComplexVector {
  Complex x[3];
};

ComplexVector operator+(const ComplexVector& a, const ComplexVector& b) {
  return {{a.x[0] + b.x[0], a.x[1] + b.x[1], a.x[2] + b.x[2]}};
}
ComplexVector operator*(const Complex& factor, const ComplexVector& a) {
  return {{factor * a.x[0], factor * a.x[1], factor * a.x[2]}};
}
Complex dot(const ComplexVector& a, const ComplexVector& b) {
  return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}
ComplexVector cross(const ComplexVector& a, const ComplexVector& b) {
  return {{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2], a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}
double length(const ComplexVector& a) { return std::sqrt(std::norm(a.x[0]) + std::norm(a.x[1]) + std::norm(a.x[2])); }

// Im(a* b)
template <class Number>
ComplexVector relative(const Number (&a)[4], const Number (&b)[4]) {
  const ComplexVector u = {{a[1], a[2], a[3]}}, v = {{b[1], b[2], b[3]}};
  return Complex(a[0]) * v + (-Complex(b[0])) * u + Complex(-1) * cross(u, v);
}

template <size_t Terms, size_t Size>
void polynomial(const double (&c)[Terms][Size], Complex s, Complex (&value)[Size], Complex (&first)[Size]) {
  for (size_t k = 0; k < Size; ++k) {
    value[k] = first[k] = 0;
    for (size_t term = Terms; term-- > 0;) {
      first[k] = first[k] * s + value[k];
      value[k] = value[k] * s + c[term][k];
    }
  }
}

// Jr(r) d, r = 2 p, d = 2 dp.
ComplexVector of_exponential(const ComplexVector& p, const ComplexVector& dp) {
  const Complex y = dot(p, p), x = std::sqrt(y);
  Complex once = 1.0 - 1.0 / 3.0 * y, twice = 2.0 / 3.0 - 2.0 / 15.0 * y;
  if (std::abs(x) > 1e-3) {
    const Complex c = std::cos(x), k = std::sin(x) / x;
    once = k * k;
    twice = (1.0 - c * k) / y;
  }
  return 2.0 * (dp + (-once) * cross(p, dp) + twice * cross(p, cross(p, dp)));
}

template <size_t Degree>
ComplexVector omega_at(const qtraj::RotationVectorSegment<Degree>& segment, Complex s) {
  Complex p[3], dp[3];
  polynomial(segment.c, s, p, dp);
  return of_exponential({{p[0], p[1], p[2]}}, {{dp[0], dp[1], dp[2]}});
}

template <size_t Degree>
ComplexVector omega_at(const qtraj::NormalizedSegment<Degree>& segment, Complex s) {
  Complex p[4], dp[4];
  polynomial(segment.c, s, p, dp);
  return (2.0 / (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3])) * relative(p, dp);
}

// p = f H v of nested arcs, the half-angle vector from the outer arc to the curve.
ComplexVector inner_exponent(const qtraj::NestedArcsSegment& segment, Complex s) {
  const auto point = [&](const qtraj::NestedArcsSegment::Arc& arc, Complex(&q)[4]) {
    for (size_t k = 0; k < 4; ++k)
      q[k] = std::cos(arc.half_angle * s) * arc.m[k] + std::sin(arc.half_angle * s) * arc.e[k];
  };
  Complex outer[4], inner[4];
  point(segment.keys, outer);
  point(segment.controls, inner);
  const Complex d = outer[0] * inner[0] + outer[1] * inner[1] + outer[2] * inner[2] + outer[3] * inner[3];
  const Complex angle = std::acos(d),
                ratio = std::abs(1.0 - d) < 1e-6 ? 1.0 + (1.0 - d) / 3.0 : angle / std::sin(angle);
  return (0.5 * (1.0 - s * s) * ratio) * relative(outer, inner);
}
ComplexVector omega_at(const qtraj::NestedArcsSegment& segment, Complex s) {
  const double step = 1e-5;
  const ComplexVector p = inner_exponent(segment, s);
  const ComplexVector dp =
      (0.5 / step) * (inner_exponent(segment, s + step) + Complex(-1) * inner_exponent(segment, s - step));
  // the outer rate, rotated by exp(-p)
  const ComplexVector carried = (2.0 * segment.keys.half_angle) * relative(segment.keys.m, segment.keys.e);
  const Complex x = std::sqrt(dot(p, p)), k = std::abs(x) < 1e-8 ? 1.0 : std::sin(x) / x;
  const ComplexVector u = (-k) * p, once = 2.0 * cross(u, carried);
  return of_exponential(p, dp) + carried + std::cos(x) * once + cross(u, once);
}
ComplexVector omega_at(const qtraj::ArcSegment& segment, Complex) {
  return (2.0 * segment.half_angle) * relative(segment.m, segment.e);
}

// Compares the bounds of pieces of all sizes with rates on the piece and on the discs.
template <class Segment>
void check_segment(const qtraj::Trajectory& trajectory, size_t index, test::Random& random) {
  const Segment& segment = qtraj::segments_of<Segment>(trajectory)[index];
  const auto alpha_at = [&](Complex s) {
    const double step = 1e-4;
    return (0.5 / step) * (omega_at(segment, s + step) + Complex(-1) * omega_at(segment, s - step));
  };
  for (int depth = 0; depth < 12; ++depth) {
    const double width = std::pow(0.5, depth), place = std::floor(random.uniform(0, 1) / width);
    const qtraj::Piece piece = {-1.0 + (2.0 * place + 1.0) * width, width};
    const qtraj::PieceBounds bounds = qtraj::piece_bounds(trajectory, index, piece);
    CAPTURE(depth, piece.middle, bounds.real.omega, bounds.real.alpha);
    for (int k = 0; k < 6; ++k) {
      const double s = piece.middle + random.uniform(-1, 1) * piece.half_width;
      qtraj::RatesInSegment rates;
      REQUIRE(qtraj::rates_in_segment(trajectory, index, s, true, rates));
      const double omega = rates.omega.norm(), alpha = rates.alpha.norm();
      CHECK(omega <= bounds.real.omega);
      CHECK(alpha <= bounds.real.alpha * (1.0 + 1e-12) + 1e-12 * omega);
      CHECK(std::abs(length(omega_at(segment, s)) - omega) <= 1e-6 * (1e-6 + omega));
      CHECK(std::abs(length(alpha_at(s)) - alpha) <= 1e-3 * (1e-6 + alpha + omega));
    }
    for (size_t disc = 0; disc < qtraj::kDiscCount; ++disc) {
      if (bounds.disc[disc].omega >= qtraj::kNoBound) continue;
      CAPTURE(disc, bounds.disc[disc].omega, bounds.disc[disc].alpha);
      for (int k = 0; k < 8; ++k) {
        const Complex s = piece.middle + std::polar(qtraj::disc_radius(disc) * width, random.uniform(0, 6.2832));
        CHECK(length(omega_at(segment, s)) <= bounds.disc[disc].omega * (1 + 1e-6) + 1e-9);
        CHECK(length(alpha_at(s)) <= bounds.disc[disc].alpha * (1 + 1e-3) + 1e-6);
      }
    }
  }
}

void check_curve(const qtraj::Trajectory& trajectory, test::Random& random) {
  for (size_t i = 0; i + 1 < trajectory.timeline.key_count; ++i) switch (trajectory.kind) {
      case qtraj::SegmentKind::arc:
        check_segment<qtraj::ArcSegment>(trajectory, i, random);
        break;
      case qtraj::SegmentKind::nested_arcs:
        check_segment<qtraj::NestedArcsSegment>(trajectory, i, random);
        break;
      case qtraj::SegmentKind::normalized:
        check_segment<qtraj::NormalizedSegment<1>>(trajectory, i, random);
        break;
      case qtraj::SegmentKind::normalized_quintic:
        check_segment<qtraj::NormalizedSegment<5>>(trajectory, i, random);
        break;
      case qtraj::SegmentKind::rotation_vector_quintic:
        check_segment<qtraj::RotationVectorSegment<5>>(trajectory, i, random);
        break;
      case qtraj::SegmentKind::rotation_vector:
        check_segment<qtraj::RotationVectorSegment<3>>(trajectory, i, random);
    }
}

}  // namespace

TEST_CASE("bounds of rates hold over pieces and over discs, for every kind of segment", "[diagnostics][bounds]") {
  test::Random random(83);
  for (const test::KernelCurve& curve : test::kernel_curves(QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_HOLD)) {
    // differences of these would tell nothing
    if (curve.name == "ROTATION_QUINTIC any" || curve.name == "QUATERNION_QUINTIC any") continue;
    CAPTURE(curve.name);
    check_curve(curve.core(), random);
  }
}

TEST_CASE("bounds of rates hold where a rotation vector is many turns long", "[diagnostics][bounds]") {
  test::Random random(89);
  const capi::Variant variant = {"", QTRAJ_HERMITE};
  const capi::Options options = capi::make_options(variant);
  REQUIRE(qtraj_options_set_turns(options.get(), QTRAJ_TURNS_SHORTEST) == QTRAJ_OK);
  for (const double rate : {30.0, 300.0}) {
    CAPTURE(rate);
    const capi::Keyframes<double> keys = {{0, 1}, {1, 0, 0, 0, 0.8, 0.6, 0, 0}};
    const capi::Rates<double> rates = {{rate, 0.3 * rate, 0, 0, rate, 0.2 * rate}, {}};
    for (int round = 0; round < 20; ++round) check_curve(capi::must_build(options.get(), keys, rates)->core, random);
  }
}

TEST_CASE("the bounds of pieces tend to the rates", "[diagnostics][bounds]") {
  for (const test::KernelCurve& curve : test::kernel_curves(QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_HOLD)) {
    CAPTURE(curve.name);
    for (size_t i = 0; i + 1 < curve.core().timeline.key_count; ++i) {
      qtraj::RatesInSegment rates;
      if (!qtraj::rates_in_segment(curve.core(), i, 0.25, true, rates)) continue;
      const qtraj::PieceBounds bounds = qtraj::piece_bounds(curve.core(), i, {0.25, 1e-9});
      // but for the part of r' or of P' that does not turn the body
      CHECK(bounds.real.omega >= rates.omega.norm());
      CHECK(bounds.disc[0].omega <= 3.0 * bounds.real.omega);
    }
  }
}

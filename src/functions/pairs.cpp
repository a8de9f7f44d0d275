#include "functions/pairs.hpp"

#include "math/arc.hpp"
#include "math/error_free.hpp"
#include "math/trigonometry.hpp"
#include "targets/kernels.hpp"

namespace qtraj {

namespace {

// Im(a* b) with exact products: good to a few eps of its length, which plain products are not at small angles.
Vector3 relative_vector_part(const Quaternion& a, const Quaternion& b) {
  const auto minor = [&](int i, int j) { return difference_of_products(a[i], b[j], a[j], b[i]); };
  return {minor(0, 1) - minor(2, 3), minor(0, 2) - minor(3, 1), minor(0, 3) - minor(1, 2)};
}

PairEnd end_of_pair(const Quaternion& q, const Vector3& axis) { return {q, multiply(q, quaternion(0.0, axis))}; }

}  // namespace

Pair make_pair(const Quaternion& a_given, const Quaternion& b_given, Path path) {
  const Quaternion a = scaled_to_one(a_given);
  Quaternion b = scaled_to_one(b_given);
  Vector3 v = relative_vector_part(a, b);
  double cosine = dot(a, b);
  const double length_of_v = length(v), sine = length_of_v < 1e-150 ? 0.0 : length_of_v;

  if (path == Path::shortest && cosine < -kHalfTurnCosine * sine) {
    b = -b;
    v = -v;
    cosine = -cosine;
  }
  const Vector3 axis = sine == 0 ? Vector3(Vector3::Zero()) : Vector3(v / sine);
  return {normalize(a).unit.value, normalize(b).unit.value, axis, sine, cosine};
}

Status read_pair(const Input<4>& a, const Input<4>& b, size_t row, Path path, Pair& pair) {
  if (!is_finite(a, row) || !is_finite(b, row)) return Status::not_finite;
  const Quaternion a_given = row_of(a, row), b_given = row_of(b, row);
  if (largest_component(a_given) == 0 || largest_component(b_given) == 0) return Status::zero_norm;
  pair = make_pair(a_given, b_given, path);
  return Status::ok;
}

Slerp::Slerp(const Pair& pair)
    : angle_(atan2(pair.sine, pair.cosine)), is_ambiguous_(pair.cosine < 0 && pair.sine < -kOpposite * pair.cosine) {
  if (is_ambiguous_) angle_ = kPi;
  const Vector3 axis = is_ambiguous_ ? Vector3(1, 0, 0) : pair.axis;
  log_ = angle_ * axis;
  a_ = end_of_pair(pair.a, axis);
  b_ = end_of_pair(pair.b, axis);
}

Status Slerp::at(double fraction, Quaternion& q) const {
  // a quarter of the angle from the nearer end, which no fraction makes overflow
  constexpr double kFar = 0x1p60;
  const bool from_a = fraction <= 0.5;
  const double quarter = 0.25 * (from_a ? fraction : fraction - 1.0) * angle_;
  const SinCos turn = sin_cos(4.0 * std::min(std::max(quarter, -kFar), kFar));
  const PairEnd& end = from_a ? a_ : b_;
  q = turn.cos * end.q + turn.sin * end.along;
  return is_ambiguous_ ? Status::ambiguous : Status::ok;
}

Nlerp::Nlerp(const Pair& pair) : a_(end_of_pair(pair.a, pair.axis)), b_(end_of_pair(pair.b, pair.axis)) {
  // half the angle has the tangent sine / (norm + cosine) = (norm - cosine) / sine; the form is taken that does not
  // cancel
  const double norm = std::sqrt(pair.sine * pair.sine + pair.cosine * pair.cosine);
  const double adjacent = pair.cosine < 0 ? pair.sine : norm + pair.cosine;
  const double opposite = pair.cosine < 0 ? norm - pair.cosine : pair.sine;
  const double hypotenuse = std::sqrt(adjacent * adjacent + opposite * opposite);
  cosine_ = adjacent / hypotenuse;
  sine_ = opposite / hypotenuse;
}

Status Nlerp::at(double fraction, Quaternion& q) const {
  const bool from_a = fraction <= 0.5;
  const double part = from_a ? fraction : 1.0 - fraction;
  // p = m + (2 part - 1) d with m = (a + b)/2 and d = (b - a)/2, which are orthogonal, in terms of the nearer end. It
  // is scaled such that it does not overflow; only its direction matters.
  const double scale = std::abs(part) > 0x1p400 ? 0x1p-600 : 1.0;
  const double scaled_part = scale * part;
  const double across = 2.0 * scaled_part * sine_ * cosine_;
  const double ahead = scale * cosine_ * cosine_ - (2.0 * scaled_part - scale) * sine_ * sine_;

  const double size = scale_for(std::max(std::abs(across), std::abs(ahead)));
  const double x = size * ahead, y = size * across, norm = std::sqrt(x * x + y * y);
  if (norm < kOpposite * scale * size) return Status::zero_norm;
  const PairEnd& end = from_a ? a_ : b_;
  q = (x / norm) * end.q + ((from_a ? y : -y) / norm) * end.along;
  return Status::ok;
}

namespace {

constexpr RowKernel<PairRows> kSlerpKernels[] = QTRAJ_OF_EACH_TARGET(slerp);
constexpr RowKernel<PairRows> kNlerpKernels[] = QTRAJ_OF_EACH_TARGET(nlerp);

// The kernel does rows, and those that it leaves are sampled on the Curve through their pair.
template <class Curve>
Outcome sample_pairs(RowKernel<PairRows> kernel, const PairRows& pairs, size_t count) {
  const bool is_one_pair = pairs.a.rows == 1 && pairs.b.rows == 1;
  Status status = Status::ok;
  Curve curve;
  bool has_curve = false;
  const auto compute = [&](size_t row, Quaternion& q) {
    if (!has_curve || !is_one_pair) {
      Pair pair;
      status = read_pair(pairs.a, pairs.b, row, pairs.path, pair);
      if (status == Status::ok) curve = Curve(pair);
      has_curve = true;
    }
    if (!is_finite(pairs.fraction, row)) return Status::not_finite;
    if (status != Status::ok) return status;
    return curve.at(number_of(pairs.fraction, row), q);
  };
  return for_each_row(
      count, pairs.q, [&](size_t row) { return kernel(pairs, row, count); }, compute);
}

}  // namespace

Outcome slerp(const PairRows& pairs, size_t count) {
  return sample_pairs<Slerp>(kSlerpKernels[target()], pairs, count);
}

Outcome nlerp(const PairRows& pairs, size_t count) {
  return sample_pairs<Nlerp>(kNlerpKernels[target()], pairs, count);
}

}  // namespace qtraj

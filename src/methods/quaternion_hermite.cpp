// The builder of QUATERNION_HERMITE.
#include "methods/method.hpp"
#include "methods/polynomials.hpp"

namespace qtraj {
namespace {

// Keys below this part of the largest count as 0: beside it their direction is lost.
constexpr double kLeastPart = 0x1p-100;
// h q' of more than this times its key leaves a curve without digits. Products of four in the formulas stay finite.
constexpr double kLimit = 0x1p200;
// Norms and coefficients between this and its inverse are sampled in float; squares then stay in its range.
constexpr double kFloatRange = 0x1p20;

// The power of two by which keys of extreme size are multiplied, the largest component of all then being between 2^-100
// and 2^100; 1 where it is.
double common_scale(double largest) {
  double scale = 1.0;
  for (int step = 0; step < 5 && largest * scale > 0x1p100; ++step) scale *= 0x1p-200;
  for (int step = 0; step < 5 && largest * scale < 0x1p-100; ++step) scale *= 0x1p200;
  return scale;
}

// Keys and tangents as the caller wrote them, with their norms, in the signs of the cleaned keys, times the common
// scale.
class GivenKeys {
 public:
  explicit GivenKeys(const Construction& construction)
      : input_(construction.input), keys_(construction.keys), wraps_(construction.options.wraps()) {
    for (size_t row = 0; row < input_.count; ++row)
      largest_ = std::max(largest_, largest_component(row_of(input_.q_wb, row)));
    scale_ = common_scale(largest_);
  }

  // Whether all keys have a direction beside the largest.
  Outcome check(double& least) const {
    least = largest_;
    for (size_t row = 0; row < input_.count; ++row) {
      const double size = largest_component(row_of(input_.q_wb, row));
      if (size < kLeastPart * largest_) return {Status::zero_norm, row};
      least = std::min(least, size);
    }
    least *= scale_;
    return {};
  }

  // Of a curve that repeats the last key has the direction of the first, and its own norm.
  Quaternion value(size_t key) const {
    const size_t row = input_.row_of_key(key), direction = wraps_ && key == keys_.segments() ? 0 : row;
    const Quaternion p = sign(direction, key) * scaled(direction);
    return direction == row ? p : Quaternion((length(scaled(row)) / length(scaled(direction))) * p);
  }

  // h q' of a key; false past the limit, which is known before any product can overflow.
  bool scaled_tangent(const Input<4>& tangents, size_t key, double h, Quaternion& h_dp) const {
    const size_t row = input_.row_of_key(key);
    const Quaternion tangent = row_of(tangents, row);
    const double limit = kLimit * largest_component(scaled(row));
    // h first where it is long: what the scale made subnormal would have lost its digits
    const double first = h > 1.0 ? h : scale_, second = h > 1.0 ? scale_ : h;
    const double most = second > 0x1p-700 ? limit / second : 0x1p1023;
    if (first > 1.0 && largest_component(tangent) > most / first) return false;
    const Quaternion once = first * tangent;
    if (largest_component(once) > most) return false;
    h_dp = sign(row, key) * second * once;
    return true;
  }

 private:
  Quaternion scaled(size_t row) const { return scale_ * row_of(input_.q_wb, row); }
  double sign(size_t row, size_t key) const { return dot(scaled(row), keys_[key].value) < 0 ? -1.0 : 1.0; }

  const KeyframeInput& input_;
  const Keyframes& keys_;
  const bool wraps_;
  double largest_ = 0, scale_ = 1;
};

// omega_body of p/|p|, 2 Im(p* p')/|p|^2.
Vector3 body_rate(const Quaternion& p, const Quaternion& h_dp, double h) {
  return (2.0 / dot(p, p)) * vector_part(multiply(conjugate(p), h_dp)) / h;
}

}  // namespace

// QUATERNION_HERMITE: the cubic in R^4 with the values and derivatives of both keys, the out-tangent of the first and
// the in-tangent of the second, dp/dt in 1/s, normalised: CUBICSPLINE of glTF 2.0 (Khronos Group, "glTF 2.0
// specification", appendix C.5). p goes through the keys as they are written, not through unit ones: keys of a file are
// rounded to float, and dividing each by its own norm would leave the file's curve by that rounding.
//
// Signs: AS_GIVEN keys as written; SHORTEST turns a key with both its tangents. Singular: p = 0, as of all normalised
// polynomials (curve/evaluate_normalized.hpp). zero_norm with the index of a key below 2^-100 of the largest;
// rate_too_fast with that of a key where |h q'| exceeds 2^200 times the key, or 2^1023.
Outcome build_quaternion_hermite(Construction& construction) {
  const KeyframeInput& input = construction.input;
  const Keyframes& keys = construction.keys;
  const GivenKeys given(construction);
  double least = 0, largest = 0;
  const Outcome outcome = given.check(least);
  if (outcome.status != Status::ok) return outcome;

  auto* segments = static_cast<NormalizedSegment<5>*>(construction.segments);
  for (size_t i = 0; i < keys.segments(); ++i) {
    const double h = keys.step(i);
    EndValues<Quaternion> ends = {{given.value(i), given.value(i + 1)}, {}, {}};
    if (!given.scaled_tangent(input.out_tangents, i, h, ends.first[0])) return {Status::rate_too_fast, i};
    if (!given.scaled_tangent(input.in_tangents, i + 1, h, ends.first[1])) return {Status::rate_too_fast, i + 1};

    Quaternion c[4];
    cubic_through(ends, c);
    segments[i] = {2.0 / h, {}};
    for (size_t term = 0; term < 4; ++term) {
      store(c[term], segments[i].c[term]);
      largest = std::max(largest, largest_component(c[term]));
    }
    if (i == 0) construction.omega_start = body_rate(ends.value[0], ends.first[0], h);
    construction.omega_end = body_rate(ends.value[1], ends.first[1], h);
  }
  const bool in_float_range = largest <= kFloatRange && least >= 1.0 / kFloatRange;
  construction.range = in_float_range ? ExponentRange::quarter_turn : ExponentRange::any;
  return {};
}

}  // namespace qtraj

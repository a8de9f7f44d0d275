// Slerp and nlerp of a pair in long double: textbook formulas, with the one thing computed more carefully that a short
// or a nearly opposite pair needs, the sine of its angle.
#ifndef QTRAJ_TESTS_WIDE_PAIR_HPP
#define QTRAJ_TESTS_WIDE_PAIR_HPP

#include "support/long_double.hpp"

namespace wide {

// a b - c d without cancellation (W. Kahan).
inline Real difference_of_products(Real a, Real b, Real c, Real d) {
  const Real product = c * d;
  return std::fma(a, b, -product) + std::fma(-c, d, product);
}

// a and the unit direction across it towards b, the angle between them on S^3, and what it lacks to half a circle.
struct Pair {
  Quaternion a, across;
  Vector log;  // a* b = exp(log)
  Real angle, supplement;
  bool is_tie;  // shortest, but whether b or -b is nearer to a, or it is a tie, is a matter of rounding
};

// Of doubles or floats as they are, of any norm. shortest: b or -b, b where their angles to a differ by rounding only.
template <class Element>
Pair pair(const Element* a_given, const Element* b_given, bool shortest) {
  const Quaternion a = quaternion(a_given);
  Quaternion b = quaternion(b_given);
  constexpr Real kTie = 4 * std::numeric_limits<double>::epsilon();
  const Real projection = dot(a, b) / (norm(a) * norm(b));
  if (shortest && projection < -kTie) b = scaled(-1, b);
  // a* b: its vector part is made of minors of a and b
  const auto minor = [&](size_t i, size_t j) { return difference_of_products(a[i], b[j], a[j], b[i]); };
  const Vector v = {minor(0, 1) - minor(2, 3), minor(0, 2) - minor(3, 1), minor(0, 3) - minor(1, 2)};
  const Real sine = norm(v), cosine = dot(a, b);
  const Vector axis = sine == 0 ? Vector{0, 0, 0} : scaled(1 / sine, v);
  const Quaternion unit = normalized(a);
  const Real angle = std::atan2(sine, cosine);
  return {unit,
          multiply(unit, {0, axis[0], axis[1], axis[2]}),
          scaled(angle, axis),
          angle,
          std::atan2(sine, -cosine),
          shortest && std::abs(projection + kTie) < kTie / 2};
}

inline Quaternion slerp(const Pair& pair, Real fraction) {
  const Real angle = fraction * pair.angle;
  return sum(scaled(std::cos(angle), pair.a), scaled(std::sin(angle), pair.across));
}

// (1 - fraction) a + fraction b: its length and its direction.
struct Chord {
  Real norm;
  Quaternion q;
};
inline Chord nlerp(const Pair& pair, Real fraction) {
  // (1 - f) + f cos angle, from the side where it does not cancel
  const Real half_sine = std::sin(pair.angle / 2), half_cosine = std::sin(pair.supplement / 2);
  const Real along = pair.angle < kPi / 2 ? 1 - 2 * fraction * half_sine * half_sine
                                          : (1 - 2 * fraction) + 2 * fraction * half_cosine * half_cosine;
  const Real across = fraction * std::sin(std::min(pair.angle, pair.supplement));
  const Quaternion p = sum(scaled(along, pair.a), scaled(across, pair.across));
  return {norm(p), normalized(p)};
}

}  // namespace wide

#endif

// The two arithmetics that evaluation is instantiated with, and polynomials in them. Fused: AVX2, AVX-512 and AArch64;
// plain: all other targets. Results of one kind are the same bits everywhere, those of the two kinds differ in
// rounding.
//
// `Number` is double, float, or a vector of either (wide.hpp): one sample or several side by side, by the same
// operations in the same order. Where samples differ in what is done to them, both results are computed and one is
// selected, and neither may raise a floating-point exception for the sample it is not meant for.
//
// Everything in this folder's headers has internal linkage: a copy compiled for a wider instruction set must never be
// the one a linker keeps for other files.
#pragma once

#include <cstddef>
#include <utility>

#include "base/floating.hpp"
#include "math/coefficients.hpp"

// Evaluation is one straight sequence: a vector passed to a call would go through memory. Builds with assertions are
// for debuggers and sanitizers, which take minutes over such sequences.
#if defined(NDEBUG)
#define QTRAJ_INLINE inline __attribute__((always_inline))
#else
#define QTRAJ_INLINE inline
#endif

// A function that is called once a chunk or seldom, and has one copy for all that call it.
#define QTRAJ_NOINLINE __attribute__((noinline))

namespace qtraj {
namespace {

// The type of a number's samples.
template <class Number>
struct ElementOf {
  using Type = Number;
};
template <class Number>
using Element = typename ElementOf<Number>::Type;

inline double fused_multiply_add(double a, double b, double c) { return __builtin_fma(a, b, c); }
inline float fused_multiply_add(float a, float b, float c) { return __builtin_fmaf(a, b, c); }

struct Plain {
  template <class Number>
  QTRAJ_INLINE static Number multiply_add(Number a, Number b, Number c) {
    return a * b + c;
  }
};

struct Fused {
  template <class Number>
  QTRAJ_INLINE static Number multiply_add(Number a, Number b, Number c) {
    return fused_multiply_add(a, b, c);
  }
};

// One instruction on every target with a square root; rounded correctly on all.
inline double square_root(double x) { return __builtin_sqrt(x); }
inline float square_root(float x) { return __builtin_sqrtf(x); }

inline double absolute(double a) { return __builtin_fabs(a); }
inline double maximum(double a, double b) { return a < b ? b : a; }
inline double with_sign_of(double sign, double a) { return __builtin_copysign(a, sign); }

// A polynomial of coefficients.hpp in the precision of its argument.
template <class Number, class Polynomial>
constexpr const auto& coefficients(Polynomial) {
  if constexpr (sizeof(Element<Number>) == sizeof(double))
    return Polynomial::kDouble;
  else
    return Polynomial::kFloat;
}

// c0 + c1 x + ... by Estrin's scheme: neighbours are joined pairwise, then in steps of x^2, x^4. As many fused steps as
// Horner's scheme has, but few that wait for each other.
template <class Arithmetic, class Number, size_t Terms>
QTRAJ_INLINE Number estrin(const Number (&c)[Terms], Number x) {
  if constexpr (Terms == 1) {
    return c[0];
  } else {
    constexpr size_t kPairs = Terms / 2;
    Number joined[Terms - kPairs];
    for (size_t k = 0; k < kPairs; ++k) joined[k] = Arithmetic::multiply_add(c[2 * k + 1], x, c[2 * k]);
    if constexpr (Terms % 2 != 0) joined[kPairs] = c[Terms - 1];
    return estrin<Arithmetic>(joined, x * x);
  }
}

// c0 + x (c1 + c2 x + ...): the first term, which is most of the sum, is added last and rounds once.
template <class Arithmetic, class Polynomial, class Number, size_t... Rest>
QTRAJ_INLINE Number evaluate(Number x, std::index_sequence<Rest...>) {
  constexpr const auto& kCoefficients = coefficients<Number>(Polynomial{});
  // not a loop: one of more than 16 terms would stay one, and its vectors go through memory
  const Number rest[] = {Number(kCoefficients[1 + Rest])...};
  return Arithmetic::multiply_add(estrin<Arithmetic>(rest, x), x, Number(kCoefficients[0]));
}
template <class Arithmetic, class Polynomial, class Number>
QTRAJ_INLINE Number evaluate(Number x) {
  constexpr const auto& kCoefficients = coefficients<Number>(Polynomial{});
  constexpr size_t kTerms = sizeof kCoefficients / sizeof kCoefficients[0];
  return evaluate<Arithmetic, Polynomial>(x, std::make_index_sequence<kTerms - 1>());
}

// Dot product in the one order that all kernels use.
template <class Arithmetic, class Number, size_t Size>
QTRAJ_INLINE Number dot_product(const Number (&a)[Size], const Number (&b)[Size]) {
  Number sum = a[0] * b[0];
  for (size_t k = 1; k < Size; ++k) sum = Arithmetic::multiply_add(a[k], b[k], sum);
  return sum;
}

// q (1.5 - |q|^2/2): unit length to rounding where |q| is within a few hundred eps of 1.
template <class Arithmetic, class Number>
QTRAJ_INLINE void newton_normalize(Number (&q)[4]) {
  using Real = Element<Number>;
  const Number factor = Arithmetic::multiply_add(Number(Real(-0.5)), dot_product<Arithmetic>(q, q), Number(Real(1.5)));
  for (Number& component : q) component = component * factor;
}

// Polynomial with vector coefficients at x.
template <class Arithmetic, class Number, size_t Terms, size_t Size>
QTRAJ_INLINE void horner(const Number (&c)[Terms][Size], Number x, Number (&value)[Size]) {
  for (size_t k = 0; k < Size; ++k) {
    value[k] = c[Terms - 1][k];
    for (size_t term = Terms - 1; term-- > 0;) value[k] = Arithmetic::multiply_add(value[k], x, c[term][k]);
  }
}

}  // namespace
}  // namespace qtraj

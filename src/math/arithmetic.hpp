// The two arithmetics that kernels are instantiated with, and polynomials in them.
//
// Fused evaluates multiply_add with one rounding (FMA: AVX2, AVX-512 and NEON), Plain with two (all other targets).
// The compiler never contracts a * b + c by itself (-ffp-contract=off), so that FMA happens where a kernel asks for it
// and nowhere else. Results therefore come in two kinds of bits: all fused targets agree to the last bit, all plain
// targets do, and the two kinds differ in rounding only.
//
// `Number` is double, float, or a vector of either (simd/wide.hpp): one sample, or one per lane, by the same operations
// in the same order. Code that samples take differently is branch-free: both results are computed and one is selected,
// and neither may raise a floating-point exception for the sample it is not meant for.
//
// Whatever kernels include has internal linkage: the linker must not keep the copy of a function that was compiled for
// a wider instruction set (base/floating.hpp).
#pragma once

#include <cstddef>
#include <utility>

#include "base/floating.hpp"
#include "math/coefficients.hpp"

// Evaluation is inlined into one straight sequence, because vectors passed to a call would be spilled to the stack.
// Builds with assertions do without: they are for debuggers and sanitizers, which take minutes over such sequences.
#if defined(NDEBUG)
#define QTRAJ_INLINE inline __attribute__((always_inline))
#else
#define QTRAJ_INLINE inline
#endif

// For functions that are called once a chunk or rarely: all callers share one copy.
#define QTRAJ_NOINLINE __attribute__((noinline))

namespace qtraj {
namespace {

// The scalar type of a Number: its own, or that of its lanes.
template <class Number>
struct ElementOf {
  using Type = Number;
};
template <class Number>
using Element = typename ElementOf<Number>::Type;

// GCC 12 makes one instruction of a multiply-add and the negation of its result, -a b - c, which is 0 where -(a b + c)
// is -0. It does so for single numbers and not for vectors. For this it must see where a value comes from: here it
// does not, at the cost of no instruction.
template <class Real>
QTRAJ_INLINE Real of_hidden_origin(Real value) {
#if defined(__GNUC__) && !defined(__clang__)
#if defined(__x86_64__)
  __asm__("" : "+x"(value));
#elif defined(__aarch64__)
  __asm__("" : "+w"(value));
#endif
#endif
  return value;
}
QTRAJ_INLINE double fused_multiply_add(double a, double b, double c) {
  return of_hidden_origin(__builtin_fma(a, b, c));
}
QTRAJ_INLINE float fused_multiply_add(float a, float b, float c) { return of_hidden_origin(__builtin_fmaf(a, b, c)); }

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

// Correctly rounded on every target, and one instruction wherever there is one.
inline double square_root(double x) { return __builtin_sqrt(x); }
inline float square_root(float x) { return __builtin_sqrtf(x); }

inline double absolute(double a) { return __builtin_fabs(a); }
inline float absolute(float a) { return __builtin_fabsf(a); }
inline double maximum(double a, double b) { return a < b ? b : a; }
inline float maximum(float a, float b) { return a < b ? b : a; }
inline double minimum(double a, double b) { return b < a ? b : a; }
inline float minimum(float a, float b) { return b < a ? b : a; }
inline double with_sign_of(double sign, double a) { return __builtin_copysign(a, sign); }
inline float with_sign_of(float sign, float a) { return __builtin_copysignf(a, sign); }

// The coefficients of a polynomial of coefficients.hpp in the precision of its argument.
template <class Number, class Polynomial>
constexpr const auto& coefficients(Polynomial) {
  if constexpr (sizeof(Element<Number>) == sizeof(double))
    return Polynomial::kDouble;
  else
    return Polynomial::kFloat;
}

// Calls `visit(k)` for each k below Count, unrolled. In a loop GCC 12 keeps the array in memory and merges a copy of
// four doubles into one of 32 bytes, for which store forwarding fails: the 32-byte load cannot be forwarded from the
// four 8-byte stores before it.
template <class Visit, size_t... K>
QTRAJ_INLINE void each_of(const Visit& visit, std::index_sequence<K...>) {
  (visit(K), ...);
}
template <size_t Count, class Visit>
QTRAJ_INLINE void each_of(const Visit& visit) {
  each_of(visit, std::make_index_sequence<Count>());
}

// c0 + c1 x + ... by Estrin's scheme: neighbouring terms are joined in pairs, these again with x^2, x^4, ... It takes
// as many multiply-adds as Horner's scheme, but its dependency chain grows with the logarithm of the number of terms.
template <class Arithmetic, class Number, size_t Terms>
QTRAJ_INLINE Number estrin(const Number (&c)[Terms], Number x);
// Not a loop, in which compilers keep the joined terms on the stack.
template <class Arithmetic, class Number, size_t Terms, size_t... Pair>
QTRAJ_INLINE Number join_pairs(const Number (&c)[Terms], Number x, std::index_sequence<Pair...>) {
  const auto pair = [&](size_t k) { return Arithmetic::multiply_add(c[2 * k + 1], x, c[2 * k]); };
  if constexpr (Terms % 2 == 0) {
    const Number joined[] = {pair(Pair)...};
    return estrin<Arithmetic>(joined, x * x);
  } else {
    const Number joined[] = {pair(Pair)..., c[Terms - 1]};
    return estrin<Arithmetic>(joined, x * x);
  }
}
template <class Arithmetic, class Number, size_t Terms>
QTRAJ_INLINE Number estrin(const Number (&c)[Terms], Number x) {
  if constexpr (Terms == 1)
    return c[0];
  else
    return join_pairs<Arithmetic>(c, x, std::make_index_sequence<Terms / 2>());
}

// The terms of a polynomial from c_First on, divided by x^First: c_First + c_(First+1) x + ...
template <class Arithmetic, class Polynomial, size_t First, class Number, size_t... Rest>
QTRAJ_INLINE Number evaluate_from(Number x, std::index_sequence<Rest...>) {
  constexpr const auto& kCoefficients = coefficients<Number>(Polynomial{});
  // not a loop: compilers do not unroll one of more than 16 terms, and would spill its vectors to the stack
  const Number rest[] = {Number(kCoefficients[First + Rest])...};
  return estrin<Arithmetic>(rest, x);
}
template <class Arithmetic, class Polynomial, size_t First, class Number>
QTRAJ_INLINE Number evaluate_from(Number x) {
  constexpr const auto& kCoefficients = coefficients<Number>(Polynomial{});
  constexpr size_t kTerms = sizeof kCoefficients / sizeof kCoefficients[0];
  return evaluate_from<Arithmetic, Polynomial, First>(x, std::make_index_sequence<kTerms - First>());
}

// c0 + x (c1 + c2 x + ...): the first term, which is most of the sum, is added last, so that it is rounded once.
template <class Arithmetic, class Polynomial, class Number>
QTRAJ_INLINE Number evaluate(Number x) {
  const Number first(coefficients<Number>(Polynomial{})[0]);
  return Arithmetic::multiply_add(evaluate_from<Arithmetic, Polynomial, 1>(x), x, first);
}

// The dot product, summed from the left as in all kernels.
template <class Arithmetic, class Number, size_t Size>
QTRAJ_INLINE Number dot_product(const Number (&a)[Size], const Number (&b)[Size]) {
  Number sum = a[0] * b[0];
  for (size_t k = 1; k < Size; ++k) sum = Arithmetic::multiply_add(a[k], b[k], sum);
  return sum;
}

// One Newton step towards unit length, q (1.5 - |q|^2/2): exact to rounding where |q| is within a few hundred eps of 1.
template <class Arithmetic, class Number>
QTRAJ_INLINE void newton_normalize(Number (&q)[4]) {
  using Real = Element<Number>;
  const Number factor = Arithmetic::multiply_add(Number(Real(-0.5)), dot_product<Arithmetic>(q, q), Number(Real(1.5)));
  for (Number& component : q) component = component * factor;
}

// A polynomial with vector coefficients at x, by Horner's scheme.
template <class Arithmetic, class Number, size_t Terms, size_t Size>
QTRAJ_INLINE void horner(const Number (&c)[Terms][Size], Number x, Number (&value)[Size]) {
  for (size_t k = 0; k < Size; ++k) {
    value[k] = c[Terms - 1][k];
    for (size_t term = Terms - 1; term-- > 0;) value[k] = Arithmetic::multiply_add(value[k], x, c[term][k]);
  }
}

}  // namespace
}  // namespace qtraj

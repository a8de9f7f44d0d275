// Wide<Real>, a vector of samples, one per lane: the Number that kernels instantiate evaluators with. A thin layer over
// Highway, as wide as the vectors of the instruction set that the file is compiled for.
#pragma once

// Static dispatch: the instruction set is that of the compiler's flags, without extensions that we do not use. Nothing
// of Highway is linked.
#define HWY_COMPILE_ONLY_STATIC
#define HWY_DISABLE_F16C
#define HWY_DISABLE_PCLMUL_AES
#include <hwy/highway.h>

#include "math/arithmetic.hpp"
#include "math/error_free.hpp"

namespace qtraj {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// The scalar overloads, which the functions below would otherwise hide.
using qtraj::all;
using qtraj::any;
using qtraj::select;
using qtraj::two_product;

// A lane mask: the samples that a condition holds for.
template <class Real>
struct WideMask {
  using Tag = hn::ScalableTag<Real>;
  hn::Mask<Tag> lanes;
};
template <class Real>
QTRAJ_INLINE bool any(WideMask<Real> mask) {
  return !hn::AllFalse(typename WideMask<Real>::Tag(), mask.lanes);
}
template <class Real>
QTRAJ_INLINE bool all(WideMask<Real> mask) {
  return hn::AllTrue(typename WideMask<Real>::Tag(), mask.lanes);
}
template <class Real>
QTRAJ_INLINE WideMask<Real> operator&(WideMask<Real> a, WideMask<Real> b) {
  return {hn::And(a.lanes, b.lanes)};
}
template <class Real>
QTRAJ_INLINE WideMask<Real> operator|(WideMask<Real> a, WideMask<Real> b) {
  return {hn::Or(a.lanes, b.lanes)};
}

template <class Real>
struct Wide {
  using Tag = hn::ScalableTag<Real>;
  static constexpr size_t kLanes = HWY_LANES(Real);

  hn::Vec<Tag> lanes;

  Wide() = default;
  QTRAJ_INLINE explicit Wide(Real value) : lanes(hn::Set(Tag(), value)) {}
  QTRAJ_INLINE static Wide of(hn::Vec<Tag> lanes) {
    Wide wide;
    wide.lanes = lanes;
    return wide;
  }
  QTRAJ_INLINE static Wide load(const Real* from) { return of(hn::LoadU(Tag(), from)); }
  QTRAJ_INLINE void store(Real* to) const { hn::StoreU(lanes, Tag(), to); }
};

template <class Real>
struct ElementOf<Wide<Real>> {
  using Type = Real;
};

template <class Real>
QTRAJ_INLINE Wide<Real> operator+(Wide<Real> a, Wide<Real> b) {
  return Wide<Real>::of(hn::Add(a.lanes, b.lanes));
}
template <class Real>
QTRAJ_INLINE Wide<Real> operator-(Wide<Real> a, Wide<Real> b) {
  return Wide<Real>::of(hn::Sub(a.lanes, b.lanes));
}
template <class Real>
QTRAJ_INLINE Wide<Real> operator-(Wide<Real> a) {
  // not hn::Neg: the compiler cannot fold it into an FMA, which negates its operands for free
  return Wide<Real>::of(hn::Vec<typename Wide<Real>::Tag>{-a.lanes.raw});
}
template <class Real>
QTRAJ_INLINE Wide<Real> operator*(Wide<Real> a, Wide<Real> b) {
  return Wide<Real>::of(hn::Mul(a.lanes, b.lanes));
}
template <class Real>
QTRAJ_INLINE Wide<Real> operator*(Real a, Wide<Real> b) {
  return Wide<Real>(a) * b;
}
template <class Real>
QTRAJ_INLINE Wide<Real> operator/(Wide<Real> a, Wide<Real> b) {
  return Wide<Real>::of(hn::Div(a.lanes, b.lanes));
}
template <class Real>
QTRAJ_INLINE WideMask<Real> operator<(Wide<Real> a, Wide<Real> b) {
  return {hn::Lt(a.lanes, b.lanes)};
}
template <class Real>
QTRAJ_INLINE WideMask<Real> operator<=(Wide<Real> a, Wide<Real> b) {
  return {hn::Le(a.lanes, b.lanes)};
}
template <class Real>
QTRAJ_INLINE WideMask<Real> operator!=(Wide<Real> a, Wide<Real> b) {
  return {hn::Ne(a.lanes, b.lanes)};
}
template <class Real>
QTRAJ_INLINE Wide<Real> fused_multiply_add(Wide<Real> a, Wide<Real> b, Wide<Real> c) {
  return Wide<Real>::of(hn::MulAdd(a.lanes, b.lanes, c.lanes));
}
template <class Real>
QTRAJ_INLINE Wide<Real> square_root(Wide<Real> a) {
  return Wide<Real>::of(hn::Sqrt(a.lanes));
}
template <class Real>
QTRAJ_INLINE Wide<Real> select(WideMask<Real> condition, Wide<Real> yes, Wide<Real> no) {
  return Wide<Real>::of(hn::IfThenElse(condition.lanes, yes.lanes, no.lanes));
}
template <class Real>
QTRAJ_INLINE Wide<Real> absolute(Wide<Real> a) {
  return Wide<Real>::of(hn::Abs(a.lanes));
}
template <class Real>
QTRAJ_INLINE Wide<Real> maximum(Wide<Real> a, Wide<Real> b) {
  return Wide<Real>::of(hn::Max(a.lanes, b.lanes));
}
template <class Real>
QTRAJ_INLINE Wide<Real> minimum(Wide<Real> a, Wide<Real> b) {
  return Wide<Real>::of(hn::Min(a.lanes, b.lanes));
}
template <class Real>
QTRAJ_INLINE Wide<Real> with_sign_of(Wide<Real> sign, Wide<Real> a) {
  return Wide<Real>::of(hn::CopySign(a.lanes, sign.lanes));
}

// With FMA the rounding error of a product takes one more instruction. It is exact in the range that error_free.hpp
// gives, hence the same bits.
#if defined(__FMA__) || defined(__aarch64__)
QTRAJ_INLINE DoubleDoubleOf<Wide<double>> two_product(Wide<double> a, Wide<double> b) {
  const Wide<double> product = a * b;
  return {product, fused_multiply_add(a, b, -product)};
}
#endif

// ---- Doubles that accompany a vector of Real: times, and rates in time ----

// As many doubles as Wide<Real> has lanes, in one vector or in two.
template <class Real>
struct Doubles;

template <>
struct Doubles<double> {
  static constexpr size_t kParts = 1;
  Wide<double> part[1];
  QTRAJ_INLINE Wide<double> rounded() const { return part[0]; }
  QTRAJ_INLINE static Doubles of(Wide<double> a) { return {{a}}; }
};

template <>
struct Doubles<float> {
  static constexpr size_t kParts = 2;
  Wide<double> part[2];
  QTRAJ_INLINE Wide<float> rounded() const {
    const hn::Half<Wide<float>::Tag> half;
    return Wide<float>::of(
        hn::Combine(Wide<float>::Tag(), hn::DemoteTo(half, part[1].lanes), hn::DemoteTo(half, part[0].lanes)));
  }
  QTRAJ_INLINE static Doubles of(Wide<float> a) {
    const hn::Half<Wide<float>::Tag> half;
    const Wide<double>::Tag wide;
    return {{Wide<double>::of(hn::PromoteTo(wide, hn::LowerHalf(half, a.lanes))),
             Wide<double>::of(hn::PromoteTo(wide, hn::UpperHalf(half, a.lanes)))}};
  }
};

}  // namespace
}  // namespace qtraj

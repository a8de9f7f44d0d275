// What evaluators have in common. An evaluator samples segments of one kind, in two steps, so that several vectors can
// be started before the first of them is finished (sample_many.hpp):
//   SegmentOf<Value>           the segment, its fields any kind of number
//   scale(segment), offset(segment)
//                              its parameter is x = (t - t_i) scale - offset; rates per unit of x take scale to time
//   Partial<Number>            what the first step leaves
//   start<Mode>(segment, x, partial)
//                              the first step
//   finish<Mode>(segment, x, partial, q)
//                              orientation
//   finish_rates<Mode>(segment, x, partial, wants_alpha, q, rates)
//                              the same orientation, and rates in the body frame, per unit of x; alpha where it is
//                              wanted, which the caller knows for all samples at once
#pragma once

#include "curve/segment.hpp"
#include "math/vector_algebra.hpp"

namespace qtraj {
namespace {

// With rates or without; kOneSegment: all lanes have the same segment.
template <bool kRates, bool kOne>
struct SampleMode {
  static constexpr bool kWithRates = kRates, kOneSegment = kOne;
};

struct EvaluatorDefaults {
  EvaluatorDefaults() = default;
  // An evaluator is made from the range of the curve's exponents, which most do not need.
  explicit EvaluatorDefaults(ExponentRange) {}

  // Whether the offset is the second field of the segment, rather than 1. The scale is the first.
  static constexpr bool kHasOffset = false;

  // Whether several vectors of a run are started before the first is finished (sample_many.hpp). Not where handing over
  // what the first step leaves costs more than is gained.
  template <bool kWithRates>
  static constexpr bool kInTwoSteps = !kWithRates;

  // How much there is to do for a sample without rates, from 1 for the least: in vectors of two lanes, gathering a
  // segment for each lane costs more than little work gains.
  static constexpr int kWork = 2;

  // Whether rates per unit of x are below 2^400 in all segments, so that a scale of at most 2^300 takes none of them
  // out of range.
  static constexpr bool kSmallRates = true;

  template <class Segment>
  static double scale(const Segment& segment) {
    return segment.scale;
  }
  template <class Segment>
  static double offset(const Segment&) {
    return 1.0;
  }
};

// In double for float samples too: the difference of times and the scale may lie outside the range of float.
template <class Arithmetic, class Number>
Number parameter(Number elapsed, Number scale, Number offset) {
  return Arithmetic::multiply_add(elapsed, scale, -offset);
}

}  // namespace
}  // namespace qtraj

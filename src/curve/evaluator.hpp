// What evaluators have in common. An evaluator samples segments of one kind in two steps, start and finish, so that
// several vectors can be started before the first of them is finished (sample_many.hpp):
//   SegmentOf<Value>           the segment, its fields any kind of number
//   scale(segment), offset(segment)
//                              the parameter is x = (t - t_i) scale - offset; rates per unit of x, times scale, are
//                              rates in time
//   PartialOf<Number, kRates>  the partial result that start hands to finish, or to finish_rates
//   start<Mode>(segment, x, partial)
//                              the first step
//   finish<Mode>(segment, x, partial, q)
//                              the orientation
//   finish_rates<Mode>(segment, x, partial, wants_alpha, q, rates)
//                              the same orientation, and rates in the body frame per unit of x; alpha only where
//                              wants_alpha, which is the same for all samples of a call
#pragma once

#include "curve/segment.hpp"
#include "math/vector_algebra.hpp"

namespace qtraj {
namespace {

// Whether rates are evaluated, and whether all lanes have the same segment (kOneSegment).
template <bool kRates, bool kOne>
struct SampleMode {
  static constexpr bool kWithRates = kRates, kOneSegment = kOne;
};

struct EvaluatorDefaults {
  EvaluatorDefaults() = default;
  // Evaluators are constructed from the range of the curve's exponents, which most of them ignore.
  explicit EvaluatorDefaults(ExponentRange) {}

  // Whether the offset is the second field of the segment; otherwise it is 1. The scale is the first field.
  static constexpr bool kHasOffset = false;

  // Whether several vectors of a run are started before the first is finished (sample_many.hpp). Not where storing and
  // reloading the partial results costs more than the overlap gains.
  template <bool kWithRates>
  static constexpr bool kInTwoSteps = !kWithRates;

  // How many times a batch takes at once, and how many of them, where they are scattered, it looks up at once: many, so
  // that gathers overlap. Both cost stack, which segments of many fields need themselves.
  static constexpr size_t kChunk = 240, kSearched = 240;

  // Cost of a sample without rates, from 1 for the cheapest kind. In vectors of two lanes, cheap samples gain less from
  // vectors than it costs to gather a segment per lane.
  static constexpr int kWork = 2;

  // Whether runs with rates have a loop of their own (sample_many.hpp), compiled for one segment in all lanes, instead
  // of the one that they share with scattered times.
  template <class Real>
  static constexpr bool kOwnLoopWithRates = false;

  // Whether rates per unit of x are below 2^400 in all segments, so that a scale of at most 2^300 cannot make them
  // overflow.
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

// The parameter x. Float samples compute it in double too: the difference of times and the scale may be outside the
// range of float.
template <class Arithmetic, class Number>
Number parameter(Number elapsed, Number scale, Number offset) {
  return Arithmetic::multiply_add(elapsed, scale, -offset);
}

}  // namespace
}  // namespace qtraj

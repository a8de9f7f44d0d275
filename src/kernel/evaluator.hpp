// What evaluators have in common. An evaluator samples segments of one kind, in two steps, so that vectors can be begun
// before the one in front is finished (batch.hpp):
//   SegmentOf<Value>           the segment, its fields any kind of number
//   scale(segment), offset(segment)
//                              its parameter is x = (t - t_i) scale - offset; rates per unit of x take scale to time
//   Begun<Number>              what the first step leaves
//   begin<Task>(segment, x, begun)
//                              the first step
//   finish<Task>(segment, x, begun, q)
//                              orientation
//   finish_rates<Task>(segment, x, begun, wants_alpha, q, rates)
//                              the same orientation, and rates in the body frame, per unit of x; alpha where it is
//                              wanted, which the caller knows for all samples at once
#pragma once

#include "motion.hpp"
#include "qtraj/segment.hpp"

namespace qtraj {
namespace {

// With rates or without; kOneSegment: all lanes have the same segment.
template <bool kRates, bool kOne>
struct EvaluatorTask {
  static constexpr bool kWithRates = kRates, kOneSegment = kOne;
};

struct EvaluatorDefaults {
  // What float samples are worked out in.
  template <class Real>
  using Working = Real;

  // Whether the offset is the second field of the segment, rather than 1. The scale is the first.
  static constexpr bool kHasOffset = false;

  // Whether vectors of a run are begun before the one in front is finished (batch.hpp). Not where handing over what the
  // first step leaves costs more than is gained.
  template <bool kWithRates>
  static constexpr bool kInTwoSteps = !kWithRates;

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

// Sampling ordinary vector curves at many times in vectors of times, one component after the other: a run, the samples
// in one segment, or scattered times, each in a segment of its own. Everything else goes row by row to vector_rows.hpp,
// with the same bits.
#pragma once

#include "curve/chunk_times.hpp"
#include "curve/evaluate_vector.hpp"
#include "curve/find_segments.hpp"
#include "curve/runs.hpp"
#include "curve/vector_rows.hpp"
#include "curve/wide_output.hpp"
#include "rows/wide_rows.hpp"

namespace qtraj {
namespace {

// ---- Where the numbers of a segment come from ----

// One segment for all lanes.
class OneSegment {
 public:
  QTRAJ_INLINE OneSegment(const VectorCurve& curve, size_t segment)
      : segment_(vector_segment(curve, segment)), dim_(curve.dim) {}

  double h() const { return segment_.h; }
  QTRAJ_INLINE Wide<double> left(size_t c) const { return Wide<double>(segment_.left[c]); }
  QTRAJ_INLINE Wide<double> right(size_t c) const { return Wide<double>(segment_.right[c]); }
  QTRAJ_INLINE Wide<double> shape(size_t term, size_t c) const { return Wide<double>(segment_.shape[term * dim_ + c]); }

 private:
  const VectorSegment segment_;
  const size_t dim_;
};

// One for each lane.
class SegmentOfEachLane {
 public:
  QTRAJ_INLINE SegmentOfEachLane(const VectorCurve& curve, Indices segments)
      : keys_(vector_keys_of(curve)),
        shapes_(shapes_of(curve)),
        dim_(curve.dim),
        to_right_(curve.holds_keys ? 0 : curve.dim),
        key_(multiple(segments, curve.dim)),
        shape_(multiple(segments, curve.dim * curve.terms)) {}

  QTRAJ_INLINE Wide<double> left(size_t c) const { return gather(keys_ + c, key_); }
  QTRAJ_INLINE Wide<double> right(size_t c) const { return gather(keys_ + to_right_ + c, key_); }
  QTRAJ_INLINE Wide<double> shape(size_t term, size_t c) const { return gather(shapes_ + term * dim_ + c, shape_); }

 private:
  // Of doubles below 2^52, exactly: most targets have no product of 64-bit integers.
  QTRAJ_INLINE static Indices multiple(Indices segments, size_t factor) {
    const Wide<double>::Tag tag;
    const IndexTag bits;
    const auto shift = hn::Set(tag, 0x1p52);
    const auto number = hn::Sub(hn::BitCast(tag, hn::Or(segments, hn::BitCast(bits, shift))), shift);
    const auto product = hn::Add(hn::Mul(number, hn::Set(tag, static_cast<double>(factor))), shift);
    return hn::Xor(hn::BitCast(bits, product), hn::BitCast(bits, shift));
  }

  const double *keys_, *shapes_;
  const size_t dim_, to_right_;
  const Indices key_, shape_;
};

// ---- One component ----

struct ComponentLanes {
  Wide<double> value, first, second;
};

// Component c of the segments.
template <class Segments>
QTRAJ_INLINE VectorComponent<Wide<double>> component(const Segments& segments, const SegmentPosition<Wide<double>>& at,
                                                     size_t terms, size_t c) {
  const Wide<double> zero(0.0), left = segments.left(c), right = segments.right(c);
  VectorComponent<Wide<double>> p = {select(at.is_first_half, left, right), right - left, zero, zero, zero, zero};
  if (terms > 0) p.a = segments.shape(0, c), p.b = segments.shape(1, c);
  if (terms > 2) p.c = segments.shape(2, c), p.d = segments.shape(3, c);
  return p;
}

template <class Segments>
QTRAJ_INLINE Wide<double> evaluate_value(const Segments& segments, const SegmentPosition<Wide<double>>& at,
                                         size_t terms, size_t c) {
  const VectorComponent<Wide<double>> p = component(segments, at, terms, c);
  return with_terms(terms, [&](auto constant) { return vector_value<decltype(constant)::value>(p, at); });
}

// Value, and the derivatives by time where they are asked for. Not inlined into the loops over components and outputs,
// which would multiply its code.
template <class Segments>
QTRAJ_NOINLINE void evaluate_component(const Segments& segments, const SegmentPosition<Wide<double>>& at,
                                       Wide<double> rate, size_t terms, bool wants_derivatives, size_t c,
                                       ComponentLanes& lanes) {
  const VectorComponent<Wide<double>> p = component(segments, at, terms, c);
  with_terms(terms, [&](auto constant) {
    constexpr size_t kTerms = decltype(constant)::value;
    lanes.value = vector_value<kTerms>(p, at);
    if (!wants_derivatives) return;
    vector_derivatives<kTerms>(p, at, lanes.first, lanes.second);
    lanes.first = lanes.first * rate;
    lanes.second = lanes.second * rate * rate;
  });
}

// ---- Many times ----

template <class Real>
class VectorBatch {
 public:
  VectorBatch(const VectorCurve& curve, const TimeReader& source, size_t count, const VectorOutputs<Real>& outputs)
      : curve_(curve),
        index_(knot_index(curve.timeline)),
        source_(source),
        times_(source, count),
        count_(count),
        outputs_(outputs),
        wants_derivatives_(outputs.first || outputs.second) {}

  Outcome sample(size_t& cursor) {
    for (first_row_ = 0; first_row_ < count_; first_row_ += kChunk) {
      const size_t rows = count_ - first_row_ < kChunk ? count_ - first_row_ : kChunk;
      if (times_.read(first_row_, rows) && sample_runs(cursor)) continue;
      if (kScattersInVectors && curve_.timeline.longest_gap == __builtin_inf())
        sample_scattered(rows);
      else
        sample_each(0, rows, cursor);
    }
    return outcome_;
  }

 private:
  using Number = Wide<double>;
  static constexpr size_t kChunk = 256, kLanes = Number::kLanes;
  // From so many rows on, a run is faster than a segment for each lane, which vectors of two are too short for.
  static constexpr size_t kLeastRun = kLanes / 2;
  static constexpr bool kScattersInVectors = kLanes > 2;

  // False, with nothing done, where runs would on average be shorter than that or times are outside the knots.
  bool sample_runs(size_t& cursor) {
    return for_each_run(times_, index_, curve_.timeline, kLeastRun, cursor,
                        [&](size_t segment, size_t begin, size_t end) {
                          if (is_gap(curve_.timeline, index_.knots, segment))
                            sample_each(begin, end, segment);
                          else
                            sample_run(segment, begin, end);
                        });
  }

  QTRAJ_NOINLINE void sample_run(size_t segment, size_t begin, size_t end) {
    if (!wants_derivatives_) {
      const size_t size = group_size();
      return size == 1   ? sample_values<1>(segment, begin, end)
             : size == 3 ? sample_values<3>(segment, begin, end)
                         : sample_values<4>(segment, begin, end);
    }
    const OneSegment numbers(curve_, segment);
    const Number knot(index_.knots[segment]), h(numbers.h()), rate(1.0 / numbers.h());
    for (size_t i = begin; i < end; i += kLanes) {
      const SegmentPosition<Number> at((load_times(i, end) - knot) / h);
      times_.prefetch(i);
      if (!write(numbers, at, rate, i, end)) sample_each(i, end - i < kLanes ? end : i + kLanes, segment);
    }
  }

  // The same for values alone, with a group of components in registers.
  template <size_t Size>
  QTRAJ_NOINLINE void sample_values(size_t segment, size_t begin, size_t end) {
    const OneSegment numbers(curve_, segment);
    const Number knot(index_.knots[segment]), h(numbers.h());
    for (size_t i = begin; i < end; i += kLanes) {
      const SegmentPosition<Number> at((load_times(i, end) - knot) / h);
      times_.prefetch(i);
      bool fits = true;
      for (size_t next = 0; next < curve_.dim; next += Size) {
        const size_t c = group_at(next, Size);
        Number value[Size];
        for (size_t k = 0; k < Size; ++k) value[k] = evaluate_value(numbers, at, curve_.terms, c + k);
        fits = write_rows(value, outputs_.value, c, i, end) && fits;
      }
      if (!fits) sample_each(i, end - i < kLanes ? end : i + kLanes, segment);
    }
  }

  QTRAJ_INLINE Number load_times(size_t i, size_t end) const {
    if (end - i >= kLanes) return Number::load(times_.from(i));
    double padded[kLanes];
    times_.fill_up(i, end, padded);
    return Number::load(padded);
  }

  // Times outside the knots are sampled as if they were the first knot, and again one by one.
  QTRAJ_NOINLINE void sample_scattered(size_t rows) {
    int64_t found[kChunk + kLanes];
    const bool all_inside = times_.clamp(index_.knots[0], curve_.timeline.last_inside);
    find_segments(index_, times_.from(0), rows, found);
    for (size_t i = 0; i < rows; i += kLanes) {
      const Indices segments = hn::LoadU(IndexTag(), found + i);
      const Number knot = gather(index_.knots, segments), h = gather(index_.knots + 1, segments) - knot;
      const SegmentPosition<Number> at((Number::load(times_.from(i)) - knot) / h);
      times_.prefetch(i);
      if (!write(SegmentOfEachLane(curve_, segments), at, Number(1.0) / h, i, rows))
        sample_each(i, rows - i < kLanes ? rows : i + kLanes, 0);
    }
    for (size_t i = 0; i < rows && !all_inside; ++i) {
      const double time = source_[first_row_ + i];
      if (!is_finite(time) || !is_inside(curve_.timeline, time)) sample_each(i, i + 1, 0);
    }
  }

  QTRAJ_NOINLINE void sample_each(size_t begin, size_t end, size_t cursor) {
    for (size_t i = begin; i < end; ++i) {
      const size_t row = first_row_ + i;
      const Status status = sample_vector_at(curve_, source_[row], cursor, from_row(outputs_, row, curve_.dim));
      if (status != Status::ok && (outcome_.status == Status::ok || row < outcome_.index)) outcome_ = {status, row};
    }
  }

  // ---- Writing ----

  // Components are written in groups of three or four, whose rows are interleaved, else number by number.
  size_t group_size() const { return curve_.dim < 3 ? 1 : curve_.dim == 3 ? 3 : 4; }
  // The last group may overlap the one before.
  size_t group_at(size_t next, size_t size) const { return next + size <= curve_.dim ? next : curve_.dim - size; }

  // False where a number is too large for Real: then the rows are to be done again.
  template <class Segments>
  QTRAJ_INLINE bool write(const Segments& segments, const SegmentPosition<Number>& at, Number rate, size_t i,
                          size_t end) const {
    const size_t size = group_size();
    bool fits = true;
    for (size_t next = 0; next < curve_.dim; next += size) {
      const size_t c = group_at(next, size);
      Number value[4], first[4], second[4];
      for (size_t k = 0; k < size; ++k) {
        ComponentLanes lanes;
        evaluate_component(segments, at, rate, curve_.terms, wants_derivatives_, c + k, lanes);
        value[k] = lanes.value;
        if (wants_derivatives_) first[k] = lanes.first, second[k] = lanes.second;
      }
      if (outputs_.value) fits = write_group(value, size, outputs_.value, c, i, end) && fits;
      if (outputs_.first) fits = write_group(first, size, outputs_.first, c, i, end) && fits;
      if (outputs_.second) fits = write_group(second, size, outputs_.second, c, i, end) && fits;
    }
    return fits;
  }

  QTRAJ_NOINLINE bool write_group(Number (&numbers)[4], size_t size, Real* to, size_t c, size_t i, size_t end) const {
    if (size == 4) return write_rows(numbers, to, c, i, end);
    Number three[] = {numbers[0], numbers[1], numbers[2]}, one[] = {numbers[0]};
    return size == 3 ? write_rows(three, to, c, i, end) : write_rows(one, to, c, i, end);
  }

  template <size_t Size>
  QTRAJ_INLINE bool write_rows(Number (&numbers)[Size], Real* to, size_t c, size_t i, size_t end) const {
    if (sizeof(Real) < sizeof(double) && !limit_lanes(largest_of<Real>(), numbers)) return false;
    const size_t row = first_row_ + i, rows = end - i < kLanes ? end - i : kLanes;
    if (Size > 1 && curve_.dim == Size && count_ - row >= kLanes) {
      prefetch_output<Real, Size, kLanes>(to, row, count_);
      interleave(numbers, to + Size * row);
      return true;
    }
    Real lanes[Size * kLanes];
    interleave(numbers, lanes);
    for (size_t k = 0; k < rows; ++k)
      std::memcpy(to + (row + k) * curve_.dim + c, lanes + Size * k, Size * sizeof(Real));
    return true;
  }

  // Rows of the numbers, one behind the other.
  template <size_t Size>
  QTRAJ_INLINE static void interleave(const Number (&numbers)[Size], Real* to) {
    if constexpr (Size > 1) {
      store_rows(numbers, to, 0);
    } else {
      double lanes[kLanes];
      numbers[0].store(lanes);
      for (size_t k = 0; k < kLanes; ++k) to[k] = static_cast<Real>(lanes[k]);
    }
  }

  const VectorCurve& curve_;
  const KnotIndex index_;
  const TimeReader& source_;
  ChunkTimes<kLanes, kChunk> times_;
  const size_t count_;
  const VectorOutputs<Real>& outputs_;
  const bool wants_derivatives_;
  Outcome outcome_;
  size_t first_row_ = 0;
};

template <class Real>
Outcome sample_vectors_in_batch(const VectorCurve& curve, const TimeSource& source, size_t count, size_t& cursor,
                                const VectorOutputs<Real>& outputs) {
  if (count < Wide<double>::kLanes || !curve.is_ordinary)
    return sample_vector_rows(curve, source, count, cursor, outputs);
  const TimeReader times(source, count);
  return VectorBatch<Real>(curve, times, count, outputs).sample(cursor);
}

}  // namespace
}  // namespace qtraj

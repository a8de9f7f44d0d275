// Sampling many times at once, in vectors. Times are taken in chunks. A chunk of increasing times that stays for a
// while in each segment is sampled run by run, the segment's numbers the same in all lanes; in any other chunk each
// lane has a segment of its own. Both do to each sample what sample.hpp does, to the last bit, so that it does not
// matter which way a chunk goes. Rows that vectors cannot do (times outside the knots or not finite, rates that
// overflow) are done again one at a time.
#pragma once

#include "sample.hpp"
#include "wide.hpp"

namespace qtraj {
namespace {

constexpr size_t kChunk = 256;
// Samples of a segment from which a run is worth its setting up, in vectors.
constexpr size_t kLeastRun = 2;

template <class Real>
struct WideRow {
  Wide<Real> q[4], omega[3], alpha[3];
};

QTRAJ_INLINE void store_interleaved(const Wide<double> (&v)[4], double* to) {
  hn::StoreInterleaved4(v[0].lanes, v[1].lanes, v[2].lanes, v[3].lanes, Wide<double>::Tag(), to);
}
QTRAJ_INLINE void store_interleaved(const Wide<float> (&v)[4], float* to) {
  hn::StoreInterleaved4(v[0].lanes, v[1].lanes, v[2].lanes, v[3].lanes, Wide<float>::Tag(), to);
}
template <class Real>
QTRAJ_INLINE void store_interleaved(const Wide<Real> (&v)[3], Real* to) {
  hn::StoreInterleaved3(v[0].lanes, v[1].lanes, v[2].lanes, typename Wide<Real>::Tag(), to);
}

// Writes `rows` <= kLanes rows; all lanes may be written where there is room.
template <class Real, size_t Size>
QTRAJ_INLINE void write_wide(const Wide<Real> (&v)[Size], Real* to, size_t row, size_t rows, bool room) {
  if (room) return store_interleaved(v, to + Size * row);
  Real lanes[Size * Wide<Real>::kLanes];
  store_interleaved(v, lanes);
  for (size_t k = 0; k < Size * rows; ++k) to[Size * row + k] = lanes[k];
}

// Rates of a segment's parameter to rates in time. Magnitudes past kSafeRate, or what float cannot hold, are left to
// the scalar code, which tells an overflow without making one: those lanes become 0, and `safe` false.
constexpr double kSafeRate = 0x1p300;

template <class Real>
QTRAJ_INLINE Wide<Real> scaled_rate(Wide<Real> rate, const Doubles<Real>& scale, int times, bool& safe) {
  const Wide<double> zero(0.0), limit(kSafeRate), largest(largest_of<Real>());
  Doubles<Real> value = Doubles<Real>::of(rate);
  for (size_t part = 0; part < Doubles<Real>::kParts; ++part) {
    Wide<double>& v = value.part[part];
    const WideMask<double> small = (absolute(v) <= limit) & (scale.part[part] <= limit);
    v = select(small, v, zero);
    const Wide<double> factor = select(small, scale.part[part], zero);
    for (int step = 0; step < times; ++step) v = v * factor;
    const WideMask<double> fits = absolute(v) <= largest;
    v = select(fits, v, zero);
    safe = safe && all(small & fits);
  }
  return value.rounded();
}

// Takes body rates to time and frame; false where a lane must be done again.
template <class Arithmetic, class Real>
QTRAJ_INLINE bool finish_rates(const Wide<Real> (&q)[4], Rates<Wide<Real>>& rates, const Doubles<Real>& scale,
                               const Wanted& wanted, WideRow<Real>& row) {
  if (wanted.frame == Frame::world) {
    rotate_to_world<Arithmetic>(q, rates.omega);
    rotate_to_world<Arithmetic>(q, rates.alpha);
  }
  bool safe = true;
  for (size_t k = 0; k < 3; ++k) {
    if (wanted.omega) row.omega[k] = scaled_rate(rates.omega[k], scale, 1, safe);
    if (wanted.alpha) row.alpha[k] = scaled_rate(rates.alpha[k], scale, 2, safe);
  }
  return safe;
}

// Lanes of int64 that accompany a vector of double.
using IndexTag = hn::RebindToSigned<Wide<double>::Tag>;
using Indices = hn::Vec<IndexTag>;

QTRAJ_INLINE Wide<double> gather(const double* from, Indices at) {
  return Wide<double>::of(hn::GatherIndex(Wide<double>::Tag(), from, at));
}

// Fields first..first + 3 (vectors of two lanes: + 1) of one record for each lane: rows are loaded and transposed,
// which is several times faster than to gather field by field.
constexpr size_t kTransposed = HWY_LANES(double) < 4 ? 2 : 4;

QTRAJ_INLINE void load_transposed(const double* const (&records)[HWY_LANES(double)], size_t first,
                                  Wide<double>* fields) {
  const Wide<double>::Tag tag;
#if HWY_MAX_BYTES == 16
  const auto row0 = hn::LoadU(tag, records[0] + first), row1 = hn::LoadU(tag, records[1] + first);
  fields[0].lanes = hn::InterleaveLower(tag, row0, row1);
  fields[1].lanes = hn::InterleaveUpper(tag, row0, row1);
#else
#if HWY_MAX_BYTES == 32
  const auto row = [&](size_t lane) { return hn::LoadU(tag, records[lane] + first); };
#else
  const hn::Half<Wide<double>::Tag> half;
  const auto row = [&](size_t lane) {
    return hn::Combine(tag, hn::LoadU(half, records[lane + 4] + first), hn::LoadU(half, records[lane] + first));
  };
#endif
  // blocks of two lanes: [f0 of 0, 1][f2 of 0, 1] ...
  const auto row0 = row(0), row1 = row(1), row2 = row(2), row3 = row(3);
  const auto even01 = hn::InterleaveLower(tag, row0, row1), odd01 = hn::InterleaveUpper(tag, row0, row1);
  const auto even23 = hn::InterleaveLower(tag, row2, row3), odd23 = hn::InterleaveUpper(tag, row2, row3);
  fields[0].lanes = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(even23), even01);
  fields[1].lanes = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(odd23), odd01);
  fields[2].lanes = hn::OddEvenBlocks(even23, hn::SwapAdjacentBlocks(even01));
  fields[3].lanes = hn::OddEvenBlocks(odd23, hn::SwapAdjacentBlocks(odd01));
#endif
}

// All fields; the last group may overlap the one before, so that nothing past a record is read.
template <size_t Fields>
QTRAJ_INLINE void load_records(const double* const (&records)[HWY_LANES(double)], Wide<double> (&fields)[Fields]) {
  for (size_t first = 0; first + kTransposed <= Fields; first += kTransposed)
    load_transposed(records, first, fields + first);
  if constexpr (Fields % kTransposed != 0)
    load_transposed(records, Fields - kTransposed, fields + Fields - kTransposed);
}

// Segments of times within the knots, by the guide.
QTRAJ_INLINE Indices find_segments(const KnotIndex& index, Wide<double> time) {
  const IndexTag tag;
  const Wide<double> shifted =
      (time - Wide<double>(index.guide.start)) * Wide<double>(index.guide.scale) + Wide<double>(Guide::kShift);
  const Indices bucket = hn::And(hn::BitCast(tag, shifted.lanes), hn::Set(tag, (int64_t{1} << 52) - 1));
  Indices low = hn::GatherIndex(tag, reinterpret_cast<const int64_t*>(index.guide.first_candidate), bucket);
  const Indices last = hn::Set(tag, static_cast<int64_t>(index.segments - 1));
  for (size_t step = size_t{1} << index.guide.steps; (step >>= 1) > 0;) {
    const Indices middle = hn::Min(hn::Add(low, hn::Set(tag, static_cast<int64_t>(step))), last);
    const Wide<double> knot = gather(index.knots, middle);
    low = hn::IfThenElse(hn::RebindMask(tag, (knot <= time).lanes), middle, low);
  }
  return low;
}

template <class Evaluator, class Arithmetic, class Real, bool kWithRates>
class Batch {
 public:
  Batch(const Evaluator& evaluator, const Trajectory& trajectory, const TimeReader& source, size_t count,
        const SampleOutputs<Real>& outputs)
      : evaluator_(evaluator),
        sampler_(evaluator, trajectory, wanted_of(outputs)),
        wanted_(wanted_of(outputs)),
        index_(knot_index(trajectory)),
        segments_(segments_of<Segment>(trajectory)),
        source_(source),
        count_(count),
        outputs_(outputs) {}

  Outcome sample(size_t& cursor) {
    Outcome outcome = {Status::ok, kNoIndex};
    for (first_row_ = 0; first_row_ < count_; first_row_ += kChunk) {
      const size_t rows = count_ - first_row_ < kChunk ? count_ - first_row_ : kChunk;
      const bool all_inside = read_times(rows);
      again_ = false;
      sample_chunk(rows, cursor);
      if (!all_inside || again_) sample_again(rows, cursor, outcome);
    }
    return outcome;
  }

 private:
  using Segment = typename Evaluator::template SegmentOf<double>;
  using WideSegment = typename Evaluator::template SegmentOf<Wide<Real>>;
  using Number = Wide<Real>;
  using Time = Wide<double>;
  static constexpr size_t kLanes = Number::kLanes, kTimeLanes = Time::kLanes;
  static constexpr size_t kFields = sizeof(Segment) / sizeof(double);

  // ---- Times ----

  // Fills times_: those outside the knots, or not finite, become the first knot. Whether there were none.
  bool read_times(size_t rows) {
    const double* from = source_.source().array;
    if (from)
      from += first_row_;
    else
      generate_times(rows);

    WideMask<double> all_inside = Time(0.0) <= Time(0.0);
    size_t i = 0;
    for (; i + kTimeLanes <= rows; i += kTimeLanes)
      all_inside = all_inside & clamp_times(Time::load(from ? from + i : times_ + i), times_ + i);
    if (i < rows) {
      double rest[kTimeLanes];
      for (size_t k = 0; k < kTimeLanes; ++k)
        rest[k] = i + k >= rows ? index_.knots[0] : from ? from[i + k] : times_[i + k];
      all_inside = all_inside & clamp_times(Time::load(rest), times_ + i);
    }
    for (size_t k = rows; k < rows + kLanes; ++k) times_[k] = times_[rows - 1];
    return all(all_inside);
  }

  void generate_times(size_t rows) {
    if (!source_.is_plain_uniform()) {
      for (size_t i = 0; i < rows; ++i) times_[i] = source_[first_row_ + i];
      return;
    }
    const Time start(source_.source().start), step(source_.source().step);
    const Time first(static_cast<double>(first_row_));
    for (size_t i = 0; i < rows; i += kTimeLanes) {
      const Time row = first + Time::of(hn::Iota(Time::Tag(), static_cast<double>(i)));
      (start + row * step).store(times_ + i);
    }
  }

  // Told by the bits first: a comparison with NaN would raise FE_INVALID.
  QTRAJ_INLINE WideMask<double> clamp_times(Time time, double* to) const {
    const hn::RebindToUnsigned<Time::Tag> bits;
    const auto exponent = hn::Set(bits, 0x7ff0000000000000u);
    const Time first(index_.knots[0]), last(index_.knots[index_.segments]);
    const auto has_full_exponent = hn::Eq(hn::And(hn::BitCast(bits, time.lanes), exponent), exponent);
    const WideMask<double> is_finite = {hn::Not(hn::RebindMask(Time::Tag(), has_full_exponent))};
    const Time finite = select(is_finite, time, first);
    const WideMask<double> inside = is_finite & (first <= finite) & (finite <= last);
    select(inside, finite, first).store(to);
    return inside;
  }

  bool is_sorted(size_t rows) const {
    WideMask<double> sorted = Time(0.0) <= Time(0.0);
    for (size_t i = 0; i < rows; i += kTimeLanes)
      sorted = sorted & (Time::load(times_ + i) <= Time::load(times_ + i + 1));
    return all(sorted);
  }

  // ---- Chunks ----

  void sample_chunk(size_t rows, size_t& cursor) {
    if (is_sorted(rows)) {
      const size_t first = find_segment(index_, times_[0], cursor);
      const size_t last = find_segment(index_, times_[rows - 1], first);
      cursor = last;
      if ((last - first) * kLeastRun * kLanes < rows) return sample_runs(rows, first, last);
    }
    sample_staged(rows);
  }

  void sample_runs(size_t rows, size_t first, size_t last) {
    for (size_t segment = first, begin = 0; segment <= last; ++segment) {
      const size_t end = segment == last ? rows : first_at_or_after(index_.knots[segment + 1], begin, rows);
      if (begin < end) sample_run(segment, begin, end);
      begin = end;
    }
  }

  // First of the sorted times in [begin, end) that is not before a knot.
  size_t first_at_or_after(double knot, size_t begin, size_t end) const {
    while (begin < end) {
      const size_t middle = begin + (end - begin) / 2;
      if (times_[middle] < knot)
        begin = middle + 1;
      else
        end = middle;
    }
    return begin;
  }

  // Rows past the end of the run, up to a vector, are written too and corrected by the next run.
  void sample_run(size_t segment, size_t begin, size_t end) {
    const Segment& record = segments_[segment];
    const auto* fields = reinterpret_cast<const double*>(&record);
    const WideSegment wide =
        read_segment<WideSegment, Number>([&](size_t k) { return Number(static_cast<Real>(fields[k])); });
    const Time knot(index_.knots[segment]), next(index_.knots[segment + 1]);
    const Time scale(Evaluator::scale(record)), offset(Evaluator::offset(record));
    Doubles<Real> scales;
    for (Time& part : scales.part) part = scale;
    for (size_t i = begin; i < end; i += kLanes) {
      Doubles<Real> x;
      for (size_t part = 0; part < Doubles<Real>::kParts; ++part) {
        const Time time = Time::load(times_ + i + part * kTimeLanes);
        // times of the next run would be far outside this segment
        const Time inside = select(time <= next, time, next);
        x.part[part] = parameter<Arithmetic>(inside - knot, scale, offset);
      }
      sample_lanes(wide, x.rounded(), scales, i, end);
    }
  }

  // Segments of all times first: their searches then overlap, as each waits for memory.
  void sample_staged(size_t rows) {
    for (size_t i = 0; i < rows + kLanes - kTimeLanes; i += kTimeLanes)
      hn::StoreU(find_segments(index_, Time::load(times_ + i)), IndexTag(), found_ + i);
    for (size_t i = 0; i < rows; i += kLanes) {
      Time fields[Doubles<Real>::kParts][kFields];
      Doubles<Real> x, scales;
      for (size_t part = 0; part < Doubles<Real>::kParts; ++part) {
        const size_t at = i + part * kTimeLanes;
        const double* records[kTimeLanes];
        for (size_t lane = 0; lane < kTimeLanes; ++lane)
          records[lane] = reinterpret_cast<const double*>(segments_ + found_[at + lane]);
        load_records(records, fields[part]);
        scales.part[part] = fields[part][0];
        const Time offset = Evaluator::kHasOffset ? fields[part][1] : Time(1.0);
        const Time knot = gather(index_.knots, hn::LoadU(IndexTag(), found_ + at));
        x.part[part] = parameter<Arithmetic>(Time::load(times_ + at) - knot, scales.part[part], offset);
      }
      const WideSegment wide = read_segment<WideSegment, Number>([&](size_t k) {
        Doubles<Real> field;
        for (size_t part = 0; part < Doubles<Real>::kParts; ++part) field.part[part] = fields[part][k];
        return field.rounded();
      });
      sample_lanes(wide, x.rounded(), scales, i, rows);
    }
  }

  // One vector of samples, of which those before `end` count.
  QTRAJ_INLINE void sample_lanes(const WideSegment& segment, Number x, const Doubles<Real>& scales, size_t i,
                                 size_t end) {
    const size_t row = first_row_ + i, rows = end - i < kLanes ? end - i : kLanes;
    const bool room = row + kLanes <= count_;
    WideRow<Real> wide;
    evaluator_.sample(segment, x, wide.q);
    if constexpr (kWithRates) {
      Rates<Number> rates;
      evaluator_.sample_rates(segment, x, rates);
      if (!finish_rates<Arithmetic>(wide.q, rates, scales, wanted_, wide)) mark_again(i, rows);
      if (outputs_.omega) write_wide(wide.omega, outputs_.omega, row, rows, room);
      if (outputs_.alpha) write_wide(wide.alpha, outputs_.alpha, row, rows, room);
      if (outputs_.q) write_wide(wide.q, outputs_.q, row, rows, room);
    } else {
      write_wide(wide.q, outputs_.q, row, rows, room);
    }
  }

  // ---- Rows done again ----

  void mark_again(size_t i, size_t rows) {
    if (!again_)
      for (bool& mark : marked_) mark = false;
    again_ = true;
    for (size_t k = i; k < i + rows; ++k) marked_[k] = true;
  }

  void sample_again(size_t rows, size_t& cursor, Outcome& outcome) {
    for (size_t i = 0; i < rows; ++i) {
      const double time = source_[first_row_ + i];
      const bool inside = is_finite(time) && time >= index_.knots[0] && time <= index_.knots[index_.segments];
      if (!inside || (again_ && marked_[i])) sample_row(sampler_, time, first_row_ + i, cursor, outputs_, outcome);
    }
  }

  const Evaluator evaluator_;
  const Sampler<Evaluator, Arithmetic, Real, kWithRates> sampler_;
  const Wanted wanted_;
  const KnotIndex index_;
  const Segment* segments_;
  const TimeReader& source_;
  const size_t count_;
  const SampleOutputs<Real>& outputs_;

  size_t first_row_ = 0;
  bool again_ = false;  // some row of the chunk is marked
  bool marked_[kChunk];
  double times_[kChunk + kLanes + 1];  // of the chunk, clamped
  int64_t found_[kChunk + kLanes];     // segments of the times
};

template <class Arithmetic, class Real>
Outcome sample_batch(const Trajectory& trajectory, const TimeSource& source, size_t count, size_t& cursor,
                     const SampleOutputs<Real>& outputs) {
  if (count < Wide<Real>::kLanes) return sample<Arithmetic>(trajectory, source, count, cursor, outputs);
  return with_evaluator<Arithmetic>(trajectory, [&](const auto& evaluator) {
    using Evaluator = std::decay_t<decltype(evaluator)>;
    if constexpr (std::is_same_v<typename Evaluator::template Working<Real>, Real>) {
      const TimeReader times(source, count);
      if (outputs.omega || outputs.alpha)
        return Batch<Evaluator, Arithmetic, Real, true>(evaluator, trajectory, times, count, outputs).sample(cursor);
      return Batch<Evaluator, Arithmetic, Real, false>(evaluator, trajectory, times, count, outputs).sample(cursor);
    } else {
      return sample<Arithmetic>(trajectory, source, count, cursor, outputs);
    }
  });
}

}  // namespace
}  // namespace qtraj

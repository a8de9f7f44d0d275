#include "functions/timed_pairs.hpp"

#include "base/times.hpp"
#include "functions/pairs.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

constexpr RowKernel<PairRows> kSlerpKernels[] = QTRAJ_OF_EACH_TARGET(slerp);
constexpr RowKernel<PairRows> kNlerpKernels[] = QTRAJ_OF_EACH_TARGET(nlerp);
constexpr RowKernel<FractionRows> kFractionKernels[] = QTRAJ_OF_EACH_TARGET(fractions);

double time_at(const Input<1>& times, size_t row) {
  return static_cast<const double*>(times.data)[first_element(times, row)];
}

// The interval between the ends of a row.
struct Interval {
  Status status;  // not_finite, time_order, time_span or ok
  double time_a, half_step;
};
Interval interval_of(const TimedPairRows& pairs, size_t row) {
  const double time_a = time_at(pairs.time_a, row), time_b = time_at(pairs.time_b, row);
  if (!is_finite(time_a) || !is_finite(time_b)) return {Status::not_finite, 0, 1};
  return {check_time(time_a, time_a, time_b), time_a, 0.5 * time_b - 0.5 * time_a};
}

// The fraction of any finite time in an interval that is ok.
double fraction_at(double time, const Interval& interval) {
  // halved first, so that the differences cannot overflow; past 4 s neither can the quotient
  constexpr double kFarthest = 0x1p1022;
  const double elapsed = 0.5 * time - 0.5 * interval.time_a, step = interval.half_step;
  if (step < 4 && std::abs(elapsed) > step * kFarthest) return elapsed > 0 ? kFarthest : -kFarthest;
  return elapsed / step;
}

// The fractions of rows; an interval that serves all is looked at once.
class Fractions {
 public:
  explicit Fractions(const TimedPairRows& pairs)
      : pairs_(pairs),
        is_one_(pairs.time_a.rows == 1 && pairs.time_b.rows == 1),
        one_(is_one_ ? interval_of(pairs, 0) : Interval()) {}

  Status read(size_t row, double& fraction) const {
    const double time = time_at(pairs_.times, row);
    if (!is_finite(time)) return Status::not_finite;
    const Interval interval = is_one_ ? one_ : interval_of(pairs_, row);
    if (interval.status == Status::ok) fraction = fraction_at(time, interval);
    return interval.status;
  }

 private:
  const TimedPairRows& pairs_;
  const bool is_one_;
  const Interval one_;
};

bool is_one_pair(const TimedPairRows& pairs) { return pairs.a.rows == 1 && pairs.b.rows == 1; }

// ---- Kernels ----

constexpr size_t kChunk = 32;

// Rows of quaternions for a kernel of double: where they are, or converted.
class DoubleRows {
 public:
  Input<4> from(const Input<4>& array, size_t first, size_t rows) {
    const size_t own_rows = array.rows == 1 ? 1 : rows;
    if (!array.is_float) return {static_cast<const double*>(array.data) + first_element(array, first), own_rows, false};
    for (size_t row = 0; row < own_rows; ++row) store(row_of(array, first + row), converted_[row]);
    return {converted_, own_rows, false};
  }

 private:
  double converted_[kChunk][4];
};

// The kernel of timed pairs: that of pairs, in chunks of rows whose fractions are between 0 and 1.
class BetweenEnds {
 public:
  BetweenEnds(RowKernel<PairRows> kernel, const TimedPairRows& pairs, const Fractions& fractions, size_t count)
      : kernel_(kernel), pairs_(pairs), given_(fractions), count_(count) {}

  // Does rows from `first` on and returns how many.
  size_t operator()(size_t first) {
    size_t row = first;
    while (can_blend_) {
      if (row >= end_) read_fractions(row);
      const size_t rows = end_ - row;
      if (rows == 0) break;
      const size_t done = blend(row, rows);
      // a single pair that the kernel leaves to the core will be left again
      can_blend_ = done > 0 || !is_one_pair(pairs_);
      row += done;
      if (done < rows) break;
    }
    return row - first;
  }

 private:
  // Reads fractions from `row` on, up to one that is not between 0 and 1.
  void read_fractions(size_t row) {
    const size_t rows = std::min(kChunk, count_ - row);
    const FractionRows chunk = {chunk_of(pairs_.times, row, rows), chunk_of(pairs_.time_a, row, rows),
                                chunk_of(pairs_.time_b, row, rows), fractions_};
    begin_ = row;
    end_ = row + kFractionKernels[target()](chunk, 0, rows);
    for (; end_ < row + rows; ++end_) {
      double& fraction = fractions_[end_ - begin_];
      if (given_.read(end_, fraction) != Status::ok || !(fraction > 0 && fraction < 1)) break;
    }
  }

  size_t blend(size_t first, size_t most) {
    const size_t rows = std::min(convertible(pairs_.a, first, most), convertible(pairs_.b, first, most));
    if (rows == 0) return 0;
    DoubleRows a, b;
    double rounded[kChunk][4];
    double* const q = pairs_.q.is_float ? rounded[0] : static_cast<double*>(pairs_.q.data) + 4 * first;
    const PairRows chunk = {a.from(pairs_.a, first, rows), b.from(pairs_.b, first, rows),
                            input<1>(fractions_ + (first - begin_), rows), pairs_.path, output<4>(q, rows)};
    const size_t done = kernel_(chunk, 0, rows);
    for (size_t row = 0; pairs_.q.is_float && row < done; ++row) write_row(pairs_.q, first + row, load(rounded[row]));
    return done;
  }

  // Rows up to the first that cannot be converted: a signalling NaN of float would raise FE_INVALID.
  static size_t convertible(const Input<4>& array, size_t first, size_t most) {
    size_t rows = 0;
    while (rows < most && (!array.is_float || is_finite(array, first + rows))) ++rows;
    return rows;
  }

  const RowKernel<PairRows> kernel_;
  const TimedPairRows& pairs_;
  const Fractions& given_;
  const size_t count_;
  double fractions_[kChunk];
  size_t begin_ = 0, end_ = 0;  // rows whose fractions these are
  bool can_blend_ = true;
};

// ---- All rows ----

// The kernel does rows, and those that it leaves are sampled on the Curve through their pair.
template <class Curve>
Outcome sample_between(RowKernel<PairRows> kernel, const TimedPairRows& pairs, size_t count) {
  Status pair_status = Status::ok;
  Curve curve;
  bool has_curve = false;
  const Fractions fractions(pairs);
  BetweenEnds between(kernel, pairs, fractions, count);
  return for_each_row(
      count, pairs.q, [&](size_t row) { return between(row); },
      [&](size_t row, Quaternion& q) {
        if (!has_curve || !is_one_pair(pairs)) {
          Pair pair;
          pair_status = read_pair(pairs.a, pairs.b, row, pairs.path, pair);
          if (pair_status == Status::ok) curve = Curve(pair);
          has_curve = true;
        }
        double fraction = 0;
        const Status time_status = fractions.read(row, fraction);
        if (time_status == Status::not_finite) return time_status;
        if (pair_status != Status::ok) return pair_status;
        return time_status == Status::ok ? curve.at(fraction, q) : time_status;
      });
}

}  // namespace

Outcome slerp_between(const TimedPairRows& pairs, size_t count) {
  return sample_between<Slerp>(kSlerpKernels[target()], pairs, count);
}

Outcome nlerp_between(const TimedPairRows& pairs, size_t count) {
  return sample_between<Nlerp>(kNlerpKernels[target()], pairs, count);
}

}  // namespace qtraj

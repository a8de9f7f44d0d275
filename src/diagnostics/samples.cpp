#include "diagnostics/samples.hpp"

#include "base/times.hpp"
#include "functions/algebra.hpp"
#include "functions/keys.hpp"
#include "math/error_free.hpp"
#include "math/so3.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

void record(Outcome& first, Status status, size_t index) {
  if (status != Status::ok && first.status == Status::ok) first = {status, index};
}

// Checks samples one after another.
class SampleCheck {
 public:
  explicit SampleCheck(const Samples& samples) : samples_(samples) {}

  Status next() {
    const Status time_status = check_next_time(samples_.time(index_));
    const Status key_status = check_key(samples_.q_wb, index_);
    ++index_;
    times_increase_ = times_increase_ && time_status == Status::ok;
    return time_status == Status::not_finite || key_status == Status::ok ? time_status : key_status;
  }

  // Whether the span to a time of ordinary size cannot overflow.
  bool has_common_start() const { return has_time_ && std::abs(first_time_) < 0x1p1000; }

  // Passes over samples that are known to be without a fault.
  void pass(size_t count) {
    if (count == 0) return;
    index_ += count;
    last_time_ = samples_.time(index_ - 1);
  }

  // Whether no time so far is at fault.
  bool times_increase() const { return times_increase_; }

 private:
  Status check_next_time(const double& time) {
    if (!is_finite(time)) return Status::not_finite;
    const Status status = has_time_ ? check_time(first_time_, last_time_, time) : Status::ok;
    if (!has_time_) first_time_ = time;
    last_time_ = time;
    has_time_ = true;
    return status;
  }

  const Samples& samples_;
  size_t index_ = 0;
  bool times_increase_ = true, has_time_ = false;
  double first_time_ = 0, last_time_ = 0;  // of the finite ones
};

struct SamplesVerdict {
  Outcome first_fault;
  bool times_increase;
};
SamplesVerdict check_samples(const Samples& samples) {
  SampleCheck check(samples);
  Outcome first_fault;
  for (size_t k = 0; k < samples.count(); ++k) record(first_fault, check.next(), k);
  return {first_fault, check.times_increase()};
}

UnitQuaternion conjugate(const UnitQuaternion& q) { return {qtraj::conjugate(q.value), qtraj::conjugate(q.error)}; }

double step(const Samples& samples, size_t k) { return samples.time(k + 1) - samples.time(k); }

// The mean rate from sample k to sample k + 1, neither of them at fault. ok or ambiguous.
Status interval_rate(const Samples& samples, size_t k, Frame frame, Vector3& rate) {
  const Quaternion from = row_of(samples.q_wb, k);
  Quaternion to = row_of(samples.q_wb, k + 1);
  if (is_opposed(from, to)) to = -to;
  const UnitQuaternion a = normalize(from).unit, b = normalize(to).unit;
  // b a* is a* b with the conjugates of b and a in the places of a and b
  const Vector3 half_angles = frame == Frame::world ? relative_log(conjugate(b), conjugate(a)) : relative_log(a, b);
  rate = 2.0 * half_angles / step(samples, k);
  return std::abs(dot(a.value, b.value)) <= kHalfTurnCosine ? Status::ambiguous : Status::ok;
}

const double* times_of(const Samples& samples) { return static_cast<const double*>(samples.times.data); }

// Number of samples before `time`, and of those not after it; all times in order.
size_t samples_before(const Samples& samples, double time) {
  return static_cast<size_t>(std::lower_bound(times_of(samples), times_of(samples) + samples.count(), time) -
                             times_of(samples));
}
size_t samples_until(const Samples& samples, double time) {
  return static_cast<size_t>(std::upper_bound(times_of(samples), times_of(samples) + samples.count(), time) -
                             times_of(samples));
}

// Whether time - earlier <= later - time, without rounding; earlier <= time <= later.
bool is_nearer_to_earlier(double time, double earlier, double later) {
  const DoubleDouble after = two_sum(time, -earlier), before = two_sum(later, -time);
  return after.value != before.value ? after.value < before.value : after.error <= before.error;
}

// Rate after minus rate before a finite time; not_finite or zero_norm where a sample it needs is.
Status jump_at(const Samples& samples, double time, Frame frame, Vector3& jump) {
  const size_t after = samples_before(samples, time), until = samples_until(samples, time);
  if (after + 1 >= samples.count() || until < 2) return Status::time_range;
  const size_t before = until - 2;
  for (const size_t sample : {before, before + 1, after, after + 1}) {
    const Status status = check_key(samples.q_wb, sample);
    if (status != Status::ok) return status;
  }
  Vector3 rate_before, rate_after;
  const Status status_before = interval_rate(samples, before, frame, rate_before);
  const Status status_after = interval_rate(samples, after, frame, rate_after);
  jump = rate_after - rate_before;
  return status_before != Status::ok ? status_before : status_after;
}

constexpr RowKernel<MeanRateRows> kMeanRateKernels[] = QTRAJ_OF_EACH_TARGET(mean_rates);

// The samples nearest to times, looked for from the last one found on: times in order find theirs in a step or two.
class NearestSample {
 public:
  explicit NearestSample(const Samples& samples) : samples_(samples) {}

  // The index of that to a finite time.
  size_t operator()(double time) {
    later_ = samples_before(time);
    if (later_ == 0) return 0;
    if (later_ == samples_.count()) return later_ - 1;
    return is_nearer_to_earlier(time, samples_.time(later_ - 1), samples_.time(later_)) ? later_ - 1 : later_;
  }

 private:
  size_t samples_before(double time) const {
    const bool goes_on = later_ > 0 && samples_.time(later_ - 1) < time;
    size_t begin = goes_on ? later_ : 0, end = begin;
    for (size_t stride = 1; end < samples_.count() && samples_.time(end) < time; stride *= 2) {
      begin = end + 1;
      end += stride;
    }
    const double* const times = times_of(samples_);
    return static_cast<size_t>(std::lower_bound(times + begin, times + std::min(end, samples_.count()), time) - times);
  }

  const Samples& samples_;
  size_t later_ = 0;
};

// Angles between pairs, written to the rows that they belong to. They are collected, as many at a time as pay.
class PairAngles {
 public:
  explicit PairAngles(const Output<1>& angles) : angles_(angles) {}

  void add(const Quaternion& a, const Quaternion& b, size_t row) {
    store(a, a_[count_]);
    store(b, b_[count_]);
    rows_[count_++] = row;
    if (count_ == kMost) write();
  }
  void write() {
    double angle[kMost];
    rotation_angle({input<4>(a_[0], count_), input<4>(b_[0], count_), output<1>(angle, count_)}, count_);
    for (size_t k = 0; k < count_; ++k) write_row(angles_, rows_[k], Row<1>(angle[k]));
    count_ = 0;
  }

 private:
  static constexpr size_t kMost = 32;
  const Output<1>& angles_;
  double a_[kMost][4], b_[kMost][4];
  size_t rows_[kMost], count_ = 0;
};

}  // namespace

Outcome estimate_omega(const Samples& samples, Frame frame, const Output<1>& t_mid, const Output<3>& omega) {
  const MeanRateRows rows = {frame, samples.times, samples.q_wb, t_mid, omega};
  const auto kernel = kMeanRateKernels[target()];
  SampleCheck check(samples);
  Outcome first_fault;
  bool usable_before = false;
  for (size_t k = 0; k < samples.count(); ++k) {
    if (usable_before && check.has_common_start()) {
      const size_t done = kernel(rows, k - 1, samples.count() - 1);
      check.pass(done);
      k += done;
      if (k == samples.count()) break;
    }
    Status status = check.next();
    const bool usable = status == Status::ok;
    if (k > 0 && usable && usable_before) {
      Vector3 rate;
      status = interval_rate(samples, k - 1, frame, rate);
      write_row(omega, k - 1, rate);
      // halved first: the sum of two times may overflow
      if (t_mid.data) write_row(t_mid, k - 1, Row<1>(0.5 * samples.time(k - 1) + 0.5 * samples.time(k)));
    } else if (k > 0) {
      write_nan(omega, k - 1);
      if (t_mid.data) write_nan(t_mid, k - 1);
    }
    record(first_fault, status, k);
    usable_before = usable;
  }
  return first_fault;
}

Outcome estimate_energy(const Samples& samples, Frame frame, double& energy) {
  energy = std::numeric_limits<double>::quiet_NaN();
  constexpr double kLargest = 1e300, kLargestRoot = 1e150;
  SampleCheck check(samples);
  Outcome first_ambiguous;
  Vector3 rate_before;
  DoubleDouble sum = {0, 0};
  for (size_t k = 0; k < samples.count(); ++k) {
    const Status status = check.next();
    if (status != Status::ok) return {status, k};
    if (k == 0) continue;
    Vector3 rate;
    record(first_ambiguous, interval_rate(samples, k - 1, frame, rate), k);
    if (k > 1) {
      const double between = 0.5 * step(samples, k - 2) + 0.5 * step(samples, k - 1);
      // the root is taken first: squares of rates may overflow
      const Vector3 root = (rate - rate_before) / std::sqrt(between);
      if (largest_component(root) > kLargestRoot) return {Status::not_finite, k};
      const DoubleDouble total = two_sum(sum.value, dot(root, root));
      sum = {total.value, sum.error + total.error};
      if (sum.value > kLargest) return {Status::not_finite, k};
    }
    rate_before = rate;
  }
  energy = sum.value + sum.error;
  return first_ambiguous;
}

Outcome estimate_jumps(const Samples& samples, const double* knots, size_t knot_count, Frame frame,
                       const Output<3>& jumps) {
  const SamplesVerdict verdict = check_samples(samples);
  const Outcome rows = for_each_row(knot_count, jumps, [&](size_t k, Vector3& jump) {
    if (!is_finite(knots[k])) return Status::not_finite;
    return verdict.times_increase ? jump_at(samples, knots[k], frame, jump) : verdict.first_fault.status;
  });
  // rows that are NaN because of a sample have that sample's outcome
  if (verdict.first_fault.status != Status::ok || rows.status == Status::ok) return verdict.first_fault;
  return {rows.status, samples.count() + rows.index};
}

Outcome keyframe_errors(const Samples& keys, const Samples& samples, const Output<1>& error, size_t* index) {
  const SamplesVerdict verdict = check_samples(samples);
  NearestSample nearest_to(samples);
  PairAngles angles(error);
  Outcome first_fault;
  for (size_t k = 0; k < keys.count(); ++k) {
    const Status status = is_finite(keys.time(k)) ? check_key(keys.q_wb, k) : Status::not_finite;
    record(first_fault, status, k);
    size_t nearest = kNoIndex;
    if (status == Status::ok && verdict.times_increase) nearest = nearest_to(keys.time(k));
    const bool usable = nearest != kNoIndex && check_key(samples.q_wb, nearest) == Status::ok;
    if (index) index[k] = usable ? nearest : kNoIndex;
    if (usable)
      angles.add(row_of(keys.q_wb, k), row_of(samples.q_wb, nearest), k);
    else
      write_nan(error, k);
  }
  angles.write();
  if (verdict.first_fault.status != Status::ok)
    record(first_fault, verdict.first_fault.status, keys.count() + verdict.first_fault.index);
  return first_fault;
}

}  // namespace qtraj

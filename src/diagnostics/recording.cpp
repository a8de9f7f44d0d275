#include "diagnostics/recording.hpp"

#include <functional>

#include "base/times.hpp"
#include "functions/algebra.hpp"
#include "functions/keys.hpp"

namespace qtraj {
namespace {

Status check_alone(const Samples& keys, size_t key) {
  return is_finite(keys.time(key)) ? check_key(keys.q_wb, key) : Status::not_finite;
}

// Whether constructors take a key at `time` right after one at `earlier`, the span of the two aside.
bool can_follow(double earlier, double time) { return check_time(earlier, earlier, time) != Status::time_order; }

// The number of keys of the longest series that can follow a key at `time`, of `longest` lengths.
size_t longest_after(const double* latest, size_t longest, double time) {
  // doubled steps back from the longest, then halved ones
  size_t fits = longest, step = 1;
  while (fits > 0 && !can_follow(time, latest[fits - 1])) {
    fits -= std::min(fits, step);
    step *= 2;
  }
  size_t past = std::min(longest, fits + step / 2);
  while (past - fits > 0) {
    const size_t middle = past - (past - fits) / 2;
    if (can_follow(time, latest[middle - 1]))
      fits = middle;
    else
      past = middle - 1;
  }
  return fits;
}

// Fills memory.chain, 0 for keys that are at fault alone, and returns the length of the longest series.
size_t measure_chains(const Samples& keys, const ChainMemory& memory) {
  size_t longest = 0;
  for (size_t key = keys.count(); key-- > 0;) {
    memory.chain[key] = 0;
    const double time = keys.time(key);
    if (check_alone(keys, key) != Status::ok) continue;
    const size_t after = longest_after(memory.latest, longest, time);
    memory.chain[key] = after + 1;
    memory.latest[after] = after == longest ? time : std::max(memory.latest[after], time);
    longest = std::max(longest, after + 1);
  }
  return longest;
}

// Judges the times of the keys that are good alone, one after another.
class TimeJudge {
 public:
  TimeJudge(const Samples& keys, const ChainMemory& memory)
      : chain_(memory.chain), left_(memory.chain ? measure_chains(keys, memory) : 0) {}

  Status judge(size_t key, double time) {
    const bool follows = !has_previous_ || can_follow(previous_, time);
    if (!follows || (chain_ && chain_[key] != left_)) return Status::time_order;
    if (!has_previous_) first_ = time;
    const Status status = has_previous_ ? check_time(first_, previous_, time) : Status::ok;
    previous_ = time;
    has_previous_ = true;
    --left_;
    return status;
  }

 private:
  const size_t* chain_;
  size_t left_;  // keys of the series from here on
  double first_ = 0, previous_ = 0;
  bool has_previous_ = false;
};

// A value that is replaced by any that is `Better`, and the key that it is of.
template <class Better>
void keep(double value, size_t key, double& best, uint64_t& best_key) {
  if (best_key != UINT64_MAX && !Better()(value, best)) return;
  best = value;
  best_key = key;
}

// Gathers the report from all keys with a direction, and from the good ones.
class Reporter {
 public:
  Reporter(const Samples& keys, qtraj_key_report& report) : keys_(keys), report_(report) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    report = {0,          0,     UINT64_MAX, kNone, UINT64_MAX, kNone,
              UINT64_MAX, kNone, UINT64_MAX, kNone, UINT64_MAX, {0, 0, 0, 0, 0}};
  }

  void add_norm(size_t key) {
    const double error = std::abs(normalize(row_of(keys_.q_wb, key)).norm - 1.0);
    keep<std::greater<double>>(error, key, report_.worst_norm_error, report_.worst_norm_index);
  }

  void add_good(size_t key) {
    const Quaternion q = row_of(keys_.q_wb, key);
    const double time = keys_.time(key);
    if (has_previous_) {
      if (is_opposed(previous_q_, q)) add_sign_change(key);
      keep<std::greater<double>>(rotation_angle(previous_q_, q), key, report_.largest_angle,
                                 report_.largest_angle_index);
      const double interval = time - previous_time_;
      keep<std::greater<double>>(interval, key, report_.longest_interval, report_.longest_interval_index);
      keep<std::less<double>>(interval, key, report_.shortest_interval, report_.shortest_interval_index);
    }
    previous_q_ = q;
    previous_time_ = time;
    has_previous_ = true;
  }

 private:
  void add_sign_change(size_t key) {
    if (report_.sign_changes++ == 0) report_.first_sign_change = key;
  }

  const Samples& keys_;
  qtraj_key_report& report_;
  Quaternion previous_q_;
  double previous_time_ = 0;
  bool has_previous_ = false;
};

}  // namespace

bool times_are_in_order(const Samples& keys) {
  bool has_previous = false;
  double previous = 0;
  for (size_t key = 0; key < keys.count(); ++key) {
    if (check_alone(keys, key) != Status::ok) continue;
    const double time = keys.time(key);
    if (has_previous && !can_follow(previous, time)) return false;
    previous = time;
    has_previous = true;
  }
  return true;
}

Outcome check_keys(const Samples& keys, const ChainMemory& memory, int32_t* statuses, qtraj_key_report& report) {
  Outcome outcome;
  TimeJudge times(keys, memory);
  Reporter reporter(keys, report);
  for (size_t key = 0; key < keys.count(); ++key) {
    Status status = check_alone(keys, key);
    if (check_key(keys.q_wb, key) == Status::ok) reporter.add_norm(key);
    if (status == Status::ok) status = times.judge(key, keys.time(key));
    if (status == Status::ok) reporter.add_good(key);
    if (statuses) statuses[key] = static_cast<int32_t>(status);
    if (status == Status::ok) continue;
    if (report.faults++ == 0) outcome = {status, key};
  }
  return outcome;
}

}  // namespace qtraj

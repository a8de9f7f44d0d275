// The arguments of a call that samples many trajectories at shared times, and its rows one after the other.
#pragma once

#include "curve/sample_call.hpp"

namespace qtraj {

// Row i of the outputs is that of one trajectory at one time: of the first trajectory at all times and so on, or of all
// trajectories at the first time and so on.
struct SeriesCall {
  const qtraj_trajectory* const* trajectories;  // [series]
  size_t series;
  const double* times;  // [count]
  size_t count;
  Layout layout;

  // The handle of a trajectory begins with it.
  const Trajectory& trajectory(size_t k) const { return *reinterpret_cast<const Trajectory*>(trajectories[k]); }
};

// Samples all rows. Every one is written, those at fault with NaN; the outcome is that of the first row at fault.
template <class Real>
using SeriesFunction = Outcome(const SeriesCall& call, const SampleOutputs<Real>& outputs);

namespace {

// Goes through the rows of a call, of which there is at least one, in stretches of neighbours: of different
// trajectories at one time, or of one trajectory at different times.
class SeriesWalk {
 public:
  explicit SeriesWalk(const SeriesCall& call)
      : call_(call),
        is_across_(call.layout == Layout::time_first || call.count == 1),
        left_(call.series * call.count) {}

  size_t left() const { return left_; }
  size_t row() const { return call_.series * call_.count - left_; }
  // Rows of the present stretch from the present one on.
  size_t stretch() const { return (is_across_ ? call_.series : call_.count) - inner_; }
  // Row i of these.
  const Trajectory& trajectory(size_t i = 0) const { return call_.trajectory(is_across_ ? inner_ + i : outer_); }
  double time(size_t i = 0) const { return read_once(call_.times[is_across_ ? outer_ : inner_ + i]); }

  // Goes on by `rows` rows, at most to the end of the stretch.
  void step(size_t rows = 1) {
    left_ -= rows;
    inner_ += rows;
    if (inner_ < (is_across_ ? call_.series : call_.count)) return;
    inner_ = 0;
    ++outer_;
  }

 private:
  const SeriesCall& call_;
  bool is_across_;
  size_t left_, inner_ = 0, outer_ = 0;
};

}  // namespace
}  // namespace qtraj

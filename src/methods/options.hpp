// A method and its settings. Every setter checks its arguments and fails without effect, so that a valid object stays
// valid.
#pragma once

#include <limits>

#include "base/settings.hpp"
#include "base/status.hpp"
#include "math/quaternion.hpp"

namespace qtraj {

// What happens at one end of the keys.
struct EndSetting {
  End condition = End::standard;
  bool has_rate = false;
  Vector3 omega = Vector3::Zero();  // in rate_frame, where has_rate
  Extrapolate extrapolate = Extrapolate::error;
};

struct Options {
  Method method = {};
  EndSetting start, end;
  Frame rate_frame = Frame::body;
  Tangent tangents = Tangent::catmull_rom;
  Reference reference = Reference::first;
  Quaternion reference_q = Quaternion::Zero();  // where reference is given
  Turns turns = Turns::shortest;                // never standard
  double period = 0;                            // s; 0: no key is added
  double closure = 1e-6;  // rad, by which the last key of a closed curve may differ from the first
  double longest_gap = std::numeric_limits<double>::infinity();  // s

  // value where the method is unknown.
  static Status make(Method method, Options& out);

  Status set_ends(End start_condition, End end_condition);
  // nullptr for an end that is not given, [3] for one that is.
  Status set_end_rates(Frame frame, const double* omega_start, const double* omega_end);
  Status set_tangents(Tangent rule);
  Status set_reference(Reference rule, const double* q_wb);
  Status set_extrapolation(Extrapolate before, Extrapolate after);
  Status set_turns(Turns rule);
  Status set_period(double seconds);  // 0: none
  Status set_closure(double angle);
  Status set_longest_gap(double seconds);  // 0: none

  // Keys of a curve through `count` keys of the caller.
  size_t key_count(size_t count) const { return count + (period > 0 ? 1 : 0); }
  bool closed() const { return start.condition == End::periodic; }
  bool wraps() const { return start.extrapolate == Extrapolate::periodic; }
};

}  // namespace qtraj

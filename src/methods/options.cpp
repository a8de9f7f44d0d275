#include "methods/options.hpp"

#include "base/floating.hpp"
#include "math/trigonometry.hpp"
#include "methods/method.hpp"

namespace qtraj {
namespace {

template <class Vector>
bool load_finite(const double* from, Vector& to) {
  for (int k = 0; k < Vector::RowsAtCompileTime; ++k) {
    if (!is_finite(from[k])) return false;
    to[k] = from[k];
  }
  return true;
}

// Whether `omega` is there where the end needs it and only there.
Status check_end_rate(const EndSetting& end, const double* omega) {
  if (end.condition == End::given && !omega) return Status::input_missing;
  if (end.condition != End::given && omega) return Status::input_unwanted;
  return Status::ok;
}

void set_end(EndSetting& end, End condition) {
  end.condition = condition;
  if (condition != End::given) end.has_rate = false;
}

}  // namespace

Status Options::make(Method method, Options& out) {
  if (!find_method(method) && !find_vector_method(method)) return Status::value;
  out = Options{};
  out.method = method;
  out.turns = default_turns(method);
  return Status::ok;
}

Status Options::set_ends(End start_condition, End end_condition) {
  const bool one_closed = (start_condition == End::periodic) != (end_condition == End::periodic);
  if (!is_known(start_condition) || !is_known(end_condition) || one_closed) return Status::value;
  if (!accepts_end(method, start_condition) || !accepts_end(method, end_condition)) return Status::setting;
  set_end(start, start_condition);
  set_end(end, end_condition);
  return Status::ok;
}

Status Options::set_end_rates(Frame frame, const double* omega_start, const double* omega_end) {
  if (!is_known(frame)) return Status::value;
  if (find_vector_method(method) || !accepts_end(method, End::given)) return Status::setting;
  const Status at_start = check_end_rate(start, omega_start), at_end = check_end_rate(end, omega_end);
  const bool one_missing = at_start == Status::input_missing || at_end == Status::input_missing;
  if (one_missing) return Status::input_missing;
  if (at_start != Status::ok || at_end != Status::ok) return Status::input_unwanted;

  Vector3 start_rate = start.omega, end_rate = end.omega;
  if (omega_start && !load_finite(omega_start, start_rate)) return Status::not_finite;
  if (omega_end && !load_finite(omega_end, end_rate)) return Status::not_finite;
  rate_frame = frame;
  start.omega = start_rate;
  end.omega = end_rate;
  start.has_rate = omega_start != nullptr;
  end.has_rate = omega_end != nullptr;
  return Status::ok;
}

Status Options::set_tangents(Tangent rule) {
  if (!is_known(rule)) return Status::value;
  if (!has_tangents(method)) return Status::setting;
  tangents = rule == Tangent::standard ? Tangent::catmull_rom : rule;
  return Status::ok;
}

Status Options::set_reference(Reference rule, const double* q_wb) {
  if (!is_known(rule) || (rule != Reference::given && q_wb)) return Status::value;
  if (!has_reference(method)) return Status::setting;
  if (rule == Reference::given) {
    Quaternion q;
    if (!load_finite(q_wb, q)) return Status::not_finite;
    if (largest_component(q) == 0) return Status::zero_norm;
    reference_q = q;
  }
  reference = rule == Reference::standard ? Reference::first : rule;
  return Status::ok;
}

Status Options::set_extrapolation(Extrapolate before, Extrapolate after) {
  const bool one_wraps = (before == Extrapolate::periodic) != (after == Extrapolate::periodic);
  if (!is_known(before) || !is_known(after) || one_wraps) return Status::value;
  start.extrapolate = before == Extrapolate::standard ? Extrapolate::error : before;
  end.extrapolate = after == Extrapolate::standard ? Extrapolate::error : after;
  return Status::ok;
}

Status Options::set_turns(Turns rule) {
  if (!is_known(rule)) return Status::value;
  if (!accepts_turns(method, rule)) return Status::setting;
  turns = rule == Turns::standard ? default_turns(method) : rule;
  return Status::ok;
}

Status Options::set_period(double seconds) {
  if (!is_finite(seconds) || seconds < 0) return Status::value;
  period = seconds;
  return Status::ok;
}

Status Options::set_closure(double angle) {
  if (!is_finite(angle) || angle < 0 || angle > kPi) return Status::value;
  closure = angle;
  return Status::ok;
}

Status Options::set_longest_gap(double seconds) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!is_finite(seconds) && seconds != kInfinity) return Status::value;
  if (seconds < 0) return Status::value;
  longest_gap = seconds > 0 ? seconds : kInfinity;
  return Status::ok;
}

}  // namespace qtraj

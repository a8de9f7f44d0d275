#include <cstring>
#include <limits>

#include "arguments.hpp"

using namespace qtraj;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

extern "C" {

int32_t qtraj_method(const qtraj_trajectory* trajectory) {
  return trajectory ? static_cast<int32_t>(trajectory->core.method) : 0;
}

size_t qtraj_key_count(const qtraj_trajectory* trajectory) { return trajectory ? trajectory->core.key_count : 0; }

double qtraj_start_time(const qtraj_trajectory* trajectory) { return trajectory ? trajectory->core.before.knot : kNaN; }

double qtraj_end_time(const qtraj_trajectory* trajectory) { return trajectory ? trajectory->core.after.knot : kNaN; }

size_t qtraj_sign_flips(const qtraj_trajectory* trajectory) { return trajectory ? trajectory->core.sign_flips : 0; }

double qtraj_worst_norm_error(const qtraj_trajectory* trajectory) {
  return trajectory ? trajectory->core.worst_norm_error : kNaN;
}

double qtraj_least_dot(const qtraj_trajectory* trajectory) { return trajectory ? trajectory->core.least_dot : kNaN; }

int32_t qtraj_iterations(const qtraj_trajectory* trajectory) { return trajectory ? trajectory->core.iterations : 0; }

double qtraj_residual(const qtraj_trajectory* trajectory) { return trajectory ? trajectory->core.residual : kNaN; }

qtraj_status qtraj_keys(const qtraj_trajectory* trajectory, double* times_out, double* q_out) {
  if (!trajectory) return QTRAJ_E_NULL;
  const size_t time_bytes = trajectory->core.key_count * sizeof(double), q_bytes = 4 * time_bytes;
  if (capi::overlap({times_out, time_bytes}, {q_out, q_bytes})) return QTRAJ_E_OVERLAP;
  if (times_out) std::memcpy(times_out, knots_of(trajectory->core), time_bytes);
  if (q_out) std::memcpy(q_out, keys_of(trajectory->core), q_bytes);
  return QTRAJ_OK;
}

}  // extern "C"

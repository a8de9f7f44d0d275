// Every method without rates of its own, q alone and with rates. The peer, SciPy, is in scipy_peers.py.
#include "support.hpp"

namespace bench {
namespace {

struct Named {
  const char* name;
  int32_t method;
};

void sample_rates(const qtraj_trajectory* trajectory, const std::vector<double>& times, bool alpha, double* out) {
  const size_t count = times.size();
  must_be_ok(qtraj_sample_rates(trajectory, QTRAJ_FRAME_BODY, times.data(), count, out, out + 4 * count,
                                alpha ? out + 7 * count : nullptr, nullptr));
}
void sample_rates(const qtraj_trajectory* trajectory, const std::vector<double>& times, bool alpha, float* out) {
  const size_t count = times.size();
  must_be_ok(qtraj_sample_rates_f32(trajectory, QTRAJ_FRAME_BODY, times.data(), count, out, out + 4 * count,
                                    alpha ? out + 7 * count : nullptr, nullptr));
}

template <class Real>
void add_rates(const Named& named, const char* suffix, bool alpha) {
  const Case sampled = {with_type<Real>((std::string(named.name) + suffix).c_str()), 1000, 1000000};
  const auto prepare = [=] {
    const qtraj_trajectory* const trajectory = trajectory_of(named.method, sampled.keys);
    const std::vector<double>& times = times_of(sampled);
    return [=, &times](Real* out) { sample_rates(trajectory, times, alpha, out); };
  };
  add<Real>(sampled, "ours", prepare, alpha ? 10 : 7);
}

template <class Real>
void add_type() {
  const Named all[] = {{"nlerp", QTRAJ_NLERP},
                       {"log_spline", QTRAJ_LOG_SPLINE},
                       {"rotation_spline", QTRAJ_ROTATION_SPLINE},
                       {"slerp", QTRAJ_SLERP},
                       {"squad", QTRAJ_SQUAD}};
  for (const Named& named : all) {
    const bool has_own_file = named.method == QTRAJ_SLERP || named.method == QTRAJ_SQUAD;
    if (!has_own_file) add_ours<Real>({with_type<Real>(named.name), 1000, 1000000}, named.method);
    add_rates<Real>(named, "_q_omega", false);
    add_rates<Real>(named, "_q_omega_alpha", true);
  }
  add_ours<Real>({with_type<Real>("rotation_spline"), 1000, 1000000, Order::random}, QTRAJ_ROTATION_SPLINE);
}

}  // namespace

void add_splines() {
  add_type<double>();
  add_type<float>();
}

}  // namespace bench

// One time a call, as in a control loop. Latency: each time waits for the sample before it.
#include "peers.hpp"
#include "support.hpp"

namespace bench {
namespace {

// 0, in a way that the compiler does not know.
double zero_after(double component) { return component * 0.0; }

void add_latency(const Case& sampled) {
  add<double>(sampled, "ours", [=] {
    const qtraj_trajectory* const trajectory = trajectory_of(QTRAJ_SLERP, sampled.keys);
    const std::vector<double>& times = times_of(sampled);
    return [=, &times](double* q) {
      size_t cursor = 0;
      q[0] = 0;
      for (const double time : times) must_be_ok(qtraj_sample_at(trajectory, time + zero_after(q[0]), &cursor, q));
    };
  });
  add<double>(sampled, "eigen", [=] {
    const std::vector<double>& knots = keys_of(sampled.keys).times;
    const std::vector<double>& times = times_of(sampled);
    return [=, &knots, &times, keys = peers::rows_from(keys_of(sampled.keys).q, peers::eigen_from<double>)](double* q) {
      q[3] = 0;
      for (const double time : times) {
        const double chained = time + zero_after(q[3]);
        peers::eigen_slerp_any_order(knots, keys, &chained, 1, q);
      }
    };
  });
}

}  // namespace

void add_single() {
  add_latency({"sample_at_f64", 1000, 10000});
  add_latency({"sample_at_f64", 1000, 10000, Order::random});
  add_latency({"sample_at_f64", 1000000, 10000});
}

}  // namespace bench

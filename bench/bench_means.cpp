#include <ctime>

#include "peers.hpp"
#include "support.hpp"

namespace bench {
namespace {

// Around one orientation, up to 2 rad from it.
const std::vector<double>& cluster_of(size_t count) {
  static std::map<std::tuple<size_t>, std::unique_ptr<std::vector<double>>> all;
  const auto make = [=] {
    Random random(count);
    const test::Quaternion center = random.orientation();
    std::vector<double> q;
    for (size_t i = 0; i < count; ++i)
      for (const double component : test::multiply(center, test::turn_within(random, 2.0))) q.push_back(component);
    return q;
  };
  return kept(all, make, count);
}

void mean_eigen(const std::vector<double>& q, double* out) {
  must_be_ok(qtraj_mean_eigen(q.data(), nullptr, q.size() / 4, out, nullptr, nullptr));
}
void mean_eigen(const std::vector<float>& q, float* out) {
  must_be_ok(qtraj_mean_eigen_f32(q.data(), nullptr, q.size() / 4, out, nullptr, nullptr));
}

template <class Real>
void add_eigen_mean(size_t count) {
  const Case mean = {with_type<Real>("mean_eigen"), 0, count};
  add<Real>(mean, "ours", [=] { return [q = converted<Real>(cluster_of(count))](Real* out) { mean_eigen(q, out); }; });
  add<Real>(mean, "eigen", [=] {
    return [q = peers::rows_from(cluster_of(count), peers::eigen_from<Real>)](Real*) {
      benchmark::DoNotOptimize(peers::eigen_mean(q));
    };
  });
}

// ---- One step of the Karcher mean ----

double thread_seconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Time of a mean that is stopped after so many steps.
double seconds_of_steps(const std::vector<double>& q, int32_t steps) {
  double mean[4];
  const double begin = thread_seconds();
  const qtraj_status status =
      qtraj_mean_karcher(q.data(), nullptr, q.size() / 4, 0, steps, mean, nullptr, nullptr, nullptr);
  const double seconds = thread_seconds() - begin;
  // a descent that had ended would go on to its proof, and be no measure of a step
  if (status != QTRAJ_E_NO_CONVERGENCE) {
    std::fprintf(stderr, "bench: %d steps of the Karcher mean: %s\n", steps, qtraj_status_text(status));
    std::exit(1);
  }
  return seconds;
}

// The API has no single step: the second one is what two take longer than one.
void add_karcher(size_t count) {
  const Case step = {"karcher_step_f64", 0, count};
  benchmark::RegisterBenchmark(step.row("ours").c_str(), [=](benchmark::State& state) {
    const std::vector<double>& q = cluster_of(count);
    for (auto iteration : state) {
      const double one = seconds_of_steps(q, 1);
      state.SetIterationTime(seconds_of_steps(q, 2) - one);
    }
    state.counters["samples"] = static_cast<double>(count);
    state.counters["manual"] = 1;
  })->UseManualTime();
  add<double>(step, "atan2", [=] {
    const std::vector<double>& q = cluster_of(count);
    std::vector<double> mean(4);
    mean_eigen(q, mean.data());
    return [=, &q](double* out) { peers::atan2_karcher_step(mean.data(), q.data(), count, out); };
  });
}

}  // namespace

void add_means() {
  for (const size_t count : {10000, 1000000}) {
    add_eigen_mean<double>(count);
    add_eigen_mean<float>(count);
    add_karcher(count);
  }
}

}  // namespace bench

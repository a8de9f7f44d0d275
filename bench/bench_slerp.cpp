#include "peers.hpp"
#include "support.hpp"

namespace bench {
namespace {

template <class Real>
void add_eigen(const Case& sampled) {
  add<Real>(sampled, "eigen", [=] {
    const std::vector<double>& knots = keys_of(sampled.keys).times;
    const std::vector<double>& times = times_of(sampled);
    const bool sorted = sampled.order == Order::sorted;
    return [=, &knots, &times, keys = peers::rows_from(keys_of(sampled.keys).q, peers::eigen_from<Real>)](Real* out) {
      (sorted ? peers::eigen_slerp_sorted<Real> : peers::eigen_slerp_any_order<Real>)(knots, keys, times.data(),
                                                                                      times.size(), out);
    };
  });
}

template <class Real>
void add_glm(const Case& sampled) {
  add<Real>(sampled, "glm", [=] {
    const std::vector<double>& knots = keys_of(sampled.keys).times;
    const std::vector<double>& times = times_of(sampled);
    return [&knots, &times, keys = peers::rows_from(keys_of(sampled.keys).q, peers::glm_from<Real>)](Real* out) {
      peers::glm_slerp_sorted(knots, keys, times.data(), times.size(), reinterpret_cast<glm::qua<Real>*>(out));
    };
  });
}

template <class Real>
void add_qvm(const Case& sampled) {
  add<Real>(sampled, "boost_qvm", [=] {
    const std::vector<double>& knots = keys_of(sampled.keys).times;
    const std::vector<double>& times = times_of(sampled);
    return [&knots, &times, keys = peers::rows_from(keys_of(sampled.keys).q, peers::qvm_from<Real>)](Real* out) {
      peers::qvm_slerp_sorted(knots, keys, times.data(), times.size(), reinterpret_cast<boost::qvm::quat<Real>*>(out));
    };
  });
}

template <class Real>
void add_bytes(const Case& sampled) {
  add<Real>(sampled, "bytes", [=] {
    const std::vector<double>& times = times_of(sampled);
    return [&times](Real* out) { peers::read_and_write(times.data(), times.size(), out); };
  });
}

template <class Real>
void add_type(const Settings& settings) {
  const std::string work = with_type<Real>("slerp");
  std::vector<size_t> sample_counts = {1000, 10000, 100000, 1000000, 10000000};
  if (settings.large) sample_counts.push_back(100000000);

  for (const size_t samples : sample_counts) {
    const Case sampled = {work, 1000, samples};
    add_ours<Real>(sampled, QTRAJ_SLERP);
    add_eigen<Real>(sampled);
    add_bytes<Real>(sampled);
    if (samples == 1000000) {
      add_glm<Real>(sampled);
      add_qvm<Real>(sampled);
    }
    if (samples < 1000000) continue;
    const Case fresh = {work, 1000, samples, Order::sorted, Memory::fresh};
    add_ours<Real>(fresh, QTRAJ_SLERP);
    if (samples == 1000000) add_eigen<Real>(fresh);
    add_bytes<Real>(fresh);
  }

  for (const size_t keys : {10, 10000, 100000, 1000000}) {
    const Case sampled = {work, keys, 1000000};
    add_ours<Real>(sampled, QTRAJ_SLERP);
    add_eigen<Real>(sampled);
  }
  for (const size_t keys : {10, 1000, 100000, 1000000}) {
    const Case sampled = {work, keys, 1000000, Order::random};
    add_ours<Real>(sampled, QTRAJ_SLERP);
    add_eigen<Real>(sampled);
  }
}

// No array of times.
void add_uniform() {
  const Case sampled = {"slerp_uniform_f64", 1000, 1000000};
  add<double>(sampled, "ours", [=] {
    const qtraj_trajectory* const trajectory = trajectory_of(QTRAJ_SLERP, sampled.keys);
    const double start = qtraj_start_time(trajectory);
    const double step = (qtraj_end_time(trajectory) - start) / static_cast<double>(sampled.samples);
    return
        [=](double* out) { must_be_ok(qtraj_sample_uniform(trajectory, start, step, sampled.samples, out, nullptr)); };
  });
}

}  // namespace

void add_slerp(const Settings& settings) {
  add_type<double>(settings);
  add_type<float>(settings);
  add_uniform();
}

}  // namespace bench

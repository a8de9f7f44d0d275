// Positions beside orientations: cubic vector curves, in batches and one time a call.
#include <algorithm>
#include <array>

#include "support.hpp"

namespace bench {
namespace {

constexpr size_t kDim = 3;

std::vector<double> positions_of(size_t count) {
  Random random(count);
  std::vector<double> values(kDim * count);
  for (double& value : values) value = random.uniform(-10.0, 10.0);
  return values;
}

const qtraj_vector_curve* curve_of(size_t key_count) {
  static std::map<std::tuple<size_t>, std::unique_ptr<const qtraj_vector_curve*>> all;
  const auto make = [=]() -> const qtraj_vector_curve* {
    qtraj_options* options = nullptr;
    must_be_ok(qtraj_options_create(QTRAJ_VECTOR_CUBIC, &options));
    qtraj_vector_curve* made = nullptr;
    must_be_ok(qtraj_vector_create(options, keys_of(key_count).times.data(), positions_of(key_count).data(), nullptr,
                                   nullptr, key_count, kDim, &made, nullptr));
    qtraj_options_destroy(options);
    return made;
  };
  return kept(all, make, key_count);
}

// What a program without a library does: the coefficients of each segment, found by a walk or by halving.
class PlainCubics {
 public:
  explicit PlainCubics(size_t key_count) : knots_(keys_of(key_count).times) {
    // a cubic from the curve's values and slopes
    std::vector<double> p(kDim * key_count), v(kDim * key_count);
    must_be_ok(
        qtraj_vector_sample(curve_of(key_count), knots_.data(), key_count, p.data(), v.data(), nullptr, nullptr));
    for (size_t i = 0; i + 1 < key_count; ++i) {
      const double h = knots_[i + 1] - knots_[i];
      for (size_t c = 0; c < kDim; ++c) {
        const size_t at = kDim * i + c;
        const double slope = (p[at + kDim] - p[at]) / h;
        coefficients_.push_back(
            {p[at], v[at], (3 * slope - 2 * v[at] - v[at + kDim]) / h, (v[at] + v[at + kDim] - 2 * slope) / (h * h)});
      }
    }
  }

  void sample(double time, size_t& segment, double* out) const {
    const size_t last = knots_.size() - 2;
    if (!(knots_[segment] <= time && time <= knots_[segment + 1])) {
      if (segment < last && time >= knots_[segment + 1] && time <= knots_[segment + 2])
        ++segment;
      else
        segment = std::min<size_t>(
            last, static_cast<size_t>(std::upper_bound(knots_.begin(), knots_.end(), time) - knots_.begin()) - 1);
    }
    const double x = time - knots_[segment];
    for (size_t c = 0; c < kDim; ++c) {
      const auto& k = coefficients_[kDim * segment + c];
      out[c] = k[0] + x * (k[1] + x * (k[2] + x * k[3]));
    }
  }

 private:
  const std::vector<double>& knots_;
  std::vector<std::array<double, 4>> coefficients_;
};

void add_batch(const Case& sampled) {
  add<double>(
      sampled, "ours",
      [=] {
        const qtraj_vector_curve* const curve = curve_of(sampled.keys);
        const std::vector<double>& times = times_of(sampled);
        return [=, &times](double* out) {
          must_be_ok(qtraj_vector_sample(curve, times.data(), times.size(), out, nullptr, nullptr, nullptr));
        };
      },
      kDim);
  add<double>(
      sampled, "loop",
      [=] {
        const std::vector<double>& times = times_of(sampled);
        return [&times, cubics = PlainCubics(sampled.keys)](double* out) {
          size_t segment = 0;
          for (size_t i = 0; i < times.size(); ++i) cubics.sample(times[i], segment, out + kDim * i);
        };
      },
      kDim);
}

// Orientations and positions in one call, beside two calls.
void add_poses(const Case& sampled) {
  const auto prepare = [=](const auto& sample) {
    return [=] {
      const qtraj_trajectory* const trajectory = trajectory_of(QTRAJ_ROTATION_SPLINE, sampled.keys);
      const qtraj_vector_curve* const curve = curve_of(sampled.keys);
      const std::vector<double>& times = times_of(sampled);
      return [=, &times](double* out) { sample(trajectory, curve, times, out, out + 4 * times.size()); };
    };
  };
  const auto one_call = [](const qtraj_trajectory* trajectory, const qtraj_vector_curve* curve,
                           const std::vector<double>& times, double* q, double* p) {
    must_be_ok(qtraj_sample_poses(trajectory, curve, QTRAJ_FRAME_BODY, times.data(), times.size(), q, nullptr, nullptr,
                                  p, nullptr, nullptr, nullptr));
  };
  const auto two_calls = [](const qtraj_trajectory* trajectory, const qtraj_vector_curve* curve,
                            const std::vector<double>& times, double* q, double* p) {
    must_be_ok(qtraj_sample(trajectory, times.data(), times.size(), q, nullptr));
    must_be_ok(qtraj_vector_sample(curve, times.data(), times.size(), p, nullptr, nullptr, nullptr));
  };
  add<double>(sampled, "ours", prepare(one_call), 4 + kDim);
  add<double>(sampled, "two_calls", prepare(two_calls), 4 + kDim);
}

// One time a call; each waits for the sample before it.
void add_latency(const Case& sampled) {
  const auto zero_after = [](double component) { return component * 0.0; };
  add<double>(sampled, "ours", [=] {
    const qtraj_vector_curve* const curve = curve_of(sampled.keys);
    const std::vector<double>& times = times_of(sampled);
    return [=, &times](double* p) {
      size_t cursor = 0;
      p[0] = 0;
      for (const double time : times)
        must_be_ok(qtraj_vector_sample_at(curve, time + zero_after(p[0]), &cursor, p, nullptr, nullptr));
    };
  });
  add<double>(sampled, "loop", [=] {
    const std::vector<double>& times = times_of(sampled);
    return [=, &times, cubics = PlainCubics(sampled.keys)](double* p) {
      size_t segment = 0;
      p[0] = 0;
      for (const double time : times) cubics.sample(time + zero_after(p[0]), segment, p);
    };
  });
}

}  // namespace

void add_vectors() {
  add_batch({"vector_cubic_f64", 1000, 1000000});
  add_batch({"vector_cubic_f64", 1000, 100000});
  add_batch({"vector_cubic_f64", 1000, 1000000, Order::random});
  add_poses({"poses_f64", 1000, 100000});
  add_latency({"vector_sample_at_f64", 1000, 10000});
}

}  // namespace bench

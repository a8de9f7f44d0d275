// A curve for every evaluator of the kernels, and all samples of a call.
#ifndef QTRAJ_TESTS_KERNEL_CURVES_HPP
#define QTRAJ_TESTS_KERNEL_CURVES_HPP

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "support/capi_variants.hpp"
#include "support/forced_kernel.hpp"

namespace test {

struct KernelCurve {
  std::string name;
  std::vector<double> knots;
  capi::Trajectory trajectory;

  const qtraj_trajectory* get() const { return trajectory.get(); }
  const qtraj::Trajectory& core() const { return trajectory->core; }
};

struct KernelCase {
  capi::Variant variant;
  size_t count;
  double largest_step;  // rad
  double rate;          // of given rates, rad/s
  double norm = 1.0;    // of the keys, in which tangents are
};

// Rotation vectors with |p| in each of its ranges.
inline std::vector<KernelCase> kernel_cases() {
  const auto log_spline = [](const char* range) {
    return capi::Variant{std::string("LOG_SPLINE ") + range, QTRAJ_LOG_SPLINE};
  };
  return {{{"SLERP", QTRAJ_SLERP}, 20, 3.1, 0},
          {{"NLERP", QTRAJ_NLERP}, 20, 3.1, 0},
          {{"SQUAD", QTRAJ_SQUAD}, 20, 2.0, 0},
          {{"SQUAD, arcs near", QTRAJ_SQUAD}, 20, 0.5, 0},
          {log_spline("quarter turn"), 5, 0.1, 0},
          {log_spline("half turn"), 9, 1.0, 0},
          {log_spline("full turn"), 12, 2.0, 0},
          {log_spline("any"), 160, 3.0, 0},
          {{"ROTATION_SPLINE", QTRAJ_ROTATION_SPLINE}, 20, 1.5, 0},
          {{"ROTATION_QUINTIC", QTRAJ_ROTATION_QUINTIC}, 20, 1.5, 0.5},
          {{"ROTATION_QUINTIC half turn", QTRAJ_ROTATION_QUINTIC}, 20, 1.5, 10},
          {{"ROTATION_QUINTIC full turn", QTRAJ_ROTATION_QUINTIC}, 20, 1.5, 20},
          {{"ROTATION_QUINTIC any", QTRAJ_ROTATION_QUINTIC}, 20, 1.5, 1000},
          {{"QUATERNION_QUINTIC", QTRAJ_QUATERNION_QUINTIC}, 20, 1.5, 0.5},
          {{"QUATERNION_QUINTIC any", QTRAJ_QUATERNION_QUINTIC}, 20, 1.5, 1e5},
          {{"QUATERNION_HERMITE", QTRAJ_QUATERNION_HERMITE}, 20, 1.5, 0.5},
          {{"QUATERNION_HERMITE any", QTRAJ_QUATERNION_HERMITE}, 20, 1.5, 0.5, 0x1p30}};
}

// Through a random walk that begins at `start`, s.
inline KernelCurve kernel_curve(const KernelCase& c, int32_t before, int32_t after, double start = -2.0) {
  Random random(c.count);
  Keys walk = random_walk(random, c.count, c.largest_step, 0.2, 2.0);
  const double shift = start - walk.times.front();
  for (double& time : walk.times) time += shift;
  const capi::Options options = capi::make_options(c.variant);
  // rates beyond what the steps turn: they shall wind the curves, not add turns to them
  REQUIRE(qtraj_options_set_turns(options.get(), QTRAJ_TURNS_SHORTEST) == QTRAJ_OK);
  REQUIRE(qtraj_options_set_extrapolation(options.get(), before, after) == QTRAJ_OK);
  for (double& component : walk.q) component *= c.norm;
  const capi::Keyframes<double> keys = {walk.times, walk.q};
  const double rate = c.variant.needs_tangents() ? c.norm * c.rate : c.rate;
  return {c.variant.name, walk.times,
          capi::must_build(options.get(), keys, capi::rates_for<double>(c.variant, c.count, rate))};
}

inline std::vector<KernelCurve> kernel_curves(int32_t before, int32_t after) {
  std::vector<KernelCurve> curves;
  for (const KernelCase& c : kernel_cases()) curves.push_back(kernel_curve(c, before, after));
  return curves;
}

// Which outputs a call asks for, in which frame.
struct Request {
  bool q, omega, alpha;
  int32_t frame;

  bool with_rates() const { return omega || alpha; }
};
constexpr Request kRequests[] = {{true, false, false, QTRAJ_FRAME_BODY},
                                 {true, true, true, QTRAJ_FRAME_BODY},
                                 {true, true, true, QTRAJ_FRAME_WORLD},
                                 {false, true, false, QTRAJ_FRAME_WORLD},
                                 {false, false, true, QTRAJ_FRAME_BODY}};

// Arrays of a call, null where not asked for.
template <class Real>
struct Arrays {
  Real *q, *omega, *alpha;

  Arrays from_row(size_t row) const {
    return {q ? q + 4 * row : nullptr, omega ? omega + 3 * row : nullptr, alpha ? alpha + 3 * row : nullptr};
  }
};
template <class Real>
qtraj_status sample(const qtraj_trajectory* trajectory, const Request& request, const double* times, size_t count,
                    const Arrays<Real>& to, size_t* bad_index = nullptr) {
  if (!request.with_rates()) return capi::sample(trajectory, times, count, to.q, bad_index);
  return capi::sample_rates(trajectory, request.frame, times, count, to.q, to.omega, to.alpha, bad_index);
}

// Rows in memory of their own; those not asked for stay 0.
template <class Real>
struct OwnRows {
  capi::Motion<Real> rows;
  Request request;

  OwnRows(size_t count, const Request& wanted) : rows(count), request(wanted) {}
  Arrays<Real> arrays() {
    return {request.q ? rows.q.data() : nullptr, request.omega ? rows.omega.data() : nullptr,
            request.alpha ? rows.alpha.data() : nullptr};
  }
};

template <class Real>
bool same_row(const Arrays<Real>& a, const Arrays<Real>& b, size_t row) {
  const auto same = [&](const Real* x, const Real* y, size_t size) {
    return !x || std::memcmp(x + size * row, y + size * row, size * sizeof(Real)) == 0;
  };
  return same(a.q, b.q, 4) && same(a.omega, b.omega, 3) && same(a.alpha, b.alpha, 3);
}

// What is expected of a batch: each time on its own, which the kernels take without vectors.
template <class Real>
OwnRows<Real> one_by_one(const qtraj_trajectory* trajectory, const Request& request, const std::vector<double>& times) {
  OwnRows<Real> own(times.size(), request);
  for (size_t i = 0; i < times.size(); ++i) sample(trajectory, request, &times[i], 1, own.arrays().from_row(i));
  return own;
}

// Calls body(target) with each kernel that runs here, and says once which do not.
template <class Body>
void for_every_kernel(Body&& body) {
  static std::set<std::string> named;
  for (const char* target : target_names()) {
    const ForcedKernel forced(target);
    if (!forced.runs_here()) {
      if (named.insert(target).second) WARN("not run: no kernel \"" << target << "\" on this CPU or in this build");
      continue;
    }
    CAPTURE(target);
    body(target);
  }
}

}  // namespace test

#endif

// The arrays of every call, and calls of the functions over rows of them.
#ifndef QTRAJ_TESTS_STACK_ROWS_HPP
#define QTRAJ_TESTS_STACK_ROWS_HPP

#include <qtraj.h>

#include "support/kernel_curves.hpp"
#include "support/painted_stack.hpp"
#include "support/row_functions.hpp"

namespace stack_calls {

using namespace capi;
using test::Call;

constexpr size_t kKeys = 203, kTimes = 999;

struct NamedCall {
  const char* group;
  std::string name;
  Call call;
};

// Arrays for any call, large enough for each of them.
struct Arrays {
  std::vector<double> times, scattered, sorted, q, vectors, fractions, out, second, third;
  std::vector<float> q_f32, out_f32, second_f32, third_f32, fractions_f32;
  std::vector<int64_t> ns;
  std::vector<int32_t> statuses;
  std::vector<size_t> flips;

  Arrays() : out(9 * kTimes), second(9 * kTimes), third(9 * kTimes), ns(kTimes), statuses(kTimes), flips(kTimes) {
    out_f32.resize(out.size()), second_f32.resize(out.size()), third_f32.resize(out.size());
    test::Random random(5);
    const test::Keys walk = test::random_walk(random, kKeys, 1.5, 0.2, 2.0);
    times = walk.times, q = walk.q;
    while (q.size() < 4 * kTimes) q.push_back(random.uniform(-1, 1));
    while (vectors.size() < 4 * kTimes) vectors.push_back(random.uniform(-1, 1));
    while (fractions.size() < kTimes) fractions.push_back(random.uniform(0.01, 0.99));
    while (scattered.size() < kTimes) scattered.push_back(random.uniform(times.front() - 9, times.back() + 9));
    sorted = scattered;
    std::sort(sorted.begin(), sorted.end());
    q_f32.assign(q.begin(), q.end());
    fractions_f32.assign(fractions.begin(), fractions.end());
  }
};

inline void add_rows(Arrays& a, std::vector<NamedCall>& calls) {
  const auto add = [&](const char* group, const char* name, const Call& call) { calls.push_back({group, name, call}); };
  const auto pairs = [&](const char* name, auto one, auto each, auto in, auto fractions, auto out) {
    add("pairs", name, [=] { one(in, in + 4, fractions, kTimes, QTRAJ_PATH_SHORTEST, out, nullptr); });
    add("pairs", name, [=] { each(in, 900, in + 400, 900, fractions, 900, 900, QTRAJ_PATH_SHORTEST, out, nullptr); });
  };
  pairs("slerp", qtraj_slerp, qtraj_slerp_pairs, a.q.data(), a.fractions.data(), a.out.data());
  pairs("nlerp", qtraj_nlerp, qtraj_nlerp_pairs, a.q.data(), a.fractions.data(), a.out.data());
  pairs("slerp of float", qtraj_slerp_f32, qtraj_slerp_pairs_f32, a.q_f32.data(), a.fractions_f32.data(),
        a.out_f32.data());
  pairs("nlerp of float", qtraj_nlerp_f32, qtraj_nlerp_pairs_f32, a.q_f32.data(), a.fractions_f32.data(),
        a.out_f32.data());
  const auto between = [&](const char* name, auto function, auto in, auto out) {
    add("pairs", name, [=, &a] {
      function(in, &a.times[0], 1, in + 4, &a.times[1], 1, a.sorted.data(), kTimes, kTimes, QTRAJ_PATH_SHORTEST, out,
               nullptr);
    });
  };
  between("slerp_pairs_between", qtraj_slerp_pairs_between, a.q.data(), a.out.data());
  between("nlerp_pairs_between", qtraj_nlerp_pairs_between, a.q.data(), a.out.data());
  between("slerp_pairs_between of float", qtraj_slerp_pairs_between_f32, a.q_f32.data(), a.out_f32.data());
  between("nlerp_pairs_between of float", qtraj_nlerp_pairs_between_f32, a.q_f32.data(), a.out_f32.data());
  add("pairs", "slerp_between", [&] {
    qtraj_slerp_between(&a.q[0], 0, &a.q[4], 5, a.sorted.data(), kTimes, QTRAJ_PATH_SHORTEST, a.out.data(), nullptr);
  });
  add("pairs", "squad_controls",
      [&] { qtraj_squad_controls(a.times.data(), a.q.data(), kKeys, a.out.data(), a.second.data(), nullptr); });
  add("pairs", "squad_segment", [&] {
    qtraj_squad_segment(&a.q[0], &a.q[4], &a.q[8], &a.q[12], a.fractions.data(), kTimes, a.out.data(), nullptr);
  });
  size_t count = kTimes / 3;
  test::for_each_row_function([&](const auto& function, auto zero) {
    using Real = decltype(zero);
    const auto arrays = std::make_shared<test::RowArrays<Real>>(function, count);
    add("rows", function.name, [=] { arrays->call(function, count, nullptr); });
  });
  add("rows", "normalize", [&] { qtraj_normalize(a.q.data(), kTimes, a.out.data(), nullptr); });
  add("rows", "normalize of float", [&] { qtraj_normalize_f32(a.q_f32.data(), kTimes, a.out_f32.data(), nullptr); });
  add("rows", "make_continuous", [&] {
    size_t flips;
    qtraj_make_continuous(a.q.data(), 1, kTimes, a.out.data(), &flips, nullptr);
  });
  add("rows", "make_continuous of float", [&] {
    size_t flips;
    qtraj_make_continuous_f32(a.q_f32.data(), 1, kTimes, a.out_f32.data(), &flips, nullptr);
  });
  add("rows", "make_continuous_strided",
      [&] { qtraj_make_continuous_strided(a.q.data(), 9, 1, kTimes / 9, 9, a.out.data(), a.flips.data(), nullptr); });
  add("rows", "make_continuous_strided of float", [&] {
    qtraj_make_continuous_strided_f32(a.q_f32.data(), 9, 1, kTimes / 9, 9, a.out_f32.data(), a.flips.data(), nullptr);
  });
  add("rows", "wxyz_from_xyzw", [&] { qtraj_wxyz_from_xyzw(a.q.data(), kTimes, a.out.data()); });
  add("rows", "wxyz_from_xyzw of float", [&] { qtraj_wxyz_from_xyzw_f32(a.q_f32.data(), kTimes, a.out_f32.data()); });
  add("rows", "xyzw_from_wxyz", [&] { qtraj_xyzw_from_wxyz(a.q.data(), kTimes, a.out.data()); });
  add("rows", "xyzw_from_wxyz of float", [&] { qtraj_xyzw_from_wxyz_f32(a.q_f32.data(), kTimes, a.out_f32.data()); });
  const auto tables = [&](const char* name, auto to_rows, auto to_columns, auto columns, auto rows) {
    for (const size_t width : {size_t{3}, size_t{4}, size_t{9}})
      add("rows", name, [=] {
        constexpr size_t kRows = kTimes / 9;
        std::remove_const_t<std::remove_pointer_t<decltype(rows)>>* each[9];
        for (size_t k = 0; k < 9; ++k) each[k] = columns + kRows * k;
        to_rows(each, width, kRows, rows);
        to_columns(rows, width, kRows, each);
      });
  };
  tables("tables", qtraj_rows_from_columns, qtraj_columns_from_rows, a.second.data(), a.out.data());
  tables("tables of float", qtraj_rows_from_columns_f32, qtraj_columns_from_rows_f32, a.second_f32.data(),
         a.out_f32.data());
  add("rows", "seconds_from_ns", [&] { qtraj_seconds_from_ns(a.ns.data(), kTimes, 7, a.out.data()); });
  add("rows", "even_times", [&] { qtraj_even_times(0, 1, kTimes, a.out.data()); });

  // near each other, for a Karcher mean that converges, and all over, where a certificate is sought
  for (const double spread : {0.3, 1.0, 3.0}) {
    const auto q = std::make_shared<std::vector<double>>();
    test::Random random(9);
    for (size_t i = 0; i < kTimes; ++i) {
      q->push_back(1.0);
      for (int k = 0; k < 3; ++k) q->push_back(random.uniform(-spread, spread));
    }
    const auto q_f32 = std::make_shared<std::vector<float>>(q->begin(), q->end());
    // weights of 0 are left out: samples are then copied in blocks
    const auto weights = std::make_shared<std::vector<double>>(a.fractions);
    const auto weights_f32 = std::make_shared<std::vector<float>>(a.fractions_f32);
    for (size_t i = 0; i < kTimes; i += 5) (*weights)[i] = 0, (*weights_f32)[i] = 0;
    for (const bool weighted : {false, true}) {
      const double* w = weighted ? weights->data() : nullptr;
      const float* w_f32 = weighted ? weights_f32->data() : nullptr;
      add("means", "eigen", [=] {
        double mean[4], gap;
        qtraj_mean_eigen(q->data(), w, kTimes, mean, &gap, nullptr), (void)weights;
      });
      add("means", "eigen of float", [=] {
        float mean[4];
        double gap;
        qtraj_mean_eigen_f32(q_f32->data(), w_f32, kTimes, mean, &gap, nullptr), (void)weights_f32;
      });
      add("means", "karcher", [=] {
        double mean[4], residual;
        int32_t iterations;
        qtraj_mean_karcher(q->data(), w, kTimes, 0, 100, mean, &iterations, &residual, nullptr), (void)weights;
      });
      add("means", "karcher of float", [=] {
        float mean[4];
        double residual;
        int32_t iterations;
        qtraj_mean_karcher_f32(q_f32->data(), w_f32, kTimes, 0, 100, mean, &iterations, &residual, nullptr);
        (void)weights_f32;
      });
    }
  }
  add("means", "moments", [&] {
    double moments[11] = {}, mean[4], gap;
    qtraj_moments_add(a.q.data(), a.fractions.data(), kTimes, moments, nullptr);
    qtraj_mean_from_moments(moments, mean, &gap);
  });
  add("many curves", "mean_eigen of float", [&] {
    const int64_t offsets[] = {0, 3, 700, 999};
    qtraj_batch_mean_eigen_f32(3, offsets, a.q_f32.data(), a.fractions_f32.data(), a.out_f32.data(), nullptr, nullptr,
                               nullptr);
  });
  add("many curves", "times at a step", [&] {
    const int64_t offsets[] = {0, 100, kKeys};
    const double step = 0.3;
    int64_t rows[3];
    qtraj_batch_step_offsets(2, offsets, a.times.data(), &step, 1, rows, nullptr, nullptr);
    qtraj_batch_times(2, offsets, a.times.data(), &step, 1, rows, a.out.data(), nullptr, nullptr);
  });
  add("sample diagnostics", "estimate_omega", [&] {
    qtraj_estimate_omega(QTRAJ_FRAME_WORLD, a.times.data(), a.q.data(), kKeys, nullptr, a.out.data(), nullptr);
  });
  add("sample diagnostics", "estimate_energy",
      [&] { qtraj_estimate_energy(QTRAJ_FRAME_WORLD, a.times.data(), a.q.data(), kKeys, a.out.data(), nullptr); });
  add("sample diagnostics", "estimate_jumps", [&] {
    qtraj_estimate_jumps(QTRAJ_FRAME_WORLD, a.times.data(), a.q.data(), kKeys, a.times.data(), kKeys, a.out.data(),
                         nullptr);
  });
  add("sample diagnostics", "keyframe_errors", [&] {
    qtraj_keyframe_errors(a.times.data(), a.q.data(), kKeys, a.times.data(), a.q.data(), kKeys, a.out.data(), nullptr,
                          nullptr);
  });
  add("sample diagnostics", "check_keys", [&] {
    qtraj_key_report report;
    qtraj_check_keys(a.times.data(), a.q.data(), kKeys, a.statuses.data(), &report, nullptr);
  });
  add("sample diagnostics", "check_keys of float", [&] {
    qtraj_key_report report;
    qtraj_check_keys_f32(a.times.data(), a.q_f32.data(), kKeys, a.statuses.data(), &report, nullptr);
  });
  add("cubic_spline", "", [&] {
    qtraj_cubic_spline(a.times.data(), a.q.data(), kKeys, 4, 0, 0, a.sorted.data(), kTimes, a.out.data(), nullptr);
  });
}

}  // namespace stack_calls

#endif

// How much stack the functions of the C API take, on every kernel: what docs/guarantees.md says of threads with small
// stacks.
#include <qtraj.h>

#include <climits>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "support/capi_batches.hpp"
#include "support/kernel_curves.hpp"
#include "support/painted_stack.hpp"
#include "support/row_functions.hpp"
#include "support/vector_curve.hpp"

using namespace capi;
using test::Call;

namespace {

// Of builds with assertions or sanitizers nothing is promised: they inline less, and guard every array.
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
constexpr bool kIsRelease = true;
#else
constexpr bool kIsRelease = false;
#endif

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

void add_sampling(const test::KernelCurve& curve, Arrays& a, std::vector<NamedCall>& calls) {
  const qtraj_trajectory* t = curve.get();
  for (const std::vector<double>* times : {&a.sorted, &a.scattered}) {
    const double* at = times->data();
    calls.push_back({"many samples", curve.name, [=, &a] { qtraj_sample(t, at, kTimes, a.out.data(), nullptr); }});
    calls.push_back(
        {"many samples", curve.name, [=, &a] { qtraj_sample_f32(t, at, kTimes, a.out_f32.data(), nullptr); }});
    for (const int32_t frame : {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD}) {
      calls.push_back({"many samples", curve.name + " rates", [=, &a] {
                         qtraj_sample_rates(t, frame, at, kTimes, a.out.data(), a.second.data(), a.third.data(),
                                            nullptr);
                       }});
      calls.push_back({"many samples", curve.name + " rates of float", [=, &a] {
                         qtraj_sample_rates_f32(t, frame, at, kTimes, a.out_f32.data(), a.second_f32.data(),
                                                a.third_f32.data(), nullptr);
                       }});
    }
  }
  calls.push_back({"many samples", curve.name + " uniform",
                   [=, &a] { qtraj_sample_uniform(t, a.times[0], 0.01, kTimes, a.out.data(), nullptr); }});
  calls.push_back({"many samples", curve.name + " uniform of float",
                   [=, &a] { qtraj_sample_uniform_f32(t, a.times[0], 0.01, kTimes, a.out_f32.data(), nullptr); }});
  calls.push_back({"many samples", curve.name + " unnormalized", [=, &a] {
                     qtraj_sample_unnormalized(t, a.scattered.data(), kTimes, a.out.data(), a.second.data(),
                                               a.third.data(), nullptr);
                   }});
  for (const double time : {a.times[3] + 0.01, a.times.front() - 1, a.times.back() + 1e5}) {
    calls.push_back({"one sample", curve.name, [=, &a] { qtraj_sample_at(t, time, nullptr, a.out.data()); }});
    calls.push_back(
        {"one sample", curve.name + " f32", [=, &a] { qtraj_sample_at_f32(t, time, nullptr, a.out_f32.data()); }});
    for (const int32_t frame : {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD}) {
      calls.push_back({"one sample", curve.name + " rates", [=, &a] {
                         qtraj_sample_rates_at(t, frame, time, nullptr, a.out.data(), a.second.data(), a.third.data());
                       }});
      calls.push_back({"one sample", curve.name + " rates f32", [=, &a] {
                         qtraj_sample_rates_at_f32(t, frame, time, nullptr, a.out_f32.data(), a.second_f32.data(),
                                                   a.third_f32.data());
                       }});
    }
  }
  const auto curve_call = [&](const char* name, const Call& call) {
    calls.push_back({"curve diagnostics", curve.name + " " + name, call});
  };
  curve_call("peaks", [=, &a] { qtraj_curve_peak_rates(t, &a.out[0], &a.out[1], &a.out[2], &a.out[3]); });
  curve_call("energy", [=, &a] { qtraj_curve_energy(t, &a.out[0]); });
  curve_call("total angle", [=, &a] { qtraj_curve_total_angle(t, &a.out[0]); });
  curve_call("jumps", [=, &a] { qtraj_curve_jumps(t, QTRAJ_FRAME_WORLD, a.out.data(), a.second.data()); });
  curve_call("least norm", [=, &a] { qtraj_curve_least_norm(t, &a.out[0], &a.out[1]); });
  curve_call("rate bounds", [=, &a] { qtraj_rate_bounds(t, &a.out[0], &a.out[1]); });
  curve_call("rate mismatch", [=, &a] {
    size_t index;
    qtraj_rate_mismatch(t, &a.out[0], &index);
  });
  calls.push_back({"getters", curve.name, [=, &a] { qtraj_keys(t, a.out.data(), a.second.data()); }});
  calls.push_back({"getters", curve.name + " times", [=, &a] { qtraj_segment_times(t, 5, a.out.data()); }});
  calls.push_back({"getters", curve.name + " count", [=, &a] {
                     size_t count;
                     qtraj_uniform_count(t, a.times[0], 0.01, &count);
                   }});
}

// All curves at once: side by side, and one after the other at many times.
void add_sampling_of_many(const std::vector<test::KernelCurve>& curves, Arrays& a, std::vector<NamedCall>& calls) {
  const auto rig = std::make_shared<std::vector<const qtraj_trajectory*>>();
  for (const test::KernelCurve& curve : curves)
    for (int copy = 0; copy < 3; ++copy) rig->push_back(curve.get());
  const size_t most = kTimes / rig->size();
  for (const size_t count : {size_t{1}, most})
    for (const int32_t layout : {QTRAJ_LAYOUT_SERIES_FIRST, QTRAJ_LAYOUT_TIME_FIRST}) {
      const double* const at = a.scattered.data();
      const std::string what = "many curves, " + std::to_string(count) + " times, layout " + std::to_string(layout);
      calls.push_back({"many samples", what, [=, &a] {
                         qtraj_sample_many(rig->data(), rig->size(), QTRAJ_FRAME_WORLD, at, count, layout, a.out.data(),
                                           a.second.data(), a.third.data(), nullptr);
                         qtraj_sample_many(rig->data(), rig->size(), QTRAJ_FRAME_WORLD, at, count, layout, a.out.data(),
                                           nullptr, nullptr, nullptr);
                       }});
      calls.push_back({"many samples", what + ", float", [=, &a] {
                         qtraj_sample_many_f32(rig->data(), rig->size(), QTRAJ_FRAME_WORLD, at, count, layout,
                                               a.out_f32.data(), a.second_f32.data(), a.third_f32.data(), nullptr);
                         qtraj_sample_many_f32(rig->data(), rig->size(), QTRAJ_FRAME_WORLD, at, count, layout,
                                               a.out_f32.data(), nullptr, nullptr, nullptr);
                       }});
    }
}

void add_construction(const Variant& variant, std::vector<NamedCall>& calls) {
  const auto add = [&](auto zero) {
    using Real = decltype(zero);
    struct Case {
      Options options;
      Keyframes<Real> keys = closed_tour<Real>(kKeys);
      Rates<Real> rates;
      std::vector<char> memory;
    };
    const auto c = std::make_shared<Case>();
    c->options = make_options(variant);
    c->rates = rates_for<Real>(variant, kKeys);
    size_t bytes = 0;
    REQUIRE(qtraj_init_size(c->options.get(), kKeys, &bytes) == QTRAJ_OK);
    c->memory.resize(bytes);
    calls.push_back({"constructors", variant.name, [=] {
                       qtraj_trajectory* out = nullptr;
                       build_in(c->memory.data(), c->memory.size(), c->options.get(), c->keys, c->rates, &out);
                     }});
    calls.push_back(
        {"constructors", variant.name + ", on the heap", [=] { build(c->options.get(), c->keys, c->rates); }});
  };
  for_double_and_float(add);
}

// Many curves: the stack of a constructor, or that of a sampler, and what lies between.
void add_batches(const Variant& variant, std::vector<NamedCall>& calls) {
  const auto add = [&](auto zero) {
    using Real = decltype(zero);
    struct Case {
      Options options;
      Table<Real> table;
      Motion<Real> out;
      std::vector<int32_t> statuses;
    };
    for (const bool evenly : {false, true}) {
      const Table<Real> table(20, variant, 30);
      const auto c = std::make_shared<Case>(
          Case{make_options(variant), table, Motion<Real>(table.rows()), std::vector<int32_t>(20)});
      BatchCall<Real> call = c->table.call(c->options.get(), c->out, true);
      call.status_out = c->statuses.data();
      if (evenly) call.sample_times = nullptr;
      calls.push_back({"many curves", variant.name, [=] { call(nullptr), (void)c; }});
    }
  };
  for_double_and_float(add);
}

// The methods that take numbers of turns.
void add_construction_with_turns(std::vector<NamedCall>& calls) {
  for (const int32_t method : {QTRAJ_SLERP, QTRAJ_ROTATION_SPLINE, QTRAJ_HERMITE, QTRAJ_ROTATION_QUINTIC}) {
    const Variant variant = {std::to_string(method) + " with turns", method};
    struct Case {
      Options options;
      Keyframes<double> keys = closed_tour<double>(kKeys);
      Rates<double> rates;
      std::vector<int32_t> turns = std::vector<int32_t>(kKeys - 1);
    };
    const auto c = std::make_shared<Case>();
    c->options = make_options(variant);
    c->rates = rates_for<double>(variant, kKeys);
    for (size_t i = 0; i < c->turns.size(); i += 50) c->turns[i] = 1;
    REQUIRE(qtraj_options_set_turns(c->options.get(), QTRAJ_TURNS_GIVEN) == QTRAJ_OK);
    calls.push_back({"constructors", variant.name, [=] {
                       qtraj_trajectory* out = nullptr;
                       qtraj_create_with_turns(c->options.get(), QTRAJ_FRAME_WORLD, c->keys.times.data(),
                                               c->keys.q.data(), c->rates.omega_or_null(), c->rates.alpha_or_null(),
                                               c->turns.data(), kKeys, &out, nullptr);
                       qtraj_destroy(out);
                     }});
  }
}

void add_rows(Arrays& a, std::vector<NamedCall>& calls) {
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

// Vector curves of 3 components, and poses with them.
void add_vectors(const VectorVariant& variant, const qtraj_trajectory* trajectory, Arrays& a,
                 std::vector<NamedCall>& calls) {
  struct Case {
    Options options;
    VectorKeys<double> keys;
    VectorCurve curve;
    std::vector<double> memory, times;
  };
  const auto c = std::make_shared<Case>();
  c->options = vector_options(variant);
  REQUIRE(qtraj_options_set_extrapolation(c->options.get(), QTRAJ_EXTRAPOLATE_CONSTANT_RATE,
                                          QTRAJ_EXTRAPOLATE_CONSTANT_RATE) == QTRAJ_OK);
  c->keys = vector_tour<double>(variant, kKeys, 3);
  c->curve = must_build_vector(c->options.get(), c->keys);
  size_t bytes = 0;
  REQUIRE(qtraj_vector_init_size(c->options.get(), kKeys, 3, &bytes) == QTRAJ_OK);
  c->memory.resize(bytes / sizeof(double) + 1);
  const std::string name = "vectors " + variant.name;
  const auto add = [&](const char* group, const char* what, const Call& call) {
    calls.push_back({group, name + what, call});
  };
  add("constructors", "", [=] {
    qtraj_vector_curve* out = nullptr;
    qtraj_vector_init(c->memory.data(), c->memory.size() * sizeof(double), c->options.get(), c->keys.times.data(),
                      c->keys.values.data(), c->keys.first_or_null(), c->keys.second_or_null(), kKeys, 3, &out,
                      nullptr);
  });
  add("constructors", ", on the heap", [=] { build_vector(c->options.get(), c->keys); });
  const qtraj_vector_curve* const v = c->curve.get();
  for (const std::vector<double>* times : {&a.sorted, &a.scattered}) {
    const double* at = times->data();
    add("many samples", "",
        [=, &a] { qtraj_vector_sample(v, at, kTimes, a.out.data(), a.second.data(), a.third.data(), nullptr); });
    add("many samples", " alone",
        [=, &a] { qtraj_vector_sample(v, at, kTimes, a.out.data(), nullptr, nullptr, nullptr); });
    add("many samples", " of float", [=, &a] {
      qtraj_vector_sample_f32(v, at, kTimes, a.out_f32.data(), a.second_f32.data(), a.third_f32.data(), nullptr);
    });
    add("many samples", ", poses", [=, &a] {
      qtraj_sample_poses(trajectory, v, QTRAJ_FRAME_WORLD, at, kTimes, a.out.data(), a.second.data(), a.third.data(),
                         a.out.data() + 4 * kTimes, a.second.data() + 4 * kTimes, a.third.data() + 4 * kTimes, nullptr);
    });
    add("many samples", ", poses of float", [=, &a] {
      qtraj_sample_poses_f32(trajectory, v, QTRAJ_FRAME_BODY, at, kTimes, a.out_f32.data(), a.second_f32.data(),
                             a.third_f32.data(), a.out_f32.data() + 4 * kTimes, a.second_f32.data() + 4 * kTimes,
                             a.third_f32.data() + 4 * kTimes, nullptr);
    });
  }
  for (const double time : {c->keys.times[3] + 0.01, c->keys.times.front() - 1, c->keys.times.back() + 1e5}) {
    add("one sample", "",
        [=, &a] { qtraj_vector_sample_at(v, time, nullptr, a.out.data(), a.second.data(), a.third.data()); });
    add("one sample", " of float", [=, &a] {
      qtraj_vector_sample_at_f32(v, time, nullptr, a.out_f32.data(), a.second_f32.data(), a.third_f32.data());
    });
    add("one sample", ", a pose", [=, &a] {
      qtraj_sample_pose_at(trajectory, v, QTRAJ_FRAME_WORLD, time, nullptr, a.out.data(), a.second.data(),
                           a.third.data(), a.out.data() + 4, a.second.data() + 3, a.third.data() + 3);
    });
    add("one sample", ", a pose of float", [=, &a] {
      qtraj_sample_pose_at_f32(trajectory, v, QTRAJ_FRAME_BODY, time, nullptr, a.out_f32.data(), a.second_f32.data(),
                               a.third_f32.data(), a.out_f32.data() + 4, a.second_f32.data() + 3,
                               a.third_f32.data() + 3);
    });
  }
  add("getters", "", [=, &a] { qtraj_vector_keys(v, a.out.data(), a.second.data()); });
  add("getters", " count", [=] {
    size_t count;
    qtraj_vector_uniform_count(v, c->keys.times[0], 0.01, &count);
  });
}

struct AllCalls {
  Arrays arrays;
  std::vector<test::KernelCurve> curves;
  std::vector<NamedCall> calls;

  AllCalls() {
    curves = test::kernel_curves(QTRAJ_EXTRAPOLATE_CONSTANT_RATE, QTRAJ_EXTRAPOLATE_CONSTANT_RATE);
    for (const test::KernelCurve& curve : curves) add_sampling(curve, arrays, calls);
    add_sampling_of_many(curves, arrays, calls);
    for (const Variant& variant : variants()) add_construction(variant, calls), add_batches(variant, calls);
    add_construction_with_turns(calls);
    size_t next = 0;
    for (const VectorVariant& variant : vector_variants())
      add_vectors(variant, curves[next++ % curves.size()].get(), arrays, calls);
    add_rows(arrays, calls);
  }
};

TEST_CASE("one sample takes 1 kB of stack at most, all other functions 8 kB", "[stack]") {
  if (!kIsRelease) return;
  const AllCalls all;
  test::PaintedStack stack(1 << 15);
  test::for_every_kernel([&](const char* target) {
    std::map<std::string, std::pair<size_t, std::string>> worst;
    for (const NamedCall& call : all.calls) {
      const size_t use = stack.use_of(call.call);
      auto& largest = worst[call.group];
      if (use > largest.first) largest = {use, call.name};
      const size_t limit = std::strcmp(call.group, "one sample") == 0 ? 1024 : 8192;
      if (use > limit) FAIL_CHECK(call.group << ", " << call.name << ": " << use << " bytes");
    }
    if (std::getenv("QTRAJ_TEST_STACK_TABLE"))
      for (const auto& group : worst)
        std::printf("%-14s %-20s %6zu  %s\n", target, group.first.c_str(), group.second.first,
                    group.second.second.c_str());
  });
}

TEST_CASE("threads with the smallest stack there is run every function and leave their neighbour's memory alone",
          "[stack]") {
  if (!kIsRelease) return;
  const AllCalls all;
  test::PaintedStack stack(static_cast<size_t>(PTHREAD_STACK_MIN));
  test::for_every_kernel([&](const char*) {
    for (const NamedCall& call : all.calls) {
      if (!stack.holds(call.call)) FAIL_CHECK(call.group << ", " << call.name);
    }
  });
}

}  // namespace

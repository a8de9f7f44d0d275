// Every function of the C API in a call that takes as much stack as it can, named and grouped as docs/guarantees.md
// does.
#ifndef QTRAJ_TESTS_STACK_CALLS_HPP
#define QTRAJ_TESTS_STACK_CALLS_HPP

#include "support/capi_batches.hpp"
#include "support/vector_curve.hpp"
#include "unit/stack_rows.hpp"

namespace stack_calls {

using namespace capi;
using test::Call;

inline void add_sampling(const test::KernelCurve& curve, Arrays& a, std::vector<NamedCall>& calls) {
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
inline void add_sampling_of_many(const std::vector<test::KernelCurve>& curves, Arrays& a,
                                 std::vector<NamedCall>& calls) {
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

inline void add_construction(const Variant& variant, std::vector<NamedCall>& calls) {
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
inline void add_batches(const Variant& variant, std::vector<NamedCall>& calls) {
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
inline void add_construction_with_turns(std::vector<NamedCall>& calls) {
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

// Vector curves of 3 components, and poses with them.
inline void add_vectors(const VectorVariant& variant, const qtraj_trajectory* trajectory, Arrays& a,
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

}  // namespace stack_calls

#endif

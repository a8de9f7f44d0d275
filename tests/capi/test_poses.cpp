// Poses: orientations and positions at the same times, whole or missing.
#include <cfloat>
#include <cmath>

#include "support/capi_variants.hpp"
#include "support/vector_curve.hpp"

using namespace capi;

namespace {

inline qtraj_status sample_poses(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions, int32_t frame,
                                 const double* times, size_t count, double* const (&out)[6], size_t* bad_index) {
  return qtraj_sample_poses(trajectory, positions, frame, times, count, out[0], out[1], out[2], out[3], out[4], out[5],
                            bad_index);
}
inline qtraj_status sample_poses(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions, int32_t frame,
                                 const double* times, size_t count, float* const (&out)[6], size_t* bad_index) {
  return qtraj_sample_poses_f32(trajectory, positions, frame, times, count, out[0], out[1], out[2], out[3], out[4],
                                out[5], bad_index);
}
inline qtraj_status sample_pose_at(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions,
                                   int32_t frame, double time, size_t* cursor, double* const (&out)[6]) {
  return qtraj_sample_pose_at(trajectory, positions, frame, time, cursor, out[0], out[1], out[2], out[3], out[4],
                              out[5]);
}
inline qtraj_status sample_pose_at(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions,
                                   int32_t frame, double time, size_t* cursor, float* const (&out)[6]) {
  return qtraj_sample_pose_at_f32(trajectory, positions, frame, time, cursor, out[0], out[1], out[2], out[3], out[4],
                                  out[5]);
}

// q, omega, alpha, p, v, a.
template <class Real>
struct Poses {
  std::vector<Real> rows[6];

  Poses(size_t count, size_t dim) {
    for (size_t k = 0; k < 6; ++k) rows[k].assign(count * width(k, dim), Real(-7));
  }
  static size_t width(size_t k, size_t dim) { return k == 0 ? 4 : k < 3 ? 3 : dim; }
};

enum Asked { kQ = 1, kOmega = 2, kAlpha = 4, kP = 8, kV = 16, kA = 32, kAll = 63 };

// Pointers to a row of the outputs asked for.
template <class Real>
struct Outputs {
  Real* at[6];

  Outputs(Poses<Real>& poses, size_t row, size_t dim, int asked = kAll) {
    for (size_t k = 0; k < 6; ++k) at[k] = asked >> k & 1 ? poses.rows[k].data() + row * poses.width(k, dim) : nullptr;
  }
};

template <class Real>
struct Curves {
  Trajectory trajectory;
  VectorCurve positions;
};

// A tour of 20 keys, and positions on knots of their own, or on the same.
template <class Real>
Curves<Real> curves(const Variant& variant, const VectorVariant& vector, size_t dim, int32_t rule, bool same_knots) {
  const Options options = make_options(variant), of_vectors = vector_options(vector);
  for (qtraj_options* some : {options.get(), of_vectors.get()})
    REQUIRE(qtraj_options_set_extrapolation(some, rule, rule) == QTRAJ_OK);
  const Keyframes<Real> keys = closed_tour<Real>(20);
  VectorKeys<Real> positions = vector_tour<Real>(vector, same_knots ? 20 : 27, dim);
  if (same_knots) positions.times = keys.times;
  return {must_build(options.get(), keys, rates_for<Real>(variant, 20)),
          must_build_vector(of_vectors.get(), positions)};
}

TEST_CASE("C API: poses are the samples of both curves, bit for bit", "[capi][poses]") {
  const VectorVariant vectors[] = {{"LINEAR", QTRAJ_VECTOR_LINEAR},
                                   {"CUBIC", QTRAJ_VECTOR_CUBIC},
                                   {"QUINTIC", QTRAJ_VECTOR_QUINTIC},
                                   {"STEP", QTRAJ_VECTOR_STEP}};
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    size_t number = 0;
    for (const Variant& variant : variants()) {
      const VectorVariant& vector = vectors[number++ % 4];
      const size_t dim = 1 + number % 5;
      const bool same_knots = number % 3 == 0;
      const int32_t frame = number % 2 ? QTRAJ_FRAME_BODY : QTRAJ_FRAME_WORLD;
      CAPTURE(variant.name, vector.name, dim, same_knots);
      const auto both = curves<Real>(variant, vector, dim, QTRAJ_EXTRAPOLATE_HOLD, same_knots);
      std::vector<double> times;
      test::Random random(number);
      while (times.size() < 300) times.push_back(random.uniform(-4, 16));
      while (times.size() < 600) times.push_back(-4 + 0.06 * static_cast<double>(times.size() - 300));
      const size_t count = times.size();
      const Motion<Real> motion = must_sample_rates<Real>(both.trajectory.get(), frame, times);
      const VectorMotion<Real> vectors_only = must_sample_vectors<Real>(both.positions.get(), times);
      const std::vector<Real>* const expected[6] = {&motion.q,           &motion.omega,       &motion.alpha,
                                                    &vectors_only.value, &vectors_only.first, &vectors_only.second};
      for (int asked = 1; asked <= kAll; asked += asked < 9 ? 1 : 6) {
        CAPTURE(asked);
        Poses<Real> poses(count, dim), one(count, dim);
        size_t bad = 7, cursor = number;
        CHECK(sample_poses(both.trajectory.get(), both.positions.get(), frame, times.data(), count,
                           Outputs<Real>(poses, 0, dim, asked).at, &bad) == QTRAJ_OK);
        CHECK(bad == SIZE_MAX);
        bool all_ok = true;
        for (size_t i = 0; i < count; ++i)
          all_ok = sample_pose_at(both.trajectory.get(), both.positions.get(), frame, times[i],
                                  i % 5 == 0 ? nullptr : &cursor, Outputs<Real>(one, i, dim, asked).at) == QTRAJ_OK &&
                   all_ok;
        CHECK(all_ok);
        for (size_t k = 0; k < 6; ++k) {
          const std::vector<Real> untouched(poses.rows[k].size(), Real(-7));
          CHECK(capi::same_bits(poses.rows[k], asked >> k & 1 ? *expected[k] : untouched));
          CHECK(capi::same_bits(one.rows[k], asked >> k & 1 ? *expected[k] : untouched));
        }
      }
    }
  });
}

// Knots 0..4 of orientations, with a gap between 1 and 3; of positions 1..6, with a gap between 4 and 6.
struct Partial {
  Trajectory trajectory;
  VectorCurve positions;

  Partial() {
    const Options options = make_options({"", QTRAJ_SLERP}), of_vectors = vector_options(QTRAJ_VECTOR_LINEAR);
    for (qtraj_options* some : {options.get(), of_vectors.get()})
      REQUIRE(qtraj_options_set_longest_gap(some, 1.5) == QTRAJ_OK);
    trajectory = must_build(options.get(), Keyframes<double>{{0, 1, 3, 4},
                                                             {1, 0, 0, 0, 0.8, 0.6, 0, 0,  //
                                                              0, 1, 0, 0, 1, 0, 0, 0}});
    positions = must_build_vector(of_vectors.get(), VectorKeys<double>{{1, 2, 3, 4, 6}, {1, 2, 3, 4, 6}, {}, {}, 1});
  }
};

TEST_CASE("C API: a pose that one curve has no value for is missing from both", "[capi][poses]") {
  const Partial both;
  struct Case {
    double time;
    qtraj_status status;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  const Case cases[] = {
      {0.0, QTRAJ_E_TIME_RANGE},  // of the positions
      {0.5, QTRAJ_E_TIME_RANGE},
      {1.0, QTRAJ_OK},
      {1.5, QTRAJ_E_GAP},  // of the orientations
      {3.0, QTRAJ_OK},
      {3.5, QTRAJ_OK},
      {4.0, QTRAJ_OK},
      {5.0, QTRAJ_E_TIME_RANGE},  // of the orientations, before the gap of the positions
      {7.0, QTRAJ_E_TIME_RANGE},
      {-1.0, QTRAJ_E_TIME_RANGE},
      {infinity, QTRAJ_E_NOT_FINITE},
      {std::nan(""), QTRAJ_E_NOT_FINITE},
  };
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    for (int asked = 1; asked <= kAll; ++asked) {
      CAPTURE(asked);
      for (const Case& c : cases) {
        CAPTURE(c.time);
        Poses<Real> pose(1, 1);
        CHECK(sample_pose_at(both.trajectory.get(), both.positions.get(), QTRAJ_FRAME_BODY, c.time, nullptr,
                             Outputs<Real>(pose, 0, 1, asked).at) == c.status);
        for (size_t k = 0; k < 6; ++k)
          for (const Real number : pose.rows[k])
            CHECK((asked >> k & 1 ? std::isnan(number) == (c.status != QTRAJ_OK) : number == Real(-7)));
      }
      // in batches the status is that of the first row at fault
      for (const size_t first : {0u, 3u, 7u, 10u})
        for (const size_t before : {0u, 1u, 30u, 300u}) {
          std::vector<double> times(before, 3.25);
          times.push_back(cases[first].time);
          for (const Case& c : cases) times.push_back(c.time);
          times.resize(times.size() + 20, 1.0);
          Poses<Real> poses(times.size(), 1);
          size_t bad = 7;
          CHECK(sample_poses(both.trajectory.get(), both.positions.get(), QTRAJ_FRAME_BODY, times.data(), times.size(),
                             Outputs<Real>(poses, 0, 1, asked).at, &bad) == cases[first].status);
          CHECK(bad == before);
          size_t wrong = 0;
          for (size_t i = 0; i < times.size(); ++i) {
            const bool missing = !((times[i] >= 3 && times[i] <= 4) || times[i] == 1);
            for (size_t k = 0; k < 6; ++k)
              for (size_t n = 0; n < Poses<Real>::width(k, 1); ++n) {
                const Real number = poses.rows[k][i * Poses<Real>::width(k, 1) + n];
                wrong += asked >> k & 1 ? std::isnan(number) != missing : number != Real(-7);
              }
          }
          CHECK(wrong == 0);
        }
    }
  });
}

TEST_CASE("C API: a fault among thousands of poses leaves all others bit for bit and has its own index",
          "[capi][poses]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const auto both = curves<Real>({"", QTRAJ_SQUAD}, {"CUBIC", QTRAJ_VECTOR_CUBIC}, 3, QTRAJ_EXTRAPOLATE_ERROR, true);
    const double first = qtraj_start_time(both.trajectory.get()), last = qtraj_end_time(both.trajectory.get());
    const size_t count = 5000;
    std::vector<double> times(count);
    REQUIRE(qtraj_even_times(first, last, count, times.data()) == QTRAJ_OK);
    Poses<Real> whole(count, 3);
    REQUIRE(sample_poses(both.trajectory.get(), both.positions.get(), QTRAJ_FRAME_BODY, times.data(), count,
                         Outputs<Real>(whole, 0, 3).at, nullptr) == QTRAJ_OK);
    for (const size_t fault : {size_t{0}, size_t{1023}, size_t{1024}, size_t{3000}, count - 1}) {
      CAPTURE(fault);
      std::vector<double> with_fault = times;
      with_fault[fault] = last + 1;
      Poses<Real> poses(count, 3);
      size_t bad = 7;
      CHECK(sample_poses(both.trajectory.get(), both.positions.get(), QTRAJ_FRAME_BODY, with_fault.data(), count,
                         Outputs<Real>(poses, 0, 3).at, &bad) == QTRAJ_E_TIME_RANGE);
      CHECK(bad == fault);
      for (size_t k = 0; k < 6; ++k) {
        const size_t width = Poses<Real>::width(k, 3);
        Real* const row = &poses.rows[k][fault * width];
        CHECK(std::all_of(row, row + width, [](Real number) { return std::isnan(number); }));
        std::copy_n(&whole.rows[k][fault * width], width, row);
        CHECK(same_bits(poses.rows[k], whole.rows[k]));
      }
    }
  });
}

TEST_CASE("C API: of two faults of a pose that of the orientation is told", "[capi][poses]") {
  // orientations with a gap where positions have ended, and the reverse
  const Options options = make_options({"", QTRAJ_SLERP}), of_vectors = vector_options(QTRAJ_VECTOR_LINEAR);
  const std::vector<double> q = {1, 0, 0, 0, 0.8, 0.6, 0, 0, 0, 1, 0, 0};
  REQUIRE(qtraj_options_set_longest_gap(options.get(), 2) == QTRAJ_OK);
  const Trajectory gap = must_build(options.get(), Keyframes<double>{{0, 1, 5}, q});
  const VectorCurve brief = must_build_vector(of_vectors.get(), VectorKeys<double>{{0, 1}, {1, 2}, {}, {}, 1});
  REQUIRE(qtraj_options_set_longest_gap(of_vectors.get(), 2) == QTRAJ_OK);
  const VectorCurve gap_of_positions =
      must_build_vector(of_vectors.get(), VectorKeys<double>{{0, 1, 5}, {1, 2, 3}, {}, {}, 1});
  const Trajectory brief_turn = must_build(options.get(), Keyframes<double>{{0, 0.5, 1}, q});
  double numbers[4], p;
  const auto status_of = [&](const Trajectory& trajectory, const VectorCurve& positions) {
    return qtraj_sample_pose_at(trajectory.get(), positions.get(), QTRAJ_FRAME_BODY, 3, nullptr, numbers, nullptr,
                                nullptr, &p, nullptr, nullptr);
  };
  CHECK(status_of(gap, brief) == QTRAJ_E_GAP);
  CHECK(status_of(brief_turn, gap_of_positions) == QTRAJ_E_TIME_RANGE);
  CHECK(status_of(gap, gap_of_positions) == QTRAJ_E_GAP);
}

TEST_CASE("C API: a number of one curve that overflows takes the pose with it", "[capi][poses]") {
  const Options options = make_options({"", QTRAJ_SLERP}), of_vectors = vector_options(QTRAJ_VECTOR_LINEAR);
  for (qtraj_options* some : {options.get(), of_vectors.get()})
    REQUIRE(qtraj_options_set_extrapolation(some, QTRAJ_EXTRAPOLATE_CONSTANT_RATE, QTRAJ_EXTRAPOLATE_CONSTANT_RATE) ==
            QTRAJ_OK);
  const Trajectory turn = must_build(options.get(), Keyframes<double>{{0, 1}, {1, 0, 0, 0, 0.8, 0.6, 0, 0}});
  const VectorCurve way = must_build_vector(of_vectors.get(), VectorKeys<double>{{0, 1}, {0, 8}, {}, {}, 1});
  double q[4], p;
  CHECK(qtraj_sample_pose_at(turn.get(), way.get(), QTRAJ_FRAME_BODY, 1e308, nullptr, q, nullptr, nullptr, &p, nullptr,
                             nullptr) == QTRAJ_E_NOT_FINITE);
  CHECK((std::isnan(q[0]) && std::isnan(p)));
  // one that is not asked for does not
  CHECK(qtraj_sample_pose_at(turn.get(), way.get(), QTRAJ_FRAME_BODY, 1e308, nullptr, q, nullptr, nullptr, nullptr, &p,
                             nullptr) == QTRAJ_OK);
  CHECK(p == 8);
}

// ---- Errors ----

alignas(8) constexpr double kNothing[64] = {};

// All arguments of a call, good as they are.
template <class Real>
struct PoseArguments {
  Partial both;
  std::vector<double> times_of = {1, 3, 3.5, 4};
  Poses<Real> poses = Poses<Real>(4, 1);
  const qtraj_trajectory* trajectory = both.trajectory.get();
  const qtraj_vector_curve* positions = both.positions.get();
  int32_t frame = QTRAJ_FRAME_WORLD;
  const double* times = times_of.data();
  size_t count = 4, bad = 7;
  Outputs<Real> out = Outputs<Real>(poses, 0, 1);

  qtraj_status sample() { return sample_poses(trajectory, positions, frame, times, count, out.at, &bad); }
  qtraj_status one() { return sample_pose_at(trajectory, positions, frame, 3.5, nullptr, out.at); }
  bool is_untouched() const {
    for (const std::vector<Real>& rows : poses.rows)
      for (const Real number : rows)
        if (number != Real(-7)) return false;
    return times_of == std::vector<double>{1, 3, 3.5, 4};
  }
};

// Changes the arguments, and checks the status, the index and that nothing is written.
template <class Change>
void check_refusal(qtraj_status expected, Change&& change, bool of_one = true) {
  for_double_and_float([&](auto zero) {
    PoseArguments<decltype(zero)> a;
    change(a);
    CHECK(a.sample() == expected);
    CHECK(a.bad == SIZE_MAX);
    if (of_one) CHECK(a.one() == expected);
    CHECK(a.is_untouched());
  });
}

TEST_CASE("C API: poses refuse what is missing, no handle, too large or unknown, in this order", "[capi][poses]") {
  const auto drop_outputs = [](auto& a) {
    for (auto& pointer : a.out.at) pointer = nullptr;
  };
  check_refusal(QTRAJ_E_NULL, [](auto& a) { a.trajectory = nullptr; });
  check_refusal(QTRAJ_E_NULL, [](auto& a) { a.positions = nullptr; });
  check_refusal(QTRAJ_E_NULL, drop_outputs);
  check_refusal(
      QTRAJ_E_NULL, [](auto& a) { a.times = nullptr; }, false);
  check_refusal(QTRAJ_E_NULL, [](auto& a) { a.count = 0, a.trajectory = nullptr; });
  check_refusal(QTRAJ_E_NULL, [](auto& a) { a.count = 0, a.positions = nullptr; });
  check_refusal(QTRAJ_E_NULL, [](auto& a) {
    a.trajectory = reinterpret_cast<const qtraj_trajectory*>(kNothing);
    a.positions = nullptr;
    a.frame = 0;
  });
  // each handle, and each in the place of the other
  check_refusal(QTRAJ_E_HANDLE, [](auto& a) { a.trajectory = reinterpret_cast<const qtraj_trajectory*>(kNothing); });
  check_refusal(QTRAJ_E_HANDLE, [](auto& a) { a.positions = reinterpret_cast<const qtraj_vector_curve*>(kNothing); });
  check_refusal(QTRAJ_E_HANDLE, [](auto& a) { a.trajectory = reinterpret_cast<const qtraj_trajectory*>(a.positions); });
  check_refusal(QTRAJ_E_HANDLE,
                [](auto& a) { a.positions = reinterpret_cast<const qtraj_vector_curve*>(a.trajectory); });
  check_refusal(QTRAJ_E_HANDLE, [](auto& a) {
    a.positions = reinterpret_cast<const qtraj_vector_curve*>(kNothing);
    a.count = SIZE_MAX, a.frame = 0;
  });
  for (const size_t count : {SIZE_MAX, SIZE_MAX / 2, SIZE_MAX / 8, SIZE_MAX / 16 + 1})
    check_refusal(
        QTRAJ_E_SIZE, [=](auto& a) { a.count = count, a.frame = 0; }, false);
  for (const int32_t frame : kUnknown) check_refusal(QTRAJ_E_VALUE, [=](auto& a) { a.frame = frame; });
  check_refusal(QTRAJ_E_VALUE, [](auto& a) { a.frame = 0, a.out.at[1] = nullptr, a.out.at[2] = a.out.at[0]; });
}

TEST_CASE("C API: arrays of poses may not overlap, any two of them", "[capi][poses][overlap]") {
  for (size_t i = 0; i < 6; ++i) {
    for (size_t k = 0; k < i; ++k) check_refusal(QTRAJ_E_OVERLAP, [=](auto& a) { a.out.at[i] = a.out.at[k]; });
    check_refusal(
        QTRAJ_E_OVERLAP,
        [=](auto& a) { a.out.at[i] = reinterpret_cast<std::decay_t<decltype(a.out.at[i])>>(a.times_of.data() + 3); },
        false);
  }
}

TEST_CASE("C API: no poses need no arrays", "[capi][poses]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    PoseArguments<Real> a;
    a.count = 0, a.times = nullptr;
    CHECK(a.sample() == QTRAJ_OK);
    CHECK(a.bad == SIZE_MAX);
    for (auto& pointer : a.out.at) pointer = nullptr;
    CHECK(a.sample() == QTRAJ_OK);
    CHECK(a.is_untouched());
    CHECK(qtraj_sample_poses(a.trajectory, a.positions, 0, nullptr, 0, nullptr, nullptr, nullptr, nullptr, nullptr,
                             nullptr, nullptr) == QTRAJ_E_VALUE);
  });
}

}  // namespace

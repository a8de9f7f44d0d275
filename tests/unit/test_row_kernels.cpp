// The functions over rows in the vectors of every kernel: what they give is what each row alone gives, whatever stands
// beside it, and they stay within the caller's arrays.
#include <qtraj.h>

#include <array>
#include <cfenv>
#include <cfloat>

#include "support/guarded.hpp"
#include "support/kernel_curves.hpp"
#include "support/random.hpp"
#include "support/row_functions.hpp"

namespace {

using test::Guarded;
using test::Random;
using test::RowFunction;

constexpr size_t kMost = 64;  // rows: every tail of a vector
constexpr size_t kWidest = 9, kMostInputs = 5;

template <class Real>
std::vector<double> in_double(const Real* numbers, size_t count) {
  return std::vector<double>(numbers, numbers + count);
}

// Pairs whose ends have the times 0 and 1: times are fractions.
#define QTRAJ_TEST_TIMED_PAIRS(function)                                                                     \
  {                                                                                                          \
#function, {{4}, {4}, {1 }}, {4}, false, [](auto in, size_t n, auto out, size_t* bad) {                    \
  const std::vector<double> starts(n, 0.0), ends(n, 1.0), times = in_double(in[2], n);                          \
  return function(in[0], starts.data(), n, in[1], ends.data(), n, times.data(), n, n, QTRAJ_PATH_AS_GIVEN, out[0], bad); \
  } \
  }

#define QTRAJ_TEST_PAIRS(function, path)                                                                               \
  {                                                                                                                    \
#function " " #path,                                                                                               \
        {{4 }, {4 }, {1 } },                                                                                           \
                {4 }, false,                                                                                           \
                 [](auto in, size_t n, auto out,                                                                       \
                    size_t* bad) { return function(in[0], n, in[1], n, in[2], n, n, QTRAJ_PATH_##path, out[0], bad); } \
  }

// All functions over rows: those of the common table, and those whose rows of one number are fractions.
std::vector<RowFunction<double>> functions(double) {
  std::vector<RowFunction<double>> all = {
      QTRAJ_TEST_PAIRS(qtraj_slerp_pairs, SHORTEST),
      QTRAJ_TEST_PAIRS(qtraj_slerp_pairs, AS_GIVEN),
      QTRAJ_TEST_PAIRS(qtraj_nlerp_pairs, SHORTEST),
      QTRAJ_TEST_PAIRS(qtraj_nlerp_pairs, AS_GIVEN),
      QTRAJ_TEST_TIMED_PAIRS(qtraj_slerp_pairs_between),
      QTRAJ_TEST_TIMED_PAIRS(qtraj_nlerp_pairs_between),
      {"normalize",
       {{4}},
       {4},
       false,
       [](auto in, size_t n, auto out, size_t* bad) { return qtraj_normalize(in[0], n, out[0], bad); }},
  };
  for (const RowFunction<double>& function : test::row_functions(0.0)) all.push_back(function);
  return all;
}
std::vector<RowFunction<float>> functions(float) {
  std::vector<RowFunction<float>> all = {
      QTRAJ_TEST_PAIRS(qtraj_slerp_pairs_f32, SHORTEST),
      QTRAJ_TEST_PAIRS(qtraj_slerp_pairs_f32, AS_GIVEN),
      QTRAJ_TEST_PAIRS(qtraj_nlerp_pairs_f32, SHORTEST),
      QTRAJ_TEST_PAIRS(qtraj_nlerp_pairs_f32, AS_GIVEN),
      QTRAJ_TEST_TIMED_PAIRS(qtraj_slerp_pairs_between_f32),
      QTRAJ_TEST_TIMED_PAIRS(qtraj_nlerp_pairs_between_f32),
      {"normalize_f32",
       {{4}},
       {4},
       false,
       [](auto in, size_t n, auto out, size_t* bad) { return qtraj_normalize_f32(in[0], n, out[0], bad); }},
  };
  for (const RowFunction<float>& function : test::row_functions(0.0f)) all.push_back(function);
  return all;
}

qtraj_status make_continuous(const double* q, size_t series, size_t length, double* out, size_t* flips, size_t* bad) {
  return qtraj_make_continuous(q, series, length, out, flips, bad);
}
qtraj_status make_continuous(const float* q, size_t series, size_t length, float* out, size_t* flips, size_t* bad) {
  return qtraj_make_continuous_f32(q, series, length, out, flips, bad);
}

// Rows of which one in `rare` has a component that vectors do not do: of another magnitude, 0 or not finite. One
// quaternion in `rare` is of another norm, and they come close to each other and to opposites.
template <class Real>
std::vector<Real> rows(Random& random, size_t width, int rare) {
  constexpr double kTiny = sizeof(Real) == 4 ? 1e-30 : 1e-300, kHuge = 1 / kTiny;
  const double odd[] = {0, kTiny, -kHuge, HUGE_VAL, std::nan(""), DBL_EPSILON, 1e-308, 5e-324};
  const double norms[] = {1.99, 2, 3, -0x1p-121, 0x1p-120, 0x1p119, -0x1p120, 1e-160, 0};
  std::vector<Real> all;
  test::Quaternion q = random.orientation();
  for (size_t row = 0; row < kMost; ++row) {
    const test::Quaternion other = random.orientation();
    for (size_t k = 0; k < 4; ++k) q[k] = row % 3 == 0 ? -q[k] : row % 3 == 1 ? other[k] : q[k] + 1e-9 * other[k];
    const auto at = static_cast<size_t>(random.uniform(0, static_cast<double>(width) * rare));
    const double norm = random.uniform(0, rare) < 1 ? norms[row % 9] : 1;
    double matrix[9];
    if (width == 9) qtraj_matrix_from_q(q.data(), 1, matrix, nullptr);
    for (size_t k = 0; k < width; ++k) {
      double value = width == 1 ? random.uniform(0, 1) : norm * (width == 9 ? matrix[k] : q[k]);
      if (k == at) value = width == 1 ? odd[row % 8] + 1 : value * odd[row % 8];
      all.push_back(static_cast<Real>(value));
    }
  }
  return all;
}

template <class Real>
bool same_bits(const Real* a, const Real* b, size_t count) {
  for (size_t k = 0; k < count; ++k)
    if (!(std::isnan(a[k]) && std::isnan(b[k])) && std::memcmp(&a[k], &b[k], sizeof(Real)) != 0) return false;
  return true;
}

// One input's rows between guard pages.
template <class Real>
struct GuardedRows {
  Guarded<Real> memory{kWidest * kMost};
  const Real* place(const std::vector<Real>& from, size_t numbers, bool at_end) {
    memory.protect(PROT_READ | PROT_WRITE);
    Real* to = memory.array(numbers, at_end);
    std::copy_n(from.begin(), numbers, to);
    memory.protect(PROT_READ);
    return to;
  }
};

// The outputs of a call, each between guard pages or alone.
template <class Real>
struct GuardedOutput {
  Guarded<Real> memory{kWidest * kMost};
  Real* array = nullptr;

  void place(size_t numbers, bool at_end) {
    memory.fill(0x5a);
    array = memory.array(numbers, at_end);
  }
};

template <class Real>
void check(const RowFunction<Real>& function, int rare) {
  Random random(41 + static_cast<uint64_t>(rare));
  const size_t inputs = function.inputs.size(), outputs = function.outputs.size();
  std::vector<std::vector<Real>> in, expected;
  for (const test::RowInput& input : function.inputs) in.push_back(rows<Real>(random, input.width, rare));
  for (const size_t width : function.outputs) expected.emplace_back(width * kMost);
  std::vector<qtraj_status> statuses;
  for (size_t row = 0; row < kMost; ++row) {
    std::vector<const Real*> from;
    std::vector<Real*> to;
    for (size_t k = 0; k < inputs; ++k) from.push_back(&in[k][function.inputs[k].width * row]);
    for (size_t k = 0; k < outputs; ++k) to.push_back(&expected[k][function.outputs[k] * row]);
    statuses.push_back(function.call(from.data(), 1, to.data(), nullptr));
  }

  std::array<GuardedRows<Real>, kMostInputs> from;
  std::array<GuardedOutput<Real>, 2> to;
  size_t wrong = 0, wrong_outcome = 0, wrote_outside = 0, raised = 0;
  for (size_t count = 0; count <= kMost; ++count)
    for (const bool at_end : {true, false}) {
      const auto all_as_expected = [&] {
        bool same = true;
        for (size_t k = 0; k < outputs; ++k)
          same = same && same_bits(to[k].array, expected[k].data(), function.outputs[k] * count);
        return same;
      };
      std::vector<const Real*> placed;
      for (size_t k = 0; k < inputs; ++k)
        placed.push_back(from[k].place(in[k], function.inputs[k].width * count, at_end));
      std::vector<Real*> out;
      for (size_t k = 0; k < outputs; ++k) {
        to[k].place(function.outputs[k] * count, at_end);
        out.push_back(to[k].array);
      }
      size_t bad_index = 7;
      std::feclearexcept(FE_ALL_EXCEPT);
      const qtraj_status status = function.call(placed.data(), count, out.data(), &bad_index);
      raised += std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) != 0;
      size_t first_bad = 0;
      while (first_bad < count && statuses[first_bad] == QTRAJ_OK) ++first_bad;
      const bool all_ok = first_bad == count;
      wrong_outcome +=
          status != (all_ok ? QTRAJ_OK : statuses[first_bad]) || bad_index != (all_ok ? SIZE_MAX : first_bad);
      wrong += !all_as_expected();
      for (size_t k = 0; k < outputs; ++k)
        wrote_outside += !to[k].memory.holds_around(out[k], function.outputs[k] * count, 0x5a);
      for (size_t k = 0; k < inputs; ++k) {  // in place
        if (function.inputs[k].width != function.outputs[0]) continue;
        std::copy_n(in[k].begin(), function.outputs[0] * count, out[0]);
        std::vector<const Real*> one_of_them = placed;
        one_of_them[k] = out[0];
        function.call(one_of_them.data(), count, out.data(), nullptr);
        wrong += !all_as_expected();
      }
    }
  CHECK(wrong == 0);
  CHECK(wrong_outcome == 0);
  CHECK(wrote_outside == 0);
  CHECK(raised == 0);
}

TEST_CASE("functions over rows give each row what it gets alone, in every kernel", "[row_kernels]") {
  test::for_every_kernel([](const char*) {
    for (const int rare : {1, 3, 20, 1000000}) {
      for (const auto& function : functions(0.0)) {
        CAPTURE(function.name, rare);
        check(function, rare);
      }
      for (const auto& function : functions(0.0f)) {
        CAPTURE(function.name, rare);
        check(function, rare);
      }
    }
  });
}

qtraj_status slerp(const double* a, const double* b, const double* fraction, size_t count, double* out) {
  return qtraj_slerp(a, b, fraction, count, QTRAJ_PATH_SHORTEST, out, nullptr);
}
qtraj_status slerp(const float* a, const float* b, const float* fraction, size_t count, float* out) {
  return qtraj_slerp_f32(a, b, fraction, count, QTRAJ_PATH_SHORTEST, out, nullptr);
}
qtraj_status slerp_pairs(const double* a, size_t a_count, const double* b, size_t b_count, const double* fraction,
                         size_t fractions, double* out) {
  return qtraj_slerp_pairs(a, a_count, b, b_count, fraction, fractions, kMost, QTRAJ_PATH_SHORTEST, out, nullptr);
}
qtraj_status slerp_pairs(const float* a, size_t a_count, const float* b, size_t b_count, const float* fraction,
                         size_t fractions, float* out) {
  return qtraj_slerp_pairs_f32(a, a_count, b, b_count, fraction, fractions, kMost, QTRAJ_PATH_SHORTEST, out, nullptr);
}
qtraj_status rotate(const double* q, size_t q_count, const double* v, size_t v_count, double* out) {
  return qtraj_rotate(q, q_count, v, v_count, kMost, out, nullptr);
}
qtraj_status rotate(const float* q, size_t q_count, const float* v, size_t v_count, float* out) {
  return qtraj_rotate_f32(q, q_count, v, v_count, kMost, out, nullptr);
}

template <class Real>
std::vector<Real> copies(const std::vector<Real>& row_first, size_t width) {
  std::vector<Real> all;
  for (size_t row = 0; row < kMost; ++row) all.insert(all.end(), row_first.begin(), row_first.begin() + width);
  return all;
}

template <class Real>
void check_repeated() {
  Random random(5);
  constexpr int kNever = 1000000;
  const std::vector<Real> a = rows<Real>(random, 4, kNever), b = rows<Real>(random, 4, kNever),
                          v = rows<Real>(random, 3, kNever), fraction = rows<Real>(random, 1, kNever);
  std::vector<Real> one(4 * kMost), many(4 * kMost);
  const auto agree = [&](size_t width, qtraj_status of_one, qtraj_status of_many) {
    CHECK(of_one == QTRAJ_OK);
    CHECK(of_many == QTRAJ_OK);
    CHECK(same_bits(one.data(), many.data(), width * kMost));
  };
  agree(4, slerp(a.data(), b.data(), fraction.data(), kMost, one.data()),
        slerp_pairs(copies(a, 4).data(), kMost, copies(b, 4).data(), kMost, fraction.data(), kMost, many.data()));
  agree(4, slerp_pairs(a.data(), kMost, b.data(), kMost, fraction.data(), 1, one.data()),
        slerp_pairs(a.data(), kMost, b.data(), kMost, copies(fraction, 1).data(), kMost, many.data()));
  agree(4, slerp_pairs(a.data(), 1, b.data(), kMost, fraction.data(), kMost, one.data()),
        slerp_pairs(copies(a, 4).data(), kMost, b.data(), kMost, fraction.data(), kMost, many.data()));
  agree(4, slerp_pairs(a.data(), kMost, b.data(), 1, fraction.data(), 1, one.data()),
        slerp_pairs(a.data(), kMost, copies(b, 4).data(), kMost, copies(fraction, 1).data(), kMost, many.data()));
  agree(3, rotate(a.data(), 1, v.data(), kMost, one.data()),
        rotate(copies(a, 4).data(), kMost, v.data(), kMost, many.data()));
  agree(3, rotate(a.data(), kMost, v.data(), 1, one.data()),
        rotate(a.data(), kMost, copies(v, 3).data(), kMost, many.data()));
}

TEST_CASE("one row that serves all gives what its copies give, in every kernel", "[row_kernels]") {
  test::for_every_kernel([](const char*) {
    check_repeated<double>();
    check_repeated<float>();
  });
}

// What make_continuous does, key after key; a key at fault is passed over.
template <class Real>
std::vector<Real> continued(const std::vector<Real>& q, size_t series, size_t length, size_t& flips) {
  std::vector<Real> result = q;
  flips = 0;
  for (size_t first = 0; first < series * length; first += length) {
    const Real* previous = nullptr;
    for (size_t row = first; row < first + length; ++row) {
      Real* key = &result[4 * row];
      long double cosine = 0, largest = 0;
      for (size_t k = 0; k < 4; ++k) largest = std::max(largest, std::abs(static_cast<long double>(key[k])));
      const bool is_key = std::all_of(key, key + 4, [](Real value) { return std::isfinite(value); }) && largest > 0;
      if (!is_key) {
        std::fill_n(key, 4, static_cast<Real>(std::nan("")));
        continue;
      }
      for (size_t k = 0; k < 4 && previous; ++k) cosine += static_cast<long double>(previous[k]) * key[k];
      if (cosine < 0) {
        for (size_t k = 0; k < 4; ++k) key[k] = -key[k];
        ++flips;
      }
      previous = key;
    }
  }
  return result;
}

template <class Real>
void check_continuous(int rare) {
  Random random(43);
  Guarded<Real> from(4 * kMost), to(4 * kMost);
  size_t wrong = 0, wrong_flips = 0, wrote_outside = 0;
  for (size_t count = 1; count <= kMost; ++count)
    for (const size_t series : {size_t{1}, size_t{2}, count})
      for (const bool at_end : {true, false})
        for (const bool in_place : {true, false}) {
          const size_t length = count / series, numbers = 4 * series * length;
          std::vector<Real> q = rows<Real>(random, 4, rare);
          q.resize(numbers);
          size_t expected_flips, flips = 0;
          const std::vector<Real> expected = continued(q, series, length, expected_flips);
          from.fill(0x5a), to.fill(0x5a);
          Real *given = from.array(numbers, at_end), *out = in_place ? given : to.array(numbers, at_end);
          std::copy(q.begin(), q.end(), given);
          make_continuous(given, series, length, out, &flips, nullptr);
          wrong += !same_bits(out, expected.data(), numbers);
          wrong_flips += flips != expected_flips;
          wrote_outside += !(in_place ? from : to).holds_around(out, numbers, 0x5a);
          wrote_outside += !in_place && !same_bits(given, q.data(), numbers);
        }
  CHECK(wrong == 0);
  CHECK(wrong_flips == 0);
  CHECK(wrote_outside == 0);
}

TEST_CASE("keys are made continuous the same way in every kernel, in place or not", "[row_kernels]") {
  test::for_every_kernel([](const char*) {
    for (const int rare : {1, 3, 20, 1000000}) {
      CAPTURE(rare);
      check_continuous<double>(rare);
      check_continuous<float>(rare);
    }
  });
}

}  // namespace

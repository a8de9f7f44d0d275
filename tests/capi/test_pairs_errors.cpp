// slerp and nlerp, of one pair and pair by pair, and faulty arguments or rows.
#include <cfloat>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"
#include "support/pair_functions.hpp"

using namespace capi;
using pairs::Batch;
using pairs::Functions;
using pairs::kPaths;

namespace {

// A call of a function of one pair or pair by pair; counts of their own are unused by the former.
template <class Real>
struct Call {
  Functions<Real> functions;
  bool is_one_pair;
  const Real *a, *b, *fractions;
  size_t fraction_count, count;
  int32_t path;
  size_t a_count = count, b_count = count;

  qtraj_status operator()(Real* q, size_t* bad_index) const {
    return is_one_pair ? functions.one(a, b, fractions, count, path, q, bad_index)
                       : functions.many(a, a_count, b, b_count, fractions, fraction_count, count, path, q, bad_index);
  }
};

// Calls body(call, batch) for slerp and nlerp, of one pair and pair by pair, double and float, over `count` good rows.
template <class Body>
void for_each_function(size_t count, const Body& body) {
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    test::Random random(count);
    Batch<Real> batch;
    for (size_t i = 0; i < count; ++i) {
      for (const double component : random.orientation()) batch.a.push_back(static_cast<Real>(component));
      for (const double component : random.orientation()) batch.b.push_back(static_cast<Real>(component));
      batch.fractions.push_back(static_cast<Real>(random.uniform(-1, 2)));
    }
    for (const Functions<Real>& functions : pairs::functions(zero))
      for (const bool is_one_pair : {true, false})
        body(Call<Real>{functions, is_one_pair, batch.a.data(), batch.b.data(), batch.fractions.data(), count, count,
                        QTRAJ_PATH_SHORTEST},
             batch);
  });
}

template <class Real>
bool row_is_nan(const std::vector<Real>& q, size_t row) {
  bool all = true;
  for (size_t k = 4 * row; k < 4 * row + 4; ++k) all = all && std::isnan(q[k]);
  return all;
}

TEST_CASE("C API: slerp and nlerp of nothing are OK with NULL arrays", "[capi][pairs]") {
  for_each_function(3, [](auto call, const auto& batch) {
    using Real = std::decay_t<decltype(batch.a[0])>;
    for (const size_t fraction_count : {size_t{0}, size_t{1}}) {
      call.a = call.b = call.fractions = nullptr;
      call.count = 0;
      call.fraction_count = call.a_count = call.b_count = fraction_count;
      size_t bad_index = 7;
      CHECK(call(static_cast<Real*>(nullptr), &bad_index) == QTRAJ_OK);
      CHECK(bad_index == SIZE_MAX);
      CHECK(call(static_cast<Real*>(nullptr), nullptr) == QTRAJ_OK);
    }
  });
}

TEST_CASE("C API: slerp and nlerp judge arguments in order and then leave outputs alone", "[capi][pairs][errors]") {
  for_each_function(3, [](const auto& good, const auto& batch) {
    using Real = std::decay_t<decltype(batch.a[0])>;
    const std::vector<Real> untouched(12, Real(7));
    std::vector<Real> q = untouched;
    const auto check = [&](qtraj_status expected, auto call, bool without_output = false) {
      size_t bad_index = 7;
      Real* out = without_output ? nullptr : q.data();
      CHECK(call(out, &bad_index) == expected);
      CHECK(bad_index == SIZE_MAX);
      CHECK(call(out, nullptr) == expected);
      CHECK(q == untouched);
    };
    auto call = good;
    for (const Real** pointer : {&call.a, &call.b, &call.fractions}) {
      call = good;
      *pointer = nullptr;
      check(QTRAJ_E_NULL, call);
      call.path = 0;
      call.count = call.fraction_count = call.a_count = call.b_count = SIZE_MAX;
      check(QTRAJ_E_NULL, call);
    }
    check(QTRAJ_E_NULL, good, true);

    if (!good.is_one_pair)
      for (const size_t own_count : {size_t{0}, size_t{2}, size_t{4}, SIZE_MAX})
        for (size_t* changed : {&call.fraction_count, &call.a_count, &call.b_count}) {
          call = good;
          *changed = own_count;
          call.path = 0;
          check(QTRAJ_E_COUNT, call);
        }

    constexpr size_t kMost = PTRDIFF_MAX;
    for (const size_t count : {SIZE_MAX, SIZE_MAX / 4 + 2, kMost / (4 * sizeof(Real)) + 1}) {
      call = good;
      call.count = call.fraction_count = call.a_count = call.b_count = count;
      call.path = 0;
      check(QTRAJ_E_SIZE, call);
    }

    for (const int32_t path : {0, 3, -1, INT32_MAX, INT32_MIN}) {
      call = good;
      call.path = path;
      call.a = q.data();
      check(QTRAJ_E_VALUE, call);
    }
  });
}

TEST_CASE("C API: slerp and nlerp may write over whole inputs of their rows and nothing else",
          "[capi][pairs][errors]") {
  for_each_function(3, [](const auto& good, const auto& batch) {
    using Real = std::decay_t<decltype(batch.a[0])>;
    std::vector<Real> expected(12), memory(64, Real(7));
    REQUIRE(good(expected.data(), nullptr) == QTRAJ_OK);
    for (const int which : {0, 1}) {
      auto call = good;
      std::copy(which == 0 ? batch.a.begin() : batch.b.begin(), which == 0 ? batch.a.end() : batch.b.end(),
                memory.begin() + 16);
      (which == 0 ? call.a : call.b) = &memory[16];
      const std::vector<Real> before = memory;
      // the output moves across the input
      for (size_t at = 0; at <= 36; ++at) {
        CAPTURE(at);
        memory = before;
        const size_t input_end = call.is_one_pair ? 20 : 28;
        const bool is_apart = at + 12 <= 16 || at >= input_end, is_same = at == 16 && !call.is_one_pair;
        const qtraj_status status = call(&memory[at], nullptr);
        REQUIRE(status == (is_apart || is_same ? QTRAJ_OK : QTRAJ_E_OVERLAP));
        if (status == QTRAJ_OK)
          REQUIRE(std::equal(expected.begin(), expected.end(), memory.begin() + static_cast<ptrdiff_t>(at)));
        else
          REQUIRE(memory == before);
      }
    }
    auto call = good;
    call.fractions = memory.data();
    CHECK(call(memory.data(), nullptr) == QTRAJ_E_OVERLAP);
    call.count = call.fraction_count = call.a_count = call.b_count = 1;
    memory[0] = batch.fractions[0];
    CHECK(call(memory.data(), nullptr) == QTRAJ_E_OVERLAP);
    // one row: a in place
    call.fractions = good.fractions;
    call.a = memory.data();
    std::copy_n(batch.a.begin(), 4, memory.begin());
    CHECK(call(memory.data(), nullptr) == QTRAJ_OK);
    CHECK(std::equal(memory.begin(), memory.begin() + 4, expected.begin()));
  });
}

TEST_CASE("C API: rows of slerp and nlerp at fault are NaN, all others right, the status that of the first",
          "[capi][pairs][errors]") {
  for_each_function(9, [](const auto& good, auto batch) {
    using Real = std::decay_t<decltype(batch.a[0])>;
    std::vector<Real> expected(36);
    REQUIRE(good(expected.data(), nullptr) == QTRAJ_OK);
    Real signalling;
    set_signalling_nan(signalling);
    const Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
    const Real* const not_finite[] = {&nan, &infinity, &signalling};
    const auto fresh = batch;
    const auto check = [&](const std::vector<size_t>& at_fault, qtraj_status status, const char* what) {
      auto call = good;
      call.a = batch.a.data(), call.b = batch.b.data(), call.fractions = batch.fractions.data();
      std::vector<Real> q(36, Real(7));
      size_t bad_index = 77;
      std::string found = disturbance([&] { call(q.data(), nullptr); });
      CAPTURE(what, call.is_one_pair);
      CHECK(found == "nothing");
      CHECK(call(q.data(), &bad_index) == status);
      CHECK(bad_index == at_fault.front());
      for (size_t row = 0; row < 9; ++row) {
        const bool is_at_fault = std::find(at_fault.begin(), at_fault.end(), row) != at_fault.end();
        const bool is_right = std::equal(q.begin() + 4 * row, q.begin() + 4 * row + 4, expected.begin() + 4 * row);
        CHECK((is_at_fault ? row_is_nan(q, row) : is_right));
      }
      batch = fresh;
    };

    for (const Real* value : not_finite) {
      std::memcpy(&batch.fractions[4], value, sizeof(Real));
      check({4}, QTRAJ_E_NOT_FINITE, "fraction");
    }
    const std::vector<size_t> all = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    const std::vector<size_t> row_0 = good.is_one_pair ? all : std::vector<size_t>{0};
    for (auto* ends : {&batch.a, &batch.b}) {
      for (const Real* value : not_finite) {
        std::memcpy(&(*ends)[2], value, sizeof(Real));
        check(row_0, QTRAJ_E_NOT_FINITE, "end");
      }
      std::fill_n(ends->begin(), 4, Real(-0.0));
      check(row_0, QTRAJ_E_ZERO_NORM, "end");
      // at one row NOT_FINITE comes first
      std::fill_n(ends->begin(), 4, Real(0));
      batch.fractions[0] = nan;
      check(row_0, QTRAJ_E_NOT_FINITE, "end and fraction");
    }
    if (good.is_one_pair) return;
    batch.a[4 * 3] = nan;
    std::fill_n(batch.b.begin() + 4 * 6, 4, Real(0));
    check({3, 6}, QTRAJ_E_NOT_FINITE, "two rows");
    batch.b[4 * 6] = infinity;
    std::fill_n(batch.a.begin() + 4 * 3, 4, Real(0));
    check({3, 6}, QTRAJ_E_ZERO_NORM, "two rows");
  });
}

TEST_CASE("C API: an end that serves all pairs is no place for the output, and at fault it spoils every row",
          "[capi][pairs][errors]") {
  for_each_function(3, [](const auto& good, auto batch) {
    using Real = std::decay_t<decltype(batch.a[0])>;
    if (good.is_one_pair) return;
    auto call = good;
    call.a = batch.a.data();
    call.a_count = 1;
    const std::vector<Real> before = batch.a;
    CHECK(call(batch.a.data(), nullptr) == QTRAJ_E_OVERLAP);
    CHECK(batch.a == before);
    batch.a[3] = std::numeric_limits<Real>::infinity();
    std::vector<Real> q(12, Real(7));
    size_t bad_index = 7;
    CHECK(call(q.data(), &bad_index) == QTRAJ_E_NOT_FINITE);
    CHECK(bad_index == 0);
    for (size_t row = 0; row < 3; ++row) CHECK(row_is_nan(q, row));
  });
}

TEST_CASE("C API: an ambiguous row counts as a fault and holds an answer", "[capi][pairs][errors]") {
  const double a[] = {1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, b[] = {0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, 0}, half = 0.5;
  double q[12];
  size_t bad_index = 7;
  CHECK(qtraj_slerp_pairs(a, 3, b, 3, &half, 1, 3, QTRAJ_PATH_AS_GIVEN, q, &bad_index) == QTRAJ_E_AMBIGUOUS);
  CHECK(bad_index == 1);
  CHECK(std::abs(q[5]) == 1);
  CHECK(std::isnan(q[8]));
  // one pair: every row is
  CHECK(qtraj_slerp(&a[4], &b[4], &half, 1, QTRAJ_PATH_AS_GIVEN, q, &bad_index) == QTRAJ_E_AMBIGUOUS);
  CHECK(bad_index == 0);
}

TEST_CASE("C API: slerp and nlerp take any pair at any fraction without raising anything", "[capi][pairs][floating]") {
  const double values[] = {0.0, 5e-324, -1e-310, 1e-160, 0.5, -1.0, 1e160, DBL_MAX, -DBL_MAX};
  const std::vector<double> fractions = {0, 1, 0.5, -2, 5e-324, 1e100, -1e200, DBL_MAX, -DBL_MAX};
  std::vector<double> q(4 * fractions.size());
  for (const double a0 : values)
    for (const double a1 : values)
      for (const double b0 : values)
        for (const double b1 : values) {
          const double a[] = {a0, 0.0, a1, a0}, b[] = {b0, b1, 0.0, b1};
          for (const Functions<double>& functions : pairs::functions(0.0))
            for (const int32_t path : kPaths) {
              qtraj_status status = QTRAJ_OK;
              const auto call = [&] {
                status = functions.one(a, b, fractions.data(), fractions.size(), path, q.data(), nullptr);
              };
              std::feclearexcept(FE_ALL_EXCEPT);
              call();
              const bool is_quiet = std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) == 0;
              const bool is_zero = (a0 == 0 && a1 == 0) || (b0 == 0 && b1 == 0);
              bool is_unit = true;
              for (size_t row = 0; row < fractions.size() && !is_zero; ++row)
                is_unit = is_unit &&
                          (std::abs(pairs::norm_of(&q[4 * row]) - 1) <= 4 * DBL_EPSILON || status == QTRAJ_E_ZERO_NORM);
              if (!is_quiet || !is_unit) FAIL(a0 << " " << a1 << ", " << b0 << " " << b1);
            }
        }
}

}  // namespace

// Keys and faulty arguments or rows: statuses, rows, untouched outputs.
#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"

using namespace capi;

namespace {

constexpr size_t kMost = PTRDIFF_MAX;

template <class Real>
std::vector<Real> some_keys() {
  return {1, 2, 3, 4, -1, 2, 0, 0, 0, 0, -2, 1, 3, 3, 3, 3, Real(0.5), 0, 0, Real(-0.25), -1, -1, 1, 0};
}

// Every function of keys as one that reads and writes `count` rows and may write bad_index.
template <class Real>
using KeysFunction = qtraj_status (*)(const Real* q, size_t count, Real* q_out, size_t* bad_index);

template <class Real>
qtraj_status one_series(const Real* q, size_t count, Real* q_out, size_t* bad_index) {
  return make_continuous(q, 1, count, q_out, nullptr, bad_index);
}
template <class Real>
qtraj_status many_series(const Real* q, size_t count, Real* q_out, size_t* bad_index) {
  return make_continuous(q, count, 1, q_out, nullptr, bad_index);
}
template <class Real>
qtraj_status to_wxyz(const Real* q, size_t count, Real* q_out, size_t* bad_index) {
  if (bad_index) *bad_index = SIZE_MAX;
  return wxyz_from_xyzw(q, count, q_out);
}
template <class Real>
qtraj_status to_xyzw(const Real* q, size_t count, Real* q_out, size_t* bad_index) {
  if (bad_index) *bad_index = SIZE_MAX;
  return xyzw_from_wxyz(q, count, q_out);
}

template <class Real, class Body>
void for_all_functions(Body&& body) {
  const std::pair<const char*, KeysFunction<Real>> functions[] = {{"normalize", normalize},
                                                                  {"one series", one_series<Real>},
                                                                  {"many series", many_series<Real>},
                                                                  {"to wxyz", to_wxyz<Real>},
                                                                  {"to xyzw", to_xyzw<Real>}};
  for (const auto& function : functions) {
    CAPTURE(function.first);
    body(function.second);
  }
}

TEST_CASE("C API: no keys are OK with NULL arrays", "[capi][keys]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    Real* none = nullptr;
    for_all_functions<Real>([&](KeysFunction<Real> function) {
      size_t bad_index = 0;
      CHECK(function(none, 0, none, &bad_index) == QTRAJ_OK);
      CHECK(bad_index == SIZE_MAX);
      CHECK(function(none, 0, none, nullptr) == QTRAJ_OK);
    });
    for (const size_t other : {size_t{0}, size_t{1}, SIZE_MAX}) {
      size_t flips = 7;
      CHECK(make_continuous(none, 0, other, none, &flips, nullptr) == QTRAJ_OK);
      CHECK(flips == 0);
      CHECK(make_continuous(none, other, 0, none, nullptr, nullptr) == QTRAJ_OK);
    }
  });
}

TEST_CASE("C API: functions of keys judge arguments in the order NULL, SIZE, OVERLAP and then leave outputs alone",
          "[capi][keys][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const std::vector<Real> before = some_keys<Real>();
    std::vector<Real> q = before, out(q.size(), Real(7));
    const std::vector<Real> untouched = out;
    for_all_functions<Real>([&](KeysFunction<Real> function) {
      const auto check = [&](qtraj_status expected, const Real* from, size_t count, Real* to) {
        size_t bad_index = 12345;
        CHECK(function(from, count, to, &bad_index) == expected);
        CHECK(bad_index == SIZE_MAX);
        CHECK(function(from, count, to, nullptr) == expected);
        CHECK(same_bits(q, before));
        CHECK(same_bits(out, untouched));
      };
      check(QTRAJ_E_NULL, nullptr, 6, out.data());
      check(QTRAJ_E_NULL, q.data(), 6, nullptr);
      check(QTRAJ_E_NULL, nullptr, SIZE_MAX, out.data());
      check(QTRAJ_E_NULL, q.data(), SIZE_MAX, nullptr);
      for (const size_t count :
           {SIZE_MAX, SIZE_MAX / 4 + 2, SIZE_MAX / 16 + 2, SIZE_MAX / 32 + 2, kMost / (4 * sizeof(Real)) + 1}) {
        check(QTRAJ_E_SIZE, q.data(), count, out.data());
        check(QTRAJ_E_SIZE, q.data(), count, q.data() + 4);
      }
      for (const size_t offset : {1, 2, 4, 19}) {
        check(QTRAJ_E_OVERLAP, q.data(), 5, q.data() + offset);
        check(QTRAJ_E_OVERLAP, q.data() + offset, 1 + offset / 4, q.data());
      }
    });
  });
}

TEST_CASE("C API: rows of keys right beside each other are no overlap", "[capi][keys]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for_all_functions<Real>([&](KeysFunction<Real> function) {
      std::vector<Real> q = some_keys<Real>();
      CHECK(function(q.data(), 3, q.data() + 12, nullptr) == QTRAJ_OK);
      CHECK(function(q.data() + 12, 3, q.data(), nullptr) == QTRAJ_OK);
    });
  });
}

TEST_CASE("C API: series that multiply to more than memory holds are SIZE and flips is left alone",
          "[capi][keys][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    std::vector<Real> q = some_keys<Real>(), out = q;
    Real* none = nullptr;
    const size_t half = size_t{1} << (sizeof(size_t) * 4);
    const size_t pairs[][2] = {
        {half, half}, {SIZE_MAX, 2}, {3, SIZE_MAX / 3 + 2}, {SIZE_MAX, SIZE_MAX}, {half / 8, half / 2}};
    for (const auto& pair : pairs)
      for (const bool swapped : {false, true}) {
        size_t flips = 7, bad_index = 0;
        CHECK(make_continuous(q.data(), pair[swapped], pair[!swapped], out.data(), &flips, &bad_index) == QTRAJ_E_SIZE);
        CHECK(flips == 7);
        CHECK(bad_index == SIZE_MAX);
        CHECK(make_continuous(q.data(), pair[swapped], pair[!swapped], none, &flips, nullptr) == QTRAJ_E_NULL);
      }
    // the count of flips may not be written into the keys
    CHECK(make_continuous(q.data(), 1, 6, out.data(), reinterpret_cast<size_t*>(out.data() + 4), nullptr) ==
          QTRAJ_E_OVERLAP);
    CHECK(make_continuous(q.data(), 1, 6, out.data(), reinterpret_cast<size_t*>(q.data()), nullptr) == QTRAJ_E_OVERLAP);
    CHECK(same_bits(q, some_keys<Real>()));
    CHECK(same_bits(out, q));
  });
}

TEST_CASE("C API: faulty keys are NaN rows, all others right, the status that of the first", "[capi][keys][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    Real signalling;
    set_signalling_nan(signalling);
    const Real infinity = std::numeric_limits<Real>::infinity(), zeros[4] = {0, -Real(0), 0, 0};
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    for (const Real& value : {nan, infinity, -infinity, signalling, zeros[0]})
      for (const size_t row : {size_t{0}, size_t{2}, size_t{5}}) {
        CAPTURE(value, row);
        const bool is_zero = std::memcmp(&value, zeros, sizeof value) == 0;
        std::vector<Real> q = some_keys<Real>();
        if (is_zero)
          std::copy_n(zeros, 4, &q[4 * row]);
        else
          std::memcpy(&q[4 * row + row % 4], &value, sizeof value);
        std::vector<Real> expected(q.size()), out(q.size());
        REQUIRE(normalize(some_keys<Real>().data(), 6, expected.data(), nullptr) == QTRAJ_OK);
        for (const bool in_place : {false, true}) {
          if (in_place) out = q;
          size_t bad_index = 0;
          CHECK(normalize(in_place ? out.data() : q.data(), 6, out.data(), &bad_index) ==
                (is_zero ? QTRAJ_E_ZERO_NORM : QTRAJ_E_NOT_FINITE));
          CHECK(bad_index == row);
          for (size_t k = 4 * row; k < 4 * row + 4; ++k) CHECK(std::isnan(out[k]));
          std::copy_n(&expected[4 * row], 4, &out[4 * row]);
          CHECK(same_bits(out, expected));
        }
      }
  });
}

TEST_CASE("C API: make_continuous goes on from the last good key", "[capi][keys][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const std::vector<Real> q = {0, 0, 0, 0, -1, 0, 0,   0, nan, 0, 0, 0, 0, 0, 0, 0,
                                 1, 0, 0, 0, 1,  0, nan, 0, -1,  0, 0, 0, 1, 0, 0, 0};
    std::vector<Real> out(q.size());
    size_t flips = 0, bad_index = 0;
    CHECK(make_continuous(q.data(), 1, 8, out.data(), &flips, &bad_index) == QTRAJ_E_ZERO_NORM);
    CHECK(bad_index == 0);
    CHECK(flips == 2);
    const int expected[8] = {0, -1, 0, 0, -1, 0, -1, -1};  // 0: NaN
    for (size_t row = 0; row < 8; ++row) {
      CAPTURE(row);
      if (expected[row] == 0)
        for (size_t k = 0; k < 4; ++k) CHECK(std::isnan(out[4 * row + k]));
      else
        CHECK(out[4 * row] == Real(expected[row]));
    }
    // a series does not look into the one before it; the first fault is an index of all rows
    CHECK(make_continuous(q.data() + 4, 3, 2, out.data(), &flips, &bad_index) == QTRAJ_E_NOT_FINITE);
    CHECK(bad_index == 1);
    CHECK(flips == 0);
    CHECK(out[0] == -1);
    CHECK(out[12] == 1);
    CHECK(out[20] == -1);
  });
}

TEST_CASE("C API: functions of keys disturb nothing", "[capi][keys][floating]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    Real signalling;
    set_signalling_nan(signalling);
    const Real values[] = {std::numeric_limits<Real>::max(),
                           -std::numeric_limits<Real>::max(),
                           std::numeric_limits<Real>::denorm_min(),
                           std::numeric_limits<Real>::min(),
                           std::numeric_limits<Real>::infinity(),
                           signalling,
                           0,
                           Real(1e-30),
                           Real(-1e30)};
    for (const Real& a : values)
      for (const Real& b : values) {
        CAPTURE(a, b);
        std::vector<Real> q = some_keys<Real>();
        for (const size_t k : {4, 9, 14}) std::memcpy(&q[k], &a, sizeof a);
        for (const size_t k : {8, 9, 10, 11, 17, 20}) std::memcpy(&q[k], &b, sizeof b);
        std::vector<Real> out(q.size());
        for_all_functions<Real>([&](KeysFunction<Real> function) {
          CHECK(disturbance([&] { function(q.data(), 6, out.data(), nullptr); }) == std::string("nothing"));
        });
      }
  });
}

}  // namespace

// The scalar cubic spline and faulty arguments, points or queries.
#include <cerrno>
#include <cfloat>
#include <cmath>
#include <functional>
#include <limits>

#include "support/capi_floating.hpp"
#include "support/capi_handles.hpp"
#include "support/catch.hpp"

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
constexpr size_t kMost = PTRDIFF_MAX;

// A call with good arguments, to be spoilt.
struct Call {
  std::vector<double> x = {0, 1, 2.5, 3, 4}, y = {0, 1, 2, -1, 0.5, 3, 1, 1, 0, 1};
  std::vector<double> queries = {3.5, 0, 4, 1.25, 0.5, 2.75};
  std::vector<double> out = std::vector<double>(12, 9.0);
  const double *x_in = x.data(), *y_in = y.data(), *queries_in = queries.data();
  double* y_out = out.data();
  size_t count = 5, dim = 2, query_count = 6, bad_index = 12345;
  int32_t start = QTRAJ_END_DEFAULT, end = QTRAJ_END_NOT_A_KNOT;

  Call() = default;
  Call(const Call&) = delete;

  qtraj_status run() {
    return qtraj_cubic_spline(x_in, y_in, count, dim, start, end, queries_in, query_count, y_out, &bad_index);
  }
  bool row_is_nan(size_t row) const { return std::isnan(out[2 * row]) && std::isnan(out[2 * row + 1]); }
};

std::vector<double> good_rows() {
  Call good;
  REQUIRE(good.run() == QTRAJ_OK);
  CHECK(good.bad_index == SIZE_MAX);
  return good.out;
}

void check_argument_error(qtraj_status expected, const std::function<void(Call&)>& change) {
  Call call;
  change(call);
  CHECK(call.run() == expected);
  CHECK(call.bad_index == SIZE_MAX);
  CHECK(call.out == std::vector<double>(12, 9.0));
}

TEST_CASE("C API: a spline without an array it needs is NULL", "[capi][spline][errors]") {
  check_argument_error(QTRAJ_E_NULL, [](Call& call) { call.x_in = nullptr; });
  check_argument_error(QTRAJ_E_NULL, [](Call& call) { call.y_in = nullptr; });
  check_argument_error(QTRAJ_E_NULL, [](Call& call) { call.queries_in = nullptr; });
  check_argument_error(QTRAJ_E_NULL, [](Call& call) { call.y_out = nullptr; });
  check_argument_error(QTRAJ_E_NULL, [](Call& call) {
    call.x_in = nullptr;
    call.count = 1;  // NULL before COUNT, OPTION
    call.start = -1;
  });
}

TEST_CASE("C API: a spline through fewer than two points is COUNT", "[capi][spline][errors]") {
  for (const size_t count : {0, 1})
    check_argument_error(QTRAJ_E_TOO_FEW, [&](Call& call) {
      call.count = count;
      call.query_count = SIZE_MAX;  // COUNT before SIZE, OPTION
      call.start = -1;
    });
  CHECK(qtraj_cubic_spline(nullptr, nullptr, 0, 0, 0, 0, nullptr, 0, nullptr, nullptr) == QTRAJ_E_TOO_FEW);
}

TEST_CASE("C API: a spline larger than memory is SIZE", "[capi][spline][errors]") {
  const size_t huge[] = {SIZE_MAX,          SIZE_MAX / 2 + 1, SIZE_MAX / 4 + 1, SIZE_MAX / 8 + 1,
                         SIZE_MAX / 16 + 1, kMost / 8 + 1,    kMost / 16 + 1,   kMost / 56 + 1};
  for (const size_t size : huge) {
    CAPTURE(size);
    check_argument_error(QTRAJ_E_SIZE, [&](Call& call) {
      call.count = size;
      call.end = 77;  // SIZE before OPTION
    });
    check_argument_error(QTRAJ_E_SIZE, [&](Call& call) { call.dim = size; });
    check_argument_error(QTRAJ_E_SIZE, [&](Call& call) {
      call.dim = size;
      call.query_count = 0;
    });
    if (size > kMost / 16) check_argument_error(QTRAJ_E_SIZE, [&](Call& call) { call.query_count = size; });
    check_argument_error(QTRAJ_E_SIZE, [&](Call& call) { call.dim = call.count = size; });
    check_argument_error(QTRAJ_E_SIZE, [&](Call& call) { call.dim = call.query_count = size; });
  }
  const size_t half = size_t{1} << (sizeof(size_t) * 4);
  check_argument_error(QTRAJ_E_SIZE, [&](Call& call) { call.dim = call.count = half; });
  check_argument_error(QTRAJ_E_SIZE, [&](Call& call) { call.dim = call.query_count = half; });
}

TEST_CASE("C API: ends that a scalar spline does not have, and one periodic end, are OPTION",
          "[capi][spline][errors]") {
  for (const int32_t end : {QTRAJ_END_CHORD + 0, QTRAJ_END_ESTIMATED + 0, QTRAJ_END_GIVEN + 0, 7, -1, 1000, INT32_MAX,
                            INT32_MIN, QTRAJ_END_PERIODIC + 0})
    for (const bool at_start : {false, true})
      check_argument_error(QTRAJ_E_VALUE, [&](Call& call) {
        (at_start ? call.start : call.end) = end;
        call.y_out = call.y.data() + 1;  // OPTION before OVERLAP
      });
}

TEST_CASE("C API: a spline over parts of its inputs is OVERLAP", "[capi][spline][errors]") {
  check_argument_error(QTRAJ_E_OVERLAP, [](Call& call) { call.y_out = call.x.data(); });
  check_argument_error(QTRAJ_E_OVERLAP, [](Call& call) { call.y_out = call.y.data(); });  // 6 rows over 5
  check_argument_error(QTRAJ_E_OVERLAP, [](Call& call) { call.y_out = call.y.data() + 9; });
  check_argument_error(QTRAJ_E_OVERLAP, [](Call& call) { call.y_out = call.queries.data(); });
  check_argument_error(QTRAJ_E_OVERLAP, [](Call& call) { call.queries_in = call.out.data() + 11; });
  // as many numbers, but rows of another length
  check_argument_error(QTRAJ_E_OVERLAP, [](Call& call) {
    call.count = 4;
    call.query_count = 2;
    call.y_out = call.x.data();
  });
}

TEST_CASE("C API: memory that malloc cannot give a spline is NO_MEMORY", "[capi][spline][errors][memory]") {
  if (sizeof(void*) < 8) return;
  errno = 0x5a5a;
  Call call;
  call.count = size_t{1} << 52;
  call.query_count = 0;
  call.y_out = nullptr;
  CHECK(call.run() == QTRAJ_E_NO_MEMORY);
  CHECK(errno == 0x5a5a);
  CHECK(call.bad_index == SIZE_MAX);
}

TEST_CASE("C API: no queries and no components are OK, and the points are checked all the same", "[capi][spline]") {
  Call none;
  none.query_count = 0;
  none.queries_in = nullptr;
  none.y_out = nullptr;
  CHECK(none.run() == QTRAJ_OK);
  none.x[2] = 0.5;
  CHECK(none.run() == QTRAJ_E_TIME_ORDER);
  CHECK(none.bad_index == 2);

  Call flat;
  flat.dim = 0;
  flat.y_in = nullptr;
  flat.y_out = nullptr;
  CHECK(flat.run() == QTRAJ_OK);
  flat.queries[3] = 17;
  CHECK(flat.run() == QTRAJ_E_TIME_RANGE);
  CHECK(flat.bad_index == 5 + 3);
}

TEST_CASE("C API: queries outside or not finite are NaN rows, all others right", "[capi][spline][errors]") {
  const std::vector<double> expected = good_rows();
  double signalling;
  capi::set_signalling_nan(signalling);
  const double faults[] = {kNaN, kInfinity, -kInfinity, signalling, -1e-14, 4.0 + 1e-14, DBL_MAX, -DBL_MAX};
  for (const double& fault : faults)
    for (const size_t row : {size_t{0}, size_t{3}, size_t{5}}) {
      CAPTURE(&fault - faults, row);
      Call call;
      std::memcpy(&call.queries[row], &fault, sizeof fault);
      if (row == 3) call.queries[5] = 100;
      CHECK(call.run() == (&fault - faults < 4 ? QTRAJ_E_NOT_FINITE : QTRAJ_E_TIME_RANGE));
      CHECK(call.bad_index == 5 + row);
      CHECK(call.row_is_nan(row));
      if (row == 3) CHECK(call.row_is_nan(5));
      for (size_t k = 0; k < 12; ++k) CHECK((k / 2 == row || (row == 3 && k / 2 == 5) || call.out[k] == expected[k]));
    }
}

TEST_CASE("C API: faulty points make every row NaN and come before faulty queries", "[capi][spline][errors]") {
  struct Fault {
    size_t row;
    double x;
    double y;
    qtraj_status status;
  };
  const Fault faults[] = {{0, kNaN, 0, QTRAJ_E_NOT_FINITE},   {4, kInfinity, 0, QTRAJ_E_NOT_FINITE},
                          {2, 2, kNaN, QTRAJ_E_NOT_FINITE},   {2, 1, -kInfinity, QTRAJ_E_NOT_FINITE},
                          {2, 1, 0, QTRAJ_E_TIME_ORDER},      {3, -7, 0, QTRAJ_E_TIME_ORDER},
                          {1, 5e-324, 0, QTRAJ_E_TIME_ORDER}, {1, 7.4e-155, 0, QTRAJ_E_TIME_ORDER}};
  for (const Fault& fault : faults) {
    CAPTURE(&fault - faults);
    Call call;
    call.x[fault.row] = fault.x;
    call.y[2 * fault.row + 1] = fault.y;
    call.queries[0] = kNaN;
    CHECK(call.run() == fault.status);
    CHECK(call.bad_index == fault.row);
    for (size_t row = 0; row < 6; ++row) CHECK(call.row_is_nan(row));
  }
  Call wide;
  wide.x = {-DBL_MAX, 0, 1, 2, DBL_MAX};
  wide.x_in = wide.x.data();
  CHECK(wide.run() == QTRAJ_E_TIME_SPAN);
  CHECK(wide.bad_index == 4);
}

TEST_CASE("C API: a periodic spline closes to 1e-6 of its largest value or is NOT_CLOSED", "[capi][spline][errors]") {
  for (const double scale : {1.0, 1e-300, 1e300, -1e-5}) {
    CAPTURE(scale);
    Call call;
    call.start = call.end = QTRAJ_END_PERIODIC;
    call.y = {1, 1, 2, -1, 0.5, 3, 1, 1, 1, 1 + 2.9e-6};
    for (double& value : call.y) value *= scale;
    call.y_in = call.y.data();
    CHECK(call.run() == QTRAJ_OK);
    // the last value counts as the first
    CHECK(call.out[2 * 2 + 1] == call.y[1]);
    call.y[9] = scale * (1 - 3.1e-6);
    CHECK(call.run() == QTRAJ_E_NOT_CLOSED);
    CHECK(call.bad_index == 4);
    for (size_t row = 0; row < 6; ++row) CHECK(call.row_is_nan(row));
    call.y[4] = kNaN;
    CHECK(call.run() == QTRAJ_E_NOT_FINITE);
    CHECK(call.bad_index == 2);
  }
}

TEST_CASE("C API: values past double's range are NOT_FINITE rows, those within are right", "[capi][spline][errors]") {
  Call call;
  call.dim = 1;
  call.start = call.end = QTRAJ_END_NATURAL;
  call.y = {0, DBL_MAX, -DBL_MAX, DBL_MAX, 0};
  call.y_in = call.y.data();
  call.queries = {0, 1, 1.2, 2.0, 2.8, 4};
  call.queries_in = call.queries.data();
  REQUIRE(call.run() == QTRAJ_E_NOT_FINITE);
  // by the same curve a million times smaller
  std::vector<double> expected(6), small = call.y;
  for (double& value : small) value /= 1048576;
  REQUIRE(qtraj_cubic_spline(call.x_in, small.data(), 5, 1, 0, 0, call.queries_in, 6, expected.data(), nullptr) ==
          QTRAJ_OK);
  size_t first = 6;
  for (size_t row = 6; row-- > 0;) {
    const bool fits = std::abs(expected[row]) <= DBL_MAX / 1048576;
    if (!fits) first = row;
    CHECK((fits ? call.out[row] == expected[row] * 1048576 : std::isnan(call.out[row])));
  }
  CHECK(first < 6);
  CHECK(call.bad_index == 5 + first);
  CHECK(call.out[1] == DBL_MAX);
}

TEST_CASE("C API: curves that swing past all reason are NOT_FINITE", "[capi][spline][errors]") {
  Call steep;
  steep.dim = 1;
  steep.x = {-1e300, 0, 1e-10, 2e-10, 3e-10};
  steep.y = {0, 0, 1, 0, 1};
  steep.queries = {-1, 1e-10, 1.5e-10, 2e-10, 3e-10, 2.5e-10};
  steep.x_in = steep.x.data();
  steep.y_in = steep.y.data();
  steep.queries_in = steep.queries.data();
  steep.start = QTRAJ_END_NOT_A_KNOT;
  CHECK(steep.run() == QTRAJ_E_NOT_FINITE);
  CHECK(steep.bad_index == 0);  // a knot: no slope there
  CHECK(std::isnan(steep.out[5]));
  steep.start = QTRAJ_END_NATURAL;
  CHECK(steep.run() == QTRAJ_E_NOT_FINITE);
  CHECK(steep.bad_index == 5);  // the first query: only its interval swings
  CHECK(std::isnan(steep.out[0]));
  for (size_t row = 1; row < 6; ++row) CHECK(std::abs(steep.out[row]) <= 2);
}

TEST_CASE("C API: splines disturb nothing", "[capi][spline][floating]") {
  double signalling;
  capi::set_signalling_nan(signalling);
  const double values[] = {DBL_MAX, -DBL_MAX, 5e-324, DBL_MIN, 1e-160, -1e300, 2, kInfinity, kNaN, signalling};
  for (const double& a : values)
    for (const double& b : values)
      for (const int32_t end : {QTRAJ_END_NATURAL, QTRAJ_END_NOT_A_KNOT, QTRAJ_END_PERIODIC})
        for (const int place : {0, 1, 2}) {
          CAPTURE(a, b, end, place);
          Call call;
          call.start = call.end = end;
          std::copy_n(call.y.begin(), 2, call.y.begin() + 8);
          std::vector<double>& spoilt = place == 0 ? call.x : place == 1 ? call.y : call.queries;
          std::memcpy(&spoilt[1], &a, sizeof a);
          std::memcpy(&spoilt[4], &b, sizeof b);
          CHECK(capi::disturbance([&] { call.run(); }) == std::string("nothing"));
        }
}

}  // namespace

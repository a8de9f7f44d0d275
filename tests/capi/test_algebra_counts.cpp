// One row that serves all, counts that do not belong together, frames and optional arrays of the algebra.
#include <qtraj.h>

#include <cstring>

#include "support/capi_handles.hpp"
#include "support/catch.hpp"
#include "support/row_functions.hpp"

namespace {

using namespace test;
using capi::kUnknown;

constexpr size_t kRows = 6;

// Functions of two inputs; the first has a count of its own, the second but for pow.
template <class Real>
struct PairFunction {
  const char* name;
  size_t a_width, b_width, out_width;
  bool b_has_count;
  std::function<qtraj_status(const Real*, size_t, const Real*, size_t, size_t, Real*, size_t*)> call;
};

std::vector<PairFunction<float>> pair_functions(float) { return {{"rotate_f32", 4, 3, 3, true, qtraj_rotate_f32}}; }
std::vector<PairFunction<double>> pair_functions(double) {
  const auto pow = [](const double* exponent, size_t exponent_count, const double* q, size_t, size_t count,
                      double* q_out,
                      size_t* bad_index) { return qtraj_pow(q, exponent, exponent_count, count, q_out, bad_index); };
  return {{"multiply", 4, 4, 4, true, qtraj_multiply},
          {"rotate", 4, 3, 3, true, qtraj_rotate},
          {"distance", 4, 4, 1, true, qtraj_distance},
          {"rotation_angle", 4, 4, 1, true, qtraj_rotation_angle},
          {"pow", 1, 4, 4, false, pow}};
}

template <class Body>
void for_each_pair_function(Body&& body) {
  for (const PairFunction<double>& function : pair_functions(double())) body(function, double());
  for (const PairFunction<float>& function : pair_functions(float())) body(function, float());
}

TEST_CASE("C API: one row serves all, on either side", "[capi][algebra]") {
  for_each_pair_function([](const auto& function, auto zero) {
    using Real = decltype(zero);
    CAPTURE(function.name);
    for (const bool share_a : {true, false}) {
      if (!share_a && !function.b_has_count) continue;
      const size_t width = share_a ? function.a_width : function.b_width;
      std::vector<Real> a = good_rows<Real>(function.a_width, kRows, 1),
                        b = good_rows<Real>(function.b_width, kRows, 2);
      std::vector<Real>& shared = share_a ? a : b;
      for (size_t k = width; k < shared.size(); ++k) shared[k] = shared[k - width];
      std::vector<Real> expected(kRows * function.out_width), found(expected.size());
      size_t bad_index = 7;
      CHECK(function.call(a.data(), kRows, b.data(), kRows, kRows, expected.data(), nullptr) == QTRAJ_OK);
      CHECK(function.call(a.data(), share_a ? 1 : kRows, b.data(), share_a ? kRows : 1, kRows, found.data(),
                          &bad_index) == QTRAJ_OK);
      CHECK(bad_index == SIZE_MAX);
      CHECK(found == expected);
    }
  });
}

TEST_CASE("C API: a count that is neither 1 nor that of the call is COUNT, after NULL and before SIZE",
          "[capi][algebra][errors]") {
  for_each_pair_function([](const auto& function, auto zero) {
    using Real = decltype(zero);
    const std::vector<Real> a = good_rows<Real>(function.a_width, kRows, 1),
                            b = good_rows<Real>(function.b_width, kRows, 2);
    const std::vector<Real> untouched(kRows * function.out_width, Real(7));
    std::vector<Real> out = untouched;
    for (const size_t wrong : {size_t{0}, size_t{2}, kRows - 1, kRows + 1, SIZE_MAX}) {
      CAPTURE(function.name, wrong);
      size_t bad_index = 7;
      CHECK(function.call(a.data(), wrong, b.data(), kRows, kRows, out.data(), &bad_index) == QTRAJ_E_COUNT);
      CHECK(bad_index == SIZE_MAX);
      if (function.b_has_count)
        CHECK(function.call(a.data(), kRows, b.data(), wrong, kRows, out.data(), nullptr) == QTRAJ_E_COUNT);
      CHECK(function.call(a.data(), wrong, b.data(), kRows, kRows, nullptr, nullptr) == QTRAJ_E_NULL);
      CHECK(out == untouched);
    }
    // without rows the counts of the inputs may be 1 all the same
    CHECK(function.call(nullptr, 1, nullptr, 0, 0, nullptr, nullptr) == QTRAJ_OK);
  });
}

TEST_CASE("C API: a shared row at fault spoils every row, and is no place for the output", "[capi][algebra][errors]") {
  std::vector<double> a = good_rows<double>(4, kRows, 1), b = good_rows<double>(4, kRows, 2), q(4 * kRows);
  size_t bad_index = 7;
  CHECK(qtraj_multiply(a.data(), kRows, b.data(), 1, kRows, b.data(), &bad_index) == QTRAJ_E_OVERLAP);
  CHECK(qtraj_multiply(b.data(), 1, a.data(), kRows, kRows, b.data(), &bad_index) == QTRAJ_E_OVERLAP);
  CHECK(b == good_rows<double>(4, kRows, 2));
  // one row in all is the same rows
  CHECK(qtraj_multiply(a.data(), 1, b.data(), 1, 1, q.data(), &bad_index) == QTRAJ_OK);
  CHECK(qtraj_multiply(a.data(), 1, b.data(), 1, 1, b.data(), &bad_index) == QTRAJ_OK);
  CHECK(std::memcmp(b.data(), q.data(), 4 * sizeof(double)) == 0);
  // both inputs and the output one array: squares
  const std::vector<double> before = a;
  CHECK(qtraj_multiply(before.data(), kRows, before.data(), kRows, kRows, q.data(), nullptr) == QTRAJ_OK);
  CHECK(qtraj_multiply(a.data(), kRows, a.data(), kRows, kRows, a.data(), nullptr) == QTRAJ_OK);
  CHECK(a == q);

  b[2] = std::numeric_limits<double>::quiet_NaN();
  CHECK(qtraj_multiply(before.data(), kRows, b.data(), 1, kRows, q.data(), &bad_index) == QTRAJ_E_NOT_FINITE);
  CHECK(bad_index == 0);
  for (const double component : q) CHECK(std::isnan(component));
}

TEST_CASE("C API: unknown frames are OPTION, after SIZE and before OVERLAP", "[capi][derivatives][errors]") {
  const std::vector<double> q = good_rows<double>(4, kRows, 1), vectors = good_rows<double>(3, kRows, 2);
  std::vector<double> dq(4 * kRows, 7), ddq(dq), omega(3 * kRows, 7), alpha(omega);
  const std::vector<double> untouched_q = dq, untouched_rates = omega;
  for (const int32_t frame : {kUnknown[0], kUnknown[1], kUnknown[2], kUnknown[3], 0, 3}) {
    CAPTURE(frame);
    size_t bad_index = 7;
    const auto derivatives = [&](const double* q_wb, size_t count, double* second) {
      return qtraj_derivatives_from_rates(frame, q_wb, vectors.data(), vectors.data(), count, dq.data(), second,
                                          &bad_index);
    };
    const auto rates = [&](const double* q_wb, size_t count, double* second) {
      return qtraj_rates_from_derivatives(frame, q_wb, q.data(), q.data(), count, omega.data(), second, &bad_index);
    };
    CHECK(derivatives(q.data(), kRows, ddq.data()) == QTRAJ_E_VALUE);
    CHECK(bad_index == SIZE_MAX);
    CHECK(derivatives(q.data(), 0, ddq.data()) == QTRAJ_E_VALUE);
    CHECK(derivatives(nullptr, kRows, ddq.data()) == QTRAJ_E_NULL);
    CHECK(derivatives(q.data(), SIZE_MAX, ddq.data()) == QTRAJ_E_SIZE);
    CHECK(derivatives(q.data(), kRows, dq.data()) == QTRAJ_E_VALUE);
    bad_index = 7;
    CHECK(rates(q.data(), kRows, alpha.data()) == QTRAJ_E_VALUE);
    CHECK(bad_index == SIZE_MAX);
    CHECK(rates(q.data(), 0, alpha.data()) == QTRAJ_E_VALUE);
    CHECK(rates(nullptr, kRows, alpha.data()) == QTRAJ_E_NULL);
    CHECK(rates(q.data(), SIZE_MAX, alpha.data()) == QTRAJ_E_SIZE);
    CHECK(rates(q.data(), kRows, omega.data()) == QTRAJ_E_VALUE);
    CHECK((dq == untouched_q && ddq == untouched_q && omega == untouched_rates && alpha == untouched_rates));
  }
}

}  // namespace

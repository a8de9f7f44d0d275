// Functions from rows to rows and faulty arguments or rows: one rule at a time for all of them.
#include <cfloat>
#include <string>

#include "support/capi_floating.hpp"
#include "support/catch.hpp"
#include "support/row_functions.hpp"

namespace {

using namespace test;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
constexpr size_t kRows = 7;

template <class Real>
bool same_bits(const std::vector<Real>& a, const std::vector<Real>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Real)) == 0;
}

template <class Real>
bool is_nan_row(const std::vector<Real>& rows, size_t width, size_t row) {
  for (size_t k = 0; k < width; ++k)
    if (!std::isnan(rows[width * row + k])) return false;
  return true;
}

// All outputs are those expected, but for NaN in these rows.
template <class Real>
bool right_but_for(const RowFunction<Real>& function, const std::vector<std::vector<Real>>& out,
                   std::vector<std::vector<Real>> expected, const std::vector<size_t>& nan_rows) {
  for (size_t k = 0; k < out.size(); ++k) {
    std::vector<Real> found = out[k];
    for (const size_t row : nan_rows) {
      const size_t width = function.outputs[k];
      if (!is_nan_row(found, width, row)) return false;
      std::fill_n(&found[width * row], width, Real(0));
      std::fill_n(&expected[k][width * row], width, Real(0));
    }
    if (!same_bits(found, expected[k])) return false;
  }
  return true;
}

template <class Real>
RowArrays<Real> called(const RowFunction<Real>& function) {
  RowArrays<Real> arrays(function, kRows);
  size_t bad_index = 7;
  REQUIRE(arrays.call(function, kRows, &bad_index) == QTRAJ_OK);
  REQUIRE(bad_index == SIZE_MAX);
  REQUIRE(arrays.call(function, kRows, nullptr) == QTRAJ_OK);
  return arrays;
}

TEST_CASE("C API: of no rows the algebra is OK with NULL arrays", "[capi][algebra][errors]") {
  for_each_row_function([](const auto& function, auto zero) {
    using Real = decltype(zero);
    CAPTURE(function.name);
    const std::vector<const Real*> in(function.inputs.size());
    const std::vector<Real*> out(function.outputs.size());
    size_t bad_index = 7;
    CHECK(function.call(in.data(), 0, out.data(), &bad_index) == QTRAJ_OK);
    CHECK(bad_index == SIZE_MAX);
    RowArrays<Real> arrays(function, 1);
    const std::vector<std::vector<Real>> untouched = arrays.out;
    CHECK(arrays.call(function, 0, nullptr) == QTRAJ_OK);
    CHECK(arrays.out == untouched);
  });
}

TEST_CASE("C API: the algebra judges NULL before SIZE and then leaves outputs alone", "[capi][algebra][errors]") {
  for_each_row_function([](const auto& function, auto zero) {
    using Real = decltype(zero);
    CAPTURE(function.name);
    RowArrays<Real> arrays(function, kRows);
    const std::vector<std::vector<Real>> untouched = arrays.out;
    const auto check = [&](qtraj_status expected, const Real* const* in, size_t count, Real* const* out) {
      size_t bad_index = 7;
      CHECK(function.call(in, count, out, &bad_index) == expected);
      CHECK(bad_index == SIZE_MAX);
      CHECK(function.call(in, count, out, nullptr) == expected);
      CHECK(arrays.out == untouched);
    };
    for (const size_t count : {kRows, SIZE_MAX}) {
      for (size_t k = 0; k < function.inputs.size(); ++k) {
        std::vector<const Real*> in = arrays.inputs();
        in[k] = nullptr;
        check(QTRAJ_E_NULL, in.data(), count, arrays.outputs().data());
      }
      for (size_t k = 0; k < function.outputs.size(); ++k) {
        std::vector<Real*> out = arrays.outputs();
        out[k] = nullptr;
        check(QTRAJ_E_NULL, arrays.inputs().data(), count, out.data());
      }
    }
    size_t width = 0;
    for (const RowInput& input : function.inputs) width = std::max(width, input.width);
    for (const size_t output : function.outputs) width = std::max(width, output);
    const size_t most = PTRDIFF_MAX / (width * sizeof(Real));
    for (const size_t count : {SIZE_MAX, SIZE_MAX / 8, SIZE_MAX / (8 * width) + 2, most + 1})
      check(QTRAJ_E_SIZE, arrays.inputs().data(), count, arrays.outputs().data());
  });
}

TEST_CASE("C API: rows of the algebra at fault are NaN, all others right, the status that of the first",
          "[capi][algebra][errors]") {
  for_each_row_function([](const auto& function, auto zero) {
    using Real = decltype(zero);
    const RowArrays<Real> good = called(function);
    Real faults[4] = {Real(kNaN), Real(kInfinity), Real(-kInfinity), Real(0)};
    capi::set_signalling_nan(faults[3]);
    for (size_t k = 0; k < function.inputs.size(); ++k)
      for (size_t component = 0; component < function.inputs[k].width; ++component)
        for (const Real& fault : faults)
          for (const size_t row : {size_t{0}, size_t{3}, kRows - 1}) {
            CAPTURE(function.name, k, component, row);
            RowArrays<Real> arrays = good;
            std::memcpy(&arrays.in[k][function.inputs[k].width * row + component], &fault, sizeof fault);
            size_t bad_index = 7;
            CHECK(arrays.call(function, kRows, &bad_index) == QTRAJ_E_NOT_FINITE);
            CHECK(bad_index == row);
            CHECK(right_but_for(function, arrays.out, good.out, {row}));
          }
  });
}

TEST_CASE("C API: zero quaternions are ZERO_NORM where a norm is needed, after NOT_FINITE", "[capi][algebra][errors]") {
  for_each_row_function([](const auto& function, auto zero) {
    using Real = decltype(zero);
    const RowArrays<Real> good = called(function);
    for (size_t k = 0; k < function.inputs.size(); ++k) {
      const size_t width = function.inputs[k].width;
      if (width != 4) continue;
      CAPTURE(function.name, k);
      RowArrays<Real> arrays = good;
      std::fill_n(&arrays.in[k][4 * 2], 4, Real(0));
      arrays.in[k][4 * 2 + 1] = Real(-0.0);
      size_t bad_index = 7;
      const bool legal = !function.inputs[k].needs_norm;
      CHECK(arrays.call(function, kRows, &bad_index) == (legal ? QTRAJ_OK : QTRAJ_E_ZERO_NORM));
      CHECK(bad_index == (legal ? SIZE_MAX : 2));
      if (!legal) CHECK(right_but_for(function, arrays.out, good.out, {2}));

      // in the same row NOT_FINITE comes first, whichever input it is in; an earlier row before both
      const size_t last = function.inputs.size() - 1;
      arrays.in[last][function.inputs[last].width * 4] = Real(kNaN);
      if (last != k) arrays.in[last][function.inputs[last].width * 2] = Real(kInfinity);
      CHECK(arrays.call(function, kRows, &bad_index) == (last != k || legal ? QTRAJ_E_NOT_FINITE : QTRAJ_E_ZERO_NORM));
      CHECK(bad_index == (last == k && legal ? 4 : 2));
    }
  });
}

TEST_CASE("C API: the algebra works in place where rows have one length, and refuses any other overlap",
          "[capi][algebra][errors]") {
  for_each_row_function([](const auto& function, auto zero) {
    using Real = decltype(zero);
    const RowArrays<Real> good = called(function);
    for (size_t i = 0; i < function.inputs.size(); ++i)
      for (size_t o = 0; o < function.outputs.size(); ++o) {
        const size_t in_elements = kRows * function.inputs[i].width, out_elements = kRows * function.outputs[o];
        for (size_t shift = 0; shift <= in_elements + out_elements; ++shift) {
          CAPTURE(function.name, i, o, shift);
          // the output begins `shift` elements after a place just before the input
          std::vector<Real> block(in_elements + 2 * out_elements, Real(7));
          std::copy(good.in[i].begin(), good.in[i].end(), &block[out_elements]);
          const std::vector<Real> before = block;
          RowArrays<Real> arrays = good;
          std::vector<const Real*> in = arrays.inputs();
          std::vector<Real*> out = arrays.outputs();
          in[i] = &block[out_elements];
          out[o] = block.data() + shift;
          size_t bad_index = 7;
          const qtraj_status status = function.call(in.data(), kRows, out.data(), &bad_index);
          const bool same = shift == out_elements && function.inputs[i].width == function.outputs[o],
                     apart = shift == 0 || shift == in_elements + out_elements;
          CHECK(status == (same || apart ? QTRAJ_OK : QTRAJ_E_OVERLAP));
          CHECK(bad_index == SIZE_MAX);
          if (status == QTRAJ_OK)
            CHECK(std::memcmp(out[o], good.out[o].data(), out_elements * sizeof(Real)) == 0);
          else
            CHECK(same_bits(block, before));
        }
      }
    if (function.outputs.size() == 2) {
      RowArrays<Real> arrays = good;
      Real* out[2] = {arrays.out[0].data(), arrays.out[0].data()};
      CHECK(function.call(arrays.inputs().data(), kRows, out, nullptr) == QTRAJ_E_OVERLAP);
    }
  });
}

// Numbers of every kind, a third of them faulty if so asked.
template <class Real>
Real extreme(Random& random, bool finite) {
  using Limits = std::numeric_limits<Real>;
  const Real numbers[] = {Limits::max(), Limits::denorm_min(),
                          Limits::min(), Limits::epsilon(),
                          Real(1e-30),   Real(1e30),
                          Real(0),       Real(1),
                          Real(0.7),     Real(std::sqrt(static_cast<double>(Limits::max())))};
  const Real faults[] = {Limits::quiet_NaN(), Limits::infinity(), Limits::max(), Real(0), Real(0)};
  const Real number = !finite && random.uniform(0, 1) < 0.05 ? faults[static_cast<size_t>(random.uniform(0, 5))]
                                                             : numbers[static_cast<size_t>(random.uniform(0, 10))];
  return random.uniform(0, 1) < 0.5 ? -number : number;
}

TEST_CASE("C API: whatever the rows, the algebra raises nothing and statuses tell of every NaN",
          "[capi][algebra][floating]") {
  const std::string nothing = "nothing";
  for_each_row_function([&](const auto& function, auto zero) {
    using Real = decltype(zero);
    constexpr size_t kCount = 3000;
    for (const bool finite : {true, false}) {
      CAPTURE(function.name, finite);
      Random random(61);
      RowArrays<Real> arrays(function, kCount);
      for (size_t k = 0; k < arrays.in.size(); ++k)
        for (size_t row = 0; row < kCount; ++row) {
          Real* values = &arrays.in[k][function.inputs[k].width * row];
          // matrices are disturbed in one element, others all over
          for (size_t at = 0; at < function.inputs[k].width; ++at)
            if (function.inputs[k].width != 9 || at == row % 9) values[at] = extreme<Real>(random, finite);
          if (finite && function.inputs[k].needs_norm && values[0] == 0) values[0] = Real(1e-3);
        }
      if (!finite) capi::set_signalling_nan(arrays.in.back()[5]);
      qtraj_status status = QTRAJ_E_INTERNAL;
      size_t bad_index = 7, first_nan = SIZE_MAX, partly_nan = 0;
      CHECK(capi::disturbance([&] { status = arrays.call(function, kCount, &bad_index); }) == nothing);
      for (size_t k = 0; k < arrays.out.size(); ++k)
        for (size_t row = 0; row < kCount; ++row) {
          size_t faults = 0;
          for (size_t at = 0; at < function.outputs[k]; ++at)
            faults += !std::isfinite(arrays.out[k][function.outputs[k] * row + at]);
          if (faults > 0) first_nan = std::min(first_nan, row);
          partly_nan += faults > 0 && !is_nan_row(arrays.out[k], function.outputs[k], row);
        }
      CHECK(partly_nan == 0);
      if (status != QTRAJ_E_AMBIGUOUS) CHECK(bad_index == first_nan);
      CHECK((status == QTRAJ_OK) == (bad_index == SIZE_MAX));
      if (finite && !function.can_overflow) CHECK(first_nan == SIZE_MAX);
    }
  });
}

}  // namespace

// Continuous signs of series along any axis: as in arrays of one series after the other, whatever lies between.
#include <cfloat>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"

using namespace capi;

namespace {

qtraj_status make_continuous_strided(const double* q, size_t series, size_t series_stride, size_t length,
                                     size_t key_stride, double* out, size_t* flips, size_t* bad_index) {
  return qtraj_make_continuous_strided(q, series, series_stride, length, key_stride, out, flips, bad_index);
}
qtraj_status make_continuous_strided(const float* q, size_t series, size_t series_stride, size_t length,
                                     size_t key_stride, float* out, size_t* flips, size_t* bad_index) {
  return qtraj_make_continuous_strided_f32(q, series, series_stride, length, key_stride, out, flips, bad_index);
}

struct Layout {
  size_t series, series_stride, length, key_stride;

  size_t row(size_t of_series, size_t key) const { return of_series * series_stride + key * key_stride; }
  size_t extent() const { return row(series - 1, length - 1) + 1; }
};

// Series one after the other, of random signs, with faults in places and in runs.
template <class Real>
std::vector<Real> dirty_series(test::Random& random, size_t series, size_t length, double rate) {
  std::vector<Real> q;
  for (size_t of_series = 0; of_series < series; ++of_series) {
    test::Quaternion pose = random.orientation();
    int run = 0;
    for (size_t key = 0; key < length; ++key) {
      pose = test::multiply(pose, test::turn_within(random, 3.1));
      if (run == 0 && random.uniform(0, 1) < rate) run = static_cast<int>(random.uniform(1, 5));
      const double sign = random.uniform(-1, 1) < 0 ? -2 : 2;
      for (size_t k = 0; k < 4; ++k) {
        Real component = static_cast<Real>(sign * pose[k]);
        if (run > 0) component = run % 2 ? std::numeric_limits<Real>::infinity() : Real(0);
        q.push_back(component);
      }
      run = std::max(0, run - 1);
    }
  }
  return q;
}

template <class Real>
void check_layout(test::Random& random, const Layout& layout, double rate) {
  const std::vector<Real> q = dirty_series<Real>(random, layout.series, layout.length, rate);
  std::vector<Real> expected(q.size());
  size_t flips, bad_index;
  const qtraj_status status =
      make_continuous(q.data(), layout.series, layout.length, expected.data(), &flips, &bad_index);
  // between the keys stands what must not be touched
  std::vector<Real> spread(4 * layout.extent(), Real(7)), out(spread.size(), Real(9)), wanted = out,
                                                                                       wanted_in_place = spread;
  for (size_t s = 0; s < layout.series; ++s)
    for (size_t key = 0; key < layout.length; ++key)
      for (size_t k = 0; k < 4; ++k) {
        const size_t from = 4 * (s * layout.length + key) + k, to = 4 * layout.row(s, key) + k;
        spread[to] = q[from];
        wanted[to] = wanted_in_place[to] = expected[from];
      }
  size_t flips_found = 77, bad_found = 77;
  CHECK(make_continuous_strided(spread.data(), layout.series, layout.series_stride, layout.length, layout.key_stride,
                                out.data(), &flips_found, &bad_found) == status);
  CHECK((flips_found == flips && bad_found == bad_index));
  const auto same = [](const std::vector<Real>& a, const std::vector<Real>& b) {
    for (size_t k = 0; k < a.size(); ++k)
      if (!(std::isnan(a[k]) ? std::isnan(b[k]) : a[k] == b[k])) return false;
    return true;
  };
  CHECK(same(out, wanted));
  CHECK(make_continuous_strided(spread.data(), layout.series, layout.series_stride, layout.length, layout.key_stride,
                                spread.data(), nullptr, nullptr) == status);
  CHECK(same(spread, wanted_in_place));
}

TEST_CASE("C API: signs along any axis are made continuous as in series one after the other", "[capi][strided]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(111);
    for (const double rate : {0.0, 0.1, 0.6})
      for (const size_t series : {1u, 2u, 5u, 17u})
        for (const size_t length : {1u, 2u, 3u, 40u}) {
          CAPTURE(series, length, rate);
          check_layout<Real>(random, {series, length, length, 1}, rate);                // [series][length][4]
          check_layout<Real>(random, {series, 1, length, series}, rate);                // [length][series][4]
          check_layout<Real>(random, {series, length + 3, length, 1}, rate);            // rows between series
          check_layout<Real>(random, {series, 3 * length, length, 3}, rate);            // every third row
          check_layout<Real>(random, {series, 2, length, 2 * series + 1}, rate);        // every second column
          check_layout<Real>(random, {series, 2 * (length - 1) + 1, length, 2}, rate);  // as close as can be
        }
  });
}

TEST_CASE("C API: one series or one key needs no stride", "[capi][strided]") {
  double q[8] = {1, 0, 0, 0, -1, 0, 0, 0};
  size_t flips = 7;
  CHECK(qtraj_make_continuous_strided(q, 1, 0, 2, 1, q, &flips, nullptr) == QTRAJ_OK);
  CHECK((flips == 1 && q[4] == 1));
  CHECK(qtraj_make_continuous_strided(q, 2, 1, 1, 0, q, &flips, nullptr) == QTRAJ_OK);
  CHECK(flips == 0);
  CHECK(qtraj_make_continuous_strided(q, 1, 0, 1, 0, q, &flips, nullptr) == QTRAJ_OK);
  for (const size_t none : {0u, 3u}) {
    flips = 7;
    CHECK(qtraj_make_continuous_strided(nullptr, none, SIZE_MAX, 3 - none, SIZE_MAX, nullptr, &flips, nullptr) ==
          QTRAJ_OK);
    CHECK(flips == 0);
  }
}

TEST_CASE("C API: strides that are wrong are judged in order, and then outputs left alone", "[capi][strided][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    std::vector<Real> q(4 * 40, Real(1)), out(4 * 40, Real(7));
    const std::vector<Real> untouched = out;
    const auto status_of = [&](const Real* from, const Layout& at, Real* to, size_t* flips = nullptr) {
      size_t bad_index = 7;
      const qtraj_status status =
          make_continuous_strided(from, at.series, at.series_stride, at.length, at.key_stride, to, flips, &bad_index);
      if (status != QTRAJ_OK) CHECK(out == untouched);
      CHECK(bad_index == SIZE_MAX);
      return status;
    };
    const Layout columns = {3, 1, 4, 3}, shared = {3, 1, 4, 2};
    CHECK(status_of(nullptr, shared, out.data()) == QTRAJ_E_NULL);
    CHECK(status_of(q.data(), shared, nullptr) == QTRAJ_E_NULL);
    for (const Layout& huge :
         {Layout{2, SIZE_MAX, 2, 1}, Layout{SIZE_MAX, 2, 2, 1}, Layout{2, 1, 2, SIZE_MAX - 1},
          Layout{2, SIZE_MAX - 1, 2, 1}, Layout{2, SIZE_MAX / 2, 2, SIZE_MAX / 2 + 1},
          Layout{SIZE_MAX, 0, SIZE_MAX, SIZE_MAX}, Layout{2, size_t(PTRDIFF_MAX) / (4 * sizeof(Real)), 1, 0}})
      CHECK(status_of(q.data(), huge, out.data()) == QTRAJ_E_SIZE);
    for (const Layout& bad : {shared, Layout{3, 0, 4, 3}, Layout{3, 1, 4, 0}, Layout{3, 3, 4, 1}, Layout{1, 1, 4, 0},
                              Layout{3, 0, 1, 1}, Layout{2, 2, 3, 1}, Layout{2, 2, 3, 2}})
      CHECK(status_of(q.data(), bad, q.data()) == QTRAJ_E_VALUE);
    // 12 rows of 4: apart from row 12 on, and in place; nowhere between
    std::vector<Real> memory(4 * 40, Real(1));
    for (size_t at = 0; at <= 28; ++at) {
      CAPTURE(at);
      const bool is_fine = at == 14 || at + 12 <= 14 || at >= 26;
      CHECK(status_of(&memory[4 * 14], columns, &memory[4 * at]) == (is_fine ? QTRAJ_OK : QTRAJ_E_OVERLAP));
    }
    // flips in a row that no series has
    CHECK(status_of(q.data(), {2, 8, 3, 2}, out.data(), reinterpret_cast<size_t*>(&q[4])) == QTRAJ_E_OVERLAP);
  });
}

TEST_CASE("C API: signs along an axis are made continuous without raising anything", "[capi][strided][floating]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    std::vector<Real> q(4 * 12, std::numeric_limits<Real>::max());
    for (size_t k = 0; k < q.size(); k += 5) set_signalling_nan(q[k]);
    q[13] = std::numeric_limits<Real>::denorm_min();
    std::vector<Real> out(q.size());
    CHECK(std::string(disturbance([&] {
            (void)make_continuous_strided(q.data(), 3, 1, 4, 3, out.data(), nullptr, nullptr);
          })) == "nothing");
  });
}

}  // namespace

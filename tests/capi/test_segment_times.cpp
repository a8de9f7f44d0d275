// Times in every segment: knots as they are and once, even in between, in order.
#include <cfloat>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"

using namespace capi;

namespace {

Trajectory curve_through(const std::vector<double>& knots) {
  std::vector<double> q;
  for (size_t k = 0; k < knots.size(); ++k)
    for (const double component : test::about({0, 0, 1}, 0.1 * static_cast<double>(k % 7))) q.push_back(component);
  qtraj_trajectory* handle = nullptr;
  REQUIRE(qtraj_create(QTRAJ_SLERP, knots.data(), q.data(), knots.size(), &handle, nullptr) == QTRAJ_OK);
  return Trajectory(handle);
}

TEST_CASE("C API: times in every segment are even, in order, and hold each knot once", "[capi][segment_times]") {
  test::Random random(101);
  for (int repetition = 0; repetition < 300; ++repetition) {
    const auto count = static_cast<size_t>(random.uniform(2, 30)),
               per_segment = static_cast<size_t>(random.uniform(2, 40));
    std::vector<double> knots = {repetition % 2 ? 1.7e9 : random.uniform(-10, 10)};
    while (knots.size() < count) {
      // now and then of a few units in the last place
      const double least = std::nextafter(knots.back(), DBL_MAX) - knots.back();
      knots.push_back(knots.back() + std::max(3 * least, std::pow(10.0, random.uniform(-16, 3))));
    }
    const Trajectory curve = curve_through(knots);
    const size_t total = (count - 1) * (per_segment - 1) + 1;
    std::vector<double> times(total + 1, 7.0), even(per_segment);
    REQUIRE(qtraj_segment_times(curve.get(), per_segment, times.data()) == QTRAJ_OK);
    CHECK(times[total] == 7);
    for (size_t i = 0; i + 1 < total; ++i) REQUIRE(times[i] <= times[i + 1]);
    for (size_t key = 0; key < count; ++key) CHECK(times[key * (per_segment - 1)] == knots[key]);
    for (size_t segment = 0; segment + 1 < count; ++segment) {
      REQUIRE(qtraj_even_times(knots[segment], knots[segment + 1], per_segment, even.data()) == QTRAJ_OK);
      CHECK(std::equal(even.begin(), even.end(), times.begin() + static_cast<ptrdiff_t>(segment * (per_segment - 1))));
    }
    // all of them are inside
    std::vector<double> q(4 * total);
    CHECK(qtraj_sample(curve.get(), times.data(), total, q.data(), nullptr) == QTRAJ_OK);
  }
}

TEST_CASE("C API: two times a segment are the knots", "[capi][segment_times]") {
  const std::vector<double> knots = {-1e308, -1, 0, 5e-150, 3, 7e307};
  const Trajectory curve = curve_through(knots);
  std::vector<double> times(knots.size());
  CHECK(std::string(disturbance([&] { (void)qtraj_segment_times(curve.get(), 2, times.data()); })) == "nothing");
  CHECK(times == knots);
  times.resize(5 * 100 + 1);
  CHECK(std::string(disturbance([&] { (void)qtraj_segment_times(curve.get(), 101, times.data()); })) == "nothing");
  CHECK(std::is_sorted(times.begin(), times.end()));
}

TEST_CASE("C API: arguments of segment_times that are wrong write nothing", "[capi][segment_times][errors]") {
  const Trajectory curve = curve_through({0, 1, 2});
  double times[16];
  std::fill_n(times, 16, 7.0);
  uint64_t other[64] = {};
  const auto* no_curve = reinterpret_cast<const qtraj_trajectory*>(other);
  CHECK(qtraj_segment_times(nullptr, 1, times) == QTRAJ_E_NULL);
  CHECK(qtraj_segment_times(curve.get(), 1, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_segment_times(no_curve, 1, times) == QTRAJ_E_HANDLE);
  for (const size_t too_few : {0u, 1u}) CHECK(qtraj_segment_times(curve.get(), too_few, times) == QTRAJ_E_TOO_FEW);
  for (const size_t too_many : {SIZE_MAX, SIZE_MAX / 2 + 1, SIZE_MAX / 16 + 2, size_t(PTRDIFF_MAX) / 16 + 2})
    CHECK(qtraj_segment_times(curve.get(), too_many, times) == QTRAJ_E_SIZE);
  for (const double time : times) CHECK(time == 7);
}

}  // namespace

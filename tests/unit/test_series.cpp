// Many trajectories in one call, on every kernel: the bits of each sample alone, whatever stands beside it, and nothing
// outside the caller's arrays touched.
#include "support/guarded.hpp"
#include "support/kernel_curves.hpp"

namespace {

using test::Arrays;
using test::Guarded;
using test::KernelCurve;
using test::OwnRows;
using test::Request;

constexpr int32_t kLayouts[] = {QTRAJ_LAYOUT_SERIES_FIRST, QTRAJ_LAYOUT_TIME_FIRST};

qtraj_status sample_many(const std::vector<const qtraj_trajectory*>& rig, const Request& request, const double* times,
                         size_t count, int32_t layout, const Arrays<double>& to, size_t* bad_index) {
  return qtraj_sample_many(rig.data(), rig.size(), request.frame, times, count, layout, to.q, to.omega, to.alpha,
                           bad_index);
}
qtraj_status sample_many(const std::vector<const qtraj_trajectory*>& rig, const Request& request, const double* times,
                         size_t count, int32_t layout, const Arrays<float>& to, size_t* bad_index) {
  return qtraj_sample_many_f32(rig.data(), rig.size(), request.frame, times, count, layout, to.q, to.omega, to.alpha,
                               bad_index);
}

// Every kind and range, extrapolated or not, and one whose longer intervals are gaps.
std::vector<KernelCurve> all_curves() {
  std::vector<KernelCurve> curves = test::kernel_curves(QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE);
  for (KernelCurve& curve : test::kernel_curves(QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_ERROR))
    curves.push_back(std::move(curve));
  const capi::Options options = capi::make_options({"", QTRAJ_SLERP});
  REQUIRE(qtraj_options_set_longest_gap(options.get(), 1.0) == QTRAJ_OK);
  test::Random random(7);
  const test::Keys walk = test::random_walk(random, 20, 1.0, 0.2, 2.0);
  curves.push_back({"gaps", walk.times, capi::must_build(options.get(), capi::Keyframes<double>{walk.times, walk.q})});
  return curves;
}

struct Rig {
  const char* name;
  std::vector<const qtraj_trajectory*> curves;
};

// Runs of one kind of any length up to a few vectors, then all kinds in no order.
std::vector<Rig> rigs(const std::vector<KernelCurve>& curves) {
  std::vector<Rig> all(2);
  all[0].name = "alike", all[1].name = "mixed";
  size_t length = 1;
  for (const KernelCurve& curve : curves) {
    for (size_t k = 0; k < length; ++k) all[0].curves.push_back(curve.get());
    length = length % 35 + 2;
  }
  test::Random random(3);
  for (size_t k = 0; k < 150; ++k)
    all[1].curves.push_back(curves[static_cast<size_t>(random.uniform(0, static_cast<double>(curves.size())))].get());
  return all;
}

// In no order, a few in runs, some outside the knots or not finite.
std::vector<double> some_times(size_t count) {
  test::Random random(count);
  std::vector<double> times;
  for (size_t i = 0; i < count; ++i)
    times.push_back(i % 7 == 3 ? random.uniform(-50, 200) : -1.9 + 0.11 * static_cast<double>(i));
  if (count > 2) times[2] = std::numeric_limits<double>::quiet_NaN();
  if (count > 9) times[9] = -std::numeric_limits<double>::infinity();
  return times;
}

// Rows in the order of a layout, each sampled alone, and the outcome that belongs to them.
template <class Real>
struct Expected {
  OwnRows<Real> rows;
  qtraj_status status = QTRAJ_OK;
  size_t bad_index = SIZE_MAX;

  Expected(const Rig& rig, const Request& request, const std::vector<double>& times, int32_t layout)
      : rows(rig.curves.size() * times.size(), request) {
    const size_t series = rig.curves.size(), count = times.size();
    for (size_t row = 0; row < series * count; ++row) {
      const bool is_time_first = layout == QTRAJ_LAYOUT_TIME_FIRST;
      const size_t k = is_time_first ? row % series : row / count, i = is_time_first ? row / series : row % count;
      const qtraj_status one = sample(rig.curves[k], request, &times[i], 1, rows.arrays().from_row(row));
      if (one != QTRAJ_OK && status == QTRAJ_OK) status = one, bad_index = row;
    }
  }
};

// The outputs of a call between guard pages, against which they end.
template <class Real>
class GuardedRows {
 public:
  GuardedRows(const Request& request, size_t rows)
      : q_(4 * rows + 1), omega_(3 * rows + 1), alpha_(3 * rows + 1), rows_(rows) {
    for (Guarded<Real>* array : {&q_, &omega_, &alpha_}) array->fill(kFilling);
    arrays_ = {request.q ? q_.array(4 * rows, true) : nullptr, request.omega ? omega_.array(3 * rows, true) : nullptr,
               request.alpha ? alpha_.array(3 * rows, true) : nullptr};
  }
  const Arrays<Real>& arrays() const { return arrays_; }
  bool nothing_else_written() {
    return (!arrays_.q || q_.holds_around(arrays_.q, 4 * rows_, kFilling)) &&
           (!arrays_.omega || omega_.holds_around(arrays_.omega, 3 * rows_, kFilling)) &&
           (!arrays_.alpha || alpha_.holds_around(arrays_.alpha, 3 * rows_, kFilling));
  }

 private:
  static constexpr int kFilling = 0x5a;
  Guarded<Real> q_, omega_, alpha_;
  size_t rows_;
  Arrays<Real> arrays_;
};

template <class Real>
void check_rig(const Rig& rig, const Request& request, size_t count, int32_t layout) {
  CAPTURE(rig.name, rig.curves.size(), request.q, request.omega, request.alpha, count, layout);
  const std::vector<double> times = some_times(count);
  Expected<Real> expected(rig, request, times, layout);
  const size_t rows = rig.curves.size() * count;
  GuardedRows<Real> guarded(request, rows);
  size_t bad_index = 0, different = 0;
  CHECK(sample_many(rig.curves, request, times.data(), count, layout, guarded.arrays(), &bad_index) == expected.status);
  CHECK(bad_index == expected.bad_index);
  // NaN rows have one payload, so that they are compared like others
  for (size_t row = 0; row < rows; ++row) different += !same_row(guarded.arrays(), expected.rows.arrays(), row);
  CHECK(different == 0);
  CHECK(guarded.nothing_else_written());
}

}  // namespace

TEST_CASE("many trajectories in one call give the bits of each sample alone, in both layouts", "[series][bits]") {
  const std::vector<KernelCurve> curves = all_curves();
  test::for_every_kernel([&](const char*) {
    for (const Rig& rig : rigs(curves))
      for (const Request& request : test::kRequests)
        for (const int32_t layout : kLayouts)
          for (const size_t count : {size_t{1}, size_t{3}, size_t{15}, size_t{16}, size_t{40}}) {
            check_rig<double>(rig, request, count, layout);
            check_rig<float>(rig, request, count, layout);
          }
  });
}

TEST_CASE("a rig of any size gives the bits of each sample alone", "[series][bits]") {
  const std::vector<KernelCurve> curves = all_curves();
  test::for_every_kernel([&](const char*) {
    for (const size_t kind : {size_t{0}, size_t{2}, size_t{8}})
      for (size_t size = 1; size <= 70; ++size) {
        const Rig rig = {curves[kind].name.c_str(), std::vector<const qtraj_trajectory*>(size, curves[kind].get())};
        check_rig<double>(rig, test::kRequests[0], 1, QTRAJ_LAYOUT_TIME_FIRST);
        check_rig<float>(rig, test::kRequests[1], 2, QTRAJ_LAYOUT_SERIES_FIRST);
      }
  });
}

TEST_CASE("times of any number give the bits of each sample alone where all trajectories at a time are neighbours",
          "[series][bits]") {
  const std::vector<KernelCurve> curves = all_curves();
  const Rig pair = {"pair", {curves[0].get(), curves[4].get()}}, one = {"one", {curves[2].get()}};
  test::for_every_kernel([&](const char*) {
    for (size_t count = 12; count < 300; count += count < 40 ? 1 : 37)
      for (const Rig* rig : {&pair, &one}) {
        check_rig<double>(*rig, test::kRequests[2], count, QTRAJ_LAYOUT_TIME_FIRST);
        check_rig<float>(*rig, test::kRequests[0], count, QTRAJ_LAYOUT_TIME_FIRST);
      }
  });
}

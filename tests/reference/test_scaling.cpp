// Construction takes time and memory in proportion to the number of keys, for every method.
#include <algorithm>
#include <cstdio>
#include <ctime>

#include "support/curve.hpp"

namespace {

using test::Curve;
using test::Keys;
using test::Quaternion;
using test::Random;
using test::Variant;

constexpr size_t kFew = 10000, kMany = 1000000;

// The same few orientations again and again, on uneven knots; the last is the first, for closed curves. All are near to
// each other: LOG_SPLINE closes only curves that do not wind.
Keys tour(size_t count) {
  Random random(21);
  const Quaternion centre = random.orientation();
  std::vector<Quaternion> orientations;
  for (int i = 0; i < 64; ++i) orientations.push_back(test::multiply(centre, test::turn_within(random, 0.6)));
  Keys keys;
  keys.times.reserve(count);
  keys.q.reserve(4 * count);
  double time = 0;
  for (size_t key = 0; key < count; ++key) {
    keys.add(time, orientations[key + 1 == count ? 0 : key % orientations.size()]);
    time += 0.5 + static_cast<double>(key % 7) / 8.0;
  }
  return keys;
}

// What a constructor takes besides its options, in arrays that are ready to be passed.
struct Input {
  Keys keys;
  std::vector<double> rates;  // small ones; serve as omega, alpha and tangents

  explicit Input(size_t count) : keys(tour(count)), rates(4 * count) {
    for (size_t i = 0; i < rates.size(); ++i) rates[i] = 0.1 * (static_cast<double>(i % 5) - 2.0);
  }
};

class Options {
 public:
  explicit Options(const Variant& variant) : handle_(test::make_options(variant.settings)) {
    const double omega[] = {0.1, -0.2, 0.3};
    if (variant.needs_end_rates())
      REQUIRE(qtraj_options_set_end_rates(handle_, QTRAJ_FRAME_BODY, omega, omega) == QTRAJ_OK);
  }
  Options(const Options&) = delete;
  Options& operator=(const Options&) = delete;
  ~Options() { qtraj_options_destroy(handle_); }
  const qtraj_options* get() const { return handle_; }

 private:
  qtraj_options* handle_;
};

size_t bytes_for(const Variant& variant, size_t count) {
  size_t bytes = 0;
  REQUIRE(qtraj_init_size(Options(variant).get(), count, &bytes) == QTRAJ_OK);
  return bytes;
}

double bytes_per_key(const Variant& variant, size_t count) {
  return static_cast<double>(bytes_for(variant, count)) / static_cast<double>(count);
}

// Processor time of one construction, s: not the time of day, so that other processes are not counted. The memory is
// there already: taking a page from the system costs more than the keys of NLERP that it holds, and malloc asks it for
// large blocks only.
double construction_time(const Variant& variant, const Options& options, const Input& input,
                         std::vector<double>& memory) {
  const double *omega = variant.needs_omega() ? input.rates.data() : nullptr,
               *alpha = variant.needs_alpha() ? input.rates.data() : nullptr;
  qtraj_trajectory* handle = nullptr;
  const std::clock_t start = std::clock();
  const Keys& keys = input.keys;
  const size_t bytes = memory.size() * sizeof(double);
  const qtraj_status status =
      variant.needs_tangents()
          ? qtraj_init_with_tangents(memory.data(), bytes, options.get(), keys.times.data(), keys.q.data(),
                                     input.rates.data(), nullptr, keys.count(), &handle, nullptr)
          : qtraj_init(memory.data(), bytes, options.get(), QTRAJ_FRAME_BODY, keys.times.data(), keys.q.data(), omega,
                       alpha, nullptr, keys.count(), &handle, nullptr);
  const std::clock_t end = std::clock();
  qtraj_destroy(handle);
  REQUIRE(status == QTRAJ_OK);
  return static_cast<double>(end - start) / CLOCKS_PER_SEC;
}

struct Times {
  double few, many;  // a key, s

  double ratio() const { return many / few; }
};

// Least times a key of interleaved repetitions: what disturbs a run, such as other processes' use of the caches and of
// the memory, only adds to it. They go on while the ratio is above `enough`, until so many are done and so much time is
// spent that a disturbance of less than seconds is over; of a real fault no repetition makes less.
Times times_per_key(const Variant& variant, const Input& few, const Input& many, double enough) {
  constexpr int kLeastRepetitions = 3, kMostRepetitions = 100;
  constexpr double kPatience = 10.0;  // s of processor time
  const Options options(variant);
  std::vector<double> memory(bytes_for(variant, kMany) / sizeof(double) + 1);
  Times least = {1e300, 1e300};
  double spent = 0;
  for (int repetition = 0; repetition < kMostRepetitions; ++repetition) {
    for (int i = 0; i < 10; ++i) {
      const double time = construction_time(variant, options, few, memory);
      least.few = std::min(least.few, time / kFew);
      spent += time;
    }
    const double time = construction_time(variant, options, many, memory);
    least.many = std::min(least.many, time / kMany);
    spent += time;
    if (least.ratio() <= enough) break;
    if (repetition + 1 >= kLeastRepetitions && spent > kPatience) break;
  }
  return least;
}

// One variant of each way to construct: other end conditions and tangent rules only change what is put into rows.
std::vector<Variant> ways_to_construct() {
  std::vector<Variant> ways;
  for (const Variant& variant : test::all_variants()) {
    const int32_t end = variant.settings.end;
    if (variant.settings.tangents == QTRAJ_TANGENT_MEAN_VELOCITY) continue;
    if (variant.settings.reference == QTRAJ_REFERENCE_GIVEN) continue;
    if (end == QTRAJ_END_CHORD || end == QTRAJ_END_GIVEN || end == QTRAJ_END_NATURAL) continue;
    ways.push_back(variant);
  }
  return ways;
}

}  // namespace

TEST_CASE("the time a constructor takes for a key does not grow with the number of keys", "[scaling]") {
  // many keys lie in memory, few in the cache, which makes up to 2.6; growth with the square would make 100
  constexpr double kAllowed = 3.0;
  const Input few(kFew), many(kMany);
  std::printf("\nconstruction: ns a key at %zu keys, at %zu, ratio; bytes a key\n", kFew, kMany);
  for (const Variant& variant : ways_to_construct()) {
    const Times times = times_per_key(variant, few, many, kAllowed);
    std::printf("%-32s %6.0f %6.0f %5.2f %6.1f\n", variant.name.c_str(), 1e9 * times.few, 1e9 * times.many,
                times.ratio(), bytes_per_key(variant, kMany));
    CAPTURE(variant.name, times.few, times.many);
    CHECK(times.ratio() <= kAllowed);
  }
}

TEST_CASE("the memory a constructor takes for a key does not depend on the number of keys", "[scaling]") {
  for (const Variant& variant : ways_to_construct()) {
    CAPTURE(variant.name);
    const double at_thousand = bytes_per_key(variant, 1000);
    for (const size_t count : {size_t(10000), size_t(65537), size_t(1000000), size_t(123456789)}) {
      CAPTURE(count, at_thousand, bytes_per_key(variant, count));
      CHECK(std::abs(bytes_per_key(variant, count) / at_thousand - 1.0) <= 0.05);
    }
  }
}

namespace {

// Times of `count` keys: in order, with every hundredth one wild, or in no order.
enum class Order { rising, wild, none };
std::vector<double> stamps(size_t count, Order order) {
  Random random(22);
  std::vector<double> times;
  for (size_t key = 0; key < count; ++key) {
    const double draw = random.uniform(0, 1);
    const bool is_wild = order == Order::none || (order == Order::wild && draw < 0.01);
    times.push_back(is_wild ? random.uniform(0, 1e9) : static_cast<double>(key));
  }
  return times;
}

// Least processor time of repeated checks, a key, s.
double check_time_per_key(const std::vector<double>& times, const std::vector<double>& q, int repetitions) {
  std::vector<int32_t> statuses(times.size());
  double least = 1e300;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    const std::clock_t start = std::clock();
    (void)qtraj_check_keys(times.data(), q.data(), times.size(), statuses.data(), nullptr, nullptr);
    least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least / static_cast<double>(times.size());
}

}  // namespace

TEST_CASE("the time check_keys takes for a key does not grow with the number of keys, in whatever order", "[scaling]") {
  // in no order every key takes two searches, which grow as the logarithm
  constexpr double kAllowed = 3.0;
  const std::vector<double> few = tour(kFew).q, many = tour(kMany).q;
  for (const Order order : {Order::rising, Order::wild, Order::none}) {
    const std::vector<double> few_times = stamps(kFew, order), many_times = stamps(kMany, order);
    double ratio = 1e300;
    for (int attempt = 0; attempt < 5 && ratio > kAllowed; ++attempt)
      ratio = std::min(ratio, check_time_per_key(many_times, many, 2) / check_time_per_key(few_times, few, 50));
    std::printf("check_keys, order %d: ratio %.2f\n", static_cast<int>(order), ratio);
    CHECK(ratio <= kAllowed);
  }
}

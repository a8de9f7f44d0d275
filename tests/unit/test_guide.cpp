// The guide finds the segment that a search over all knots finds, for any spacing and in any rounding mode.
#include <cfenv>
#include <cmath>
#include <string>
#include <vector>

#include "curve/knot_lookup.hpp"
#include "support/catch.hpp"
#include "support/kernel_curves.hpp"
#include "support/random.hpp"

namespace {

struct Knots {
  std::string name;
  std::vector<double> times;
};

Knots spaced(const std::string& name, size_t count, double start, double (*gap)(test::Random&, size_t)) {
  test::Random random(count);
  Knots knots = {name + " " + std::to_string(count), {start}};
  while (knots.times.size() < count) knots.times.push_back(knots.times.back() + gap(random, knots.times.size()));
  return knots;
}

std::vector<Knots> all_knots() {
  std::vector<Knots> all;
  for (const size_t count : {2u, 3u, 4u, 5u, 8u, 9u, 17u, 100u, 1000u, 1025u}) {
    all.push_back(spaced("uniform", count, 0.0, [](test::Random&, size_t) { return 0.1; }));
    all.push_back(spaced("uniform, negative", count, -1e4, [](test::Random&, size_t) { return 1.0 / 3.0; }));
    all.push_back(spaced("random", count, 3.0, [](test::Random& r, size_t) { return r.uniform(0.01, 2.0); }));
    all.push_back(
        spaced("seconds since 1970", count, 1.7e9, [](test::Random& r, size_t) { return r.uniform(1e-3, 1); }));
    all.push_back(spaced("geometric, six decades", count, -1.0, [](test::Random&, size_t i) {
      return 1e-3 * std::pow(10.0, 6.0 * static_cast<double>(i % 200) / 199.0);
    }));
    all.push_back(spaced("six decades at random", count, 7.0,
                         [](test::Random& r, size_t) { return std::pow(10.0, r.uniform(-4.0, 2.0)); }));
    // the guide can tell nothing about these: nearly all fall into one bucket
    all.push_back(spaced("clustered", count, 0.0, [](test::Random&, size_t i) { return i % 500 == 2 ? 1e6 : 1e-3; }));
    all.push_back(spaced("tiny", count, 0.0, [](test::Random& r, size_t) { return r.uniform(1e-150, 2e-150); }));
  }
  all.push_back({"as long as double can tell", {-8e307, -1e300, 0, 1, 1e307, 8e307}});
  return all;
}

// Knots, their neighbours, and times between, all within the knots.
std::vector<double> probes(const std::vector<double>& knots) {
  test::Random random(1);
  std::vector<double> times;
  const auto add = [&](double time) {
    if (time >= knots.front() && time <= knots.back()) times.push_back(time);
  };
  for (size_t i = 0; i < knots.size(); ++i) {
    add(std::nextafter(knots[i], -INFINITY));
    add(knots[i]);
    add(std::nextafter(knots[i], INFINITY));
    if (i > 0) add(knots[i - 1] + random.uniform(0.0, 1.0) * (knots[i] - knots[i - 1]));
    const double u = random.uniform(0.0, 1.0);
    add((1 - u) * knots.front() + u * knots.back());
  }
  return times;
}

size_t by_upper_bound(const std::vector<double>& knots, double time) {
  const auto above = std::upper_bound(knots.begin(), knots.end(), time);
  return std::min<size_t>(static_cast<size_t>(above - knots.begin()), knots.size() - 1) - 1;
}

// A guide whose array is followed by entries that would be noticed.
struct OwnGuide {
  std::vector<uint64_t> first_candidate;
  qtraj::KnotIndex index;

  explicit OwnGuide(const std::vector<double>& knots)
      : first_candidate(qtraj::Guide::entries(knots.size()) + 2, UINT64_MAX) {
    double scale;
    size_t candidates;
    qtraj::build_guide(knots.data(), knots.size(), first_candidate.data(), scale, candidates);
    index = {knots.data(), knots.size() - 1, {first_candidate.data(), knots[0], scale, candidates}};
  }
};

constexpr size_t kNoGuess = SIZE_MAX;

}  // namespace

TEST_CASE("the guide finds the segment that starts at or last before a time", "[guide]") {
  for (const Knots& knots : all_knots()) {
    CAPTURE(knots.name);
    const OwnGuide guide(knots.times);
    size_t wrong = 0;
    for (const double time : probes(knots.times)) {
      const size_t expected = by_upper_bound(knots.times, time);
      for (const size_t guess : {kNoGuess, size_t{0}, expected, expected - 1, expected + 1, knots.times.size() - 2})
        if (qtraj::find_segment(guide.index, time, guess) != expected) ++wrong;
    }
    CHECK(wrong == 0);
  }
}

// n candidates take log2 n steps, rounded up.
TEST_CASE("a guide leaves no more candidates than there are segments, and few where knots are even", "[guide]") {
  for (const Knots& knots : all_knots()) {
    CAPTURE(knots.name);
    const OwnGuide guide(knots.times);
    CHECK(guide.index.guide.candidates >= 1);
    CHECK(guide.index.guide.candidates <= knots.times.size() - 1);
    if (knots.name.rfind("uniform", 0) == 0) CHECK(guide.index.guide.candidates <= 2);
  }
}

TEST_CASE("a guide writes its entries, each of segments, none before the last, and nothing else", "[guide]") {
  for (const Knots& knots : all_knots()) {
    CAPTURE(knots.name);
    const OwnGuide guide(knots.times);
    const size_t entries = qtraj::Guide::entries(knots.times.size());
    const auto end = guide.first_candidate.begin() + static_cast<ptrdiff_t>(entries);
    CHECK(std::is_sorted(guide.first_candidate.begin(), end));
    CHECK(guide.first_candidate[entries - 1] + guide.index.guide.candidates <= knots.times.size() - 1);
    CHECK(std::all_of(end, guide.first_candidate.end(), [](uint64_t entry) { return entry == UINT64_MAX; }));
  }
}

TEST_CASE("the guide is exact in every rounding mode, whichever it was built in", "[guide][floating]") {
  constexpr int kModes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  for (const Knots& knots : all_knots()) {
    const std::vector<double> times = probes(knots.times);
    for (const int built_in : kModes)
      for (const int used_in : kModes) {
        std::fesetround(built_in);
        const OwnGuide guide(knots.times);
        std::fesetround(used_in);
        size_t wrong = 0, past_the_end = 0;
        for (const double time : times) {
          if (bucket_of(guide.index.guide, time) >= qtraj::Guide::entries(knots.times.size())) {
            ++past_the_end;
            continue;
          }
          if (qtraj::find_segment(guide.index, time, kNoGuess) != by_upper_bound(knots.times, time)) ++wrong;
        }
        std::fesetround(FE_TONEAREST);
        CAPTURE(knots.name, built_in, used_in);
        CHECK(past_the_end == 0);
        CHECK(wrong == 0);
      }
  }
}

TEST_CASE("vectors of times in no order find the segments that each time alone finds", "[guide][batch]") {
  test::Random random(5);
  for (const Knots& knots : all_knots()) {
    std::vector<double> q, times = probes(knots.times);
    for (size_t key = 0; key < knots.times.size(); ++key)
      for (const double component : random.orientation()) q.push_back(component);
    for (size_t i = times.size(); i-- > 1;)
      std::swap(times[i], times[static_cast<size_t>(random.uniform(0, static_cast<double>(i)))]);
    const capi::Trajectory trajectory =
        capi::must_build<double>(capi::make_options({"", QTRAJ_SLERP}).get(), {knots.times, q});
    test::for_every_kernel([&](const char*) {
      CAPTURE(knots.name);
      const test::Request& request = test::kRequests[0];
      test::OwnRows<double> rows(times.size(), request);
      test::OwnRows<double> expected = test::one_by_one<double>(trajectory.get(), request, times);
      CHECK(sample(trajectory.get(), request, times.data(), times.size(), rows.arrays()) == QTRAJ_OK);
      size_t wrong = 0;
      for (size_t row = 0; row < times.size(); ++row) wrong += !same_row(rows.arrays(), expected.arrays(), row);
      CHECK(wrong == 0);
    });
  }
}

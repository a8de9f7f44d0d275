// Curves pass through their keys, within rounding errors of what a segment turns.
#include <algorithm>
#include <cfloat>

#include "support/capi_variants.hpp"

using namespace capi;

namespace {

// Random attitudes at intervals up to `ratio` apart; given rates, if any, differ as much.
Keyframes<double> ragged_keys(test::Random& random, double decades) {
  Keyframes<double> keys;
  double time = 0;
  const auto count = static_cast<int>(random.uniform(3, 11));
  for (int key = 0; key < count; ++key) {
    keys.times.push_back(time);
    for (const double component : random.orientation()) keys.q.push_back(component);
    time += std::pow(10.0, random.uniform(-decades, 0));
  }
  return keys;
}

Rates<double> ragged_rates(test::Random& random, const Variant& variant, size_t count, double decades) {
  Rates<double> rates = rates_for<double>(variant, count);
  for (std::vector<double>* rows : {&rates.omega, &rates.alpha})
    for (double& component : *rows) component = random.uniform(-1, 1) * std::pow(10.0, random.uniform(0, decades / 2));
  return rates;
}

// The largest of 1 and, at the ends of the segment, |h omega| and, where it is given, |h^2 alpha|.
double turn_of(const std::vector<double>& times, const Motion<double>& motion, size_t segment, bool with_alpha) {
  const double h = times[segment + 1] - times[segment];
  double turn = 1;
  for (size_t row = 3 * segment; row < 3 * segment + 6; row += 3) {
    double omega = 0, alpha = 0;
    for (size_t k = row; k < row + 3; ++k) {
      omega += motion.omega[k] * motion.omega[k];
      alpha += motion.alpha[k] * motion.alpha[k];
    }
    turn = std::max({turn, h * std::sqrt(omega), with_alpha ? h * h * std::sqrt(alpha) : 0.0});
  }
  return turn;
}

}  // namespace

TEST_CASE("C API: curves pass through their keys to 4 eps, quintics to 32, of the turn of a segment", "[capi]") {
  for (const Variant& variant : variants())
    for (const double decades : {0.5, 3.0, 8.0}) {
      test::Random random(41);
      const bool is_quintic = !rates_for<double>(variant, 2).alpha.empty();
      double worst = 0, missed = 0;
      int built = 0;
      for (int round = 0; round < 400; ++round) {
        Keyframes<double> keys = ragged_keys(random, decades);
        if (variant.end == QTRAJ_END_PERIODIC) std::copy_n(keys.q.begin(), 4, keys.q.end() - 4);
        const Rates<double> rates = ragged_rates(random, variant, keys.count(), decades);
        // the rates wind the segments: as turns they would move the keys' signs
        const Options options = make_options(variant);
        REQUIRE(qtraj_options_set_turns(options.get(), QTRAJ_TURNS_SHORTEST) == QTRAJ_OK);
        const Built curve = build(options.get(), keys, rates);
        if (curve.status != QTRAJ_OK) continue;
        ++built;
        const size_t count = keys.count();
        std::vector<double> used(4 * count);
        REQUIRE(qtraj_keys(curve.trajectory.get(), nullptr, used.data()) == QTRAJ_OK);
        const Motion<double> motion = must_sample_rates<double>(curve.trajectory.get(), QTRAJ_FRAME_BODY, keys.times);
        for (size_t key = 0; key < count; ++key) {
          double miss = 0;
          for (size_t k = 4 * key; k < 4 * key + 4; ++k) miss = std::max(miss, std::abs(motion.q[k] - used[k]));
          worst = std::max(worst, miss / turn_of(keys.times, motion, std::min(key, count - 2), is_quintic));
          missed = std::max(missed, miss);
        }
      }
      CAPTURE(variant.name, decades, built, worst / DBL_EPSILON, missed);
      CHECK(built > 100);
      CHECK(worst <= (is_quintic ? 32 : 5) * DBL_EPSILON);
    }
}

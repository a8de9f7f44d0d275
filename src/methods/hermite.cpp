// The builder of HERMITE.
#include "math/so3.hpp"
#include "methods/key_rates.hpp"
#include "methods/method.hpp"
#include "methods/polynomials.hpp"
#include "methods/turns.hpp"

namespace qtraj {

// HERMITE: q_i exp(r/2), r the cubic with r(0) = 0, r(h) = R_i = 2 log(q_i* q_{i+1}) and the given body rates w at both
// ends: r'(0) = w_i, r'(h) = Jr^-1(R_i) w_{i+1}. A step with whole turns has another base (methods/turns.hpp) and both
// ends of that form. rate_too_fast with a key's index where |h w| exceeds 2^500.
Outcome build_hermite(Construction& construction) {
  constexpr double kLimit = 0x1p500;
  const Keyframes& keys = construction.keys;
  auto* segments = static_cast<RotationVectorSegment<3>*>(construction.segments);
  double bound = 0;
  for (size_t i = 0; i < keys.segments(); ++i) {
    const double h = keys.step(i);
    Vector3 start, end;
    if (!given_scaled_omega(construction, i, h, kLimit, start)) return {Status::rate_too_fast, i};
    if (!given_scaled_omega(construction, i + 1, h, kLimit, end)) return {Status::rate_too_fast, i + 1};
    const StepRates rates = {{start, end}, {Vector3::Zero(), Vector3::Zero()}};
    Step step;
    const Outcome outcome = take_step(construction, i, &rates, step);
    if (outcome.status != Status::ok) return outcome;
    const Chart chart = chart_of(keys[i], step);
    const EndValues<Vector3> p = {{0.5 * chart.start, 0.5 * chart.end},
                                  {0.5 * first_derivative(chart.start, start), 0.5 * first_derivative(chart.end, end)},
                                  {}};
    bound = std::max(bound, set_cubic(chart.base, h, p, segments[i]));
    if (i == 0) construction.omega_start = start / h;
    construction.omega_end = end / h;
  }
  construction.range = range_of(bound);
  return {};
}

}  // namespace qtraj

// The builder of HERMITE.
#include "math/so3.hpp"
#include "methods/key_rates.hpp"
#include "methods/method.hpp"
#include "methods/polynomials.hpp"
#include "methods/turns.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

constexpr RowKernel<HermiteRows> kHermiteKernels[] = QTRAJ_OF_EACH_TARGET(hermite);

constexpr double kLimit = 0x1p500;

// The segments that the kernel sets from `first` on; not that to a key that a period adds, whose rate is in another
// row. Returns how many.
size_t set_many(const Construction& construction, size_t first, RotationVectorSegment<3>* segments, double& bound) {
  const KeyframeInput& input = construction.input;
  const Turns rule = construction.options.turns;
  if (rule == Turns::given) return 0;
  const bool is_world = construction.rate_frame == Frame::world;
  return kHermiteKernels[target()](
      {construction.keys.arrays(), input.omega, is_world, rule == Turns::from_rates, input.epsilon(), segments, &bound},
      first, input.count - 1);
}

}  // namespace

// HERMITE: q_i exp(r/2), r the cubic with r(0) = 0, r(h) = R_i = 2 log(q_i* q_{i+1}) and the given body rates w at both
// ends: r'(0) = w_i, r'(h) = Jr^-1(R_i) w_{i+1}. A step with whole turns has another base (methods/turns.hpp) and both
// ends of that form. rate_too_fast with a key's index where |h w| exceeds 2^500.
Outcome build_hermite(Construction& construction) {
  const Keyframes& keys = construction.keys;
  auto* segments = static_cast<RotationVectorSegment<3>*>(construction.segments);
  double bound = 0;
  for (size_t i = 0; i < keys.segments(); ++i) {
    i += set_many(construction, i, segments, bound);
    if (i == keys.segments()) break;
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
  }
  construction.set_end_rates([&](size_t key, size_t segment) {
    const double h = keys.step(segment);
    Vector3 scaled;
    given_scaled_omega(construction, key, h, kLimit, scaled);
    return Vector3(scaled / h);
  });
  construction.range = range_of(bound);
  return {};
}

}  // namespace qtraj

// What constructors leave behind is the same to the last bit, with every kernel, as what the core makes of one segment
// after the other, which is what the scalar target does.
#include <cstring>
#include <vector>

#include "methods/build.hpp"
#include "support/catch.hpp"
#include "support/forced_kernel.hpp"
#include "support/random.hpp"

namespace {

using qtraj::Status;

constexpr size_t kCounts[] = {2, 3, 4, 5, 8, 9, 10, 16, 17, 33, 100};

// What makes segments that kernels leave to the core, one in a few, and segments that they do not.
enum class Walk { plain, rests, half_turns, far_times, fast, tiny_steps };
constexpr Walk kWalks[] = {Walk::plain, Walk::rests, Walk::half_turns, Walk::far_times, Walk::fast, Walk::tiny_steps};

struct Recording {
  std::vector<double> times, q, omega;
  std::vector<float> q_f32, omega_f32;

  Recording(size_t count, Walk walk) {
    test::Random random(count);
    test::Quaternion key = random.orientation();
    double time = random.uniform(-5, 5);
    for (size_t i = 0; i < count; ++i) {
      const bool special = random.uniform(0, 4) < 1;
      double angle = random.uniform(0, walk == Walk::tiny_steps ? 1e-9 : 1.0), step = random.uniform(0.05, 0.15);
      if (special && walk == Walk::rests) angle = 0;
      if (special && walk == Walk::half_turns) angle = 3.141592653589793;
      if (special && walk == Walk::far_times) step *= i % 2 == 0 ? 1e70 : 1e-5;
      const double rate = special && walk == Walk::fast ? 100.0 : 3.0, norm = i % 3 == 0 ? -1.0 : 1.0 + 1e-7;
      key = test::multiply(key, test::about(random.direction(), angle));
      times.push_back(time += step);
      for (const double component : key) q.push_back(norm * component);
      for (const double component : random.direction()) omega.push_back(rate * component);
    }
    q_f32.assign(q.begin(), q.end());
    omega_f32.assign(omega.begin(), omega.end());
  }

  qtraj::KeyframeInput input(bool is_float, bool has_rates) const {
    const size_t count = times.size();
    qtraj::KeyframeInput input = {times.data(), qtraj::input<4>(q.data(), count), {}, {}, nullptr, count};
    if (is_float) input.q_wb = qtraj::input<4>(q_f32.data(), count);
    if (has_rates && is_float) input.omega = qtraj::input<3>(omega_f32.data(), count);
    if (has_rates && !is_float) input.omega = qtraj::input<3>(omega.data(), count);
    return input;
  }
};

// Outcome and handle.
struct Built {
  qtraj::Outcome outcome;
  std::vector<char> handle;

  Built(const qtraj::Options& options, const qtraj::KeyframeInput& input, qtraj::Frame frame) {
    qtraj::CurveSize size;
    REQUIRE(qtraj::trajectory_size(options, input.count, size));
    std::vector<double> memory(size.handle / sizeof(double)), workspace(size.workspace / sizeof(double));
    qtraj::Trajectory* built = nullptr;
    outcome = qtraj::build_trajectory(options, input, frame, memory.data(), workspace.data(), &built);
    const char* bytes = reinterpret_cast<const char*>(memory.data());
    if (outcome.status == Status::ok) handle.assign(bytes, bytes + size.handle);
  }

  bool operator==(const Built& other) const {
    return outcome.status == other.outcome.status && outcome.index == other.outcome.index && handle == other.handle;
  }
};

Built with_target(const char* target, const qtraj::Options& options, const qtraj::KeyframeInput& input,
                  qtraj::Frame frame) {
  const test::ForcedKernel forced(target);
  REQUIRE(forced.runs_here());
  return Built(options, input, frame);
}

// Every kernel against the scalar target, over all recordings.
void check(const qtraj::Options& options, bool has_rates) {
  for (const char* target : test::target_names()) {
    if (!test::ForcedKernel(target).runs_here()) continue;
    for (const Walk walk : kWalks)
      for (const size_t count : kCounts)
        for (const bool is_float : {false, true}) {
          CAPTURE(target, static_cast<int>(walk), count, is_float);
          const Recording recording(count, walk);
          const qtraj::KeyframeInput input = recording.input(is_float, has_rates);
          const qtraj::Frame frame = count % 2 == 0 ? qtraj::Frame::body : qtraj::Frame::world;
          CHECK(with_target(target, options, input, frame) == with_target("scalar plain", options, input, frame));
        }
  }
}

qtraj::Options options_of(int32_t method) {
  qtraj::Options options;
  REQUIRE(qtraj::Options::make(static_cast<qtraj::Method>(method), options) == Status::ok);
  return options;
}

}  // namespace

TEST_CASE("SLERP is constructed as segment by segment, with every kernel", "[construction]") {
  qtraj::Options options = options_of(QTRAJ_SLERP);
  check(options, false);
  REQUIRE(options.set_extrapolation(qtraj::Extrapolate::constant_rate, qtraj::Extrapolate::constant_rate) ==
          Status::ok);
  check(options, false);
}

TEST_CASE("SQUAD is constructed as segment by segment, with every kernel", "[construction]") {
  for (const qtraj::Tangent rule : {qtraj::Tangent::catmull_rom, qtraj::Tangent::mean_velocity}) {
    qtraj::Options options = options_of(QTRAJ_SQUAD);
    REQUIRE(options.set_tangents(rule) == Status::ok);
    check(options, false);
  }
  qtraj::Options given = options_of(QTRAJ_SQUAD);
  REQUIRE(given.set_tangents(qtraj::Tangent::given) == Status::ok);
  check(given, true);
}

TEST_CASE("HERMITE is constructed as segment by segment, with every kernel", "[construction]") {
  for (const qtraj::Turns rule : {qtraj::Turns::from_rates, qtraj::Turns::shortest, qtraj::Turns::as_given}) {
    qtraj::Options options = options_of(QTRAJ_HERMITE);
    REQUIRE(options.set_turns(rule) == Status::ok);
    check(options, true);
    // a closing key has its rate in another row
    REQUIRE(options.set_period(1e90) == Status::ok);
    check(options, true);
  }
}

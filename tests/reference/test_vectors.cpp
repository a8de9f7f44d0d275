// Samples against values computed at 60 digits; accuracy as the README promises it.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>

#include "support/derivative.hpp"
#include "support/vector_file.hpp"

namespace {

using test::Keys;
using test::Quaternion;
using test::Trajectory;
using test::Vector;
using test::VectorFile;

// The trajectory a file describes.
Trajectory trajectory_of(const VectorFile& file) {
  const std::map<std::string, int32_t> methods = {{"slerp", QTRAJ_SLERP},
                                                  {"nlerp", QTRAJ_NLERP},
                                                  {"squad", QTRAJ_SQUAD},
                                                  {"logspline", QTRAJ_LOG_SPLINE},
                                                  {"hermite", QTRAJ_HERMITE},
                                                  {"spline", QTRAJ_ROTATION_SPLINE},
                                                  {"rotquintic", QTRAJ_ROTATION_QUINTIC},
                                                  {"quintic", QTRAJ_QUATERNION_QUINTIC}};
  const std::map<std::string, int32_t> ends = {{"chord", QTRAJ_END_CHORD},
                                               {"natural", QTRAJ_END_NATURAL},
                                               {"estimated", QTRAJ_END_ESTIMATED},
                                               {"given", QTRAJ_END_GIVEN}};
  test::Settings settings{};
  settings.method = methods.at(file.method);
  std::vector<double> end_rates;
  for (const auto& [option, values] : file.options) {
    if (option == "boundary") settings.end = ends.at(values.at(0));
    if (option == "tangents")
      settings.tangents = values.at(0) == "catmull_rom" ? QTRAJ_TANGENT_CATMULL_ROM : QTRAJ_TANGENT_MEAN_VELOCITY;
    if (option == "end_rates_body")
      for (const std::string& value : values) end_rates.push_back(std::stod(value));
  }
  qtraj_options* options = test::make_options(settings);
  if (!end_rates.empty())
    REQUIRE(qtraj_options_set_end_rates(options, QTRAJ_FRAME_BODY, &end_rates.at(0), &end_rates.at(3)) == QTRAJ_OK);
  qtraj_trajectory* handle = nullptr;
  const double *times = file.keys.times.data(), *q = file.keys.q.data();
  if (file.omega_world.empty()) {
    CHECK(qtraj_create_with_options(options, times, q, file.keys.count(), &handle, nullptr) == QTRAJ_OK);
  } else {
    const double* alpha = file.method == "hermite" ? nullptr : file.alpha_world.data();
    CHECK(qtraj_create_with_rates(options, QTRAJ_FRAME_WORLD, times, q, file.omega_world.data(), alpha,
                                  file.keys.count(), &handle, nullptr) == QTRAJ_OK);
  }
  qtraj_options_destroy(options);
  return Trajectory(handle);
}

// Rotation angle from key to key, the shorter way.
double step_angle(const Keys& keys, size_t key) {
  const Quaternion a = keys.orientation(key), b = keys.orientation(key + 1);
  double difference = 0, sum = 0;
  for (size_t k = 0; k < 4; ++k) {
    difference += (b[k] - a[k]) * (b[k] - a[k]);
    sum += (b[k] + a[k]) * (b[k] + a[k]);
  }
  return 4.0 * std::atan2(std::sqrt(std::min(difference, sum)), std::sqrt(std::max(difference, sum)));
}

double length_at(const std::vector<double>& vectors, size_t row) {
  return std::sqrt(vectors[3 * row] * vectors[3 * row] + vectors[3 * row + 1] * vectors[3 * row + 1] +
                   vectors[3 * row + 2] * vectors[3 * row + 2]);
}

// Largest rotation angle that a method's exponent takes, rad: from the first key for LOG_SPLINE, else within a segment,
// where a cubic leaves the chord by up to 4/27 of each of its end slopes.
double exponent_angle(const VectorFile& file, const Trajectory& trajectory) {
  const Keys keys = trajectory.keys();
  const std::vector<double> omega = trajectory.sample_rates(QTRAJ_FRAME_BODY, keys.times).omega;
  double largest = 0, turned = 0;
  for (size_t key = 0; key + 1 < keys.count(); ++key) {
    const double step = step_angle(keys, key), h = keys.times[key + 1] - keys.times[key];
    turned += step;  // at least the angle from the first key; equal to it for turns about one axis
    const double bulge =
        file.method == "spline" ? 4.0 / 27.0 * h * (length_at(omega, key) + length_at(omega, key + 1)) : 0.0;
    largest = std::max(largest, file.method == "logspline" ? turned : step + bulge);
  }
  return largest;
}

// How much a change of the rotation vectors at the keys can grow in the natural cubic spline through them: the largest
// sum over t of its cardinal functions. Taken from the spline through a small turn about x at one key at a time.
double natural_spline_growth(const Keys& keys, const std::vector<double>& times) {
  constexpr double kTurn = 1e-6;
  const test::Settings settings = {QTRAJ_LOG_SPLINE, QTRAJ_END_NATURAL, 0, QTRAJ_REFERENCE_GIVEN, {1, 0, 0, 0}};
  std::vector<double> sums(times.size(), 0.0);
  for (size_t turned = 0; turned < keys.count(); ++turned) {
    Keys cardinal;
    for (size_t key = 0; key < keys.count(); ++key)
      cardinal.add(keys.times[key], test::about({1, 0, 0}, key == turned ? kTurn : 0.0));
    const std::vector<double> q = Trajectory(settings, cardinal).sample(times);
    for (size_t i = 0; i < times.size(); ++i) sums[i] += std::abs(2.0 * std::asin(q[4 * i + 1])) / kTurn;
  }
  return *std::max_element(sums.begin(), sums.end());
}

// Accuracy as the README promises it: of q, and of rates relative to the scales below.
struct Bound {
  double q, q_f32, rates;
};
Bound accuracy(const VectorFile& file, const Trajectory& trajectory) {
  if (file.method == "slerp" || file.method == "nlerp") return {4e-16, 2.5e-7, 1e-13};
  if (file.method == "quintic") return {4e-16, 2.2e-7, 1e-13};  // S/n of the promise is at least 1
  const double factor = 1.0 + exponent_angle(file, trajectory);
  const double growth =
      file.name == "logspline_wild" ? natural_spline_growth(trajectory.keys(), file.sample_times()) : 1.0;
  return {4e-16 * factor * growth, 3e-7 * factor, 1e-13 * growth};
}

// Scales of the errors: the largest |omega|, and the larger of the largest |alpha| and |omega|/h.
struct Scales {
  double omega, alpha;
};
Scales scales_of(const VectorFile& file) {
  Scales scales = {0, 0};
  for (const VectorFile::Sample& sample : file.samples) {
    size_t segment = 0;
    while (segment + 2 < file.keys.count() && file.keys.times[segment + 1] <= sample.time) ++segment;
    const double h = file.keys.times[segment + 1] - file.keys.times[segment];
    const double speed = test::length(sample.omega_world);
    scales.omega = std::max(scales.omega, speed);
    scales.alpha = std::max({scales.alpha, test::length(sample.alpha_world), speed / h});
  }
  return scales;
}

struct RateErrors {
  double omega, alpha;
};
template <class Motion>
RateErrors rate_errors(const VectorFile& file, const Motion& motion) {
  RateErrors worst = {0, 0};
  for (size_t i = 0; i < file.samples.size(); ++i) {
    Vector omega, alpha;
    for (size_t k = 0; k < 3; ++k) {
      omega[k] = static_cast<double>(motion.omega[3 * i + k]);
      alpha[k] = static_cast<double>(motion.alpha[3 * i + k]);
    }
    worst.omega = std::max(worst.omega, test::distance(omega, file.samples[i].omega_world));
    worst.alpha = std::max(worst.alpha, test::distance(alpha, file.samples[i].alpha_world));
  }
  return worst;
}

template <class Real>
double worst_error(const VectorFile& file, const std::vector<Real>& q) {
  double worst = 0;
  for (size_t i = 0; i < file.samples.size(); ++i)
    for (size_t k = 0; k < 4; ++k)
      worst = std::max(worst, std::abs(static_cast<double>(q[4 * i + k]) - file.samples[i].q[k]));
  return worst;
}

template <class Real>
bool same_bits(const std::vector<Real>& a, const std::vector<Real>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Real)) == 0;
}

}  // namespace

TEST_CASE("samples agree with 60-digit values", "[vectors]") {
  for (const std::string& name : test::vector_files()) {
    const VectorFile file = test::read_vector_file(name);
    const Trajectory trajectory = trajectory_of(file);
    const Bound bound = accuracy(file, trajectory);
    CAPTURE(name, bound.q, bound.q_f32);
    CHECK(worst_error(file, trajectory.sample(file.sample_times())) <= bound.q);
    CHECK(worst_error(file, trajectory.sample_f32(file.sample_times())) <= bound.q_f32);
  }
}

TEST_CASE("rates agree with 60-digit values", "[vectors][rates]") {
  for (const std::string& name : test::vector_files()) {
    const VectorFile file = test::read_vector_file(name);
    const Trajectory trajectory = trajectory_of(file);
    const Bound bound = accuracy(file, trajectory);
    const Scales scales = scales_of(file);
    const RateErrors error = rate_errors(file, trajectory.sample_rates(QTRAJ_FRAME_WORLD, file.sample_times()));
    const RateErrors error_f32 = rate_errors(file, trajectory.sample_rates_f32(QTRAJ_FRAME_WORLD, file.sample_times()));
    CAPTURE(name, bound.rates);
    CHECK(error.omega <= bound.rates * scales.omega);
    CHECK(error.alpha <= bound.rates * scales.alpha);
    CHECK(error_f32.omega <= 1e-5 * scales.omega);
    CHECK(error_f32.alpha <= 1e-5 * scales.alpha);
  }
}

TEST_CASE("rates in the body frame are those in the world frame, turned, and q is that of sample", "[vectors][rates]") {
  for (const std::string& name : test::vector_files()) {
    const VectorFile file = test::read_vector_file(name);
    const Trajectory trajectory = trajectory_of(file);
    const std::vector<double> times = file.sample_times();
    const auto body = trajectory.sample_rates(QTRAJ_FRAME_BODY, times);
    const auto world = trajectory.sample_rates(QTRAJ_FRAME_WORLD, times);
    const Scales scales = scales_of(file);
    CAPTURE(name);
    CHECK(same_bits(body.q, trajectory.sample(times)));
    CHECK(same_bits(trajectory.sample_rates_f32(QTRAJ_FRAME_BODY, times).q, trajectory.sample_f32(times)));
    for (size_t i = 0; i < times.size(); ++i) {
      const Quaternion q = {body.q[4 * i], body.q[4 * i + 1], body.q[4 * i + 2], body.q[4 * i + 3]};
      const auto turned = [&](const std::vector<double>& v) {
        return test::rotate(q, {v[3 * i], v[3 * i + 1], v[3 * i + 2]});
      };
      const auto row = [&](const std::vector<double>& v) { return Vector{v[3 * i], v[3 * i + 1], v[3 * i + 2]}; };
      CHECK(test::distance(turned(body.omega), row(world.omega)) <= 4e-15 * scales.omega);
      CHECK(test::distance(turned(body.alpha), row(world.alpha)) <= 4e-15 * scales.alpha);
    }
  }
}

TEST_CASE("a time gives the same bits in any order and from every function", "[vectors][bits]") {
  for (const std::string& name : test::vector_files()) {
    const VectorFile file = test::read_vector_file(name);
    const Trajectory trajectory = trajectory_of(file);
    const std::vector<double> times = file.sample_times();
    const std::vector<double> q = trajectory.sample(times);
    const std::vector<float> q_f32 = trajectory.sample_f32(times);
    CAPTURE(name);

    std::vector<size_t> order(times.size());
    std::iota(order.begin(), order.end(), size_t{0});
    test::Random random(7);
    for (size_t i = order.size(); i-- > 1;)
      std::swap(order[i], order[static_cast<size_t>(random.uniform(0, static_cast<double>(i + 1)))]);
    std::vector<double> shuffled_times, expected;
    std::vector<float> expected_f32;
    for (const size_t i : order) {
      shuffled_times.push_back(times[i]);
      expected.insert(expected.end(), &q[4 * i], &q[4 * i] + 4);
      expected_f32.insert(expected_f32.end(), &q_f32[4 * i], &q_f32[4 * i] + 4);
    }
    CHECK(same_bits(trajectory.sample(shuffled_times), expected));
    CHECK(same_bits(trajectory.sample_f32(shuffled_times), expected_f32));

    std::vector<double> one_by_one(4 * times.size());
    std::vector<float> one_by_one_f32(4 * times.size());
    size_t cursor = 0, cursor_f32 = 0;
    for (size_t i = 0; i < times.size(); ++i) {
      CHECK(qtraj_sample_at(trajectory.get(), times[i], &cursor, &one_by_one[4 * i]) == QTRAJ_OK);
      CHECK(qtraj_sample_at_f32(trajectory.get(), times[i], &cursor_f32, &one_by_one_f32[4 * i]) == QTRAJ_OK);
    }
    CHECK(same_bits(one_by_one, q));
    CHECK(same_bits(one_by_one_f32, q_f32));
  }
}

TEST_CASE("uniform sampling gives the bits of sampling the same times", "[vectors][bits]") {
  for (const std::string& name : test::vector_files()) {
    const VectorFile file = test::read_vector_file(name);
    const Trajectory trajectory = trajectory_of(file);
    constexpr size_t kCount = 100;
    const double start = file.keys.times.front(), step = (file.keys.times.back() - start) / kCount;
    std::vector<double> times(kCount), q(4 * kCount);
    std::vector<float> q_f32(4 * kCount);
    for (size_t i = 0; i < kCount; ++i) times[i] = start + static_cast<double>(i) * step;
    REQUIRE(qtraj_sample_uniform(trajectory.get(), start, step, kCount, q.data(), nullptr) == QTRAJ_OK);
    REQUIRE(qtraj_sample_uniform_f32(trajectory.get(), start, step, kCount, q_f32.data(), nullptr) == QTRAJ_OK);
    CAPTURE(name);
    CHECK(same_bits(q, trajectory.sample(times)));
    CHECK(same_bits(q_f32, trajectory.sample_f32(times)));
  }
}

TEST_CASE("no reference file is left out", "[vectors]") {
  const std::vector<std::string> names = test::vector_files();
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(QTRAJ_REFERENCE_DIR)) {
    const std::string name = entry.path().stem().string();
    const std::set<std::string> of_other_tests = {"means", "unnormalized",  "turns",
                                                  "screw", "vector_curves", "quaternion_hermite"};
    if (entry.path().extension() != ".txt" || of_other_tests.count(name) == 1) continue;
    CAPTURE(name);
    CHECK(std::count(names.begin(), names.end(), name) == 1);
    ++files;
  }
  CHECK(files == names.size());
}

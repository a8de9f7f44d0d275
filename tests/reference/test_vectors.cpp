// Samples against values computed at 60 digits; accuracy as the README promises it.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <numeric>

#include "support/trajectory.hpp"
#include "support/vector_file.hpp"

namespace {

using test::Keys;
using test::Quaternion;
using test::Trajectory;
using test::VectorFile;

test::Settings settings_of(const VectorFile& file) {
  test::Settings settings{};
  if (file.method == "slerp") settings.method = QTRAJ_SLERP;
  if (file.method == "nlerp") settings.method = QTRAJ_NLERP;
  if (file.method == "squad") settings.method = QTRAJ_SQUAD;
  if (file.method == "logspline") settings.method = QTRAJ_LOG_SPLINE;
  for (const auto& [option, value] : file.options) {
    if (option == "tangents" && value == "catmull_rom") settings.tangents = QTRAJ_TANGENT_CATMULL_ROM;
    if (option == "tangents" && value == "mean_velocity") settings.tangents = QTRAJ_TANGENT_MEAN_VELOCITY;
    if (option == "boundary" && value == "natural") settings.end = QTRAJ_END_NATURAL;
  }
  return settings;
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

// Largest rotation angle that a method's exponent takes at the keys, rad: between neighbours, or from the first key.
double exponent_angle(const VectorFile& file, const Keys& keys) {
  double largest = 0, turned = 0;
  for (size_t key = 0; key + 1 < keys.count(); ++key) {
    const double step = step_angle(keys, key);
    turned += step;  // at least the angle from the first key; equal to it for turns about one axis
    largest = std::max(largest, file.method == "logspline" ? turned : step);
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

struct Bound {
  double f64, f32;
};
Bound accuracy(const VectorFile& file, const Keys& keys) {
  if (file.method == "slerp" || file.method == "nlerp") return {4e-16, 2.5e-7};
  const double factor = 1.0 + exponent_angle(file, keys);
  const double growth = file.name == "logspline_wild" ? natural_spline_growth(keys, file.sample_times()) : 1.0;
  return {4e-16 * factor * growth, 3e-7 * factor};
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

std::vector<std::string> all_files() {
  std::vector<std::string> names;
  for (const char* method : {"slerp", "nlerp", "squad", "logspline"})
    for (const std::string& name : test::vector_files(method)) names.push_back(name);
  return names;
}

}  // namespace

TEST_CASE("samples agree with 60-digit values", "[vectors]") {
  for (const std::string& name : all_files()) {
    const VectorFile file = test::read_vector_file(name);
    const Trajectory trajectory(settings_of(file), file.keys);
    const Bound bound = accuracy(file, trajectory.keys());
    CAPTURE(name, bound.f64, bound.f32);
    CHECK(worst_error(file, trajectory.sample(file.sample_times())) <= bound.f64);
    CHECK(worst_error(file, trajectory.sample_f32(file.sample_times())) <= bound.f32);
  }
}

TEST_CASE("keys of float lead to the same curve to their rounding", "[vectors][f32]") {
  for (const std::string& name : all_files()) {
    if (name.find("wild") != std::string::npos) continue;  // amplifies the rounding of its keys
    const VectorFile file = test::read_vector_file(name);
    const std::vector<float> q(file.keys.q.begin(), file.keys.q.end());
    qtraj_trajectory* handle = nullptr;
    qtraj_options* options = test::make_options(settings_of(file));
    REQUIRE(qtraj_create_with_f32(options, file.keys.times.data(), q.data(), file.keys.count(), &handle, nullptr) ==
            QTRAJ_OK);
    qtraj_options_destroy(options);
    const Trajectory trajectory(handle);
    const double factor = 1.0 + exponent_angle(file, trajectory.keys());
    CAPTURE(name);
    CHECK(worst_error(file, trajectory.sample(file.sample_times())) <= 4e-7 * factor);
  }
}

TEST_CASE("a time gives the same bits in any order and from every function", "[vectors][bits]") {
  for (const std::string& name : all_files()) {
    const VectorFile file = test::read_vector_file(name);
    const Trajectory trajectory(settings_of(file), file.keys);
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
  for (const std::string& name : all_files()) {
    const VectorFile file = test::read_vector_file(name);
    const Trajectory trajectory(settings_of(file), file.keys);
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
  const std::vector<std::string> names = all_files();
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(QTRAJ_REFERENCE_DIR)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".txt" || name == "means") continue;
    CAPTURE(name);
    CHECK(std::count(names.begin(), names.end(), name) == 1);
    ++files;
  }
  CHECK(files == names.size());
}

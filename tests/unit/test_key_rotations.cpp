// Keyframes made ready and the rotations between them are what each alone gives, in every kernel.
#include <cmath>
#include <cstring>
#include <vector>

#include "methods/key_rotations.hpp"
#include "support/catch.hpp"
#include "support/forced_kernel.hpp"
#include "support/guarded.hpp"
#include "support/random.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

constexpr RowKernel<JacobianRecords> kJacobianKernels[] = QTRAJ_OF_EACH_TARGET(jacobians);

}  // namespace
}  // namespace qtraj

namespace {

using qtraj::Quaternion;
using qtraj::Status;
using qtraj::UnitQuaternion;
using qtraj::Vector3;

constexpr size_t kCounts[] = {1, 2, 3, 9, 63, 64, 65, 66, 127, 128, 129, 300};

template <class Real>
constexpr int kTinyExponents[] = {-430, -515, -1000, -1008, -1016, -1030, -1040};
template <>
constexpr int kTinyExponents<float>[] = {-30, -40, -60, -75, -100, -120, -140};

// Keys of which one in `rare` is of a magnitude that vectors do not do, some a hair or half a turn from the one before.
template <class Real>
std::vector<Real> walk(size_t count, int rare) {
  test::Random random(count);
  constexpr double kTiny = sizeof(Real) == 4 ? 1e-30 : 1e-300;
  std::vector<Real> q;
  test::Quaternion key = random.orientation();
  for (size_t i = 0; i < count; ++i) {
    const double angle = i % 7 == 0 ? 0 : i % 7 == 1 ? 1e-9 : i % 7 == 2 ? 3.14159 : random.uniform(0, 6);
    key = test::multiply(key, test::about(random.direction(), angle));
    double scale = random.uniform(0.1, 3) * (i % 3 == 0 ? -1 : 1);
    if (random.uniform(0, rare) < 1) scale *= i % 2 == 0 ? kTiny : 1 / kTiny;
    for (const double component : key) q.push_back(static_cast<Real>(scale * component));
    // a component beside which products have errors that are no numbers any more
    if (random.uniform(0, rare) < 1)
      q[4 * i + i % 4] *= static_cast<Real>(std::ldexp(1.0, kTinyExponents<Real>[i % 7]));
  }
  return q;
}

struct Cleaned {
  std::vector<double> times, q, error;
  qtraj::KeyframeReport report;
  qtraj::Outcome outcome;
  qtraj::Keyframes keys;

  template <class Real>
  explicit Cleaned(const std::vector<Real>& given) : Cleaned(given.data(), given.size() / 4) {}
  template <class Real>
  Cleaned(const Real* given, size_t count) : q(4 * count), error(4 * count) {
    std::vector<double> knots;
    for (size_t i = 0; i < count; ++i) knots.push_back(static_cast<double>(i));
    times.resize(count);
    keys = {times.data(), reinterpret_cast<double(*)[4]>(q.data()), reinterpret_cast<double(*)[4]>(error.data()),
            count};
    const Real* none = nullptr;
    const qtraj::KeyframeInput input = {knots.data(),
                                        qtraj::input<4>(given, count),
                                        qtraj::input<3>(none, count),
                                        qtraj::input<3>(none, count),
                                        nullptr,
                                        count};
    outcome = qtraj::clean_keyframes(input, false, keys, report);
  }
};

bool same_bits(const void* a, const void* b, size_t bytes) { return std::memcmp(a, b, bytes) == 0; }
bool same_bits(const Vector3& a, const Vector3& b) { return same_bits(a.data(), b.data(), sizeof(double[3])); }

template <class Real>
void check_cleaned(const std::vector<Real>& given) {
  const Cleaned cleaned(given);
  REQUIRE(cleaned.outcome.status == Status::ok);
  size_t wrong = 0, flips = 0;
  double worst_norm_error = 0, least_dot = 1;
  Quaternion before;
  for (size_t key = 0; key < cleaned.times.size(); ++key) {
    const Quaternion q = Eigen::Matrix<Real, 4, 1>(&given[4 * key]).template cast<double>();
    qtraj::Normalized expected = qtraj::normalize(q);
    worst_norm_error = std::max(worst_norm_error, std::abs(expected.norm - 1.0));
    if (key > 0 && qtraj::dot(before, expected.unit.value) < 0) expected.unit = qtraj::negate(expected.unit), ++flips;
    if (key > 0) least_dot = std::min(least_dot, qtraj::dot(before, expected.unit.value));
    before = expected.unit.value;
    wrong += !same_bits(&cleaned.q[4 * key], before.data(), sizeof(double[4]));
    wrong += !same_bits(&cleaned.error[4 * key], expected.unit.error.data(), sizeof(double[4]));
  }
  CHECK(wrong == 0);
  CHECK(cleaned.report.sign_flips == flips);
  CHECK(cleaned.report.worst_norm_error == worst_norm_error);
  CHECK(cleaned.report.least_dot == least_dot);
}

template <class Real>
void check_guarded(size_t count) {
  test::Guarded<Real> memory(4 * 300);
  const std::vector<Real> keys = walk<Real>(count, 50);
  for (const bool at_end : {true, false}) {
    memory.protect(PROT_READ | PROT_WRITE);
    Real* given = memory.array(keys.size(), at_end);
    std::copy(keys.begin(), keys.end(), given);
    memory.protect(PROT_READ);
    const Cleaned cleaned(given, count), expected(keys);
    CHECK(same_bits(cleaned.q.data(), expected.q.data(), keys.size() * sizeof(double)));
  }
}

template <class Check>
void for_every_kernel_and_walk(const Check& check) {
  for (const char* target : test::target_names()) {
    const test::ForcedKernel forced(target);
    if (!forced.runs_here()) continue;
    for (const size_t count : kCounts)
      for (const int rare : {1, 3, 50, 1000000}) {
        CAPTURE(target, count, rare);
        check(count, rare);
      }
  }
}

}  // namespace

TEST_CASE("each key is cleaned as it is alone, in every kernel", "[keyframes]") {
  for_every_kernel_and_walk([](size_t count, int rare) {
    check_cleaned(walk<double>(count, rare));
    check_cleaned(walk<float>(count, rare));
  });
}

TEST_CASE("constructors read nothing beside the caller's keys, in every kernel", "[keyframes]") {
  for_every_kernel_and_walk([](size_t count, int) {
    check_guarded<double>(count);
    check_guarded<float>(count);
  });
}

TEST_CASE("the first key at fault is found wherever it stands, in every kernel", "[keyframes]") {
  for_every_kernel_and_walk([](size_t count, int rare) {
    for (const size_t at : {size_t{0}, count / 2, count - 1}) {
      std::vector<double> q = walk<double>(count, rare);
      q[4 * (count - 1) + 2] = std::nan("");
      for (size_t k = 0; k < 4; ++k) q[4 * at + k] = 0;
      const Cleaned cleaned(q);
      CHECK(cleaned.outcome.status == Status::zero_norm);
      CHECK(cleaned.outcome.index == at);
    }
  });
}

TEST_CASE("rotations between keys are those of each pair, in every kernel", "[so3]") {
  for_every_kernel_and_walk([](size_t count, int rare) {
    const Cleaned cleaned(walk<double>(count, rare));
    const qtraj::Keyframes& keys = cleaned.keys;
    size_t wrong = 0, logs = 0, rotations = 0;
    qtraj::for_each_log(keys, [&](size_t segment, const Vector3& log) {
      wrong += segment != logs++ || !same_bits(log, qtraj::relative_log(keys[segment], keys[segment + 1]));
    });
    const UnitQuaternion from = keys[count / 2];
    qtraj::for_each_rotation(from, keys, [&](size_t key, const qtraj::RelativeRotation& rotation) {
      const qtraj::RelativeRotation expected = qtraj::relative_rotation(from, keys[key]);
      wrong += key != rotations++ || !same_bits(rotation.sin_part, expected.sin_part);
      wrong += rotation.angle != expected.angle;
    });
    CHECK(wrong == 0);
    CHECK(logs == count - 1);
    CHECK(rotations == count);
  });
}

TEST_CASE("Jacobians are those of each rotation, in every kernel, up to half a turn", "[so3]") {
  struct Record {
    double before, r[3], jacobian[9], turning[3], after;
  };
  constexpr size_t kStride = sizeof(Record) / sizeof(double);
  for_every_kernel_and_walk([](size_t count, int rare) {
    test::Random random(count);
    std::vector<Record> records(count);
    for (Record& record : records) {
      const bool is_far = random.uniform(0, rare) < 1;
      const double angle = is_far                       ? random.uniform(3.1415, 6)
                           : random.uniform(0, 1) < 0.1 ? 0
                                                        : random.uniform(0, 3.1415);
      const test::Vector axis = random.direction();
      for (size_t k = 0; k < 3; ++k) record.r[k] = angle * axis[k];
      record.before = record.after = 7;
    }
    size_t wrong = 0;
    for (size_t row = 0; row < count; ++row) {
      const size_t first = row;
      const qtraj::JacobianRecords all = {records[0].r, records[0].jacobian, records[0].turning, kStride};
      row += qtraj::kJacobianKernels[qtraj::target()](all, row, count);
      for (size_t done = first; done < row; ++done) {
        const Record& record = records[done];
        const qtraj::JacobianAndTurning expected = qtraj::jacobian_and_turning(qtraj::load(record.r));
        wrong += !same_bits(record.jacobian, expected.jacobian.data(), sizeof record.jacobian);
        wrong += !same_bits(record.turning, &expected.turning, sizeof record.turning);
        wrong += record.before != 7 || record.after != 7;
      }
      wrong += row < count && qtraj::length(qtraj::load(records[row].r)) < 3.1415;
    }
    CHECK(wrong == 0);
  });
}

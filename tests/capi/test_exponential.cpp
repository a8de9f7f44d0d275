// exp, log, pow and rotation vectors: error bounds on a million rows, every branch, and the singular cases.
#include <qtraj.h>

#include <cstring>

#include "support/catch.hpp"
#include "support/hard_rows.hpp"

namespace {

using namespace test;

const double kPi = static_cast<double>(wide::kPi);

// Vectors of whole length: those times a number of 40 bits have a length that is known exactly.
struct Quadruple {
  double x, y, z, length;
};
constexpr Quadruple kQuadruples[] = {{1, 2, 2, 3},  {-2, 3, 6, 7},   {4, -1, 8, 9}, {0, 3, 4, 5},
                                     {2, 6, 9, 11}, {-6, 7, -6, 11}, {0, 0, -1, 1}, {-12, 0, 5, 13}};

double shortened(double x) {
  const double shifted = 0x1.0008p13 * x;
  return shifted - (shifted - x);
}

TEST_CASE("C API: exp is within 1.5 eps up to 2^26 rad and good to 1.5 eps for small vectors", "[capi][exponential]") {
  Random random(31);
  std::vector<double> v, lengths, q(4 * kHardRows);
  for (size_t row = 0; row < kHardRows; ++row) {
    const Quadruple& direction = kQuadruples[row % 8];
    const double size = row % 3 == 0   ? std::pow(10.0, random.uniform(-300, 0))
                        : row % 3 == 1 ? hard_angle(random) + kPi * static_cast<double>(row % 7)
                                       : random.uniform(0, 0x1p26 - 1);
    const double unit = shortened(size / direction.length);
    append(v, Vector{unit * direction.x, unit * direction.y, unit * direction.z});
    lengths.push_back(unit);
  }
  REQUIRE(qtraj_exp(v.data(), kHardRows, q.data(), nullptr) == QTRAJ_OK);
  Worst worst, worst_small;
  for (size_t row = 0; row < kHardRows; ++row) {
    const wide::Real length = wide::Real(lengths[row]) * wide::Real(kQuadruples[row % 8].length);
    const wide::Real sinc = length == 0 ? 1 : std::sin(length) / length;
    const wide::Quaternion reference = {std::cos(length), sinc * v[3 * row], sinc * v[3 * row + 1],
                                        sinc * v[3 * row + 2]};
    worst.add(row, wide::error(&q[4 * row], reference), 1.5 * kEps);
    for (size_t k = 1; k < 4 && length <= 1; ++k)
      worst_small.add(row, static_cast<double>(std::abs(q[4 * row + k] - reference[k])),
                      1.5 * kEps * static_cast<double>(std::abs(reference[k])) + kLeast);
  }
  CHECK(worst.ratio <= 1);
  CHECK(worst_small.ratio <= 1);
}

TEST_CASE("C API: exp and pow of huge angles are within eps of the angle to 2^50 and unit beyond",
          "[capi][exponential]") {
  Random random(32);
  Worst worst, worst_pow;
  double worst_norm = 0;
  for (int i = 0; i < 100000; ++i) {
    const Quadruple& direction = kQuadruples[i % 8];
    const double unit = shortened(std::pow(2.0, random.uniform(20, 46)));
    const double v[3] = {unit * direction.x, unit * direction.y, unit * direction.z};
    const wide::Real length = wide::Real(unit) * wide::Real(direction.length), sinc = std::sin(length) / length;
    double q[4];
    REQUIRE(qtraj_exp(v, 1, q, nullptr) == QTRAJ_OK);
    worst.add(0, wide::error(q, wide::Quaternion{std::cos(length), sinc * v[0], sinc * v[1], sinc * v[2]}),
              1.5 * kEps + kEps * static_cast<double>(length));
    // of any finite size at all
    const double size = std::pow(10.0, random.uniform(10, 308));
    const Vector axis = hard_direction(random);
    const double huge[3] = {size * axis[0], size * axis[1], i % 3 == 0 ? DBL_MAX : size * axis[2]};
    REQUIRE(qtraj_exp(huge, 1, q, nullptr) == QTRAJ_OK);
    worst_norm = std::max(worst_norm, static_cast<double>(std::abs(wide::norm(wide::quaternion(q)) - 1)));
    REQUIRE(qtraj_q_from_rotation_vector(huge, 1, q, nullptr) == QTRAJ_OK);
    worst_norm = std::max(worst_norm, static_cast<double>(std::abs(wide::norm(wide::quaternion(q)) - 1)));
    const Quaternion base = hard_orientation(random);
    const double many = std::pow(10.0, random.uniform(5, 14.5));
    const wide::Vector log = wide::scaled(many, wide::log(wide::quaternion(base.data())));
    qtraj_pow(base.data(), &many, 1, 1, q, nullptr);
    if (wide::norm(log) > 0)
      worst_pow.add(0, wide::error(q, wide::exp(log)), kEps * (1.5 + static_cast<double>(wide::norm(log))));
    const double exponent = i % 5 == 0 ? DBL_MAX : i % 2 == 0 ? size : -size;
    REQUIRE(qtraj_pow(base.data(), &exponent, 1, 1, q, nullptr) != QTRAJ_E_NOT_FINITE);
    worst_norm = std::max(worst_norm, static_cast<double>(std::abs(wide::norm(wide::quaternion(q)) - 1)));
  }
  CHECK(worst.ratio <= 1);
  CHECK(worst_pow.ratio <= 1);
  CHECK(worst_norm <= 4 * kEps);
}

TEST_CASE("C API: logs and rotation vectors are good to 0.75 eps at every angle and norm", "[capi][exponential]") {
  const std::vector<double>& q = hard_quaternions();
  std::vector<double> v(3 * kHardRows), r(3 * kHardRows);
  size_t fault = 0;
  CHECK(qtraj_log(q.data(), kHardRows, v.data(), &fault) == QTRAJ_E_AMBIGUOUS);
  REQUIRE(qtraj_rotation_vector_from_q(q.data(), kHardRows, r.data(), nullptr) == QTRAJ_OK);
  Worst worst, worst_rotation, worst_length;
  size_t first_ambiguous = SIZE_MAX;
  for (size_t row = 0; row < kHardRows; ++row) {
    const wide::Quaternion wide_q = wide::quaternion(&q[4 * row]);
    const bool ambiguous = q[4 * row] < 0 && wide::norm(wide::vector_part(wide_q)) == 0;
    if (ambiguous) first_ambiguous = std::min(first_ambiguous, row);
    const wide::Vector log = ambiguous ? wide::Vector{wide::kPi, 0, 0} : wide::log(wide_q);
    // the shorter way
    const wide::Vector rotation = wide::scaled(2, wide::log(q[4 * row] < 0 ? wide::scaled(-1, wide_q) : wide_q));
    for (size_t k = 0; k < 3; ++k) {
      worst.add(row, static_cast<double>(std::abs(v[3 * row + k] - log[k])),
                static_cast<double>(0.75 * kEps * std::abs(log[k])) + kLeast);
      worst_rotation.add(row, static_cast<double>(std::abs(r[3 * row + k] - rotation[k])),
                         static_cast<double>(0.75 * kEps * std::abs(rotation[k])) + kLeast);
    }
    const wide::Real length = wide::norm(wide::vector(&v[3 * row])),
                     rotation_length = wide::norm(wide::vector(&r[3 * row]));
    worst_length.add(row, static_cast<double>(std::abs(length - wide::norm(log))), 2 * kEps);
    worst_length.add(row, static_cast<double>(std::abs(rotation_length - wide::norm(rotation))), 2 * kEps);
  }
  CHECK(worst.ratio <= 1);
  CHECK(worst_rotation.ratio <= 1);
  CHECK(worst_length.ratio <= 1);
  CHECK(fault == first_ambiguous);
}

TEST_CASE("C API: exp inverts log, and log inverts exp to 2 eps below pi, exactly for tiny vectors",
          "[capi][exponential]") {
  Random random(33);
  Worst worst, worst_tiny, worst_back;
  for (int i = 0; i < 1000000; ++i) {
    const Vector direction = hard_direction(random);
    const bool tiny = i % 2 == 0;
    const double length = tiny ? std::pow(10.0, random.uniform(-300, -8)) : hard_angle(random);
    const double v[3] = {length * direction[0], length * direction[1], length * direction[2]};
    double q[4], back[3], again[4];
    REQUIRE(qtraj_exp(v, 1, q, nullptr) == QTRAJ_OK);
    // exp of a length that rounds to pi is just short of -1 or just past it
    if (length > 3.14159) continue;
    REQUIRE(qtraj_log(q, 1, back, nullptr) == QTRAJ_OK);
    const double error = wide::error(back, wide::vector(v));
    (tiny ? worst_tiny : worst).add(0, error, tiny ? 0 : 2 * kEps);
    REQUIRE(qtraj_exp(back, 1, again, nullptr) == QTRAJ_OK);
    worst_back.add(0, wide::error(again, wide::quaternion(q)), 2 * kEps);
  }
  CHECK(worst_tiny.ratio <= 1);
  CHECK(worst.ratio <= 1);
  CHECK(worst_back.ratio <= 1);
}

TEST_CASE("C API: log folds exp of a vector at and past pi to the other side", "[capi][exponential]") {
  Random random(36);
  Worst worst, worst_length;
  for (size_t i = 0; i < 200000; ++i) {
    const Vector direction = hard_direction(random);
    const double distance = std::pow(10.0, random.uniform(-15, -0.5));  // from pi
    const double length = i % 2 == 0 ? 3.141592653589793 - distance : 3.141592653589793 + distance;
    const double v[3] = {length * direction[0], length * direction[1], length * direction[2]};
    double q[4], back[3];
    REQUIRE(qtraj_exp(v, 1, q, nullptr) == QTRAJ_OK);
    REQUIRE(qtraj_log(q, 1, back, nullptr) == QTRAJ_OK);
    const wide::Real exact = wide::norm(wide::vector(v)), folded = exact < wide::kPi ? exact : exact - 2 * wide::kPi;
    // q is rounded, and where its vector part is short so is the direction it tells
    const double turned = 4 * kEps / static_cast<double>(std::abs(wide::kPi - exact));
    worst.add(i, wide::error(back, wide::scaled(folded / exact, wide::vector(v))), 2 * kEps + 3.1416 * turned);
    worst_length.add(i, static_cast<double>(std::abs(wide::norm(wide::vector(back)) - std::abs(folded))), 2 * kEps);
  }
  CHECK(worst.ratio <= 1);
  CHECK(worst_length.ratio <= 1);
}

TEST_CASE("C API: pow is within 1.5 eps and a quarter eps of the angle up to 2^26 rad", "[capi][exponential]") {
  Random random(34);
  const std::vector<double>& q = hard_quaternions();
  std::vector<double> exponents, powers(4 * kHardRows);
  constexpr double kNamed[] = {0, 1, -1, 0.5, 2, -3, 1e-300, 7.25};
  for (size_t row = 0; row < kHardRows; ++row)
    exponents.push_back(row % 3 == 0 ? kNamed[row / 3 % 8]
                                     : std::pow(10.0, random.uniform(-5, 7.3)) * (row % 2 == 0 ? 1 : -1));
  size_t fault = 0;
  CHECK(qtraj_pow(q.data(), exponents.data(), kHardRows, kHardRows, powers.data(), &fault) == QTRAJ_E_AMBIGUOUS);
  Worst worst;
  size_t first_ambiguous = SIZE_MAX;
  for (size_t row = 0; row < kHardRows; ++row) {
    const wide::Quaternion wide_q = wide::quaternion(&q[4 * row]);
    const bool antipode = q[4 * row] < 0 && wide::norm(wide::vector_part(wide_q)) == 0;
    if (antipode && exponents[row] != std::floor(exponents[row])) first_ambiguous = std::min(first_ambiguous, row);
    const wide::Vector log = wide::scaled(exponents[row], antipode ? wide::Vector{wide::kPi, 0, 0} : wide::log(wide_q));
    const double angle = static_cast<double>(wide::norm(log));
    if (angle <= 0x1p26)
      worst.add(row, wide::error(&powers[4 * row], wide::exp(log)), 1.5 * kEps + 0.25 * kEps * angle);
  }
  CHECK(worst.ratio <= 1);
  CHECK(fault == first_ambiguous);
}

TEST_CASE("C API: log of -1 is pi about x and ambiguous, powers of -1 only where the axis matters",
          "[capi][exponential][singular]") {
  for (const double norm : {1.0, 1e-160, 1e160, 5e-324, DBL_MAX}) {
    const double minus_one[4] = {-norm, 0, -0.0, 0}, one[4] = {norm, 0, 0, 0};
    double v[3] = {7, 7, 7};
    size_t fault = 7;
    CHECK(qtraj_log(minus_one, 1, v, &fault) == QTRAJ_E_AMBIGUOUS);
    CHECK(fault == 0);
    CHECK((v[0] == kPi && v[1] == 0 && v[2] == 0));
    CHECK(qtraj_log(one, 1, v, &fault) == QTRAJ_OK);
    CHECK((v[0] == 0 && v[1] == 0 && v[2] == 0));
    CHECK(qtraj_rotation_vector_from_q(minus_one, 1, v, &fault) == QTRAJ_OK);
    CHECK((v[0] == 0 && v[1] == 0 && v[2] == 0));

    double q[4];
    for (const double exponent : {0.0, 1.0, -1.0, 2.0, 3.0, -40.0, 1e15 + 1, 0x1p53, 1e300, -DBL_MAX}) {
      CAPTURE(norm, exponent);
      CHECK(qtraj_pow(minus_one, &exponent, 1, 1, q, &fault) == QTRAJ_OK);
      CHECK(fault == SIZE_MAX);
      CHECK((q[0] == (std::fmod(exponent, 2.0) == 0 ? 1 : -1) && q[1] == 0 && q[2] == 0 && q[3] == 0));
      CHECK(qtraj_pow(one, &exponent, 1, 1, q, &fault) == QTRAJ_OK);
      CHECK((q[0] == 1 && q[1] == 0 && q[2] == 0 && q[3] == 0));
    }
    const double half = 0.5;
    CHECK(qtraj_pow(minus_one, &half, 1, 1, q, &fault) == QTRAJ_E_AMBIGUOUS);
    CHECK(fault == 0);
    CHECK((std::abs(q[0]) < 1e-16 && q[1] == 1 && q[2] == 0 && q[3] == 0));
  }
  // the smallest vector part gives the axis
  const double beside[4] = {-1, 0, -5e-324, 0};
  double v[3];
  CHECK(qtraj_log(beside, 1, v, nullptr) == QTRAJ_OK);
  CHECK((v[0] == 0 && v[1] == -kPi && v[2] == 0));
}

TEST_CASE("C API: q and -q have one rotation vector, at half a turn the vector part gives the axis",
          "[capi][exponential][singular]") {
  const std::vector<double>& q = hard_quaternions();
  std::vector<double> opposite(q), r(3 * kHardRows), r_opposite(3 * kHardRows);
  for (double& component : opposite) component = -component;
  REQUIRE(qtraj_rotation_vector_from_q(q.data(), kHardRows, r.data(), nullptr) == QTRAJ_OK);
  REQUIRE(qtraj_rotation_vector_from_q(opposite.data(), kHardRows, r_opposite.data(), nullptr) == QTRAJ_OK);
  size_t wrong = 0;
  for (size_t at = 0; at < r.size(); ++at) wrong += r_opposite[at] != (q[at / 3 * 4] == 0 ? -r[at] : r[at]);
  CHECK(wrong == 0);
  for (const double w : {0.0, -0.0}) {
    const double half_turn[4] = {w, 0, -3, 4};
    double half[3];
    CHECK(qtraj_rotation_vector_from_q(half_turn, 1, half, nullptr) == QTRAJ_OK);
    CHECK((half[0] == 0 && std::abs(half[1] + 0.6 * kPi) < 4e-16 && std::abs(half[2] - 0.8 * kPi) < 5e-16));
  }
}

TEST_CASE("C API: rotation vectors of any length are exp of their half", "[capi][exponential]") {
  const std::vector<double> r = HardRows(35, 300).vectors();
  std::vector<double> half(r), q(4 * kHardRows), q_half(4 * kHardRows);
  for (double& component : half) component *= 0.5;
  REQUIRE(qtraj_q_from_rotation_vector(r.data(), kHardRows, q.data(), nullptr) == QTRAJ_OK);
  REQUIRE(qtraj_exp(half.data(), kHardRows, q_half.data(), nullptr) == QTRAJ_OK);
  CHECK(std::memcmp(q.data(), q_half.data(), q.size() * sizeof(double)) == 0);
}

}  // namespace

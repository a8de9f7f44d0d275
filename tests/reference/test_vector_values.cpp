// Vector curves of every method and of all pairs of ends against values computed at 50 digits (vector_curves.py).
#include <cfloat>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "support/long_double.hpp"
#include "support/vector_curve.hpp"
#include "support/worst.hpp"

using namespace capi;

namespace {

struct ReferenceCurve {
  VectorVariant variant;
  VectorKeys<double> keys;
  std::vector<double> times;
  std::vector<wide::Real> expected;  // [time][dim][4]: value, first and second derivative, sum of magnitudes

  double step(size_t segment) const { return keys.times[segment + 1] - keys.times[segment]; }
  size_t segment_of(double time) const {
    size_t segment = 0;
    while (segment + 2 < keys.count() && time >= keys.times[segment + 1]) ++segment;
    return segment;
  }
  // Eps that the spline itself is off by, of the largest magnitude of a component (qtraj_cubic_spline()).
  double spline_bound() const {
    if (variant.method != QTRAJ_VECTOR_CUBIC) return 0;
    double longest = 0, shortest = DBL_MAX;
    for (size_t i = 0; i + 1 < keys.count(); ++i) {
      longest = std::max(longest, step(i));
      shortest = std::min(shortest, step(i));
    }
    const double ratio = 1 + longest / shortest;
    const bool swings = variant.start == QTRAJ_END_NOT_A_KNOT || variant.end == QTRAJ_END_NOT_A_KNOT;
    return 4 * (swings ? ratio * ratio : ratio);
  }
};

VectorVariant variant_of(const std::string& method, const std::string& start, const std::string& end) {
  const std::map<std::string, int32_t> methods = {{"step", QTRAJ_VECTOR_STEP},
                                                  {"linear", QTRAJ_VECTOR_LINEAR},
                                                  {"cubic", QTRAJ_VECTOR_CUBIC},
                                                  {"hermite", QTRAJ_VECTOR_HERMITE},
                                                  {"quintic", QTRAJ_VECTOR_QUINTIC}},
                                       ends = {{"default", QTRAJ_END_DEFAULT},
                                               {"natural", QTRAJ_END_NATURAL},
                                               {"not_a_knot", QTRAJ_END_NOT_A_KNOT},
                                               {"given", QTRAJ_END_GIVEN},
                                               {"periodic", QTRAJ_END_PERIODIC}};
  return {method + " " + start + " " + end, methods.at(method), ends.at(start), ends.at(end)};
}

// Rows of numbers; NaN where a file says "nan", which streams do not read.
class Lines {
 public:
  Lines() : stream_(QTRAJ_REFERENCE_DIR "/vector_curves.txt") { REQUIRE(stream_.is_open()); }

  bool next_curve(std::istringstream& head) {
    std::string line;
    while (std::getline(stream_, line))
      if (!line.empty() && line[0] != '#') {
        head = std::istringstream(line);
        return true;
      }
    return false;
  }
  std::istringstream next() {
    std::string line;
    REQUIRE(std::getline(stream_, line));
    return std::istringstream(line);
  }
  template <class Real>
  static void read(std::istringstream& fields, size_t count, std::vector<Real>& to) {
    for (size_t k = 0; k < count; ++k) {
      std::string word;
      REQUIRE(fields >> word);
      to.push_back(static_cast<Real>(std::stold(word)));
    }
  }

 private:
  std::ifstream stream_;
};

ReferenceCurve read_curve(std::istringstream& head, Lines& lines) {
  std::string word, method, start, end;
  size_t dim = 0, count = 0, samples = 0;
  REQUIRE(head >> word >> method >> start >> end >> dim >> count);
  REQUIRE(word == "curve");
  ReferenceCurve curve = {variant_of(method, start, end), {{}, {}, {}, {}, dim}, {}, {}};
  VectorKeys<double>& keys = curve.keys;
  for (size_t i = 0; i < count; ++i) {
    auto fields = lines.next();
    Lines::read(fields, 1, keys.times);
    Lines::read(fields, dim, keys.values);
    Lines::read(fields, dim, keys.first);
    Lines::read(fields, dim, keys.second);
  }
  if (!curve.variant.needs_first()) keys.first.clear();
  if (!curve.variant.needs_second()) keys.second.clear();
  if (curve.variant.gives_end()) {  // the rows of the first and of the last key
    std::copy_n(keys.first.end() - static_cast<ptrdiff_t>(dim), dim, keys.first.begin() + static_cast<ptrdiff_t>(dim));
    keys.first.resize(2 * dim);
  }
  auto fields = lines.next();
  REQUIRE(fields >> word >> samples);
  for (size_t i = 0; i < samples; ++i) {
    auto row = lines.next();
    Lines::read(row, 1, curve.times);
    Lines::read(row, 4 * dim, curve.expected);
  }
  return curve;
}

struct Errors {
  double value = 0, single = 0;  // over the bound
  double first = 0, second = 0;  // in eps of what the error of the value is measured in, by time
};

void compare(const ReferenceCurve& reference, Errors& worst) {
  const Options options = vector_options(reference.variant);
  const VectorCurve curve = must_build_vector(options.get(), reference.keys);
  const VectorMotion<double> motion = must_sample_vectors<double>(curve.get(), reference.times);
  const VectorMotion<float> single = must_sample_vectors<float>(curve.get(), reference.times);
  const size_t dim = reference.keys.dim;
  const double spline = reference.spline_bound();
  for (size_t c = 0; c < dim; ++c) {
    double largest = 0;
    for (size_t i = c; i < reference.keys.values.size(); i += dim)
      largest = std::max(largest, std::abs(reference.keys.values[i]));
    for (size_t i = 0; i < reference.times.size(); ++i) {
      const wide::Real* expected = &reference.expected[4 * (i * dim + c)];
      const double h = reference.step(reference.segment_of(reference.times[i]));
      const double unit = DBL_EPSILON * (static_cast<double>(expected[3]) + spline / 4 * largest);
      const size_t at = i * dim + c;
      test::raise_to(worst.value, std::abs(motion.value[at] - expected[0]) / (4 * unit));
      test::raise_to(worst.single,
                     std::abs(single.value[at] - expected[0]) / (0.5 * FLT_EPSILON * std::abs(expected[0]) + 4 * unit));
      test::raise_to(worst.first, std::abs(motion.first[at] - expected[1]) * h / unit);
      test::raise_to(worst.second, std::abs(motion.second[at] - expected[2]) * h * h / unit);
    }
  }
}

}  // namespace

TEST_CASE("vector curves meet values of 50 digits, by every method and at all ends", "[reference][vector]") {
  Lines lines;
  std::istringstream head;
  size_t curves = 0;
  std::map<int32_t, Errors> errors;
  while (lines.next_curve(head)) {
    const ReferenceCurve curve = read_curve(head, lines);
    CAPTURE(curve.variant.name, curve.keys.count(), curve.keys.dim, curve.keys.times[0]);
    Errors of_curve;
    compare(curve, of_curve);
    CHECK(of_curve.value <= 1);
    CHECK(of_curve.single <= 1);
    CHECK(of_curve.first <= 16);
    CHECK(of_curve.second <= 64);
    Errors& worst = errors[curve.variant.method];
    test::raise_to(worst.value, of_curve.value);
    test::raise_to(worst.single, of_curve.single);
    test::raise_to(worst.first, of_curve.first);
    test::raise_to(worst.second, of_curve.second);
    ++curves;
  }
  CHECK(curves == 128);
  CHECK(errors.size() == 5);
  if (std::getenv("QTRAJ_TEST_ERROR_TABLE"))
    for (const auto& [method, worst] : errors)
      std::printf("%d: value %.2f, float %.2f of the bound; first %.2f, second %.2f\n", static_cast<int>(method),
                  worst.value, worst.single, worst.first, worst.second);
}

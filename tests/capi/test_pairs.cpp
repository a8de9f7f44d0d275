// slerp and nlerp: error bounds against long double, and that their twins agree.
#include <cfloat>

#include "support/capi_variants.hpp"
#include "support/pair_functions.hpp"
#include "support/wide_pair.hpp"

using namespace capi;
using pairs::Batch;
using pairs::Functions;
using pairs::kPaths;
using test::Random;

namespace {

template <class Real>
std::vector<Real> many(const Functions<Real>& functions, const Batch<Real>& batch, int32_t path) {
  std::vector<Real> q(4 * batch.count());
  functions.many(batch.a.data(), batch.count(), batch.b.data(), batch.count(), batch.fractions.data(), batch.count(),
                 batch.count(), path, q.data(), nullptr);
  return q;
}

// All rows with the ends of row 0.
template <class Real>
Batch<Real> with_first_pair(Batch<Real> batch) {
  for (size_t i = 4; i < batch.a.size(); ++i) batch.a[i] = batch.a[i - 4], batch.b[i] = batch.b[i - 4];
  return batch;
}

// Worst error found, in units of the bound, and how often the status was not the one that the pair asks for.
struct Found {
  double slerp = 0, nlerp = 0, norm = 0;
  size_t wrong_statuses = 0;
};

// Status beside a limit: either is right within rounding of it.
bool is_right(bool is_at_fault, long double distance, long double limit) {
  return distance < 0.9L * limit ? is_at_fault : distance > 1.1L * limit ? !is_at_fault : true;
}

void compare(const pairs::Ends& ends, int32_t path, Random& random, Found& found) {
  const wide::Pair pair = wide::pair(ends.a.data(), ends.b.data(), path == QTRAJ_PATH_SHORTEST);
  const pairs::Fractions fractions = pairs::hard_fractions(random, static_cast<double>(pair.angle));
  constexpr size_t kCount = std::tuple_size<pairs::Fractions>::value;
  double slerped[4 * kCount], nlerped[4 * kCount];
  const double *a = ends.a.data(), *b = ends.b.data();
  const qtraj_status status = qtraj_slerp(a, b, fractions.data(), kCount, path, slerped, nullptr);
  qtraj_nlerp(a, b, fractions.data(), kCount, path, nlerped, nullptr);
  if (pair.is_tie) return;

  const bool is_ambiguous = status == QTRAJ_E_AMBIGUOUS;
  found.wrong_statuses += (status != QTRAJ_OK && !is_ambiguous) || !is_right(is_ambiguous, pair.supplement, 1e-14L);
  for (size_t k = 0; k < kCount; ++k) {
    const double fraction = fractions[k], tiny = 1e-150 * std::abs(fraction);
    const double theta = std::abs(static_cast<double>(fraction * pair.angle));
    const double *slerp_row = &slerped[4 * k], *nlerp_row = &nlerped[4 * k];
    found.norm = std::max(found.norm, std::abs(pairs::norm_of(slerp_row) - 1));
    if (!is_ambiguous) {
      const bool is_between = fraction >= 0 && fraction <= 1;
      const double bound = is_between ? 6e-16 : 6e-16 + 7e-16 * theta + tiny;
      found.slerp = std::max(found.slerp, wide::error(slerp_row, wide::slerp(pair, fraction)) / bound);
    }

    const wide::Chord chord = wide::nlerp(pair, fraction);
    const bool is_zero = std::isnan(nlerp_row[0]);
    found.wrong_statuses += !is_right(is_zero, chord.norm, 1e-14L);
    if (is_zero) continue;
    found.norm = std::max(found.norm, std::abs(pairs::norm_of(nlerp_row) - 1));
    found.nlerp =
        std::max(found.nlerp, wide::error(nlerp_row, chord.q) / (7e-16 + tiny / static_cast<double>(chord.norm)));
  }
}

TEST_CASE("C API: slerp and nlerp stay within their bounds on 1e6 random and singular inputs", "[capi][pairs]") {
  Random random(1);
  Found found;
  for (size_t i = 0; i < 125000; ++i) compare(pairs::hard_ends(random, 160), kPaths[i % 2], random, found);
  CAPTURE(found.slerp, found.nlerp, found.norm);
  CHECK(found.slerp <= 1);
  CHECK(found.nlerp <= 1);
  CHECK(found.norm <= 4 * DBL_EPSILON);
  CHECK(found.wrong_statuses == 0);
}

TEST_CASE("C API: slerp and nlerp pair by pair give the bits of one pair at many fractions", "[capi][pairs]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Batch<Real> batch = pairs::hard_batch<Real>(2, 4000), one_pair = with_first_pair(batch);
    for (const Functions<Real>& functions : pairs::functions(zero))
      for (const int32_t path : kPaths) {
        const std::vector<Real> expected = many(functions, batch, path);
        std::vector<Real> q(expected.size());
        for (size_t i = 0; i < batch.count(); ++i)
          functions.one(&batch.a[4 * i], &batch.b[4 * i], &batch.fractions[i], 1, path, &q[4 * i], nullptr);
        CHECK(same_bits(q, expected));

        functions.one(batch.a.data(), batch.b.data(), batch.fractions.data(), batch.count(), path, q.data(), nullptr);
        CHECK(same_bits(q, many(functions, one_pair, path)));

        Batch<Real> one_fraction = batch;
        for (Real& fraction : one_fraction.fractions) fraction = Real(0.3);
        functions.many(batch.a.data(), batch.count(), batch.b.data(), batch.count(), one_fraction.fractions.data(), 1,
                       batch.count(), path, q.data(), nullptr);
        CHECK(same_bits(q, many(functions, one_fraction, path)));
      }
  });
}

TEST_CASE("C API: float slerp and nlerp are those of double, rounded once", "[capi][pairs]") {
  const Batch<float> batch = pairs::hard_batch<float>(3, 250000);
  const Batch<double> widened = {{batch.a.begin(), batch.a.end()},
                                 {batch.b.begin(), batch.b.end()},
                                 {batch.fractions.begin(), batch.fractions.end()}};
  for (size_t kind = 0; kind < 2; ++kind)
    for (const int32_t path : kPaths) {
      const std::vector<double> q = many(pairs::functions(0.0)[kind], widened, path);
      std::vector<float> rounded;
      for (const double component : q) rounded.push_back(static_cast<float>(component));
      CHECK(same_bits(many(pairs::functions(0.0f)[kind], batch, path), rounded));
    }
}

}  // namespace

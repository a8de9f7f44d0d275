#include <cfloat>

#include "qtraj/block_sum.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

using Sum = qtraj::BlockSum<1>;

double sum_of(const std::vector<double>& terms) {
  Sum sum;
  for (const double term : terms) sum.add(Sum::Terms(term));
  return sum.value()[0];
}

double error_in_eps(const std::vector<double>& terms) {
  long double exact = 0, size = 0;
  for (const double term : terms) exact += term, size += std::abs(term);
  return static_cast<double>(std::abs(sum_of(terms) - exact) / size) / DBL_EPSILON;
}

}  // namespace

TEST_CASE("sums of any length keep their bound", "[block_sum]") {
  test::Random random(1);
  for (size_t count = 0; count < 100; ++count) {
    std::vector<double> terms = {1.0};
    for (size_t i = 0; i < count; ++i) terms.push_back(random.uniform(-1.0, 1.0));
    CAPTURE(count);
    CHECK(error_in_eps(terms) <= 8.0);
  }
  // in a plain sum each of these is lost
  CHECK(sum_of(std::vector<double>(65536, 0x1p-54)) == 0x1p-38);
  std::vector<double> lost(1 << 20, 0x1p-54);
  lost[0] = 1.0;
  CHECK(error_in_eps(lost) <= 8.0);
  std::vector<double> million;
  for (int i = 0; i < 1000000; ++i) million.push_back(random.uniform(0.0, 1.0));
  CHECK(error_in_eps(million) <= 0.6);
}

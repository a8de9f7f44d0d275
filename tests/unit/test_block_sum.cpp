#include <cfloat>

#include "math/block_sum.hpp"
#include "rows/sums.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

template <class AddTerms>
bool add_block(size_t rows, const AddTerms& add_terms, qtraj::BlockSum<1>& sum) {
  if (!qtraj::add_rows<double>(rows, add_terms, sum)) return qtraj::discard_block(sum);
  qtraj::close_block<double>(sum);
  return true;
}

// Rows that fill no lanes are followed by zeros.
double sum_of(std::vector<double> terms) {
  while (terms.size() % qtraj::kSumLanes != 0) terms.push_back(0.0);
  qtraj::BlockSum<1> sum;
  const size_t done = qtraj::do_blocks(0, terms.size(), [&](size_t first, size_t rows) {
    const auto add_term = [&](size_t row, double(&to)[1]) {
      to[0] += terms[first + row];
      return true;
    };
    return add_block(rows, add_term, sum);
  });
  REQUIRE(done == terms.size());
  return sum.value(0);
}

double error_in_eps(const std::vector<double>& terms) {
  long double exact = 0, size = 0;
  for (const double term : terms) exact += term, size += std::abs(term);
  return static_cast<double>(std::abs(sum_of(terms) - exact) / size) / DBL_EPSILON;
}

}  // namespace

TEST_CASE("sums of any length keep their bound", "[block_sum]") {
  test::Random random(1);
  for (size_t count = 0; count < 400; ++count) {
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
  // all of a block's terms but one are rounded in the same direction
  std::vector<double> one_way(1 << 12, 0x1.8p-53);
  for (size_t i = 0; i < one_way.size(); i += qtraj::kBlockRows)
    std::fill_n(one_way.begin() + static_cast<std::ptrdiff_t>(i), qtraj::kSumLanes, 1.0);
  CHECK(error_in_eps(one_way) <= 8.0);
  std::vector<double> million;
  for (int i = 0; i < 1000000; ++i) million.push_back(random.uniform(0.0, 1.0));
  CHECK(error_in_eps(million) <= 0.6);
}

TEST_CASE("a block that ends early leaves its sum alone", "[block_sum]") {
  qtraj::BlockSum<1> sum;
  const auto rows_before = [&](size_t end) {
    return qtraj::do_blocks(0, 1000, [&](size_t first, size_t rows) {
      const auto add_term = [&](size_t row, double(&to)[1]) {
        to[0] += 1.0;
        return first + row < end;
      };
      return add_block(rows, add_term, sum);
    });
  };
  CHECK((rows_before(127) == 0 && sum.value(0) == 0));
  CHECK((rows_before(300) == 256 && sum.value(0) == 256));
  CHECK((rows_before(1000) == 1000 && sum.value(0) == 1256));
}

// One time, one result, of vector curves and poses: whatever the function, the order, the split, the cursor, the place
// in memory. Of vector curves the bits are those of every kernel, fused or not: their hash is pinned here.
#include <cmath>
#include <cstring>
#include <numeric>

#include "support/capi_variants.hpp"
#include "support/vector_curve.hpp"

using namespace capi;

namespace {

constexpr size_t kDims[] = {1, 2, 3, 4, 5, 8};

// A curve that takes any time.
template <class Real>
VectorCurve any_time_curve(const VectorVariant& variant, size_t dim, bool wraps) {
  const Options options = vector_options(variant);
  REQUIRE(qtraj_options_set_extrapolation(options.get(), wraps ? QTRAJ_EXTRAPOLATE_PERIODIC : QTRAJ_EXTRAPOLATE_HOLD,
                                          wraps ? QTRAJ_EXTRAPOLATE_PERIODIC : QTRAJ_EXTRAPOLATE_CONSTANT_RATE) ==
          QTRAJ_OK);
  return must_build_vector(options.get(), vector_tour<Real>(variant, 40, dim));
}

// Sorted runs, knots, repeated times, times outside and times in no order.
std::vector<double> many_times(const qtraj_vector_curve* curve) {
  std::vector<double> knots(qtraj_vector_key_count(curve));
  REQUIRE(qtraj_vector_keys(curve, knots.data(), nullptr) == QTRAJ_OK);
  std::vector<double> times = times_in(knots, 12);
  test::Random random(3);
  while (times.size() < 800) times.push_back(random.uniform(knots.front() - 5, knots.back() + 5));
  while (times.size() < 1000) times.push_back(random.uniform(knots.front(), knots.back()));
  while (times.size() < 1100) times.push_back(times[times.size() - 400]);
  return times;
}

// Calls body(curve, times, expected) for every variant, for double and float samples.
template <class Body>
void for_every_curve(Body&& body) {
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    for (const VectorVariant& variant : vector_variants())
      for (const size_t dim : kDims)
        for (const bool wraps : {false, true}) {
          CAPTURE(variant.name, dim, wraps);
          const VectorCurve curve = any_time_curve<Real>(variant, dim, wraps);
          const std::vector<double> times = many_times(curve.get());
          body(curve.get(), times, must_sample_vectors<Real>(curve.get(), times));
        }
  });
}

TEST_CASE("C API: a vector sample does not depend on the order of the times", "[capi][vector][same_bits]") {
  for_every_curve([](const qtraj_vector_curve* curve, const std::vector<double>& times, const auto& expected) {
    using Motion = std::decay_t<decltype(expected)>;
    using Real = typename decltype(expected.value)::value_type;
    const size_t dim = qtraj_vector_dim(curve);
    std::vector<size_t> order(times.size());
    std::iota(order.begin(), order.end(), size_t{0});
    const auto check = [&] {
      std::vector<double> permuted;
      for (const size_t from : order) permuted.push_back(times[from]);
      const Motion sampled = must_sample_vectors<Real>(curve, permuted);
      Motion back(expected.value.size());
      for (size_t i = 0; i < order.size(); ++i) {
        std::copy_n(&sampled.value[dim * i], dim, &back.value[dim * order[i]]);
        std::copy_n(&sampled.first[dim * i], dim, &back.first[dim * order[i]]);
        std::copy_n(&sampled.second[dim * i], dim, &back.second[dim * order[i]]);
      }
      CHECK(same_bits(back, expected));
    };
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return times[a] < times[b]; });
    check();
    std::reverse(order.begin(), order.end());
    check();
    test::Random random(7);
    for (size_t i = order.size() - 1; i > 0; --i)
      std::swap(order[i], order[static_cast<size_t>(random.uniform(0, static_cast<double>(i + 1)))]);
    check();
  });
}

TEST_CASE("C API: a vector sample depends neither on the split of the batch nor on the outputs asked for",
          "[capi][vector][same_bits]") {
  for_every_curve([](const qtraj_vector_curve* curve, const std::vector<double>& times, const auto& expected) {
    using Motion = std::decay_t<decltype(expected)>;
    const size_t dim = qtraj_vector_dim(curve);
    for (const size_t length : {1u, 2u, 3u, 5u, 8u, 9u, 33u, 257u, 1099u})
      for (int asked = 1; asked < 8; ++asked) {
        if (length > 9 && asked % 3 != 1) continue;
        CAPTURE(length, asked);
        Motion motion = expected;
        const auto clear = [](auto& rows) { std::fill(rows.begin(), rows.end(), -7); };
        if (asked & 1) clear(motion.value);
        if (asked & 2) clear(motion.first);
        if (asked & 4) clear(motion.second);
        bool all_ok = true;
        for (size_t at = 0; at < times.size(); at += length) {
          const size_t count = std::min<size_t>(length, times.size() - at);
          all_ok = vector_sample(curve, &times[at], count, asked & 1 ? &motion.value[dim * at] : nullptr,
                                 asked & 2 ? &motion.first[dim * at] : nullptr,
                                 asked & 4 ? &motion.second[dim * at] : nullptr, nullptr) == QTRAJ_OK &&
                   all_ok;
        }
        CHECK(all_ok);
        CHECK(same_bits(motion, expected));
      }
  });
}

TEST_CASE("C API: vector_sample_at gives the bits of the batch with every cursor", "[capi][vector][same_bits]") {
  for_every_curve([](const qtraj_vector_curve* curve, const std::vector<double>& times, const auto& expected) {
    using Motion = std::decay_t<decltype(expected)>;
    const size_t dim = qtraj_vector_dim(curve);
    size_t running = 0;
    for (int kind = 0; kind < 3; ++kind) {
      Motion motion(expected.value.size());
      bool all_ok = true;
      for (size_t i = 0; i < times.size(); ++i) {
        size_t any = SIZE_MAX - 7919 * i;
        size_t* cursor = kind == 0 ? nullptr : kind == 1 ? &running : &any;
        all_ok = vector_sample_at(curve, times[i], cursor, &motion.value[dim * i], &motion.first[dim * i],
                                  &motion.second[dim * i]) == QTRAJ_OK &&
                 all_ok;
      }
      CHECK(all_ok);
      CHECK(same_bits(motion, expected));
    }
  });
}

TEST_CASE("C API: vector_sample_uniform gives the bits of vector_sample at start + (double)i * step",
          "[capi][vector][same_bits]") {
  struct Grid {
    double start, step;
    size_t count;
  };
  const Grid grids[] = {{-2.0, 0.1, 400},   {-2.0, 1.0 / 3.0, 100}, {35.0, -0.07, 700}, {1.0, 0.0, 50},
                        {-7.0, 1e-3, 1001}, {1e6, -7.7, 300},       {0.3, 1e-17, 100},  {-1.0, 0.5, 1}};
  for_every_curve([&](const qtraj_vector_curve* curve, const std::vector<double>&, const auto& expected) {
    using Motion = std::decay_t<decltype(expected)>;
    using Real = typename decltype(expected.value)::value_type;
    for (const Grid& grid : grids) {
      std::vector<double> times(grid.count);
      for (size_t i = 0; i < grid.count; ++i) {
        const double offset = static_cast<double>(i) * grid.step;  // rounded on its own: never one fma
        times[i] = grid.start + offset;
      }
      Motion motion(grid.count * qtraj_vector_dim(curve));
      CHECK(vector_sample_uniform(curve, grid.start, grid.step, grid.count, motion.value.data(), motion.first.data(),
                                  motion.second.data(), nullptr) == QTRAJ_OK);
      CHECK(same_bits(motion, must_sample_vectors<Real>(curve, times)));
    }
  });
}

TEST_CASE("C API: a float vector is the double one rounded once", "[capi][vector][same_bits]") {
  for (const VectorVariant& variant : vector_variants())
    for (const size_t dim : kDims) {
      CAPTURE(variant.name, dim);
      const VectorCurve curve = any_time_curve<double>(variant, dim, false);
      const std::vector<double> times = many_times(curve.get());
      const VectorMotion<double> wide = must_sample_vectors<double>(curve.get(), times);
      const VectorMotion<float> single = must_sample_vectors<float>(curve.get(), times);
      const auto rounded = [](const std::vector<double>& rows) { return std::vector<float>(rows.begin(), rows.end()); };
      CHECK(capi::same_bits(single.value, rounded(wide.value)));
      CHECK(capi::same_bits(single.first, rounded(wide.first)));
      CHECK(capi::same_bits(single.second, rounded(wide.second)));
    }
}

TEST_CASE("C API: keys of float given as double make the same vector curve", "[capi][vector][same_bits]") {
  for (const VectorVariant& variant : vector_variants()) {
    CAPTURE(variant.name);
    const VectorKeys<float> keys = vector_tour<float>(variant, 30, 3);
    const VectorKeys<double> widened = {keys.times,
                                        {keys.values.begin(), keys.values.end()},
                                        {keys.first.begin(), keys.first.end()},
                                        {keys.second.begin(), keys.second.end()},
                                        3};
    const Options options = vector_options(variant);
    const VectorCurve curve = must_build_vector(options.get(), keys), wide = must_build_vector(options.get(), widened);
    const std::vector<double> times = times_in(keys.times, 9);
    CHECK(same_bits(must_sample_vectors<double>(curve.get(), times), must_sample_vectors<double>(wide.get(), times)));
  }
}

TEST_CASE("C API: arrays of vectors need the alignment of their element only", "[capi][vector][same_bits][memory]") {
  for_every_curve([](const qtraj_vector_curve* curve, const std::vector<double>& times, const auto& expected) {
    using Real = typename decltype(expected.value)::value_type;
    for (size_t shift = 1; shift < 8; shift += 2) {
      // ends where its block ends, so that a sanitizer sees any access past it
      std::vector<double> moved(shift + times.size());
      std::vector<Real> value(shift + expected.value.size());
      std::copy(times.begin(), times.end(), moved.begin() + static_cast<ptrdiff_t>(shift));
      CHECK(vector_sample(curve, moved.data() + shift, times.size(), value.data() + shift, static_cast<Real*>(nullptr),
                          static_cast<Real*>(nullptr), nullptr) == QTRAJ_OK);
      CHECK(std::memcmp(value.data() + shift, expected.value.data(), expected.value.size() * sizeof(Real)) == 0);
    }
  });
}

// FNV-1a.
class Hash {
 public:
  template <class Real>
  void add(const std::vector<Real>& numbers) {
    for (const Real number : numbers) {
      unsigned char bytes[sizeof number];
      std::memcpy(bytes, &number, sizeof bytes);
      for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 1099511628211u;
    }
  }
  uint64_t value() const { return hash_; }

 private:
  uint64_t hash_ = 14695981039346656037u;
};

TEST_CASE("C API: vector curves have the same bits on every kernel and processor", "[capi][vector][same_bits]") {
  Hash hash;
  for_every_curve([&](const qtraj_vector_curve*, const std::vector<double>&, const auto& expected) {
    hash.add(expected.value), hash.add(expected.first), hash.add(expected.second);
  });
  CHECK(hash.value() == 0x55137fdcd3c05f33u);
}

}  // namespace

// Calls leave the upper halves of the vector registers clean. The processor tells: bits 2 and 6 of its state components
// (Intel SDM, vol. 1, 13.1 and 13.6) are the upper halves of the YMM and of the ZMM registers.
#include <qtraj.h>

#if defined(__x86_64__)
#include <cpuid.h>
#endif

#include "support/kernel_curves.hpp"

namespace {

#if defined(__x86_64__)
bool can_tell() {
  unsigned a = 0, b = 0, c = 0, d = 0;
  const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  return has_avx2 && __get_cpuid_count(0xd, 1, &a, &b, &c, &d) != 0 && (a & 4) != 0;
}
void clean() { __asm__ volatile("vzeroupper"); }
bool are_clean() {
  unsigned low = 0, high = 0;
  __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(1));
  return (low & 0x44) == 0;
}
void soil() { __asm__ volatile("vpcmpeqd %%ymm0, %%ymm0, %%ymm0" : : : "xmm0"); }
#else
bool can_tell() { return false; }
void clean() {}
bool are_clean() { return true; }
void soil() {}
#endif

// How many of the calls leave them in use.
template <class... Calls>
size_t unclean(const Calls&... calls) {
  size_t count = 0;
  const auto check = [&](const auto& call) {
    clean();
    call();
    count += !are_clean();
  };
  (check(calls), ...);
  return count;
}

template <class Real>
size_t unclean_samples(const test::KernelCurve& curve, const test::Request& request) {
  constexpr size_t kCount = 100;
  test::OwnRows<Real> rows(kCount, request);
  const test::Arrays<Real> to = rows.arrays();
  const double first = curve.knots.front(), span = curve.knots.back() - first;
  test::Random random(1);
  std::vector<double> sorted, any;
  for (size_t i = 0; i < kCount; ++i) {
    sorted.push_back(first + span * static_cast<double>(i) / kCount);
    any.push_back(first + span * random.uniform(0, 1));
  }
  size_t cursor = 0;
  const qtraj_trajectory* trajectory = curve.get();
  return unclean([&] { sample(trajectory, request, sorted.data(), kCount, to); },
                 [&] { sample(trajectory, request, any.data(), kCount, to); },
                 [&] { sample(trajectory, request, any.data(), 1, to); },
                 [&] { capi::sample_at(trajectory, any[7], &cursor, to.q); },
                 [&] { capi::sample_rates_at(trajectory, request.frame, any[8], &cursor, to.q, to.omega, to.alpha); });
}

// Few rows are done without vectors.
size_t unclean_rows(size_t count) {
  test::Random random(2);
  const test::Keys keys = test::random_walk(random, count + 1, 1.0, 0.2, 2.0);
  const std::vector<float> keys_f32(keys.q.begin(), keys.q.end());
  const double* q = keys.q.data();
  const float* q_f32 = keys_f32.data();
  const double half = 0.5;
  const float half_f32 = 0.5F;
  const std::vector<double> vectors(3 * count, 1.0), weights(count, 2.0);
  std::vector<double> out(4 * count), signs = keys.q;
  std::vector<float> out_f32(4 * count);
  double mean[4];
  return unclean(
      [&] { qtraj_slerp_pairs(q, count, q + 4, count, &half, 1, count, QTRAJ_PATH_SHORTEST, out.data(), nullptr); },
      [&] {
        qtraj_slerp_pairs_f32(q_f32, count, q_f32 + 4, count, &half_f32, 1, count, QTRAJ_PATH_AS_GIVEN, out_f32.data(),
                              nullptr);
      },
      [&] { qtraj_nlerp_pairs(q, count, q + 4, count, &half, 1, count, QTRAJ_PATH_SHORTEST, out.data(), nullptr); },
      [&] { qtraj_rotate(q, count, vectors.data(), count, count, out.data(), nullptr); },
      [&] { qtraj_rotate(q, 1, vectors.data(), count, count, out.data(), nullptr); },
      [&] { qtraj_normalize(q, count, out.data(), nullptr); },
      [&] { qtraj_normalize_f32(q_f32, count, out_f32.data(), nullptr); },
      [&] { qtraj_make_continuous(signs.data(), 1, count, signs.data(), nullptr, nullptr); },
      [&] { qtraj_mean_eigen(q, nullptr, count, mean, nullptr, nullptr); },
      [&] { qtraj_mean_eigen(q, weights.data(), count, mean, nullptr, nullptr); },
      [&] { qtraj_mean_karcher(q, weights.data(), count, 0, 100, mean, nullptr, nullptr, nullptr); });
}

size_t unclean_constructions(size_t segments) {
  test::Random random(3);
  const test::Keys keys = test::random_walk(random, segments + 1, 1.0, 0.2, 2.0);
  const auto construct = [&](int32_t method) {
    return [&keys, method] {
      qtraj_trajectory* made = nullptr;
      qtraj_create(method, keys.times.data(), keys.q.data(), keys.times.size(), &made, nullptr);
      qtraj_destroy(made);
    };
  };
  return unclean(construct(QTRAJ_SLERP), construct(QTRAJ_SQUAD), construct(QTRAJ_LOG_SPLINE),
                 construct(QTRAJ_ROTATION_SPLINE));
}

}  // namespace

TEST_CASE("no call leaves the upper halves of vector registers in use", "[kernel]") {
  if (!can_tell()) {
    WARN("not run: this CPU does not tell which registers are in use");
    return;
  }
  soil();
  const bool noticed = !are_clean();
  clean();
  REQUIRE(noticed);
  const std::vector<test::KernelCurve> curves = test::kernel_curves(QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_ERROR);
  test::for_every_kernel([&](const char*) {
    for (const test::KernelCurve& curve : curves)
      for (const test::Request& request : test::kRequests) {
        CAPTURE(curve.name, request.omega, request.alpha);
        CHECK(unclean_samples<double>(curve, request) == 0);
        CHECK(unclean_samples<float>(curve, request) == 0);
      }
    for (const size_t count : {1u, 3u, 21u}) {
      CHECK(unclean_rows(count) == 0);
      CHECK(unclean_constructions(count) == 0);
    }
  });
}

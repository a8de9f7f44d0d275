// Every allocation fails in turn: the status says so, nothing is written or leaked, errno is the caller's. And what is
// said not to allocate does not. The linker wraps malloc and free of the library (tests/CMakeLists.txt).
#include <cerrno>
#include <cstdlib>

#include "support/capi_batches.hpp"
#include "support/capi_means.hpp"
#include "support/capi_variants.hpp"
#include "support/row_functions.hpp"
#include "support/vector_curve.hpp"

using namespace capi;

namespace {

constexpr int kErrno = 0x5a5a;

struct Allocations {
  int asked = 0, live = 0;
  int failing = -1;  // the number of the one that fails, none below 0
};
Allocations allocations;

}  // namespace

extern "C" {
void* __real_malloc(size_t bytes);
void __real_free(void* memory);

void* __wrap_malloc(size_t bytes) {
  if (allocations.asked++ == allocations.failing) {
    errno = ENOMEM;
    return nullptr;
  }
  void* const memory = __real_malloc(bytes);
  if (memory) ++allocations.live;
  return memory;
}
void __wrap_free(void* memory) {
  if (memory) --allocations.live;
  __real_free(memory);
  errno = EINVAL;  // as it may
}
// of these there is none
void* __wrap_calloc(size_t, size_t) { std::abort(); }
void* __wrap_realloc(void*, size_t) { std::abort(); }
}

namespace {

// Calls with the first allocation failing, then the second, until one call asks for fewer. Call: a status.
template <class Call>
int fail_in_turn(const Call& call) {
  int failing = 0;
  for (;; ++failing) {
    const int live = allocations.live;
    allocations = {0, live, failing};
    errno = kErrno;
    const qtraj_status status = call();
    const int errno_after = errno, asked = allocations.asked;
    allocations.failing = -1;
    CHECK(errno_after == kErrno);
    if (asked <= failing) {
      CHECK(status != QTRAJ_E_NO_MEMORY);
      return failing;
    }
    CHECK(status == QTRAJ_E_NO_MEMORY);
    CHECK(allocations.live == live);
  }
}

template <class Call>
void must_not_allocate(const Call& call) {
  allocations.asked = 0;
  call();
  CHECK(allocations.asked == 0);
}

TEST_CASE("C API: constructors without memory are NO_MEMORY and leave nothing", "[robust][memory]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      CAPTURE(variant.name);
      const Options options = make_options(variant);
      const Keyframes<Real> keys = closed_tour<Real>(40);
      const Rates<Real> rates = rates_for<Real>(variant, 40);
      const int live = allocations.live;
      const int times_failed = fail_in_turn([&] {
        const Built built = build(options.get(), keys, rates);
        CHECK(built.bad_index == SIZE_MAX);
        CHECK((built.status == QTRAJ_OK) == (built.trajectory != nullptr));
        errno = kErrno;  // what destroying leaves is not asked
        return built.status;
      });
      CHECK(times_failed >= 1);
      CHECK(allocations.live == live);
    }
  });
}

TEST_CASE("C API: vector curves without memory are NO_MEMORY, and sampling them allocates nothing",
          "[robust][memory]") {
  for (const VectorVariant& variant : vector_variants()) {
    CAPTURE(variant.name);
    const Options options = vector_options(variant);
    const VectorKeys<double> keys = vector_tour<double>(variant, 20, 3);
    const int asked = fail_in_turn([&] {
      qtraj_vector_curve* out = nullptr;
      size_t bad = 7;
      const qtraj_status status =
          qtraj_vector_create(options.get(), keys.times.data(), keys.values.data(), keys.first_or_null(),
                              keys.second_or_null(), keys.count(), keys.dim, &out, &bad);
      CHECK((status == QTRAJ_OK) == (out != nullptr));
      CHECK(bad == SIZE_MAX);
      qtraj_vector_destroy(out);
      return status;
    });
    CHECK(asked == (variant.method == QTRAJ_VECTOR_CUBIC ? 2 : 1));
    const VectorCurve curve = must_build_vector(options.get(), keys);
    std::vector<double> p(60), v(60), a(60);
    must_not_allocate(
        [&] { qtraj_vector_sample(curve.get(), keys.times.data(), 20, p.data(), v.data(), a.data(), nullptr); });
  }
}

TEST_CASE("C API: options and the spline without memory are NO_MEMORY and write nothing", "[robust][memory]") {
  const int live = allocations.live;
  fail_in_turn([] {
    int stale = 0;
    auto* options = reinterpret_cast<qtraj_options*>(&stale);
    const qtraj_status status = qtraj_options_create(QTRAJ_SQUAD, &options);
    CHECK((status == QTRAJ_OK) == (options != nullptr));
    const int errno_after = errno;
    qtraj_options_destroy(options);
    errno = errno_after;
    return status;
  });
  fail_in_turn([] {
    const double x[] = {0, 1, 3, 4}, y[] = {1, 2, 0, 5};
    double y_out[] = {77, 77, 77, 77};
    size_t bad_index = 3;
    const qtraj_status status =
        qtraj_cubic_spline(x, y, 4, 1, QTRAJ_END_DEFAULT, QTRAJ_END_DEFAULT, x, 4, y_out, &bad_index);
    CHECK(bad_index == SIZE_MAX);
    CHECK((status == QTRAJ_OK) == (y_out[0] != 77));
    return status;
  });
  CHECK(allocations.live == live);
}

TEST_CASE("C API: a batch allocates once, in memory of the caller never, and without memory writes nothing",
          "[robust][memory]") {
  const int live = allocations.live;
  for (const Variant& variant : variants()) {
    if (variant.needs_tangents()) continue;
    CAPTURE(variant.name);
    const Table<double> table(9, variant);
    const Options options = make_options(variant);
    std::vector<int32_t> statuses(9, 77);
    const int times_failed = fail_in_turn([&] {
      Motion<double> out(table.rows());
      out.q[0] = 77;
      BatchCall<double> call = table.call(options.get(), out, true);
      call.status_out = statuses.data();
      size_t bad_index = 3;
      const qtraj_status status = call(&bad_index);
      const int errno_after = errno;
      CHECK(bad_index == SIZE_MAX);
      CHECK((status == QTRAJ_OK) == (statuses[0] == QTRAJ_OK));
      CHECK((status == QTRAJ_OK) == (out.q[0] != 77));
      errno = errno_after;
      return status;
    });
    CHECK(times_failed == 1);
    size_t bytes = 0;
    REQUIRE(qtraj_init_size(options.get(), table.longest(), &bytes) == QTRAJ_OK);
    std::vector<double> memory(bytes / sizeof(double));
    Motion<double> out(table.rows());
    BatchCall<double> call = table.call(options.get(), out, true);
    call.memory = memory.data(), call.bytes = bytes, call.sample_times = nullptr;
    must_not_allocate([&] { CHECK(call(nullptr) == QTRAJ_OK); });
  }
  CHECK(allocations.live == live);
}

TEST_CASE("C API: sampling, curve diagnostics and functions over arrays allocate nothing", "[robust][memory]") {
  for (const Variant& variant : variants()) {
    CAPTURE(variant.name);
    const Keyframes<double> keys = closed_tour<double>(12);
    const Trajectory curve = must_build(make_options(variant).get(), keys, rates_for<double>(variant, 12));
    const std::vector<double> times = times_in(keys.times, 30);
    std::vector<double> q(4 * times.size()), omega(3 * times.size()), alpha(3 * times.size());
    must_not_allocate([&] {
      double number;
      sample_rates(curve.get(), QTRAJ_FRAME_BODY, times.data(), times.size(), q.data(), omega.data(), alpha.data(),
                   nullptr);
      qtraj_curve_energy(curve.get(), &number);
      qtraj_curve_total_angle(curve.get(), &number);
      qtraj_curve_peak_rates(curve.get(), &number, nullptr, &number, nullptr);
      qtraj_curve_least_norm(curve.get(), &number, nullptr);
      qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_BODY, omega.data(), alpha.data());
    });
  }
  for (const test::RowFunction<double>& function : test::row_functions(double())) {
    CAPTURE(function.name);
    test::RowArrays<double> arrays(function, 300);
    const std::vector<const double*> inputs = arrays.inputs();
    const std::vector<double*> outputs = arrays.outputs();
    must_not_allocate([&] { function.call(inputs.data(), 300, outputs.data(), nullptr); });
  }
  const std::vector<double> q = test::good_rows<double>(4, 300, 5);
  must_not_allocate([&] {
    double mean[4];
    qtraj_mean_eigen(q.data(), nullptr, 300, mean, nullptr, nullptr);
    qtraj_mean_karcher(q.data(), nullptr, 300, 0, 100, mean, nullptr, nullptr, nullptr);
    const int64_t offsets[] = {0, 100, 300};
    double means[8], moments[11] = {};
    qtraj_batch_mean_eigen(2, offsets, q.data(), nullptr, means, nullptr, nullptr, nullptr);
    qtraj_moments_add(q.data(), nullptr, 300, moments, nullptr);
    qtraj_mean_from_moments(moments, mean, nullptr);
  });
}

}  // namespace

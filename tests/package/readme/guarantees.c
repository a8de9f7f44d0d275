/* docs/guarantees.md: memory, environment, bits. */
#include <errno.h>
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <string.h>

#include "claims.h"

/* Linked with --wrap=malloc: every allocation of the program and of the static library comes through here. */
static size_t allocations = 0, most_allocations = SIZE_MAX; /* after so many malloc has no more */
void* __real_malloc(size_t bytes);
void* __wrap_malloc(size_t bytes);
void* __wrap_malloc(size_t bytes) { return ++allocations > most_allocations ? NULL : __real_malloc(bytes); }

static void check_memory_and_environment(void) {
  static double memory[2048], options_memory[QTRAJ_OPTIONS_BYTES / sizeof(double)];
  static double still[count][3];
  double q[3][4], several[3] = {6, 8, 0.5};
  double rates[6][3];
  qtraj_options* options;
  qtraj_trajectory* trajectory;
  size_t bytes, before = allocations;
  int method;

  qtraj_destroy(build(QTRAJ_SLERP, count, times, keys));
  CHECK(allocations > before); /* they are counted */
  before = allocations;
  errno = 42;
  fesetround(FE_UPWARD);
  feclearexcept(FE_ALL_EXCEPT);
  for (method = 1; method <= methods; ++method) {
    const double* omega = method >= QTRAJ_HERMITE ? still[0] : NULL;
    const double* alpha = method > QTRAJ_HERMITE ? still[0] : NULL;
    CHECK(!qtraj_options_init(options_memory, sizeof options_memory, method, &options));
    CHECK(!qtraj_init_size(options, count, &bytes) && bytes <= sizeof memory);
    CHECK(qtraj_init(memory, bytes - 1, options, QTRAJ_FRAME_BODY, times, keys[0], omega, alpha, NULL, count,
                     &trajectory, NULL) == QTRAJ_E_BUFFER);
    CHECK(qtraj_init((char*)memory + 4, sizeof memory - 4, options, QTRAJ_FRAME_BODY, times, keys[0], omega, alpha,
                     NULL, count, &trajectory, NULL) == QTRAJ_E_BUFFER);
    CHECK(!qtraj_init(memory, bytes, options, QTRAJ_FRAME_BODY, times, keys[0], omega, alpha, NULL, count, &trajectory,
                      NULL));
    qtraj_sample_rates(trajectory, QTRAJ_FRAME_WORLD, several, 3, q[0], rates[0], rates[3], NULL);
    qtraj_curve_peak_rates(trajectory, &q[0][0], NULL, NULL, NULL);
    qtraj_sample(trajectory, several, 3, q[0], NULL);
    qtraj_sample_uniform(trajectory, 0, 1e300, 3, q[0], NULL);
    qtraj_sample_at(trajectory, NAN, NULL, q[0]);
    qtraj_destroy(trajectory);
  }
  CHECK(allocations == before);
  CHECK(errno == 42);
  CHECK(fegetround() == FE_UPWARD);
  CHECK(fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) == 0);
  fesetround(FE_TONEAREST);
}

/* qtraj_check_keys takes memory where times are out of order; without it nothing is written. */
static void check_memory_of_check_keys(void) {
  const double mixed[count] = {0, 2, 1, 3, 4, 5, 6, 7};
  const size_t before = allocations;
  int32_t statuses[count];
  qtraj_key_report report;
  size_t bad, given;
  CHECK(!qtraj_check_keys(times, keys[0], count, statuses, &report, &bad));
  CHECK(allocations == before);
  CHECK(qtraj_check_keys(mixed, keys[0], count, statuses, &report, &bad) == QTRAJ_E_TIME_ORDER && bad == 2);
  CHECK(allocations > before);
  report.faults = 7;
  statuses[2] = 77;
  for (given = 0; given < 2; ++given) {
    most_allocations = allocations + given;
    CHECK(qtraj_check_keys(mixed, keys[0], count, statuses, &report, &bad) == QTRAJ_E_NO_MEMORY && bad == SIZE_MAX);
    CHECK(report.faults == 7 && statuses[2] == 77);
  }
  most_allocations = SIZE_MAX;
}

static void check_bits(void) {
  enum { samples = 200 };
  static double at[samples], forward[samples][4], other[samples][4], backward[samples][4];
  float single[4];
  int method, i, k;
  for (method = 1; method <= methods; ++method) {
    qtraj_trajectory* trajectory = build(method, count, times, keys);
    size_t cursor = 1234;
    qtraj_sample_uniform(trajectory, 0.01, 0.034, samples, forward[0], NULL);
    for (i = 0; i < samples; ++i) at[i] = 0.01 + (double)i * 0.034;
    qtraj_sample(trajectory, at, 7, other[0], NULL); /* split */
    qtraj_sample(trajectory, at + 7, samples - 7, other[7], NULL);
    CHECK(memcmp(forward, other, sizeof forward) == 0);
    for (i = 0; i < samples; ++i) at[i] = 0.01 + (double)(samples - 1 - i) * 0.034;
    qtraj_sample(trajectory, at, samples, backward[0], NULL);
    for (i = 0; i < samples; ++i) {
      double norm = 0;
      CHECK(memcmp(forward[i], backward[samples - 1 - i], sizeof forward[i]) == 0);
      qtraj_sample_at(trajectory, at[samples - 1 - i], &cursor, other[i]);
      CHECK(memcmp(forward[i], other[i], sizeof forward[i]) == 0);
      qtraj_sample_at_f32(trajectory, at[samples - 1 - i], NULL, single);
      for (k = 0; k < 4; ++k) {
        norm += other[i][k] * other[i][k];
        CHECK(fabs(single[k] - other[i][k]) < 1.5e-6);
      }
      CHECK(fabs(sqrt(norm) - 1) <= 4 * DBL_EPSILON);
    }
    qtraj_destroy(trajectory);
  }
  {
    static const char* const targets[] = {"avx512 fused", "avx2 fused", "neon fused", "sse4 plain", "scalar plain"};
    int known = 0;
    for (i = 0; i < 5; ++i) known += strcmp(qtraj_target(), targets[i]) == 0;
    CHECK(known == 1);
  }
}

void check_guarantees(void) {
  check_memory_and_environment();
  check_memory_of_check_keys();
  check_bits();
}

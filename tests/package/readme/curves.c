/* docs/curves.md: what becomes of the keys, uniform and even times, cursors, many curves, what a trajectory tells. */
#include <math.h>
#include <string.h>

#include "claims.h"

static void check_keys(void) {
  double q[4], messy[count][4];
  qtraj_trajectory* trajectory;
  int i, k, method;
  size_t flips = 0;
  for (i = 0; i < count; ++i)
    for (k = 0; k < 4; ++k) messy[i][k] = (i % 3 == 1 ? -3.0 : 1.0) * keys[i][k];
  for (i = 0; i < count; ++i) flips += i % 3 == 1;
  for (method = 1; method <= methods; ++method) {
    trajectory = build(method, count, times, messy);
    CHECK(qtraj_sign_flips(trajectory) == flips);
    CHECK(fabs(qtraj_worst_norm_error(trajectory) - 2) < 1e-14);
    for (i = 0; i < count; ++i) {
      qtraj_sample_at(trajectory, times[i], NULL, q);
      for (k = 0; k < 4; ++k) CHECK(fabs(q[k] - keys[i][k]) < 4e-15);
    }
    CHECK(difference(trajectory, build(method, count, times, keys)) < 1e-14);
  }
  { /* half a turn apart: the sign given decides the way round */
    double ahead[2][4] = {{1, 0, 0, 0}, {0, 0, 0, 1}}, back[2][4] = {{1, 0, 0, 0}, {0, 0, 0, -1}};
    const double quarter = sqrt(0.5);
    trajectory = build(QTRAJ_SLERP, 2, times, ahead);
    qtraj_sample_at(trajectory, 0.5, NULL, q);
    CHECK(fabs(q[3] - quarter) < 1e-15 && qtraj_sign_flips(trajectory) == 0 && qtraj_least_dot(trajectory) == 0);
    qtraj_destroy(trajectory);
    trajectory = build(QTRAJ_SLERP, 2, times, back);
    qtraj_sample_at(trajectory, 0.5, NULL, q);
    CHECK(fabs(q[3] + quarter) < 1e-15);
    qtraj_destroy(trajectory);
  }
  { /* norms from 1e-160 to 1e160 */
    double tiny[2][4] = {{1e-160, 0, 0, 0}, {0, 0, 0, 1e160}}, plain[2][4] = {{1, 0, 0, 0}, {0, 0, 0, 1}};
    CHECK(difference(build(QTRAJ_SLERP, 2, times, tiny), build(QTRAJ_SLERP, 2, times, plain)) == 0);
  }
}

static void check_times(void) {
  double even[11], uniform[11][4], at[11][4], q[4];
  size_t cursor = 12345; /* any value */
  qtraj_trajectory* curve = build(QTRAJ_SQUAD, count, times, keys);
  int i;
  CHECK(!qtraj_even_times(0, 1, 11, even) && even[3] == 0.3 && even[10] == 1);
  CHECK(0 + 3 * 0.1 != 0.3); /* as qtraj_sample_uniform forms it */
  CHECK(!qtraj_even_times(0, 7, 11, even) && even[0] == 0 && even[10] == 7);
  CHECK(!qtraj_sample_uniform(curve, 0.01, 0.1, 11, uniform[0], NULL));
  for (i = 0; i < 11; ++i) {
    volatile double product = (double)i * 0.1; /* rounded after each operation */
    CHECK(!qtraj_sample_at(curve, 0.01 + product, &cursor, q) && memcmp(q, uniform[i], sizeof q) == 0);
    even[i] = 0.01 + product;
  }
  CHECK(!qtraj_sample(curve, even, 11, at[0], NULL) && memcmp(at, uniform, sizeof at) == 0);
  qtraj_destroy(curve);
}

static void check_many_curves(void) {
  const double at[2] = {0.3, 1.1};
  const qtraj_trajectory* rig[2];
  double by_curve[2][2][4], by_time[2][2][4], alone[2][4];
  int curve, i;
  rig[0] = build(QTRAJ_SLERP, count, times, keys);
  rig[1] = build(QTRAJ_SQUAD, count, times, keys);
  CHECK(
      !qtraj_sample_many(rig, 2, QTRAJ_FRAME_BODY, at, 2, QTRAJ_LAYOUT_SERIES_FIRST, by_curve[0][0], NULL, NULL, NULL));
  CHECK(!qtraj_sample_many(rig, 2, QTRAJ_FRAME_BODY, at, 2, QTRAJ_LAYOUT_TIME_FIRST, by_time[0][0], NULL, NULL, NULL));
  for (curve = 0; curve < 2; ++curve) {
    CHECK(!qtraj_sample(rig[curve], at, 2, alone[0], NULL));
    for (i = 0; i < 2; ++i) {
      CHECK(memcmp(by_curve[curve][i], alone[i], sizeof alone[i]) == 0);
      CHECK(memcmp(by_time[i][curve], alone[i], sizeof alone[i]) == 0);
    }
    qtraj_destroy((qtraj_trajectory*)rig[curve]);
  }
}

static void check_getters(void) {
  double t[count], q[count][4];
  qtraj_trajectory* curve = build(QTRAJ_HERMITE, count, times, keys);
  int i, k;
  CHECK(qtraj_method(curve) == QTRAJ_HERMITE && qtraj_key_count(curve) == count);
  CHECK(qtraj_start_time(curve) == times[0] && qtraj_end_time(curve) == times[count - 1]);
  CHECK(!qtraj_keys(curve, t, q[0]) && memcmp(t, times, sizeof t) == 0);
  for (i = 0; i < count; ++i)
    for (k = 0; k < 4; ++k) CHECK(fabs(q[i][k] - keys[i][k]) < 1e-15);
  CHECK(qtraj_least_dot(curve) > 0 && qtraj_least_dot(curve) < 1);
  qtraj_destroy(curve);

  CHECK(qtraj_method(NULL) == 0 && qtraj_key_count(NULL) == 0 && qtraj_sign_flips(NULL) == 0);
  CHECK(qtraj_iterations(NULL) == 0 && isnan(qtraj_residual(NULL)) && isnan(qtraj_least_dot(NULL)));
  CHECK(isnan(qtraj_start_time(NULL)) && isnan(qtraj_end_time(NULL)) && isnan(qtraj_worst_norm_error(NULL)));
  CHECK(strcmp(qtraj_version(), QTRAJ_VERSION_STRING) == 0 && qtraj_version_number() == QTRAJ_VERSION_NUMBER);
}

/* Three series: the keys, one key alone, and the keys again, of which a slice is sampled. */
static void check_batches(void) {
  const int64_t key_offsets[] = {0, count, count + 1, 2 * count + 1}, sample_offsets[] = {5, 10, 12, 17};
  double t[2 * count + 1], q[2 * count + 1][4], out[20][4], even[5], alone[5][4];
  int32_t statuses[3];
  size_t bad;
  qtraj_options* options = options_of(QTRAJ_SQUAD);
  qtraj_trajectory* curve = build(QTRAJ_SQUAD, count, times, keys);
  memcpy(t, times, sizeof times);
  memcpy(q, keys, sizeof keys);
  memcpy(t + count, times, sizeof times[0]);
  memcpy(q + count, keys, sizeof keys[0]);
  memcpy(t + count + 1, times, sizeof times);
  memcpy(q + count + 1, keys, sizeof keys);
  out[4][0] = out[17][0] = 7;
  CHECK(qtraj_batch_sample(options, 3, key_offsets, t, q[0], sample_offsets, NULL, NULL, 0, out[0], statuses, &bad) ==
        QTRAJ_E_TOO_FEW);
  CHECK(bad == 1 && statuses[0] == QTRAJ_OK && statuses[1] == QTRAJ_E_TOO_FEW && statuses[2] == QTRAJ_OK);
  CHECK(isnan(out[10][0]) && isnan(out[11][3]) && out[4][0] == 7 && out[17][0] == 7);
  /* evenly from the first to the last key, to the last bit what the curve alone gives */
  CHECK(!qtraj_even_times(times[0], times[count - 1], 5, even) && !qtraj_sample(curve, even, 5, alone[0], NULL));
  CHECK(memcmp(out[5], alone, sizeof alone) == 0 && memcmp(out[12], alone, sizeof alone) == 0);
  /* the last of the three is a call of its own */
  memset(out, 0, sizeof out);
  CHECK(
      !qtraj_batch_sample(options, 1, key_offsets + 2, t, q[0], sample_offsets + 2, NULL, NULL, 0, out[0], NULL, NULL));
  CHECK(memcmp(out[12], alone, sizeof alone) == 0 && out[11][0] == 0);
  CHECK(!qtraj_options_set_longest_gap(options, 0.5));
  CHECK(qtraj_batch_sample(options, 3, key_offsets, t, q[0], sample_offsets, NULL, NULL, 0, out[0], statuses, NULL) ==
        QTRAJ_E_GAP);
  qtraj_destroy(curve);
  qtraj_options_destroy(options);
}

void check_curves(void) {
  check_keys();
  check_times();
  check_many_curves();
  check_batches();
  check_getters();
}

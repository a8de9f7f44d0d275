/* docs/functions.md: pairs, keys, algebra, means, sample diagnostics, spline. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "claims.h"

static const double identity[4] = {1, 0, 0, 0};

static double angle_between(const double a[4], const double b[4]) {
  double angle;
  CHECK(!qtraj_rotation_angle(a, 1, b, 1, 1, &angle, NULL));
  return angle;
}

static void check_paths(void) {
  const double fraction[5] = {0, 0.5, 1, 0.25, 3.5}, opposite[4] = {-3, 0, 0, 0};
  double b[4], minus_b[4], q[5][4], steps[3];
  size_t bad;
  int k;
  turn(1.2, 1, 2, 3, b);
  for (k = 0; k < 4; ++k) minus_b[k] = -b[k];
  CHECK(qtraj_slerp(identity, b, fraction, 5, 0, q[0], NULL) == QTRAJ_E_VALUE);
  CHECK(!qtraj_slerp(identity, minus_b, fraction, 5, QTRAJ_PATH_SHORTEST, q[0], NULL));
  CHECK(memcmp(q[0], identity, sizeof identity) == 0 && fabs(q[2][0] - b[0]) < 1e-15);
  for (k = 0; k < 3; ++k) steps[k] = angle_between(identity, q[k == 0 ? 3 : k]);
  CHECK(fabs(steps[0] - 0.3) < 1e-15 && fabs(steps[1] - 0.6) < 1e-15 && fabs(steps[2] - 1.2) < 1e-15);
  CHECK(fabs(angle_between(identity, q[4]) - (8 * atan(1.0) - 1.2 * 3.5)) < 1e-14);
  CHECK(!qtraj_slerp(identity, minus_b, fraction, 5, QTRAJ_PATH_AS_GIVEN, q[0], NULL));
  CHECK(fabs(q[2][0] + b[0]) < 1e-15 && angle_between(identity, q[1]) > 2.5);

  /* antipodal: a full turn about the body's x axis; for nlerp no turn, and nothing half way */
  CHECK(qtraj_slerp(identity, opposite, fraction, 5, QTRAJ_PATH_AS_GIVEN, q[0], &bad) == QTRAJ_E_AMBIGUOUS && bad == 0);
  CHECK(fabs(q[1][1] - 1) < 1e-15 && fabs(q[3][1] - sqrt(0.5)) < 1e-15 && fabs(q[2][0] + 1) < 1e-15);
  CHECK(qtraj_nlerp(identity, opposite, fraction, 5, QTRAJ_PATH_AS_GIVEN, q[0], &bad) == QTRAJ_E_ZERO_NORM && bad == 1);
  CHECK(isnan(q[1][0]) && q[3][0] == 1 && q[2][0] == -1);
}

static void check_keys_and_algebra(void) {
  const double minus_one[4] = {-1, 0, 0, 0};
  double v[3], matrix[9], off[9], q[4], flipped[3][4];
  size_t flips, bad;
  int k;
  CHECK(qtraj_log(minus_one, 1, v, &bad) == QTRAJ_E_AMBIGUOUS && fabs(v[0] - 4 * atan(1.0)) < 1e-15);
  CHECK(v[1] == 0 && v[2] == 0);
  CHECK(!qtraj_matrix_from_q(keys[3], 1, matrix, NULL) && !qtraj_q_from_matrix(matrix, 1, 0, q, NULL, NULL));
  CHECK(angle_between(keys[3], q) < 1e-15 && q[0] >= 0);
  for (k = 0; k < 9; ++k) off[k] = 1.01 * matrix[k];
  CHECK(qtraj_q_from_matrix(off, 1, 0, q, NULL, &bad) == QTRAJ_E_NOT_ROTATION && bad == 0 && isnan(q[0]));
  CHECK(!qtraj_q_from_matrix(off, 1, 0.02, q, v, NULL) && fabs(v[0] - 0.01 * sqrt(3.0)) < 1e-12);
  for (k = 0; k < 9; ++k) off[k] = floor(1000 * matrix[k] + 0.5) / 1000;
  CHECK(!qtraj_q_from_matrix(off, 1, 2e-3, q, NULL, NULL));
  for (k = 0; k < 9; ++k) off[k] = -matrix[k];
  CHECK(qtraj_q_from_matrix(off, 1, 0, q, NULL, NULL) == QTRAJ_E_NOT_ROTATION);

  for (k = 0; k < 4; ++k) {
    flipped[0][k] = flipped[2][k] = 5 * keys[0][k];
    flipped[1][k] = -keys[1][k];
  }
  CHECK(!qtraj_make_continuous(flipped[0], 1, 3, flipped[0], &flips, NULL) && flips == 1);
  CHECK(flipped[1][0] == keys[1][0] && flipped[0][0] == 5 * keys[0][0]);
  CHECK(qtraj_normalize(flipped[0], 2, flipped[1], NULL) == QTRAJ_E_OVERLAP);
}

static void check_means(void) {
  const double apart[2][4] = {{1, 0, 0, 0}, {0, 0, 0, -1}}, heavy[2] = {2, 1}, none[2] = {0, 0}, below[2] = {1, -1};
  double q[4], r[4], gap, twice[3][4];
  size_t bad;
  int k;
  CHECK(qtraj_mean_eigen(apart[0], NULL, 2, q, &gap, NULL) == QTRAJ_E_AMBIGUOUS && gap < 1e-15 && !isnan(q[0]));
  CHECK(!qtraj_mean_eigen(apart[0], heavy, 2, q, &gap, NULL) && fabs(gap - 1 / 3.0) < 1e-15);
  CHECK(qtraj_mean_karcher(apart[0], NULL, 2, 0, 50, q, NULL, NULL, NULL) == QTRAJ_E_AMBIGUOUS && !isnan(q[0]));
  CHECK(qtraj_mean_karcher(apart[0], heavy, 2, 0, 50, q, NULL, NULL, NULL) == QTRAJ_E_AMBIGUOUS && !isnan(q[0]));
  CHECK(qtraj_mean_eigen(apart[0], none, 2, q, NULL, &bad) == QTRAJ_E_ZERO_NORM && bad == SIZE_MAX && isnan(q[0]));
  CHECK(qtraj_mean_eigen(apart[0], below, 2, q, NULL, &bad) == QTRAJ_E_NEGATIVE_WEIGHT && bad == 1);
  { /* weight 0 does not excuse a row */
    const double lost[2][4] = {{1, 0, 0, 0}, {0, 0, 0, 0}}, first_only[2] = {1, 0};
    size_t at;
    CHECK(qtraj_mean_eigen(lost[0], first_only, 2, q, NULL, &at) == QTRAJ_E_ZERO_NORM && at == 1);
  }
  CHECK(qtraj_mean_eigen(apart[0], NULL, 0, q, NULL, NULL) == QTRAJ_E_TOO_FEW);
  CHECK(qtraj_mean_karcher(apart[0], NULL, 2, -1, 50, q, NULL, NULL, NULL) == QTRAJ_E_VALUE);
  CHECK(qtraj_mean_karcher(apart[0], NULL, 2, 0, 0, q, NULL, NULL, NULL) == QTRAJ_E_VALUE);
  CHECK(qtraj_mean_karcher(keys[0], NULL, 3, 0, 1, q, NULL, NULL, NULL) == QTRAJ_E_NO_CONVERGENCE);

  /* weight 2 is the same sample twice; signs do not matter but for the first */
  memcpy(twice[0], keys[0], sizeof keys[0]);
  for (k = 0; k < 4; ++k) {
    twice[1][k] = -keys[0][k];
    twice[2][k] = 1e100 * keys[1][k];
  }
  CHECK(!qtraj_mean_karcher(keys[0], heavy, 2, 0, 50, q, NULL, NULL, NULL));
  CHECK(!qtraj_mean_karcher(twice[0], NULL, 3, 0, 50, r, NULL, NULL, NULL));
  for (k = 0; k < 4; ++k) CHECK(fabs(q[k] - r[k]) < 1e-15);
  CHECK(!qtraj_mean_eigen(twice[1], NULL, 1, q, NULL, NULL) && fabs(q[0] + keys[0][0]) < 1e-15);
}

static void check_samples(void) {
  double t[count], q[count][4], omega[count - 1][3], energy, jump[2][3], error[2];
  const double knots[2] = {1, 4.1};
  size_t bad, nearest[2];
  memcpy(t, times, sizeof t);
  memcpy(q, keys, sizeof q);
  q[6][1] = NAN;
  CHECK(qtraj_estimate_omega(QTRAJ_FRAME_BODY, t, q[0], count, NULL, omega[0], &bad) == QTRAJ_E_NOT_FINITE && bad == 6);
  CHECK(!isnan(omega[4][0]) && isnan(omega[5][0]) && isnan(omega[6][0]));
  CHECK(qtraj_estimate_energy(QTRAJ_FRAME_BODY, t, q[0], count, &energy, &bad) == QTRAJ_E_NOT_FINITE && bad == 6);
  CHECK(isnan(energy));
  /* knot 0 does not use it, knot 1 lies between samples 4 and 5 and does */
  CHECK(qtraj_estimate_jumps(QTRAJ_FRAME_BODY, t, q[0], count, knots, 2, jump[0], &bad) == QTRAJ_E_NOT_FINITE);
  CHECK(bad == 6 && !isnan(jump[0][0]) && isnan(jump[1][0]));
  CHECK(qtraj_keyframe_errors(knots, keys[1], 2, t, q[0], count, error, nearest, &bad) == QTRAJ_E_NOT_FINITE);
  CHECK(bad == 2 + 6 && error[0] < 1e-15 && nearest[0] == 1 && !isnan(error[1]) && nearest[1] == 4);
  t[6] = 4; /* a time at fault: nothing can be looked up */
  CHECK(qtraj_estimate_jumps(QTRAJ_FRAME_BODY, t, keys[0], count, knots, 2, jump[0], &bad) == QTRAJ_E_TIME_ORDER);
  CHECK(bad == 6 && isnan(jump[0][0]) && isnan(jump[1][0]));
  CHECK(qtraj_keyframe_errors(knots, keys[1], 2, t, keys[0], count, error, NULL, &bad) == QTRAJ_E_TIME_ORDER);
  CHECK(bad == 2 + 6 && isnan(error[0]) && isnan(error[1]));
  { /* half a turn apart */
    const double half[2][4] = {{1, 0, 0, 0}, {0, 0, 2, 0}};
    CHECK(qtraj_estimate_omega(QTRAJ_FRAME_WORLD, times, half[0], 2, NULL, omega[0], &bad) == QTRAJ_E_AMBIGUOUS);
    CHECK(bad == 1 && fabs(omega[0][1] - 4 * atan(1.0)) < 1e-14);
  }
}

static void check_spline(void) {
  const double at[2] = {2, 8};
  double y[count][2], out[2][2];
  size_t bad;
  int i, k;
  for (i = 0; i < count; ++i) {
    y[i][0] = 3 - 2 * times[i];
    y[i][1] = times[i] * times[i] * times[i];
  }
  for (k = 0; k < 7; ++k) {
    const int32_t end = k == 0 ? QTRAJ_END_DEFAULT : QTRAJ_END_CHORD + k - 1;
    const int has = end == QTRAJ_END_DEFAULT || end == QTRAJ_END_NATURAL || end == QTRAJ_END_NOT_A_KNOT;
    const qtraj_status status = qtraj_cubic_spline(times, y[0], count, 2, end, end, at, 2, out[0], &bad);
    CHECK(status == (has ? QTRAJ_E_TIME_RANGE : end == QTRAJ_END_PERIODIC ? QTRAJ_E_NOT_CLOSED : QTRAJ_E_VALUE));
    if (!has) continue;
    CHECK(bad == count + 1 && fabs(out[0][0] + 1) < 1e-14 && isnan(out[1][0]) && isnan(out[1][1]));
    CHECK((fabs(out[0][1] - 8) < 1e-12) == (end == QTRAJ_END_NOT_A_KNOT)); /* NATURAL bends no cubic */
  }
}

/* float twins compute in double and round once */
static void check_float(void) {
  enum { samples = 100 };
  float a[4], b[4], single[samples][4], single_fractions[samples];
  double wide_a[4], wide_b[4], fractions[samples], wide[samples][4];
  int i, k;
  for (k = 0; k < 4; ++k) {
    wide_a[k] = a[k] = (float)keys[2][k];
    wide_b[k] = b[k] = (float)keys[5][k];
  }
  for (i = 0; i < samples; ++i) fractions[i] = single_fractions[i] = 0.037f * (float)(i - 20);
  CHECK(!qtraj_slerp(wide_a, wide_b, fractions, samples, QTRAJ_PATH_AS_GIVEN, wide[0], NULL));
  CHECK(!qtraj_slerp_f32(a, b, single_fractions, samples, QTRAJ_PATH_AS_GIVEN, single[0], NULL));
  for (i = 0; i < samples; ++i)
    for (k = 0; k < 4; ++k) CHECK(single[i][k] == (float)wide[i][k]);
}

/* Moments of two parts, added number by number, have the mean of all; w >= 0. */
static void check_moments(void) {
  double moments[2][11] = {{0}}, mean[4], whole[4], angle;
  int k;
  CHECK(!qtraj_moments_add(keys[0], NULL, 3, moments[0], NULL));
  CHECK(!qtraj_moments_add(keys[3], NULL, count - 3, moments[1], NULL));
  for (k = 0; k < 11; ++k) moments[0][k] += moments[1][k];
  CHECK(moments[0][0] == count);
  CHECK(!qtraj_mean_from_moments(moments[0], mean, NULL) && mean[0] >= 0);
  CHECK(!qtraj_mean_eigen(keys[0], NULL, count, whole, NULL, NULL));
  CHECK(!qtraj_rotation_angle(mean, 1, whole, 1, 1, &angle, NULL) && angle < 1e-14);
}

static void check_screws_and_tables(void) {
  const double p_a[3] = {1, 2, 3}, p_b[3] = {3, 2, 1}, fractions[3] = {0, 0.5, 1}, half_turn[4] = {0, 0, 0, 2};
  const double w[3] = {1, 2, 3}, x[3] = {4, 5, 6}, *columns[2] = {w, x};
  double b[4], q[3][4], p[3][3], moved[3][3], shifted_a[3], shifted_b[3], rows[3][2], back[2][3];
  double* columns_out[2] = {back[0], back[1]};
  size_t bad;
  int i, k;
  turn(1.2, 1, 2, 3, b);
  CHECK(!qtraj_screw_pairs(identity, p_a, 1, b, p_b, 1, fractions, 3, 3, q[0], p[0], NULL));
  CHECK(memcmp(p[0], p_a, sizeof p_a) == 0 && memcmp(p[2], p_b, sizeof p_b) == 0);
  /* another origin of the world moves all positions alike */
  for (k = 0; k < 3; ++k) shifted_a[k] = p_a[k] + 10, shifted_b[k] = p_b[k] + 10;
  CHECK(!qtraj_screw_pairs(identity, shifted_a, 1, b, shifted_b, 1, fractions, 3, 3, q[0], moved[0], NULL));
  for (i = 0; i < 3; ++i)
    for (k = 0; k < 3; ++k) CHECK(fabs(moved[i][k] - p[i][k] - 10) < 1e-14);
  /* no turn: the straight line; half a turn: one of two */
  CHECK(!qtraj_screw_pairs(b, p_a, 1, b, p_b, 1, fractions, 3, 3, q[0], p[0], NULL));
  CHECK(p[1][0] == 2 && p[1][1] == 2 && p[1][2] == 2);
  CHECK(qtraj_screw_pairs(identity, p_a, 1, half_turn, p_b, 1, fractions, 3, 3, q[0], p[0], &bad) == QTRAJ_E_AMBIGUOUS);
  CHECK(bad == 0 && fabs(q[1][3] - sqrt(0.5)) < 1e-15 && memcmp(p[2], p_b, sizeof p_b) == 0);

  CHECK(!qtraj_rows_from_columns(columns, 2, 3, rows[0]));
  CHECK(!qtraj_columns_from_rows(rows[0], 2, 3, columns_out));
  for (i = 0; i < 3; ++i) CHECK(rows[i][0] == w[i] && rows[i][1] == x[i] && back[0][i] == w[i] && back[1][i] == x[i]);
}

void check_functions(void) {
  check_paths();
  check_screws_and_tables();
  check_keys_and_algebra();
  check_means();
  check_samples();
  check_spline();
  check_float();
  check_moments();
}

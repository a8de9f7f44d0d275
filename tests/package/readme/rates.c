/* docs/rates.md: rates and curve diagnostics. */
#include <math.h>
#include <string.h>

#include "claims.h"

/* Compiles as it stands there. */
static void run_snippet(const qtraj_trajectory* curve) {
  enum { rows = 3 };
  const double sample_times[rows] = {0.5, 1, 1.2};
  double omegas[rows][3], alphas[rows][3];
  {
    const double* times = sample_times;
    const size_t count = rows;
#include "rates_snippet.c"
    CHECK(one == QTRAJ_OK && many == QTRAJ_OK);
    CHECK(fabs(length(omega) - length(omegas[1])) < 1e-14 && fabs(length(alpha) - length(alphas[1])) < 1e-13);
    CHECK(fabs(q[0]) < 1);
  }
}

/* 2 q' q^-1 (world) or 2 q^-1 q' (body), by differences. */
static void turning(const qtraj_trajectory* curve, double time, int32_t frame, double omega[3]) {
  const double h = 1e-5;
  const double sign = frame == QTRAJ_FRAME_WORLD ? -1 : 1; /* of the cross product in the quaternion product */
  double q[4], before[4], after[4], d[4];
  int k;
  qtraj_sample_at(curve, time, NULL, q);
  qtraj_sample_at(curve, time - h, NULL, before);
  qtraj_sample_at(curve, time + h, NULL, after);
  for (k = 0; k < 4; ++k) d[k] = (after[k] - before[k]) / h; /* 2 q' */
  omega[0] = q[0] * d[1] - q[1] * d[0] - sign * (q[2] * d[3] - q[3] * d[2]);
  omega[1] = q[0] * d[2] - q[2] * d[0] - sign * (q[3] * d[1] - q[1] * d[3]);
  omega[2] = q[0] * d[3] - q[3] * d[0] - sign * (q[1] * d[2] - q[2] * d[1]);
}

/* R v for the rotation of q. */
static void to_world(const double q[4], const double v[3], double out[3]) {
  out[0] = (1 - 2 * (q[2] * q[2] + q[3] * q[3])) * v[0] + 2 * (q[1] * q[2] - q[0] * q[3]) * v[1] +
           2 * (q[1] * q[3] + q[0] * q[2]) * v[2];
  out[1] = 2 * (q[1] * q[2] + q[0] * q[3]) * v[0] + (1 - 2 * (q[1] * q[1] + q[3] * q[3])) * v[1] +
           2 * (q[2] * q[3] - q[0] * q[1]) * v[2];
  out[2] = 2 * (q[1] * q[3] - q[0] * q[2]) * v[0] + 2 * (q[2] * q[3] + q[0] * q[1]) * v[1] +
           (1 - 2 * (q[1] * q[1] + q[2] * q[2])) * v[2];
}

static double apart(const double a[3], const double b[3]) {
  const double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  return length(d);
}

static void check_frames(const qtraj_trajectory* curve) {
  const int32_t frames[2] = {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD};
  const double h = 1e-5;
  double time, q[4], plain[4], omega[2][3], alpha[2][3], expected[3], before[3], after[3], turned[3], alone[3];
  int f, k;
  for (time = 0.05; time < 7; time += 0.31) {
    for (f = 0; f < 2; ++f) {
      CHECK(!qtraj_sample_rates_at(curve, frames[f], time, NULL, q, omega[f], alpha[f]));
      turning(curve, time, frames[f], expected);
      CHECK(apart(omega[f], expected) < 1e-7);
      CHECK(!qtraj_sample_rates_at(curve, frames[f], time - h, NULL, NULL, before, NULL));
      CHECK(!qtraj_sample_rates_at(curve, frames[f], time + h, NULL, NULL, after, NULL));
      for (k = 0; k < 3; ++k) expected[k] = (after[k] - before[k]) / (2 * h);
      CHECK(apart(alpha[f], expected) < 1e-6);
      /* any subset has the same bits */
      CHECK(!qtraj_sample_rates_at(curve, frames[f], time, NULL, NULL, NULL, alone));
      CHECK(memcmp(alone, alpha[f], sizeof alone) == 0);
    }
    CHECK(!qtraj_sample_at(curve, time, NULL, plain) && memcmp(plain, q, sizeof q) == 0);
    to_world(q, omega[0], turned);
    CHECK(apart(turned, omega[1]) < 1e-14);
    to_world(q, alpha[0], turned);
    CHECK(apart(turned, alpha[1]) < 1e-13);
  }
}

/* Right-hand values at the keys, left-hand at the last. */
static void check_sides(void) {
  qtraj_trajectory* curve = build(QTRAJ_SLERP, count, times, keys);
  double at[3], middle[3], jump[count][3], last[3] = {0};
  int i, k;
  CHECK(!qtraj_curve_jumps(curve, QTRAJ_FRAME_BODY, jump[0], NULL));
  for (i = 0; i < count; ++i) {
    const int segment = i + 1 < count ? i : count - 2;
    CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, times[i], NULL, NULL, at, NULL));
    CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, 0.5 * (times[segment] + times[segment + 1]), NULL, NULL,
                                 middle, NULL));
    CHECK(apart(at, middle) < 1e-14);
    if (i > 0 && i + 1 < count) {
      for (k = 0; k < 3; ++k) last[k] = at[k] - last[k];
      CHECK(apart(jump[i], last) < 1e-14 && length(jump[i]) > 0.01);
    } else {
      CHECK(length(jump[i]) == 0);
    }
    memcpy(last, at, sizeof last);
  }
  qtraj_destroy(curve);
}

static void check_outside(void) {
  double q[4], omega[3], alpha[3], end[3], jump[count][3];
  int method;
  for (method = 1; method <= methods; ++method) {
    qtraj_options* options = options_of(method);
    qtraj_trajectory* curve = with(options, keys);
    CHECK(qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, 7.1, NULL, q, omega, alpha) == QTRAJ_E_TIME_RANGE);
    CHECK(isnan(q[0]) && isnan(omega[1]) && isnan(alpha[2]));
    qtraj_destroy(curve);

    CHECK(!qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE));
    curve = with(options, keys);
    CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_WORLD, -0.1, NULL, NULL, omega, alpha));
    CHECK(length(omega) == 0 && length(alpha) == 0);
    CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_WORLD, 7, NULL, NULL, end, NULL));
    CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_WORLD, 17, NULL, NULL, omega, alpha));
    CHECK(apart(omega, end) < 1e-13 && length(alpha) == 0);
    qtraj_destroy(curve);

    CHECK(!qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC));
    curve = with(options, closed_keys);
    CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_WORLD, 2.5, NULL, NULL, end, NULL));
    CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_WORLD, 2.5 + 7 * 3, NULL, NULL, omega, NULL));
    CHECK(apart(omega, end) < 1e-12);
    if (method == QTRAJ_SLERP) { /* the jump from end to start */
      CHECK(!qtraj_curve_jumps(curve, QTRAJ_FRAME_BODY, jump[0], NULL) && length(jump[0]) > 0.01);
      CHECK(apart(jump[0], jump[count - 1]) == 0);
    }
    qtraj_destroy(curve);
    qtraj_options_destroy(options);
  }
}

static void check_float(void) {
  const double soon[2] = {0, 1e-25};
  double two[2][4], at_rest[2][3] = {{0}}, omega[3], alpha[3];
  float q_f32[4], omega_f32[3], alpha_f32[3];
  qtraj_trajectory* curve;
  int method, k;
  for (method = 1; method <= methods; ++method) {
    curve = build(method, count, times, keys);
    CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, 2.2, NULL, NULL, omega, alpha));
    CHECK(!qtraj_sample_rates_at_f32(curve, QTRAJ_FRAME_BODY, 2.2, NULL, NULL, omega_f32, alpha_f32));
    for (k = 0; k < 3; ++k) {
      CHECK(fabs(omega_f32[k] - omega[k]) <= 1e-5 * length(omega));
      CHECK(fabs(alpha_f32[k] - alpha[k]) <= 1e-5 * fmax(length(alpha), length(omega)));
    }
    qtraj_destroy(curve);
  }
  turn(0, 0, 0, 1, two[0]);
  turn(1, 0, 0, 1, two[1]);
  CHECK(!create_given(QTRAJ_HERMITE, soon, two, at_rest, NULL, 2, &curve, NULL));
  CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, 3e-26, NULL, NULL, omega, alpha) && alpha[2] > 1e50);
  CHECK(qtraj_sample_rates_at_f32(curve, QTRAJ_FRAME_BODY, 3e-26, NULL, q_f32, omega_f32, alpha_f32) ==
        QTRAJ_E_NOT_FINITE);
  CHECK(isnan(q_f32[0]) && isnan(omega_f32[2]) && isnan(alpha_f32[2]));
  qtraj_destroy(curve);
}

/* Against closed forms: the turn by a in time T from rest to rest, angle a (10 u^3 - 15 u^4 + 6 u^5); and SLERP. */
static void check_diagnostics(void) {
  const double a = 2.5, duration[2] = {0, 4}, T = 4;
  double two[2][4], still[2][3] = {{0}}, omega, omega_time, alpha, alpha_time, energy, angle, sum = 0, step, dot;
  qtraj_trajectory* curve;
  int i, k;
  turn(0, 1, 2, 3, two[0]);
  turn(a, 1, 2, 3, two[1]);
  CHECK(!create_given(QTRAJ_ROTATION_QUINTIC, duration, two, still, still, 2, &curve, NULL));
  CHECK(!qtraj_curve_peak_rates(curve, &omega, &omega_time, &alpha, &alpha_time));
  CHECK(!qtraj_curve_energy(curve, &energy) && !qtraj_curve_total_angle(curve, &angle));
  CHECK(fabs(omega / (15.0 / 8 * a / T) - 1) < 1e-9 && fabs(omega_time - 2) < 1e-6);
  CHECK(fabs(alpha / (10 / sqrt(3) * a / (T * T)) - 1) < 1e-9);
  CHECK(fabs(fabs(alpha_time - 2) - T / sqrt(12)) < 1e-6);
  CHECK(fabs(energy / (120.0 / 7 * a * a / (T * T * T)) - 1) < 1e-9 && fabs(angle / a - 1) < 1e-9);
  qtraj_destroy(curve);

  curve = build(QTRAJ_SLERP, count, times, keys);
  for (i = 1; i < count; ++i) {
    for (dot = 0, k = 0; k < 4; ++k) dot += keys[i - 1][k] * keys[i][k];
    step = 2 * acos(dot);
    sum += step;
  }
  CHECK(!qtraj_curve_energy(curve, &energy) && energy < 1e-20);
  CHECK(!qtraj_curve_total_angle(curve, &angle) && fabs(angle / sum - 1) < 1e-9);
  qtraj_destroy(curve);
}

/* A quaternion quintic about z from a key back to it, at the rate w at both ends: with v = u (1 - u) and x = h w the
 * polynomials are 1 - x^2 v^2 / 8 and x/2 v v' (1 + 3 v), the norm |1 - x^2/128| in the middle. */
static void check_small_norm(double least) {
  const double h = 2, x = sqrt(128 * (1 + least)), t[2] = {0, 2};
  const long double exact_x = h * (x / h);
  double q[2][4], omega[2][3] = {{0}}, alpha[2][3] = {{0}}, sample[3], norm, norm_time, peak, peak_time, off = 0;
  qtraj_trajectory* curve;
  int i;
  turn(0, 0, 0, 1, q[0]);
  turn(0, 0, 0, 1, q[1]);
  omega[0][2] = omega[1][2] = x / h;
  CHECK(!create_given(QTRAJ_QUATERNION_QUINTIC, t, q, omega, alpha, 2, &curve, NULL));
  CHECK(!qtraj_curve_least_norm(curve, &norm, &norm_time) && fabs(norm / least - 1) < 1e-6 &&
        fabs(norm_time - 1) < 1e-6);
  CHECK(!qtraj_curve_peak_rates(curve, &peak, &peak_time, NULL, NULL) && fabs(peak_time - 1) < 1e-6);
  for (i = -500; i <= 500; ++i) {
    const double time = 1 + i * 0.01 * least;
    const long double u = time / 2, v = u * (1 - u), dv = 1 - 2 * u;
    const long double a = 1 - exact_x * exact_x * v * v / 8, da = -exact_x * exact_x * v * dv / 4;
    const long double b = exact_x / 2 * v * dv * (1 + 3 * v);
    const long double db = exact_x / 2 * ((dv * dv - 2 * v) * (1 + 3 * v) + 3 * v * dv * dv);
    const long double exact = 2 * (a * db - b * da) / (a * a + b * b) / h;
    CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, time, NULL, NULL, sample, NULL));
    off = fmax(off, fabs((double)(sample[2] - exact)));
    if (i == 0) CHECK(fabs((double)(peak / exact)) - 1 < 1e-9 && fabs((double)(peak / exact)) > 1 - 1e-9);
  }
  CHECK(off <= 1e-13 * fmax(1, 0.01 / least) * peak);
  qtraj_destroy(curve);
}

void check_rates(void) {
  qtraj_trajectory* curve;
  int method;
  for (method = 1; method <= methods; ++method) {
    curve = build(method, count, times, keys);
    check_frames(curve);
    run_snippet(curve);
    qtraj_destroy(curve);
  }
  check_sides();
  check_outside();
  check_float();
  check_diagnostics();
  check_small_norm(0.1);
  check_small_norm(0.01);
  check_small_norm(1e-4);
  check_small_norm(1e-6);
}

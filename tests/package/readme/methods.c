/* docs/methods.md: continuity, reach of a key, two keys, what is said about single methods. */
#include <math.h>
#include <string.h>

#include "claims.h"

/* Largest jumps at the keys relative to the largest rates. */
static void jumps(int32_t method, double* omega, double* alpha) {
  double omega_jump[count][3], alpha_jump[count][3], omega_peak, alpha_peak;
  qtraj_trajectory* curve = build(method, count, times, keys);
  int i;
  CHECK(!qtraj_curve_jumps(curve, QTRAJ_FRAME_WORLD, omega_jump[0], alpha_jump[0]));
  CHECK(!qtraj_curve_peak_rates(curve, &omega_peak, NULL, &alpha_peak, NULL));
  *omega = *alpha = 0;
  for (i = 0; i < count; ++i) {
    *omega = fmax(*omega, length(omega_jump[i]) / omega_peak);
    *alpha = fmax(*alpha, length(alpha_jump[i]) / fmax(alpha_peak, omega_peak));
  }
  qtraj_destroy(curve);
}

static void check_continuity(void) {
  static const int continuity[methods + 1] = {0, 0, 0, 1, 2, 2, 1, 2, 2};
  double omega, alpha;
  int method;
  for (method = 1; method <= methods; ++method) {
    jumps(method, &omega, &alpha);
    CHECK(continuity[method] >= 1 ? omega < 1e-13 : omega > 0.01);
    CHECK(continuity[method] >= 2 ? alpha < 1e-12 : continuity[method] == 0 || alpha > 0.01);
  }
}

static void check_shapes(void) {
  double moved[count][4], q[4], r[4], reference[4];
  qtraj_trajectory *a, *b;
  qtraj_options* options;
  int method;

  /* SQUAD: a segment depends on its own two keys and one more on either side */
  memcpy(moved, keys, sizeof keys);
  turn(1.9, 1, 2, 3, moved[5]);
  a = build(QTRAJ_SQUAD, count, times, keys);
  b = build(QTRAJ_SQUAD, count, times, moved);
  qtraj_sample_at(a, 2.0, NULL, q); /* segment 2: keys 1 to 4 */
  qtraj_sample_at(b, 2.0, NULL, r);
  CHECK(memcmp(q, r, sizeof q) == 0);
  qtraj_sample_at(a, 3.5, NULL, q); /* segment 3: keys 2 to 5 */
  qtraj_sample_at(b, 3.5, NULL, r);
  CHECK(memcmp(q, r, sizeof q) != 0);
  qtraj_destroy(a);
  qtraj_destroy(b);

  /* two keys */
  for (method = QTRAJ_SQUAD; method <= QTRAJ_ROTATION_SPLINE; ++method)
    CHECK(difference(build(method, 2, times, keys), build(QTRAJ_SLERP, 2, times, keys)) < 1e-15);
  CHECK(difference(build(QTRAJ_NLERP, 2, times, keys), build(QTRAJ_SLERP, 2, times, keys)) > 1e-5);
  turn(1.0, 3, -1, 1, reference);
  options = options_of(QTRAJ_LOG_SPLINE);
  CHECK(qtraj_options_set_reference(options, QTRAJ_REFERENCE_GIVEN, reference) == QTRAJ_OK);
  CHECK(qtraj_create_with_options(options, times, keys[0], 2, &a, NULL) == QTRAJ_OK);
  CHECK(difference(a, build(QTRAJ_SLERP, 2, times, keys)) > 1e-6);
  qtraj_options_destroy(options);
}

/* A motion at rest until 3 s, then turning at 1 rad/s. The largest error from `from` to `until`. */
static double start_error(int32_t method, double from, double until) {
  double t[7], q[7][4], sample[4], largest = 0;
  qtraj_trajectory* curve;
  int i;
  for (i = 0; i < 7; ++i) {
    t[i] = i;
    turn(fmax(0, i - 3.0), 0, 0, 1, q[i]);
  }
  curve = build(method, 7, t, q);
  for (i = 0; i <= 100; ++i) {
    const double time = from + (until - from) * i / 100;
    qtraj_sample_at(curve, time, NULL, sample);
    largest = fmax(largest, fabs(sample[3] - sin(0.5 * fmax(0, time - 3))));
  }
  qtraj_destroy(curve);
  return largest;
}

static void check_ripple(void) {
  CHECK(start_error(QTRAJ_SLERP, 0, 6) < 1e-15);
  CHECK(start_error(QTRAJ_SQUAD, 2, 4) > 0.01 && start_error(QTRAJ_SQUAD, 0, 2) < 1e-15);
  CHECK(start_error(QTRAJ_ROTATION_SPLINE, 2, 4) > 0.01 && start_error(QTRAJ_ROTATION_SPLINE, 1, 2) > 1e-3);
  CHECK(start_error(QTRAJ_ROTATION_SPLINE, 0, 1) > 1e-4);
  CHECK(start_error(QTRAJ_ROTATION_SPLINE, 1, 2) < 0.5 * start_error(QTRAJ_ROTATION_SPLINE, 2, 3));
}

static double random_number(uint32_t* state) {
  *state = *state * 1664525u + 1013904223u;
  return (*state >> 8) / 16777216.0;
}

static void check_solver(void) {
  qtraj_trajectory* curve;
  int method;
  for (method = 1; method <= methods; ++method) {
    curve = build(method, count, times, keys);
    CHECK(method == QTRAJ_ROTATION_SPLINE ? qtraj_iterations(curve) >= 4 && qtraj_iterations(curve) <= 8
                                          : qtraj_iterations(curve) == 0);
    CHECK(method == QTRAJ_ROTATION_SPLINE ? qtraj_residual(curve) < 1e-12 : qtraj_residual(curve) == 0);
    qtraj_destroy(curve);
  }
  { /* keys at random, over intervals of 1e-4 to 1 */
    enum { n = 8 };
    double t[n], q[n][4];
    uint32_t state = 9101;
    size_t bad = 0;
    int i, k;
    for (i = 0; i < n; ++i) {
      t[i] = i == 0 ? 0 : t[i - 1] + pow(10, -4 * random_number(&state));
      for (k = 0; k < 4; ++k) {
        double sum = -2;
        int term;
        for (term = 0; term < 4; ++term) sum += random_number(&state);
        q[i][k] = sum;
      }
    }
    CHECK(qtraj_create(QTRAJ_ROTATION_SPLINE, t, q[0], n, &curve, &bad) == QTRAJ_E_NO_CONVERGENCE);
    CHECK(curve == NULL && bad == SIZE_MAX);
  }
}

/* A quintic in four dimensions from one key to one half a turn or no turn away, both with the same rate. */
static qtraj_trajectory* quintic(double angle, double omega_x, double omega_y) {
  const double t[2] = {0, 2};
  double q[2][4], omega[2][3] = {{0}}, alpha[2][3] = {{0}};
  qtraj_trajectory* curve;
  turn(0, 0, 0, 1, q[0]);
  turn(angle, 0, 0, 1, q[1]);
  omega[0][0] = omega[1][0] = omega_x;
  omega[0][1] = omega[1][1] = omega_y;
  CHECK(!create_given(QTRAJ_QUATERNION_QUINTIC, t, q, omega, alpha, 2, &curve, NULL));
  return curve;
}

static void check_norms(void) {
  const double half_turn = 4 * atan(1.0);
  double norm, time, q[4], omega[3], alpha[3], half[2][4] = {{1, 0, 0, 0}, {0, 0, 0, 1}};
  qtraj_trajectory* curve;
  int method;
  for (method = QTRAJ_SQUAD; method < QTRAJ_QUATERNION_QUINTIC; ++method) {
    curve = build(method, count, times, keys);
    CHECK(!qtraj_curve_least_norm(curve, &norm, NULL) && (method == QTRAJ_NLERP ? norm < 1 : norm == 1));
    qtraj_destroy(curve);
  }
  curve = build(QTRAJ_NLERP, 2, times, half);
  CHECK(!qtraj_curve_least_norm(curve, &norm, &time) && fabs(norm - sqrt(0.5)) < 1e-12);
  qtraj_destroy(curve);

  curve = quintic(half_turn, 0, 0);
  CHECK(!qtraj_curve_least_norm(curve, &norm, &time) && fabs(norm - sqrt(0.5)) < 1e-12 && fabs(time - 1) < 1e-6);
  qtraj_destroy(curve);
  curve = quintic(0, 4.2, 3.7);
  CHECK(!qtraj_curve_least_norm(curve, &norm, NULL) && norm < 0.1);
  qtraj_destroy(curve);

  curve = quintic(0, 4, 4); /* through 0 in the middle */
  CHECK(!qtraj_curve_least_norm(curve, &norm, &time) && norm == 0 && time == 1);
  CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, 1, NULL, q, omega, alpha));
  CHECK(q[0] == 1 && q[1] == 0 && q[2] == 0 && q[3] == 0 && length(omega) == 0 && length(alpha) == 0);
  qtraj_destroy(curve);
}

/* By how much a curve about z leaves keys at 0, 0, 90 and 90 degrees, degrees. */
static double overshoot(const qtraj_trajectory* curve) {
  double largest = 0, q[4];
  int i;
  for (i = 0; i <= 30000; ++i) {
    const double time = i / 10000.0;
    double angle, off;
    if (qtraj_sample_at(curve, time, NULL, q) != QTRAJ_OK) return INFINITY;
    angle = 2 * atan2(q[3], q[0]) * 45 / atan(1.0);
    off = time <= 1 ? fabs(angle) : time >= 2 ? fabs(angle - 90) : fmax(-angle, angle - 90);
    largest = fmax(largest, off);
  }
  return largest;
}

static void check_overshoot(void) {
  static const struct {
    int32_t method, end;
    double degrees;
    int32_t tangents;
  } rows[] = {{QTRAJ_SLERP, 0, 0, 0},
              {QTRAJ_NLERP, 0, 0, 0},
              {QTRAJ_SQUAD, 0, 6.7, 0},
              {QTRAJ_SQUAD, QTRAJ_END_CHORD, 6.7, 0},
              {QTRAJ_SQUAD, QTRAJ_END_ESTIMATED, 11.3, 0},
              {QTRAJ_SQUAD, 0, 0, QTRAJ_TANGENT_REST},
              {QTRAJ_SQUAD, QTRAJ_END_CHORD, 0, QTRAJ_TANGENT_REST},
              {QTRAJ_SQUAD, QTRAJ_END_ESTIMATED, 0, QTRAJ_TANGENT_REST},
              {QTRAJ_LOG_SPLINE, 0, 11.5, 0},
              {QTRAJ_LOG_SPLINE, QTRAJ_END_NOT_A_KNOT, 22.7, 0},
              {QTRAJ_ROTATION_SPLINE, 0, 22.7, 0},
              {QTRAJ_ROTATION_SPLINE, QTRAJ_END_CHORD, 8.0, 0},
              {QTRAJ_ROTATION_SPLINE, QTRAJ_END_NATURAL, 11.5, 0},
              {QTRAJ_HERMITE, 0, 0, 0},
              {QTRAJ_ROTATION_QUINTIC, 0, 0, 0},
              {QTRAJ_QUATERNION_QUINTIC, 0, 0, 0},
              {QTRAJ_QUATERNION_HERMITE, 0, 0, 0}};
  const double t[4] = {0, 1, 2, 3}, h = sqrt(0.5);
  const double q[4][4] = {{1, 0, 0, 0}, {1, 0, 0, 0}, {h, 0, 0, h}, {h, 0, 0, h}}, still[4][3] = {{0}},
               still_tangents[4][4] = {{0}};
  size_t row;
  for (row = 0; row < sizeof rows / sizeof rows[0]; ++row) {
    const int32_t method = rows[row].method;
    qtraj_options* options = options_of(method);
    qtraj_trajectory* curve = NULL;
    if (rows[row].end) CHECK(!qtraj_options_set_ends(options, rows[row].end, rows[row].end));
    if (rows[row].tangents) CHECK(!qtraj_options_set_tangents(options, rows[row].tangents));
    if (method == QTRAJ_QUATERNION_HERMITE)
      CHECK(!qtraj_create_with_tangents(options, t, q[0], still_tangents[0], NULL, 4, &curve, NULL));
    else if (method < QTRAJ_HERMITE)
      CHECK(!qtraj_create_with_options(options, t, q[0], 4, &curve, NULL));
    else
      CHECK(!qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, t, q[0], still[0],
                                     method == QTRAJ_HERMITE ? NULL : still[0], 4, &curve, NULL));
    CHECK(fabs(overshoot(curve) - rows[row].degrees) <= 0.051);
    qtraj_destroy(curve);
    qtraj_options_destroy(options);
  }
}

void check_methods(void) {
  check_overshoot();
  check_continuity();
  check_shapes();
  check_ripple();
  check_solver();
  check_norms();
}

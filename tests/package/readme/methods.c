/* The table of methods: smoothness, reach of a key, two keys, order of accuracy. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "claims.h"

/* Largest jump at an inner key of the derivative of this order, from differences of step h. */
static double jump(int32_t method, int order) {
  const double h = 1e-3;
  qtraj_trajectory* trajectory = build(method, count, times, keys);
  double largest = 0, q[5][4];
  int i, j, k;
  for (i = 1; i + 1 < count; ++i) {
    for (j = 0; j < 5; ++j) qtraj_sample_at(trajectory, times[i] + (j - 2) * h, NULL, q[j]);
    for (k = 0; k < 4; ++k) {
      const double before[2] = {(3 * q[2][k] - 4 * q[1][k] + q[0][k]) / (2 * h),
                                (q[2][k] - 2 * q[1][k] + q[0][k]) / (h * h)};
      const double after[2] = {(-3 * q[2][k] + 4 * q[3][k] - q[4][k]) / (2 * h),
                               (q[2][k] - 2 * q[3][k] + q[4][k]) / (h * h)};
      largest = fmax(largest, fabs(after[order - 1] - before[order - 1]));
    }
  }
  qtraj_destroy(trajectory);
  return largest;
}

static void check_curves(void) {
  double moved[count][4], q[4], r[4], reference[4];
  qtraj_trajectory *a, *b;
  qtraj_options* options;
  int method;

  CHECK(jump(QTRAJ_SLERP, 1) > 0.01 && jump(QTRAJ_NLERP, 1) > 0.01);
  CHECK(jump(QTRAJ_SQUAD, 1) < 1e-5 && jump(QTRAJ_SQUAD, 2) > 0.01);
  CHECK(jump(QTRAJ_LOG_SPLINE, 1) < 1e-5 && jump(QTRAJ_LOG_SPLINE, 2) < 5e-3);

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
  for (method = QTRAJ_SQUAD; method <= QTRAJ_LOG_SPLINE; ++method)
    CHECK(difference(build(method, 2, times, keys), build(QTRAJ_SLERP, 2, times, keys)) < 1e-15);
  CHECK(difference(build(QTRAJ_NLERP, 2, times, keys), build(QTRAJ_SLERP, 2, times, keys)) > 1e-5);
  turn(1.0, 3, -1, 1, reference);
  options = options_of(QTRAJ_LOG_SPLINE);
  CHECK(qtraj_options_set_reference(options, QTRAJ_REFERENCE_GIVEN, reference) == QTRAJ_OK);
  CHECK(qtraj_create_with(options, times, keys[0], 2, &a, NULL) == QTRAJ_OK);
  CHECK(difference(a, build(QTRAJ_SLERP, 2, times, keys)) > 1e-6);
  qtraj_options_destroy(options);
}

/* ---- Accuracy ---- */

/* A smooth motion, its rate in the body frame, and keys of it at intervals of 3:5. */
enum { most_keys = 130 };
static void motion(double time, double q[4]) {
  turn(1.2 * sin(time) + 0.3 * time, 1 + 0.5 * sin(2 * time), time, 1, q);
}

static void motion_rate(double time, double omega[3]) {
  const double h = 1e-4;
  double q[4], before[4], after[4], d[4];
  int k;
  motion(time, q);
  motion(time - h, before);
  motion(time + h, after);
  for (k = 0; k < 4; ++k) d[k] = (after[k] - before[k]) / h; /* 2 q' */
  omega[0] = q[0] * d[1] - q[1] * d[0] - q[2] * d[3] + q[3] * d[2];
  omega[1] = q[0] * d[2] - q[2] * d[0] - q[3] * d[1] + q[1] * d[3];
  omega[2] = q[0] * d[3] - q[3] * d[0] - q[1] * d[2] + q[2] * d[1];
}

/* Largest error on a part of [0, 3]: everywhere, or away from the ends. */
static double error(const qtraj_options* options, int given, int n, int inside) {
  double t[most_keys], q[most_keys][4], omega[most_keys][3], sample[4], exact[4], largest = 0;
  qtraj_trajectory* curve;
  int i, k;
  for (i = 0; i < n; ++i) {
    t[i] = 3.0 * (i + (i % 2 ? -0.25 : 0)) / (n - 1);
    motion(t[i], q[i]);
    motion_rate(t[i], omega[i]);
  }
  if (given ? qtraj_create_with_rates(options, t, q[0], QTRAJ_FRAME_BODY, omega[0], NULL, (size_t)n, &curve, NULL)
            : qtraj_create_with(options, t, q[0], (size_t)n, &curve, NULL))
    exit(1);
  for (i = 0; i <= 3000; ++i) {
    const double time = i * 0.001;
    if (inside && fabs(time - 1.5) > 0.8) continue;
    qtraj_sample_at(curve, time, NULL, sample);
    motion(time, exact);
    for (k = 0; k < 4; ++k) largest = fmax(largest, fabs(sample[k] - exact[k]));
  }
  qtraj_destroy(curve);
  return largest;
}

/* The power of the spacing with which the error falls. */
static double order(const qtraj_options* options, int given, int inside) {
  return log(error(options, given, 33, inside) / error(options, given, 129, inside)) / log(4.0);
}
#define CHECK_ORDER(order, power) CHECK(fabs((order) - (power)) < 0.3)

static void check_orders(void) {
  qtraj_options* options = options_of(QTRAJ_SLERP);
  CHECK_ORDER(order(options, 0, 0), 2);
  qtraj_options_destroy(options);
  options = options_of(QTRAJ_NLERP);
  CHECK_ORDER(order(options, 0, 0), 2);
  qtraj_options_destroy(options);

  options = options_of(QTRAJ_SQUAD);
  CHECK_ORDER(order(options, 0, 1), 3);
  CHECK_ORDER(order(options, 0, 0), 2);
  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_ESTIMATED, QTRAJ_END_ESTIMATED));
  CHECK_ORDER(order(options, 0, 0), 3);
  CHECK(!qtraj_options_set_tangents(options, QTRAJ_TANGENT_MEAN_VELOCITY));
  CHECK_ORDER(order(options, 0, 1), 2);
  CHECK(!qtraj_options_set_tangents(options, QTRAJ_TANGENT_GIVEN));
  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_DEFAULT, QTRAJ_END_DEFAULT));
  CHECK_ORDER(order(options, 1, 0), 4);
  qtraj_options_destroy(options);

  options = options_of(QTRAJ_LOG_SPLINE);
  CHECK_ORDER(order(options, 0, 1), 4);
  CHECK_ORDER(order(options, 0, 0), 2);
  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_NOT_A_KNOT, QTRAJ_END_NOT_A_KNOT));
  CHECK_ORDER(order(options, 0, 0), 4);
  qtraj_options_destroy(options);
}

void check_methods(void) {
  check_curves();
  check_orders();
}

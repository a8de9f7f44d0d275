/* docs/methods.md: orders. */
#include <math.h>
#include <stdlib.h>

#include "claims.h"

enum { most_keys = 260 };

/* A smooth motion with its rates in the body frame; derivatives by differences of order 8, in long double. */
static void motion(long double time, long double q[4]) {
  const long double angle = 1.2L * sinl(time) + 0.3L * time;
  const long double axis[3] = {1 + 0.5L * sinl(2 * time), time, 1};
  const long double s = sinl(0.5L * angle) / sqrtl(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  int k;
  q[0] = cosl(0.5L * angle);
  for (k = 0; k < 3; ++k) q[k + 1] = s * axis[k];
}

static const long double step = 0.004L, weight[5] = {0, 4 / 5.0L, -1 / 5.0L, 4 / 105.0L, -1 / 280.0L};

static void motion_omega(long double time, long double omega[3]) {
  long double q[4], before[4], after[4], d[4] = {0};
  int i, k;
  motion(time, q);
  for (i = 1; i <= 4; ++i) {
    motion(time - i * step, before);
    motion(time + i * step, after);
    for (k = 0; k < 4; ++k) d[k] += 2 * weight[i] * (after[k] - before[k]) / step; /* 2 q' */
  }
  omega[0] = q[0] * d[1] - q[1] * d[0] - q[2] * d[3] + q[3] * d[2];
  omega[1] = q[0] * d[2] - q[2] * d[0] - q[3] * d[1] + q[1] * d[3];
  omega[2] = q[0] * d[3] - q[3] * d[0] - q[1] * d[2] + q[2] * d[1];
}

static void motion_alpha(long double time, long double alpha[3]) {
  long double before[3], after[3];
  int i, k;
  for (k = 0; k < 3; ++k) alpha[k] = 0;
  for (i = 1; i <= 4; ++i) {
    motion_omega(time - i * step, before);
    motion_omega(time + i * step, after);
    for (k = 0; k < 3; ++k) alpha[k] += weight[i] * (after[k] - before[k]) / step;
  }
}

static double off(const double* a, const long double* b, int n) {
  double largest = 0;
  while (n-- > 0) largest = fmax(largest, fabs((double)(a[n] - b[n])));
  return largest;
}

/* Largest errors of q, omega and alpha on a part of [0, 3], everywhere or away from the ends, of a curve through n keys
 * of the motion, at intervals of 3:5. */
static void errors(const qtraj_options* options, int given, int n, int inside, double largest[3]) {
  double t[most_keys], q[most_keys][4], omega[most_keys][3], alpha[most_keys][3], sample[4], rate[3], bend[3];
  long double exact[4];
  qtraj_trajectory* curve;
  int i, k;
  for (i = 0; i < n; ++i) {
    t[i] = 3.0 * (i + (i % 2 ? -0.25 : 0)) / (n - 1);
    motion(t[i], exact);
    for (k = 0; k < 4; ++k) q[i][k] = (double)exact[k];
    motion_omega(t[i], exact);
    for (k = 0; k < 3; ++k) omega[i][k] = (double)exact[k];
    motion_alpha(t[i], exact);
    for (k = 0; k < 3; ++k) alpha[i][k] = (double)exact[k];
  }
  if (given ? qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, t, q[0], omega[0], given == 2 ? alpha[0] : NULL,
                                      (size_t)n, &curve, NULL)
            : qtraj_create_with_options(options, t, q[0], (size_t)n, &curve, NULL))
    exit(1);
  largest[0] = largest[1] = largest[2] = 0;
  for (i = 0; i <= 2000; ++i) {
    const double time = 3.0 * i / 2000;
    if (inside && fabs(time - 1.5) > 0.8) continue;
    qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, time, NULL, sample, rate, bend);
    motion(time, exact);
    largest[0] = fmax(largest[0], off(sample, exact, 4));
    motion_omega(time, exact);
    largest[1] = fmax(largest[1], off(rate, exact, 3));
    motion_alpha(time, exact);
    largest[2] = fmax(largest[2], off(bend, exact, 3));
  }
  qtraj_destroy(curve);
}

/* Powers of the spacing with which the errors fall: `order` for q, one less for omega, two less for alpha, or, where
 * that is 0 or less, no fall at all. */
static int has_order(const qtraj_options* options, int given, int inside, int order) {
  const int few = 65;
  double coarse[3], fine[3];
  int k, right = 1;
  errors(options, given, few, inside, coarse);
  errors(options, given, 4 * few - 3, inside, fine);
  for (k = 0; k < 3; ++k) {
    const double found = log(coarse[k] / fine[k]) / log(4.0);
    const int close = order - k > 0 ? fabs(found - (order - k)) < 0.35 : fabs(found) < 0.35;
    if (!close) printf("order %d of derivative %d: %.2f\n", order, k, found);
    right = right && close;
  }
  return right;
}

void check_orders(void) {
  static const int standard[methods + 1] = {0, 2, 2, 2, 2, 4, 4, 6, 6};
  qtraj_options* options;
  int method;
  for (method = 1; method <= methods; ++method) {
    options = options_of(method);
    CHECK(has_order(options, method < QTRAJ_HERMITE ? 0 : method == QTRAJ_HERMITE ? 1 : 2, 0, standard[method]));
    if (method == QTRAJ_SQUAD || method == QTRAJ_LOG_SPLINE)
      CHECK(has_order(options, 0, 1, method == QTRAJ_SQUAD ? 3 : 4));
    qtraj_options_destroy(options);
  }

  options = options_of(QTRAJ_SQUAD);
  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_ESTIMATED, QTRAJ_END_ESTIMATED));
  CHECK(has_order(options, 0, 0, 3));
  CHECK(!qtraj_options_set_tangents(options, QTRAJ_TANGENT_MEAN_VELOCITY));
  CHECK(has_order(options, 0, 1, 2));
  CHECK(!qtraj_options_set_tangents(options, QTRAJ_TANGENT_GIVEN));
  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_DEFAULT, QTRAJ_END_DEFAULT));
  CHECK(has_order(options, 1, 0, 4));
  qtraj_options_destroy(options);

  options = options_of(QTRAJ_LOG_SPLINE);
  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_NOT_A_KNOT, QTRAJ_END_NOT_A_KNOT));
  CHECK(has_order(options, 0, 0, 4));
  qtraj_options_destroy(options);

  options = options_of(QTRAJ_ROTATION_SPLINE);
  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_CHORD, QTRAJ_END_CHORD));
  CHECK(has_order(options, 0, 0, 2) && has_order(options, 0, 1, 4));
  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_NATURAL, QTRAJ_END_NATURAL));
  CHECK(has_order(options, 0, 0, 2) && has_order(options, 0, 1, 4));
  {
    long double exact[3];
    double start[3], end[3];
    int k;
    motion_omega(0, exact);
    for (k = 0; k < 3; ++k) start[k] = (double)exact[k];
    motion_omega(3, exact);
    for (k = 0; k < 3; ++k) end[k] = (double)exact[k];
    CHECK(!qtraj_options_set_ends(options, QTRAJ_END_GIVEN, QTRAJ_END_GIVEN));
    CHECK(!qtraj_options_set_end_rates(options, QTRAJ_FRAME_BODY, start, end));
    CHECK(has_order(options, 0, 0, 4));
  }
  qtraj_options_destroy(options);
}

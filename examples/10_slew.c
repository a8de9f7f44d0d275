/* Lesson 10: a slew from rest to rest, by the quintic, within the limits of the spacecraft.
 *
 * ROTATION_QUINTIC goes through the keys with the angular velocities and accelerations that are given: all zero here.
 * The turn between two keys is then about a fixed axis, its angle a s(t/T) with s(u) = u^3 (10 - 15 u + 6 u^2), so that
 * the peaks are 15/8 a/T and 10/sqrt(3) a/T^2: T follows from the limits. The samples are what a controller needs: the
 * attitude and rate to be at, and the torque that gets there. */
#include <math.h>
#include <stdio.h>

#include "lesson.h"

static const double limit_omega = 0.010, limit_alpha = 0.0002;             /* rad/s, rad/s^2 */
static const double inertia[3] = {4000, 3500, 2500};                       /* kg m^2, about the axes of the body */
static const double from[4] = {1, 0, 0, 0}, to[4] = {0.1, 0.7, -0.5, 0.5}; /* 168 degrees apart; any norm */

/* torque_body = I alpha_body + omega_body x I omega_body, N m */
static void torque(const double omega_body[3], const double alpha_body[3], double out[3]) {
  int k;
  for (k = 0; k < 3; ++k) {
    const int y = (k + 1) % 3, z = (k + 2) % 3;
    out[k] = inertia[k] * alpha_body[k] + (inertia[z] - inertia[y]) * omega_body[y] * omega_body[z];
  }
}

static qtraj_trajectory* create(int32_t method, double duration) {
  const double at_rest[2][3] = {{0, 0, 0}, {0, 0, 0}};
  double times[2] = {0, 0}, keys[2][4];
  qtraj_options* options;
  qtraj_trajectory* slew;
  int k;
  times[1] = duration;
  for (k = 0; k < 4; ++k) {
    keys[0][k] = from[k];
    keys[1][k] = to[k];
  }
  must(qtraj_options_create(method, &options), "options");
  /* before and after the slew: at rest */
  must(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_HOLD), "options");
  must(qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, times, keys[0], at_rest[0], at_rest[0], 2, &slew, NULL),
       "create");
  qtraj_options_destroy(options);
  return slew;
}

static void report(const char* name, const qtraj_trajectory* slew) {
  double omega, alpha, norm;
  must(qtraj_curve_peak_rates(slew, &omega, NULL, &alpha, NULL), "peaks");
  must(qtraj_curve_least_norm(slew, &norm, NULL), "norm");
  printf("%-18s at most %.6f rad/s, %.9f rad/s^2; least norm %.3f\n", name, omega, alpha, norm);
}

int main(void) {
  qtraj_trajectory *slew, *other;
  double angle, duration;
  size_t cursor = 0;
  int tick;

  /* the angle between the keys: what a curve of one second turns by */
  slew = create(QTRAJ_ROTATION_QUINTIC, 1.0);
  must(qtraj_curve_total_angle(slew, &angle), "angle");
  qtraj_destroy(slew);
  duration = fmax(15.0 / 8.0 * angle / limit_omega, sqrt(10.0 / sqrt(3.0) * angle / limit_alpha));
  printf("%.4f rad in %.1f s\n", angle, duration);

  slew = create(QTRAJ_ROTATION_QUINTIC, duration);
  report("ROTATION_QUINTIC", slew);
  /* the same in four dimensions, then normalised: faster where the norm is small */
  other = create(QTRAJ_QUATERNION_QUINTIC, duration);
  report("QUATERNION_QUINTIC", other);
  qtraj_destroy(other);

  printf("          q                              omega_body, mrad/s     torque_body, N m\n");
  for (tick = -1; tick <= 13; tick += 2) {
    const double time = 50.0 * tick;
    double q[4], omega[3], alpha[3], n[3];
    must(qtraj_sample_rates_at(slew, QTRAJ_FRAME_BODY, time, &cursor, q, omega, alpha), "sample");
    torque(omega, alpha, n);
    printf("%5.0f s  %6.3f %6.3f %6.3f %6.3f  %7.3f %7.3f %7.3f  %7.4f %7.4f %7.4f\n", time, q[0], q[1], q[2], q[3],
           1e3 * omega[0], 1e3 * omega[1], 1e3 * omega[2], n[0], n[1], n[2]);
  }
  qtraj_destroy(slew);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./10_slew
 *   2.9413 rad in 551.5 s
 *   ROTATION_QUINTIC   at most 0.010000 rad/s, 0.000055835 rad/s^2; least norm 1.000
 *   QUATERNION_QUINTIC at most 0.012301 rad/s, 0.000072507 rad/s^2; least norm 0.742
 *             q                              omega_body, mrad/s     torque_body, N m
 *     -50 s   1.000  0.000  0.000  0.000    0.000   0.000   0.000   0.0000  0.0000  0.0000
 *      50 s   1.000  0.007 -0.005  0.005    0.765  -0.547   0.547   0.1105 -0.0683  0.0494
 *     150 s   0.982  0.132 -0.094  0.094    4.414  -3.153   3.153   0.1574 -0.0713  0.0728
 *     250 s   0.821  0.401 -0.287  0.287    6.913  -4.938   4.938   0.0622  0.0276  0.0339
 *     350 s   0.463  0.623 -0.445  0.445    6.052  -4.323   4.323  -0.0833  0.1030 -0.0324
 *     450 s   0.168  0.694 -0.495  0.495    2.538  -1.813   1.813  -0.1517  0.1037 -0.0669
 *     550 s   0.100  0.700 -0.500  0.500    0.001  -0.001   0.001  -0.0044  0.0027 -0.0019
 *     650 s   0.100  0.700 -0.500  0.500    0.000   0.000   0.000   0.0000  0.0000  0.0000
 */

/* Lesson 14: time stamps in nanoseconds.
 *
 * Loggers stamp their rows with the nanoseconds since 1970: 19 digits, of which a double holds 16. Turned into seconds
 * as they are, stamps are off by up to 0.12 us. That is nothing to an orientation, but a rate divides by the interval,
 * an acceleration by its square: 200 rows a second make 0.12 us a percent of it.
 *
 * An instrument swings here by 0.35 rad to both sides every two seconds; its accelerations are known. */
#include <math.h>
#include <stdio.h>

#include "lesson.h"

enum { kCount = 801 }; /* four seconds, 200 rows a second */

static const double kSwing = 0.35, kTurning = 3.14159265358979324; /* rad, rad/s of its phase */

static double angle_at(double t) { return kSwing * sin(kTurning * t); }

static double alpha_at(double t) { return -kTurning * kTurning * angle_at(t); }

/* The largest error of the acceleration at the keys, in percent of the largest acceleration. */
static double alpha_error(const double times[kCount], double q[kCount][4]) {
  static double alpha[kCount][3];
  qtraj_trajectory* curve;
  double worst = 0;
  int i;
  must(qtraj_create(QTRAJ_ROTATION_SPLINE, times, q[0], kCount, &curve, NULL), "create");
  must(qtraj_sample_rates(curve, QTRAJ_FRAME_BODY, times, kCount, NULL, NULL, alpha[0], NULL), "sample");
  qtraj_destroy(curve);
  for (i = 1; i + 1 < kCount; ++i) worst = fmax(worst, fabs(alpha[i][2] - alpha_at(0.005 * i)));
  return 100 * worst / (kTurning * kTurning * kSwing);
}

int main(void) {
  static int64_t ns[kCount];
  static double q[kCount][4], times[kCount];
  const int64_t start = 1700000000123456789; /* in November 2023 */
  int i;
  for (i = 0; i < kCount; ++i) {
    ns[i] = start + 5000000 * (int64_t)i;
    q[i][0] = cos(angle_at(0.005 * i) / 2);
    q[i][3] = sin(angle_at(0.005 * i) / 2);
  }

  for (i = 0; i < kCount; ++i) times[i] = 1e-9 * (double)ns[i];
  printf("seconds since 1970:      row 1 after %.9f s, alpha off by %.3f %%\n", times[1] - times[0],
         alpha_error(times, q));

  /* Too late: the digits are gone. */
  for (i = 0; i < kCount; ++i) times[i] = 1e-9 * (double)ns[i] - 1e-9 * (double)ns[0];
  printf("the first subtracted:    row 1 after %.9f s, alpha off by %.3f %%\n", times[1] - times[0],
         alpha_error(times, q));

  /* Subtracted as whole numbers, then rounded, once. */
  must(qtraj_seconds_from_ns(ns, kCount, ns[0], times), "seconds");
  printf("qtraj_seconds_from_ns:   row 1 after %.9f s, alpha off by %.3f %%\n", times[1] - times[0],
         alpha_error(times, q));
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./14_nanoseconds
 *   seconds since 1970:      row 1 after 0.004999876 s, alpha off by 1.298 %
 *   the first subtracted:    row 1 after 0.004999876 s, alpha off by 1.298 %
 *   qtraj_seconds_from_ns:   row 1 after 0.005000000 s, alpha off by 0.002 %
 */

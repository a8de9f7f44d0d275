/* Lesson 16: a motion within limits of rate and acceleration, by stretching its time.
 *
 * The path through the keys stays as it is, only slower: with all times longer by s, rates are divided by s and
 * accelerations by s^2. qtraj_rate_bounds tells both of the whole curve, never less than they are, so that what fits
 * the limits by it does fit. */
#include <math.h>
#include <stdio.h>

#include "lesson.h"

enum { looks = 5 };
static const double look_times[looks] = {0, 1, 2.5, 3, 5}; /* s, as fast as somebody would like it */
static const double look_q[looks][4] = {
    {1, 0, 0, 0}, {0.9, 0.1, 0.3, 0.3}, {0.7, 0.1, 0.3, 0.6}, {0.8, 0.3, 0.3, 0.4}, {1, 0, 0.1, -0.1}};
static const double limit_omega = 0.8, limit_alpha = 1.0; /* rad/s, rad/s^2: those of the gimbal */

static qtraj_trajectory* create(double stretch) {
  double times[looks];
  qtraj_trajectory* curve;
  int i;
  for (i = 0; i < looks; ++i) times[i] = stretch * look_times[i];
  must(qtraj_create(QTRAJ_ROTATION_SPLINE, times, look_q[0], looks, &curve, NULL), "create");
  return curve;
}

int main(void) {
  double omega, alpha, stretch;
  qtraj_trajectory* curve = create(1);
  must(qtraj_rate_bounds(curve, &omega, &alpha), "bounds");
  qtraj_destroy(curve);
  printf("as wanted:  %5.2f s, at most %.6f rad/s and %.6f rad/s^2\n", look_times[looks - 1], omega, alpha);

  stretch = fmax(omega / limit_omega, sqrt(alpha / limit_alpha));
  stretch *= 1 + 1e-9; /* for the rounding of the stretched times */
  curve = create(stretch);
  must(qtraj_rate_bounds(curve, &omega, &alpha), "bounds");
  printf("stretched:  %5.2f s, at most %.6f rad/s and %.6f rad/s^2\n", qtraj_end_time(curve), omega, alpha);
  qtraj_destroy(curve);
  return omega > limit_omega || alpha > limit_alpha;
}

/* Prints, in this folder:
 *
 *   $ ./16_limits
 *   as wanted:   5.00 s, at most 2.594631 rad/s and 3.767900 rad/s^2
 *   stretched:  16.22 s, at most 0.800000 rad/s and 0.358202 rad/s^2
 */

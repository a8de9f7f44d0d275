/* Lesson 9: angular velocity and acceleration of a recorded slew, in both frames.
 *
 *   09_rates RECORDING.csv STEP [--conjugate]
 *
 * ROTATION_SPLINE is the curve for this: its acceleration has no jumps. The recording has a line
 * t,qw,qx,qy,qz,wx,wy,wz for each key; its rates, measured in inertial ("world") axes with a noise of 0.031 mrad/s, are
 * not used for the curve and tell how good the curve's own are. Every STEP'th key is kept: attitudes of six digits, 4 s
 * apart, are too rough to be differentiated twice. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "lesson.h"

static double length(const double v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

int main(int argc, char** argv) {
  static const char* const rate_columns[5] = {"t", "wx", "wy", "wz", "wz"}; /* four numbers are read: one twice */
  const int world_to_body = take_option(&argc, argv, "--conjugate");
  const size_t step = argc == 3 ? (size_t)strtoul(argv[2], NULL, 10) : 0;
  struct keys keys, measured;
  qtraj_trajectory* attitude;
  double(*omega_world)[3], sum = 0, omega_peak, omega_time, alpha_peak, alpha_time, time, angle;
  size_t i, inside = 0;
  int k;

  if (step == 0) {
    fprintf(stderr, "usage: %s RECORDING.csv STEP [--conjugate]\n", argv[0]);
    return 1;
  }
  keys = read_keys(argv[1], NULL);
  if (world_to_body) conjugate(&keys); /* see lesson 1 */
  measured = read_columns(argv[1], rate_columns, NULL);
  keys.count = (keys.count - 1) / step + 1;
  for (i = 0; i < keys.count; ++i) {
    keys.times[i] = keys.times[i * step];
    for (k = 0; k < 4; ++k) keys.q[i][k] = keys.q[i * step][k];
  }
  must(qtraj_create(QTRAJ_ROTATION_SPLINE, keys.times, keys.q[0], keys.count, &attitude, NULL), "create");

  /* One frame: any of the three outputs may be NULL. Here only omega is wanted, at the times of all measurements. */
  omega_world = malloc(measured.count * sizeof *omega_world);
  if (omega_world == NULL) return 1;
  while (inside < measured.count && measured.times[inside] <= qtraj_end_time(attitude)) ++inside;
  must(qtraj_sample_rates(attitude, QTRAJ_FRAME_WORLD, measured.times, inside, NULL, omega_world[0], NULL, NULL),
       "sample");
  for (i = 0; i < inside; ++i) {
    for (k = 0; k < 3; ++k) omega_world[i][k] -= measured.q[i][k];
    sum += length(omega_world[i]) * length(omega_world[i]);
  }
  must(qtraj_curve_peak_rates(attitude, &omega_peak, &omega_time, &alpha_peak, &alpha_time), "peaks");
  must(qtraj_curve_total_angle(attitude, &angle), "angle");
  printf("%lu keys: a way of %.2f rad, at most %.3f mrad/s (%.0f s) and %.1f urad/s^2 (%.0f s)\n",
         (unsigned long)keys.count, angle, 1e3 * omega_peak, omega_time, 1e6 * alpha_peak, alpha_time);
  printf("measured rates differ by %.3f mrad/s rms\n", 1e3 * sqrt(sum / (double)inside));

  /* Both frames: the same vectors, seen from inertial axes and from those of the spacecraft. */
  printf("        omega_world, mrad/s      omega_body, mrad/s       alpha_body, urad/s^2\n");
  for (time = 1700; time <= 2000; time += 50) {
    double world[3], body[3], alpha_body[3];
    must(qtraj_sample_rates_at(attitude, QTRAJ_FRAME_WORLD, time, NULL, NULL, world, NULL), "sample");
    must(qtraj_sample_rates_at(attitude, QTRAJ_FRAME_BODY, time, NULL, NULL, body, alpha_body), "sample");
    printf("%4.0f s ", time);
    for (k = 0; k < 3; ++k) printf(" %6.3f", 1e3 * world[k]);
    printf("    ");
    for (k = 0; k < 3; ++k) printf(" %6.3f", 1e3 * body[k]);
    printf("    ");
    for (k = 0; k < 3; ++k) printf(" %6.2f", 1e6 * alpha_body[k]);
    printf("\n");
  }

  qtraj_destroy(attitude);
  free_keys(&keys);
  free_keys(&measured);
  free(omega_world);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./09_rates data/cassini_turn.csv 4 --conjugate
 *   607 keys: a way of 7.16 rad, at most 1.639 mrad/s (3553 s) and 20.5 urad/s^2 (5439 s)
 *   measured rates differ by 0.031 mrad/s rms
 *           omega_world, mrad/s      omega_body, mrad/s       alpha_body, urad/s^2
 *   1700 s  -0.032 -0.056 -0.232     -0.223 -0.029  0.085      -7.75  -2.95   3.71
 *   1750 s   0.001 -0.618 -0.312     -0.292 -0.550  0.302      -0.57 -11.56   4.38
 *   1800 s   0.036 -1.249 -0.338     -0.309 -1.141  0.529      -0.13 -10.67   4.27
 *   1850 s   0.022 -1.397 -0.337     -0.300 -1.272  0.600       0.14   0.03   0.16
 *   1900 s   0.005 -1.403 -0.337     -0.295 -1.270  0.616      -0.20   0.51   0.30
 *   1950 s  -0.017 -1.402 -0.336     -0.286 -1.262  0.635       0.36  -0.38  -0.43
 *   2000 s  -0.040 -1.407 -0.334     -0.274 -1.260  0.655       0.52   0.01   1.26
 *   $ ./09_rates data/cassini_turn.csv 1 --conjugate | head -n 1
 *   2428 keys: a way of 7.17 rad, at most 1.643 mrad/s (3554 s) and 108.5 urad/s^2 (6247 s)
 */

/* Lesson 8: a motion that repeats.
 *
 *   08_cycle ANIMATION.csv
 *
 * The right upper arm of the fox of lesson 3: it ends as it begins. With PERIODIC ends the curve goes on at the seam as
 * it does at its other keys: SQUAD at the same rate, ROTATION_SPLINE with the same acceleration too. With PERIODIC
 * extrapolation it can be sampled at any time, and repeats exactly. A file without a closing key needs a period, one
 * whose closing key was rounded a closure angle. */
#include <math.h>
#include <stdio.h>

#include "lesson.h"

enum { arm_begins = 4 * 25, arm_keys = 25 }; /* the fifth joint of the file */

static qtraj_trajectory* create_arm(const struct keys* keys, int32_t method, int32_t ends) {
  qtraj_options* options;
  qtraj_trajectory* arm;
  must(qtraj_options_create(method, &options), "options");
  must(qtraj_options_set_ends(options, ends, ends), "ends");
  must(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC), "options");
  must(qtraj_create_with_options(options, keys->times + arm_begins, keys->q[arm_begins], arm_keys, &arm, NULL),
       "create");
  qtraj_options_destroy(options);
  return arm;
}

/* The jumps at the first key of a closed curve are those from its end to its start. */
static void report_seam(const struct keys* keys, const char* name, int32_t method, int32_t ends) {
  qtraj_trajectory* arm = create_arm(keys, method, ends);
  double omega[arm_keys][3], alpha[arm_keys][3], omega_peak, alpha_peak;
  must(qtraj_curve_jumps(arm, QTRAJ_FRAME_BODY, omega[0], alpha[0]), "jumps");
  must(qtraj_curve_peak_rates(arm, &omega_peak, NULL, &alpha_peak, NULL), "peaks");
  printf("%-32s %8.3f of %6.3f rad/s  %8.1f of %6.1f rad/s^2\n", name,
         sqrt(omega[0][0] * omega[0][0] + omega[0][1] * omega[0][1] + omega[0][2] * omega[0][2]), omega_peak,
         sqrt(alpha[0][0] * alpha[0][0] + alpha[0][1] * alpha[0][1] + alpha[0][2] * alpha[0][2]), alpha_peak);
  qtraj_destroy(arm);
}

/* The loop without its closing key, and with one that was written with three decimals. */
static void close_loops(struct keys keys) {
  double(*q)[4] = keys.q + arm_begins;
  const double *times = keys.times + arm_begins, period = times[arm_keys - 1] - times[0];
  qtraj_options* options;
  qtraj_trajectory* arm;
  size_t k;
  must(qtraj_options_create(QTRAJ_ROTATION_SPLINE, &options), "options");
  must(qtraj_options_set_ends(options, QTRAJ_END_PERIODIC, QTRAJ_END_PERIODIC), "ends");
  must(qtraj_options_set_period(options, period), "period");
  must(qtraj_create_with_options(options, times, q[0], arm_keys - 1, &arm, NULL), "create");
  printf("without its closing key, a period of %.3f s: %lu keys\n", period, (unsigned long)qtraj_key_count(arm));
  qtraj_destroy(arm);

  for (k = 0; k < 4; ++k) q[arm_keys - 1][k] = floor(1000 * q[0][k] + 0.5) / 1000;
  must(qtraj_options_set_period(options, 0), "no period");
  printf("closing key rounded: %s\n",
         qtraj_status_text(qtraj_create_with_options(options, times, q[0], arm_keys, &arm, NULL)));
  must(qtraj_options_set_closure(options, 3e-3), "closure");
  printf("with a closure angle of 3e-3 rad: %s\n",
         qtraj_status_text(qtraj_create_with_options(options, times, q[0], arm_keys, &arm, NULL)));
  qtraj_destroy(arm);
  qtraj_options_destroy(options);
}

int main(int argc, char** argv) {
  struct keys keys;
  qtraj_trajectory* cycle;
  double period, q[4], omega_body[3];
  int round;

  if (argc != 2) {
    fprintf(stderr, "usage: %s ANIMATION.csv\n", argv[0]);
    return 1;
  }
  keys = read_keys(argv[1], NULL);
  if (keys.count < arm_begins + arm_keys) return 1;

  cycle = create_arm(&keys, QTRAJ_ROTATION_SPLINE, QTRAJ_END_PERIODIC);
  period = qtraj_end_time(cycle) - qtraj_start_time(cycle);
  for (round = -1000; round <= 1000; round += 500) {
    must(qtraj_sample_rates_at(cycle, QTRAJ_FRAME_BODY, 0.5 + round * period, NULL, q, omega_body, NULL), "sample");
    printf("round %5d  %7.4f %7.4f %7.4f %7.4f  turning at %.3f rad/s about z\n", round, q[0], q[1], q[2], q[3],
           omega_body[2]);
  }
  qtraj_destroy(cycle);

  printf("jump at the seam, and the largest of the curve\n");
  report_seam(&keys, "SQUAD, chord ends", QTRAJ_SQUAD, QTRAJ_END_CHORD);
  report_seam(&keys, "SQUAD, periodic", QTRAJ_SQUAD, QTRAJ_END_PERIODIC);
  report_seam(&keys, "ROTATION_SPLINE, estimated ends", QTRAJ_ROTATION_SPLINE, QTRAJ_END_ESTIMATED);
  report_seam(&keys, "ROTATION_SPLINE, periodic", QTRAJ_ROTATION_SPLINE, QTRAJ_END_PERIODIC);
  close_loops(keys);
  free_keys(&keys);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./08_cycle data/fox_run_gltf.csv
 *   round -1000   0.6723  0.0004 -0.0117 -0.7401  turning at -16.406 rad/s about z
 *   round  -500   0.6723  0.0004 -0.0117 -0.7401  turning at -16.406 rad/s about z
 *   round     0   0.6723  0.0004 -0.0117 -0.7401  turning at -16.406 rad/s about z
 *   round   500   0.6723  0.0004 -0.0117 -0.7401  turning at -16.406 rad/s about z
 *   round  1000   0.6723  0.0004 -0.0117 -0.7401  turning at -16.406 rad/s about z
 *   jump at the seam, and the largest of the curve
 *   SQUAD, chord ends                   2.544 of 16.139 rad/s      63.2 of  559.8 rad/s^2
 *   SQUAD, periodic                     0.000 of 16.139 rad/s      63.2 of  559.8 rad/s^2
 *   ROTATION_SPLINE, estimated ends     0.501 of 16.484 rad/s     142.0 of  447.5 rad/s^2
 *   ROTATION_SPLINE, periodic           0.000 of 16.484 rad/s       0.0 of  447.5 rad/s^2
 *   without its closing key, a period of 1.158 s: 25 keys
 *   closing key rounded: the last key is not the first: append it, set a period or a closure
 *   with a closure angle of 3e-3 rad: success
 */

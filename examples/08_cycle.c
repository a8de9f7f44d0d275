/* Lesson 8: a motion that repeats.
 *
 *   08_cycle ANIMATION.csv
 *
 * The right upper arm of the fox of lesson 3: it ends as it begins. With PERIODIC ends the curve also turns at the same
 * rate on both sides of the seam, and with PERIODIC extrapolation it can be sampled at any time. */
#include <stdio.h>

#include "lesson.h"

enum { arm_begins = 4 * 25, arm_keys = 25 }; /* the fifth joint of the file */

/* Angle by which the rate jumps at the seam: between the turns just before and just after it, degrees a second. */
static double jump_at_seam(const qtraj_trajectory* arm) {
  const double seam = qtraj_end_time(arm), step = 1e-5;
  double times[3], q[3][4], mirrored[4], dot = 0;
  int k;
  for (k = 0; k < 3; ++k) times[k] = seam + (k - 1) * step;
  must(qtraj_sample(arm, times, 3, q[0], NULL), "sample");
  /* where q[2] would be if the turn before the seam went on: q[0] reflected at q[1] */
  for (k = 0; k < 4; ++k) dot += q[0][k] * q[1][k];
  for (k = 0; k < 4; ++k) mirrored[k] = 2.0 * dot * q[1][k] - q[0][k];
  return degrees_between(mirrored, q[2]) / step;
}

static qtraj_trajectory* create_arm(const struct keys* keys, int32_t ends) {
  qtraj_options* options;
  qtraj_trajectory* arm;
  must(qtraj_options_create(QTRAJ_SQUAD, &options), "options");
  must(qtraj_options_set_ends(options, ends, ends), "ends");
  must(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC), "options");
  must(qtraj_create_with(options, keys->times + arm_begins, keys->q[arm_begins], arm_keys, &arm, NULL), "create");
  qtraj_options_destroy(options);
  return arm;
}

int main(int argc, char** argv) {
  const int columns[5] = {1, 5, 2, 3, 4};
  struct keys keys;
  qtraj_trajectory *cycle, *open;
  double period, q[4];
  int round;

  if (argc != 2) {
    fprintf(stderr, "usage: %s ANIMATION.csv\n", argv[0]);
    return 1;
  }
  keys = read_keys(argv[1], columns);
  if (keys.count < arm_begins + arm_keys) return 1;

  cycle = create_arm(&keys, QTRAJ_END_PERIODIC);
  period = qtraj_end_time(cycle) - qtraj_start_time(cycle);
  for (round = -1000; round <= 1000; round += 500) {
    must(qtraj_sample_at(cycle, 0.5 + round * period, NULL, q), "sample");
    printf("round %5d  %7.4f %7.4f %7.4f %7.4f\n", round, q[0], q[1], q[2], q[3]);
  }

  open = create_arm(&keys, QTRAJ_END_CHORD);
  printf("jump of the rate at the seam, degrees/s: periodic ends %.1f, chord ends %.1f\n", jump_at_seam(cycle),
         jump_at_seam(open));

  qtraj_destroy(open);
  qtraj_destroy(cycle);
  free_keys(&keys);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./08_cycle data/fox_run_gltf.csv
 *   round -1000   0.6723  0.0004 -0.0117 -0.7401
 *   round  -500   0.6723  0.0004 -0.0117 -0.7401
 *   round     0   0.6723  0.0004 -0.0117 -0.7401
 *   round   500   0.6723  0.0004 -0.0117 -0.7401
 *   round  1000   0.6723  0.0004 -0.0117 -0.7401
 *   jump of the rate at the seam, degrees/s: periodic ends 0.0, chord ends 145.7
 */

/* Lesson 6: methods and their settings compared on a recording.
 *
 *   06_settings RECORDING.csv STEP [--conjugate]
 *
 * Only every STEP'th key is kept, each curve is drawn through those, and the keys left out tell how far it is off. The
 * recording has a line t,qw,qx,qy,qz,wx,wy,wz for each key, its rates measured in inertial ("world") axes. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "lesson.h"

struct setting {
  const char* name;
  int32_t method, ends, tangents, reference; /* 0: as the library has it */
};
static const struct setting settings[] = {
    {"SLERP", QTRAJ_SLERP, 0, 0, 0},
    {"NLERP", QTRAJ_NLERP, 0, 0, 0},
    {"SQUAD", QTRAJ_SQUAD, 0, 0, 0},
    {"SQUAD, ends estimated", QTRAJ_SQUAD, QTRAJ_END_ESTIMATED, 0, 0},
    {"SQUAD, mean velocity", QTRAJ_SQUAD, 0, QTRAJ_TANGENT_MEAN_VELOCITY, 0},
    {"SQUAD, measured rates", QTRAJ_SQUAD, 0, QTRAJ_TANGENT_GIVEN, 0},
    {"LOG_SPLINE", QTRAJ_LOG_SPLINE, 0, 0, 0},
    {"LOG_SPLINE, not a knot", QTRAJ_LOG_SPLINE, QTRAJ_END_NOT_A_KNOT, 0, 0},
    {"LOG_SPLINE, about the mean", QTRAJ_LOG_SPLINE, 0, 0, QTRAJ_REFERENCE_MEAN},
    {"ROTATION_SPLINE", QTRAJ_ROTATION_SPLINE, 0, 0, 0},
    {"ROTATION_SPLINE, natural", QTRAJ_ROTATION_SPLINE, QTRAJ_END_NATURAL, 0, 0},
    {"HERMITE, measured rates", QTRAJ_HERMITE, 0, 0, 0},
};

static qtraj_trajectory* create(const struct setting* setting, const struct keys* keys, const double* omega_world) {
  qtraj_options* options;
  qtraj_trajectory* curve;
  must(qtraj_options_create(setting->method, &options), "options");
  /* a setting that the method does not have is an error */
  if (setting->ends) must(qtraj_options_set_ends(options, setting->ends, setting->ends), "ends");
  if (setting->tangents) must(qtraj_options_set_tangents(options, setting->tangents), "tangents");
  if (setting->reference) must(qtraj_options_set_reference(options, setting->reference, NULL), "reference");
  if (setting->tangents == QTRAJ_TANGENT_GIVEN || setting->method == QTRAJ_HERMITE)
    must(qtraj_create_with_rates(options, QTRAJ_FRAME_WORLD, keys->times, keys->q[0], omega_world, NULL, keys->count,
                                 &curve, NULL),
         setting->name);
  else
    must(qtraj_create_with_options(options, keys->times, keys->q[0], keys->count, &curve, NULL), setting->name);
  qtraj_options_destroy(options);
  return curve;
}

static void report(const char* name, const qtraj_trajectory* curve, const struct keys* truth) {
  double sum = 0, largest = 0;
  size_t i;
  for (i = 0; i < truth->count && truth->times[i] <= qtraj_end_time(curve); ++i) {
    double q[4], off;
    must(qtraj_sample_at(curve, truth->times[i], NULL, q), name);
    off = degrees_between(q, truth->q[i]);
    sum += off * off;
    largest = fmax(largest, off);
  }
  printf("%-28s %.3f  %.2f\n", name, sqrt(sum / (double)i), largest);
}

int main(int argc, char** argv) {
  static const char* const rate_columns[5] = {"t", "wx", "wy", "wz", "wz"}; /* four numbers are read: one twice */
  const int world_to_body = take_option(&argc, argv, "--conjugate");
  const size_t step = argc == 3 ? (size_t)strtoul(argv[2], NULL, 10) : 0;
  struct keys truth, kept, rates;
  double* omega_world;
  size_t i;
  int k;

  if (step == 0) {
    fprintf(stderr, "usage: %s RECORDING.csv STEP [--conjugate]\n", argv[0]);
    return 1;
  }
  truth = read_keys(argv[1], NULL);
  kept = read_keys(argv[1], NULL);
  rates = read_columns(argv[1], rate_columns, NULL);
  omega_world = malloc(rates.count * 3 * sizeof *omega_world);
  if (omega_world == NULL) return 1;
  if (world_to_body) conjugate(&truth); /* see lesson 1 */
  /* norm 1, so that angles can be measured */
  must(qtraj_normalize(truth.q[0], truth.count, truth.q[0], NULL), "normalize");

  kept.count = (truth.count - 1) / step + 1;
  for (i = 0; i < kept.count; ++i) {
    kept.times[i] = truth.times[i * step];
    for (k = 0; k < 4; ++k) kept.q[i][k] = truth.q[i * step][k];
    for (k = 0; k < 3; ++k) omega_world[3 * i + (size_t)k] = rates.q[i * step][k];
  }

  printf("%4lu of %4lu keys            error in degrees: rms, largest\n", (unsigned long)kept.count,
         (unsigned long)truth.count);
  for (i = 0; i < sizeof settings / sizeof settings[0]; ++i) {
    qtraj_trajectory* curve = create(&settings[i], &kept, omega_world);
    report(settings[i].name, curve, &truth);
    qtraj_destroy(curve);
  }

  free_keys(&truth);
  free_keys(&kept);
  free_keys(&rates);
  free(omega_world);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./06_settings data/cassini_turn.csv 40 --conjugate
 *     61 of 2428 keys            error in degrees: rms, largest
 *   SLERP                        0.264  1.92
 *   NLERP                        0.264  1.92
 *   SQUAD                        0.182  1.21
 *   SQUAD, ends estimated        0.182  1.21
 *   SQUAD, mean velocity         0.182  1.21
 *   SQUAD, measured rates        0.106  0.43
 *   LOG_SPLINE                   0.177  1.01
 *   LOG_SPLINE, not a knot       0.177  1.01
 *   LOG_SPLINE, about the mean   0.182  1.03
 *   ROTATION_SPLINE              0.176  1.01
 *   ROTATION_SPLINE, natural     0.176  1.01
 *   HERMITE, measured rates      0.106  0.43
 *   $ ./06_settings data/newhorizons_signflip.csv 10 --conjugate
 *     43 of  425 keys            error in degrees: rms, largest
 *   SLERP                        0.029  0.28
 *   NLERP                        0.029  0.28
 *   SQUAD                        0.025  0.26
 *   SQUAD, ends estimated        0.021  0.20
 *   SQUAD, mean velocity         0.026  0.27
 *   SQUAD, measured rates        0.017  0.16
 *   LOG_SPLINE                   0.023  0.23
 *   LOG_SPLINE, not a knot       0.020  0.18
 *   LOG_SPLINE, about the mean   0.023  0.23
 *   ROTATION_SPLINE              0.021  0.20
 *   ROTATION_SPLINE, natural     0.023  0.23
 *   HERMITE, measured rates      0.017  0.16
 */

/* Lesson 15: a body that turns by more than half a turn from row to row.
 *
 * Rows each 12 s of a spacecraft that spins at 18 degrees a second are 216 degrees apart. The shorter way from one to
 * the next, 144 degrees, is the wrong way round; no norm, no sign and no status says so. Its rates do: HERMITE takes
 * the turn that they tell. Where the rates themselves are wrong, as in degrees, they do not fit the steps. */
#include <math.h>
#include <stdio.h>

#include "lesson.h"

enum { rows = 11 };

static const double radians = 3.14159265358979324 / 180;
static const double interval = 12, spin = 18; /* s, degrees a second about the z axis of the body */

static void attitude_at(double t, double q[4]) {
  q[0] = cos(spin * t / 2 * radians);
  q[1] = q[2] = 0;
  q[3] = sin(spin * t / 2 * radians);
}

/* A curve through the rows, by a rule for its turns. */
static qtraj_trajectory* create(int32_t rule, double rate_unit) {
  double times[rows], q[rows][4], omega_body[rows][3];
  qtraj_options* options;
  qtraj_trajectory* curve;
  int i;
  for (i = 0; i < rows; ++i) {
    times[i] = interval * i;
    attitude_at(times[i], q[i]);
    omega_body[i][0] = omega_body[i][1] = 0;
    omega_body[i][2] = spin * rate_unit;
  }
  must(qtraj_options_create(QTRAJ_HERMITE, &options), "options");
  must(qtraj_options_set_turns(options, rule), "turns");
  must(qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, times, q[0], omega_body[0], NULL, rows, &curve, NULL),
       "create");
  qtraj_options_destroy(options);
  return curve;
}

static void report(const char* name, qtraj_trajectory* curve) {
  double worst = 0, mismatch, angle;
  int i;
  for (i = 0; i <= 1000; ++i) {
    const double t = interval * (rows - 1) * i / 1000;
    double q[4], truth[4];
    must(qtraj_sample_at(curve, t, NULL, q), "sample");
    attitude_at(t, truth);
    worst = fmax(worst, degrees_between(q, truth));
  }
  must(qtraj_rate_mismatch(curve, &mismatch, NULL), "mismatch");
  must(qtraj_curve_total_angle(curve, &angle), "angle");
  printf("%-28s off by up to %5.1f degrees, %6.1f in all, rates and steps differ by %.2f rad\n", name, worst,
         angle / radians, mismatch);
  qtraj_destroy(curve);
}

/* Without rates: one whole turn less than nothing, 144 - 360 degrees, for every step. */
static qtraj_trajectory* create_with_counts(void) {
  int32_t turns[rows - 1];
  double times[rows], q[rows][4];
  qtraj_options* options;
  qtraj_trajectory* curve;
  int i;
  for (i = 0; i < rows; ++i) {
    times[i] = interval * i;
    attitude_at(times[i], q[i]);
    if (i > 0) turns[i - 1] = -1; /* the shorter turn goes back: the other way round */
  }
  must(qtraj_options_create(QTRAJ_ROTATION_SPLINE, &options), "options");
  must(qtraj_options_set_turns(options, QTRAJ_TURNS_GIVEN), "turns");
  must(qtraj_create_with_turns(options, 0, times, q[0], NULL, NULL, turns, rows, &curve, NULL), "create");
  qtraj_options_destroy(options);
  return curve;
}

int main(void) {
  report("the shorter turn", create(QTRAJ_TURNS_SHORTEST, radians));
  report("what the rates tell", create(QTRAJ_TURNS_DEFAULT, radians)); /* FROM_RATES */
  report("rates in degrees", create(QTRAJ_TURNS_DEFAULT, 1));
  report("no rates, turns counted", create_with_counts());
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./15_turns
 *   the shorter turn             off by up to 180.0 degrees, 1906.3 in all, rates and steps differ by 6.28 rad
 *   what the rates tell          off by up to   0.0 degrees, 2160.0 in all, rates and steps differ by 0.00 rad
 *   rates in degrees             off by up to 179.9 degrees, 124560.0 in all, rates and steps differ by 1.40 rad
 *   no rates, turns counted      off by up to   0.0 degrees, 2160.0 in all, rates and steps differ by 0.00 rad
 */

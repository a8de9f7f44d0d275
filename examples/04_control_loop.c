/* Lesson 4: one sample at a time, for a control loop, also before the first key and after the last one.
 *
 *   04_control_loop RECORDING.csv [--conjugate]
 *
 * The loop starts before the first telemetry of a spinning spacecraft is there (HOLD: stay at the first key) and goes
 * on after contact is lost (CONSTANT_RATE: turn on with the last rate). Contact is lost after 60 of the keys here; the
 * others tell how good the prediction was. With a CHORD end the last rate is that of the last step, which noise harms
 * less than that of a polynomial through four keys, the default. */
#include <stdio.h>

#include "lesson.h"

enum { keys_received = 60 };

static qtraj_trajectory* create(const struct keys* keys) {
  qtraj_options* options;
  qtraj_trajectory* attitude;
  must(qtraj_options_create(QTRAJ_ROTATION_SPLINE, &options), "options");
  must(qtraj_options_set_ends(options, QTRAJ_END_DEFAULT, QTRAJ_END_CHORD), "ends");
  must(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE), "options");
  must(qtraj_create_with_options(options, keys->times, keys->q[0], keys_received, &attitude, NULL), "create");
  qtraj_options_destroy(options);
  return attitude;
}

static const char* phase(const qtraj_trajectory* attitude, double time) {
  if (time < qtraj_start_time(attitude)) return "before";
  return time > qtraj_end_time(attitude) ? "after" : "on";
}

int main(int argc, char** argv) {
  const int world_to_body = take_option(&argc, argv, "--conjugate");
  struct keys keys;
  qtraj_trajectory* attitude;
  size_t i, cursor = 0; /* remembers the segment; 0 to begin, one for each loop */
  int tick;
  double q[4];

  if (argc != 2) {
    fprintf(stderr, "usage: %s RECORDING.csv [--conjugate]\n", argv[0]);
    return 1;
  }
  keys = read_keys(argv[1], NULL);
  if (keys.count < keys_received) return 1;
  if (world_to_body) conjugate(&keys); /* see lesson 1 */
  attitude = create(&keys);

  /* 50 Hz; qtraj_sample_at neither allocates nor locks, and the cursor saves the search */
  for (tick = -100; tick <= 4500; ++tick) {
    const double time = tick / 50.0;
    must(qtraj_sample_at(attitude, time, &cursor, q), "sample");
    /* a controller would steer by q here */
    if (tick % 500 == 0 || tick == -100)
      printf("%5.1f s %-6s  %7.4f %7.4f %7.4f %7.4f\n", time, phase(attitude, time), q[0], q[1], q[2], q[3]);
  }

  /* the keys that were not received; the recorded norms are 1 to 1e-6 */
  for (i = keys_received - 1; i < keys.count; i += 12) {
    must(qtraj_sample_at(attitude, keys.times[i], &cursor, q), "sample");
    printf("%2.0f s after contact was lost: off by %.3f degrees\n", keys.times[i] - keys.times[keys_received - 1],
           degrees_between(q, keys.q[i]));
  }

  qtraj_destroy(attitude);
  free_keys(&keys);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./04_control_loop data/juno_spinner.csv --conjugate
 *    -2.0 s before   0.6864  0.1312  0.7085  0.0985
 *     0.0 s on       0.6864  0.1312  0.7085  0.0985
 *    10.0 s on       0.2732  0.6732  0.2578  0.6370
 *    20.0 s on      -0.4015  0.5706 -0.4397  0.5655
 *    30.0 s on      -0.6918 -0.0783 -0.7162 -0.0474
 *    40.0 s on      -0.3197 -0.6522 -0.3070 -0.6149
 *    50.0 s on       0.3585 -0.6017  0.3962 -0.5937
 *    60.0 s after    0.6935  0.0250  0.7200 -0.0040
 *    70.0 s after    0.3645  0.6277  0.3544  0.5895
 *    80.0 s after   -0.3135  0.6294 -0.3505  0.6186
 *    90.0 s after   -0.6913  0.0285 -0.7198  0.0554
 *    0 s after contact was lost: off by 0.000 degrees
 *   12 s after contact was lost: off by 0.000 degrees
 *   24 s after contact was lost: off by 0.001 degrees
 *   35 s after contact was lost: off by 0.001 degrees
 */

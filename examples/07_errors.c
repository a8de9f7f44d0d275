/* Lesson 7: everything that can go wrong, and what to do about it.
 *
 *   07_errors KEYS.csv
 *
 * The status says what is wrong, bad_index which key or sample it is; there is no other state to ask. All faulty keys
 * of a file are found by one call. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lesson.h"

/* What kind of mistake it is decides who can do something about it. */
static const char* blame(qtraj_status status) {
  if (status == QTRAJ_E_NO_MEMORY) return "the machine";
  switch (qtraj_status_class(status)) {
    case QTRAJ_CLASS_DONE:
      return "nobody";
    case QTRAJ_CLASS_REFUSED:
      return "the caller"; /* nothing was written */
    case QTRAJ_CLASS_DATA:
      return "the data"; /* bad_index names the element */
    case QTRAJ_CLASS_ONE_OF_SEVERAL:
      return "nobody: another answer is as right";
    default:
      return "the library"; /* QTRAJ_E_INTERNAL, or a status newer than this program */
  }
}

/* Names the faulty keys of the file by line, as compilers do, and leaves them out: all in one call. */
static void clean(const char* path, struct keys* keys) {
  qtraj_key_report report;
  int32_t* const statuses = malloc(keys->count * sizeof *statuses);
  size_t i, good = 0;
  qtraj_status status;
  if (statuses == NULL) exit(1);
  status = qtraj_check_keys(keys->times, keys->q[0], keys->count, statuses, &report, NULL);
  if (qtraj_status_class(status) == QTRAJ_CLASS_REFUSED) must(status, "check keys");

  /* No fault, but numbers whose norm is off by more than 0.01 are hardly quaternions: other columns? degrees? */
  if (report.worst_norm_error > 0.01)
    printf("%s:%lu: norm off by %.2g\n", path, (unsigned long)keys->lines[report.worst_norm_index],
           report.worst_norm_error);
  for (i = 0; i < keys->count; ++i) {
    if (statuses[i] != QTRAJ_OK) {
      printf("%s:%lu: %s\n", path, (unsigned long)keys->lines[i], qtraj_status_text(statuses[i]));
      continue;
    }
    keys->times[good] = keys->times[i];
    memcpy(keys->q[good], keys->q[i], sizeof keys->q[good]);
    keys->lines[good] = keys->lines[i];
    ++good;
  }
  free(statuses);

  printf("%lu of %lu keys used; largest step %.1f degrees, longest interval %.2f s\n", (unsigned long)good,
         (unsigned long)keys->count, report.largest_angle * 57.29577951308232, report.longest_interval);
  keys->count = good;
}

static void show(const char* what, qtraj_status status) {
  printf("%-24s blames %-11s %s\n", what, blame(status), qtraj_status_text(status));
}

int main(int argc, char** argv) {
  const double times[4] = {0.5, -1.0, NAN, 1.5};
  double q[4][4];
  struct keys keys;
  qtraj_trajectory *trajectory, *none;
  qtraj_options* options;
  size_t bad, i;
  qtraj_status status;

  if (argc != 2) {
    fprintf(stderr, "usage: %s KEYS.csv\n", argv[0]);
    return 1;
  }
  keys = read_columns(argv[1], key_columns, NULL); /* read_keys would stop at norms that are off */
  clean(argv[1], &keys);
  must(qtraj_create(QTRAJ_ROTATION_SPLINE, keys.times, keys.q[0], keys.count, &trajectory, NULL), argv[1]);

  /* Sampling fails row by row: a row at fault is NaN, the others are right, and the status is that of the first. */
  status = qtraj_sample(trajectory, times, 4, q[0], &bad);
  printf("sample %lu: %s\n", (unsigned long)bad, qtraj_status_text(status));
  for (i = 0; i < 4; ++i) printf("  at %4.1f s: %s\n", times[i], isnan(q[i][0]) ? "nothing" : "an orientation");

  /* Mistakes of the program */
  show("one key", qtraj_create(QTRAJ_SLERP, keys.times, keys.q[0], 1, &none, NULL));
  show("no keys", qtraj_create(QTRAJ_SLERP, NULL, NULL, keys.count, &none, NULL));
  show("no method", qtraj_create(0, keys.times, keys.q[0], keys.count, &none, NULL));
  must(qtraj_options_create(QTRAJ_SLERP, &options), "options");
  show("tangents for SLERP", qtraj_options_set_tangents(options, QTRAJ_TANGENT_CATMULL_ROM));
  show("output over the input", qtraj_sample(trajectory, q[0], 4, q[0], NULL));

  /* A curve that shall go round and round has to come back to its first key. */
  must(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC), "options");
  show("an open curve, repeated", qtraj_create_with_options(options, keys.times, keys.q[0], keys.count, &none, &bad));

  qtraj_options_destroy(options);
  qtraj_destroy(none); /* NULL after an error, and NULL does no harm */
  qtraj_destroy(trajectory);
  free_keys(&keys);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./07_errors data/faulty_keys.csv
 *   data/faulty_keys.csv:14: time does not come after the one before: sort, leave repeats out
 *   data/faulty_keys.csv:15: NaN or infinity, or a result that overflows: leave this element out
 *   data/faulty_keys.csv:16: quaternion of norm 0, or weights that are all 0: leave this element out
 *   data/faulty_keys.csv:18: time does not come after the one before: sort, leave repeats out
 *   data/faulty_keys.csv:20: NaN or infinity, or a result that overflows: leave this element out
 *   15 of 20 keys used; largest step 30.0 degrees, longest interval 0.30 s
 *   sample 1: time outside the knots: stay inside or set an extrapolation
 *     at  0.5 s: an orientation
 *     at -1.0 s: nothing
 *     at  nan s: nothing
 *     at  1.5 s: an orientation
 *   one key                  blames the caller  too few elements: pass 2 keys, 1 sample of a mean, or more
 *   no keys                  blames the caller  a required pointer is NULL: pass the array, or a count of 0
 *   no method                blames the caller  not a constant of this family, or a value out of its range: check it
 *   tangents for SLERP       blames the caller  the method does not have this setting: leave it out
 *   output over the input    blames the caller  an output overlaps another array: give it an array of its own
 *   an open curve, repeated  blames the data    the last key is not the first: append it, set a period or a closure
 */

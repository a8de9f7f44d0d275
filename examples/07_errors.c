/* Lesson 7: everything that can go wrong, and what to do about it.
 *
 *   07_errors KEYS.csv
 *
 * The status says what is wrong, bad_index which key or sample it is; there is no other state to ask. Faulty keys are
 * reported here by file and line, as compilers do, and left out. */
#include <math.h>
#include <stdio.h>
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

static void remove_key(struct keys* keys, size_t bad) {
  const size_t rest = keys->count - bad - 1;
  memmove(keys->times + bad, keys->times + bad + 1, rest * sizeof *keys->times);
  memmove(keys->q + bad, keys->q + bad + 1, rest * sizeof *keys->q);
  memmove(keys->lines + bad, keys->lines + bad + 1, rest * sizeof *keys->lines);
  --keys->count;
}

/* A trajectory through the keys that are usable, NULL if that cannot be. */
static qtraj_trajectory* create_from_usable(const char* path, struct keys* keys) {
  for (;;) {
    size_t bad;
    qtraj_trajectory* trajectory;
    const qtraj_status status = qtraj_create(QTRAJ_SQUAD, keys->times, keys->q[0], keys->count, &trajectory, &bad);
    if (status == QTRAJ_OK) return trajectory;
    if (bad == SIZE_MAX) { /* not the fault of one key: too few are left, out of memory, ... */
      printf("%s: %s\n", path, qtraj_status_text(status));
      return NULL;
    }
    printf("%s:%lu: %s\n", path, (unsigned long)keys->lines[bad], qtraj_status_text(status));
    remove_key(keys, bad);
  }
}

static void show(const char* what, qtraj_status status) {
  printf("%-24s blames %-11s %s\n", what, blame(status), qtraj_status_text(status));
}

int main(int argc, char** argv) {
  const int columns[5] = {0, 1, 2, 3, 4};
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
  keys = read_keys(argv[1], columns);
  trajectory = create_from_usable(argv[1], &keys);
  if (trajectory == NULL) return 1;
  printf("%lu keys used\n", (unsigned long)qtraj_key_count(trajectory));

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
 *   15 keys used
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

/* Lesson 12: where a recording changes the sign of its quaternions.
 *
 *   12_sign_flips RECORDING.csv
 *
 * q and -q are one orientation, and recordings go over from one to the other: at any time, or, as Cassini's does, where
 * w would become negative. Constructors mend that themselves; what works on the four numbers (a filter, a difference, a
 * plot) needs it done first. */
#include <stdio.h>
#include <stdlib.h>

#include "lesson.h"

static double dot(const double a[4], const double b[4]) {
  double result;
  must(qtraj_dot(a, 1, b, 1, 1, &result, NULL), "dot");
  return result;
}

/* A key was changed where it no longer has the sign it was recorded with. A flip is where that begins or ends: flips
 * are fewer than changed keys, as one flip changes all keys up to the next. */
static void list_flips(const struct keys* recorded, double (*continuous)[4]) {
  size_t i, flips = 0;
  int changed = 0;
  for (i = 1; i < recorded->count; ++i) {
    const int changed_before = changed;
    changed = dot(recorded->q[i], continuous[i]) < 0;
    if (changed == changed_before) continue;
    ++flips;
    printf("  line %3lu, %.6f s: w from %7.4f to %7.4f, which is %7.4f\n", (unsigned long)recorded->lines[i],
           recorded->times[i], recorded->q[i - 1][0], recorded->q[i][0], (changed ? -1 : 1) * recorded->q[i][0]);
  }
  printf("flips: %lu\n", (unsigned long)flips);
}

int main(int argc, char** argv) {
  struct keys recorded;
  double(*continuous)[4], least = 1;
  size_t changed, still, bad, i;
  qtraj_status status;

  if (argc != 2) {
    fprintf(stderr, "usage: %s RECORDING.csv\n", argv[0]);
    return 1;
  }
  recorded = read_keys(argv[1], NULL);
  continuous = malloc(recorded.count * sizeof *continuous);
  if (continuous == NULL) return 1;

  /* One series of `count` keys. Many of the same length, the joints of a figure for instance, take one call too. */
  status = qtraj_make_continuous(recorded.q[0], 1, recorded.count, continuous[0], &changed, &bad);
  if (status != QTRAJ_OK && bad != SIZE_MAX)
    fprintf(stderr, "%s:%lu: not used\n", argv[1], (unsigned long)recorded.lines[bad]);
  must(status, "make continuous");
  printf("%lu of %lu keys changed\n", (unsigned long)changed, (unsigned long)recorded.count);
  list_flips(&recorded, continuous);

  /* Nothing is left to do, which a second pass, in place, confirms. */
  must(qtraj_make_continuous(continuous[0], 1, recorded.count, continuous[0], &still, NULL), "make continuous");
  for (i = 1; i < recorded.count; ++i) {
    const double product = dot(continuous[i - 1], continuous[i]);
    if (product < least) least = product;
  }
  printf("after it: %lu keys changed, least dot product of neighbours %.6f\n", (unsigned long)still, least);

  free_keys(&recorded);
  free(continuous);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./12_sign_flips data/newhorizons_signflip.csv
 *   423 of 425 keys changed
 *     line   3, 2.920000 s: w from  0.6892 to -0.6900, which is  0.6900
 *     line 426, 555.008000 s: w from -0.6858 to  0.6859, which is  0.6859
 *   flips: 2
 *   after it: 0 keys changed, least dot product of neighbours 0.999989
 *   $ ./12_sign_flips data/cassini_turn.csv
 *   1731 of 2428 keys changed
 *     line 699, 2787.332031 s: w from  0.0007 to  0.0021, which is -0.0021
 *   flips: 1
 *   after it: 0 keys changed, least dot product of neighbours 0.999962
 */

/* Lesson 2: another file format: component order, timestamps, gaps.
 *
 *   02_tum_recording GROUNDTRUTH.tum
 *
 * Rows of the TUM format are `timestamp tx ty tz qx qy qz qw`: the scalar comes last, where the library wants it first,
 * and the timestamp counts seconds from 1970. Here the orientation of a hand-held camera is sampled for its images, 30
 * times a second, but not in gaps of the motion capture: a setting refuses times inside intervals that are too long. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "lesson.h"

static const double longest_gap = 0.05; /* s; the motion capture runs at 100 Hz */

static qtraj_trajectory* create(const struct keys* keys) {
  qtraj_options* options;
  qtraj_trajectory* camera;
  must(qtraj_options_create(QTRAJ_ROTATION_SPLINE, &options), "options");
  must(qtraj_options_set_longest_gap(options, longest_gap), "longest gap");
  must(qtraj_create_with_options(options, keys->times, keys->q[0], keys->count, &camera, NULL), "create");
  qtraj_options_destroy(options);
  return camera;
}

int main(int argc, char** argv) {
  struct keys keys;
  qtraj_trajectory* camera;
  qtraj_status status;
  double *times, (*q)[4], start;
  size_t count, i, in_gaps = 0;

  if (argc != 2) {
    fprintf(stderr, "usage: %s GROUNDTRUTH.tum\n", argv[0]);
    return 1;
  }
  /* the columns are found by the names in the heading; some files of this format have none */
  keys = read_keys(argv[1], "timestamp tx ty tz qx qy qz qw");
  camera = create(&keys);

  /* Timestamps are used as they are: near 1.3e9 s doubles are 0.24 microseconds apart. (A float would be 128 s off;
   * that is why times are double in every function. Stamps of whole nanoseconds: lesson 14.) */
  start = qtraj_start_time(camera);
  printf("%lu poses from %.6f s on, for %.2f s\n", (unsigned long)keys.count, start, qtraj_end_time(camera) - start);
  printf("doubles resolve less than a microsecond there: %s\n", start * DBL_EPSILON < 1e-6 ? "yes" : "no");

  must(qtraj_uniform_count(camera, start, 1 / 30.0, &count), "count");
  times = malloc(count * sizeof *times);
  q = malloc(count * sizeof *q);
  if (times == NULL || q == NULL) return 1;
  for (i = 0; i < count; ++i) times[i] = start + (double)i * (1 / 30.0);
  status = qtraj_sample(camera, times, count, q[0], NULL); /* rows in gaps are NaN, all others right */
  if (status != QTRAJ_E_GAP) must(status, "sample");

  printf("images, as `timestamp qx qy qz qw`:\n");
  for (i = 0; i < count; ++i) {
    if (isnan(q[i][0])) ++in_gaps;
    if (i % 200 == 0) printf("%.6f %.4f %.4f %.4f %.4f\n", times[i], q[i][1], q[i][2], q[i][3], q[i][0]);
  }
  printf("%lu of %lu images fall into gaps longer than %.2f s\n", (unsigned long)in_gaps, (unsigned long)count,
         longest_gap);

  qtraj_destroy(camera);
  free_keys(&keys);
  free(times);
  free(q);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./02_tum_recording data/tum_fr1_xyz.tum
 *   3000 poses from 1305031098.665900 s on, for 30.09 s
 *   doubles resolve less than a microsecond there: yes
 *   images, as `timestamp qx qy qz qw`:
 *   1305031098.665900 0.6132 0.5962 -0.3311 -0.3986
 *   1305031105.332567 0.6517 0.6182 -0.2965 -0.3243
 *   1305031111.999233 0.6863 0.6090 -0.2555 -0.3047
 *   1305031118.665900 0.6573 0.6478 -0.2719 -0.2729
 *   1305031125.332567 0.6424 0.6430 -0.3151 -0.2729
 *   3 of 903 images fall into gaps longer than 0.05 s
 */

/* Lesson 2: another file format: component order, timestamps, gaps.
 *
 *   02_tum_recording GROUNDTRUTH.tum
 *
 * Rows of the TUM format are `timestamp tx ty tz qx qy qz qw`: the scalar comes last, where the library wants it first,
 * and the timestamp counts seconds from 1970. Here the orientation of a hand-held camera is sampled for its images, 30
 * times a second, and images in a gap of the motion capture are told apart. */
#include <float.h>
#include <stdio.h>
#include <stdlib.h>

#include "lesson.h"

int main(int argc, char** argv) {
  const int columns[5] = {0, 7, 4, 5, 6}; /* t qw qx qy qz */
  const double longest_gap = 0.05;        /* s; the motion capture runs at 100 Hz */
  struct keys keys;
  qtraj_trajectory* camera;
  double *times, (*q)[4], start, duration;
  size_t count, i, key = 0, in_gaps = 0;

  if (argc != 2) {
    fprintf(stderr, "usage: %s GROUNDTRUTH.tum\n", argv[0]);
    return 1;
  }
  keys = read_keys(argv[1], columns);
  must(qtraj_create(QTRAJ_SQUAD, keys.times, keys.q[0], keys.count, &camera, NULL), "create");

  /* Timestamps are used as they are: near 1.3e9 s doubles are 0.24 microseconds apart. (A float would be 128 s off;
   * that is why times are double in every function. Where a clock counts integer nanoseconds, subtract the first stamp
   * before the conversion to double.) */
  start = qtraj_start_time(camera);
  duration = qtraj_end_time(camera) - start;
  printf("%lu poses from %.4f s on, for %.2f s\n", (unsigned long)keys.count, start, duration);
  printf("doubles resolve less than a microsecond there: %s\n", start * DBL_EPSILON < 1e-6 ? "yes" : "no");

  count = (size_t)(duration * 30.0) + 1;
  while (start + (double)(count - 1) / 30.0 > qtraj_end_time(camera)) --count;
  times = malloc(count * sizeof *times);
  q = malloc(count * sizeof *q);
  if (times == NULL || q == NULL) return 1;
  for (i = 0; i < count; ++i) times[i] = start + (double)i / 30.0;
  must(qtraj_sample(camera, times, count, q[0], NULL), "sample");

  printf("images, as `timestamp qx qy qz qw`:\n");
  for (i = 0; i < count; ++i) {
    while (key + 2 < keys.count && keys.times[key + 1] <= times[i]) ++key;
    if (keys.times[key + 1] - keys.times[key] > longest_gap) ++in_gaps;
    if (i % 200 == 0) printf("%.4f %.4f %.4f %.4f %.4f\n", times[i], q[i][1], q[i][2], q[i][3], q[i][0]);
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
 *   3000 poses from 1305031098.6659 s on, for 30.09 s
 *   doubles resolve less than a microsecond there: yes
 *   images, as `timestamp qx qy qz qw`:
 *   1305031098.6659 0.6132 0.5962 -0.3311 -0.3986
 *   1305031105.3326 0.6517 0.6182 -0.2964 -0.3243
 *   1305031111.9992 0.6863 0.6090 -0.2555 -0.3047
 *   1305031118.6659 0.6573 0.6478 -0.2719 -0.2729
 *   1305031125.3326 0.6425 0.6431 -0.3151 -0.2729
 *   3 of 903 images fall into gaps longer than 0.05 s
 */

/* Lesson 13: which method is closest? Leave keys out and see.
 *
 *   13_leave_keys_out RECORDING.csv STEP
 *
 * Every STEP'th sample of the recording is a key, the others tell by which angle the curve misses them. One number
 * would hide how: the median is what happens as a rule, the 99th percentile and the largest are what happens where the
 * motion changes. Smoother is not always closer: see below for which curve is the best by which of them, and on which
 * recording. Lesson 6 shows what settings and measured rates add.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "lesson.h"

struct method {
  const char* name;
  const char* continuity;
  int32_t value;
};
static const struct method methods[] = {
    {"NLERP", "C0", QTRAJ_NLERP},
    {"SLERP", "C0", QTRAJ_SLERP},
    {"SQUAD", "C1", QTRAJ_SQUAD},
    {"LOG_SPLINE", "C2", QTRAJ_LOG_SPLINE},
    {"ROTATION_SPLINE", "C2", QTRAJ_ROTATION_SPLINE},
};

static void move_sample(struct keys* to, const struct keys* from, size_t i) {
  int k;
  to->times[to->count] = from->times[i];
  for (k = 0; k < 4; ++k) to->q[to->count][k] = from->q[i][k];
  ++to->count;
}

/* Every step'th sample becomes a key, those between two keys become left out; both have room for all. */
static void split(const struct keys* samples, size_t step, struct keys* keys, struct keys* left_out) {
  const size_t last_key = (samples->count - 1) / step * step;
  size_t i;
  keys->count = left_out->count = 0;
  for (i = 0; i <= last_key; ++i) move_sample(i % step == 0 ? keys : left_out, samples, i);
}

static int compare(const void* a, const void* b) {
  const double x = *(const double*)a, y = *(const double*)b;
  return (x > y) - (x < y);
}

/* The smallest value that `percent` of the sorted ones do not exceed. */
static double percentile(const double* sorted, size_t count, double percent) {
  const size_t rank = (size_t)ceil(percent / 100 * (double)count);
  return sorted[rank > 0 ? rank - 1 : 0];
}

static void report(const struct method* method, const struct keys* keys, const struct keys* left_out, double (*q)[4],
                   double* angles) {
  const size_t count = left_out->count;
  const double arc_minutes = 60 * 45 / atan(1.0);
  qtraj_trajectory* curve;
  size_t i;
  must(qtraj_create(method->value, keys->times, keys->q[0], keys->count, &curve, NULL), method->name);
  must(qtraj_sample(curve, left_out->times, count, q[0], NULL), method->name);
  qtraj_destroy(curve);
  /* whatever their signs, and though the recording's norms are a little off 1 */
  must(qtraj_rotation_angle(q[0], count, left_out->q[0], count, count, angles, NULL), method->name);
  for (i = 0; i < count; ++i) angles[i] *= arc_minutes;
  qsort(angles, count, sizeof *angles, compare);
  printf("%-16s %s  %8.3f  %8.2f  %8.2f\n", method->name, method->continuity, percentile(angles, count, 50),
         percentile(angles, count, 99), angles[count - 1]);
}

int main(int argc, char** argv) {
  const size_t step = argc == 3 ? (size_t)strtoul(argv[2], NULL, 10) : 0;
  struct keys samples, keys, left_out;
  double(*q)[4], *angles;
  size_t i;

  if (step < 2) {
    fprintf(stderr, "usage: %s RECORDING.csv STEP, from 2 on\n", argv[0]);
    return 1;
  }
  samples = read_keys(argv[1], NULL);
  keys = read_keys(argv[1], NULL);
  left_out = read_keys(argv[1], NULL);
  split(&samples, step, &keys, &left_out);
  q = malloc(samples.count * sizeof *q);
  angles = malloc(samples.count * sizeof *angles);
  if (q == NULL || angles == NULL) return 1;

  printf("%4lu keys, %4lu left out  arc minutes: median, 99%%, largest\n", (unsigned long)keys.count,
         (unsigned long)left_out.count);
  if (left_out.count > 0)
    for (i = 0; i < sizeof methods / sizeof methods[0]; ++i) report(&methods[i], &keys, &left_out, q, angles);

  free_keys(&samples);
  free_keys(&keys);
  free_keys(&left_out);
  free(q);
  free(angles);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./13_leave_keys_out data/cassini_turn.csv 2
 *   1214 keys, 1213 left out  arc minutes: median, 99%, largest
 *   NLERP            C0     0.127      0.47      1.27
 *   SLERP            C0     0.127      0.47      1.27
 *   SQUAD            C1     0.116      0.27      1.32
 *   LOG_SPLINE       C2     0.121      0.26      1.33
 *   ROTATION_SPLINE  C2     0.121      0.26      1.33
 *   $ ./13_leave_keys_out data/cassini_turn.csv 20
 *    122 keys, 2299 left out  arc minutes: median, 99%, largest
 *   NLERP            C0     0.800     25.20     31.10
 *   SLERP            C0     0.801     25.19     31.10
 *   SQUAD            C1     0.208     12.01     18.80
 *   LOG_SPLINE       C2     0.340     10.78     18.02
 *   ROTATION_SPLINE  C2     0.327     10.79     17.98
 *   $ ./13_leave_keys_out data/cassini_turn.csv 80
 *     31 keys, 2370 left out  arc minutes: median, 99%, largest
 *   NLERP            C0    12.644    274.21    321.01
 *   SLERP            C0    12.654    274.08    321.02
 *   SQUAD            C1     5.955    182.99    221.55
 *   LOG_SPLINE       C2     9.679    158.43    195.09
 *   ROTATION_SPLINE  C2     9.387    158.43    195.08
 *   $ ./13_leave_keys_out data/newhorizons_signflip.csv 8
 *     54 keys,  371 left out  arc minutes: median, 99%, largest
 *   NLERP            C0     0.021     10.66     18.91
 *   SLERP            C0     0.021     10.66     18.91
 *   SQUAD            C1     0.041     15.54     24.92
 *   LOG_SPLINE       C2     0.042     13.87     32.96
 *   ROTATION_SPLINE  C2     0.041     12.00     26.99
 */

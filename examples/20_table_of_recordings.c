/* Lesson 20: a table of recordings: many curves in one call, a mean of each, and a mean of parts.
 *
 *   20_table_of_recordings RECORDING.tum ANOTHER.csv
 *
 * In a table each row is a recording with a list of keys, and all lists lie one after the other in shared arrays, told
 * apart by offsets: recording k has the keys from offsets[k] up to offsets[k + 1]. Here a recording is cut wherever the
 * motion capture lost the head of its subject for half a second, and another file is one recording more. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "lesson.h"

enum { most = 100 };
static const double longest_gap = 0.5, step = 1 / 60.0; /* s */

struct table {
  size_t count;
  int64_t offsets[most + 1];
  double* times;  /* those of all recordings */
  double (*q)[4]; /* likewise */
};

static void* allocate(size_t bytes) {
  void* memory = malloc(bytes > 0 ? bytes : 1);
  if (memory == NULL) exit(1);
  return memory;
}

/* Appends keys to the table, cut where there are none for longer than the gap. */
static void append(struct table* table, const struct keys* keys, double gap) {
  const size_t before = (size_t)table->offsets[table->count];
  size_t i, k;
  for (i = 0; i < keys->count; ++i) {
    if (i > 0 && keys->times[i] - keys->times[i - 1] > gap && table->count + 2 < most)
      table->offsets[++table->count] = (int64_t)(before + i);
    table->times[before + i] = keys->times[i];
    for (k = 0; k < 4; ++k) table->q[before + i][k] = keys->q[i][k];
  }
  table->offsets[++table->count] = (int64_t)(before + keys->count);
}

/* Samples every recording 60 times a second. A recording at fault has a status of its own, and is no harm to the rest:
 * what the call returns is the status of the first of them. */
static void sample(const struct table* table) {
  int64_t rows[most + 1];
  int32_t statuses[most];
  double *times, (*q)[4];
  size_t bad, k;
  qtraj_options* options;
  qtraj_status status;

  /* how many samples each has; the faults are seen once more below */
  status = qtraj_batch_step_offsets(table->count, table->offsets, table->times, &step, 1, rows, NULL, NULL);
  if (status != QTRAJ_E_TOO_FEW) must(status, "offsets");
  times = allocate((size_t)rows[table->count] * sizeof *times);
  q = allocate((size_t)rows[table->count] * sizeof *q);
  status = qtraj_batch_times(table->count, table->offsets, table->times, &step, 1, rows, times, NULL, NULL);
  if (status != QTRAJ_E_TOO_FEW) must(status, "times");

  /* without memory of ours: one allocation, for the longest recording */
  must(qtraj_options_create(QTRAJ_ROTATION_SPLINE, &options), "options");
  status = qtraj_batch_sample(options, table->count, table->offsets, table->times, table->q[0], rows, times, NULL, 0,
                              q[0], statuses, &bad);
  qtraj_options_destroy(options);
  printf("%lu recordings, %ld samples\n", (unsigned long)table->count, (long)rows[table->count]);
  if (status != QTRAJ_OK) printf("  the first at fault: %lu\n", (unsigned long)bad);
  for (k = 0; k < table->count; ++k) {
    const double* last = rows[k + 1] > rows[k] ? q[rows[k + 1] - 1] : NULL;
    printf("  %lu: %4ld keys, %3ld samples", (unsigned long)k, (long)(table->offsets[k + 1] - table->offsets[k]),
           (long)(rows[k + 1] - rows[k]));
    if (statuses[k] == QTRAJ_OK)
      printf(", the last %.4f %.4f %.4f %.4f\n", last[0], last[1], last[2], last[3]);
    else
      printf(": %s\n", qtraj_status_text(statuses[k]));
  }
  free(times);
  free(q);
}

/* The mean attitude of each recording, by one call. A slice of the table is a call of its own: the arrays stay as they
 * are, and the offsets begin where the slice does. */
static void means_of(const struct table* table, size_t first, size_t count) {
  double mean[most][4], eigengap[most];
  size_t k;
  must(qtraj_batch_mean_eigen(count, table->offsets + first, table->q[0], NULL, mean[0], eigengap, NULL, NULL),
       "means");
  printf("means of recordings %lu to %lu\n", (unsigned long)first, (unsigned long)(first + count - 1));
  for (k = 0; k < count; ++k)
    printf("  %.4f %7.4f %.4f %.4f, eigengap %.4f\n", mean[k][0], mean[k][1], mean[k][2], mean[k][3], eigengap[k]);
}

/* The mean of all keys, were the halves of the table on two machines: each has eleven numbers to send, and their sum
 * has the mean of all. */
static void mean_of_halves(const struct table* table, size_t count) {
  const size_t rows = (size_t)table->offsets[count], half = rows / 2;
  double moments[2][11] = {{0}}, mean[4], whole[4];
  int k;
  must(qtraj_moments_add(table->q[0], NULL, half, moments[0], NULL), "the first half");
  must(qtraj_moments_add(table->q[half], NULL, rows - half, moments[1], NULL), "the second half");
  for (k = 0; k < 11; ++k) moments[0][k] += moments[1][k];
  must(qtraj_mean_from_moments(moments[0], mean, NULL), "mean of both halves");
  must(qtraj_mean_eigen(table->q[0], NULL, rows, whole, NULL, NULL), "mean of all");
  printf("mean of %.0f keys, by halves: %.4f %.4f %.4f %.4f\n", moments[0][0], mean[0], mean[1], mean[2], mean[3]);
  printf("the same as of all at once: %s\n", degrees_between(mean, whole) < 1e-12 ? "yes" : "no");
}

int main(int argc, char** argv) {
  struct table table = {0, {0}, NULL, NULL};
  struct keys keys, more;
  if (argc != 3) {
    fprintf(stderr, "usage: %s RECORDING.tum ANOTHER.csv\n", argv[0]);
    return 1;
  }
  keys = read_keys(argv[1], "timestamp tx ty tz qx qy qz qw");
  more = read_keys(argv[2], NULL);
  table.times = allocate((keys.count + more.count) * sizeof *table.times);
  table.q = allocate((keys.count + more.count) * sizeof *table.q);
  append(&table, &keys, longest_gap);
  append(&table, &more, HUGE_VAL);

  sample(&table);
  means_of(&table, 2, 3);
  mean_of_halves(&table, table.count - 1);

  free(table.times);
  free(table.q);
  free_keys(&keys);
  free_keys(&more);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./20_table_of_recordings data/tum_fr2_desk_head.tum data/faulty_keys.csv
 *   8 recordings, 2274 samples
 *     the first at fault: 4
 *     0: 3997 keys, 997 samples, the last -0.4655 0.8773 0.0885 -0.0769
 *     1: 1196 keys, 424 samples, the last -0.3785 0.7710 0.4390 -0.2638
 *     2:    3 keys,   1 samples, the last -0.3705 0.7899 0.4235 -0.2438
 *     3:   82 keys, 132 samples, the last -0.4263 0.7259 0.4588 -0.2843
 *     4:    1 keys,   0 samples: too few elements: pass 2 keys, 1 sample of a mean, or more
 *     5:    1 keys,   0 samples: too few elements: pass 2 keys, 1 sample of a mean, or more
 *     6: 2720 keys, 617 samples, the last -0.0914 0.2586 0.8358 -0.4757
 *     7:   20 keys, 103 samples: time does not come after the one before: sort, leave repeats out
 *   means of recordings 2 to 4
 *     -0.3706  0.7898 0.4236 -0.2436, eigengap 1.0000
 *     -0.4023  0.7296 0.4766 -0.2805, eigengap 0.9995
 *     -0.2822  0.5097 0.7115 -0.3928, eigengap 1.0000
 *   mean of 8000 keys, by halves: 0.5149 -0.8457 -0.1262 0.0614
 *   the same as of all at once: yes
 */

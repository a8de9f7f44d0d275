/* Lesson 1: a recording of a spacecraft's attitude, sampled at a fixed rate.
 *
 *   01_sample_recording RECORDING.csv METHOD RATE OUT.csv [--conjugate]
 *
 * METHOD is rotation_spline, the first to try, or slerp, nlerp, squad, log_spline; RATE in samples a second. The
 * recording has columns t, qw, qx, qy, qz, named by its heading, and is read as its archive has it: norms a little off
 * 1, signs that flip. The library mends both.
 *
 * The library wants orientations from body to world. A file does not say which way its own go: --conjugate is for those
 * from world to body, such as this one. SPICE, its source, stores rotations from inertial to body axes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lesson.h"

static int32_t method_named(const char* name) {
  if (strcmp(name, "rotation_spline") == 0) return QTRAJ_ROTATION_SPLINE;
  if (strcmp(name, "slerp") == 0) return QTRAJ_SLERP;
  if (strcmp(name, "nlerp") == 0) return QTRAJ_NLERP;
  if (strcmp(name, "squad") == 0) return QTRAJ_SQUAD;
  if (strcmp(name, "log_spline") == 0) return QTRAJ_LOG_SPLINE;
  return 0; /* no method: qtraj_create will say so */
}

/* Nine decimals: stamps of seconds since 1970 keep all that a double has of them. */
static void write_csv(const char* path, double start, double step, double (*q)[4], size_t count) {
  size_t i;
  FILE* file = fopen(path, "w");
  if (file != NULL) {
    fprintf(file, "t,qw,qx,qy,qz\n");
    for (i = 0; i < count; ++i)
      fprintf(file, "%.9f,%.9f,%.9f,%.9f,%.9f\n", start + (double)i * step, q[i][0], q[i][1], q[i][2], q[i][3]);
  }
  if (file == NULL || fclose(file) != 0) {
    perror(path);
    exit(1);
  }
}

int main(int argc, char** argv) {
  const int world_to_body = take_option(&argc, argv, "--conjugate");
  const double rate = argc == 5 ? atof(argv[3]) : 0;
  qtraj_trajectory* attitude;
  struct keys keys;
  double start, step, (*q)[4];
  size_t count, i;

  if (!(rate > 0 && rate <= 1e6)) {
    fprintf(stderr, "usage: %s RECORDING.csv rotation_spline|slerp|nlerp|squad|log_spline RATE OUT.csv [--conjugate]\n",
            argv[0]);
    return 1;
  }
  keys = read_keys(argv[1], NULL);
  if (world_to_body) conjugate(&keys);

  must(qtraj_create(method_named(argv[2]), keys.times, keys.q[0], keys.count, &attitude, NULL), "create");
  free_keys(&keys); /* the trajectory has its own copy */
  start = qtraj_start_time(attitude);
  printf("%lu keys over %.1f s, %lu signs changed, norms off by up to %.1e\n", (unsigned long)qtraj_key_count(attitude),
         qtraj_end_time(attitude) - start, (unsigned long)qtraj_sign_flips(attitude), qtraj_worst_norm_error(attitude));

  step = 1.0 / rate;
  must(qtraj_uniform_count(attitude, start, step, &count), "count"); /* up to the last key */
  q = malloc(count * sizeof *q);
  if (q == NULL) {
    fprintf(stderr, "out of memory\n");
    return 1;
  }
  must(qtraj_sample_uniform(attitude, start, step, count, q[0], NULL), "sample");
  qtraj_destroy(attitude);

  write_csv(argv[4], start, step, q, count);
  printf("%lu samples by %s, of which\n", (unsigned long)count, argv[2]);
  for (i = 0; i < count; i += count / 6 + 1)
    printf("  %12.6f s  %7.4f %7.4f %7.4f %7.4f\n", start + (double)i * step, q[i][0], q[i][1], q[i][2], q[i][3]);
  free(q);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./01_sample_recording data/cassini_turn.csv rotation_spline 1 attitude.csv --conjugate
 *   2428 keys over 9705.7 s, 1731 signs changed, norms off by up to 2.3e-05
 *   9706 samples by rotation_spline, of which
 *         0.000000 s   0.6371  0.1541 -0.7390  0.1556
 *      1618.000000 s   0.6371  0.1541 -0.7390  0.1556
 *      3236.000000 s  -0.3145 -0.2280 -0.8888  0.2432
 *      4854.000000 s  -0.7147 -0.2147 -0.4415  0.4981
 *      6472.000000 s  -0.7589  0.0455 -0.0365  0.6486
 *      8090.000000 s  -0.6964  0.1651  0.0391  0.6974
 *   $ head -n 3 attitude.csv
 *   t,qw,qx,qy,qz
 *   0.000000000,0.637107248,0.154118786,-0.739009768,0.155583793
 *   1.000000000,0.637107248,0.154118786,-0.739009768,0.155583793
 *   $ sed 's/tx ty tz qx qy qz qw/qx qy qz qw tx ty tz/' data/tum_fr1_xyz.tum >positions.tum
 *   $ ./01_sample_recording positions.tum rotation_spline 1 attitude.csv
 *   positions.tum:304: norm off by 1.4, in 3000 of 3000 rows by more than 0.01: positions, angles?
 *   status 1
 */

/* Lesson 17: whole poses: the path of a camera, its orientation and its position at the same times.
 *
 *   17_camera_path GROUNDTRUTH.tum
 *
 * Positions are a curve of their own beside the trajectory, with the same knots, gaps and ends; one call samples both,
 * and a pose that either of them has no value for is missing as a whole. Here every tenth pose of a recording is kept,
 * and the others tell how well the path comes back. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "lesson.h"

enum { kept = 10 };                     /* of the recording's 100 Hz */
static const double longest_gap = 0.12; /* s */
static const char* const layout = "timestamp tx ty tz qx qy qz qw";
static const char* const position_columns[5] = {"timestamp", "tx", "ty", "tz", "qw"};

static qtraj_trajectory* create_trajectory(const double* times, const double* q, size_t count) {
  qtraj_options* options;
  qtraj_trajectory* orientations;
  must(qtraj_options_create(QTRAJ_ROTATION_SPLINE, &options), "options");
  must(qtraj_options_set_longest_gap(options, longest_gap), "longest gap");
  must(qtraj_create_with_options(options, times, q, count, &orientations, NULL), "create");
  qtraj_options_destroy(options);
  return orientations;
}

static qtraj_vector_curve* create_positions(int32_t method, const double* times, const double* p, size_t count) {
  qtraj_options* options;
  qtraj_vector_curve* positions;
  must(qtraj_options_create(method, &options), "options");
  must(qtraj_options_set_longest_gap(options, longest_gap), "longest gap");
  must(qtraj_vector_create(options, times, p, NULL, NULL, count, 3, &positions, NULL), "positions");
  qtraj_options_destroy(options);
  return positions;
}

/* Mean distance in mm of positions that were left out from the curve, where it has a value. */
static double mean_error(double (*p)[3], const struct keys* recorded, size_t count, size_t* missing) {
  double sum = 0;
  size_t i, k;
  for (*missing = i = 0; i < count; ++i) {
    double square = 0;
    if (isnan(p[i][0])) {
      ++*missing;
      continue;
    }
    for (k = 0; k < 3; ++k) square += (p[i][k] - recorded->q[i][k]) * (p[i][k] - recorded->q[i][k]);
    sum += sqrt(square);
  }
  return 1000 * sum / (double)(count - *missing);
}

int main(int argc, char** argv) {
  static const int32_t methods[] = {QTRAJ_VECTOR_LINEAR, QTRAJ_VECTOR_CUBIC};
  struct keys keys, places; /* the same rows: orientations x y z w, positions in the first three columns */
  double *times, *q, *p, (*q_out)[4], (*p_out)[3], (*v_out)[3], speed = 0;
  size_t count, samples, i, k, missing;
  qtraj_trajectory* orientations;

  if (argc != 2) {
    fprintf(stderr, "usage: %s GROUNDTRUTH.tum\n", argv[0]);
    return 1;
  }
  keys = read_keys(argv[1], layout);
  places = read_columns(argv[1], position_columns, layout);
  count = (keys.count - 1) / kept + 1;
  samples = (count - 1) * kept + 1; /* up to the last pose that is kept */
  times = malloc(count * sizeof *times);
  q = malloc(4 * count * sizeof *q);
  p = malloc(3 * count * sizeof *p);
  q_out = malloc(samples * sizeof *q_out);
  p_out = malloc(samples * sizeof *p_out);
  v_out = malloc(samples * sizeof *v_out);
  if (!times || !q || !p || !q_out || !p_out || !v_out) return 1;
  for (i = 0; i < count; ++i) {
    times[i] = keys.times[kept * i];
    for (k = 0; k < 4; ++k) q[4 * i + k] = keys.q[kept * i][k];
    for (k = 0; k < 3; ++k) p[3 * i + k] = places.q[kept * i][k];
  }
  orientations = create_trajectory(times, q, count);

  for (k = 0; k < 2; ++k) {
    qtraj_vector_curve* positions = create_positions(methods[k], times, p, count);
    const qtraj_status status = qtraj_sample_poses(orientations, positions, QTRAJ_FRAME_WORLD, keys.times, samples,
                                                   q_out[0], NULL, NULL, p_out[0], v_out[0], NULL, NULL);
    if (status != QTRAJ_E_GAP) must(status, "sample"); /* poses in gaps are NaN, all others right */
    printf("%s: %.2f mm off on average\n", k == 0 ? "lines" : "cubics", mean_error(p_out, &places, samples, &missing));
    qtraj_vector_destroy(positions);
  }
  for (i = 0; i < samples; ++i) {
    const double length = sqrt(v_out[i][0] * v_out[i][0] + v_out[i][1] * v_out[i][1] + v_out[i][2] * v_out[i][2]);
    if (length > speed) speed = length; /* false for NaN */
  }
  printf("%lu of %lu poses fall into gaps; the camera's highest speed is %.2f m/s\n", (unsigned long)missing,
         (unsigned long)samples, speed);
  printf("poses, as `%s`:\n", layout);
  for (i = 5; i < samples; i += 900)
    printf("%.4f %.4f %.4f %.4f %.4f %.4f %.4f %.4f\n", keys.times[i], p_out[i][0], p_out[i][1], p_out[i][2],
           q_out[i][1], q_out[i][2], q_out[i][3], q_out[i][0]);

  qtraj_destroy(orientations);
  free_keys(&keys);
  free_keys(&places);
  free(times);
  free(q);
  free(p);
  free(q_out);
  free(p_out);
  free(v_out);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./17_camera_path data/tum_fr1_xyz.tum
 *   lines: 0.61 mm off on average
 *   cubics: 0.26 mm off on average
 *   9 of 2991 poses fall into gaps; the camera's highest speed is 0.58 m/s
 *   poses, as `timestamp tx ty tz qx qy qz qw`:
 *   1305031098.7158 1.3458 0.6307 1.6276 0.6143 0.5972 -0.3320 -0.3947
 *   1305031107.7157 1.3172 0.6442 1.6714 0.6502 0.6186 -0.2818 -0.3393
 *   1305031116.8156 1.2562 0.7833 1.5339 0.7299 0.5762 -0.2061 -0.3046
 *   1305031125.8155 1.0717 0.5820 1.6216 0.6378 0.6428 -0.3057 -0.2943
 */

/* Lesson 19: a rotation channel of a glTF file, as the file prescribes it.
 *
 *   19_gltf_channel ANIMATION.csv
 *
 * A sampler whose interpolation is CUBICSPLINE has three rows of floats for each key, x y z w: in-tangent, value,
 * out-tangent. QTRAJ_QUATERNION_HERMITE takes them as they are, signs and norms included; before the first key and
 * after the last a channel holds. (LINEAR is QTRAJ_SLERP.)
 *
 * The channel is made here, of the right upper arm of the fox of lesson 3: the tangents are slopes between the keys
 * before and after. */
#include <math.h>
#include <stdio.h>

#include "lesson.h"

enum { arm_begins = 4 * 25, arm_keys = 25 }; /* the fifth joint of the file */

struct channel {
  float input[arm_keys];        /* times, s */
  float output[arm_keys][3][4]; /* in-tangent, value, out-tangent; x y z w */
};

/* What an exporter does. */
static struct channel make_channel(const struct keys* keys) {
  const double* t = keys->times + arm_begins;
  double(*q)[4] = keys->q + arm_begins;
  struct channel channel;
  int key, k;
  for (key = 0; key < arm_keys; ++key) {
    const int before = key > 0 ? key - 1 : 0, after = key + 1 < arm_keys ? key + 1 : key;
    channel.input[key] = (float)t[key];
    for (k = 0; k < 4; ++k) {
      const int wxyz = (k + 1) % 4;
      const double slope = (q[after][wxyz] - q[before][wxyz]) / (t[after] - t[before]);
      channel.output[key][0][k] = channel.output[key][2][k] = (float)slope;
      channel.output[key][1][k] = (float)q[key][wxyz];
    }
  }
  return channel;
}

static qtraj_trajectory* create_curve(const struct channel* channel, const double times[arm_keys]) {
  float rows[3][arm_keys][4]; /* in-tangents, keys, out-tangents, apart */
  qtraj_options* options;
  qtraj_trajectory* curve;
  int key, part;
  for (part = 0; part < 3; ++part)
    for (key = 0; key < arm_keys; ++key)
      must(qtraj_wxyz_from_xyzw_f32(channel->output[key][part], 1, rows[part][key]), "order");
  must(qtraj_options_create(QTRAJ_QUATERNION_HERMITE, &options), "options");
  must(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_HOLD), "hold");
  must(qtraj_create_with_tangents_f32(options, times, rows[1][0], rows[0][0], rows[2][0], arm_keys, &curve, NULL),
       "create");
  qtraj_options_destroy(options);
  return curve;
}

/* The formula of the glTF 2.0 specification, appendix C.5, not yet normalised; w x y z. */
static void by_the_file(const struct channel* channel, double time, double q[4]) {
  int k = 0, i;
  double td, t;
  while (k + 2 < arm_keys && channel->input[k + 1] <= time) ++k;
  td = (double)channel->input[k + 1] - channel->input[k];
  t = (time - channel->input[k]) / td;
  for (i = 0; i < 4; ++i)
    q[(i + 1) % 4] = (2 * t * t * t - 3 * t * t + 1) * channel->output[k][1][i] +
                     td * (t * t * t - 2 * t * t + t) * channel->output[k][2][i] +
                     (-2 * t * t * t + 3 * t * t) * channel->output[k + 1][1][i] +
                     td * (t * t * t - t * t) * channel->output[k + 1][0][i];
}

int main(int argc, char** argv) {
  struct keys keys;
  struct channel channel;
  double times[arm_keys], off = 0, off_squad = 0, peak, norm;
  qtraj_trajectory *curve, *squad;
  size_t count, i;

  if (argc != 2) {
    fprintf(stderr, "usage: %s ANIMATION.csv\n", argv[0]);
    return 1;
  }
  keys = read_keys(argv[1], NULL);
  if (keys.count < arm_begins + arm_keys) return 1;
  channel = make_channel(&keys);
  for (i = 0; i < arm_keys; ++i) times[i] = channel.input[i];
  curve = create_curve(&channel, times);
  must(qtraj_create(QTRAJ_SQUAD, times, keys.q[arm_begins], arm_keys, &squad, NULL), "create");

  must(qtraj_uniform_count(curve, times[0], 1 / 60.0, &count), "count");
  for (i = 0; i < count; ++i) {
    const double time = times[0] + (double)i / 60.0;
    double q[4], q_squad[4], q_file[4], omega_body[3];
    must(qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, time, NULL, q, omega_body, NULL), "sample");
    must(qtraj_sample_at(squad, time, NULL, q_squad), "sample");
    by_the_file(&channel, time, q_file);
    must(qtraj_normalize(q_file, 1, q_file, NULL), "normalize");
    off = fmax(off, degrees_between(q, q_file));
    off_squad = fmax(off_squad, degrees_between(q_squad, q_file));
    if (i % 20 == 0)
      printf("%5.3f s  %7.4f %7.4f %7.4f %7.4f  turning at %7.3f rad/s about z\n", time, q[0], q[1], q[2], q[3],
             omega_body[2]);
  }
  must(qtraj_curve_peak_rates(curve, &peak, NULL, NULL, NULL), "peak");
  must(qtraj_curve_least_norm(curve, &norm, NULL), "norm");
  printf("%lu frames, from the file's formula %s; at most %.3f rad/s, least norm %.4f\n", (unsigned long)count,
         off < 1e-12 ? "less than 1e-12 degrees" : "too far", peak, norm);
  printf("SQUAD through the same keys is off by up to %.2f degrees\n", off_squad);

  qtraj_destroy(squad);
  qtraj_destroy(curve);
  free_keys(&keys);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./19_gltf_channel data/fox_run_gltf.csv
 *   0.000 s   0.5313 -0.0038 -0.0050 -0.8472  turning at   2.947 rad/s about z
 *   0.333 s   0.9048  0.0002 -0.0216 -0.4253  turning at   3.116 rad/s about z
 *   0.667 s   0.4408  0.0001 -0.0097 -0.8976  turning at  -1.045 rad/s about z
 *   1.000 s   0.5979 -0.0292  0.0024 -0.8010  turning at   3.476 rad/s about z
 *   70 frames, from the file's formula less than 1e-12 degrees; at most 16.196 rad/s, least norm 0.9947
 *   SQUAD through the same keys is off by up to 2.56 degrees
 */

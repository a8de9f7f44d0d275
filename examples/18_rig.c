/* Lesson 18: a rig: all joints at once, frame by frame and as a whole.
 *
 *   18_rig ANIMATION.csv
 *
 * The fox of lesson 3 again. A frame of a game is all joints at one time: one call, which fills vectors across joints.
 * A clip that is baked is all joints at many times: one call too, its rows by time, as a player streams them, or by
 * joint, as a file stores them. Rates come in the same call: here they tell which joint turns fastest. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lesson.h"

enum { max_joints = 32, frames_a_second = 60 };

/* The joint whose keys begin at key `first`; *end is where they end: there time starts again. The clip repeats. */
static qtraj_trajectory* create_joint(const struct keys* keys, size_t first, size_t* end) {
  qtraj_options* options;
  qtraj_trajectory* joint;
  for (*end = first + 1; *end < keys->count && keys->times[*end] > keys->times[*end - 1]; ++*end) continue;
  must(qtraj_options_create(QTRAJ_SLERP, &options), "options");
  must(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC), "options");
  must(qtraj_options_set_closure(options, 1e-5), "closure"); /* the file's numbers are floats */
  must(qtraj_create_with_options(options, keys->times + first, keys->q[first], *end - first, &joint, NULL), "create");
  qtraj_options_destroy(options);
  return joint;
}

/* What playing needs: the pose of one frame, [joints][4]. */
static void play(const qtraj_trajectory* const* rig, size_t joints, int frame, double (*pose)[4]) {
  const double time = frame / (double)frames_a_second;
  must(qtraj_sample_many(rig, joints, QTRAJ_FRAME_BODY, &time, 1, QTRAJ_LAYOUT_TIME_FIRST, pose[0], NULL, NULL, NULL),
       "frame");
}

int main(int argc, char** argv) {
  qtraj_trajectory* joints[max_joints];
  const qtraj_trajectory* rig[max_joints];
  double pose[max_joints][4], *times, (*by_time)[4], (*omega)[3], duration, fastest = 0;
  size_t count = 0, frames, first = 0, i, joint, which = 0;
  int same = 1;
  struct keys keys;

  if (argc != 2) {
    fprintf(stderr, "usage: %s ANIMATION.csv\n", argv[0]);
    return 1;
  }
  keys = read_keys(argv[1], NULL);
  for (; first < keys.count && count < max_joints; ++count)
    rig[count] = joints[count] = create_joint(&keys, first, &first);
  duration = qtraj_end_time(rig[0]);
  frames = (size_t)ceil(duration * frames_a_second);

  /* the whole clip: rows [frames][joints] */
  times = malloc(frames * sizeof *times);
  by_time = malloc(frames * count * sizeof *by_time);
  omega = malloc(frames * count * sizeof *omega);
  if (!times || !by_time || !omega) return 1;
  for (i = 0; i < frames; ++i) times[i] = (double)i / frames_a_second;
  must(qtraj_sample_many(rig, count, QTRAJ_FRAME_BODY, times, frames, QTRAJ_LAYOUT_TIME_FIRST, by_time[0], omega[0],
                         NULL, NULL),
       "clip");
  printf("%lu joints, %lu frames of a run that takes %.3f s\n", (unsigned long)count, (unsigned long)frames, duration);

  /* playing gives the same numbers */
  for (i = 0; i < frames; ++i) {
    play(rig, count, (int)i, pose);
    same = same && memcmp(pose, by_time[i * count], count * sizeof pose[0]) == 0;
  }
  printf("frame by frame the same bits: %s\n", same ? "yes" : "no");

  for (i = 0; i < frames * count; ++i) {
    const double rate = sqrt(omega[i][0] * omega[i][0] + omega[i][1] * omega[i][1] + omega[i][2] * omega[i][2]);
    if (rate > fastest) fastest = rate, which = i;
  }
  joint = which % count;
  printf("fastest: joint %lu in frame %lu, %.1f rad/s\n", (unsigned long)joint, (unsigned long)(which / count),
         fastest);

  for (i = 0; i < count; ++i) qtraj_destroy(joints[i]);
  free_keys(&keys);
  free(times);
  free(by_time);
  free(omega);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./18_rig data/fox_run_gltf.csv
 *   20 joints, 70 frames of a run that takes 1.158 s
 *   frame by frame the same bits: yes
 *   fastest: joint 3 in frame 33, 19.1 rad/s
 */

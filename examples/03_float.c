/* Lesson 3: the same with float.
 *
 *   03_float ANIMATION.csv
 *
 * Animations come and go in float: `_f32` functions read and write it. Times stay double. The file has the keys of all
 * joints of a running fox, one joint after the other, as `joint,t,qx,qy,qz,qw`; every joint gets its own curve, and for
 * each frame the pose is the orientation of every joint relative to its parent. SLERP is what the file asks for: its
 * format calls that LINEAR. */
#include <stdio.h>

#include "lesson.h"

enum { max_joints = 32, max_keys = 100, arm = 4, leg = 15 };

/* The joint whose keys begin at key `first`; *end is where they end: there time starts again. */
static qtraj_trajectory* create_joint(const struct keys* keys, size_t first, size_t* end) {
  float q[max_keys][4];
  qtraj_trajectory* joint;
  size_t i, count = 0;
  int k;
  do {
    i = first + count;
    for (k = 0; k < 4; ++k) q[count][k] = (float)keys->q[i][k]; /* the file's numbers are floats */
    ++count;
  } while (count < max_keys && i + 1 < keys->count && keys->times[i + 1] > keys->times[i]);
  *end = first + count;
  must(qtraj_create_f32(QTRAJ_SLERP, keys->times + first, q[0], count, &joint, NULL), "create");
  return joint;
}

int main(int argc, char** argv) {
  qtraj_trajectory* joints[max_joints];
  float pose[max_joints][4];
  double q[4], off, largest = 0;
  struct keys keys;
  size_t count = 0, joint, first = 0;
  int frame, k;

  if (argc != 2) {
    fprintf(stderr, "usage: %s ANIMATION.csv\n", argv[0]);
    return 1;
  }
  keys = read_keys(argv[1], NULL);
  while (first < keys.count && count < max_joints) joints[count++] = create_joint(&keys, first, &first);
  if (count <= leg) return 1;
  printf("%lu joints, %lu keys\n", (unsigned long)count, (unsigned long)keys.count);

  for (frame = 0; frame <= 60; ++frame) {
    const double time = frame / 60.0;
    for (joint = 0; joint < count; ++joint) {
      must(qtraj_sample_at_f32(joints[joint], time, NULL, pose[joint]), "sample");
      /* any trajectory can be sampled in float and in double */
      must(qtraj_sample_at(joints[joint], time, NULL, q), "sample");
      for (k = 0; k < 4; ++k) {
        off = pose[joint][k] > q[k] ? pose[joint][k] - q[k] : q[k] - pose[joint][k];
        if (off > largest) largest = off;
      }
    }
    if (frame % 20 == 0)
      printf("frame %2d  arm %7.4f %7.4f %7.4f %7.4f  leg %7.4f %7.4f %7.4f %7.4f\n", frame, pose[arm][0], pose[arm][1],
             pose[arm][2], pose[arm][3], pose[leg][0], pose[leg][1], pose[leg][2], pose[leg][3]);
  }
  printf("float and double differ by less than 3e-7: %s\n", largest < 3e-7 ? "yes" : "no");

  for (joint = 0; joint < count; ++joint) qtraj_destroy(joints[joint]);
  free_keys(&keys);
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./03_float data/fox_run_gltf.csv
 *   20 joints, 500 keys
 *   frame  0  arm  0.5313 -0.0038 -0.0050 -0.8472  leg -0.4948 -0.0446 -0.0826  0.8639
 *   frame 20  arm  0.9048  0.0002 -0.0216 -0.4253  leg -0.0261 -0.0537 -0.0448  0.9972
 *   frame 40  arm  0.4408  0.0001 -0.0097 -0.8976  leg -0.2742 -0.0448 -0.0260  0.9603
 *   frame 60  arm  0.5900 -0.0275  0.0020 -0.8069  leg -0.7430  0.0153 -0.1249  0.6573
 *   float and double differ by less than 3e-7: yes
 */

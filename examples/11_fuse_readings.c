/* Lesson 11: three readings of one attitude, fused into one, and what AMBIGUOUS means.
 *
 *   11_fuse_readings
 *
 * A weight says how many times a reading counts: weight 2 is the same reading given twice, 0 leaves it out, and only
 * the ratios matter. Readings of independent errors are fused best with 1 / sigma^2, sigma the angle by which a reading
 * is off as a rule. */
#include <math.h>
#include <stdio.h>

#include "lesson.h"

enum { readings = 3 };
struct sensor {
  const char* name;
  double sigma; /* degrees */
};
static const struct sensor sensors[readings] = {{"star tracker", 0.5}, {"sun and horizon", 1}, {"magnetometer", 3}};

/* As they come in: with the signs and the norms that each sensor gives them. */
static const double attitudes[readings][4] = {
    {0.8829, 0.1561, 0.3128, 0.3130}, {-0.8798, -0.1622, -0.3249, -0.3060}, {1.8016, 0.2684, 0.5690, 0.6010}};

static void fuse(void) {
  const double degrees = 45 / atan(1.0);
  double weights[readings], sum = 0, eigen[4], karcher[4], eigengap, off[readings];
  int32_t iterations;
  int i;
  for (i = 0; i < readings; ++i) {
    weights[i] = 1 / (sensors[i].sigma * sensors[i].sigma);
    sum += weights[i];
  }

  /* The eigen mean minimises the weighted sum of squared chords, in one pass, the Karcher mean that of squared angles,
   * in a few. They differ in the third order of the spread only. Tolerance 0 is the finest there is. */
  must(qtraj_mean_eigen(attitudes[0], weights, readings, eigen, &eigengap, NULL), "eigen mean");
  must(qtraj_mean_karcher(attitudes[0], weights, readings, 0, 50, karcher, &iterations, NULL, NULL), "Karcher mean");
  printf("eigen mean    %.6f %.6f %.6f %.6f, eigengap %.4f\n", eigen[0], eigen[1], eigen[2], eigen[3], eigengap);
  printf("Karcher mean  %.6f %.6f %.6f %.6f, %d iterations, %.5f degrees away\n", karcher[0], karcher[1], karcher[2],
         karcher[3], (int)iterations, degrees_between(eigen, karcher));

  printf("good to %.2f degrees, were the readings as good as they say:\n", 1 / sqrt(sum));
  /* One mean serves all rows. Neither signs nor norms matter to the angle by which a body turns. */
  must(qtraj_rotation_angle(attitudes[0], readings, karcher, 1, readings, off, NULL), "angles");
  for (i = 0; i < readings; ++i)
    printf("  %-15s  weight %.2f  off by %.2f degrees\n", sensors[i].name, weights[i], degrees * off[i]);
}

/* Of several best answers one is written; which one is a matter of rounding, and nothing to print. */
static void show(const char* what, qtraj_status status, const double q[4]) {
  printf("  %-14s", what);
  if (status == QTRAJ_OK) printf("%.3f %.3f %.3f %.3f  ", q[0], q[1], q[2], q[3]);
  printf("%s\n", qtraj_status_text(status));
}

/* Two readings a half turn apart. From either, the ways to the other by the left and by the right are equally long, so
 * there are two best means by angle, at any weights. Chords know no such tie between unequal weights: there the eigen
 * mean is the heavier reading. AMBIGUOUS comes with one of the best answers: use it where any will do, else ask for
 * another reading. */
static void disagree(void) {
  const double apart[2][4] = {{1, 0, 0, 0}, {0, 0, 0, 1}}, weights[2][2] = {{1, 1}, {2, 1}};
  double mean[4];
  int i;
  for (i = 0; i < 2; ++i) {
    qtraj_status status;
    printf("half a turn apart, weights %.0f and %.0f:\n", weights[i][0], weights[i][1]);
    status = qtraj_mean_eigen(apart[0], weights[i], 2, mean, NULL, NULL);
    show("eigen mean", status, mean);
    status = qtraj_mean_karcher(apart[0], weights[i], 2, 0, 50, mean, NULL, NULL, NULL);
    show("Karcher mean", status, mean);
    printf("  %-14sthis one %.1f and %.1f degrees from the readings\n", "", degrees_between(mean, apart[0]),
           degrees_between(mean, apart[1]));
  }
}

int main(void) {
  fuse();
  disagree();
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./11_fuse_readings
 *   eigen mean    0.882855 0.156849 0.314615 0.311420, eigengap 0.9999
 *   Karcher mean  0.882856 0.156848 0.314614 0.311420, 2 iterations, 0.00011 degrees away
 *   good to 0.44 degrees, were the readings as good as they say:
 *     star tracker     weight 4.00  off by 0.29 degrees
 *     sun and horizon  weight 1.00  off by 1.51 degrees
 *     magnetometer     weight 0.11  off by 4.94 degrees
 *   half a turn apart, weights 1 and 1:
 *     eigen mean    more than one answer is equally right: see the rule of the function
 *     Karcher mean  more than one answer is equally right: see the rule of the function
 *                   this one 90.0 and 90.0 degrees from the readings
 *   half a turn apart, weights 2 and 1:
 *     eigen mean    1.000 0.000 0.000 0.000  success
 *     Karcher mean  more than one answer is equally right: see the rule of the function
 *                   this one 60.0 and 120.0 degrees from the readings
 */

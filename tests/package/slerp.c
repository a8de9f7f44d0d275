/* The smallest user of the library: SLERP through three keys about one axis, sampled, compared with known values. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "qtraj.h"

int main(void) {
  const double half = 0.70710678118654752; /* cos 45 degrees */
  const double cos_eighth = 0.92387953251128674, sin_eighth = 0.38268343236508977;
  const double key_times[] = {0.0, 1.0, 3.0}; /* s; turned by 0, 90 and 180 degrees about z */
  const double keys[] = {1, 0, 0, 0, half, 0, 0, half, 0, 0, 0, 1};
  const double times[] = {0.5, 1.0, 2.0}; /* turned by 45, 90 and 135 degrees */
  const double expected[] = {cos_eighth, 0, 0, sin_eighth, half, 0, 0, half, sin_eighth, 0, 0, cos_eighth};
  double q[12];
  qtraj_trajectory* trajectory = NULL;
  size_t i;

  if (strcmp(qtraj_version(), QTRAJ_VERSION_STRING) != 0) return 1;
  if (qtraj_create(QTRAJ_SLERP, key_times, keys, 3, &trajectory, NULL) != QTRAJ_OK) return 1;
  if (qtraj_sample(trajectory, times, 3, q, NULL) != QTRAJ_OK) return 1;
  qtraj_destroy(trajectory);
  for (i = 0; i < 12; ++i) {
    if (!(fabs(q[i] - expected[i]) <= 1e-15)) {
      printf("component %lu: %.17g, expected %.17g\n", (unsigned long)i, q[i], expected[i]);
      return 1;
    }
  }
  printf("qtraj %s\n", qtraj_version());
  return 0;
}

/* Lesson 5: without a heap: options and trajectory in static memory.
 *
 * What create does with malloc, init does in memory of the caller, aligned to 8 bytes: nothing is allocated, here or in
 * any sampling function. Linked with libqtraj.a the program needs no C++ runtime either. SQUAD, as these
 * are waypoints far apart, and each moves only what is near it. */
#include <stdio.h>

#include "lesson.h"

#define LOOKS 5
static const double look_times[LOOKS] = {0.0, 1.5, 3.0, 4.0, 6.0}; /* s */
static const double looks[LOOKS][4] = {
    {0.9877, -0.0114, 0.1300, 0.0864},   /* almost ahead, and down by 15 degrees */
    {0.8121, -0.0749, 0.1069, 0.5687},   /* to the left */
    {0.7698, -0.1962, 0.2802, 0.5390},   /* further down */
    {0.8848, 0.0915, 0.1962, -0.4126},   /* to the right */
    {-0.9877, 0.0114, -0.1300, -0.0864}, /* back again; the sign does not matter */
};

/* Arrays of double are aligned as needed. How much a trajectory takes depends on the method, the number of keys and the
 * version: qtraj_init_size tells. */
static double options_memory[QTRAJ_OPTIONS_BYTES / sizeof(double)];
static double trajectory_memory[512];

int main(void) {
  qtraj_options* options;
  qtraj_trajectory* pointing;
  double q[4];
  size_t bytes, cursor = 0;
  qtraj_status status;
  int tick;

  must(qtraj_options_init(options_memory, sizeof options_memory, QTRAJ_SQUAD, &options), "options");
  must(qtraj_init_size(options, LOOKS, &bytes), "size");
  if (bytes > sizeof trajectory_memory) return 1;

  /* too little memory is a status, not a crash */
  status = qtraj_init(trajectory_memory, bytes / 2, options, 0, look_times, looks[0], NULL, NULL, NULL, LOOKS,
                      &pointing, NULL);
  printf("half the memory: %s\n", qtraj_status_text(status));

  /* the three 0, NULL, NULL: no rates at the keys */
  must(qtraj_init(trajectory_memory, sizeof trajectory_memory, options, 0, look_times, looks[0], NULL, NULL, NULL,
                  LOOKS, &pointing, NULL),
       "init");
  for (tick = 0; tick <= 12; tick += 2) {
    must(qtraj_sample_at(pointing, 0.5 * tick, &cursor, q), "sample");
    printf("%.1f s  %.3f %6.3f %.3f %6.3f\n", 0.5 * tick, q[0], q[1], q[2], q[3]);
  }
  /* destroy is not needed here and does nothing; the memory may be used for something else once sampling is over */
  return 0;
}

/* Prints, in this folder:
 *
 *   $ ./05_static_memory
 *   half the memory: memory too small or not aligned to 8 bytes: ask qtraj_init_size
 *   0.0 s  0.988 -0.011 0.130  0.086
 *   1.0 s  0.883 -0.050 0.102  0.455
 *   2.0 s  0.736 -0.130 0.150  0.647
 *   3.0 s  0.770 -0.196 0.280  0.539
 *   4.0 s  0.885  0.092 0.196 -0.413
 *   5.0 s  0.915  0.103 0.133 -0.367
 *   6.0 s  0.988 -0.011 0.130  0.086
 */

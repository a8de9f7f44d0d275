#include "lesson.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void stop(const char* path, size_t line, const char* why) {
  fprintf(stderr, "%s:%lu: %s\n", path, (unsigned long)line, why);
  exit(1);
}

void must(qtraj_status status, const char* what) {
  if (status == QTRAJ_OK) return;
  fprintf(stderr, "%s: %s\n", what, qtraj_status_text(status));
  exit(1);
}

double degrees_between(const double a[4], const double b[4]) {
  const double degrees = 45.0 / atan(1.0);
  double difference = 0, sum = 0;
  int k;
  for (k = 0; k < 4; ++k) {
    difference += (a[k] - b[k]) * (a[k] - b[k]);
    sum += (a[k] + b[k]) * (a[k] + b[k]);
  }
  return 4.0 * degrees * atan2(sqrt(fmin(difference, sum)), sqrt(fmax(difference, sum)));
}

/* ---- Reading ---- */

static void* grow(void* array, size_t bytes) {
  void* grown = realloc(array, bytes);
  if (grown == NULL) {
    fprintf(stderr, "out of memory\n");
    exit(1);
  }
  return grown;
}

/* Reads the field'th number of a row, from 0; 0 if there is none. */
static int read_field(const char* row, int field, double* value) {
  const char* const blanks = " \t\r\n";
  char* end;
  row += strspn(row, blanks);
  for (; field > 0; --field) {
    row += strcspn(row, ", \t\r\n");
    row += strspn(row, blanks);
    if (*row == ',') row += 1 + strspn(row + 1, blanks);
  }
  *value = strtod(row, &end);
  return end != row && strchr(", \t\r\n", *end) != NULL;
}

/* Appends a row to the keys; 0 if a number is missing. */
static int add_key(struct keys* keys, const char* row, const int columns[5], size_t line) {
  const size_t i = keys->count;
  int k;
  if ((i & (i - 1)) == 0) { /* full at 0, 1, 2, 4, ... */
    const size_t room = i == 0 ? 1 : 2 * i;
    keys->times = grow(keys->times, room * sizeof *keys->times);
    keys->q = grow(keys->q, room * sizeof *keys->q);
    keys->lines = grow(keys->lines, room * sizeof *keys->lines);
  }
  if (!read_field(row, columns[0], &keys->times[i])) return 0;
  for (k = 0; k < 4; ++k) {
    if (!read_field(row, columns[k + 1], &keys->q[i][k])) return 0;
  }
  keys->lines[i] = line;
  ++keys->count;
  return 1;
}

struct keys read_keys(const char* path, const int columns[5]) {
  struct keys keys = {0, NULL, NULL, NULL};
  char row[1024];
  size_t line = 0;
  FILE* file = fopen(path, "r");
  if (file == NULL) {
    perror(path);
    exit(1);
  }
  while (fgets(row, sizeof row, file) != NULL) {
    ++line;
    if (strchr(row, '\n') == NULL && !feof(file)) stop(path, line, "line too long");
    if (row[0] == '#' || row[strspn(row, " \t\r\n")] == '\0') continue;
    if (add_key(&keys, row, columns, line)) continue;
    if (keys.count > 0) stop(path, line, "a number is missing");
  }
  if (ferror(file)) {
    perror(path);
    exit(1);
  }
  fclose(file);
  if (keys.count == 0) stop(path, line, "no keys");
  return keys;
}

void free_keys(struct keys* keys) {
  free(keys->times);
  free(keys->q);
  free(keys->lines);
}

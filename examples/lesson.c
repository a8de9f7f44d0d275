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

/* The next field of a row; it begins behind blanks and ends at a comma or a blank. */
static const char* next_field(const char* field) {
  field += strcspn(field, ", \t\r\n");
  field += strspn(field, " \t\r\n");
  if (*field == ',') field += 1 + strspn(field + 1, " \t\r\n");
  return field;
}

/* Reads the number of a field; 0 if there is none. */
static int read_number(const char* row, int place, double* value) {
  char* end;
  row += strspn(row, " \t\r\n");
  for (; place > 0; --place) row = next_field(row);
  *value = strtod(row, &end);
  return end != row && strchr(", \t\r\n", *end) != NULL;
}

static int is_named(const char* field, const char* name) {
  const size_t length = strcspn(field, ", \t\r\n");
  return length == strlen(name) && strncmp(field, name, length) == 0;
}

/* Place of a column, from 0; -1 if the heading does not name it. */
static int find_column(const char* heading, const char* name) {
  const char* field = heading + strspn(heading, "# \t\r\n");
  const int time = strcmp(name, "t") == 0;
  int place;
  for (place = 0; *field != '\0'; field = next_field(field), ++place) {
    if (is_named(field, name) || (time && (is_named(field, "time") || is_named(field, "timestamp")))) return place;
  }
  return -1;
}

/* 0 if the line does not name all columns. */
static int find_columns(const char* heading, const char* const names[5], int places[5]) {
  int k;
  for (k = 0; k < 5; ++k) {
    places[k] = find_column(heading, names[k]);
    if (places[k] < 0) return 0;
  }
  return 1;
}

/* Appends a row to the keys; 0 if a number is missing. */
static int add_key(struct keys* keys, const char* row, const int places[5], size_t line) {
  const size_t i = keys->count;
  int k;
  if ((i & (i - 1)) == 0) { /* full at 0, 1, 2, 4, ... */
    const size_t room = i == 0 ? 1 : 2 * i;
    keys->times = grow(keys->times, room * sizeof *keys->times);
    keys->q = grow(keys->q, room * sizeof *keys->q);
    keys->lines = grow(keys->lines, room * sizeof *keys->lines);
  }
  if (!read_number(row, places[0], &keys->times[i])) return 0;
  for (k = 0; k < 4; ++k) {
    if (!read_number(row, places[k + 1], &keys->q[i][k])) return 0;
  }
  keys->lines[i] = line;
  ++keys->count;
  return 1;
}

static int has_number(const char* row) {
  double number;
  return read_number(row, 0, &number) || read_number(row, 1, &number);
}

const char* const key_columns[5] = {"t", "qw", "qx", "qy", "qz"};

struct keys read_columns(const char* path, const char* const names[5], const char* layout) {
  struct keys keys = {0, NULL, NULL, NULL};
  char row[1024];
  size_t line = 0;
  int places[5], found = 0;
  FILE* file = fopen(path, "r");
  if (file == NULL) {
    perror(path);
    exit(1);
  }
  while (fgets(row, sizeof row, file) != NULL) {
    ++line;
    if (strchr(row, '\n') == NULL && !feof(file)) stop(path, line, "line too long");
    if (!found) found = find_columns(row, names, places);
    if (row[0] == '#' || row[strspn(row, " \t\r\n")] == '\0') continue;
    if (keys.count == 0 && !has_number(row)) { /* a heading */
      if (!found) stop(path, line, "the heading does not name the columns that are read here");
      continue;
    }
    if (!found && layout != NULL) found = find_columns(layout, names, places);
    if (!found) stop(path, line, "no heading above the numbers: which column is which?");
    if (!add_key(&keys, row, places, line)) stop(path, line, "a number is missing");
  }
  if (ferror(file)) {
    perror(path);
    exit(1);
  }
  fclose(file);
  if (keys.count == 0) stop(path, line, "no keys");
  return keys;
}

static int is_off(const double q[4]) {
  return fabs(sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]) - 1) > 0.01;
}

/* Ends the program unless all norms are 1 to 0.01. Faulty keys, NaN or 0, are left to the constructors. */
static void expect_quaternions(const char* path, const struct keys* keys) {
  qtraj_key_report report;
  size_t i, off = 0;
  const qtraj_status status = qtraj_check_keys(keys->times, keys->q[0], keys->count, NULL, &report, NULL);
  if (qtraj_status_class(status) == QTRAJ_CLASS_REFUSED) must(status, path);
  if (!(report.worst_norm_error > 0.01)) return;
  for (i = 0; i < keys->count; ++i) off += (size_t)is_off(keys->q[i]);
  fprintf(stderr, "%s:%lu: norm off by %.2g, in %lu of %lu rows by more than 0.01: ", path,
          (unsigned long)keys->lines[report.worst_norm_index], report.worst_norm_error, (unsigned long)off,
          (unsigned long)keys->count);
  fputs(2 * off > keys->count ? "positions, angles?\n" : "faulty rows?\n", stderr);
  exit(1);
}

struct keys read_keys(const char* path, const char* layout) {
  const struct keys keys = read_columns(path, key_columns, layout);
  expect_quaternions(path, &keys);
  return keys;
}

void free_keys(struct keys* keys) {
  free(keys->times);
  free(keys->q);
  free(keys->lines);
}

/* ---- What the caller says about them ---- */

void conjugate(struct keys* keys) { must(qtraj_conjugate(keys->q[0], keys->count, keys->q[0], NULL), "conjugate"); }

int take_option(int* argc, char** argv, const char* option) {
  int i, k;
  for (i = 1; i < *argc; ++i) {
    if (strcmp(argv[i], option) != 0) continue;
    for (k = i; k < *argc; ++k) argv[k] = argv[k + 1];
    --*argc;
    return 1;
  }
  return 0;
}

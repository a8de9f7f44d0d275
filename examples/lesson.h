/* What the lessons share: reading a recording, one way to stop, the angle between two orientations. */
#ifndef LESSON_H
#define LESSON_H

#include <qtraj.h>
#include <stddef.h>

/* Keyframes of a recording; free with free_keys. */
struct keys {
  size_t count;
  double* times;  /* [count] */
  double (*q)[4]; /* [count], in the order of the columns that were asked for */
  size_t* lines;  /* [count] line of the file that holds the key, from 1 */
};

/* Reads the columns t (or time, timestamp), qw, qx, qy and qz of a text file with one key a row, its fields apart by
 * commas or blanks. The heading says where they are: a line above the numbers, also one that starts with #. `layout`
 * stands for the heading of a file that has none; NULL: such a file is not read. Ends the program with a message if
 * that fails, and where the numbers are no quaternions: where a norm is off by more than 0.01. */
struct keys read_keys(const char* path, const char* layout);
/* The same of other columns, rates for instance, the first of them the time; their numbers may be anything. */
struct keys read_columns(const char* path, const char* const names[5], const char* layout);
extern const char* const key_columns[5]; /* those of read_keys */
void free_keys(struct keys* keys);

/* Turns keys that take world vectors to the body into those that take body vectors to the world, which the library
 * wants, or back. No file says which it has: only who wrote it does. */
void conjugate(struct keys* keys);

/* Whether the option is among the arguments; takes it out of them. */
int take_option(int* argc, char** argv, const char* option);

/* Ends the program with a message unless the status is QTRAJ_OK. Lesson 7 shows what else can be done. */
void must(qtraj_status status, const char* what);

/* Angle of the rotation from a to b, degrees in [0, 180]; a and b are of norm 1, their signs do not matter. */
double degrees_between(const double a[4], const double b[4]);

#endif

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

/* Reads a text file with one key a row, its fields apart by commas or blanks. `columns` are the places, from 0, of the
 * time and of the four components. Lines that start with # and a heading above the numbers are passed over. Ends the
 * program with a message if the file cannot be read. */
struct keys read_keys(const char* path, const int columns[5]);
void free_keys(struct keys* keys);

/* Ends the program with a message unless the status is QTRAJ_OK. Lesson 7 shows what else can be done. */
void must(qtraj_status status, const char* what);

/* Angle of the rotation from a to b, degrees in [0, 180]; a and b are of norm 1, their signs do not matter. */
double degrees_between(const double a[4], const double b[4]);

#endif

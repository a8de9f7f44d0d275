// Callers' arrays as functions over rows take them. Kernels include this header: it names no type of Eigen.
#pragma once

#include <cstddef>

#include "qtraj/settings.hpp"

namespace qtraj {

// Rows to read, of float or double; repeated: one row that serves all.
struct ArrayIn {
  const void* data;
  bool repeated;
};

struct PairArrays {
  ArrayIn a, b;      // [4]
  ArrayIn fraction;  // [1]
  void* q;           // [4]
  bool single;       // all of float
  Path path;
};
struct RotateArrays {
  ArrayIn q;      // [4]
  ArrayIn v;      // [3]
  void* v_world;  // [3]
  bool single;
};
struct KeyArrays {
  const void* q;  // [4]
  void* q_out;    // [4], may be q
  bool single;
};
struct UnitKeyArrays {
  const void* q;  // [4]
  bool single;
  double (*unit)[4];
  double (*unit_error)[4];  // what the rounding of unit left
};
struct RelativeRotationArrays {
  ArrayIn a, a_error;         // [4] of double: unit quaternions and what their rounding left
  const double *b, *b_error;  // the same
  double (*rotation)[4];      // from a to b: sin_part and angle as qtraj/so3.hpp has them
};
// Numbers in records, `stride` numbers from one to the next: pointers are to those of the first record.
struct JacobianRecords {
  const double* r;   // [3], a rotation vector
  double* jacobian;  // [9], Jr(r), column after column
  double* turning;   // [3], the factors of beta
  size_t stride;
};
struct SampleArrays {
  const void* q;        // [4]
  const void* weights;  // [1]; null: all 1
  size_t count;
  bool single;
  double weight_scale;  // a power of two
  bool is_padded;       // weights of 0 are those of rows that fill up the last lanes
};

}  // namespace qtraj

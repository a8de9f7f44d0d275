/* Generalised ufuncs over the functions of the C interface that take rows: broadcasting, out=, float32 and float64.
 *
 * One loop serves all that go row by row: a table says how many numbers a row of each operand has and which C function
 * takes it. Rows at fault are NaN, by the library; FE_INVALID makes np.errstate decide what becomes of them. An
 * ambiguous row holds an answer and sets a flag of the thread, which take_ambiguous() reads. */
#include <Python.h>
#include <fenv.h>
#include <math.h>
#include <numpy/arrayobject.h>
#include <numpy/ufuncobject.h>
#include <qtraj.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum {
  kOperands = 8, /* of one function, at most */
  kNumbers = 24, /* in one row of all operands together, at most */
  kBlock = 128,  /* rows that are gathered at a time where they are not contiguous */
  kLook = 64     /* rows that are looked at at a time once one is at fault */
};

static _Thread_local bool ambiguous;

enum { kInvalid = 1, kAmbiguous = 2 };

/* What a status says of rows. */
static int kind_of(qtraj_status status) {
  if (status == QTRAJ_OK) return 0;
  return qtraj_status_class(status) == QTRAJ_CLASS_ONE_OF_SEVERAL ? kAmbiguous : kInvalid;
}

/* Leaves what was seen where callers look for it. */
static void tell(int seen) {
  if (seen & kInvalid) feraiseexcept(FE_INVALID);
  if (seen & kAmbiguous) ambiguous = true;
}

/* ---- The functions, all with one signature ---- */

/* in: rows of each input, counts of them or one that serves all; out: count rows of each output. */
typedef qtraj_status call_rows(const void* const* in, const size_t* counts, size_t count, void* const* out,
                               size_t* bad);

#define CALL(name, type, call)                                                                                         \
  static qtraj_status name(const void* const* in, const size_t* counts, size_t count, void* const* out, size_t* bad) { \
    const type *a = in[0], *b = in[1], *c = in[2], *d = in[3], *e = in[4];                                             \
    const double *s = in[1], *t = in[3], *u = in[4];                                                                   \
    type *x = out[0], *y = out[1];                                                                                     \
    (void)counts, (void)bad, (void)a, (void)b, (void)c, (void)d, (void)e, (void)s, (void)t, (void)u, (void)x, (void)y; \
    return call;                                                                                                       \
  }
#define BOTH(name, function, arguments)          \
  CALL(name, double, qtraj_##function arguments) \
  CALL(name##_f32, float, qtraj_##function##_f32 arguments)

#define PAIRS (a, counts[0], b, counts[1], count, x, bad)
#define FRACTIONS(path) (a, counts[0], b, counts[1], c, counts[2], count, path, x, bad)
BOTH(slerp_shortest, slerp_pairs, FRACTIONS(QTRAJ_PATH_SHORTEST))
BOTH(slerp_as_given, slerp_pairs, FRACTIONS(QTRAJ_PATH_AS_GIVEN))
BOTH(nlerp_shortest, nlerp_pairs, FRACTIONS(QTRAJ_PATH_SHORTEST))
BOTH(nlerp_as_given, nlerp_pairs, FRACTIONS(QTRAJ_PATH_AS_GIVEN))
#define TIMES(path) (a, s, counts[0], c, t, counts[2], u, counts[4], count, path, x, bad)
BOTH(slerp_between_shortest, slerp_pairs_between, TIMES(QTRAJ_PATH_SHORTEST))
BOTH(slerp_between_as_given, slerp_pairs_between, TIMES(QTRAJ_PATH_AS_GIVEN))
BOTH(nlerp_between_shortest, nlerp_pairs_between, TIMES(QTRAJ_PATH_SHORTEST))
BOTH(nlerp_between_as_given, nlerp_pairs_between, TIMES(QTRAJ_PATH_AS_GIVEN))
BOTH(screw, screw_pairs, (a, b, counts[0], c, d, counts[2], e, counts[4], count, x, y, bad))
BOTH(multiply, multiply, PAIRS)
BOTH(rotate, rotate, PAIRS)
BOTH(distance, distance, PAIRS)
BOTH(exponential, exp, (a, count, x, bad))
BOTH(logarithm, log, (a, count, x, bad))
BOTH(rotation_vector_from_q, rotation_vector_from_q, (a, count, x, bad))
BOTH(q_from_rotation_vector, q_from_rotation_vector, (a, count, x, bad))
BOTH(matrix_from_q, matrix_from_q, (a, count, x, bad))
BOTH(normalize, normalize, (a, count, x, bad))
BOTH(wxyz_from_xyzw, wxyz_from_xyzw, (a, count, x))
BOTH(xyzw_from_wxyz, xyzw_from_wxyz, (a, count, x))
CALL(conjugate, double, qtraj_conjugate(a, count, x, bad))
CALL(inverse, double, qtraj_inverse(a, count, x, bad))
CALL(norm, double, qtraj_norm(a, count, x, bad))
CALL(dot, double, qtraj_dot PAIRS)
CALL(angle, double, qtraj_rotation_angle PAIRS)
CALL(power, double, qtraj_pow(a, b, counts[1], count, x, bad))
CALL(derivatives_body, double, qtraj_derivatives_from_rates(QTRAJ_FRAME_BODY, a, b, c, count, x, y, bad))
CALL(derivatives_world, double, qtraj_derivatives_from_rates(QTRAJ_FRAME_WORLD, a, b, c, count, x, y, bad))
CALL(rates_body, double, qtraj_rates_from_derivatives(QTRAJ_FRAME_BODY, a, b, c, count, x, y, bad))
CALL(rates_world, double, qtraj_rates_from_derivatives(QTRAJ_FRAME_WORLD, a, b, c, count, x, y, bad))

/* What the library takes one at a time: all rows at once where that one serves them all, else row by row. */
#define EACH(call)                                                         \
  for (size_t i = 0; i < count; ++i) {                                     \
    const qtraj_status status = call;                                      \
    if (status != QTRAJ_OK && first == QTRAJ_OK) first = status, *bad = i; \
  }                                                                        \
  return first

static qtraj_status squad_segment(const void* const* in, const size_t* counts, size_t count, void* const* out,
                                  size_t* bad) {
  const double* row[5];
  for (int k = 0; k < 5; ++k) row[k] = in[k];
  double* q = out[0];
  qtraj_status first = QTRAJ_OK;
  size_t step[5], unused;
  bool one = true;
  for (int k = 0; k < 5; ++k) step[k] = counts[k] == 1 ? 0 : k < 4 ? 4 : 1;
  for (int k = 0; k < 4; ++k) one = one && counts[k] == 1;
  if (one && counts[4] == count) return qtraj_squad_segment(row[0], row[1], row[2], row[3], row[4], count, q, bad);
  EACH(qtraj_squad_segment(row[0] + i * step[0], row[1] + i * step[1], row[2] + i * step[2], row[3] + i * step[3],
                           row[4] + i * step[4], 1, q + 4 * i, &unused));
}

#define FROM_MATRIX(name, type, function)                                                                              \
  static qtraj_status name(const void* const* in, const size_t* counts, size_t count, void* const* out, size_t* bad) { \
    const type *matrix = in[0], *limit = in[1];                                                                        \
    type *q = out[0], *distance = out[1];                                                                              \
    qtraj_status first = QTRAJ_OK;                                                                                     \
    size_t unused;                                                                                                     \
    if (counts[1] == 1) return function(matrix, count, (double)limit[0], q, distance, bad);                            \
    EACH(function(matrix + 9 * i, 1, (double)limit[i], q + 4 * i, distance + i, &unused));                             \
  }
FROM_MATRIX(q_from_matrix, double, qtraj_q_from_matrix)
FROM_MATRIX(q_from_matrix_f32, float, qtraj_q_from_matrix_f32)

static qtraj_status mean_from_moments(const void* const* in, const size_t* counts, size_t count, void* const* out,
                                      size_t* bad) {
  const double* moments = in[0];
  double *mean = out[0], *eigengap = out[1];
  qtraj_status first = QTRAJ_OK;
  (void)counts;
  EACH(qtraj_mean_from_moments(moments + 11 * i, mean + 4 * i, eigengap + i));
}

/* ---- The table ---- */

struct function {
  const char* name;
  const char* signature;
  int inputs, outputs;
  int width[kOperands]; /* numbers a row of each operand: 1: no core axis, 9: two of 3, else one */
  unsigned shared;      /* bit i: input i may have one row for all */
  unsigned tied;        /* bit i: input i has one row for all only together with the next */
  unsigned times;       /* bit i: operand i is double beside floats, too */
  call_rows* of_double;
  call_rows* of_float; /* NULL: by way of double */
};

#define PAIR_OF(name, width, out, signature) \
  { #name, signature, 2, 1, {4, width, out }, 3, 0, 0, name, name##_f32 }
#define ONE(name, width, out, signature) \
  { #name, signature, 1, 1, {width, out }, 0, 0, 0, name, name##_f32 }
#define BETWEEN(name) \
  { #name, "(4),(),(4),(),()->(4)", 5, 1, {4, 1, 4, 1, 1, 4 }, 31, 5, 26, name, name##_f32 }
#define FRACTION(name) \
  { #name, "(4),(4),()->(4)", 3, 1, {4, 4, 1, 4 }, 7, 0, 0, name, name##_f32 }
#define RATES(name) \
  { #name, "(4),(3),(3)->(4),(4)", 3, 2, {4, 3, 3, 4, 4 }, 0, 0, 0, name, NULL }
#define DERIVATIVES(name) \
  { #name, "(4),(4),(4)->(3),(3)", 3, 2, {4, 4, 4, 3, 3 }, 0, 0, 0, name, NULL }

static const struct function functions[] = {
    FRACTION(slerp_shortest),
    FRACTION(slerp_as_given),
    FRACTION(nlerp_shortest),
    FRACTION(nlerp_as_given),
    BETWEEN(slerp_between_shortest),
    BETWEEN(slerp_between_as_given),
    BETWEEN(nlerp_between_shortest),
    BETWEEN(nlerp_between_as_given),
    {"screw", "(4),(3),(4),(3),()->(4),(3)", 5, 2, {4, 3, 4, 3, 1, 4, 3}, 31, 5, 0, screw, screw_f32},
    PAIR_OF(multiply, 4, 4, "(4),(4)->(4)"),
    PAIR_OF(rotate, 3, 3, "(4),(3)->(3)"),
    PAIR_OF(distance, 4, 1, "(4),(4)->()"),
    {"dot", "(4),(4)->()", 2, 1, {4, 4, 1}, 3, 0, 0, dot, NULL},
    {"angle", "(4),(4)->()", 2, 1, {4, 4, 1}, 3, 0, 0, angle, NULL},
    {"power", "(4),()->(4)", 2, 1, {4, 1, 4}, 2, 0, 0, power, NULL},
    {"exp", "(3)->(4)", 1, 1, {3, 4}, 0, 0, 0, exponential, exponential_f32},
    {"log", "(4)->(3)", 1, 1, {4, 3}, 0, 0, 0, logarithm, logarithm_f32},
    ONE(rotation_vector_from_q, 4, 3, "(4)->(3)"),
    ONE(q_from_rotation_vector, 3, 4, "(3)->(4)"),
    ONE(matrix_from_q, 4, 9, "(4)->(3,3)"),
    ONE(normalize, 4, 4, "(4)->(4)"),
    ONE(wxyz_from_xyzw, 4, 4, "(4)->(4)"),
    ONE(xyzw_from_wxyz, 4, 4, "(4)->(4)"),
    {"conjugate", "(4)->(4)", 1, 1, {4, 4}, 0, 0, 0, conjugate, NULL},
    {"inverse", "(4)->(4)", 1, 1, {4, 4}, 0, 0, 0, inverse, NULL},
    {"norm", "(4)->()", 1, 1, {4, 1}, 0, 0, 0, norm, NULL},
    {"q_from_matrix", "(3,3),()->(4),()", 2, 2, {9, 1, 4, 1}, 2, 0, 0, q_from_matrix, q_from_matrix_f32},
    RATES(derivatives_body),
    RATES(derivatives_world),
    DERIVATIVES(rates_body),
    DERIVATIVES(rates_world),
    {"squad_segment", "(4),(4),(4),(4),()->(4)", 5, 1, {4, 4, 4, 4, 1, 4}, 31, 0, 0, squad_segment, NULL},
    {"mean_from_moments", "(11)->(4),()", 1, 2, {11, 4, 1}, 0, 0, 0, mean_from_moments, NULL},
};
enum { kFunctions = sizeof functions / sizeof functions[0] };

/* ---- The loop ---- */

/* An operand of the loop: rows at a distance, their numbers at distances of their own. */
struct operand {
  char* rows;
  npy_intp row_step;
  npy_intp step[2]; /* of the numbers of a row: from line to line of a matrix, from number to number */
  int width;
  bool is_double;
};

static npy_intp size_of(const struct operand* operand) { return operand->is_double ? sizeof(double) : sizeof(float); }

/* Whether the library can read or write the rows where they are. */
static bool is_contiguous(const struct operand* operand, npy_intp count, bool may_repeat) {
  const npy_intp size = size_of(operand);
  if (operand->width != 1 && operand->step[1] != size) return false;
  if (operand->width == 9 && operand->step[0] != 3 * size) return false;
  return count == 1 || operand->row_step == operand->width * size || (may_repeat && operand->row_step == 0);
}

static char* number(const struct operand* operand, npy_intp row, int k) {
  char* start = operand->rows + row * operand->row_step;
  if (operand->width == 9) return start + k / 3 * operand->step[0] + k % 3 * operand->step[1];
  return start + k * operand->step[1];
}

/* Rows from where they are to a block of double or float, and back. */
static void gather(const struct operand* operand, npy_intp first, npy_intp count, void* block, bool to_double) {
  for (npy_intp i = 0; i < count; ++i) {
    for (int k = 0; k < operand->width; ++k) {
      const char* from = number(operand, first + i, k);
      const npy_intp at = i * operand->width + k;
      if (!to_double)
        ((float*)block)[at] = *(const float*)from;
      else
        ((double*)block)[at] = operand->is_double ? *(const double*)from : (double)*(const float*)from;
    }
  }
}

static void scatter(const struct operand* operand, npy_intp first, npy_intp count, const void* block, bool of_double) {
  for (npy_intp i = 0; i < count; ++i) {
    for (int k = 0; k < operand->width; ++k) {
      char* to = number(operand, first + i, k);
      const npy_intp at = i * operand->width + k;
      if (!of_double)
        *(float*)to = ((const float*)block)[at];
      else if (operand->is_double)
        *(double*)to = ((const double*)block)[at];
      else
        *(float*)to = (float)((const double*)block)[at];
    }
  }
}

/* One call of a function on contiguous rows. */
struct call {
  const struct function* function;
  call_rows* rows;
  npy_intp size[kOperands]; /* bytes of a number of each operand, as the function takes them */
  const void* in[kOperands];
  void* out[kOperands];
  size_t counts[kOperands];
};

/* What a refused call leaves as it was: NaN. */
static void fill_nan(const struct call* call, size_t first, size_t count) {
  for (int k = 0; k < call->function->outputs; ++k) {
    const int operand = call->function->inputs + k;
    const size_t width = (size_t)call->function->width[operand];
    for (size_t i = first * width; i < (first + count) * width; ++i) {
      if (call->size[operand] == sizeof(double))
        ((double*)call->out[k])[i] = NAN;
      else
        ((float*)call->out[k])[i] = NAN;
    }
  }
}

/* Rows first to first + count of a call. Returns what was seen; *bad is the first row at fault, as of all rows. */
static int part(const struct call* call, size_t first, size_t count, size_t* bad) {
  const struct function* function = call->function;
  const void* in[kOperands] = {NULL};
  void* out[kOperands] = {NULL};
  size_t counts[kOperands];
  for (int k = 0; k < function->inputs; ++k) {
    const bool one = call->counts[k] == 1;
    in[k] = (const char*)call->in[k] + (one ? 0 : first * (size_t)(function->width[k] * call->size[k]));
    counts[k] = one ? 1 : count;
  }
  for (int k = 0; k < function->outputs; ++k) {
    const int operand = function->inputs + k;
    out[k] = (char*)call->out[k] + first * (size_t)(function->width[operand] * call->size[operand]);
  }
  const qtraj_status status = call->rows(in, counts, count, out, bad);
  *bad += first;
  if (status != QTRAJ_OK && qtraj_status_class(status) == QTRAJ_CLASS_REFUSED) fill_nan(call, first, count);
  return kind_of(status);
}

/* All rows. A status is that of the first row at fault: where there is one, those after it are looked at once more. */
static int all_rows(const struct call* call, size_t count) {
  size_t bad = 0, unused;
  int seen = part(call, 0, count, &bad);
  if (seen == 0 || bad >= count) return seen;
  for (size_t at = bad + 1; at < count && seen != (kInvalid | kAmbiguous); at += kLook) {
    const size_t end = at + kLook < count ? at + kLook : count;
    if (part(call, at, end - at, &unused) == 0) continue;
    for (size_t row = at; row < end; ++row) seen |= part(call, row, 1, &unused);
  }
  return seen;
}

struct loop {
  const struct function* function;
  bool is_double; /* operands, but for times, which always are */
};

static void find_operands(const struct loop* loop, char** args, const npy_intp* steps, struct operand* operands) {
  const struct function* function = loop->function;
  const int count = function->inputs + function->outputs;
  int core = count;
  for (int k = 0; k < count; ++k) {
    struct operand* operand = &operands[k];
    operand->rows = args[k];
    operand->row_step = steps[k];
    operand->width = function->width[k];
    operand->is_double = loop->is_double || (function->times >> k & 1);
    operand->step[0] = operand->width == 9 ? steps[core++] : 0;
    operand->step[1] = operand->width == 1 ? 0 : steps[core++];
  }
}

/* Where the operands lie, if the library can take them from there. */
static bool is_direct(const struct loop* loop, const struct operand* operands, npy_intp count) {
  const struct function* function = loop->function;
  if (!loop->is_double && function->of_float == NULL) return false;
  for (int k = 0; k < function->inputs + function->outputs; ++k) {
    const bool may_repeat = k < function->inputs && (function->shared >> k & 1);
    if (!is_contiguous(&operands[k], count, may_repeat)) return false;
  }
  for (int k = 0; k + 1 < function->inputs && count > 1; ++k) {
    const bool tied = function->tied >> k & 1;
    if (tied && (operands[k].row_step == 0) != (operands[k + 1].row_step == 0)) return false;
  }
  return true;
}

/* One call on the operands' own memory. */
static int where_they_are(struct call* call, const struct operand* operands, npy_intp count) {
  const struct function* function = call->function;
  for (int k = 0; k < function->inputs; ++k) {
    call->in[k] = operands[k].rows;
    call->counts[k] = operands[k].row_step == 0 && (function->shared >> k & 1) ? 1 : (size_t)count;
  }
  for (int k = 0; k < function->outputs; ++k) call->out[k] = operands[function->inputs + k].rows;
  return all_rows(call, (size_t)count);
}

/* Blocks of rows, gathered and scattered. */
static int in_blocks(struct call* call, const struct operand* operands, npy_intp count) {
  const struct function* function = call->function;
  const int all = function->inputs + function->outputs;
  double numbers[kBlock * kNumbers];
  int seen = 0;
  for (npy_intp first = 0; first < count; first += kBlock) {
    const npy_intp rows = count - first < kBlock ? count - first : kBlock;
    double* block = numbers;
    for (int k = 0; k < all; ++k) {
      if (k < function->inputs) {
        gather(&operands[k], first, rows, block, call->size[k] == sizeof(double));
        call->in[k] = block;
        call->counts[k] = (size_t)rows;
      } else {
        call->out[k - function->inputs] = block;
      }
      block += kBlock * function->width[k];
    }
    seen |= all_rows(call, (size_t)rows);
    for (int k = function->inputs; k < all; ++k) {
      scatter(&operands[k], first, rows, call->out[k - function->inputs], call->size[k] == sizeof(double));
    }
  }
  return seen;
}

static void by_rows(char** args, const npy_intp* dimensions, const npy_intp* steps, void* data) {
  const struct loop* loop = data;
  const struct function* function = loop->function;
  const bool wide = loop->is_double || function->of_float == NULL;
  struct call call = {.function = function, .rows = wide ? function->of_double : function->of_float};
  struct operand operands[kOperands];
  if (dimensions[0] == 0) return;
  find_operands(loop, args, steps, operands);
  for (int k = 0; k < function->inputs + function->outputs; ++k) {
    call.size[k] = wide || operands[k].is_double ? sizeof(double) : sizeof(float);
  }
  tell(is_direct(loop, operands, dimensions[0]) ? where_they_are(&call, operands, dimensions[0])
                                                : in_blocks(&call, operands, dimensions[0]));
}

/* ---- The module ---- */

/* Says that a number is invalid: for those who find rows at fault outside the loops above. */
static void raise_invalid(char** args, const npy_intp* dimensions, const npy_intp* steps, void* data) {
  (void)data;
  for (npy_intp i = 0; i < dimensions[0]; ++i) *(double*)(args[1] + i * steps[1]) = NAN;
  feraiseexcept(FE_INVALID);
}

static PyObject* take_ambiguous(PyObject* module, PyObject* none) {
  (void)module, (void)none;
  const bool was = ambiguous;
  ambiguous = false;
  return PyBool_FromLong(was);
}

static PyMethodDef methods[] = {{"take_ambiguous", take_ambiguous, METH_NOARGS,
                                 "Whether a row was ambiguous in a call of this thread since the last question."},
                                {NULL, NULL, 0, NULL}};

static int add(PyObject* module, const char* name, PyObject* ufunc) {
  if (ufunc == NULL) return -1;
  const int failed = PyModule_AddObjectRef(module, name, ufunc);
  Py_DECREF(ufunc);
  return failed;
}

static int add_ufuncs(PyObject* module) {
  /* ufuncs keep pointers to all of this */
  static struct loop loops[kFunctions][2];
  static void* data[kFunctions][2];
  static char types[kFunctions][2 * kOperands];
  static PyUFuncGenericFunction by_row[] = {by_rows, by_rows};
  static PyUFuncGenericFunction invalid[] = {raise_invalid};
  static char of_invalid[] = {NPY_DOUBLE, NPY_DOUBLE};
  static void* nothing[] = {NULL};

  for (int i = 0; i < kFunctions; ++i) {
    const struct function* function = &functions[i];
    const int operands = function->inputs + function->outputs;
    for (int is_double = 0; is_double < 2; ++is_double) {
      loops[i][is_double] = (struct loop){function, is_double};
      data[i][is_double] = &loops[i][is_double];
      for (int k = 0; k < operands; ++k) {
        types[i][is_double * operands + k] = is_double || (function->times >> k & 1) ? NPY_DOUBLE : NPY_FLOAT;
      }
    }
    PyObject* ufunc =
        PyUFunc_FromFuncAndDataAndSignature(by_row, data[i], types[i], 2, function->inputs, function->outputs,
                                            PyUFunc_None, function->name, function->signature, 0, function->signature);
    if (add(module, function->name, ufunc) < 0) return -1;
  }
  return add(module, "sample",
             PyUFunc_FromFuncAndData(invalid, nothing, of_invalid, 1, 1, 1, PyUFunc_None, "sample",
                                     "NaN, and invalid under np.errstate.", 0));
}

static int execute(PyObject* module) {
  if (PyArray_ImportNumPyAPI() < 0 || PyUFunc_ImportUFuncAPI() < 0) return -1;
  return add_ufuncs(module);
}

static PyModuleDef_Slot slots[] = {{Py_mod_exec, execute},
#ifdef Py_mod_gil
                                   {Py_mod_gil, Py_MOD_GIL_NOT_USED},
#endif
                                   {0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, .m_name = "qtraj._ufuncs", .m_doc = "Generalised ufuncs over rows.",
    .m_size = 0,           .m_methods = methods,      .m_slots = slots};

PyMODINIT_FUNC PyInit__ufuncs(void) { return PyModuleDef_Init(&definition); }

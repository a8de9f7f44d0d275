/* qtraj: smooth orientation trajectories through quaternion keyframes.
 *
 * _f32 twins exist for what moves keyframes and samples in bulk: construction, sampling, slerp and nlerp, keys, rotate,
 * means. They read and write float; times, settings and scalar results stay double; sums are taken in double.
 *
 * Conventions
 *   Hamilton product, right-handed, q = w x y z; q_wb takes body vectors to world; q and -q are one orientation.
 *   Radians, seconds. Arrays are contiguous: [count][4] q, [count][3] vectors, [count][9] row-major matrices.
 * Results
 *   The status is the contract. Argument errors (NULL, COUNT, SIZE, OPTION, BUFFER, OVERLAP) leave all data outputs
 *   untouched. Array functions process every row: a row at fault becomes NaN, the others are right, the status is
 *   that of the first row at fault. Under AMBIGUOUS the row holds one valid answer, chosen by the documented rule.
 *   bad_index may be NULL. It is written by every call: index of the first element at fault, else SIZE_MAX.
 *   Constructors write NULL to *out on every error.
 * Counts
 *   count 0 is OK with NULL arrays, except where a minimum is stated (keys 2, means 1, differences 2): then COUNT.
 *   An input with a count of its own has `count` rows, or 1 row that serves all.
 * Memory
 *   The caller owns every array. Inputs are copied or only read during the call; nothing is borrowed. An output may be
 *   the same array as an input of the same type and row length; any other overlap is OVERLAP.
 * Threads
 *   No global state. A trajectory is immutable: any number of threads may sample it. Options belong to one thread at a
 *   time. Rounding mode, FP traps, errno and locale are never changed; only FE_INEXACT and FE_UNDERFLOW can be raised.
 * Enumerators are passed as int32_t. Values never change meaning; new ones are appended. */
#ifndef QTRAJ_H
#define QTRAJ_H

#include <stddef.h>
#include <stdint.h>

#define QTRAJ_VERSION_MAJOR 0
#define QTRAJ_VERSION_MINOR 1
#define QTRAJ_VERSION_PATCH 0
#define QTRAJ_VERSION_STRING "0.1.0"
#define QTRAJ_VERSION_NUMBER (QTRAJ_VERSION_MAJOR * 1000000 + QTRAJ_VERSION_MINOR * 1000 + QTRAJ_VERSION_PATCH)

#if defined(_WIN32) && defined(QTRAJ_BUILDING_SHARED)
#define QTRAJ_API __declspec(dllexport)
#elif defined(_WIN32) && !defined(QTRAJ_STATIC)
#define QTRAJ_API __declspec(dllimport)
#elif defined(__GNUC__)
#define QTRAJ_API __attribute__((visibility("default")))
#else
#define QTRAJ_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Constants ---- */

typedef enum qtraj_status {
  QTRAJ_OK = 0,
  QTRAJ_E_NULL = 1,             /* a required pointer is NULL */
  QTRAJ_E_COUNT = 2,            /* too few elements, or counts that do not belong together */
  QTRAJ_E_SIZE = 3,             /* an array would be larger than PTRDIFF_MAX bytes */
  QTRAJ_E_OPTION = 4,           /* unknown constant, option the method does not have, or rates it needs are missing */
  QTRAJ_E_BUFFER = 5,           /* caller's memory too small or not aligned to 8 bytes */
  QTRAJ_E_OVERLAP = 6,          /* output overlaps another array where that is not allowed */
  QTRAJ_E_NO_MEMORY = 7,        /* allocation failed */
  QTRAJ_E_NOT_FINITE = 8,       /* NaN or infinity in the input, or a result that overflows */
  QTRAJ_E_ZERO_NORM = 9,        /* quaternion of norm 0; weights that are all 0 */
  QTRAJ_E_TIME_ORDER = 10,      /* times not strictly increasing, or a step too small to divide by */
  QTRAJ_E_TIME_RANGE = 11,      /* time outside the knots under EXTRAPOLATE_ERROR; span of the knots overflows */
  QTRAJ_E_NEGATIVE_WEIGHT = 12, /* weight below 0 */
  QTRAJ_E_NOT_CLOSED = 13,     /* PERIODIC, but first and last key differ by more than 1e-6 rad (or wind, LOG_SPLINE) */
  QTRAJ_E_NOT_ROTATION = 14,   /* matrix more than 1e-3 away from a rotation, or with a negative determinant */
  QTRAJ_E_AMBIGUOUS = 15,      /* more than one answer is equally right */
  QTRAJ_E_NO_CONVERGENCE = 16, /* iteration limit reached */
  QTRAJ_E_INTERNAL = 17,       /* a defect of the library: please report */
  QTRAJ_STATUS_INT32 = -0x7fffffff - 1 /* never returned: keeps the type a signed 32-bit integer */
} qtraj_status;

/* 0 is no method, no frame: a forgotten argument is QTRAJ_E_OPTION. */
enum qtraj_method_value {
  QTRAJ_SLERP = 1,             /* C0, constant rate in each segment */
  QTRAJ_NLERP = 2,             /* C0, normalised linear */
  QTRAJ_SQUAD = 3,             /* C1 */
  QTRAJ_LOG_SPLINE = 4,        /* C2, cubic in one chart */
  QTRAJ_ROTATION_SPLINE = 5,   /* C2, no chart */
  QTRAJ_HERMITE = 6,           /* C1, rates at the keys given */
  QTRAJ_ROTATION_QUINTIC = 7,  /* C2, rates and accelerations at the keys given */
  QTRAJ_QUATERNION_QUINTIC = 8 /* C2, the same in R^4, normalised */
};
enum qtraj_frame_value { QTRAJ_FRAME_BODY = 1, QTRAJ_FRAME_WORLD = 2 };
enum qtraj_end_value {
  QTRAJ_END_DEFAULT = 0,    /* SQUAD: CHORD; LOG_SPLINE, cubic_spline: NATURAL; ROTATION_SPLINE: ESTIMATED */
  QTRAJ_END_CHORD = 1,      /* rate of the end segment's slerp: SQUAD, ROTATION_SPLINE */
  QTRAJ_END_NATURAL = 2,    /* second derivative (ROTATION_SPLINE: alpha) 0: LOG_SPLINE, ROTATION_SPLINE */
  QTRAJ_END_NOT_A_KNOT = 3, /* LOG_SPLINE */
  QTRAJ_END_ESTIMATED = 4,  /* Lagrange derivative through the end keys: SQUAD, ROTATION_SPLINE */
  QTRAJ_END_GIVEN = 5,      /* qtraj_options_set_end_rates */
  QTRAJ_END_PERIODIC = 6    /* both ends or none */
};
enum qtraj_tangent_value {
  QTRAJ_TANGENT_DEFAULT = 0, /* CATMULL_ROM */
  QTRAJ_TANGENT_CATMULL_ROM = 1,
  QTRAJ_TANGENT_MEAN_VELOCITY = 2,
  QTRAJ_TANGENT_GIVEN = 3 /* omega of qtraj_create_with_rates */
};
enum qtraj_reference_value {
  QTRAJ_REFERENCE_DEFAULT = 0, /* FIRST */
  QTRAJ_REFERENCE_FIRST = 1,
  QTRAJ_REFERENCE_MEAN = 2, /* unweighted eigen mean of the keys */
  QTRAJ_REFERENCE_GIVEN = 3
};
enum qtraj_extrapolate_value {
  QTRAJ_EXTRAPOLATE_ERROR = 0,         /* NaN row, QTRAJ_E_TIME_RANGE */
  QTRAJ_EXTRAPOLATE_HOLD = 1,          /* end key, zero rates */
  QTRAJ_EXTRAPOLATE_CONSTANT_RATE = 2, /* geodesic with the end rate, zero acceleration */
  QTRAJ_EXTRAPOLATE_PERIODIC = 3       /* time wrapped; both sides or none */
};
enum qtraj_path_value { QTRAJ_PATH_SHORTEST = 1, QTRAJ_PATH_AS_GIVEN = 2 };

/* Room for an options object in the caller's memory; holds for every library of the same SONAME. */
#define QTRAJ_OPTIONS_BYTES 512

typedef struct qtraj_trajectory qtraj_trajectory; /* immutable once built */
typedef struct qtraj_options qtraj_options;       /* method and its settings, reusable */

/* ---- Library ---- */

/* Version that was linked, "0.1.0"; borrowed: static text. */
QTRAJ_API const char* qtraj_version(void);
/* The same as QTRAJ_VERSION_NUMBER. */
QTRAJ_API int32_t qtraj_version_number(void);
/* One-line text of a status, "unknown status" for others, never NULL; borrowed: static text. */
QTRAJ_API const char* qtraj_status_text(int32_t status);
/* Kernel that runs here and its arithmetic, "avx2 fused", "scalar plain": which golden hash applies; static text. */
QTRAJ_API const char* qtraj_target(void);

/* ---- Options: heap or caller's memory; every setter checks at once and fails without effect ---- */

/* New options of a method with its defaults; owned: qtraj_options_destroy. */
QTRAJ_API qtraj_status qtraj_options_create(int32_t method, qtraj_options** out);
/* The same in caller's memory of at least QTRAJ_OPTIONS_BYTES, 8-byte aligned, which outlives it; nothing allocated. */
QTRAJ_API qtraj_status qtraj_options_init(void* memory, size_t bytes, int32_t method, qtraj_options** out);
/* Frees what options_create made; no-op for NULL and for options_init. */
QTRAJ_API void qtraj_options_destroy(qtraj_options* options);
/* End condition at the first and at the last key. */
QTRAJ_API qtraj_status qtraj_options_set_ends(qtraj_options* options, int32_t start, int32_t end);
/* Rates for END_GIVEN, rad/s, copied; NULL for an end that is not GIVEN. */
QTRAJ_API qtraj_status qtraj_options_set_end_rates(qtraj_options* options, int32_t frame, const double* omega_start,
                                                   const double* omega_end);
/* SQUAD: tangent rule. */
QTRAJ_API qtraj_status qtraj_options_set_tangents(qtraj_options* options, int32_t rule);
/* LOG_SPLINE: base orientation; q_wb [4] with REFERENCE_GIVEN, else NULL; its sign is made <q, first key> >= 0. */
QTRAJ_API qtraj_status qtraj_options_set_reference(qtraj_options* options, int32_t rule, const double* q_wb);
/* What a time before the first and after the last knot means. */
QTRAJ_API qtraj_status qtraj_options_set_extrapolation(qtraj_options* options, int32_t before, int32_t after);

/* ---- Construction: inputs are copied, normalised, made sign-continuous ---- */

/* Trajectory with the method's defaults through count >= 2 keys; owned: qtraj_destroy. */
QTRAJ_API qtraj_status qtraj_create(int32_t method, const double* times, const double* q_wb, size_t count,
                                    qtraj_trajectory** out, size_t* bad_index);
QTRAJ_API qtraj_status qtraj_create_f32(int32_t method, const double* times, const float* q_wb, size_t count,
                                        qtraj_trajectory** out, size_t* bad_index);
/* The same with options. */
QTRAJ_API qtraj_status qtraj_create_with_options(const qtraj_options* options, const double* times, const double* q_wb,
                                                 size_t count, qtraj_trajectory** out, size_t* bad_index);
QTRAJ_API qtraj_status qtraj_create_with_options_f32(const qtraj_options* options, const double* times,
                                                     const float* q_wb, size_t count, qtraj_trajectory** out,
                                                     size_t* bad_index);
/* The same with rates at the keys: omega [count][3] rad/s; alpha [count][3] rad/s^2, for the quintics, else NULL. */
QTRAJ_API qtraj_status qtraj_create_with_rates(const qtraj_options* options, int32_t frame, const double* times,
                                               const double* q_wb, const double* omega, const double* alpha,
                                               size_t count, qtraj_trajectory** out, size_t* bad_index);
QTRAJ_API qtraj_status qtraj_create_with_rates_f32(const qtraj_options* options, int32_t frame, const double* times,
                                                   const float* q_wb, const float* omega, const float* alpha,
                                                   size_t count, qtraj_trajectory** out, size_t* bad_index);
/* Bytes that qtraj_init needs for count keys, working space included. */
QTRAJ_API qtraj_status qtraj_init_size(const qtraj_options* options, size_t count, size_t* bytes);
/* create_with_rates in caller's memory, 8-byte aligned, which outlives the handle and stays in place; omega and alpha
 * may be NULL (frame is then ignored). */
QTRAJ_API qtraj_status qtraj_init(void* memory, size_t bytes, const qtraj_options* options, int32_t frame,
                                  const double* times, const double* q_wb, const double* omega, const double* alpha,
                                  size_t count, qtraj_trajectory** out, size_t* bad_index);
QTRAJ_API qtraj_status qtraj_init_f32(void* memory, size_t bytes, const qtraj_options* options, int32_t frame,
                                      const double* times, const float* q_wb, const float* omega, const float* alpha,
                                      size_t count, qtraj_trajectory** out, size_t* bad_index);
/* Frees what create made; no-op for NULL and for init. */
QTRAJ_API void qtraj_destroy(qtraj_trajectory* trajectory);

/* ---- Sampling: any order of times; the same time gives the same bits from every function ---- */

/* Orientations q_out [count][4] at times [count]. */
QTRAJ_API qtraj_status qtraj_sample(const qtraj_trajectory* trajectory, const double* times, size_t count,
                                    double* q_out, size_t* bad_index);
QTRAJ_API qtraj_status qtraj_sample_f32(const qtraj_trajectory* trajectory, const double* times, size_t count,
                                        float* q_out, size_t* bad_index);
/* With omega_out, alpha_out [count][3], rad/s and rad/s^2 in frame; each output may be NULL, not all; right-hand values
 * at knots. */
QTRAJ_API qtraj_status qtraj_sample_rates(const qtraj_trajectory* trajectory, int32_t frame, const double* times,
                                          size_t count, double* q_out, double* omega_out, double* alpha_out,
                                          size_t* bad_index);
QTRAJ_API qtraj_status qtraj_sample_rates_f32(const qtraj_trajectory* trajectory, int32_t frame, const double* times,
                                              size_t count, float* q_out, float* omega_out, float* alpha_out,
                                              size_t* bad_index);
/* At start + (double)i * step, rounded twice, for i < count. */
QTRAJ_API qtraj_status qtraj_sample_uniform(const qtraj_trajectory* trajectory, double start, double step, size_t count,
                                            double* q_out, size_t* bad_index);
QTRAJ_API qtraj_status qtraj_sample_uniform_f32(const qtraj_trajectory* trajectory, double start, double step,
                                                size_t count, float* q_out, size_t* bad_index);
/* times_out [count] evenly from first to last, both exact and never past last (start + i * step may be): feed it to any
 * sampler. TIME_ORDER where last < first. */
QTRAJ_API qtraj_status qtraj_even_times(double first, double last, size_t count, double* times_out);
/* One time, for control loops. cursor: any value, 0 to begin; a hint kept by the caller, never changes the result; may
 * be NULL. */
QTRAJ_API qtraj_status qtraj_sample_at(const qtraj_trajectory* trajectory, double time, size_t* cursor, double* q_out);
QTRAJ_API qtraj_status qtraj_sample_at_f32(const qtraj_trajectory* trajectory, double time, size_t* cursor,
                                           float* q_out);

/* The same with rates; each output may be NULL, not all. */
QTRAJ_API qtraj_status qtraj_sample_rates_at(const qtraj_trajectory* trajectory, int32_t frame, double time,
                                             size_t* cursor, double* q_out, double* omega_out, double* alpha_out);
QTRAJ_API qtraj_status qtraj_sample_rates_at_f32(const qtraj_trajectory* trajectory, int32_t frame, double time,
                                                 size_t* cursor, float* q_out, float* omega_out, float* alpha_out);

/* ---- What a trajectory knows: plain values; 0 or NaN for a NULL handle ---- */

/* Method it was built with. */
QTRAJ_API int32_t qtraj_method(const qtraj_trajectory* trajectory);
/* Number of keys. */
QTRAJ_API size_t qtraj_key_count(const qtraj_trajectory* trajectory);
/* First knot, s. */
QTRAJ_API double qtraj_start_time(const qtraj_trajectory* trajectory);
/* Last knot, s. */
QTRAJ_API double qtraj_end_time(const qtraj_trajectory* trajectory);
/* Number of keys whose sign was changed. */
QTRAJ_API size_t qtraj_sign_flips(const qtraj_trajectory* trajectory);
/* Largest | |q| - 1 | of the keys as given. */
QTRAJ_API double qtraj_worst_norm_error(const qtraj_trajectory* trajectory);
/* Smallest dot product of neighbouring keys, >= 0; near 0 a step is close to a half turn and its direction a matter of
 * rounding. */
QTRAJ_API double qtraj_least_dot(const qtraj_trajectory* trajectory);
/* Iterations the constructor took, 0 for direct methods. */
QTRAJ_API int32_t qtraj_iterations(const qtraj_trajectory* trajectory);
/* ROTATION_SPLINE: largest alpha jump left at a knot relative to the largest alpha; 0 for direct methods. */
QTRAJ_API double qtraj_residual(const qtraj_trajectory* trajectory);
/* Keys as used: times_out [key_count], q_out [key_count][4], normalised and sign-continuous; each may be NULL. */
QTRAJ_API qtraj_status qtraj_keys(const qtraj_trajectory* trajectory, double* times_out, double* q_out);
/* NLERP, QUATERNION_QUINTIC: smallest norm before normalisation and its time (nullable); 1 for the others. Computed by
 * the call. */
QTRAJ_API qtraj_status qtraj_curve_least_norm(const qtraj_trajectory* trajectory, double* norm, double* time);

/* ---- Curve diagnostics: double only, computed by the call ---- */

/* Right-hand minus left-hand omega and alpha at each knot, [key_count][3], each nullable; ends 0, or the wrap's jump
 * where PERIODIC. */
QTRAJ_API qtraj_status qtraj_curve_jumps(const qtraj_trajectory* trajectory, int32_t frame, double* omega_jump,
                                         double* alpha_jump);
/* Largest |omega| and |alpha| and their times; each nullable. */
QTRAJ_API qtraj_status qtraj_curve_peak_rates(const qtraj_trajectory* trajectory, double* omega_peak,
                                              double* omega_time, double* alpha_peak, double* alpha_time);
/* Integral of |alpha|^2 over the segments, rad^2/s^3; impulses at rate jumps are not counted. */
QTRAJ_API qtraj_status qtraj_curve_energy(const qtraj_trajectory* trajectory, double* energy);
/* Integral of |omega|, rad. */
QTRAJ_API qtraj_status qtraj_curve_total_angle(const qtraj_trajectory* trajectory, double* angle);

/* ---- Pairs: inputs of any norm but 0; any real fraction ---- */

/* q_out [count][4] on the arc from a [4], fraction 0, to b [4], fraction 1. SHORTEST: to b or -b, whichever is nearer
 * (half a turn apart, to 4 eps: b). AS_GIVEN with b = -a to 1e-14 rad, also in float: AMBIGUOUS, a turn of the body
 * about its x axis. A fault of a or b is one of every row. */
QTRAJ_API qtraj_status qtraj_slerp(const double* a, const double* b, const double* fraction, size_t count, int32_t path,
                                   double* q_out, size_t* bad_index);
QTRAJ_API qtraj_status qtraj_slerp_f32(const float* a, const float* b, const float* fraction, size_t count,
                                       int32_t path, float* q_out, size_t* bad_index);
/* Pair by pair: a, b [count][4], fraction [fraction_count], 1 or count. */
QTRAJ_API qtraj_status qtraj_slerp_pairs(const double* a, const double* b, const double* fraction,
                                         size_t fraction_count, size_t count, int32_t path, double* q_out,
                                         size_t* bad_index);
QTRAJ_API qtraj_status qtraj_slerp_pairs_f32(const float* a, const float* b, const float* fraction,
                                             size_t fraction_count, size_t count, int32_t path, float* q_out,
                                             size_t* bad_index);
/* Normalised linear interpolation of one pair; ZERO_NORM where the chord passes through 0, |p| < 1e-14. */
QTRAJ_API qtraj_status qtraj_nlerp(const double* a, const double* b, const double* fraction, size_t count, int32_t path,
                                   double* q_out, size_t* bad_index);
QTRAJ_API qtraj_status qtraj_nlerp_f32(const float* a, const float* b, const float* fraction, size_t count,
                                       int32_t path, float* q_out, size_t* bad_index);
/* Pair by pair. */
QTRAJ_API qtraj_status qtraj_nlerp_pairs(const double* a, const double* b, const double* fraction,
                                         size_t fraction_count, size_t count, int32_t path, double* q_out,
                                         size_t* bad_index);
QTRAJ_API qtraj_status qtraj_nlerp_pairs_f32(const float* a, const float* b, const float* fraction,
                                             size_t fraction_count, size_t count, int32_t path, float* q_out,
                                             size_t* bad_index);
/* Slerp from a at time_a to b at time_b, sampled at times [count], outside too. */
QTRAJ_API qtraj_status qtraj_slerp_between(const double* a, double time_a, const double* b, double time_b,
                                           const double* times, size_t count, int32_t path, double* q_out,
                                           size_t* bad_index);
/* Controls a_i, b_i of keys [count][4], CATMULL_ROM, CHORD ends; signs as given (qtraj_make_continuous first); times
 * NULL: uniform; a of the last and b of the first key are that key. */
QTRAJ_API qtraj_status qtraj_squad_controls(const double* times, const double* q_wb, size_t count, double* a_out,
                                            double* b_out, size_t* bad_index);
/* One segment q0 -> q1 with controls a (of q0) and b (of q1), each [4], arcs as given, at fraction [count]. */
QTRAJ_API qtraj_status qtraj_squad_segment(const double* q0, const double* q1, const double* a, const double* b,
                                           const double* fraction, size_t count, double* q_out, size_t* bad_index);

/* ---- Keys: in place allowed ---- */

/* Unit quaternions, signs kept. */
QTRAJ_API qtraj_status qtraj_normalize(const double* q, size_t count, double* q_out, size_t* bad_index);
QTRAJ_API qtraj_status qtraj_normalize_f32(const float* q, size_t count, float* q_out, size_t* bad_index);
/* Signs such that <q_{i-1}, q_i> >= 0 along each series of [series][length][4], norms kept; flips (nullable): how many
 * were changed. */
QTRAJ_API qtraj_status qtraj_make_continuous(const double* q, size_t series, size_t length, double* q_out,
                                             size_t* flips, size_t* bad_index);
QTRAJ_API qtraj_status qtraj_make_continuous_f32(const float* q, size_t series, size_t length, float* q_out,
                                                 size_t* flips, size_t* bad_index);
/* Component order x y z w -> w x y z; values are only moved. */
QTRAJ_API qtraj_status qtraj_wxyz_from_xyzw(const double* q_xyzw, size_t count, double* q_out);
QTRAJ_API qtraj_status qtraj_wxyz_from_xyzw_f32(const float* q_xyzw, size_t count, float* q_out);
/* Component order w x y z -> x y z w; values are only moved. */
QTRAJ_API qtraj_status qtraj_xyzw_from_wxyz(const double* q, size_t count, double* q_xyzw_out);
QTRAJ_API qtraj_status qtraj_xyzw_from_wxyz_f32(const float* q, size_t count, float* q_xyzw_out);

/* ---- Algebra: in place where row lengths agree ---- */

/* Hamilton product a b of quaternions as they are (not normalised); a_count, b_count: 1 or count. */
QTRAJ_API qtraj_status qtraj_multiply(const double* a, size_t a_count, const double* b, size_t b_count, size_t count,
                                      double* q_out, size_t* bad_index);
/* (w, -x, -y, -z). */
QTRAJ_API qtraj_status qtraj_conjugate(const double* q, size_t count, double* q_out, size_t* bad_index);
/* conjugate / norm^2. */
QTRAJ_API qtraj_status qtraj_inverse(const double* q, size_t count, double* q_out, size_t* bad_index);
/* Euclidean norm, norm_out [count]. */
QTRAJ_API qtraj_status qtraj_norm(const double* q, size_t count, double* norm_out, size_t* bad_index);
/* Dot product in R^4, dot_out [count]. */
QTRAJ_API qtraj_status qtraj_dot(const double* a, const double* b, size_t count, double* dot_out, size_t* bad_index);
/* Unit quaternion of a half-angle vector v [count][3]: (cos |v|, v sin |v| / |v|). */
QTRAJ_API qtraj_status qtraj_exp(const double* v, size_t count, double* q_out, size_t* bad_index);
/* Half-angle vector [count][3] of q / |q|, |v| in [0, pi]; at q = -1 the x axis, AMBIGUOUS. */
QTRAJ_API qtraj_status qtraj_log(const double* q, size_t count, double* v_out, size_t* bad_index);
/* exp(exponent * log(q)), q normalised; exponent_count: 1 or count. */
QTRAJ_API qtraj_status qtraj_pow(const double* q, const double* exponent, size_t exponent_count, size_t count,
                                 double* q_out, size_t* bad_index);
/* World vectors q v q^-1 of body vectors v_body [v_count][3], q_wb [q_count][4]; each count 1 or count. */
QTRAJ_API qtraj_status qtraj_rotate(const double* q_wb, size_t q_count, const double* v_body, size_t v_count,
                                    size_t count, double* v_world_out, size_t* bad_index);
QTRAJ_API qtraj_status qtraj_rotate_f32(const float* q_wb, size_t q_count, const float* v_body, size_t v_count,
                                        size_t count, float* v_world_out, size_t* bad_index);
/* Angle on S^3 between a and b, [0, pi]: signs count. */
QTRAJ_API qtraj_status qtraj_distance(const double* a, size_t a_count, const double* b, size_t b_count, size_t count,
                                      double* angle_out, size_t* bad_index);
/* Angle of the rotation that takes a to b, [0, pi]: signs do not count. */
QTRAJ_API qtraj_status qtraj_rotation_angle(const double* a, size_t a_count, const double* b, size_t b_count,
                                            size_t count, double* angle_out, size_t* bad_index);
/* Rotation vector [count][3], rad, |r| in [0, pi]; at pi the axis follows the sign of the vector part. */
QTRAJ_API qtraj_status qtraj_rotation_vector_from_q(const double* q, size_t count, double* r_out, size_t* bad_index);
/* Unit quaternion of a rotation vector, any length. */
QTRAJ_API qtraj_status qtraj_q_from_rotation_vector(const double* r, size_t count, double* q_out, size_t* bad_index);
/* Rotation matrix, row-major [count][9], v_world = M v_body. */
QTRAJ_API qtraj_status qtraj_matrix_from_q(const double* q_wb, size_t count, double* matrix_out, size_t* bad_index);
/* Unit quaternion, w >= 0, of the matrix. */
QTRAJ_API qtraj_status qtraj_q_from_matrix(const double* matrix, size_t count, double* q_out, size_t* bad_index);
/* q', q'' [count][4] of q / |q| from omega, alpha [count][3] in frame; alpha and ddq_out NULL together. */
QTRAJ_API qtraj_status qtraj_derivatives_from_rates(int32_t frame, const double* q_wb, const double* omega,
                                                    const double* alpha, size_t count, double* dq_out, double* ddq_out,
                                                    size_t* bad_index);
/* omega, alpha of the curve q / |q| from q and its own derivatives q', q'': what changes its norm is ignored; ddq and
 * alpha_out NULL together. */
QTRAJ_API qtraj_status qtraj_rates_from_derivatives(int32_t frame, const double* q_wb, const double* dq,
                                                    const double* ddq, size_t count, double* omega_out,
                                                    double* alpha_out, size_t* bad_index);

/* ---- Means: count >= 1, weights [count] >= 0 or NULL, summed in double; mean_out [4] ---- */

/* Top eigenvector of sum w q q^T, sign of the first sample of weight above 0; eigengap (nullable): (l1 - l2) / trace; a
 * tie is AMBIGUOUS. */
QTRAJ_API qtraj_status qtraj_mean_eigen(const double* q, const double* weights, size_t count, double* mean_out,
                                        double* eigengap, size_t* bad_index);
QTRAJ_API qtraj_status qtraj_mean_eigen_f32(const float* q, const float* weights, size_t count, float* mean_out,
                                            double* eigengap, size_t* bad_index);
/* Global minimum of sum w angle^2; AMBIGUOUS (best mean written) where not proven unique. tolerance: rad on S^3, floor
 * 4 eps, 0 the floor; iterations, residual (nullable): how many, last step. NO_CONVERGENCE leaves the last iterate. */
QTRAJ_API qtraj_status qtraj_mean_karcher(const double* q, const double* weights, size_t count, double tolerance,
                                          int32_t max_iterations, double* mean_out, int32_t* iterations,
                                          double* residual, size_t* bad_index);
QTRAJ_API qtraj_status qtraj_mean_karcher_f32(const float* q, const float* weights, size_t count, double tolerance,
                                              int32_t max_iterations, float* mean_out, int32_t* iterations,
                                              double* residual, size_t* bad_index);

/* ---- Sample diagnostics: samples of any origin, neighbours sign-folded ---- */

/* Mean rates between neighbours: t_mid_out [count-1] (nullable), omega_out [count-1][3]; count >= 2. */
QTRAJ_API qtraj_status qtraj_estimate_omega(int32_t frame, const double* times, const double* q_wb, size_t count,
                                            double* t_mid_out, double* omega_out, size_t* bad_index);
/* Sum of |w_{k+1} - w_k|^2 / (m_{k+1} - m_k) over the estimated rates w at mid-times m, rad^2/s^3; count >= 3. */
QTRAJ_API qtraj_status qtraj_estimate_energy(int32_t frame, const double* times, const double* q_wb, size_t count,
                                             double* energy, size_t* bad_index);
/* At each knot: estimated rate of the first sample interval that begins at or after it minus that of the last one that
 * ends at or before it; where one is missing, NaN and TIME_RANGE. bad_index counts samples, then knots. */
QTRAJ_API qtraj_status qtraj_estimate_jumps(int32_t frame, const double* times, const double* q_wb, size_t count,
                                            const double* knots, size_t knot_count, double* jump_out,
                                            size_t* bad_index);
/* Rotation angle, rad, of each key to the sample nearest in time (a tie: the earlier), and its index (nullable); sample
 * times increase. bad_index counts keys, then samples. error_out may not be the array of sample times. */
QTRAJ_API qtraj_status qtraj_keyframe_errors(const double* key_times, const double* key_q, size_t key_count,
                                             const double* times, const double* q_wb, size_t count, double* error_out,
                                             size_t* index_out, size_t* bad_index);

/* ---- Spline: double only; allocates working space ---- */

/* C2 cubic through y [count][dim] at x [count]; ends DEFAULT, NATURAL, NOT_A_KNOT or PERIODIC; y_out [query_count][dim]
 * at queries, outside x NaN and TIME_RANGE; count >= 2. PERIODIC: first and last y equal to 1e-6 of the largest, else
 * NOT_CLOSED. bad_index counts points, then queries. */
QTRAJ_API qtraj_status qtraj_cubic_spline(const double* x, const double* y, size_t count, size_t dim, int32_t start,
                                          int32_t end, const double* queries, size_t query_count, double* y_out,
                                          size_t* bad_index);

#ifdef __cplusplus
}
#endif

#endif

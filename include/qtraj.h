/** @file qtraj.h
 * Smooth orientation trajectories through quaternion keyframes.
 *
 * Twins whose names end in _f32 exist for what moves keyframes and samples in bulk: construction, sampling, slerp,
 * nlerp and screw motions, keys, tables, rotate, means. They read and write float; times, settings and scalar results
 * stay double; sums are taken in double.
 *
 * @par Conventions
 *   Hamilton product, right-handed, q = w x y z; q_wb takes body vectors to world, v_world = q v_body q^-1; q and -q
 *   are one orientation. omega_world = 2 q' q^-1, omega_body = 2 q^-1 q'; alpha is the derivative of omega in the same
 *   frame. Radians, seconds. Arrays are contiguous: [count][4] q, [count][3] vectors, [count][9] row-major matrices.
 * @par Results
 *   The status is the contract. Mistakes of the call (NULL, HANDLE, TOO_FEW, COUNT, SIZE, VALUE, SETTING,
 *   INPUT_MISSING, INPUT_UNWANTED, BUFFER, OVERLAP) are judged first, in this order, and NO_MEMORY after them: data
 *   outputs are untouched, "nothing is written". Array functions process every row: a row at fault becomes NaN, the
 *   others are right, the status is that of the first row at fault. At one row NOT_FINITE comes first, then ZERO_NORM,
 *   then the others. Under AMBIGUOUS the row holds one valid answer, chosen by the documented rule. Compilers warn
 *   where a status is ignored, unless it is cast to void or QTRAJ_NODISCARD is defined as nothing.
 * @par bad_index
 *   Receives the index of the first element at fault, else SIZE_MAX; it may be NULL. Every call that has it writes it,
 *   under argument errors too.
 * @par Constructors
 *   They write NULL to *out on every error, AMBIGUOUS included, and leak nothing.
 * @par Counts
 *   count 0 is OK with NULL arrays, except where a function states a minimum, such as 2 keys or 1 sample of a mean:
 *   then TOO_FEW. An input with a count of its own has count rows, or 1 row that serves all.
 * @par Memory
 *   The caller owns every array. Inputs are copied or only read during the call; nothing is borrowed. Pointers must not
 *   be NULL where the comment of the function does not allow it. An output may be the same array as an input of the
 *   same type, row length and number of rows ("in place"); any other overlap is OVERLAP.
 * @par Threads
 *   No state that calls share, but the choice of a kernel, made once. A trajectory is immutable: any number of threads
 *   may sample it. Options belong to one thread at a time. Rounding mode, FP traps, errno and locale are never
 *   changed; only FE_INEXACT and FE_UNDERFLOW can be raised.
 * @par Constants
 *   Enumerators are passed as int32_t. Values never change meaning; new ones are appended. No two families of constants
 *   that are passed share a value, so that an argument in the place of another is QTRAJ_E_VALUE; 0 is the default where
 *   a family has one, and no value elsewhere.
 * @par Topics
 *   @ref qtraj-constants, @ref qtraj-library, @ref qtraj-options, @ref qtraj-construction, @ref qtraj-sampling,
 *   @ref qtraj-getters, @ref qtraj-curve-diagnostics, @ref qtraj-vector-curves, @ref qtraj-poses,
 *   @ref qtraj-batches, @ref qtraj-pairs, @ref qtraj-keys, @ref qtraj-algebra, @ref qtraj-means,
 *   @ref qtraj-sample-diagnostics, @ref qtraj-spline */
#ifndef QTRAJ_H
#define QTRAJ_H

#include <stddef.h>
#include <stdint.h>

/** Major version of this header. */
#define QTRAJ_VERSION_MAJOR 0
/** Minor version of this header. */
#define QTRAJ_VERSION_MINOR 1
/** Patch version of this header. */
#define QTRAJ_VERSION_PATCH 0
/** Version of this header as text; qtraj_version() tells that of the library. */
#define QTRAJ_VERSION_STRING "0.1.0"
/** Version of this header as a number that can be compared; qtraj_version_number() tells that of the library. */
#define QTRAJ_VERSION_NUMBER (QTRAJ_VERSION_MAJOR * 1000000 + QTRAJ_VERSION_MINOR * 1000 + QTRAJ_VERSION_PATCH)

/** @def QTRAJ_API
 * Marks the functions of the library. On Windows define QTRAJ_STATIC before the header where the static one is linked.
 */
#if defined(_WIN32) && defined(QTRAJ_BUILDING_SHARED)
#define QTRAJ_API __declspec(dllexport)
#elif defined(_WIN32) && !defined(QTRAJ_STATIC)
#define QTRAJ_API __declspec(dllimport)
#elif defined(__GNUC__)
#define QTRAJ_API __attribute__((visibility("default")))
#else
#define QTRAJ_API
#endif

/** @cond */
/* Makes compilers warn where a status is ignored; a cast to void says that it is on purpose. Empty where the compiler
 * has no such attribute for types; define it as nothing before the header to be without the warning. */
#ifndef QTRAJ_NODISCARD
#if (defined(__cplusplus) && __cplusplus >= 201703L) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 202000L)
#define QTRAJ_NODISCARD [[nodiscard]]
#elif defined(__clang__)
#define QTRAJ_NODISCARD __attribute__((__warn_unused_result__))
#elif defined(__GNUC__) && __GNUC__ >= 10 && (!defined(__cplusplus) || __cplusplus >= 201103L)
#define QTRAJ_NODISCARD [[nodiscard]]
#else
#define QTRAJ_NODISCARD
#endif
#endif
#if defined(__GNUC__)
#define QTRAJ_EXTENSION __extension__ /* keeps -pedantic silent about an attribute that the standard has not yet */
#else
#define QTRAJ_EXTENSION
#endif
/** @endcond */

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Constants ---- */

/** @defgroup qtraj-constants Constants and types
 * Statuses, methods and settings, and the two handles.
 * @{ */

/** How a call ended: what it means, and what to do. qtraj_status_text() gives one line of it, qtraj_status_class() what
 * kind of answer it is. From 1 on: the call was refused; from 21 on: data at fault; from 41 on: one answer of several.
 */
QTRAJ_EXTENSION typedef enum QTRAJ_NODISCARD qtraj_status {
  /** Done. */
  QTRAJ_OK = 0,
  /** A pointer that must be there is NULL: pass it, or a count of 0 where there is nothing to pass. */
  QTRAJ_E_NULL = 1,
  /** A handle that is none of its kind: another object, one that was destroyed, options of a trajectory's method for a
   * vector curve or the reverse, or memory that is not aligned to 8 bytes. Pass what the constructor gave. */
  QTRAJ_E_HANDLE = 2,
  /** Fewer elements than the function takes, such as 2 keys or 1 sample of a mean: look at count. */
  QTRAJ_E_TOO_FEW = 3,
  /** Counts that do not belong together: an input's own count is 1 or count; offsets of series that are negative or
   * decrease. */
  QTRAJ_E_COUNT = 4,
  /** An array would be larger than PTRDIFF_MAX bytes: look for a count that was negative, or never set. */
  QTRAJ_E_SIZE = 5,
  /** A constant that is not one of its family, or one of two ends PERIODIC; a tolerance, a limit, an angle or a number
   * of seconds that is none: compare the argument with the comment of the function. */
  QTRAJ_E_VALUE = 6,
  /** A setting that the method does not have, such as tangents of a SLERP: leave it out, or choose another method. */
  QTRAJ_E_SETTING = 7,
  /** Rates, turns or tangents that the method or a setting needs are missing: pass them to qtraj_create_with_rates(),
   * qtraj_create_with_turns(), qtraj_create_with_tangents() or qtraj_init(), those of GIVEN ends to
   * qtraj_options_set_end_rates(). */
  QTRAJ_E_INPUT_MISSING = 8,
  /** Rates, turns or tangents that neither the method nor a setting uses: pass NULL, or choose a method with them. */
  QTRAJ_E_INPUT_UNWANTED = 9,
  /** Memory of the caller too small, or not aligned to 8 bytes: QTRAJ_OPTIONS_BYTES and qtraj_init_size() tell how much
   * is needed. */
  QTRAJ_E_BUFFER = 10,
  /** An output overlaps another array where that is not allowed: give it an array of its own. */
  QTRAJ_E_OVERLAP = 11,
  /** Allocation failed: free some, or build in memory of your own with qtraj_options_init() and qtraj_init(),
   * or qtraj_vector_init(). */
  QTRAJ_E_NO_MEMORY = 12,
  /** NaN or infinity in the input, or a result that overflows: mend or leave out the element at bad_index. */
  QTRAJ_E_NOT_FINITE = 21,
  /** A quaternion of norm 0; weights that are all 0 (without an index); an nlerp through 0: leave the element out. */
  QTRAJ_E_ZERO_NORM = 22,
  /** Times that do not increase, or by less than about 7.5e-155 s, with the index of the later one: sort them and leave
   * repeated ones out. */
  QTRAJ_E_TIME_ORDER = 23,
  /** A time outside the knots under QTRAJ_EXTRAPOLATE_ERROR, a query outside a spline, a knot without samples on both
   * sides: stay inside, or choose an extrapolation. */
  QTRAJ_E_TIME_RANGE = 24,
  /** The span from the first time to this one overflows: look for a time that was never set, or in another unit. */
  QTRAJ_E_TIME_SPAN = 25,
  /** A time inside an interval that is longer than qtraj_options_set_longest_gap() allows: there are no data there. */
  QTRAJ_E_GAP = 26,
  /** A weight below 0: make it 0 or more. */
  QTRAJ_E_NEGATIVE_WEIGHT = 27,
  /** A curve that must close does not, last and first key differ by more than the closure angle (cubic_spline: y by
   * 1e-6 of the largest), or the keys of a LOG_SPLINE have wound round: append the first key, set a period or a larger
   * closure angle, or choose other ends. */
  QTRAJ_E_NOT_CLOSED = 28,
  /** A matrix farther from every rotation than the limit, or with a negative determinant: look for a scale or a
   * reflection in it. */
  QTRAJ_E_NOT_ROTATION = 29,
  /** A given rate is too fast for an interval beside its key: look for another unit, degrees or milliseconds. */
  QTRAJ_E_RATE_TOO_FAST = 30,
  /** ROTATION_SPLINE found no curve: use another method. A Karcher mean reached max_iterations: raise them. An integral
   * or a peak cannot be proven: too many turns, or rates that rounding leaves no digits of, see
   * qtraj_curve_least_norm(). */
  QTRAJ_E_NO_CONVERGENCE = 31,
  /** More than one answer is equally right: an axis, a way round, a mean. Arrays hold one of them, by the rule that the
   * function states; a constructor leaves no trajectory. */
  QTRAJ_E_AMBIGUOUS = 41,
  /** A defect of the library: please report it. */
  QTRAJ_E_INTERNAL = 51,
  /** Never returned: keeps the type a signed 32-bit integer. */
  QTRAJ_STATUS_INT32 = -0x7fffffff - 1
} qtraj_status;

/** What kind of answer a status is: qtraj_status_class(). */
enum qtraj_class_value {
  QTRAJ_CLASS_DONE = 901,           /**< all results are there and right */
  QTRAJ_CLASS_REFUSED = 902,        /**< a mistake of the call, or no memory: no data output is written */
  QTRAJ_CLASS_DATA = 903,           /**< data refused, or rows at fault: those are NaN, all others right */
  QTRAJ_CLASS_ONE_OF_SEVERAL = 904, /**< more than one answer is right; arrays hold one of them */
  QTRAJ_CLASS_DEFECT = 905          /**< a defect of the library, or a number that is no status of it */
};

/** Methods: how the curve goes from key to key. C0: its rate jumps at keys; C1: the rate is continuous; C2: so is the
 * acceleration. No two families of constants share a value: an argument in the wrong place is QTRAJ_E_VALUE, as is 0, a
 * forgotten one, but in the families that have a default. */
enum qtraj_method_value {
  /** C0: the shortest turn between two keys, at constant rate; dense recordings, keys that must not be overshot. */
  QTRAJ_SLERP = 1,
  /** C0: the same turn by normalised linear interpolation, at a slightly uneven rate. */
  QTRAJ_NLERP = 2,
  /** C1, on unevenly spaced keys too: two nested slerps; a key moves only what is near it. */
  QTRAJ_SQUAD = 3,
  /** C2: cubic spline in one chart, the rotation vector from a reference orientation; for motion about one attitude. */
  QTRAJ_LOG_SPLINE = 4,
  /** C2: cubic rotation vectors from key to key, no chart; what is differentiated; the first to try. */
  QTRAJ_ROTATION_SPLINE = 5,
  /** C1: cubic rotation vectors, the rates at the keys given. */
  QTRAJ_HERMITE = 6,
  /** C2: quintic rotation vectors, rates and accelerations at the keys given. */
  QTRAJ_ROTATION_QUINTIC = 7,
  /** C2: the same in R^4, normalised; for steps well below half a turn, see qtraj_curve_least_norm(). */
  QTRAJ_QUATERNION_QUINTIC = 8,
  /** Not continuous: each key is held until the next one; what files prescribe for what jumps. Rates are 0. */
  QTRAJ_STEP = 9,
  /** C0, and as smooth as its tangents: cubic in R^4 from in- and out-tangents at the keys, normalised; the CUBICSPLINE
   * of glTF. */
  QTRAJ_QUATERNION_HERMITE = 10
};
/** Methods of vector curves, such as positions: how each component goes from key to key. */
enum qtraj_vector_method_value {
  /** Not continuous: each key is held until the next one; derivatives are 0. */
  QTRAJ_VECTOR_STEP = 1001,
  /** C0: straight lines. */
  QTRAJ_VECTOR_LINEAR = 1002,
  /** C2: the cubic spline through the keys; ends NATURAL, NOT_A_KNOT, GIVEN, PERIODIC. */
  QTRAJ_VECTOR_CUBIC = 1003,
  /** C1: cubics, the first derivatives at the keys given, one for both sides of a key. */
  QTRAJ_VECTOR_HERMITE = 1004,
  /** C2: quintics, first and second derivatives at the keys given. */
  QTRAJ_VECTOR_QUINTIC = 1005
};
/** Frame that angular velocities and accelerations are given in. */
enum qtraj_frame_value {
  QTRAJ_FRAME_BODY = 101, /**< omega_body = 2 q^-1 q' */
  QTRAJ_FRAME_WORLD = 102 /**< omega_world = 2 q' q^-1, the body vector turned by q */
};
/** End conditions: what determines the curve at its first and at its last key, of the methods that are named.
 * qtraj_cubic_spline() has NATURAL, NOT_A_KNOT and PERIODIC. */
enum qtraj_end_value {
  QTRAJ_END_DEFAULT = 0,      /**< SQUAD: CHORD; LOG_SPLINE, VECTOR_CUBIC, cubic_spline: NATURAL; ROTATION_SPLINE:
                                 ESTIMATED */
  QTRAJ_END_CHORD = 201,      /**< rate of the end segment's slerp: SQUAD, ROTATION_SPLINE */
  QTRAJ_END_NATURAL = 202,    /**< second derivative (ROTATION_SPLINE: alpha) 0: LOG_SPLINE, ROTATION_SPLINE,
                                 VECTOR_CUBIC */
  QTRAJ_END_NOT_A_KNOT = 203, /**< the last two segments are one cubic: LOG_SPLINE, VECTOR_CUBIC */
  QTRAJ_END_ESTIMATED = 204,  /**< rate of a polynomial through the end keys: SQUAD (3 keys), ROTATION_SPLINE (4) */
  QTRAJ_END_GIVEN = 205,   /**< rate from qtraj_options_set_end_rates(): SQUAD, ROTATION_SPLINE; first derivative from
                              qtraj_vector_create(): VECTOR_CUBIC */
  QTRAJ_END_PERIODIC = 206 /**< goes on at the other end, both ends or none: SQUAD, LOG_SPLINE, ROTATION_SPLINE,
                              VECTOR_CUBIC */
};
/** SQUAD: the rate of the curve at a key. */
enum qtraj_tangent_value {
  QTRAJ_TANGENT_DEFAULT = 0,       /**< CATMULL_ROM */
  QTRAJ_TANGENT_CATMULL_ROM = 301, /**< mean of the slerp rates before and after, the shorter interval counting more */
  QTRAJ_TANGENT_MEAN_VELOCITY = 302, /**< plain mean of the two */
  QTRAJ_TANGENT_GIVEN = 303,         /**< omega of qtraj_create_with_rates() or qtraj_init() */
  QTRAJ_TANGENT_REST = 304           /**< no overshoot: 0 where the two slerp rates differ in sign or one is 0, else
                                          CATMULL_ROM, at most 3 times the smaller; each component of its own */
};
/** LOG_SPLINE: the orientation that rotation vectors start from. The curve is singular one full turn away from it. */
enum qtraj_reference_value {
  QTRAJ_REFERENCE_DEFAULT = 0, /**< FIRST */
  QTRAJ_REFERENCE_FIRST = 401, /**< the first key */
  QTRAJ_REFERENCE_MEAN = 402,  /**< unweighted eigen mean of the keys */
  QTRAJ_REFERENCE_GIVEN = 403  /**< q_wb of qtraj_options_set_reference() */
};
/** What a time before the first or after the last knot means. */
enum qtraj_extrapolate_value {
  QTRAJ_EXTRAPOLATE_DEFAULT = 0,         /**< ERROR */
  QTRAJ_EXTRAPOLATE_ERROR = 501,         /**< NaN row, QTRAJ_E_TIME_RANGE */
  QTRAJ_EXTRAPOLATE_HOLD = 502,          /**< end key, zero rates */
  QTRAJ_EXTRAPOLATE_CONSTANT_RATE = 503, /**< geodesic with the end rate, zero acceleration */
  QTRAJ_EXTRAPOLATE_PERIODIC = 504       /**< time wrapped into the knots; both sides or none; the keys must close */
};
/** How far a step from key to key turns: its branch, of the many rotations that lead from one key to the next. */
enum qtraj_turns_value {
  QTRAJ_TURNS_DEFAULT = 0,    /**< HERMITE, ROTATION_QUINTIC: FROM_RATES; QUATERNION_HERMITE: AS_GIVEN; else SHORTEST */
  QTRAJ_TURNS_SHORTEST = 701, /**< the shorter turn, at most half a turn */
  QTRAJ_TURNS_AS_GIVEN = 702, /**< the arc that the signs of the keys say, up to a whole turn */
  QTRAJ_TURNS_FROM_RATES = 703, /**< nearest to what the rates at both ends say: HERMITE, ROTATION_QUINTIC */
  QTRAJ_TURNS_GIVEN = 704       /**< whole turns beside the shorter one, a number a step: qtraj_create_with_turns() */
};
/** Order of the rows that qtraj_sample_many() writes. */
enum qtraj_layout_value {
  QTRAJ_LAYOUT_SERIES_FIRST = 801, /**< [series][count]: all times of the first trajectory, then those of the next */
  QTRAJ_LAYOUT_TIME_FIRST = 802    /**< [count][series]: all trajectories at the first time, then at the next */
};
/** Which of the two ways round from a to b an interpolation takes. */
enum qtraj_path_value {
  QTRAJ_PATH_SHORTEST = 601, /**< to b or -b, whichever is nearer; half a turn apart, to 4 eps, to b */
  QTRAJ_PATH_AS_GIVEN = 602  /**< to b, also where that is the longer way round */
};

/** Room for an options object in the caller's memory, bytes; holds for every library of the same SONAME. */
#define QTRAJ_OPTIONS_BYTES 512

/** A curve through keyframes, one block of memory, immutable once built: any number of threads may sample it at once.
 * Made by qtraj_create() and its kin or qtraj_init(), given back with qtraj_destroy(). */
typedef struct qtraj_trajectory qtraj_trajectory;
/** A curve of vectors of any length, such as positions, beside a trajectory or alone: one block of memory, immutable
 * once built. Made by qtraj_vector_create() or qtraj_vector_init(), given back with qtraj_vector_destroy(). */
typedef struct qtraj_vector_curve qtraj_vector_curve;
/** A method and its settings, reusable for any number of trajectories, which keep nothing of it. Made by
 * qtraj_options_create() or qtraj_options_init(), given back with qtraj_options_destroy(). One thread at a time. */
typedef struct qtraj_options qtraj_options;

/** What qtraj_check_keys() found in a recording besides the status of each key: 128 bytes, the same on every machine.
 *
 * An index is that of a key, of the later one of two neighbours, and UINT64_MAX where there is none; its value is then
 * NaN. Of equal values it is the first. Neighbours are keys without fault that follow each other once those at fault
 * are left out. */
typedef struct qtraj_key_report {
  uint64_t faults;                 /**< number of keys whose status is not QTRAJ_OK */
  uint64_t sign_changes;           /**< number of neighbours whose dot product is below 0: harmless, q and -q are one */
  uint64_t first_sign_change;      /**< index of the first of them */
  double worst_norm_error;         /**< largest | |q| - 1 | of all keys with a direction; above 0.01 these are hardly
                                      quaternions: look at order, type and layout of the array */
  uint64_t worst_norm_index;       /**< its index */
  double largest_angle;            /**< largest rotation angle between neighbours, rad, in [0, pi]; near pi it is a
                                      matter of chance which way round a curve goes */
  uint64_t largest_angle_index;    /**< its index */
  double longest_interval;         /**< longest time between neighbours, s: a gap in the data */
  uint64_t longest_interval_index; /**< its index */
  double shortest_interval;        /**< shortest time between neighbours, s: a row written twice, or another clock */
  uint64_t shortest_interval_index; /**< its index */
  uint64_t reserved[5];             /**< 0 */
} qtraj_key_report;

/** @} */

/* ---- Library ---- */

/** @defgroup qtraj-library Library
 * What the library tells about itself.
 * @{ */

/** Version of the library that was linked.
 *
 * @return such as "0.1.0"; borrowed: static text, never freed, never NULL */
QTRAJ_API const char* qtraj_version(void);

/** Version of the library that was linked, as a number.
 *
 * @return QTRAJ_VERSION_NUMBER of the header that the library was built with */
QTRAJ_API int32_t qtraj_version_number(void);

/** One-line text of a status.
 *
 * @param status  a qtraj_status, or any other number
 * @return English text, "unknown status" for a number that is none; borrowed: static text, never NULL */
QTRAJ_API const char* qtraj_status_text(int32_t status);

/** Kind of answer that a status is.
 *
 * @param status  a qtraj_status, or any other number
 * @return a qtraj_class_value; QTRAJ_CLASS_DEFECT for a number that is no status of this version */
QTRAJ_API int32_t qtraj_status_class(int32_t status);

/** Kernel that runs here and its arithmetic: which golden hash applies.
 *
 * Samples have the same bits wherever the arithmetic, fused or plain, is the same.
 *
 * @return such as "avx2 fused" or "scalar plain"; borrowed: static text, never NULL */
QTRAJ_API const char* qtraj_target(void);

/** @} */

/* ---- Options: heap or caller's memory; every setter checks at once and fails without effect ---- */

/** @defgroup qtraj-options Options
 * A method and its settings, on the heap or in the caller's memory. Setters check at once and fail without effect.
 * @{ */

/** New options of a method with its default settings, on the heap.
 *
 * @param method  a qtraj_method_value, or for vector curves a qtraj_vector_method_value
 * @param out     receives the options, owned: free them with qtraj_options_destroy(); NULL on every error
 * @return QTRAJ_OK, or QTRAJ_E_NULL (out), QTRAJ_E_VALUE (unknown method), QTRAJ_E_NO_MEMORY: no options */
QTRAJ_API qtraj_status qtraj_options_create(int32_t method, qtraj_options** out);

/** New options of a method with its default settings, in the caller's memory; nothing is allocated.
 *
 * @param memory  [bytes], aligned to 8 bytes; must outlive the options and stay in place
 * @param bytes   QTRAJ_OPTIONS_BYTES or more
 * @param method  a qtraj_method_value, or for vector curves a qtraj_vector_method_value
 * @param out     receives the options, which need no qtraj_options_destroy(); NULL on every error
 * @return QTRAJ_OK, or QTRAJ_E_NULL (out, memory), QTRAJ_E_VALUE (unknown method), QTRAJ_E_BUFFER (memory too small or
 *   not aligned): no options, memory is untouched */
QTRAJ_API qtraj_status qtraj_options_init(void* memory, size_t bytes, int32_t method, qtraj_options** out);

/** Ends the life of options, and frees those made by qtraj_options_create(). Used after it they are QTRAJ_E_HANDLE.
 *
 * @param options  memory of qtraj_options_init() stays the caller's; NULL and what are no options are left alone */
QTRAJ_API void qtraj_options_destroy(qtraj_options* options);

/** Sets the end conditions at the first and at the last key, of SQUAD, LOG_SPLINE, ROTATION_SPLINE or VECTOR_CUBIC.
 *
 * A rate that is stored for an end is dropped where that end becomes other than QTRAJ_END_GIVEN.
 *
 * @param options  changed
 * @param start    a qtraj_end_value that the method has, at the first key
 * @param end      the same at the last key; QTRAJ_END_PERIODIC is for both ends or none
 * @return QTRAJ_OK, or without effect QTRAJ_E_NULL (options), QTRAJ_E_HANDLE, QTRAJ_E_VALUE (an unknown end, or one of
 *   the two PERIODIC), QTRAJ_E_SETTING (the method does not have this end) */
QTRAJ_API qtraj_status qtraj_options_set_ends(qtraj_options* options, int32_t start, int32_t end);

/** Sets the rates of the curve at the ends that are QTRAJ_END_GIVEN; call qtraj_options_set_ends() before.
 *
 * @param options      changed
 * @param frame        a qtraj_frame_value, of both rates
 * @param omega_start  [3], rad/s, at the first key, copied; NULL where that end is not QTRAJ_END_GIVEN
 * @param omega_end    [3], rad/s, at the last key, copied; NULL where that end is not QTRAJ_END_GIVEN
 * @return QTRAJ_OK, or without effect
 *   - QTRAJ_E_NULL (options), QTRAJ_E_HANDLE, QTRAJ_E_VALUE (frame), QTRAJ_E_SETTING (a method without END_GIVEN;
 *     VECTOR_CUBIC has its derivatives from qtraj_vector_create());
 *   - QTRAJ_E_INPUT_MISSING, QTRAJ_E_INPUT_UNWANTED: no rate for an end that is GIVEN, or one for an end that is not;
 *   - QTRAJ_E_NOT_FINITE: a rate */
QTRAJ_API qtraj_status qtraj_options_set_end_rates(qtraj_options* options, int32_t frame, const double* omega_start,
                                                   const double* omega_end);

/** Sets the tangent rule of SQUAD: the rate of the curve at its keys.
 *
 * The tangents of a QUATERNION_HERMITE are no setting: qtraj_create_with_tangents() takes them.
 *
 * @param options  changed
 * @param rule     a qtraj_tangent_value; QTRAJ_TANGENT_GIVEN makes the constructors want omega
 * @return QTRAJ_OK, or without effect QTRAJ_E_NULL (options), QTRAJ_E_HANDLE, QTRAJ_E_VALUE (an unknown rule),
 *   QTRAJ_E_SETTING (a method without tangents) */
QTRAJ_API qtraj_status qtraj_options_set_tangents(qtraj_options* options, int32_t rule);

/** Sets the reference of LOG_SPLINE: the orientation that its rotation vectors start from.
 *
 * @param options  changed
 * @param rule     a qtraj_reference_value
 * @param q_wb     [4], w x y z, body to world, any norm but 0, copied; with another rule NULL. Constructors give it the
 *                 sign that is nearer to the first key
 * @return QTRAJ_OK, or without effect
 *   - QTRAJ_E_NULL (options, or q_wb with REFERENCE_GIVEN), QTRAJ_E_HANDLE;
 *   - QTRAJ_E_VALUE (an unknown rule, or q_wb with another rule), QTRAJ_E_SETTING (a method without reference);
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: q_wb */
QTRAJ_API qtraj_status qtraj_options_set_reference(qtraj_options* options, int32_t rule, const double* q_wb);

/** Sets what a time before the first and after the last knot means; every method has it.
 *
 * @param options  changed
 * @param before   a qtraj_extrapolate_value for times before the first knot
 * @param after    the same for times after the last one; QTRAJ_EXTRAPOLATE_PERIODIC is for both sides or none
 * @return QTRAJ_OK, or without effect QTRAJ_E_NULL (options), QTRAJ_E_HANDLE, QTRAJ_E_VALUE (an unknown rule, or one of
 *   the two PERIODIC) */
QTRAJ_API qtraj_status qtraj_options_set_extrapolation(qtraj_options* options, int32_t before, int32_t after);

/** Sets how far each step from key to key turns.
 *
 * Keys do not tell how often a body has turned between them: of the turns theta + 2 pi k about one axis that lead from
 * one to the next, theta being the shorter one, the rule chooses k. SHORTEST: 0, the only rule of NLERP, SQUAD,
 * LOG_SPLINE and QUATERNION_QUINTIC. AS_GIVEN: 0, or -1, the other way round, where the dot product of the keys is
 * negative; a step that a period adds is the shorter turn; the default of QUATERNION_HERMITE, which has these two.
 * FROM_RATES: the nearest to h times the mean of the two rates (and h^2/12 times the difference of the accelerations),
 * along the axis of the step. GIVEN: the numbers that qtraj_create_with_turns() or qtraj_init() gets. A step that makes
 * whole turns and ends where it began, to 16 eps of the keys' type, has its axis from the rates, and ends within that
 * of its key; without rates it is QTRAJ_E_AMBIGUOUS with the index of its last key. So is, by FROM_RATES, a step that
 * ends within 1e-6 rad of where it began while its rates make more than half a turn about another axis than its own.
 * Samples are continuous: a key that is reached by an odd number of turns has its sign changed.
 *
 * @param options  changed
 * @param rule     a qtraj_turns_value
 * @return QTRAJ_OK, or without effect QTRAJ_E_NULL (options), QTRAJ_E_HANDLE, QTRAJ_E_VALUE (an unknown rule),
 *   QTRAJ_E_SETTING (the method does not have this rule) */
QTRAJ_API qtraj_status qtraj_options_set_turns(qtraj_options* options, int32_t rule);

/** Closes a curve whose keys do not: the first key is repeated one period after it; every method has it.
 *
 * The trajectory has one key more than was passed; that one's rates and tangents are those of the first. Under PERIODIC
 * extrapolation the curve repeats after exactly this period. With the first key written again at the end, leave the
 * period unset.
 *
 * @param options  changed
 * @param period   s, more than from the first key to the last, which the constructors check (QTRAJ_E_TIME_ORDER, or
 *                 QTRAJ_E_TIME_SPAN where it overflows, with the index of the last key); 0: no key is added
 * @return QTRAJ_OK, or without effect QTRAJ_E_NULL (options), QTRAJ_E_HANDLE, QTRAJ_E_VALUE (below 0 or not finite) */
QTRAJ_API qtraj_status qtraj_options_set_period(qtraj_options* options, double period);

/** Sets by how much the last key of a closed curve may differ from the first; every method has it.
 *
 * Of PERIODIC ends or extrapolation. The curve goes through the first key at both ends, up to its sign.
 *
 * @param options  changed
 * @param angle    rad, 0 to pi, the rotation angle between the two keys; of vector curves the difference of a component
 *                 over its largest magnitude; 1e-6 unless set; keys written with five decimals need 3e-5
 * @return QTRAJ_OK, or without effect QTRAJ_E_NULL (options), QTRAJ_E_HANDLE, QTRAJ_E_VALUE (not in this range) */
QTRAJ_API qtraj_status qtraj_options_set_closure(qtraj_options* options, double angle);

/** Sets the longest interval between keys that is interpolated; every method has it.
 *
 * A time inside a longer interval is QTRAJ_E_GAP and its row NaN; the knots at its ends are samples as before. The
 * curve is built through all keys, and curve diagnostics are those of the whole curve.
 *
 * @param options  changed
 * @param seconds  s, more than 0; 0 or infinity: no limit
 * @return QTRAJ_OK, or without effect QTRAJ_E_NULL (options), QTRAJ_E_HANDLE, QTRAJ_E_VALUE (below 0 or NaN) */
QTRAJ_API qtraj_status qtraj_options_set_longest_gap(qtraj_options* options, double seconds);

/** @} */

/* ---- Construction: inputs are copied, normalised, made sign-continuous ---- */

/** @defgroup qtraj-construction Construction
 * Keys are copied, normalised and made sign-continuous: each gets the sign that is nearer to the key before it; at
 * equal distance it keeps its own, as the first does. Steps of more than half a turn, and signs by them, are a setting
 * of their own, qtraj_options_set_turns(). Any trajectory can be sampled in double and in float.
 * @{ */

/** Builds a trajectory through keys, with the default settings of a method.
 *
 * @param method     a qtraj_method_value that needs neither rates nor tangents: SLERP to ROTATION_SPLINE, STEP
 * @param times      [count], s, strictly increasing: the knots
 * @param q_wb       [count][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param count      number of keys, 2 or more
 * @param out        receives the trajectory, owned: free it with qtraj_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory
 *   - QTRAJ_E_NULL, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_VALUE (an unknown method), QTRAJ_E_INPUT_MISSING (a method
 *     that needs rates or tangents), QTRAJ_E_NO_MEMORY;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the key at bad_index; NOT_FINITE
 *     also where absurdly uneven knots throw a LOG_SPLINE out of range;
 *   - QTRAJ_E_NO_CONVERGENCE: ROTATION_SPLINE found no curve, which takes extreme keys */
QTRAJ_API qtraj_status qtraj_create(int32_t method, const double* times, const double* q_wb, size_t count,
                                    qtraj_trajectory** out, size_t* bad_index);

/** Builds a trajectory through keys of float, with the default settings of a method: twin of qtraj_create().
 *
 * The keys are read as float, the times as double, and the curve is built in double.
 *
 * @param method     a qtraj_method_value that needs neither rates nor tangents: SLERP to ROTATION_SPLINE, STEP
 * @param times      [count], s, strictly increasing: the knots
 * @param q_wb       [count][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param count      number of keys, 2 or more
 * @param out        receives the trajectory, owned: free it with qtraj_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory
 *   - QTRAJ_E_NULL, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_VALUE (an unknown method), QTRAJ_E_INPUT_MISSING (a method
 *     that needs rates or tangents), QTRAJ_E_NO_MEMORY;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the key at bad_index; NOT_FINITE
 *     also where absurdly uneven knots throw a LOG_SPLINE out of range;
 *   - QTRAJ_E_NO_CONVERGENCE: ROTATION_SPLINE found no curve, which takes extreme keys */
QTRAJ_API qtraj_status qtraj_create_f32(int32_t method, const double* times, const float* q_wb, size_t count,
                                        qtraj_trajectory** out, size_t* bad_index);

/** Builds a trajectory through keys, with settings of the caller's.
 *
 * @param options    method and settings, read during the call; none that need rates or tangents at all keys
 * @param times      [count], s, strictly increasing: the knots
 * @param q_wb       [count][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param count      number of keys, 2 or more
 * @param out        receives the trajectory, owned: free it with qtraj_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_INPUT_MISSING (at all keys, or at a GIVEN
 *     end where none was set), QTRAJ_E_NO_MEMORY;
 *   - QTRAJ_E_RATE_TOO_FAST: the rate of the end at bad_index, for the interval beside it;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the key at bad_index; NOT_FINITE
 *     also where absurdly uneven knots throw a LOG_SPLINE out of range;
 *   - QTRAJ_E_NOT_CLOSED: PERIODIC ends or extrapolation, and the last key, at bad_index, does not return to the first;
 *   - QTRAJ_E_AMBIGUOUS: the mean of REFERENCE_MEAN is not unique; with the index of a key: the step to it makes a
 *     whole turn (QTRAJ_TURNS_AS_GIVEN), and nothing tells its axis;
 *   - QTRAJ_E_NO_CONVERGENCE: ROTATION_SPLINE found no curve, which takes extreme keys */
QTRAJ_API qtraj_status qtraj_create_with_options(const qtraj_options* options, const double* times, const double* q_wb,
                                                 size_t count, qtraj_trajectory** out, size_t* bad_index);

/** Builds a trajectory through keys of float, with settings of the caller's: twin of qtraj_create_with_options().
 *
 * The keys are read as float, the times as double, and the curve is built in double. A mean of keys (REFERENCE_MEAN)
 * ties by the rounding of float.
 *
 * @param options    method and settings, read during the call; none that need rates or tangents at all keys
 * @param times      [count], s, strictly increasing: the knots
 * @param q_wb       [count][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param count      number of keys, 2 or more
 * @param out        receives the trajectory, owned: free it with qtraj_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_INPUT_MISSING (at all keys, or at a GIVEN
 *     end where none was set), QTRAJ_E_NO_MEMORY;
 *   - QTRAJ_E_RATE_TOO_FAST: the rate of the end at bad_index, for the interval beside it;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the key at bad_index; NOT_FINITE
 *     also where absurdly uneven knots throw a LOG_SPLINE out of range;
 *   - QTRAJ_E_NOT_CLOSED: PERIODIC ends or extrapolation, and the last key, at bad_index, does not return to the first;
 *   - QTRAJ_E_AMBIGUOUS: the mean of REFERENCE_MEAN is not unique; with the index of a key: the step to it makes a
 *     whole turn (QTRAJ_TURNS_AS_GIVEN), and nothing tells its axis;
 *   - QTRAJ_E_NO_CONVERGENCE: ROTATION_SPLINE found no curve, which takes extreme keys */
QTRAJ_API qtraj_status qtraj_create_with_options_f32(const qtraj_options* options, const double* times,
                                                     const float* q_wb, size_t count, qtraj_trajectory** out,
                                                     size_t* bad_index);

/** Builds a trajectory through keys with given rates: HERMITE, the quintics, and SQUAD with QTRAJ_TANGENT_GIVEN.
 *
 * @param options    method and settings, read during the call
 * @param frame      a qtraj_frame_value, of omega and alpha
 * @param times      [count], s, strictly increasing: the knots
 * @param q_wb       [count][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param omega      [count][3], rad/s, angular velocities at the keys
 * @param alpha      [count][3], rad/s^2, angular accelerations at the keys, for the quintics; else NULL
 * @param count      number of keys, 2 or more
 * @param out        receives the trajectory, owned: free it with qtraj_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_NO_MEMORY;
 *   - QTRAJ_E_INPUT_MISSING: alpha, turns, or the rate of a GIVEN end; QTRAJ_E_INPUT_UNWANTED: omega or alpha for a
 *     method or setting that does not use them;
 *   - QTRAJ_E_RATE_TOO_FAST: the rate, or acceleration, of the key at bad_index, for an interval beside it;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the key at bad_index;
 *   - QTRAJ_E_NOT_CLOSED: PERIODIC ends or extrapolation, and the last key, at bad_index, does not return to the
 *     first;
 *   - QTRAJ_E_AMBIGUOUS: the step to the key at bad_index makes a whole turn (QTRAJ_TURNS_AS_GIVEN), its rates are 0,
 *     and nothing tells its axis */
QTRAJ_API qtraj_status qtraj_create_with_rates(const qtraj_options* options, int32_t frame, const double* times,
                                               const double* q_wb, const double* omega, const double* alpha,
                                               size_t count, qtraj_trajectory** out, size_t* bad_index);

/** Builds a trajectory through keys with given rates, of float: twin of qtraj_create_with_rates().
 *
 * Keys, omega and alpha are read as float, the times as double, and the curve is built in double.
 *
 * @param options    method and settings, read during the call: HERMITE, a quintic, or SQUAD with QTRAJ_TANGENT_GIVEN
 * @param frame      a qtraj_frame_value, of omega and alpha
 * @param times      [count], s, strictly increasing: the knots
 * @param q_wb       [count][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param omega      [count][3], rad/s, angular velocities at the keys
 * @param alpha      [count][3], rad/s^2, angular accelerations at the keys, for the quintics; else NULL
 * @param count      number of keys, 2 or more
 * @param out        receives the trajectory, owned: free it with qtraj_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_NO_MEMORY;
 *   - QTRAJ_E_INPUT_MISSING: alpha, turns, or the rate of a GIVEN end; QTRAJ_E_INPUT_UNWANTED: omega or alpha for a
 *     method or setting that does not use them;
 *   - QTRAJ_E_RATE_TOO_FAST: the rate, or acceleration, of the key at bad_index, for an interval beside it;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the key at bad_index;
 *   - QTRAJ_E_NOT_CLOSED: PERIODIC ends or extrapolation, and the last key, at bad_index, does not return to the
 *     first;
 *   - QTRAJ_E_AMBIGUOUS: the step to the key at bad_index makes a whole turn (QTRAJ_TURNS_AS_GIVEN), its rates are 0,
 *     and nothing tells its axis */
QTRAJ_API qtraj_status qtraj_create_with_rates_f32(const qtraj_options* options, int32_t frame, const double* times,
                                                   const float* q_wb, const float* omega, const float* alpha,
                                                   size_t count, qtraj_trajectory** out, size_t* bad_index);

/** Builds a trajectory through keys with a number of whole turns for each step.
 *
 * Of SLERP, ROTATION_SPLINE, HERMITE and ROTATION_QUINTIC with QTRAJ_TURNS_GIVEN.
 *
 * @param options    method and settings, read during the call
 * @param frame      a qtraj_frame_value, of omega and alpha; ignored where omega is NULL
 * @param times      [count], s, strictly increasing: the knots
 * @param q_wb       [count][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param omega      [count][3], rad/s, at the keys, for HERMITE and ROTATION_QUINTIC; else NULL
 * @param alpha      [count][3], rad/s^2, at the keys, for ROTATION_QUINTIC; else NULL
 * @param turns      [count - 1], with a period set [count]: whole turns of each step beside the shorter one, about its
 *                   axis; negative: the other way round
 * @param count      number of keys, 2 or more
 * @param out        receives the trajectory, owned: free it with qtraj_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory what qtraj_create_with_rates() gives, and
 *   - QTRAJ_E_NULL: turns; QTRAJ_E_INPUT_MISSING, QTRAJ_E_INPUT_UNWANTED: as there, the latter also where the options
 *     have another rule for turns;
 *   - QTRAJ_E_AMBIGUOUS: the step to the key at bad_index makes whole turns, ends where it began, and no rates tell its
 *     axis;
 *   - QTRAJ_E_NO_CONVERGENCE: ROTATION_SPLINE found no curve: steps of nearly whole turns about changing axes */
QTRAJ_API qtraj_status qtraj_create_with_turns(const qtraj_options* options, int32_t frame, const double* times,
                                               const double* q_wb, const double* omega, const double* alpha,
                                               const int32_t* turns, size_t count, qtraj_trajectory** out,
                                               size_t* bad_index);

/** Builds a trajectory with a number of whole turns for each step, of float keys: twin of qtraj_create_with_turns().
 *
 * Keys, omega and alpha are read as float, the times as double, and the curve is built in double.
 *
 * Of SLERP, ROTATION_SPLINE, HERMITE and ROTATION_QUINTIC with QTRAJ_TURNS_GIVEN.
 *
 * @param options    method and settings, read during the call
 * @param frame      a qtraj_frame_value, of omega and alpha; ignored where omega is NULL
 * @param times      [count], s, strictly increasing: the knots
 * @param q_wb       [count][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param omega      [count][3], rad/s, at the keys, for HERMITE and ROTATION_QUINTIC; else NULL
 * @param alpha      [count][3], rad/s^2, at the keys, for ROTATION_QUINTIC; else NULL
 * @param turns      [count - 1], with a period set [count]: whole turns of each step beside the shorter one, about its
 *                   axis; negative: the other way round
 * @param count      number of keys, 2 or more
 * @param out        receives the trajectory, owned: free it with qtraj_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory what qtraj_create_with_rates_f32() gives, and
 *   - QTRAJ_E_NULL: turns; QTRAJ_E_INPUT_MISSING, QTRAJ_E_INPUT_UNWANTED: as there, the latter also where the options
 *     have another rule for turns;
 *   - QTRAJ_E_AMBIGUOUS: the step to the key at bad_index makes whole turns, ends where it began, and no rates tell its
 *     axis;
 *   - QTRAJ_E_NO_CONVERGENCE: ROTATION_SPLINE found no curve: steps of nearly whole turns about changing axes */
QTRAJ_API qtraj_status qtraj_create_with_turns_f32(const qtraj_options* options, int32_t frame, const double* times,
                                                   const float* q_wb, const float* omega, const float* alpha,
                                                   const int32_t* turns, size_t count, qtraj_trajectory** out,
                                                   size_t* bad_index);

/** Builds a trajectory through keys with given tangents: QTRAJ_QUATERNION_HERMITE.
 *
 * Between two keys the cubic in R^4 from the out-tangent of the first and the in-tangent of the second, normalised: the
 * CUBICSPLINE of glTF 2.0, appendix C. It goes through the keys as they are written, with their norms; keys of extreme
 * size (the largest component of all below 2^-100 or above 2^100) are multiplied by a power of two, all by the same.
 * By default keys also keep their signs (QTRAJ_TURNS_AS_GIVEN); by QTRAJ_TURNS_SHORTEST a key that gets the other sign
 * gets other tangents of both sides, too. A key that a period adds has the tangents of the first; the last key of a
 * curve that repeats has the direction of the first, its own norm and its own tangent.
 *
 * @param options       method and settings, read during the call
 * @param times         [count], s, strictly increasing: the knots
 * @param q_wb          [count][4], w x y z, body to world, the keys; any norm but 0
 * @param in_tangents   [count][4], w x y z, dq/dt before each key, 1/s, all finite; the first serves a period only
 * @param out_tangents  [count][4], the same after each key; the last serves a period only; NULL: in_tangents are both
 * @param count         number of keys, 2 or more
 * @param out           receives the trajectory, owned: free it with qtraj_destroy(); NULL on every error
 * @param bad_index     receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_INPUT_MISSING (rates that another method
 *     needs), QTRAJ_E_INPUT_UNWANTED (another method), QTRAJ_E_NO_MEMORY;
 *   - QTRAJ_E_NOT_FINITE (a key or any of its tangents), QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the
 *     key at bad_index; ZERO_NORM also where a key is below 2^-100 of the largest;
 *   - QTRAJ_E_NOT_CLOSED: PERIODIC extrapolation, and the last key, at bad_index, does not return to the first;
 *   - QTRAJ_E_RATE_TOO_FAST: a tangent of the key at bad_index, times the interval on its side, is more than 2^200
 *     times the key, or more than 2^1023 */
QTRAJ_API qtraj_status qtraj_create_with_tangents(const qtraj_options* options, const double* times, const double* q_wb,
                                                  const double* in_tangents, const double* out_tangents, size_t count,
                                                  qtraj_trajectory** out, size_t* bad_index);

/** Builds a trajectory through keys with given tangents, of float: twin of qtraj_create_with_tangents().
 *
 * Keys and tangents are read as float, the times as double, and the curve is built in double.
 *
 * @param options       method and settings, read during the call
 * @param times         [count], s, strictly increasing: the knots
 * @param q_wb          [count][4], w x y z, body to world, the keys; any norm but 0
 * @param in_tangents   [count][4], w x y z, dq/dt before each key, 1/s, all finite; the first serves a period only
 * @param out_tangents  [count][4], the same after each key; the last serves a period only; NULL: in_tangents are both
 * @param count         number of keys, 2 or more
 * @param out           receives the trajectory, owned: free it with qtraj_destroy(); NULL on every error
 * @param bad_index     receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_INPUT_MISSING (rates that another method
 *     needs), QTRAJ_E_INPUT_UNWANTED (another method), QTRAJ_E_NO_MEMORY;
 *   - QTRAJ_E_NOT_FINITE (a key or any of its tangents), QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the
 *     key at bad_index; ZERO_NORM also where a key is below 2^-100 of the largest;
 *   - QTRAJ_E_NOT_CLOSED: PERIODIC extrapolation, and the last key, at bad_index, does not return to the first;
 *   - QTRAJ_E_RATE_TOO_FAST: a tangent of the key at bad_index, times the interval on its side, is more than 2^200
 *     times the key, or more than 2^1023 */
QTRAJ_API qtraj_status qtraj_create_with_tangents_f32(const qtraj_options* options, const double* times,
                                                      const float* q_wb, const float* in_tangents,
                                                      const float* out_tangents, size_t count, qtraj_trajectory** out,
                                                      size_t* bad_index);

/** Bytes that qtraj_init(), qtraj_init_with_tangents() and their twins need, working space included.
 *
 * @param options  method and settings, read during the call
 * @param count    number of keys, 2 or more
 * @param bytes    receives the number of bytes
 * @return QTRAJ_OK, or QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE: nothing is written */
QTRAJ_API qtraj_status qtraj_init_size(const qtraj_options* options, size_t count, size_t* bytes);

/** Builds a trajectory through keys in the caller's memory, with or without given rates; nothing is allocated.
 *
 * @param memory     [bytes], aligned to 8 bytes, overlapping no input; must outlive the trajectory and stay in place
 * @param bytes      qtraj_init_size() of the same options and count, or more
 * @param options    method and settings, read during the call
 * @param frame      a qtraj_frame_value, of omega and alpha; ignored where omega is NULL
 * @param times      [count], s, strictly increasing: the knots
 * @param q_wb       [count][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param omega      [count][3], rad/s, at the keys, for HERMITE, the quintics, SQUAD with TANGENT_GIVEN; else NULL
 * @param alpha      [count][3], rad/s^2, at the keys, for the quintics; else NULL
 * @param turns      whole turns of each step, for QTRAJ_TURNS_GIVEN, as of qtraj_create_with_turns(); else NULL
 * @param count      number of keys, 2 or more
 * @param out        receives the trajectory, which needs no qtraj_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_INPUT_MISSING,
 *     QTRAJ_E_INPUT_UNWANTED, QTRAJ_E_BUFFER (memory too small or not aligned), QTRAJ_E_OVERLAP: memory is untouched;
 *   - QTRAJ_E_RATE_TOO_FAST: the rate, or acceleration, of the key at bad_index, for an interval beside it;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the key at bad_index; NOT_FINITE
 *     also where absurdly uneven knots throw a LOG_SPLINE out of range;
 *   - QTRAJ_E_NOT_CLOSED: PERIODIC ends or extrapolation, and the last key, at bad_index, does not return to the first;
 *   - QTRAJ_E_AMBIGUOUS: the mean of REFERENCE_MEAN is not unique; with the index of a key: the step to it makes a
 *     whole turn (QTRAJ_TURNS_AS_GIVEN), and nothing tells its axis;
 *   - QTRAJ_E_NO_CONVERGENCE: ROTATION_SPLINE found no curve, which takes extreme keys */
QTRAJ_API qtraj_status qtraj_init(void* memory, size_t bytes, const qtraj_options* options, int32_t frame,
                                  const double* times, const double* q_wb, const double* omega, const double* alpha,
                                  const int32_t* turns, size_t count, qtraj_trajectory** out, size_t* bad_index);

/** Builds a trajectory through keys of float in the caller's memory: twin of qtraj_init().
 *
 * Keys, omega and alpha are read as float, the times as double, and the curve is built in double. Nothing is allocated.
 *
 * @param memory     [bytes], aligned to 8 bytes, overlapping no input; must outlive the trajectory and stay in place
 * @param bytes      qtraj_init_size() of the same options and count, or more
 * @param options    method and settings, read during the call
 * @param frame      a qtraj_frame_value, of omega and alpha; ignored where omega is NULL
 * @param times      [count], s, strictly increasing: the knots
 * @param q_wb       [count][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param omega      [count][3], rad/s, at the keys, for HERMITE, the quintics, SQUAD with TANGENT_GIVEN; else NULL
 * @param alpha      [count][3], rad/s^2, at the keys, for the quintics; else NULL
 * @param turns      whole turns of each step, for QTRAJ_TURNS_GIVEN, as of qtraj_create_with_turns(); else NULL
 * @param count      number of keys, 2 or more
 * @param out        receives the trajectory, which needs no qtraj_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_INPUT_MISSING,
 *     QTRAJ_E_INPUT_UNWANTED, QTRAJ_E_BUFFER (memory too small or not aligned), QTRAJ_E_OVERLAP: memory is untouched;
 *   - QTRAJ_E_RATE_TOO_FAST: the rate, or acceleration, of the key at bad_index, for an interval beside it;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the key at bad_index; NOT_FINITE
 *     also where absurdly uneven knots throw a LOG_SPLINE out of range;
 *   - QTRAJ_E_NOT_CLOSED: PERIODIC ends or extrapolation, and the last key, at bad_index, does not return to the first;
 *   - QTRAJ_E_AMBIGUOUS: the mean of REFERENCE_MEAN is not unique; with the index of a key: the step to it makes a
 *     whole turn (QTRAJ_TURNS_AS_GIVEN), and nothing tells its axis;
 *   - QTRAJ_E_NO_CONVERGENCE: ROTATION_SPLINE found no curve, which takes extreme keys */
QTRAJ_API qtraj_status qtraj_init_f32(void* memory, size_t bytes, const qtraj_options* options, int32_t frame,
                                      const double* times, const float* q_wb, const float* omega, const float* alpha,
                                      const int32_t* turns, size_t count, qtraj_trajectory** out, size_t* bad_index);

/** Builds a trajectory through keys with given tangents in the caller's memory; nothing is allocated.
 *
 * The curve is that of qtraj_create_with_tangents().
 *
 * @param memory        [bytes], aligned to 8 bytes, overlapping no input; must outlive the trajectory and stay in place
 * @param bytes         qtraj_init_size() of the same options and count, or more
 * @param options       method and settings, read during the call
 * @param times         [count], s, strictly increasing: the knots
 * @param q_wb          [count][4], w x y z, body to world, the keys; any norm but 0
 * @param in_tangents   [count][4], w x y z, dq/dt before each key, 1/s, all finite; the first serves a period only
 * @param out_tangents  [count][4], the same after each key; the last serves a period only; NULL: in_tangents are both
 * @param count         number of keys, 2 or more
 * @param out           receives the trajectory, which needs no qtraj_destroy(); NULL on every error
 * @param bad_index     receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_INPUT_MISSING (rates that another method
 *     needs), QTRAJ_E_INPUT_UNWANTED (another method), QTRAJ_E_BUFFER (memory too small or not aligned),
 *     QTRAJ_E_OVERLAP: memory is untouched;
 *   - QTRAJ_E_NOT_FINITE (a key or any of its tangents), QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the
 *     key at bad_index; ZERO_NORM also where a key is below 2^-100 of the largest;
 *   - QTRAJ_E_NOT_CLOSED: PERIODIC extrapolation, and the last key, at bad_index, does not return to the first;
 *   - QTRAJ_E_RATE_TOO_FAST: a tangent of the key at bad_index, times the interval on its side, is more than 2^200
 *     times the key, or more than 2^1023 */
QTRAJ_API qtraj_status qtraj_init_with_tangents(void* memory, size_t bytes, const qtraj_options* options,
                                                const double* times, const double* q_wb, const double* in_tangents,
                                                const double* out_tangents, size_t count, qtraj_trajectory** out,
                                                size_t* bad_index);

/** Builds a trajectory with given tangents, of float, in the caller's memory: twin of qtraj_init_with_tangents().
 *
 * Keys and tangents are read as float, the times as double, and the curve is built in double. Nothing is allocated.
 *
 * @param memory        [bytes], aligned to 8 bytes, overlapping no input; must outlive the trajectory and stay in place
 * @param bytes         qtraj_init_size() of the same options and count, or more
 * @param options       method and settings, read during the call
 * @param times         [count], s, strictly increasing: the knots
 * @param q_wb          [count][4], w x y z, body to world, the keys; any norm but 0
 * @param in_tangents   [count][4], w x y z, dq/dt before each key, 1/s, all finite; the first serves a period only
 * @param out_tangents  [count][4], the same after each key; the last serves a period only; NULL: in_tangents are both
 * @param count         number of keys, 2 or more
 * @param out           receives the trajectory, which needs no qtraj_destroy(); NULL on every error
 * @param bad_index     receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a trajectory
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_INPUT_MISSING (rates that another method
 *     needs), QTRAJ_E_INPUT_UNWANTED (another method), QTRAJ_E_BUFFER (memory too small or not aligned),
 *     QTRAJ_E_OVERLAP: memory is untouched;
 *   - QTRAJ_E_NOT_FINITE (a key or any of its tangents), QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the
 *     key at bad_index; ZERO_NORM also where a key is below 2^-100 of the largest;
 *   - QTRAJ_E_NOT_CLOSED: PERIODIC extrapolation, and the last key, at bad_index, does not return to the first;
 *   - QTRAJ_E_RATE_TOO_FAST: a tangent of the key at bad_index, times the interval on its side, is more than 2^200
 *     times the key, or more than 2^1023 */
QTRAJ_API qtraj_status qtraj_init_with_tangents_f32(void* memory, size_t bytes, const qtraj_options* options,
                                                    const double* times, const float* q_wb, const float* in_tangents,
                                                    const float* out_tangents, size_t count, qtraj_trajectory** out,
                                                    size_t* bad_index);

/** Ends the life of a trajectory, and frees one on the heap. Used after it, it is QTRAJ_E_HANDLE.
 *
 * @param trajectory  memory of qtraj_init() stays the caller's; NULL and what is no trajectory are left alone */
QTRAJ_API void qtraj_destroy(qtraj_trajectory* trajectory);

/** @} */

/* ---- Sampling: any order of times; the same time gives the same bits from every function ---- */

/** @defgroup qtraj-sampling Sampling
 * Times may come in any order, and the same time gives the same bits from every function of one type. Sampling never
 * allocates. At a knot a sample belongs to the segment that starts there, at the last knot to the last one, or, where
 * the curve is repeated by PERIODIC extrapolation, to the first. A time outside the knots by no more than 4 units in
 * the last place of the larger end counts as that end: the last of an even grid of rounded times is a sample.
 * @{ */

/** Samples orientations at many times.
 *
 * @param trajectory  the curve; not NULL, also where count is 0
 * @param times       [count], s, in any order; outside the knots the curve's extrapolation decides
 * @param count       number of samples; where it is 0 arrays may be NULL
 * @param q_out       [count][4], w x y z, body to world, unit; may not overlap times
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (a time), QTRAJ_E_TIME_RANGE (a time outside the knots under EXTRAPOLATE_ERROR), QTRAJ_E_GAP:
 *     that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_sample(const qtraj_trajectory* trajectory, const double* times, size_t count,
                                    double* q_out, size_t* bad_index);

/** Samples orientations at many times in float: twin of qtraj_sample().
 *
 * Computes in single precision, in double where the curve needs it; the place of a time between the knots is double.
 *
 * @param trajectory  the curve, of double or float keys; not NULL, also where count is 0
 * @param times       [count], s, in any order; outside the knots the curve's extrapolation decides
 * @param count       number of samples; where it is 0 arrays may be NULL
 * @param q_out       [count][4], w x y z, body to world, unit; may not overlap times
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (a time), QTRAJ_E_TIME_RANGE (a time outside the knots under EXTRAPOLATE_ERROR), QTRAJ_E_GAP:
 *     that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_sample_f32(const qtraj_trajectory* trajectory, const double* times, size_t count,
                                        float* q_out, size_t* bad_index);

/** Samples orientations, angular velocities and angular accelerations at many times.
 *
 * Rates are exact derivatives of the curve. A rate that jumps at a knot has its right-hand value there, at the last
 * knot its left-hand one, unless the curve repeats.
 *
 * @param trajectory  the curve; not NULL, also where count is 0
 * @param frame       a qtraj_frame_value, of omega_out and alpha_out
 * @param times       [count], s, in any order; outside the knots the curve's extrapolation decides
 * @param count       number of samples; where it is 0 arrays may be NULL
 * @param q_out       [count][4], w x y z, body to world, unit; may be NULL, but not all three outputs
 * @param omega_out   [count][3], rad/s; may be NULL, but not all three outputs
 * @param alpha_out   [count][3], rad/s^2; may be NULL, but not all three outputs
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_OVERLAP (of any two arrays): nothing
 *     is written;
 *   - QTRAJ_E_NOT_FINITE (a time, or a rate that overflows), QTRAJ_E_TIME_RANGE (a time outside the knots under
 *     EXTRAPOLATE_ERROR), QTRAJ_E_GAP: that row is NaN in every output, all others are right */
QTRAJ_API qtraj_status qtraj_sample_rates(const qtraj_trajectory* trajectory, int32_t frame, const double* times,
                                          size_t count, double* q_out, double* omega_out, double* alpha_out,
                                          size_t* bad_index);

/** Samples orientations, angular velocities and accelerations at many times in float: twin of qtraj_sample_rates().
 *
 * Computes in single precision, in double where the curve needs it; the place of a time between the knots is double.
 * A rate that jumps at a knot has its right-hand value there, at the last knot its left-hand one, unless
 * the curve repeats.
 *
 * @param trajectory  the curve, of double or float keys; not NULL, also where count is 0
 * @param frame       a qtraj_frame_value, of omega_out and alpha_out
 * @param times       [count], s, in any order; outside the knots the curve's extrapolation decides
 * @param count       number of samples; where it is 0 arrays may be NULL
 * @param q_out       [count][4], w x y z, body to world, unit; may be NULL, but not all three outputs
 * @param omega_out   [count][3], rad/s; may be NULL, but not all three outputs
 * @param alpha_out   [count][3], rad/s^2; may be NULL, but not all three outputs
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_OVERLAP (of any two arrays): nothing
 *     is written;
 *   - QTRAJ_E_NOT_FINITE (a time, or a rate too large for float), QTRAJ_E_TIME_RANGE (a time outside the knots under
 *     EXTRAPOLATE_ERROR), QTRAJ_E_GAP: that row is NaN in every output, all others are right */
QTRAJ_API qtraj_status qtraj_sample_rates_f32(const qtraj_trajectory* trajectory, int32_t frame, const double* times,
                                              size_t count, float* q_out, float* omega_out, float* alpha_out,
                                              size_t* bad_index);

/** Samples many trajectories at shared times.
 *
 * Rows have the bits of qtraj_sample() and qtraj_sample_rates(). A rig of few times, such as the joints of a
 * skeleton at one, is sampled in vectors across trajectories: those whose methods are alike stand best side by side.
 *
 * @param trajectories  [series], the curves, one of them as often as you like; not NULL, also where count is 0
 * @param series        number of curves; where it is 0 all arrays may be NULL
 * @param frame         a qtraj_frame_value, of omega_out and alpha_out
 * @param times         [count], s, in any order; outside the knots the extrapolation of each curve decides
 * @param count         number of times; where it is 0 times and outputs may be NULL
 * @param layout        a qtraj_layout_value: rows are [series][count] or [count][series]
 * @param q_out         [rows][4], w x y z, body to world, unit; may be NULL, but not all three outputs
 * @param omega_out     [rows][3], rad/s; may be NULL, but not all three outputs
 * @param alpha_out     [rows][3], rad/s^2; may be NULL, but not all three outputs
 * @param bad_index     receives the index of the first row at fault, as the rows are laid out, SIZE_MAX where there is
 *                      none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL (also one of the trajectories), QTRAJ_E_HANDLE (one of the trajectories), QTRAJ_E_SIZE,
 *     QTRAJ_E_VALUE (frame, layout), QTRAJ_E_OVERLAP (of an output with any other array): nothing is written;
 *   - QTRAJ_E_NOT_FINITE (a time, or a rate that overflows), QTRAJ_E_TIME_RANGE (a time outside the knots under
 *     EXTRAPOLATE_ERROR), QTRAJ_E_GAP: that row is NaN in every output, all others are right */
QTRAJ_API qtraj_status qtraj_sample_many(const qtraj_trajectory* const* trajectories, size_t series, int32_t frame,
                                         const double* times, size_t count, int32_t layout, double* q_out,
                                         double* omega_out, double* alpha_out, size_t* bad_index);

/** Samples many trajectories at shared times in float: twin of qtraj_sample_many().
 *
 * Computes in single precision, in double where a curve needs it; the place of a time between the knots is double.
 *
 * Rows have the bits of qtraj_sample_f32() and qtraj_sample_rates_f32(). A rig of few times, such as the joints of a
 * skeleton at one, is sampled in vectors across trajectories: those whose methods are alike stand best side by side.
 *
 * @param trajectories  [series], the curves, of double or float keys, one of them as often as you like; not NULL, also
 *                      where count is 0
 * @param series        number of curves; where it is 0 all arrays may be NULL
 * @param frame         a qtraj_frame_value, of omega_out and alpha_out
 * @param times         [count], s, in any order; outside the knots the extrapolation of each curve decides
 * @param count         number of times; where it is 0 times and outputs may be NULL
 * @param layout        a qtraj_layout_value: rows are [series][count] or [count][series]
 * @param q_out         [rows][4], w x y z, body to world, unit; may be NULL, but not all three outputs
 * @param omega_out     [rows][3], rad/s; may be NULL, but not all three outputs
 * @param alpha_out     [rows][3], rad/s^2; may be NULL, but not all three outputs
 * @param bad_index     receives the index of the first row at fault, as the rows are laid out, SIZE_MAX where there is
 *                      none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL (also one of the trajectories), QTRAJ_E_HANDLE (one of the trajectories), QTRAJ_E_SIZE,
 *     QTRAJ_E_VALUE (frame, layout), QTRAJ_E_OVERLAP (of an output with any other array): nothing is written;
 *   - QTRAJ_E_NOT_FINITE (a time, or a rate too large for float), QTRAJ_E_TIME_RANGE (a time outside the knots under
 *     EXTRAPOLATE_ERROR), QTRAJ_E_GAP: that row is NaN in every output, all others are right */
QTRAJ_API qtraj_status qtraj_sample_many_f32(const qtraj_trajectory* const* trajectories, size_t series, int32_t frame,
                                             const double* times, size_t count, int32_t layout, float* q_out,
                                             float* omega_out, float* alpha_out, size_t* bad_index);

/** Samples the curve in R^4 that is normalised, of NLERP, QUATERNION_QUINTIC and QUATERNION_HERMITE, and its
 * derivatives.
 *
 * p / |p| is the orientation; p is the key at every knot, of QUATERNION_HERMITE with its norm. A derivative that jumps
 * at a knot has its right-hand value there, at the last knot its left-hand one. Outside the knots p is the unit
 * quaternion of qtraj_sample() by the curve's extrapolation, and the derivatives are those of it: 0 under HOLD, of the
 * great circle under CONSTANT_RATE, of the wrapped time under PERIODIC.
 *
 * @param trajectory  an NLERP, QUATERNION_QUINTIC or QUATERNION_HERMITE; not NULL, also where count is 0
 * @param times       [count], s, in any order; outside the knots the curve's extrapolation decides
 * @param count       number of samples; where it is 0 arrays may be NULL
 * @param p_out       [count][4], w x y z, not normalised; may be NULL, but not all three outputs
 * @param dp_out      [count][4], 1/s; may be NULL, but not all three outputs
 * @param ddp_out     [count][4], 1/s^2; may be NULL, but not all three outputs
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_SIZE, QTRAJ_E_SETTING (any other method), QTRAJ_E_OVERLAP (of any two
 *     arrays): nothing is written;
 *   - QTRAJ_E_NOT_FINITE (a time, or a derivative that overflows), QTRAJ_E_TIME_RANGE (a time outside the knots under
 *     EXTRAPOLATE_ERROR), QTRAJ_E_GAP: that row is NaN in every output, all others are right */
QTRAJ_API qtraj_status qtraj_sample_unnormalized(const qtraj_trajectory* trajectory, const double* times, size_t count,
                                                 double* p_out, double* dp_out, double* ddp_out, size_t* bad_index);

/** Samples orientations at a fixed rate: at start + (double)i * step, rounded twice, for every i below count.
 *
 * @param trajectory  the curve; not NULL, also where count is 0
 * @param start       s, time of row 0
 * @param step        s, from row to row; may be 0 or negative
 * @param count       number of samples; where it is 0 q_out may be NULL
 * @param q_out       [count][4], w x y z, body to world, unit
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_SIZE: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (a time), QTRAJ_E_TIME_RANGE (a time outside the knots under EXTRAPOLATE_ERROR), QTRAJ_E_GAP:
 *     that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_sample_uniform(const qtraj_trajectory* trajectory, double start, double step, size_t count,
                                            double* q_out, size_t* bad_index);

/** Samples orientations at a fixed rate in float, at start + (double)i * step: twin of qtraj_sample_uniform().
 *
 * Computes in single precision, in double where the curve needs it; times and their place between the knots are double.
 *
 * @param trajectory  the curve, of double or float keys; not NULL, also where count is 0
 * @param start       s, time of row 0
 * @param step        s, from row to row; may be 0 or negative
 * @param count       number of samples; where it is 0 q_out may be NULL
 * @param q_out       [count][4], w x y z, body to world, unit
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_SIZE: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (a time), QTRAJ_E_TIME_RANGE (a time outside the knots under EXTRAPOLATE_ERROR), QTRAJ_E_GAP:
 *     that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_sample_uniform_f32(const qtraj_trajectory* trajectory, double start, double step,
                                                size_t count, float* q_out, size_t* bad_index);

/** Number of samples at a fixed rate that lie within the knots: the count for qtraj_sample_uniform().
 *
 * Of the rows start + (double)i * step, from i = 0 on, those up to the knot that the step leads to, that one included.
 *
 * @param trajectory  the curve
 * @param start       s, time of row 0, within the knots
 * @param step        s, from row to row; may be negative
 * @param count       receives the number, 1 or more; 0 on every error
 * @return QTRAJ_OK, or QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_SIZE (more than 2^53 rows), QTRAJ_E_VALUE (step 0),
 *   QTRAJ_E_NOT_FINITE (start or step), QTRAJ_E_TIME_RANGE (start outside the knots) */
QTRAJ_API qtraj_status qtraj_uniform_count(const qtraj_trajectory* trajectory, double start, double step,
                                           size_t* count);

/** Times at even distances from first to last, both exact, none past last: for the samplers that take times.
 *
 * @param first      s, time of row 0
 * @param last       s, time of the last row; first or later, also where count is 1 and the only row is first
 * @param count      number of times; 0 is OK, then times_out may be NULL
 * @param times_out  [count], s, never decreasing
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (first or last), QTRAJ_E_TIME_ORDER (last before first): all rows are NaN */
QTRAJ_API qtraj_status qtraj_even_times(double first, double last, size_t count, double* times_out);

/** Times in every segment of a trajectory, evenly spaced, both ends included: knots are there once, and as they are.
 *
 * Row k (per_segment - 1) is knot k; times never decrease. What differs from segment to segment, such as a difference
 * or a plot of rates that jump, wants times like these.
 *
 * @param trajectory   the curve
 * @param per_segment  number of times in each segment, 2 or more
 * @param times_out    [(key_count - 1) * (per_segment - 1) + 1], s, key_count that of qtraj_key_count()
 * @return QTRAJ_OK, or QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_TOO_FEW (per_segment), QTRAJ_E_SIZE: nothing is written */
QTRAJ_API qtraj_status qtraj_segment_times(const qtraj_trajectory* trajectory, size_t per_segment, double* times_out);

/** Samples the orientation at one time, for control loops.
 *
 * @param trajectory  the curve
 * @param time        s; outside the knots the curve's extrapolation decides
 * @param cursor      a hint of the caller's, any value, 0 to begin: the segment to try first, never changes the result;
 *                    receives the segment used, or stays as it is where there is none; may be NULL
 * @param q_out       [4], w x y z, body to world, unit
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (time), QTRAJ_E_TIME_RANGE (time outside the knots under EXTRAPOLATE_ERROR), QTRAJ_E_GAP:
 *     q_out is NaN */
QTRAJ_API qtraj_status qtraj_sample_at(const qtraj_trajectory* trajectory, double time, size_t* cursor, double* q_out);

/** Samples the orientation at one time in float, for control loops: twin of qtraj_sample_at().
 *
 * Computes in single precision, in double where the curve needs it; the place of time between the knots is double.
 *
 * @param trajectory  the curve, of double or float keys
 * @param time        s; outside the knots the curve's extrapolation decides
 * @param cursor      a hint of the caller's, any value, 0 to begin: the segment to try first, never changes the result;
 *                    receives the segment used, or stays as it is where there is none; may be NULL
 * @param q_out       [4], w x y z, body to world, unit
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (time), QTRAJ_E_TIME_RANGE (time outside the knots under EXTRAPOLATE_ERROR), QTRAJ_E_GAP:
 *     q_out is NaN */
QTRAJ_API qtraj_status qtraj_sample_at_f32(const qtraj_trajectory* trajectory, double time, size_t* cursor,
                                           float* q_out);

/** Samples orientation, angular velocity and angular acceleration at one time, for control loops.
 *
 * A rate that jumps at a knot has its right-hand value there, at the last knot its left-hand one, unless
 * the curve repeats.
 *
 * @param trajectory  the curve
 * @param frame       a qtraj_frame_value, of omega_out and alpha_out
 * @param time        s; outside the knots the curve's extrapolation decides
 * @param cursor      a hint of the caller's, any value, 0 to begin: the segment to try first, never changes the result;
 *                    receives the segment used, or stays as it is where there is none; may be NULL
 * @param q_out       [4], w x y z, body to world, unit; may be NULL, but not all three outputs
 * @param omega_out   [3], rad/s; may be NULL, but not all three outputs
 * @param alpha_out   [3], rad/s^2; may be NULL, but not all three outputs
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_VALUE (frame), QTRAJ_E_OVERLAP (of any two outputs): nothing is written;
 *   - QTRAJ_E_NOT_FINITE (time, or a rate that overflows), QTRAJ_E_TIME_RANGE (time outside the knots under
 *     EXTRAPOLATE_ERROR), QTRAJ_E_GAP: every output is NaN */
QTRAJ_API qtraj_status qtraj_sample_rates_at(const qtraj_trajectory* trajectory, int32_t frame, double time,
                                             size_t* cursor, double* q_out, double* omega_out, double* alpha_out);

/** Samples orientation, angular velocity and acceleration at one time in float: twin of qtraj_sample_rates_at().
 *
 * Computes in single precision, in double where the curve needs it; the place of time between the knots is double. A
 * rate that jumps at a knot has its right-hand value there, at the last knot its left-hand one, unless
 * the curve repeats.
 *
 * @param trajectory  the curve, of double or float keys
 * @param frame       a qtraj_frame_value, of omega_out and alpha_out
 * @param time        s; outside the knots the curve's extrapolation decides
 * @param cursor      a hint of the caller's, any value, 0 to begin: the segment to try first, never changes the result;
 *                    receives the segment used, or stays as it is where there is none; may be NULL
 * @param q_out       [4], w x y z, body to world, unit; may be NULL, but not all three outputs
 * @param omega_out   [3], rad/s; may be NULL, but not all three outputs
 * @param alpha_out   [3], rad/s^2; may be NULL, but not all three outputs
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_VALUE (frame), QTRAJ_E_OVERLAP (of any two outputs): nothing is written;
 *   - QTRAJ_E_NOT_FINITE (time, or a rate too large for float), QTRAJ_E_TIME_RANGE (time outside the knots under
 *     EXTRAPOLATE_ERROR), QTRAJ_E_GAP: every output is NaN */
QTRAJ_API qtraj_status qtraj_sample_rates_at_f32(const qtraj_trajectory* trajectory, int32_t frame, double time,
                                                 size_t* cursor, float* q_out, float* omega_out, float* alpha_out);

/** @} */

/* ---- What a trajectory knows: plain values; 0 or NaN for NULL and for what is no trajectory ---- */

/** @defgroup qtraj-getters What a trajectory knows
 * What the constructor found. Functions that return plain values give 0 or NaN for NULL, and for a handle that is no
 * trajectory.
 * @{ */

/** Method that a trajectory was built with.
 *
 * @param trajectory  may be NULL
 * @return a qtraj_method_value; 0 for NULL */
QTRAJ_API int32_t qtraj_method(const qtraj_trajectory* trajectory);

/** Number of keys, with the one that qtraj_options_set_period() adds.
 *
 * @param trajectory  may be NULL
 * @return 2 or more; 0 for NULL */
QTRAJ_API size_t qtraj_key_count(const qtraj_trajectory* trajectory);

/** First knot.
 *
 * @param trajectory  may be NULL
 * @return s; NaN for NULL */
QTRAJ_API double qtraj_start_time(const qtraj_trajectory* trajectory);

/** Last knot.
 *
 * @param trajectory  may be NULL
 * @return s; NaN for NULL */
QTRAJ_API double qtraj_end_time(const qtraj_trajectory* trajectory);

/** Number of keys whose sign the constructor changed.
 *
 * @param trajectory  may be NULL
 * @return number of keys; 0 for NULL */
QTRAJ_API size_t qtraj_sign_flips(const qtraj_trajectory* trajectory);

/** How far the norms of the keys, as given, were from 1.
 *
 * @param trajectory  may be NULL
 * @return the largest | |q| - 1 |; NaN for NULL */
QTRAJ_API double qtraj_worst_norm_error(const qtraj_trajectory* trajectory);

/** Smallest dot product of neighbouring keys, whatever their signs: the cosine of half the
 * largest step, each taken as the shorter turn.
 *
 * Near 0 a step is close to a half turn, and its direction a matter of rounding.
 *
 * @param trajectory  may be NULL
 * @return 0 to 1; NaN for NULL */
QTRAJ_API double qtraj_least_dot(const qtraj_trajectory* trajectory);

/** Iterations that the constructor took.
 *
 * @param trajectory  may be NULL
 * @return ROTATION_SPLINE: how often its equations were solved, parts of them by their share, rounded up; 0 for all
 *   other methods and for NULL */
QTRAJ_API int32_t qtraj_iterations(const qtraj_trajectory* trajectory);

/** What rounding left of the equations of a ROTATION_SPLINE.
 *
 * @param trajectory  may be NULL
 * @return the largest jump of alpha at a knot, relative to the larger of the largest |alpha| and the largest |omega|/h,
 *   h the length of a segment; 0 for all other methods, NaN for NULL */
QTRAJ_API double qtraj_residual(const qtraj_trajectory* trajectory);

/** Copies the knots and keys as the curve uses them: normalised, of the signs that samples have there.
 *
 * @param trajectory  the curve
 * @param times_out   [key_count], s; may be NULL
 * @param q_out       [key_count][4], w x y z, body to world, unit; may be NULL
 * @return QTRAJ_OK, or QTRAJ_E_NULL (trajectory), QTRAJ_E_HANDLE, QTRAJ_E_OVERLAP (of the two outputs): nothing is
 *   written */
QTRAJ_API qtraj_status qtraj_keys(const qtraj_trajectory* trajectory, double* times_out, double* q_out);

/** Smallest norm of an NLERP, QUATERNION_QUINTIC or QUATERNION_HERMITE before it is normalised, computed by the call.
 *
 * Where it is small, beside 1 or beside the norms of the keys of a QUATERNION_HERMITE, the curve is fast and strongly
 * curved, and rates lose digits.
 *
 * @param trajectory  the curve
 * @param norm        receives the norm; 1 for all other methods
 * @param time        receives the time of it, s, for other methods that of the first knot; may be NULL
 * @return QTRAJ_OK, or QTRAJ_E_NULL (trajectory, norm), QTRAJ_E_HANDLE: nothing is written */
QTRAJ_API qtraj_status qtraj_curve_least_norm(const qtraj_trajectory* trajectory, double* norm, double* time);

/** @} */

/* ---- Curve diagnostics: double only, computed by the call ---- */

/** @defgroup qtraj-curve-diagnostics Curve diagnostics
 * They look at the whole curve between its knots, each segment up to its very ends, in double.
 * @{ */

/** By how much omega and alpha jump at each knot: right-hand minus left-hand value.
 *
 * Rows of the first and the last knot are 0, or where anything is PERIODIC the jump from the end to the start. Without
 * outputs it is OK and does nothing.
 *
 * @param trajectory  the curve
 * @param frame       a qtraj_frame_value, of both outputs
 * @param omega_jump  [key_count][3], rad/s; may be NULL
 * @param alpha_jump  [key_count][3], rad/s^2; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL (trajectory), QTRAJ_E_HANDLE, QTRAJ_E_VALUE (frame), QTRAJ_E_OVERLAP (of the two outputs): nothing
 *     is written;
 *   - QTRAJ_E_NOT_FINITE: a rate overflows: the rows of that knot are NaN, all others are right */
QTRAJ_API qtraj_status qtraj_curve_jumps(const qtraj_trajectory* trajectory, int32_t frame, double* omega_jump,
                                         double* alpha_jump);

/** Greatest lengths of omega and alpha, and when they are reached; only what is asked for is computed.
 *
 * Values of the curve, which it is proven to exceed nowhere by more than 1e-10 relative, or by more than the rounding
 * errors of its rates where these are larger, at most 1e-6. An alpha of less than 1e-12 of the largest |omega|/h, h the
 * length of a segment, is rounding and may be any such value. Ordinary segments take some 10 us, a call at most 1e5
 * pieces of a few us and 300 more for each segment.
 *
 * @param trajectory  the curve
 * @param omega_peak  receives the largest |omega|, rad/s; may be NULL
 * @param omega_time  receives its time, s; may be NULL
 * @param alpha_peak  receives the largest |alpha|, rad/s^2, inside segments; may be NULL
 * @param alpha_time  receives its time, s; may be NULL
 * @return QTRAJ_OK, or QTRAJ_E_NULL (trajectory), QTRAJ_E_HANDLE, QTRAJ_E_NOT_FINITE (a peak overflows),
 *   QTRAJ_E_NO_CONVERGENCE (nothing is proven: it takes more pieces, or rounding leaves too few digits of a rate):
 *   nothing is written */
QTRAJ_API qtraj_status qtraj_curve_peak_rates(const qtraj_trajectory* trajectory, double* omega_peak,
                                              double* omega_time, double* alpha_peak, double* alpha_time);

/** Bounds of |omega| and |alpha| between the first and the last knot, for limits that must hold: never below the true
 * peaks, rounding included, and within 1e-6 of them, relative.
 *
 * For alpha within 1e-12 of the largest |omega|/h besides, see qtraj_curve_peak_rates(), whose work it is.
 *
 * @param trajectory  the curve
 * @param omega       receives the bound of |omega|, rad/s; may be NULL, but not both
 * @param alpha       receives the bound of |alpha|, rad/s^2, inside segments; may be NULL
 * @return as qtraj_curve_peak_rates(), and QTRAJ_E_NULL where both outputs are NULL */
QTRAJ_API qtraj_status qtraj_rate_bounds(const qtraj_trajectory* trajectory, double* omega, double* alpha);

/** Whether rates and steps tell the same: the largest angle between a step and what the rates at its ends make of it.
 *
 * The rates make h times the mean of the two of a step, taken in the body frame in its middle; the step is the rotation
 * that the curve makes of it, turns included. Of good rates the difference is small, of order h^3; half a radian or
 * more says that the rates are not what the caller thinks: degrees for radians, world for body, a wrong sign or order.
 *
 * @param trajectory  the curve; telling for methods with given rates, of all others the rates are the library's own
 * @param angle       receives the angle, rad
 * @param index       receives the index of the step, that of its first key; may be NULL
 * @return QTRAJ_OK, or QTRAJ_E_NULL (trajectory, angle), QTRAJ_E_HANDLE, QTRAJ_E_NOT_FINITE (a rate is past 1e150
 *   rad/s or rad a step): nothing is written */
QTRAJ_API qtraj_status qtraj_rate_mismatch(const qtraj_trajectory* trajectory, double* angle, size_t* index);

/** Integral of |alpha|^2 over the segments; impulses at jumps of the rate are not counted.
 *
 * Proven to 1e-9 relative, but for what rounding makes of an alpha below 1e-12 of the largest |omega|/h. As much work
 * as the peaks.
 *
 * @param trajectory  the curve
 * @param energy      receives the integral, rad^2/s^3
 * @return QTRAJ_OK, or QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_NOT_FINITE (the integral overflows),
 *   QTRAJ_E_NO_CONVERGENCE (nothing is proven, as of peaks): nothing is written */
QTRAJ_API qtraj_status qtraj_curve_energy(const qtraj_trajectory* trajectory, double* energy);

/** Integral of |omega|: the whole way that the curve turns, not the angle between its ends.
 *
 * Proven to 1e-9 relative. Ordinary segments take some 20 us, SQUAD's three times that.
 *
 * @param trajectory  the curve
 * @param angle       receives the integral, rad
 * @return QTRAJ_OK, or QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_NO_CONVERGENCE (nothing is proven, as of peaks): nothing
 *   is written */
QTRAJ_API qtraj_status qtraj_curve_total_angle(const qtraj_trajectory* trajectory, double* angle);

/** @} */

/* ---- Vector curves: positions and other numbers beside a trajectory ---- */

/** @defgroup qtraj-vector-curves Vector curves
 * Curves of vectors of any length, such as positions, beside a trajectory or alone. Knots, order of times, gaps, ends,
 * loops, extrapolation and statuses are those of trajectories; options are made with a qtraj_vector_method_value. Each
 * component is a curve of its own; at a knot it is the key (but for 1e-300 of the largest one), at equal keys without
 * slopes a constant. Sampling never allocates, and has the same bits on every processor.
 * @{ */

/** Builds a vector curve through keys.
 *
 * @param options    of a qtraj_vector_method_value, read during the call
 * @param times      [count], s, strictly increasing: the knots
 * @param values     [count][dim], the keys
 * @param first      [count][dim], 1/s, first derivatives at the keys, for HERMITE and QUINTIC; [2][dim], at the first
 *                   and the last key, for CUBIC with a GIVEN end (the row of another end is not read); else NULL
 * @param second     [count][dim], 1/s^2, second derivatives at the keys, for QUINTIC; else NULL
 * @param count      number of keys, 2 or more
 * @param dim        numbers a key, 1 or more
 * @param out        receives the curve, owned: free it with qtraj_vector_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return QTRAJ_OK, or without a curve
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE (also: options of a trajectory's method), QTRAJ_E_TOO_FEW (count or dim),
 *     QTRAJ_E_SIZE, QTRAJ_E_INPUT_MISSING, QTRAJ_E_INPUT_UNWANTED (first or second), QTRAJ_E_NO_MEMORY;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the key at bad_index;
 *   - QTRAJ_E_RATE_TOO_FAST: a derivative of the key at bad_index, for an interval beside it;
 *   - QTRAJ_E_NOT_CLOSED: PERIODIC ends or extrapolation, and the last key, at bad_index, does not return to the
 *     first */
QTRAJ_API qtraj_status qtraj_vector_create(const qtraj_options* options, const double* times, const double* values,
                                           const double* first, const double* second, size_t count, size_t dim,
                                           qtraj_vector_curve** out, size_t* bad_index);

/** Builds a vector curve through keys of float: twin of qtraj_vector_create().
 *
 * Values and derivatives are read as float, the times as double, and the curve is built in double.
 *
 * @param options    of a qtraj_vector_method_value, read during the call
 * @param times      [count], s, strictly increasing: the knots
 * @param values     [count][dim], the keys
 * @param first      [count][dim], 1/s, first derivatives at the keys, for HERMITE and QUINTIC; [2][dim], at the first
 *                   and the last key, for CUBIC with a GIVEN end (the row of another end is not read); else NULL
 * @param second     [count][dim], 1/s^2, second derivatives at the keys, for QUINTIC; else NULL
 * @param count      number of keys, 2 or more
 * @param dim        numbers a key, 1 or more
 * @param out        receives the curve, owned: free it with qtraj_vector_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return as qtraj_vector_create() */
QTRAJ_API qtraj_status qtraj_vector_create_f32(const qtraj_options* options, const double* times, const float* values,
                                               const float* first, const float* second, size_t count, size_t dim,
                                               qtraj_vector_curve** out, size_t* bad_index);

/** Bytes that qtraj_vector_init() and qtraj_vector_init_f32() need, working space included.
 *
 * @param options  of a qtraj_vector_method_value, read during the call
 * @param count    number of keys, 2 or more
 * @param dim      numbers a key, 1 or more
 * @param bytes    receives the number of bytes
 * @return QTRAJ_OK, or QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE: nothing is written */
QTRAJ_API qtraj_status qtraj_vector_init_size(const qtraj_options* options, size_t count, size_t dim, size_t* bytes);

/** Builds a vector curve through keys in the caller's memory; nothing is allocated.
 *
 * @param memory     [bytes], aligned to 8 bytes, overlapping no input; must outlive the curve and stay in place
 * @param bytes      qtraj_vector_init_size() of the same options, count and dim, or more
 * @param options    of a qtraj_vector_method_value, read during the call
 * @param times      [count], s, strictly increasing: the knots
 * @param values     [count][dim], the keys
 * @param first      as of qtraj_vector_create()
 * @param second     as of qtraj_vector_create()
 * @param count      number of keys, 2 or more
 * @param dim        numbers a key, 1 or more
 * @param out        receives the curve, which needs no qtraj_vector_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return as qtraj_vector_create(), without NO_MEMORY, and QTRAJ_E_BUFFER (memory too small or not aligned),
 *   QTRAJ_E_OVERLAP: memory is untouched */
QTRAJ_API qtraj_status qtraj_vector_init(void* memory, size_t bytes, const qtraj_options* options, const double* times,
                                         const double* values, const double* first, const double* second, size_t count,
                                         size_t dim, qtraj_vector_curve** out, size_t* bad_index);

/** Builds a vector curve through keys of float in the caller's memory: twin of qtraj_vector_init().
 *
 * @param memory     [bytes], aligned to 8 bytes, overlapping no input; must outlive the curve and stay in place
 * @param bytes      qtraj_vector_init_size() of the same options, count and dim, or more
 * @param options    of a qtraj_vector_method_value, read during the call
 * @param times      [count], s, strictly increasing: the knots
 * @param values     [count][dim], the keys
 * @param first      as of qtraj_vector_create_f32()
 * @param second     as of qtraj_vector_create_f32()
 * @param count      number of keys, 2 or more
 * @param dim        numbers a key, 1 or more
 * @param out        receives the curve, which needs no qtraj_vector_destroy(); NULL on every error
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where it is not one key; may be NULL
 * @return as qtraj_vector_init() */
QTRAJ_API qtraj_status qtraj_vector_init_f32(void* memory, size_t bytes, const qtraj_options* options,
                                             const double* times, const float* values, const float* first,
                                             const float* second, size_t count, size_t dim, qtraj_vector_curve** out,
                                             size_t* bad_index);

/** Ends the life of a vector curve, and frees one on the heap. Used after it, it is QTRAJ_E_HANDLE.
 *
 * @param curve  memory of qtraj_vector_init() stays the caller's; NULL and what is no vector curve are left alone */
QTRAJ_API void qtraj_vector_destroy(qtraj_vector_curve* curve);

/** Samples vectors and their derivatives at many times.
 *
 * A derivative that jumps at a knot has its right-hand value there, at the last knot its left-hand one, unless the
 * curve repeats.
 *
 * @param curve       the curve; not NULL, also where count is 0
 * @param times       [count], s, in any order; outside the knots the curve's extrapolation decides
 * @param count       number of samples; where it is 0 arrays may be NULL
 * @param value_out   [count][dim]; may be NULL, but not all three outputs
 * @param first_out   [count][dim], 1/s; may be NULL, but not all three outputs
 * @param second_out  [count][dim], 1/s^2; may be NULL, but not all three outputs
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP (of any two arrays): nothing is written;
 *   - QTRAJ_E_NOT_FINITE (a time, or a number that overflows), QTRAJ_E_TIME_RANGE (a time outside the knots under
 *     EXTRAPOLATE_ERROR), QTRAJ_E_GAP: that row is NaN in every output, all others are right */
QTRAJ_API qtraj_status qtraj_vector_sample(const qtraj_vector_curve* curve, const double* times, size_t count,
                                           double* value_out, double* first_out, double* second_out, size_t* bad_index);

/** Samples vectors and their derivatives at many times into float: twin of qtraj_vector_sample().
 *
 * Computes in double and rounds once.
 *
 * @param curve       the curve, of double or float keys; not NULL, also where count is 0
 * @param times       [count], s, in any order; outside the knots the curve's extrapolation decides
 * @param count       number of samples; where it is 0 arrays may be NULL
 * @param value_out   [count][dim]; may be NULL, but not all three outputs
 * @param first_out   [count][dim], 1/s; may be NULL, but not all three outputs
 * @param second_out  [count][dim], 1/s^2; may be NULL, but not all three outputs
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return as qtraj_vector_sample(); NOT_FINITE also for a number too large for float */
QTRAJ_API qtraj_status qtraj_vector_sample_f32(const qtraj_vector_curve* curve, const double* times, size_t count,
                                               float* value_out, float* first_out, float* second_out,
                                               size_t* bad_index);

/** Samples vectors and their derivatives at a fixed rate: at start + (double)i * step, rounded twice.
 *
 * @param curve       the curve; not NULL, also where count is 0
 * @param start       s, time of row 0
 * @param step        s, from row to row; may be 0 or negative
 * @param count       number of samples, as of qtraj_vector_uniform_count(); where it is 0 outputs may be NULL
 * @param value_out   [count][dim]; may be NULL, but not all three outputs
 * @param first_out   [count][dim], 1/s; may be NULL, but not all three outputs
 * @param second_out  [count][dim], 1/s^2; may be NULL, but not all three outputs
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return as qtraj_vector_sample() */
QTRAJ_API qtraj_status qtraj_vector_sample_uniform(const qtraj_vector_curve* curve, double start, double step,
                                                   size_t count, double* value_out, double* first_out,
                                                   double* second_out, size_t* bad_index);

/** Samples vectors and their derivatives at a fixed rate into float: twin of qtraj_vector_sample_uniform().
 *
 * @param curve       the curve, of double or float keys; not NULL, also where count is 0
 * @param start       s, time of row 0
 * @param step        s, from row to row; may be 0 or negative
 * @param count       number of samples, as of qtraj_vector_uniform_count(); where it is 0 outputs may be NULL
 * @param value_out   [count][dim]; may be NULL, but not all three outputs
 * @param first_out   [count][dim], 1/s; may be NULL, but not all three outputs
 * @param second_out  [count][dim], 1/s^2; may be NULL, but not all three outputs
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return as qtraj_vector_sample_f32() */
QTRAJ_API qtraj_status qtraj_vector_sample_uniform_f32(const qtraj_vector_curve* curve, double start, double step,
                                                       size_t count, float* value_out, float* first_out,
                                                       float* second_out, size_t* bad_index);

/** Samples a vector and its derivatives at one time, for control loops.
 *
 * @param curve       the curve
 * @param time        s; outside the knots the curve's extrapolation decides
 * @param cursor      a hint of the caller's, any value, 0 to begin: the segment to try first, never changes the result;
 *                    receives the segment used, or stays as it is where there is none; may be NULL
 * @param value_out   [dim]; may be NULL, but not all three outputs
 * @param first_out   [dim], 1/s; may be NULL, but not all three outputs
 * @param second_out  [dim], 1/s^2; may be NULL, but not all three outputs
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_OVERLAP (of any two outputs): nothing is written;
 *   - QTRAJ_E_NOT_FINITE (time, or a number that overflows), QTRAJ_E_TIME_RANGE (time outside the knots under
 *     EXTRAPOLATE_ERROR), QTRAJ_E_GAP: every output is NaN */
QTRAJ_API qtraj_status qtraj_vector_sample_at(const qtraj_vector_curve* curve, double time, size_t* cursor,
                                              double* value_out, double* first_out, double* second_out);

/** Samples a vector and its derivatives at one time into float: twin of qtraj_vector_sample_at().
 *
 * @param curve       the curve, of double or float keys
 * @param time        s; outside the knots the curve's extrapolation decides
 * @param cursor      a hint of the caller's, any value, 0 to begin: the segment to try first, never changes the result;
 *                    receives the segment used, or stays as it is where there is none; may be NULL
 * @param value_out   [dim]; may be NULL, but not all three outputs
 * @param first_out   [dim], 1/s; may be NULL, but not all three outputs
 * @param second_out  [dim], 1/s^2; may be NULL, but not all three outputs
 * @return as qtraj_vector_sample_at(); NOT_FINITE also for a number too large for float */
QTRAJ_API qtraj_status qtraj_vector_sample_at_f32(const qtraj_vector_curve* curve, double time, size_t* cursor,
                                                  float* value_out, float* first_out, float* second_out);

/** Number of samples at a fixed rate that lie within the knots: the count for qtraj_vector_sample_uniform().
 *
 * @param curve  the curve
 * @param start  s, time of row 0, within the knots
 * @param step   s, from row to row; may be negative
 * @param count  receives the number, 1 or more; 0 on every error
 * @return as qtraj_uniform_count() */
QTRAJ_API qtraj_status qtraj_vector_uniform_count(const qtraj_vector_curve* curve, double start, double step,
                                                  size_t* count);

/** Method that a vector curve was built with.
 *
 * @param curve  may be NULL
 * @return a qtraj_vector_method_value; 0 for NULL */
QTRAJ_API int32_t qtraj_vector_method(const qtraj_vector_curve* curve);

/** Number of keys, with the one that qtraj_options_set_period() adds.
 *
 * @param curve  may be NULL
 * @return 2 or more; 0 for NULL */
QTRAJ_API size_t qtraj_vector_key_count(const qtraj_vector_curve* curve);

/** Numbers in a key.
 *
 * @param curve  may be NULL
 * @return 1 or more; 0 for NULL */
QTRAJ_API size_t qtraj_vector_dim(const qtraj_vector_curve* curve);

/** First knot.
 *
 * @param curve  may be NULL
 * @return s; NaN for NULL */
QTRAJ_API double qtraj_vector_start_time(const qtraj_vector_curve* curve);

/** Last knot.
 *
 * @param curve  may be NULL
 * @return s; NaN for NULL */
QTRAJ_API double qtraj_vector_end_time(const qtraj_vector_curve* curve);

/** Copies the knots and keys as the curve uses them.
 *
 * @param curve       the curve
 * @param times_out   [key_count], s; may be NULL
 * @param values_out  [key_count][dim]; may be NULL
 * @return QTRAJ_OK, or QTRAJ_E_NULL (curve), QTRAJ_E_HANDLE, QTRAJ_E_OVERLAP (of the two outputs): nothing is
 *   written */
QTRAJ_API qtraj_status qtraj_vector_keys(const qtraj_vector_curve* curve, double* times_out, double* values_out);

/** @} */

/* ---- Whole poses ---- */

/** @defgroup qtraj-poses Poses
 * Orientations and positions at the same times.
 * @{ */

/** Samples orientations and positions, and their rates, at the same times.
 *
 * A row that one of the two curves has no value for is NaN in every output, so that a pose is whole or missing.
 *
 * @param trajectory  the curve of orientations; not NULL, also where count is 0
 * @param positions   the curve of positions, of any dim; the same
 * @param frame       a qtraj_frame_value, of omega_out and alpha_out
 * @param times       [count], s, in any order
 * @param count       number of samples; where it is 0 arrays may be NULL
 * @param q_out       [count][4], w x y z, body to world, unit; may be NULL, but not all outputs
 * @param omega_out   [count][3], rad/s; may be NULL
 * @param alpha_out   [count][3], rad/s^2; may be NULL
 * @param p_out       [count][dim]; may be NULL
 * @param v_out       [count][dim], 1/s, first derivative; may be NULL
 * @param a_out       [count][dim], 1/s^2, second derivative; may be NULL
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_OVERLAP (of any two arrays): nothing
 *     is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_TIME_RANGE, QTRAJ_E_GAP, of the trajectory or else of the positions: that row is NaN
 *     in every output, all others are right */
QTRAJ_API qtraj_status qtraj_sample_poses(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions,
                                          int32_t frame, const double* times, size_t count, double* q_out,
                                          double* omega_out, double* alpha_out, double* p_out, double* v_out,
                                          double* a_out, size_t* bad_index);

/** Samples orientations and positions, and their rates, into float: twin of qtraj_sample_poses().
 *
 * @param trajectory  the curve of orientations; not NULL, also where count is 0
 * @param positions   the curve of positions, of any dim; the same
 * @param frame       a qtraj_frame_value, of omega_out and alpha_out
 * @param times       [count], s, in any order
 * @param count       number of samples; where it is 0 arrays may be NULL
 * @param q_out       [count][4], w x y z, body to world, unit; may be NULL, but not all outputs
 * @param omega_out   [count][3], rad/s; may be NULL
 * @param alpha_out   [count][3], rad/s^2; may be NULL
 * @param p_out       [count][dim]; may be NULL
 * @param v_out       [count][dim], 1/s, first derivative; may be NULL
 * @param a_out       [count][dim], 1/s^2, second derivative; may be NULL
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return as qtraj_sample_poses(); NOT_FINITE also for a number too large for float */
QTRAJ_API qtraj_status qtraj_sample_poses_f32(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions,
                                              int32_t frame, const double* times, size_t count, float* q_out,
                                              float* omega_out, float* alpha_out, float* p_out, float* v_out,
                                              float* a_out, size_t* bad_index);

/** Samples orientation and position, and their rates, at one time, for control loops.
 *
 * @param trajectory  the curve of orientations
 * @param positions   the curve of positions, of any dim
 * @param frame       a qtraj_frame_value, of omega_out and alpha_out
 * @param time        s
 * @param cursor      a hint of the caller's, any value, 0 to begin: the segment of the trajectory to try first, and
 *                    that of the positions: it serves both where they have the same knots; never changes the result;
 *                    may be NULL
 * @param q_out       [4], w x y z, body to world, unit; may be NULL, but not all outputs
 * @param omega_out   [3], rad/s; may be NULL
 * @param alpha_out   [3], rad/s^2; may be NULL
 * @param p_out       [dim]; may be NULL
 * @param v_out       [dim], 1/s, first derivative; may be NULL
 * @param a_out       [dim], 1/s^2, second derivative; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_VALUE (frame), QTRAJ_E_OVERLAP (of any two outputs): nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_TIME_RANGE, QTRAJ_E_GAP, of the trajectory or else of the positions: every output is
 *     NaN */
QTRAJ_API qtraj_status qtraj_sample_pose_at(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions,
                                            int32_t frame, double time, size_t* cursor, double* q_out,
                                            double* omega_out, double* alpha_out, double* p_out, double* v_out,
                                            double* a_out);

/** Samples orientation and position, and their rates, at one time into float: twin of qtraj_sample_pose_at().
 *
 * @param trajectory  the curve of orientations
 * @param positions   the curve of positions, of any dim
 * @param frame       a qtraj_frame_value, of omega_out and alpha_out
 * @param time        s
 * @param cursor      as of qtraj_sample_pose_at()
 * @param q_out       [4], w x y z, body to world, unit; may be NULL, but not all outputs
 * @param omega_out   [3], rad/s; may be NULL
 * @param alpha_out   [3], rad/s^2; may be NULL
 * @param p_out       [dim]; may be NULL
 * @param v_out       [dim], 1/s, first derivative; may be NULL
 * @param a_out       [dim], 1/s^2, second derivative; may be NULL
 * @return as qtraj_sample_pose_at(); NOT_FINITE also for a number too large for float */
QTRAJ_API qtraj_status qtraj_sample_pose_at_f32(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions,
                                                int32_t frame, double time, size_t* cursor, float* q_out,
                                                float* omega_out, float* alpha_out, float* p_out, float* v_out,
                                                float* a_out);

/** @} */

/* ---- Many curves: series of rows in shared arrays, told apart by offsets ---- */

/** @defgroup qtraj-batches Many curves
 * Tables of recordings: each series has its keys, and its samples, one after the other in arrays that all share. Series
 * k has the rows from offsets[k] up to offsets[k + 1], as the lists of Arrow, Parquet and their kin have them
 * (LargeList). Arrays are indexed by the offsets as they are: where the first one is not 0, as in a slice of a table,
 * rows before it are neither read nor written, nor are those from the last one on.
 *
 * Each series gives what it would alone, to the last bit. One at fault has a status of its own, and rows of NaN, and is
 * no harm to the others; the call returns the status of the first. TOO_FEW, VALUE (of a step) or SIZE is then its
 * fault where bad_index has its index, and else a mistake of the call. Offsets and arrays may be NULL where count is 0,
 * arrays also where no series has a row.
 *
 * Nothing here starts a thread. Offsets split without a copy: series k up to k + n are a call of its own with
 * key_offsets + k, sample_offsets + k, status_out + k, count n and all other arrays as they are.
 * @{ */

/** Samples many curves, each of a series of keys: qtraj_init() and qtraj_sample() of each in one call.
 *
 * @param options         method and settings, read during the call; none that need rates, turns or tangents
 * @param count           number of series
 * @param key_offsets     [count + 1], rows of the first key of each series and, last, of the end of the last
 * @param key_times       s, of each series strictly increasing: its knots
 * @param key_q_wb        [][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param sample_offsets  [count + 1], rows of the first sample of each series and, last, of the end of the last
 * @param sample_times    s, in any order; NULL: of each series evenly from its first to its last key, a closing one of
 *                        qtraj_options_set_period() included, both exact, as of qtraj_even_times()
 * @param memory          [bytes], aligned to 8 bytes; may overlap no other array; NULL: allocated, once
 * @param bytes           qtraj_init_size() of the longest series, or more, of which even times use 4 kB; ignored where
 *                        memory is NULL
 * @param q_out           [][4], w x y z, body to world, unit; may overlap no other array
 * @param status_out      [count], the status of each series; may overlap no other array; may be NULL
 * @param bad_index       receives the index of the first series at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_COUNT (offsets that are negative or decrease, with the index of the first
 *     series), QTRAJ_E_SIZE, QTRAJ_E_INPUT_MISSING, QTRAJ_E_BUFFER (memory too small or not aligned), QTRAJ_E_OVERLAP,
 *     QTRAJ_E_NO_MEMORY: nothing is written;
 *   - what qtraj_init() says of the keys of the series at bad_index, AMBIGUOUS too, and QTRAJ_E_TOO_FEW where it has
 *     fewer than 2: all its rows are NaN, those of all other series are right;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_TIME_RANGE, QTRAJ_E_GAP: samples of that series, as of qtraj_sample(): their rows are
 *     NaN, all others are right */
QTRAJ_API qtraj_status qtraj_batch_sample(const qtraj_options* options, size_t count, const int64_t* key_offsets,
                                          const double* key_times, const double* key_q_wb,
                                          const int64_t* sample_offsets, const double* sample_times, void* memory,
                                          size_t bytes, double* q_out, int32_t* status_out, size_t* bad_index);

/** Samples many curves in float, each of a series of keys: twin of qtraj_batch_sample().
 *
 * The keys are read as float, the times as double, curves are built in double and sampled as by qtraj_sample_f32().
 *
 * @param options         method and settings, read during the call; none that need rates, turns or tangents
 * @param count           number of series
 * @param key_offsets     [count + 1], rows of the first key of each series and, last, of the end of the last
 * @param key_times       s, of each series strictly increasing: its knots
 * @param key_q_wb        [][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param sample_offsets  [count + 1], rows of the first sample of each series and, last, of the end of the last
 * @param sample_times    s, in any order; NULL: of each series evenly from its first to its last key, a closing one of
 *                        qtraj_options_set_period() included, both exact, as of qtraj_even_times()
 * @param memory          [bytes], aligned to 8 bytes; may overlap no other array; NULL: allocated, once
 * @param bytes           qtraj_init_size() of the longest series, or more, of which even times use 4 kB; ignored where
 *                        memory is NULL
 * @param q_out           [][4], w x y z, body to world, unit; may overlap no other array
 * @param status_out      [count], the status of each series; may overlap no other array; may be NULL
 * @param bad_index       receives the index of the first series at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_COUNT (offsets that are negative or decrease, with the index of the first
 *     series), QTRAJ_E_SIZE, QTRAJ_E_INPUT_MISSING, QTRAJ_E_BUFFER (memory too small or not aligned), QTRAJ_E_OVERLAP,
 *     QTRAJ_E_NO_MEMORY: nothing is written;
 *   - what qtraj_init_f32() says of the keys of the series at bad_index, AMBIGUOUS too, and QTRAJ_E_TOO_FEW where it
 *     has fewer than 2: all its rows are NaN, those of all other series are right;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_TIME_RANGE, QTRAJ_E_GAP: samples of that series, as of qtraj_sample_f32(): their rows
 *     are NaN, all others are right */
QTRAJ_API qtraj_status qtraj_batch_sample_f32(const qtraj_options* options, size_t count, const int64_t* key_offsets,
                                              const double* key_times, const float* key_q_wb,
                                              const int64_t* sample_offsets, const double* sample_times, void* memory,
                                              size_t bytes, float* q_out, int32_t* status_out, size_t* bad_index);

/** Samples many curves with rates: given at the keys, wanted in the samples, or both.
 *
 * @param options         method and settings, read during the call; none that need turns or tangents
 * @param frame           a qtraj_frame_value, of all rates
 * @param count           number of series
 * @param key_offsets     [count + 1], rows of the first key of each series and, last, of the end of the last
 * @param key_times       s, of each series strictly increasing: its knots
 * @param key_q_wb        [][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param key_omega       [][3], rad/s, at the keys, for HERMITE, the quintics, SQUAD with TANGENT_GIVEN; else NULL
 * @param key_alpha       [][3], rad/s^2, at the keys, for the quintics; else NULL
 * @param sample_offsets  [count + 1], rows of the first sample of each series and, last, of the end of the last
 * @param sample_times    s, in any order; NULL: of each series evenly from its first to its last key, a closing one of
 *                        qtraj_options_set_period() included, both exact, as of qtraj_even_times()
 * @param memory          [bytes], aligned to 8 bytes; may overlap no other array; NULL: allocated, once
 * @param bytes           qtraj_init_size() of the longest series, or more, of which even times use 4 kB; ignored where
 *                        memory is NULL
 * @param q_out           [][4], w x y z, body to world, unit; may be NULL, but not all three outputs
 * @param omega_out       [][3], rad/s; may be NULL, but not all three outputs
 * @param alpha_out       [][3], rad/s^2; may be NULL, but not all three outputs
 * @param status_out      [count], the status of each series; may overlap no other array; may be NULL
 * @param bad_index       receives the index of the first series at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_COUNT (offsets that are negative or decrease, with the index of the first
 *     series), QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_INPUT_MISSING, QTRAJ_E_INPUT_UNWANTED, QTRAJ_E_BUFFER
 *     (memory too small or not aligned), QTRAJ_E_OVERLAP, QTRAJ_E_NO_MEMORY: nothing is written;
 *   - what qtraj_init() says of the keys of the series at bad_index, AMBIGUOUS too, and QTRAJ_E_TOO_FEW where it has
 *     fewer than 2: all its rows are NaN, those of all other series are right;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_TIME_RANGE, QTRAJ_E_GAP: samples of that series, as of qtraj_sample_rates(): their
 *     rows are NaN, all others are right */
QTRAJ_API qtraj_status qtraj_batch_sample_rates(const qtraj_options* options, int32_t frame, size_t count,
                                                const int64_t* key_offsets, const double* key_times,
                                                const double* key_q_wb, const double* key_omega,
                                                const double* key_alpha, const int64_t* sample_offsets,
                                                const double* sample_times, void* memory, size_t bytes, double* q_out,
                                                double* omega_out, double* alpha_out, int32_t* status_out,
                                                size_t* bad_index);

/** Samples many curves with rates in float: twin of qtraj_batch_sample_rates().
 *
 * Keys and rates are read as float, the times as double, curves are built in double and sampled as by
 * qtraj_sample_rates_f32().
 *
 * @param options         method and settings, read during the call; none that need turns or tangents
 * @param frame           a qtraj_frame_value, of all rates
 * @param count           number of series
 * @param key_offsets     [count + 1], rows of the first key of each series and, last, of the end of the last
 * @param key_times       s, of each series strictly increasing: its knots
 * @param key_q_wb        [][4], w x y z, body to world, the keys; any norm but 0, any sign
 * @param key_omega       [][3], rad/s, at the keys, for HERMITE, the quintics, SQUAD with TANGENT_GIVEN; else NULL
 * @param key_alpha       [][3], rad/s^2, at the keys, for the quintics; else NULL
 * @param sample_offsets  [count + 1], rows of the first sample of each series and, last, of the end of the last
 * @param sample_times    s, in any order; NULL: of each series evenly from its first to its last key, a closing one of
 *                        qtraj_options_set_period() included, both exact, as of qtraj_even_times()
 * @param memory          [bytes], aligned to 8 bytes; may overlap no other array; NULL: allocated, once
 * @param bytes           qtraj_init_size() of the longest series, or more, of which even times use 4 kB; ignored where
 *                        memory is NULL
 * @param q_out           [][4], w x y z, body to world, unit; may be NULL, but not all three outputs
 * @param omega_out       [][3], rad/s; may be NULL, but not all three outputs
 * @param alpha_out       [][3], rad/s^2; may be NULL, but not all three outputs
 * @param status_out      [count], the status of each series; may overlap no other array; may be NULL
 * @param bad_index       receives the index of the first series at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_HANDLE, QTRAJ_E_COUNT (offsets that are negative or decrease, with the index of the first
 *     series), QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_INPUT_MISSING, QTRAJ_E_INPUT_UNWANTED, QTRAJ_E_BUFFER
 *     (memory too small or not aligned), QTRAJ_E_OVERLAP, QTRAJ_E_NO_MEMORY: nothing is written;
 *   - what qtraj_init_f32() says of the keys of the series at bad_index, AMBIGUOUS too, and QTRAJ_E_TOO_FEW where it
 *     has fewer than 2: all its rows are NaN, those of all other series are right;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_TIME_RANGE, QTRAJ_E_GAP: samples of that series, as of qtraj_sample_rates_f32():
 *     their rows are NaN, all others are right */
QTRAJ_API qtraj_status qtraj_batch_sample_rates_f32(const qtraj_options* options, int32_t frame, size_t count,
                                                    const int64_t* key_offsets, const double* key_times,
                                                    const float* key_q_wb, const float* key_omega,
                                                    const float* key_alpha, const int64_t* sample_offsets,
                                                    const double* sample_times, void* memory, size_t bytes,
                                                    float* q_out, float* omega_out, float* alpha_out,
                                                    int32_t* status_out, size_t* bad_index);

/** Offsets of samples at a fixed step: how many rows of each series lie within its keys.
 *
 * Row i of a series is at its first key time + (double)i * step, rounded twice; the last row is the last one that
 * counts as within the keys, as of qtraj_uniform_count(). qtraj_batch_times() makes these times.
 *
 * @param count               number of series
 * @param key_offsets         [count + 1], rows of the first key of each series and, last, of the end of the last
 * @param key_times           s; of each series only the first and the last are read
 * @param step                [step_count], s, above 0
 * @param step_count          1 or count
 * @param sample_offsets_out  [count + 1], from 0 on; may overlap no other array; where count is 0 it may be NULL
 * @param status_out          [count], the status of each series; may overlap no other array; may be NULL
 * @param bad_index           receives the index of the first series at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT (step_count; offsets that are negative or decrease, with the index of the first
 *     series), QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_TOO_FEW (fewer than 2 keys), QTRAJ_E_VALUE (its step is 0 or below), QTRAJ_E_SIZE (more than 2^53 rows,
 *     or together more than an array can have), QTRAJ_E_NOT_FINITE, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the series
 *     at bad_index; it has no rows, all others are right */
QTRAJ_API qtraj_status qtraj_batch_step_offsets(size_t count, const int64_t* key_offsets, const double* key_times,
                                                const double* step, size_t step_count, int64_t* sample_offsets_out,
                                                int32_t* status_out, size_t* bad_index);

/** Times at a fixed step from the first key of each series on, at the rows of qtraj_batch_step_offsets() or others.
 *
 * @param count           number of series
 * @param key_offsets     [count + 1], rows of the first key of each series and, last, of the end of the last
 * @param key_times       s; of each series only the first and the last are read
 * @param step            [step_count], s, above 0
 * @param step_count      1 or count
 * @param sample_offsets  [count + 1], rows of the first time of each series and, last, of the end of the last; a series
 *                        may have more rows than lie within its keys, or fewer
 * @param times_out       s, at the rows of sample_offsets; may overlap no other array
 * @param status_out      [count], the status of each series; may overlap no other array; may be NULL
 * @param bad_index       receives the index of the first series at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT (step_count; offsets that are negative or decrease, with the index of the first
 *     series), QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_TOO_FEW (fewer than 2 keys), QTRAJ_E_VALUE (its step is 0 or below), QTRAJ_E_NOT_FINITE,
 *     QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the series at bad_index; its rows are NaN, all others are right;
 *   - QTRAJ_E_NOT_FINITE, a time of that series that overflows: its row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_batch_times(size_t count, const int64_t* key_offsets, const double* key_times,
                                         const double* step, size_t step_count, const int64_t* sample_offsets,
                                         double* times_out, int32_t* status_out, size_t* bad_index);

/** Eigen means of many groups of samples: qtraj_mean_eigen() of each, to the last bit.
 *
 * @param count       number of groups
 * @param offsets     [count + 1], rows of the first sample of each group and, last, of the end of the last
 * @param q           [][4], w x y z, of any norm but 0
 * @param weights     0 or more, not all 0 in a group; NULL: all 1
 * @param mean_out    [count][4], w x y z, unit; may overlap no other array
 * @param eigengap    [count], (l1 - l2) / trace, the two largest eigenvalues, in [0, 1]; may overlap no other array;
 *                    may be NULL
 * @param status_out  [count], the status of each group; may overlap no other array; may be NULL
 * @param bad_index   receives the index of the first group at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT (offsets that are negative or decrease, with the index of the first group),
 *     QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_TOO_FEW (no samples), QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (also: all weights are 0),
 *     QTRAJ_E_NEGATIVE_WEIGHT: the group at bad_index; its mean and eigengap are NaN, all others are right;
 *   - QTRAJ_E_AMBIGUOUS: the two largest eigenvalues of that group tie, to 64 eps of double; its mean is one of the
 *     best */
QTRAJ_API qtraj_status qtraj_batch_mean_eigen(size_t count, const int64_t* offsets, const double* q,
                                              const double* weights, double* mean_out, double* eigengap,
                                              int32_t* status_out, size_t* bad_index);

/** Eigen means of many groups of samples of float: twin of qtraj_batch_mean_eigen().
 *
 * Samples and weights are read as float, sums are taken in double, means rounded once.
 *
 * @param count       number of groups
 * @param offsets     [count + 1], rows of the first sample of each group and, last, of the end of the last
 * @param q           [][4], w x y z, of any norm but 0
 * @param weights     0 or more, not all 0 in a group; NULL: all 1
 * @param mean_out    [count][4], w x y z, unit; may overlap no other array
 * @param eigengap    [count], (l1 - l2) / trace, the two largest eigenvalues, in [0, 1]; may overlap no other array;
 *                    may be NULL
 * @param status_out  [count], the status of each group; may overlap no other array; may be NULL
 * @param bad_index   receives the index of the first group at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT (offsets that are negative or decrease, with the index of the first group),
 *     QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_TOO_FEW (no samples), QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (also: all weights are 0),
 *     QTRAJ_E_NEGATIVE_WEIGHT: the group at bad_index; its mean and eigengap are NaN, all others are right;
 *   - QTRAJ_E_AMBIGUOUS: the two largest eigenvalues of that group tie, to 64 eps of float; its mean is one of the best
 */
QTRAJ_API qtraj_status qtraj_batch_mean_eigen_f32(size_t count, const int64_t* offsets, const float* q,
                                                  const float* weights, float* mean_out, double* eigengap,
                                                  int32_t* status_out, size_t* bad_index);

/** @} */

/* ---- Pairs: inputs of any norm but 0; any real fraction ---- */

/** @defgroup qtraj-pairs Pairs
 * Between two quaternions of any norm but 0, at any real fraction: 0 is a, 1 is b, others are between or beyond.
 * @{ */

/** Slerp of one pair at many fractions: the arc from a to b at constant rate.
 *
 * AS_GIVEN with b = -a, to 1e-14 rad, is a full turn about no known axis: AMBIGUOUS, the body turns about its x axis.
 *
 * @param a          [4], w x y z, of any norm but 0: fraction 0
 * @param b          [4], w x y z, of any norm but 0: fraction 1
 * @param fraction   [count], any real numbers
 * @param count      number of fractions; where it is 0 arrays may be NULL
 * @param path       QTRAJ_PATH_SHORTEST or QTRAJ_PATH_AS_GIVEN
 * @param q_out      [count][4], w x y z, unit; may not overlap an input, but where count is 1 may be a or b
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_VALUE (path), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE: a fraction: that row is NaN, all others are right;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: a or b, which is a fault of every row: all are NaN;
 *   - QTRAJ_E_AMBIGUOUS: opposite a and b; rows hold the turn about x */
QTRAJ_API qtraj_status qtraj_slerp(const double* a, const double* b, const double* fraction, size_t count, int32_t path,
                                   double* q_out, size_t* bad_index);

/** Slerp of one pair at many fractions in float: twin of qtraj_slerp().
 *
 * Computed in double and rounded once.
 *
 * AS_GIVEN with b = -a, to 1e-14 rad, is a full turn about no known axis: AMBIGUOUS, the body turns about its x axis.
 *
 * @param a          [4], w x y z, of any norm but 0: fraction 0
 * @param b          [4], w x y z, of any norm but 0: fraction 1
 * @param fraction   [count], any real numbers
 * @param count      number of fractions; where it is 0 arrays may be NULL
 * @param path       QTRAJ_PATH_SHORTEST or QTRAJ_PATH_AS_GIVEN
 * @param q_out      [count][4], w x y z, unit; may not overlap an input, but where count is 1 may be a or b
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_VALUE (path), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE: a fraction: that row is NaN, all others are right;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: a or b, which is a fault of every row: all are NaN;
 *   - QTRAJ_E_AMBIGUOUS: opposite a and b; rows hold the turn about x */
QTRAJ_API qtraj_status qtraj_slerp_f32(const float* a, const float* b, const float* fraction, size_t count,
                                       int32_t path, float* q_out, size_t* bad_index);

/** Slerp pair by pair: the arcs from a to b at constant rate; ends and fractions are one for all or one for each.
 *
 * AS_GIVEN with b = -a, to 1e-14 rad, is a full turn about no known axis: AMBIGUOUS, the body turns about its x axis.
 *
 * @param a               [a_count][4], w x y z, of any norm but 0: fraction 0
 * @param a_count         1 or count
 * @param b               [b_count][4], w x y z, of any norm but 0: fraction 1
 * @param b_count         1 or count
 * @param fraction        [fraction_count], any real numbers
 * @param fraction_count  1 or count
 * @param count           number of pairs; where it is 0 arrays may be NULL
 * @param path            QTRAJ_PATH_SHORTEST or QTRAJ_PATH_AS_GIVEN
 * @param q_out           [count][4], w x y z, unit; may be an a or b of count rows
 * @param bad_index       receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_VALUE (path), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (a or b): that row is NaN, all others are right;
 *   - QTRAJ_E_AMBIGUOUS: opposite a and b; that row holds the turn about x */
QTRAJ_API qtraj_status qtraj_slerp_pairs(const double* a, size_t a_count, const double* b, size_t b_count,
                                         const double* fraction, size_t fraction_count, size_t count, int32_t path,
                                         double* q_out, size_t* bad_index);

/** Slerp pair by pair in float: twin of qtraj_slerp_pairs().
 *
 * Computed in double and rounded once. Ends and fractions are one for all or one for each.
 *
 * AS_GIVEN with b = -a, to 1e-14 rad, is a full turn about no known axis: AMBIGUOUS, the body turns about its x axis.
 *
 * @param a               [a_count][4], w x y z, of any norm but 0: fraction 0
 * @param a_count         1 or count
 * @param b               [b_count][4], w x y z, of any norm but 0: fraction 1
 * @param b_count         1 or count
 * @param fraction        [fraction_count], any real numbers
 * @param fraction_count  1 or count
 * @param count           number of pairs; where it is 0 arrays may be NULL
 * @param path            QTRAJ_PATH_SHORTEST or QTRAJ_PATH_AS_GIVEN
 * @param q_out           [count][4], w x y z, unit; may be an a or b of count rows
 * @param bad_index       receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_VALUE (path), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (a or b): that row is NaN, all others are right;
 *   - QTRAJ_E_AMBIGUOUS: opposite a and b; that row holds the turn about x */
QTRAJ_API qtraj_status qtraj_slerp_pairs_f32(const float* a, size_t a_count, const float* b, size_t b_count,
                                             const float* fraction, size_t fraction_count, size_t count, int32_t path,
                                             float* q_out, size_t* bad_index);

/** Normalised linear interpolation of one pair at many fractions.
 *
 * @param a          [4], w x y z, of any norm but 0: fraction 0
 * @param b          [4], w x y z, of any norm but 0: fraction 1
 * @param fraction   [count], any real numbers; far outside the result tends to the direction of b - a
 * @param count      number of fractions; where it is 0 arrays may be NULL
 * @param path       QTRAJ_PATH_SHORTEST or QTRAJ_PATH_AS_GIVEN
 * @param q_out      [count][4], w x y z, unit; may not overlap an input, but where count is 1 may be a or b
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_VALUE (path), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (a fraction), QTRAJ_E_ZERO_NORM (the chord passes through 0 there, norm below 1e-14, which
 *     takes AS_GIVEN and opposite a and b): that row is NaN, all others are right;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: a or b, which is a fault of every row: all are NaN */
QTRAJ_API qtraj_status qtraj_nlerp(const double* a, const double* b, const double* fraction, size_t count, int32_t path,
                                   double* q_out, size_t* bad_index);

/** Normalised linear interpolation of one pair at many fractions in float: twin of qtraj_nlerp().
 *
 * Computed in double and rounded once.
 *
 * @param a          [4], w x y z, of any norm but 0: fraction 0
 * @param b          [4], w x y z, of any norm but 0: fraction 1
 * @param fraction   [count], any real numbers; far outside the result tends to the direction of b - a
 * @param count      number of fractions; where it is 0 arrays may be NULL
 * @param path       QTRAJ_PATH_SHORTEST or QTRAJ_PATH_AS_GIVEN
 * @param q_out      [count][4], w x y z, unit; may not overlap an input, but where count is 1 may be a or b
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_VALUE (path), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (a fraction), QTRAJ_E_ZERO_NORM (the chord passes through 0 there, norm below 1e-14, which
 *     takes AS_GIVEN and opposite a and b): that row is NaN, all others are right;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: a or b, which is a fault of every row: all are NaN */
QTRAJ_API qtraj_status qtraj_nlerp_f32(const float* a, const float* b, const float* fraction, size_t count,
                                       int32_t path, float* q_out, size_t* bad_index);

/** Normalised linear interpolation pair by pair; ends and fractions are one for all or one for each.
 *
 * @param a               [a_count][4], w x y z, of any norm but 0: fraction 0
 * @param a_count         1 or count
 * @param b               [b_count][4], w x y z, of any norm but 0: fraction 1
 * @param b_count         1 or count
 * @param fraction        [fraction_count], any real numbers; far outside the result tends to the direction of b - a
 * @param fraction_count  1 or count
 * @param count           number of pairs; where it is 0 arrays may be NULL
 * @param path            QTRAJ_PATH_SHORTEST or QTRAJ_PATH_AS_GIVEN
 * @param q_out           [count][4], w x y z, unit; may be an a or b of count rows
 * @param bad_index       receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_VALUE (path), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (a or b, or a chord through 0, norm below 1e-14, which takes AS_GIVEN and
 *     opposite a and b): that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_nlerp_pairs(const double* a, size_t a_count, const double* b, size_t b_count,
                                         const double* fraction, size_t fraction_count, size_t count, int32_t path,
                                         double* q_out, size_t* bad_index);

/** Normalised linear interpolation pair by pair in float: twin of qtraj_nlerp_pairs().
 *
 * Computed in double and rounded once. Ends and fractions are one for all or one for each.
 *
 * @param a               [a_count][4], w x y z, of any norm but 0: fraction 0
 * @param a_count         1 or count
 * @param b               [b_count][4], w x y z, of any norm but 0: fraction 1
 * @param b_count         1 or count
 * @param fraction        [fraction_count], any real numbers; far outside the result tends to the direction of b - a
 * @param fraction_count  1 or count
 * @param count           number of pairs; where it is 0 arrays may be NULL
 * @param path            QTRAJ_PATH_SHORTEST or QTRAJ_PATH_AS_GIVEN
 * @param q_out           [count][4], w x y z, unit; may be an a or b of count rows
 * @param bad_index       receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_VALUE (path), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (a or b, or a chord through 0, norm below 1e-14, which takes AS_GIVEN and
 *     opposite a and b): that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_nlerp_pairs_f32(const float* a, size_t a_count, const float* b, size_t b_count,
                                             const float* fraction, size_t fraction_count, size_t count, int32_t path,
                                             float* q_out, size_t* bad_index);

/** Slerp from a at time_a to b at time_b, sampled at many times, before and after the two too.
 *
 * AS_GIVEN with b = -a, to 1e-14 rad, is a full turn about no known axis: AMBIGUOUS, the body turns about its x axis.
 *
 * @param a          [4], w x y z, of any norm but 0
 * @param time_a     s
 * @param b          [4], w x y z, of any norm but 0
 * @param time_b     s, after time_a
 * @param times      [count], s, in any order
 * @param count      number of times; where it is 0 arrays may be NULL
 * @param path       QTRAJ_PATH_SHORTEST or QTRAJ_PATH_AS_GIVEN
 * @param q_out      [count][4], w x y z, unit; may not overlap an input, but where count is 1 may be a or b
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_VALUE (path), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE: one of times: that row is NaN, all others are right;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN (their distance overflows): a, b,
 *     time_a or time_b, which is a fault of every row: all are NaN;
 *   - QTRAJ_E_AMBIGUOUS: opposite a and b; rows hold the turn about x */
QTRAJ_API qtraj_status qtraj_slerp_between(const double* a, double time_a, const double* b, double time_b,
                                           const double* times, size_t count, int32_t path, double* q_out,
                                           size_t* bad_index);

/** Slerp pair by pair between ends that have times, at times, outside too.
 *
 * The fraction is (time - time_a) / (time_b - time_a). An end, quaternion and time, is one for all or one for each.
 *
 * AS_GIVEN with b = -a, to 1e-14 rad, is a full turn about no known axis: AMBIGUOUS, the body turns about its x axis.
 *
 * @param a            [a_count][4], w x y z, of any norm but 0
 * @param time_a       [a_count], s
 * @param a_count      1 or count
 * @param b            [b_count][4], w x y z, of any norm but 0
 * @param time_b       [b_count], s, after time_a
 * @param b_count      1 or count
 * @param times        [times_count], s
 * @param times_count  1 or count
 * @param count        number of rows; where it is 0 arrays may be NULL
 * @param path         QTRAJ_PATH_SHORTEST or QTRAJ_PATH_AS_GIVEN
 * @param q_out        [count][4], w x y z, unit; may be an a or b of count rows
 * @param bad_index    receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_VALUE (path), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (a or b), QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN (time_a and time_b): that
 *     row is NaN, all others are right;
 *   - QTRAJ_E_AMBIGUOUS: opposite a and b; that row holds the turn about x */
QTRAJ_API qtraj_status qtraj_slerp_pairs_between(const double* a, const double* time_a, size_t a_count, const double* b,
                                                 const double* time_b, size_t b_count, const double* times,
                                                 size_t times_count, size_t count, int32_t path, double* q_out,
                                                 size_t* bad_index);

/** Slerp pair by pair between ends that have times: twin of qtraj_slerp_pairs_between().
 *
 * Times are double. Computed in double and rounded once. The fraction is (time - time_a) / (time_b - time_a). An end,
 * quaternion and time, is one for all or one for each.
 *
 * AS_GIVEN with b = -a, to 1e-14 rad, is a full turn about no known axis: AMBIGUOUS, the body turns about its x axis.
 *
 * @param a            [a_count][4], w x y z, of any norm but 0
 * @param time_a       [a_count], s
 * @param a_count      1 or count
 * @param b            [b_count][4], w x y z, of any norm but 0
 * @param time_b       [b_count], s, after time_a
 * @param b_count      1 or count
 * @param times        [times_count], s
 * @param times_count  1 or count
 * @param count        number of rows; where it is 0 arrays may be NULL
 * @param path         QTRAJ_PATH_SHORTEST or QTRAJ_PATH_AS_GIVEN
 * @param q_out        [count][4], w x y z, unit; may be an a or b of count rows
 * @param bad_index    receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_VALUE (path), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (a or b), QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN (time_a and time_b): that
 *     row is NaN, all others are right;
 *   - QTRAJ_E_AMBIGUOUS: opposite a and b; that row holds the turn about x */
QTRAJ_API qtraj_status qtraj_slerp_pairs_between_f32(const float* a, const double* time_a, size_t a_count,
                                                     const float* b, const double* time_b, size_t b_count,
                                                     const double* times, size_t times_count, size_t count,
                                                     int32_t path, float* q_out, size_t* bad_index);

/** Normalised linear interpolation pair by pair between ends that have times, at times, outside too.
 *
 * The fraction is (time - time_a) / (time_b - time_a). An end, quaternion and time, is one for all or one for each.
 *
 * @param a            [a_count][4], w x y z, of any norm but 0
 * @param time_a       [a_count], s
 * @param a_count      1 or count
 * @param b            [b_count][4], w x y z, of any norm but 0
 * @param time_b       [b_count], s, after time_a
 * @param b_count      1 or count
 * @param times        [times_count], s
 * @param times_count  1 or count
 * @param count        number of rows; where it is 0 arrays may be NULL
 * @param path         QTRAJ_PATH_SHORTEST or QTRAJ_PATH_AS_GIVEN
 * @param q_out        [count][4], w x y z, unit; may be an a or b of count rows
 * @param bad_index    receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_VALUE (path), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (a or b, or a chord through 0, norm below 1e-14, which takes AS_GIVEN and
 *     opposite a and b), QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN (time_a and time_b): that row is NaN, all others are
 *     right */
QTRAJ_API qtraj_status qtraj_nlerp_pairs_between(const double* a, const double* time_a, size_t a_count, const double* b,
                                                 const double* time_b, size_t b_count, const double* times,
                                                 size_t times_count, size_t count, int32_t path, double* q_out,
                                                 size_t* bad_index);

/** Normalised linear interpolation pair by pair between ends that have times: twin of qtraj_nlerp_pairs_between().
 *
 * Times are double. Computed in double and rounded once. The fraction is (time - time_a) / (time_b - time_a). An end,
 * quaternion and time, is one for all or one for each.
 *
 * @param a            [a_count][4], w x y z, of any norm but 0
 * @param time_a       [a_count], s
 * @param a_count      1 or count
 * @param b            [b_count][4], w x y z, of any norm but 0
 * @param time_b       [b_count], s, after time_a
 * @param b_count      1 or count
 * @param times        [times_count], s
 * @param times_count  1 or count
 * @param count        number of rows; where it is 0 arrays may be NULL
 * @param path         QTRAJ_PATH_SHORTEST or QTRAJ_PATH_AS_GIVEN
 * @param q_out        [count][4], w x y z, unit; may be an a or b of count rows
 * @param bad_index    receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_VALUE (path), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (a or b, or a chord through 0, norm below 1e-14, which takes AS_GIVEN and
 *     opposite a and b), QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN (time_a and time_b): that row is NaN, all others are
 *     right */
QTRAJ_API qtraj_status qtraj_nlerp_pairs_between_f32(const float* a, const double* time_a, size_t a_count,
                                                     const float* b, const double* time_b, size_t b_count,
                                                     const double* times, size_t times_count, size_t count,
                                                     int32_t path, float* q_out, size_t* bad_index);

/** Screw motion pair by pair: poses between a and b, orientation and position together.
 *
 * The rates, angular and linear, are constant in the body frame: T_a exp(u log(T_a^-1 T_b)), the turn the
 * shorter of the two. Fraction 0 gives p_a, fraction 1 p_b. Without a turn it is the straight line. Half a turn, to 4
 * eps of the cosine of its half, is AMBIGUOUS: the row holds the way to q_b as given, by the rule of
 * QTRAJ_PATH_SHORTEST.
 *
 * @param q_a             [a_count][4], w x y z, body to world, of any norm but 0
 * @param p_a             [a_count][3], positions in the world frame, in any unit of length
 * @param a_count         1 or count
 * @param q_b             [b_count][4], w x y z, body to world, of any norm but 0
 * @param p_b             [b_count][3], in the unit of p_a
 * @param b_count         1 or count
 * @param fraction        [fraction_count], any real numbers: 0 is pose a, 1 is pose b
 * @param fraction_count  1 or count
 * @param count           number of poses; where it is 0 arrays may be NULL
 * @param q_out           [count][4], w x y z, unit; may be a q_a or q_b of count rows
 * @param p_out           [count][3]; may be a p_a or p_b of count rows
 * @param bad_index       receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (an input, or a position too large for double), QTRAJ_E_ZERO_NORM (q_a or q_b): that row is
 *     NaN in both outputs, all others are right;
 *   - QTRAJ_E_AMBIGUOUS: orientations half a turn apart; that row holds one of the two ways */
QTRAJ_API qtraj_status qtraj_screw_pairs(const double* q_a, const double* p_a, size_t a_count, const double* q_b,
                                         const double* p_b, size_t b_count, const double* fraction,
                                         size_t fraction_count, size_t count, double* q_out, double* p_out,
                                         size_t* bad_index);

/** Screw motion pair by pair in float: twin of qtraj_screw_pairs().
 *
 * Computed in double and rounded once.
 *
 * The rates, angular and linear, are constant in the body frame: T_a exp(u log(T_a^-1 T_b)), the turn the
 * shorter of the two. Fraction 0 gives p_a, fraction 1 p_b. Without a turn it is the straight line. Half a turn, to 4
 * eps of the cosine of its half, is AMBIGUOUS: the row holds the way to q_b as given, by the rule of
 * QTRAJ_PATH_SHORTEST.
 *
 * @param q_a             [a_count][4], w x y z, body to world, of any norm but 0
 * @param p_a             [a_count][3], positions in the world frame, in any unit of length
 * @param a_count         1 or count
 * @param q_b             [b_count][4], w x y z, body to world, of any norm but 0
 * @param p_b             [b_count][3], in the unit of p_a
 * @param b_count         1 or count
 * @param fraction        [fraction_count], any real numbers: 0 is pose a, 1 is pose b
 * @param fraction_count  1 or count
 * @param count           number of poses; where it is 0 arrays may be NULL
 * @param q_out           [count][4], w x y z, unit; may be a q_a or q_b of count rows
 * @param p_out           [count][3]; may be a p_a or p_b of count rows
 * @param bad_index       receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (an input, or a position too large for float), QTRAJ_E_ZERO_NORM (q_a or q_b): that row is NaN
 *     in both outputs, all others are right;
 *   - QTRAJ_E_AMBIGUOUS: orientations half a turn apart; that row holds one of the two ways */
QTRAJ_API qtraj_status qtraj_screw_pairs_f32(const float* q_a, const float* p_a, size_t a_count, const float* q_b,
                                             const float* p_b, size_t b_count, const float* fraction,
                                             size_t fraction_count, size_t count, float* q_out, float* p_out,
                                             size_t* bad_index);

/** Inner controls a_i, b_i of SQUAD for keys, by the rule CATMULL_ROM with CHORD ends.
 *
 * Arcs between neighbours are taken as their signs give them: qtraj_make_continuous() comes first. The first key's
 * controls are that key, and so are the last one's.
 *
 * @param times      [count], s, strictly increasing; NULL: uniform
 * @param q_wb       [count][4], w x y z, body to world, the keys; any norm but 0
 * @param count      number of keys; where it is 0 arrays may be NULL
 * @param a_out      [count][4], unit, control of the segment that starts at the key; may be q_wb
 * @param b_out      [count][4], unit, control of the segment that ends at the key; may be q_wb where a_out is not
 * @param bad_index  receives the index of the first key at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN (the span of the times overflows):
 *     the key at bad_index; its rows and those of its neighbours are NaN in both outputs, but the first and the last
 *     key's, which need no neighbour; all others are right;
 *   - QTRAJ_E_AMBIGUOUS: a neighbour is the opposite of this key; the arc between them turns about the body's x axis */
QTRAJ_API qtraj_status qtraj_squad_controls(const double* times, const double* q_wb, size_t count, double* a_out,
                                            double* b_out, size_t* bad_index);

/** One segment of SQUAD from its keys and controls, at many fractions; arcs as their signs give them.
 *
 * @param q0         [4], w x y z, of any norm but 0, key where the segment starts: fraction 0
 * @param q1         [4], the same, key where it ends: fraction 1
 * @param a          [4], the same, a of q0 by qtraj_squad_controls()
 * @param b          [4], the same, b of q1
 * @param fraction   [count], any real numbers
 * @param count      number of fractions; where it is 0 arrays may be NULL
 * @param q_out      [count][4], w x y z, unit; may not overlap an input, but where count is 1 may be a quaternion
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE: a fraction: that row is NaN, all others are right;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: a key or a control, which is a fault of every row: all are NaN;
 *   - QTRAJ_E_AMBIGUOUS: the ends of an arc are opposite; it turns about the body's x axis */
QTRAJ_API qtraj_status qtraj_squad_segment(const double* q0, const double* q1, const double* a, const double* b,
                                           const double* fraction, size_t count, double* q_out, size_t* bad_index);

/** @} */

/* ---- Keys: in place allowed ---- */

/** @defgroup qtraj-keys Keys
 * Arrays of keys looked at and made ready. What gives keys works in place.
 * @{ */

/** Finds all faults of a recording at once, and what is suspicious in it without being a fault.
 *
 * NOT_FINITE and ZERO_NORM are judged by the key alone. Of the keys that are left the longest series whose times
 * increase is good, the one whose keys come first where there are several, and all others are TIME_ORDER: one wild
 * time, ahead or back, is one fault, of a repeated time the first stays, and where a clock was set back the longer
 * part. (A constructor stops at the first key that does not fit the one before it: after a time that is ahead that is
 * the next key.) The keys without fault are keys that constructors take, if two or more are left.
 *
 * Takes memory during the call, 16 bytes a key, only where times are out of order; its time grows as the number of
 * keys.
 *
 * @param times       [count], s
 * @param q_wb        [count][4], w x y z, body to world, the keys
 * @param count       number of keys, any; where it is 0 arrays may be NULL
 * @param status_out  [count], a qtraj_status for each key: QTRAJ_OK, or the first of QTRAJ_E_NOT_FINITE,
 *                    QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN (too far after the first good key); may
 *                    be NULL
 * @param report      receives how many keys are at fault, and what is suspicious; may be NULL
 * @param bad_index   receives the index of the first key at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP (of the report too), QTRAJ_E_NO_MEMORY: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: that of the first key at fault; all
 *     outputs are written */
QTRAJ_API qtraj_status qtraj_check_keys(const double* times, const double* q_wb, size_t count, int32_t* status_out,
                                        qtraj_key_report* report, size_t* bad_index);

/** Finds all faults of a recording of float keys at once: twin of qtraj_check_keys().
 *
 * The keys are read as float, the times as double; the report is double.
 *
 * NOT_FINITE and ZERO_NORM are judged by the key alone. Of the keys that are left the longest series whose times
 * increase is good, the one whose keys come first where there are several, and all others are TIME_ORDER: one wild
 * time, ahead or back, is one fault, of a repeated time the first stays, and where a clock was set back the longer
 * part. (A constructor stops at the first key that does not fit the one before it: after a time that is ahead that is
 * the next key.) The keys without fault are keys that constructors take, if two or more are left.
 *
 * Takes memory during the call, 16 bytes a key, only where times are out of order; its time grows as the number of
 * keys.
 *
 * @param times       [count], s
 * @param q_wb        [count][4], w x y z, body to world, the keys
 * @param count       number of keys, any; where it is 0 arrays may be NULL
 * @param status_out  [count], a qtraj_status for each key: QTRAJ_OK, or the first of QTRAJ_E_NOT_FINITE,
 *                    QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN (too far after the first good key); may
 *                    be NULL
 * @param report      receives how many keys are at fault, and what is suspicious; may be NULL
 * @param bad_index   receives the index of the first key at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP (of the report too), QTRAJ_E_NO_MEMORY: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: that of the first key at fault; all
 *     outputs are written */
QTRAJ_API qtraj_status qtraj_check_keys_f32(const double* times, const float* q_wb, size_t count, int32_t* status_out,
                                            qtraj_key_report* report, size_t* bad_index);

/** Seconds of time stamps that count nanoseconds: (ns - origin) / 10^9, rounded once.
 *
 * The difference is exact, also where it passes the range of int64_t, and the result the double nearest to the
 * quotient. Pass the first stamp of a recording as the origin: stamps since 1970 that are turned into double first are
 * off by up to 1.2e-7 s, which makes angular accelerations at 200 Hz wrong by a percent.
 *
 * @param ns           [count], ns
 * @param count        number of stamps; where it is 0 arrays may be NULL
 * @param origin       ns, the stamp that becomes 0
 * @param seconds_out  [count], s; may not overlap ns
 * @return QTRAJ_OK, or QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written */
QTRAJ_API qtraj_status qtraj_seconds_from_ns(const int64_t* ns, size_t count, int64_t origin, double* seconds_out);

/** Unit quaternions, signs kept.
 *
 * @param q          [count][4], of any norm but 0
 * @param count      number of quaternions; where it is 0 arrays may be NULL
 * @param q_out      [count][4], unit; may be q
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_normalize(const double* q, size_t count, double* q_out, size_t* bad_index);

/** Unit quaternions of float, signs kept: twin of qtraj_normalize().
 *
 * Computed in double and rounded once.
 *
 * @param q          [count][4], of any norm but 0
 * @param count      number of quaternions; where it is 0 arrays may be NULL
 * @param q_out      [count][4], unit; may be q
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_normalize_f32(const float* q, size_t count, float* q_out, size_t* bad_index);

/** Makes the signs of series of keys continuous: the dot product of neighbours is then >= 0.
 *
 * The first key of a series keeps its sign, and so does a key whose dot product is 0. Nothing but signs is changed.
 *
 * @param q          [series][length][4], of any norm but 0, one series after the other
 * @param series     number of series; where it or length is 0 arrays may be NULL
 * @param length     number of keys of each
 * @param q_out      [series][length][4]; may be q
 * @param flips      receives the number of keys that were negated, of all series; may be NULL
 * @param bad_index  receives the index of the first row at fault, of series * length, SIZE_MAX where there is none; may
 *                   be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP (of flips too): nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: that row is NaN; the next is judged by the last good one before */
QTRAJ_API qtraj_status qtraj_make_continuous(const double* q, size_t series, size_t length, double* q_out,
                                             size_t* flips, size_t* bad_index);

/** Makes the signs of series of float keys continuous: twin of qtraj_make_continuous().
 *
 * The dot product of neighbours, taken in double, is then >= 0. The first key of a series keeps its sign, and so does a
 * key whose dot product is 0. Nothing but signs is changed.
 *
 * @param q          [series][length][4], of any norm but 0, one series after the other
 * @param series     number of series; where it or length is 0 arrays may be NULL
 * @param length     number of keys of each
 * @param q_out      [series][length][4]; may be q
 * @param flips      receives the number of keys that were negated, of all series; may be NULL
 * @param bad_index  receives the index of the first row at fault, of series * length, SIZE_MAX where there is none; may
 *                   be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP (of flips too): nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: that row is NaN; the next is judged by the last good one before */
QTRAJ_API qtraj_status qtraj_make_continuous_f32(const float* q, size_t series, size_t length, float* q_out,
                                                 size_t* flips, size_t* bad_index);

/** Makes the signs of series continuous that lie along any axis of an array.
 *
 * Key k of series s is row s * series_stride + k * key_stride of q and of q_out. In an array [length][series][4] the
 * strides are 1 and series; in [series][length][4] length and 1, as in qtraj_make_continuous(), whose results these
 * are. Rows between are neither read nor written.
 *
 * @param q              its first row is key 0 of series 0; keys of any norm but 0
 * @param series         number of series; where it or length is 0 arrays may be NULL
 * @param series_stride  rows from a series to the next
 * @param length         number of keys of each
 * @param key_stride     rows from a key to the next of its series; no two keys may share a row: series_stride exceeds
 *                       (length - 1) * key_stride, or key_stride exceeds (series - 1) * series_stride
 * @param q_out          as q, with the same strides; may be q; else it may not overlap q from first row to last
 * @param flips          receives the number of keys that were negated, of all series; may be NULL
 * @param bad_index      receives s * length + k, the least of all keys at fault, SIZE_MAX where there is none; may
 *                       be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_VALUE (strides that make keys share rows), QTRAJ_E_OVERLAP (of flips too):
 *     nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: that row is NaN; the next is judged by the last good one before */
QTRAJ_API qtraj_status qtraj_make_continuous_strided(const double* q, size_t series, size_t series_stride,
                                                     size_t length, size_t key_stride, double* q_out, size_t* flips,
                                                     size_t* bad_index);

/** Makes the signs of series of float keys continuous along any axis: twin of qtraj_make_continuous_strided().
 *
 * Key k of series s is row s * series_stride + k * key_stride of q and of q_out. In an array [length][series][4] the
 * strides are 1 and series; in [series][length][4] length and 1, as in qtraj_make_continuous_f32(), whose results these
 * are. Rows between are neither read nor written.
 *
 * @param q              its first row is key 0 of series 0; keys of any norm but 0
 * @param series         number of series; where it or length is 0 arrays may be NULL
 * @param series_stride  rows from a series to the next
 * @param length         number of keys of each
 * @param key_stride     rows from a key to the next of its series; no two keys may share a row: series_stride exceeds
 *                       (length - 1) * key_stride, or key_stride exceeds (series - 1) * series_stride
 * @param q_out          as q, with the same strides; may be q; else it may not overlap q from first row to last
 * @param flips          receives the number of keys that were negated, of all series; may be NULL
 * @param bad_index      receives s * length + k, the least of all keys at fault, SIZE_MAX where there is none; may
 *                       be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_VALUE (strides that make keys share rows), QTRAJ_E_OVERLAP (of flips too):
 *     nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: that row is NaN; the next is judged by the last good one before */
QTRAJ_API qtraj_status qtraj_make_continuous_strided_f32(const float* q, size_t series, size_t series_stride,
                                                         size_t length, size_t key_stride, float* q_out, size_t* flips,
                                                         size_t* bad_index);

/** Component order x y z w to w x y z: values are only moved, whatever they are.
 *
 * @param q_xyzw  [count][4], x y z w
 * @param count   number of quaternions; where it is 0 arrays may be NULL
 * @param q_out   [count][4], w x y z; may be q_xyzw
 * @return QTRAJ_OK, or QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written */
QTRAJ_API qtraj_status qtraj_wxyz_from_xyzw(const double* q_xyzw, size_t count, double* q_out);

/** Component order x y z w to w x y z of float, values only moved: twin of qtraj_wxyz_from_xyzw().
 *
 * @param q_xyzw  [count][4], x y z w
 * @param count   number of quaternions; where it is 0 arrays may be NULL
 * @param q_out   [count][4], w x y z; may be q_xyzw
 * @return QTRAJ_OK, or QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written */
QTRAJ_API qtraj_status qtraj_wxyz_from_xyzw_f32(const float* q_xyzw, size_t count, float* q_out);

/** Component order w x y z to x y z w: values are only moved, whatever they are.
 *
 * @param q           [count][4], w x y z
 * @param count       number of quaternions; where it is 0 arrays may be NULL
 * @param q_xyzw_out  [count][4], x y z w; may be q
 * @return QTRAJ_OK, or QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written */
QTRAJ_API qtraj_status qtraj_xyzw_from_wxyz(const double* q, size_t count, double* q_xyzw_out);

/** Component order w x y z to x y z w of float, values only moved: twin of qtraj_xyzw_from_wxyz().
 *
 * @param q           [count][4], w x y z
 * @param count       number of quaternions; where it is 0 arrays may be NULL
 * @param q_xyzw_out  [count][4], x y z w; may be q
 * @return QTRAJ_OK, or QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written */
QTRAJ_API qtraj_status qtraj_xyzw_from_wxyz_f32(const float* q, size_t count, float* q_xyzw_out);

/** Columns to rows, as many as you like: values are only moved, whatever their bits.
 *
 * @param columns   [width], each [count]; they may overlap each other
 * @param width     number of columns; where it is 0 nothing is done
 * @param count     length of the columns; where it is 0 nothing is done
 * @param rows_out  [count][width]
 * @return QTRAJ_OK, or QTRAJ_E_NULL (also one of the columns), QTRAJ_E_SIZE, QTRAJ_E_OVERLAP (of rows_out
 *   with columns or one of them): nothing is written */
QTRAJ_API qtraj_status qtraj_rows_from_columns(const double* const* columns, size_t width, size_t count,
                                               double* rows_out);

/** Columns to rows of float, values only moved: twin of qtraj_rows_from_columns().
 *
 * @param columns   [width], each [count]; they may overlap each other
 * @param width     number of columns; where it is 0 nothing is done
 * @param count     length of the columns; where it is 0 nothing is done
 * @param rows_out  [count][width]
 * @return QTRAJ_OK, or QTRAJ_E_NULL (also one of the columns), QTRAJ_E_SIZE, QTRAJ_E_OVERLAP (of rows_out
 *   with columns or one of them): nothing is written */
QTRAJ_API qtraj_status qtraj_rows_from_columns_f32(const float* const* columns, size_t width, size_t count,
                                                   float* rows_out);

/** Rows to columns, as many as you like: values are only moved, whatever their bits.
 *
 * @param rows         [count][width]
 * @param width        number of columns; where it is 0 nothing is done
 * @param count        number of rows; where it is 0 nothing is done
 * @param columns_out  [width], each [count]; none may overlap another, the rows or columns_out
 * @return QTRAJ_OK, or QTRAJ_E_NULL (also one of the columns), QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written */
QTRAJ_API qtraj_status qtraj_columns_from_rows(const double* rows, size_t width, size_t count,
                                               double* const* columns_out);

/** Rows to columns of float, values only moved: twin of qtraj_columns_from_rows().
 *
 * @param rows         [count][width]
 * @param width        number of columns; where it is 0 nothing is done
 * @param count        number of rows; where it is 0 nothing is done
 * @param columns_out  [width], each [count]; none may overlap another, the rows or columns_out
 * @return QTRAJ_OK, or QTRAJ_E_NULL (also one of the columns), QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written */
QTRAJ_API qtraj_status qtraj_columns_from_rows_f32(const float* rows, size_t width, size_t count,
                                                   float* const* columns_out);

/** @} */

/* ---- Algebra: in place where row lengths agree ---- */

/** @defgroup qtraj-algebra Algebra
 * Row by row, in place where row lengths agree. Products, norms, dot products and conjugates take quaternions as they
 * are, 0 included; all others take any norm but 0.
 * @{ */

/** Hamilton product a b of quaternions as they are, not normalised.
 *
 * @param a          [a_count][4], w x y z
 * @param a_count    1 or count
 * @param b          [b_count][4], w x y z
 * @param b_count    1 or count
 * @param count      number of products; where it is 0 arrays may be NULL
 * @param q_out      [count][4], w x y z; may be an input of count rows
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (a, b, or a product that overflows): that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_multiply(const double* a, size_t a_count, const double* b, size_t b_count, size_t count,
                                      double* q_out, size_t* bad_index);

/** Hamilton product a b of quaternions in float: twin of qtraj_multiply().
 *
 * @param a          [a_count][4], w x y z
 * @param a_count    1 or count
 * @param b          [b_count][4], w x y z
 * @param b_count    1 or count
 * @param count      number of products; where it is 0 arrays may be NULL
 * @param q_out      [count][4], w x y z; may be an input of count rows
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return as qtraj_multiply(); NOT_FINITE also for a product too large for float */
QTRAJ_API qtraj_status qtraj_multiply_f32(const float* a, size_t a_count, const float* b, size_t b_count, size_t count,
                                          float* q_out, size_t* bad_index);

/** Conjugates (w, -x, -y, -z) of quaternions as they are: of unit ones the inverse rotations.
 *
 * @param q          [count][4], w x y z
 * @param count      number of quaternions; where it is 0 arrays may be NULL
 * @param q_out      [count][4], w x y z; may be q
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE: that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_conjugate(const double* q, size_t count, double* q_out, size_t* bad_index);

/** Inverses of quaternions as they are: conjugate / norm^2.
 *
 * @param q          [count][4], w x y z, other than 0
 * @param count      number of quaternions; where it is 0 arrays may be NULL
 * @param q_out      [count][4], w x y z; may be q
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (q, or an inverse that overflows), QTRAJ_E_ZERO_NORM: that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_inverse(const double* q, size_t count, double* q_out, size_t* bad_index);

/** Euclidean norms of quaternions.
 *
 * @param q          [count][4], w x y z
 * @param count      number of quaternions; where it is 0 arrays may be NULL
 * @param norm_out   [count]; may not overlap q
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (q, or a norm that overflows): that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_norm(const double* q, size_t count, double* norm_out, size_t* bad_index);

/** Dot products in R^4 of quaternions as they are: of unit ones the cosine of half the turn from a to b.
 *
 * @param a          [a_count][4], w x y z
 * @param a_count    1 or count
 * @param b          [b_count][4], w x y z
 * @param b_count    1 or count
 * @param count      number of pairs; where it is 0 arrays may be NULL
 * @param dot_out    [count]; may not overlap an input
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (a, b, or a product that overflows): that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_dot(const double* a, size_t a_count, const double* b, size_t b_count, size_t count,
                                 double* dot_out, size_t* bad_index);

/** Exponential of half-angle vectors: (cos |v|, v sin |v| / |v|), the rotation about v by 2 |v|.
 *
 * @param v          [count][3], rad, of any length
 * @param count      number of vectors; where it is 0 arrays may be NULL
 * @param q_out      [count][4], w x y z, unit; may not overlap v
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE: that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_exp(const double* v, size_t count, double* q_out, size_t* bad_index);

/** Exponential of half-angle vectors in float: twin of qtraj_exp().
 *
 * @param v          [count][3], rad, of any length
 * @param count      number of rows; where it is 0 arrays may be NULL
 * @param q_out      [count][4], w x y z, unit; may not overlap v
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return as qtraj_exp() */
QTRAJ_API qtraj_status qtraj_exp_f32(const float* v, size_t count, float* q_out, size_t* bad_index);

/** Logarithm of q / |q|: half-angle vectors, the sign of q kept, so that qtraj_exp() gives q / |q| back.
 *
 * @param q          [count][4], w x y z, of any norm but 0
 * @param count      number of quaternions; where it is 0 arrays may be NULL
 * @param v_out      [count][3], rad, |v| in [0, pi]; may not overlap q
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: that row is NaN, all others are right;
 *   - QTRAJ_E_AMBIGUOUS: q / |q| is -1; that row is (pi, 0, 0) */
QTRAJ_API qtraj_status qtraj_log(const double* q, size_t count, double* v_out, size_t* bad_index);

/** Logarithm of q / |q| in float: twin of qtraj_log().
 *
 * @param q          [count][4], w x y z, of any norm but 0
 * @param count      number of rows; where it is 0 arrays may be NULL
 * @param v_out      [count][3], rad, |v| in [0, pi]; may not overlap q
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return as qtraj_log() */
QTRAJ_API qtraj_status qtraj_log_f32(const float* q, size_t count, float* v_out, size_t* bad_index);

/** Powers of q / |q|: exp(exponent * log(q)).
 *
 * @param q               [count][4], w x y z, of any norm but 0
 * @param exponent        [exponent_count], any real numbers
 * @param exponent_count  1 or count
 * @param count           number of quaternions; where it is 0 arrays may be NULL
 * @param q_out           [count][4], w x y z, unit; may be q
 * @param bad_index       receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (q or exponent), QTRAJ_E_ZERO_NORM: that row is NaN, all others are right;
 *   - QTRAJ_E_AMBIGUOUS: q / |q| is -1 and the exponent not whole; that row is a turn about the x axis */
QTRAJ_API qtraj_status qtraj_pow(const double* q, const double* exponent, size_t exponent_count, size_t count,
                                 double* q_out, size_t* bad_index);

/** World vectors q v q^-1 of body vectors.
 *
 * @param q_wb         [q_count][4], w x y z, body to world, of any norm but 0
 * @param q_count      1 or count
 * @param v_body       [v_count][3], of any unit
 * @param v_count      1 or count
 * @param count        number of results; where it is 0 arrays may be NULL
 * @param v_world_out  [count][3], of the same unit; may be v_body where v_count is count
 * @param bad_index    receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (q_wb, v_body, or a result that overflows), QTRAJ_E_ZERO_NORM: that row is NaN, all others are
 *     right */
QTRAJ_API qtraj_status qtraj_rotate(const double* q_wb, size_t q_count, const double* v_body, size_t v_count,
                                    size_t count, double* v_world_out, size_t* bad_index);

/** World vectors q v q^-1 of body vectors in float: twin of qtraj_rotate().
 *
 * Computed in double and rounded once.
 *
 * @param q_wb         [q_count][4], w x y z, body to world, of any norm but 0
 * @param q_count      1 or count
 * @param v_body       [v_count][3], of any unit
 * @param v_count      1 or count
 * @param count        number of results; where it is 0 arrays may be NULL
 * @param v_world_out  [count][3], of the same unit; may be v_body where v_count is count
 * @param bad_index    receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (q_wb, v_body, or a result too large for float), QTRAJ_E_ZERO_NORM: that row is NaN, all
 *     others are right */
QTRAJ_API qtraj_status qtraj_rotate_f32(const float* q_wb, size_t q_count, const float* v_body, size_t v_count,
                                        size_t count, float* v_world_out, size_t* bad_index);

/** Angles between quaternions on S^3, where signs count: half the angle that the body turns by.
 *
 * @param a          [a_count][4], w x y z, of any norm but 0
 * @param a_count    1 or count
 * @param b          [b_count][4], w x y z, of any norm but 0
 * @param b_count    1 or count
 * @param count      number of pairs; where it is 0 arrays may be NULL
 * @param angle_out  [count], rad, in [0, pi]; may not overlap an input
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_distance(const double* a, size_t a_count, const double* b, size_t b_count, size_t count,
                                      double* angle_out, size_t* bad_index);

/** Angles between quaternions on S^3 in float: twin of qtraj_distance().
 *
 * @param a          [a_count][4], w x y z, of any norm but 0
 * @param a_count    1 or count
 * @param b          [b_count][4], w x y z, of any norm but 0
 * @param b_count    1 or count
 * @param count      number of pairs; where it is 0 arrays may be NULL
 * @param angle_out  [count], rad, in [0, pi]; may not overlap an input
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return as qtraj_distance() */
QTRAJ_API qtraj_status qtraj_distance_f32(const float* a, size_t a_count, const float* b, size_t b_count, size_t count,
                                          float* angle_out, size_t* bad_index);

/** Angles of the rotations that take a to b, where signs do not count.
 *
 * @param a          [a_count][4], w x y z, of any norm but 0
 * @param a_count    1 or count
 * @param b          [b_count][4], w x y z, of any norm but 0
 * @param b_count    1 or count
 * @param count      number of pairs; where it is 0 arrays may be NULL
 * @param angle_out  [count], rad, in [0, pi]; may not overlap an input
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_COUNT, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_rotation_angle(const double* a, size_t a_count, const double* b, size_t b_count,
                                            size_t count, double* angle_out, size_t* bad_index);

/** Rotation vectors of quaternions, the shorter way round.
 *
 * q and -q give the same, but at half a turn, where the vector part of q gives the axis.
 *
 * @param q          [count][4], w x y z, of any norm but 0
 * @param count      number of quaternions; where it is 0 arrays may be NULL
 * @param r_out      [count][3], rad, |r| in [0, pi]; may not overlap q
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_rotation_vector_from_q(const double* q, size_t count, double* r_out, size_t* bad_index);

/** Rotation vectors of quaternions in float: twin of qtraj_rotation_vector_from_q().
 *
 * @param q          [count][4], w x y z, of any norm but 0
 * @param count      number of rows; where it is 0 arrays may be NULL
 * @param r_out      [count][3], rad, |r| in [0, pi]; may not overlap q
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return as qtraj_rotation_vector_from_q() */
QTRAJ_API qtraj_status qtraj_rotation_vector_from_q_f32(const float* q, size_t count, float* r_out, size_t* bad_index);

/** Unit quaternions of rotation vectors of any length.
 *
 * @param r          [count][3], rad
 * @param count      number of vectors; where it is 0 arrays may be NULL
 * @param q_out      [count][4], w x y z, unit; may not overlap r
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE: that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_q_from_rotation_vector(const double* r, size_t count, double* q_out, size_t* bad_index);

/** Unit quaternions of rotation vectors in float: twin of qtraj_q_from_rotation_vector().
 *
 * @param r          [count][3], rad, of any length
 * @param count      number of rows; where it is 0 arrays may be NULL
 * @param q_out      [count][4], w x y z, unit; may not overlap r
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return as qtraj_q_from_rotation_vector() */
QTRAJ_API qtraj_status qtraj_q_from_rotation_vector_f32(const float* r, size_t count, float* q_out, size_t* bad_index);

/** Rotation matrices of quaternions: v_world = M v_body.
 *
 * @param q_wb        [count][4], w x y z, body to world, of any norm but 0
 * @param count       number of quaternions; where it is 0 arrays may be NULL
 * @param matrix_out  [count][9], row-major; may not overlap q_wb
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: that row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_matrix_from_q(const double* q_wb, size_t count, double* matrix_out, size_t* bad_index);

/** Rotation matrices of quaternions in float: twin of qtraj_matrix_from_q().
 *
 * @param q_wb        [count][4], w x y z, body to world, of any norm but 0
 * @param count       number of quaternions; where it is 0 arrays may be NULL
 * @param matrix_out  [count][9], row-major; may not overlap q_wb
 * @param bad_index   receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return as qtraj_matrix_from_q() */
QTRAJ_API qtraj_status qtraj_matrix_from_q_f32(const float* q_wb, size_t count, float* matrix_out, size_t* bad_index);

/** Unit quaternions of the rotations nearest to matrices, and how far those are.
 *
 * The distance is the root of the sum of the squared differences of the nine elements. Elements of three decimals make
 * 1.5e-3 at most: a limit of 2e-3 takes them.
 *
 * @param matrix        [count][9], row-major, v_world = M v_body
 * @param count         number of matrices; where it is 0 arrays may be NULL
 * @param limit         largest distance from a rotation, 0 to 0.5; 0: 1e-3
 * @param q_out         [count][4], w x y z, body to world, unit, w >= 0; may not overlap another array
 * @param distance_out  [count], the distance, also of rows that the limit refuses; NaN where it exceeds 0.5 or the
 *                      determinant is negative; may be NULL
 * @param bad_index     receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_VALUE (limit), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_NOT_ROTATION (farther than the limit from every rotation, or a negative determinant):
 *     that row of q_out is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_q_from_matrix(const double* matrix, size_t count, double limit, double* q_out,
                                           double* distance_out, size_t* bad_index);

/** Unit quaternions of the rotations nearest to matrices in float: twin of qtraj_q_from_matrix().
 *
 * @param matrix        [count][9], row-major, v_world = M v_body
 * @param count         number of matrices; where it is 0 arrays may be NULL
 * @param limit         largest distance from a rotation, 0 to 0.5; 0: 1e-3
 * @param q_out         [count][4], w x y z, body to world, unit, w >= 0; may not overlap another array
 * @param distance_out  [count], the distance, also of rows that the limit refuses; NaN where it exceeds 0.5 or the
 *                      determinant is negative; may be NULL
 * @param bad_index     receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return as qtraj_q_from_matrix() */
QTRAJ_API qtraj_status qtraj_q_from_matrix_f32(const float* matrix, size_t count, double limit, float* q_out,
                                               float* distance_out, size_t* bad_index);

/** Derivatives q', q'' of q / |q| from angular velocities and accelerations.
 *
 * @param frame      a qtraj_frame_value, of omega and alpha
 * @param q_wb       [count][4], w x y z, body to world, of any norm but 0
 * @param omega      [count][3], rad/s
 * @param alpha      [count][3], rad/s^2; NULL together with ddq_out
 * @param count      number of rows; where it is 0 arrays may be NULL
 * @param dq_out     [count][4], 1/s; may be q_wb
 * @param ddq_out    [count][4], 1/s^2; NULL together with alpha; may be q_wb where dq_out is not
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (an input, or a result that overflows), QTRAJ_E_ZERO_NORM: that row is NaN in both outputs,
 *     all others are right */
QTRAJ_API qtraj_status qtraj_derivatives_from_rates(int32_t frame, const double* q_wb, const double* omega,
                                                    const double* alpha, size_t count, double* dq_out, double* ddq_out,
                                                    size_t* bad_index);

/** Angular velocities and accelerations of the curve q / |q| from q and its own derivatives q', q''.
 *
 * What changes the norm of q alone is ignored.
 *
 * @param frame      a qtraj_frame_value, of omega_out and alpha_out
 * @param q_wb       [count][4], w x y z, body to world, of any norm but 0
 * @param dq         [count][4], 1/s
 * @param ddq        [count][4], 1/s^2; NULL together with alpha_out
 * @param count      number of rows; where it is 0 arrays may be NULL
 * @param omega_out  [count][3], rad/s; may not overlap another array
 * @param alpha_out  [count][3], rad/s^2; NULL together with ddq; may not overlap another array
 * @param bad_index  receives the index of the first row at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (an input, or a result that overflows), QTRAJ_E_ZERO_NORM: that row is NaN in both outputs,
 *     all others are right */
QTRAJ_API qtraj_status qtraj_rates_from_derivatives(int32_t frame, const double* q_wb, const double* dq,
                                                    const double* ddq, size_t count, double* omega_out,
                                                    double* alpha_out, size_t* bad_index);

/** @} */

/* ---- Means: count >= 1, weights [count] >= 0 or NULL, summed in double; mean_out [4] ---- */

/** @defgroup qtraj-means Means
 * Of one sample and more, summed in double. A weight says how many times its sample counts; only ratios matter. Signs
 * of samples do not matter, but that the mean has the sign of the first sample whose weight is not 0.
 * @{ */

/** Mean that minimises the weighted sum of squared chords: the top eigenvector of sum w q q^T.
 *
 * @param q          [count][4], w x y z, of any norm but 0
 * @param weights    [count], 0 or more, not all 0; NULL: all 1
 * @param count      number of samples, 1 or more
 * @param mean_out   [4], w x y z, unit; may not overlap an input, but where count is 1 may be q
 * @param eigengap   receives (l1 - l2) / trace, the two largest eigenvalues, in [0, 1]; may be NULL
 * @param bad_index  receives the index of the first sample at fault, SIZE_MAX where it is not one; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (also, without an index: all weights are 0), QTRAJ_E_NEGATIVE_WEIGHT:
 *     mean_out and eigengap are NaN;
 *   - QTRAJ_E_AMBIGUOUS: the two largest eigenvalues tie, to 64 eps of double; mean_out is one of the best */
QTRAJ_API qtraj_status qtraj_mean_eigen(const double* q, const double* weights, size_t count, double* mean_out,
                                        double* eigengap, size_t* bad_index);

/** Mean that minimises the weighted sum of squared chords, of float samples: twin of qtraj_mean_eigen().
 *
 * Samples and weights are read as float, the sum is taken in double, the mean rounded once.
 *
 * @param q          [count][4], w x y z, of any norm but 0
 * @param weights    [count], 0 or more, not all 0; NULL: all 1
 * @param count      number of samples, 1 or more
 * @param mean_out   [4], w x y z, unit; may not overlap an input, but where count is 1 may be q
 * @param eigengap   receives (l1 - l2) / trace, the two largest eigenvalues, in [0, 1]; may be NULL
 * @param bad_index  receives the index of the first sample at fault, SIZE_MAX where it is not one; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (also, without an index: all weights are 0), QTRAJ_E_NEGATIVE_WEIGHT:
 *     mean_out and eigengap are NaN;
 *   - QTRAJ_E_AMBIGUOUS: the two largest eigenvalues tie, to 64 eps of float; mean_out is one of the best */
QTRAJ_API qtraj_status qtraj_mean_eigen_f32(const float* q, const float* weights, size_t count, float* mean_out,
                                            double* eigengap, size_t* bad_index);

/** Mean that minimises the weighted sum of squared angles; an OK proves it to be the global minimum.
 *
 * @param q               [count][4], w x y z, of any norm but 0
 * @param weights         [count], 0 or more, not all 0; NULL: all 1
 * @param count           number of samples, 1 or more
 * @param tolerance       rad on S^3, 0 or more: a descent ends after a step of this length; what is less than 4 eps of
 *                        double counts as that
 * @param max_iterations  of the descent to the mean, 1 or more; descents that only serve the proof have 64 at most
 * @param mean_out        [4], w x y z, unit; may not overlap an input, but where count is 1 may be q
 * @param iterations      receives how many the descent to the mean took; may be NULL
 * @param residual        receives the length of its last step, rad on S^3; may be NULL
 * @param bad_index       receives the index of the first sample at fault, SIZE_MAX where it is not one; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_VALUE (tolerance not finite or below 0, max_iterations below
 *     1), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (also, without an index: all weights are 0), QTRAJ_E_NEGATIVE_WEIGHT:
 *     mean_out and residual are NaN, iterations 0;
 *   - QTRAJ_E_AMBIGUOUS: not proven to be the only best, a tie or samples spread widely; mean_out is the best found;
 *   - QTRAJ_E_NO_CONVERGENCE: max_iterations were not enough; mean_out is the last iterate */
QTRAJ_API qtraj_status qtraj_mean_karcher(const double* q, const double* weights, size_t count, double tolerance,
                                          int32_t max_iterations, double* mean_out, int32_t* iterations,
                                          double* residual, size_t* bad_index);

/** Mean that minimises the weighted sum of squared angles, of float samples: twin of qtraj_mean_karcher().
 *
 * Samples and weights are read as float, the descents run in double, the mean is rounded once. An OK proves it to be
 * the global minimum.
 *
 * @param q               [count][4], w x y z, of any norm but 0
 * @param weights         [count], 0 or more, not all 0; NULL: all 1
 * @param count           number of samples, 1 or more
 * @param tolerance       rad on S^3, 0 or more: a descent ends after a step of this length; what is less than 4 eps of
 *                        float counts as that
 * @param max_iterations  of the descent to the mean, 1 or more; descents that only serve the proof have 64 at most
 * @param mean_out        [4], w x y z, unit; may not overlap an input, but where count is 1 may be q
 * @param iterations      receives how many the descent to the mean took; may be NULL
 * @param residual        receives the length of its last step, rad on S^3; may be NULL
 * @param bad_index       receives the index of the first sample at fault, SIZE_MAX where it is not one; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_VALUE (tolerance not finite or below 0, max_iterations below
 *     1), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (also, without an index: all weights are 0), QTRAJ_E_NEGATIVE_WEIGHT:
 *     mean_out and residual are NaN, iterations 0;
 *   - QTRAJ_E_AMBIGUOUS: not proven to be the only best, a tie or samples spread widely; mean_out is the best found;
 *   - QTRAJ_E_NO_CONVERGENCE: max_iterations were not enough; mean_out is the last iterate */
QTRAJ_API qtraj_status qtraj_mean_karcher_f32(const float* q, const float* weights, size_t count, double tolerance,
                                              int32_t max_iterations, float* mean_out, int32_t* iterations,
                                              double* residual, size_t* bad_index);

/** Adds samples to moments, from which qtraj_mean_from_moments() makes their mean: for samples that come in parts.
 *
 * Moments are the sum of the weights w, then the upper triangle, row by row, of sum w q q^T, q made unit: zeros to
 * begin with. Those of parts that were taken apart, elsewhere or at another time, are merged by adding them number by
 * number.
 *
 * @param q          [count][4], w x y z, of any norm but 0
 * @param weights    [count], 0 or more; NULL: all 1
 * @param count      number of samples; where it is 0 arrays may be NULL
 * @param moments    [11], added to; may overlap no other array
 * @param bad_index  receives the index of the first sample at fault, SIZE_MAX where it is not one; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is added;
 *   - QTRAJ_E_NOT_FINITE (a sample; without an index: moments, as they are, or their sum overflows), QTRAJ_E_ZERO_NORM,
 *     QTRAJ_E_NEGATIVE_WEIGHT: nothing is added */
QTRAJ_API qtraj_status qtraj_moments_add(const double* q, const double* weights, size_t count, double* moments,
                                         size_t* bad_index);

/** Adds samples of float to moments: twin of qtraj_moments_add().
 *
 * Samples and weights are read as float; moments are of double, and those of float and double samples may be merged.
 *
 * @param q          [count][4], w x y z, of any norm but 0
 * @param weights    [count], 0 or more; NULL: all 1
 * @param count      number of samples; where it is 0 arrays may be NULL
 * @param moments    [11], added to; may overlap no other array
 * @param bad_index  receives the index of the first sample at fault, SIZE_MAX where it is not one; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is added;
 *   - QTRAJ_E_NOT_FINITE (a sample; without an index: moments, as they are, or their sum overflows), QTRAJ_E_ZERO_NORM,
 *     QTRAJ_E_NEGATIVE_WEIGHT: nothing is added */
QTRAJ_API qtraj_status qtraj_moments_add_f32(const float* q, const float* weights, size_t count, double* moments,
                                             size_t* bad_index);

/** Eigen mean of all samples whose moments were added: that of qtraj_mean_eigen(), but for rounding and the sign.
 *
 * w is 0 or more; where it is 0, the first other component that is not 0 is above 0.
 *
 * @param moments   [11], of qtraj_moments_add(), or sums of such
 * @param mean_out  [4], w x y z, unit; may overlap no other array
 * @param eigengap  receives (l1 - l2) / trace, the two largest eigenvalues, in [0, 1]; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_VALUE (no moments: the trace is not the sum of weights, or an eigenvalue is below 0, by
 *     more than 1e-8 of that sum), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM (no samples, or all weights are 0), QTRAJ_E_NEGATIVE_WEIGHT (the sum of
 *     weights is below 0): mean_out and eigengap are NaN;
 *   - QTRAJ_E_AMBIGUOUS: the two largest eigenvalues tie, to 64 eps of double; mean_out is one of the best */
QTRAJ_API qtraj_status qtraj_mean_from_moments(const double* moments, double* mean_out, double* eigengap);

/** @} */

/* ---- Sample diagnostics: samples of any origin, neighbours sign-folded ---- */

/** @defgroup qtraj-sample-diagnostics Sample diagnostics
 * Of samples of any origin, any norm but 0, whatever their signs: neighbours are taken the shorter way round. A faulty
 * sample makes the rows that use it NaN, no others, and is reported even if no row uses it. A time is judged by the
 * finite ones before it.
 * @{ */

/** Mean angular velocities between neighbouring samples.
 *
 * @param frame      a qtraj_frame_value, of omega_out
 * @param times      [count], s, strictly increasing
 * @param q_wb       [count][4], w x y z, body to world, of any norm but 0
 * @param count      number of samples, 2 or more
 * @param t_mid_out  [count - 1], s, the middles of the intervals; may not overlap another array; may be NULL
 * @param omega_out  [count - 1][3], rad/s, row k from sample k to k + 1; may not overlap another array
 * @param bad_index  receives the index of the first sample at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN (the span of the times overflows):
 *     a sample; the one or two rows beside it are NaN in both outputs, all others are right;
 *   - QTRAJ_E_AMBIGUOUS, with the later sample: two are half a turn apart; that row has one of the two directions */
QTRAJ_API qtraj_status qtraj_estimate_omega(int32_t frame, const double* times, const double* q_wb, size_t count,
                                            double* t_mid_out, double* omega_out, size_t* bad_index);

/** Approximates the integral of |alpha|^2 by samples: the sum of |w_{k+1} - w_k|^2 / (m_{k+1} - m_k).
 *
 * w are the rates of qtraj_estimate_omega(), m the middles of their intervals.
 *
 * @param frame      a qtraj_frame_value, of the rates that are compared
 * @param times      [count], s, strictly increasing
 * @param q_wb       [count][4], w x y z, body to world, of any norm but 0
 * @param count      number of samples, 3 or more
 * @param energy     receives the sum, rad^2/s^3
 * @param bad_index  receives the index of the first sample at fault, SIZE_MAX where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE (a sample, or the sum exceeds 1e300 there), QTRAJ_E_ZERO_NORM, QTRAJ_E_TIME_ORDER,
 *     QTRAJ_E_TIME_SPAN (the span of the times overflows): energy is NaN;
 *   - QTRAJ_E_AMBIGUOUS, with the later sample: two are half a turn apart; energy is that of one of the directions */
QTRAJ_API qtraj_status qtraj_estimate_energy(int32_t frame, const double* times, const double* q_wb, size_t count,
                                             double* energy, size_t* bad_index);

/** By how much the estimated angular velocity of samples jumps at each knot.
 *
 * Row k is the rate of the first interval between samples that begins at or after knots[k], minus that of the last one
 * that ends at or before it; rates as of qtraj_estimate_omega().
 *
 * @param frame       a qtraj_frame_value, of jump_out
 * @param times       [count], s, strictly increasing
 * @param q_wb        [count][4], w x y z, body to world, of any norm but 0
 * @param count       number of samples, 2 or more
 * @param knots       [knot_count], s, in any order
 * @param knot_count  number of knots; where it is 0 knots and jump_out may be NULL; samples are checked all the same
 * @param jump_out    [knot_count][3], rad/s; may not overlap another array
 * @param bad_index   receives the first index at fault, that of a sample, or count plus that of a knot, SIZE_MAX where
 *                    there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_VALUE (frame), QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: a sample; rows that use its orientation are NaN, all others are right;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN: the time of a sample; all rows are NaN;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_TIME_RANGE (no interval on one side): a knot; its row is NaN, all others are right;
 *   - QTRAJ_E_AMBIGUOUS: a knot, beside which samples are half a turn apart; its row has one of the two directions */
QTRAJ_API qtraj_status qtraj_estimate_jumps(int32_t frame, const double* times, const double* q_wb, size_t count,
                                            const double* knots, size_t knot_count, double* jump_out,
                                            size_t* bad_index);

/** Rotation angle of each key to the sample nearest in time, at a tie the earlier one.
 *
 * The angle by which the body turns, signs ignored: twice the angle on S^3 that qtraj_distance() gives of the nearer
 * sign.
 *
 * @param key_times  [key_count], s, in any order
 * @param key_q      [key_count][4], w x y z, body to world, of any norm but 0
 * @param key_count  number of keys; where it is 0 their arrays and the outputs may be NULL, and samples are checked all
 *                   the same
 * @param times      [count], s, strictly increasing
 * @param q_wb       [count][4], w x y z, body to world, the samples; of any norm but 0
 * @param count      number of samples, 1 or more, without keys 0 too
 * @param error_out  [key_count], rad, in [0, pi]; may be key_times, not times
 * @param index_out  [key_count], index of that sample, SIZE_MAX where the row is at fault; may not overlap another
 *                   array; may be NULL
 * @param bad_index  receives the first index at fault, that of a key, or key_count plus that of a sample, SIZE_MAX
 *                   where there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_OVERLAP: nothing is written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM: a key, or a sample's orientation; rows of that key, or of keys that are
 *     nearest to that sample, are NaN, all others are right;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN (their span overflows): the time of a sample; all rows
 *     are NaN */
QTRAJ_API qtraj_status qtraj_keyframe_errors(const double* key_times, const double* key_q, size_t key_count,
                                             const double* times, const double* q_wb, size_t count, double* error_out,
                                             size_t* index_out, size_t* bad_index);

/** @} */

/* ---- Spline: double only; allocates working space ---- */

/** @defgroup qtraj-spline Spline
 * For numbers of any kind, positions for instance, in double.
 * @{ */

/** C2 cubic spline through rows of numbers, sampled at queries; allocates working space during the call.
 *
 * @param x            [count], strictly increasing: the knots
 * @param y            [count][dim], values at the knots
 * @param count        number of points, 2 or more
 * @param dim          numbers a row, each a spline of its own; where it is 0 y and y_out may be NULL
 * @param start        QTRAJ_END_DEFAULT (NATURAL), QTRAJ_END_NATURAL, QTRAJ_END_NOT_A_KNOT or QTRAJ_END_PERIODIC
 * @param end          the same at the last point; QTRAJ_END_PERIODIC is for both ends or none
 * @param queries      [query_count], in any order
 * @param query_count  number of queries; where it is 0 queries and y_out may be NULL; points are checked all the same
 * @param y_out        [query_count][dim]; may be an input of as many rows and as long ones
 * @param bad_index    receives the first index at fault, that of a point, or count plus that of a query, SIZE_MAX where
 *                     there is none; may be NULL
 * @return QTRAJ_OK, or
 *   - QTRAJ_E_NULL, QTRAJ_E_TOO_FEW, QTRAJ_E_SIZE, QTRAJ_E_VALUE (ends), QTRAJ_E_OVERLAP, QTRAJ_E_NO_MEMORY: nothing is
 *     written;
 *   - QTRAJ_E_NOT_FINITE, QTRAJ_E_TIME_ORDER, QTRAJ_E_TIME_SPAN (the span of x overflows): a point; all rows are NaN;
 *   - QTRAJ_E_NOT_CLOSED: PERIODIC, and the last point, at bad_index, has a y off the first by more than 1e-6 of the
 *     largest; all rows are NaN;
 *   - QTRAJ_E_NOT_FINITE (or a value overflows), QTRAJ_E_TIME_RANGE (outside x by more than 4 ulps of the larger end):
 *     a query; its row is NaN, all others are right */
QTRAJ_API qtraj_status qtraj_cubic_spline(const double* x, const double* y, size_t count, size_t dim, int32_t start,
                                          int32_t end, const double* queries, size_t query_count, double* y_out,
                                          size_t* bad_index);

/** @} */

#ifdef __cplusplus
}
#endif

/** @mainpage The C interface
 * @copybrief qtraj.h
 *
 * @copydetails qtraj.h */

#endif

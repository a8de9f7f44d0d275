/* docs/settings.md: which method has which setting, defaults, given rates. */
#include <math.h>
#include <string.h>

#include "claims.h"

/* Compiles as it stands there; returns 1 on an error. */
static int run_snippet(const double* keys, qtraj_trajectory** built) {
  qtraj_trajectory* curve;
#include "settings_snippet.c"
  *built = curve;
  return 0;
}

static void check_snippet(void) {
  double q[4], r[4];
  qtraj_options* options = options_of(QTRAJ_ROTATION_SPLINE);
  qtraj_trajectory *curve = NULL, *same;
  int run, k;
  CHECK(run_snippet(keys[0], &curve) == 0);
  if (curve == NULL) return;
  CHECK(!qtraj_sample_at(curve, -1, NULL, q) && !qtraj_sample_at(curve, times[0], NULL, r));
  for (k = 0; k < 4; ++k) CHECK(fabs(q[k] - r[k]) < 1e-15);
  CHECK(!qtraj_sample_at(curve, times[count - 1] + 1, NULL, q));
  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_CHORD, QTRAJ_END_CHORD));
  for (run = 0; run < 2; ++run) { /* options can be used again */
    CHECK(!qtraj_create_with_options(options, times, keys[0], count, &same, NULL) && distance(curve, same) == 0);
    qtraj_destroy(same);
  }
  qtraj_options_destroy(options);
  qtraj_destroy(curve);
}

static void check_end_conditions(void) {
  static const char taken[methods + 1][8] = {"", "", "", "DC  EGP", "D NK  P", "DCN EGP", "", "", ""};
  static const char letters[] = "DCNKEGP";
  static const int32_t ends[7] = {QTRAJ_END_DEFAULT,   QTRAJ_END_CHORD, QTRAJ_END_NATURAL, QTRAJ_END_NOT_A_KNOT,
                                  QTRAJ_END_ESTIMATED, QTRAJ_END_GIVEN, QTRAJ_END_PERIODIC};
  int method, k;
  for (method = 1; method <= methods; ++method) {
    qtraj_options* options = options_of(method);
    for (k = 0; k < 7; ++k) {
      const int yes = strchr(taken[method], letters[k]) != NULL;
      CHECK(qtraj_options_set_ends(options, ends[k], ends[k]) == (yes ? QTRAJ_OK : QTRAJ_E_SETTING));
      if (ends[k] != QTRAJ_END_PERIODIC)
        CHECK(qtraj_options_set_ends(options, ends[k], QTRAJ_END_PERIODIC) == QTRAJ_E_VALUE);
    }
    CHECK(qtraj_options_set_tangents(options, QTRAJ_TANGENT_DEFAULT) ==
          (method == QTRAJ_SQUAD ? QTRAJ_OK : QTRAJ_E_SETTING));
    CHECK(qtraj_options_set_reference(options, QTRAJ_REFERENCE_DEFAULT, NULL) ==
          (method == QTRAJ_LOG_SPLINE ? QTRAJ_OK : QTRAJ_E_SETTING));
    CHECK(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_ERROR) == QTRAJ_OK);
    CHECK(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_HOLD) ==
          QTRAJ_E_VALUE);
    qtraj_options_destroy(options);
  }
}

static void check_defaults(void) {
  qtraj_options* options = options_of(QTRAJ_SQUAD);
  CHECK(qtraj_options_set_ends(options, QTRAJ_END_CHORD, QTRAJ_END_CHORD) == QTRAJ_OK);
  CHECK(qtraj_options_set_tangents(options, QTRAJ_TANGENT_CATMULL_ROM) == QTRAJ_OK);
  CHECK(difference(with(options, keys), build(QTRAJ_SQUAD, count, times, keys)) == 0);
  CHECK(qtraj_options_set_tangents(options, QTRAJ_TANGENT_MEAN_VELOCITY) == QTRAJ_OK);
  CHECK(difference(with(options, keys), build(QTRAJ_SQUAD, count, times, keys)) > 1e-4);
  /* a setter that fails has no effect */
  CHECK(qtraj_options_set_tangents(options, 99) == QTRAJ_E_VALUE);
  CHECK(difference(with(options, keys), build(QTRAJ_SQUAD, count, times, keys)) > 1e-4);
  qtraj_options_destroy(options);

  options = options_of(QTRAJ_ROTATION_SPLINE);
  CHECK(qtraj_options_set_ends(options, QTRAJ_END_ESTIMATED, QTRAJ_END_ESTIMATED) == QTRAJ_OK);
  CHECK(difference(with(options, keys), build(QTRAJ_ROTATION_SPLINE, count, times, keys)) == 0);
  qtraj_options_destroy(options);

  options = options_of(QTRAJ_LOG_SPLINE);
  CHECK(qtraj_options_set_ends(options, QTRAJ_END_NATURAL, QTRAJ_END_NATURAL) == QTRAJ_OK);
  CHECK(qtraj_options_set_reference(options, QTRAJ_REFERENCE_FIRST, NULL) == QTRAJ_OK);
  CHECK(difference(with(options, keys), build(QTRAJ_LOG_SPLINE, count, times, keys)) == 0);
  qtraj_options_destroy(options);
}

static void check_given_rates(void) {
  const double slow[3] = {0.1, 0.2, -0.1}, nan_rate[3] = {NAN, 0, 0};
  double omega_body[count][3] = {{0}}, omega_world[count][3];
  qtraj_options* options = options_of(QTRAJ_SQUAD);
  qtraj_trajectory *a, *b;
  size_t bad;
  int i;

  /* a rate exactly for the ends that are GIVEN at that moment */
  CHECK(qtraj_options_set_end_rates(options, QTRAJ_FRAME_BODY, slow, slow) == QTRAJ_E_INPUT_UNWANTED);
  CHECK(qtraj_options_set_ends(options, QTRAJ_END_GIVEN, QTRAJ_END_CHORD) == QTRAJ_OK);
  CHECK(try_with(options, count, times, keys, &bad) == QTRAJ_E_INPUT_MISSING && bad == SIZE_MAX);
  CHECK(qtraj_options_set_end_rates(options, QTRAJ_FRAME_BODY, slow, slow) == QTRAJ_E_INPUT_UNWANTED);
  CHECK(qtraj_options_set_end_rates(options, QTRAJ_FRAME_BODY, NULL, NULL) == QTRAJ_E_INPUT_MISSING);
  CHECK(qtraj_options_set_end_rates(options, 0, slow, NULL) == QTRAJ_E_VALUE);
  CHECK(qtraj_options_set_end_rates(options, QTRAJ_FRAME_BODY, nan_rate, NULL) == QTRAJ_E_NOT_FINITE);
  CHECK(qtraj_options_set_end_rates(options, QTRAJ_FRAME_BODY, slow, NULL) == QTRAJ_OK);
  CHECK(try_with(options, count, times, keys, &bad) == QTRAJ_OK && bad == SIZE_MAX);

  /* frames: omega_world = q omega_body q^-1 */
  for (i = 0; i < count; ++i) {
    const double *q = keys[i], *w = omega_body[i];
    double* out = omega_world[i];
    omega_body[i][0] = 0.3;
    omega_body[i][1] = 0.1 * i;
    out[0] = (1 - 2 * (q[2] * q[2] + q[3] * q[3])) * w[0] + 2 * (q[1] * q[2] - q[0] * q[3]) * w[1];
    out[1] = 2 * (q[1] * q[2] + q[0] * q[3]) * w[0] + (1 - 2 * (q[1] * q[1] + q[3] * q[3])) * w[1];
    out[2] = 2 * (q[1] * q[3] - q[0] * q[2]) * w[0] + 2 * (q[2] * q[3] + q[0] * q[1]) * w[1];
  }
  CHECK(qtraj_options_set_ends(options, QTRAJ_END_DEFAULT, QTRAJ_END_DEFAULT) == QTRAJ_OK);
  CHECK(qtraj_options_set_tangents(options, QTRAJ_TANGENT_GIVEN) == QTRAJ_OK);
  CHECK(try_with(options, count, times, keys, NULL) == QTRAJ_E_INPUT_MISSING); /* the rates are missing */
  CHECK(!qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, times, keys[0], omega_body[0], NULL, count, &a, NULL));
  CHECK(!qtraj_create_with_rates(options, QTRAJ_FRAME_WORLD, times, keys[0], omega_world[0], NULL, count, &b, NULL));
  CHECK(distance(a, b) < 1e-14);
  qtraj_destroy(b);

  /* END_DEFAULT takes the end's rate from the keys, as GIVEN with that rate does; CHORD stays CHORD */
  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_GIVEN, QTRAJ_END_GIVEN));
  CHECK(!qtraj_options_set_end_rates(options, QTRAJ_FRAME_BODY, omega_body[0], omega_body[count - 1]));
  CHECK(!qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, times, keys[0], omega_body[0], NULL, count, &b, NULL));
  CHECK(distance(a, b) == 0);
  qtraj_destroy(b);
  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_CHORD, QTRAJ_END_CHORD));
  CHECK(!qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, times, keys[0], omega_body[0], NULL, count, &b, NULL));
  CHECK(difference(a, b) > 1e-3);

  /* too fast: |h omega/2 - L| at key 3 just below and just above 2 pi; there h = 1.5 before it, L is small */
  omega_body[3][0] = -8.5;
  CHECK(qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, times, keys[0], omega_body[0], NULL, count, &a, &bad) ==
        QTRAJ_E_RATE_TOO_FAST);
  CHECK(a == NULL && bad == 3);
  omega_body[3][0] = -7.0;
  CHECK(qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, times, keys[0], omega_body[0], NULL, count, &a, &bad) ==
        QTRAJ_OK);
  qtraj_destroy(a);
  qtraj_options_destroy(options);
}

/* ROTATION_SPLINE's end conditions, at the ends of the curve. */
static void check_spline_ends(void) {
  const double given[3] = {0.1, -0.3, 0.2}, ends[2] = {times[0], times[count - 1]};
  double omega[3], alpha[3], chord[2][3];
  qtraj_options* options = options_of(QTRAJ_ROTATION_SPLINE);
  qtraj_trajectory *curve, *slerp = build(QTRAJ_SLERP, count, times, keys);
  int end, k;
  CHECK(!qtraj_sample_rates(slerp, QTRAJ_FRAME_BODY, ends, 2, NULL, chord[0], NULL, NULL));
  qtraj_destroy(slerp);

  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_CHORD, QTRAJ_END_GIVEN));
  CHECK(!qtraj_options_set_end_rates(options, QTRAJ_FRAME_WORLD, NULL, given));
  curve = with(options, keys);
  CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, ends[0], NULL, NULL, omega, NULL));
  for (k = 0; k < 3; ++k) CHECK(fabs(omega[k] - chord[0][k]) < 1e-14);
  CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_WORLD, ends[1], NULL, NULL, omega, NULL));
  for (k = 0; k < 3; ++k) CHECK(fabs(omega[k] - given[k]) < 1e-14);
  qtraj_destroy(curve);

  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_NATURAL, QTRAJ_END_NATURAL));
  curve = with(options, keys);
  for (end = 0; end < 2; ++end) {
    CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, ends[end], NULL, NULL, NULL, alpha));
    CHECK(length(alpha) < 1e-12);
  }
  qtraj_destroy(curve);
  qtraj_options_destroy(options);
}

/* SQUAD, closed, with rates given: the first key's at the last too. */
static void check_closed_given(void) {
  double omega[count][3] = {{0.1, 0.2, 0.3}}, jump[count][3], first[3];
  qtraj_options* options = options_of(QTRAJ_SQUAD);
  qtraj_trajectory* curve;
  omega[count - 1][0] = -0.4;
  CHECK(!qtraj_options_set_tangents(options, QTRAJ_TANGENT_GIVEN));
  CHECK(!qtraj_options_set_ends(options, QTRAJ_END_PERIODIC, QTRAJ_END_PERIODIC));
  CHECK(
      !qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, times, closed_keys[0], omega[0], NULL, count, &curve, NULL));
  CHECK(!qtraj_curve_jumps(curve, QTRAJ_FRAME_BODY, jump[0], NULL) && length(jump[0]) < 1e-14);
  CHECK(!qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, times[0], NULL, NULL, first, NULL));
  CHECK(fabs(first[0] - 0.1) < 1e-14 && fabs(first[1] - 0.2) < 1e-14 && fabs(first[2] - 0.3) < 1e-14);
  qtraj_destroy(curve);
  qtraj_options_destroy(options);
}

/* Rates exactly for the methods and settings that use them. */
static void check_needs(void) {
  double zero[count][3] = {{0}};
  qtraj_trajectory* curve;
  int method, given;
  for (method = 1; method <= methods; ++method) {
    const int needed = method == QTRAJ_HERMITE ? 1 : method > QTRAJ_HERMITE ? 2 : 0;
    for (given = 0; given <= 2; ++given) {
      const qtraj_status status =
          given == 0 ? qtraj_create(method, times, keys[0], count, &curve, NULL)
                     : create_given(method, times, keys, zero, given == 2 ? zero : NULL, count, &curve, NULL);
      CHECK(status == (given < needed ? QTRAJ_E_INPUT_MISSING : given > needed ? QTRAJ_E_INPUT_UNWANTED : QTRAJ_OK));
      qtraj_destroy(curve);
    }
  }
}

void check_settings(void) {
  check_snippet();
  check_spline_ends();
  check_closed_given();
  check_needs();
  check_end_conditions();
  check_defaults();
  check_given_rates();
}

/* docs/errors.md and the limits of docs/guarantees.md: statuses, bad_index, rows of NaN. */
#include <math.h>
#include <string.h>

#include "claims.h"

/* SQUAD through the keys, of which one has another time and another w. */
static qtraj_status with_key(size_t key, double time, double w, size_t* bad) {
  double t[count], q[count][4];
  qtraj_trajectory* built;
  qtraj_status status;
  memcpy(t, times, sizeof t);
  memcpy(q, keys, sizeof q);
  t[key] = time;
  q[key][0] = w;
  status = qtraj_create(QTRAJ_SQUAD, t, q[0], count, &built, bad);
  CHECK((built == NULL) == (status != QTRAJ_OK));
  qtraj_destroy(built);
  return status;
}

/* Given rates that turn too far in an interval; key 1 has them, the interval is 2 s. */
static void check_limits(void) {
  const double t[3] = {0, 2, 3};
  double q[3][4] = {{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}};
  qtraj_trajectory* curve;
  size_t bad;
  int method;
  for (method = QTRAJ_HERMITE; method <= QTRAJ_QUATERNION_QUINTIC; ++method) {
    double omega[3][3] = {{0}}, alpha[3][3] = {{0}};
    const int power = method == QTRAJ_HERMITE ? 500 : 240;
    omega[1][0] = ldexp(1, power - 1);
    CHECK(!create_given(method, t, q, omega, method == QTRAJ_HERMITE ? NULL : alpha, 3, &curve, &bad));
    qtraj_destroy(curve);
    omega[1][0] = ldexp(1.01, power - 1);
    CHECK(create_given(method, t, q, omega, method == QTRAJ_HERMITE ? NULL : alpha, 3, &curve, &bad) ==
          QTRAJ_E_RATE_TOO_FAST);
    CHECK(curve == NULL && bad == 1);
    if (method == QTRAJ_HERMITE) continue;
    omega[1][0] = 0;
    alpha[1][1] = ldexp(1.01, power - 2);
    CHECK(create_given(method, t, q, omega, alpha, 3, &curve, &bad) == QTRAJ_E_RATE_TOO_FAST && bad == 1);
    alpha[1][1] = ldexp(1, power - 2);
    CHECK(!create_given(method, t, q, omega, alpha, 3, &curve, &bad));
    qtraj_destroy(curve);
  }
  { /* the rate of an end */
    const double still[3] = {0, 0, 0};
    double omega[3] = {0, 0, 0};
    qtraj_options* options = options_of(QTRAJ_ROTATION_SPLINE);
    CHECK(!qtraj_options_set_ends(options, QTRAJ_END_GIVEN, QTRAJ_END_GIVEN));
    omega[1] = ldexp(1.01, 199);
    CHECK(!qtraj_options_set_end_rates(options, QTRAJ_FRAME_BODY, omega, still));
    CHECK(try_with(options, 3, t, q, &bad) == QTRAJ_E_RATE_TOO_FAST && bad == 0);
    omega[1] = ldexp(1.01, 200);
    CHECK(!qtraj_options_set_end_rates(options, QTRAJ_FRAME_BODY, still, omega));
    CHECK(try_with(options, 3, t, q, &bad) == QTRAJ_E_RATE_TOO_FAST && bad == 2);
    qtraj_options_destroy(options);
  }
  { /* an energy past the largest double */
    const double soon[3] = {0, 1e-110, 1};
    double omega[3][3] = {{0, 0, 1e110}}, energy;
    CHECK(!create_given(QTRAJ_HERMITE, soon, q, omega, NULL, 3, &curve, NULL));
    CHECK(qtraj_curve_energy(curve, &energy) == QTRAJ_E_NOT_FINITE);
    qtraj_destroy(curve);
  }
}

/* All faults at once: which keys, and that the others make a curve. */
static void check_recordings(void) {
  const double wild[count] = {0, 1, 1e9, 3, 4, 4, 0, 7}, set_back[6] = {0, 1, 2, 3, 0.5, 1.5};
  int32_t statuses[count];
  double t[count], q[count][4], w;
  qtraj_key_report report;
  qtraj_trajectory* curve;
  size_t bad, k, good = 0;
  CHECK(qtraj_check_keys(wild, keys[0], count, statuses, &report, &bad) == QTRAJ_E_TIME_ORDER && bad == 2);
  for (k = 0; k < count; ++k) {
    CHECK(statuses[k] == (k == 2 || k == 5 || k == 6 ? QTRAJ_E_TIME_ORDER : QTRAJ_OK));
    if (statuses[k] != QTRAJ_OK) continue;
    t[good] = wild[k];
    memcpy(q[good++], keys[k], sizeof q[0]);
  }
  CHECK(report.faults == 3 && report.worst_norm_error < 1e-12);
  CHECK(report.longest_interval == 3 && report.longest_interval_index == 7);
  CHECK(!qtraj_create(QTRAJ_SQUAD, t, q[0], good, &curve, NULL));
  qtraj_destroy(curve);
  CHECK(qtraj_create(QTRAJ_SQUAD, wild, keys[0], count, &curve, &bad) == QTRAJ_E_TIME_ORDER && bad == 3);

  CHECK(qtraj_check_keys(set_back, keys[0], 6, statuses, &report, &bad) == QTRAJ_E_TIME_ORDER && bad == 4);
  CHECK(report.faults == 2);

  /* x y z w for w x y z keeps the norm; the time for the first component does not */
  for (k = 0; k < count; ++k) {
    w = keys[k][0];
    memmove(q[k], keys[k] + 1, 3 * sizeof w);
    q[k][3] = w;
  }
  CHECK(!qtraj_check_keys(times, q[0], count, NULL, &report, NULL) && report.worst_norm_error < 1e-12);
  for (k = 0; k < count; ++k) q[k][0] = times[k];
  CHECK(!qtraj_check_keys(times, q[0], count, NULL, &report, NULL) && report.worst_norm_error > 0.01);
}

/* Compiles as it stands there. */
static qtraj_status run_snippet(const double* keys, qtraj_trajectory** built, size_t* bad) {
  qtraj_trajectory* curve;
#include "errors_snippet.c"
  *built = curve;
  *bad = bad_index;
  return status;
}

void check_errors(void) {
  const double mixed[4] = {0.5, 8, NAN, 6.5}, uneven[4] = {0, 1e-153, 1e10, 2e10};
  double q[4][4], spread[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  qtraj_trajectory *trajectory, *none;
  qtraj_options* options;
  size_t bad;
  int32_t status;

  CHECK(with_key(2, 1.5, 1, &bad) == QTRAJ_OK && bad == SIZE_MAX);
  CHECK(with_key(2, 1.0, 1, &bad) == QTRAJ_E_TIME_ORDER && bad == 2);
  CHECK(with_key(1, 7.4e-155, 1, &bad) == QTRAJ_E_TIME_ORDER && bad == 1);
  CHECK(with_key(1, 7.5e-155, 1, &bad) == QTRAJ_OK);
  CHECK(with_key(3, INFINITY, 1, &bad) == QTRAJ_E_NOT_FINITE && bad == 3);
  CHECK(with_key(3, 3.0, NAN, &bad) == QTRAJ_E_NOT_FINITE && bad == 3);
  {
    double zero[3][4] = {{1, 0, 0, 0}, {0, 0, 0, 0}, {0, NAN, 0, 0}}; /* the lowest index decides */
    CHECK(qtraj_create(QTRAJ_SLERP, times, zero[0], 3, &none, &bad) == QTRAJ_E_ZERO_NORM && bad == 1);
  }
  {
    const double far[2] = {-1.7e308, 1.7e308};
    CHECK(qtraj_create(QTRAJ_SLERP, far, keys[0], 2, &none, &bad) == QTRAJ_E_TIME_SPAN && bad == 1);
  }
  CHECK(qtraj_create(QTRAJ_LOG_SPLINE, uneven, spread[0], 4, &none, &bad) == QTRAJ_E_NOT_FINITE && none == NULL);

  none = (qtraj_trajectory*)&none; /* not NULL */
  CHECK(qtraj_create(0, times, keys[0], count, &none, &bad) == QTRAJ_E_VALUE && none == NULL && bad == SIZE_MAX);
  CHECK(qtraj_create(QTRAJ_SLERP, NULL, keys[0], count, &none, NULL) == QTRAJ_E_NULL);
  CHECK(qtraj_create(QTRAJ_SLERP, times, keys[0], 1, &none, NULL) == QTRAJ_E_TOO_FEW);
  CHECK(qtraj_create(QTRAJ_SLERP, times, keys[0], SIZE_MAX / 8, &none, NULL) == QTRAJ_E_SIZE);

  check_limits();
  check_recordings();
  CHECK(run_snippet(keys[0], &trajectory, &bad) == QTRAJ_OK && bad == SIZE_MAX && trajectory != NULL);
  qtraj_destroy(trajectory);

  options = options_of(QTRAJ_LOG_SPLINE);
  CHECK(!qtraj_options_set_reference(options, QTRAJ_REFERENCE_MEAN, NULL));
  CHECK(try_with(options, 2, times, spread, &bad) == QTRAJ_E_AMBIGUOUS);
  qtraj_options_destroy(options);
  qtraj_options_destroy(NULL);
  qtraj_destroy(NULL);

  trajectory = build(QTRAJ_SQUAD, count, times, keys);
  CHECK(qtraj_sample(trajectory, mixed, 4, q[0], &bad) == QTRAJ_E_TIME_RANGE && bad == 1);
  CHECK(!isnan(q[0][0]) && isnan(q[1][0]) && isnan(q[2][0]) && !isnan(q[3][0]));
  q[0][0] = 3;
  CHECK(qtraj_sample(trajectory, q[0], 4, q[0], NULL) == QTRAJ_E_OVERLAP && q[0][0] == 3);
  CHECK(qtraj_sample(trajectory, NULL, 4, q[0], NULL) == QTRAJ_E_NULL && q[0][0] == 3);
  CHECK(qtraj_sample(trajectory, mixed, 0, NULL, NULL) == QTRAJ_OK);
  qtraj_destroy(trajectory);
  for (status = -1; status < 20; ++status) CHECK(qtraj_status_text(status)[0] != '\0');
}

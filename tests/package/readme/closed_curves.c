/* docs/settings.md: times outside the keys, closed curves. */
#include <math.h>
#include <string.h>

#include "claims.h"

static void check_extrapolation(void) {
  double q[4], r[4], s[4];
  int method, k;
  for (method = 1; method <= methods; ++method) {
    qtraj_options* options = options_of(method);
    qtraj_trajectory* trajectory = build(method, count, times, keys);
    CHECK(qtraj_sample_at(trajectory, -0.1, NULL, q) == QTRAJ_E_TIME_RANGE && isnan(q[0]) && isnan(q[3]));
    qtraj_destroy(trajectory);

    CHECK(!qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE));
    trajectory = with(options, keys);
    CHECK(!qtraj_sample_at(trajectory, -5, NULL, q) && !qtraj_sample_at(trajectory, 0, NULL, r));
    for (k = 0; k < 4; ++k) CHECK(fabs(q[k] - r[k]) < 1e-15);
    qtraj_sample_at(trajectory, 7 - 1e-4, NULL, q);
    qtraj_sample_at(trajectory, 7, NULL, r);
    qtraj_sample_at(trajectory, 7 + 1e-4, NULL, s);
    for (k = 0; k < 4; ++k) CHECK(fabs(q[k] - 2 * r[k] + s[k]) < 1e-7); /* no jump of the rate */
    CHECK(!qtraj_sample_at(trajectory, 1e100, NULL, q) && !qtraj_sample_at(trajectory, 1e200, NULL, r));
    CHECK(memcmp(q, r, sizeof q) == 0);
    CHECK(qtraj_sample_at(trajectory, INFINITY, NULL, q) == QTRAJ_E_NOT_FINITE && isnan(q[1]));
    CHECK(qtraj_sample_at(trajectory, NAN, NULL, q) == QTRAJ_E_NOT_FINITE && isnan(q[1]));
    qtraj_destroy(trajectory);

    CHECK(!qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC));
    trajectory = with(options, closed_keys);
    CHECK(!qtraj_sample_at(trajectory, 2.5, NULL, q) && !qtraj_sample_at(trajectory, 2.5 - 7 * 5, NULL, r));
    for (k = 0; k < 4; ++k) CHECK(fabs(fabs(q[k]) - fabs(r[k])) < 1e-13);
    qtraj_destroy(trajectory);
    qtraj_options_destroy(options);
  }
}

static qtraj_status try_any(const qtraj_options* options, size_t n, const double* t, double (*q)[4], size_t* bad) {
  qtraj_trajectory* built;
  const qtraj_status status = create(options, n, t, q, &built, bad);
  CHECK((built == NULL) == (status != QTRAJ_OK));
  qtraj_destroy(built);
  return status;
}

static void check_closed(void) {
  double almost[count][4], round[4][4], q[4], r[4];
  const double quarters[4] = {0, 1, 2, 3};
  size_t bad;
  int i, method;
  for (method = 1; method <= methods; ++method) {
    qtraj_options* options = options_of(method);
    qtraj_trajectory* trajectory;
    const int has_ends = qtraj_options_set_ends(options, QTRAJ_END_PERIODIC, QTRAJ_END_PERIODIC) == QTRAJ_OK;
    CHECK(has_ends == (method >= QTRAJ_SQUAD && method <= QTRAJ_ROTATION_SPLINE));
    if (has_ends) {
      CHECK(try_any(options, count, times, keys, &bad) == QTRAJ_E_NOT_CLOSED && bad == count - 1);
      CHECK(try_any(options, count, times, closed_keys, &bad) == QTRAJ_OK);
      CHECK(!qtraj_options_set_ends(options, QTRAJ_END_DEFAULT, QTRAJ_END_DEFAULT));
    }
    CHECK(!qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC));
    CHECK(try_any(options, count, times, keys, &bad) == QTRAJ_E_NOT_CLOSED && bad == count - 1);

    memcpy(almost, closed_keys, sizeof almost); /* key 0 is the identity */
    turn(1.01e-6, 1, 2, 3, almost[count - 1]);
    CHECK(try_any(options, count, times, almost, &bad) == QTRAJ_E_NOT_CLOSED && bad == count - 1);
    turn(0.99e-6, 1, 2, 3, almost[count - 1]);
    CHECK(try_any(options, count, times, almost, &bad) == QTRAJ_OK);
    trajectory = with(options, almost);
    qtraj_sample_at(trajectory, times[count - 1], NULL, q);
    CHECK(fabs(q[1]) + fabs(q[2]) + fabs(q[3]) < 1e-15 && fabs(fabs(q[0]) - 1) < 1e-15);
    qtraj_destroy(trajectory);

    /* a full turn in three steps: the last key is -1 times the first, and so is every second round */
    for (i = 0; i < 4; ++i) turn(i * 8 * atan(1.0) / 3, 1, 1, 1, round[i]);
    CHECK(create(options, 4, quarters, round, &trajectory, NULL) == QTRAJ_OK);
    qtraj_sample_at(trajectory, 0.5, NULL, q);
    for (i = -3; i <= 3; ++i) {
      qtraj_sample_at(trajectory, 0.5 + 3 * i, NULL, r);
      CHECK(fabs(r[0] - (i % 2 ? -q[0] : q[0])) < 1e-15 && fabs(r[1] - (i % 2 ? -q[1] : q[1])) < 1e-15);
    }
    qtraj_destroy(trajectory);
    if (method == QTRAJ_LOG_SPLINE) {
      CHECK(!qtraj_options_set_ends(options, QTRAJ_END_PERIODIC, QTRAJ_END_PERIODIC));
      CHECK(try_any(options, 4, quarters, round, &bad) == QTRAJ_E_NOT_CLOSED && bad == 3);
    }
    qtraj_options_destroy(options);
  }
}

void check_closed_curves(void) {
  check_extrapolation();
  check_closed();
}

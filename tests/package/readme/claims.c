#include "claims.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int failures = 0;
const double times[count] = {0, 1, 1.5, 3, 4, 4.2, 5, 7};
double keys[count][4];
static double omega_body[count][3], alpha_body[count][3];
double closed_keys[count][4];

void turn(double angle, double x, double y, double z, double q[4]) {
  const double s = sin(0.5 * angle) / sqrt(x * x + y * y + z * z);
  q[0] = cos(0.5 * angle);
  q[1] = s * x;
  q[2] = s * y;
  q[3] = s * z;
}

static void make_keys(void) {
  int i;
  for (i = 0; i < count; ++i) {
    turn(0.5 * times[i], 1 + 0.2 * sin(times[i]), 1, 0.5 * cos(times[i]), keys[i]);
    omega_body[i][0] = omega_body[i][1] = 0.3;
    alpha_body[i][2] = 0.02;
  }
  memcpy(closed_keys, keys, sizeof keys);
  memcpy(closed_keys[count - 1], keys[0], sizeof keys[0]);
}

qtraj_options* options_of(int32_t method) {
  qtraj_options* options;
  if (qtraj_options_create(method, &options) != QTRAJ_OK) exit(1);
  return options;
}

qtraj_status create(const qtraj_options* options, size_t n, const double* t, double (*q)[4], qtraj_trajectory** out,
                    size_t* bad) {
  qtraj_status status = qtraj_create_with_options(options, t, q[0], n, out, bad);
  if (status == QTRAJ_E_INPUT_MISSING)
    status = qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, t, q[0], omega_body[0], NULL, n, out, bad);
  if (status == QTRAJ_E_INPUT_MISSING)
    status = qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, t, q[0], omega_body[0], alpha_body[0], n, out, bad);
  return status;
}

qtraj_trajectory* build(int32_t method, size_t n, const double* t, double (*q)[4]) {
  qtraj_options* options = options_of(method);
  qtraj_trajectory* built;
  if (create(options, n, t, q, &built, NULL) != QTRAJ_OK) exit(1);
  qtraj_options_destroy(options);
  return built;
}

qtraj_status create_given(int32_t method, const double* t, double (*q)[4], double (*omega)[3], double (*alpha)[3],
                          size_t n, qtraj_trajectory** out, size_t* bad) {
  qtraj_options* options = options_of(method);
  const qtraj_status status =
      qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, t, q[0], omega[0], alpha ? alpha[0] : NULL, n, out, bad);
  qtraj_options_destroy(options);
  return status;
}

double length(const double v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

qtraj_status try_with(const qtraj_options* options, size_t n, const double* t, double (*q)[4], size_t* bad) {
  qtraj_trajectory* built;
  const qtraj_status status = qtraj_create_with_options(options, t, q[0], n, &built, bad);
  CHECK((built == NULL) == (status != QTRAJ_OK));
  qtraj_destroy(built);
  return status;
}

double distance(const qtraj_trajectory* a, const qtraj_trajectory* b) {
  double largest = 0, p[4], q[4];
  int i, k;
  for (i = 0; i <= 700; ++i) {
    const double time = qtraj_start_time(a) + (qtraj_end_time(a) - qtraj_start_time(a)) * i / 700;
    if (qtraj_sample_at(a, time, NULL, p) || qtraj_sample_at(b, time, NULL, q)) return INFINITY;
    for (k = 0; k < 4; ++k) largest = fmax(largest, fabs(p[k] - q[k]));
  }
  return largest;
}

double difference(qtraj_trajectory* a, qtraj_trajectory* b) {
  const double result = distance(a, b);
  qtraj_destroy(a);
  qtraj_destroy(b);
  return result;
}

qtraj_trajectory* with(const qtraj_options* options, double (*q)[4]) {
  qtraj_trajectory* built;
  if (create(options, count, times, q, &built, NULL) != QTRAJ_OK) exit(1);
  return built;
}

int main(void) {
  make_keys();
  check_curves();
  check_methods();
  check_orders();
  check_settings();
  check_rates();
  check_closed_curves();
  check_errors();
  check_guarantees();
  check_functions();
  printf("%d claims of the pages in docs/ are not so\n", failures);
  return failures != 0;
}

/* What the pages in docs/ say about the library's behaviour, claim by claim, as far as it needs no reference values. A
 * file for each page. */
#ifndef CLAIMS_H
#define CLAIMS_H

#include <qtraj.h>
#include <stdio.h>

extern int failures;
#define CHECK(claim) ((claim) ? (void)0 : (void)(++failures, printf("%s:%d: not so: %s\n", __FILE__, __LINE__, #claim)))

enum { count = 8, methods = 8 };
extern const double times[count];
extern double keys[count][4]; /* a tumbling body, norm 1, sign-continuous */
extern double closed_keys[count][4];

/* The rotation by an angle, rad, about an axis of any length. */
void turn(double angle, double x, double y, double z, double q[4]);

qtraj_options* options_of(int32_t method);
/* Builds with the rates of some motion, of which the method gets those that it needs. */
qtraj_status create(const qtraj_options* options, size_t n, const double* t, double (*q)[4], qtraj_trajectory** out,
                    size_t* bad);
/* The same with the method's defaults, or through `count` keys; ends the program on an error. */
qtraj_trajectory* build(int32_t method, size_t n, const double* t, double (*q)[4]);
qtraj_trajectory* with(const qtraj_options* options, double (*q)[4]);
/* Through keys with rates of the caller's, in the body frame. */
qtraj_status create_given(int32_t method, const double* t, double (*q)[4], double (*omega)[3], double (*alpha)[3],
                          size_t n, qtraj_trajectory** out, size_t* bad);
/* Builds without rates and destroys. */
qtraj_status try_with(const qtraj_options* options, size_t n, const double* t, double (*q)[4], size_t* bad);

/* Largest difference of a component, over the whole curve. */
double distance(const qtraj_trajectory* a, const qtraj_trajectory* b);
/* The same, and destroys both. */
double difference(qtraj_trajectory* a, qtraj_trajectory* b);

double length(const double v[3]);

void check_curves(void);
void check_methods(void);
void check_orders(void);
void check_settings(void);
void check_rates(void);
void check_closed_curves(void);
void check_errors(void);
void check_guarantees(void);
void check_functions(void);

#endif

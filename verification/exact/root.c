/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/root.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#include <math.h>

double root_between(double (*function)(double, void *), void *context, double low, double high,
                    double tolerance)
{
    enum { ROUNDS = 200 };
    gsl_function f = {.function = function, .params = context};
    gsl_error_handler_t *const handler = gsl_set_error_handler_off();
    gsl_root_fsolver *const solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    int status = solver == NULL ? GSL_ENOMEM : gsl_root_fsolver_set(solver, &f, low, high);
    int test = GSL_CONTINUE;
    for (int round = 0; status == GSL_SUCCESS && test == GSL_CONTINUE && round < ROUNDS; round++) {
        status = gsl_root_fsolver_iterate(solver);
        test = gsl_root_test_interval(gsl_root_fsolver_x_lower(solver),
                                      gsl_root_fsolver_x_upper(solver), 0.0, tolerance);
    }
    const double root =
        status == GSL_SUCCESS && test == GSL_SUCCESS ? gsl_root_fsolver_root(solver) : (double)NAN;
    if (solver != NULL)
        gsl_root_fsolver_free(solver);
    gsl_set_error_handler(handler);
    return root;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/bisection.h"

#include <math.h>

static enum mpm_status climb(const double *ladder, size_t count, bisection_test *test,
                             void *context, struct bisection_border *border,
                             struct mpm_error *error)
{
    *border = (struct bisection_border){.fails = HUGE_VAL};
    for (size_t k = 0; k < count; k++) {
        bool passes = false;
        const enum mpm_status status = test(context, ladder[k], &passes, error);
        if (status != MPM_OK)
            return status;
        const bool above = isfinite(border->fails);
        border->passed += passes;
        border->stray += passes && above;
        if (passes && !above)
            border->passes = ladder[k];
        if (!passes && !above)
            border->fails = ladder[k];
    }
    return MPM_OK;
}

enum mpm_status bisection_find(const double *ladder, size_t count, double tolerance,
                               bisection_test *test, void *context, struct bisection_border *border,
                               struct mpm_error *error)
{
    enum mpm_status status = climb(ladder, count, test, context, border, error);
    while (status == MPM_OK && border->passes > 0.0 && isfinite(border->fails) &&
           border->fails > border->passes * (1.0 + tolerance)) {
        const double middle = sqrt(border->passes * border->fails);
        bool passes = false;
        status = test(context, middle, &passes, error);
        if (status == MPM_OK)
            *(passes ? &border->passes : &border->fails) = middle;
    }
    return status;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/grid_convergence.h"

#include <math.h>
#include <stdbool.h>

struct grid_convergence grid_convergence(double coarse, double medium, double fine, double ratio,
                                         double safety)
{
    const double quotient = (coarse - medium) / (medium - fine);
    if (!(quotient > 1.0) || isinf(quotient) || !(ratio > 1.0))
        return (struct grid_convergence){(double)NAN, (double)NAN, (double)NAN};
    /* ratio^order is the quotient itself */
    const double correction = (fine - medium) / (quotient - 1.0);
    return (struct grid_convergence){.order = log(quotient) / log(ratio),
                                     .extrapolated = fine + correction,
                                     .index = safety * fabs(correction / fine)};
}

/* Where the order is not known well enough for Roache's own factor. */
static const double SAFETY_UNSURE = 3.0;
static const double LEAST_ORDER = 0.5;
static const double NEAR_FORMAL = 0.1;

double grid_uncertainty(size_t count, const double *values, double ratio, double formal_order)
{
    if (count < 2)
        return (double)NAN;
    const double *const last = &values[count - 1];
    double order = 1.0, safety = SAFETY_UNSURE;
    if (count > 2) {
        const double observed =
            grid_convergence(last[-2], last[-1], last[0], ratio, GRID_CONVERGENCE_SAFETY).order;
        const bool formal = fabs(observed - formal_order) <= NEAR_FORMAL * formal_order;
        order = formal ? formal_order
                       : fmax(LEAST_ORDER, fmin(isnan(observed) ? 0.0 : observed, formal_order));
        safety = formal ? GRID_CONVERGENCE_SAFETY : SAFETY_UNSURE;
    }
    return safety * fabs((last[0] - last[-1]) / last[0]) / (pow(ratio, order) - 1.0);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/grid_convergence.h"

#include <math.h>

struct grid_convergence grid_convergence(double coarse, double medium, double fine, double ratio,
                                         double safety)
{
    const double quotient = (coarse - medium) / (medium - fine);
    if (!(quotient > 1.0) || !(ratio > 1.0))
        return (struct grid_convergence){(double)NAN, (double)NAN, (double)NAN};
    /* ratio^order is the quotient itself */
    const double correction = (fine - medium) / (quotient - 1.0);
    return (struct grid_convergence){.order = log(quotient) / log(ratio),
                                     .extrapolated = fine + correction,
                                     .index = safety * fabs(correction / fine)};
}

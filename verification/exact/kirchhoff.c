/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/kirchhoff.h"

#include <math.h>

double kirchhoff_theta(const struct kirchhoff *table, double temperature)
{
    double sum = 0.0;
    for (size_t k = 1; k < table->count && temperature > table->point[k - 1][0]; k++) {
        const double *const below = table->point[k - 1], *const above = table->point[k];
        const double end = fmin(temperature, above[0]);
        const double part = (end - below[0]) / (above[0] - below[0]);
        sum += (end - below[0]) * 0.5 * (below[1] + (1.0 - part) * below[1] + part * above[1]);
    }
    return sum;
}

double kirchhoff_temperature(const struct kirchhoff *table, double from, double rise)
{
    enum { HALVINGS = 200 };
    const double wanted = kirchhoff_theta(table, from) + rise;
    double low = table->point[0][0], high = table->point[table->count - 1][0];
    if (!(wanted >= 0.0 && wanted <= kirchhoff_theta(table, high)))
        return (double)NAN;
    for (int k = 0; k < HALVINGS && low < high; k++) {
        const double middle = 0.5 * (low + high);
        if (kirchhoff_theta(table, middle) < wanted)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

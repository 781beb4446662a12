/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/property.h"

#include <math.h>

/* The first point that is above T, 0 to count. */
static size_t first_above(const struct mpm_property *property, double temperature)
{
    size_t low = 0, high = property->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (property->points[middle][0] <= temperature)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* dv/dT between the points k - 1 and k; 0 outside of the table. */
static double slope(const struct mpm_property *property, size_t k)
{
    if (k == 0 || k == property->count)
        return 0.0;
    const double *const below = property->points[k - 1], *const above = property->points[k];
    return (above[1] - below[1]) / (above[0] - below[0]);
}

/* A point that the part of the table below point k ends at: that part's value follows from it. */
static const double *anchor(const struct mpm_property *property, size_t k)
{
    return property->points[k == 0 ? 0 : k - 1];
}

static double value_in(const struct mpm_property *property, size_t k, double temperature)
{
    const double *const point = anchor(property, k);
    return point[1] + slope(property, k) * (temperature - point[0]);
}

double mpm_property_value(const struct mpm_property *property, double temperature)
{
    return value_in(property, first_above(property, temperature), temperature);
}

double mpm_property_slope(const struct mpm_property *property, double temperature)
{
    return slope(property, first_above(property, temperature));
}

/* From the anchor of that part. */
static double integral_in(const struct mpm_property *property, size_t k, double temperature)
{
    const double *const point = anchor(property, k);
    const double along = temperature - point[0];
    return along * (point[1] + 0.5 * slope(property, k) * along);
}

double mpm_property_integral(const struct mpm_property *property, double temperature)
{
    const size_t k = first_above(property, temperature);
    return property->integral[k == 0 ? 0 : k - 1] + integral_in(property, k, temperature);
}

void mpm_property_prepare(const struct mpm_property *property)
{
    double *const integral = property->integral;
    if (property->count == 0)
        return;
    integral[0] = 0.0;
    for (size_t k = 1; k < property->count; k++)
        integral[k] = integral[k - 1] + integral_in(property, k, property->points[k][0]);
    const double below_zero = mpm_property_integral(property, 0.0);
    for (size_t k = 0; k < property->count; k++)
        integral[k] -= below_zero;
}

bool mpm_property_covers(const struct mpm_property *property, double temperature)
{
    return property->count == 0 || (temperature >= property->points[0][0] &&
                                    temperature <= property->points[property->count - 1][0]);
}

/* The part in which T goes on in that direction: at a point the one beyond it. */
static size_t part_ahead(const struct mpm_property *property, double temperature, bool up)
{
    const size_t k = first_above(property, temperature);
    return !up && k > 0 && property->points[k - 1][0] == temperature ? k - 1 : k;
}

double mpm_property_rise(const struct mpm_property *property, double temperature, double content)
{
    const bool up = content > 0.0;
    double at = temperature, left = content;
    for (size_t k = part_ahead(property, at, up);; k = up ? k + 1 : k - 1) {
        const double v = value_in(property, k, at), root = v * v + 2.0 * slope(property, k) * left;
        const double rise = root > 0.0 ? 2.0 * left / (v + sqrt(root)) : copysign(HUGE_VAL, left);
        if (up ? k == property->count : k == 0)
            return at - temperature + rise;
        const double end = property->points[up ? k : k - 1][0];
        if (up ? rise <= end - at : rise >= end - at)
            return at == temperature ? rise : at - temperature + rise;
        left -= 0.5 * (v + property->points[up ? k : k - 1][1]) * (end - at);
        at = end;
    }
}

double mpm_property_least(const struct mpm_property *property)
{
    double least = HUGE_VAL;
    for (size_t k = 0; k < property->count; k++)
        least = fmin(least, property->points[k][1]);
    return least;
}

double mpm_property_largest(const struct mpm_property *property)
{
    double largest = 0.0;
    for (size_t k = 0; k < property->count; k++)
        largest = fmax(largest, property->points[k][1]);
    return largest;
}

double mpm_property_largest_ratio(const struct mpm_property *over, const struct mpm_property *under)
{
    const struct mpm_property *const both[] = {over, under};
    double largest = -1.0;
    for (int which = 0; which < 2; which++)
        for (size_t k = 0; k < both[which]->count; k++) {
            const double at = both[which]->points[k][0];
            if (mpm_property_covers(both[1 - which], at))
                largest =
                    fmax(largest, mpm_property_value(over, at) / mpm_property_value(under, at));
        }
    return largest;
}

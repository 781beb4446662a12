/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/energy_curve.h"

#include <math.h>

enum { FEWEST = 5 };

static double change(const struct energy_curve *curve, size_t row)
{
    return curve->total[row * curve->stride] - 1.0;
}

static double time_of(const struct energy_curve *curve, size_t row)
{
    return curve->time[row * curve->stride];
}

double energy_curve_extreme(const struct energy_curve *curve)
{
    double extreme = curve->count > 0 ? 0.0 : (double)NAN;
    for (size_t k = 0; k < curve->count; k++)
        if (!(fabs(change(curve, k)) <= fabs(extreme)))
            extreme = isnan(extreme) ? extreme : change(curve, k);
    return extreme;
}

double energy_curve_mean(const struct energy_curve *curve, double from, double to)
{
    double sum = 0.0, count = 0.0;
    for (size_t k = 0; k < curve->count; k++)
        if (time_of(curve, k) >= from && time_of(curve, k) <= to) {
            sum += change(curve, k);
            count += 1.0;
        }
    return sum / count;
}

double energy_curve_time_off(const struct energy_curve *curve, double limit)
{
    for (size_t k = 0; k < curve->count; k++)
        if (!(fabs(change(curve, k)) <= limit))
            return time_of(curve, k);
    return (double)NAN;
}

/* d(U/E(0))/dt at an inner row */
static double power(const struct energy_curve *curve, size_t row)
{
    const double rise =
        curve->strain[(row + 1) * curve->stride] - curve->strain[(row - 1) * curve->stride];
    return rise / (time_of(curve, row + 1) - time_of(curve, row - 1));
}

/* A straight line by least squares, through the mean. */
struct line {
    double time, value, slope;
};

static struct line line_through(const struct energy_curve *curve,
                                double (*value)(const struct energy_curve *, size_t))
{
    struct line line = {0.0, 0.0, 0.0};
    double above = 0.0, below = 0.0;
    const size_t last = curve->count - 1;
    for (size_t k = 1; k < last; k++) {
        line.time += time_of(curve, k) / (double)(last - 1);
        line.value += value(curve, k) / (double)(last - 1);
    }
    for (size_t k = 1; k < last; k++) {
        const double t = time_of(curve, k) - line.time;
        above += t * (value(curve, k) - line.value);
        below += t * t;
    }
    line.slope = above / below;
    return line;
}

static double beside(const struct line *line, double time, double value)
{
    return value - line->value - line->slope * (time - line->time);
}

double energy_curve_swing(const struct energy_curve *curve, double time_step)
{
    if (curve->count < FEWEST)
        return (double)NAN;
    const struct line of_change = line_through(curve, change);
    const struct line of_power = line_through(curve, power);
    double above = 0.0, below = 0.0;
    for (size_t k = 1; k + 1 < curve->count; k++) {
        const double t = time_of(curve, k), p = beside(&of_power, t, power(curve, k));
        above += p * beside(&of_change, t, change(curve, k));
        below += p * p;
    }
    return above / (0.5 * time_step * below);
}

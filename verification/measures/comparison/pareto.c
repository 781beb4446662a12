/* Error against cost.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison/pareto.h"

#include <math.h>
#include <stdbool.h>

static bool counts(const struct pareto_point *point)
{
    return isfinite(point->cost) && isfinite(point->error) && point->cost > 0 && point->error >= 0;
}

static bool dominates(const struct pareto_point *one, const struct pareto_point *other)
{
    return one->cost <= other->cost && one->error <= other->error &&
           (one->cost < other->cost || one->error < other->error);
}

static bool is_equal(const struct pareto_point *one, const struct pareto_point *other)
{
    return !(one->cost < other->cost) && !(other->cost < one->cost) &&
           !(one->error < other->error) && !(other->error < one->error);
}

static bool is_on_front(const struct pareto_point *points, size_t count, size_t place)
{
    if (!counts(&points[place]))
        return false;
    for (size_t i = 0; i < count; i++)
        if (counts(&points[i]) && (dominates(&points[i], &points[place]) ||
                                   (i < place && is_equal(&points[i], &points[place]))))
            return false;
    return true;
}

size_t pareto_front(const struct pareto_point *points, size_t count, size_t *front)
{
    size_t found = 0;
    for (size_t i = 0; i < count; i++) {
        if (!is_on_front(points, count, i))
            continue;
        size_t place = found++;
        for (; place > 0 && points[front[place - 1]].cost > points[i].cost; place--)
            front[place] = front[place - 1];
        front[place] = i;
    }
    return found;
}

/* On the straight line through two points in logarithms; the finer one may have error 0. */
static double interpolate(const struct pareto_point *coarse, const struct pareto_point *fine,
                          double error)
{
    if (fine->error <= 0)
        return fine->cost;
    const double part = log(coarse->error / error) / log(coarse->error / fine->error);
    return coarse->cost * pow(fine->cost / coarse->cost, part);
}

struct pareto_cost pareto_cost_to_reach(const struct pareto_point *ladder, size_t count,
                                        double error)
{
    for (size_t i = 0; i < count; i++) {
        if (!counts(&ladder[i]) || ladder[i].error > error)
            continue;
        if (i == 0 || !counts(&ladder[i - 1]))
            return (struct pareto_cost){PARETO_AT_MOST, ladder[i].cost};
        return (struct pareto_cost){PARETO_REACHED, interpolate(&ladder[i - 1], &ladder[i], error)};
    }
    return (struct pareto_cost){PARETO_NOT_REACHED, (double)NAN};
}

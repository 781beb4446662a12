/* Error against cost: which points are worth their cost, and what an error costs. Pure
 * functions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_PARETO_H
#define VERIFICATION_MEASURES_PARETO_H

#include <stddef.h>

/* A run: what it cost and how wrong it was. One with a value that is not finite, a cost that
 * is not above zero or a negative error (a run that failed) is on no front and reaches
 * nothing. */
struct pareto_point {
    double cost, error;
};

/* The points that no other one dominates (costs no more and errs no more, and less in one of
 * the two), by rising cost; of equal ones the first. Their places go to front[0 .. count - 1]
 * (room for `count`); returns how many there are. Cost: O(count^2). */
size_t pareto_front(const struct pareto_point *points, size_t count, size_t *front);

enum pareto_reach {
    PARETO_NOT_REACHED, /* by no run of the ladder */
    PARETO_AT_MOST,     /* by the first run that counts: the cost is an upper bound */
    PARETO_REACHED,     /* between two neighbouring runs: interpolated */
};

struct pareto_cost {
    enum pareto_reach reach;
    double cost; /* NaN if not reached */
};

/* What a ladder (runs of one method from coarse to fine) costs where it first comes down to
 * `error` > 0: between two neighbours error is taken as a power of cost. Never extrapolated;
 * a failed run between two others breaks the ladder, so that the one after it, if good
 * enough, is an upper bound. */
struct pareto_cost pareto_cost_to_reach(const struct pareto_point *ladder, size_t count,
                                        double error);

#endif

/* What takes part in a manufactured motion, and when it is refused for what does not.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/manufactured/manufactured_sample.h"

enum { AXES = 2, SAMPLES = 40, COARSE = 12, TIMES = 64 };

/* What is still a part of the whole: of a term, of the period's largest, of the field at nodes. */
static const double LEAST_TERM = 0.02, LEAST_MOTION = 0.05, LEAST_AT_NODES = 0.1;
/* A component with less than this part of the other one's motion has none. */
static const double NO_MOTION = 1e-9;
/* Round-off, over the amplitude, that a field may leave where it is zero. */
static const double ZERO = 1e-9;
static const double MOST_NODES = 1e6;

/* Sums of squares over places. */
struct squares {
    double acceleration[AXES], divergence[AXES], hoop[AXES], nonlinear[AXES];
    double velocity[AXES], displacement[AXES];
    double least_j;
    size_t count;
};

static void add_squares(const struct manufactured_problem *problem, const double place[AXES],
                        double time, struct squares *sum)
{
    struct manufactured_state s;
    manufactured_evaluate(problem, place, time, &s);
    const double *const f = s.deformation;
    sum->least_j = fmin(sum->least_j, (f[0] * f[3] - f[1] * f[2]) * f[4]);
    for (int axis = 0; axis < AXES; axis++) {
        const double inertia = problem->density * s.acceleration[axis];
        const double nonlinear = s.divergence[axis] - s.linear[axis];
        sum->acceleration[axis] += inertia * inertia;
        sum->divergence[axis] += s.divergence[axis] * s.divergence[axis];
        sum->hoop[axis] += s.hoop[axis] * s.hoop[axis];
        sum->nonlinear[axis] += nonlinear * nonlinear;
        sum->velocity[axis] += s.velocity[axis] * s.velocity[axis];
        sum->displacement[axis] += s.displacement[axis] * s.displacement[axis];
    }
    sum->count++;
}

/* Over the middles of n by n parts of the domain. */
static struct squares squares_at(const struct manufactured_problem *problem, double time, int n)
{
    struct squares sum = {.least_j = HUGE_VAL};
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            const double part[AXES] = {(i + 0.5) / n, (j + 0.5) / n};
            double place[AXES];
            (void)manufactured_place(problem, part, place);
            add_squares(problem, place, time, &sum);
        }
    return sum;
}

/* ------------------------------------------------------------------- shares */

static double root_of_part(double part, double whole)
{
    return whole > 0.0 ? sqrt(part / whole) : 0.0;
}

/* The nodes in the domain; false if there are too many or none. */
static bool squares_at_nodes(const struct manufactured_problem *problem, double time,
                             const double cell[AXES], struct squares *sum)
{
    const struct manufactured_domain *const d = &problem->domain;
    const bool annulus = d->region == MANUFACTURED_ANNULUS;
    const double slack = 1e-9; /* of a cell */
    double counts[AXES];
    for (int axis = 0; axis < AXES; axis++)
        counts[axis] = floor((d->high[axis] - d->low[axis]) / cell[axis] + slack);
    *sum = (struct squares){.least_j = HUGE_VAL};
    if (!(cell[0] > 0.0 && cell[1] > 0.0 && (counts[0] + 1.0) * (counts[1] + 1.0) <= MOST_NODES))
        return false;
    for (int i = 0; i <= (int)counts[0]; i++)
        for (int j = 0; j <= (int)counts[1]; j++) {
            const double place[AXES] = {d->low[0] + i * cell[0], d->low[1] + j * cell[1]};
            const double radius = hypot(place[0], place[1]);
            if (!annulus || (radius >= d->inner && radius <= d->outer))
                add_squares(problem, place, time, sum);
        }
    return sum->count > 0;
}

static struct manufactured_activity shares_of(const struct squares *now,
                                              const struct squares *coarse,
                                              const struct squares *largest,
                                              const struct squares *nodes)
{
    struct manufactured_activity a = {0};
    const double points = (double)now->count, node_count = (double)nodes->count;
    for (int axis = 0; axis < AXES; axis++) {
        const double whole = now->acceleration[axis] + now->divergence[axis];
        a.acceleration[axis] = root_of_part(now->acceleration[axis], whole);
        a.divergence[axis] = root_of_part(now->divergence[axis], whole);
        a.hoop[axis] = root_of_part(now->hoop[axis], whole);
        a.velocity[axis] = root_of_part(coarse->velocity[axis], largest->velocity[axis]);
        a.displacement[axis] =
            root_of_part(coarse->displacement[axis], largest->displacement[axis]);
        a.nodes[axis] =
            root_of_part(nodes->displacement[axis] / node_count, now->displacement[axis] / points);
    }
    a.nonlinear = root_of_part(now->nonlinear[0] + now->nonlinear[1],
                               now->acceleration[0] + now->acceleration[1] + now->divergence[0] +
                                   now->divergence[1]);
    return a;
}

/* ---------------------------------------------------------------- refusals */

static enum mpm_status check_share(const char *what, int axis, double share, double least,
                                   double time, struct mpm_error *error)
{
    if (share >= least)
        return MPM_OK;
    return manufactured_refuse(error,
                               "degenerate at time %g: %s of component %d is %.3g; allowed: at "
                               "least %g",
                               time, what, axis, share, least);
}

static enum mpm_status check_component(const struct manufactured_problem *problem, int axis,
                                       const struct manufactured_activity *a, double time,
                                       struct mpm_error *error)
{
    const struct {
        const char *what;
        double share, least;
    } checks[] = {
        {"velocity over its largest (a turning point)", a->velocity[axis], LEAST_MOTION},
        {"displacement over its largest (a passage through zero)", a->displacement[axis],
         LEAST_MOTION},
        {"displacement at the nodes over that at all points", a->nodes[axis], LEAST_AT_NODES},
        {"the share of the acceleration", a->acceleration[axis], LEAST_TERM},
        {"the share of the stress divergence", a->divergence[axis], LEAST_TERM},
        {"the share of the hoop terms", problem->geometry == MPM_AXISYMMETRIC ? a->hoop[axis] : 1.0,
         LEAST_TERM},
    };
    for (size_t k = 0; k < sizeof checks / sizeof *checks; k++)
        if (check_share(checks[k].what, axis, checks[k].share, checks[k].least, time, error) !=
            MPM_OK)
            return MPM_BAD_INPUT;
    return MPM_OK;
}

/* u = 0 at t = 0; on the axis u_r = 0 and (u_z)_R = 0. */
static enum mpm_status check_places(const struct manufactured_problem *problem, double amplitude,
                                    struct mpm_error *error)
{
    const bool axis = problem->geometry == MPM_AXISYMMETRIC && problem->domain.low[0] == 0.0;
    for (int i = 0; i < COARSE; i++)
        for (int j = 0; j < COARSE; j++) {
            const double part[AXES] = {(i + 0.5) / COARSE, (j + 0.5) / COARSE};
            struct manufactured_state s;
            double place[AXES];
            (void)manufactured_place(problem, part, place);
            manufactured_evaluate(problem, place, 0.0, &s);
            if (!(hypot(s.displacement[0], s.displacement[1]) <= ZERO * amplitude))
                return manufactured_refuse(error,
                                           "displacement at (%g, %g), time 0, is %g %g; "
                                           "allowed: 0",
                                           place[0], place[1], s.displacement[0],
                                           s.displacement[1]);
            place[0] = 0.0;
            if (axis)
                manufactured_evaluate(problem, place, problem->end, &s);
            if (axis &&
                !(fabs(s.displacement[0]) <= ZERO * amplitude && fabs(s.deformation[2]) <= ZERO))
                return manufactured_refuse(error,
                                           "not regular on the axis: at z = %g, u_r = %g "
                                           "and F_zr = %g; allowed: 0 and 0",
                                           place[1], s.displacement[0], s.deformation[2]);
        }
    return MPM_OK;
}

/* The largest of a period; MPM_BAD_INPUT: a body inside out. */
static enum mpm_status look_at_period(const struct manufactured_problem *problem,
                                      struct squares *largest, struct mpm_error *error)
{
    *largest = (struct squares){0};
    for (int k = 0; k < TIMES; k++) {
        const double time = problem->period * k / TIMES;
        const struct squares now = squares_at(problem, time, COARSE);
        if (!(now.least_j > 0.0))
            return manufactured_refuse(error,
                                       "det F is %g at time %g; allowed: above 0 (a smaller "
                                       "amplitude)",
                                       now.least_j, time);
        for (int axis = 0; axis < AXES; axis++) {
            largest->velocity[axis] = fmax(largest->velocity[axis], now.velocity[axis]);
            largest->displacement[axis] = fmax(largest->displacement[axis], now.displacement[axis]);
        }
    }
    return MPM_OK;
}

enum mpm_status manufactured_activity(const struct manufactured_problem *problem, double time,
                                      const double cell[2], struct manufactured_activity *activity,
                                      struct mpm_error *error)
{
    struct squares largest, nodes;
    if (look_at_period(problem, &largest, error) != MPM_OK)
        return MPM_BAD_INPUT;
    const double most = fmax(largest.displacement[0], largest.displacement[1]);
    if (!(most > 0.0))
        return manufactured_refuse(error, "no displacement in a whole period; allowed: some");
    if (check_places(problem, sqrt(most) / COARSE, error) != MPM_OK)
        return MPM_BAD_INPUT;
    if (!squares_at_nodes(problem, time, cell, &nodes))
        return manufactured_refuse(error,
                                   "cells of %g by %g; allowed: such that 1 to %g nodes are "
                                   "in the domain",
                                   cell[0], cell[1], MOST_NODES);
    const struct squares now = squares_at(problem, time, SAMPLES);
    const struct squares coarse = squares_at(problem, time, COARSE); /* as the largest are */
    *activity = shares_of(&now, &coarse, &largest, &nodes);
    for (int axis = 0; axis < AXES; axis++) {
        const bool moves = largest.displacement[axis] > NO_MOTION * NO_MOTION * most;
        if (moves && check_component(problem, axis, activity, time, error) != MPM_OK)
            return MPM_BAD_INPUT;
    }
    return MPM_OK;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/cohesive_traction.h"

#include "method/cracks/crack_fields.h"
#include "method/cracks/crack_opening.h"

#include <math.h>

/* What a point of a crack has of its law. */
struct point {
    double opening[2]; /* that the law resists: all, but its normal part where surfaces overlap */
    double effective, largest;
    double secant;
};

static struct point point_of(const struct mpm_state *state, size_t crack, size_t first,
                             size_t point)
{
    const struct mpm_crack_openings *const openings = &state->cracks.openings;
    struct point made;
    double n[2];
    mpm_crack_point_normal(&state->cracks.chains[crack], point, n);
    for (int axis = 0; axis < 2; axis++)
        made.opening[axis] = openings->vector[axis][first + point];
    const double overlap = fmin(made.opening[0] * n[0] + made.opening[1] * n[1], 0.0);
    for (int axis = 0; axis < 2; axis++)
        made.opening[axis] -= overlap * n[axis];
    made.effective = sqrt(made.opening[0] * made.opening[0] + made.opening[1] * made.opening[1]);
    made.largest = fmax(openings->largest[first + point], made.effective);
    made.secant = mpm_cohesive_secant(&state->scene->cracks[crack].cohesive, made.largest);
    return made;
}

double mpm_cohesive_effective(const struct mpm_state *state, size_t crack, size_t first,
                              size_t point)
{
    return point_of(state, crack, first, point).effective;
}

void mpm_cohesive_traction_at(const struct mpm_state *state, size_t crack, size_t first,
                              size_t point, double traction[2])
{
    const struct point at = point_of(state, crack, first, point);
    for (int axis = 0; axis < 2; axis++)
        traction[axis] = -at.secant * at.opening[axis];
}

/* ---------------------------------------------------------------- spreading */

static void add_force(const struct mpm_state *state, const struct mpm_crack_surface *surface,
                      const double force[2], double sign)
{
    for (int i = 0; i < surface->count; i++)
        for (int axis = 0; axis < 2; axis++)
            state->grid.sum[surface->node[i]][axis].force +=
                sign * surface->weight[i] * force[axis];
}

static void spread_point(const struct mpm_state *state, size_t crack, size_t first, size_t point)
{
    const struct mpm_crack_openings *const openings = &state->cracks.openings;
    const size_t k = first + point;
    const struct mpm_crack_surface *const surfaces = openings->surfaces[k];
    const struct point at = point_of(state, crack, first, point);
    double force[2];
    openings->largest[k] = at.largest;
    if (surfaces[0].count == 0 || surfaces[1].count == 0)
        return;
    for (int axis = 0; axis < 2; axis++)
        force[axis] = -at.secant * at.opening[axis] * openings->area[k];
    add_force(state, &surfaces[0], force, 1.0);
    add_force(state, &surfaces[1], force, -1.0);
}

void mpm_cohesive_spread(struct mpm_state *state)
{
    const struct mpm_scene *const scene = state->scene;
    if (state->cracks.openings.largest == NULL)
        return;
    for (size_t crack = 0; crack < scene->crack_count; crack++) {
        const size_t first = mpm_crack_first_point(state, crack);
        if (scene->cracks[crack].cohesive.law == NULL)
            continue;
        for (size_t k = 0; k < state->cracks.chains[crack].count; k++)
            spread_point(state, crack, first, k);
    }
}

/* ------------------------------------------------------------------- energy */

/* Of both ends of the step: v_i^n + v_i^{n+1} of one surface at a point. */
static void add_velocities(const struct mpm_state *state, const struct mpm_crack_surface *surface,
                           double sign, double v[2])
{
    for (int i = 0; i < surface->count; i++)
        for (int axis = 0; axis < 2; axis++)
            v[axis] += sign * surface->weight[i] *
                       (state->grid.start[surface->node[i]][axis] +
                        state->grid.motion[surface->node[i]].end[axis]);
}

/* Twice the power that the tractions of one crack take from the nodes. */
static double crack_power(const struct mpm_state *state, size_t crack)
{
    const struct mpm_crack_openings *const openings = &state->cracks.openings;
    const size_t first = mpm_crack_first_point(state, crack);
    double power = 0.0;
    for (size_t point = 0; point < state->cracks.chains[crack].count; point++) {
        const struct mpm_crack_surface *const surfaces = openings->surfaces[first + point];
        double traction[2], v[2] = {0.0, 0.0};
        if (surfaces[0].count == 0 || surfaces[1].count == 0)
            continue;
        mpm_cohesive_traction_at(state, crack, first, point, traction);
        add_velocities(state, &surfaces[0], 1.0, v);
        add_velocities(state, &surfaces[1], -1.0, v);
        power -= openings->area[first + point] * (traction[0] * v[0] + traction[1] * v[1]);
    }
    return power;
}

double mpm_cohesive_nodal_work(const struct mpm_state *state)
{
    double power = 0.0;
    if (state->cracks.openings.largest == NULL)
        return 0.0;
    for (size_t crack = 0; crack < state->scene->crack_count; crack++)
        if (state->scene->cracks[crack].cohesive.law != NULL)
            power += crack_power(state, crack);
    return 0.5 * state->time_step * power;
}

/* Of one crack, added. */
static void add_energies(const struct mpm_state *state, size_t crack, size_t first, double *stored,
                         double *dissipated)
{
    const struct mpm_crack_openings *const openings = &state->cracks.openings;
    const struct mpm_cohesive *const cohesive = &state->scene->cracks[crack].cohesive;
    for (size_t k = 0; k < state->cracks.chains[crack].count; k++) {
        const struct point at = point_of(state, crack, first, k);
        const double area = openings->area[first + k];
        *stored += area * 0.5 * at.secant * at.effective * at.effective;
        *dissipated += area * (mpm_cohesive_work(cohesive, at.largest) -
                               0.5 * at.secant * at.largest * at.largest);
    }
}

void mpm_cohesive_energies(const struct mpm_state *state, double *stored, double *dissipated)
{
    const struct mpm_scene *const scene = state->scene;
    *stored = *dissipated = 0.0;
    if (state->cracks.openings.largest == NULL)
        return;
    for (size_t crack = 0; crack < scene->crack_count; crack++)
        if (scene->cracks[crack].cohesive.law != NULL)
            add_energies(state, crack, mpm_crack_first_point(state, crack), stored, dissipated);
}

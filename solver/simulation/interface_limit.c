/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/interface_limit.h"

#include <math.h>

/* 1/rho of the lightest deformable body of a field; 0 of a rigid one. */
static double lightness(const struct mpm_simulation *simulation, size_t field)
{
    const struct mpm_state *const state = &simulation->state;
    double largest = 0.0;
    for (size_t body = 0; body < state->scene->body_count; body++)
        if (state->contact.field_of[body] == field && !state->scene->bodies[body].rigid)
            largest = fmax(largest, 1.0 / state->bodies[body].material.density);
    return largest;
}

double mpm_interface_kappa(const struct mpm_simulation *simulation, size_t *pair)
{
    const struct mpm_contact_spec *const spec = &simulation->scene->contact;
    const double *const cell = simulation->state.grid.cell;
    const double h = fmin(cell[0], cell[1]);
    double largest = 0.0;
    bool lands;
    for (size_t k = 0; k < spec->pair_count && !simulation->scene->at_rest; k++) {
        const struct mpm_pair_spec *const law = &spec->pairs[k];
        if (law->law != MPM_PAIR_INTERFACE)
            continue;
        const double dt = mpm_time_step_next(simulation, HUGE_VAL, &lands);
        const double d = fmax(law->shear, fmax(law->tension, law->compression));
        const double kappa =
            2.0 * dt / h * dt *
            (lightness(simulation, law->of[0]) + lightness(simulation, law->of[1])) * d;
        if (kappa > largest) {
            largest = kappa;
            *pair = k;
        }
    }
    return largest;
}

enum mpm_status mpm_interface_check(const struct mpm_simulation *simulation,
                                    struct mpm_error *error)
{
    size_t pair = 0;
    const double kappa = mpm_interface_kappa(simulation, &pair);
    if (kappa <= MPM_KAPPA_MAX)
        return MPM_OK;
    return mpm_error_set(error, MPM_BAD_INPUT,
                         "%s: an interface %.3g times as stiff as an explicit step follows; "
                         "allowed: up to %g times, "
                         "or law: bonded",
                         simulation->scene->contact.pairs[pair].key, kappa, MPM_KAPPA_MAX);
}

/* Of the round-off of a ratio. */
static const double EVEN = 1e-12;

double mpm_pair_unevenness(const struct mpm_pair_spec *pair)
{
    const double across = fmax(pair->tension, pair->compression), along = pair->shear;
    if (pair->law != MPM_PAIR_INTERFACE || pair->normal == MPM_NORMAL_LOGISTIC ||
        pair->normal == MPM_NORMAL_GIVEN || !(fmin(across, along) > 0.0))
        return 0.0;
    return (1.0 - EVEN) * fmax(across / along, along / across);
}

double mpm_interface_unevenness(const struct mpm_scene *scene, size_t *pair)
{
    double largest = 0.0;
    for (size_t k = 0; k < scene->contact.pair_count; k++) {
        const double ratio = mpm_pair_unevenness(&scene->contact.pairs[k]);
        if (ratio > largest) {
            largest = ratio;
            *pair = k;
        }
    }
    return largest;
}

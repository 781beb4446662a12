/* What a scene damps: made when the simulation is created.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/loads/damping_rate.h"
#include "method/loads/grid_drag.h"
#include "simulation/simulation.h"

static enum mpm_status create_rate(const struct mpm_simulation *simulation, const char *text,
                                   struct mpm_expression **rate, struct mpm_error *error)
{
    return text == NULL ? MPM_OK
                        : mpm_expression_create(text, mpm_scene_coordinates(simulation->scene),
                                                true, simulation->state.workers, rate, error);
}

enum mpm_status mpm_damping_create(struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    const struct mpm_damping_spec *const spec = &scene->damping;
    struct mpm_damping *const damping = &simulation->state.damping;
    MPM_TRY(create_rate(simulation, spec->grid, &damping->grid, error));
    MPM_TRY(create_rate(simulation, spec->particle, &damping->particle, error));
    MPM_TRY(create_rate(simulation, spec->pic, &damping->pic, error));
    const bool grid = damping->grid != NULL || spec->thermostat;
    damping->grid_form = grid ? spec->grid_form : MPM_GRID_DAMPING_NODES;
    damping->nodes = grid && spec->grid_form == MPM_GRID_DAMPING_NODES;
    damping->particles =
        damping->particle != NULL || damping->pic != NULL || (grid && !damping->nodes);
    if (damping->pic == NULL || mpm_expression_is_uniform(damping->pic))
        return MPM_OK;
    return mpm_scene_error(error, scene, scene->line_damping, "damping.pic",
                           "'%s' varies in space; allowed: a number, or a formula in t", spec->pic);
}

void mpm_damping_free(struct mpm_damping *damping)
{
    mpm_expression_free(damping->grid);
    mpm_expression_free(damping->particle);
    mpm_expression_free(damping->pic);
}

void mpm_damping_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    mpm_grid_drag_layout(state, arena);
    if (state->damping.nodes || state->damping.grid_form == MPM_GRID_DAMPING_PARTICLES ||
        state->scene->rest.asked || state->scene->energy_balance)
        state->row_sums = MPM_TAKE(arena, struct mpm_row_sums,
                                   (size_t)(state->grid.rows + state->grid.field_rows));
}

/* Rates at t = 0, where the particles are: also those of the nodes, which are near. */
static enum mpm_status check_rate(const struct mpm_simulation *simulation,
                                  const struct mpm_expression *rate, const char *key, size_t p,
                                  double time_step, struct mpm_error *error)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    const double place[2] = {particles->position[0][p], particles->position[1][p]};
    if (rate == NULL)
        return MPM_OK;
    const double value = mpm_expression_value(rate, 0, place, 0.0);
    if (mpm_rate_is_allowed(value, time_step))
        return MPM_OK;
    return mpm_scene_error(error, simulation->scene, simulation->scene->line_damping, key,
                           "'%s' is %g at (%g, %g), time 0; allowed: at least 0 and below %g, 1 "
                           "over the time step",
                           mpm_expression_text(rate), value, place[0], place[1], 1.0 / time_step);
}

enum mpm_status mpm_damping_check_start(const struct mpm_simulation *simulation,
                                        struct mpm_error *error)
{
    const struct mpm_damping *const damping = &simulation->state.damping;
    bool lands;
    const double time_step = mpm_time_step_next(simulation, simulation->scene->end, &lands);
    for (size_t p = 0; p < simulation->state.particles.count; p++) {
        MPM_TRY(check_rate(simulation, damping->grid, "damping.grid", p, time_step, error));
        MPM_TRY(check_rate(simulation, damping->particle, "damping.particle", p, time_step, error));
    }
    return MPM_OK;
}

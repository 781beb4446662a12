/* J integrals of a scene: their tips, their memory, their values.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"

#include <math.h>
#include <stdint.h>

void mpm_j_integrals_layout(struct mpm_simulation *simulation, struct mpm_arena *arena)
{
    const struct mpm_scene *const scene = simulation->scene;
    size_t nodes = 0;
    for (size_t k = 0; k < scene->j_integral_count; k++) {
        const size_t needed = mpm_j_nodes(&scene->j_integrals[k]);
        nodes = needed > nodes ? needed : nodes;
    }
    if (nodes == 0)
        return;
    simulation->tips = MPM_TAKE(arena, struct mpm_crack_tip, scene->j_integral_count);
    simulation->j_scratch.nodes = MPM_TAKE(arena, struct mpm_j_node, nodes);
    simulation->j_scratch.parts = MPM_TAKE(arena, struct mpm_crack_part, scene->crack_count);
}

/* Of the chain as the scene gives it. */
static struct mpm_j_tip tip_of(const struct mpm_scene *scene,
                               const struct mpm_j_integral_spec *spec)
{
    const struct mpm_crack_spec *const crack = &scene->cracks[spec->crack];
    const size_t last = crack->point_count - 1;
    const double *const at = crack->points[spec->at_start ? 0 : last];
    const double *const before = crack->points[spec->at_start ? 1 : last - 1];
    const double length = hypot(at[0] - before[0], at[1] - before[1]);
    return (struct mpm_j_tip){
        .place = {at[0], at[1]},
        .direction = {(at[0] - before[0]) / length, (at[1] - before[1]) / length},
    };
}

enum mpm_status mpm_j_integral_evaluate(const struct mpm_simulation *simulation, size_t index,
                                        struct mpm_j_value *value, struct mpm_error *error)
{
    const enum mpm_status status =
        mpm_j_evaluate(&simulation->state, &simulation->scene->j_integrals[index],
                       &simulation->tips[index].undeformed, &simulation->j_scratch, value, error);
    if (status == MPM_RUN_FAILED && error != NULL)
        error->cause = MPM_CAUSE_J_INTEGRAL;
    return status;
}

enum mpm_status mpm_j_integrals_fill(struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    for (size_t k = 0; k < scene->j_integral_count; k++) {
        const struct mpm_j_integral_spec *const spec = &scene->j_integrals[k];
        struct mpm_j_value value;
        struct mpm_error why = {.status = MPM_OK};
        simulation->tips[k].undeformed = tip_of(scene, spec);
        if (mpm_j_integral_evaluate(simulation, k, &value, &why) != MPM_OK)
            return mpm_error_set(error, MPM_BAD_INPUT, "%s:%d: %s", scene->path, spec->line,
                                 why.message);
    }
    return MPM_OK;
}

static bool has_growth(const struct mpm_scene *scene)
{
    for (size_t k = 0; k < scene->j_integral_count; k++)
        if (scene->j_integrals[k].growth.toughness > 0.0)
            return true;
    return false;
}

/* Not numbers where growth has brought the tip and another crack together. */
static enum mpm_status find_value(const struct mpm_simulation *simulation, size_t index,
                                  struct mpm_j_value *value, struct mpm_error *error)
{
    const double none = (double)NAN;
    const bool has_ended = simulation->tips[index].end.reason != MPM_TIP_GOES_ON;
    const enum mpm_status status =
        has_ended ? MPM_OK : mpm_j_integral_evaluate(simulation, index, value, error);
    if (has_ended ||
        (status == MPM_RUN_FAILED && value->met != SIZE_MAX && has_growth(simulation->scene))) {
        *value = (struct mpm_j_value){.j = {none, none}, .stress_intensity = {none, none}};
        return MPM_OK;
    }
    return status;
}

enum mpm_status mpm_simulation_j_integral(const struct mpm_simulation *simulation, size_t index,
                                          struct mpm_j_integral *value, struct mpm_error *error)
{
    struct mpm_j_value found;
    if (index >= simulation->scene->j_integral_count)
        return mpm_error_set(error, MPM_BAD_INPUT, "J integral %zu; allowed: below %zu", index,
                             simulation->scene->j_integral_count);
    const struct mpm_j_integral_spec *const spec = &simulation->scene->j_integrals[index];
    const struct mpm_crack_tip *const tip = &simulation->tips[index];
    MPM_TRY(find_value(simulation, index, &found, error));
    *value = (struct mpm_j_integral){
        .crack = spec->crack,
        .at_start = spec->at_start,
        .grown = tip->grown,
        .dissipated = tip->dissipated,
    };
    mpm_j_tip_place(&simulation->state, spec, value->tip);
    for (int i = 0; i < 2; i++) {
        value->direction[i] = tip->undeformed.direction[i];
        value->j[i] = found.j[i];
        value->stress_intensity[i] = found.stress_intensity[i];
    }
    return MPM_OK;
}

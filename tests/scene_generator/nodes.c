/* mpm-nodes SCENE: the velocities with which nodes move particles, as text on standard output, one
 * line for each node with mass in every step, additional velocity fields of nodes near cracks
 * included:
 *
 *     step time time_step x y v_x v_y mass temperature concentration
 *
 * of the step that ends at `time`: the velocity of the node at its end, or with position_update:
 * midpoint the mean of both ends, the mass of the field, and the scalars of which gradients were
 * taken, at the start of the step; 0 in a scene without. In a scene where nothing moves the
 * mass is the capacity. Snapshots have particles alone; the tests of scenes hold the nodes against
 * the conditions of the scene. Nodes beyond the grid's edge are left out. Exit status: that of a
 * run of the scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/fields/fields.h"
#include "method/grid/grid_update.h"
#include "simulation/simulation.h"

#include <stdio.h>

static double mass_of(const struct mpm_state *state, int64_t node)
{
    return state->scene->at_rest ? state->transport.list[0].capacity[node] : state->grid.mass[node];
}

static double value_of(const struct mpm_state *state, enum mpm_scalar which, int64_t node)
{
    for (size_t k = 0; k < state->transport.count; k++)
        if (state->transport.list[k].which == which)
            return state->transport.list[k].value[node];
    return 0.0;
}

static void print_node(const struct mpm_simulation *simulation, int64_t node)
{
    const struct mpm_state *const state = &simulation->state;
    const struct mpm_grid *const grid = &state->grid;
    const int64_t parent = mpm_field_parent(state, node);
    if (mpm_grid_is_ghost(grid, parent) || !(mass_of(state, node) > 0.0))
        return;
    const double step = state->time_step;
    const bool midpoint = simulation->scene->position_update == MPM_MIDPOINT;
    double position[2], velocity[2];
    mpm_grid_position(grid, parent, position);
    for (int axis = 0; axis < 2; axis++)
        velocity[axis] = grid->motion[node].end[axis] -
                         (midpoint ? 0.5 * step * grid->motion[node].acceleration[axis] : 0.0);
    (void)printf("%llu %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n",
                 (unsigned long long)simulation->step, state->time, step, position[0], position[1],
                 velocity[0], velocity[1], mass_of(state, node),
                 value_of(state, MPM_TEMPERATURE, node), value_of(state, MPM_CONCENTRATION, node));
}

/* Nodes of active rows, in their order, rows of additional fields after those of the grid; what
 * lies beyond the active columns is of an earlier step. */
static void print_nodes(const struct mpm_simulation *simulation)
{
    const struct mpm_state *const state = &simulation->state;
    const struct mpm_grid *const grid = &state->grid;
    for (int64_t row = state->first_row; row >= 0; row = mpm_grid_next_row(state, row))
        for (int64_t column = state->row_low[row]; column <= state->row_high[row]; column++)
            print_node(simulation, row * grid->columns + column);
}

static int fail(const struct mpm_error *error)
{
    (void)fprintf(stderr, "mpm-nodes: %s\n", error->message);
    return (int)error->status;
}

static enum mpm_status run(const struct mpm_scene *scene, struct mpm_error *error)
{
    const struct mpm_simulation_options options = {.threads = 1};
    struct mpm_simulation *simulation = NULL;
    MPM_TRY(mpm_simulation_create(scene, &options, &simulation, error));
    enum mpm_status status = MPM_OK;
    while (status == MPM_OK && simulation->state.time < mpm_scene_end_time(scene) &&
           (scene->steps == 0 || simulation->step < (uint64_t)scene->steps)) {
        status = mpm_simulation_advance(simulation, mpm_scene_end_time(scene), error);
        if (status == MPM_OK)
            print_nodes(simulation);
    }
    mpm_simulation_free(simulation);
    return status;
}

int main(int argc, char **argv)
{
    struct mpm_error error = {.status = MPM_OK};
    struct mpm_scene *scene = NULL;
    if (argc != 2) {
        (void)fputs("mpm-nodes: usage: mpm-nodes SCENE\n", stderr);
        return MPM_BAD_INPUT;
    }
    if (mpm_scene_read(argv[1], NULL, 0, &scene, &error) != MPM_OK)
        return fail(&error);
    const enum mpm_status status = run(scene, &error);
    mpm_scene_free(scene);
    return status == MPM_OK ? MPM_OK : fail(&error);
}

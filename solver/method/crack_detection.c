/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/crack_detection.h"

#include "base/strips.h"
#include "method/crack_fields.h"
#include "method/crack_map.h"
#include "method/transfer.h"

#include <math.h>

/* ---------------------------------------------------------------- measuring */

static bool is_asked(const struct mpm_scene *scene)
{
    for (size_t k = 0; k < scene->crack_count; k++)
        if (mpm_crack_has_contact(scene, k))
            return true;
    return false;
}

bool mpm_crack_detection_needs_surfaces(const struct mpm_scene *scene)
{
    for (size_t k = 0; k < scene->crack_count; k++)
        if (mpm_crack_has_contact(scene, k) && scene->cracks[k].detection != MPM_DETECT_CELL)
            return true;
    return false;
}

/* What a particle adds to the sums of its nodes. */
struct contribution {
    double place[2];
    double area;       /* A_p = 4 l_1 l_2 (F_xx F_yy - F_xy F_yx): CRAMP (9) at finite strain */
    double surface[2]; /* x_p + F_p w_p */
};

static struct contribution contribution_of(const struct mpm_state *state, size_t p)
{
    const struct mpm_particles *const particles = &state->particles;
    const double *const half = state->bodies[particles->body[p]].half_size;
    double *const *const f = particles->deformation;
    struct contribution made = {
        .place = {particles->position[0][p], particles->position[1][p]},
        .area =
            4.0 * half[0] * half[1] * (f[MPM_XX][p] * f[MPM_YY][p] - f[MPM_XY][p] * f[MPM_YX][p]),
    };
    if (particles->surface[0] != NULL) {
        const double way[2] = {particles->surface[0][p], particles->surface[1][p]};
        made.surface[0] = made.place[0] + f[MPM_XX][p] * way[0] + f[MPM_XY][p] * way[1];
        made.surface[1] = made.place[1] + f[MPM_YX][p] * way[0] + f[MPM_YY][p] * way[1];
    }
    return made;
}

static void add_crossing(const struct mpm_state *state, const struct mpm_crack_crossing *crossing,
                         struct mpm_crack_node *node)
{
    double normal[2];
    mpm_crack_segment_normal(&state->cracks.chains[crossing->crack], crossing->segment, normal);
    node->normal[0] += normal[0];
    node->normal[1] += normal[1];
    node->crack = crossing->crack < node->crack ? crossing->crack : node->crack;
}

static void add_sums(const struct contribution *made, const struct mpm_stencil_node *entry,
                     const double place[2], struct mpm_crack_sums *sums)
{
    const double weight = made->area * entry->s;
    sums->area += weight;
    for (int axis = 0; axis < 2; axis++) {
        sums->gradient[axis] += made->area * entry->g[axis];
        sums->surface[axis] += weight * (made->surface[axis] - place[axis]);
    }
}

/* Has one of the particle's nodes further fields? */
static bool reaches_fields(const struct mpm_state *state, const struct mpm_cell_block *block)
{
    for (int64_t row = block->low[1]; row <= block->high[1] + 1; row++)
        for (int64_t column = block->low[0]; column <= block->high[0] + 1; column++)
            if (state->cracks.node_of[row * state->grid.columns + column] != 0)
                return true;
    return false;
}

static void measure(void *context, size_t p, const struct mpm_cell_block *block)
{
    const struct mpm_state *const state = context;
    const struct mpm_crack_kept *const kept = mpm_crack_kept_of(state, p);
    uint32_t code = kept == NULL ? 0 : kept->code;
    struct mpm_stencil room;
    if (kept == NULL && !reaches_fields(state, block))
        return;
    const struct contribution made = contribution_of(state, p);
    const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
    for (int k = 0; k < stencil->count; k++, code >>= 2) {
        const int64_t home = mpm_crack_home(state, state->node_zero + stencil->node[k].node);
        if (state->cracks.node_of[home] == 0)
            continue;
        struct mpm_crack_node *const node = &state->cracks.nodes[state->cracks.node_of[home] - 1];
        double place[2];
        mpm_grid_position(&state->grid, home, place);
        add_sums(&made, &stencil->node[k], place, &node->sums[code & 3u]);
        if ((code & 3u) != 0)
            add_crossing(state, &kept->crossing[k], node);
    }
}

/* Strips of one colour have no node in common. */
static void measure_strip(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    (void)worker;
    mpm_crack_bands_visit(state, &state->strips[index], &state->cracks.map->beside, measure,
                          context);
}

void mpm_crack_detection_measure(struct mpm_state *state, int workers)
{
    if (state->cracks.node_count > 0 && is_asked(state->scene))
        mpm_strips_run(state->strip_count, workers, measure_strip, state);
}

/* ------------------------------------------------------------------ deciding */

/* Of the surface of the field below beyond that of the field above, along the normal. */
static double gap_of(const struct mpm_crack_sums *above, const struct mpm_crack_sums *below,
                     const double n[2])
{
    double gap = 0.0;
    for (int axis = 0; axis < 2; axis++)
        gap += n[axis] * (below->surface[axis] / below->area - above->surface[axis] / above->area);
    return gap;
}

struct mpm_crack_volume mpm_crack_volume_at(const struct mpm_state *state,
                                            const struct mpm_crack_node *node,
                                            const enum mpm_crack_side pair[2],
                                            const double normal[2])
{
    const struct mpm_crack_sums *const above = &node->sums[pair[0]], *const below =
                                                                         &node->sums[pair[1]];
    const double *const cell = state->grid.cell;
    const double area = above->area + below->area;
    const enum mpm_crack_detection detection = state->scene->cracks[node->crack].detection;
    if (detection == MPM_DETECT_CELL)
        return (struct mpm_crack_volume){area, cell[0] * cell[1]};
    const double gap = gap_of(above, below, normal);
    if (detection == MPM_DETECT_DISPLACEMENT) {
        const double along[2] = {cell[0] * normal[0], cell[1] * normal[1]};
        const double size = sqrt(along[0] * along[0] + along[1] * along[1]);
        return (struct mpm_crack_volume){size - gap, size};
    }
    double gain = 0.0;
    for (int axis = 0; axis < 2; axis++)
        gain += 0.5 * gap * normal[axis] * (above->gradient[axis] - below->gradient[axis]);
    /* what a node sees of a body's far side it would lose: that is no part of the gap */
    gain = gap > 0.0 ? fmax(gain, 0.0) : fmin(gain, 0.0);
    return (struct mpm_crack_volume){area, area + gain};
}

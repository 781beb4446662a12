/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_particles.h"

#include "base/strips.h"
#include "method/grid/conditions.h"
#include "method/grid/symmetry.h"
#include "method/transfer/nearby.h"
#include "method/transfer/transfer.h"

#include <math.h>

void mpm_contact_particles_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    struct mpm_body_contact *const contact = &state->contact;
    contact->near = MPM_TAKE(arena, struct mpm_contact_near, state->particles.count);
    contact->near_count = MPM_TAKE(arena, size_t, (size_t)state->strip_count);
}

/* ------------------------------------------------------------------ finding */

/* Is one of the nodes of a block listed? */
static bool reaches(const struct mpm_state *state, const struct mpm_cell_block *block)
{
    for (int64_t row = block->low[1]; row <= block->high[1] + 1; row++)
        for (int64_t column = block->low[0]; column <= block->high[0] + 1; column++)
            if (state->contact.node_of[row * state->grid.columns + column] != 0)
                return true;
    return false;
}

/* The list of a strip as it grows. */
struct listing {
    const struct mpm_state *state;
    struct mpm_contact_near *near;
    size_t count;
};

static void list_particle(void *context, size_t p, const struct mpm_cell_block *block)
{
    struct listing *const listing = context;
    const struct mpm_state *const state = listing->state;
    if (state->contact.field_of[state->particles.body[p]] == MPM_CONTACT_FIELDS ||
        !reaches(state, block))
        return;
    listing->near[listing->count++] = (struct mpm_contact_near){
        .particle = (uint32_t)p,
        .column = (int32_t)block->low[0],
        .row = (int32_t)block->low[1],
        .columns = (uint16_t)(block->high[0] + 2 - block->low[0]),
        .rows = (uint16_t)(block->high[1] + 2 - block->low[1]),
    };
}

static void list_strip(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    struct listing listing = {state, state->contact.near + state->strips[index].begin, 0};
    (void)worker;
    mpm_nearby_visit(state, index, &state->contact.beside, list_particle, &listing);
    state->contact.near_count[index] = listing.count;
}

void mpm_contact_particles_find(struct mpm_state *state, int workers)
{
    mpm_strips_run(state->strip_count, workers, list_strip, state);
}

/* ------------------------------------------------------------ one particle */

int mpm_contact_key_in(const struct mpm_state *state, const struct mpm_field_use *use, int64_t node)
{
    for (int k = 0; k < use->detours; k++)
        if (use->detour[k].node == node)
            return state->fields.list[use->detour[k].field - mpm_fields_first(state)].key;
    return 0;
}

/* H = I - F^-1, in the plane. */
static void find_slope(const struct mpm_particles *particles, size_t p, double slope[4])
{
    double *const *const f = particles->deformation;
    const double xx = f[MPM_XX][p], xy = f[MPM_XY][p], yx = f[MPM_YX][p], yy = f[MPM_YY][p];
    const double j = xx * yy - xy * yx;
    slope[0] = 1.0 - yy / j;
    slope[1] = xy / j;
    slope[2] = yx / j;
    slope[3] = 1.0 - xx / j;
}

static void add_displacement(const struct mpm_particles *particles, size_t p,
                             struct mpm_contact_particle *made)
{
    find_slope(particles, p, made->slope);
    for (int axis = 0; axis < 2; axis++) {
        made->displacement[axis] = made->place[axis] - particles->origin[axis][p];
        made->velocity[axis] = particles->velocity[axis][p];
    }
}

void mpm_contact_particle_weigh(const struct mpm_state *state, size_t p,
                                struct mpm_contact_particle *particle)
{
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_body *const body = &state->bodies[particles->body[p]];
    double f[MPM_GRADIENT_SIZE];
    mpm_particle_deformation(particles, p, f);
    particle->area = 4.0 * body->half_size[0] * body->half_size[1] *
                     (f[MPM_XX] * f[MPM_YY] - f[MPM_XY] * f[MPM_YX]);
    particle->volume = particles->mass[p] * mpm_determinant(f) / body->material.density;
    if (state->contact.sums_displacement)
        add_displacement(particles, p, particle);
}

/* Of a cell: a node on the edge of a particle's support gets nothing from it, by round-off either.
 */
static const double SUPPORT_SLACK = 1e-9;

void mpm_contact_particle_find_domain(const struct mpm_state *state, size_t p,
                                      struct mpm_contact_particle *particle)
{
    const struct mpm_shape_domain domain = mpm_particle_carried_domain(state, p);
    state->family->reach(&state->shape_grid, &domain, particle->support);
    for (int k = 0; k < 4; k++)
        particle->edge[k] = domain.edge[k];
    for (int axis = 0; axis < 2; axis++)
        particle->support[axis] += state->grid.cell[axis] * (1.0 - SUPPORT_SLACK);
}

/* ------------------------------------------------------------------ rigid */

static struct mpm_contact_particle rigid_particle(const struct mpm_state *state, size_t p)
{
    const struct mpm_rigid_particles *const rigid = &state->rigid;
    const double *const half = state->bodies[rigid->body[p]].half_size;
    const double area = 4.0 * half[0] * half[1];
    const double depth =
        state->shape_grid.axisymmetric ? rigid->position[0][p] : state->scene->thickness;
    return (struct mpm_contact_particle){
        .field = state->contact.field_of[rigid->body[p]],
        .place = {rigid->position[0][p], rigid->position[1][p]},
        .area = area,
        .volume = area * depth,
        .edge = {half[0], 0.0, 0.0, half[1]},
    };
}

/* Of a rigid particle beyond planes of symmetry across the axes with a sign -1: the nodes that it
 * reaches there become those that they are images of, and the particle its own image. Entries of
 * other nodes keep their T alone, whose sum is the whole particle's. Returns whether it reaches
 * any.
 */
static bool take_image(const struct mpm_state *state, const double signs[2],
                       struct mpm_contact_particle *particle, struct mpm_stencil *stencil)
{
    const double place[2] = {particle->place[0], particle->place[1]};
    bool any = false;
    for (int k = 0; k < stencil->count; k++) {
        struct mpm_stencil_node *const entry = &stencil->node[k];
        const int64_t beyond = state->node_zero + entry->node;
        double sign[2], from[2], to[2];
        const int64_t node = mpm_symmetry_original(state, beyond, sign);
        if (entry->s == 0.0 || sign[0] != signs[0] || sign[1] != signs[1]) {
            entry->s = 0.0;
            continue;
        }
        any = true;
        mpm_grid_position(&state->grid, beyond, from);
        mpm_grid_position(&state->grid, node, to);
        entry->node = node - state->node_zero;
        for (int axis = 0; axis < 2; axis++) {
            entry->g[axis] *= sign[axis];
            if (sign[axis] < 0.0)
                particle->place[axis] = to[axis] - (place[axis] - from[axis]);
        }
    }
    for (int k = 0; k < 4; k++)
        particle->edge[k] *= signs[k % 2];
    return any;
}

/* Which nodes beyond a plane are listed depends on the strips of particles, so a rigid body's part
 * there counts at the nodes inside from the start. */
static void work_on_images(struct mpm_state *state, const struct mpm_contact_particle *particle,
                           const struct mpm_stencil *stencil, mpm_contact_rigid_work *work)
{
    for (int k = 0; k < 4; k++) {
        const double signs[2] = {(k & 1) != 0 ? -1.0 : 1.0, (k & 2) != 0 ? -1.0 : 1.0};
        struct mpm_contact_particle seen = *particle;
        struct mpm_stencil image = *stencil;
        if (take_image(state, signs, &seen, &image))
            work(state, &seen, &image);
    }
}

void mpm_contact_rigid_run(struct mpm_state *state, mpm_contact_rigid_work *work)
{
    for (size_t p = 0; state->contact.rigid_at != NULL && p < state->rigid.count; p++) {
        struct mpm_stencil stencil;
        if (state->contact.field_of[state->rigid.body[p]] == MPM_CONTACT_FIELDS)
            continue;
        mpm_rigid_particle_stencil(state, p, &stencil);
        const struct mpm_contact_particle particle = rigid_particle(state, p);
        if (state->symmetries.count == 0)
            work(state, &particle, &stencil);
        else
            work_on_images(state, &particle, &stencil, work);
    }
}

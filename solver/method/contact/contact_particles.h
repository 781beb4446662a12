/* The particles that reach nodes of several fields: found once a step, and visited by what looks at
 * them together with these nodes.
 *
 * Cost: of finding them, mpm_nearby_visit; 16 bytes for each particle of the scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CONTACT_PARTICLES_H
#define MPM_METHOD_CONTACT_PARTICLES_H

#include "base/simd.h"
#include "method/contact/shared_nodes.h"

/* A particle, rigid or not, as those see it who visit it; what it weighs and what its domain is are
 * set by functions of their own. */
struct mpm_contact_particle {
    int field;
    const struct mpm_field_use *use; /* where cracks cut its body: its fields; or NULL */
    double place[2];
    /* what it weighs */
    double area, volume;
    double displacement[2], slope[4]; /* of scenes with an interface: u, H = I - F^-1, */
    double velocity[2];               /* and the velocity */
    /* its domain */
    double edge[4];    /* half edges */
    double support[2]; /* nodes that it gives mass to are nearer than this along each axis */
};

/* Takes the memory. */
void mpm_contact_particles_layout(struct mpm_state *state, struct mpm_arena *arena);

/* Lists the particles, strip by strip in their order: nodes are listed. */
void mpm_contact_particles_find(struct mpm_state *state, int workers);

/* The list of a strip; contact.near_count[strip] of them. */
static inline const struct mpm_contact_near *mpm_contact_near_of(const struct mpm_state *state,
                                                                 int64_t strip)
{
    return state->contact.near + state->strips[strip].begin;
}

/* Field and place of a particle that is not rigid. */
static inline void mpm_contact_particle_begin(const struct mpm_state *state, size_t p,
                                              struct mpm_contact_particle *particle)
{
    particle->field = state->contact.field_of[state->particles.body[p]];
    particle->use = mpm_field_use_of(state, p);
    for (int axis = 0; axis < 2; axis++)
        particle->place[axis] = state->particles.position[axis][p];
}
void mpm_contact_particle_weigh(const struct mpm_state *state, size_t p,
                                struct mpm_contact_particle *particle);
void mpm_contact_particle_find_domain(const struct mpm_state *state, size_t p,
                                      struct mpm_contact_particle *particle);

/* The key of a particle of several fields at a node. */
int mpm_contact_key_in(const struct mpm_state *state, const struct mpm_field_use *use,
                       int64_t node);
/* The key that a particle has at a node. */
static inline int mpm_contact_key_at(const struct mpm_state *state,
                                     const struct mpm_contact_particle *particle, int64_t node)
{
    return particle->use == NULL ? 0 : mpm_contact_key_in(state, particle->use, node);
}

/* Work for a particle and a listed node that it gives mass to; `from` the node to the particle. */
typedef void mpm_contact_visit(struct mpm_state *state, const struct mpm_contact_particle *particle,
                               const double from[2], struct mpm_contact_node *node);

/* Nodes of a listed particle. */
MPM_INLINE void mpm_contact_nodes_visit(struct mpm_state *state,
                                        const struct mpm_contact_near *near,
                                        const struct mpm_contact_particle *particle,
                                        mpm_contact_visit *visit)
{
    const struct mpm_grid *const grid = &state->grid;
    const int64_t end[2] = {near->column + near->columns, near->row + near->rows};
    for (int64_t row = near->row; row < end[1]; row++) {
        const uint32_t *const place = state->contact.node_of + row * grid->columns;
        double from[2];
        from[1] = mpm_grid_way(grid, 1, row, particle->place[1]);
        if (!(fabs(from[1]) < particle->support[1]))
            continue;
        for (int64_t column = near->column; column < end[0]; column++) {
            if (place[column] == 0)
                continue;
            from[0] = mpm_grid_way(grid, 0, column, particle->place[0]);
            if (fabs(from[0]) < particle->support[0])
                visit(state, particle, from, &state->contact.nodes[place[column] - 1]);
        }
    }
}

/* All listed particles of a strip, with their domains and, if `weighs`, with what they weigh. */
MPM_INLINE void mpm_contact_strip_visit(struct mpm_state *state, int64_t strip, bool weighs,
                                        mpm_contact_visit *visit)
{
    const struct mpm_contact_near *const near = mpm_contact_near_of(state, strip);
    for (size_t k = 0; k < state->contact.near_count[strip]; k++) {
        struct mpm_contact_particle particle;
        mpm_contact_particle_begin(state, near[k].particle, &particle);
        mpm_contact_particle_find_domain(state, near[k].particle, &particle);
        if (weighs)
            mpm_contact_particle_weigh(state, near[k].particle, &particle);
        mpm_contact_nodes_visit(state, &near[k], &particle, visit);
    }
}

/* Work for a particle of a rigid body in contact; beyond planes of symmetry, for its image inside.
 */
typedef void mpm_contact_rigid_work(struct mpm_state *state,
                                    const struct mpm_contact_particle *particle,
                                    const struct mpm_stencil *stencil);
void mpm_contact_rigid_run(struct mpm_state *state, mpm_contact_rigid_work *work);

/* Its listed nodes. */
MPM_INLINE void mpm_contact_stencil_visit(struct mpm_state *state,
                                          const struct mpm_contact_particle *particle,
                                          const struct mpm_stencil *stencil,
                                          mpm_contact_visit *visit)
{
    for (int k = 0; k < stencil->count; k++) {
        struct mpm_contact_node *const node =
            mpm_contact_node_at(state, state->node_zero + stencil->node[k].node);
        double at[2];
        if (node == NULL || stencil->node[k].s == 0.0)
            continue;
        mpm_grid_position(&state->grid, node->node, at);
        visit(state, particle,
              (const double[2]){particle->place[0] - at[0], particle->place[1] - at[1]}, node);
    }
}

#endif

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

/* A particle, rigid or not, as sums see it. */
struct mpm_contact_particle {
    int field;
    const struct mpm_field_use *use; /* where cracks cut its body: its fields; or NULL */
    double place[2];
    double area, volume;
    double edge[4];    /* half edges of its domain */
    double support[2]; /* nodes that it gives mass to are nearer than this along each axis */
    /* of scenes with an interface, else 0: u, H = I - F^-1, and the velocity */
    double displacement[2], slope[4], velocity[2];
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

struct mpm_contact_particle mpm_contact_particle_of(const struct mpm_state *state, size_t p);

/* The key that a particle has at a node. */
int mpm_contact_key_at(const struct mpm_state *state, const struct mpm_contact_particle *particle,
                       int64_t node);

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
        for (int64_t column = near->column; column < end[0] && fabs(from[1]) < particle->support[1];
             column++) {
            if (place[column] == 0)
                continue;
            from[0] = mpm_grid_way(grid, 0, column, particle->place[0]);
            if (fabs(from[0]) < particle->support[0])
                visit(state, particle, from, &state->contact.nodes[place[column] - 1]);
        }
    }
}

/* All listed particles of a strip. */
MPM_INLINE void mpm_contact_strip_visit(struct mpm_state *state, int64_t strip,
                                        mpm_contact_visit *visit)
{
    const struct mpm_contact_near *const near = mpm_contact_near_of(state, strip);
    for (size_t k = 0; k < state->contact.near_count[strip]; k++) {
        const struct mpm_contact_particle particle =
            mpm_contact_particle_of(state, near[k].particle);
        mpm_contact_nodes_visit(state, &near[k], &particle, visit);
    }
}

/* Work for a particle of a rigid body in contact. */
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

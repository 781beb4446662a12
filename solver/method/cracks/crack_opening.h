/* The surfaces of a crack, at each point of its chain: how far they have moved apart.
 *
 * CRAMP moves a crack with the mass centre of both sides, (32), which does not determine its
 * opening. A surface moves with its own side: as a massless particle would that lies just above
 * (below) the crack at the point. At each corner of the cell that the surface is in, it takes the
 * field that such a particle has there; ahead of a crack's tip both take the same. The opening is
 * delta = u_above - u_below,  d delta/dt = sum_above w_i v_i - sum_below w_i v_i with the
 * velocities v_i that update the stress, where the order of the step has that: an opening is a
 * strain. The velocities that move particles have a part that no particle takes up: where all
 * particles of a stressed body are at rest, nodes beside a crack still have it, and an opening that
 * follows them drifts and feeds on it (seen with MUSL, USF and USAVG). The surfaces lie half of the
 * opening to both sides of the point.
 *
 * The weights w_i are the linear functions N_i there, taken down at nodes that the side hardly
 * reaches: w_i ~ N_i min(1, m_i / (m_max/10)),  sum w_i = 1, m_max the largest mass of the side's
 * fields there: a node with no mass to speak of has any velocity, and a traction that works on
 * these same weights would throw it away. Nodes that may not move cracks (mpm_cracks_advance) do
 * not count, so that outside of bodies surfaces stay together.
 *
 * Where surfaces lie is known as well as a field with an edge knows it: a node's velocity is that
 * of the mass centre of what it sees, up to half a cell inside. So an opening has the strain of
 * that layer in it, and surfaces that turn by an angle seem to slide by as much as the angle times
 * half a cell. Scenes that do not track openings run none of this.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CRACK_OPENING_H
#define MPM_METHOD_CRACK_OPENING_H

#include "method/state.h"

/* Is the opening of this crack tracked? */
static inline bool mpm_crack_is_followed(const struct mpm_crack_spec *spec)
{
    return spec->opening || spec->cohesive.law != NULL;
}

/* Once nodes have their velocities at the start of the step: the fields and weights of all
 * surfaces, and their way with the first part of the stress update. A surface whose side has no
 * mass there stays where it is, with the other one. Cost: the segments of a cell's crack, for each
 * of 8 nodes a point. MPM_RUN_FAILED: a surface leaves the grid. */
enum mpm_status mpm_crack_openings_begin(struct mpm_state *state, struct mpm_error *error);

/* Their way with the second part, with the velocities that update the stress then. */
enum mpm_status mpm_crack_openings_finish(struct mpm_state *state, struct mpm_error *error);

/* MPM_RUN_FAILED: a surface is outside of the grid; of openings that a checkpoint has. */
enum mpm_status mpm_crack_openings_check(const struct mpm_state *state, struct mpm_error *error);

/* Unit normal of a chain at its point `k`, from below to above; along is on its right: from the
 * first point to the last. */
void mpm_crack_point_normal(const struct mpm_crack_chain *chain, size_t k, double normal[2]);

/* The opening of a point: along the normal, positive if apart, and along the crack, positive if the
 * surface above has slid towards its last point. `point` counts from the first of the chain, or of
 * a piece of it, `first` is that one's place among the points of all cracks. */
struct mpm_crack_gap {
    double opening, sliding;
};
struct mpm_crack_gap mpm_crack_gap_at(const struct mpm_state *state,
                                      const struct mpm_crack_chain *chain, size_t first,
                                      size_t point);

#endif

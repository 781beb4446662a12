/* Velocity conditions within a step: boundaries, rigid bodies and mirrors at the axis.
 *
 * A condition prescribes a component of a node's velocity at both ends of the step
 * (CRAMP, Tasks 2 and 3): the acceleration handed to the particles is the difference
 * over the step, and the force that makes it so works on the body.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CONDITIONS_H
#define MPM_METHOD_CONDITIONS_H

#include "method/state.h"

/* Lists the conditions on nodes that carry mass. Boundaries win over rigid bodies, and so do
 * mirrors, the extra nodes of method.axis_nodes: mirrored.
 * MPM_RUN_FAILED: a prescribed velocity that is not finite; two rigid bodies that
 * prescribe different velocities for one node. */
enum mpm_status mpm_conditions_gather(struct mpm_state *state, struct mpm_error *error);

/* The stencil of a particle of a rigid body. */
void mpm_rigid_particle_stencil(const struct mpm_state *state, size_t p,
                                struct mpm_stencil *stencil);
/* A component of a rigid body's velocity at a place, at the start of the step, and at its end where
 * the place has moved to with the body. MPM_RUN_FAILED: not finite. */
enum mpm_status mpm_rigid_velocity(const struct mpm_state *state, uint32_t body, int axis,
                                   const double position[2], double *start, double *end,
                                   struct mpm_error *error);

/* Each of the next three is followed by contact of cracks, which leaves held components as they are
 * (held of mpm_field_node and mpm_additional_field), and then by the mirrors of the same
 * velocities. */

/* Start velocities. */
void mpm_conditions_apply_start(struct mpm_state *state);
/* End velocities and accelerations; adds the conditions' work to external_work: reaction times the
 * prescribed velocity. Where that accelerates, particles take the node's inertia at the velocity
 * that they gave it, so that the balance of energy closes to second order in the cell. */
void mpm_conditions_apply_end(struct mpm_state *state);
/* End velocities over the re-extrapolated ones. */
void mpm_conditions_apply_extrapolated(struct mpm_state *state);

/* Velocities of the nodes that mirror others. */
void mpm_mirrors_apply_start(struct mpm_state *state);
void mpm_mirrors_apply_end(struct mpm_state *state);
void mpm_mirrors_apply_extrapolated(struct mpm_state *state);

/* Velocities on their way through the orders of XPIC and FMPM: those that they began as. */
void mpm_conditions_apply_smoothed(struct mpm_state *state);

/* Moves the rigid bodies' particles over the step. MPM_RUN_FAILED: one leaves the grid. */
enum mpm_status mpm_rigid_advance(struct mpm_state *state, struct mpm_error *error);

#endif

/* What several passes of the reference kernels do with a particle: part of each, not called.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_PARTICLE_UPDATES_H
#define MPM_METHOD_PARTICLE_UPDATES_H

#include "base/simd.h"
#include "method/transfer/extent.h"

#include <float.h>

/* f_i -= m_p (tau / rho_0) . G_ip, and the hoop stress times T_ip (0 in planar). */
MPM_INLINE void mpm_particle_add_internal_force(const struct mpm_state *state, size_t p,
                                                const struct mpm_stencil *stencil)
{
    const double mass = state->particles.mass[p];
    const double xx = mass * state->particles.stress[MPM_SYM_XX][p];
    const double yy = mass * state->particles.stress[MPM_SYM_YY][p];
    const double zz = mass * state->particles.stress[MPM_SYM_ZZ][p];
    const double xy = mass * state->particles.stress[MPM_SYM_XY][p];
    for (int k = 0; k < stencil->count; k++) {
        const struct mpm_stencil_node *const entry = &stencil->node[k];
        struct mpm_node_sum *const sum = state->grid.sum[state->node_zero + entry->node];
        sum[0].force -= xx * entry->g[0] + xy * entry->g[1] + zz * entry->t;
        sum[1].force -= xy * entry->g[0] + yy * entry->g[1];
    }
}

/* tau / rho_0, and what the strip knows of wave speeds. */
MPM_INLINE void mpm_particle_set_stress(const struct mpm_particles *particles, size_t p,
                                        const double stress[MPM_SYMMETRIC_SIZE],
                                        double wave_speed_squared, struct mpm_strip *strip)
{
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        particles->stress[k][p] = stress[k];
    if (!(wave_speed_squared <= DBL_MAX))
        mpm_strip_record(strip, MPM_NOT_FINITE, particles->id[p], 0, wave_speed_squared);
    if (wave_speed_squared > strip->wave_speed_squared)
        strip->wave_speed_squared = wave_speed_squared;
}

/* grid.gradient += momentum S_ip */
MPM_INLINE void mpm_particle_add_extrapolated(const struct mpm_state *state,
                                              const struct mpm_stencil *stencil,
                                              const double momentum[2])
{
    for (int k = 0; k < stencil->count; k++) {
        double(*const sum)[2] = state->grid.gradient[state->node_zero + stencil->node[k].node];
        sum[0][0] += momentum[0] * stencil->node[k].s;
        sum[1][0] += momentum[1] * stencil->node[k].s;
    }
}

/* v_p += dt sum S a_i, and its part of the strip's kinetic energy */
MPM_INLINE void mpm_particle_update_velocity(const struct mpm_state *state, size_t p,
                                             const struct mpm_stencil *stencil,
                                             struct mpm_strip *strip)
{
    double a[2] = {0.0, 0.0};
    for (int k = 0; k < stencil->count; k++) {
        const double *const acceleration =
            state->grid.motion[state->node_zero + stencil->node[k].node].acceleration;
        a[0] += stencil->node[k].s * acceleration[0];
        a[1] += stencil->node[k].s * acceleration[1];
    }
    const double vx = state->particles.velocity[0][p] + state->time_step * a[0];
    const double vy = state->particles.velocity[1][p] + state->time_step * a[1];
    state->particles.velocity[0][p] = vx;
    state->particles.velocity[1][p] = vy;
    const double square = vx * vx + vy * vy;
    if (!(square <= DBL_MAX))
        mpm_strip_record(strip, MPM_NOT_FINITE, state->particles.id[p], 0, square);
    strip->kinetic_energy += 0.5 * state->particles.mass[p] * square;
}

#endif

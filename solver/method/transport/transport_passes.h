/* Passes over the particles of a scalar that is conducted, state->transport.conducted; equations in
 * transport.h. Those of the reference kernels; the fast ones have the same (fast_scalars.h).
 *
 *   spread             content_i += sum c m v S_ip, capacity_i += sum c m S_ip
 *   conduct            inflow_i += sum V s S_ip - sum V k grad v . G_ip, with grad v = sum v_j G_jp
 *   update             v_p += dt sum result_i S_ip, with PIC v_p = sum result_i S_ip
 *   update_and_spread  and content_i += sum c m v S_ip of the new v_p: where nothing moves
 *   filter             result_i += sum c m S_ip sum_j S_jp value_j
 *
 * Sums over particles go in their order.
 *
 * With tables c and k are those at v_p of the start of the step, and the update keeps what nodes
 * give: with the enthalpy h(v) = integral of c from 0 to v per mass, and dv = dt sum result_i S_ip
 * (PIC: sum result_i S_ip - v_p),
 *
 *     h(v_p new) = h(v_p) + c(v_p) dv,
 *
 * so that sum m h changes by sum_i M_i times the nodes' changes, as sum c m v does with a constant
 * c. v_p + dv would change it by sum m c'(v_p) dv^2/2 more in each step, of first order in the step
 * over a run, and could pass over a peak of c. The two differ by c' dv^2/(2 c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_TRANSPORT_PASSES_H
#define MPM_METHOD_TRANSPORT_PASSES_H

#include "method/state.h"

/* Of constants, and of scenes in which a material has a table. */
extern const struct mpm_scalar_passes mpm_scalar_passes, mpm_table_scalar_passes;

/* The values of the particles. */
static inline double *mpm_scalar_values(const struct mpm_nodal_scalar *scalar,
                                        const struct mpm_particles *particles)
{
    return mpm_particle_array(particles, scalar->row->field, 0);
}

/* Runs one for a scalar, and one of the rows of its nodes. */
void mpm_scalar_pass_run(struct mpm_state *state, int workers,
                         const struct mpm_nodal_scalar *scalar, mpm_pass *pass);
void mpm_scalar_rows_run(struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                         mpm_pass *pass);

#endif

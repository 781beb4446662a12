/* Values of particles and values of nodes, exchanged with the weights S alone:
 *
 *   spread    n_i += sum_p m_p S_ip v_p                    from a field of the particles
 *   gather    v_p  = sum_i S_ip n_i                        to a field of the particles
 *   filter    n_i += sum_p m_p S_ip sum_j S_jp w_j         both, and S is found once
 *
 * by either set of kernels, and with the additional velocity fields of nodes near cracks. Sums over
 * particles go in their order. Spread is the transpose of gather times the particles' masses: what
 * one hands over, sum_i n_i u_i, is sum_p m_p v_p (S u)_p of the other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_EXCHANGE_H
#define MPM_METHOD_EXCHANGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    MPM_EXCHANGE_COMPONENTS = 2, /* at most: a scalar, or a vector */
    MPM_NODE_VALUES = 4,         /* numbers of a node in an array: a vector of the fast kernels */
};

struct mpm_exchange {
    size_t components;
    size_t field; /* enum mpm_particle_field, of doubles; read without `from`, set without `to` */
    const double *from; /* nodes; component k is number k. Or NULL */
    /* Nodes; component k is added to number 2 k, and perhaps to the next one: as grid.gradient has
     * them. Others are of no use afterwards. NULL: to particles */
    double *to;
};

struct mpm_state;

/* Runs one, within a step; `to` has been cleared. Cost: a stencil for each particle, and one vector
 * for each of its nodes, read or added to. */
void mpm_exchange_run(struct mpm_state *state, int workers, const struct mpm_exchange *exchange);

/* *state->exchange of a strip: the pass of the reference kernels. */
void mpm_pass_exchange(void *state, int64_t strip, int worker);

#endif

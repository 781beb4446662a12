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

/* Of a node in an array that takes part: a vector of the fast kernels. */
enum { MPM_NODE_VALUES = 4 };

struct mpm_exchange {
    size_t components; /* up to MPM_NODE_VALUES: a scalar has one */
    size_t field; /* enum mpm_particle_field, of doubles; read without `from`, set without `to` */
    const double *from; /* per node: MPM_NODE_VALUES numbers, the first ones in use; or NULL */
    double *to;         /* the same; the others are of no use afterwards. Not NULL if `from` is */
    bool pairs;         /* in `to`, component k goes to number 2 k: as grid.gradient has them */
};

struct mpm_state;

/* Runs one, within a step. Nodes have been cleared. Cost: a stencil for each particle, and one
 * vector for each of its nodes, read or added to. */
void mpm_exchange_run(struct mpm_state *state, int workers, const struct mpm_exchange *exchange);

/* The same of a strip, with state->exchange: the pass of the reference kernels. */
void mpm_pass_exchange(void *state, int64_t strip, int worker);

#endif

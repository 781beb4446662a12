/* The displacement of a field beside a node, as a linear function of the place: the jump between
 * two of them is what an imperfect interface acts by.
 *
 * With w_p = A_p S_ip, places x_p from the node, displacements u_p and gradients H_p = I - F_p^-1,
 * a + B x minimises
 *     sum_p w_p |u_p - a - B x_p|^2 + lambda |B - H|^2 sum_p w_p,   H = sum_p w_p H_p/sum_p w_p,
 * and in the same way for velocities, with H = 0. B follows the places of the particles, so that
 * the fit of a body that nodes move linearly moves with the node; H decides where places do not,
 * all being on one line, or so close together that B would magnify their noise: lambda is 1e-6 of a
 * cell's square and a tenth of the square of the way from their middle to the place.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_DISPLACEMENT_FIT_H
#define MPM_METHOD_DISPLACEMENT_FIT_H

#include "method/contact/body_contact_state.h"

/* One particle. */
struct mpm_displacement_sample {
    double weight;
    const double *x, *u, *h, *v;
};
void mpm_displacement_add(struct mpm_displacement_sums *sums,
                          const struct mpm_displacement_sample *sample);

/* Adds those of particles mirrored at the plane across an axis. */
void mpm_displacement_fold(struct mpm_displacement_sums *sums,
                           const struct mpm_displacement_sums *mirrored, int axis);

/* On that plane: the sums of both sides, but for a factor. */
void mpm_displacement_put_on_plane(struct mpm_displacement_sums *sums, int axis);

struct mpm_displacement_fit {
    double u[2], v[2];
    double f[4]; /* F, xx xy yx yy */
};

/* At a place x from the node; without particles u and v are zero and F is I. `unit`: the size of a
 * cell. */
struct mpm_displacement_fit mpm_displacement_fit(const struct mpm_displacement_sums *sums,
                                                 double unit, const double x[2]);

/* [u], of the second field less the first. */
void mpm_displacement_jump(const struct mpm_displacement_fit *first,
                           const struct mpm_displacement_fit *second, double jump[2]);

#endif

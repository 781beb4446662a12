/* Linear stability of the step for a column that CPDI holds stretched: at what rate a small
 * departure from the uniform state grows.
 *
 * `particles` equal particles stand on each other between a foot that is held at node 0 and an end
 * that a traction loads. Cells have size 1; a particle is `length` long in the state as it is, with
 * the Cauchy stress `stress`, the slope `tangent` of that stress over the relative change of
 * length, and the density `density`. In one dimension the force on node i is
 *
 *     f_i = - sum_p sigma_p (N_i(r_p) - N_i(l_p)) + T N_i(r_last),      N the hat function,
 *
 * with domains' ends r_p, l_p = x_p +- L_p/2 (CPDI: S is the mean of N at both ends, G their
 * difference over L), so that touching domains of one stress are in balance wherever the nodes are.
 * Small departures xi_p of positions, v_p of velocities and e_p of relative lengths follow
 *
 *     e_p += before dt G_p v,             v_i = sum_p m S_ip v_p / M_i
 *     M_i a_i = - sum_p [ (tangent e_p + stress (e_p - d_p)) (N_i(r_p) - N_i(l_p))
 *               + stress (N_i'(r_p) (xi_p + L d_p/2) - N_i'(l_p) (xi_p - L d_p/2)) ]
 *               + stress N_i'(r_last) (xi_last + L d_last/2)
 *     v_p += dt S_p a - (1 - fraction) (v_p - S_p v)
 *     e_p += after dt G_p w,              w: v + dt a, or v_p extrapolated again
 *     xi_p += dt S_p u,                   u: by `position`
 *
 * d_p being e_p at the start of the step, as domains and gradients are those of the start and the
 * volume is that of now (solver/README.md, "One step"). A departure for
 * which ends of neighbours part by g pulls at the nodes about the gap by stress N' g: nothing in
 * the material resists it. Such gaps grow where u and the velocity of the strains differ.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_STRETCHED_COLUMN_H
#define VERIFICATION_EXACT_STRETCHED_COLUMN_H

#include <stdbool.h>
#include <stddef.h>

enum stretched_order {
    STRETCHED_USL,
    STRETCHED_MUSL,
    STRETCHED_USF,
    STRETCHED_USAVG,
    STRETCHED_USAVG_ONCE /* without re-extrapolation */
};

enum stretched_position {
    STRETCHED_GRID_VELOCITY,  /* u = v + dt a */
    STRETCHED_MIDPOINT,       /* u = v + dt a/2 */
    STRETCHED_STRAIN_VELOCITY /* u = before v + after w: that of the strains */
};

enum { STRETCHED_PARTICLES_MAX = 64 };

struct stretched_column {
    enum stretched_order order;
    enum stretched_position position;
    double fraction;  /* of FLIP: 1 for all */
    size_t particles; /* 2 to STRETCHED_PARTICLES_MAX */
    double length, stress, tangent, density;
};

/* ln of the largest modulus of an eigenvalue of the step of length `time_step` over that length:
 * the rate at which the fastest departure grows, in 1/time. Eigenvalues on the unit circle that
 * meet are known to half the digits, so that a rate below 1e-6/time_step counts as none. NaN
 * outside of the stated range, or if GSL fails. No end of a domain may lie on a node, where N has
 * no slope, but the foot. Cost: (3 particles)^3, 20 ms for 24. */
double stretched_column_rate(const struct stretched_column *column, double time_step);

#endif

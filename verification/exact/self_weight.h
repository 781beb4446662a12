/* A column that stands under its own weight, held sideways or without Poisson's effect: the
 * exact solution of cases T4 and T5.
 *
 * P_yy = rho_0 g (l_0 - Y) balances the weight of what is above the initial height Y, whatever the
 * law, and where nothing strains sideways the Cauchy stress sigma_yy is P_yy (sigma = P F^T / J,
 * J = F_yy): W. M. Coombs, C. E. Augarde, AMPLE: a material point learning environment, Adv. Eng.
 * Softw. 139 (2020) 102748. For the law `linear_elastic`, P_yy = M (F_yy - 1) at any strain
 * (vibrating_bar.h), so that
 *
 *     v(Y) = rho_0 g / M (l_0 Y - Y^2/2).
 *
 * A weight w + s Y that grows with the height, s = 0 above, adds s (l_0^2 - Y^2)/2 to the stress
 * and s/M (l_0^2 Y/2 - Y^3/6) to the displacement, where the column moves so little that s y is s
 * Y.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_SELF_WEIGHT_H
#define VERIFICATION_EXACT_SELF_WEIGHT_H

struct self_weight {
    double height;  /* l_0 */
    double weight;  /* rho_0 g at the foot, negative downwards */
    double slope;   /* s: what it has more in a unit of height */
    double modulus; /* M: E without Poisson's effect */
};

/* sigma_yy at the initial height Y, 0 <= Y <= l_0. */
double self_weight_stress(const struct self_weight *column, double start);

/* v(Y) */
double self_weight_displacement(const struct self_weight *column, double start);

#endif

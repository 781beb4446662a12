/* The field around the tip of a crack whose faces are free, in an isotropic elastic body at small
 * strain: the terms of M. L. Williams (J. Appl. Mech. 24 (1957) 109-114) that K_I, K_II are
 * for, and the stress T along the crack. Local axes at the tip: 1 away from the crack, 2 on the
 * left of it; theta from -pi to pi, the faces. With G the shear modulus, and
 *     kappa = 3 - 4 nu (plane strain) or (3 - nu)/(1 + nu) (plane stress):
 *     u_1 = sqrt(r/(2 pi))/(2 G) { K_I  [(kappa - 1/2) cos(theta/2) - cos(3 theta/2)/2]
 *                                + K_II [(kappa + 3/2) sin(theta/2) + sin(3 theta/2)/2] },
 *     u_2 = sqrt(r/(2 pi))/(2 G) { K_I  [(kappa + 1/2) sin(theta/2) - sin(3 theta/2)/2]
 *                                - K_II [(kappa - 3/2) cos(theta/2) + cos(3 theta/2)/2] },
 * and of T: u_1 = T x_1 (kappa + 1)/(8 G), u_2 = -T x_2 (3 - kappa)/(8 G).
 *     J_1 = (K_I^2 + K_II^2)/E',   J_2 = -2 K_I K_II/E' (T = 0),   E' = 8 G/(kappa + 1).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_WILLIAMS_FIELD_H
#define VERIFICATION_EXACT_WILLIAMS_FIELD_H

struct williams_field {
    double mode_1, mode_2; /* K_I, K_II: stress times root of length */
    double parallel;       /* T */
    double shear, kappa;   /* G, kappa */
    double tip[2];
    double direction[2]; /* unit vector away from the crack */
};

/* Displacement, and its gradient u_i,k at [2 i + k], along the axes of the plane; not at the tip.
 */
void williams_field_displacement(const struct williams_field *field, const double place[2],
                                 double u[2]);
void williams_field_gradient(const struct williams_field *field, const double place[2],
                             double gradient[4]);

/* E' */
double williams_field_modulus(const struct williams_field *field);

#endif

/* Stress intensity of a long crack that a plane wave of tension strikes head on, in plane strain.
 *
 * A step of tension sigma travels at the speed c of longitudinal waves towards the crack, along its
 * normal, and arrives at t = 0:
 *     K_I(t) = 2 sigma/(1 - nu) sqrt(c t (1 - 2 nu)/pi)
 * until waves from elsewhere reach the tip (L. B. Freund, Dynamic Fracture Mechanics, Cambridge
 * University Press 1990, sec. 2.4 and 2.5). A wave whose tension grows evenly within `rise` is a
 * row of small steps: the integral of K_I over them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_STRUCK_CRACK_H
#define VERIFICATION_EXACT_STRUCK_CRACK_H

struct struck_crack {
    double modulus, poisson, density; /* Young's modulus; nu below 1/2 */
    double stress, rise;              /* sigma; time > 0 */
};

/* Speed of longitudinal waves. */
double struck_crack_celerity(const struct struck_crack *crack);

/* K_I at a time after the wave has begun to arrive; 0 before. */
double struck_crack_intensity(const struct struck_crack *crack, double time);

#endif

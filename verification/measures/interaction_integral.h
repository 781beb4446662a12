/* Stress intensities at the tip of a crack from the fields of particles around it, by the
 * interaction integral as a sum over an area (F. Z. Li, C. F. Shih, A. Needleman, Eng. Fract. Mech.
 * 21 (1985) 405-421; J. F. Yau, S. S. Wang, H. T. Corten, J. Appl. Mech. 47 (1980) 335-341).
 *
 * For a body at rest at small strain, a straight crack with free faces, and any q that is 1 near
 * the tip and 0 far from it, J = int (s_ij u_i,1 - W delta_1j) q,j dA, with direction 1 away from
 * the crack. For the sum of two states J has the terms of each and M = int (s_ij a_i,1 + t_ij u_i,1
 * - s_kl a_k,l delta_1j) q,j dA, which is 2 (K_I A_I + K_II A_II)/E' if the second state,
 * displacement a and stress t, is the field of a tip (williams_field.h) with A_I, A_II. Here q
 * falls smoothly from 1 at the distance `inner` to 0 at `outer`, as half a cosine; particles count
 * with their volume.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_INTERACTION_INTEGRAL_H
#define VERIFICATION_MEASURES_INTERACTION_INTEGRAL_H

#include "verification/exact/cracks/williams_field.h"

#include <stddef.h>

/* Fields of particles: undeformed places (2 each), F (5 each), stress (4 each), volume over the
 * thickness. */
struct interaction_particles {
    size_t count;
    const double *place, *gradient, *stress, *volume;
};

/* K_I and K_II. Of `tip` the material, the place and the direction are taken. Not a number if no
 * particle lies between `inner` and `outer`. Cost: two fields of a tip a particle. */
void interaction_integral(const struct interaction_particles *particles,
                          const struct williams_field *tip, double inner, double outer,
                          double intensity[2]);

#endif

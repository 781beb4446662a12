/* Plane stress of laws of the path: the end of a step with the F_zz at which tau_zz vanishes.
 *
 * With the start of the step and the plane part of F fixed, tau_zz is a function of x = ln F_zz
 * that rises. Over rho_0 its slope is K + 4/3 G as long as the step is elastic. Where it is
 * plastic, the deviatoric part is smaller: n_zz^2 <= 2/3 of the unit deviator n along the flow
 * leaves a slope of at least K. So the root is between x and x - tau_zz/K, further away at most by
 * what back stress and axes that turn change, and the first step of Newton's with the elastic slope
 * is exact in an elastic step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_PLANE_STRESS_H
#define MPM_MODEL_PLANE_STRESS_H

#include "model/material.h"

/* `update` of the material's law, which has `plane_stress`, to the F of `step` with another F_zz:
 * where |tau_zz| is not above round-off of its slope. On input f[MPM_ZZ] is a first guess, above 0;
 * on output it is F_zz. `step->f` is not read. State variables: `old_state` at the start of the
 * step, `state` at its end.
 * False: `update` has no end of the step; or there is no such F_zz, and f[MPM_ZZ] is NaN.
 * Cost: two to about ten times `update`. */
bool mpm_plane_stress_update(const struct mpm_material *material, const struct mpm_law_step *step,
                             double f[MPM_GRADIENT_SIZE], const double *old_state, double *state,
                             double stress[MPM_SYMMETRIC_SIZE], double *wave_speed_squared);

#endif

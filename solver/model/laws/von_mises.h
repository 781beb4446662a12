/* Von Mises' yield stress with its hardening, of solids with and without an equation of state; see
 * von_mises.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_VON_MISES_H
#define MPM_MODEL_VON_MISES_H

#include "model/laws/plastic_flow.h"

/* Rows of struct mpm_law_parameter. */
#define MPM_VON_MISES_PARAMETERS                                                                   \
    {.which = MPM_PARAMETER_YIELD_STRESS},                                                         \
        {.which = MPM_PARAMETER_HARDENING_MODULUS, .optional = true},                              \
        {.which = MPM_PARAMETER_HARDENING_STRAIN, .optional = true},                               \
        {.which = MPM_PARAMETER_HARDENING_EXPONENT, .optional = true},                             \
    {                                                                                              \
        .which = MPM_PARAMETER_KINEMATIC_MODULUS, .optional = true                                 \
    }

struct mpm_plastic_model mpm_von_mises_model(const struct mpm_material *material);

/* Plastic work per mass since t = 0, a function of p. */
double mpm_von_mises_dissipation(const struct mpm_material *material, const double *state);

/* What is wrong with the parameters of hardening, or NULL. */
const char *mpm_von_mises_fault(const double *parameter);

#endif

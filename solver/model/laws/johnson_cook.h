/* Johnson and Cook's yield stress, of solids with and without an equation of state; see
 * johnson_cook.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_JOHNSON_COOK_H
#define MPM_MODEL_JOHNSON_COOK_H

#include "model/laws/plastic_flow.h"

/* Rows of struct mpm_law_parameter. */
#define MPM_JOHNSON_COOK_PARAMETERS                                                                \
    {.which = MPM_PARAMETER_YIELD_STRESS},                                                         \
        {.which = MPM_PARAMETER_HARDENING_COEFFICIENT, .optional = true},                          \
        {.which = MPM_PARAMETER_HARDENING_EXPONENT, .optional = true},                             \
        {.which = MPM_PARAMETER_RATE_COEFFICIENT, .optional = true},                               \
        {.which = MPM_PARAMETER_REFERENCE_RATE, .optional = true},                                 \
        {.which = MPM_PARAMETER_SOFTENING_EXPONENT, .optional = true},                             \
        {.which = MPM_PARAMETER_REFERENCE_TEMPERATURE, .optional = true},                          \
        {.which = MPM_PARAMETER_MELTING_TEMPERATURE, .optional = true},                            \
        {.which = MPM_PARAMETER_START_TEMPERATURE, .optional = true},                              \
        {.which = MPM_PARAMETER_SPECIFIC_HEAT, .optional = true},                                  \
    {                                                                                              \
        .which = MPM_PARAMETER_TAYLOR_QUINNEY, .optional = true                                    \
    }

extern const struct mpm_plastic_model mpm_johnson_cook_model;

/* Does the temperature soften it? */
bool mpm_johnson_cook_softens(const struct mpm_material *material);

/* What is wrong with the parameters of strength, or NULL; in any scene, and beyond that in one
 * without transport.temperature. */
const char *mpm_johnson_cook_fault(const double *parameter);
const char *mpm_johnson_cook_fault_without_heat(const double *parameter);

#endif

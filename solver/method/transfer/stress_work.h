/* Work of a stress over a step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_STRESS_WORK_H
#define MPM_METHOD_STRESS_WORK_H

#include "model/material.h"

/* Integral of P : dF from the old F to the new one by the trapezoidal rule; P = tau F^-T is the
 * first Piola-Kirchhoff stress over rho_0. Error of third order in dF. */
double mpm_stress_work(const double old_stress[MPM_SYMMETRIC_SIZE],
                       const double stress[MPM_SYMMETRIC_SIZE], const struct mpm_law_step *step);

#endif

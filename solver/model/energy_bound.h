/* Upper bounds of the strain energy of many particles, without the logarithms and roots of the
 * laws: for a run's guard, which asks whether the energy is below a limit.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_ENERGY_BOUND_H
#define MPM_MODEL_ENERGY_BOUND_H

#include "model/material.h"

#include <stddef.h>

/* A number that is not below the sum of mass times strain energy of the particles begin .. end - 1,
 * all of that material, but for round-off of the material's stiffness times mass:
 *   neo_hookean: at small strains at most 1 + G/(3 K) times the sum;
 *   linear_elastic: the sum itself;
 *   any other law: HUGE_VAL, so that who asks takes the sum itself.
 * `deformation` has the components of F particle by particle; det F is above 0. Cost: some 25
 * instructions a particle. */
double mpm_energy_bound(const struct mpm_material *material,
                        double *const deformation[MPM_GRADIENT_SIZE], const double *mass,
                        size_t begin, size_t end);

#endif

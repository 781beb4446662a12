/* Upper bounds of the strain energy of many particles, without the logarithms and roots of the
 * laws: for a run's guard, which asks whether the energy is below a limit.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_ENERGY_BOUND_H
#define MPM_MODEL_ENERGY_BOUND_H

#include "model/material.h"

#include <stddef.h>

/* At least the sum of mass times strain energy of the particles begin .. end - 1, all of that
 * material, and at small strains no more than 1 + G/(3 K) times it (neo_hookean) or the sum itself
 * (linear_elastic; any other law). `deformation` has the components of F particle by particle, det
 * F above 0. To round-off of the material's stiffness times mass. Cost: some 25 instructions a
 * particle, those of its energy for any other law. */
double mpm_energy_bound(const struct mpm_material *material,
                        double *const deformation[MPM_GRADIENT_SIZE], const double *mass,
                        size_t begin, size_t end);

#endif

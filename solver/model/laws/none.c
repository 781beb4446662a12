/* No stress: the law of materials that only conduct. Nothing moves in a scene whose materials have
 * it (struct mpm_scene.at_rest), and no step asks it for a stress; it answers all the same, so that
 * what works on every law needs no exception.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/material.h"

static void stress(const struct mpm_material *material, const double f[MPM_GRADIENT_SIZE],
                   double tau[MPM_SYMMETRIC_SIZE], double *wave_speed_squared)
{
    (void)material;
    (void)f;
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        tau[k] = 0.0;
    *wave_speed_squared = 0.0;
}

static double energy(const struct mpm_material *material, const double f[MPM_GRADIENT_SIZE],
                     const double *state)
{
    (void)material;
    (void)f;
    (void)state;
    return 0.0;
}

static double energy_bound(const struct mpm_material *material, double *const f[MPM_GRADIENT_SIZE],
                           const double *mass, size_t begin, size_t end)
{
    (void)material;
    (void)f;
    (void)mass;
    (void)begin;
    (void)end;
    return 0.0;
}

static double thickness_stretch(const struct mpm_material *material,
                                const double f[MPM_GRADIENT_SIZE])
{
    (void)material;
    (void)f;
    return 1.0;
}

const struct mpm_material_law mpm_none = {
    .name = "none",
    .description = "no stress: the material only conducts; in all materials of a scene or in none",
    .stress = stress,
    .energy = energy,
    .energy_bound = energy_bound,
    .thickness_stretch = thickness_stretch,
};

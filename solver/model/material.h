/* Constitutive laws: a law is one file and one line of the list below.
 *
 * Laws are hyperelastic functions of the whole deformation gradient. They give the
 * Kirchhoff stress over the initial density, tau / rho_0 (Notes 18-22): with it a
 * nodal force needs the particle's mass only, not its current volume or density.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_MATERIAL_H
#define MPM_MODEL_MATERIAL_H

#include "base/status.h"
#include "base/tensor.h"

struct mpm_material_law;

/* A law with its constants, all over the initial density: length^2 / time^2. */
struct mpm_material {
    const struct mpm_material_law *law;
    double density; /* rho_0 */
    double bulk;    /* K / rho_0 */
    double shear;   /* G / rho_0 */
    double lame;    /* lambda / rho_0 = (K - 2 G / 3) / rho_0 */
};

struct mpm_material_law {
    const char *name;
    const char *description;
    /* tau / rho_0 at F, and the square of the fastest wave speed there (over the
     * directions of the plane, in the deformed body). F must have det F > 0. */
    void (*stress)(const struct mpm_material *material, const double f[MPM_GRADIENT_SIZE],
                   double stress[MPM_SYMMETRIC_SIZE], double *wave_speed_squared);
    /* Strain energy per unit mass; may use logarithms. */
    double (*energy)(const struct mpm_material *material, const double f[MPM_GRADIENT_SIZE]);
    /* The F_zz that makes tau_zz vanish for the plane part of F: plane stress. */
    double (*thickness_stretch)(const struct mpm_material *material,
                                const double f[MPM_GRADIENT_SIZE]);
};

/* One line a law: `const struct mpm_material_law mpm_<name>` in <name>.c. */
#define MPM_MATERIAL_LAWS(LAW)                                                                     \
    LAW(neo_hookean)                                                                               \
    LAW(linear_elastic)

#define MPM_DECLARE_LAW(name) extern const struct mpm_material_law mpm_##name;
MPM_MATERIAL_LAWS(MPM_DECLARE_LAW)
#undef MPM_DECLARE_LAW

/* The law of that name, or NULL. */
const struct mpm_material_law *mpm_material_law_find(const char *name);
/* "neo_hookean, linear_elastic" */
const char *mpm_material_law_names(void);

/* bulk K and shear G in the scene's units; density > 0. */
struct mpm_material mpm_material_make(const struct mpm_material_law *law, double density,
                                      double bulk, double shear);

#endif

/* Fast kernels: four particles at a time in the registers that the machine has, for scenes
 * whose nodes have one field or several (fast_patches.h). They do what the reference kernels in
 * transfer.c do, to round-off; sums over the nodes go in the same order, so that results are the
 * same bits for every level of SIMD, every compiler and every number of threads.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_H
#define MPM_METHOD_FAST_H

#include "method/passes.h"
#include "model/scene.h"

enum mpm_fast_geometry {
    MPM_FAST_PLANAR, /* plane strain and plane stress differ in the laws alone: fast_laws.h */
    MPM_FAST_AXISYMMETRIC,
    MPM_FAST_GEOMETRIES,
};

/* What passes of mechanics take along: nothing, a scalar (struct mpm_passes), or the velocity
 * gradients of APIC, which not all families have. */
enum mpm_fast_cargo {
    MPM_FAST_WITHOUT_SCALAR,
    MPM_FAST_WITH_SCALAR,
    MPM_FAST_AFFINE,
    MPM_FAST_CARGOES,
};

/* A family's kernels, by cargo, geometry and order of the stress update. */
typedef const struct mpm_passes mpm_fast_family[MPM_FAST_CARGOES][MPM_FAST_GEOMETRIES]
                                               [MPM_ORDER_COUNT];

/* The families that have fast kernels, those that the makefile compiles them for: F(enumerator,
 * name, level). */
#define MPM_FAST_FAMILIES(F, level)                                                                \
    F(MPM_CLASSIC, classic, level)                                                                 \
    F(MPM_UGIMP, ugimp, level)                                                                     \
    F(MPM_CPDI, cpdi, level)                                                                       \
    F(MPM_BSPLINE2, bspline2, level)                                                               \
    F(MPM_BSPLINE3, bspline3, level)

/* The levels of SIMD that this build has: one file, compiled for each. */
#define MPM_FAST_FAMILY(shape, name, level) extern mpm_fast_family mpm_fast_##name##_##level;
MPM_FAST_FAMILIES(MPM_FAST_FAMILY, baseline)
#ifdef __x86_64__
MPM_FAST_FAMILIES(MPM_FAST_FAMILY, v3)
#endif
#undef MPM_FAST_FAMILY

/* The widest level that this machine runs. */
enum mpm_simd mpm_fast_widest(void);

/* Why a scene has no fast kernels; NULL where it has them. */
const char *mpm_fast_lacks(const struct mpm_scene *scene);

/* The kernels of a scene that has them at a level; NULL where this build or machine lacks
 * the level. */
const struct mpm_passes *mpm_fast_passes(const struct mpm_scene *scene, enum mpm_simd simd);

#endif

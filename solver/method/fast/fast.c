/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/fast/fast.h"

#include "method/fast/fast_laws.h"
#include "method/shape/shape.h"
#include "method/transfer/transfers.h"

#define FAMILIES(level)                                                                            \
    {                                                                                              \
        [MPM_CLASSIC] = &mpm_fast_classic_##level, [MPM_UGIMP] = &mpm_fast_ugimp_##level,          \
        [MPM_CPDI] = &mpm_fast_cpdi_##level, [MPM_BSPLINE2] = &mpm_fast_bspline2_##level,          \
        [MPM_BSPLINE3] = &mpm_fast_bspline3_##level,                                               \
    }

static mpm_fast_family *const families[MPM_SIMD_COUNT][MPM_SHAPE_COUNT] = {
    [MPM_SIMD_BASELINE] = FAMILIES(baseline),
#ifdef MPM_FAST_V3 /* of the makefile: this build has that level */
    [MPM_SIMD_X86_64_V3] = FAMILIES(v3),
#endif
};

/* The level's AVX2, BMI and FMA stand for the whole of it: no processor has them alone. */
static bool runs_v3(void)
{
#ifdef MPM_FAST_V3
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
#else
    return false;
#endif
}

enum mpm_simd mpm_fast_widest(void)
{
    return runs_v3() ? MPM_SIMD_X86_64_V3 : MPM_SIMD_BASELINE;
}

static enum mpm_fast_geometry geometry_of(const struct mpm_scene *scene)
{
    if (scene->geometry != MPM_AXISYMMETRIC)
        return MPM_FAST_PLANAR;
    return scene->radius_update == MPM_RADIUS_HOOP ? MPM_FAST_HOOP_RADIUS : MPM_FAST_AXISYMMETRIC;
}

static bool has_vectors(const struct mpm_material_law *law)
{
    const struct mpm_fast_law *row = mpm_fast_laws_baseline;
    while (row->law != NULL && row->law != law)
        row++;
    return row->law != NULL;
}

const char *mpm_fast_lacks(const struct mpm_scene *scene)
{
    if (scene->axis == MPM_PLANAR && !mpm_shape_family(scene->shape)->point)
        return "there are no fast kernels for method.axis: planar";
    if (mpm_transfer_of(scene->transfer)->no_fast != NULL)
        return mpm_transfer_of(scene->transfer)->no_fast;
    for (size_t k = 0; k < scene->material_count; k++)
        if (!has_vectors(scene->materials[k].law))
            return "there are no fast kernels for the law of a material";
    if (scene->form == MPM_FORM_MOMENTUM)
        return "there are no fast kernels for method.form: momentum";
    return NULL;
}

const struct mpm_passes *mpm_fast_passes(const struct mpm_scene *scene, enum mpm_simd simd)
{
    mpm_fast_family *const family = families[simd][scene->shape];
    if (family == NULL || (simd == MPM_SIMD_X86_64_V3 && !runs_v3()))
        return NULL;
    return &(*family)[geometry_of(scene)][scene->stress_update];
}

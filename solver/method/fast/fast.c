/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/fast/fast.h"

#include "method/fast/fast_laws.h"
#include "method/shape/shape.h"
#include "method/transfer/transfers.h"
#include "mpm.h"

#define FAMILY(shape, name, level) [shape] = &mpm_fast_##name##_##level,
/* NULL: a family without fast kernels. */
static mpm_fast_family *const families[MPM_SIMD_COUNT][MPM_SHAPE_COUNT] = {
    [MPM_SIMD_BASELINE] = {MPM_FAST_FAMILIES(FAMILY, baseline)},
#ifdef MPM_FAST_V3 /* of the makefile: this build has that level */
    [MPM_SIMD_X86_64_V3] = {MPM_FAST_FAMILIES(FAMILY, v3)},
#endif
};
#undef FAMILY

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
    return scene->geometry == MPM_AXISYMMETRIC ? MPM_FAST_AXISYMMETRIC : MPM_FAST_PLANAR;
}

/* With several scalars each has passes of its own: sources of particles are those of one. So has
 * one with steps of its own, with several fields at a node, or beside APIC. */
static enum mpm_fast_cargo cargo_of(const struct mpm_scene *scene)
{
    int scalars = 0;
    for (int which = 0; which < MPM_SCALAR_COUNT; which++)
        scalars += scene->scalars[which].asked ? 1 : 0;
    if (scene->transfer == MPM_TRANSFER_APIC)
        return MPM_FAST_AFFINE;
    const bool each_step = scene->transport_substeps == 1 && scene->transport_every == 1;
    const bool one_field = scene->crack_count == 0 && scene->contact.field_count == 0;
    return scalars == 1 && each_step && one_field && !scene->at_rest ? MPM_FAST_WITH_SCALAR
                                                                     : MPM_FAST_WITHOUT_SCALAR;
}

/* What the equations of metals on vectors have. */
static bool metal_has_vectors(const struct mpm_material_spec *body)
{
    return !(body->parameter[MPM_PARAMETER_KINEMATIC_MODULUS] > 0.0) &&
           body->hardening.count == 0 && !mpm_material_softens(body->law, body->parameter);
}

bool mpm_fast_body_has_vectors(const struct mpm_material_spec *body)
{
    const struct mpm_fast_law *row = mpm_fast_laws_baseline;
    while (row->law != NULL && row->law != body->law)
        row++;
    if (row->metal)
        return metal_has_vectors(body);
    return row->law != NULL && mpm_law_state_count(body->law) == 0 && !body->viscosity.given;
}

const char *mpm_fast_lacks(const struct mpm_scene *scene)
{
    if (families[MPM_SIMD_BASELINE][scene->shape] == NULL)
        return "there are no fast kernels for this method.shape";
    if (scene->axis == MPM_PLANAR && !mpm_shape_family(scene->shape)->point)
        return "there are no fast kernels for method.axis: planar";
    if (scene->transfer == MPM_TRANSFER_APIC && scene->shape == MPM_CPDI)
        return "there are no fast kernels for method.transfer: apic with CPDI";
    if (mpm_scene_couples(scene))
        return "there are no fast kernels for stresses that depend on a scalar";
    if (mpm_scene_has_tables(scene))
        return "there are no fast kernels for properties that depend on the temperature";
    if (scene->form == MPM_FORM_MOMENTUM)
        return "there are no fast kernels for method.form: momentum";
    if (scene->crack_count > 0 && scene->crack_method == MPM_CRACKS_VISIBILITY)
        return "there are no fast kernels for method.cracks: visibility";
    return NULL;
}

const struct mpm_passes *mpm_fast_passes(const struct mpm_scene *scene, enum mpm_simd simd)
{
    mpm_fast_family *const family = families[simd][scene->shape];
    if (family == NULL || (simd == MPM_SIMD_X86_64_V3 && !runs_v3()))
        return NULL;
    return &(*family)[cargo_of(scene)][geometry_of(scene)][scene->stress_update];
}

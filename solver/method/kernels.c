/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/kernels.h"

#include "method/fast.h"
#include "method/grid_update.h"
#include "method/transfer.h"

static const struct mpm_passes reference_passes[] = {
    [MPM_USL] = {mpm_pass_momentum_and_force, NULL, mpm_pass_velocity, mpm_pass_stress_and_position,
                 mpm_pass_recompute},
    [MPM_MUSL] = {mpm_pass_momentum_and_force, NULL, mpm_pass_velocity_and_momentum,
                  mpm_pass_stress_and_position, mpm_pass_recompute},
    [MPM_USF] = {mpm_pass_momentum, mpm_pass_stress_and_force, mpm_pass_velocity, mpm_pass_position,
                 mpm_pass_recompute},
    [MPM_USAVG] = {mpm_pass_momentum, mpm_pass_stress_and_force, mpm_pass_velocity_and_momentum,
                   mpm_pass_stress_and_position, mpm_pass_recompute},
};

static const char *const simd_names[MPM_SIMD_COUNT] = {
    [MPM_SIMD_AUTO] = "auto",
    [MPM_SIMD_BASELINE] = "baseline",
    [MPM_SIMD_X86_64_V3] = "x86-64-v3",
};

const char *mpm_simd_name(enum mpm_simd simd)
{
    return simd_names[simd];
}

static struct mpm_kernel_choice reference_choice(const struct mpm_scene *scene, const char *reason)
{
    return (struct mpm_kernel_choice){
        .passes = &reference_passes[scene->stress_update],
        .flip_particles = scene->flip_fraction < 1.0 ? mpm_pass_flip_fraction : NULL,
        .name = "reference",
        .reason = reason,
        .simd = "none",
    };
}

enum mpm_status mpm_kernels_choose(const struct mpm_scene *scene,
                                   const struct mpm_simulation_options *options,
                                   struct mpm_kernel_choice *choice, struct mpm_error *error)
{
    const enum mpm_simd simd = options->simd == MPM_SIMD_AUTO ? mpm_fast_widest() : options->simd;
    const bool damped = scene->flip_fraction < 1.0;
    const char *const lacking = mpm_fast_lacks(scene);
    if ((unsigned)options->kernels >= MPM_KERNELS_COUNT || (unsigned)simd >= MPM_SIMD_COUNT)
        return mpm_error_set(error, MPM_BAD_INPUT, "kernels %d, simd %d; allowed: below %d and %d",
                             (int)options->kernels, (int)simd, MPM_KERNELS_COUNT, MPM_SIMD_COUNT);
    if (options->kernels == MPM_KERNELS_REFERENCE) {
        *choice = reference_choice(scene, "asked for; scalar, one particle at a time");
        return MPM_OK;
    }
    if (lacking != NULL && options->kernels == MPM_KERNELS_FAST)
        return mpm_error_set(error, MPM_BAD_INPUT, "kernels: fast: %s; allowed: auto, reference",
                             lacking);
    if (lacking != NULL) {
        *choice = reference_choice(scene, lacking);
        return MPM_OK;
    }
    *choice = (struct mpm_kernel_choice){
        .passes = mpm_fast_passes(scene, simd),
        .flip_rows = damped ? mpm_row_flip_fraction : NULL,
        .flip_particles = damped ? mpm_pass_keep_fraction : NULL,
        .name = "fast",
        .reason = "all that the scene asks for has them; four particles at a time",
        .simd = simd_names[simd],
    };
    if (choice->passes == NULL)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "simd: %s is not what this build and this machine have; allowed: "
                             "auto, baseline",
                             simd_names[simd]);
    return MPM_OK;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/kernels.h"

#include "method/fast.h"
#include "method/grid_update.h"
#include "method/smoothing.h"
#include "method/transfer.h"

static const struct mpm_passes reference_passes[] = {
    [MPM_USL] = {mpm_pass_momentum_and_force, NULL, mpm_pass_velocity, mpm_pass_stress_and_position,
                 mpm_pass_recompute, mpm_pass_smooth},
    [MPM_MUSL] = {mpm_pass_momentum_and_force, NULL, mpm_pass_velocity_and_momentum,
                  mpm_pass_stress_and_position, mpm_pass_recompute, mpm_pass_smooth},
    [MPM_USF] = {mpm_pass_momentum, mpm_pass_stress_and_force, mpm_pass_velocity, mpm_pass_position,
                 mpm_pass_recompute, mpm_pass_smooth},
    [MPM_USAVG] = {mpm_pass_momentum, mpm_pass_stress_and_force, mpm_pass_velocity_and_momentum,
                   mpm_pass_stress_and_position, mpm_pass_recompute, mpm_pass_smooth},
};

/* What a transfer does besides the passes: in the reference kernels, which have a pass for the
 * fraction, and in the fast ones, which have it done to the nodes. */
struct transfer {
    bool smooths; /* from order 2 on; before that it is PIC */
    mpm_pass *rows;
};

static const struct transfer transfers[] = {
    [MPM_TRANSFER_FLIP] = {false, NULL},
    [MPM_TRANSFER_PIC] = {false, NULL},
    [MPM_TRANSFER_XPIC] = {true, mpm_row_xpic},
    [MPM_TRANSFER_FMPM] = {true, mpm_row_fmpm},
};

static void choose_transfer(const struct mpm_scene *scene, bool fast,
                            struct mpm_kernel_choice *choice)
{
    const struct transfer *const transfer = &transfers[scene->transfer];
    if (transfer->smooths && scene->transfer_order > 1) {
        choice->smooth = mpm_smoothing_run;
        choice->flip_rows = transfer->rows;
        choice->flip_particles = mpm_pass_keep_fraction;
    } else if (scene->flip_fraction < 1.0) {
        choice->flip_rows = fast ? mpm_row_flip_fraction : NULL;
        choice->flip_particles = fast ? mpm_pass_keep_fraction : mpm_pass_flip_fraction;
    }
}

static const char *const simd_names[MPM_SIMD_COUNT] = {
    [MPM_SIMD_AUTO] = "auto",
    [MPM_SIMD_BASELINE] = "baseline",
    [MPM_SIMD_X86_64_V3] = "x86-64-v3",
};

const char *mpm_simd_name(enum mpm_simd simd)
{
    return simd_names[simd];
}

enum mpm_status mpm_kernels_choose(const struct mpm_scene *scene,
                                   const struct mpm_simulation_options *options,
                                   struct mpm_kernel_choice *choice, struct mpm_error *error)
{
    const enum mpm_simd simd = options->simd == MPM_SIMD_AUTO ? mpm_fast_widest() : options->simd;
    if ((unsigned)options->kernels >= MPM_KERNELS_COUNT || (unsigned)simd >= MPM_SIMD_COUNT)
        return mpm_error_set(error, MPM_BAD_INPUT, "kernels %d, simd %d; allowed: below %d and %d",
                             (int)options->kernels, (int)simd, MPM_KERNELS_COUNT, MPM_SIMD_COUNT);
    if (options->kernels == MPM_KERNELS_REFERENCE) {
        *choice = (struct mpm_kernel_choice){
            .passes = &reference_passes[scene->stress_update],
            .name = "reference",
            .reason = "asked for; scalar, one particle at a time",
            .simd = "none",
        };
        choose_transfer(scene, false, choice);
        return MPM_OK;
    }
    *choice = (struct mpm_kernel_choice){
        .passes = mpm_fast_passes(scene, simd),
        .name = "fast",
        .reason = "every feature of a scene has them; four particles at a time",
        .simd = simd_names[simd],
    };
    if (choice->passes == NULL)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "simd: %s is not what this build and this machine have; allowed: "
                             "auto, baseline",
                             simd_names[simd]);
    choose_transfer(scene, true, choice);
    return MPM_OK;
}

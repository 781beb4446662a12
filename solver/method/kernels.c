/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/kernels.h"

#include "method/fast/fast.h"
#include "method/fast/fast_laws.h"
#include "method/grid/grid_update.h"
#include "method/transfer/transfer.h"
#include "method/transfer/transfers.h"
#include "method/transport/transport_passes.h"

static const struct mpm_passes *reference_passes(const struct mpm_scene *scene)
{
    return &mpm_transfer_of(scene->transfer)->passes[scene->stress_update];
}

/* What transfers do besides the passes. The reference kernels have a pass for a fraction; the fast
 * ones have it done to the nodes. */
static void choose_transfer(const struct mpm_scene *scene, bool fast,
                            struct mpm_kernel_choice *choice)
{
    const struct mpm_transfer *const transfer = mpm_transfer_of(scene->transfer);
    /* APIC takes more than positions from v^{n+1}, which the rows change for the midpoint update */
    const bool reads_ends =
        scene->transfer == MPM_TRANSFER_APIC && scene->position_update == MPM_MIDPOINT;
    if (transfer->smooth != NULL && scene->transfer_order > 1) { /* order 1 is PIC */
        choice->smooth = transfer->smooth;
        choice->flip_rows = transfer->smoothed_rows;
        choice->flip_particles = mpm_pass_keep_fraction;
    } else if (scene->flip_fraction < 1.0 && fast && !reads_ends) {
        choice->flip_rows = mpm_row_flip_fraction;
        choice->flip_particles = mpm_pass_keep_fraction;
    } else if (scene->flip_fraction < 1.0) {
        choice->flip_particles = mpm_pass_flip_fraction;
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

static void choose_reference(const struct mpm_scene *scene, const char *reason,
                             struct mpm_kernel_choice *choice)
{
    *choice = (struct mpm_kernel_choice){
        .passes = reference_passes(scene),
        .start_rows = mpm_row_start_velocity,
        .scalar = mpm_scene_has_tables(scene) ? &mpm_table_scalar_passes : &mpm_scalar_passes,
        .name = "reference",
        .reason = reason,
        .simd = "none",
    };
    choose_transfer(scene, false, choice);
}

/* Planes of symmetry and contact between bodies need masses of nodes before velocities are made of
 * them. */
static bool reads_masses(const struct mpm_scene *scene)
{
    bool any = scene->contact.field_count > 0;
    for (size_t k = 0; k < scene->boundary_count; k++)
        any = any || scene->boundaries[k].symmetry;
    return any;
}

static bool all_in_vectors(const struct mpm_scene *scene)
{
    const bool plane_stress = scene->geometry == MPM_PLANE_STRESS;
    bool all = true;
    for (size_t k = 0; k < scene->material_count; k++)
        all = all && mpm_fast_body_has_vectors(&scene->materials[k]) &&
              !(plane_stress && mpm_law_state_count(scene->materials[k].law) > 0);
    return all || scene->at_rest;
}

static enum mpm_status choose_fast(const struct mpm_scene *scene, bool packed_fields,
                                   enum mpm_simd simd, struct mpm_kernel_choice *choice,
                                   struct mpm_error *error)
{
    const bool without_forces = mpm_stress_order(scene->stress_update)->before > 0.0;
    *choice = (struct mpm_kernel_choice){
        .passes = mpm_fast_passes(scene, simd),
        .start_rows = without_forces ? mpm_row_start_from_sums : mpm_row_start_velocity,
        .name = "fast",
        .reason =
            all_in_vectors(scene)
                ? "all features of the scene have them; four particles at a time"
                : "all features of the scene have them; four particles at a time, but for the "
                  "stress of some materials",
        .simd = simd_names[simd],
    };
    if (choice->passes == NULL)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "simd: %s is not what this build and this machine have; allowed: "
                             "auto, baseline",
                             simd_names[simd]);
    choice->scalar = choice->passes->scalar;
    if (without_forces && (packed_fields || reads_masses(scene))) {
        choice->gather_rows = mpm_row_gather_mass;
        choice->start_rows = mpm_row_start_velocity;
    }
    choose_transfer(scene, true, choice);
    return MPM_OK;
}

enum mpm_status mpm_kernels_choose(const struct mpm_scene *scene, bool packed_fields,
                                   const struct mpm_simulation_options *options,
                                   struct mpm_kernel_choice *choice, struct mpm_error *error)
{
    const enum mpm_simd simd = options->simd == MPM_SIMD_AUTO ? mpm_fast_widest() : options->simd;
    const char *const lacking = mpm_fast_lacks(scene);
    if ((unsigned)options->kernels >= MPM_KERNELS_COUNT || (unsigned)simd >= MPM_SIMD_COUNT)
        return mpm_error_set(error, MPM_BAD_INPUT, "kernels %d, simd %d; allowed: below %d and %d",
                             (int)options->kernels, (int)simd, MPM_KERNELS_COUNT, MPM_SIMD_COUNT);
    if (lacking != NULL && options->kernels == MPM_KERNELS_FAST)
        return mpm_error_set(error, MPM_BAD_INPUT, "kernels: fast: %s; allowed: auto, reference",
                             lacking);
    if (options->kernels == MPM_KERNELS_REFERENCE)
        choose_reference(scene, "selected; scalar, one particle at a time", choice);
    else if (lacking != NULL)
        choose_reference(scene, lacking, choice);
    else
        return choose_fast(scene, packed_fields, simd, choice, error);
    return MPM_OK;
}

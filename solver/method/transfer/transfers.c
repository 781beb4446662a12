/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/transfers.h"

#include "method/transfer/affine.h"
#include "method/transfer/projection.h"
#include "method/transfer/smoothing.h"
#include "method/transfer/transfer.h"
#include "model/particles.h"

/* The steps of one way to exchange: to the grid, with the stress at hand or without; what
 * reads back from it. */
#define ORDERS(momentum, momentum_force, stress_force, velocity, extrapolate, position, finish)    \
    {                                                                                              \
        [MPM_USL] = STEP(momentum_force, NULL, velocity, finish),                                  \
        [MPM_MUSL] = STEP(momentum_force, NULL, extrapolate, finish),                              \
        [MPM_USF] = STEP(momentum, stress_force, velocity, position),                              \
        [MPM_USAVG] = STEP(momentum, stress_force, extrapolate, finish),                           \
        [MPM_USAVG_ONCE] = STEP(momentum, stress_force, velocity, finish),                         \
    }
#define STEP(first, before, back, last)                                                            \
    {                                                                                              \
        first, before, back, last, mpm_pass_recompute, mpm_pass_project, NULL, false               \
    }

static const struct mpm_passes velocity_passes[MPM_ORDER_COUNT] = ORDERS(
    mpm_pass_momentum, mpm_pass_momentum_and_force, mpm_pass_stress_and_force, mpm_pass_velocity,
    mpm_pass_velocity_and_momentum, mpm_pass_position, mpm_pass_stress_and_position);

static const struct mpm_passes affine_passes[MPM_ORDER_COUNT] =
    ORDERS(mpm_pass_affine_momentum, mpm_pass_affine_momentum_and_force, mpm_pass_stress_and_force,
           mpm_pass_affine_velocity, mpm_pass_affine_velocity_and_momentum, mpm_pass_position,
           mpm_pass_stress_and_position);

static const struct mpm_transfer transfers[MPM_TRANSFER_COUNT] = {
    [MPM_TRANSFER_FLIP] = {.name = "flip", .fraction = true, .passes = velocity_passes},
    [MPM_TRANSFER_PIC] = {.name = "pic", .passes = velocity_passes},
    [MPM_TRANSFER_XPIC] = {.name = "xpic",
                           .order = true,
                           .passes = velocity_passes,
                           .smooth = mpm_smooth_start,
                           .smoothed_rows = mpm_row_xpic,
                           .no_momentum = "takes the weights back out of nodal velocities"},
    [MPM_TRANSFER_FMPM] = {.name = "fmpm",
                           .order = true,
                           .passes = velocity_passes,
                           .smooth = mpm_smooth_end,
                           .smoothed_rows = mpm_row_fmpm,
                           .no_momentum = "makes other nodal velocities of the momenta",
                           .no_grid_drag = "gives particles other velocities than the nodes'"},
    [MPM_TRANSFER_APIC] = {.name = "apic",
                           .carries = MPM_USE_APIC,
                           .passes = affine_passes,
                           .no_momentum = "carries the gradient of nodal velocities",
                           .no_visibility = "takes a gradient from all of a particle's nodes",
                           .no_grid_drag = "carries the gradient of nodal velocities"},
};

const struct mpm_transfer *mpm_transfer_of(enum mpm_transfer_kind kind)
{
    return &transfers[kind];
}

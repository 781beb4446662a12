/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/state.h"

static const struct mpm_stress_order orders[] = {
    [MPM_USL] = {.name = "usl", .before = 0.0, .after = 1.0, .extrapolate = false},
    [MPM_MUSL] = {.name = "musl", .before = 0.0, .after = 1.0, .extrapolate = true},
    [MPM_USF] = {.name = "usf", .before = 1.0, .after = 0.0, .extrapolate = false},
    [MPM_USAVG] = {.name = "usavg", .before = 0.5, .after = 0.5, .extrapolate = true},
    [MPM_USAVG_ONCE] = {.name = "usavg once", .before = 0.5, .after = 0.5, .extrapolate = false},
};

const struct mpm_stress_order *mpm_stress_order(enum mpm_stress_update update)
{
    return &orders[update];
}

void mpm_failure_merge(struct mpm_failure *into, const struct mpm_failure *failure)
{
    if (failure->kind == MPM_NO_FAILURE)
        return;
    if (into->kind == MPM_NO_FAILURE || failure->particle < into->particle)
        *into = *failure;
}

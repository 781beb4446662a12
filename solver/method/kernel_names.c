/* The names of kernels and instructions, as commands take and print them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"

#include <string.h>

static const char *const kernels_names[MPM_KERNELS_COUNT] = {
    [MPM_KERNELS_AUTO] = "auto",
    [MPM_KERNELS_REFERENCE] = "reference",
    [MPM_KERNELS_FAST] = "fast",
};

const char *mpm_kernels_name(enum mpm_kernels kernels)
{
    return kernels_names[kernels];
}

enum mpm_status mpm_kernels_find(const char *name, enum mpm_kernels *kernels,
                                 struct mpm_error *error)
{
    for (int k = 0; k < MPM_KERNELS_COUNT; k++)
        if (strcmp(name, kernels_names[k]) == 0) {
            *kernels = (enum mpm_kernels)k;
            return MPM_OK;
        }
    return mpm_error_set(error, MPM_BAD_INPUT,
                         "'%s' is no set of kernels; allowed: auto, reference, fast", name);
}

enum mpm_status mpm_simd_find(const char *name, enum mpm_simd *simd, struct mpm_error *error)
{
    for (int k = 0; k < MPM_SIMD_COUNT; k++)
        if (strcmp(name, mpm_simd_name((enum mpm_simd)k)) == 0) {
            *simd = (enum mpm_simd)k;
            return MPM_OK;
        }
    return mpm_error_set(error, MPM_BAD_INPUT,
                         "'%s' is no level of SIMD; allowed: auto, baseline, x86-64-v3", name);
}

/* Chooses between the two sets of kernels: which passes over the particles a scene gets.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_KERNELS_H
#define MPM_METHOD_KERNELS_H

#include "method/passes.h"
#include "model/scene.h"

/* Looks the passes up for a scene; `packed_fields`: may its nodes have some (fields.h)?
 * MPM_BAD_INPUT: a level of SIMD was selected that build
 * or machine do not have, or no set of kernels at all. */
enum mpm_status mpm_kernels_choose(const struct mpm_scene *scene, bool packed_fields,
                                   const struct mpm_simulation_options *options,
                                   struct mpm_kernel_choice *choice, struct mpm_error *error);

#endif

/* Passes of scenes with packed velocity fields (fields.h), as cracks have them: fast kernels for
 * all particles but those that have such fields in their stencils.
 *
 * These take the reference kernels, spans of a strip at a
 * time; the rest of the strip takes the fast ones. What the strip sums up is put together of both.
 * Both agree to round-off, not to the bit: particles of such scenes keep their stress in the last
 * good state (simulation/backup.c), which is found again from F elsewhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_SPLIT_H
#define MPM_METHOD_SPLIT_H

#include "method/passes.h"

/* They run state->kernels.plain and .general. */
extern const struct mpm_passes mpm_split_passes;

#endif

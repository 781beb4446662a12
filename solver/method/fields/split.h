/* Passes of scenes with packed velocity fields (fields.h), as cracks have them: fast kernels for
 * all particles but those that have such fields in their stencils.
 *
 * These particles take the reference kernels, one span of a strip at a time; the rest of the strip
 * takes the fast ones. The sums of a strip are made of both. Both sets of kernels agree to
 * round-off, not to the bit: the last good state of such scenes has the particles' stress
 * (simulation/backup.c), which is computed again from F in other scenes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_SPLIT_H
#define MPM_METHOD_SPLIT_H

#include "method/passes.h"

/* They run state->kernels.plain and .general. */
extern const struct mpm_passes mpm_split_passes;

#endif

/* What a scene's choice of method.transfer consists of. A new transfer is one name in MPM_TRANSFERS
 * (model/scene.h), one row of the table in transfers.c, and the file of its passes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_TRANSFERS_H
#define MPM_METHOD_TRANSFERS_H

#include "method/passes.h"
#include "model/scene.h"

struct mpm_transfer {
    const char *name;
    /* Keys of method.transfer that it takes; the latter is required then. */
    bool fraction, order;
    /* Bits of enum mpm_particle_use for what its particles carry. */
    unsigned carries;
    /* Reference kernels by order of the stress update; those of form: momentum, or NULL. */
    const struct mpm_passes *passes, *by_momentum;
    /* From order 2 on, before particles read back: makes the motion that they read of smoothed
     * velocities. NULL: nothing. */
    mpm_pass *smoothed_rows;
    /* Why it is not with form: momentum, not with additional velocity fields and not with grid
     * damping at the particles (with "it" before all three), and has no fast kernels; NULL: it is.
     */
    const char *no_momentum, *no_fields, *no_grid_drag, *no_fast;
};

const struct mpm_transfer *mpm_transfer_of(enum mpm_transfer_kind kind);

#endif

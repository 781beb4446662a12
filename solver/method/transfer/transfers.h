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
    const struct mpm_passes *passes; /* reference kernels, by order of the stress update */
    /* From order 2 on, before particles read back: smooths velocities over all nodes, and makes the
     * motion that particles read of them. NULL: nothing. */
    void (*smooth)(struct mpm_state *state, int workers);
    mpm_pass *smoothed_rows;
    /* Why it is not with form: momentum, not with cracks: visibility and not with grid damping at
     * the particles (with "it" before all three); NULL: it is. */
    const char *no_momentum, *no_visibility, *no_grid_drag;
};

const struct mpm_transfer *mpm_transfer_of(enum mpm_transfer_kind kind);

#endif

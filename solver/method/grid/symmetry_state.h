/* What planes of symmetry keep; see symmetry.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_SYMMETRY_STATE_H
#define MPM_METHOD_SYMMETRY_STATE_H

#include <stddef.h>
#include <stdint.h>

/* A plane of symmetry: a line of nodes; see symmetry.h. */
struct mpm_symmetry {
    int axis;       /* of its normal */
    int64_t line;   /* column or row of its nodes, ghosts counted */
    int64_t inside; /* towards the bodies: 1 or -1 */
};

struct mpm_symmetries {
    struct mpm_symmetry *planes;
    size_t count;
};

#endif

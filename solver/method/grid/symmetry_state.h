/* What planes of symmetry keep; see symmetry.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_SYMMETRY_STATE_H
#define MPM_METHOD_SYMMETRY_STATE_H

#include <stdbool.h>
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
    bool passed; /* a crack passes one of them */
};

/* Is a node beyond a plane, an image of one inside? Its column and row. */
static inline bool mpm_symmetries_have_beyond(const struct mpm_symmetries *symmetries,
                                              const int64_t place[2])
{
    for (size_t k = 0; k < symmetries->count; k++) {
        const struct mpm_symmetry *const plane = &symmetries->planes[k];
        if ((plane->line - place[plane->axis]) * plane->inside > 0)
            return true;
    }
    return false;
}

#endif

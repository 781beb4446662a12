/* What is known of the tips of cracks. Part of the public interface: mpm.h includes it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_FRACTURE_H
#define MPM_FRACTURE_H

#include "mpm_api.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

MPM_API_BEGIN

/* The J integral at a tip of a crack, as `j_integral` of the scene defines it, and what follows
 * from it. Components along 1, the direction in which the crack would grow straight on, and along
 * 2, on the left of it; both in the undeformed body. */
struct mpm_j_integral {
    size_t crack;
    bool at_start;              /* of the chain, else at its end */
    double tip[2];              /* where it is */
    double direction[2];        /* 1 */
    double j[2];                /* J_1, the energy released per area of growth, and J_2 */
    double stress_intensity[2]; /* K_I, above 0 where it opens, and K_II, above 0 where the side on
                                   the left of 1 is sheared along 1 ahead of the tip */
    double grown;               /* length that the tip has grown by */
    double dissipated;          /* toughness times area of that growth: thickness, or per radian;
                                   part of no sum of energies: growth releases it into waves */
};

/* Why a tip that may grow has ended, in a run that goes on. */
enum mpm_tip_end_reason {
    MPM_TIP_GOES_ON,
    MPM_TIP_MEETS_CRACK,         /* its next increment would cross a crack, or come too near */
    MPM_TIP_CONTOUR_MEETS_CRACK, /* the contour of its J integral would meet or surround one */
};
struct mpm_tip_end {
    enum mpm_tip_end_reason reason;
    size_t met;    /* the crack of the scene, which may be its own */
    uint64_t step; /* when that was found, */
    double time;
    double place[2]; /* and where the tip was */
};

MPM_API_END

#endif

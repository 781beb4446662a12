/* What a body force that the caller gives keeps; see given_force.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_GIVEN_FORCE_STATE_H
#define MPM_METHOD_GIVEN_FORCE_STATE_H

#include "model/grid.h"

/* A body force that the caller gives; see given_force.h. All NULL where none is given. */
struct mpm_given_force {
    struct mpm_body_force caller;
    double *value[2];              /* per particle: b_p of the step */
    struct mpm_node_sum (*sum)[2]; /* per node: sum m_p S_ip b_p in the place of the momentum */
    double *mass;                  /* per node: comes with it, and nobody asks for it */
    double *row_work;              /* per node row */
};

#endif

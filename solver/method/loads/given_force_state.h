/* What a body force that the caller gives keeps; see given_force.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_GIVEN_FORCE_STATE_H
#define MPM_METHOD_GIVEN_FORCE_STATE_H

#include "method/transfer/projection_state.h"
#include "mpm.h"

/* A body force that the caller gives; see given_force.h. All NULL where none is given. */
struct mpm_given_force {
    struct mpm_body_force caller;
    double (*force)[MPM_NODE_VALUES]; /* per node: sum m_p S_ip b_p, as in mpm_projection.to */
    double *row_work;                 /* per node row */
};

#endif

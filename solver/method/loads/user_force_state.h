/* The arrays of a user force; see user_force.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_USER_FORCE_STATE_H
#define MPM_METHOD_USER_FORCE_STATE_H

#include "method/transfer/projection_state.h"
#include "mpm.h"

/* All NULL where there is none. */
struct mpm_user_force {
    struct mpm_body_force caller;
    double (*force)[MPM_NODE_VALUES]; /* per node: sum m_p S_ip b_p, as in mpm_projection.to */
    double *row_work;                 /* per node row */
};

#endif

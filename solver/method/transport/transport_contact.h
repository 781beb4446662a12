/* Passages between bodies in contact: pairs of fields with a law for the scalar, at nodes where the
 * pair's detection finds that they touch and that their surfaces share some area. Fields that may
 * part (friction, stick, frictionless) with detection: extent touch up to the pair's gap. The area
 * is that of contact_detection.h: at a corner of a body it depends on the normal, and one that is
 * tilted there loses a part.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_TRANSPORT_CONTACT_H
#define MPM_METHOD_TRANSPORT_CONTACT_H

#include "method/state.h"

/* Lists them for all scalars, once contact is known. Cost: a look at the pairs of nodes. */
void mpm_transport_contact_list(struct mpm_state *state);

#endif

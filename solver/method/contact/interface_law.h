/* Imperfect interfaces: tractions by the jump of displacement between two fields; body_contact.h
 * has the equations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_INTERFACE_LAW_H
#define MPM_METHOD_INTERFACE_LAW_H

#include "method/contact/exchange.h"

/* Task 4: gives the fields of interfaces their impulses. */
void mpm_interfaces_pull(struct mpm_state *state);
/* After all exchanges of task 4: work of the impulses, energy that is stored at the end of the
 * step. */
void mpm_interfaces_count(struct mpm_state *state);

#endif

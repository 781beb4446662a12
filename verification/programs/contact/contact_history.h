/* What a simulation with contact between bodies says of a pair of fields, by the names of the
 * history's columns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_CONTACT_HISTORY_H
#define VERIFICATION_PROGRAMS_CONTACT_HISTORY_H

#include "verification/programs/programs.h"

/* The place of "contact_<first>_<second>_<what>" among the scene's quantities of contact.
 * MPM_BAD_INPUT: it has none of that name. */
enum mpm_status contact_history_find(const struct mpm_scene *scene, size_t first, size_t second,
                                     const char *what, size_t *index, struct mpm_error *error);

/* The sum of `what` ("nodes") over all pairs. */
double contact_history_sum(const struct mpm_scene *scene, const struct mpm_simulation *simulation,
                           const char *what);

#endif

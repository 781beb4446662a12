/* The observers of a run: when each is due, and the observation that it gets.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_OBSERVERS_H
#define MPM_IO_OBSERVERS_H

#include "mpm.h"

struct mpm_observers;

/* Of `count` observers, which must outlive it, for a simulation in its first state or one that was
 * read from a checkpoint. MPM_BAD_INPUT: an interval below 0 or not finite, times that do not
 * ascend, no function. */
enum mpm_status mpm_observers_create(const struct mpm_observer *list, size_t count,
                                     const struct mpm_scene *scene,
                                     const struct mpm_simulation *simulation,
                                     struct mpm_observers **observers, struct mpm_error *error);
void mpm_observers_free(struct mpm_observers *observers);

/* The next time that a step has to land on, `end` at most. */
double mpm_observers_limit(const struct mpm_observers *observers, double end);

/* Is one due after the step just taken, or at the end of the run? Once for each step. */
bool mpm_observers_due(struct mpm_observers *observers, bool end);

/* Calls those that are due, or all of them; what the first that fails returns. */
enum mpm_status mpm_observers_call(struct mpm_observers *observers, bool all,
                                   struct mpm_error *error);

#endif

/* Time levels: results may have positions, velocities and stress of other times than that of their
 * row, as a leapfrog keeps them. The columns time_of_positions, time_of_velocities and
 * time_of_stress state them, and the reference is then taken there: between its instants by cubic
 * polynomials. Displacement goes with positions, det F with stress.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_TIME_LEVEL_H
#define VERIFICATION_SCORE_TIME_LEVEL_H

#include "verification/score/bundle.h"

/* The reference of a column for a row of the results, at the point that the weights are for. */
double time_level_reference(const struct bundle *bundle, const struct lattice_weights *weights,
                            enum score_column column, const struct score_table *results, size_t row,
                            size_t instant);

/* MPM_BAD_INPUT: a level further from the instant than a quarter of the time between two, or any
 * level where the reference jumps: nothing is known between its instants there. */
enum mpm_status time_level_check(const struct bundle *bundle, const struct score_table *results,
                                 size_t row, size_t instant, struct mpm_error *error);

#endif

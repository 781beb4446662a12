/* The Pareto picture of a comparison.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_COMPARISON_PLOT_H
#define VERIFICATION_SUITE_COMPARISON_PLOT_H

#include "verification/suite/comparison_view.h"
#include "verification/suite/figures.h"

/* Draws <home>/figure-comparison.svg: one quantity over the other, a point for each row, the
 * front joined and labelled. WITHOUT_DATA if the case declares no such picture, fewer than two
 * rows have both numbers, or the style is in neither folder. `folder` is the run's, `home`
 * the case's in it; `reports` may be NULL. */
struct figure_result comparison_plot(const struct comparison_view *view, const json_t *run,
                                     const char *folder, const char *home, const char *reports);

/* The data that is drawn, `x y` of all points, then of the front by rising x; "" if fewer than
 * two rows have both numbers. *axes takes gnuplot's commands for ranges and labels. g_free. */
char *comparison_plot_data(const struct comparison_view *view, size_t x, size_t y, GString *axes);

#endif

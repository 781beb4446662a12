/* The Pareto picture of a comparison.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_COMPARISON_PLOT_H
#define VERIFICATION_REPORT_COMPARISON_PLOT_H

#include "verification/pages/figure.h"
#include "verification/report/comparison_view.h"

/* Draws <home>/figure-comparison.svg: one quantity over the other, a point for each row that takes
 * part, those on the table's front filled and named, the others numbered. WITHOUT_DATA if the case
 * declares no such picture, or fewer than two rows have both numbers. `home` is the folder of the
 * case in the run's. */
struct figure_result comparison_plot(const struct comparison_view *view, const json_t *run,
                                     const char *home, const char *reports);

/* The data that is drawn, a line `x y order shape front` for each point, those on the front first;
 * "" if there are fewer than two. *axes takes gnuplot's commands for ranges, tics and labels.
 * g_free. */
char *comparison_plot_data(const struct comparison_view *view, size_t x, size_t y, GString *axes);

/* Appends an SVG of the picture's size with a place for each of its points, which a pointer finds
 * and whose title is the variant with both numbers; nothing where there is no picture. */
void comparison_plot_marks(const struct comparison_view *view, GString *html);

#endif

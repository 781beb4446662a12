/* The slope of a line through samples, by least squares, from sums.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_LINE_FIT_H
#define VERIFICATION_MEASURES_LINE_FIT_H

/* Start from zeros. */
struct line_fit {
    double count, t, v, tt, tv; /* sums of 1, t, v, t^2, t v */
};

void line_fit_add(struct line_fit *line, double t, double v);

/* (n sum t v - sum t sum v)/(n sum t^2 - (sum t)^2), in units of v over t; NaN unless two samples
 * have different t. Sums lose digits where |t| is large against the spread of t. */
double line_fit_slope(const struct line_fit *line);

#endif

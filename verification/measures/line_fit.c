/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/line_fit.h"

void line_fit_add(struct line_fit *line, double t, double v)
{
    line->count += 1.0;
    line->t += t;
    line->v += v;
    line->tt += t * t;
    line->tv += t * v;
}

double line_fit_slope(const struct line_fit *line)
{
    return (line->count * line->tv - line->t * line->v) /
           (line->count * line->tt - line->t * line->t);
}

/* On which side of a line is a point? The sign is exact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_ORIENTATION_H
#define MPM_BASE_ORIENTATION_H

#include <float.h>
#include <math.h>

/* The sign of the area of a triangle from its corners as they are, without round-off. For what
 * mpm_orientation cannot decide. */
double mpm_orientation_exact(const double a[2], const double b[2], const double c[2]);

/* Positive if a b c is counter clockwise, negative if clockwise, 0 if they are on one line: twice
 * the area of the triangle, rounded, but for the sign, which is that of the area of these very
 * numbers (none so large or small that products overflow or underflow). Differences and products
 * are rounded once each: a sum of more than 3 eps/2 of its parts, and a little, has its sign right
 * (J. R. Shewchuk, Discrete Comput. Geom. 18, 1997). Cost: some ns; of points on a line or very
 * near to one, a tenth of a microsecond. */
static inline double mpm_orientation(const double a[2], const double b[2], const double c[2])
{
    const double one = (a[0] - c[0]) * (b[1] - c[1]), other = (a[1] - c[1]) * (b[0] - c[0]);
    const double area = one - other;
    if (fabs(area) > 2.0 * DBL_EPSILON * (fabs(one) + fabs(other)) || (one == 0.0 && other == 0.0))
        return area;
    return mpm_orientation_exact(a, b, c);
}

#endif

/* Grid-convergence index: an estimate, without the exact solution, of how far a computed number is
 * from its limit. P. J. Roache, Perspective: a method for uniform reporting of grid refinement
 * studies, J. Fluids Eng. 116 (1994) 405-413. With an exact solution at hand the suite can see
 * whether the index would have covered the true error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_GRID_CONVERGENCE_H
#define VERIFICATION_MEASURES_GRID_CONVERGENCE_H

#include <stddef.h>

/* Roache's safety factor for three or more grids with an observed order; with two grids and an
 * order from theory he takes 3. */
#define GRID_CONVERGENCE_SAFETY 1.25

struct grid_convergence {
    double order;        /* ln |(coarse - medium) / (medium - fine)| / ln ratio */
    double extrapolated; /* Richardson's limit, fine + (fine - medium) / (ratio^order - 1) */
    double index;        /* safety |fine - medium| / (ratio^order - 1) / |fine|, without unit */
};

/* Of a number computed on three grids whose h falls by `ratio` > 1 each time. All NaN where the
 * differences do not fall with one sign: such a series has no order, and the index no meaning. */
struct grid_convergence grid_convergence(double coarse, double medium, double fine, double ratio,
                                         double safety);

/* Numerical uncertainty of a number computed on two or more grids whose h falls by `ratio` > 1 each
 * time, relative to the last one, without unit:
 *
 *   safety |last - last but one| / (ratio^order - 1) / |last|.
 *
 * With three grids or more by the rule of Oberkampf and Roy (Verification and validation in
 * scientific computing, 2010, 8.7): the order observed on the last three within 10 % of the formal
 * one: that, and the safety 1.25; else the observed one, not below 0.5 and not above the formal
 * one, and the safety 3. Differences that do not fall with one sign count as 0.5. With two grids:
 * first order and the safety 3. NaN if a value is, or with fewer grids. */
double grid_uncertainty(size_t count, const double *values, double ratio, double formal_order);

#endif

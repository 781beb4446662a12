/* Grid-convergence index: an estimate, without the exact solution, of how far a computed number is
 * from its limit. P. J. Roache, Perspective: a method for uniform reporting of grid refinement
 * studies, J. Fluids Eng. 116 (1994) 405-413. With an exact solution at hand the suite can see
 * whether the index would have covered the true error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_GRID_CONVERGENCE_H
#define VERIFICATION_MEASURES_GRID_CONVERGENCE_H

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

#endif

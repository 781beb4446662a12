/* Logistic regression: the plane phi = c . t, t = (1, x, y), with the least
 *     f(c) = sum_p w_p log(1 + exp(-s_p phi_p)) + lambda/2 (c_1^2 + c_2^2),
 * s_p = -1 for the points of one set, 1 for those of the other. Two sets that a line separates have
 * f near 0 for every steep phi; of these the penalty takes the plane with the widest gap.
 *
 * f is strictly convex where both sets have points and no line holds all points. The way to its
 * least is Newton's with backtracking: whole steps from far away go round in circles, or further
 * away each time, where sets overlap by little. A step d is halved until
 *     f(c + d) <= f(c) + 1e-4 d . f'(c),
 * but for round-off of f; so f becomes less from step to step, and near its least whole steps
 * double the right digits (Boyd, Vandenberghe, Convex Optimization, 9.5). It ends when no
 * component of a step is above 1e-10.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_LOGISTIC_PLANE_H
#define MPM_METHOD_LOGISTIC_PLANE_H

#include <stdbool.h>

struct mpm_logistic_plane {
    bool used, moves; /* moves: not at the least of f yet */
    double c[3];
    double value, slope[3], curvature[6]; /* f, f', f'' (00, 01, 02, 11, 12, 22) at c: sums */
    /* where the step to c began, f there, and what f' there says of the step */
    double from[3], least, falls, step[3];
};

/* Solves m c = r, m being the symmetric matrix of {00, 01, 02, 11, 12, 22}; false: its determinant
 * is below `singular` times the product of its diagonal. */
bool mpm_solve_plane(const double m[6], const double r[3], double singular, double c[3]);

/* From a first guess; the sums are empty. */
struct mpm_logistic_plane mpm_logistic_begin(const double c[3]);
/* Adds a point's part to the sums at c. */
void mpm_logistic_add(struct mpm_logistic_plane *plane, const double t[3], double sign,
                      double weight);
/* The points have been added: another c, and empty sums. `moves` says whether points must be
 * added again. */
void mpm_logistic_step(struct mpm_logistic_plane *plane);

#endif

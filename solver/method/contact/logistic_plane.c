/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/logistic_plane.h"

#include <math.h>
#include <string.h>

static const double LAMBDA = 1e-7;
/* The change of c at which steps end. */
static const double CONVERGED = 1e-10;
/* The longest first guess, and the longest step of less: of steeper planes the sums are round-off.
 * Three points make a first guess of thousands. */
static const double LONGEST = 8.0;
/* Of what the slope promises, the part by which f must become less. */
static const double ENOUGH = 1e-4;
/* Of f: below it is round-off. */
static const double LEVEL = 1e-12;

bool mpm_solve_plane(const double m[6], const double r[3], double singular, double c[3])
{
    const double a = m[0], b = m[1], d = m[2], e = m[3], f = m[4], g = m[5];
    const double minor[3] = {e * g - f * f, d * f - b * g, b * f - d * e};
    const double determinant = a * minor[0] + b * minor[1] + d * minor[2];
    if (!(determinant > singular * a * e * g))
        return false;
    c[0] = (minor[0] * r[0] + minor[1] * r[1] + minor[2] * r[2]) / determinant;
    c[1] = (minor[1] * r[0] + (a * g - d * d) * r[1] + (b * d - a * f) * r[2]) / determinant;
    c[2] = (minor[2] * r[0] + (b * d - a * f) * r[1] + (a * e - b * b) * r[2]) / determinant;
    return true;
}

static double largest_of(const double c[3])
{
    return fmax(fabs(c[0]), fmax(fabs(c[1]), fabs(c[2])));
}

static void shorten(double c[3], double longest)
{
    const double largest = largest_of(c);
    for (int k = 0; k < 3 && largest > longest; k++)
        c[k] *= longest / largest;
}

struct mpm_logistic_plane mpm_logistic_begin(const double c[3])
{
    struct mpm_logistic_plane plane = {
        .used = true, .moves = true, .c = {c[0], c[1], c[2]}, .least = HUGE_VAL};
    shorten(plane.c, LONGEST);
    return plane;
}

void mpm_logistic_add(struct mpm_logistic_plane *plane, const double t[3], double sign,
                      double weight)
{
    const double phi = plane->c[0] * t[0] + plane->c[1] * t[1] + plane->c[2] * t[2];
    const double missed = 1.0 / (1.0 + exp(sign * phi));
    const double bend = weight * missed * (1.0 - missed);
    plane->value += weight * (fmax(-sign * phi, 0.0) + log1p(exp(-fabs(phi))));
    for (int k = 0; k < 3; k++)
        plane->slope[k] -= weight * sign * missed * t[k];
    plane->curvature[0] += bend;
    plane->curvature[1] += bend * t[1];
    plane->curvature[2] += bend * t[2];
    plane->curvature[3] += bend * t[1] * t[1];
    plane->curvature[4] += bend * t[1] * t[2];
    plane->curvature[5] += bend * t[2] * t[2];
}

static void add_penalty(struct mpm_logistic_plane *plane)
{
    for (int k = 1; k < 3; k++) {
        plane->value += 0.5 * LAMBDA * plane->c[k] * plane->c[k];
        plane->slope[k] += LAMBDA * plane->c[k];
    }
    plane->curvature[3] += LAMBDA;
    plane->curvature[5] += LAMBDA;
}

static double along_step(const struct mpm_logistic_plane *plane)
{
    return plane->slope[0] * plane->step[0] + plane->slope[1] * plane->step[1] +
           plane->slope[2] * plane->step[2];
}

/* Newton's; that of each component alone where the matrix is singular to round-off. */
static void find_step(struct mpm_logistic_plane *plane)
{
    static const int diagonal[3] = {0, 3, 5};
    const double down[3] = {-plane->slope[0], -plane->slope[1], -plane->slope[2]};
    if (!mpm_solve_plane(plane->curvature, down, 0.0, plane->step) || !(along_step(plane) < 0.0))
        for (int k = 0; k < 3; k++) {
            const double bend = plane->curvature[diagonal[k]];
            plane->step[k] = bend > 0.0 ? down[k] / bend : 0.0;
        }
    shorten(plane->step, fmax(LONGEST, largest_of(plane->c)));
    plane->falls = along_step(plane);
}

void mpm_logistic_step(struct mpm_logistic_plane *plane)
{
    add_penalty(plane);
    if (plane->value <= plane->least + ENOUGH * plane->falls + LEVEL * plane->least) {
        plane->least = plane->value;
        memcpy(plane->from, plane->c, sizeof plane->from);
        find_step(plane);
    } else {
        plane->falls *= 0.5;
        for (int k = 0; k < 3; k++)
            plane->step[k] *= 0.5;
    }
    for (int k = 0; k < 3; k++) {
        plane->c[k] = plane->from[k] + plane->step[k];
        plane->slope[k] = 0.0;
    }
    plane->value = 0.0;
    memset(plane->curvature, 0, sizeof plane->curvature);
    plane->moves = largest_of(plane->step) > CONVERGED;
}

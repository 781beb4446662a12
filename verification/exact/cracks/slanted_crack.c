/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/cracks/slanted_crack.h"

#include <complex.h>
#include <gsl/gsl_linalg.h>
#include <math.h>

/* TERMS of each of P and Q; POINTS of each of two edges, the other two are these turned by 180
 * degrees. Unknowns are the real and imaginary parts of the coefficients, but for the imaginary
 * part of Q's first one, which is a rotation. */
enum { TERMS = 24, POINTS = 160, ROWS = 4 * POINTS, UNKNOWNS = 4 * TERMS - 1 };

/* Phi and Omega, and the derivative of Phi, of one coefficient equal to 1. */
struct potentials {
    double complex phi, omega, slope;
};

static double complex number(double real, double imaginary)
{
    return real + imaginary * (double complex)I;
}

/* sqrt(z^2 - a^2) with its cut along the crack, near z far away. */
static double complex root(double complex z, double a)
{
    return csqrt(z - a) * csqrt(z + a);
}

/* The k-th power of P, z^(2k+1), if `odd`, or of Q, z^(2k); in units of `scale`. */
static struct potentials term_at(double complex z, double a, double scale, int k, bool odd)
{
    const double complex unit = z / scale;
    const int power = odd ? 2 * k + 1 : 2 * k;
    const double complex value = cpow(unit, power);
    const double complex slope = power == 0 ? 0.0 : power * cpow(unit, power - 1) / scale;
    if (!odd)
        return (struct potentials){value, -value, slope};
    const double complex x = root(z, a);
    return (struct potentials){value / x, 0.0, slope / x - value * z / (x * x * x)};
}

/* Traction t_x + i t_y on a plane with the normal n_x + i n_y, for a coefficient that multiplies
 * the term. Omega is that of the conjugate place. */
static double complex traction_of(double complex z, double complex normal,
                                  const struct potentials *at, double complex omega,
                                  double complex coefficient)
{
    const double complex phi = coefficient * at->phi;
    const double complex shear = /* s_yy - i s_xy */
        phi + coefficient * omega + (z - conj(z)) * conj(coefficient * at->slope);
    const double yy = creal(shear), xy = -cimag(shear), xx = 4.0 * creal(phi) - yy;
    const double nx = creal(normal), ny = cimag(normal);
    return number(xx * nx + xy * ny, xy * nx + yy * ny);
}

/* A point of collocation on the right (edge 0) or upper edge, and the traction there; all turned
 * into the axes of the crack. Points are denser towards the corners, as Chebyshev's. */
static void point_on(const struct slanted_crack *crack, int edge, int k, double complex *z,
                     double complex *normal, double complex *traction)
{
    const double complex turn = number(cos(crack->angle), -sin(crack->angle));
    const double complex up = number(0.0, 1.0) * turn;
    const double along = cos(acos(-1.0) * (k + 0.5) / POINTS);
    const double x = edge == 0 ? crack->half_width : crack->half_width * along;
    const double y = edge == 0 ? crack->half_height * along : crack->half_height;
    *z = x * turn + y * up;
    *normal = edge == 0 ? turn : up;
    *traction = edge == 0 ? 0.0 : up; /* over sigma */
}

static void fill_row(const struct slanted_crack *crack, double scale, int edge, int k,
                     gsl_matrix *matrix, gsl_vector *right)
{
    const size_t row = 2 * (size_t)(edge * POINTS + k);
    double complex z, normal, wanted;
    point_on(crack, edge, k, &z, &normal, &wanted);
    gsl_vector_set(right, row, creal(wanted));
    gsl_vector_set(right, row + 1, cimag(wanted));
    for (int column = 0; column < UNKNOWNS; column++) {
        const bool odd = column < 2 * TERMS;
        const int place = odd ? column : column - 2 * TERMS + (column > 2 * TERMS ? 1 : 0);
        const double complex coefficient = number(place % 2 == 0, place % 2);
        const struct potentials at = term_at(z, crack->half_length, scale, place / 2, odd);
        const struct potentials mirrored =
            term_at(conj(z), crack->half_length, scale, place / 2, odd);
        const double complex omega = odd ? mirrored.phi : mirrored.omega;
        const double complex t = traction_of(z, normal, &at, omega, coefficient);
        gsl_matrix_set(matrix, row, (size_t)column, creal(t));
        gsl_matrix_set(matrix, row + 1, (size_t)column, cimag(t));
    }
}

/* 2 P(a) sqrt(pi/a) with the coefficients found. */
static double complex intensity_of(const struct slanted_crack *crack, double scale,
                                   const gsl_vector *found)
{
    double complex sum = 0.0;
    for (size_t k = 0; k < TERMS; k++) {
        const double complex coefficient =
            number(gsl_vector_get(found, 2 * k), gsl_vector_get(found, 2 * k + 1));
        sum += coefficient * pow(crack->half_length / scale, (double)(2 * k + 1));
    }
    return 2.0 * sum * sqrt(acos(-1.0) / crack->half_length) * crack->stress;
}

struct system {
    gsl_matrix *matrix;
    gsl_vector *right, *pivots, *found, *residual;
};

static void collocate(const struct slanted_crack *crack, const struct system *system,
                      struct slanted_crack_intensity *intensity)
{
    const double scale = hypot(crack->half_width, crack->half_height);
    for (int edge = 0; edge < 2; edge++)
        for (int k = 0; k < POINTS; k++)
            fill_row(crack, scale, edge, k, system->matrix, system->right);
    gsl_linalg_QR_decomp(system->matrix, system->pivots);
    gsl_linalg_QR_lssolve(system->matrix, system->pivots, system->right, system->found,
                          system->residual);
    const double complex k = intensity_of(crack, scale, system->found);
    intensity->mode_1 = creal(k);
    intensity->mode_2 = -cimag(k);
    intensity->residual = fmax(gsl_vector_max(system->residual), -gsl_vector_min(system->residual));
}

enum mpm_status slanted_crack_solve(const struct slanted_crack *crack,
                                    struct slanted_crack_intensity *intensity,
                                    struct mpm_error *error)
{
    const double x = crack->half_length * fabs(cos(crack->angle));
    const double y = crack->half_length * fabs(sin(crack->angle));
    if (!(crack->half_length > 0.0 && x < crack->half_width && y < crack->half_height))
        return failure_set(
            error, MPM_BAD_INPUT,
            "a crack of half length %g at %g rad is not inside a plate of half sizes "
            "%g and %g",
            crack->half_length, crack->angle, crack->half_width, crack->half_height);
    const struct system system = {gsl_matrix_calloc(ROWS, UNKNOWNS), gsl_vector_calloc(ROWS),
                                  gsl_vector_calloc(UNKNOWNS), gsl_vector_calloc(UNKNOWNS),
                                  gsl_vector_calloc(ROWS)};
    const bool memory = system.matrix != NULL && system.right != NULL && system.pivots != NULL &&
                        system.found != NULL && system.residual != NULL;
    if (memory)
        collocate(crack, &system, intensity);
    gsl_matrix_free(system.matrix);
    gsl_vector_free(system.right);
    gsl_vector_free(system.pivots);
    gsl_vector_free(system.found);
    gsl_vector_free(system.residual);
    return memory ? MPM_OK
                  : failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for collocation");
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/shapes/corner_quadrature.h"
#include "verification/exact/manufactured/hat.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdlib.h>

enum { WORKSPACE_INTERVALS = 64 };

/* GSL's tolerance, times the size of the integrand; see shape_quadrature.c. */
static const double TOLERANCE = 5e-14;

/* Signs of d1 and d2 at the corners. */
static const double CORNER_SIGN[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

struct corner_quadrature {
    gsl_integration_workspace *outer, *inner;
};

struct corner_quadrature *corner_quadrature_create(void)
{
    struct corner_quadrature *quadrature = calloc(1, sizeof *quadrature);
    if (quadrature == NULL) {
        return NULL;
    }
    quadrature->outer = gsl_integration_workspace_alloc(WORKSPACE_INTERVALS);
    quadrature->inner = gsl_integration_workspace_alloc(WORKSPACE_INTERVALS);
    if (quadrature->outer == NULL || quadrature->inner == NULL) {
        corner_quadrature_free(quadrature);
        return NULL;
    }
    return quadrature;
}

void corner_quadrature_free(struct corner_quadrature *quadrature)
{
    if (quadrature == NULL) {
        return;
    }
    gsl_integration_workspace_free(quadrature->outer);
    gsl_integration_workspace_free(quadrature->inner);
    free(quadrature);
}

struct corner_integrand {
    const struct parallelogram *shape;
    enum shape_value kind;
    double corner[4];   /* N_i at the corners */
    double radius;      /* of the centre, in cells */
    double rho, zeta;   /* zeta is fixed during the inner quadrature */
    double tolerance;   /* absolute */
    double inner_error; /* largest estimate of the inner quadrature */
    bool failed;
    gsl_integration_workspace *inner;
};

/* The corners' interpolation of N_i, or its derivative along x or y by the inverse of
 * J = (d1; d2), N&G (32), (34), (36). */
static double interpolation(const struct corner_integrand *integrand, double rho, double zeta)
{
    const double(*d)[2] = integrand->shape->domain_vector;
    double value = 0, along_rho = 0, along_zeta = 0;
    for (size_t a = 0; a < 4; a++) {
        const double factor_rho = (1 + CORNER_SIGN[a][0] * rho) / 2;
        const double factor_zeta = (1 + CORNER_SIGN[a][1] * zeta) / 2;
        value += factor_rho * factor_zeta * integrand->corner[a];
        along_rho += CORNER_SIGN[a][0] / 2 * factor_zeta * integrand->corner[a];
        along_zeta += CORNER_SIGN[a][1] / 2 * factor_rho * integrand->corner[a];
    }
    const double determinant = d[0][0] * d[1][1] - d[1][0] * d[0][1];
    if (integrand->kind == SHAPE_GX) {
        return (d[1][1] * along_rho - d[0][1] * along_zeta) / determinant;
    }
    if (integrand->kind == SHAPE_GY) {
        return (d[0][0] * along_zeta - d[1][0] * along_rho) / determinant;
    }
    return value;
}

/* Integrand over (rho, zeta) in [-1, 1]^2, divided by 4 r_p (4 where the weight is one). */
static double corner_integrand_value(double rho, void *context)
{
    struct corner_integrand *integrand = context;
    const struct parallelogram *shape = integrand->shape;
    double weight = 0.25;
    if (shape->radial && integrand->kind != SHAPE_T) {
        const double offset =
            rho * shape->domain_vector[0][0] + integrand->zeta * shape->domain_vector[1][0];
        weight *= (integrand->radius + offset) / integrand->radius;
    }
    return weight * interpolation(integrand, rho, integrand->zeta);
}

static double corner_inner_integral(double zeta, void *context)
{
    struct corner_integrand *integrand = context;
    integrand->zeta = zeta;
    gsl_function function = {corner_integrand_value, integrand};
    double result = 0, error = 0;
    const int status =
        gsl_integration_qag(&function, -1, 1, integrand->tolerance, 0, WORKSPACE_INTERVALS,
                            GSL_INTEG_GAUSS15, integrand->inner, &result, &error);
    integrand->failed = integrand->failed || status != GSL_SUCCESS;
    integrand->inner_error = fmax(integrand->inner_error, error);
    return result;
}

/* The size of the integrand: the tolerance of a cancelling integral cannot be relative to
 * its value. Bilinear functions have their extremes in the corners. */
static double corner_integrand_size(struct corner_integrand *integrand, double magnification)
{
    double size = 1;
    for (size_t a = 0; a < 4; a++) {
        size = fmax(size, fabs(interpolation(integrand, CORNER_SIGN[a][0], CORNER_SIGN[a][1])));
    }
    return size * magnification;
}

static bool integrate(const struct corner_quadrature *quadrature, double magnification,
                      struct corner_integrand *integrand, struct shape_reference *out)
{
    for (size_t i = 0; i < SHAPE_VALUES; i++) {
        if (i == SHAPE_T && !integrand->shape->radial) {
            out->value[i] = out->value[SHAPE_S]; /* planar functions: T <r> = S */
            out->estimate[i] = out->estimate[SHAPE_S];
            continue;
        }
        integrand->kind = (enum shape_value)i;
        integrand->inner_error = 0;
        integrand->tolerance = TOLERANCE * corner_integrand_size(integrand, magnification);
        gsl_function function = {corner_inner_integral, integrand};
        const int status = gsl_integration_qag(
            &function, -1, 1, integrand->tolerance, 0, WORKSPACE_INTERVALS, GSL_INTEG_GAUSS15,
            quadrature->outer, &out->value[i], &out->estimate[i]);
        if (status != GSL_SUCCESS || integrand->failed) {
            return false;
        }
        out->estimate[i] += 2 * integrand->inner_error; /* over the outer interval of 2 */
    }
    return true;
}

static void corner_position(const struct parallelogram *shape, size_t a, long double corner[2])
{
    for (size_t k = 0; k < 2; k++) {
        corner[k] = shape->centre[k] +
                    (long double)CORNER_SIGN[a][0] * (long double)shape->domain_vector[0][k] +
                    (long double)CORNER_SIGN[a][1] * (long double)shape->domain_vector[1][k];
    }
}

bool corner_quadrature_node(struct corner_quadrature *quadrature, const struct parallelogram *shape,
                            double magnification, int64_t column, int64_t row,
                            struct shape_reference *reference)
{
    struct corner_integrand integrand = {.shape = shape, .inner = quadrature->inner};
    integrand.radius = (double)(shape->centre[0] - shape->zero);
    *reference = (struct shape_reference){.depth = -1};
    for (size_t a = 0; a < 4; a++) {
        long double corner[2];
        corner_position(shape, a, corner);
        const double x = (double)(corner[0] - (long double)column);
        const double y = (double)(corner[1] - (long double)row);
        integrand.corner[a] = hat(x) * hat(y);
        reference->depth = fmax(reference->depth, fmin(1 - fabs(x), 1 - fabs(y)));
    }
    return reference->depth <= 0 || integrate(quadrature, magnification, &integrand, reference);
}

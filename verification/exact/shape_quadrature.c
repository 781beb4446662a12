/* Shape functions by adaptive quadrature of their definitions; see shape_quadrature.h.
 *
 * Lengths are in cells here. Positions are split into node plus offset in long double, so
 * that the reference has no cancellation of its own far from the origin.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/shape_quadrature.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdlib.h>

/* A uGIMP domain of up to two cells' width, its neighbours and the ring around them. */
enum { AXIS_NODES_MAX = 8, WORKSPACE_INTERVALS = 64 };

/* What GSL is asked for, times the size of the integrand. Its estimate cannot fall below
 * 50 eps = 1.1e-14 of the integral of the absolute value; a polynomial reaches that at once. */
static const double TOLERANCE = 5e-14;

/* One axis of a rectangular domain: [lower, upper] and r = 0, in cells from node 0. */
struct axis_domain {
    long double lower, upper, zero;
    bool radial;
};

/* Averages of N (weighted, plain) and of its slope (weighted) over one axis. */
enum axis_value { AXIS_MEAN, AXIS_SLOPE, AXIS_PLAIN, AXIS_VALUES };

struct axis_node {
    double value[AXIS_VALUES], estimate[AXIS_VALUES];
    double depth;
};

/* A CPDI domain: centre and half edges in cells, signs of the corners in table order. */
struct parallelogram {
    long double centre[2], zero;
    double half_edge[2][2]; /* d1, d2 */
    bool radial;
};

static const double CORNER_SIGN[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

struct shape_quadrature {
    struct mpm_shape_query query;
    struct shape_domain domain;
    struct axis_node axis[2][AXIS_NODES_MAX]; /* classic and uGIMP */
    struct parallelogram parallelogram;       /* CPDI */
    gsl_integration_workspace *outer, *inner;
};

struct shape_quadrature *shape_quadrature_create(void)
{
    gsl_set_error_handler_off();
    struct shape_quadrature *quadrature = calloc(1, sizeof *quadrature);
    if (quadrature == NULL) {
        return NULL;
    }
    quadrature->outer = gsl_integration_workspace_alloc(WORKSPACE_INTERVALS);
    quadrature->inner = gsl_integration_workspace_alloc(WORKSPACE_INTERVALS);
    if (quadrature->outer == NULL || quadrature->inner == NULL) {
        shape_quadrature_free(quadrature);
        return NULL;
    }
    return quadrature;
}

void shape_quadrature_free(struct shape_quadrature *quadrature)
{
    if (quadrature == NULL) {
        return;
    }
    gsl_integration_workspace_free(quadrature->outer);
    gsl_integration_workspace_free(quadrature->inner);
    free(quadrature);
}

/* The hat of a node at distance `offset` cells, and its slope; N&G (18). */
static double hat(double offset)
{
    return fmax(0, 1 - fabs(offset));
}

static double hat_slope(double offset)
{
    if (fabs(offset) >= 1) {
        return 0;
    }
    return offset < 0 ? 1 : -1;
}

/* ------------------------------------------------- rectangles, axis by axis */

struct axis_integrand {
    double node_radius; /* of the node, in cells */
    double norm;        /* width of the domain times its mean radius, in cells */
    bool weighted;      /* by r */
    bool slope;
};

static double axis_integrand_value(double offset, void *context)
{
    const struct axis_integrand *integrand = context;
    const double weight = integrand->weighted ? integrand->node_radius + offset : 1;
    const double value = integrand->slope ? hat_slope(offset) : hat(offset);
    return weight * value / integrand->norm;
}

/* Break points within (from, to): grid lines of the node's support and r = 0. */
static size_t axis_break_points(double from, double to, double zero, double points[6])
{
    double inner[4] = {-1, 0, 1, zero};
    for (size_t i = 3; i > 0 && inner[i] < inner[i - 1]; i--) { /* zero into its place */
        const double swap = inner[i];
        inner[i] = inner[i - 1];
        inner[i - 1] = swap;
    }
    size_t count = 0;
    points[count++] = from;
    for (size_t i = 0; i < 4; i++) {
        if (inner[i] > points[count - 1] && inner[i] < to) {
            points[count++] = inner[i];
        }
    }
    points[count++] = to;
    return count;
}

/* Averages of one hat over one axis of the domain. */
static bool axis_node_integrate(struct shape_quadrature *quadrature, const struct axis_domain *axis,
                                int64_t index, struct axis_node *node)
{
    const double from = (double)(axis->lower - (long double)index);
    const double to = (double)(axis->upper - (long double)index);
    const double zero = (double)(axis->zero - (long double)index);
    *node = (struct axis_node){.depth = fmin(to, 1) - fmax(from, -1)};
    if (node->depth <= 0) {
        return true;
    }
    double points[6];
    const size_t count = axis_break_points(from, to, axis->radial ? zero : from, points);
    const double mean_radius = axis->radial ? (from + to) / 2 - zero : 1;
    for (size_t i = 0; i < AXIS_VALUES; i++) {
        struct axis_integrand integrand = {.node_radius = -zero, .norm = to - from};
        integrand.slope = i == AXIS_SLOPE;
        integrand.weighted = axis->radial && i != AXIS_PLAIN;
        integrand.norm *= integrand.weighted ? mean_radius : 1;
        gsl_function function = {axis_integrand_value, &integrand};
        const int status = gsl_integration_qagp(
            &function, points, count, TOLERANCE * quadrature->domain.magnification, 0,
            WORKSPACE_INTERVALS, quadrature->outer, &node->value[i], &node->estimate[i]);
        if (status != GSL_SUCCESS) {
            return false;
        }
    }
    return true;
}

/* A coordinate in cells from node 0. */
static long double cells_from_origin(const struct mpm_shape_query *query, size_t k, double x)
{
    return ((long double)x - (long double)query->origin[k]) / (long double)query->cell[k];
}

/* The rectangle's extent along one axis; cut at r = 0 if truncated. */
static struct axis_domain axis_domain_of(const struct mpm_shape_query *query, size_t k)
{
    const long double centre = cells_from_origin(query, k, query->position[k]);
    const long double half = query->shape == MPM_CLASSIC
                                 ? 0
                                 : (long double)query->half_size[k] / (long double)query->cell[k];
    struct axis_domain axis = {.lower = centre - half, .upper = centre + half};
    axis.zero = cells_from_origin(query, k, 0);
    axis.radial = query->geometry == MPM_AXISYMMETRIC && k == 0;
    if (axis.radial && query->axis == MPM_TRUNCATED && axis.lower < axis.zero) {
        axis.lower = axis.zero;
    }
    return axis;
}

static void classic_axis_node(const struct axis_domain *axis, int64_t index, struct axis_node *node)
{
    const double offset = (double)(axis->lower - (long double)index);
    *node = (struct axis_node){.depth = 1 - fabs(offset)};
    node->value[AXIS_MEAN] = node->value[AXIS_PLAIN] = hat(offset);
    node->value[AXIS_SLOPE] = hat_slope(offset);
}

static void window_set(struct shape_domain *domain, size_t k, long double lower, long double upper)
{
    domain->first[k] = (int64_t)floorl(lower) - 1;
    domain->last[k] = (int64_t)ceill(upper) + 1;
}

/* Mean radius and magnification of a domain whose r spans centre -/+ half, in cells. */
static void domain_set_radius(struct shape_domain *domain, double cell, double centre, double half)
{
    domain->mean_radius = centre * cell;
    domain->crosses_axis = half > centre;
    domain->magnification =
        domain->crosses_axis ? (centre * centre + half * half) / (2 * half * centre) : 1;
}

static bool rectangle_prepare(struct shape_quadrature *quadrature)
{
    const struct mpm_shape_query *query = &quadrature->query;
    struct axis_domain axes[2] = {axis_domain_of(query, 0), axis_domain_of(query, 1)};
    if (axes[0].radial) {
        domain_set_radius(&quadrature->domain, query->cell[0],
                          (double)((axes[0].lower + axes[0].upper) / 2 - axes[0].zero),
                          (double)(axes[0].upper - axes[0].lower) / 2);
    }
    for (size_t k = 0; k < 2; k++) {
        window_set(&quadrature->domain, k, axes[k].lower, axes[k].upper);
        const int64_t first = quadrature->domain.first[k];
        const int64_t count = quadrature->domain.last[k] - first + 1;
        if (count > AXIS_NODES_MAX) {
            return false;
        }
        for (int64_t i = 0; i < count; i++) {
            struct axis_node *node = &quadrature->axis[k][i];
            if (query->shape == MPM_CLASSIC) {
                classic_axis_node(&axes[k], first + i, node);
            } else if (!axis_node_integrate(quadrature, &axes[k], first + i, node)) {
                return false;
            }
        }
    }
    return true;
}

/* Which average of each axis makes S, G_x, G_y and T <r>. */
static const enum axis_value FACTOR[SHAPE_VALUES][2] = {
    [SHAPE_S] = {AXIS_MEAN, AXIS_MEAN},
    [SHAPE_GX] = {AXIS_SLOPE, AXIS_MEAN},
    [SHAPE_GY] = {AXIS_MEAN, AXIS_SLOPE},
    [SHAPE_T] = {AXIS_PLAIN, AXIS_PLAIN},
};

static void rectangle_node(const struct shape_quadrature *quadrature, size_t column, size_t row,
                           struct shape_reference *reference)
{
    const struct axis_node *x = &quadrature->axis[0][column];
    const struct axis_node *y = &quadrature->axis[1][row];
    *reference = (struct shape_reference){.depth = fmin(x->depth, y->depth)};
    if (reference->depth <= 0) {
        return;
    }
    for (size_t i = 0; i < SHAPE_VALUES; i++) {
        const size_t a = FACTOR[i][0], b = FACTOR[i][1];
        reference->value[i] = x->value[a] * y->value[b];
        reference->estimate[i] = fabs(x->value[a]) * y->estimate[b] +
                                 x->estimate[a] * fabs(y->value[b]) +
                                 x->estimate[a] * y->estimate[b];
    }
}

/* ----------------------------------------------------------- parallelograms */

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
    const double(*d)[2] = integrand->shape->half_edge;
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
            rho * shape->half_edge[0][0] + integrand->zeta * shape->half_edge[1][0];
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

static bool parallelogram_node(struct shape_quadrature *quadrature, struct shape_reference *out,
                               struct corner_integrand *integrand)
{
    for (size_t i = 0; i < SHAPE_VALUES; i++) {
        if (i == SHAPE_T && !quadrature->parallelogram.radial) {
            continue;
        }
        integrand->kind = (enum shape_value)i;
        integrand->inner_error = 0;
        integrand->tolerance =
            TOLERANCE * corner_integrand_size(integrand, quadrature->domain.magnification);
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
                    (long double)CORNER_SIGN[a][0] * (long double)shape->half_edge[0][k] +
                    (long double)CORNER_SIGN[a][1] * (long double)shape->half_edge[1][k];
    }
}

static bool parallelogram_node_at(struct shape_quadrature *quadrature, int64_t column, int64_t row,
                                  struct shape_reference *reference)
{
    const struct parallelogram *shape = &quadrature->parallelogram;
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
    return reference->depth <= 0 || parallelogram_node(quadrature, reference, &integrand);
}

/* Half edges in cells, N&G (31) with each component over its own axis' cell. */
static void half_edges_set(const struct mpm_shape_query *query, double half_edge[2][2])
{
    const double *f = query->deformation_gradient; /* xx xy yx yy */
    for (size_t k = 0; k < 2; k++) {
        half_edge[0][k] = f[2 * k] * query->half_size[0] / query->cell[k];
        half_edge[1][k] = f[2 * k + 1] * query->half_size[1] / query->cell[k];
    }
}

static bool parallelogram_prepare(struct shape_quadrature *quadrature)
{
    const struct mpm_shape_query *query = &quadrature->query;
    struct parallelogram *shape = &quadrature->parallelogram;
    half_edges_set(query, shape->half_edge);
    shape->radial = query->geometry == MPM_AXISYMMETRIC;
    shape->zero = cells_from_origin(query, 0, 0);
    for (size_t k = 0; k < 2; k++) {
        shape->centre[k] = cells_from_origin(query, k, query->position[k]);
    }
    const double radius = (double)(shape->centre[0] - shape->zero);
    double reach = fabs(shape->half_edge[0][0]) + fabs(shape->half_edge[1][0]);
    if (shape->radial && query->axis == MPM_TRUNCATED && reach > radius) {
        for (size_t i = 0; i < 4; i++) {
            shape->half_edge[i / 2][i % 2] *= radius / reach;
        }
        reach = radius;
    }
    if (shape->radial) {
        domain_set_radius(&quadrature->domain, query->cell[0], radius, reach);
    }
    for (size_t k = 0; k < 2; k++) {
        const double half = fabs(shape->half_edge[0][k]) + fabs(shape->half_edge[1][k]);
        window_set(&quadrature->domain, k, shape->centre[k] - (long double)half,
                   shape->centre[k] + (long double)half);
    }
    return true;
}

/* ------------------------------------------------------------------- public */

static bool query_is_valid(const struct mpm_shape_query *query)
{
    bool valid = true;
    for (size_t k = 0; k < 2; k++) {
        valid = valid && isfinite(query->origin[k]) && isfinite(query->position[k]) &&
                query->cell[k] > 0 && isfinite(query->cell[k]) && isfinite(query->half_size[k]);
        valid = valid && (query->shape == MPM_CLASSIC || query->half_size[k] > 0);
        valid = valid && (query->shape != MPM_UGIMP || query->half_size[k] <= query->cell[k]);
    }
    for (size_t i = 0; i < 4; i++) {
        valid = valid && (query->shape != MPM_CPDI || isfinite(query->deformation_gradient[i]));
    }
    const bool on_axis = query->shape == MPM_UGIMP && query->axis == MPM_TRUNCATED;
    return valid && (query->geometry != MPM_AXISYMMETRIC || query->position[0] > 0 ||
                     (on_axis && !(query->position[0] < 0)));
}

bool shape_quadrature_prepare(struct shape_quadrature *quadrature,
                              const struct mpm_shape_query *query, struct shape_domain *domain)
{
    if (!query_is_valid(query)) {
        return false;
    }
    quadrature->query = *query;
    quadrature->domain = (struct shape_domain){.magnification = 1};
    const bool done = query->shape == MPM_CPDI ? parallelogram_prepare(quadrature)
                                               : rectangle_prepare(quadrature);
    *domain = quadrature->domain;
    return done;
}

bool shape_quadrature_node(struct shape_quadrature *quadrature, int64_t column, int64_t row,
                           struct shape_reference *reference)
{
    const struct mpm_shape_query *query = &quadrature->query;
    const struct shape_domain *domain = &quadrature->domain;
    *reference = (struct shape_reference){.depth = -1};
    if (column < domain->first[0] || column > domain->last[0] || row < domain->first[1] ||
        row > domain->last[1]) {
        return true;
    }
    const bool axisymmetric = query->geometry == MPM_AXISYMMETRIC;
    const long double node_radius =
        (long double)query->origin[0] + (long double)column * (long double)query->cell[0];
    const double tiny = 1e-9 * query->cell[0]; /* tells r = 0 from r = -cell */
    if (axisymmetric && query->axis == MPM_TRUNCATED && node_radius < -(long double)tiny) {
        return true;
    }
    if (query->shape == MPM_CPDI) {
        return parallelogram_node_at(quadrature, column, row, reference);
    }
    rectangle_node(quadrature, (size_t)(column - domain->first[0]),
                   (size_t)(row - domain->first[1]), reference);
    if (!axisymmetric) {
        reference->value[SHAPE_T] = reference->estimate[SHAPE_T] = 0;
    }
    return true;
}

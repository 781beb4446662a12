/* Shape functions by adaptive quadrature of their definitions; see shape_quadrature.h.
 *
 * Lengths are in cells here. Positions are split into node plus offset in long double, so
 * that the reference has no cancellation of its own far from the origin.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/shapes/shape_quadrature.h"
#include "verification/exact/manufactured/hat.h"
#include "verification/exact/shapes/corner_quadrature.h"
#include "verification/exact/shapes/spline_quadrature.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdlib.h>

/* A uGIMP domain of up to two cells' width or a cubic B-spline's four nodes, their neighbours
 * and the ring around them. */
enum { AXIS_NODES_MAX = 8, WORKSPACE_INTERVALS = 64 };

/* GSL's tolerance, times the size of the integrand. Its estimate cannot fall below
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

struct shape_quadrature {
    struct mpm_shape_query query;
    struct shape_domain domain;
    struct axis_node axis[2][AXIS_NODES_MAX]; /* all but CPDI */
    struct parallelogram parallelogram;       /* CPDI */
    struct spline_quadrature *splines;        /* B-splines */
    struct corner_quadrature *corners;        /* CPDI */
    gsl_integration_workspace *workspace;     /* uGIMP */
};

struct shape_quadrature *shape_quadrature_create(void)
{
    gsl_set_error_handler_off();
    struct shape_quadrature *quadrature = calloc(1, sizeof *quadrature);
    if (quadrature == NULL) {
        return NULL;
    }
    quadrature->workspace = gsl_integration_workspace_alloc(WORKSPACE_INTERVALS);
    quadrature->corners = corner_quadrature_create();
    quadrature->splines = spline_quadrature_create();
    if (quadrature->workspace == NULL || quadrature->corners == NULL ||
        quadrature->splines == NULL) {
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
    gsl_integration_workspace_free(quadrature->workspace);
    corner_quadrature_free(quadrature->corners);
    spline_quadrature_free(quadrature->splines);
    free(quadrature);
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
            WORKSPACE_INTERVALS, quadrature->workspace, &node->value[i], &node->estimate[i]);
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
    const long double half = query->shape == MPM_UGIMP
                                 ? (long double)query->half_size[k] / (long double)query->cell[k]
                                 : 0;
    struct axis_domain axis = {.lower = centre - half, .upper = centre + half};
    axis.zero = cells_from_origin(query, k, 0);
    axis.radial = query->geometry == MPM_AXISYMMETRIC && query->axis != MPM_PLANAR && k == 0;
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

/* 2, 3, or 0 for all but B-splines. */
static int spline_degree(const struct mpm_shape_query *query)
{
    return query->shape == MPM_BSPLINE2 ? 2 : query->shape == MPM_BSPLINE3 ? 3 : 0;
}

/* The grid ends at its first and last node and, in axisymmetry, at r = 0. */
static bool spline_axis_nodes(struct shape_quadrature *quadrature, const struct axis_domain *axis,
                              size_t k, size_t count)
{
    const struct mpm_shape_query *query = &quadrature->query;
    const bool bounded = query->cells[k] > 0, from_axis = axis->radial && axis->zero >= 0;
    const struct spline_line line = {
        .degree = spline_degree(query),
        .place = axis->lower,
        .has_edge = {bounded || axis->radial, bounded},
        .edge = {from_axis || !bounded ? llroundl(axis->zero) : 0, query->cells[k]},
    };
    struct spline_node nodes[AXIS_NODES_MAX];
    if (!spline_quadrature_line(quadrature->splines, &line, quadrature->domain.first[k], count,
                                nodes)) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        const double *value = nodes[i].value, *estimate = nodes[i].estimate;
        quadrature->axis[k][i] = (struct axis_node){
            .value = {value[SPLINE_VALUE], value[SPLINE_SLOPE], value[SPLINE_VALUE]},
            .estimate = {estimate[SPLINE_VALUE], estimate[SPLINE_SLOPE], estimate[SPLINE_VALUE]},
            .depth = nodes[i].depth,
        };
    }
    return true;
}

static bool axis_nodes_prepare(struct shape_quadrature *quadrature, const struct axis_domain *axis,
                               size_t k)
{
    const int degree = spline_degree(&quadrature->query);
    const long double reach = degree > 0 ? (long double)spline_reach(degree) : 0;
    window_set(&quadrature->domain, k, axis->lower - reach, axis->upper + reach);
    const int64_t first = quadrature->domain.first[k];
    const int64_t count = quadrature->domain.last[k] - first + 1;
    if (count > AXIS_NODES_MAX) {
        return false;
    }
    if (degree > 0) {
        return spline_axis_nodes(quadrature, axis, k, (size_t)count);
    }
    for (int64_t i = 0; i < count; i++) {
        struct axis_node *node = &quadrature->axis[k][i];
        if (quadrature->query.shape == MPM_CLASSIC) {
            classic_axis_node(axis, first + i, node);
        } else if (!axis_node_integrate(quadrature, axis, first + i, node)) {
            return false;
        }
    }
    return true;
}

static bool rectangle_prepare(struct shape_quadrature *quadrature)
{
    const struct mpm_shape_query *query = &quadrature->query;
    struct axis_domain axes[2] = {axis_domain_of(query, 0), axis_domain_of(query, 1)};
    if (axes[0].radial) {
        domain_set_radius(&quadrature->domain, query->cell[0],
                          (double)((axes[0].lower + axes[0].upper) / 2 - axes[0].zero),
                          (double)(axes[0].upper - axes[0].lower) / 2);
    } else if (query->axis == MPM_PLANAR) {
        quadrature->domain.mean_radius = query->position[0];
    }
    return axis_nodes_prepare(quadrature, &axes[0], 0) &&
           axis_nodes_prepare(quadrature, &axes[1], 1);
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

/* Domain vectors in cells, N&G (31) with each component over its own axis' cell. */
static void domain_vectors_set(const struct mpm_shape_query *query, double domain_vector[2][2])
{
    const double *f = query->deformation_gradient; /* xx xy yx yy */
    for (size_t k = 0; k < 2; k++) {
        domain_vector[0][k] = f[2 * k] * query->half_size[0] / query->cell[k];
        domain_vector[1][k] = f[2 * k + 1] * query->half_size[1] / query->cell[k];
    }
}

static bool parallelogram_prepare(struct shape_quadrature *quadrature)
{
    const struct mpm_shape_query *query = &quadrature->query;
    struct parallelogram *shape = &quadrature->parallelogram;
    domain_vectors_set(query, shape->domain_vector);
    shape->radial = query->geometry == MPM_AXISYMMETRIC && query->axis != MPM_PLANAR;
    quadrature->domain.mean_radius = query->position[0];
    shape->zero = cells_from_origin(query, 0, 0);
    for (size_t k = 0; k < 2; k++) {
        shape->centre[k] = cells_from_origin(query, k, query->position[k]);
    }
    const double radius = (double)(shape->centre[0] - shape->zero);
    double reach = fabs(shape->domain_vector[0][0]) + fabs(shape->domain_vector[1][0]);
    if (shape->radial && query->axis == MPM_TRUNCATED && reach > radius) {
        for (size_t i = 0; i < 4; i++) {
            shape->domain_vector[i / 2][i % 2] *= radius / reach;
        }
        reach = radius;
    }
    if (shape->radial) {
        domain_set_radius(&quadrature->domain, query->cell[0], radius, reach);
    }
    for (size_t k = 0; k < 2; k++) {
        const double half = fabs(shape->domain_vector[0][k]) + fabs(shape->domain_vector[1][k]);
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
        const bool has_domain = query->shape == MPM_UGIMP || query->shape == MPM_CPDI;
        valid = valid && (!has_domain || query->half_size[k] > 0);
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
    bool done = true;
    if (query->shape == MPM_CPDI) {
        done = corner_quadrature_node(quadrature->corners, &quadrature->parallelogram,
                                      domain->magnification, column, row, reference);
    } else {
        rectangle_node(quadrature, (size_t)(column - domain->first[0]),
                       (size_t)(row - domain->first[1]), reference);
    }
    if (!axisymmetric) {
        reference->value[SHAPE_T] = reference->estimate[SHAPE_T] = 0;
    }
    return done;
}

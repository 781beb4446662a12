/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/shapes/spline_quadrature.h"
#include "verification/exact/manufactured/hat.h"

#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdlib.h>

enum { WORKSPACE_INTERVALS = 64 };

/* GSL's tolerance; the averages are of order one. It never claims less than 1.1e-14. */
static const double TOLERANCE = 5e-14;

struct spline_quadrature {
    gsl_integration_workspace *workspace;
};

struct spline_quadrature *spline_quadrature_create(void)
{
    struct spline_quadrature *quadrature = calloc(1, sizeof *quadrature);
    if (quadrature == NULL) {
        return NULL;
    }
    quadrature->workspace = gsl_integration_workspace_alloc(WORKSPACE_INTERVALS);
    if (quadrature->workspace == NULL) {
        free(quadrature);
        return NULL;
    }
    return quadrature;
}

void spline_quadrature_free(struct spline_quadrature *quadrature)
{
    if (quadrature == NULL) {
        return;
    }
    gsl_integration_workspace_free(quadrature->workspace);
    free(quadrature);
}

double spline_reach(int degree)
{
    return degree == 2 ? 1.5 : 2;
}

/* --------------------------------------------------------------- one average */

struct average {
    int degree;
    double offset; /* of the point from the node */
    bool slope;
};

/* The hat or its slope at y from the node, times the weight of y in the average. */
static double integrand(double y, void *context)
{
    const struct average *average = context;
    const double value = average->slope ? hat_slope(y) : hat(y);
    return average->degree == 2 ? value : value * hat(average->offset - y);
}

/* Where the integrand has kinks, in order, from one end of its support to the other. */
static size_t break_points(const struct average *average, double points[4])
{
    const double width = average->degree == 2 ? 0.5 : 1;
    const double from = fmax(-1, average->offset - width);
    const double to = fmin(1, average->offset + width);
    const double kinks[2] = {fmin(0, average->offset), fmax(0, average->offset)};
    size_t count = 0;
    points[count++] = from;
    for (size_t i = 0; i < 2; i++) {
        if (kinks[i] > points[count - 1] && kinks[i] < to) {
            points[count++] = kinks[i];
        }
    }
    points[count++] = to;
    return count;
}

static bool integrate(const struct spline_quadrature *quadrature, const struct spline_line *line,
                      int64_t index, struct spline_node *node)
{
    struct average average = {line->degree, (double)(line->place - (long double)index), false};
    *node = (struct spline_node){.depth = spline_reach(line->degree) - fabs(average.offset)};
    if (node->depth <= 0) {
        return true;
    }
    double points[4];
    const size_t count = break_points(&average, points);
    for (size_t i = 0; i < SPLINE_VALUES; i++) {
        average.slope = i == SPLINE_SLOPE;
        gsl_function function = {integrand, &average};
        const int status =
            gsl_integration_qagp(&function, points, count, TOLERANCE, 0, WORKSPACE_INTERVALS,
                                 quadrature->workspace, &node->value[i], &node->estimate[i]);
        if (status != 0) {
            return false;
        }
    }
    return true;
}

/* -------------------------------------------------------------------- edges */

static void add_times(struct spline_node *to, double factor, const struct spline_node *from)
{
    for (size_t i = 0; i < SPLINE_VALUES; i++) {
        to->value[i] += factor * from->value[i];
        to->estimate[i] += fabs(factor) * from->estimate[i];
    }
}

/* The nodes beyond an edge; `inwards` is 1 at the first node, -1 at the last. Two cells
 * beyond, nothing is in reach of a point inside. */
static void fold(struct spline_node nodes[], size_t count, int64_t edge, int64_t inwards)
{
    for (int64_t i = 0; i < (int64_t)count; i++) {
        if ((i - edge) * inwards >= 0) {
            continue;
        }
        if (i == edge - inwards && nodes[i].depth > 0) {
            add_times(&nodes[edge], 2, &nodes[i]);
            add_times(&nodes[edge + inwards], -1, &nodes[i]);
        }
        nodes[i] = (struct spline_node){.depth = -1};
    }
}

bool spline_quadrature_line(struct spline_quadrature *quadrature, const struct spline_line *line,
                            int64_t first, size_t count, struct spline_node nodes[])
{
    for (size_t i = 0; i < count; i++) {
        if (!integrate(quadrature, line, first + (int64_t)i, &nodes[i])) {
            return false;
        }
    }
    for (size_t side = 0; side < 2; side++) {
        if (line->has_edge[side]) {
            fold(nodes, count, line->edge[side] - first, side == 0 ? 1 : -1);
        }
    }
    return true;
}

/* S3: N&G Figs 2 and 3 and the B-splines at an edge from the solver's own functions, and values
 * at points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/shapes/shape_lines.h"
#include "verification/programs/shapes/program_shape_kind.h"

#include <math.h>
#include <stdlib.h>

static const double SIZE = 0.5; /* l_p of the figures */

/* Four nodes; the figures' abscissa is 2 r / cell. */
enum { NODES = 4, COLUMNS = 1 + 2 * NODES };

enum value { VALUE_S, VALUE_DS, VALUE_T };

/* A point of the formulas; the value by hand is the case's `expected`. */
struct point {
    enum mpm_shape shape;
    const char *quantity;
    enum mpm_axis axis;
    enum value value;
    int64_t node;
    double radius; /* in cells */
};

static const struct point POINTS[] = {
    {MPM_UGIMP, "s0_on_axis", MPM_TRUNCATED, VALUE_S, 0, 0},
    {MPM_UGIMP, "s1_on_axis", MPM_TRUNCATED, VALUE_S, 1, 0},
    {MPM_UGIMP, "ds0_near_axis", MPM_TRUNCATED, VALUE_DS, 0, 0.125},
    {MPM_UGIMP, "ds1_near_axis", MPM_TRUNCATED, VALUE_DS, 1, 0.125},
    {MPM_UGIMP, "t0_near_axis", MPM_TRUNCATED, VALUE_T, 0, 0.125},
    {MPM_UGIMP, "t1_near_axis", MPM_TRUNCATED, VALUE_T, 1, 0.125},
    {MPM_UGIMP, "s_minus_1_untruncated", MPM_UNTRUNCATED, VALUE_S, -1, 0.125},
    {MPM_UGIMP, "s0_untruncated", MPM_UNTRUNCATED, VALUE_S, 0, 0.125},
    {MPM_UGIMP, "s1_untruncated", MPM_UNTRUNCATED, VALUE_S, 1, 0.125},
    {MPM_UGIMP, "ds0_untruncated", MPM_UNTRUNCATED, VALUE_DS, 0, 0.125},
    {MPM_UGIMP, "s0_at_node_1", MPM_TRUNCATED, VALUE_S, 0, 1},
    {MPM_UGIMP, "ds0_at_node_1", MPM_TRUNCATED, VALUE_DS, 0, 1},
    {MPM_UGIMP, "ds1_at_node_1", MPM_TRUNCATED, VALUE_DS, 1, 1},
    {MPM_UGIMP, "s1_between_nodes", MPM_TRUNCATED, VALUE_S, 1, 1.5},
    {MPM_BSPLINE2, "s0_at_edge", MPM_TRUNCATED, VALUE_S, 0, 0},
    {MPM_BSPLINE2, "s0_folded", MPM_TRUNCATED, VALUE_S, 0, 0.25},
    {MPM_BSPLINE2, "s1_folded", MPM_TRUNCATED, VALUE_S, 1, 0.25},
    {MPM_BSPLINE2, "ds0_folded", MPM_TRUNCATED, VALUE_DS, 0, 0.25},
    {MPM_BSPLINE2, "s0_at_knot", MPM_TRUNCATED, VALUE_S, 0, 0.5},
    {MPM_BSPLINE2, "s0_at_node_1", MPM_TRUNCATED, VALUE_S, 0, 1},
    {MPM_BSPLINE2, "s1_at_node_1", MPM_TRUNCATED, VALUE_S, 1, 1},
    {MPM_BSPLINE2, "ds1_past_node_1", MPM_TRUNCATED, VALUE_DS, 1, 1.25},
    {MPM_BSPLINE3, "s0_at_edge", MPM_TRUNCATED, VALUE_S, 0, 0},
    {MPM_BSPLINE3, "s0_folded", MPM_TRUNCATED, VALUE_S, 0, 0.5},
    {MPM_BSPLINE3, "s1_folded", MPM_TRUNCATED, VALUE_S, 1, 0.5},
    {MPM_BSPLINE3, "s2_folded", MPM_TRUNCATED, VALUE_S, 2, 0.5},
    {MPM_BSPLINE3, "ds0_folded", MPM_TRUNCATED, VALUE_DS, 0, 0.5},
    {MPM_BSPLINE3, "s0_at_node_1", MPM_TRUNCATED, VALUE_S, 0, 1},
    {MPM_BSPLINE3, "s1_at_node_1", MPM_TRUNCATED, VALUE_S, 1, 1},
    {MPM_BSPLINE3, "ds1_past_node_2", MPM_TRUNCATED, VALUE_DS, 1, 2.5},
};

struct curve {
    const char *name;
    enum mpm_shape shape;
    enum mpm_geometry geometry;
    enum mpm_axis axis;
    bool edge; /* at node 0 */
    int64_t first_node;
    double from, to; /* abscissa */
};

static const struct curve CURVES[] = {
    {"truncated", MPM_UGIMP, MPM_AXISYMMETRIC, MPM_TRUNCATED, false, -1, -3, 6},
    {"untruncated", MPM_UGIMP, MPM_AXISYMMETRIC, MPM_UNTRUNCATED, false, -1, -3, 6},
    {"planar", MPM_UGIMP, MPM_PLANE_STRAIN, MPM_TRUNCATED, false, -1, -3, 6},
    {"folded", MPM_BSPLINE2, MPM_PLANE_STRAIN, MPM_TRUNCATED, true, 0, 0, 6},
    {"free", MPM_BSPLINE2, MPM_PLANE_STRAIN, MPM_TRUNCATED, false, -1, 0, 6},
    {"folded", MPM_BSPLINE3, MPM_PLANE_STRAIN, MPM_TRUNCATED, true, 0, 0, 6},
    {"free", MPM_BSPLINE3, MPM_PLANE_STRAIN, MPM_TRUNCATED, false, -1, 0, 6},
};

/* B-splines of points are the same in every geometry: with r = 0, the edge. */
static void report_points(struct measurement *measurement, enum mpm_shape shape)
{
    for (size_t i = 0; i < sizeof POINTS / sizeof *POINTS; i++) {
        const struct point *point = &POINTS[i];
        const struct shape_line line = {shape, MPM_AXISYMMETRIC, point->axis, SIZE, false};
        if (point->shape != shape) {
            continue;
        }
        const struct shape_line_value at = shape_line_at(&line, point->node, point->radius);
        const double values[] = {[VALUE_S] = at.s, [VALUE_DS] = at.ds, [VALUE_T] = at.t};
        measurement_report(measurement, point->quantity, values[point->value]);
    }
}

/* One row: abscissa, then S_r and dS_r of each node; axisymmetric curves have r > 0 only. */
static void curve_row(const struct curve *curve, double abscissa, double row[COLUMNS])
{
    const struct shape_line line = {curve->shape, curve->geometry, curve->axis, SIZE, curve->edge};
    const bool defined = curve->geometry != MPM_AXISYMMETRIC || abscissa > 0;
    row[0] = abscissa;
    for (int n = 0; n < NODES; n++) {
        struct shape_line_value at = {(double)NAN, (double)NAN, (double)NAN};
        if (defined) {
            at = shape_line_at(&line, curve->first_node + n, abscissa / 2);
        }
        row[1 + n] = at.s;
        row[1 + NODES + n] = at.ds;
    }
}

static enum mpm_status write_curves(struct measurement *measurement, enum mpm_shape shape,
                                    size_t points, double *rows, struct mpm_error *error)
{
    for (size_t i = 0; i < sizeof CURVES / sizeof *CURVES; i++) {
        const struct curve *curve = &CURVES[i];
        if (curve->shape != shape) {
            continue;
        }
        for (size_t j = 0; j < points; j++) {
            const double part = (double)j / (double)(points - 1);
            curve_row(curve, curve->from + (curve->to - curve->from) * part, &rows[j * COLUMNS]);
        }
        TRY(measurement_series(measurement, curve->name,
                               curve->first_node < 0
                                   ? "2r/cell S_-1 S_0 S_1 S_2 dS_-1 dS_0 dS_1 dS_2"
                                   : "2r/cell S_0 S_1 S_2 S_3 dS_0 dS_1 dS_2 dS_3",
                               COLUMNS, points, rows, error));
    }
    return MPM_OK;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    enum mpm_shape shape;
    unsigned points;
    TRY(shape_family_read(measurement, &shape, error));
    TRY(measurement_count(measurement, "points", 1, SHAPE_COUNT_MAX, &points, error));
    report_points(measurement, shape);
    double *rows = calloc(points, COLUMNS * sizeof *rows);
    if (rows == NULL) {
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory: %u points of a curve",
                           points);
    }
    const enum mpm_status status = write_curves(measurement, shape, points, rows, error);
    free(rows);
    return status;
}

const struct measure_program program_shape_curves = {
    "shape_curves",
    "one-dimensional shape functions near the axis, as in N&G Figs 2 and 3, or an edge", run};

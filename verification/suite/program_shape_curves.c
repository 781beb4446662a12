/* S3: N&G Figs 2 and 3 from the solver's own functions, and the paper's values at points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/shape_lines.h"
#include "verification/suite/program_shape_kind.h"

#include <math.h>
#include <stdlib.h>

static const double SIZE = 0.5; /* l_p of the figures */

/* Nodes -1 to 2; the figures' abscissa is 2 r / cell, from -3 to 6. */
enum { FIRST_NODE = -1, NODES = 4, COLUMNS = 1 + 2 * NODES };
static const double FROM = -3, TO = 6;

enum value { VALUE_S, VALUE_DS, VALUE_T };

/* A point of the paper's formulas; the value by hand is the case's `expected`. */
struct point {
    const char *quantity;
    enum mpm_axis axis;
    enum value value;
    int64_t node;
    double radius; /* in cells */
};

static const struct point POINTS[] = {
    {"s0_on_axis", MPM_TRUNCATED, VALUE_S, 0, 0},
    {"s1_on_axis", MPM_TRUNCATED, VALUE_S, 1, 0},
    {"ds0_near_axis", MPM_TRUNCATED, VALUE_DS, 0, 0.125},
    {"ds1_near_axis", MPM_TRUNCATED, VALUE_DS, 1, 0.125},
    {"t0_near_axis", MPM_TRUNCATED, VALUE_T, 0, 0.125},
    {"t1_near_axis", MPM_TRUNCATED, VALUE_T, 1, 0.125},
    {"s_minus_1_untruncated", MPM_UNTRUNCATED, VALUE_S, -1, 0.125},
    {"s0_untruncated", MPM_UNTRUNCATED, VALUE_S, 0, 0.125},
    {"s1_untruncated", MPM_UNTRUNCATED, VALUE_S, 1, 0.125},
    {"ds0_untruncated", MPM_UNTRUNCATED, VALUE_DS, 0, 0.125},
    {"s0_at_node_1", MPM_TRUNCATED, VALUE_S, 0, 1},
    {"ds0_at_node_1", MPM_TRUNCATED, VALUE_DS, 0, 1},
    {"ds1_at_node_1", MPM_TRUNCATED, VALUE_DS, 1, 1},
    {"s1_between_nodes", MPM_TRUNCATED, VALUE_S, 1, 1.5},
};

struct curve {
    const char *name;
    enum mpm_geometry geometry;
    enum mpm_axis axis;
};

static const struct curve CURVES[] = {
    {"truncated", MPM_AXISYMMETRIC, MPM_TRUNCATED},
    {"untruncated", MPM_AXISYMMETRIC, MPM_UNTRUNCATED},
    {"planar", MPM_PLANE_STRAIN, MPM_TRUNCATED},
};

static void report_points(struct measurement *measurement)
{
    for (size_t i = 0; i < sizeof POINTS / sizeof *POINTS; i++) {
        const struct point *point = &POINTS[i];
        const struct shape_line line = {MPM_UGIMP, MPM_AXISYMMETRIC, point->axis, SIZE};
        const struct shape_line_value at = shape_line_at(&line, point->node, point->radius);
        const double values[] = {[VALUE_S] = at.s, [VALUE_DS] = at.ds, [VALUE_T] = at.t};
        measurement_report(measurement, point->quantity, values[point->value]);
    }
}

/* One row: abscissa, then S_r and dS_r of each node; axisymmetric curves have r > 0 only. */
static void curve_row(const struct curve *curve, double abscissa, double row[COLUMNS])
{
    const struct shape_line line = {MPM_UGIMP, curve->geometry, curve->axis, SIZE};
    const bool defined = curve->geometry != MPM_AXISYMMETRIC || abscissa > 0;
    row[0] = abscissa;
    for (int n = 0; n < NODES; n++) {
        struct shape_line_value at = {(double)NAN, (double)NAN, (double)NAN};
        if (defined) {
            at = shape_line_at(&line, FIRST_NODE + n, abscissa / 2);
        }
        row[1 + n] = at.s;
        row[1 + NODES + n] = at.ds;
    }
}

static enum mpm_status write_curves(struct measurement *measurement, size_t points, double *rows,
                                    struct mpm_error *error)
{
    for (size_t i = 0; i < sizeof CURVES / sizeof *CURVES; i++) {
        for (size_t j = 0; j < points; j++) {
            const double abscissa = FROM + (TO - FROM) * (double)j / (double)(points - 1);
            curve_row(&CURVES[i], abscissa, &rows[j * COLUMNS]);
        }
        TRY(measurement_series(measurement, CURVES[i].name,
                               "2r/cell S_-1 S_0 S_1 S_2 dS_-1 dS_0 dS_1 dS_2", COLUMNS, points,
                               rows, error));
    }
    return MPM_OK;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    size_t points;
    TRY(shape_count_read(measurement, "points", &points, error));
    report_points(measurement);
    double *rows = calloc(points, COLUMNS * sizeof *rows);
    if (rows == NULL) {
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory: %zu points of a curve",
                           points);
    }
    const enum mpm_status status = write_curves(measurement, points, rows, error);
    free(rows);
    return status;
}

const struct measure_program program_shape_curves = {
    "shape_curves", "one-dimensional shape functions near the axis, as in N&G Figs 2 and 3", run};

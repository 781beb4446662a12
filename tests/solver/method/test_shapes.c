/* B-splines at the edges of grids, and planar functions used axisymmetrically.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm.h"
#include "suites.h"
#include "support/near.h"
#include "support/scenes.h"

#include <float.h>
#include <glib.h>
#include <stdlib.h>
#include <string.h>

/* Sums of 16 products of a few rounded numbers of order one. */
static const double ROUND_OFF = 16 * 4 * DBL_EPSILON;

/* --------------------------------------------------------------- one particle */

static const enum mpm_shape splines[] = {MPM_BSPLINE2, MPM_BSPLINE3};
enum { SPLINES = G_N_ELEMENTS(splines) };

/* On cells of 2 by 3, coordinates in cells. */
static struct mpm_shape_query query_at(enum mpm_shape shape, enum mpm_geometry geometry,
                                       int64_t cells, double x, double y)
{
    return (struct mpm_shape_query){
        .shape = shape,
        .geometry = geometry,
        .cell = {2, 3},
        .cells = {cells, cells},
        .position = {2 * x, 3 * y},
        .half_size = {0.5, 0.75},
        .deformation_gradient = {1, 0, 0, 1},
    };
}

/* In the corner: S of the corner's node alone, and the slopes along its edges. */
START_TEST(a_bspline_leaves_one_weight_on_the_edge)
{
    for (int64_t cells = 1; cells <= 5; cells++)
        for (int corner = 0; corner < 4; corner++) {
            const int64_t column = corner % 2 * cells, row = corner / 2 * cells;
            const struct mpm_shape_query query =
                query_at(splines[_i], MPM_PLANE_STRAIN, cells, (double)column, (double)row);
            struct mpm_stencil_entry entries[MPM_STENCIL_MAX];
            const size_t count = mpm_shape_evaluate(&query, entries);
            ck_assert_uint_eq(count, 3);
            for (size_t k = 0; k < count; k++) {
                const bool here = entries[k].column == column && entries[k].row == row;
                ck_assert_double_eq(entries[k].s, here ? 1.0 : 0.0);
                ck_assert(entries[k].column >= 0 && entries[k].column <= cells);
                ck_assert(entries[k].row >= 0 && entries[k].row <= cells);
            }
        }
}
END_TEST

START_TEST(folded_bsplines_are_not_negative_and_reproduce_linear_functions)
{
    enum { PLACES = 64 };
    for (int64_t cells = 1; cells <= 6; cells++)
        for (int place = 0; place <= PLACES; place++) {
            const double x = (double)cells * place / PLACES;
            const struct mpm_shape_query query =
                query_at(splines[_i], MPM_PLANE_STRAIN, cells, x, (double)cells - x);
            struct mpm_stencil_entry entries[MPM_STENCIL_MAX];
            const size_t count = mpm_shape_evaluate(&query, entries);
            double sum = 0.0, first = 0.0, slope = 0.0;
            for (size_t k = 0; k < count; k++) {
                ck_assert(entries[k].s >= 0.0);
                ck_assert(entries[k].column >= 0 && entries[k].column <= cells);
                sum += entries[k].s;
                first += entries[k].s * (double)entries[k].column;
                slope += entries[k].g[0] * 2 * (double)entries[k].column;
            }
            ck_assert_near(sum, 1.0, ROUND_OFF);
            ck_assert_near(first, x, 6 * ROUND_OFF);
            ck_assert_near(slope, 1.0, 6 * ROUND_OFF);
        }
}
END_TEST

/* Within round-off of a knot the node beyond has no entry, not one of 1e-32. */
START_TEST(no_weight_is_left_of_round_off_at_a_knot)
{
    const int inside = splines[_i] == MPM_BSPLINE2 ? 2 : 3; /* nodes along an axis, on a knot */
    const double knot = splines[_i] == MPM_BSPLINE2 ? 4.5 : 4.0;
    for (int shift = -2; shift <= 2; shift++) {
        const double x = knot * (1.0 + shift * 0.25 * DBL_EPSILON);
        const struct mpm_shape_query query = query_at(splines[_i], MPM_PLANE_STRAIN, 9, x, knot);
        struct mpm_stencil_entry entries[MPM_STENCIL_MAX];
        ck_assert_uint_eq(mpm_shape_evaluate(&query, entries), (size_t)(inside * inside));
    }
}
END_TEST

static void assert_same(const struct mpm_stencil_entry *a, const struct mpm_stencil_entry *b)
{
    ck_assert(a->column == b->column && a->row == b->row);
    ck_assert_double_eq(a->s, b->s);
    ck_assert_double_eq(a->g[0], b->g[0]);
    ck_assert_double_eq(a->g[1], b->g[1]);
    ck_assert_double_eq(a->t, b->t);
}

/* There is no domain to cut; r = 0 is an edge, whether or not the grid has one there. */
START_TEST(bsplines_are_the_same_truncated_untruncated_and_planar)
{
    for (int place = 1; place <= 40; place++) {
        struct mpm_stencil_entry first[MPM_STENCIL_MAX], entries[MPM_STENCIL_MAX];
        struct mpm_shape_query query =
            query_at(splines[_i], MPM_AXISYMMETRIC, 8, 0.0625 * place, 2.25);
        static const enum mpm_axis axes[] = {MPM_UNTRUNCATED, MPM_PLANAR, MPM_TRUNCATED};
        const size_t count = mpm_shape_evaluate(&query, first);
        for (size_t a = 0; a < G_N_ELEMENTS(axes); a++) {
            query.axis = axes[a];
            query.cells[0] = a == 2 ? 0 : 8;
            ck_assert_uint_eq(mpm_shape_evaluate(&query, entries), count);
            for (size_t k = 0; k < count; k++)
                assert_same(&first[k], &entries[k]);
        }
        for (size_t k = 0; k < count; k++)
            ck_assert_near(first[k].t * query.position[0], first[k].s, ROUND_OFF);
    }
}
END_TEST

/* ---------------------------------------------------------------------- scenes */

/* A disk whose nodes have the condition v_r = -0.1 r. */
static const char DISK[] =
    "format: 1\n"
    "title: A disk\n"
    "geometry: axisymmetric\n"
    "grid: {origin: [0, 0], cell: [1, 0.8], cells: [9, 6]}\n"
    "time: {end: 1000, courant: 0.2}\n"
    "method: {shape: ugimp, stress_update: musl, deformation_terms: 1}\n"
    "materials: [{name: rubber, law: neo_hookean, density: 1, bulk: 80, shear: 48}]\n"
    "bodies:\n"
    "  - {name: disk, material: rubber, region: {rectangle: {from: [0, 1.6], to: [5, 4]}},\n"
    "     velocity: ['-0.1*r', 0]}\n"
    "boundary: [{region: {rectangle: {from: [0, 0], to: [9, 4.8]}}, velocity: ['-0.1*r', 0]}]\n";

static const struct domain_case {
    const char *shape, *nodes;
    bool homogeneous;
} domain_cases[] = {
    {"ugimp", "free", false},
    {"ugimp", "zero", false},
    {"ugimp", "mirrored", true},
    {"cpdi", "mirrored", true},
};

/* The largest |F_rr - F_tt| after some steps; F_rr = F_tt in the field -0.1 r. */
static double uneven(const char *shape, const char *nodes, const char *origin, const char *cells,
                     const char *order)
{
    char *settings[] = {
        g_strdup_printf("method.shape=%s", shape),
        g_strdup_printf("method.axis_nodes=%s", nodes),
        g_strdup("method.axis=planar"),
        g_strdup_printf("grid.origin=%s", origin),
        g_strdup_printf("grid.cells=%s", cells),
        g_strdup_printf("method.stress_update=%s", order),
        NULL,
    };
    struct test_run run = test_run_open(DISK, (const char *const *)(void *)settings, 1);
    size_t count;
    double largest = 0.0;
    test_run_steps(&run, 10);
    double *const f = test_run_field(&run, MPM_FIELD_DEFORMATION_GRADIENT, &count);
    ck_assert(f[5 * count - 5] < 0.999);
    for (size_t p = 0; p < count; p++)
        largest = fmax(largest, fabs(f[5 * p] - f[5 * p + 4]));
    free(f);
    test_run_close(&run);
    for (size_t k = 0; k < G_N_ELEMENTS(settings); k++)
        g_free(settings[k]);
    return largest;
}

/* A mirrored node continues the field: planar functions then have sum T v_r = sum G_r v_r. */
START_TEST(extra_nodes_keep_a_linear_field_only_if_mirrored)
{
    static const char *const orders[] = {"usl", "musl", "usf", "usavg"};
    const struct domain_case *const c = &domain_cases[_i];
    for (size_t k = 0; k < G_N_ELEMENTS(orders); k++) {
        const double at_axis = uneven(c->shape, c->nodes, "[0, 0]", "[9, 6]", orders[k]);
        const double behind = uneven(c->shape, c->nodes, "[-2, 0]", "[11, 6]", orders[k]);
        if (c->homogeneous)
            ck_assert_double_le(at_axis, 10 * ROUND_OFF);
        else
            ck_assert_double_ge(at_axis, 1e-5);
        /* where the grid begins is nothing to the axis; extra nodes of little mass amplify the
         * rounding of coordinates */
        ck_assert_near(behind, at_axis, 1e-9);
    }
}
END_TEST

START_TEST(planar_functions_have_no_fast_kernels_and_say_so)
{
    static const struct {
        const char *shape, *kernels;
    } cases[] = {{"ugimp", "reference"},
                 {"cpdi", "reference"},
                 {"classic", "fast"},
                 {"bspline2", "fast"},
                 {"bspline3", "fast"}};
    for (size_t k = 0; k < G_N_ELEMENTS(cases); k++) {
        char *shape = g_strdup_printf("method.shape=%s", cases[k].shape);
        const char *const settings[] = {"method.axis=planar", shape, NULL};
        struct test_run run = test_run_open(DISK, settings, 1);
        const bool fast = strcmp(cases[k].kernels, "fast") == 0;
        ck_assert_str_eq(mpm_simulation_kernels(run.simulation), cases[k].kernels);
        struct mpm_plan plan;
        struct mpm_error error;
        struct mpm_simulation_options options = {.threads = 1, .kernels = MPM_KERNELS_AUTO};
        ck_assert_int_eq(mpm_scene_plan(run.scene, &options, &plan, &error), MPM_OK);
        ck_assert(fast || strstr(plan.kernels_reason, "method.axis: planar") != NULL);
        options.kernels = MPM_KERNELS_FAST;
        ck_assert_int_eq(mpm_scene_plan(run.scene, &options, &plan, &error),
                         fast ? MPM_OK : MPM_BAD_INPUT);
        if (!fast)
            ck_assert_str_eq(error.message,
                             "kernels: fast: there are no fast kernels for method.axis: planar; "
                             "allowed: auto, reference");
        test_run_close(&run);
        g_free(shape);
    }
}
END_TEST

Suite *suite_shapes(void)
{
    Suite *suite = suite_create("shapes");
    TCase *functions = tcase_create("functions");
    tcase_add_loop_test(functions, a_bspline_leaves_one_weight_on_the_edge, 0, SPLINES);
    tcase_add_loop_test(functions, folded_bsplines_are_not_negative_and_reproduce_linear_functions,
                        0, SPLINES);
    tcase_add_loop_test(functions, no_weight_is_left_of_round_off_at_a_knot, 0, SPLINES);
    tcase_add_loop_test(functions, bsplines_are_the_same_truncated_untruncated_and_planar, 0,
                        SPLINES);
    suite_add_tcase(suite, functions);
    TCase *axis = tcase_create("axis");
    tcase_add_loop_test(axis, extra_nodes_keep_a_linear_field_only_if_mirrored, 0,
                        G_N_ELEMENTS(domain_cases));
    tcase_add_test(axis, planar_functions_have_no_fast_kernels_and_say_so);
    suite_add_tcase(suite, axis);
    return suite;
}

/* Integrals over the edges of particles' domains against quadrature.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/shape/edge.h"
#include "suites.h"
#include "support/near.h"

#include <float.h>
#include <glib.h>
#include <gsl/gsl_integration.h>
#include <math.h>

enum { SHAPES = MPM_SHAPE_COUNT, SAMPLES = 100, POINTS = 16, CASES = 4 };

/* Planar, and the three that axisymmetry has. */
static const struct {
    enum mpm_geometry geometry;
    enum mpm_axis axis;
} places[CASES] = {
    {MPM_PLANE_STRAIN, MPM_TRUNCATED},
    {MPM_AXISYMMETRIC, MPM_TRUNCATED},
    {MPM_AXISYMMETRIC, MPM_UNTRUNCATED},
    {MPM_AXISYMMETRIC, MPM_PLANAR},
};

/* Areas are up to 2 x 10 here, and a weight is a sum of up to 64 products of a few factors, each
 * rounded; continued cubics are up to 30. */
static const double ROUND_OFF = 20.0 * 30.0 * 64 * DBL_EPSILON;
static const double DEPTH = 1.7;

struct sample {
    const struct mpm_shape_family *family;
    struct mpm_shape_grid grid;
    struct mpm_shape_domain domain;
    enum mpm_edge edge;
};

/* A domain anywhere on cells of 2 by 3, in a third of the tests near the axis, its F with rotation
 * and shear. */
static struct sample draw(GRand *random, int index)
{
    static const double origin[2] = {0.0, -3.0}, cell[2] = {2.0, 3.0};
    static const int64_t cells[2] = {9, 9};
    const int place = index / SHAPES;
    struct sample sample = {
        .family = mpm_shape_family((enum mpm_shape)(index % SHAPES)),
        .grid = mpm_shape_grid_describe(origin, cell, cells, places[place].geometry,
                                        places[place].axis),
        .domain = {.half_size = {g_rand_double_range(random, 0.1, 1.0),
                                 g_rand_double_range(random, 0.1, 1.5)}},
        .edge = (enum mpm_edge)g_rand_int_range(random, 0, MPM_EDGE_COUNT),
    };
    double f[4];
    for (int k = 0; k < 4; k++)
        f[k] = (k % 3 == 0 ? 1.0 : 0.0) + g_rand_double_range(random, -0.45, 0.45);
    sample.grid.columns = 1000;
    sample.domain.position[0] = g_rand_double_range(random, 0.1, index % 3 == 0 ? 1.5 : 14.0);
    sample.domain.position[1] = g_rand_double_range(random, 0.5, 20.0);
    mpm_shape_push_forward(f, sample.domain.half_size, sample.domain.edge);
    return sample;
}

/* The definition in edge.h, by corners: the undeformed rectangle, cut at r = 0, or the
 * parallelogram, shrunk there. */
static void corners_of(const struct sample *sample, double ends[2][2])
{
    static const int first[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const struct mpm_shape_domain *const domain = &sample->domain;
    const bool ugimp = sample->family == &mpm_shape_ugimp;
    const bool ends_there =
        sample->grid.axisymmetric && (sample->grid.truncated || sample->family->point);
    const double *const e = domain->edge, *const half = domain->half_size;
    double scale = 1.0;
    if (ends_there && !ugimp)
        scale = fmin(1.0, domain->position[0] / (fabs(e[0]) + fabs(e[2])));
    for (int end = 0; end < 2; end++) {
        const int *const sign = first[((int)sample->edge + end) % 4];
        for (int axis = 0; axis < 2; axis++)
            ends[end][axis] = domain->position[axis] +
                              (ugimp ? sign[axis] * half[axis]
                                     : scale * (sign[0] * e[axis] + sign[1] * e[2 + axis]));
        if (ends_there && ugimp)
            ends[end][0] = fmax(ends[end][0], 0.0);
    }
}

static double hat(double x)
{
    return fmax(0.0, 1.0 - fabs(x));
}

/* N of a node at a place; that of a point family inside the particle's own span. */
static double value_at(const struct sample *sample, int64_t node, const double place[2])
{
    const int64_t shifted = node + 10500; /* rows from -10, columns from -500 */
    const int64_t column = shifted % 1000 - 500, row = shifted / 1000 - 10;
    if (!sample->family->point)
        return hat(place[0] / 2.0 - (double)column) * hat((place[1] + 3.0) / 3.0 - (double)row);
    struct mpm_shape_domain domain = {.position = {place[0], place[1]}};
    struct mpm_shape_grid grid = sample->grid;
    struct mpm_stencil stencil;
    grid.axisymmetric = false;
    sample->family->evaluate(&grid, &domain, &stencil);
    for (int k = 0; k < stencil.count; k++)
        if (stencil.node[k].node == node)
            return stencil.node[k].s;
    return 0.0;
}

/* N between the corners is interpolated; of points it is that of the middle. */
static double quadrature(const struct sample *sample, int64_t node)
{
    double ends[2][2], sum = 0.0;
    corners_of(sample, ends);
    const double middle[2] = {0.5 * (ends[0][0] + ends[1][0]), 0.5 * (ends[0][1] + ends[1][1])};
    const double length = hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
    gsl_integration_glfixed_table *const table = gsl_integration_glfixed_table_alloc(POINTS);
    for (size_t k = 0; k < POINTS; k++) {
        double part, weight;
        gsl_integration_glfixed_point(0.0, 1.0, k, &part, &weight, table);
        const double place[2] = {ends[0][0] + part * (ends[1][0] - ends[0][0]),
                                 ends[0][1] + part * (ends[1][1] - ends[0][1])};
        const double n = sample->family->point ? value_at(sample, node, middle)
                                               : (1.0 - part) * value_at(sample, node, ends[0]) +
                                                     part * value_at(sample, node, ends[1]);
        sum += weight * length * n * (sample->grid.axisymmetric ? place[0] : DEPTH);
    }
    gsl_integration_glfixed_table_free(table);
    return sum;
}

static struct mpm_edge_weights weights_of(const struct sample *sample)
{
    struct mpm_edge_weights weights;
    mpm_edge_integrate(sample->family, &sample->grid, &sample->domain, sample->edge, DEPTH,
                       &weights);
    return weights;
}

static double weight_of(const struct mpm_edge_weights *weights, int64_t node)
{
    for (int k = 0; k < weights->count; k++)
        if (weights->entry[k].node == node)
            return weights->entry[k].w;
    return 0.0;
}

/* Do the edge and its image across the particle lie in the span of cells that the particle is in?
 * Knots are the nodes, or lie half way between them. */
static bool keeps_to_its_span(const struct sample *sample)
{
    const double shift = sample->family == &mpm_shape_bspline2 ? 0.5 : 0.0;
    double ends[2][2];
    corners_of(sample, ends);
    for (int end = 0; end < 2; end++)
        for (int axis = 0; axis < 2; axis++) {
            const double scale = sample->grid.inverse_cell[axis];
            const double origin = sample->grid.origin[axis];
            const double home = (sample->domain.position[axis] - origin) * scale + shift;
            const double there = (ends[end][axis] - origin) * scale + shift;
            if (floor(there) != floor(home) || floor(2.0 * home - there) != floor(home))
                return false;
        }
    return true;
}

START_TEST(weights_of_an_edge_are_the_integrals_of_the_nodes_functions_along_it)
{
    GRand *const random = g_rand_new_with_seed(20260 + (guint32)_i);
    int seen = 0;
    for (int tried = 0; seen < SAMPLES && tried < 100 * SAMPLES; tried++) {
        struct sample sample = draw(random, _i);
        if (sample.family->point)
            for (int k = 0; k < 4; k++)
                sample.domain.edge[k] *= 0.2;
        if (sample.family->point && !keeps_to_its_span(&sample))
            continue;
        const struct mpm_edge_weights weights = weights_of(&sample);
        for (int64_t row = -1; row < 12; row++)
            for (int64_t column = -1; column < 11; column++)
                ck_assert_near(weight_of(&weights, 1000 * row + column),
                               quadrature(&sample, 1000 * row + column), ROUND_OFF);
        seen++;
    }
    ck_assert_int_eq(seen, SAMPLES);
    g_rand_free(random);
}
END_TEST

/* Whatever the edge reaches past: sum w = A and sum w x_i = integral of x dS (of points: A times
 * the middle), so that a traction's force and moment are the edge's. */
START_TEST(weights_of_an_edge_have_its_area_and_its_first_moment)
{
    GRand *const random = g_rand_new_with_seed(777 + (guint32)_i);
    for (int k = 0; k < SAMPLES; k++) {
        const struct sample sample = draw(random, _i);
        const struct mpm_edge_weights weights = weights_of(&sample);
        double ends[2][2], area = 0.0, moment[2] = {0.0, 0.0};
        corners_of(&sample, ends);
        const double length = hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
        const bool radial = sample.grid.axisymmetric;
        const double depth[2] = {radial ? ends[0][0] : DEPTH, radial ? ends[1][0] : DEPTH};
        for (int n = 0; n < weights.count; n++) {
            const int64_t node = weights.entry[n].node + 10500;
            const int64_t row = node / 1000 - 10;
            area += weights.entry[n].w;
            moment[0] += weights.entry[n].w * 2.0 * (double)(node % 1000 - 500);
            moment[1] += weights.entry[n].w * (3.0 * (double)row - 3.0);
        }
        ck_assert_near(area, 0.5 * length * (depth[0] + depth[1]), ROUND_OFF);
        for (int axis = 0; axis < 2; axis++) {
            const double middle = 0.5 * (ends[0][axis] + ends[1][axis]);
            const double integral = length / 6.0 *
                                    (ends[0][axis] * (2.0 * depth[0] + depth[1]) +
                                     ends[1][axis] * (depth[0] + 2.0 * depth[1]));
            ck_assert_near(moment[axis], sample.family->point ? middle * area : integral,
                           40.0 * ROUND_OFF);
        }
        const struct mpm_edge_line line =
            mpm_edge_find(sample.family, &sample.grid, &sample.domain, sample.edge);
        ck_assert_near(mpm_edge_area(&sample.grid, &line, DEPTH), area, ROUND_OFF);
    }
    g_rand_free(random);
}
END_TEST

START_TEST(an_edge_reaches_no_node_that_the_particle_does_not)
{
    GRand *const random = g_rand_new_with_seed(4711 + (guint32)_i);
    for (int k = 0; k < SAMPLES; k++) {
        const struct sample sample = draw(random, _i);
        const struct mpm_edge_weights weights = weights_of(&sample);
        struct mpm_stencil stencil;
        sample.family->evaluate(&sample.grid, &sample.domain, &stencil);
        for (int n = 0; n < weights.count; n++) {
            bool found = false;
            for (int i = 0; i < stencil.count; i++)
                found |= stencil.node[i].node == weights.entry[n].node;
            ck_assert(found);
        }
    }
    g_rand_free(random);
}
END_TEST

/* Two places of a spline's particle, 2e-9 of a cell apart, with a knot between them: no weight
 * jumps. Weights are of order 10 and their slopes of order 100; a jump of the polynomials' last
 * term is of order 1. */
START_TEST(weights_of_an_edge_on_splines_do_not_jump_where_the_particle_passes_a_knot)
{
    static const enum mpm_shape shapes[] = {MPM_BSPLINE2, MPM_BSPLINE3};
    GRand *const random = g_rand_new_with_seed(99);
    for (int k = 0; k < SAMPLES; k++) {
        struct sample sample = draw(random, _i);
        const int axis = k % 2, shape = k / 2 % 2;
        const double knot = g_rand_int_range(random, 1, 7) + (shape == 0 ? 0.5 : 0.0);
        struct mpm_edge_weights weights[2];
        sample.family = mpm_shape_family(shapes[shape]);
        for (int side = 0; side < 2; side++) {
            sample.domain.position[axis] =
                sample.grid.origin[axis] +
                (knot + (side == 0 ? -1e-9 : 1e-9)) / sample.grid.inverse_cell[axis];
            weights[side] = weights_of(&sample);
        }
        for (int side = 0; side < 2; side++)
            for (int n = 0; n < weights[side].count; n++) {
                const int64_t node = weights[side].entry[n].node;
                ck_assert_near(weight_of(&weights[0], node), weight_of(&weights[1], node), 1e-6);
            }
    }
    g_rand_free(random);
}
END_TEST

/* N&G (44), (48): what begins on the axis has no inner edge; (45), (47): a square of 2 l from 0 to
 * 2 l gives 2 l^2/3 and 4 l^2/3 to the nodes of its corners, two cells of l away. */
START_TEST(an_edge_on_the_axis_has_no_area_and_one_that_leaves_it_is_weighted_with_r)
{
    static const double origin[2] = {0.0, 0.0}, cell[2] = {0.5, 0.5};
    static const int64_t cells[2] = {9, 9};
    static const enum mpm_shape domains[] = {MPM_UGIMP, MPM_CPDI};
    for (size_t k = 0; k < G_N_ELEMENTS(domains); k++) {
        struct sample sample = {
            .family = mpm_shape_family(domains[k]),
            .grid = mpm_shape_grid_describe(origin, cell, cells, MPM_AXISYMMETRIC, MPM_TRUNCATED),
            .domain = {{0.5, 1.5}, {0.5, 0.5}, {0.5, 0.0, 0.0, 0.5}},
            .edge = MPM_EDGE_LEFT,
        };
        sample.grid.columns = 1000;
        struct mpm_edge_weights weights = weights_of(&sample);
        ck_assert_int_eq(weights.count, 0);
        sample.edge = MPM_EDGE_TOP;
        weights = weights_of(&sample);
        ck_assert_int_eq(weights.count, 2);
        ck_assert_near(weight_of(&weights, 4000), 0.5 / 3.0, DBL_EPSILON);
        ck_assert_near(weight_of(&weights, 4002), 1.0 / 3.0, DBL_EPSILON);
        sample.edge = MPM_EDGE_RIGHT;
        weights = weights_of(&sample);
        ck_assert_near(weight_of(&weights, 2002), 0.5, DBL_EPSILON);
        ck_assert_near(weight_of(&weights, 4002), 0.5, DBL_EPSILON);
    }
}
END_TEST

Suite *suite_edges(void)
{
    Suite *suite = suite_create("edges");
    TCase *integrals = tcase_create("integrals");
    tcase_add_loop_test(integrals,
                        weights_of_an_edge_are_the_integrals_of_the_nodes_functions_along_it, 0,
                        SHAPES * CASES);
    tcase_add_loop_test(integrals, weights_of_an_edge_have_its_area_and_its_first_moment, 0,
                        SHAPES * CASES);
    tcase_add_loop_test(integrals, an_edge_reaches_no_node_that_the_particle_does_not, 0,
                        SHAPES * CASES);
    tcase_add_loop_test(integrals,
                        weights_of_an_edge_on_splines_do_not_jump_where_the_particle_passes_a_knot,
                        0, SHAPES * CASES);
    tcase_add_test(integrals,
                   an_edge_on_the_axis_has_no_area_and_one_that_leaves_it_is_weighted_with_r);
    suite_add_tcase(suite, integrals);
    return suite;
}

/* Tests of the exact references and the statistics: quadrature of the shape functions against
 * integrals done by hand, radial compression against N&G's numbers and its own energy.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "verification/exact/plastic/compression.h"
#include "verification/exact/shapes/shape_quadrature.h"
#include "verification/measures/fields.h"
#include "verification/measures/shapes/shape_comparison.h"
#include "verification/measures/shapes/shape_identities.h"
#include "verification/measures/shapes/shape_lines.h"
#include "verification/measures/shapes/shape_samples.h"

#include <math.h>

enum { FAMILIES = MPM_SHAPE_COUNT };

/* Sums of a few products of numbers of order one: 16 roundings of eps/2 each. */
static const double ROUND_OFF = 2e-15;

/* --------------------------------------------------------------- quadrature */

/* A domain on cells of 2 x 4 whose half size is a quarter of a cell each way. */
static struct mpm_shape_query query_at(enum mpm_shape shape, enum mpm_geometry geometry,
                                       enum mpm_axis axis, double x, double y)
{
    return (struct mpm_shape_query){
        .shape = shape,
        .geometry = geometry,
        .axis = axis,
        .origin = {0, 0},
        .cell = {2, 4},
        .position = {2 * x, 4 * y},
        .half_size = {0.5, 1},
        .deformation_gradient = {1, 0, 0, 1},
    };
}

struct hand_case {
    const char *what;
    enum mpm_shape shape;
    enum mpm_geometry geometry;
    enum mpm_axis axis;
    double position[2]; /* in cells */
    int64_t node[2];
    double expected[SHAPE_VALUES]; /* S, G_x dx, G_y dy, T <r> */
};

#define PLANAR MPM_PLANE_STRAIN, MPM_TRUNCATED
#define CUT    MPM_AXISYMMETRIC, MPM_TRUNCATED
#define UNCUT  MPM_AXISYMMETRIC, MPM_UNTRUNCATED
#define FLAT   MPM_AXISYMMETRIC, MPM_PLANAR

/* Axis averages of the hat over [p - 1/4, p + 1/4], with u the distance from the node:
 *   p = 1/2: N is linear there, so 1/2 and slope -1 (node 0), 1/2 and +1 (node 1);
 *   p = 0: 1 - 1/8 and slope 0 (node 0), int_0^{1/4} u du / (1/2) = 1/16 and 1/2 (node 1).
 * With weight r at p = 1/2: <r^2>/<r> = (1/4 + 1/48)/(1/2) = 13/24 is what node 1 gets.
 * At r_p = 1/8, cut to [0, 3/8]: node 1 gets (2/3)(3/8) = 1/4, <r> = 3/16.
 * At r_p = 1/8, not cut, [-1/8, 3/8]: int r dr = 1/16; node -1: -int u^2 = -1/1536, so
 * -1/96; node 1: 9/512 * 16 = 9/32; node 0 the rest. Slopes: N_0 rises below r = 0, where
 * int r dr = -1/128, and falls above, where it is 9/128: (-1/128 - 9/128) 16 = -5/4.
 * CPDI takes N at the corners, p -/+ 1/4; at p = 0 these are 3/4 (node 0).
 * Planar functions at r_p = 1/8: node -1 gets int_0^{1/8} u du / (1/2) = 1/64, slope -1/4.
 * B-splines at the distance d from the node: quadratic 3/4 - d^2 up to 1/2, (3/2 - d)^2/2 beyond;
 * cubic 2/3 - d^2 + d^3/2 up to 1, (2 - d)^3/6 beyond. So 3/4 and 2/3 at 0, slope 0; 1/2 and 23/48
 * at 1/2, slopes -1 and -5/8. Folded at r = 0: quadratic 1 - u at node 0, u at node 1; cubic u -
 * u^3/3 at node 1, 11/24 at u = 1/2, slope 1 - u^2 = 3/4. */
static const struct hand_case HAND_CASES[] = {
    {"classic", MPM_CLASSIC, PLANAR, {0.25, 0.5}, {0, 0}, {0.375, -0.5, -0.75, 0}},
    {"classic hoop", MPM_CLASSIC, CUT, {0.25, 0.5}, {1, 1}, {0.125, 0.5, 0.25, 0.125}},
    {"inside a cell", MPM_UGIMP, PLANAR, {0.5, 0.5}, {0, 0}, {0.25, -0.5, -0.5, 0}},
    {"over a node", MPM_UGIMP, PLANAR, {0, 0.5}, {0, 1}, {0.4375, 0, 0.875, 0}},
    {"beside a node", MPM_UGIMP, PLANAR, {0, 0.5}, {1, 0}, {1. / 32, 0.25, -1. / 16, 0}},
    {"radial", MPM_UGIMP, UNCUT, {0.5, 0.5}, {1, 0}, {13. / 48, 0.5, -13. / 24, 0.25}},
    {"cut, axis node", MPM_UGIMP, CUT, {0.125, 0.5}, {0, 0}, {0.375, -0.5, -0.75, 13. / 32}},
    {"cut, next node", MPM_UGIMP, CUT, {0.125, 0.5}, {1, 0}, {0.125, 0.5, -0.25, 3. / 32}},
    {"cut, past the axis", MPM_UGIMP, CUT, {0.125, 0.5}, {-1, 0}, {0, 0, 0, 0}},
    {"uncut -1", MPM_UGIMP, UNCUT, {0.125, 0.5}, {-1, 0}, {-1. / 192, 0.0625, 1. / 96, 1. / 128}},
    {"uncut 0", MPM_UGIMP, UNCUT, {0.125, 0.5}, {0, 0}, {35. / 96, -0.625, -35. / 48, 27. / 64}},
    {"uncut 1", MPM_UGIMP, UNCUT, {0.125, 0.5}, {1, 0}, {9. / 64, 0.5625, -9. / 32, 9. / 128}},
    {"corners", MPM_CPDI, PLANAR, {0, 0.5}, {0, 0}, {0.375, 0, -0.75, 0}},
    {"corners, next", MPM_CPDI, PLANAR, {0, 0.5}, {1, 0}, {1. / 16, 0.25, -0.125, 0}},
    {"corners, radial", MPM_CPDI, UNCUT, {0.5, 0.5}, {1, 0}, {13. / 48, 0.5, -13. / 24, 0.25}},
    /* shrunk by 1/2 to [0, 1/4]: <r^2>/<r> = (1/64 + 1/192) 8 = 1/6 */
    {"shrunk", MPM_CPDI, CUT, {0.125, 0.5}, {1, 0}, {1. / 12, 0.5, -1. / 6, 1. / 16}},
    {"flat", MPM_UGIMP, FLAT, {0.125, 0.5}, {-1, 0}, {1. / 128, -0.125, -1. / 64, 1. / 128}},
    {"flat, corners", MPM_CPDI, FLAT, {0.5, 0.5}, {1, 0}, {0.25, 0.5, -0.5, 0.25}},
    {"quadratic", MPM_BSPLINE2, PLANAR, {0, 0.5}, {0, 0}, {0.375, 0, -0.75, 0}},
    {"quadratic, axis", MPM_BSPLINE2, CUT, {0.25, 0.5}, {0, 0}, {0.375, -0.5, -0.75, 0.375}},
    {"quadratic, beyond", MPM_BSPLINE2, UNCUT, {0.25, 0.5}, {-1, 0}, {0, 0, 0, 0}},
    {"cubic", MPM_BSPLINE3, PLANAR, {0, 0.5}, {0, 0}, {23. / 72, 0, -5. / 12, 0}},
    {"cubic, axis",
     MPM_BSPLINE3,
     UNCUT,
     {0.5, 0.5},
     {1, 0},
     {253. / 1152, 23. / 64, -55. / 192, 253. / 1152}},
};

START_TEST(quadrature_agrees_with_integrals_done_by_hand)
{
    const struct hand_case *hand = &HAND_CASES[_i];
    const struct mpm_shape_query query =
        query_at(hand->shape, hand->geometry, hand->axis, hand->position[0], hand->position[1]);
    struct shape_quadrature *quadrature = shape_quadrature_create();
    struct shape_domain domain;
    struct shape_reference reference;
    ck_assert_msg(shape_quadrature_prepare(quadrature, &query, &domain), "%s", hand->what);
    ck_assert_msg(shape_quadrature_node(quadrature, hand->node[0], hand->node[1], &reference), "%s",
                  hand->what);
    for (size_t i = 0; i < SHAPE_VALUES; i++) {
        ck_assert_msg(fabs(reference.value[i] - hand->expected[i]) < ROUND_OFF,
                      "%s: value %zu is %.17g, by hand %.17g", hand->what, i, reference.value[i],
                      hand->expected[i]);
        ck_assert_double_le(reference.estimate[i], 1e-13);
    }
    shape_quadrature_free(quadrature);
}
END_TEST

START_TEST(edges_of_a_turned_domain_are_measured_in_the_cells_they_point_along)
{
    /* A quarter turn: d1 = (0, 0.5) is 1/8 of the cell's height, d2 = (-1, 0) half its
     * width; a formula with the other axis' cell would give 1/4 and 1/4. */
    struct mpm_shape_query query = query_at(MPM_CPDI, PLANAR, 0, 0);
    const double quarter_turn[4] = {0, -1, 1, 0};
    for (size_t i = 0; i < 4; i++) {
        query.deformation_gradient[i] = quarter_turn[i];
    }
    struct shape_quadrature *quadrature = shape_quadrature_create();
    struct shape_domain domain;
    struct shape_reference reference;
    ck_assert(shape_quadrature_prepare(quadrature, &query, &domain));
    ck_assert(shape_quadrature_node(quadrature, 0, 0, &reference));
    ck_assert_double_eq_tol(reference.value[SHAPE_S], 0.5 * 0.875, ROUND_OFF);
    ck_assert(shape_quadrature_node(quadrature, 1, 1, &reference));
    ck_assert_double_eq_tol(reference.value[SHAPE_S], 0.25 * 0.0625, ROUND_OFF);
    shape_quadrature_free(quadrature);
}
END_TEST

START_TEST(a_domain_shrinks_by_its_furthest_corner_whatever_the_signs)
{
    /* d1r = 0.3, d2r = -0.3 cells around r = 0.3: |d1r + d2r| = 0 would not shrink it. */
    struct mpm_shape_query query = query_at(MPM_CPDI, CUT, 0.3, 0.5);
    query.deformation_gradient[0] = 1.2;
    query.deformation_gradient[1] = -0.6;
    struct shape_quadrature *quadrature = shape_quadrature_create();
    struct shape_domain domain;
    struct shape_reference reference;
    ck_assert(shape_quadrature_prepare(quadrature, &query, &domain));
    ck_assert(!domain.crosses_axis);
    double second_moment = 0; /* sum r_i S = <r^2>/<r> with both edges halved */
    for (int64_t row = domain.first[1]; row <= domain.last[1]; row++) {
        for (int64_t column = domain.first[0]; column <= domain.last[0]; column++) {
            ck_assert(shape_quadrature_node(quadrature, column, row, &reference));
            second_moment += (double)column * reference.value[SHAPE_S];
        }
    }
    ck_assert_double_eq_tol(second_moment, (0.09 + 2 * 0.15 * 0.15 / 3) / 0.3, ROUND_OFF);
    shape_quadrature_free(quadrature);
}
END_TEST

START_TEST(the_window_holds_every_node_reached_and_a_ring_around_them)
{
    static const double positions[] = {0.1, 0.25, 0.5, 0.75, 1, 3.3};
    const double position = positions[_i % 6];
    const struct mpm_shape_query query =
        query_at((enum mpm_shape)(_i / 6), PLANAR, position, position);
    struct shape_quadrature *quadrature = shape_quadrature_create();
    struct shape_domain domain;
    struct shape_reference reference;
    ck_assert(shape_quadrature_prepare(quadrature, &query, &domain));
    double sum = 0;
    for (int64_t row = domain.first[1]; row <= domain.last[1]; row++) {
        for (int64_t column = domain.first[0]; column <= domain.last[0]; column++) {
            ck_assert(shape_quadrature_node(quadrature, column, row, &reference));
            const bool ring = row == domain.first[1] || row == domain.last[1] ||
                              column == domain.first[0] || column == domain.last[0];
            ck_assert(!ring || reference.depth <= 0);
            sum += reference.value[SHAPE_S];
        }
    }
    ck_assert_double_eq_tol(sum, 1, ROUND_OFF);
    shape_quadrature_free(quadrature);
}
END_TEST

START_TEST(domains_that_make_no_sense_are_refused)
{
    struct mpm_shape_query queries[5];
    for (size_t i = 0; i < 5; i++) {
        queries[i] = query_at(MPM_UGIMP, UNCUT, 0.5, 0.5);
    }
    queries[0].position[1] = (double)NAN;
    queries[1].cell[0] = 0;
    queries[2].half_size[1] = 4.1;
    queries[3].position[0] = 0;
    queries[4].shape = MPM_CPDI;
    queries[4].deformation_gradient[3] = (double)INFINITY;
    struct shape_quadrature *quadrature = shape_quadrature_create();
    struct shape_domain domain;
    for (size_t i = 0; i < 5; i++) {
        ck_assert_msg(!shape_quadrature_prepare(quadrature, &queries[i], &domain), "%zu", i);
    }
    shape_quadrature_free(quadrature);
}
END_TEST

/* ---------------------------------------------------- the solver's functions */

enum { SPOT_CHECKS = 40, VARIANTS = 3 * FAMILIES };

/* Each family by planar, truncated, untruncated. */
static struct mpm_shape_query variant(int index)
{
    return (struct mpm_shape_query){
        .shape = (enum mpm_shape)(index / 3),
        .geometry = index % 3 == 0 ? MPM_PLANE_STRAIN : MPM_AXISYMMETRIC,
        .axis = index % 3 == 1 ? MPM_TRUNCATED : MPM_UNTRUNCATED,
    };
}

START_TEST(the_solvers_shape_functions_agree_with_their_quadrature)
{
    const struct mpm_shape_query kind = variant(_i % VARIANTS);
    struct shape_sampler *sampler = shape_sampler_create(7);
    struct shape_quadrature *quadrature = shape_quadrature_create();
    struct shape_comparison comparison = {0};
    for (size_t i = 0; i < SPOT_CHECKS; i++) {
        struct mpm_shape_query query;
        shape_sampler_draw(sampler, &kind, (enum shape_region)(_i / VARIANTS), &query);
        ck_assert(shape_comparison_add(&comparison, quadrature, &query));
    }
    ck_assert_double_le(shape_comparison_error(&comparison), 1e-12);
    ck_assert_double_le(shape_comparison_estimate(&comparison), 1e-13);
    ck_assert_uint_eq(comparison.strays, 0);
    ck_assert_uint_gt(comparison.nodes_outside, SPOT_CHECKS);
    shape_quadrature_free(quadrature);
    shape_sampler_free(sampler);
}
END_TEST

START_TEST(the_solvers_shape_functions_keep_their_identities)
{
    const struct mpm_shape_query kind = variant(_i % VARIANTS);
    struct shape_sampler *sampler = shape_sampler_create(7);
    struct shape_residuals residuals = {0};
    for (size_t i = 0; i < SPOT_CHECKS; i++) {
        struct mpm_shape_query query;
        shape_sampler_draw(sampler, &kind, (enum shape_region)(_i / VARIANTS), &query);
        shape_residuals_add(&residuals, &query);
    }
    /* 16 entries, each moved by up to 330 eps (case S2). */
    ck_assert_double_le(field_maximum(residuals.residual, 1, SHAPE_IDENTITY_COUNT), 1.2e-12);
    shape_sampler_free(sampler);
}
END_TEST

START_TEST(the_same_seed_draws_the_same_domains)
{
    const struct mpm_shape_query kind = variant(8);
    struct shape_sampler *one = shape_sampler_create(3), *two = shape_sampler_create(3);
    for (int region = 0; region < SHAPE_REGION_COUNT; region++) {
        struct mpm_shape_query a, b;
        shape_sampler_draw(one, &kind, (enum shape_region)region, &a);
        shape_sampler_draw(two, &kind, (enum shape_region)region, &b);
        ck_assert_double_eq(a.position[0], b.position[0]);
        ck_assert_double_eq(a.deformation_gradient[3], b.deformation_gradient[3]);
    }
    shape_sampler_free(one);
    shape_sampler_free(two);
}
END_TEST

START_TEST(the_factor_along_r_is_the_papers)
{
    /* N&G (20), (25), (28) at r = 1/8 of a cell, l_p = 1/2. */
    const struct shape_line line = {MPM_UGIMP, CUT, 0.5, false};
    const struct shape_line_value value = shape_line_at(&line, 0, 0.125);
    ck_assert_double_eq_tol(value.s, 0.75, ROUND_OFF);
    ck_assert_double_eq_tol(value.ds, -0.5, ROUND_OFF);
    ck_assert_double_eq_tol(value.t, 13. / 3, 4 * ROUND_OFF);
    ck_assert_double_eq(shape_line_at(&line, -1, 0.125).s, 0);
}
END_TEST

/* -------------------------------------------------------------- compression */

/* N&G 4.1, MPa. */
static const struct compression_material POLYMER = {.bulk = 2254.9, .shear = 864.662};

START_TEST(sixty_percent_radial_compression_leaves_sixteen_percent_of_the_volume)
{
    const double j = compression_relative_volume(-0.6);
    ck_assert_double_eq_tol(j, 0.16, ROUND_OFF);
    ck_assert_double_eq_tol(compression_radial_strain(j), -0.6, ROUND_OFF);
    /* By hand: -5.25 (1307.842 + 977.938) and -5.25 (1307.842 - 1955.877), to 5 digits. */
    const struct compression_stress stress = compression_stress(&POLYMER, j);
    ck_assert_double_eq_tol(stress.rr, -12000.4, 0.3);
    ck_assert_double_eq_tol(stress.zz, 3402.2, 0.3);
    ck_assert_double_eq(stress.tt, stress.rr);
}
END_TEST

START_TEST(stress_is_the_derivative_of_the_energy)
{
    static const double volumes[] = {0.0064, 0.16, 0.5, 0.99, 1.5};
    const double j = volumes[_i], radial = sqrt(j);
    const struct compression_stress stress = compression_stress(&POLYMER, j);
    const double expected[3] = {stress.rr, stress.zz, stress.tt};
    for (size_t k = 0; k < 3; k++) {
        double above[3] = {radial, 1, radial}, below[3] = {radial, 1, radial};
        const double step = 1e-5 * above[k];
        above[k] += step;
        below[k] -= step;
        const double slope =
            (compression_energy(&POLYMER, above) - compression_energy(&POLYMER, below)) /
            (2 * step);
        const double cauchy = slope * (k == 1 ? 1 : radial) / j;
        /* Central differences: (1e-5)^2 times a third derivative of order ten, and
         * eps/1e-5 of rounding, both relative to the energy's scale over J. */
        ck_assert_double_eq_tol(cauchy, expected[k], 1e-8 * POLYMER.bulk / j);
    }
}
END_TEST

START_TEST(an_undeformed_disk_has_no_stress_and_no_energy)
{
    const double stretch[3] = {1, 1, 1};
    ck_assert_double_eq(compression_energy(&POLYMER, stretch), 0);
    ck_assert_double_eq(compression_stress(&POLYMER, 1).rr, 0);
    ck_assert_double_eq(compression_stress(&POLYMER, 1).zz, 0);
}
END_TEST

/* -------------------------------------------------------------------- fields */

START_TEST(statistics_of_a_strided_field_use_its_own_component_only)
{
    const double field[] = {2, 100, 4, 100, 6, 100};
    ck_assert_double_eq(field_mean(field, 2, 3), 4);
    ck_assert_double_eq_tol(field_standard_deviation(field, 2, 3), sqrt(8. / 3), ROUND_OFF);
    ck_assert_double_eq_tol(field_relative_deviation(field, 2, 3), sqrt(8. / 3) / 4, ROUND_OFF);
    ck_assert_double_eq(field_relative_maximum(field, 2, 3, -4), 2.5);
    ck_assert_double_eq(field_maximum(field, 2, 3), 6);
    ck_assert_double_eq(field_standard_deviation(field, 2, 1), 0);
}
END_TEST

START_TEST(a_nan_anywhere_makes_every_statistic_nan)
{
    double field[] = {-1, 2, -3};
    field[_i] = (double)NAN;
    ck_assert_double_nan(field_mean(field, 1, 3));
    ck_assert_double_nan(field_standard_deviation(field, 1, 3));
    ck_assert_double_nan(field_relative_deviation(field, 1, 3));
    ck_assert_double_nan(field_relative_maximum(field, 1, 3, 1));
    ck_assert_double_nan(field_maximum(field, 1, 3));
    ck_assert_double_nan(field_larger((double)NAN, 1));
    ck_assert_double_nan(field_larger(1, (double)NAN));
}
END_TEST

START_TEST(the_statistics_of_nothing_are_nan)
{
    ck_assert_double_nan(field_mean(NULL, 1, 0));
    ck_assert_double_nan(field_standard_deviation(NULL, 1, 0));
    ck_assert_double_nan(field_relative_maximum(NULL, 1, 0, 1));
    ck_assert_double_nan(field_maximum(NULL, 1, 0));
}
END_TEST

Suite *suite_exact(void)
{
    Suite *suite = suite_create("exact");
    TCase *quadrature = tcase_create("shape quadrature");
    tcase_add_loop_test(quadrature, quadrature_agrees_with_integrals_done_by_hand, 0,
                        sizeof HAND_CASES / sizeof *HAND_CASES);
    tcase_add_test(quadrature, edges_of_a_turned_domain_are_measured_in_the_cells_they_point_along);
    tcase_add_test(quadrature, a_domain_shrinks_by_its_furthest_corner_whatever_the_signs);
    tcase_add_loop_test(quadrature, the_window_holds_every_node_reached_and_a_ring_around_them, 0,
                        6 * FAMILIES);
    tcase_add_test(quadrature, domains_that_make_no_sense_are_refused);
    suite_add_tcase(suite, quadrature);
    TCase *solver = tcase_create("shape functions");
    tcase_add_loop_test(solver, the_solvers_shape_functions_agree_with_their_quadrature, 0,
                        SHAPE_REGION_FAR_ANYWHERE * VARIANTS);
    tcase_add_loop_test(solver, the_solvers_shape_functions_keep_their_identities, 0,
                        SHAPE_REGION_FAR_ANYWHERE * VARIANTS);
    tcase_add_test(solver, the_same_seed_draws_the_same_domains);
    tcase_add_test(solver, the_factor_along_r_is_the_papers);
    suite_add_tcase(suite, solver);
    TCase *compression = tcase_create("radial compression");
    tcase_add_test(compression,
                   sixty_percent_radial_compression_leaves_sixteen_percent_of_the_volume);
    tcase_add_loop_test(compression, stress_is_the_derivative_of_the_energy, 0, 5);
    tcase_add_test(compression, an_undeformed_disk_has_no_stress_and_no_energy);
    suite_add_tcase(suite, compression);
    TCase *fields = tcase_create("fields");
    tcase_add_test(fields, statistics_of_a_strided_field_use_its_own_component_only);
    tcase_add_loop_test(fields, a_nan_anywhere_makes_every_statistic_nan, 0, 3);
    tcase_add_test(fields, the_statistics_of_nothing_are_nan);
    suite_add_tcase(suite, fields);
    return suite;
}

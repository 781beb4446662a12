/* How far the domain of a particle goes along a line through a node.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_edges.h"
#include "suites.h"
#include "support/near.h"

#include <glib.h>
#include <math.h>

/* Some ten operations with numbers up to 4: about 40 eps. */
static const double ROUND_OFF = 1e-14;

struct found {
    double nearest, beside;
};

static double height(const double x[2], const double n[2])
{
    return n[0] * x[0] + n[1] * x[1] + MPM_EDGE_SLOPE * fabs(n[0] * x[1] - n[1] * x[0]);
}

static double beside_of(const double x[2], const double n[2])
{
    return n[0] * x[1] - n[1] * x[0];
}

/* By definition: the expression is linear on both sides of the line, so that it is least at a
 * corner or where an edge of the domain crosses the line. */
static struct found by_corners(const double edge[4], const double from[2], const double n[2])
{
    static const double signs[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
    struct found found = {HUGE_VAL, HUGE_VAL};
    double corners[4][2];
    for (int k = 0; k < 4; k++)
        for (int axis = 0; axis < 2; axis++)
            corners[k][axis] = from[axis] + signs[k][0] * edge[axis] + signs[k][1] * edge[2 + axis];
    for (int k = 0; k < 4; k++) {
        const double *const one = corners[k], *const next = corners[(k + 1) % 4];
        const double a = beside_of(one, n), b = beside_of(next, n);
        found.nearest = fmin(found.nearest, height(one, n));
        found.beside = fmin(found.beside, fabs(a));
        if (!(a * b < 0.0))
            continue;
        const double part = a / (a - b);
        const double crossing[2] = {one[0] + part * (next[0] - one[0]),
                                    one[1] + part * (next[1] - one[1])};
        found.nearest = fmin(found.nearest, n[0] * crossing[0] + n[1] * crossing[1]);
        found.beside = 0.0;
    }
    return found;
}

static void assert_same(const double edge[4], const double from[2], double angle)
{
    const double n[2] = {cos(angle), sin(angle)};
    const struct found expected = by_corners(edge, from, n);
    struct found found;
    found.nearest = mpm_domain_nearest(edge, from, n, &found.beside);
    ck_assert_near(found.nearest, expected.nearest, ROUND_OFF);
    ck_assert_near(found.beside, expected.beside, ROUND_OFF);
}

/* Squares, sheared and flat domains, and points; all turns; beside the line, across it, and with
 * the node inside. */
static const double domains[][4] = {
    {0.25, 0.0, 0.0, 0.25}, {0.3, 0.1, -0.2, 0.25}, {0.9, 0.7, 0.1, 0.3}, {0.5, 0.5, -0.01, 0.01},
    {0.0, 0.25, 0.25, 0.0}, {0.4, 0.0, 0.0, 0.0},   {0.0, 0.0, 0.0, 0.0},
};

START_TEST(the_edge_of_a_domain_is_at_a_corner_or_where_the_line_crosses_it)
{
    GRand *const random = g_rand_new_with_seed(17);
    for (int k = 0; k < 2000; k++) {
        const double from[2] = {g_rand_double_range(random, -1.5, 1.5),
                                g_rand_double_range(random, -1.5, 1.5)};
        assert_same(domains[_i], from, g_rand_double_range(random, 0.0, 7.0));
    }
    g_rand_free(random);
    for (int k = 0; k < 16; k++)
        for (int place = -4; place <= 4; place++)
            assert_same(domains[_i], (const double[2]){0.25 * place, 0.5}, 0.125 * G_PI * k);
}
END_TEST

Suite *suite_contact_edges(void)
{
    Suite *const suite = suite_create("contact_edges");
    TCase *const group = tcase_create("edges");
    tcase_add_loop_test(group, the_edge_of_a_domain_is_at_a_corner_or_where_the_line_crosses_it, 0,
                        (int)G_N_ELEMENTS(domains));
    suite_add_tcase(suite, group);
    return suite;
}

/* Logistic regression: the plane of the least sum, whatever the points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/logistic_plane.h"
#include "suites.h"
#include "support/near.h"

#include <math.h>

/* As many particles as meet at a node, four by four in a cell, and as many steps as a run takes. */
enum { POINTS = 64, STEPS = 200 };

struct point {
    double t[3], sign, weight;
};

/* From 0 to 1, the same on every machine. */
static double draw(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (double)(*seed >> 8) / 16777216.0;
}

/* Where two sets of points are, from the line y = slope x + shift on. */
static const struct layout {
    double gap;    /* between the sets; below 0 they overlap */
    int strays;    /* points of the first set that lie this far in the other */
    double beyond; /* ... */
    double light;  /* weights of the second set */
} layouts[] = {
    {0.5, 0, 0.0, 1.0},    /* apart */
    {0.01, 0, 0.0, 1.0},   /* hardly apart */
    {1e-6, 0, 0.0, 1e-3},  /* all but touching, one of them light */
    {-0.3, 0, 0.0, 1.0},   /* overlapping */
    {0.3, 1, 0.31, 1.0},   /* one point is past a gap by a hundredth of a cell */
    {0.3, 1, 0.3001, 1.0}, /* by a ten-thousandth */
    {0.5, 2, 2.0, 1.0},    /* two of them far behind the others */
    {0.1, 1, 1.5, 1e-4},   /* behind those of a light set */
};
enum { LAYOUTS = sizeof layouts / sizeof *layouts, DRAWS = 60 };

static void place(const struct layout *layout, unsigned seed, struct point points[POINTS])
{
    const double slope = 4.0 * draw(&seed) - 2.0, shift = 2.0 * draw(&seed) - 1.0;
    for (int k = 0; k < POINTS; k++) {
        struct point *const point = &points[k];
        const bool second = k % 2 == 1;
        const double away = 0.5 * layout->gap + 1.5 * draw(&seed);
        const double x = 4.0 * draw(&seed) - 2.0;
        const double up = second ? away : k / 2 < layout->strays ? layout->beyond : -away;
        *point = (struct point){{1.0, x, slope * x + shift + up * hypot(1.0, slope)},
                                second ? 1.0 : -1.0,
                                second ? 0.0625 * layout->light : 0.0625};
    }
}

/* f as its definition has it. */
static double sum(const struct point points[POINTS], const double c[3])
{
    double f = 0.5e-7 * (c[1] * c[1] + c[2] * c[2]);
    for (int k = 0; k < POINTS; k++) {
        const double *const t = points[k].t;
        const double by = -points[k].sign * (c[0] + c[1] * t[1] + c[2] * t[2]);
        f += points[k].weight * (by > 30.0 ? by + exp(-by) : log1p(exp(by)));
    }
    return f;
}

static struct mpm_logistic_plane find(const struct point points[POINTS], const double start[3])
{
    struct mpm_logistic_plane plane = mpm_logistic_begin(start);
    for (int step = 0; step < STEPS && plane.moves; step++) {
        for (int k = 0; k < POINTS; k++)
            mpm_logistic_add(&plane, points[k].t, points[k].sign, points[k].weight);
        mpm_logistic_step(&plane);
    }
    return plane;
}

/* A thousandth of c, either way along each axis: f is convex, so what is least there is least. */
START_TEST(the_plane_has_the_least_sum_wherever_the_points_are)
{
    for (unsigned k = 0; k < DRAWS; k++) {
        struct point points[POINTS];
        place(&layouts[_i], 7u * k + 1u, points);
        const struct mpm_logistic_plane plane = find(points, (const double[3]){0.0, 0.1, 0.5});
        const double least = sum(points, plane.c);
        ck_assert_msg(!plane.moves, "draw %u: no plane after %d steps", k, STEPS);
        const double size = 1e-3 * (fabs(plane.c[0]) + fabs(plane.c[1]) + fabs(plane.c[2]));
        for (int axis = 0; axis < 3; axis++)
            for (int way = -1; way <= 1; way += 2) {
                double c[3] = {plane.c[0], plane.c[1], plane.c[2]};
                c[axis] += way * size;
                ck_assert_msg(sum(points, c) > least, "draw %u: less beside (%g, %g, %g)", k,
                              plane.c[0], plane.c[1], plane.c[2]);
            }
    }
}
END_TEST

/* From wherever it begins: a first guess with the wrong sign, or far too steep. */
START_TEST(the_plane_does_not_depend_on_the_first_guess)
{
    static const double starts[][3] = {
        {0.0, 0.0, 0.0}, {3.0, -5.0, -5.0}, {-40.0, 30.0, 20.0}, {3000.0, -2000.0, -2200.0}};
    for (unsigned k = 0; k < DRAWS; k++) {
        struct point points[POINTS];
        place(&layouts[_i], 7u * k + 1u, points);
        const struct mpm_logistic_plane first = find(points, (const double[3]){0.0, 0.1, 0.5});
        for (int start = 0; start < 4; start++) {
            const struct mpm_logistic_plane other = find(points, starts[start]);
            const double steep = hypot(first.c[1], first.c[2]);
            ck_assert(!other.moves);
            for (int axis = 0; axis < 3; axis++)
                ck_assert_near(other.c[axis], first.c[axis], 1e-7 * steep);
        }
    }
}
END_TEST

/* Found by search: sets that a line separates, light points among heavy ones. From the plane of
 * linear regression on whole steps go round in circles, up to 40 a way. */
START_TEST(steps_that_would_go_round_in_circles_are_halved)
{
    static const double places[2][6][4] = {
        {{-0.375, -1.125, 1.0, 0.25},
         {-0.875, -0.875, -1.0, 0.25},
         {-0.875, 0.625, -1.0, 0.25},
         {0.875, 1.125, -1.0, 1e-3},
         {-0.375, 1.125, -1.0, 0.25},
         {1.625, -0.625, 1.0, 1e-3}},
        {{-1.125, 1.375, -1.0, 1e-3},
         {-0.125, -1.125, 1.0, 1e-3},
         {-1.125, -1.125, 1.0, 0.25},
         {-0.625, 1.375, 1.0, 1e-3},
         {-0.375, -0.125, 1.0, 0.25},
         {0.625, 1.375, 1.0, 0.25}},
    };
    static const double starts[2][3] = {{0.68710685, 1.97033756, -0.61377526},
                                        {0.99864507, 0.00249877, -0.00177306}};
    struct point points[POINTS] = {{{0.0}, 1.0, 0.0}};
    for (int k = 0; k < 6; k++) {
        const double *const at = places[_i][k];
        points[k] = (struct point){{1.0, at[0], at[1]}, at[2], at[3]};
    }
    for (int k = 6; k < POINTS; k++)
        points[k].sign = 1.0;
    const struct mpm_logistic_plane plane = find(points, starts[_i]);
    ck_assert(!plane.moves);
    for (int k = 0; k < 6; k++) {
        const double *const t = points[k].t;
        ck_assert(points[k].sign * (plane.c[0] + plane.c[1] * t[1] + plane.c[2] * t[2]) > 0.0);
    }
}
END_TEST

/* A body that reaches a node by round-off alone has mass there, and no particle. */
START_TEST(points_of_one_set_have_no_plane)
{
    struct mpm_logistic_plane plane = mpm_logistic_begin((const double[3]){-1.0, 1e-16, 2e-16});
    for (int k = 0; k < POINTS; k++) {
        const int column = k % 8, row = k / 8;
        mpm_logistic_add(&plane, (const double[3]){1.0, 0.25 * column, 0.25 * row},
                         _i == 0 ? -1.0 : 1.0, 0.0625);
    }
    mpm_logistic_step(&plane);
    ck_assert(!plane.moves && plane.c[1] == 0.0 && plane.c[2] == 0.0);
    ck_assert(plane.value == 0.0 && plane.slope[0] == 0.0); /* as after any step */
}
END_TEST

/* Points in rows: the line in the middle between those nearest is the one with the widest gap. */
START_TEST(between_rows_of_points_the_plane_is_in_the_middle)
{
    static const double half_gaps[] = {0.2, 1e-3, 1e-6};
    const double half = half_gaps[_i];
    struct point points[POINTS];
    for (int k = 0; k < POINTS; k++) {
        const int column = k / 2 % 8, row = k / 16;
        const double side = k % 2 == 1 ? 1.0 : -1.0;
        points[k] =
            (struct point){{1.0, 0.25 * column, 0.4 + side * (half + 0.25 * row)}, side, 0.0625};
    }
    const struct mpm_logistic_plane plane = find(points, (const double[3]){0.0, 0.4, 0.5});
    ck_assert(!plane.moves);
    ck_assert_near(plane.c[1] / plane.c[2], 0.0, 1e-9);
    ck_assert_near(-plane.c[0] / plane.c[2], 0.4, 1e-9);
}
END_TEST

Suite *suite_logistic_plane(void)
{
    Suite *suite = suite_create("logistic_plane");
    TCase *planes = tcase_create("planes");
    tcase_add_loop_test(planes, the_plane_has_the_least_sum_wherever_the_points_are, 0, LAYOUTS);
    tcase_add_loop_test(planes, the_plane_does_not_depend_on_the_first_guess, 0, LAYOUTS);
    tcase_add_loop_test(planes, steps_that_would_go_round_in_circles_are_halved, 0, 2);
    tcase_add_loop_test(planes, points_of_one_set_have_no_plane, 0, 2);
    tcase_add_loop_test(planes, between_rows_of_points_the_plane_is_in_the_middle, 0, 3);
    suite_add_tcase(suite, planes);
    return suite;
}

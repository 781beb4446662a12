/* Exact solutions of bodies in contact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "verification/exact/contact/hertz.h"
#include "verification/exact/contact/incline.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

/* Sums of some ten terms of the size of the result. */
static const double ROUNDING = 1e-14;

/* ------------------------------------------------------------------ incline */

START_TEST(friction_and_pressure_of_an_incline_balance_the_weight)
{
    static const double inertia[] = {0.5, 0.4}; /* disk, sphere */
    const double k = inertia[_i], radius = 3.0;
    for (int step = 1; step < 17; step++) {
        const struct incline incline = {9.81, step * PI / 36.0, 0.3, 0.35};
        const struct incline_motion motion = incline_round(&incline, k, radius);
        const double friction = 9.81 * sin(incline.angle) - motion.acceleration; /* over m */
        const double pressure = 9.81 * cos(incline.angle);
        ck_assert_near(k * radius * motion.spin, friction, ROUNDING * 9.81);
        if (motion.slips)
            ck_assert_near(friction, 0.3 * pressure, ROUNDING * 9.81);
        else
            ck_assert(friction <= 0.35 * pressure);
        if (!motion.slips)
            ck_assert_near(motion.acceleration, motion.spin * radius, ROUNDING * 9.81);
        const struct incline_motion block = incline_block(&incline);
        ck_assert_near(9.81 * sin(incline.angle) - block.acceleration,
                       block.slips ? 0.3 * pressure : 9.81 * sin(incline.angle), ROUNDING * 9.81);
    }
}
END_TEST

START_TEST(a_disk_rolls_up_to_three_times_the_friction_and_a_sphere_to_three_and_a_half)
{
    static const double inertia[] = {0.5, 0.4}, times[] = {3.0, 3.5};
    for (int side = -1; side <= 1; side += 2) {
        const struct incline incline = {1.0, atan(0.2 * times[_i] * (1.0 + 1e-9 * side)), 0.2, 0.2};
        const struct incline_motion motion = incline_round(&incline, inertia[_i], 2.0);
        ck_assert(motion.slips == (side > 0));
        /* rolling and sliding meet there */
        ck_assert_near(motion.acceleration, sin(incline.angle) / (1.0 + inertia[_i]), 1e-8);
        ck_assert_near(motion.spin, motion.acceleration / 2.0, 1e-8);
    }
}
END_TEST

START_TEST(a_block_is_held_up_to_its_static_friction)
{
    struct incline incline = {1.0, atan(0.5) - 1e-9, 0.3, 0.5};
    ck_assert(!incline_block(&incline).slips && incline_block(&incline).acceleration == 0.0);
    incline.angle += 2e-9;
    ck_assert(incline_block(&incline).slips && incline_block(&incline).acceleration > 0.17);
}
END_TEST

/* -------------------------------------------------------------------- Hertz */

static const struct hertz sphere = {
    .radius = 8.0, .young = 90.0, .poisson = 0.25, .mass = 7.0, .speed = 0.3};

/* The surface's displacement at r < a under p0 sqrt(1 - s^2/a^2), by rings about that place: with w
 * counted along the ray at the angle phi from the foot of the centre, p0/a sqrt(A - w^2), A = a^2 -
 * r^2 sin^2 phi, is integrated over w = sqrt(A) sin(theta). Midpoint rule: n^-2. */
static double displacement_at(double r, double a, double pressure, double modulus)
{
    enum { RAYS = 400, PLACES = 200 };
    double sum = 0.0;
    for (int ray = 0; ray < RAYS; ray++) {
        const double phi = 2.0 * PI * (ray + 0.5) / RAYS;
        const double chord = sqrt(a * a - r * r * sin(phi) * sin(phi));
        const double from = asin(r * cos(phi) / chord), step = (0.5 * PI - from) / PLACES;
        for (int place = 0; place < PLACES; place++) {
            const double c = chord * cos(from + (place + 0.5) * step);
            sum += pressure / a * c * c * step * 2.0 * PI / RAYS;
        }
    }
    return sum / (PI * modulus);
}

START_TEST(hertz_pressure_flattens_the_sphere)
{
    const double indentation = 0.2, a = hertz_radius(&sphere, indentation);
    const double r = a * 0.2 * _i;
    ck_assert_near(
        displacement_at(r, a, hertz_pressure(&sphere, indentation), hertz_modulus(&sphere)),
        indentation - r * r / (2.0 * sphere.radius), 2e-5 * indentation);
}
END_TEST

START_TEST(hertz_force_is_the_sum_of_the_pressure)
{
    const double indentation = 0.2, a = hertz_radius(&sphere, indentation);
    const double p0 = hertz_pressure(&sphere, indentation);
    ck_assert_near(hertz_force(&sphere, indentation), 2.0 / 3.0 * PI * a * a * p0,
                   ROUNDING * hertz_force(&sphere, indentation));
}
END_TEST

START_TEST(plates_press_a_small_contact_as_hertz_has_it)
{
    double before = 1.0;
    for (double a = 0.8; a > 0.02; a /= 2.0) {
        const double off = 1.0 - hertz_plates_indentation(&sphere, a) * sphere.radius / (a * a);
        ck_assert(off > 0.0);
        if (a < 0.8) /* first order in a/R */
            ck_assert_near(off, before / 2.0, 1e-12);
        before = off;
        ck_assert_near(hertz_plates_radius(&sphere, hertz_plates_indentation(&sphere, a)), a,
                       1e-12 * a);
    }
    /* 4/(3 pi) (1 + nu)(3 - 2 nu)/(4 (1 - nu^2)) a/R */
    ck_assert_near(before, 4.0 / (3.0 * PI) * 1.25 * 2.5 / (4.0 * 0.9375) * 0.025 / 8.0, 1e-12);
}
END_TEST

START_TEST(an_impact_is_over_when_its_equation_of_motion_says_so)
{
    const double duration = hertz_duration(&sphere), deepest = hertz_deepest(&sphere);
    /* delta^(3/2) at the start: Runge and Kutta's error falls with n^-2.5 only */
    ck_assert_near(hertz_indentation_at(&sphere, 0.5 * duration, 2000), deepest, 1e-8 * deepest);
    for (int k = 1; k < 5; k++)
        ck_assert_near(hertz_indentation_at(&sphere, 0.1 * k * duration, 2000),
                       hertz_indentation_at(&sphere, (1.0 - 0.1 * k) * duration, 2000),
                       1e-7 * deepest);
    ck_assert_near(hertz_indentation_at(&sphere, duration * (1.0 - 1e-12), 2000), 0.0,
                   1e-7 * deepest);
    ck_assert(hertz_indentation_at(&sphere, duration, 10) == 0.0);
    /* the form with 2.868 of handbooks */
    const double modulus = hertz_modulus(&sphere);
    ck_assert_near(duration,
                   2.868 * pow(49.0 / (sphere.radius * modulus * modulus * sphere.speed), 0.2),
                   2e-4 * duration);
}
END_TEST

Suite *suite_contact_solutions(void)
{
    Suite *suite = suite_create("contact_solutions");
    TCase *incline = tcase_create("incline");
    tcase_add_loop_test(incline, friction_and_pressure_of_an_incline_balance_the_weight, 0, 2);
    tcase_add_loop_test(
        incline, a_disk_rolls_up_to_three_times_the_friction_and_a_sphere_to_three_and_a_half, 0,
        2);
    tcase_add_test(incline, a_block_is_held_up_to_its_static_friction);
    suite_add_tcase(suite, incline);
    TCase *hertz = tcase_create("hertz");
    tcase_add_loop_test(hertz, hertz_pressure_flattens_the_sphere, 0, 5);
    tcase_add_test(hertz, hertz_force_is_the_sum_of_the_pressure);
    tcase_add_test(hertz, plates_press_a_small_contact_as_hertz_has_it);
    tcase_add_test(hertz, an_impact_is_over_when_its_equation_of_motion_says_so);
    suite_add_tcase(suite, hertz);
    return suite;
}

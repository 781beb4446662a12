/* Tests of the exact references for waves and modes: roots of the breathing modes against an
 * evaluation of their own, waves of a step, the spinning disk.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "verification/exact/spinning_disk.h"
#include "verification/exact/waves/radial_mode.h"
#include "verification/exact/waves/step_wave.h"

#include <glib.h>
#include <math.h>
#include <stddef.h>

/* ---------------------------------------------------------- breathing modes */

/* J0 and J1 by Bessel's integral, (1/pi) int_0^pi cos(n t - x sin t) dt: the trapezoidal rule
 * is exact to round-off for a periodic entire function once n + x is below the points. */
static double bessel(int n, double x)
{
    enum { POINTS = 64 };
    double sum = 0.0;
    for (int k = 0; k < POINTS; k++) {
        const double t = G_PI * (k + 0.5) / POINTS;
        sum += cos(n * t - x * sin(t));
    }
    return sum / POINTS;
}

static const struct radial_mode_body BODIES[] = {
    {RADIAL_MODE_CYLINDER, 12, 1, 0.3, 1},     {RADIAL_MODE_CYLINDER, 0.5, 200, 0, 8},
    {RADIAL_MODE_CYLINDER, 3, 5, 0.49, 2},     {RADIAL_MODE_THIN_DISK, 12, 1, 0.3, 1},
    {RADIAL_MODE_THIN_DISK, 2, 70, 0.45, 2.7},
};
enum { BODY_COUNT = sizeof BODIES / sizeof BODIES[0], MODES = 5 };

/* sigma_rr at the rim over C k, from J1' = J0 - J1/x */
static double rim_stress(const struct radial_mode_body *body, double x)
{
    const double nu = body->poisson;
    const double kappa = body->kind == RADIAL_MODE_CYLINDER ? nu / (1 - nu) : nu;
    return bessel(0, x) - bessel(1, x) / x + kappa * bessel(1, x) / x;
}

START_TEST(the_rim_of_every_breathing_mode_is_free_and_none_is_left_out)
{
    const struct radial_mode_body *body = &BODIES[_i];
    const double step = 1e-3;
    unsigned found = 0;
    double x = step;
    while (found < MODES) {
        if (rim_stress(body, x) * rim_stress(body, x + step) < 0) {
            double low = x, high = x + step;
            for (int k = 0; k < 60; k++) {
                const double middle = 0.5 * (low + high);
                if (rim_stress(body, low) * rim_stress(body, middle) <= 0)
                    high = middle;
                else
                    low = middle;
            }
            found++;
            ck_assert_double_eq_tol(radial_mode_wave_number(body, found) * body->radius, low,
                                    1e-12 * low);
        }
        x += step;
    }
}
END_TEST

START_TEST(a_breathing_mode_obeys_the_equation_of_motion)
{
    const struct radial_mode_body *body = &BODIES[_i];
    for (unsigned mode = 1; mode <= 3; mode++) {
        const double k = radial_mode_wave_number(body, mode);
        const double omega = radial_mode_frequency(body, k);
        const double nu = body->poisson, e = body->young;
        /* C in Lame's constants, lambda of plane stress 2 G nu/(1 - nu) */
        const double g = e / (2 * (1 + nu));
        const double lambda = body->kind == RADIAL_MODE_CYLINDER
                                  ? e * nu / ((1 + nu) * (1 - 2 * nu))
                                  : 2 * g * nu / (1 - nu);
        const double r = 0.6 * body->radius, d = 1e-4 * body->radius;
        const double u = radial_mode_displacement(k, r);
        const double after = radial_mode_displacement(k, r + d);
        const double before = radial_mode_displacement(k, r - d);
        const double laplacian =
            (after - 2 * u + before) / (d * d) + (after - before) / (2 * d * r) - u / (r * r);
        const double scale = body->density * omega * omega;
        /* differences: (k d)^2/12 of the scale, and 4 eps/(k d)^2 */
        ck_assert_double_eq_tol((lambda + 2 * g) * laplacian / scale, -u, 1e-6);
    }
}
END_TEST

START_TEST(the_series_of_a_mode_is_its_bessel_function)
{
    enum { TERMS = 24 };
    double c[TERMS];
    const double k = 1.7;
    radial_mode_series(k, TERMS, c);
    for (double x = 0.1; x <= 10; x += 0.37) {
        const double r = x / k;
        double sum = 0;
        for (size_t m = TERMS; m-- > 0;)
            sum = sum * r * r + c[m];
        /* terms that sum to I1(10) = 2671 without their signs cancel: eps of that */
        ck_assert_double_eq_tol(sum * r, bessel(1, x), 2e-12);
        ck_assert_double_eq_tol(radial_mode_displacement(k, r), bessel(1, x), 1e-14);
    }
}
END_TEST

START_TEST(there_is_no_mode_before_the_first)
{
    ck_assert_double_nan(radial_mode_wave_number(&BODIES[0], 0));
}
END_TEST

/* ---------------------------------------------------------------- step wave */

/* Ai by its power series, good to 1e-10 for |x| <= 4 */
static double airy(double x)
{
    double f = 0, g = 0, f_term = 1, g_term = x;
    for (int k = 0; k < 40; k++) {
        f += f_term;
        g += g_term;
        f_term *= x * x * x / ((3 * k + 2) * (3 * k + 3));
        g_term *= x * x * x / ((3 * k + 3) * (3 * k + 4));
    }
    return 0.355028053887817 * f - 0.258819403792807 * g;
}

START_TEST(a_dispersed_step_is_the_integral_of_airys_function)
{
    const double h = 1e-3;
    for (double x = -4; x <= 4; x += 0.25) {
        const double slope = (step_wave_dispersed(x + h) - step_wave_dispersed(x - h)) / (2 * h);
        /* differences: h^2/6 of Ai'' = x Ai, 4 0.4/6 1e-6 */
        ck_assert_double_eq_tol(slope, -airy(x), 5e-7);
    }
    ck_assert_double_eq_tol(step_wave_dispersed(0), 1.0 / 3.0, 1e-12);
    ck_assert_double_lt(fabs(step_wave_dispersed(20)), 1e-10);
    /* 1 + |x|^(-3/4) cos(...)/sqrt(pi) far behind */
    ck_assert_double_lt(fabs(step_wave_dispersed(-150) - 1), 0.565 * pow(150, -0.75));
    /* its largest value, at the first zero of Ai, which case W1 states */
    ck_assert_double_eq_tol(step_wave_dispersed(-2.33810741046), 1.27435, 1e-5);
    ck_assert_double_eq_tol(step_wave_dispersed(-0.409602956933), 0.5, 1e-10);
}
END_TEST

START_TEST(a_step_wave_balances_momentum_and_energy)
{
    const struct step_wave wave = {8, 2, 0.25};
    const double c = step_wave_celerity(&wave), p = step_wave_pressure(&wave);
    ck_assert_double_eq(c, 2);
    /* rho V of each length c dt is stopped by p dt; p^2/(2 M) is the kinetic energy before */
    ck_assert_double_eq(p, 2 * 0.25 * c);
    ck_assert_double_eq(p * p / (2 * 8), 0.5 * 2 * 0.25 * 0.25);
    ck_assert_double_eq(step_wave_similarity(&wave, 0.125, 1, 16, 8), 0);
    ck_assert_double_eq_tol(step_wave_similarity(&wave, 0.125, 1, 18, 8), 2 / cbrt(6), 1e-15);
}
END_TEST

/* -------------------------------------------------------------- spinning disk */

START_TEST(a_spinning_disk_grows_as_case_e4_states)
{
    static const struct {
        struct spinning_disk disk;
        double factor; /* of theta^2/2 a step */
    } stated[] = {
        {{SPINNING_DISK_USL, false, 1}, 0},    {{SPINNING_DISK_USL, true, 1}, 1},
        {{SPINNING_DISK_USL, false, 2}, 1},    {{SPINNING_DISK_USL, true, 2}, 2},
        {{SPINNING_DISK_USL, false, 3}, 1},    {{SPINNING_DISK_USF, false, 1}, -2},
        {{SPINNING_DISK_USF, true, 1}, -1},    {{SPINNING_DISK_USF, false, 2}, -1},
        {{SPINNING_DISK_USF, true, 2}, 0},     {{SPINNING_DISK_USAVG, false, 1}, -0.5},
        {{SPINNING_DISK_USAVG, true, 1}, 0.5}, {{SPINNING_DISK_USAVG, false, 2}, 0},
        {{SPINNING_DISK_USAVG, true, 2}, 1},   {{SPINNING_DISK_USAVG, false, 20}, 0},
    };
    const double theta = 0.01;
    for (size_t k = 0; k < sizeof stated / sizeof stated[0]; k++) {
        const double growth = spinning_disk_growth(&stated[k].disk, theta);
        /* the next term is theta^2 of the leading ones, of order 2 */
        ck_assert_msg(fabs(growth / (0.5 * theta * theta) - stated[k].factor) < 1e-3,
                      "row %zu: %g, stated %g", k, growth / (0.5 * theta * theta),
                      stated[k].factor);
    }
}
END_TEST

Suite *suite_modes(void)
{
    Suite *suite = suite_create("modes");
    TCase *radial = tcase_create("breathing modes"), *step = tcase_create("step wave");
    tcase_add_loop_test(radial, the_rim_of_every_breathing_mode_is_free_and_none_is_left_out, 0,
                        BODY_COUNT);
    tcase_add_loop_test(radial, a_breathing_mode_obeys_the_equation_of_motion, 0, BODY_COUNT);
    tcase_add_test(radial, the_series_of_a_mode_is_its_bessel_function);
    tcase_add_test(radial, there_is_no_mode_before_the_first);
    suite_add_tcase(suite, radial);
    tcase_add_test(step, a_dispersed_step_is_the_integral_of_airys_function);
    tcase_add_test(step, a_step_wave_balances_momentum_and_energy);
    suite_add_tcase(suite, step);
    TCase *spin = tcase_create("spinning disk");
    tcase_add_test(spin, a_spinning_disk_grows_as_case_e4_states);
    suite_add_tcase(suite, spin);
    return suite;
}

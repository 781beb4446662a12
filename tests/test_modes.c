/* Tests of the exact references for waves and modes: roots of the breathing modes against an
 * evaluation of their own, the dispersion of a bar against a simulation of its equations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/bar_dispersion.h"
#include "verification/exact/radial_mode.h"
#include "verification/exact/spinning_disk.h"
#include "verification/exact/step_wave.h"

#include <check.h>
#include <math.h>
#include <stddef.h>

Suite *suite_modes(void);

static const double PI = 3.14159265358979323846;

/* ---------------------------------------------------------- breathing modes */

/* J0 and J1 by Bessel's integral, (1/pi) int_0^pi cos(n t - x sin t) dt: the trapezoidal rule
 * is exact to round-off for a periodic entire function once n + x is below the points. */
static double bessel(int n, double x)
{
    enum { POINTS = 64 };
    double sum = 0.0;
    for (int k = 0; k < POINTS; k++) {
        const double t = PI * (k + 0.5) / POINTS;
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

/* --------------------------------------------------------------- dispersion */

enum { CELLS = 12, PARTICLES_MAX = 4 };

/* The tasks of a step written out for a row of particles that stay where they are; nodes 0
 * and CELLS held. */
struct row {
    unsigned n; /* particles a cell */
    double velocity[CELLS * PARTICLES_MAX], strain[CELLS * PARTICLES_MAX];
};

static double place(const struct row *row, size_t p)
{
    return ((double)(p % row->n) + 0.5) / row->n;
}

static void to_nodes(const struct row *row, double v[CELLS + 1])
{
    double mass[CELLS + 1] = {0}, momentum[CELLS + 1] = {0};
    for (size_t p = 0; p < CELLS * row->n; p++) {
        const double x = place(row, p);
        const size_t i = p / row->n;
        mass[i] += 1 - x;
        mass[i + 1] += x;
        momentum[i] += (1 - x) * row->velocity[p];
        momentum[i + 1] += x * row->velocity[p];
    }
    for (size_t i = 0; i <= CELLS; i++)
        v[i] = i == 0 || i == CELLS ? 0 : momentum[i] / mass[i];
}

static void strain_by(struct row *row, const double v[CELLS + 1], double dt)
{
    for (size_t p = 0; p < CELLS * row->n; p++)
        row->strain[p] += dt * (v[p / row->n + 1] - v[p / row->n]);
}

static void advance(struct row *row, enum bar_dispersion_order order, double fraction, double dt)
{
    double v[CELLS + 1], a[CELLS + 1] = {0}, after[CELLS + 1];
    to_nodes(row, v);
    strain_by(row, v,
              order == BAR_DISPERSION_USF     ? dt
              : order == BAR_DISPERSION_USAVG ? 0.5 * dt
                                              : 0);
    for (size_t p = 0; p < CELLS * row->n; p++) {
        a[p / row->n] += row->strain[p] / row->n;
        a[p / row->n + 1] -= row->strain[p] / row->n;
    }
    a[0] = a[CELLS] = 0;
    for (size_t i = 0; i <= CELLS; i++)
        after[i] = v[i] + dt * a[i];
    for (size_t p = 0; p < CELLS * row->n; p++) {
        const double x = place(row, p);
        const size_t i = p / row->n;
        const double flip = row->velocity[p] + dt * ((1 - x) * a[i] + x * a[i + 1]);
        const double pic = (1 - x) * after[i] + x * after[i + 1];
        row->velocity[p] = fraction * flip + (1 - fraction) * pic;
    }
    if (order == BAR_DISPERSION_MUSL || order == BAR_DISPERSION_USAVG)
        to_nodes(row, after);
    strain_by(row, after,
              order == BAR_DISPERSION_USF     ? 0
              : order == BAR_DISPERSION_USAVG ? 0.5 * dt
                                              : dt);
}

/* The amplitudes of three steps in turn obey a'' = T a' - D a. */
START_TEST(the_dispersion_is_that_of_the_tasks_of_a_step)
{
    static const struct {
        unsigned particles;
        double fraction, dt;
    } cases[] = {{2, 1, 0.4}, {2, 0.9, 0.4}, {1, 1, 0.8}, {4, 0.5, 0.1}, {3, 0, 0.3}};
    for (size_t c = 0; c < sizeof cases / sizeof cases[0]; c++) {
        const enum bar_dispersion_order order = (enum bar_dispersion_order)_i;
        struct row row = {.n = cases[c].particles};
        const double k = 2 * PI / CELLS, dt = cases[c].dt;
        double amplitude[4], v[CELLS + 1];
        for (size_t p = 0; p < CELLS * row.n; p++) {
            const double x = place(&row, p);
            const size_t i = p / row.n;
            row.velocity[p] = (1 - x) * sin(k * (double)i) + x * sin(k * (double)(i + 1));
        }
        for (size_t s = 0; s < 4; s++) {
            to_nodes(&row, v);
            amplitude[s] = v[2];
            advance(&row, order, cases[c].fraction, dt);
        }
        const struct bar_dispersion bar = {order, cases[c].particles, cases[c].fraction, 1, 1, dt};
        const struct bar_dispersion_result result = bar_dispersion(&bar, k);
        const double radius = exp(-result.decay * dt);
        const double trace = 2 * radius * cos(result.frequency * dt);
        for (size_t s = 0; s < 2; s++)
            ck_assert_msg(fabs(amplitude[s + 2] - trace * amplitude[s + 1] +
                               radius * radius * amplitude[s]) < 1e-14,
                          "order %d, case %zu, step %zu", _i, c, s);
    }
}
END_TEST

START_TEST(fine_grids_and_steps_give_the_exact_frequency_at_second_order)
{
    for (int order = 0; order < BAR_DISPERSION_ORDERS; order++) {
        const struct bar_dispersion bar = {(enum bar_dispersion_order)order, 2, 1, 3, 0.01, 0.001};
        const double kh = 0.02;
        const double courant = 0.3, error = 1.0 / 24 + 3.0 / 32 - courant * courant / 24;
        const struct bar_dispersion_result result = bar_dispersion(&bar, kh / bar.cell);
        /* the next term is (k h)^2 of this one; for USL (1 - s) q/2 is of fourth order too */
        ck_assert_double_eq_tol(result.frequency / (3 * kh / bar.cell), 1 - kh * kh * error, 1e-7);
    }
}
END_TEST

/* The bar of case E3: 32 cells a wavelength, 80 steps a period. Its bands rest on these. */
START_TEST(the_numbers_that_case_e3_states_are_those_of_the_theory)
{
    static const struct {
        enum bar_dispersion_order order;
        double fraction, frequency, decay; /* % of the exact frequency, % a period */
    } stated[] = {
        {BAR_DISPERSION_USAVG, 1, -0.49559, 0},
        {BAR_DISPERSION_MUSL, 1, -0.49559, 0},
        {BAR_DISPERSION_USF, 1, -0.49559, 0},
        {BAR_DISPERSION_USL, 1, -0.49449, 0.17722},
        {BAR_DISPERSION_USAVG, 0.99, -0.4938, 0.28824},
        {BAR_DISPERSION_MUSL, 0.99, -0.4938, 0.28824},
    };
    for (size_t k = 0; k < sizeof stated / sizeof stated[0]; k++) {
        const struct bar_dispersion bar = {stated[k].order, 2, stated[k].fraction, 1, 1, 0.4};
        const struct bar_dispersion_result result = bar_dispersion(&bar, PI / 16);
        ck_assert_double_eq_tol(100 * (result.frequency / (PI / 16) - 1), stated[k].frequency,
                                1e-5);
        ck_assert_double_eq_tol(100 * 32 * result.decay, stated[k].decay, 1e-5);
    }
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
    TCase *radial = tcase_create("breathing modes"), *bar = tcase_create("dispersion");
    TCase *step = tcase_create("step wave");
    tcase_add_loop_test(radial, the_rim_of_every_breathing_mode_is_free_and_none_is_left_out, 0,
                        BODY_COUNT);
    tcase_add_loop_test(radial, a_breathing_mode_obeys_the_equation_of_motion, 0, BODY_COUNT);
    tcase_add_test(radial, the_series_of_a_mode_is_its_bessel_function);
    tcase_add_test(radial, there_is_no_mode_before_the_first);
    tcase_add_loop_test(bar, the_dispersion_is_that_of_the_tasks_of_a_step, 0,
                        BAR_DISPERSION_ORDERS);
    tcase_add_test(bar, fine_grids_and_steps_give_the_exact_frequency_at_second_order);
    tcase_add_test(bar, the_numbers_that_case_e3_states_are_those_of_the_theory);
    suite_add_tcase(suite, radial);
    suite_add_tcase(suite, bar);
    tcase_add_test(step, a_dispersed_step_is_the_integral_of_airys_function);
    tcase_add_test(step, a_step_wave_balances_momentum_and_energy);
    suite_add_tcase(suite, step);
    TCase *spin = tcase_create("spinning disk");
    tcase_add_test(spin, a_spinning_disk_grows_as_case_e4_states);
    suite_add_tcase(suite, spin);
    return suite;
}

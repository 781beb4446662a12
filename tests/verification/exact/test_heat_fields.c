/* The exact fields of family H against what they must satisfy: the equation of conduction, surface,
 * start, and numbers from elsewhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "verification/exact/heat/heat.h"
#include "verification/exact/heat/heat_edges.h"
#include "verification/exact/heat/uptake.h"
#include "verification/exact/kirchhoff.h"

#include <glib.h>
#include <math.h>

/* Differences of fields with derivatives of order 100: truncation 1e-6, rounding 1e-16/1e-6. */
static const double STEP = 1e-3, SLOPE = 5e-4;

typedef double field(enum heat_body body, double place, double tau);

/* v_t - v_xx - (n - 1) v_x / x with n = 1, 2, 3 axes */
static double residual(field *v, enum heat_body body, double place, double tau)
{
    const double left = v(body, place - STEP, tau), middle = v(body, place, tau);
    const double right = v(body, place + STEP, tau);
    const double rate =
        (v(body, place, tau + STEP * STEP) - v(body, place, tau - STEP * STEP)) / (2 * STEP * STEP);
    return rate - (left - 2.0 * middle + right) / (STEP * STEP) -
           (double)body * (right - left) / (2.0 * STEP * place);
}

static const double places[] = {0.1, 0.35, 0.6, 0.85};
static const double times[] = {0.03, 0.1, 0.4};

START_TEST(fields_of_held_surfaces_solve_the_equation)
{
    const enum heat_body body = (enum heat_body)_i;
    for (size_t t = 0; t < G_N_ELEMENTS(times); t++) {
        for (size_t k = 0; k < G_N_ELEMENTS(places); k++)
            ck_assert_near(residual(heat_surface_held, body, places[k], times[t]), 0.0, SLOPE);
        ck_assert_near(heat_surface_held(body, 1.0, times[t]), 1.0, 1e-14);
    }
    ck_assert_near(heat_surface_held(body, 0.2, 1e-3), 0.0, 1e-12); /* still cold */
    ck_assert_near(heat_surface_held(body, 0.5, 10.0), 1.0, 1e-9);
    /* near the surface the half-space: erfc((1 - x)/(2 sqrt tau)), and curvature in a cylinder */
    if (body == HEAT_SLAB)
        ck_assert_near(heat_surface_held(body, 0.98, 1e-3), erfc(0.01 / sqrt(1e-3)), 1e-12);
}
END_TEST

START_TEST(fields_of_fluxes_solve_the_equation)
{
    const enum heat_body body = (enum heat_body)_i;
    for (size_t t = 0; t < G_N_ELEMENTS(times); t++) {
        const double tau = times[t];
        for (size_t k = 0; k < G_N_ELEMENTS(places); k++)
            ck_assert_near(residual(heat_surface_flux, body, places[k], tau), 0.0, SLOPE);
        const double slope =
            (3.0 * heat_surface_flux(body, 1.0, tau) - 4.0 * heat_surface_flux(body, 0.99, tau) +
             heat_surface_flux(body, 0.98, tau)) /
            0.02;
        ck_assert_near(slope, 1.0, 5e-3);
    }
    ck_assert_near(heat_surface_flux(body, 0.2, 1e-3), 0.0, 1e-10);
}
END_TEST

START_TEST(fields_of_sources_solve_the_equation)
{
    const enum heat_body body = (enum heat_body)_i;
    for (size_t t = 0; t < G_N_ELEMENTS(times); t++) {
        for (size_t k = 0; k < G_N_ELEMENTS(places); k++)
            ck_assert_near(residual(heat_source_held, body, places[k], times[t]), 1.0, SLOPE);
        ck_assert_near(heat_source_held(body, 1.0, times[t]), 0.0, 1e-14);
    }
    ck_assert_near(heat_source_held(body, 0.2, 1e-3), 1e-3, 1e-12); /* nothing has flowed here */
    ck_assert_near(heat_source_held(body, 0.5, 10.0), 0.375 / ((double)body + 1.0), 1e-9);
}
END_TEST

static double convects(enum heat_body body, double place, double tau)
{
    return heat_surface_convection(body, place, tau, 3.0);
}

START_TEST(fields_of_convection_solve_the_equation)
{
    const enum heat_body body = (enum heat_body)_i;
    for (size_t t = 0; t < G_N_ELEMENTS(times); t++) {
        const double tau = times[t], at = convects(body, 1.0, tau);
        for (size_t k = 0; k < G_N_ELEMENTS(places); k++)
            ck_assert_near(residual(convects, body, places[k], tau), 0.0, SLOPE);
        const double slope =
            (3.0 * at - 4.0 * convects(body, 0.99, tau) + convects(body, 0.98, tau)) / 0.02;
        ck_assert_near(slope, 3.0 * (1.0 - at), 5e-3);
        /* a film that does not resist is a surface that is held; one that resists, a flux of b */
        ck_assert_near(heat_surface_convection(body, 0.6, tau, 1e9),
                       heat_surface_held(body, 0.6, tau), 1e-8);
        ck_assert_near(heat_surface_convection(body, 0.6, tau, 1e-6),
                       1e-6 * heat_surface_flux(body, 0.6, tau), 1e-10);
    }
    ck_assert_near(heat_surface_convection(body, 0.2, 1e-3, 3.0), 0.0, 1e-10);
    ck_assert_near(heat_surface_convection(body, 0.0, 0.1, 3.0),
                   heat_surface_convection(body, 1e-6, 0.1, 3.0), 1e-10);
}
END_TEST

START_TEST(a_body_that_radiates_follows_its_equation)
{
    const double start = 900.0, rate = 4e-11, t = 25.0, d = 1e-3;
    const double now = heat_radiated(start, rate, t);
    ck_assert_near((heat_radiated(start, rate, t + d) - heat_radiated(start, rate, t - d)) /
                       (2.0 * d),
                   -rate * now * now * now * now, 1e-6);
    ck_assert_near(heat_radiated(start, rate, 0.0), start, 1e-12 * start);
}
END_TEST

static double sphere_mode(enum heat_body body, double place, double tau)
{
    (void)body;
    return heat_sphere_mode(place, tau);
}

START_TEST(the_mode_of_a_sphere_solves_the_equation)
{
    for (size_t t = 0; t < G_N_ELEMENTS(times); t++) {
        for (size_t k = 0; k < G_N_ELEMENTS(places); k++)
            ck_assert_near(residual(sphere_mode, HEAT_SPHERE, places[k], times[t]), 0.0, SLOPE);
        ck_assert_near(heat_sphere_mode(1.0, times[t]), 0.0, 1e-15);
        ck_assert_near(heat_sphere_mode(1e-9, times[t]), heat_sphere_mode(0.0, times[t]), 1e-15);
    }
    ck_assert_near(heat_sphere_mode(0.0, 0.0), 1.0, 0.0);
}
END_TEST

/* v_t = k_1 v_xx + k_2 v_yy, and a source keeps its heat: v is pi w^2 in all. */
START_TEST(a_spot_solves_the_equation_with_two_diffusivities)
{
    const double k[2] = {0.7, 0.2}, width = 0.8, time = 0.3, x[2] = {0.3, -0.5};
    double spatial = 0.0;
    for (int axis = 0; axis < 2; axis++) {
        double left[2] = {x[0], x[1]}, right[2] = {x[0], x[1]};
        left[axis] -= STEP;
        right[axis] += STEP;
        spatial += k[axis] *
                   (heat_spot(left, width, k, time) - 2.0 * heat_spot(x, width, k, time) +
                    heat_spot(right, width, k, time)) /
                   (STEP * STEP);
    }
    ck_assert_near((heat_spot(x, width, k, time + STEP) - heat_spot(x, width, k, time - STEP)) /
                       (2 * STEP),
                   spatial, 1e-5);
    ck_assert_near(heat_spot(x, width, k, 0.0), exp(-0.34 / 0.64), 1e-15);
}
END_TEST

START_TEST(a_passing_rod_is_steady)
{
    const double u = 0.9, kappa = 0.3, x = -0.4;
    const double left = heat_passing_rod(x - STEP, u, kappa);
    const double right = heat_passing_rod(x + STEP, u, kappa);
    ck_assert_near(u * (right - left) / (2.0 * STEP),
                   kappa * (left - 2.0 * heat_passing_rod(x, u, kappa) + right) / (STEP * STEP),
                   1e-5);
    ck_assert_near(heat_passing_rod(0.0, u, kappa), 1.0, 0.0);
    ck_assert_near(heat_passing_rod(0.7, u, kappa), 1.0, 0.0);
}
END_TEST

/* NAFEMS T3, and the driven end. */
START_TEST(a_driven_slab_has_the_temperature_of_nafems)
{
    const double rate = 35.0 / (7200.0 * 440.5) / 0.01, w = G_PI / 40.0;
    ck_assert_near(100.0 * heat_slab_driven(0.8, rate, w, 32.0), 36.60, 5e-3);
    ck_assert_near(heat_slab_driven(1.0, rate, w, 32.0), sin(32.0 * w), 1e-13);
    ck_assert_near(heat_slab_driven(0.0, rate, w, 32.0), 0.0, 1e-15);
    const double x = 0.7, t = 20.0, h = 1e-3, d = 1e-3;
    const double v_t =
        (heat_slab_driven(x, rate, w, t + d) - heat_slab_driven(x, rate, w, t - d)) / (2.0 * d);
    const double v_xx =
        (heat_slab_driven(x - h, rate, w, t) - 2.0 * heat_slab_driven(x, rate, w, t) +
         heat_slab_driven(x + h, rate, w, t)) /
        (h * h);
    ck_assert_near(v_t, rate * v_xx, 1e-6);
}
END_TEST

/* A slab in 200 layers by explicit differences; the surface is half a layer from the last one. */
static double layered_uptake(double b, double tau)
{
    enum { LAYERS = 200 };
    const double h = 1.0 / LAYERS, step = 0.25 * h * h;
    const int steps = (int)ceil(tau / step);
    double v[LAYERS] = {0.0}, flux[LAYERS + 1] = {0.0}, sum = 0.0;
    for (int n = 0; n < steps; n++) {
        for (int k = 1; k < LAYERS; k++)
            flux[k] = (v[k] - v[k - 1]) / h;
        flux[LAYERS] = b * (1.0 - v[LAYERS - 1]) / (1.0 + 0.5 * b * h);
        for (int k = 0; k < LAYERS; k++)
            v[k] += tau / steps * (flux[k + 1] - flux[k]) / h;
    }
    for (int k = 0; k < LAYERS; k++)
        sum += v[k] * h;
    return sum;
}

START_TEST(what_a_slab_takes_up_is_that_of_its_layers)
{
    static const double b[] = {0.1, 2.0, 30.0};
    for (size_t k = 0; k < G_N_ELEMENTS(b); k++) {
        ck_assert_near(slab_uptake(b[k], 0.0), 0.0, 1e-7 * (1.0 + b[k] * b[k]));
        ck_assert_near(slab_uptake(b[k], 0.05), layered_uptake(b[k], 0.05), 2e-5);
        ck_assert_near(slab_uptake(b[k], 0.5), layered_uptake(b[k], 0.5), 2e-5);
        ck_assert_near(slab_uptake(b[k], 200.0), 1.0, 1e-8);
    }
}
END_TEST

/* k = 1 up to T = 2, then k = 1 + 2 (T - 2) up to 5, then down to 4 at 7. */
static const struct kirchhoff bent = {4, {{-1.0, 1.0}, {2.0, 1.0}, {5.0, 7.0}, {7.0, 4.0}}};

START_TEST(kirchhoffs_transform_is_the_integral_of_the_conductivity_and_its_inverse)
{
    ck_assert_near(kirchhoff_theta(&bent, 2.0), 3.0, 1e-14);
    ck_assert_near(kirchhoff_theta(&bent, 3.0), 3.0 + 2.0, 1e-14); /* 1 + 2 (T - 2)/2 */
    ck_assert_near(kirchhoff_theta(&bent, 5.0), 15.0, 1e-14);
    ck_assert_near(kirchhoff_theta(&bent, 7.0), 26.0, 1e-14);
    for (int k = -10; k <= 70; k++)
        ck_assert_near(
            kirchhoff_temperature(&bent, 0.5,
                                  kirchhoff_theta(&bent, 0.1 * k) - kirchhoff_theta(&bent, 0.5)),
            0.1 * k, 1e-13);
    ck_assert(isnan(kirchhoff_temperature(&bent, 0.5, 100.0)));
    ck_assert(isnan(kirchhoff_temperature(&bent, 0.5, -2.0)));
}
END_TEST

Suite *suite_heat_fields(void)
{
    Suite *suite = suite_create("heat_fields");
    TCase *fields = tcase_create("fields");
    tcase_add_loop_test(fields, fields_of_held_surfaces_solve_the_equation, 0, HEAT_BODIES);
    tcase_add_loop_test(fields, fields_of_fluxes_solve_the_equation, 0, HEAT_BODIES);
    tcase_add_loop_test(fields, fields_of_sources_solve_the_equation, 0, HEAT_BODIES);
    tcase_add_loop_test(fields, fields_of_convection_solve_the_equation, 0, HEAT_BODIES);
    tcase_add_test(fields, a_body_that_radiates_follows_its_equation);
    tcase_add_test(fields, the_mode_of_a_sphere_solves_the_equation);
    tcase_add_test(fields, a_spot_solves_the_equation_with_two_diffusivities);
    tcase_add_test(fields, a_passing_rod_is_steady);
    tcase_add_test(fields, a_driven_slab_has_the_temperature_of_nafems);
    tcase_add_test(fields, what_a_slab_takes_up_is_that_of_its_layers);
    tcase_add_test(fields,
                   kirchhoffs_transform_is_the_integral_of_the_conductivity_and_its_inverse);
    suite_add_tcase(suite, fields);
    return suite;
}

/* Two bodies of different temperature brought together: the exact field against what it must
 * satisfy, by differences, and against closed forms for half-spaces.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "verification/exact/contact/heat_layers.h"

#include <glib.h>
#include <math.h>

/* Second and third differences of functions with derivatives of order 100 to 1000. */
static const double STEP = 1e-3, SLOPE = 1e-3;

static const double conductances[] = {HUGE_VAL, 5.0, 0.1};
enum { CASES = 2 * (int)G_N_ELEMENTS(conductances) };
static const double times[] = {0.01, 0.05, 0.3};

static struct heat_layers layers_of(int index)
{
    return (struct heat_layers){
        .cylinder = index % 2 == 1,
        .width = {1.0, 0.7},
        .conductivity = {1.0, 2.0},
        .capacity = {1.0, 4.0},
        .start = {1.0, -0.5},
        .conductance = conductances[index / 2],
    };
}

static struct heat_layers_series *series_of(const struct heat_layers *layers, double from)
{
    struct heat_layers_series *const series = g_new(struct heat_layers_series, 1);
    ck_assert(heat_layers_solve(layers, from, series));
    return series;
}

/* c v_t - k (v_xx + v_x/x), in each body */
START_TEST(fields_of_two_bodies_solve_the_equation)
{
    const struct heat_layers layers = layers_of(_i);
    struct heat_layers_series *const series = series_of(&layers, 0.009);
    static const double places[2][3] = {{0.2, 0.5, 0.95}, {1.05, 1.3, 1.6}};
    for (size_t t = 0; t < G_N_ELEMENTS(times); t++)
        for (int body = 0; body < 2; body++)
            for (int k = 0; k < 3; k++) {
                const double x = places[body][k], h = STEP, d = STEP * STEP;
                const double left = heat_layers_value(series, body, x - h, times[t]);
                const double middle = heat_layers_value(series, body, x, times[t]);
                const double right = heat_layers_value(series, body, x + h, times[t]);
                const double rate = (heat_layers_value(series, body, x, times[t] + d) -
                                     heat_layers_value(series, body, x, times[t] - d)) /
                                    (2.0 * d);
                const double bend = (left - 2.0 * middle + right) / (h * h) +
                                    (layers.cylinder ? (right - left) / (2.0 * h * x) : 0.0);
                ck_assert_near(layers.capacity[body] * rate, layers.conductivity[body] * bend,
                               20.0 * SLOPE);
            }
    g_free(series);
}
END_TEST

/* Three-point slopes at the contact and outside. */
START_TEST(fluxes_at_the_contact_are_those_of_its_law)
{
    const struct heat_layers layers = layers_of(_i);
    struct heat_layers_series *const series = series_of(&layers, 0.009);
    const double at = layers.width[0], end = at + layers.width[1], h = STEP;
    for (size_t t = 0; t < G_N_ELEMENTS(times); t++) {
        double v[2], flux[2];
        for (int body = 0; body < 2; body++) {
            const double way = body == 0 ? -h : h;
            v[body] = heat_layers_value(series, body, at, times[t]);
            flux[body] =
                layers.conductivity[body] / (2.0 * way) *
                (4.0 * heat_layers_value(series, body, at + way, times[t]) - 3.0 * v[body] -
                 heat_layers_value(series, body, at + 2.0 * way, times[t]));
        }
        ck_assert_near(flux[0], flux[1], SLOPE);
        ck_assert_near((v[1] - v[0]) - flux[0] / layers.conductance, 0.0,
                       isfinite(layers.conductance) ? SLOPE / layers.conductance : 1e-12);
        ck_assert_near(heat_layers_value(series, 1, end, times[t]),
                       heat_layers_value(series, 1, end - h, times[t]), SLOPE * h * 10.0);
    }
    g_free(series);
}
END_TEST

/* Of Simpson's rule with 1000 intervals: what the first body has lost. */
START_TEST(what_has_passed_is_what_the_first_body_lacks)
{
    enum { INTERVALS = 1000 };
    const struct heat_layers layers = layers_of(_i);
    struct heat_layers_series *const series = series_of(&layers, 0.009);
    for (size_t t = 0; t < G_N_ELEMENTS(times); t++) {
        double lost = 0.0;
        for (int k = 0; k <= INTERVALS; k++) {
            const double x = layers.width[0] * k / INTERVALS;
            const double weight = k == 0 || k == INTERVALS ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
            lost += weight * (layers.start[0] - heat_layers_value(series, 0, x, times[t])) *
                    (layers.cylinder ? x : 1.0);
        }
        lost *= layers.capacity[0] * layers.width[0] / INTERVALS / 3.0;
        ck_assert_near(heat_layers_passed(series, times[t]), lost, 1e-9);
    }
    g_free(series);
}
END_TEST

/* Long before heat is at the ends, slabs are half-spaces (Carslaw and Jaeger): with perfect contact
 * between them a constant temperature, and error functions on either side; with a conductance H and
 * both sides alike the Robin problem of one, with 2 H and the mean of both. */
START_TEST(early_on_slabs_are_half_spaces)
{
    const double t = 2e-3, x = 0.03;
    struct heat_layers layers = layers_of(0);
    struct heat_layers_series *series = series_of(&layers, t);
    const double between = heat_layers_between(&layers);
    ck_assert_near(between, 1.0 - 1.5 * sqrt(8.0) / (1.0 + sqrt(8.0)), 1e-15);
    ck_assert_near(heat_layers_value(series, 0, 1.0, t), between, 1e-10);
    ck_assert_near(heat_layers_value(series, 0, 1.0 - x, t),
                   between + (1.0 - between) * erf(x / (2.0 * sqrt(t))), 1e-10);
    ck_assert_near(heat_layers_value(series, 1, 1.0 + x, t),
                   between + (-0.5 - between) * erf(x / (2.0 * sqrt(0.5 * t))), 1e-10);
    g_free(series);
    layers.conductance = 4.0;
    layers.conductivity[1] = layers.capacity[1] = 1.0;
    series = series_of(&layers, t);
    const double h = 2.0 * layers.conductance, s = 2.0 * sqrt(t);
    const double fallen = 0.75 * (erfc(x / s) - exp(h * x + h * h * t) * erfc(x / s + h * sqrt(t)));
    ck_assert_near(heat_layers_value(series, 0, 1.0 - x, t), 1.0 - fallen, 1e-10);
    g_free(series);
}
END_TEST

START_TEST(too_early_a_time_has_more_modes_than_there_is_room_for)
{
    const struct heat_layers layers = layers_of(_i);
    struct heat_layers_series *const series = g_new(struct heat_layers_series, 1);
    ck_assert(!heat_layers_solve(&layers, 1e-7, series));
    g_free(series);
}
END_TEST

Suite *suite_heat_layers(void)
{
    Suite *const suite = suite_create("heat_layers");
    TCase *const tests = tcase_create("heat_layers");
    tcase_add_loop_test(tests, fields_of_two_bodies_solve_the_equation, 0, CASES);
    tcase_add_loop_test(tests, fluxes_at_the_contact_are_those_of_its_law, 0, CASES);
    tcase_add_loop_test(tests, what_has_passed_is_what_the_first_body_lacks, 0, CASES);
    tcase_add_test(tests, early_on_slabs_are_half_spaces);
    tcase_add_loop_test(tests, too_early_a_time_has_more_modes_than_there_is_room_for, 0, CASES);
    suite_add_tcase(suite, tests);
    return suite;
}

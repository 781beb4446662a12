/* The exact solutions of damped motion: the free body, the bar, and the bar on its grid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "verification/exact/waves/damped_bar.h"
#include "verification/exact/waves/damped_flight.h"
#include "verification/measures/oscillation.h"

#include <check.h>
#include <glib.h>
#include <math.h>
#include <stddef.h>

static const double PI = 3.14159265358979323846;

/* ------------------------------------------------------------- a free body */

static const struct damped_flight FLIGHTS[] = {
    {.grid = 0.3, .particle = 0.2},
    {.grid = 0.1, .growth = 0.15, .particle = 0.05},
    {.feedback = 0.25},
};
static const double END = 4.0;

/* Largest rate over END. */
static double rate_at(const struct damped_flight *flight, double time)
{
    const double w = sqrt(flight->feedback);
    return flight->grid + flight->particle + flight->growth * time + w * tanh(w * time);
}

START_TEST(the_velocity_of_a_free_body_obeys_its_equation)
{
    const double h = 1e-4;
    for (double t = 0.2; t < END; t += 0.3) {
        const double slope = (damped_flight_velocity(&FLIGHTS[_i], t + h) -
                              damped_flight_velocity(&FLIGHTS[_i], t - h)) /
                             (2.0 * h);
        ck_assert_near(slope, -rate_at(&FLIGHTS[_i], t) * damped_flight_velocity(&FLIGHTS[_i], t),
                       1e-8); /* h^2/6 of the third derivative */
    }
    ck_assert_double_eq(damped_flight_velocity(&FLIGHTS[_i], 0.0), 1.0);
}
END_TEST

/* Steps of first order come to the exact velocity, and their way to its integral. */
START_TEST(steps_of_a_free_body_come_to_the_exact_decay)
{
    for (int midpoint = 0; midpoint < 2; midpoint++) {
        struct damped_flight flight = FLIGHTS[_i];
        double error[2];
        flight.midpoint = midpoint == 1;
        for (int k = 0; k < 2; k++) {
            const int steps = 4000 << k;
            const double dt = END / steps;
            struct damped_flight_state state = damped_flight_start;
            double integral = 0.0;
            for (int n = 0; n < steps; n++) {
                damped_flight_advance(&flight, n * dt, dt, &state);
                integral += dt * damped_flight_velocity(&flight, (n + 0.5) * dt);
            }
            error[k] = state.velocity / damped_flight_velocity(&flight, END) - 1.0;
            ck_assert_near(state.way, integral, 2.0 * dt);
        }
        ck_assert(fabs(error[0]) < 1e-3 && error[0] != 0.0);
        ck_assert_near(error[0] / error[1], 2.0, 0.02);
    }
}
END_TEST

START_TEST(a_thermostat_with_a_target_stops_at_no_rate_below_zero)
{
    const struct damped_flight flight = {.feedback = 0.25, .target = 0.4};
    struct damped_flight_state state = damped_flight_start;
    bool cut_off = false;
    ck_assert(isnan(damped_flight_velocity(&flight, 1.0)));
    for (int n = 0; n < 1000; n++) {
        damped_flight_advance(&flight, 0.05 * n, 0.05, &state);
        ck_assert(state.rate >= 0.0);
        cut_off = cut_off || state.rate == 0.0;
    }
    ck_assert(cut_off);
    ck_assert(state.velocity * state.velocity < 0.4); /* there is nothing that would speed it up */
}
END_TEST

/* ------------------------------------------------------------------- a bar */

static const struct damped_bar BARS[] = {
    {.length = 16.0, .speed = 1.0, .rate = 0.02, .profile = DAMPED_BAR_UNIFORM},
    {.length = 16.0, .speed = 1.0, .rate = 0.02, .profile = DAMPED_BAR_COSINE},
    {.length = 5.0, .speed = 3.0, .rate = 0.9, .profile = DAMPED_BAR_COSINE},
};

/* u = Re(exp(l t) f(X)), f'' = (l^2 + l alpha) f/c^2 from f(0) = 0, f'(0) = 1 by Runge-Kutta steps:
 * f(L) is zero. */
START_TEST(the_mode_of_a_damped_bar_vanishes_at_its_ends)
{
    enum { STEPS = 4000, STATES = 4 };
    const struct damped_bar *const bar = &BARS[_i];
    const struct bar_dispersion_result mode = damped_bar_mode(bar);
    const double h = bar->length / STEPS;
    double y[STATES] = {0.0, 0.0, 1.0, 0.0}, largest = 0.0; /* f, then f', real and imaginary */
    for (int n = 0; n < STEPS; n++) {
        double slope[4][STATES], at[STATES];
        for (int stage = 0; stage < 4; stage++) {
            const double part = stage == 0 ? 0.0 : stage == 3 ? 1.0 : 0.5;
            for (size_t k = 0; k < STATES; k++)
                at[k] = y[k] + (stage == 0 ? 0.0 : part * h * slope[stage - 1][k]);
            const double x = (n + part) * h;
            const double alpha =
                bar->rate *
                (bar->profile == DAMPED_BAR_COSINE ? 1.0 - cos(2.0 * PI * x / bar->length) : 1.0);
            const double re = -mode.decay, im = mode.frequency, c2 = bar->speed * bar->speed;
            const double a = (re * re - im * im + re * alpha) / c2;
            const double b = (2.0 * re * im + im * alpha) / c2;
            slope[stage][0] = at[2];
            slope[stage][1] = at[3];
            slope[stage][2] = a * at[0] - b * at[1];
            slope[stage][3] = a * at[1] + b * at[0];
        }
        for (size_t k = 0; k < STATES; k++)
            y[k] += h / 6.0 * (slope[0][k] + 2.0 * slope[1][k] + 2.0 * slope[2][k] + slope[3][k]);
        largest = fmax(largest, hypot(y[0], y[1]));
    }
    ck_assert(mode.decay > 0.0 && mode.frequency > 0.0);
    ck_assert_near(hypot(y[0], y[1]) / largest, 0.0, 1e-10);
}
END_TEST

/* 3a/4 to first order. */
START_TEST(a_small_rate_that_depends_on_the_place_decays_with_its_mean)
{
    struct damped_bar bar = BARS[1];
    bar.rate = 1e-5;
    ck_assert_near(damped_bar_mode(&bar).decay / bar.rate, 0.75, 1e-8);
    ck_assert_near(damped_bar_mode(&bar).frequency, PI / 16.0, 1e-9);
}
END_TEST

/* --------------------------------------------------------- a bar on its grid */

enum { CELLS = 16, COUNT = 2 * CELLS };

static double field_rate(const struct damped_bar *bar, double x)
{
    if (bar->profile == DAMPED_BAR_BAND)
        return fabs(x - 8.0) < bar->width ? bar->rate : 0.0;
    return bar->profile == DAMPED_BAR_COSINE ? bar->rate * (1.0 - cos(PI * x / 8.0)) : bar->rate;
}

/* The tasks of a step of two particles a cell, written out; cells of width 1. */
static void advance(const struct damped_bar *bar, enum damped_bar_form form, bool usl, double dt,
                    double velocity[COUNT], double strain[COUNT])
{
    double mass[CELLS + 1] = {0}, v[CELLS + 1] = {0}, a[CELLS + 1] = {0}, after[CELLS + 1];
    for (size_t p = 0; p < COUNT; p++)
        for (size_t k = 0; k < 2; k++) {
            const double x = p % 2 == 0 ? 0.25 : 0.75, weight = k == 0 ? 1.0 - x : x;
            mass[p / 2 + k] += 0.5 * weight;
            v[p / 2 + k] += 0.5 * weight * velocity[p];
            a[p / 2 + k] += (k == 0 ? 0.5 : -0.5) * strain[p];
        }
    for (size_t i = 0; i <= CELLS; i++) {
        const bool held = i == 0 || i == CELLS;
        v[i] = held ? 0.0 : v[i] / mass[i];
        a[i] = held ? 0.0 : a[i] / mass[i];
        if (form == DAMPED_BAR_NODES)
            a[i] -= field_rate(bar, (double)i) * v[i];
        after[i] = v[i] + dt * a[i];
    }
    for (size_t p = 0; p < COUNT; p++) {
        const size_t i = p / 2;
        const double x = p % 2 == 0 ? 0.25 : 0.75, place = (double)i + x;
        const double left = field_rate(bar, (double)i), right = field_rate(bar, (double)i + 1.0);
        const double drags[DAMPED_BAR_FORMS] = {
            [DAMPED_BAR_PARTICLES] = (1.0 - x) * left * v[i] + x * right * v[i + 1],
            [DAMPED_BAR_PARTICLE_RATE] = field_rate(bar, place) * ((1.0 - x) * v[i] + x * v[i + 1]),
            [DAMPED_BAR_OWN] = field_rate(bar, place) * velocity[p],
        };
        velocity[p] += dt * ((1.0 - x) * a[i] + x * a[i + 1] - drags[form]);
    }
    if (!usl)
        for (size_t i = 1; i < CELLS; i++)
            after[i] = (0.25 * velocity[2 * i - 2] + 0.75 * velocity[2 * i - 1] +
                        0.75 * velocity[2 * i] + 0.25 * velocity[2 * i + 1]) /
                       2.0;
    for (size_t p = 0; p < COUNT; p++)
        strain[p] += dt * (after[p / 2 + 1] - after[p / 2]);
}

/* sin k X of a particle */
static double shape_of(size_t p)
{
    const size_t cell = p / 2;
    return sin(PI / 16.0 * ((double)cell + (p % 2 == 0 ? 0.25 : 0.75)));
}

/* The fitted decay of the particles' velocities projected onto the mode. */
static double decay_of(const struct damped_bar *bar, enum damped_bar_form form, bool usl, double dt)
{
    enum { STEPS = 800 };
    double velocity[COUNT], strain[COUNT] = {0.0}, time[STEPS], value[STEPS];
    struct oscillation fit;
    for (size_t p = 0; p < COUNT; p++)
        velocity[p] = shape_of(p);
    for (size_t n = 0; n < STEPS; n++) {
        advance(bar, form, usl, dt, velocity, strain);
        time[n] = dt * (double)(n + 1);
        value[n] = 0.0;
        for (size_t p = 0; p < COUNT; p++)
            value[n] += velocity[p] * shape_of(p);
    }
    ck_assert(oscillation_fit(STEPS, time, value, PI / 16.0, &fit));
    return fit.decay;
}

/* Exact for one rate; to first order in a rate that varies, up to 0.04 of a frequency of 0.2. */
static const double ONE_MODE[] = {1e-8, 6e-3, 0.03};

START_TEST(the_drag_on_the_grid_is_that_of_the_tasks_of_a_step)
{
    static const struct damped_bar rates[] = {
        {.length = 16.0, .speed = 1.0, .rate = 0.02, .profile = DAMPED_BAR_UNIFORM},
        {.length = 16.0, .speed = 1.0, .rate = 0.02, .profile = DAMPED_BAR_COSINE},
        {.length = 16.0, .speed = 1.0, .rate = 0.04, .profile = DAMPED_BAR_BAND, .width = 0.6},
    };
    const struct damped_bar *const bar = &rates[_i % 3];
    const enum damped_bar_form form = (enum damped_bar_form)(_i / 3 % DAMPED_BAR_FORMS);
    const bool usl = _i / 3 / DAMPED_BAR_FORMS == 1;
    struct bar_dispersion grid = {.order = usl ? BAR_DISPERSION_USL : BAR_DISPERSION_MUSL,
                                  .particles = 2,
                                  .fraction = 1.0,
                                  .speed = 1.0,
                                  .cell = 1.0,
                                  .step = 0.4};
    damped_bar_set_drag(bar, form, &grid);
    if (form == DAMPED_BAR_OWN && bar->profile != DAMPED_BAR_UNIFORM) {
        ck_assert(isnan(grid.drag));
        return;
    }
    const double decay = bar_dispersion(&grid, PI / 16.0).decay;
    ck_assert_near(decay_of(bar, form, usl, grid.step) / decay, 1.0, ONE_MODE[_i % 3]);
}
END_TEST

Suite *suite_damped_motion(void)
{
    Suite *suite = suite_create("damped_motion");
    TCase *flight = tcase_create("free body");
    tcase_add_loop_test(flight, the_velocity_of_a_free_body_obeys_its_equation, 0,
                        G_N_ELEMENTS(FLIGHTS));
    tcase_add_loop_test(flight, steps_of_a_free_body_come_to_the_exact_decay, 0,
                        G_N_ELEMENTS(FLIGHTS));
    tcase_add_test(flight, a_thermostat_with_a_target_stops_at_no_rate_below_zero);
    suite_add_tcase(suite, flight);
    TCase *bar = tcase_create("bar");
    tcase_add_loop_test(bar, the_mode_of_a_damped_bar_vanishes_at_its_ends, 0, G_N_ELEMENTS(BARS));
    tcase_add_test(bar, a_small_rate_that_depends_on_the_place_decays_with_its_mean);
    tcase_add_loop_test(bar, the_drag_on_the_grid_is_that_of_the_tasks_of_a_step, 0,
                        2 * 3 * DAMPED_BAR_FORMS);
    suite_add_tcase(suite, bar);
    return suite;
}

/* Tests of what long runs are measured by: conservation of energy and momentum, the fit of an
 * oscillation, what a curve of energies shows, the slope of a line.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "verification/measures/conservation.h"
#include "verification/measures/energy_curve.h"
#include "verification/measures/line_fit.h"
#include "verification/measures/oscillation.h"

#include <math.h>

static const double TWO_PI = 6.28318530717958647692;

/* ------------------------------------------------------------------- conservation */

static struct mpm_ledger ledger_at(double energy, double work, double px, double py, double spin)
{
    return (struct mpm_ledger){.mass = 2,
                               .momentum = {px, py},
                               .angular_momentum = spin,
                               .kinetic_energy = 0.25 * energy,
                               .strain_energy = 0.75 * energy,
                               .external_work = work,
                               .total_energy = energy};
}

START_TEST(the_largest_drift_either_way_excludes_the_work_from_outside)
{
    struct conservation conservation;
    const struct mpm_ledger rows[] = {ledger_at(4, 0, 1, 1, 5), ledger_at(5, 0.5, 1, 1, 5),
                                      ledger_at(3, 0.5, 4, 5, 3), ledger_at(4, 0, 1, 1, 5)};
    conservation_open(&conservation, &rows[0]);
    for (size_t k = 1; k < 4; k++)
        conservation_add(&conservation, &rows[k]);
    ck_assert_uint_eq(conservation.samples, 4);
    ck_assert_double_eq(conservation.energy_high, 0.125);
    ck_assert_double_eq(conservation.energy_low, -0.375);
    ck_assert_double_eq(conservation_energy_drift(&conservation), 0.375);
    ck_assert_double_eq(conservation_energy_now(&conservation), 0);
    ck_assert_double_eq(conservation.smallest_kinetic, 0.1875);
    /* sqrt(2 * 2 * 4) = 4; the momentum moved by (3, 4), the angular momentum by 2 */
    ck_assert_double_eq(conservation_momentum_drift(&conservation), 1.25);
    ck_assert_double_eq(conservation_angular_momentum_drift(&conservation, 2), 0.25);
}
END_TEST

START_TEST(a_nan_in_one_ledger_stays_in_the_drifts)
{
    struct conservation conservation;
    struct mpm_ledger row = ledger_at(4, 0, 1, 1, 5);
    conservation_open(&conservation, &row);
    row = ledger_at((double)NAN, 0, (double)NAN, 0, (double)NAN);
    conservation_add(&conservation, &row);
    row = ledger_at(4, 0, 1, 1, 5);
    conservation_add(&conservation, &row);
    ck_assert_double_nan(conservation_energy_drift(&conservation));
    ck_assert_double_nan(conservation_momentum_drift(&conservation));
    ck_assert_double_nan(conservation_angular_momentum_drift(&conservation, 1));
    ck_assert_double_nan(conservation.smallest_kinetic);
}
END_TEST

/* ------------------------------------------------------------- oscillation */

enum { SAMPLES = 2001 };

/* 100 periods of 1, 20 samples each, at times that are off the lattice, as steps are. */
static void sample(double frequency, double decay, double overtone, double *time, double *value)
{
    for (int k = 0; k < SAMPLES; k++) {
        const double t = 0.05 * k + 0.002 * sin(17.0 * k);
        time[k] = t;
        value[k] = exp(-decay * t) * (0.7 * cos(frequency * t) - 0.4 * sin(frequency * t)) +
                   overtone * cos(3.7 * frequency * t);
    }
}

/* The guess is off by up to a tenth: ten periods over the whole run. */
START_TEST(a_fit_finds_frequency_and_decay_over_a_hundred_periods)
{
    static const struct {
        double frequency, decay;
    } cases[] = {{1.0, 0}, {0.91, 0.003}, {1.09, -0.01}, {0.995, 0.1}, {1.02, 0.0001}};
    /* the phase is known to eps over 2000 samples, the frequency to that over 100 periods */
    static const double TOLERANCE = 1e-12;
    double time[SAMPLES], value[SAMPLES];
    const double frequency = TWO_PI * cases[_i].frequency, decay = cases[_i].decay;
    struct oscillation fit;
    sample(frequency, decay, 0, time, value);
    ck_assert(oscillation_fit(SAMPLES, time, value, TWO_PI, &fit));
    ck_assert_double_eq_tol(fit.frequency, frequency, TOLERANCE * frequency);
    ck_assert_double_eq_tol(fit.decay, decay, TOLERANCE * frequency);
    ck_assert_double_eq_tol(fit.amplitude, hypot(0.7, 0.4), 1e-10);
    ck_assert_double_lt(fit.residual, 1e-10);
}
END_TEST

START_TEST(the_bound_of_a_fit_holds_with_an_overtone)
{
    double time[SAMPLES], value[SAMPLES];
    struct oscillation fit;
    for (int k = 0; k < 5; k++) {
        const double frequency = TWO_PI * (0.98 + 0.01 * k);
        sample(frequency, 0.002, 0.05, time, value);
        ck_assert(oscillation_fit(SAMPLES, time, value, TWO_PI, &fit));
        ck_assert_double_le(fabs(fit.frequency - frequency), fit.bound);
        ck_assert_double_lt(fit.bound, 1e-3 * frequency);
        ck_assert_double_gt(fit.residual, 0.01);
    }
}
END_TEST

START_TEST(a_frequency_that_moves_shows_in_the_bound)
{
    double time[SAMPLES], value[SAMPLES];
    struct oscillation fit;
    for (int k = 0; k < SAMPLES; k++) {
        time[k] = 0.05 * k;
        value[k] = cos(TWO_PI * time[k] * (1 + 1e-5 * time[k]));
    }
    ck_assert(oscillation_fit(SAMPLES, time, value, TWO_PI, &fit));
    /* 1 at the start, 1 + 2e-3 at the end: the halves' means lie 5e-4 on either side */
    ck_assert_double_gt(fit.bound, 3e-4 * TWO_PI);
    ck_assert_double_lt(fit.bound, 1e-3 * TWO_PI);
}
END_TEST

START_TEST(what_is_no_oscillation_is_not_fitted)
{
    double time[SAMPLES], value[SAMPLES];
    struct oscillation fit;
    sample(TWO_PI, 0, 0, time, value);
    ck_assert(!oscillation_fit(4, time, value, TWO_PI, &fit));
    ck_assert(!oscillation_fit(SAMPLES, time, value, 0, &fit));
    value[1000] = (double)NAN;
    ck_assert(!oscillation_fit(SAMPLES, time, value, TWO_PI, &fit));
    ck_assert_double_nan(fit.frequency);
    ck_assert_double_nan(fit.bound);
}
END_TEST

/* ------------------------------------------------------------ energy curves */

enum { ROWS = 400, ROW = 3 };

static struct energy_curve curve_of(const double (*rows)[ROW], size_t count)
{
    return (struct energy_curve){count, ROW, &rows[0][0], &rows[0][1], &rows[0][2]};
}

/* A mass on a spring, angular frequency 1, by symplectic Euler with the new velocity in the place
 * (`ahead`) or the old place in the velocity's mirror image; a drift of `slope` t is added. */
static void swing_of_spring(bool ahead, double slope, double dt, double (*rows)[ROW])
{
    double x = 1.0, v = 0.0;
    for (size_t k = 0; k < ROWS; k++) {
        const double time = (double)k * dt;
        rows[k][0] = time;
        rows[k][1] = x * x + v * v + slope * time;
        rows[k][2] = x * x;
        if (ahead) {
            v -= dt * x;
            x += dt * v;
        } else {
            x += dt * v;
            v -= dt * x;
        }
    }
}

START_TEST(the_swing_of_symplectic_euler_has_its_sign_and_size_beside_a_drift)
{
    static const double DT = 0.05, SECOND_ORDER = 4.0 * 0.05 * 0.05;
    double rows[ROWS][ROW];
    const struct energy_curve curve = curve_of((const double(*)[ROW])rows, ROWS);
    for (int drifts = 0; drifts < 2; drifts++) {
        swing_of_spring(true, 0.1 * drifts, DT, rows);
        ck_assert_double_eq_tol(energy_curve_swing(&curve, DT), 1.0, SECOND_ORDER);
        swing_of_spring(false, 0.1 * drifts, DT, rows);
        ck_assert_double_eq_tol(energy_curve_swing(&curve, DT), -1.0, SECOND_ORDER);
    }
}
END_TEST

START_TEST(an_energy_curve_shows_sign_mean_and_time_of_its_change)
{
    static const double ROWS_OF[][ROW] = {
        {0, 1, 0}, {1, 1.25, 0}, {2, 0.5, 0}, {3, 1.125, 0}, {4, 1.375, 0}};
    const struct energy_curve curve = curve_of(ROWS_OF, 5), none = curve_of(ROWS_OF, 0);
    ck_assert_double_eq(energy_curve_extreme(&curve), -0.5);
    ck_assert_double_eq(energy_curve_mean(&curve, 3, 4), 0.25);
    ck_assert_double_eq(energy_curve_mean(&curve, 0.5, 1.5), 0.25);
    ck_assert_double_nan(energy_curve_mean(&curve, 5, 6));
    ck_assert_double_eq(energy_curve_time_off(&curve, 0.25), 2);
    ck_assert_double_nan(energy_curve_time_off(&curve, 0.5));
    ck_assert_double_nan(energy_curve_extreme(&none));
    ck_assert_double_nan(energy_curve_swing(&none, 1));
    ck_assert_double_nan(energy_curve_swing(&curve, 1)); /* strain energy without change */
}
END_TEST

START_TEST(a_nan_stays_in_what_an_energy_curve_shows)
{
    double rows[][ROW] = {{0, 1, 0}, {1, (double)NAN, 1}, {2, 0.5, 2}, {3, 1, 0}, {4, 1, 1}};
    const struct energy_curve curve = curve_of((const double(*)[ROW])rows, 5);
    ck_assert_double_nan(energy_curve_extreme(&curve));
    ck_assert_double_nan(energy_curve_mean(&curve, 0, 4));
    ck_assert_double_eq(energy_curve_time_off(&curve, 0.9), 1);
    ck_assert_double_nan(energy_curve_swing(&curve, 1));
}
END_TEST

/* --------------------------------------------------------------------------- lines */

/* The middle sample is off the line, which turns no line through equal steps. */
START_TEST(a_line_has_the_slope_of_least_squares)
{
    struct line_fit line = {.count = 0};
    line_fit_add(&line, 1, 5);
    ck_assert_double_nan(line_fit_slope(&line));
    line_fit_add(&line, 2, 100);
    line_fit_add(&line, 3, 8);
    ck_assert_double_eq(line_fit_slope(&line), 1.5);
    line_fit_add(&line, 6, 8); /* t less its mean, 3: -2, -1, 0, 3 */
    ck_assert_double_eq(line_fit_slope(&line), (-2 * 5 - 100 + 3 * 8) / 14.0);
}
END_TEST

Suite *suite_measures(void)
{
    Suite *suite = suite_create("measures");
    TCase *conservation = tcase_create("conservation"), *fits = tcase_create("oscillation");
    tcase_add_test(conservation, the_largest_drift_either_way_excludes_the_work_from_outside);
    tcase_add_test(conservation, a_nan_in_one_ledger_stays_in_the_drifts);
    tcase_add_loop_test(fits, a_fit_finds_frequency_and_decay_over_a_hundred_periods, 0, 5);
    tcase_add_test(fits, the_bound_of_a_fit_holds_with_an_overtone);
    tcase_add_test(fits, a_frequency_that_moves_shows_in_the_bound);
    tcase_add_test(fits, what_is_no_oscillation_is_not_fitted);
    suite_add_tcase(suite, conservation);
    suite_add_tcase(suite, fits);
    TCase *curves = tcase_create("energy curves");
    tcase_add_test(curves, the_swing_of_symplectic_euler_has_its_sign_and_size_beside_a_drift);
    tcase_add_test(curves, an_energy_curve_shows_sign_mean_and_time_of_its_change);
    tcase_add_test(curves, a_nan_stays_in_what_an_energy_curve_shows);
    suite_add_tcase(suite, curves);
    TCase *lines = tcase_create("lines");
    tcase_add_test(lines, a_line_has_the_slope_of_least_squares);
    suite_add_tcase(suite, lines);
    return suite;
}

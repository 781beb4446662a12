/* Exact states of plastic bodies against equilibrium, yield, Hooke's law and each other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "verification/exact/lame_cylinder.h"
#include "verification/exact/plastic/hill_sphere.h"
#include "verification/exact/plastic/plastic_tube.h"
#include "verification/exact/plastic/plastic_wave.h"

#include <math.h>

static const struct hill_sphere sphere = {10.0, 20.0, 1000.0, 0.3, 0.1};
static const double ROUND_OFF = 1e-13; /* of numbers up to 1 */
/* Central differences: 1e-4 squared over 10 squared, times third derivatives of order 1, of Y. */
static const double DIFFERENCE = 1e-4, SLOPE = 1e-9;

static double slope_of_rr(double peak, double pressure, double r)
{
    return (hill_sphere_state(&sphere, peak, pressure, r + DIFFERENCE).rr -
            hill_sphere_state(&sphere, peak, pressure, r - DIFFERENCE).rr) /
           (2.0 * DIFFERENCE);
}

static double slope_of_u(double peak, double pressure, double r)
{
    return (hill_sphere_state(&sphere, peak, pressure, r + DIFFERENCE).u -
            hill_sphere_state(&sphere, peak, pressure, r - DIFFERENCE).u) /
           (2.0 * DIFFERENCE);
}

static const struct {
    double peak, pressure;
} loads[] = {{0.03, 0.03}, {0.09, 0.09}, {0.111, 0.111}, {0.111, 0.05}, {0.111, 0.0}};
enum { LOADS = sizeof loads / sizeof *loads };

START_TEST(a_sphere_is_in_equilibrium_within_yield_and_bears_its_pressure)
{
    const double peak = loads[_i].peak, pressure = loads[_i].pressure;
    for (double r = 10.25; r < 20.0; r += 0.5) {
        const struct hill_sphere_state s = hill_sphere_state(&sphere, peak, pressure, r);
        ck_assert_near(slope_of_rr(peak, pressure, r), 2.0 * (s.tt - s.rr) / r, SLOPE);
        ck_assert_double_le(fabs(s.tt - s.rr), sphere.yield * (1.0 + ROUND_OFF));
    }
    ck_assert_near(hill_sphere_state(&sphere, peak, pressure, 10.0).rr, -pressure, ROUND_OFF);
    ck_assert_near(hill_sphere_state(&sphere, peak, pressure, 20.0).rr, 0.0, ROUND_OFF);
}
END_TEST

START_TEST(volume_strain_of_a_sphere_is_elastic_and_hoops_are_beyond_the_front)
{
    const double peak = loads[_i].peak, pressure = loads[_i].pressure;
    const double front = hill_sphere_front(&sphere, peak), nu = sphere.poisson;
    for (double r = 10.25; r < 20.0; r += 0.5) {
        const struct hill_sphere_state s = hill_sphere_state(&sphere, peak, pressure, r);
        const double trace = slope_of_u(peak, pressure, r) + 2.0 * s.u / r;
        ck_assert_near(trace, (1.0 - 2.0 * nu) / sphere.young * (s.rr + 2.0 * s.tt), SLOPE);
        if (r > front)
            ck_assert_near(s.u / r, ((1.0 - nu) * s.tt - nu * s.rr) / sphere.young, ROUND_OFF);
    }
    /* at the front the displacement has no jump */
    ck_assert_near(hill_sphere_state(&sphere, peak, pressure, front * (1.0 - 1e-12)).u,
                   hill_sphere_state(&sphere, peak, pressure, front * (1.0 + 1e-12)).u, 1e-14);
}
END_TEST

START_TEST(a_sphere_beyond_its_limits_has_no_state)
{
    ck_assert_double_nan(hill_sphere_front(&sphere, 0.2));
    ck_assert_double_nan(hill_sphere_state(&sphere, 0.13, 0.0, 15.0).rr);
    ck_assert_double_nan(hill_sphere_state(&sphere, 0.05, 0.06, 15.0).rr);
    ck_assert_near(hill_sphere_front(&sphere, hill_sphere_first_yield(&sphere)), 10.0, ROUND_OFF);
}
END_TEST

static struct plastic_tube_run *tube_under(double pressure, double poisson, size_t elements)
{
    const struct plastic_tube tube = {10.0, 20.0, 1000.0, poisson, 0.1, elements, 40};
    struct plastic_tube_run *const run = plastic_tube_create(&tube);
    ck_assert(plastic_tube_load(run, pressure));
    return run;
}

/* h^2/8 times the second derivatives of stress (6 p/a^2) and displacement, h = 10/400. */
static const double LINEAR = 1e-6;

START_TEST(an_elastic_tube_is_lames)
{
    struct plastic_tube_run *const run = tube_under(0.03, 0.3, 400);
    const struct lame_cylinder cylinder = {10.0, 20.0, 0.03, 0.0, 1000.0, 0.3};
    for (double r = 10.0; r <= 20.0; r += 0.37) {
        const struct lame_state exact = lame_cylinder_state(&cylinder, r);
        const struct plastic_tube_state s = plastic_tube_at(run, r);
        ck_assert_near(s.rr, exact.rr, LINEAR);
        ck_assert_near(s.tt, exact.tt, LINEAR);
        ck_assert_near(s.zz, exact.zz, LINEAR);
        ck_assert_near(s.u, exact.u, LINEAR);
    }
    ck_assert_double_eq(plastic_tube_front(run), 10.0);
    plastic_tube_free(run);
}
END_TEST

/* At nu = 0.4999 a part of 1 - 2 nu of stresses is left; an element of 10/400 at the front. */
static const double NEARLY = 2e-5, ELEMENT = 0.026;

START_TEST(a_tube_that_keeps_its_volume_is_hills)
{
    const double k = 0.1 / sqrt(3.0), c = 14.0;
    const double pressure = 2.0 * k * log(c / 10.0) + k * (1.0 - c * c / 400.0);
    struct plastic_tube_run *const run = tube_under(pressure, 0.4999, 400);
    ck_assert_near(plastic_tube_front(run), c, ELEMENT);
    for (double r = 10.1; r < 20.0; r += 0.5) {
        const struct plastic_tube_state s = plastic_tube_at(run, r);
        const double rr = r <= c ? -pressure + 2.0 * k * log(r / 10.0)
                                 : -k * c * c * (1.0 / (r * r) - 1.0 / 400.0);
        const double swing = r <= c ? k : k * c * c / (r * r);
        ck_assert_near(s.rr, rr, NEARLY);
        ck_assert_near(s.tt, rr + 2.0 * swing, NEARLY);
        ck_assert_near(s.zz, rr + swing, NEARLY);
        /* u r = c^2 k/(2 G), G = E/3 */
        ck_assert_near(s.u * r, c * c * k / (2.0 * 1000.0 / 3.0), 20.0 * NEARLY);
    }
    plastic_tube_free(run);
}
END_TEST

START_TEST(a_tube_unloads_as_an_elastic_one)
{
    const double peak = 0.065;
    const struct lame_cylinder fall = {10.0, 20.0, peak, 0.0, 1000.0, 0.3};
    struct plastic_tube_run *const loaded = tube_under(peak, 0.3, 400);
    struct plastic_tube_run *const unloaded = tube_under(peak, 0.3, 400);
    ck_assert(plastic_tube_load(unloaded, 0.0));
    for (double r = 10.0; r <= 20.0; r += 0.37) {
        const struct lame_state less = lame_cylinder_state(&fall, r);
        const struct plastic_tube_state before = plastic_tube_at(loaded, r);
        const struct plastic_tube_state after = plastic_tube_at(unloaded, r);
        ck_assert_near(after.rr, before.rr - less.rr, 2.0 * LINEAR);
        ck_assert_near(after.tt, before.tt - less.tt, 2.0 * LINEAR);
        ck_assert_near(after.zz, before.zz - less.zz, 2.0 * LINEAR);
        ck_assert_near(after.u, before.u - less.u, LINEAR);
    }
    ck_assert_double_gt(plastic_tube_front(unloaded), 13.0);
    plastic_tube_free(loaded);
    plastic_tube_free(unloaded);
}
END_TEST

/* What P4 takes, 500 elements and 400 steps: 2e-4 of Y in the axial stress, of first order in the
 * steps, and 2e-5 of the displacement of the inner face, which is 1.6e-3. */
static const double TURNED = 2e-5, MOVED = 3e-8;

START_TEST(elements_and_steps_of_a_tube_are_enough)
{
    const struct plastic_tube coarse = {10.0, 20.0, 1000.0, 0.3, 0.1, 500, 400};
    const struct plastic_tube fine = {10.0, 20.0, 1000.0, 0.3, 0.1, 1000, 1600};
    struct plastic_tube_run *const one = plastic_tube_create(&coarse);
    struct plastic_tube_run *const other = plastic_tube_create(&fine);
    ck_assert(plastic_tube_load(one, 0.065) && plastic_tube_load(other, 0.065));
    for (double r = 10.0; r <= 20.0; r += 0.17) {
        const struct plastic_tube_state a = plastic_tube_at(one, r), b = plastic_tube_at(other, r);
        ck_assert_near(a.rr, b.rr, TURNED);
        ck_assert_near(a.tt, b.tt, TURNED);
        ck_assert_near(a.zz, b.zz, TURNED);
        ck_assert_near(a.u, b.u, MOVED);
    }
    plastic_tube_free(one);
    plastic_tube_free(other);
}
END_TEST

START_TEST(a_tube_has_no_equilibrium_beyond_its_limit)
{
    const struct plastic_tube tube = {10.0, 20.0, 1000.0, 0.3, 0.1, 50, 10};
    struct plastic_tube_run *const run = plastic_tube_create(&tube);
    ck_assert(!plastic_tube_load(run, 2.0 / sqrt(3.0) * 0.1 * log(2.0) * 1.02));
    plastic_tube_free(run);
}
END_TEST

/* Small steps of the strain: the law of small strains along one axis, integrated. */
static void strain_evenly(const struct plastic_wave *wave, double strain, double *pressure,
                          double *q, double *plastic)
{
    enum { STEPS = 1000 };
    *q = *plastic = 0.0;
    for (int k = 1; k <= STEPS; k++) {
        const double e = strain * k / STEPS;
        const double trial = 3.0 * wave->shear * (2.0 / 3.0 * e - *plastic);
        const double over = trial - wave->yield - wave->hardening * *plastic;
        if (over > 0.0)
            *plastic += over / (3.0 * wave->shear + wave->hardening);
        *q = 3.0 * wave->shear * (2.0 / 3.0 * e - *plastic);
    }
    *pressure = wave->bulk * strain + 2.0 / 3.0 * *q;
}

START_TEST(fronts_of_a_plastic_wave_balance_mass_and_momentum)
{
    static const double hardenings[] = {0.0, 0.3};
    const struct plastic_wave wave = {0.6, 0.3, 2.0, 6e-6, hardenings[_i], 3e-5};
    const struct plastic_wave_fronts fronts = plastic_wave_fronts(&wave);
    const struct plastic_wave_state *const first = &fronts.precursor, *const last = &fronts.plastic;
    double pressure, q, plastic;
    ck_assert_near(first->pressure, wave.yield * (0.6 / 0.6 + 2.0 / 3.0), 1e-20);
    ck_assert_near(first->pressure,
                   wave.density * first->celerity * (wave.speed - first->remaining), 1e-19);
    ck_assert_near(first->strain * first->celerity, wave.speed - first->remaining, 1e-19);
    ck_assert_near(last->pressure - first->pressure,
                   wave.density * last->celerity * (first->remaining - last->remaining), 1e-19);
    ck_assert_near((last->strain - first->strain) * last->celerity,
                   first->remaining - last->remaining, 1e-19);
    ck_assert_double_eq(last->remaining, 0.0);
    ck_assert(last->celerity < first->celerity);
    strain_evenly(&wave, last->strain, &pressure, &q, &plastic);
    ck_assert_near(last->pressure, pressure, 1e-17);
    ck_assert_near(last->lateral, pressure - q, 1e-17);
    ck_assert_near(last->plastic, plastic, 1e-17);
}
END_TEST

Suite *suite_plastic_states(void)
{
    Suite *suite = suite_create("plastic_states");
    TCase *tests = tcase_create("plastic_states");
    tcase_add_loop_test(tests, a_sphere_is_in_equilibrium_within_yield_and_bears_its_pressure, 0,
                        LOADS);
    tcase_add_loop_test(tests, volume_strain_of_a_sphere_is_elastic_and_hoops_are_beyond_the_front,
                        0, LOADS);
    tcase_add_test(tests, a_sphere_beyond_its_limits_has_no_state);
    tcase_add_test(tests, an_elastic_tube_is_lames);
    tcase_add_test(tests, a_tube_that_keeps_its_volume_is_hills);
    tcase_add_test(tests, a_tube_unloads_as_an_elastic_one);
    tcase_add_test(tests, elements_and_steps_of_a_tube_are_enough);
    tcase_add_test(tests, a_tube_has_no_equilibrium_beyond_its_limit);
    tcase_add_loop_test(tests, fronts_of_a_plastic_wave_balance_mass_and_momentum, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}

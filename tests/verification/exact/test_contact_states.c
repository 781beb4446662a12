/* The exact solutions of family C against what they must satisfy: jumps at fronts, momentum and
 * energy, balance, surfaces and interfaces.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "verification/exact/contact/inclusion.h"
#include "verification/exact/contact/laminate.h"
#include "verification/exact/contact/struck_bars.h"

#include <glib.h>
#include <math.h>

/* ---------------------------------------------------------------- two bars */

static const struct struck_bars bars[] = {
    {{32, 64}, {1, 1}, {1, 1}, 0.01, 0.5},
    {{3, 20}, {2, 8}, {1.5, 3}, 0.2, 0},
    {{5, 5}, {70, 200}, {2.7, 7.8}, 1e-3, 1},
};
enum { CELLS = 4000 };

/* Momentum and energy of bar `bar` at a time, by the midpoint rule: fronts leave at most one cell
 * wrong by what jumps there. */
static void sums(const struct struck_bars *b, int bar, double time, double *momentum,
                 double *energy)
{
    const double step = b->length[bar] / CELLS;
    *momentum = *energy = 0.0;
    for (int k = 0; k < CELLS; k++) {
        const struct struck_state state = struck_bars_state(b, bar, (k + 0.5) * step, time);
        *momentum += step * b->density[bar] * state.velocity;
        *energy += step * (0.5 * b->density[bar] * state.velocity * state.velocity +
                           0.5 * state.stress * state.stress / b->modulus[bar]);
    }
}

START_TEST(struck_bars_keep_momentum_and_energy_and_each_gains_the_impulse)
{
    const struct struck_bars *const b = &bars[_i];
    const double mass = b->density[0] * b->length[0], hit = b->gap / b->speed;
    const double lasts = struck_bars_duration(b), tolerance = 8.0 / CELLS;
    ck_assert(struck_bars_are_solved(b));
    for (double time = 0.0; time < hit + 5.0 * lasts; time += 0.0917 * lasts) {
        double momentum[2], energy[2];
        const double pressed = fmin(fmax(time - hit, 0.0), lasts);
        for (int bar = 0; bar < 2; bar++)
            sums(b, bar, time, &momentum[bar], &energy[bar]);
        ck_assert_near(momentum[1], struck_bars_pressure(b) * pressed, tolerance * mass * b->speed);
        ck_assert_near(momentum[0] + momentum[1], mass * b->speed, tolerance * mass * b->speed);
        ck_assert_near(energy[0] + energy[1], 0.5 * mass * b->speed * b->speed,
                       tolerance * mass * b->speed * b->speed);
    }
}
END_TEST

START_TEST(struck_bars_have_one_velocity_and_pressure_in_contact_and_free_ends)
{
    const struct struck_bars *const b = &bars[_i];
    const double hit = b->gap / b->speed, lasts = struck_bars_duration(b);
    for (double part = 0.01; part < 3.0; part += 0.0731) {
        const double time = hit + part * lasts;
        const struct struck_state first = struck_bars_state(b, 0, 0, time);
        const struct struck_state second = struck_bars_state(b, 1, 0, time);
        for (int bar = 0; bar < 2; bar++)
            ck_assert_near(struck_bars_state(b, bar, b->length[bar], time).stress, 0.0,
                           1e-12 * struck_bars_pressure(b));
        if (part < 1.0) {
            ck_assert_near(first.stress, -struck_bars_pressure(b), 1e-14);
            ck_assert_near(second.stress, first.stress, 1e-14 * struck_bars_pressure(b));
            ck_assert_near(second.velocity, struck_bars_velocity(b), 1e-14);
            ck_assert_near(first.velocity, second.velocity, 1e-14 * b->speed);
        } else {
            ck_assert_near(first.stress, 0.0, 1e-12 * struck_bars_pressure(b));
            ck_assert(second.velocity >= first.velocity); /* they part, and stay apart */
        }
    }
}
END_TEST

/* From the momenta, at an end when both bars are apart. */
START_TEST(restitution_is_that_of_the_mean_velocities_and_l1_over_l2_for_one_material)
{
    const struct struck_bars *const b = &bars[_i];
    double momentum[2], energy;
    for (int bar = 0; bar < 2; bar++)
        sums(b, bar, b->gap / b->speed + 1.5 * struck_bars_duration(b), &momentum[bar], &energy);
    const double e = (momentum[1] / (b->density[1] * b->length[1]) -
                      momentum[0] / (b->density[0] * b->length[0])) /
                     b->speed;
    ck_assert_near(struck_bars_restitution(b), e, 20.0 / CELLS);
    if (_i == 0)
        ck_assert_near(struck_bars_restitution(b), 0.5, 1e-15);
}
END_TEST

START_TEST(bars_whose_echoes_come_in_another_order_are_refused)
{
    struct struck_bars other = bars[1];
    other.modulus[0] = 100;
    ck_assert(!struck_bars_are_solved(&other));
    other = bars[1];
    other.length[0] = 100;
    ck_assert(!struck_bars_are_solved(&other));
}
END_TEST

/* ----------------------------------------------------------------- laminate */

/* The work of the traction, half of it times the way of the end, is in both layers and in the
 * interface. */
START_TEST(the_work_on_a_laminate_is_what_layers_and_interface_store)
{
    const struct laminate l = {{8, 5}, {1, 4}, 0.25};
    const double t = -0.3;
    const double layers = 0.5 * t * t * (8.0 / 1.0 + 5.0 / 4.0);
    ck_assert_near(0.5 * t * laminate_displacement(&l, t, 13.0), layers + laminate_stored(&l, t),
                   1e-15);
    ck_assert_near(laminate_modulus(&l), t * 13.0 / laminate_displacement(&l, t, 13.0), 1e-14);
    ck_assert_near(laminate_displacement(&l, t, 8.0 + 1e-12) - laminate_displacement(&l, t, 8.0),
                   t / l.interface, 1e-11);
    ck_assert_near(laminate_displacement(&l, t, 3.0), 3.0 * t, 1e-15);
}
END_TEST

/* ---------------------------------------------------------------- inclusion */

static const struct inclusion inclusions[] = {
    {2, 4, 12, {2, 0.6}, {1.5, 0.3}, 0.5, 1e-3},
    {3, 4, 12, {2, 0.6}, {1.5, 0.3}, 0.5, 1e-3},
    {3, 1, 2, {0.1, 7}, {0.05, 3}, 40, -0.1},
};

/* d sigma_rr/dr + (d - 1)(sigma_rr - sigma_tt)/r = 0, and Hooke's law, by central differences:
 * 1e-8 of third derivatives and 1e-12 of round-off over the step. */
START_TEST(an_inclusion_and_its_matrix_are_in_balance_and_obey_hookes_law)
{
    const struct inclusion *const c = &inclusions[_i];
    const double step = 1e-4 * c->radius, scale = fabs(inclusion_state(c, 0.5 * c->radius).rr);
    for (double r = 0.3 * c->radius; r < c->outer; r += 0.171 * c->radius) {
        const int body = r > c->radius;
        const struct inclusion_state low = inclusion_state(c, r - step),
                                     high = inclusion_state(c, r + step),
                                     here = inclusion_state(c, r);
        const double strain = (high.u - low.u) / (2.0 * step), hoop = here.u / r;
        const double trace = strain + (c->dimensions - 1) * hoop;
        const double lambda = c->bulk[body] - 2.0 / 3.0 * c->shear[body];
        if (fabs(r - c->radius) < 2.0 * step)
            continue;
        ck_assert_near((high.rr - low.rr) / (2.0 * step) * r +
                           (c->dimensions - 1) * (here.rr - here.tt),
                       0.0, 1e-5 * scale);
        ck_assert_near(here.rr, lambda * trace + 2.0 * c->shear[body] * strain, 1e-5 * scale);
        ck_assert_near(here.tt, lambda * trace + 2.0 * c->shear[body] * hoop, 1e-5 * scale);
    }
}
END_TEST

START_TEST(an_inclusions_interface_bears_its_stress_at_its_jump)
{
    const struct inclusion *const c = &inclusions[_i];
    const struct inclusion_state inside = inclusion_state(c, c->radius),
                                 outside = inclusion_state(c, c->radius * (1.0 + 1e-14));
    const double scale = fabs(inside.rr);
    ck_assert_near(inside.rr, outside.rr, 1e-11 * scale);
    ck_assert_near((outside.u - inside.u) * c->interface, inside.rr, 1e-10 * scale);
    ck_assert_near(inclusion_state(c, c->outer).u, c->displacement, 1e-14);
    ck_assert_near(inside.rr,
                   c->dimensions * inclusion_effective_modulus(c) * outside.u / c->radius,
                   1e-10 * scale);
}
END_TEST

Suite *suite_contact_states(void)
{
    Suite *suite = suite_create("contact_states");
    TCase *tests = tcase_create("exact");
    tcase_add_loop_test(tests, struck_bars_keep_momentum_and_energy_and_each_gains_the_impulse, 0,
                        G_N_ELEMENTS(bars));
    tcase_add_loop_test(tests, struck_bars_have_one_velocity_and_pressure_in_contact_and_free_ends,
                        0, G_N_ELEMENTS(bars));
    tcase_add_loop_test(tests,
                        restitution_is_that_of_the_mean_velocities_and_l1_over_l2_for_one_material,
                        0, G_N_ELEMENTS(bars));
    tcase_add_test(tests, bars_whose_echoes_come_in_another_order_are_refused);
    tcase_add_test(tests, the_work_on_a_laminate_is_what_layers_and_interface_store);
    tcase_add_loop_test(tests, an_inclusion_and_its_matrix_are_in_balance_and_obey_hookes_law, 0,
                        G_N_ELEMENTS(inclusions));
    tcase_add_loop_test(tests, an_inclusions_interface_bears_its_stress_at_its_jump, 0,
                        G_N_ELEMENTS(inclusions));
    suite_add_tcase(suite, tests);
    return suite;
}

/* Heat of plastic work that a conducted temperature gets, and its strength that follows it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/law_state.h"
#include "suites.h"
#include "support/heat_block.h"
#include "support/near.h"
#include "support/settings.h"

#include <glib.h>
#include <math.h>

/* All nodes are prescribed; yield after 0.02 of strain. */
#define EVEN "boundary=[{region: all, velocity: ['0.4*(x-6)', '-0.4*(y-5)']}]"
#define JOHNSON_COOK                                                                               \
    "law: johnson_cook, density: 2, bulk: 3, shear: 1, yield_stress: 0.05, "                       \
    "hardening_coefficient: "                                                                      \
    "0.1, hardening_exponent: 0.4, softening_exponent: 1.2, reference_temperature: 1, "            \
    "melting_temperature: 1.5, taylor_quinney: 0.9"
#define CONDUCTED ", heat_capacity: 0.1, conductivity: 0.2"

static struct test_run run_even(const char *material, const char *const *more, int steps)
{
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "materials=[{name: soft, %s}]", material);
    settings_add(&settings, EVEN);
    settings_add(&settings, "bodies.0.velocity=['0.4*(x-6)', '-0.4*(y-5)']");
    for (; *more != NULL; more++)
        settings_add(&settings, *more);
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
    test_run_steps(&run, steps);
    settings_clear(&settings);
    return run;
}

/* In even motion nothing flows, and the temperature of either is that of the plastic work. */
START_TEST(strength_follows_a_conducted_temperature_as_its_own)
{
    static const char *const conducting[] = {"time={end: 1000, step: 0.01}",
                                             "transport={temperature: {start: 1.1, heating: true}}",
                                             NULL};
    static const char *const alone[] = {"time={end: 1000, step: 0.01}", "transport={}", NULL};
    struct test_run one = run_even(JOHNSON_COOK CONDUCTED, conducting, 20);
    struct test_run other =
        run_even(JOHNSON_COOK ", start_temperature: 1.1, specific_heat: 0.1", alone, 20);
    const struct mpm_particles *const mine = &one.simulation->state.particles;
    const struct mpm_particles *const theirs = &other.simulation->state.particles;
    ck_assert_uint_eq(mine->count, theirs->count);
    ck_assert_double_gt(mine->temperature[0], 1.11);
    for (size_t p = 0; p < mine->count; p++) {
        ck_assert_near(mine->temperature[p],
                       mpm_particle_state_temperature(&other.simulation->state, p), 1e-12);
        for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
            ck_assert_near(mine->stress[k][p], theirs->stress[k][p], 1e-12);
    }
    test_run_close(&one);
    test_run_close(&other);
}
END_TEST

START_TEST(a_conducted_temperature_melts)
{
    static const char *const hot[] = {"time={end: 1000, step: 0.01}",
                                      "transport={temperature: {start: 1.6, heating: true}}", NULL};
    struct test_run run = run_even(JOHNSON_COOK CONDUCTED, hot, 4);
    const struct mpm_ledger ledger = test_run_ledger(&run);
    ck_assert_uint_eq(ledger.melted_particles, run.simulation->state.particles.count);
    ck_assert_near(ledger.plastic_heat, 0.0, 0.0);
    test_run_close(&run);
}
END_TEST

#define VON_MISES                                                                                  \
    "law: von_mises, density: 2, bulk: 3, shear: 1, yield_stress: 0.05, hardening_modulus: 0.2, "  \
    "taylor_quinney: 0.6, heat_capacity: 0.5, conductivity: 0.2"
#define EXPANDING ", thermal_expansion: 0.03, stress_free_temperature: 2"

/* What total_energy, expansion_work, thermal_energy and thermoelastic_energy have together beyond
 * work from outside, over the heat of plastic work. Loads on nodes and losses are left out by
 * transfer_loss. */
static double gap_of(int parts)
{
    char *const time = g_strdup_printf("time={end: 1000, step: %g}", 0.02 / parts);
    const char *const more[] = {time, "transport={temperature: {start: 2, heating: true}}",
                                "output={energy_balance: true}", "method.stress_update=usavg",
                                NULL};
    struct test_run run = run_even(VON_MISES EXPANDING, more, 0);
    const double before = heat_block_heat(&run), start = test_run_ledger(&run).total_energy;
    test_run_steps(&run, 20 * parts);
    const struct mpm_ledger ledger = test_run_ledger(&run);
    ck_assert_double_gt(ledger.plastic_heat, 0.1);
    ck_assert_near(heat_block_heat(&run) - before, ledger.deformation_heat, 1e-12);
    const double gap = ledger.total_energy - start + ledger.transfer_loss + ledger.expansion_work +
                       ledger.thermoelastic_energy + ledger.deformation_heat - ledger.external_work;
    test_run_close(&run);
    g_free(time);
    return fabs(gap) / ledger.plastic_heat;
}

START_TEST(the_first_law_closes_with_the_step_beside_thermoelastic_heat)
{
    const double coarse = gap_of(1), fine = gap_of(2), finest = gap_of(4);
    ck_assert_double_lt(coarse, 1e-3);
    ck_assert_double_lt(fine, 0.6 * coarse);
    ck_assert_double_lt(finest, 0.6 * fine);
}
END_TEST

/* Beside held nodes particles get no heat that only nodes without conditions take away again. */
START_TEST(held_nodes_take_the_heat_of_the_particles_beside_them)
{
    static const char *const held[] = {
        "time={end: 1000, step: 0.02}",
        "transport={temperature: {start: 2, heating: true, conditions: [{region: all, value: 2}]}}",
        NULL};
    struct test_run run = run_even(VON_MISES, held, 20);
    const struct mpm_particles *const particles = &run.simulation->state.particles;
    const struct mpm_ledger ledger = test_run_ledger(&run);
    const double mean = ledger.plastic_heat / (0.5 * ledger.mass); /* without conduction */
    double worst = 0.0;
    for (size_t p = 0; p < particles->count; p++)
        worst = fmax(worst, fabs(particles->temperature[p] - 2.0));
    ck_assert_double_gt(mean, 0.005);
    ck_assert_double_lt(worst, 0.1 * mean); /* that of one step in twenty */
    test_run_close(&run);
}
END_TEST

/* Of the first row of particles, after some steps at rest beside a side held at 0, from 1. One
 * particle in a cell across: S = 1/2 at the side and at the row of nodes above it. */
static double beside_a_cold_side(bool heating, double step, int steps)
{
    char *const time = g_strdup_printf("time={end: 1000, step: %g}", step);
    char *const transport = g_strdup_printf(
        "transport={temperature: {start: 1%s, conditions: [{region: {line: {from: [0, 3.2], to: "
        "[14, 3.2]}}, value: 0}]}}",
        heating ? ", heating: true" : "");
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings,
                           "materials=[{name: soft, law: von_mises, density: 2, bulk: 3, "
                           "shear: 1, yield_stress: 0.05, heat_capacity: 0.5, "
                           "conductivity: 1e-14%s}]",
                           heating ? ", taylor_quinney: 0.6" : "");
    settings_add(&settings, time);
    settings_add(&settings, transport);
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
    test_run_steps(&run, steps);
    const struct mpm_particles *const particles = &run.simulation->state.particles;
    double beside = (double)NAN;
    for (size_t p = 0; p < particles->count; p++) {
        if (particles->position[1][p] > 4.0)
            ck_assert_near(particles->temperature[p], 1.0, 1e-12);
        else
            beside = particles->temperature[p];
    }
    test_run_close(&run);
    settings_clear(&settings);
    g_free(time);
    g_free(transport);
    return beside;
}

/* docs/heat.md: D is -1 in the first step and a quarter of the last one in each further step, and
 * moves the row by half of it; no matter how long a step is. Without heat of deformation the first
 * step does it all. */
START_TEST(held_nodes_settle_by_steps_and_not_by_time)
{
    static const double lengths[] = {1e-2, 1e-5};
    for (int k = 0; k < 2; k++)
        for (int steps = 1; steps <= 6; steps++) {
            const double moved = 2.0 / 3.0 * (1.0 - pow(0.25, steps));
            ck_assert_near(beside_a_cold_side(true, lengths[k], steps), 1.0 - moved, 1e-12);
            ck_assert_near(beside_a_cold_side(false, lengths[k], steps), 0.5, 1e-12);
        }
}
END_TEST

/* The coldest particle's rise over that of a particle far from the held side, by the step. */
static double coldest_beside_held_nodes(int parts)
{
    char *const time = g_strdup_printf("time={end: 1000, step: %g}", 0.02 / parts);
    const char *const more[] = {
        time,
        "transport={temperature: {start: 2, heating: true, conditions: [{region: {line: {from: [0, "
        "3.2], to: [14, 3.2]}}, value: 2}]}}",
        NULL};
    struct test_run run = run_even(VON_MISES, more, 20 * parts);
    const struct mpm_particles *const particles = &run.simulation->state.particles;
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (size_t p = 0; p < particles->count; p++) {
        least = fmin(least, particles->temperature[p] - 2.0);
        most = fmax(most, particles->temperature[p] - 2.0);
    }
    test_run_close(&run);
    g_free(time);
    ck_assert_double_gt(most, 0.005);
    return least / most;
}

/* What is heated at a rate leaves beside held nodes what is of first order in the step. */
START_TEST(half_the_step_halves_what_heat_leaves_beside_held_nodes)
{
    const double coarse = coldest_beside_held_nodes(1), fine = coldest_beside_held_nodes(2),
                 finest = coldest_beside_held_nodes(4);
    ck_assert_double_gt(fabs(coarse - fine), 1e-6);
    ck_assert_double_lt(fabs(fine - finest), 0.6 * fabs(coarse - fine));
}
END_TEST

Suite *suite_plastic_heat(void)
{
    Suite *suite = suite_create("plastic_heat");
    TCase *heating = tcase_create("heating");
    tcase_add_test(heating, strength_follows_a_conducted_temperature_as_its_own);
    tcase_add_test(heating, a_conducted_temperature_melts);
    tcase_add_test(heating, the_first_law_closes_with_the_step_beside_thermoelastic_heat);
    tcase_add_test(heating, held_nodes_take_the_heat_of_the_particles_beside_them);
    tcase_add_test(heating, held_nodes_settle_by_steps_and_not_by_time);
    tcase_add_test(heating, half_the_step_halves_what_heat_leaves_beside_held_nodes);
    suite_add_tcase(suite, heating);
    return suite;
}

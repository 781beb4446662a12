/* Heat and mechanics: expansion, gases and heat of deformation, with every family, geometry and
 * order of the stress update.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/transfer.h"
#include "suites.h"
#include "support/combinations.h"
#include "support/heat_block.h"
#include "support/near.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of the block: rho_0, moduli, alpha, the temperature without stress, c, R. */
static const double DENSITY = 2.0, BULK = 1.25, SHEAR = 0.75, ALPHA = 0.1, FREE = 1.5,
                    CAPACITY = 0.5, GAS = 0.3;

#define MATERIAL(law, conductivity, more)                                                          \
    "materials=[{name: soft, law: " law                                                            \
    ", density: 2, heat_capacity: 0.5, conductivity: " conductivity ", " more "}]"
#define SOLID "bulk: 1.25, shear: 0.75, thermal_expansion: 0.1, stress_free_temperature: 1.5"

enum law { NEO_HOOKEAN, LINEAR_ELASTIC, IDEAL_GAS, LAWS };
static const char *const without_conduction[LAWS] = {
    MATERIAL("neo_hookean", "0", SOLID), MATERIAL("linear_elastic", "0", SOLID),
    MATERIAL("ideal_gas", "0", "gas_constant: 0.3")};
static const char *const conducting[LAWS] = {MATERIAL("neo_hookean", "0.25", SOLID),
                                             MATERIAL("linear_elastic", "0.25", SOLID),
                                             MATERIAL("ideal_gas", "0.25", "gas_constant: 0.3")};

#define HEATING "transport.temperature.heating=true"

static bool is_axisymmetric(int index)
{
    return test_combination(index).axisymmetric;
}

static bool is_plane_stress(int index)
{
    return strcmp(test_combination(index).geometry, "plane_stress") == 0;
}

/* Gases have no plane stress. */
static int laws_of(int index)
{
    return is_plane_stress(index) ? IDEAL_GAS : LAWS;
}

/* tau / rho_0 of the law at F exp(-alpha (T - T_0)) */
static void stress_at(const struct mpm_state *state, size_t p, double temperature,
                      double stress[MPM_SYMMETRIC_SIZE])
{
    const struct mpm_material *const material = &state->bodies[state->particles.body[p]].material;
    double f[MPM_GRADIENT_SIZE], unused;
    mpm_particle_deformation(&state->particles, p, f);
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        f[k] *= exp(-ALPHA * (temperature - FREE));
    material->law->stress(material, f, stress, &unused);
}

static double trace(const struct mpm_particles *particles, size_t p)
{
    return particles->stress[MPM_SYM_XX][p] + particles->stress[MPM_SYM_YY][p] +
           particles->stress[MPM_SYM_ZZ][p];
}

/* ------------------------------------------------------- a block that is held */

static const char HELD[] = "boundary=[{region: all, velocity: [0, 0]}]";
static const char HEATED[] = "transport.temperature.conditions=[{region: all, value: '2+0.5*t'}]";

/* In the plane and along the thickness, F = (1, 1, F_zz). neo-Hookean: tau = K/2 (J^2 - 1). Linear
 * elastic with the stretches s and t: tau = s (2 G (s - 1) + lambda (2 (s - 1) + t - 1)), and t of
 * tau_zz = 0. */
static double held_stress(enum law law, bool plane_stress, double temperature, double *thickness)
{
    const double free = exp(ALPHA * (temperature - FREE)), s = 1.0 / free;
    const double lambda = BULK - 2.0 / 3.0 * SHEAR;
    *thickness = 1.0;
    if (law == IDEAL_GAS)
        return -GAS * temperature;
    if (law == NEO_HOOKEAN)
        return 0.5 * BULK / DENSITY * (pow(s, 6.0) - 1.0);
    const double t = plane_stress ? 1.0 - 2.0 * lambda * (s - 1.0) / (2.0 * SHEAR + lambda) : s;
    *thickness = t * free;
    return s * (2.0 * SHEAR * (s - 1.0) + lambda * (2.0 * (s - 1.0) + t - 1.0)) / DENSITY;
}

START_TEST(a_block_that_is_held_has_the_stress_of_its_law_without_the_free_strain)
{
    for (int law = 0; law < laws_of(_i); law++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, conducting[law]);
        settings_add(&settings, HELD);
        settings_add(&settings, HEATED);
        settings_add(&settings, "transport.temperature.start=2");
        struct test_run run = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
        test_run_steps(&run, 5);
        const struct mpm_state *const state = &run.simulation->state;
        const double temperature = 2.0 + 0.5 * mpm_simulation_time(run.simulation);
        double thickness;
        const double wanted =
            held_stress((enum law)law, is_plane_stress(_i), temperature, &thickness);
        for (size_t p = 0; p < state->particles.count; p++) {
            double of_law[MPM_SYMMETRIC_SIZE];
            const double *const *const tau = (const double *const *)state->particles.stress;
            if (law == LINEAR_ELASTIC || !is_plane_stress(_i)) {
                ck_assert_near(tau[MPM_SYM_XX][p], wanted, HEAT_BLOCK_ROUND_OFF);
                ck_assert_near(tau[MPM_SYM_YY][p], wanted, HEAT_BLOCK_ROUND_OFF);
                ck_assert_near(state->particles.deformation[MPM_ZZ][p], thickness,
                               HEAT_BLOCK_ROUND_OFF);
            }
            ck_assert_near(tau[MPM_SYM_ZZ][p], is_plane_stress(_i) ? 0.0 : wanted,
                           HEAT_BLOCK_ROUND_OFF);
            if (law == IDEAL_GAS)
                continue;
            stress_at(state, p, temperature, of_law);
            ck_assert_near(tau[MPM_SYM_XX][p], of_law[MPM_SYM_XX], HEAT_BLOCK_ROUND_OFF);
        }
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* Particles keep temperatures that vary within a cell; their gas has those of the grid. */
START_TEST(laws_have_the_temperature_of_the_grid)
{
    struct settings settings = test_combination_settings(_i);
    const bool solid = is_plane_stress(_i);
    settings_add(&settings, without_conduction[solid ? LINEAR_ELASTIC : IDEAL_GAS]);
    settings_add(&settings, HELD);
    heat_block_add_wild_heat(&settings, is_axisymmetric(_i));
    settings_add(&settings, is_axisymmetric(_i) ? "transport.temperature.start='3+sin(3*r)'"
                                                : "transport.temperature.start='3+sin(3*x)'");
    settings_add(&settings, "transport.temperature.source=0");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
    test_run_steps(&run, 3);
    const struct mpm_state *const state = &run.simulation->state;
    double apart = 0.0;
    for (size_t p = 0; p < state->particles.count; p++) {
        struct mpm_stencil room;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        double of_grid = 0.0, thickness;
        for (int k = 0; k < stencil->count; k++)
            of_grid += stencil->node[k].s *
                       heat_block_scalar(&run)->value[state->node_zero + stencil->node[k].node];
        ck_assert_near(state->particles.stress[MPM_SYM_XX][p],
                       held_stress(solid ? LINEAR_ELASTIC : IDEAL_GAS, solid, of_grid, &thickness),
                       HEAT_BLOCK_ROUND_OFF);
        apart = fmax(apart, fabs(of_grid - state->particles.temperature[p]));
    }
    ck_assert_double_gt(apart, 0.1);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* F = exp(alpha (T - T_0)) of all axes: planar bodies in plane stress, where F_zz follows. */
START_TEST(a_body_that_has_expanded_has_no_stress)
{
    if (!is_plane_stress(_i) && !is_axisymmetric(_i))
        return;
    for (int law = 0; law < IDEAL_GAS; law++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, conducting[law]);
        settings_add(&settings, "transport.temperature.start=3");
        struct test_run run = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
        struct mpm_error error = {.message = ""};
        const struct mpm_particles *const particles = &run.simulation->state.particles;
        const double free = exp(ALPHA * (3.0 - FREE));
        double *const start = g_new0(double, 5 * particles->count);
        for (size_t p = 0; p < particles->count; p++)
            start[5 * p] = start[5 * p + 3] = start[5 * p + 4] = free;
        ck_assert_msg(mpm_simulation_set_start(run.simulation, NULL, start, &error) == MPM_OK, "%s",
                      error.message);
        test_run_steps(&run, 3);
        for (size_t p = 0; p < particles->count; p++) {
            for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
                ck_assert_near(particles->stress[k][p], 0.0, HEAT_BLOCK_ROUND_OFF);
            ck_assert_near(particles->deformation[MPM_ZZ][p], free, HEAT_BLOCK_ROUND_OFF);
        }
        g_free(start);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* ------------------------------------------------------- heat of deformation */

/* Of the same F everywhere: along z alone with r, where gradients of hat functions are means. */
static void add_motion(struct settings *settings, bool axisymmetric)
{
    settings_add(settings, axisymmetric
                               ? "boundary=[{region: all, velocity: [0, '0.1*(z-5)*(1+t)']}]"
                               : "boundary=[{region: all, velocity: ['0.1*(x-6)*(1+t)+0.05*(y-5)', "
                                 "'0.06*(y-5)-0.07*(x-6)']}]");
}

static struct test_run open_moved(int index, enum law law, double sign)
{
    struct settings settings = test_combination_settings(index);
    settings_add(&settings, without_conduction[law]);
    settings_add(&settings, HEATING);
    add_motion(&settings, is_axisymmetric(index));
    settings_add(&settings, "transport.temperature.start=2");
    settings_add_formatted(&settings, "time={end: 1000, step: %g}", 0.05 * sign);
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
    settings_clear(&settings);
    return run;
}

/* c dT = - alpha T dX with X = tr(tau)/rho_0, so that ln T/T_0 = - alpha/c (X - X_0), whatever the
 * path and the step; the stress is that at the new temperature. */
START_TEST(a_solid_without_conduction_has_the_temperature_of_its_stress)
{
    for (int law = 0; law < IDEAL_GAS; law++) {
        struct test_run run = open_moved(_i, (enum law)law, 1.0);
        const struct mpm_state *const state = &run.simulation->state;
        const double begun = trace(&state->particles, 0), heat = heat_block_heat(&run);
        ck_assert_double_lt(begun, -0.02);
        test_run_steps(&run, 20);
        for (size_t p = 0; p < state->particles.count; p++) {
            const double temperature = state->particles.temperature[p];
            double of_law[MPM_SYMMETRIC_SIZE];
            ck_assert_near(log(temperature / 2.0),
                           -ALPHA / CAPACITY * (trace(&state->particles, p) - begun),
                           HEAT_BLOCK_ROUND_OFF);
            stress_at(state, p, temperature, of_law);
            for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
                ck_assert_near(state->particles.stress[k][p], of_law[k], HEAT_BLOCK_ROUND_OFF);
        }
        ck_assert_double_lt(state->particles.temperature[0], 1.99);
        ck_assert_near(test_run_ledger(&run).deformation_heat / heat,
                       heat_block_heat(&run) / heat - 1.0, HEAT_BLOCK_ROUND_OFF);
        test_run_close(&run);
    }
}
END_TEST

START_TEST(a_gas_without_conduction_keeps_its_entropy)
{
    if (is_plane_stress(_i))
        return;
    struct test_run run = open_moved(_i, IDEAL_GAS, 1.0);
    const struct mpm_state *const state = &run.simulation->state;
    test_run_steps(&run, 20);
    for (size_t p = 0; p < state->particles.count; p++) {
        double f[MPM_GRADIENT_SIZE];
        mpm_particle_deformation(&state->particles, p, f);
        const double temperature = state->particles.temperature[p];
        ck_assert_near(temperature * pow(mpm_determinant(f), GAS / CAPACITY), 2.0,
                       10.0 * HEAT_BLOCK_ROUND_OFF);
        ck_assert_near(state->particles.stress[MPM_SYM_YY][p], -GAS * temperature,
                       HEAT_BLOCK_ROUND_OFF);
    }
    ck_assert_double_lt(state->particles.temperature[0], 1.9);
    test_run_close(&run);
}
END_TEST

/* -------------------------------------------------------------------- sums */

/* All that acts: motion, heat within cells, a side that is held, fluxes. */
static struct test_run open_wild(int index, enum law law, bool heating)
{
    const bool axisymmetric = is_axisymmetric(index);
    struct settings settings = test_combination_settings(index);
    settings_add(&settings, conducting[law]);
    test_add_wild_velocity(&settings, axisymmetric);
    heat_block_add_wild_heat(&settings, axisymmetric);
    settings_add(&settings, axisymmetric ? "transport.temperature.start='3+sin(3*r)*cos(2*z)'"
                                         : "transport.temperature.start='3+sin(3*x)*cos(2*y)'");
    settings_add(&settings, HEAT_BLOCK_HOT_SIDE);
    settings_add(&settings, "transport.temperature.fluxes=[{body: block, edge: all, value: 0.3}]");
    settings_add(&settings, "loads={body_force: [0.1, 0.2]}");
    settings_add(&settings, "output={energy_balance: true}");
    if (heating)
        settings_add(&settings, HEATING);
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
    settings_clear(&settings);
    return run;
}

START_TEST(energy_and_heat_are_what_loads_flows_and_deformation_have_given)
{
    for (int k = 0; k < 2 * laws_of(_i); k++) {
        const bool heating = k % 2 == 1;
        struct test_run run = open_wild(_i, (enum law)(k / 2), heating);
        const struct mpm_ledger start = test_run_ledger(&run);
        const double heat = heat_block_heat(&run);
        test_run_steps(&run, test_combination(_i).amplifies_round_off ? 3 : 12);
        const struct mpm_ledger end = test_run_ledger(&run);
        const struct mpm_scalar_totals *const in = &heat_block_scalar(&run)->totals;
        const double scale = fabs(start.kinetic_energy) + fabs(end.strain_energy) +
                             fabs(end.expansion_work) + fabs(end.external_work) +
                             fabs(end.transfer_loss);
        ck_assert(fabs(end.expansion_work) > 1e-4 && fabs(end.transfer_loss) > 1e-4);
        ck_assert_near((end.total_energy + end.transfer_loss - end.external_work) / scale,
                       start.total_energy / scale, HEAT_BLOCK_ROUND_OFF);
        ck_assert(heating == (fabs(end.deformation_heat) > 1e-5));
        ck_assert_near(heat_block_heat(&run) / heat - 1.0,
                       (in->held + in->source + in->edges + end.deformation_heat) / heat,
                       HEAT_BLOCK_ROUND_OFF);
        test_run_close(&run);
    }
}
END_TEST

/* ------------------------------------------------------------------- twins */

START_TEST(a_material_that_does_not_expand_has_the_bits_of_one_without_the_key)
{
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, k == 0 ? MATERIAL("neo_hookean", "0.25", "bulk: 1.25, shear: 0.75")
                                       : MATERIAL("neo_hookean", "0.25",
                                                  "bulk: 1.25, shear: 0.75, thermal_expansion: 0, "
                                                  "stress_free_temperature: 1.5"));
        heat_block_add_wild_heat(&settings, is_axisymmetric(_i));
        test_add_wild_velocity(&settings, is_axisymmetric(_i));
        runs[k] = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
        test_run_steps(&runs[k], 20);
        settings_clear(&settings);
    }
    ck_assert(test_run_same_bits(&runs[0], &runs[1]));
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}
END_TEST

static const char HALF[] = "bodies.block.region.rectangle={from: [3, 5.6], to: [9, 8]}";
static const char PLANE[] =
    "boundary=[{region: {line: {from: [0, 5.6], to: [14, 5.6]}}, symmetry: true}]";

START_TEST(a_half_with_a_plane_of_symmetry_works_and_heats_as_half_of_the_whole)
{
    const bool axisymmetric = is_axisymmetric(_i);
    for (int law = 0; law < laws_of(_i); law++) {
        struct mpm_ledger ledgers[2];
        for (int k = 0; k < 2; k++) {
            struct settings settings = test_combination_settings(_i);
            settings_add(&settings, conducting[law]);
            settings_add(&settings,
                         axisymmetric ? "transport.temperature.start='3+sin(3*r)*cos(2*(z-5.6))'"
                                      : "transport.temperature.start='3+sin(3*x)*cos(2*(y-5.6))'");
            settings_add(&settings,
                         axisymmetric
                             ? "bodies.block.velocity=['0.1*cos(r)', '0.1*sin(2*(z-5.6))']"
                             : "bodies.block.velocity=['0.1*cos(x)', '0.1*sin(2*(y-5.6))']");
            settings_add(&settings, HEATING);
            settings_add(&settings, "time={end: 1000, step: 0.05}");
            if (k == 1) {
                settings_add(&settings, HALF);
                settings_add(&settings, PLANE);
            }
            struct test_run run = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
            test_run_steps(&run, test_combination(_i).amplifies_round_off ? 3 : 20);
            ledgers[k] = test_run_ledger(&run);
            test_run_close(&run);
            settings_clear(&settings);
        }
        ck_assert(fabs(ledgers[0].expansion_work) > 1e-3);
        ck_assert(fabs(ledgers[0].deformation_heat) > 1e-4);
        ck_assert_near(2.0 * ledgers[1].expansion_work, ledgers[0].expansion_work, 1e-10);
        ck_assert_near(2.0 * ledgers[1].deformation_heat, ledgers[0].deformation_heat, 1e-10);
        ck_assert_near(2.0 * ledgers[1].thermoelastic_energy, ledgers[0].thermoelastic_energy,
                       1e-10);
        ck_assert_near(2.0 * ledgers[1].total_energy, ledgers[0].total_energy, 1e-10);
    }
}
END_TEST

START_TEST(bits_of_bodies_that_expand_do_not_depend_on_threads)
{
    static const char moving[] = "bodies.block.velocity=['0.3*sin(2*x)*cos(y)', '0.4*cos(x+2*y)']";
    const char *const settings[] = {TEST_BLOCK_FOR_THREADS,
                                    conducting[_i],
                                    HEATING,
                                    "transport.temperature.start='3+sin(3*x)*cos(2*y)'",
                                    moving,
                                    "output={energy_balance: true}",
                                    NULL};
    test_same_bits_over_threads(HEAT_BLOCK, settings, 20, NULL);
}
END_TEST

/* ------------------------------------------------------------------ failures */

static void assert_same_scalars(const struct mpm_particles *one, const struct mpm_particles *other)
{
    const size_t size = one->count * sizeof(double);
    if (one->free_strain != NULL)
        ck_assert_mem_eq(one->free_strain, other->free_strain, size);
    ck_assert_mem_eq(one->law_temperature, other->law_temperature, size);
}

/* A source that is infinite from t = 1 on: the run goes back to the step before. */
START_TEST(a_failed_run_has_the_expansion_of_its_last_good_step)
{
    struct test_run runs[2];
    struct mpm_error error = {.message = ""};
    int steps = 0;
    for (int k = 0; k < 2; k++) {
        struct settings settings = {.count = 0};
        settings_add(&settings, conducting[_i]);
        settings_add(&settings, HEATING);
        settings_add(&settings, "time={end: 1000, step: 0.05}");
        settings_add(&settings, "transport.temperature.start='3+sin(3*x)*cos(2*y)'");
        settings_add(&settings, "transport.temperature.source='1/(1-t>0.001 ? 1 : 0)'");
        runs[k] = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
        settings_clear(&settings);
    }
    while (mpm_simulation_advance(runs[0].simulation, 1000.0, &error) == MPM_OK)
        steps++;
    ck_assert_int_ge(steps, 15);
    ck_assert_ptr_nonnull(strstr(error.message, "source in transport that is not finite"));
    test_run_steps(&runs[1], steps);
    ck_assert(test_run_same_bits(&runs[0], &runs[1]));
    assert_same_scalars(&runs[0].simulation->state.particles, &runs[1].simulation->state.particles);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}
END_TEST

Suite *suite_expansion(void)
{
    Suite *suite = suite_create("expansion");
    TCase *all = tcase_create("every combination");
    tcase_add_loop_test(all, a_block_that_is_held_has_the_stress_of_its_law_without_the_free_strain,
                        0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, laws_have_the_temperature_of_the_grid, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, a_body_that_has_expanded_has_no_stress, 0, HEAT_BLOCK_REST);
    tcase_add_loop_test(all, a_solid_without_conduction_has_the_temperature_of_its_stress, 0,
                        TEST_COMBINATIONS);
    tcase_add_loop_test(all, a_gas_without_conduction_keeps_its_entropy, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, energy_and_heat_are_what_loads_flows_and_deformation_have_given, 0,
                        TEST_COMBINATIONS);
    tcase_add_loop_test(all, a_material_that_does_not_expand_has_the_bits_of_one_without_the_key, 0,
                        TEST_COMBINATIONS);
    tcase_add_loop_test(all, a_half_with_a_plane_of_symmetry_works_and_heats_as_half_of_the_whole,
                        0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, bits_of_bodies_that_expand_do_not_depend_on_threads, 0, LAWS);
    tcase_add_loop_test(all, a_failed_run_has_the_expansion_of_its_last_good_step, 0, LAWS);
    suite_add_tcase(suite, all);
    return suite;
}

/* The balance of energy of every step: what loads, conditions, damping, contact and transfers do to
 * it is measured, and the sum closes to round-off. Strain energy and cohesive energies cancel in
 * that sum, since the transfer loss has the negative change of both: what the loss goes to with the
 * step shows them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/combinations.h"
#include "support/near.h"
#include "support/scenes.h"
#include "support/settings.h"
#include "support/soft_block.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const char BLOCK[] = TEST_SOFT_BLOCK("");
static const char BLOCK_AND_WALL[] = TEST_SOFT_BLOCK(
    "  - {name: wall, rigid: {velocity: [0.05, '-0.1*t']}, region: {rectangle: {from: [8, 3.2],\n"
    "     to: [9, 7.2]}}}\n");

/* What makes a scene do something with its energy, in each of the combinations. */
static const struct feature {
    const char *name;
    const char *settings[4];
    bool wall;
} features[] = {
    {.name = "free"},
    {.name = "uniform body force", .settings = {"loads={body_force: [0.1, '0.2*cos(t)']}"}},
    {.name = "varying body force", .settings = {"loads={body_force: ['@A*sin(t)', '0.1*@B']}"}},
    {.name = "tractions",
     .settings = {"loads={tractions: [{body: block, edge: top, value: [0.03, 0.2]}, "
                  "{body: block, edge: right, value: [0.1, '0.02*@B'], frame: edge}]}"}},
    {.name = "particle forces",
     .settings = {"loads={particle_forces: [{body: block, edge: left, value: [-0.1, 0.1]}]}"}},
    {.name = "a floor that moves",
     .settings = {"boundary=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, "
                  "velocity: [free, '0.2*sin(2*t)']}]"}},
    {.name = "all nodes driven along one axis",
     .settings = {"boundary=[{region: all, velocity: ['0.1*@A*t', free]}]"}},
    {.name = "a rigid wall", .wall = true},
    {.name = "grid damping", .settings = {"damping={grid: 0.3}"}},
    {.name = "grid damping by place, and a floor",
     .settings = {"damping={grid: '0.1*@B'}",
                  "boundary=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, "
                  "velocity: ['0.02*@A', 0]}]"}},
    {.name = "particle damping under weight",
     .settings = {"damping={particle: 0.3}", "loads={body_force: [0, -0.2]}"}},
    {.name = "pic damping under varying forces",
     .settings = {"damping={pic: 0.6, particle: '0.02*@B'}",
                  "loads={body_force: ['0.1*@A', 0], tractions: [{body: block, edge: all, "
                  "value: [-0.1, 0], frame: edge}]}"}},
    {.name = "thermostat", .settings = {"damping={thermostat: {gain: 0.5}}"}},
    {.name = "flip 0.9", .settings = {"method.transfer={kind: flip, fraction: 0.9}"}},
    {.name = "pic under traction",
     .settings = {"method.transfer={kind: pic}",
                  "loads={tractions: [{body: block, edge: top, value: [0, 0.2]}]}"}},
    {.name = "xpic", .settings = {"method.transfer={kind: xpic, order: 3}"}},
    {.name = "fmpm with a floor",
     .settings = {"method.transfer={kind: fmpm, order: 2}",
                  "boundary=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, "
                  "velocity: ['0.02*@A', 0]}]"}},
    {.name = "apic", .settings = {"method.transfer={kind: apic}"}},
    {.name = "momentum form", .settings = {"method.form=momentum"}},
    {.name = "midpoint, damped",
     .settings = {"method.position_update=midpoint", "damping={particle: 0.2, grid: 0.1}"}},
    {.name = "a plane of symmetry",
     .settings = {"boundary=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, symmetry: true}]",
                  "loads={body_force: [0.1, 0]}"}},
    {.name = "a wall that goes on past a plane of symmetry, damped",
     .settings = {"boundary=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, symmetry: true}, "
                  "{region: {line: {from: [8, 0], to: [8, 12]}}, velocity: ['-0.1*cos(t)', "
                  "'0.1*(@B-3.2)']}]",
                  "damping={grid: '0.1*@B'}"}},
    {.name = "a rigid wall beside a plane of symmetry that it moves along and towards",
     .settings = {"boundary=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, symmetry: true}]"},
     .wall = true},
    {.name = "a wall that ends at a plane of symmetry",
     .settings = {"boundary=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, symmetry: true}, "
                  "{region: {line: {from: [8, 4], to: [8, 12]}}, velocity: ['-0.1*cos(t)', "
                  "'0.1*(@B-3.2)']}]"}},
    {.name = "a crack open",
     .settings = {"cracks=[{points: [[2.7, 5.3], [6.1, 5.9]], contact: none}]"}},
    {.name = "a crack with friction",
     .settings = {"cracks=[{points: [[2.7, 5.3], [6.1, 5.9]], contact: friction, friction: 0.3, "
                  "detection: cell}]",
                  "damping={grid: 0.2}"}},
    {.name = "a crack that sticks, under traction",
     .settings = {"cracks=[{points: [[2.7, 5.3], [6.1, 5.9]], contact: stick, detection: cell}]",
                  "loads={tractions: [{body: block, edge: top, value: [0, -0.2]}], "
                  "body_force: [0, -0.1]}"}},
    {.name = "an oblique crack at a wall that presses",
     .settings =
         {"cracks=[{points: [[2.9, 4.9], [5.1, 6.9]], contact: friction, friction: 0.2, "
          "detection: cell}]",
          "boundary=[{region: {line: {from: [3, 0], to: [3, 12]}}, velocity: ['0.1*cos(t)', "
          "'-0.05*cos(t)']}]"}},
    {.name = "an oblique crack at a plane of symmetry",
     .settings = {"cracks=[{points: [[4.1, 3.9], [6.1, 5.9]], contact: stick, detection: cell}]",
                  "boundary=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, symmetry: true}]"}},
    {.name = "two cracks beside each other",
     .settings = {"cracks=[{points: [[3.3, 3.7], [7.1, 4.0]], contact: frictionless, detection: "
                  "cell}, {points: [[3.3, 6.5], [7.1, 6.7]], contact: friction, friction: 0.3}]",
                  "loads={tractions: [{body: block, edge: top, value: [0, -0.3]}]}"}},
    {.name = "a cohesive crack",
     .settings = {"cracks=[{points: [[2.3, 5.3], [8.7, 5.4]], contact: none, cohesive: {law: "
                  "linear, strength: 0.1, toughness: 0.02, stiffness: 1}}]",
                  "loads={tractions: [{body: block, edge: top, value: [0, 0.3]}]}"}},
};
enum { FEATURES = sizeof features / sizeof *features };

/* @A and @B: the names of the axes. */
static void add_for_geometry(struct settings *settings, const char *text, bool axisymmetric)
{
    char *const first = g_strdup(text);
    char **const a = g_strsplit(first, "@A", -1);
    char *const second = g_strjoinv(axisymmetric ? "r" : "x", a);
    char **const b = g_strsplit(second, "@B", -1);
    char *const third = g_strjoinv(axisymmetric ? "z" : "y", b);
    settings_add_formatted(settings, "%s", third);
    g_strfreev(a);
    g_strfreev(b);
    g_free(first);
    g_free(second);
    g_free(third);
}

static struct test_run open_scene(const struct feature *feature, int index, const char *time)
{
    const bool axisymmetric = test_combination(index).axisymmetric;
    struct settings settings = test_combination_settings(index);
    if (time != NULL)
        settings_add(&settings, time);
    settings_add(&settings, "output.energy_balance=true");
    test_add_wild_velocity(&settings, axisymmetric);
    for (int k = 0; k < 4 && feature->settings[k] != NULL; k++)
        add_for_geometry(&settings, feature->settings[k], axisymmetric);
    const struct test_run run =
        test_run_open(feature->wall ? BLOCK_AND_WALL : BLOCK, settings.texts, 1);
    settings_clear(&settings);
    return run;
}

static double open_balance(const struct mpm_ledger *ledger)
{
    return ledger->total_energy + ledger->transfer_loss + ledger->contact_loss -
           ledger->external_work;
}

/* The largest energy in the sum: round-off is of it. */
static double scale_of(const struct mpm_ledger *ledger)
{
    return ledger->kinetic_energy + ledger->strain_energy + fabs(ledger->external_work) +
           ledger->damping_dissipation + fabs(ledger->transfer_loss) + fabs(ledger->contact_loss);
}

enum { STEPS = 7 };

/* A step moves some 1 % of the energy, 1e11 times the bound. */
START_TEST(every_step_closes_to_round_off)
{
    const struct feature *const feature = &features[_i];
    for (int index = 0; index < TEST_COMBINATIONS; index++) {
        struct test_run run = open_scene(feature, index, NULL);
        struct mpm_ledger before = test_run_ledger(&run);
        ck_assert(before.transfer_loss == 0.0);
        for (int step = 1; step <= STEPS; step++) {
            test_run_steps(&run, 1);
            const struct mpm_ledger after = test_run_ledger(&run);
            const double left = open_balance(&after) - open_balance(&before);
            const struct test_combination c = test_combination(index);
            ck_assert_msg(fabs(left) <= TEST_SOFT_ROUND_OFF * scale_of(&after),
                          "%s, %s %s %s, step %d: %g of %g", feature->name, c.geometry, c.shape,
                          c.order, step, left, scale_of(&after));
            before = after;
        }
        test_run_close(&run);
    }
}
END_TEST

/* Nothing takes energy here however short the step is: FLIP, no impact, no contact. */
static const struct feature without_losses[] = {
    {.name = "neo_hookean"},
    {.name = "linear_elastic",
     .settings =
         {"materials.soft={name: soft, law: linear_elastic, density: 1, bulk: 1.25, shear: 0.75}"}},
    {.name = "a cohesive crack",
     .settings = {"bodies.block.velocity=[0, '0.1*(@B-5.4)']",
                  "cracks=[{points: [[3, 5.4], [8, 5.4]], contact: none, cohesive: {law: linear, "
                  "strength: 0.02, toughness: 0.01, stiffness: 0.5}}]"}},
};
enum { WITHOUT_LOSSES = sizeof without_losses / sizeof *without_losses };

/* The transfer loss at t = 1.6, and the energy that stresses and cohesive tractions hold or have
 * dissipated then. */
static double loss_of(const struct feature *feature, int index, int steps, double *stored)
{
    char *time = g_strdup_printf("time={end: 1.6, step: %.17g}", 1.6 / steps);
    struct test_run run = open_scene(feature, index, time);
    test_run_steps(&run, steps);
    const struct mpm_ledger end = test_run_ledger(&run);
    *stored = end.strain_energy + end.cohesive_stored + end.cohesive_dissipated;
    test_run_close(&run);
    g_free(time);
    return end.transfer_loss;
}

/* The work of a step is the change of the energies but for squares of the step, so that the loss
 * goes to zero with it; a wrong energy leaves its error. Of losses L and L' with half the step the
 * limit is 2 L' - L, but for squares of the step. */
START_TEST(energies_are_the_work_of_tractions_as_the_step_goes_to_zero)
{
    static const double of_stored = 0.05, of_change = 0.5; /* squares of the step */
    const struct feature *const feature = &without_losses[_i];
    for (int index = 0; index < TEST_COMBINATIONS; index++) {
        if (test_combination(index).amplifies_round_off)
            continue; /* nodes of little mass at the edge: the step is not small for them */
        double stored;
        const double whole = loss_of(feature, index, 32, &stored);
        const double half = loss_of(feature, index, 64, &stored);
        const double limit = 2.0 * half - whole;
        const struct test_combination c = test_combination(index);
        ck_assert_msg(fabs(limit) <= of_stored * stored + of_change * fabs(whole - half),
                      "%s, %s %s %s: loss %g, with half the step %g, of %g", feature->name,
                      c.geometry, c.shape, c.order, whole, half, stored);
    }
}
END_TEST

Suite *suite_energy_balance(void)
{
    Suite *suite = suite_create("energy_balance");
    TCase *steps = tcase_create("steps");
    tcase_add_loop_test(steps, every_step_closes_to_round_off, 0, FEATURES);
    tcase_add_loop_test(steps, energies_are_the_work_of_tractions_as_the_step_goes_to_zero, 0,
                        WITHOUT_LOSSES);
    suite_add_tcase(suite, steps);
    return suite;
}

/* Heat conduction: how scenes state it, and what is refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/scene.h"
#include "suites.h"
#include "support/near.h"
#include "support/scene_files.h"
#include "support/scenes.h"

#include <glib.h>
#include <string.h>

static const char CONDUCTING[] = "tests/scenes/good/conducting.yaml";

START_TEST(transport_says_what_its_file_says)
{
    struct mpm_scene *scene = test_scene_read(CONDUCTING, NULL);
    const struct mpm_scalar_spec *const heat = &scene->scalars[MPM_TEMPERATURE];
    const struct mpm_conduction *const steel = &scene->materials[0].conduction[MPM_TEMPERATURE];
    const struct mpm_conduction *const wood = &scene->materials[1].conduction[MPM_TEMPERATURE];
    ck_assert(heat->asked && !scene->at_rest);
    ck_assert_int_eq(heat->transfer, MPM_SCALAR_FLIP);
    ck_assert_str_eq(heat->start, "0");
    ck_assert_str_eq(heat->source, "5*x*t");
    ck_assert_uint_eq(heat->condition_count, 1);
    ck_assert_str_eq(heat->conditions[0].value, "20+10*t");
    ck_assert_str_eq(scene->bodies[0].start[MPM_TEMPERATURE], "20+x");
    ck_assert_ptr_null(scene->bodies[1].start[MPM_TEMPERATURE]);
    ck_assert_double_eq(steel->capacity, 0.5);
    ck_assert(!steel->anisotropic);
    ck_assert_double_eq(steel->k[0], 4.0);
    ck_assert_double_eq(steel->k[1], 4.0);
    ck_assert_double_eq(steel->k[2], 0.0);
    ck_assert(wood->anisotropic); /* 3 and 1, turned by 30 degrees */
    ck_assert_near(wood->k[0], 2.5, 1e-15);
    ck_assert_near(wood->k[1], 1.5, 1e-15);
    ck_assert_near(wood->k[2], 0.8660254037844386, 1e-15);
    mpm_scene_free(scene);
}
END_TEST

static const char AT_REST[] =
    "materials=[{name: steel, law: none, density: 2, heat_capacity: 1, conductivity: 1}, "
    "{name: wood, law: none, density: 2, heat_capacity: 1, conductivity: 1}]";

#define TABLES(capacity, conductivity)                                                             \
    "materials.steel={name: steel, law: neo_hookean, density: 1, bulk: 1, shear: 1, "              \
    "heat_capacity_table: " capacity ", conductivity_table: " conductivity "}"

/* Settings of the good scene, a line each, and part of the message. */
static const char *const refused[][2] = {
    {"materials.steel.heat_capacity=0", "materials.0.heat_capacity: out of range"},
    {"materials.steel.conductivity=-1", "materials.0.conductivity: out of range"},
    {"materials.steel={name: steel, law: neo_hookean, density: 1, bulk: 1, shear: 1, conductivity: "
     "1}",
     "no heat_capacity"},
    {"materials.wood.conductivity=1",
     "2 of conductivity, principal_conductivities and conductivity_table given"},
    {"materials.steel={name: steel, law: neo_hookean, density: 1, bulk: 1, shear: 1, "
     "heat_capacity: 1}",
     "0 of conductivity, principal_conductivities and conductivity_table given"},
    {"materials.steel.conductivity_angle=3", "for a conductivity without directions"},
    {"materials.steel.conductivity_table=[[0, 1], [1, 2]]",
     "2 of conductivity, principal_conductivities and conductivity_table given"},
    {"materials.steel.heat_capacity_table=[[0, 1], [1, 2]]",
     "both of heat_capacity and heat_capacity_table given; allowed: exactly one"},
    {TABLES("[[0, 1]]", "[[0, 1], [9, 1]]"), "materials.0.heat_capacity_table: "},
    {TABLES("[[0, 1], [0, 2]]", "[[0, 1], [9, 1]]"),
     "materials.0.heat_capacity_table.1: got temperature 0 after 0; allowed: above it"},
    {TABLES("[[0, 1], [5, 1], [4, 2]]", "[[0, 1], [9, 1]]"),
     "materials.0.heat_capacity_table.2: got temperature 4 after 5"},
    {TABLES("[[0, 1], [5, 1]]", "[[0, 0], [9, 1]]"),
     "materials.0.conductivity_table.0: got 0 at temperature 0; allowed: above 0"},
    {TABLES("[[0, 1], [5, -1]]", "[[0, 1], [9, 1]]"),
     "materials.0.heat_capacity_table.1: got -1 at temperature 5; allowed: above 0"},
    {TABLES("[[0, 1], [5, x]]", "[[0, 1], [9, 1]]"), "materials.0.heat_capacity_table.1.1: "},
    {TABLES("[[0, 1], [5, 1]]", "[[6, 1], [9, 1]]"),
     "materials.0: heat_capacity_table from 0 to 5 and conductivity_table from 6 to 9; allowed: "
     "tables with temperatures in common"},
    {TABLES("[[0, 1], [5, 1]]", "[[0, 1], [9, 1]], conductivity_angle: 3"),
     "for a conductivity without directions"},
    {"transport={}", "materials.0.heat_capacity: given in a scene without transport.temperature"},
    {"transport.temperature.source='x*'", "transport.temperature.source: "},
    {"transport.temperature.source='1/(x-x)'", "allowed: finite"},
    {"transport.temperature.start='t'", "transport.temperature.start: "},
    {"transport.temperature.transfer=apic", "allowed: flip | pic | xpic | fmpm"},
    {"transport.temperature.transfer=xpic",
     "transport.temperature.transfer: xpic without an order; allowed: with order: 2"},
    {"transport.temperature.order=2",
     "transport.temperature.order: given with a transfer that has no order"},
    {"transport.temperature={transfer: fmpm, order: 0}",
     "transport.temperature.order: out of range"},
    {"transport.temperature.conditions.0.value=free", "a component cannot be free here"},
    {"transport.temperature.conditions.0.region={disk: {center: [1, 1], radius: 1}}",
     "transport.temperature.conditions.0.region"},
    {"transport.temperature.flux=1",
     "unknown key \"flux\"; allowed: transfer, order, start, source"},
    {"transport.temperature.fluxes=[{body: left, edge: top}]",
     "transport.temperature.fluxes.0: 0 of value, convection and radiation given"},
    {"transport.temperature.fluxes=[{body: left, edge: top, value: 1, convection: {coefficient: 1, "
     "ambient: 2}}]",
     "transport.temperature.fluxes.0: 2 of value, convection and radiation given"},
    {"transport.temperature.fluxes=[{body: middle, edge: top, value: 1}]",
     "transport.temperature.fluxes.0.body: no such body"},
    {"transport.temperature.fluxes=[{body: left, edge: top, radiation: {emissivity: 2, sigma: 1, "
     "ambient: 2}}]",
     "transport.temperature.fluxes.0.radiation.emissivity: out of range"},
    {"bodies.right.rigid={velocity: [0, 0]}", "both of material and rigid given"},
    {"bodies.right={name: right, rigid: {velocity: [0, 0]}, temperature: 3, region: {rectangle: "
     "{from: [6, 0], to: [8, 2]}}}",
     "a temperature for a rigid body"},
    {"contact={law: stick, heat: conductance}", "contact.heat: conductance without its value"},
    {"contact={law: stick, heat: perfect, conductance: 1}",
     "contact.conductance: got 1, beside another law of heat"},
    {"contact={law: stick, heat: conductance, conductance: -1}",
     "contact.conductance: out of range"},
    {"contact={law: stick, heat: perfekt}", "allowed: insulated | perfect | conductance"},
    {"contact={pairs: [{of: [steel, wod], law: stick, heat: perfect}]}", "unknown material"},
    {"contact={pairs: [{of: [steel, wood], law: stick, heat: perfect}, {of: [wood, steel], law: "
     "stick, heat: insulated}]}",
     "'wood' and 'steel' again, which contact.pairs.0 has already"},
    {"contact={pairs: [{of: [steel, wood], law: stick, conductance: 1}]}",
     "contact.pairs.0: conductance or heat_gap without heat"},
    {"contact={law: stick, pairs: [{of: [steel, wood], law: none, heat: perfect}]}",
     "contact.pairs.0.heat: a law of heat for a pair that shares its fields"},
    {"contact={heat: perfect, pairs: [{of: [steel, wood], law: stick, heat: insulated}]}",
     "contact.heat: given, and no pair uses it"},
    {"contact={law: bonded, heat: perfect, heat_gap: 0.1}",
     "contact.heat_gap: given, and no pair uses it"},
    {"contact={pairs: [{of: [steel, wood], law: bonded, heat: perfect, heat_gap: 0.1}]}",
     "contact.pairs.0.heat_gap: got 0.1, which this pair does not use"},
    {"cracks=[{points: [[1, 1], [3, 1.1]], conductance: 1}]",
     "cracks.0.conductance: got 1, beside another law of heat"},
    {"cracks=[{points: [[1, 1], [3, 1.1]], heat: conductance}]",
     "cracks.0.heat: conductance without its value"},
    {"materials.wood={name: wood, law: none, density: 2, heat_capacity: 1, conductivity: 1}",
     "materials.1.law: got none beside materials with a stress"},
    {AT_REST, "bodies.0: a velocity in a scene where nothing moves"},
    {"time={end: 1, rest: {residual: 0.1}}", "time.rest.kinetic_energy: missing"},
    {"materials.steel.saturation=1", "given in a scene without transport.concentration"},
    {"materials.steel.swelling=1", "given in a scene without transport.concentration"},
    {"bodies.left.concentration=1", "given in a scene without transport.concentration"},
    {"materials.steel.diffusivity_table=[[0, 1], [1, 2]]",
     "given in a scene without transport.concentration"},
    {"transport.concentration={}", "no saturation, in a scene with transport.concentration"},
};

START_TEST(what_contradicts_itself_is_refused)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_scene_read(CONDUCTING, &refused[_i][0], 1, &scene, &error), MPM_BAD_INPUT);
    test_contains(error.message, refused[_i][1]);
}
END_TEST

/* Combinations of two settings. */
static const char *const refused_together[][3] = {
    {TABLES("[[0, 1], [50, 2]]", "[[0, 1], [50, 1]]"), "transport.temperature.heating=true",
     "materials.0.heat_capacity_table: given with transport.temperature.heating; allowed: "
     "heat_capacity"},
    {"contact={law: stick}", "cracks=[{points: [[1, 1], [3, 1.1]]}]",
     "conduction with cracks beside contact between bodies"},
    {"method.cracks=visibility", "cracks=[{points: [[1, 1], [3, 1.1]]}]",
     "conduction with method.cracks: visibility"},
    {"bodies.right={name: wall, rigid: {velocity: [0, 0]}, region: {rectangle: {from: [6, 0], to: "
     "[8, 2]}}}",
     "contact={pairs: [{of: [steel, wall], law: stick, heat: perfect}]}",
     "contact.pairs.0.heat: a law of heat with a rigid body"},
    {"bodies.right={name: wall, rigid: {velocity: [0, 0]}, region: {rectangle: {from: [6, 0], to: "
     "[8, 2]}}}",
     "contact={heat: perfect, pairs: [{of: [steel, wall], law: stick}]}",
     "contact.heat: given, and no pair uses it"},
};

START_TEST(what_does_not_fit_together_is_refused)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_scene_read(CONDUCTING, refused_together[_i], 2, &scene, &error),
                     MPM_BAD_INPUT);
    test_contains(error.message, refused_together[_i][2]);
}
END_TEST

#define STEEL(law, more)                                                                           \
    "materials.steel={name: steel, law: " law ", density: 2, heat_capacity: 0.5, conductivity: "   \
    "4, " more "}"
#define SOLID "bulk: 3, shear: 1"

/* Of heat and mechanics: settings and part of the message. */
static const char *const refused_couplings[][3] = {
    {STEEL("neo_hookean", SOLID ", thermal_expansion: 0.1"), "title=x",
     "materials.0: thermal_expansion without stress_free_temperature; allowed: both or none"},
    {STEEL("neo_hookean", SOLID ", stress_free_temperature: 3"), "title=x",
     "materials.0: stress_free_temperature without thermal_expansion; allowed: both or none"},
    {STEEL("ideal_gas", "gas_constant: 1, thermal_expansion: 0.1, stress_free_temperature: 3"),
     "title=x", "materials.0.thermal_expansion: given for the law ideal_gas; allowed: for laws of"},
    {"materials=[{name: steel, law: none, density: 2, heat_capacity: 1, conductivity: 1, "
     "thermal_expansion: 0.1, stress_free_temperature: 3}, {name: wood, law: none, density: 2, "
     "heat_capacity: 1, conductivity: 1}]",
     "bodies.left={name: left, material: steel, region: {rectangle: {from: [0, 0], to: [4, 2]}}}",
     "materials.0.thermal_expansion: given for the law none; allowed: for laws of solids"},
    {STEEL("neo_hookean", SOLID), "transport.temperature.heating=true",
     "transport.temperature.heating: got true where no deformation gives heat; allowed: with a "
     "material that has thermal_expansion, taylor_quinney or the law ideal_gas"},
    {STEEL("von_mises", SOLID ", yield_stress: 1"), "transport.temperature.heating=true",
     "transport.temperature.heating: got true where no deformation gives heat"},
    {STEEL("von_mises", SOLID ", yield_stress: 1, taylor_quinney: 0.9"), "title=x",
     "materials.0.taylor_quinney: given without transport.temperature.heating, where plastic work "
     "heats nothing; allowed: with heating: true"},
    {STEEL("von_mises", SOLID ", yield_stress: 1, taylor_quinney: 1.1"), "title=x",
     "materials.0.taylor_quinney: out of range"},
    {STEEL("neo_hookean", SOLID ", taylor_quinney: 0.9"), "title=x",
     "materials.0: the law neo_hookean has no parameter taylor_quinney"},
    {STEEL("johnson_cook", SOLID ", yield_stress: 1, specific_heat: 3"), "title=x",
     "materials.0.law: got johnson_cook with start_temperature or specific_heat, a temperature of "
     "its own, in a scene with transport.temperature; allowed: without start_temperature and "
     "specific_heat"},
    {STEEL("johnson_cook", SOLID ", yield_stress: 1, start_temperature: 3"), "title=x",
     "materials.0.law: got johnson_cook with start_temperature or specific_heat"},
    {STEEL("johnson_cook", SOLID ", yield_stress: 1, softening_exponent: 1"), "title=x",
     "materials.0: softening requires softening_exponent, reference_temperature and "
     "melting_temperature; allowed: all or none"},
    {STEEL("neo_hookean", SOLID ", thermal_expansion: 0, stress_free_temperature: 3"),
     "transport.temperature.heating=true", "transport.temperature.heating: got true where no"},
    {STEEL("ideal_gas", "gas_constant: 1"), "geometry=plane_stress",
     "materials.0: the law ideal_gas has no plane stress; allowed geometry: plane_strain"},
    {STEEL("ideal_gas", "gas_constant: 0"), "title=x", "materials.0.gas_constant: out of range"},
    {STEEL("ideal_gas", SOLID ", gas_constant: 1"), "title=x", "materials.0"},
    {STEEL("neo_hookean", SOLID ", gas_constant: 1"), "title=x", "materials.0"},
    {STEEL("ideal_gas", "bulk: 3"), "title=x", "materials.0"},
    {STEEL("neo_hookean", SOLID ", thermal_expansion: .nan, stress_free_temperature: 3"), "title=x",
     "materials.0.thermal_expansion"},
};

START_TEST(couplings_that_contradict_themselves_are_refused)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_scene_read(CONDUCTING, refused_couplings[_i], 2, &scene, &error),
                     MPM_BAD_INPUT);
    test_contains(error.message, refused_couplings[_i][2]);
}
END_TEST

/* Without transport, temperatures have no meaning, nor has what depends on them. */
static const char *const refused_without[][2] = {
    {"materials=[{name: steel, law: ideal_gas, density: 2, gas_constant: 1}, {name: wood, law: "
     "neo_hookean, density: 1, bulk: 1, shear: 1}]",
     "materials.0.law: got ideal_gas, whose stress depends on the temperature, in a scene without "
     "transport.temperature; allowed: with it"},
    {"materials=[{name: steel, law: neo_hookean, density: 2, bulk: 3, shear: 1, "
     "thermal_expansion: 1, stress_free_temperature: 0}, {name: wood, law: neo_hookean, density: "
     "1, bulk: 1, shear: 1}]",
     "materials.0.thermal_expansion: given in a scene without transport.temperature"},
    {"materials=[{name: steel, law: neo_hookean, density: 2, bulk: 3, shear: 1, "
     "stress_free_temperature: 1}, {name: wood, law: neo_hookean, density: 1, bulk: 1, shear: 1}]",
     "materials.0.stress_free_temperature: given in a scene without transport.temperature"},
    {"materials=[{name: steel, law: von_mises, density: 2, bulk: 3, shear: 1, yield_stress: 1, "
     "taylor_quinney: 0.9}, {name: wood, law: neo_hookean, density: 1, bulk: 1, shear: 1}]",
     "materials.0: taylor_quinney in a scene without transport.temperature, where plastic work "
     "heats nothing; allowed: with transport.temperature and its heating: true"},
    {"materials=[{name: steel, law: johnson_cook, density: 2, bulk: 3, shear: 1, yield_stress: 1, "
     "softening_exponent: 1, reference_temperature: 1, melting_temperature: 2}, {name: wood, law: "
     "neo_hookean, density: 1, bulk: 1, shear: 1}]",
     "materials.0: softening by a temperature of its own requires softening_exponent, "
     "reference_temperature, melting_temperature, start_temperature, specific_heat and "
     "taylor_quinney; allowed: all or none"},
};

START_TEST(couplings_without_a_temperature_are_refused)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    const char *const settings[] = {refused_without[_i][0], "transport={}",
                                    "bodies.left={name: left, material: steel, region: {rectangle: "
                                    "{from: [0, 0], to: [4, 2]}}}"};
    ck_assert_int_eq(mpm_scene_read(CONDUCTING, settings, 3, &scene, &error), MPM_BAD_INPUT);
    test_contains(error.message, refused_without[_i][1]);
}
END_TEST

START_TEST(expansion_and_heating_are_what_the_file_states)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    const char *const settings[] = {
        STEEL("neo_hookean", SOLID ", thermal_expansion: -0.1, stress_free_temperature: -3"),
        "transport.temperature.heating=true"};
    ck_assert_msg(mpm_scene_read(CONDUCTING, settings, 2, &scene, &error) == MPM_OK, "%s",
                  error.message);
    ck_assert_double_eq(scene->materials[0].expansion[MPM_TEMPERATURE].coefficient, -0.1);
    ck_assert_double_eq(scene->materials[0].expansion[MPM_TEMPERATURE].stress_free, -3.0);
    ck_assert_double_eq(scene->materials[1].expansion[MPM_TEMPERATURE].coefficient, 0.0);
    ck_assert(scene->scalars[MPM_TEMPERATURE].heats);
    ck_assert(mpm_scene_couples(scene) && mpm_scene_heats(scene));
    mpm_scene_free(scene);
}
END_TEST

/* The same in a scene where nothing moves. */
static const char *const refused_at_rest[][2] = {
    {"method.stress_update=usl", "method.stress_update: given in a scene where nothing moves"},
    {"method.transfer={kind: pic}", "method.transfer: given in a scene where nothing moves"},
    {"loads={body_force: [0, 1]}", "loads: given in a scene where nothing moves"},
    {"damping={grid: 1}", "damping: given in a scene where nothing moves"},
    {"time={end: 1, rest: {residual: 0.1, kinetic_energy: 0.1}}",
     "time.rest.kinetic_energy: given"},
    {"output={energy_balance: true}", "output.energy_balance: given"},
    {"boundary=[{region: all, velocity: [0, 0]}]", "boundary.0: a velocity in a scene where"},
    {"transport.substeps=2", "transport.substeps: given in a scene where nothing moves"},
    {"bodies.right={name: right, rigid: {velocity: [0, 0]}, region: {rectangle: {from: [6, 0], to: "
     "[8, 2]}}}",
     "bodies.1: a rigid body in a scene where nothing moves"},
    {"contact={law: friction, friction: 0.3}", "contact: a law of motion in a scene where nothing"},
    {"contact={law: stick, adhesion: 2}", "contact: adhesion in a scene where nothing"},
    {"cracks=[{points: [[1, 1], [3, 1.1]], contact: stick}]",
     "cracks.0.contact: given in a scene where nothing moves"},
};

START_TEST(what_belongs_to_motion_is_refused_where_nothing_moves)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    const char *const settings[] = {AT_REST,
                                    "bodies.left={name: left, material: steel, region: {rectangle: "
                                    "{from: [0, 0], to: [4, 2]}}}",
                                    refused_at_rest[_i][0]};
    ck_assert_int_eq(mpm_scene_read(CONDUCTING, settings, 3, &scene, &error), MPM_BAD_INPUT);
    test_contains(error.message, refused_at_rest[_i][1]);
}
END_TEST

/* What needs nodes and particles is found when the simulation is created. */
static const char *const refused_later[][2] = {
    {"transport.temperature.conditions.0.region={line: {from: [0.3, 0], to: [0.3, 2]}}",
     "transport.temperature.conditions.0.region: selects no node of the grid"},
    {"transport.temperature.conditions=[{region: {line: {from: [0, 0], to: [0, 2]}}, value: 1}, "
     "{region: {line: {from: [0, 0], to: [4, 0]}}, value: '1+t'}]",
     "transport.temperature.conditions.1.value: prescribes 1.03125 at the node (0, 0)"},
    {"transport.temperature.start='1/(x-6.25)'", "initial temperature of body 'right' is inf"},
    {"transport.temperature.source='1/(x-6.25)'", "transport.temperature.source: is inf"},
    {"time={end: 1, step: 0.3}", "1 / (2 kappa (1/h_x^2 + 1/h_y^2))"},
};

START_TEST(what_does_not_fit_the_grid_is_refused)
{
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *simulation = NULL;
    struct mpm_error error = {.message = ""};
    const struct mpm_simulation_options options = {.threads = 1};
    ck_assert_int_eq(mpm_scene_read(CONDUCTING, &refused_later[_i][0], 1, &scene, &error), MPM_OK);
    ck_assert_int_eq(mpm_simulation_create(scene, &options, &simulation, &error), MPM_BAD_INPUT);
    test_contains(error.message, refused_later[_i][1]);
    mpm_scene_free(scene);
}
END_TEST

Suite *suite_scene_transport(void)
{
    Suite *suite = suite_create("scene_transport");
    TCase *reading = tcase_create("reading");
    tcase_add_test(reading, transport_says_what_its_file_says);
    tcase_add_loop_test(reading, what_does_not_fit_together_is_refused, 0,
                        (int)G_N_ELEMENTS(refused_together));
    tcase_add_loop_test(reading, what_contradicts_itself_is_refused, 0, (int)G_N_ELEMENTS(refused));
    tcase_add_loop_test(reading, couplings_that_contradict_themselves_are_refused, 0,
                        (int)G_N_ELEMENTS(refused_couplings));
    tcase_add_loop_test(reading, couplings_without_a_temperature_are_refused, 0,
                        (int)G_N_ELEMENTS(refused_without));
    tcase_add_test(reading, expansion_and_heating_are_what_the_file_states);
    tcase_add_loop_test(reading, what_belongs_to_motion_is_refused_where_nothing_moves, 0,
                        (int)G_N_ELEMENTS(refused_at_rest));
    tcase_add_loop_test(reading, what_does_not_fit_the_grid_is_refused, 0,
                        (int)G_N_ELEMENTS(refused_later));
    suite_add_tcase(suite, reading);
    return suite;
}

/* Laws of metals on vectors of four particles: the same bits as particle by particle, in any state;
 * and who is taken on vectors at all.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/kernel_pair.h"
#include "support/scenes.h"

#include "method/fast/fast.h"
#include "method/fast/fast_block.h"
#include "method/fast/fast_laws.h"
#include "model/laws/gruneisen_solid.h"
#include "simulation/simulation.h"

#include <glib.h>

/* ------------------------------------------------------------------------ laws */

#define STRENGTH                                                                                   \
    "shear: 0.3, yield_stress: 0.005, hardening_coefficient: 0.004, hardening_exponent: 0.3, "     \
    "rate_coefficient: 0.02, reference_rate: 1e-3, softening_exponent: 1.2, "                      \
    "reference_temperature: 300, melting_temperature: 1700, start_temperature: 300, "              \
    "specific_heat: 1e-4, taylor_quinney: 0.9"
#define PRESSURE "sound_speed: 1, hugoniot_slope: 1.5, gruneisen: 2"
#define VISCOUS  ", viscosity: {linear: 0.2, quadratic: 1.5}"
#define POWER    "hardening_strain: 0.01, hardening_exponent: 0.2"

static const struct law_case {
    const char *text;
    bool warms; /* its strength depends on a temperature */
} laws[] = {
    {"law: von_mises, bulk: 0.6, shear: 0.3, yield_stress: 0.005", false},
    {"law: von_mises, bulk: 0.6, shear: 0.3, yield_stress: 0.005, " POWER VISCOUS, false},
    {"law: von_mises, bulk: 0.6, shear: 0.3, yield_stress: 0.005, hardening_modulus: 0.01", false},
    {"law: johnson_cook, bulk: 0.6, " STRENGTH, true},
    {"law: johnson_cook, bulk: 0.6, " STRENGTH VISCOUS, true},
    {"law: johnson_cook, bulk: 0.6, shear: 0.3, yield_stress: 0.005", false},
    {"law: johnson_cook, bulk: 0.6, shear: 0.3, yield_stress: 0.005, hardening_coefficient: 0.005, "
     "hardening_exponent: 0.015",
     false},
    {"law: von_mises_gruneisen, shear: 0.3, yield_stress: 0.005, " POWER ", " PRESSURE, false},
    {"law: von_mises_gruneisen, shear: 0.3, yield_stress: 0.005, " PRESSURE VISCOUS, false},
    {"law: johnson_cook_gruneisen, " STRENGTH ", " PRESSURE, true},
    {"law: johnson_cook_gruneisen, " STRENGTH ", " PRESSURE VISCOUS, true},
    {"law: johnson_cook_gruneisen, " STRENGTH ", pressure_cutoff: 0.2, " PRESSURE VISCOUS, true},
};

enum { STEEP_LAW = 6, GRUNEISEN_LAW = 9, LAW_WITH_BOTH = 11 }; /* with melting and cut-off */

static struct test_run open_law(const struct law_case *law, const char *geometry)
{
    static const char scene[] =
        "format: 1\ngeometry: %s\ngrid: {origin: [0, 0], cell: [1, 0.8], cells: [12, 12]}\n"
        "units: {length: mm, mass: kg, time: ms, temperature: K}\n"
        "time: {end: 1000, step: 0.02}\n"
        "materials: [{name: metal, density: 1.3, %s}]\n"
        "bodies: [{name: block, material: metal, region: {rectangle: {from: [2, 2], to: [10, 8]}}, "
        "velocity: [0.001, 0]}]\n";
    char *text = g_strdup_printf(scene, geometry, law->text);
    struct test_run run = test_run_open(text, NULL, 1);
    g_free(text);
    test_run_steps(&run, 1);
    return run;
}

/* ---------------------------------------------------------------------- states */

/* Where a particle is before the step, and how fast it deforms. */
static const struct state_case {
    const char *name;
    double strain, plastic, heat; /* of F, p, and energy of heat in units of that which melts */
    double volume, rate;          /* J, and the size of velocity gradients */
    bool in_vectors;              /* of all laws */
} states[] = {
    {"undeformed", 0.0, 0.0, 0.0, 1.0, 0.0, true},
    {"elastic", 0.003, 0.0, 0.0, 1.0, 0.01, true},
    {"first to yield", 0.004, 0.0, 0.0, 0.999, 0.5, true},
    {"yielding", 0.004, 0.3, 0.2, 1.001, 0.5, true},
    {"in a shock", 0.01, 0.1, 0.1, 0.9, 3.0, true},
    {"barely plastic", 0.02, 1e-290, 0.0, 1.0, 0.2, true},
    {"melted", 0.01, 0.3, 1.5, 1.0, 0.5, false},
    {"torn", 0.01, 0.3, 0.0, 1.2, 0.5, false},
    {"dense", 0.01, 0.3, 0.0, 0.75, 0.5, false},
};
enum { STATES = G_N_ELEMENTS(states), BLOCK = MPM_BLOCK_VECTORS * MPM_VECTOR_SIZE };

static double around(GRand *random, double size)
{
    return g_rand_double_range(random, -1.0, 1.0) * size;
}

static size_t variables_of(const struct test_run *run)
{
    return mpm_law_state_count(run->scene->materials[0].law);
}

static void set_variable(const struct test_run *run, size_t p, size_t k, double value)
{
    if (k < variables_of(run))
        *mpm_particle_law_state(&run->simulation->state.particles, p, k) = value;
}

static void fill_particle(const struct test_run *run, size_t p, const struct state_case *at,
                          bool plane, GRand *random)
{
    const struct mpm_particles *const particles = &run->simulation->state.particles;
    const double stretch = cbrt(at->volume), melting = 1400.0 * 1e-4;
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        particles->deformation[k][p] =
            (k == MPM_XY || k == MPM_YX ? 0.0 : stretch) + around(random, at->strain);
    if (plane)
        particles->deformation[MPM_ZZ][p] = 1.0;
    for (size_t k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        set_variable(run, p, MPM_PLASTIC_INVERSE + k,
                     (k == MPM_SYM_XY ? 0.0 : 1.0) + around(random, 0.5 * at->strain));
    set_variable(run, p, MPM_PLASTIC_STRAIN, at->plastic);
    set_variable(run, p, MPM_SOLID_ENERGY, at->heat * melting);
    set_variable(run, p, MPM_SOLID_WORK, 0.01 * at->plastic);
}

/* ------------------------------------------------------------------ both updates */

/* The numbers that an update changes, of a block's particles. */
enum { NUMBERS = MPM_GRADIENT_SIZE + MPM_SYMMETRIC_SIZE + MPM_LAW_STATES + 2 };
struct numbers {
    double of[NUMBERS][BLOCK];
};

static double *number_at(const struct test_run *run, size_t which, size_t p)
{
    const struct mpm_particles *const particles = &run->simulation->state.particles;
    if (which < MPM_GRADIENT_SIZE)
        return &particles->deformation[which][p];
    which -= MPM_GRADIENT_SIZE;
    if (which < MPM_SYMMETRIC_SIZE)
        return &particles->stress[which][p];
    which -= MPM_SYMMETRIC_SIZE;
    if (which < MPM_LAW_STATES)
        return which < variables_of(run) ? mpm_particle_law_state(particles, p, which) : NULL;
    which -= MPM_LAW_STATES;
    return particles->viscous[which] == NULL ? NULL : &particles->viscous[which][p];
}

static void copy_numbers(const struct test_run *run, struct numbers *numbers, bool back)
{
    for (size_t which = 0; which < NUMBERS; which++)
        for (size_t p = 0; p < BLOCK; p++) {
            double *const number = number_at(run, which, p);
            if (number != NULL && back)
                *number = numbers->of[which][p];
            else
                numbers->of[which][p] = number == NULL ? 0.0 : *number;
        }
}

/* Of a block's update; `by_particle`: did any part of it go particle by particle? */
struct outcome {
    struct numbers numbers;
    double wave_squared;
    bool by_particle;
    enum mpm_failure_kind failure;
};

static struct outcome update(const struct test_run *run, const struct mpm_fast_law *row,
                             enum mpm_geometry geometry, mpm_vector (*gradient)[MPM_GRADIENT_SIZE])
{
    const struct mpm_state *const state = &run->simulation->state;
    struct mpm_strip strip = {.wave_speed_squared = 0.0};
    struct fast_sums sums = {.state = state, .strip = &strip};
    struct fast_constants constants;
    struct outcome outcome;
    mpm_fast_constants(state, 0, 1.0, &constants);
    row->update[geometry](&constants, &state->particles, 0, BLOCK, &sums,
                          (const mpm_vector(*)[MPM_GRADIENT_SIZE])gradient);
    copy_numbers(run, &outcome.numbers, false);
    outcome.by_particle = strip.wave_speed_squared > 0.0 || strip.failure.kind != MPM_NO_FAILURE;
    outcome.failure = strip.failure.kind;
    outcome.wave_squared = strip.wave_speed_squared;
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++)
        outcome.wave_squared = fmax(outcome.wave_squared, sums.wave[lane]);
    return outcome;
}

static const struct mpm_fast_law *row_of(const struct mpm_fast_law *table,
                                         const struct mpm_material_law *law)
{
    while (table->law != NULL && table->law != law)
        table++;
    return table;
}

/* The block at hand by both: fails where a bit differs. Is it taken on vectors as a whole? */
static bool update_by_both(const struct test_run *run, const struct mpm_fast_law *table,
                           enum mpm_geometry geometry, const char *what, GRand *random, double rate)
{
    mpm_vector gradient[MPM_BLOCK_VECTORS][MPM_GRADIENT_SIZE];
    for (int v = 0; v < MPM_BLOCK_VECTORS; v++)
        for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
            for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++)
                gradient[v][k][lane] =
                    k == MPM_ZZ && geometry == MPM_PLANE_STRAIN ? 0.0 : around(random, rate);
    struct numbers before;
    copy_numbers(run, &before, false);
    const struct mpm_material_law *const law = run->scene->materials[0].law;
    const struct outcome vectors = update(run, row_of(table, law), geometry, gradient);
    copy_numbers(run, &before, true);
    const struct outcome single = update(run, row_of(table, NULL), geometry, gradient);
    ck_assert_msg(vectors.failure == single.failure, "%s: failure %d, by particle %d", what,
                  (int)vectors.failure, (int)single.failure);
    for (size_t which = 0; which < NUMBERS; which++)
        for (size_t p = 0; p < BLOCK; p++)
            ck_assert_msg(vectors.numbers.of[which][p] == single.numbers.of[which][p],
                          "%s: number %zu of particle %zu: %.17g, by particle %.17g", what, which,
                          p, vectors.numbers.of[which][p], single.numbers.of[which][p]);
    ck_assert_msg(vectors.wave_squared == single.wave_squared || single.failure != MPM_NO_FAILURE,
                  "%s: wave %.17g, by particle %.17g", what, vectors.wave_squared,
                  single.wave_squared);
    return !vectors.by_particle;
}

/* Each law in one geometry, and one set of instructions. */
struct setup {
    const struct law_case *law;
    enum mpm_geometry geometry;
    const struct mpm_fast_law *table;
    char name[160];
};
enum { SETUPS = 4 * G_N_ELEMENTS(laws) };

/* False: this machine does not have these instructions. */
static bool take_setup(int index, struct setup *setup, struct test_run *run)
{
    const bool wide = index % 2 != 0, plane = index / 2 % 2 != 0;
    setup->law = &laws[index / 4];
    setup->geometry = plane ? MPM_PLANE_STRAIN : MPM_AXISYMMETRIC;
    setup->table = mpm_fast_laws_baseline;
    if (wide && mpm_fast_widest() == MPM_SIMD_BASELINE)
        return false;
#ifdef MPM_FAST_V3
    if (wide)
        setup->table = mpm_fast_laws_v3;
#endif
    (void)g_snprintf(setup->name, sizeof setup->name, "%s (%s)", setup->law->text,
                     plane ? "plane strain" : "axisymmetric");
    *run = open_law(setup->law, plane ? "plane_strain" : "axisymmetric");
    return true;
}

/* ------------------------------------------------------------------------ tests */

enum { ROUNDS = 20 };

START_TEST(four_particles_in_one_state_have_the_bits_of_each_alone)
{
    struct setup setup;
    struct test_run run;
    if (!take_setup(_i, &setup, &run))
        return;
    GRand *random = g_rand_new_with_seed(41);
    for (size_t s = 0; s < STATES; s++) {
        int in_vectors = 0;
        for (int round = 0; round < ROUNDS; round++) {
            char *what = g_strdup_printf("%s, %s", setup.name, states[s].name);
            for (size_t p = 0; p < BLOCK; p++)
                fill_particle(&run, p, &states[s], setup.geometry == MPM_PLANE_STRAIN, random);
            in_vectors +=
                update_by_both(&run, setup.table, setup.geometry, what, random, states[s].rate);
            g_free(what);
        }
        if (states[s].in_vectors)
            ck_assert_msg(in_vectors == ROUNDS, "%s, %s: %d of %d on vectors", setup.name,
                          states[s].name, in_vectors, ROUNDS);
    }
    g_rand_free(random);
    test_run_close(&run);
}
END_TEST

START_TEST(four_particles_in_different_states_have_the_bits_of_each_alone)
{
    struct setup setup;
    struct test_run run;
    if (!take_setup(_i, &setup, &run))
        return;
    GRand *random = g_rand_new_with_seed(43);
    for (int round = 0; round < 10 * ROUNDS; round++) {
        for (size_t p = 0; p < BLOCK; p++) {
            const size_t s = (size_t)g_rand_int_range(random, 0, STATES);
            fill_particle(&run, p, &states[s], setup.geometry == MPM_PLANE_STRAIN, random);
        }
        (void)update_by_both(&run, setup.table, setup.geometry, setup.name, random, 0.5);
    }
    g_rand_free(random);
    test_run_close(&run);
}
END_TEST

START_TEST(melted_and_cut_states_are_taken_particle_by_particle)
{
    static const struct law_case *const law = &laws[LAW_WITH_BOTH];
    struct test_run run = open_law(law, "axisymmetric");
    GRand *random = g_rand_new_with_seed(47);
    for (size_t s = 0; s < STATES; s++) {
        for (size_t p = 0; p < BLOCK; p++)
            fill_particle(&run, p, &states[s], false, random);
        const bool in_vectors = update_by_both(&run, mpm_fast_laws_baseline, MPM_AXISYMMETRIC,
                                               states[s].name, random, 0.01);
        ck_assert_msg(in_vectors == states[s].in_vectors, "%s: %d", states[s].name, in_vectors);
    }
    g_rand_free(random);
    test_run_close(&run);
}
END_TEST

/* The least shear at which a particle of the law yields. */
static double shear_at_yield(const struct mpm_material *material)
{
    double low = 0.0, high = 0.1;
    for (int k = 0; k < 60; k++) {
        const double f[MPM_GRADIENT_SIZE] = {
            [MPM_XX] = 1.0, [MPM_XY] = 0.5 * (low + high), [MPM_YY] = 1.0, [MPM_ZZ] = 1.0};
        const struct mpm_law_step step = {.old_f = f, .f = f, .duration = 0.02};
        double state[MPM_LAW_STATES] = {1.0, 1.0, 1.0}, tau[MPM_SYMMETRIC_SIZE], wave;
        ck_assert(material->law->update(material, &step, state, tau, &wave));
        *(state[MPM_PLASTIC_STRAIN] > 0.0 ? &high : &low) = f[MPM_XY];
    }
    return high;
}

/* Plastic strains of 1e-300, whose powers leave the range of the exponential function. */
START_TEST(the_faintest_plastic_strain_has_the_bits_of_one_particle)
{
    struct test_run run = open_law(&laws[STEEP_LAW], "axisymmetric");
    GRand *random = g_rand_new_with_seed(53);
    const double shear = shear_at_yield(&run.simulation->state.bodies[0].material);
    for (size_t p = 0; p < BLOCK; p++) {
        fill_particle(&run, p, &states[0], false, random);
        run.simulation->state.particles.deformation[MPM_XY][p] = shear;
    }
    (void)update_by_both(&run, mpm_fast_laws_baseline, MPM_AXISYMMETRIC, "faint", random, 0.0);
    ck_assert(*mpm_particle_law_state(&run.simulation->state.particles, 0, MPM_PLASTIC_STRAIN) >
              0.0);
    g_rand_free(random);
    test_run_close(&run);
}
END_TEST

START_TEST(back_stress_tables_and_conducted_temperatures_have_no_vectors)
{
    struct test_run run = open_law(&laws[GRUNEISEN_LAW], "axisymmetric");
    struct mpm_material_spec *const material = &run.scene->materials[0];
    double *const given = material->parameter;
    ck_assert(mpm_fast_body_has_vectors(material));
    material->hardening.count = 1;
    ck_assert(!mpm_fast_body_has_vectors(material));
    material->hardening.count = 0;
    given[MPM_PARAMETER_KINEMATIC_MODULUS] = 1.0;
    ck_assert(!mpm_fast_body_has_vectors(material));
    given[MPM_PARAMETER_KINEMATIC_MODULUS] = 0.0;
    ck_assert(mpm_fast_body_has_vectors(material));
    material->law = &mpm_johnson_cook;
    given[MPM_PARAMETER_SPECIFIC_HEAT] = 0.0; /* softening by a conducted temperature */
    ck_assert(!mpm_fast_body_has_vectors(material));
    test_run_close(&run);
}
END_TEST

/* ------------------------------------------------------------------------- scenes */

/* A rod meets a plate at r = 0: one metal with viscosity and one without, 3 x 3 particles a cell,
 * so that rows end within vectors. In the last scenes the plate's metal has back stress, and is
 * taken particle by particle. */
static const char IMPACT[] =
    "format: 1\ngeometry: axisymmetric\n"
    "grid: {origin: [0, 0], cell: [1, 0.8], cells: [12, 15]}\n"
    "units: {length: mm, mass: kg, time: ms, temperature: K}\n"
    "time: {end: 1000, courant: 0.3}\n"
    "method: {shape: ugimp, stress_update: musl}\n"
    "materials:\n"
    "  - {name: heavy, density: 1.3, law: johnson_cook_gruneisen, " STRENGTH ", " PRESSURE VISCOUS
    "}\n"
    "  - {name: light, density: 0.7, law: von_mises, bulk: 0.4, shear: 0.2, yield_stress: 0.003, "
    "hardening_modulus: 0.01}\n"
    "bodies:\n"
    "  - {name: rod, material: heavy, particles_per_cell: [3, 3], velocity: [0, -0.3],\n"
    "     region: {rectangle: {from: [0, 6.4], to: [3, 9.6]}}}\n"
    "  - {name: plate, material: light, particles_per_cell: [3, 3],\n"
    "     region: {rectangle: {from: [0, 3.2], to: [7, 6.4]}}}\n";
#define BACK_STRESS "materials.light.kinematic_modulus=0.01"
#define PLANE       "geometry=plane_strain"
#define AXIS        "boundary=[{region: {line: {from: [0, 0], to: [0, 12]}}, symmetry: true}]"
#define CONTACT     "contact={fields: bodies, law: friction, friction: 0.2, normal: larger}"
#define MIRROR      "boundary=[{region: {line: {from: [0, 3.2], to: [12, 3.2]}}, symmetry: true}]"
#define CRACK       "cracks=[{points: [[2.2, 4.9], [4.7, 4.3]], contact: friction, friction: 0.1}]"

static const char *const impacts[][5] = {
    {NULL},
    {CONTACT, NULL},
    {CONTACT, "method.stress_update=usavg", "method.shape=cpdi", NULL},
    {CONTACT, "method.shape=bspline2", "method.stress_update=usl", NULL},
    {CONTACT, "method.transfer={kind: apic}", MIRROR, NULL},
    {CRACK, MIRROR, "method.stress_update=usf", NULL},
    {PLANE, AXIS, CONTACT, "method.shape=classic", NULL},
    {BACK_STRESS, CONTACT, NULL},
    {BACK_STRESS, CRACK, NULL},
};

START_TEST(metals_on_vectors_agree_with_the_reference_kernels_beside_other_features)
{
    const struct kernel_side sides[2] = {
        {impacts[_i], {.threads = 1, .kernels = MPM_KERNELS_REFERENCE}},
        {impacts[_i], {.threads = 1, .kernels = MPM_KERNELS_FAST}}};
    struct kernel_pair pair = kernel_pair_open_text(IMPACT, sides);
    kernel_pair_assert_alike(&pair, 60);
    const struct mpm_particles *const particles = &pair.simulation[1]->state.particles;
    size_t flowed = 0;
    for (size_t p = 0; p < particles->count; p++)
        flowed += *mpm_particle_law_state(particles, p, MPM_PLASTIC_STRAIN) > 0.0;
    ck_assert_msg(flowed > particles->count / 20, "%zu of %zu have flowed", flowed,
                  particles->count);
    kernel_pair_close(&pair);
}
END_TEST

Suite *suite_fast_metals(void)
{
    Suite *const suite = suite_create("fast_metals");
    TCase *const bits = tcase_create("bits");
    tcase_add_loop_test(bits, four_particles_in_one_state_have_the_bits_of_each_alone, 0, SETUPS);
    tcase_add_loop_test(bits, four_particles_in_different_states_have_the_bits_of_each_alone, 0,
                        SETUPS);
    tcase_add_test(bits, melted_and_cut_states_are_taken_particle_by_particle);
    tcase_add_test(bits, the_faintest_plastic_strain_has_the_bits_of_one_particle);
    tcase_add_test(bits, back_stress_tables_and_conducted_temperatures_have_no_vectors);
    suite_add_tcase(suite, bits);
    TCase *const scenes = tcase_create("scenes");
    tcase_add_loop_test(scenes,
                        metals_on_vectors_agree_with_the_reference_kernels_beside_other_features, 0,
                        G_N_ELEMENTS(impacts));
    suite_add_tcase(suite, scenes);
    return suite;
}

/* Fast kernels against reference kernels over what a scene may combine, on scenes made to be
 * awkward, and where a run fails.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/combinations.h"
#include "support/crowd.h"
#include "support/folder.h"
#include "support/kernel_pair.h"
#include "support/settings.h"

#include <glib.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct geometry {
    const char *name, *setting; /* setting: one more, or NULL */
    bool axisymmetric, hoop;    /* hoop: r may move with the hoop rate */
} geometries[] = {
    {"plane_strain", NULL, false, false},
    {"plane_stress", NULL, false, false},
    {"axisymmetric", "method.axis=truncated", true, true},
    {"axisymmetric", "method.axis=untruncated", true, false},
};
static const struct order {
    const char *name, *setting; /* setting: one more, or NULL */
} orders[] = {{"usl", NULL},
              {"musl", NULL},
              {"usf", NULL},
              {"usavg", NULL},
              {"usavg", "method.extrapolate=false"}};
enum {
    GEOMETRIES = G_N_ELEMENTS(geometries),
    ORDERS = G_N_ELEMENTS(orders),
    LAWS = G_N_ELEMENTS(laws),
    COMBINATIONS = TEST_SHAPES * GEOMETRIES * ORDERS,
    LONG_TIMEOUT = 3600,
};

/* ------------------------------------------------------------------ settings */

static const struct order *order_of(int combination)
{
    return &orders[combination / TEST_SHAPES / GEOMETRIES];
}

/* Family, geometry and order number `index`. */
static const struct geometry *add_combination(struct settings *settings, int index)
{
    const struct geometry *geometry = &geometries[index / TEST_SHAPES % GEOMETRIES];
    settings_add_formatted(settings, "method.shape=%s", test_shapes[index % TEST_SHAPES]);
    settings_add_formatted(settings, "geometry=%s", geometry->name);
    if (geometry->setting != NULL)
        settings_add(settings, geometry->setting);
    const struct order *const order = order_of(index);
    settings_add_formatted(settings, "method.stress_update=%s", order->name);
    if (order->setting != NULL)
        settings_add(settings, order->setting);
    return geometry;
}

/* x, y of an expression as the geometry calls them. */
static char *translated(const char *text, const struct geometry *geometry)
{
    char *copy = g_strdup(text);
    for (char *c = copy; geometry->axisymmetric && *c != '\0'; c++)
        *c = *c == 'X' ? 'r' : *c == 'Y' ? 'z' : *c;
    for (char *c = copy; *c != '\0'; c++)
        *c = *c == 'X' ? 'x' : *c == 'Y' ? 'y' : *c;
    return copy;
}

static void add_translated(struct settings *settings, const char *text,
                           const struct geometry *geometry)
{
    char *copy = translated(text, geometry);
    settings->owned[settings->owned_count++] = copy;
    settings_add(settings, copy);
}

/* --------------------------------------------------------------------- pairs */

/* Opens the scene `text` with reference and fast kernels, or (noisy) with fast kernels twice;
 * fails the test if it is refused. */
static struct kernel_pair open_pair(const char *text, const struct settings *settings, bool noisy)
{
    char *folder = test_folder_create();
    char *path = test_folder_write(folder, "scene.yaml", text);
    const struct kernel_side sides[2] = {
        {settings->texts, {.threads = 1, .kernels = MPM_KERNELS_REFERENCE}},
        {settings->texts, {.threads = 1, .kernels = KERNEL_PAIR_OTHER}},
    };
    struct kernel_pair pair;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status =
        noisy ? kernel_pair_open_noisy(path, settings->texts, &pair, &error)
              : kernel_pair_open(path, sides, &pair, &error);
    g_free(path);
    test_folder_remove(folder);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    return pair;
}

/* What becomes of a rounding error at the start after as many steps. */
static double noise_after(const char *text, const struct settings *settings, uint64_t steps)
{
    struct kernel_pair pair = open_pair(text, settings, true);
    for (uint64_t step = 0; step < steps && kernel_pair_step(&pair); step++)
        ;
    const double part = kernel_pair_worst(&pair);
    kernel_pair_close(&pair);
    return part;
}

/* Fails the test unless both sides agree; the message names the settings, and states how far a
 * rounding error gets. */
static void check_pair(const struct kernel_pair *pair, const char *text,
                       const struct settings *settings)
{
    if (kernel_pair_worst(pair) <= KERNEL_PAIR_BOUND && kernel_pair_ended_alike(pair))
        return;
    char *found = kernel_pair_text(pair);
    char *all = g_strjoinv(" ", (char **)(uintptr_t)settings->texts);
    ck_abort_msg("with %s: a rounding error comes to %.1e; %.1200s", all,
                 noise_after(text, settings, mpm_simulation_step(pair->simulation[0])), found);
}

/* USL, and USAVG without re-extrapolation, make any round-off grow without bound where nodes of
 * little mass are: at the edges of bodies with classic functions, and at r < 0, where untruncated
 * domains leave a mass that is a small difference. APIC does with classic functions at any edge
 * (affine.h). There, two codes can be compared for a few steps only. */
static bool amplifies_round_off(int combination, const struct settings *settings)
{
    for (guint k = 0; k < settings->count; k++)
        if (strstr(settings->texts[k], "apic") != NULL &&
            strcmp(test_shapes[combination % TEST_SHAPES], "classic") == 0)
            return true;
    const struct geometry *geometry = &geometries[combination / TEST_SHAPES % GEOMETRIES];
    return (strcmp(order_of(combination)->name, "usl") == 0 ||
            order_of(combination)->setting != NULL) &&
           (strcmp(test_shapes[combination % TEST_SHAPES], "classic") == 0 ||
            (geometry->axisymmetric && !geometry->hoop));
}

/* Takes the steps, which must go well, and compares. Returns the largest |F - 1| at the end. */
static double run_pair(int combination, const char *text, const struct settings *settings)
{
    struct kernel_pair pair = open_pair(text, settings, false);
    for (int step = amplifies_round_off(combination, settings) ? 10 : KERNEL_PAIR_STEPS;
         step > 0 && kernel_pair_step(&pair); step--)
        ;
    check_pair(&pair, text, settings);
    ck_assert_msg(pair.error[0].status == MPM_OK, "%s", pair.error[0].message);
    const size_t count = mpm_simulation_particle_count(pair.simulation[0]);
    double strain = 0.0;
    mpm_simulation_field(pair.simulation[0], MPM_FIELD_DEFORMATION_GRADIENT, pair.values[0]);
    for (size_t i = 0; i < 5 * count; i++) {
        const bool diagonal = i % 5 == 0 || i % 5 > 2;
        strain = fmax(strain, fabs(pair.values[0][i] - (diagonal ? 1.0 : 0.0)));
    }
    kernel_pair_close(&pair);
    return strain;
}

/* -------------------------------------------------------------- combinations */

/* What a scene may have besides; each bit of `chosen` is one, and `exchange` which of them. */
static void add_features(struct settings *settings, unsigned chosen, unsigned exchange,
                         bool has_apic, const struct geometry *geometry)
{
    const unsigned last = has_apic ? EXCHANGES : APIC;
    if ((chosen & 1u) != 0)
        settings_add(settings, "method.position_update=midpoint");
    if ((chosen & 2u) != 0)
        settings_add(settings, exchanges[exchange % last]);
    if ((chosen & 4u) != 0)
        add_translated(settings, "loads={body_force: ['0.02*sin(X+t)', -0.03]}", geometry);
    if ((chosen & 8u) != 0)
        settings_add(settings,
                     geometry->hoop ? "method.radius_update=hoop" : "method.deformation_terms=4");
}

/* All of the table in the long tier; otherwise two choices of features for each combination,
 * taken so that every two features meet somewhere. */
START_TEST(both_kernels_agree_on_every_combination)
{
    enum { FEATURES = 16, CHOICES = 2 };
    const unsigned choices = kernel_pair_is_long() ? FEATURES : CHOICES;
    for (unsigned law = 0; law < LAWS; law++)
        for (unsigned k = 0; k < choices; k++) {
            struct settings settings = {.count = 0};
            const struct geometry *geometry = add_combination(&settings, _i);
            const unsigned chosen =
                kernel_pair_is_long() ? k : (7 * (unsigned)_i + 5 * law + 11 * k) % FEATURES;
            if (geometry->axisymmetric)
                settings_add(&settings, "grid.origin=[0, 0]");
            for (size_t i = 0; i < G_N_ELEMENTS(crowd_velocities); i++)
                add_translated(&settings, crowd_velocities[i], geometry);
            add_laws(&settings, &laws[law]);
            add_features(&settings, chosen, (unsigned)_i + law + (unsigned)_i / TEST_SHAPES,
                         strcmp(test_shapes[_i % TEST_SHAPES], "cpdi") != 0, geometry);
            if (!laws[law].no_plane_stress || strcmp(geometry->name, "plane_stress") != 0)
                ck_assert(run_pair(_i, CROWD, &settings) > 0.01);
            settings_clear(&settings);
        }
}
END_TEST

/* ------------------------------------------------------------ awkward scenes */

/* A body alone. Wave speed 1.5. */
static const char ALONE[] =
    "format: 1\n"
    "title: One body\n"
    "geometry: plane_strain\n"
    "grid: {origin: [-1, -2], cell: [1, 1], cells: [40, 40]}\n"
    "time: {end: 1000, courant: 0.3}\n"
    "materials: [{name: soft, law: neo_hookean, density: 1, bulk: 1.25, shear: 0.75}]\n"
    "bodies:\n"
    "  - {name: body, material: soft, region: {rectangle: {from: [4, 4], to: [5, 5]}},\n"
    "     particles_per_cell: [1, 1]}\n";

static void place_body(struct settings *settings, const struct geometry *geometry)
{
    if (geometry->axisymmetric)
        settings_add(settings, "grid.origin=[0, -2]");
}

/* Fewer than a vector, and the rest of one. */
START_TEST(both_kernels_agree_on_a_few_particles)
{
    static const int counts[] = {1, 2, 3, 4, 5, 7, 9};
    for (size_t k = 0; k < G_N_ELEMENTS(counts); k++) {
        struct settings settings = {.count = 0};
        const struct geometry *geometry = add_combination(&settings, _i);
        place_body(&settings, geometry);
        settings_add_formatted(&settings, "bodies.body.particles_per_cell=[%d, 1]", counts[k]);
        add_translated(&settings, "bodies.body.velocity=['0.2*sin(9*X)', '0.3*sin(7*X)']",
                       geometry);
        (void)run_pair(_i, ALONE, &settings);
        settings_clear(&settings);
    }
}
END_TEST

/* Positions go in steps of 1/8 and 1/16 of a cell, to the bit: on centres, where the functions
 * of uGIMP change their branch, and on the lines of the grid. */
START_TEST(both_kernels_agree_on_particles_that_stand_on_the_lines_of_the_grid)
{
    struct settings settings = {.count = 0};
    const struct geometry *geometry = add_combination(&settings, _i);
    place_body(&settings, geometry);
    settings_add(&settings, "bodies.body.region.rectangle.to=[7, 6]");
    settings_add(&settings, "bodies.body.particles_per_cell=[2, 2]");
    settings_add(&settings, "time={end: 1000, step: 0.125}");
    settings_add(&settings, geometry->axisymmetric ? "bodies.body.velocity=[0, 1]"
                                                   : "bodies.body.velocity=[0.5, 1]");
    /* classic: a node next to a particle on a line may have a gradient and no mass */
    const double strain = run_pair(_i, ALONE, &settings);
    ck_assert_msg(strain < 1e-12 || _i % TEST_SHAPES == 0, "%g", strain);
    settings_clear(&settings);
}
END_TEST

/* So soft that the bodies go on as they were thrown: domains of CPDI get three times as long,
 * reach over several cells and turn. Axes differ. */
START_TEST(both_kernels_agree_on_stretched_and_sheared_bodies)
{
    static const char *const motions[] = {
        "bodies.body.velocity=['0.2*(X-17)', '-0.03*(Y-17)']",
        "bodies.body.velocity=['0.2*(Y-17)', '0.05*(X-17)']",
        "bodies.body.velocity=['0.1*(X-17)-0.3*(Y-17)', '0.3*(X-17)+0.2*(Y-17)']",
    };
    for (size_t k = 0; k < G_N_ELEMENTS(motions); k++) {
        struct settings settings = {.count = 0};
        const struct geometry *geometry = add_combination(&settings, _i);
        place_body(&settings, geometry);
        settings_add(&settings, "grid.cell=[1, 0.6]");
        settings_add(&settings, "grid.cells=[40, 60]");
        settings_add(&settings, "time.courant=0.12");
        settings_add(&settings, "materials.soft.bulk=0.05");
        settings_add(&settings, "materials.soft.shear=0.03");
        settings_add(&settings, "bodies.body.region.rectangle.from=[15.2, 15.5]");
        settings_add(&settings, "bodies.body.region.rectangle.to=[19, 19]");
        settings_add(&settings, "bodies.body.particles_per_cell=[2, 2]");
        add_translated(&settings, motions[k], geometry);
        const double strain = run_pair(_i, ALONE, &settings);
        ck_assert_msg(strain > 0.2, "%s: %g", motions[k], strain);
        settings_clear(&settings);
    }
}
END_TEST

/* A disk from the axis on: innermost particles at an eighth of a cell, drawn in and pushed out. */
START_TEST(both_kernels_agree_next_to_the_axis)
{
    static const char *const motions[] = {
        "bodies.body.velocity=['-0.2*X', '0.1*sin(Y)']",
        "bodies.body.velocity=['0.25*X*cos(3*Y)', '0.1*X']",
    };
    for (size_t k = 0; k < G_N_ELEMENTS(motions); k++) {
        struct settings settings = {.count = 0};
        const struct geometry *geometry = add_combination(&settings, _i);
        if (geometry->axisymmetric) {
            place_body(&settings, geometry);
            settings_add(&settings, "bodies.body.region.rectangle.from=[0, 4]");
            settings_add(&settings, "bodies.body.region.rectangle.to=[3, 7]");
            settings_add(&settings, "bodies.body.particles_per_cell=[4, 2]");
            add_translated(&settings, motions[k], geometry);
            if (k > 0 && geometry->hoop)
                settings_add(&settings, "method.radius_update=hoop");
            const double strain = run_pair(_i, ALONE, &settings);
            ck_assert_msg(strain > 0.01, "%g", strain);
        }
        settings_clear(&settings);
    }
}
END_TEST

/* Boxes filled from wall to wall, down to a single cell: B-splines fold on every side, and
 * the narrowest from both at once. */
START_TEST(both_kernels_agree_from_wall_to_wall)
{
    static const int sizes[][2] = {{1, 3}, {2, 1}, {3, 2}, {5, 4}};
    for (size_t k = 0; k < G_N_ELEMENTS(sizes); k++) {
        const int w = sizes[k][0], h = sizes[k][1];
        struct settings settings = {.count = 0};
        const struct geometry *geometry = add_combination(&settings, _i);
        settings_add(&settings, "grid.origin=[0, 0]");
        settings_add_formatted(&settings, "grid.cells=[%d, %d]", w, h);
        settings_add_formatted(&settings,
                               "bodies.body.region.rectangle={from: [0, 0], to: [%d, %d]}", w, h);
        settings_add(&settings, "bodies.body.particles_per_cell=[3, 2]");
        char *motion = g_strdup_printf("bodies.body.velocity=['0.05*sin(%g*X)*cos(2*Y)', "
                                       "'0.05*sin(%g*Y)*cos(X)']",
                                       G_PI / w, G_PI / h);
        add_translated(&settings, motion, geometry);
        settings_add_formatted(
            &settings,
            "boundary=[{region: {line: {from: [0, 0], to: [0, %d]}}, velocity: [0, "
            "free]}, {region: {line: {from: [%d, 0], to: [%d, %d]}}, velocity: [0, "
            "free]}, {region: {line: {from: [0, 0], to: [%d, 0]}}, velocity: [free, "
            "0]}, {region: {line: {from: [0, %d], to: [%d, %d]}}, velocity: [free, 0]}]",
            h, w, w, h, w, h, w, h);
        (void)run_pair(_i, ALONE, &settings);
        g_free(motion);
        settings_clear(&settings);
    }
}
END_TEST

/* ------------------------------------------------------------------ failures */

static const struct failing {
    const char *name, *says; /* part of the message, in axisymmetry if it differs in the plane */
    const char *settings[6]; /* to NULL */
} failing[] = {
    {"a body that flies off",
     "left the grid",
     {"bodies.body.velocity=[4, 0.5]", "bodies.body.region.rectangle.from=[30, 20]",
      "bodies.body.region.rectangle.to=[33, 22]"}},
    {"a step over more than a cell",
     "cells along",
     {"bodies.body.velocity=[0.5, 6]", "loads={body_force: [0, '20*t']}",
      "time={end: 100, step: 0.125, allow_unstable: true}"}},
    {"a body crushed until it is inverted",
     "inverted at step",
     {"boundary=[{region: all, velocity: [0, '(0.1-18*(t>1))*(Y-4.5)']}]",
      "materials.soft.law=linear_elastic", "method.deformation_terms=1",
      "time={end: 100, step: 0.125, allow_unstable: true}"}},
    {"particles pulled past the axis",
     "",
     {"bodies.body.region.rectangle.from=[0, 4]", "bodies.body.region.rectangle.to=[3, 6]",
      "boundary=[{region: {rectangle: {from: [1, 0], to: [20, 10]}}, velocity: ['-3*t-1', 0]}]",
      "time={end: 100, step: 0.125, allow_unstable: true}"}},
    {"a load that is not finite after a while",
     "not finite",
     {"loads={body_force: ['sqrt(2.47-t)', 0]}"}},
    {"a load that varies in space and is not finite after a while",
     "has a body force that is not finite",
     {"loads={body_force: ['0*X+sqrt(2.47-t)', 0]}"}},
    {"a boundary that is not finite after a while",
     "not finite",
     {"boundary=[{region: {line: {from: [4, 2], to: [4, 8]}}, velocity: ['sqrt(1.25-t)', free]}]"}},
};

/* Particles at the middle of a body that grows along y for ever. */
static const struct failing growing = {
    "a domain larger than the grid",
    "has a domain that reaches",
    {"boundary=[{region: all, velocity: [0, '0.5*(Y-4.5)']}]", "grid.cells=[40, 12]",
     "time={end: 100, step: 0.125, allow_unstable: true}", "bodies.body.region.rectangle.to=[7, 5]",
     "bodies.body.particles_per_cell=[2, 1]"},
};

/* The same step, the same particle, the same words; and then the same last good state. */
static void fail_alike(int combination, const struct failing *failing_scene)
{
    enum { STEPS_MAX = 200 };
    struct settings settings = {.count = 0};
    const struct geometry *geometry = add_combination(&settings, combination);
    place_body(&settings, geometry);
    settings_add(&settings, "bodies.body.particles_per_cell=[2, 2]");
    for (size_t k = 0; failing_scene->settings[k] != NULL; k++)
        add_translated(&settings, failing_scene->settings[k], geometry);
    struct kernel_pair pair = open_pair(ALONE, &settings, false);
    for (int step = 0; step < STEPS_MAX && kernel_pair_step(&pair); step++)
        ;
    check_pair(&pair, ALONE, &settings);
    const char *said = pair.error[0].message;
    ck_assert_msg(pair.error[0].status == MPM_RUN_FAILED &&
                      strstr(said, failing_scene->says) != NULL,
                  "%s: %s", failing_scene->name, said);
    kernel_pair_close(&pair);
    settings_clear(&settings);
}

/* Without re-extrapolation a rounding error comes to more than the bound on the way there. */
START_TEST(both_kernels_fail_alike)
{
    static const struct settings none = {.count = 0};
    const bool comparable = !amplifies_round_off(_i, &none) && order_of(_i)->setting == NULL;
    for (size_t k = 0; k < G_N_ELEMENTS(failing) && comparable; k++)
        fail_alike(_i, &failing[k]);
    if (strcmp(test_shapes[_i % TEST_SHAPES], "cpdi") == 0)
        fail_alike(_i, &growing);
}
END_TEST

Suite *suite_kernel_table(void)
{
    Suite *suite = suite_create("kernel_table");
    TCase *table = tcase_create("table");
    if (kernel_pair_is_long())
        tcase_set_timeout(table, LONG_TIMEOUT);
    tcase_add_loop_test(table, both_kernels_agree_on_every_combination, 0, COMBINATIONS);
    suite_add_tcase(suite, table);
    TCase *awkward = tcase_create("awkward");
    tcase_add_loop_test(awkward, both_kernels_agree_on_a_few_particles, 0, COMBINATIONS);
    tcase_add_loop_test(awkward,
                        both_kernels_agree_on_particles_that_stand_on_the_lines_of_the_grid, 0,
                        COMBINATIONS);
    tcase_add_loop_test(awkward, both_kernels_agree_on_stretched_and_sheared_bodies, 0,
                        COMBINATIONS);
    tcase_add_loop_test(awkward, both_kernels_agree_next_to_the_axis, 0, COMBINATIONS);
    tcase_add_loop_test(awkward, both_kernels_agree_from_wall_to_wall, 0, COMBINATIONS);
    suite_add_tcase(suite, awkward);
    TCase *failures = tcase_create("failures");
    tcase_add_loop_test(failures, both_kernels_fail_alike, 0, COMBINATIONS);
    suite_add_tcase(suite, failures);
    return suite;
}

/* The J integral of fields that particles are given, without a step: of a crack tip, and of smooth
 * fields, whose J is 0 whatever they are.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"
#include "suites.h"
#include "support/near.h"
#include "support/scenes.h"
#include "support/settings.h"
#include "verification/exact/lame_cylinder.h"
#include "verification/exact/williams_field.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>

enum { AXES = 2, GRADIENT = 5 };

static const char BLOCK[] =
    "format: 1\n"
    "geometry: plane_strain\n"
    "grid: {origin: [0, 0], cell: [1, 0.8], cells: [36, 45]}\n"
    "time: {end: 1, courant: 0.3}\n"
    "materials: [{name: stiff, law: linear_elastic, density: 2, bulk: 80, shear: 48}]\n"
    "bodies:\n"
    "  - {name: block, material: stiff, region: {rectangle: {from: [2, 1.6], to: [34, 34.4]}}}\n";
static const double BULK = 80.0, SHEAR = 48.0, DENSITY = 2.0;

static const char *const families[] = {"classic", "ugimp", "cpdi", "bspline2", "bspline3"};
enum { FAMILIES = G_N_ELEMENTS(families) };

static double poisson(void)
{
    return (3.0 * BULK - 2.0 * SHEAR) / (2.0 * (3.0 * BULK + SHEAR));
}

static double kappa_of(enum mpm_geometry geometry)
{
    return geometry == MPM_PLANE_STRESS ? (3.0 - poisson()) / (1.0 + poisson())
                                        : 3.0 - 4.0 * poisson();
}

/* ------------------------------------------------------------ given starts */

/* A state: gradient of the displacement, and velocity, at a place. */
struct given {
    void (*gradient)(const void *context, const double place[AXES], double gradient[GRADIENT]);
    void (*velocity)(const void *context, const double place[AXES], double velocity[AXES]);
    const void *context;
};

static void give(struct test_run *run, const struct given *given)
{
    struct mpm_error error = {.message = ""};
    size_t count;
    double *const place = test_run_field(run, MPM_FIELD_POSITION, &count);
    double *const f = g_new0(double, GRADIENT * count);
    double *const v = g_new0(double, AXES * count);
    for (size_t p = 0; p < count; p++) {
        double *const own = f + GRADIENT * p;
        if (given->gradient != NULL)
            given->gradient(given->context, place + AXES * p, own);
        own[0] += 1.0;
        own[3] += 1.0;
        own[4] += 1.0;
        if (given->velocity != NULL)
            given->velocity(given->context, place + AXES * p, v + AXES * p);
    }
    const enum mpm_status status = mpm_simulation_set_start(run->simulation, v, f, &error);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    g_free(f);
    g_free(v);
    free(place);
}

static struct mpm_j_integral j_of(const struct test_run *run, size_t index)
{
    struct mpm_j_integral value;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status =
        mpm_simulation_j_integral(run->simulation, index, &value, &error);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    return value;
}

/* ---------------------------------------------------------- fields of a tip */

static void tip_gradient(const void *context, const double place[AXES], double gradient[GRADIENT])
{
    williams_field_gradient(context, place, gradient);
}

/* Tips: on the grid's lines and off them, at both ends of a chain, in all directions. */
static const struct tip {
    const char *points, *name;
    double direction[AXES];
} TIPS[] = {
    {"[[0.2, 18.1], [18.3, 18.1]]", "end", {1, 0}},
    {"[[18.3, 18.1], [0.2, 18.1]]", "start", {1, 0}},
    {"[[35.8, 17.6], [18.3, 17.6]]", "end", {-1, 0}}, /* on a line of nodes, from the right */
    {"[[18, 17.6], [18, 0.3]]", "start", {0, 1}},     /* and at a node */
    {"[[6.2, 2.1], [18.2, 18.1]]", "end", {0.6, 0.8}},
    {"[[18.2, 18.1], [34.2, 6.1]]", "start", {-0.8, 0.6}},
};
enum { TIP_COUNT = G_N_ELEMENTS(TIPS) };
enum { SIZES = 4 };
static const int CONTOURS[SIZES] = {4, 6, 8, 10};

static struct test_run open_tip(const struct tip *tip, const char *shape, const char *geometry)
{
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "geometry=%s", geometry);
    settings_add_formatted(&settings, "method.shape=%s", shape);
    settings_add_formatted(
        &settings,
        "cracks=[{points: %s, contact: none, j_integral: [{tip: %s, contour: 4, dynamic: false}, "
        "{tip: %s, contour: 6, dynamic: false}, {tip: %s, contour: 8, dynamic: false}, "
        "{tip: %s, contour: 10, dynamic: false}]}]",
        tip->points, tip->name, tip->name, tip->name, tip->name);
    const struct test_run run = test_run_open(BLOCK, settings.texts, 1);
    settings_clear(&settings);
    return run;
}

static struct williams_field field_at(const struct test_run *run, const struct tip *tip,
                                      enum mpm_geometry geometry)
{
    const struct mpm_j_integral value = j_of(run, 0);
    return (struct williams_field){
        .shear = SHEAR,
        .kappa = kappa_of(geometry),
        .tip = {value.tip[0], value.tip[1]},
        .direction = {tip->direction[0], tip->direction[1]},
    };
}

/* Means over a cell of what falls with the root of the distance r, or with it, and linear values
 * between nodes: errors of the order of (h/r)^2. */
static double tolerance(int contour)
{
    return 0.25 / ((double)contour * contour);
}

START_TEST(the_field_of_a_tip_has_its_j_and_its_stress_intensities)
{
    static const struct {
        double one, two, parallel;
    } loads[] = {{1e-4, 0, 0}, {0, 1e-4, 0}, {0, -1e-4, 0}, {8e-5, 6e-5, 0}, {1e-4, 0, 3e-5}};
    const struct tip *const tip = &TIPS[_i / FAMILIES];
    const enum mpm_geometry geometry = _i % 2 == 0 ? MPM_PLANE_STRAIN : MPM_PLANE_STRESS;
    struct test_run run = open_tip(tip, families[_i % FAMILIES],
                                   geometry == MPM_PLANE_STRAIN ? "plane_strain" : "plane_stress");
    struct williams_field field = field_at(&run, tip, geometry);
    const double modulus = williams_field_modulus(&field);
    for (size_t k = 0; k < G_N_ELEMENTS(loads); k++) {
        field.mode_1 = loads[k].one;
        field.mode_2 = loads[k].two;
        field.parallel = loads[k].parallel;
        give(&run, &(struct given){tip_gradient, NULL, &field});
        for (size_t i = 0; i < SIZES; i++) {
            const struct mpm_j_integral found = j_of(&run, i);
            const double j = 1e-8 / modulus, bound = tolerance(CONTOURS[i]);
            ck_assert_near(found.direction[0], tip->direction[0], 1e-12);
            ck_assert_near(found.direction[1], tip->direction[1], 1e-12);
            if (getenv("SHOW")) printf("%d %s %d load %zu: j1 %.4f j2 %.4f (%.4f) K %.4f %.4f (%.2f %.2f)\n", _i, families[_i%FAMILIES], CONTOURS[i], k, found.j[0]/j, found.j[1]/j, -2.0 * loads[k].one * loads[k].two / modulus/j, found.stress_intensity[0]*1e4,found.stress_intensity[1]*1e4, loads[k].one*1e4, loads[k].two*1e4); else {
            ck_assert_near(found.j[0], j, j * bound);
            ck_assert_near(found.j[1], -2.0 * loads[k].one * loads[k].two / modulus, j * bound);
            ck_assert_near(found.stress_intensity[0], loads[k].one, 1e-4 * bound);
            ck_assert_near(found.stress_intensity[1], loads[k].two, 1e-4 * bound);
            }
        }
    }
    test_run_close(&run);
}
END_TEST

Suite *suite_j_integral(void)
{
    Suite *suite = suite_create("j_integral");
    TCase *tips = tcase_create("tips");
    tcase_add_loop_test(tips, the_field_of_a_tip_has_its_j_and_its_stress_intensities, 0,
                        TIP_COUNT * FAMILIES);
    suite_add_tcase(suite, tips);
    return suite;
}

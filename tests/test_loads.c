/* Body forces that are the same everywhere, and the FLIP fraction: what is done for them at the
 * nodes against what the particles would do.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"
#include "support/kernel_pair.h"
#include "support/scenes.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const shapes[] = {"classic", "ugimp", "cpdi", "bspline2", "bspline3"};
static const char *const geometries[] = {"plane_strain", "plane_stress", "axisymmetric"};
static const char *const orders[] = {"usl", "musl", "usf", "usavg"};
enum {
    SHAPES = G_N_ELEMENTS(shapes),
    GEOMETRIES = G_N_ELEMENTS(geometries),
    ORDERS = G_N_ELEMENTS(orders),
    KERNEL_SETS = 2,
    COMBINATIONS = SHAPES * GEOMETRIES * ORDERS * KERNEL_SETS,
};

/* Wave speed 1.5, masses of order 20. The boundary moves, so that the force has a part in the
 * reaction there. */
static const char BLOCK[] =
    "format: 1\n"
    "title: A block that swings\n"
    "geometry: plane_strain\n"
    "grid: {origin: [0, 0], cell: [1, 0.8], cells: [14, 15]}\n"
    "time: {end: 1000, courant: 0.3}\n"
    "materials: [{name: soft, law: neo_hookean, density: 1, bulk: 1.25, shear: 0.75}]\n"
    "bodies:\n"
    "  - {name: block, material: soft, region: {rectangle: {from: [3, 3.2], to: [8, 7.2]}},\n"
    "     particles_per_cell: [2, 2]}\n"
    "boundary:\n"
    "  - {region: {line: {from: [0, 3.2], to: [14, 3.2]}}, velocity: [free, '0.02*sin(2*t)']}\n";
static const double WAVE_SPEED = 1.5;

static double external_work(const struct mpm_simulation *simulation)
{
    struct mpm_ledger ledger;
    mpm_simulation_ledger(simulation, &ledger);
    return ledger.external_work;
}

/* One force twice: the second time so that it counts as one that varies, and acts at the
 * particles. */
static struct kernel_pair open_pair(int index)
{
    char *shape = g_strdup_printf("method.shape=%s", shapes[index % SHAPES]);
    const char *geometry = geometries[index / SHAPES % GEOMETRIES];
    char *place = g_strdup_printf("geometry=%s", geometry);
    char *order =
        g_strdup_printf("method.stress_update=%s", orders[index / SHAPES / GEOMETRIES % ORDERS]);
    char *varying = g_strdup_printf("loads={body_force: ['0*%s+0.03*cos(3*t)', -0.08]}",
                                    strcmp(geometry, "axisymmetric") == 0 ? "r" : "x");
    const char *const settings[2][5] = {
        {shape, place, order, "loads={body_force: ['0.03*cos(3*t)', -0.08]}"},
        {shape, place, order, varying},
    };
    const struct mpm_simulation_options options = {
        .threads = 1,
        .kernels = index < COMBINATIONS / KERNEL_SETS ? MPM_KERNELS_REFERENCE : MPM_KERNELS_FAST,
    };
    const struct kernel_side sides[2] = {{settings[0], options}, {settings[1], options}};
    char *folder = test_folder_create();
    char *path = test_folder_write(folder, "scene.yaml", BLOCK);
    struct kernel_pair pair;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status = kernel_pair_open(path, sides, &pair, &error);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    test_folder_remove(folder);
    char *const texts[] = {shape, place, order, varying, path};
    for (size_t k = 0; k < G_N_ELEMENTS(texts); k++)
        g_free(texts[k]);
    return pair;
}

/* Work is a sum of force times velocity times time: velocities agree to the bound in parts of
 * the wave speed, forces in parts of the stiffness, 2.25, times the length of 5 that is held. */
START_TEST(a_uniform_force_moves_and_works_alike_at_nodes_and_at_particles)
{
    struct kernel_pair pair = open_pair(_i);
    const bool amplifies = _i % SHAPES == 0 && _i / SHAPES / GEOMETRIES % ORDERS == 0;
    for (int step = amplifies ? 10 : KERNEL_PAIR_STEPS; step > 0; step--)
        ck_assert_msg(kernel_pair_step(&pair), "%s", pair.error[0].message);
    char *text = kernel_pair_text(&pair);
    ck_assert_msg(kernel_pair_worst(&pair) <= KERNEL_PAIR_BOUND, "%s", text);
    g_free(text);
    struct mpm_ledger ledger;
    mpm_simulation_ledger(pair.simulation[0], &ledger);
    const double work[2] = {ledger.external_work, external_work(pair.simulation[1])};
    const double force = 0.085 * ledger.mass + 2.25 * 5.0;
    const double bound = KERNEL_PAIR_BOUND * force * WAVE_SPEED * ledger.time;
    ck_assert(fabs(work[0]) > 1e3 * bound);
    ck_assert_msg(fabs(work[0] - work[1]) <= bound, "%.17g, %.17g: differ by %g; allowed: %g",
                  work[0], work[1], work[0] - work[1], bound);
    kernel_pair_close(&pair);
}
END_TEST

/* Enough particles for three workers. */
START_TEST(any_number_of_threads_gives_the_same_bits_under_a_uniform_force)
{
    static const enum mpm_field fields[] = {MPM_FIELD_POSITION, MPM_FIELD_VELOCITY};
    const char *const settings[] = {
        "grid.cells=[70, 70]",
        "bodies.block.region.rectangle={from: [3, 3.2], to: [63, 51.2]}",
        "bodies.block.velocity=['0.1*sin(y/5)', '0.1*cos(x/4)']",
        "method.transfer={kind: flip, fraction: 0.95}",
        "loads={body_force: ['0.03*cos(3*t)', -0.08]}",
        _i == 0 ? "method.stress_update=usl" : "method.stress_update=usavg",
        _i == 0 ? "method.shape=ugimp" : "method.shape=cpdi",
        NULL,
    };
    struct test_run one = test_run_open(BLOCK, settings, 1);
    test_run_steps(&one, 20);
    for (int threads = 2; threads <= 3; threads++) {
        struct test_run more = test_run_open(BLOCK, settings, threads);
        test_run_steps(&more, 20);
        ck_assert(external_work(one.simulation) == external_work(more.simulation));
        for (size_t f = 0; f < G_N_ELEMENTS(fields); f++) {
            size_t count;
            double *const a = test_run_field(&one, fields[f], &count);
            double *const b = test_run_field(&more, fields[f], NULL);
            ck_assert_int_eq(memcmp(a, b, 2 * count * sizeof *a), 0);
            free(a);
            free(b);
        }
        test_run_close(&more);
    }
    test_run_close(&one);
}
END_TEST

Suite *suite_loads(void)
{
    Suite *suite = suite_create("loads");
    TCase *uniform = tcase_create("uniform");
    tcase_add_loop_test(uniform, a_uniform_force_moves_and_works_alike_at_nodes_and_at_particles, 0,
                        COMBINATIONS);
    tcase_add_loop_test(uniform, any_number_of_threads_gives_the_same_bits_under_a_uniform_force, 0,
                        2);
    suite_add_tcase(suite, uniform);
    return suite;
}

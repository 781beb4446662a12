/* Body forces that are the same everywhere, and the FLIP fraction: what is done for them at the
 * nodes against what the particles would do.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
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
    const struct kernel_pair pair = kernel_pair_open_text(BLOCK, sides);
    char *const texts[] = {shape, place, order, varying};
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
    kernel_pair_assert_alike(&pair, amplifies ? 10 : KERNEL_PAIR_STEPS);
    struct mpm_ledger ledger;
    mpm_simulation_ledger(pair.simulation[0], &ledger);
    kernel_pair_assert_same_work(&pair, 0.085 * ledger.mass + 2.25 * 5.0, WAVE_SPEED);
    kernel_pair_close(&pair);
}
END_TEST

/* Enough particles for three workers. */
START_TEST(any_number_of_threads_gives_the_same_bits_under_a_uniform_force)
{
    const char *const settings[] = {
        TEST_BLOCK_FOR_THREADS,
        "bodies.block.velocity=['0.1*sin(y/5)', '0.1*cos(x/4)']",
        "method.transfer={kind: flip, fraction: 0.95}",
        "loads={body_force: ['0.03*cos(3*t)', -0.08]}",
        _i == 0 ? "method.stress_update=usl" : "method.stress_update=usavg",
        _i == 0 ? "method.shape=ugimp" : "method.shape=cpdi",
        NULL,
    };
    test_same_bits_over_threads(BLOCK, settings, 20, NULL);
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

/* Tractions and particle forces in scenes: their sum, their work, their frames, which edges bear
 * them, and what is refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/combinations.h"
#include "support/near.h"
#include "support/scene_files.h"
#include "support/scenes.h"
#include "support/settings.h"
#include "support/soft_block.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const edges[] = {"bottom", "right", "top", "left"};
enum {
    EDGES = 4,
    GRADIENT = 5,
};

/* Six by four sites that strain and turn; free, so that only loads change the momentum. */
static const char BLOCK[] =
    TEST_SOFT_SCENE("{end: 1000, step: 0.05}",
                    "  - {name: block, material: soft, region: {rectangle: {from: [4, 3.2],\n"
                    "     to: [7, 4.8]}}, velocity: [0, 0]}\n");
enum { COLUMNS = 6, ROWS = 4, COUNT = COLUMNS * ROWS };
static const double HALF[2] = {0.25, 0.2};

static struct test_run open_block(int index, const char *load)
{
    static const char *const planar = "bodies.block.velocity=['0.3*sin(y)+0.1*x', '0.2*cos(x)']";
    static const char *const radial = "bodies.block.velocity=['0.3*sin(z)+0.1*r', '0.2*cos(r)']";
    struct settings settings = test_combination_settings(index);
    settings_add(&settings, test_combination(index).axisymmetric ? radial : planar);
    settings_add(&settings, load);
    const struct test_run run = test_run_open(BLOCK, settings.texts, 1);
    settings_clear(&settings);
    return run;
}

/* Fields of all particles at one moment. */
struct moment {
    double position[2 * COUNT], f[GRADIENT * COUNT];
    struct mpm_ledger ledger;
};

static void look(const struct test_run *run, struct moment *moment)
{
    ck_assert_uint_eq(mpm_simulation_particle_count(run->simulation), COUNT);
    mpm_simulation_field(run->simulation, MPM_FIELD_POSITION, moment->position);
    mpm_simulation_field(run->simulation, MPM_FIELD_DEFORMATION_GRADIENT, moment->f);
    mpm_simulation_ledger(run->simulation, &moment->ledger);
}

static bool is_on_face(int id, int edge)
{
    const int column = id % COLUMNS, row = id / COLUMNS;
    return (edge == 0 && row == 0) || (edge == 1 && column == COLUMNS - 1) ||
           (edge == 2 && row == ROWS - 1) || (edge == 3 && column == 0);
}

/* The edge as a vector, counter clockwise, and its middle: of F, or of the undeformed domain. */
static void edge_of(const struct moment *moment, int id, int edge, bool carried, double vector[2],
                    double middle[2])
{
    static const double unit[GRADIENT] = {1.0, 0.0, 0.0, 1.0, 1.0};
    static const int outward[EDGES][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    const double *const f = carried ? &moment->f[GRADIENT * id] : unit;
    const int *const n = outward[edge];
    for (int axis = 0; axis < 2; axis++) {
        vector[axis] = 2.0 * (-f[2 * axis] * HALF[0] * n[1] + f[2 * axis + 1] * HALF[1] * n[0]);
        middle[axis] = moment->position[2 * id + axis] + f[2 * axis] * HALF[0] * n[0] +
                       f[2 * axis + 1] * HALF[1] * n[1];
    }
}

/* Force of the traction (n, t) in a frame, over all edges on a face: T times the deformed area. */
static void expected_force(const struct moment *moment, int index, int edge, bool in_edge,
                           double force[2])
{
    const struct test_combination c = test_combination(index);
    const bool ugimp = strcmp(c.shape, "ugimp") == 0;
    const bool thins = strcmp(c.geometry, "plane_stress") == 0 && !ugimp;
    force[0] = force[1] = 0.0;
    for (int id = 0; id < COUNT; id++) {
        double vector[2], along[2], middle[2], unused[2];
        if (!is_on_face(id, edge))
            continue;
        edge_of(moment, id, edge, !ugimp, vector, middle);
        edge_of(moment, id, edge, true, along, unused);
        const double length = hypot(along[0], along[1]);
        const double depth = c.axisymmetric ? middle[0]
                             : thins        ? moment->f[GRADIENT * id + 4]
                                            : 1.0;
        const double area = hypot(vector[0], vector[1]) * depth;
        const double value[2] = {0.01 * middle[0], 0.02 + 0.003 * middle[1]};
        force[0] +=
            area * (in_edge ? (value[0] * along[1] + value[1] * along[0]) / length : value[0]);
        force[1] +=
            area * (in_edge ? (value[1] * along[1] - value[0] * along[0]) / length : value[1]);
    }
}

/* FLIP hands the forces of a step to the particles whole: with a load, the sum of momenta is dt
 * times their sum larger than without. Momenta are of order one, sums of 24 particles over 16
 * nodes; a step's change is of order 1e-3, so that a wrong factor is 1e9 times the bound. */
static const double MOMENTUM_ROUND_OFF = 24 * 16 * 8 * DBL_EPSILON;

/* Loads begin with the seventh step, when the block has strained. */
enum { STEPS_BEFORE = 6 };
static const double STEP = 0.05;
#define LOADED "(t>0.29)"

/* Momentum after the loaded step; the state before it. */
static void step_under(int index, const char *load, struct moment *before, double momentum[2])
{
    struct test_run run = open_block(index, load);
    struct mpm_ledger ledger;
    test_run_steps(&run, STEPS_BEFORE);
    look(&run, before);
    test_run_steps(&run, 1);
    mpm_simulation_ledger(run.simulation, &ledger);
    memcpy(momentum, ledger.momentum, sizeof ledger.momentum);
    test_run_close(&run);
}

static char *load_text(int index, const char *list, const char *edge, const char *frame)
{
    const bool radial = test_combination(index).axisymmetric;
    return g_strdup_printf("loads={%s: [{body: block, edge: %s, frame: %s, value: "
                           "['0.01*%s*" LOADED "', '(0.02+0.003*%s)*" LOADED "']}]}",
                           list, edge, frame, radial ? "r" : "x", radial ? "z" : "y");
}

/* Every family in every geometry at every edge, and in every order. */
START_TEST(a_traction_gives_its_value_times_the_deformed_area)
{
    const int edge = (_i + _i / TEST_SHAPES + _i / (TEST_SHAPES * TEST_GEOMETRIES)) % EDGES;
    struct moment before;
    double without[2];
    step_under(_i, "loads={}", &before, without);
    for (int frame = 0; frame < 2; frame++) {
        char *const load = load_text(_i, "tractions", edges[edge], frame == 0 ? "global" : "edge");
        double with[2], force[2];
        step_under(_i, load, &before, with);
        expected_force(&before, _i, edge, frame == 1, force);
        for (int axis = 0; axis < 2; axis++) {
            ck_assert_double_gt(fabs(force[axis]), 1e-3);
            ck_assert_near(with[axis] - without[axis], STEP * force[axis], MOMENTUM_ROUND_OFF);
        }
        g_free(load);
    }
}
END_TEST

/* The value at the particle times the edge's area at t = 0. */
START_TEST(a_particle_force_gives_its_value_times_the_area_at_the_start)
{
    struct moment before;
    double without[2], with[2], force[2] = {0.0, 0.0};
    const bool radial = test_combination(_i).axisymmetric;
    step_under(_i, "loads={}", &before, without);
    char *const load = load_text(_i, "particle_forces", "right", "global");
    step_under(_i, load, &before, with);
    for (int id = COLUMNS - 1; id < COUNT; id += COLUMNS) {
        const double area = 2.0 * HALF[1] * (radial ? 7.0 : 1.0);
        force[0] += area * 0.01 * before.position[2 * id];
        force[1] += area * (0.02 + 0.003 * before.position[2 * id + 1]);
    }
    for (int axis = 0; axis < 2; axis++)
        ck_assert_near(with[axis] - without[axis], STEP * force[axis], MOMENTUM_ROUND_OFF);
    g_free(load);
}
END_TEST

/* One particle to a cell is on a knot of the quadratic splines: the span beyond has a node
 * without mass, in reach of the upper edge. */
START_TEST(no_force_is_lost_on_a_node_without_mass)
{
    const char *const settings[] = {
        "method.shape=bspline2", "bodies.block.particles_per_cell=[1, 1]",
        "loads={tractions: [{body: block, edge: top, value: [0, 1]}]}", NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    struct mpm_ledger start, end;
    mpm_simulation_ledger(run.simulation, &start);
    test_run_steps(&run, 1);
    mpm_simulation_ledger(run.simulation, &end);
    ck_assert_near(end.momentum[1] - start.momentum[1],
                   3.0 * mpm_simulation_time_step(run.simulation), MOMENTUM_ROUND_OFF);
    test_run_close(&run);
}
END_TEST

/* Velocities after some steps of the block, by its sites; with the load on its mirror image too. */
static double *velocities_under(const char *shape, const char *sites, const char *edge, double sign,
                                size_t *count)
{
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "method.shape=%s", shape);
    settings_add_formatted(&settings, "bodies.block.particles_per_cell=[%s, 2]", sites);
    settings_add_formatted(&settings,
                           "loads={tractions: [{body: block, edge: %s, value: [%g, 0.1]}]}", edge,
                           0.2 * sign);
    struct test_run run = test_run_open(BLOCK, settings.texts, 1);
    settings_clear(&settings);
    test_run_steps(&run, 4);
    double *const v = test_run_field(&run, MPM_FIELD_VELOCITY, count);
    test_run_close(&run);
    return v;
}

/* One particle a cell is on the knots of quadratic splines, three have one there too; the block is
 * of three cells, so that its mirror image is itself. Velocities are of order 0.1. */
START_TEST(a_load_on_the_left_moves_the_block_as_its_mirror_image_does_on_the_right)
{
    static const char *const sites[] = {"1", "2", "3"};
    size_t count;
    double *const right = velocities_under(test_shapes[_i / 3], sites[_i % 3], "right", 1, &count);
    double *const left = velocities_under(test_shapes[_i / 3], sites[_i % 3], "left", -1, &count);
    const size_t columns = 3 * (size_t)(_i % 3 + 1);
    double largest = 0.0;
    for (size_t p = 0; p < count; p++) {
        const size_t image = p / columns * columns + (columns - 1 - p % columns);
        ck_assert_near(right[2 * p], -left[2 * image], MOMENTUM_ROUND_OFF);
        ck_assert_near(right[2 * p + 1], left[2 * image + 1], MOMENTUM_ROUND_OFF);
        largest = fmax(largest, fabs(right[2 * p]));
    }
    ck_assert_double_gt(largest, 0.01);
    free(right);
    free(left);
}
END_TEST

/* Energy gained over work at t = 1 with so many steps. */
static double balance(int index, const char *list, int steps)
{
    struct settings settings = test_combination_settings(index);
    struct mpm_ledger ledger;
    settings_add(&settings, "method.stress_update=usavg");
    settings_add(&settings, "method.extrapolate=false");
    settings_add_formatted(&settings, "time.step=%.17g", 1.0 / steps);
    settings_add_formatted(&settings,
                           "loads={%s: [{body: block, edge: all, frame: edge, "
                           "value: ['0.01*t', '0.005*t']}]}",
                           list);
    struct test_run run = test_run_open(BLOCK, settings.texts, 1);
    test_run_steps(&run, steps);
    mpm_simulation_ledger(run.simulation, &ledger);
    ck_assert_double_gt(ledger.external_work, 1e-5);
    test_run_close(&run);
    settings_clear(&settings);
    return ledger.total_energy / ledger.external_work;
}

/* A transfer by FLIP loses energy in proportion to the step, some percent of so little here:
 * steps of 0.01 and 0.005 show what is left of the balance at none, to second order, 0.001. */
START_TEST(tractions_and_particle_forces_work_what_the_energy_gains)
{
    static const char *const lists[] = {"tractions", "particle_forces"};
    for (size_t list = 0; list < 2; list++)
        ck_assert_near(2.0 * balance(_i, lists[list], 200) - balance(_i, lists[list], 100), 1.0,
                       0.001);
}
END_TEST

/* ------------------------------------------------------------------ which edges */

/* Momentum in a step over its length is the force: with a stress of one the area. */
static double area_of(const char *region, const char *load, int axis)
{
    struct settings settings = {0};
    settings_add_formatted(&settings, "bodies.block.region=%s", region);
    settings_add_formatted(&settings, "loads={tractions: [%s]}", load);
    settings_add(&settings, "bodies.block.velocity=[0, 0]");
    struct test_run run = test_run_open(BLOCK, settings.texts, 1);
    struct mpm_ledger ledger;
    test_run_steps(&run, 1);
    mpm_simulation_ledger(run.simulation, &ledger);
    const double area = ledger.momentum[axis] / mpm_simulation_time_step(run.simulation);
    test_run_close(&run);
    settings_clear(&settings);
    return area;
}

START_TEST(a_face_is_made_of_edges_without_a_neighbour_whatever_the_region)
{
    static const char DISK[] = "{disk: {center: [7, 6.4], radius: 2}}";
    static const char RING[] = "{annulus: {center: [7, 6.4], inner: 1, outer: 2}}";
    static const char TOP[] = "{body: block, edge: top, value: [0, 1]}";
    static const char LEFT[] = "{body: block, edge: left, value: [1, 0]}";
    static const char PRESSURE[] = "{body: block, edge: all, value: [-1, 0], frame: edge}";
    /* staircase approximations: as wide as the disk, 4, and as the hole besides; sites of 0.5 by
     * 0.4 */
    ck_assert_near(area_of(DISK, TOP, 1), 4.0, MOMENTUM_ROUND_OFF);
    ck_assert_near(area_of(DISK, LEFT, 0), 4.0, MOMENTUM_ROUND_OFF);
    ck_assert_near(area_of(RING, TOP, 1), 4.0 + 2.0, MOMENTUM_ROUND_OFF);
    ck_assert_near(area_of(RING, PRESSURE, 0), 0.0, MOMENTUM_ROUND_OFF);
    ck_assert_near(area_of(RING, PRESSURE, 1), 0.0, MOMENTUM_ROUND_OFF);
}
END_TEST

START_TEST(loads_on_one_edge_add_up)
{
    static const char BLOCK_REGION[] = "{rectangle: {from: [4, 3.2], to: [7, 4.8]}}";
    ck_assert_near(area_of(BLOCK_REGION,
                           "{body: block, edge: top, value: [0, 1]}, "
                           "{body: block, edge: all, value: [0, 2]}",
                           1),
                   3.0 + 2.0 * 2.0 * (3.0 + 1.6), MOMENTUM_ROUND_OFF);
}
END_TEST

/* ---------------------------------------------------------------- bits, refusals */

static const char LOADS[] =
    "loads={tractions: [{body: block, edge: all, frame: edge, value: ['-0.1*sin(x)', 0.02]}], "
    "particle_forces: [{body: block, edge: left, value: ['0.1*t', '0.01*y']}]}";

/* Enough particles for three workers. */
START_TEST(any_number_of_threads_gives_the_same_bits_under_tractions)
{
    const char *const settings[] = {
        TEST_BLOCK_FOR_THREADS,
        "bodies.block.velocity=['0.1*sin(y/5)', '0.1*cos(x/4)']",
        LOADS,
        "method.stress_update=usavg",
        _i == 0 ? "method.shape=cpdi" : "method.shape=bspline2",
        NULL,
    };
    test_same_bits_over_threads(BLOCK, settings, 20, NULL);
}
END_TEST

START_TEST(a_load_that_stops_being_finite_ends_the_run_and_names_itself)
{
    const char *const settings[] = {
        "loads={particle_forces: [{body: block, edge: top, value: [0, 'sqrt(0.5-t)']}]}", NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    struct mpm_error error = {.message = ""};
    enum mpm_status status = MPM_OK;
    for (int step = 0; step < 1000 && status == MPM_OK; step++)
        status = mpm_simulation_advance(run.simulation, HUGE_VAL, &error);
    ck_assert_int_eq(status, MPM_RUN_FAILED);
    test_contains(error.message, "particle 18 (body 'block') bears a load that is not finite: "
                                 "loads.particle_forces.0.value.1 = ");
    test_run_close(&run);
}
END_TEST

Suite *suite_tractions(void)
{
    Suite *suite = suite_create("tractions");
    TCase *forces = tcase_create("forces");
    tcase_add_loop_test(forces, a_traction_gives_its_value_times_the_deformed_area, 0,
                        TEST_COMBINATIONS);
    tcase_add_loop_test(forces, a_particle_force_gives_its_value_times_the_area_at_the_start, 0,
                        TEST_SHAPES * TEST_GEOMETRIES);
    tcase_add_loop_test(forces,
                        a_load_on_the_left_moves_the_block_as_its_mirror_image_does_on_the_right, 0,
                        3 * TEST_SHAPES);
    tcase_add_test(forces, no_force_is_lost_on_a_node_without_mass);
    tcase_add_loop_test(forces, tractions_and_particle_forces_work_what_the_energy_gains, 0,
                        TEST_SHAPES * TEST_GEOMETRIES);
    suite_add_tcase(suite, forces);
    TCase *faces = tcase_create("faces");
    tcase_add_test(faces, a_face_is_made_of_edges_without_a_neighbour_whatever_the_region);
    tcase_add_test(faces, loads_on_one_edge_add_up);
    suite_add_tcase(suite, faces);
    TCase *runs = tcase_create("runs");
    tcase_add_loop_test(runs, any_number_of_threads_gives_the_same_bits_under_tractions, 0, 2);
    tcase_add_test(runs, a_load_that_stops_being_finite_ends_the_run_and_names_itself);
    suite_add_tcase(suite, runs);
    return suite;
}

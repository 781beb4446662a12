/* Conduction of heat: gradients, sums, motion, symmetry, and both sets of kernels, with every
 * family, geometry and order of the stress update.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport.h"
#include "simulation/simulation.h"
#include "suites.h"
#include "support/combinations.h"
#include "support/kernel_pair.h"
#include "support/near.h"
#include "support/scenes.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2 };

/* A block with a hot side, on cells that are not square. Temperatures of order 1 in it, heat of
 * order 30 (planar) and 200 (per radian). kappa = 0.25; the first step is the waves'. */
static const char BLOCK[] = TEST_BLOCK_SCENE(
    "{end: 1000, courant: 0.3}",
    "{name: soft, law: neo_hookean, density: 2, bulk: 1.25, shear: 0.75, heat_capacity: 0.5, "
    "conductivity: 0.25}",
    "  - {name: block, material: soft, region: {rectangle: {from: [3, 3.2],\n"
    "     to: [9, 8]}}, particles_per_cell: [3, 1]}\n"
    "transport: {temperature: {}}\n");

/* Of about a hundred products and steps, over the numbers' own size. */
static const double ROUND_OFF = 1e-13;

static const char HOT_SIDE[] =
    "transport.temperature.conditions=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, "
    "value: '1+0.1*t'}]";

static bool is_axisymmetric(int index)
{
    return test_combination(index).axisymmetric;
}

/* Temperatures and a source that vary within a cell. */
static void add_wild_heat(struct settings *settings, bool axisymmetric)
{
    settings_add(settings, axisymmetric ? "transport.temperature.start='sin(3*r)*cos(2*z)'"
                                        : "transport.temperature.start='sin(3*x)*cos(2*y)'");
    settings_add(settings, axisymmetric ? "transport.temperature.source='cos(r+2*z+t)'"
                                        : "transport.temperature.source='cos(x+2*y+t)'");
}

static struct mpm_state *state_of(const struct test_run *run)
{
    return &run->simulation->state;
}

static struct mpm_nodal_scalar *scalar_of(const struct test_run *run)
{
    return &state_of(run)->transport.list[0];
}

static double heat(const struct test_run *run)
{
    return mpm_transport_content(state_of(run), scalar_of(run), NULL);
}

static struct test_run open_run(struct settings *settings, enum mpm_kernels kernels)
{
    struct test_run run = {0};
    struct mpm_error error = {.message = ""};
    const struct mpm_simulation_options options = {.kernels = kernels, .threads = 1};
    run = test_run_open(BLOCK, settings->texts, 1);
    mpm_simulation_free(run.simulation);
    ck_assert_msg(mpm_simulation_create(run.scene, &options, &run.simulation, &error) == MPM_OK,
                  "%s", error.message);
    return run;
}

/* Reference kernels, then what the scene gets by itself. */
enum { SETS = 2 };
static enum mpm_kernels kernels_of(int set)
{
    return set == 0 ? MPM_KERNELS_REFERENCE : MPM_KERNELS_AUTO;
}

/* ----------------------------------------------------------------- gradients */

/* sum_i x_i inflow_i along both axes, of nodal values a + b . x: with an exact gradient, - sum V k
 * b whatever the body's edges do, since sum_i x_i G_ip is the unit tensor. */
static void first_moment(const struct test_run *run, const double b[AXES], double moment[AXES])
{
    struct mpm_state *const state = state_of(run);
    struct mpm_nodal_scalar *const scalar = scalar_of(run);
    const int64_t nodes = mpm_grid_nodes(&state->grid);
    for (int64_t node = 0; node < nodes; node++) {
        double place[AXES];
        mpm_grid_position(&state->grid, node, place);
        scalar->value[node][0] = scalar->value[node][1] = 0.7 + b[0] * place[0] + b[1] * place[1];
        scalar->inflow[node][0] = scalar->inflow[node][1] = 0.0;
    }
    state->transport.conducted = scalar;
    for (int64_t strip = 0; strip < state->strip_count; strip++)
        state->kernels.conduct(state, strip, 0);
    state->transport.conducted = NULL;
    moment[0] = moment[1] = 0.0;
    for (int64_t node = 0; node < nodes; node++) {
        double place[AXES];
        mpm_grid_position(&state->grid, node, place);
        for (int axis = 0; axis < AXES; axis++)
            moment[axis] += place[axis] * (scalar->inflow[node][0] + scalar->inflow[node][1]);
    }
}

static double total_volume(const struct test_run *run)
{
    size_t count;
    double *const volume = test_run_field(run, MPM_FIELD_VOLUME, &count);
    double sum = 0.0;
    for (size_t p = 0; p < count; p++)
        sum += volume[p];
    free(volume);
    return sum;
}

/* Axisymmetric functions have sum_i r_i G_ip = 1 only for domains of points: those of uGIMP and
 * CPDI are means weighted with r. Gradients along z are exact with all. */
START_TEST(a_linear_field_has_an_exact_gradient)
{
    static const double b[AXES] = {0.3, -0.8};
    for (int set = 0; set < SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        struct test_run run = open_run(&settings, kernels_of(set));
        double moment[AXES];
        const double scale = 0.25 * total_volume(&run);
        first_moment(&run, b, moment);
        for (int axis = is_axisymmetric(_i) ? 1 : 0; axis < AXES; axis++)
            ck_assert_near(moment[axis] / scale, -b[axis], ROUND_OFF);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* The rate of a linear field is zero where no node lacks a particle: cubic splines see an edge up
 * to eight cells away. With r, div grad r = 1/r. */
START_TEST(a_linear_field_stays_inside)
{
    for (int set = 0; set < SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, is_axisymmetric(_i)
                                    ? "transport.temperature.start='2-0.8*z'"
                                    : "transport.temperature.start='2+0.3*x-0.8*y'");
        settings_add(&settings, "grid.cells=[24, 24]");
        settings_add(&settings, "bodies.block.region.rectangle={from: [2, 1.6], to: [22, 17.6]}");
        struct test_run run = open_run(&settings, kernels_of(set));
        size_t count;
        double *const before = test_run_field(&run, MPM_FIELD_TEMPERATURE, &count);
        test_run_steps(&run, 1);
        double *const after = test_run_field(&run, MPM_FIELD_TEMPERATURE, NULL);
        double *const place = test_run_field(&run, MPM_FIELD_POSITION, NULL);
        size_t inside = 0;
        for (size_t p = 0; p < count; p++) {
            const double x = place[AXES * p], y = place[AXES * p + 1];
            if (x < 11.0 || x > 13.0 || y < 8.8 || y > 10.4)
                continue;
            ck_assert_near(after[p], before[p], ROUND_OFF);
            inside++;
        }
        ck_assert_uint_eq(inside, 12);
        free(before);
        free(after);
        free(place);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* -------------------------------------------------------------------- sums */

START_TEST(heat_is_what_source_and_conditions_have_given)
{
    static const char *const transfers[] = {"flip", "pic"};
    for (int k = 0; k < SETS * 2; k++) {
        struct settings settings = test_combination_settings(_i);
        add_wild_heat(&settings, is_axisymmetric(_i));
        test_add_wild_velocity(&settings, is_axisymmetric(_i));
        settings_add(&settings, HOT_SIDE);
        settings_add_formatted(&settings, "transport.temperature.transfer=%s", transfers[k / SETS]);
        struct test_run run = open_run(&settings, kernels_of(k % SETS));
        const double start = heat(&run);
        test_run_steps(&run, test_combination(_i).amplifies_round_off ? 3 : 40);
        const struct mpm_scalar_totals *const totals = &scalar_of(&run)->totals;
        const double scale = 1.0 + fabs(start) + fabs(totals->held) + fabs(totals->source);
        ck_assert(fabs(totals->held) > 1e-3 && fabs(totals->source) > 1e-3);
        ck_assert_near((heat(&run) - start) / scale, (totals->held + totals->source) / scale,
                       ROUND_OFF);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

START_TEST(heat_is_per_radian_or_for_the_thickness)
{
    struct settings settings = test_combination_settings(_i);
    settings_add(&settings, "transport.temperature.start=3");
    if (!is_axisymmetric(_i))
        settings_add(&settings, "thickness=0.5");
    struct test_run run = open_run(&settings, MPM_KERNELS_AUTO);
    const double area = 6.0 * 4.8, per = is_axisymmetric(_i) ? 6.0 : 0.5;
    ck_assert_near(heat(&run), 2.0 * 0.5 * 3.0 * area * per, 1e-10);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* Of each kind one, on all sides; T^4 of absolute temperatures. */
static const char FLUXES[] =
    "transport.temperature.fluxes=[{body: block, edge: all, value: '0.3+0.1*t'}, {body: block, "
    "edge: right, convection: {coefficient: 0.4, ambient: '3+t'}}, {body: block, edge: bottom, "
    "radiation: {emissivity: 0.5, sigma: 0.01, ambient: 5}}]";

START_TEST(heat_is_what_fluxes_have_given)
{
    for (int set = 0; set < SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        test_add_wild_velocity(&settings, is_axisymmetric(_i));
        settings_add(&settings, is_axisymmetric(_i) ? "transport.temperature.start='3+sin(3*r)'"
                                                    : "transport.temperature.start='3+sin(3*x)'");
        settings_add(&settings, HOT_SIDE);
        settings_add(&settings, FLUXES);
        struct test_run run = open_run(&settings, kernels_of(set));
        const double start = heat(&run);
        test_run_steps(&run, test_combination(_i).amplifies_round_off ? 3 : 40);
        const struct mpm_scalar_totals *const totals = &scalar_of(&run)->totals;
        const double scale = 1.0 + fabs(start) + fabs(totals->held) + fabs(totals->edges);
        ck_assert(fabs(totals->edges) > 1e-2);
        ck_assert_near((heat(&run) - start) / scale, (totals->held + totals->edges) / scale,
                       ROUND_OFF);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* A flux of 2 on one side: 6 wide at the top, 4.8 high at r = 9. */
START_TEST(a_flux_gives_its_area_and_per_radian)
{
    static const char *const sides[] = {"top", "right"};
    for (int side = 0; side < 2; side++) {
        struct settings settings = test_combination_settings(_i);
        const double planar[] = {6.0, 4.8}, per_radian[] = {0.5 * (81.0 - 9.0), 9.0 * 4.8};
        settings_add_formatted(&settings,
                               "transport.temperature.fluxes=[{body: block, edge: %s, value: 2}]",
                               sides[side]);
        struct test_run run = open_run(&settings, MPM_KERNELS_AUTO);
        test_run_steps(&run, 3);
        const double area = (is_axisymmetric(_i) ? per_radian : planar)[side];
        ck_assert_near(heat(&run), 2.0 * area * mpm_simulation_time(run.simulation), 1e-10);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* A body of one temperature, whose conductivity keeps it so: dT/dt = h A (ambient - T)/(c rho V),
 * A/V = 2 (6 + 4.8)/(6 4.8). */
START_TEST(a_body_cools_to_its_surroundings)
{
    struct settings settings = {.count = 0};
    settings_add(&settings, "materials=[{name: soft, law: none, density: 2, heat_capacity: 0.5, "
                            "conductivity: 100}]");
    settings_add_formatted(&settings, "method.shape=%s", test_shapes[_i]);
    settings_add(&settings, "transport.temperature.start=5");
    settings_add(&settings, "transport.temperature.fluxes=[{body: block, edge: all, convection: "
                            "{coefficient: 0.5, ambient: 1}}]");
    settings_add(&settings, "time.end=1");
    struct test_run run = open_run(&settings, MPM_KERNELS_AUTO);
    struct mpm_error error = {.message = ""};
    while (mpm_simulation_time(run.simulation) < 1.0)
        ck_assert_int_eq(mpm_simulation_advance(run.simulation, 1.0, &error), MPM_OK);
    const double rate = 0.5 * 2.0 * 10.8 / 28.8;
    /* explicit steps of 1e-3 and gradients of 0.5 in a conductivity of 100 */
    ck_assert_near(heat(&run) / 28.8, 1.0 + 4.0 * exp(-rate), 0.01);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* Only the source, and no motion: c rho dT/dt = s. */
START_TEST(a_source_warms_a_free_body_evenly)
{
    for (int set = 0; set < SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, "transport.temperature.source=3");
        settings_add(&settings, "transport.temperature.start=1");
        struct test_run run = open_run(&settings, kernels_of(set));
        test_run_steps(&run, 5);
        size_t count;
        double *const value = test_run_field(&run, MPM_FIELD_TEMPERATURE, &count);
        const double expected = 1.0 + 3.0 * mpm_simulation_time(run.simulation);
        for (size_t p = 0; p < count; p++)
            ck_assert_near(value[p], expected, 1e-12);
        free(value);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* ------------------------------------------------------------------- motion */

START_TEST(particles_keep_their_temperature_without_conduction_bit_by_bit)
{
    for (int set = 0; set < SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, "materials.soft.conductivity=0");
        settings_add(&settings, is_axisymmetric(_i)
                                    ? "transport.temperature.start='2+sin(3*r)*cos(2*z)'"
                                    : "transport.temperature.start='2+sin(3*x)*cos(2*y)'");
        test_add_wild_velocity(&settings, is_axisymmetric(_i));
        struct test_run run = open_run(&settings, kernels_of(set));
        size_t count;
        double *const before = test_run_field(&run, MPM_FIELD_TEMPERATURE, &count);
        test_run_steps(&run, test_combination(_i).amplifies_round_off ? 3 : 40);
        double *const after = test_run_field(&run, MPM_FIELD_TEMPERATURE, NULL);
        ck_assert_mem_eq(before, after, count * sizeof *before);
        free(before);
        free(after);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

START_TEST(pic_conducts_without_conductivity)
{
    struct settings settings = test_combination_settings(_i);
    settings_add(&settings, "materials.soft.conductivity=0");
    settings_add(&settings, "transport.temperature.transfer=pic");
    add_wild_heat(&settings, is_axisymmetric(_i));
    settings_add(&settings, "transport.temperature.source=0");
    struct test_run run = open_run(&settings, MPM_KERNELS_AUTO);
    double before[2], after[2];
    const double start = mpm_transport_content(state_of(&run), scalar_of(&run), before);
    test_run_steps(&run, 10);
    ck_assert_near(mpm_transport_content(state_of(&run), scalar_of(&run), after), start, 1e-10);
    ck_assert_double_lt(after[1] - after[0], 0.8 * (before[1] - before[0]));
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* Conductivities of a material, turned by 30 degrees: F is a rotation by 50 degrees more. */
START_TEST(conductivities_turn_with_the_material)
{
    static const double b[AXES] = {0.6, -0.2};
    const double turn = 50.0 * G_PI / 180.0, angle = 80.0 * G_PI / 180.0;
    const double f[] = {cos(turn), -sin(turn), sin(turn), cos(turn), 1.0};
    for (int set = 0; set < SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings,
                     "materials=[{name: soft, law: neo_hookean, density: 2, bulk: 1.25, shear: "
                     "0.75, heat_capacity: 0.5, principal_conductivities: [0.5, 0.1], "
                     "conductivity_angle: 30}]");
        struct test_run run = open_run(&settings, kernels_of(set));
        struct mpm_error error = {.message = ""};
        size_t count;
        double *const place = test_run_field(&run, MPM_FIELD_POSITION, &count);
        double *const start = g_new(double, 5 * count);
        for (size_t p = 0; p < count; p++)
            memcpy(start + 5 * p, f, sizeof f);
        ck_assert_msg(mpm_simulation_set_start(run.simulation, NULL, start, &error) == MPM_OK, "%s",
                      error.message);
        double moment[AXES];
        first_moment(&run, b, moment);
        const double volume = total_volume(&run), c = cos(angle), s = sin(angle);
        const double along = c * b[0] + s * b[1], across = c * b[1] - s * b[0];
        const double flow[AXES] = {c * 0.5 * along - s * 0.1 * across,
                                   s * 0.5 * along + c * 0.1 * across};
        for (int axis = is_axisymmetric(_i) ? 1 : 0; axis < AXES; axis++)
            if (!is_axisymmetric(_i))
                ck_assert_near(moment[axis] / volume, -flow[axis], ROUND_OFF);
        free(place);
        g_free(start);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* ----------------------------------------------------------------- symmetry */

static const char HALF[] = "bodies.block.region.rectangle={from: [3, 5.6], to: [9, 8]}";
static const char PLANE[] =
    "boundary=[{region: {line: {from: [0, 5.6], to: [14, 5.6]}}, symmetry: true}]";

#define END_FLUX(edge) "{body: block, edge: " edge ", convection: {coefficient: 0.4, ambient: 2}}"
static const char BOTH_ENDS[] =
    "transport.temperature.fluxes=[" END_FLUX("top") ", " END_FLUX("bottom") "]";
static const char UPPER_END[] = "transport.temperature.fluxes=[" END_FLUX("top") "]";

/* Left side prescribed, also at the nodes beyond the plane and on it. */
START_TEST(a_half_with_a_plane_of_symmetry_is_half_of_the_whole)
{
    const bool axisymmetric = is_axisymmetric(_i);
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, axisymmetric
                                    ? "transport.temperature.start='sin(3*r)*cos(2*(z-5.6))'"
                                    : "transport.temperature.start='sin(3*x)*cos(2*(y-5.6))'");
        settings_add(&settings, axisymmetric ? "transport.temperature.source='cos(r)*(z-5.6)^2'"
                                             : "transport.temperature.source='cos(x)*(y-5.6)^2'");
        settings_add(&settings, "transport.temperature.conditions=[{region: {line: {from: [3, 0], "
                                "to: [3, 12]}}, value: 2}]");
        settings_add(&settings, axisymmetric
                                    ? "bodies.block.velocity=['0.1*cos(r)', '0.1*sin(2*(z-5.6))']"
                                    : "bodies.block.velocity=['0.1*cos(x)', '0.1*sin(2*(y-5.6))']");
        if (k == 1) {
            settings_add(&settings, HALF);
            settings_add(&settings, PLANE);
        }
        settings_add(&settings, k == 0 ? BOTH_ENDS : UPPER_END);
        settings_add(&settings, "time={end: 1000, step: 0.05}");
        runs[k] = open_run(&settings, MPM_KERNELS_AUTO);
        settings_clear(&settings);
    }
    for (int k = 0; k < 2; k++)
        test_run_steps(&runs[k], test_combination(_i).amplifies_round_off ? 3 : 20);
    ck_assert_near(2.0 * scalar_of(&runs[1])->totals.edges, scalar_of(&runs[0])->totals.edges,
                   1e-10);
    ck_assert_near(2.0 * heat(&runs[1]), heat(&runs[0]), 1e-10);
    ck_assert_near(2.0 * scalar_of(&runs[1])->totals.held, scalar_of(&runs[0])->totals.held, 1e-10);
    ck_assert_near(2.0 * scalar_of(&runs[1])->totals.source, scalar_of(&runs[0])->totals.source,
                   1e-10);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}
END_TEST

/* ------------------------------------------------------------------ kernels */

static const char WITHOUT_STRESS[] =
    "materials=[{name: soft, law: none, density: 2, heat_capacity: 0.5, conductivity: 0.25}]";

START_TEST(fast_kernels_conduct_as_reference_kernels_do)
{
    enum { STEPS = 30 };
    struct settings settings = test_combination_settings(_i % TEST_COMBINATIONS);
    const bool axisymmetric = is_axisymmetric(_i % TEST_COMBINATIONS);
    add_wild_heat(&settings, axisymmetric);
    settings_add(&settings, HOT_SIDE);
    settings_add(&settings,
                 "materials=[{name: soft, law: neo_hookean, density: 2, bulk: 1.25, shear: 0.75, "
                 "heat_capacity: 0.5, principal_conductivities: [0.4, 0.1], conductivity_angle: "
                 "20}]");
    test_add_wild_velocity(&settings, axisymmetric);
    const struct kernel_side sides[SETS] = {
        {settings.texts, {.kernels = MPM_KERNELS_REFERENCE, .threads = 1}},
        {settings.texts, {.kernels = MPM_KERNELS_FAST, .threads = 1}},
    };
    struct kernel_pair pair = kernel_pair_open_text(BLOCK, sides);
    for (int step = 0; step < STEPS && kernel_pair_step(&pair); step++)
        ;
    if (!test_combination(_i).amplifies_round_off)
        ck_assert_msg(kernel_pair_worst(&pair) <= KERNEL_PAIR_BOUND, "%s", kernel_pair_text(&pair));
    kernel_pair_close(&pair);
    settings_clear(&settings);
}
END_TEST

/* The only order that a scene at rest has. */
enum { AT_REST = TEST_SHAPES * TEST_GEOMETRIES };

static struct settings at_rest_settings(int index)
{
    const struct test_combination c = test_combination(index);
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "method.shape=%s", c.shape);
    settings_add_formatted(&settings, "geometry=%s", c.geometry);
    settings_add(&settings, "time={end: 1000, step: 0.05}");
    add_wild_heat(&settings, c.axisymmetric);
    settings_add(&settings, HOT_SIDE);
    return settings;
}

START_TEST(fast_kernels_conduct_at_rest_as_reference_kernels_do)
{
    struct settings settings = at_rest_settings(_i);
    settings_add(&settings, WITHOUT_STRESS);
    const struct kernel_side sides[SETS] = {
        {settings.texts, {.kernels = MPM_KERNELS_REFERENCE, .threads = 1}},
        {settings.texts, {.kernels = MPM_KERNELS_FAST, .threads = 1}},
    };
    struct kernel_pair pair = kernel_pair_open_text(BLOCK, sides);
    for (int step = 0; step < KERNEL_PAIR_STEPS; step++)
        ck_assert(kernel_pair_step(&pair));
    ck_assert_double_le(kernel_pair_worst(&pair), KERNEL_PAIR_BOUND);
    kernel_pair_close(&pair);
    settings_clear(&settings);
}
END_TEST

/* A body with stress that nothing moves takes the passes of a step in motion. */
START_TEST(heat_alone_is_heat_in_a_body_that_does_not_move)
{
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = at_rest_settings(_i);
        if (k == 1)
            settings_add(&settings, WITHOUT_STRESS);
        runs[k] = open_run(&settings, MPM_KERNELS_AUTO);
        test_run_steps(&runs[k], 40);
        settings_clear(&settings);
    }
    size_t count;
    double *const moving = test_run_field(&runs[0], MPM_FIELD_TEMPERATURE, &count);
    double *const alone = test_run_field(&runs[1], MPM_FIELD_TEMPERATURE, NULL);
    for (size_t p = 0; p < count; p++)
        ck_assert_near(moving[p], alone[p], ROUND_OFF);
    ck_assert_near(heat(&runs[0]), heat(&runs[1]), 1e-11);
    free(moving);
    free(alone);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}
END_TEST

START_TEST(bits_of_temperatures_do_not_depend_on_threads)
{
    static const char *const with_stress[] = {
        TEST_BLOCK_FOR_THREADS,
        "transport.temperature.start='sin(3*x)*cos(2*y)'",
        "transport.temperature.source='cos(x+2*y+t)'",
        HOT_SIDE,
        "bodies.block.velocity=['0.3*sin(2*x)*cos(y)', '0.4*cos(x+2*y)']",
        NULL};
    static const char *const alone[] = {TEST_BLOCK_FOR_THREADS,
                                        "transport.temperature.start='sin(3*x)*cos(2*y)'",
                                        "transport.temperature.source='cos(x+2*y+t)'",
                                        HOT_SIDE,
                                        WITHOUT_STRESS,
                                        NULL};
    test_same_bits_over_threads(BLOCK, _i == 0 ? with_stress : alone, 40, NULL);
}
END_TEST

/* ------------------------------------------------------------------ failures */

/* The source is infinite from t = 2 on: the run goes back to the step before. */
START_TEST(a_failed_run_has_the_temperatures_of_its_last_good_step)
{
    struct test_run runs[2];
    struct mpm_error error = {.message = ""};
    int steps = 0;
    for (int k = 0; k < 2; k++) {
        struct settings settings = at_rest_settings(_i);
        settings_add(&settings, "transport.temperature.source='1/(2-t>0.001 ? 1 : 0)'");
        if (_i % 2 == 0)
            settings_add(&settings, WITHOUT_STRESS);
        runs[k] = open_run(&settings, MPM_KERNELS_AUTO);
        settings_clear(&settings);
    }
    while (mpm_simulation_advance(runs[0].simulation, 1000.0, &error) == MPM_OK)
        steps++;
    ck_assert_int_ge(steps, 35);
    ck_assert_ptr_nonnull(strstr(error.message, "source in transport that is not finite"));
    test_run_steps(&runs[1], steps);
    ck_assert(test_run_same_bits(&runs[0], &runs[1]));
    ck_assert_double_eq(scalar_of(&runs[0])->totals.held, scalar_of(&runs[1])->totals.held);
    ck_assert_double_eq(scalar_of(&runs[0])->totals.source, scalar_of(&runs[1])->totals.source);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}
END_TEST

START_TEST(a_prescribed_temperature_that_is_not_finite_ends_the_run)
{
    struct settings settings = at_rest_settings(_i);
    struct mpm_error error = {.message = ""};
    settings_add(&settings, "transport.temperature.conditions.0.value='1/(2-t>0.001 ? 1 : 0)'");
    struct test_run run = open_run(&settings, MPM_KERNELS_AUTO);
    while (mpm_simulation_advance(run.simulation, 1000.0, &error) == MPM_OK)
        ;
    ck_assert_int_eq(error.status, MPM_RUN_FAILED);
    ck_assert_ptr_nonnull(
        strstr(error.message, "prescribed by transport.temperature.conditions.0"));
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* kappa = 0.25, cells of 1 by 0.8: 1/(0.5 (1 + 1/0.64)) */
START_TEST(steps_stay_below_the_limit_of_explicit_conduction)
{
    static const double LIMIT = 1.0 / (0.5 * (1.0 + 1.0 / 0.64));
    struct settings settings = {.count = 0};
    settings_add(&settings, WITHOUT_STRESS);
    struct test_run run = open_run(&settings, MPM_KERNELS_AUTO);
    test_run_steps(&run, 1);
    ck_assert_near(mpm_simulation_time_step(run.simulation), 0.3 * LIMIT, 1e-12);
    test_run_close(&run);
    settings_clear(&settings);
    settings_add(&settings, "materials.soft.conductivity=1000");
    run = open_run(&settings, MPM_KERNELS_AUTO);
    test_run_steps(&run, 1);
    ck_assert_near(mpm_simulation_time_step(run.simulation), 0.3 * LIMIT * 0.25e-3, 1e-12);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

Suite *suite_heat(void)
{
    Suite *suite = suite_create("heat");
    TCase *all = tcase_create("every combination");
    tcase_add_loop_test(all, a_linear_field_has_an_exact_gradient, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, a_linear_field_stays_inside, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, heat_is_what_source_and_conditions_have_given, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, heat_is_what_fluxes_have_given, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, a_flux_gives_its_area_and_per_radian, 0, AT_REST);
    tcase_add_loop_test(all, a_body_cools_to_its_surroundings, 0, TEST_SHAPES);
    tcase_add_loop_test(all, heat_is_per_radian_or_for_the_thickness, 0, AT_REST);
    tcase_add_loop_test(all, a_source_warms_a_free_body_evenly, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, particles_keep_their_temperature_without_conduction_bit_by_bit, 0,
                        TEST_COMBINATIONS);
    tcase_add_loop_test(all, pic_conducts_without_conductivity, 0, AT_REST);
    tcase_add_loop_test(all, conductivities_turn_with_the_material, 0, AT_REST);
    tcase_add_loop_test(all, a_half_with_a_plane_of_symmetry_is_half_of_the_whole, 0,
                        TEST_COMBINATIONS);
    tcase_add_loop_test(all, fast_kernels_conduct_as_reference_kernels_do, 0, TEST_COMBINATIONS);
    suite_add_tcase(suite, all);
    TCase *rest = tcase_create("at rest");
    tcase_add_loop_test(rest, fast_kernels_conduct_at_rest_as_reference_kernels_do, 0, AT_REST);
    tcase_add_loop_test(rest, heat_alone_is_heat_in_a_body_that_does_not_move, 0, AT_REST);
    tcase_add_loop_test(rest, bits_of_temperatures_do_not_depend_on_threads, 0, 2);
    tcase_add_loop_test(rest, a_failed_run_has_the_temperatures_of_its_last_good_step, 0, 2);
    tcase_add_loop_test(rest, a_prescribed_temperature_that_is_not_finite_ends_the_run, 0, 1);
    tcase_add_test(rest, steps_stay_below_the_limit_of_explicit_conduction);
    suite_add_tcase(suite, rest);
    return suite;
}

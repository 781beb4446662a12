/* Manufactured solutions: derivatives against finite differences, stress against the solver's
 * laws, the weak form, the edges, the axis.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/manufactured.h"
#include "support/near.h"
#include "support/scenes.h"
#include "verification/exact/manufactured/manufactured_field.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2, GRADIENT = 5, STRESS = 4 };

/* A place inside, different for each k; of annuli at a quarter to three quarters of the width. */
static void place_of(const struct manufactured_problem *problem, int k, double place[AXES])
{
    const struct manufactured_domain *const d = &problem->domain;
    const double part[AXES] = {0.13 + 0.077 * k, 0.21 + 0.091 * k};
    for (int axis = 0; axis < AXES; axis++)
        place[axis] = d->low[axis] + part[axis] * (d->high[axis] - d->low[axis]);
    if (d->region == MANUFACTURED_ANNULUS) {
        const double radius = d->inner + part[0] * (d->outer - d->inner);
        place[0] = radius * cos(6.0 * part[1]);
        place[1] = radius * sin(6.0 * part[1]);
    }
}
enum { PLACES = 8 };

/* ------------------------------------------------------- finite differences
 *
 * Central differences over a step of 1e-4 of a wave, 2 pi / length: h^2/6 times the third
 * derivative, (2 pi)^2 or so of the quantity, and round-off over the step. */
static const double STEP = 1e-5, DIFFERENCE = 1e-6;

struct stencil {
    struct manufactured_state low, high;
    double width;
};

/* along X, Y or t */
static struct stencil around(const struct manufactured_problem *problem, const double place[AXES],
                             double time, int along)
{
    struct stencil s;
    const double step = along == AXES ? STEP * problem->period : STEP * problem->domain.high[0];
    for (int side = 0; side < 2; side++) {
        double there[AXES + 1] = {place[0], place[1], time};
        there[along] += side == 0 ? -step : step;
        manufactured_evaluate(problem, there, there[AXES], side == 0 ? &s.low : &s.high);
    }
    s.width = 2.0 * step;
    return s;
}

START_TEST(velocity_and_acceleration_are_rates_of_displacement_and_velocity)
{
    struct manufactured_problem problem;
    if (!test_problem_at(_i, &problem))
        return;
    const double rate = 6.3 / problem.period, scale = problem.parameter[0] * rate;
    for (int k = 0; k < PLACES; k++) {
        struct manufactured_state state;
        double place[AXES];
        place_of(&problem, k, place);
        const struct stencil s = around(&problem, place, problem.end, AXES);
        manufactured_evaluate(&problem, place, problem.end, &state);
        for (int axis = 0; axis < AXES; axis++) {
            const double v = (s.high.displacement[axis] - s.low.displacement[axis]) / s.width;
            const double a = (s.high.velocity[axis] - s.low.velocity[axis]) / s.width;
            ck_assert_near(state.velocity[axis], v, DIFFERENCE * scale);
            ck_assert_near(state.acceleration[axis], a, DIFFERENCE * scale * rate);
        }
    }
}
END_TEST

START_TEST(f_is_the_gradient_of_the_displacement)
{
    struct manufactured_problem problem;
    if (!test_problem_at(_i, &problem))
        return;
    for (int k = 0; k < PLACES; k++) {
        struct manufactured_state state;
        double place[AXES];
        place_of(&problem, k, place);
        manufactured_evaluate(&problem, place, problem.end, &state);
        for (int along = 0; along < AXES; along++) {
            const struct stencil s = around(&problem, place, problem.end, along);
            for (int axis = 0; axis < AXES; axis++) {
                const double slope =
                    (s.high.displacement[axis] - s.low.displacement[axis]) / s.width;
                ck_assert_near(state.deformation[2 * axis + along], (axis == along) + slope,
                               DIFFERENCE);
            }
        }
        if (problem.geometry == MPM_AXISYMMETRIC)
            ck_assert_near(state.deformation[4], 1.0 + state.displacement[0] / place[0], 1e-14);
        else if (problem.geometry == MPM_PLANE_STRAIN)
            ck_assert(state.deformation[4] == 1.0);
        else
            ck_assert_near(state.nominal[4], 0.0, 1e-14 * TEST_MODULUS);
    }
}
END_TEST

/* Div P in cylindrical coordinates, its parts and what it leaves for the body force. */
START_TEST(div_p_and_the_body_force_follow_from_p)
{
    struct manufactured_problem problem;
    if (!test_problem_at(_i, &problem))
        return;
    const double scale = TEST_MODULUS * 40.0 * problem.parameter[0]; /* E (2 pi)^2 A */
    for (int k = 0; k < PLACES; k++) {
        struct manufactured_state state;
        double place[AXES], divergence[AXES] = {0.0, 0.0};
        place_of(&problem, k, place);
        manufactured_evaluate(&problem, place, problem.end, &state);
        for (int along = 0; along < AXES; along++) {
            const struct stencil s = around(&problem, place, problem.end, along);
            for (int axis = 0; axis < AXES; axis++)
                divergence[axis] +=
                    (s.high.nominal[2 * axis + along] - s.low.nominal[2 * axis + along]) / s.width;
        }
        const double *const p = state.nominal;
        const bool radial = problem.geometry == MPM_AXISYMMETRIC;
        const double hoop[AXES] = {radial ? (p[0] - p[4]) / place[0] : 0.0,
                                   radial ? p[2] / place[0] : 0.0};
        for (int axis = 0; axis < AXES; axis++) {
            ck_assert_near(state.hoop[axis], hoop[axis], 1e-13 * scale);
            ck_assert_near(state.divergence[axis], divergence[axis] + hoop[axis],
                           10.0 * DIFFERENCE * scale);
            ck_assert_near(state.body_force[axis],
                           state.acceleration[axis] - state.divergence[axis] / TEST_DENSITY,
                           1e-13 * scale / TEST_DENSITY);
        }
    }
}
END_TEST

/* ------------------------------------------------------------------- stress */

/* The solver gets F as a start and states which stress follows from it. */
START_TEST(stress_is_what_the_solver_makes_of_the_same_f)
{
    static const char BLOCK[] =
        "format: 1\n"
        "grid: {origin: [0, 0], cell: [1, 1], cells: [4, 4]}\n"
        "time: {end: 1, courant: 0.1}\n"
        "bodies: [{name: block, material: m, region: {rectangle: {from: [1, 1], to: [3, 3]}},\n"
        "          particles_per_cell: [2, 1]}]\n";
    struct manufactured_problem problem;
    if (!test_problem_at(_i, &problem))
        return;
    char *geometry =
        g_strdup_printf("geometry=%s", test_geometry_names[_i / TEST_FIELDS / TEST_LAWS]);
    char *material = g_strdup_printf("materials=[{name: m, law: %s, density: %.17g, bulk: %.17g, "
                                     "shear: %.17g}]",
                                     test_laws[_i / TEST_FIELDS % TEST_LAWS], TEST_DENSITY,
                                     TEST_BULK, TEST_SHEAR);
    const char *const settings[] = {geometry, material, NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    struct manufactured_state states[PLACES];
    double f[PLACES][GRADIENT];
    for (int k = 0; k < PLACES; k++) {
        double place[AXES];
        place_of(&problem, k, place);
        manufactured_evaluate(&problem, place, problem.end, &states[k]);
        memcpy(f[k], states[k].deformation, sizeof f[k]);
    }
    struct mpm_error error = {.message = ""};
    ck_assert_msg(mpm_simulation_set_start(run.simulation, NULL, &f[0][0], &error) == MPM_OK, "%s",
                  error.message);
    size_t count;
    double *const stress = test_run_field(&run, MPM_FIELD_STRESS, &count);
    ck_assert_uint_eq(count, PLACES);
    for (int k = 0; k < PLACES; k++)
        for (int c = 0; c < STRESS; c++)
            ck_assert_near(states[k].stress[c], stress[STRESS * k + c], 1e-14 * TEST_MODULUS);
    free(stress);
    test_run_close(&run);
    g_free(geometry);
    g_free(material);
}
END_TEST

START_TEST(small_amplitudes_are_hookes_law)
{
    struct manufactured_problem problem;
    struct mpm_error error = {.message = ""};
    if (!test_problem_at(_i, &problem))
        return;
    const double amplitude = 1e-7;
    ck_assert_int_eq(manufactured_set(&problem, "amplitude", amplitude, &error), MPM_OK);
    for (int k = 0; k < PLACES; k++) {
        struct manufactured_state state;
        double place[AXES];
        place_of(&problem, k, place);
        manufactured_evaluate(&problem, place, problem.end, &state);
        for (int axis = 0; axis < AXES; axis++) /* strain of 2 pi A and more: 6 A for the vortex */
            ck_assert_near(state.divergence[axis], state.linear[axis],
                           TEST_MODULUS * (2e3 * amplitude * amplitude + 1e-13));
    }
}
END_TEST

/* -------------------------------------------------------------- weak, edges */

/* 64 x 64 products summed up, cancelling to the size of the smallest term. */
static const double WEAK = 1e-13;

START_TEST(the_weak_form_holds_to_round_off)
{
    struct manufactured_problem problem;
    if (!test_problem_at(_i, &problem))
        return;
    ck_assert_double_le(manufactured_weak_residual(&problem, problem.end), WEAK);
    ck_assert_double_le(manufactured_weak_residual(&problem, 0.17 * problem.period), WEAK);
}
END_TEST

/* M2's faces are free to first order in A with neo_hookean: the rest is second order. */
START_TEST(edges_are_held_and_free_as_the_field_says)
{
    struct manufactured_problem problem;
    struct manufactured_edges_left left;
    if (!test_problem_at(_i, &problem))
        return;
    manufactured_edges(&problem, problem.end, &left);
    ck_assert_double_le(left.displacement, 1e-14);
    if (problem.law == MANUFACTURED_LINEAR_ELASTIC ||
        strcmp(manufactured_name(problem.field), "expanding_ring") != 0)
        ck_assert_double_le(left.traction, 1e-13);
}
END_TEST

START_TEST(the_rings_faces_are_left_with_a_traction_that_falls_with_the_amplitude)
{
    struct manufactured_problem problem =
        test_problem("expanding_ring", "neo_hookean", MPM_PLANE_STRAIN);
    struct mpm_error error = {.message = ""};
    double traction[3];
    for (int k = 0; k < 3; k++) {
        struct manufactured_edges_left left;
        ck_assert_int_eq(manufactured_set(&problem, "amplitude",
                                          k == 0   ? 0.1
                                          : k == 1 ? 1e-4
                                                   : 1e-5,
                                          &error),
                         MPM_OK);
        manufactured_edges(&problem, problem.end, &left);
        traction[k] = left.traction;
    }
    /* of the largest |P|: a tenth at A = 0.1, and in proportion to A below */
    ck_assert(traction[0] > 0.05 && traction[0] < 0.2);
    ck_assert_near(traction[1] / traction[2], 10.0, 0.5);
}
END_TEST

/* --------------------------------------------------------------------- axis */

/* Distances fall by tens to 0 itself: quotients by R become limits on the way. Fields are even or
 * odd in R, so that they differ from their values on the axis by (k R)^2, or k R. */
START_TEST(a_field_is_regular_on_the_axis)
{
    static const char *const fields[] = {"cylinder", "bar"};
    const struct manufactured_problem problem =
        test_problem(fields[_i / TEST_LAWS], test_laws[_i % TEST_LAWS], MPM_AXISYMMETRIC);
    struct manufactured_state on, near;
    const double axis[AXES] = {0.0, 0.1},
                 scale = TEST_MODULUS * 40.0 * problem.parameter[0] / TEST_DENSITY;
    manufactured_evaluate(&problem, axis, problem.end, &on);
    ck_assert(isfinite(on.body_force[0]) && isfinite(on.body_force[1]));
    ck_assert(fabs(on.deformation[4] - 1.0) > 0.05);
    ck_assert_near(on.deformation[0], on.deformation[4], 1e-15);
    ck_assert_near(on.body_force[0], 0.0, 1e-15 * scale);
    for (double r = 1e-3; r > 1e-12; r *= 0.1) {
        const double place[AXES] = {r, axis[1]};
        manufactured_evaluate(&problem, place, problem.end, &near);
        ck_assert_near(near.deformation[4], on.deformation[4], 20.0 * r * r + 1e-15);
        for (int k = 0; k < AXES; k++)
            ck_assert_near(near.body_force[k], on.body_force[k],
                           scale * (20.0 * r + 1e-15 / fmax(r, 1e-8)));
    }
}
END_TEST

/* ---------------------------------------------------------------- callbacks */

START_TEST(the_callback_gives_the_body_force_for_any_count_and_order_of_ids)
{
    struct manufactured_problem problem;
    if (!test_problem_at(_i, &problem))
        return;
    static const uint32_t ids[] = {5, 0, 7, 3, 1};
    double places[PLACES][AXES], x[PLACES], y[PLACES], *const force[AXES] = {x, y};
    for (int k = 0; k < PLACES; k++)
        place_of(&problem, k, places[k]);
    struct manufactured_load load = {&problem, &places[0][0]};
    for (size_t count = 0; count <= G_N_ELEMENTS(ids); count++) {
        for (size_t k = 0; k < PLACES; k++)
            x[k] = y[k] = 17.0;
        manufactured_load_evaluate(&load, problem.end, count, ids, force);
        for (size_t k = 0; k < count; k++) {
            struct manufactured_state state;
            manufactured_evaluate(&problem, places[ids[k]], problem.end, &state);
            ck_assert(x[k] == state.body_force[0] && y[k] == state.body_force[1]);
        }
        for (size_t k = count; k < PLACES; k++)
            ck_assert(x[k] == 17.0 && y[k] == 17.0);
    }
}
END_TEST

START_TEST(every_level_of_instructions_gives_the_same_bits)
{
    struct manufactured_problem problem;
    if (!test_problem_at(_i, &problem))
        return;
    enum { COUNT = 37 };
    double places[COUNT][AXES], b[2][AXES][COUNT] = {{{0.0}}};
    uint32_t ids[COUNT];
    struct manufactured_problem other = problem;
    other.kernels = &manufactured_kernels_baseline;
    other.field = other.kernels->fields[_i % TEST_FIELDS];
    for (int k = 0; k < COUNT; k++) {
        place_of(&problem, k % PLACES, places[k]);
        places[k][0] *= 1.0 + 1e-3 * k;
        ids[k] = (uint32_t)k;
    }
    for (int side = 0; side < 2; side++) {
        struct manufactured_load load = {side == 0 ? &problem : &other, &places[0][0]};
        double *const force[AXES] = {b[side][0], b[side][1]};
        manufactured_load_evaluate(&load, problem.end, COUNT, ids, force);
    }
    for (int axis = 0; axis < AXES; axis++)
        for (int k = 0; k < COUNT; k++)
            ck_assert(b[0][axis][k] == b[1][axis][k]);
    ck_assert(fabs(b[0][0][5]) > 0.0);
}
END_TEST

Suite *suite_manufactured(void)
{
    Suite *suite = suite_create("manufactured");
    TCase *fields = tcase_create("fields");
    tcase_add_loop_test(fields, velocity_and_acceleration_are_rates_of_displacement_and_velocity, 0,
                        TEST_PROBLEMS);
    tcase_add_loop_test(fields, f_is_the_gradient_of_the_displacement, 0, TEST_PROBLEMS);
    tcase_add_loop_test(fields, div_p_and_the_body_force_follow_from_p, 0, TEST_PROBLEMS);
    tcase_add_loop_test(fields, stress_is_what_the_solver_makes_of_the_same_f, 0, TEST_PROBLEMS);
    tcase_add_loop_test(fields, small_amplitudes_are_hookes_law, 0, TEST_PROBLEMS);
    tcase_add_loop_test(fields, the_weak_form_holds_to_round_off, 0, TEST_PROBLEMS);
    tcase_add_loop_test(fields, edges_are_held_and_free_as_the_field_says, 0, TEST_PROBLEMS);
    tcase_add_test(fields, the_rings_faces_are_left_with_a_traction_that_falls_with_the_amplitude);
    tcase_add_loop_test(fields, a_field_is_regular_on_the_axis, 0, 2 * TEST_LAWS);
    tcase_add_loop_test(fields, the_callback_gives_the_body_force_for_any_count_and_order_of_ids, 0,
                        TEST_PROBLEMS);
    tcase_add_loop_test(fields, every_level_of_instructions_gives_the_same_bits, 0, TEST_PROBLEMS);
    suite_add_tcase(suite, fields);
    return suite;
}

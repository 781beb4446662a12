/* Manufactured solutions: derivatives against finite differences, stress against the solver's
 * laws, the weak form, the edges, the axis, and the refusal of degenerate choices.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "support/scenes.h"
#include "verification/exact/manufactured.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2, GRADIENT = 5, STRESS = 4 };

static const char *const laws[] = {"neo_hookean", "linear_elastic"};
static const enum mpm_geometry geometries[] = {MPM_PLANE_STRAIN, MPM_PLANE_STRESS,
                                               MPM_AXISYMMETRIC};
static const char *const geometry_names[] = {"plane_strain", "plane_stress", "axisymmetric"};
enum {
    LAWS = G_N_ELEMENTS(laws),
    GEOMETRIES = G_N_ELEMENTS(geometries),
    FIELDS = 5,
    KINDS = FIELDS * LAWS * GEOMETRIES,
};

/* E = 1e7, nu = 0.3, rho = 1000: sqrt(E / rho) = 100 */
static const double DENSITY = 1000.0, BULK = 1e7 / 1.2, SHEAR = 1e7 / 2.6, MODULUS = 1e7;

/* False where the field does not exist in the geometry. */
static bool open_kind(int index, struct manufactured_problem *problem)
{
    const struct manufactured_field *const field = manufactured_at((size_t)(index % FIELDS));
    struct mpm_error error;
    const struct manufactured_setup setup = {
        .field = manufactured_name(field),
        .law = laws[index / FIELDS % LAWS],
        .geometry = geometries[index / FIELDS / LAWS],
        .density = DENSITY,
        .bulk = BULK,
        .shear = SHEAR,
    };
    const enum mpm_status status = manufactured_open(&setup, problem, &error);
    ck_assert_msg(status == MPM_OK || strstr(error.message, "fills an annulus") != NULL, "%s",
                  error.message);
    return status == MPM_OK;
}

static struct manufactured_problem open_problem(const char *field, const char *law,
                                                enum mpm_geometry geometry)
{
    const struct manufactured_setup setup = {field, law, geometry, DENSITY, BULK, SHEAR};
    struct manufactured_problem problem;
    struct mpm_error error;
    ck_assert_msg(manufactured_open(&setup, &problem, &error) == MPM_OK, "%s", error.message);
    return problem;
}

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
    if (!open_kind(_i, &problem))
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
    if (!open_kind(_i, &problem))
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
            ck_assert_near(state.nominal[4], 0.0, 1e-14 * MODULUS);
    }
}
END_TEST

/* Div P in cylindrical coordinates, its parts and what it leaves for the body force. */
START_TEST(div_p_and_the_body_force_follow_from_p)
{
    struct manufactured_problem problem;
    if (!open_kind(_i, &problem))
        return;
    const double scale = MODULUS * 40.0 * problem.parameter[0]; /* E (2 pi)^2 A */
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
                           state.acceleration[axis] - state.divergence[axis] / DENSITY,
                           1e-13 * scale / DENSITY);
        }
    }
}
END_TEST

/* ------------------------------------------------------------------- stress */

/* The solver gets F as a start and says which stress follows from it. */
START_TEST(stress_is_what_the_solver_makes_of_the_same_f)
{
    static const char BLOCK[] =
        "format: 1\n"
        "grid: {origin: [0, 0], cell: [1, 1], cells: [4, 4]}\n"
        "time: {end: 1, courant: 0.1}\n"
        "bodies: [{name: block, material: m, region: {rectangle: {from: [1, 1], to: [3, 3]}},\n"
        "          particles_per_cell: [2, 1]}]\n";
    struct manufactured_problem problem;
    if (!open_kind(_i, &problem))
        return;
    char *geometry = g_strdup_printf("geometry=%s", geometry_names[_i / FIELDS / LAWS]);
    char *material = g_strdup_printf("materials=[{name: m, law: %s, density: %.17g, bulk: %.17g, "
                                     "shear: %.17g}]",
                                     laws[_i / FIELDS % LAWS], DENSITY, BULK, SHEAR);
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
            ck_assert_near(states[k].stress[c], stress[STRESS * k + c], 1e-14 * MODULUS);
    free(stress);
    test_run_close(&run);
    g_free(geometry);
    g_free(material);
}
END_TEST

START_TEST(small_amplitudes_are_hookes_law)
{
    struct manufactured_problem problem;
    struct mpm_error error;
    if (!open_kind(_i, &problem))
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
                           MODULUS * (2e3 * amplitude * amplitude + 1e-13));
    }
}
END_TEST

/* -------------------------------------------------------------- weak, edges */

/* 64 x 64 products summed up, cancelling to the size of the smallest term. */
static const double WEAK = 1e-13;

START_TEST(the_weak_form_holds_to_round_off)
{
    struct manufactured_problem problem;
    if (!open_kind(_i, &problem))
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
    if (!open_kind(_i, &problem))
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
        open_problem("expanding_ring", "neo_hookean", MPM_PLANE_STRAIN);
    struct mpm_error error;
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
        open_problem(fields[_i / LAWS], laws[_i % LAWS], MPM_AXISYMMETRIC);
    struct manufactured_state on, near;
    const double axis[AXES] = {0.0, 0.1}, scale = MODULUS * 40.0 * problem.parameter[0] / DENSITY;
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
    if (!open_kind(_i, &problem))
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

/* ----------------------------------------------------------------- activity */

START_TEST(every_field_has_all_terms_at_its_own_end)
{
    struct manufactured_problem problem;
    struct mpm_error error;
    if (!open_kind(_i, &problem))
        return;
    struct manufactured_activity activity;
    const double cell[AXES] = {problem.domain.high[0] / 16.0, problem.domain.high[1] / 16.0};
    const enum mpm_status status =
        manufactured_activity(&problem, problem.end, cell, &activity, &error);
    if (problem.geometry == MPM_AXISYMMETRIC &&
        strcmp(manufactured_name(problem.field), "axis_aligned") == 0) {
        ck_assert_int_eq(status, MPM_BAD_INPUT); /* P_zr = 0: nothing of the hoop in z */
        ck_assert_msg(strstr(error.message, "the share of the hoop terms of component 1 is 0") !=
                          NULL,
                      "%s", error.message);
        return;
    }
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    for (int axis = 0; axis < AXES; axis++) {
        const double squares = activity.acceleration[axis] * activity.acceleration[axis] +
                               activity.divergence[axis] * activity.divergence[axis];
        ck_assert_near(squares, activity.velocity[axis] > 0.0 ? 1.0 : 0.0, 1e-14);
    }
    if (problem.law == MANUFACTURED_NEO_HOOKEAN)
        ck_assert_double_ge(activity.nonlinear, 0.02);
}
END_TEST

struct degenerate {
    const char *field, *parameter;
    double value, part_of_period; /* 0: the field's own end */
    double cells;
    enum mpm_geometry geometry;
    const char *words;
};
static const struct degenerate DEGENERATES[] = {
    {"axis_aligned", "waves", 1, 0.25, 16, MPM_PLANE_STRAIN, "a turning point"},
    {"cylinder", "waves", 1, 0.75, 16, MPM_AXISYMMETRIC, "a turning point"},
    {"vortex", "amplitude", 0.2, 0.25, 16, MPM_PLANE_STRAIN, "a turning point"},
    {"axis_aligned", "waves", 1, 0.5, 16, MPM_PLANE_STRAIN, "a passage through zero"},
    {"expanding_ring", "amplitude", 0.1, 1.0, 16, MPM_PLANE_STRESS, "a passage through zero"},
    {"axis_aligned", "waves", 8, 0, 16, MPM_PLANE_STRAIN, "displacement at the nodes"},
    {"axis_aligned", "waves", 32, 0, 64, MPM_PLANE_STRAIN, "displacement at the nodes"},
    {"axis_aligned", "amplitude", 1e-3, 0, 1e4, MPM_PLANE_STRAIN, "cells of 0.0001 by 0.0001"},
    {"axis_aligned", "waves", 4, 0, 16, MPM_PLANE_STRAIN, "det F is"},
    {"axis_aligned", "amplitude", 1e-3, 0, 16, MPM_AXISYMMETRIC, "hoop terms of component 1"},
    {"axis_aligned", "waves", 4, 0, 64, MPM_PLANE_STRAIN, "the share of the acceleration"},
};

START_TEST(a_degenerate_choice_is_refused_with_its_reason)
{
    const struct degenerate *const d = &DEGENERATES[_i];
    struct manufactured_problem problem = open_problem(d->field, "neo_hookean", d->geometry);
    struct manufactured_activity activity;
    struct mpm_error error = {.message = ""};
    const bool large = strstr(d->words, "det F") != NULL;
    if (strcmp(d->parameter, "waves") == 0 && !large)
        ck_assert_int_eq(manufactured_set(&problem, "amplitude", 1e-4, &error), MPM_OK);
    ck_assert_int_eq(manufactured_set(&problem, d->parameter, d->value, &error), MPM_OK);
    const double end = d->part_of_period > 0.0 ? d->part_of_period * problem.period : problem.end;
    const double cell[AXES] = {1.0 / d->cells, 1.0 / d->cells};
    ck_assert_msg(manufactured_activity(&problem, end, cell, &activity, &error) == MPM_BAD_INPUT,
                  "passed: %s %g", d->field, d->value);
    ck_assert_msg(strstr(error.message, d->words) != NULL, "%s", error.message);
}
END_TEST

/* ------------------------------------------------------------------ choices */

START_TEST(names_and_values_that_are_not_allowed_are_refused)
{
    struct manufactured_setup setup = {"vortex", "neo_hookean", MPM_PLANE_STRAIN, 1.0, 1.0, 1.0};
    struct manufactured_problem problem;
    struct mpm_error error;
    ck_assert_int_eq(manufactured_open(&setup, &problem, &error), MPM_OK);
    ck_assert_int_eq(manufactured_set(&problem, "radius", 1.0, &error), MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "parameter `radius` of field `vortex`; allowed: amplitude");
    ck_assert_int_eq(manufactured_set(&problem, "amplitude", 2.0, &error), MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "amplitude of field `vortex` is 2; allowed: 1e-09 to 1");
    ck_assert_int_eq(manufactured_set(&problem, "amplitude", (double)NAN, &error), MPM_BAD_INPUT);
    setup.shear = 0.0;
    ck_assert_int_eq(manufactured_open(&setup, &problem, &error), MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "shear modulus is 0; allowed: above 0");
    setup.law = "rubber";
    setup.shear = 1.0;
    ck_assert_int_eq(manufactured_open(&setup, &problem, &error), MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "law `rubber`; allowed: neo_hookean, linear_elastic");
    setup.field = "whirl";
    ck_assert_int_eq(manufactured_open(&setup, &problem, &error), MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "field `whirl`; allowed: axis_aligned, expanding_ring, vortex, "
                                    "cylinder, bar");
    ck_assert(manufactured_at(FIELDS) == NULL && manufactured_at(FIELDS - 1) != NULL);
}
END_TEST

Suite *suite_manufactured(void)
{
    Suite *suite = suite_create("manufactured");
    TCase *fields = tcase_create("fields");
    tcase_add_loop_test(fields, velocity_and_acceleration_are_rates_of_displacement_and_velocity, 0,
                        KINDS);
    tcase_add_loop_test(fields, f_is_the_gradient_of_the_displacement, 0, KINDS);
    tcase_add_loop_test(fields, div_p_and_the_body_force_follow_from_p, 0, KINDS);
    tcase_add_loop_test(fields, stress_is_what_the_solver_makes_of_the_same_f, 0, KINDS);
    tcase_add_loop_test(fields, small_amplitudes_are_hookes_law, 0, KINDS);
    tcase_add_loop_test(fields, the_weak_form_holds_to_round_off, 0, KINDS);
    tcase_add_loop_test(fields, edges_are_held_and_free_as_the_field_says, 0, KINDS);
    tcase_add_test(fields, the_rings_faces_are_left_with_a_traction_that_falls_with_the_amplitude);
    tcase_add_loop_test(fields, a_field_is_regular_on_the_axis, 0, 2 * LAWS);
    tcase_add_loop_test(fields, the_callback_gives_the_body_force_for_any_count_and_order_of_ids, 0,
                        KINDS);
    suite_add_tcase(suite, fields);
    TCase *choices = tcase_create("choices");
    tcase_add_loop_test(choices, every_field_has_all_terms_at_its_own_end, 0, KINDS);
    tcase_add_loop_test(choices, a_degenerate_choice_is_refused_with_its_reason, 0,
                        G_N_ELEMENTS(DEGENERATES));
    tcase_add_test(choices, names_and_values_that_are_not_allowed_are_refused);
    suite_add_tcase(suite, choices);
    return suite;
}

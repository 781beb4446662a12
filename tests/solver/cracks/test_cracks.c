/* Velocity fields, contact and motion of cracks in whole steps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_fields.h"
#include "method/cracks/crack_map.h"
#include "method/grid/grid_update.h"
#include "suites.h"
#include "support/crack_block.h"
#include "support/near.h"
#include "support/transfer_block.h"

#include <float.h>
#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2, GRADIENT = 5, PLACES = 2 };

static const double MIDDLE = 5.6;

/* On the grid line, and between lines of nodes and of particles. */
static const char *const CRACKS[PLACES] = {"[[2, 5.6], [10, 5.6]]",
                                           "[[2, 5.6], [6, 5.7], [10, 5.6]]"};

/* Masses are of 144 particles of 0.2: momenta are sums of as many products of a velocity of order
 * 1, rounded some times each on their way to nodes and back. */
static const double MOMENTUM_ROUND_OFF = 1e-13;

/* -------------------------------------------------------------------- fields */

START_TEST(all_fields_together_have_the_mass_and_momentum_of_the_particles)
{
    struct settings settings = crack_block_method(_i % CRACK_BLOCK_METHODS);
    settings_add_formatted(&settings, "cracks=[{points: %s, contact: none}]",
                           CRACKS[_i / CRACK_BLOCK_METHODS]);
    test_add_wild_velocity(&settings, false);
    struct test_run run = crack_block_open(&settings);
    const struct mpm_ledger before = test_run_ledger(&run);
    test_run_steps(&run, 1);
    const struct mpm_state *const state = crack_block_state(&run);
    double mass = 0.0, momentum[AXES] = {0.0, 0.0}, of_additional = 0.0;
    for (int64_t row = state->first_row; row >= 0; row = mpm_grid_next_row(state, row)) {
        const struct mpm_row_span span = mpm_row_span(state, row);
        for (int64_t node = span.first; node < span.end; node++) {
            mass += state->grid.mass[node];
            of_additional += row >= state->grid.rows ? state->grid.mass[node] : 0.0;
            for (int axis = 0; axis < AXES; axis++)
                momentum[axis] += state->grid.sum[node][axis].momentum;
        }
    }
    ck_assert_near(mass, before.mass, before.mass * MOMENTUM_ROUND_OFF);
    for (int axis = 0; axis < AXES; axis++)
        ck_assert_near(momentum[axis], before.momentum[axis], before.mass * MOMENTUM_ROUND_OFF);
    ck_assert(of_additional > 0.05 * mass && of_additional < 0.5 * mass);
    test_run_close(&run);
}
END_TEST

/* Each half keeps its own velocity, and is not deformed. */
static const double FREE_ROUND_OFF = 1e-13;

static void assert_free(const struct test_run *run, const struct crack_block_start *start,
                        double bound)
{
    double *const velocity = test_run_field(run, MPM_FIELD_VELOCITY, NULL);
    double *const f = test_run_field(run, MPM_FIELD_DEFORMATION_GRADIENT, NULL);
    for (size_t k = 0; k < start->count; k++) {
        for (size_t c = AXES * k; c < AXES * (k + 1); c++)
            ck_assert_near(velocity[c], start->velocity[c], bound);
        for (size_t c = 0; c < GRADIENT; c++)
            ck_assert_near(f[GRADIENT * k + c], c % 3 == 0 || c == 4 ? 1.0 : 0.0, bound);
    }
    free(velocity);
    free(f);
}

START_TEST(sides_that_fly_apart_are_free_and_keep_their_shape)
{
    static const char *const apart[] = {
        "bodies.block.velocity=['y > 5.6 ? 0.3 : -0.7', 'y > 5.6 ? 0.9 : -0.4']",
        "bodies.block.velocity=['0', 'z > 5.6 ? 0.9 : -0.4']"};
    const bool axisymmetric = _i / CRACK_BLOCK_METHODS == PLACES;
    struct settings settings = crack_block_method(_i % CRACK_BLOCK_METHODS);
    settings_add(&settings, apart[axisymmetric]);
    if (axisymmetric)
        settings_add(&settings, "geometry=axisymmetric");
    settings_add_formatted(&settings, "cracks=[{points: %s}]",
                           CRACKS[_i / CRACK_BLOCK_METHODS % PLACES]);
    struct test_run run = crack_block_open(&settings);
    struct crack_block_start start = crack_block_start(&run);
    test_run_steps(&run, 30);
    assert_free(&run, &start, crack_block_amplifies(_i) ? 1e-9 : FREE_ROUND_OFF);
    crack_block_start_free(&start);
    test_run_close(&run);
}
END_TEST

/* Also where nodes beyond the axis mirror those on this side, in all their fields. The sides are
 * allowed to overlap a little: then particles near the axis reach nodes beyond it past the crack.
 */
START_TEST(sides_of_a_penny_crack_are_free_with_mirrored_nodes)
{
    static const char *const shapes[] = {"ugimp", "cpdi"};
    struct settings settings = {.count = 0};
    settings_add_formatted(
        &settings, "method={shape: %s, stress_update: %s, axis: planar, axis_nodes: mirrored}",
        shapes[_i % 2], test_orders[_i / 2 % TEST_ORDERS]);
    settings_add(&settings, "geometry=axisymmetric");
    settings_add(&settings, "grid.origin=[-2, 0]");
    settings_add(&settings, "bodies.block.region.rectangle={from: [0, 3.2], to: [6, 8]}");
    settings_add(&settings, "bodies.block.velocity=['0', 'z > 5.6 ? -0.4 : 0.9']");
    settings_add(&settings, "cracks=[{points: [[0, 5.6], [9, 5.6]], contact: none}]");
    struct test_run run = crack_block_open(&settings);
    struct crack_block_start start = crack_block_start(&run);
    test_run_steps(&run, 8);
    assert_free(&run, &start, FREE_ROUND_OFF);
    crack_block_start_free(&start);
    test_run_close(&run);
}
END_TEST

/* The crack moves with all that it is in: the position is a sum of 30 steps' ways. */
static void assert_carried(struct settings *settings)
{
    settings_add(settings, "bodies.block.velocity=[0.3, -0.2]");
    struct test_run run = crack_block_open(settings);
    const struct mpm_cracks *const cracks = &crack_block_state(&run)->cracks;
    double *const start[AXES] = {
        g_memdup2(cracks->position[0], cracks->point_count * sizeof(double)),
        g_memdup2(cracks->position[1], cracks->point_count * sizeof(double))};
    test_run_steps(&run, 30);
    const double time = mpm_simulation_time(run.simulation);
    ck_assert_uint_gt(cracks->point_count, 10);
    for (size_t k = 0; k < cracks->point_count; k++) {
        ck_assert_near(cracks->position[0][k], start[0][k] + 0.3 * time, FREE_ROUND_OFF);
        ck_assert_near(cracks->position[1][k], start[1][k] - 0.2 * time, FREE_ROUND_OFF);
    }
    g_free(start[0]);
    g_free(start[1]);
    test_run_close(&run);
}

/* Not with the momentum form, which strains a moving body at its edges, a crack's sides among them.
 */
START_TEST(a_crack_moves_at_the_velocity_of_its_body)
{
    struct settings settings = crack_block_method(_i % CRACK_BLOCK_METHODS);
    crack_block_add_exchange(&settings, _i / CRACK_BLOCK_METHODS);
    settings_add(&settings, "cracks=[{points: [[4, 4], [6, 5.6], [8, 7]]}]");
    assert_carried(&settings);
}
END_TEST

/* A crack that is wide open has points that no node with mass reaches: here those in the hole of a
 * ring, six cells wide, which the crack passes. */
START_TEST(a_crack_that_is_wide_open_moves_as_a_whole)
{
    struct settings settings = crack_block_method(_i);
    settings_add(&settings,
                 "bodies.block.region={annulus: {center: [6.9, 6], inner: 2.9, outer: 4.3}}");
    settings_add(&settings, "cracks=[{points: [[3.3, 6], [10.5, 6]]}]");
    assert_carried(&settings);
}
END_TEST

/* Three particles in a cell give nodes beside the crack a quarter of a particle's mass, to
 * round-off. */
START_TEST(a_crack_and_its_mirror_image_move_as_mirror_images)
{
    static const char *const scenes[2][2] = {
        {"bodies.block.velocity=['0.4*(6-x)', '0.3+0.1*(x-6)']",
         "cracks=[{points: [[6.268, 4.464], [5.9, 6.864]]}]"},
        {"bodies.block.velocity=['0.4*(6-x)', '0.3-0.1*(x-6)']",
         "cracks=[{points: [[5.732, 4.464], [6.1, 6.864]]}]"}};
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = crack_block_method(_i);
        settings_add(&settings, "bodies.block.particles_per_cell=[3, 2]");
        settings_add(&settings, scenes[k][0]);
        settings_add(&settings, scenes[k][1]);
        runs[k] = crack_block_open(&settings);
        test_run_steps(&runs[k], 5);
    }
    const struct mpm_cracks *const one = &crack_block_state(&runs[0])->cracks;
    const struct mpm_cracks *const other = &crack_block_state(&runs[1])->cracks;
    ck_assert_uint_eq(one->point_count, other->point_count);
    for (size_t k = 0; k < one->point_count; k++) {
        ck_assert_near(other->position[0][k], 12.0 - one->position[0][k], FREE_ROUND_OFF);
        ck_assert_near(other->position[1][k], one->position[1][k], FREE_ROUND_OFF);
    }
    test_run_close(&runs[0]);
    test_run_close(&runs[1]);
}
END_TEST

/* ------------------------------------------------------------------- contact */

/* Compressed along y, so that surfaces press against each other from the first step on, while the
 * halves slide past each other at `slip`. */
static struct test_run open_pressed(int index, double slip, const char *contact,
                                    struct crack_block_start *start)
{
    struct settings settings = crack_block_method(index % CRACK_BLOCK_METHODS);
    if (contact != NULL)
        settings_add_formatted(&settings, "cracks=[{points: %s, contact: %s}]", CRACKS[0], contact);
    struct test_run run = crack_block_open(&settings);
    *start = crack_block_start(&run);
    double *const f = test_run_field(&run, MPM_FIELD_DEFORMATION_GRADIENT, NULL);
    for (size_t k = 0; k < start->count; k++) {
        const double above = start->place[AXES * k + 1] - MIDDLE;
        f[GRADIENT * k + 3] = 0.98;
        start->velocity[AXES * k] = above > 0.0 ? slip : -slip;
        start->velocity[AXES * k + 1] = -0.3 * above;
    }
    struct mpm_error error;
    ck_assert_int_eq(mpm_simulation_set_start(run.simulation, start->velocity, f, &error), MPM_OK);
    free(f);
    return run;
}

/* Momentum that the half above gets in one step. */
static void take_one_step(int index, double slip, const char *contact, double gained[AXES])
{
    struct crack_block_start start;
    struct test_run run = open_pressed(index, slip, contact, &start);
    double above[2][AXES], below[2][AXES];
    crack_block_momentum(&run, &start, true, above[0]);
    crack_block_momentum(&run, &start, false, below[0]);
    test_run_steps(&run, 1);
    crack_block_momentum(&run, &start, true, above[1]);
    crack_block_momentum(&run, &start, false, below[1]);
    for (int axis = 0; axis < AXES; axis++) {
        gained[axis] = above[1][axis] - above[0][axis];
        ck_assert_near(below[1][axis] - below[0][axis], -gained[axis], 15.0 * MOMENTUM_ROUND_OFF);
    }
    crack_block_start_free(&start);
    test_run_close(&run);
}

START_TEST(contact_keeps_momentum_and_shares_it_by_its_law)
{
    double none[AXES], smooth[AXES], rough[AXES], rougher[AXES], stick[AXES];
    take_one_step(_i, 0.5, "none", none);
    take_one_step(_i, 0.5, "frictionless", smooth);
    take_one_step(_i, 0.5, "friction, friction: 0.25", rough);
    take_one_step(_i, -0.5, "friction, friction: 0.75", rougher);
    take_one_step(_i, 0.0, "stick", stick);
    for (int axis = 0; axis < AXES; axis++)
        ck_assert_near(none[axis], 0.0, 15.0 * MOMENTUM_ROUND_OFF);
    ck_assert_double_gt(smooth[1], 1e-2);
    ck_assert_near(smooth[0], 0.0, 15.0 * MOMENTUM_ROUND_OFF);
    ck_assert_near(rough[0], -0.25 * rough[1], 15.0 * MOMENTUM_ROUND_OFF);
    ck_assert_near(rougher[0], 0.75 * rougher[1], 15.0 * MOMENTUM_ROUND_OFF);
    ck_assert_near(rough[1], smooth[1], 0.1 * smooth[1]);
    ck_assert_near(stick[0], 0.0, 15.0 * MOMENTUM_ROUND_OFF);
}
END_TEST

/* Under loads that press, to which the run sticks wherever surfaces are in contact, what friction
 * of any amount holds is what sticks, bit by bit. */
START_TEST(friction_that_is_not_overcome_sticks)
{
    struct crack_block_start start[2];
    struct test_run runs[2] = {open_pressed(_i, 0.01, "stick", &start[0]),
                               open_pressed(_i, 0.01, "friction, friction: 1e6", &start[1])};
    for (int k = 0; k < 2; k++)
        test_run_steps(&runs[k], 5);
    ck_assert(test_run_same_bits(&runs[0], &runs[1]));
    for (int k = 0; k < 2; k++) {
        crack_block_start_free(&start[k]);
        test_run_close(&runs[k]);
    }
}
END_TEST

/* Under compression, in which surfaces approach each other at every node and stay there. */
START_TEST(a_crack_that_sticks_is_none_while_it_is_pressed)
{
    static const enum mpm_field fields[] = {MPM_FIELD_POSITION, MPM_FIELD_VELOCITY,
                                            MPM_FIELD_DEFORMATION_GRADIENT, MPM_FIELD_STRESS};
    struct crack_block_start start[2];
    struct test_run runs[2] = {open_pressed(_i, 0.0, "stick, separated: 1e-6", &start[0]),
                               open_pressed(_i, 0.0, NULL, &start[1])};
    for (int k = 0; k < 2; k++)
        test_run_steps(&runs[k], 1);
    for (size_t f = 0; f < G_N_ELEMENTS(fields); f++)
        ck_assert_near(test_run_difference(&runs[0], &runs[1], fields[f]), 0.0, 1e-12);
    for (int k = 0; k < 2; k++) {
        crack_block_start_free(&start[k]);
        test_run_close(&runs[k]);
    }
}
END_TEST

/* Two halves that meet: the total is conserved over a hundred steps. */
START_TEST(momentum_is_conserved_over_a_collision)
{
    static const char *const laws[] = {"frictionless", "friction, friction: 0.4", "stick"};
    for (int law = 0; law < 3 && !crack_block_amplifies(_i); law++) {
        struct settings settings = crack_block_method(_i);
        settings_add(&settings, "bodies.block.velocity=['y > 5.6 ? 0.7 : -0.2', "
                                "'y > 5.6 ? -0.6 : 0.3 + 0.1*x']");
        settings_add_formatted(&settings, "cracks=[{points: %s, contact: %s}]", CRACKS[1],
                               laws[law]);
        struct test_run run = crack_block_open(&settings);
        const struct mpm_ledger before = test_run_ledger(&run);
        test_run_steps(&run, 60);
        const struct mpm_ledger after = test_run_ledger(&run);
        for (int axis = 0; axis < AXES; axis++)
            ck_assert_near(after.momentum[axis], before.momentum[axis],
                           60.0 * before.mass * MOMENTUM_ROUND_OFF);
        test_run_close(&run);
    }
}
END_TEST

/* ------------------------------------------------------------------- the run */

START_TEST(results_are_the_same_bits_for_any_number_of_threads)
{
    static const char *const shapes[] = {"method={shape: cpdi, stress_update: usavg}",
                                         "method={shape: bspline2, stress_update: musl}"};
    static const char *const crack =
        "cracks=[{points: [[2, 10], [30, 25.6], [40, 45], [64, 20]], contact: friction, "
        "friction: 0.3}]";
    const char *const settings[] = {
        TEST_BLOCK_FOR_THREADS, shapes[_i], crack,
        "bodies.block.velocity=['0.3*sin(0.2*x)*cos(0.3*y)', '0.4*cos(0.1*x+0.2*y)']", NULL};
    test_same_bits_over_threads(CRACK_BLOCK, settings, 4, NULL);
}
END_TEST

START_TEST(a_scene_without_cracks_has_nothing_of_them)
{
    static const char *const cracked[] = {"cracks=[{points: [[2, 5.6], [10, 5.6]]}]", NULL};
    struct test_run without = test_run_open(CRACK_BLOCK, NULL, 1);
    struct test_run with = test_run_open(CRACK_BLOCK, cracked, 1);
    test_run_steps(&without, 2);
    const struct mpm_cracks *const cracks = &crack_block_state(&without)->cracks;
    const struct mpm_fields *const fields = &crack_block_state(&without)->fields;
    ck_assert(cracks->point_count == 0 && cracks->chains == NULL && cracks->crossings == NULL);
    ck_assert(fields->node_capacity == 0 && fields->keys == 0 && fields->rows == 0);
    ck_assert(fields->use_of == NULL && fields->node_of == NULL && fields->asked == NULL);
    ck_assert(fields->nodes == NULL && fields->list == NULL && fields->uses == NULL);
    ck_assert(crack_block_state(&without)->symmetries.count == 0);
    ck_assert_int_eq(crack_block_state(&without)->grid.field_rows, 0);
    ck_assert_uint_lt(mpm_simulation_bytes(without.simulation),
                      mpm_simulation_bytes(with.simulation));
    test_run_close(&without);
    test_run_close(&with);
}
END_TEST

static const struct {
    const char *settings[3], *words;
} FAILING[] = {
    {{"cracks=[{points: [[2, 5.6], [13.9, 5.6]]}]",
      "bodies.block.region.rectangle={from: [7, 3.2], to: [13, 8]}",
      "bodies.block.velocity=[1, 0]"},
     "a point of cracks.0 left the grid from ("},
    {{"cracks=[{points: [[2, 5.3], [10, 5.3]]}, {points: [[2, 5.5], [10, 5.5]]}]"},
     "reaches a node past two cracks; allowed: past one"},
    /* the second one runs back: above one is below the other, for functions of any support */
    {{"cracks=[{points: [[2, 5.3], [10, 5.3]]}, {points: [[10, 5.5], [2, 5.5]]}]"},
     "reaches a node past two cracks; allowed: past one"},
    {{"cracks=[{points: [[2, 5.3], [10, 5.3]]}, {points: [[10, 5.5], [2, 5.5]]}]",
      "method={shape: ugimp, cracks: visibility}"},
     "reaches a node past two cracks; allowed: past one"},
    {{"cracks=[{points: [[10, 5.3], [2, 5.3]]}, {points: [[2, 5.6], [10, 5.6]]}]",
      "method.shape=cpdi"},
     "reaches a node past two cracks; allowed: past one"},
    {{"cracks=[{points: [[2, 5.5], [10, 5.5]]}, {points: [[10, 6.1], [2, 6.1]]}]",
      "method.shape=bspline2"},
     "reaches a node past two cracks; allowed: past one"},
    {{"cracks=[{points: [[5.2, 5.6], [6.8, 5.6]], contact: none, spacing: 1}]",
      "bodies=[{name: block, material: rubber, velocity: ['2*(x-6)', 0], "
      "region: {rectangle: {from: [5.2, 3.2], to: [6.8, 8]}}}]",
      "materials.0={name: rubber, law: neo_hookean, density: 1, bulk: 0.01, shear: 0.01}"},
     "a segment of cracks.0 was stretched, from ("},
};

/* What is measured when the scene is created may not suffice for what cracks become. */
START_TEST(cracks_that_find_no_room_end_the_run_with_a_message)
{
    static const char *const words[] = {"more cells near cracks than the 1 that",
                                        "more particles near cracks than the 1 that",
                                        "more nodes near cracks than the 1 that"};
    struct settings settings = {.count = 0};
    settings_add(&settings, "cracks=[{points: [[2, 5.6], [10, 5.6]]}]");
    struct test_run run = crack_block_open(&settings);
    struct mpm_state *const state = &run.simulation->state;
    struct mpm_error error = {.message = ""};
    test_run_steps(&run, 1);
    *(_i == 0   ? &state->cracks.map->capacity
      : _i == 1 ? &state->fields.use_capacity
                : &state->fields.node_capacity) = 1;
    mpm_fields_begin(state);
    ck_assert_int_eq(mpm_cracks_find_fields(state, 1, &error), MPM_RUN_FAILED);
    ck_assert_msg(strstr(error.message, words[_i]) != NULL, "%s", error.message);
    test_run_close(&run);
}
END_TEST

/* Everything goes back to the last good step, the cracks too. */
START_TEST(a_run_that_cannot_go_on_says_why_and_goes_back_with_its_cracks)
{
    struct settings settings = {.count = 0};
    settings_add(&settings, "method.shape=ugimp");
    for (int k = 0; k < 3 && FAILING[_i].settings[k] != NULL; k++)
        settings_add(&settings, FAILING[_i].settings[k]);
    struct test_run failed = test_run_open(CRACK_BLOCK, settings.texts, 1);
    struct test_run good = crack_block_open(&settings);
    struct mpm_error error = {.message = ""};
    enum mpm_status status = MPM_OK;
    for (int step = 0; status == MPM_OK && step < 500; step++)
        status = mpm_simulation_advance(failed.simulation, 100.0, &error);
    ck_assert_msg(status == MPM_RUN_FAILED, "%s", error.message);
    ck_assert_msg(strstr(error.message, FAILING[_i].words) != NULL, "%s", error.message);
    test_run_steps(&good, (int)mpm_simulation_step(failed.simulation));
    ck_assert(test_run_same_bits(&failed, &good));
    const struct mpm_cracks *const one = &crack_block_state(&failed)->cracks,
                                   *const other = &crack_block_state(&good)->cracks;
    for (int axis = 0; axis < AXES; axis++)
        ck_assert_int_eq(
            memcmp(one->position[axis], other->position[axis], one->point_count * sizeof(double)),
            0);
    test_run_close(&failed);
    test_run_close(&good);
}
END_TEST

/* Stress is not saved but found again from F: of particles near cracks too. */
START_TEST(steps_beside_cracks_are_repeated_with_the_same_bits)
{
    static const char *const laws[] = {
        "materials=[{name: rubber, law: neo_hookean, density: 1, bulk: 80, shear: 48}]",
        "materials=[{name: rubber, law: linear_elastic, density: 1, bulk: 80, shear: 48}]"};
    struct settings settings = crack_block_method(_i % CRACK_BLOCK_FAMILIES);
    settings_add(&settings, laws[_i / CRACK_BLOCK_FAMILIES]);
    settings_add(&settings, "bodies.block.velocity=['0.1*sin(y)', '0.1*cos(x)']");
    settings_add(&settings, "cracks=[{points: [[1, 5.3], [7, 5.9]], contact: none}]");
    struct test_run back = test_run_open(CRACK_BLOCK, settings.texts, 1);
    struct test_run plain = crack_block_open(&settings);
    const int steps = MPM_STEPS_BETWEEN_SORTS + 10;
    test_run_steps(&back, steps);
    test_run_steps(&plain, steps);
    ck_assert_uint_gt(mpm_simulation_field_particles(back.simulation), 0);
    mpm_backup_restore(back.simulation, (uint64_t)steps);
    ck_assert(test_run_same_bits(&back, &plain));
    test_run_close(&back);
    test_run_close(&plain);
}
END_TEST

Suite *suite_cracks(void)
{
    Suite *suite = suite_create("cracks");
    TCase *fields = tcase_create("fields");
    tcase_add_loop_test(fields, all_fields_together_have_the_mass_and_momentum_of_the_particles, 0,
                        PLACES * CRACK_BLOCK_METHODS);
    tcase_add_loop_test(fields, sides_that_fly_apart_are_free_and_keep_their_shape, 0,
                        (PLACES + 1) * CRACK_BLOCK_METHODS);
    tcase_add_loop_test(fields, sides_of_a_penny_crack_are_free_with_mirrored_nodes, 0,
                        2 * TEST_ORDERS);
    tcase_add_loop_test(fields, a_crack_moves_at_the_velocity_of_its_body, 0,
                        CRACK_BLOCK_WAYS * CRACK_BLOCK_FORM * CRACK_BLOCK_METHODS);
    tcase_add_loop_test(fields, a_crack_that_is_wide_open_moves_as_a_whole, 0, CRACK_BLOCK_METHODS);
    tcase_add_loop_test(fields, a_crack_and_its_mirror_image_move_as_mirror_images, 0,
                        CRACK_BLOCK_METHODS);
    suite_add_tcase(suite, fields);
    TCase *contact = tcase_create("contact");
    tcase_add_loop_test(contact, contact_keeps_momentum_and_shares_it_by_its_law, 0,
                        CRACK_BLOCK_METHODS);
    tcase_add_loop_test(contact, friction_that_is_not_overcome_sticks, 0, CRACK_BLOCK_METHODS);
    tcase_add_loop_test(contact, a_crack_that_sticks_is_none_while_it_is_pressed, 0,
                        CRACK_BLOCK_METHODS);
    tcase_add_loop_test(contact, momentum_is_conserved_over_a_collision, 0, CRACK_BLOCK_METHODS);
    suite_add_tcase(suite, contact);
    TCase *runs = tcase_create("runs");
    tcase_add_loop_test(runs, results_are_the_same_bits_for_any_number_of_threads, 0, 2);
    tcase_add_test(runs, a_scene_without_cracks_has_nothing_of_them);
    tcase_add_loop_test(runs, cracks_that_find_no_room_end_the_run_with_a_message, 0, 3);
    tcase_add_loop_test(runs, steps_beside_cracks_are_repeated_with_the_same_bits, 0,
                        2 * CRACK_BLOCK_FAMILIES);
    tcase_add_loop_test(runs, a_run_that_cannot_go_on_says_why_and_goes_back_with_its_cracks, 0,
                        G_N_ELEMENTS(FAILING));
    suite_add_tcase(suite, runs);
    return suite;
}

/* Contact of cracks at nodes that velocity conditions hold.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_impulse.h"
#include "method/cracks/crack_fields.h"
#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"
#include "suites.h"
#include "support/crack_block.h"
#include "support/near.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>

enum { AXES = 2, LAWS = 3 };

static const struct {
    const char *settings;
    struct mpm_contact_law law;
} laws[LAWS] = {
    {"contact: frictionless", {MPM_CONTACT_FRICTIONLESS, 0.0, false}},
    {"contact: friction, friction: 0.4", {MPM_CONTACT_FRICTION, 0.4, false}},
    {"contact: stick", {MPM_CONTACT_STICK, 0.0, false}},
};

/* --------------------------------------------------------------- one exchange */

enum { DIRECTIONS = 24, HOLDS = 16, SLIDES = 7 };

/* Velocities and masses are of order 1, and each result is some operations away from them; an
 * impulse at a wall that the normal is nearly across is larger, by 1/n_free at most. */
static const double EXCHANGE_ROUND_OFF = 1e-14;

static const double PAIR_MASSES[2] = {0.7, 2.3};

/* The velocity above turns by steps of a circle; below it is fixed. */
static void describe_pair(int slide, int hold, struct mpm_contact_side sides[2])
{
    const double angle = 2.0 * G_PI * (double)slide / SLIDES + 0.3;
    const double velocity[2][AXES] = {{cos(angle), sin(angle)}, {0.2, -0.1}};
    for (int side = 0; side < 2; side++)
        for (int axis = 0; axis < AXES; axis++) {
            const bool held = (hold >> (2 * side + axis) & 1) != 0;
            sides[side].velocity[axis] = velocity[side][axis];
            sides[side].mobility[axis] = held ? 0.0 : 1.0 / PAIR_MASSES[side];
        }
}

/* Of what can change, seen from what is held: a wall that moves does work. */
static double kinetic_energy(const struct mpm_contact_side sides[2])
{
    double energy = 0.0;
    for (int axis = 0; axis < AXES; axis++) {
        double held = 0.0;
        for (int side = 0; side < 2; side++)
            if (sides[side].mobility[axis] == 0.0)
                held = sides[side].velocity[axis];
        for (int side = 0; side < 2; side++) {
            const double velocity = sides[side].velocity[axis] - held;
            if (sides[side].mobility[axis] > 0.0)
                energy += 0.5 * velocity * velocity / sides[side].mobility[axis];
        }
    }
    return energy;
}

static void exchange(const struct mpm_contact_side before[2], const double impulse[AXES],
                     struct mpm_contact_side after[2])
{
    for (int side = 0; side < 2; side++)
        for (int axis = 0; axis < AXES; axis++) {
            after[side].mobility[axis] = before[side].mobility[axis];
            after[side].velocity[axis] =
                before[side].velocity[axis] +
                (side == 0 ? 1.0 : -1.0) * before[side].mobility[axis] * impulse[axis];
        }
}

/* The tilt of the normal: exact axes are among them. */
static void normal_of(int direction, double normal[AXES])
{
    static const double axes[4][AXES] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
    const double angle = 2.0 * G_PI * (double)direction / DIRECTIONS;
    const bool along_axis = direction % (DIRECTIONS / 4) == 0;
    normal[0] = along_axis ? axes[direction / (DIRECTIONS / 4)][0] : cos(angle);
    normal[1] = along_axis ? axes[direction / (DIRECTIONS / 4)][1] : sin(angle);
}

static void assert_exchange(int law, const struct mpm_contact_side sides[2],
                            const double normal[AXES])
{
    struct mpm_contact_side after[2];
    double impulse[AXES];
    mpm_contact_impulse(&laws[law].law, sides, normal, impulse);
    exchange(sides, impulse, after);
    double mobility = 0.0;
    for (int axis = 0; axis < AXES; axis++)
        mobility +=
            (sides[0].mobility[axis] + sides[1].mobility[axis]) * normal[axis] * normal[axis];
    const double pressed = impulse[0] * normal[0] + impulse[1] * normal[1];
    const double dragged = impulse[1] * normal[0] - impulse[0] * normal[1];
    ck_assert_double_le(kinetic_energy(after), kinetic_energy(sides) + EXCHANGE_ROUND_OFF);
    if (mobility == 0.0)
        ck_assert_double_eq(pressed, 0.0);
    if (laws[law].law.kind == MPM_CONTACT_FRICTIONLESS)
        ck_assert_near(dragged, 0.0, 10.0 * EXCHANGE_ROUND_OFF);
    if (laws[law].law.kind == MPM_CONTACT_FRICTION)
        ck_assert_double_le(fabs(dragged),
                            laws[law].law.friction * fabs(pressed) + 10.0 * EXCHANGE_ROUND_OFF);
}

START_TEST(an_exchange_keeps_held_components_and_never_adds_energy)
{
    for (int law = 0; law < LAWS; law++)
        for (int direction = 0; direction < DIRECTIONS; direction++)
            for (int slide = 0; slide < SLIDES; slide++) {
                struct mpm_contact_side sides[2];
                double normal[AXES];
                describe_pair(slide, _i, sides);
                normal_of(direction, normal);
                assert_exchange(law, sides, normal);
            }
}
END_TEST

/* Both fields of a node are held alike: then nothing is left of the approach, and with stick of any
 * difference that can change. */
START_TEST(fields_that_are_held_alike_do_not_approach_after_an_exchange)
{
    for (int law = 0; law < LAWS; law++)
        for (int direction = 0; direction < DIRECTIONS; direction++)
            for (int slide = 0; slide < SLIDES; slide++) {
                struct mpm_contact_side sides[2], after[2];
                double normal[AXES], impulse[AXES];
                describe_pair(slide, _i * 5, sides);
                normal_of(direction, normal);
                mpm_contact_impulse(&laws[law].law, sides, normal, impulse);
                exchange(sides, impulse, after);
                ck_assert_near(mpm_contact_approach(after, normal), 0.0, EXCHANGE_ROUND_OFF);
                for (int axis = 0; axis < AXES && laws[law].law.kind == MPM_CONTACT_STICK; axis++)
                    if (sides[0].mobility[axis] > 0.0)
                        ck_assert_near(after[0].velocity[axis], after[1].velocity[axis],
                                       EXCHANGE_ROUND_OFF);
            }
}
END_TEST

/* CRAMP (13)-(19), written with masses. */
START_TEST(free_fields_exchange_what_cramp_says)
{
    const double reduced = PAIR_MASSES[0] * PAIR_MASSES[1] / (PAIR_MASSES[0] + PAIR_MASSES[1]);
    for (int direction = 0; direction < DIRECTIONS; direction++)
        for (int slide = 0; slide < SLIDES; slide++) {
            struct mpm_contact_side sides[2];
            double n[AXES], impulse[AXES], d[AXES];
            describe_pair(slide, 0, sides);
            normal_of(direction, n);
            for (int axis = 0; axis < AXES; axis++)
                d[axis] = sides[0].velocity[axis] - sides[1].velocity[axis];
            const double across = d[0] * n[0] + d[1] * n[1], along = d[1] * n[0] - d[0] * n[1];
            const double limit = laws[_i].law.kind == MPM_CONTACT_STICK
                                     ? HUGE_VAL
                                     : laws[_i].law.friction * fabs(across);
            const double taken = copysign(fmin(fabs(along), limit), along);
            mpm_contact_impulse(&laws[_i].law, sides, n, impulse);
            ck_assert_near(impulse[0], -reduced * (across * n[0] - taken * n[1]),
                           EXCHANGE_ROUND_OFF);
            ck_assert_near(impulse[1], -reduced * (across * n[1] + taken * n[0]),
                           EXCHANGE_ROUND_OFF);
        }
}
END_TEST

/* --------------------------------------------------------------- whole steps */

/* A block of 6 by 6 cells between two rigid bodies that press it along its wall, and a crack that
 * meets the wall at an angle. In places (u, w): u is the distance from the wall, w runs along it.
 */
enum { SIDE = 8, WALLS = 4 };

static const char PRESSED[] = "format: 1\n"
                              "geometry: plane_strain\n"
                              "grid: {origin: [0, 0], cell: [1, 1], cells: [8, 8]}\n"
                              "time: {end: 1000, courant: 0.4}\n"
                              "materials: [{name: m, law: neo_hookean, density: 1, young: 1, "
                              "poisson: 0.3}]\n"
                              "bodies: []\n";

static const struct wall {
    const char *name;
    bool upright, far; /* across the first axis? at the grid's far edge? */
} walls[WALLS] = {
    {"left", true, false}, {"right", true, true}, {"bottom", false, false}, {"top", false, true}};

static void place_at(const struct wall *wall, double u, double w, double place[AXES])
{
    const double depth = wall->far ? SIDE - u : u;
    place[0] = wall->upright ? depth : w;
    place[1] = wall->upright ? w : depth;
}

/* "[x, y], [x, y]" of the two places, the lower values first for a box. */
static char *corners(const struct wall *wall, const double from[AXES], const double to[AXES],
                     const char *format, bool ordered)
{
    double a[AXES], b[AXES];
    place_at(wall, from[0], from[1], a);
    place_at(wall, to[0], to[1], b);
    for (int axis = 0; axis < AXES && ordered; axis++) {
        const double low = fmin(a[axis], b[axis]);
        b[axis] = fmax(a[axis], b[axis]);
        a[axis] = low;
    }
    return g_strdup_printf(format, a[0], a[1], b[0], b[1]);
}

static const char BOX[] = "{rectangle: {from: [%.17g, %.17g], to: [%.17g, %.17g]}}";

/* A component across the wall, and one along it. */
static char *components(const struct wall *wall, const char *across, const char *along)
{
    return wall->upright ? g_strdup_printf("[%s, %s]", across, along)
                         : g_strdup_printf("[%s, %s]", along, across);
}

static void add_bodies(struct settings *settings, const struct wall *wall, const char *speed)
{
    char *const block = corners(wall, (double[]){0, 1}, (double[]){6, 7}, BOX, true);
    char *const low = corners(wall, (double[]){0, 0}, (double[]){7, 1}, BOX, true);
    char *const high = corners(wall, (double[]){0, 7}, (double[]){7, 8}, BOX, true);
    char *const up = components(wall, "free", speed);
    char *const back = g_strconcat("-", speed, NULL);
    char *const down = components(wall, "free", back);
    settings_add_formatted(settings,
                           "bodies=[{name: block, material: m, region: %s}, "
                           "{name: low, rigid: {velocity: %s}, region: %s}, "
                           "{name: high, rigid: {velocity: %s}, region: %s}]",
                           block, up, low, down, high);
    g_free(block);
    g_free(low);
    g_free(high);
    g_free(up);
    g_free(back);
    g_free(down);
}

static void add_crack(struct settings *settings, const struct wall *wall, const double from[AXES],
                      const double to[AXES], const char *law)
{
    char *const points = corners(wall, from, to, "[[%.17g, %.17g], [%.17g, %.17g]]", false);
    settings_add_formatted(settings, "cracks=[{points: %s, %s}]", points, law);
    g_free(points);
}

/* `velocity` away from the wall, or NULL for a plane of symmetry. */
static void add_wall(struct settings *settings, const struct wall *wall, const char *velocity)
{
    char *const line = corners(wall, (double[]){0, 0}, (double[]){0, SIDE},
                               "{line: {from: [%.17g, %.17g], to: [%.17g, %.17g]}}", true);
    char *const across = g_strconcat(wall->far ? "-" : "", velocity, NULL);
    char *const held = components(wall, across, "free");
    if (velocity == NULL)
        settings_add_formatted(settings, "boundary=[{region: %s, symmetry: true}]", line);
    else
        settings_add_formatted(settings, "boundary=[{region: %s, velocity: %s}]", line, held);
    g_free(line);
    g_free(across);
    g_free(held);
}

/* A node's component has what its condition prescribes, bit for bit, at the start of the step, at
 * its end and in what updates the stress. */
static void assert_condition(const struct mpm_state *state,
                             const struct mpm_active_condition *active)
{
    const int axis = active->component;
    const int64_t node = active->node;
    const struct mpm_node_motion *const motion = &state->grid.motion[node];
    ck_assert(state->grid.start[node][axis] == active->start);
    ck_assert(motion->end[axis] == active->end);
    ck_assert(motion->acceleration[axis] == (active->end - active->start) / state->time_step);
    for (int k = 0; k < 2; k++)
        ck_assert(state->grid.gradient[node][axis][k] == active->end);
}

/* Mirrors have the condition's value of the re-extrapolated velocity too, not of the end. */
static void assert_mirror(const struct mpm_state *state, const struct mpm_active_condition *mirror)
{
    ck_assert(state->grid.start[mirror->node][0] == mirror->start);
    ck_assert(state->grid.motion[mirror->node].end[0] == mirror->end);
}

/* Nodes with several fields of which a condition holds a component: a test has to have some. */
static size_t assert_conditions(const struct test_run *run)
{
    const struct mpm_state *const state = crack_block_state(run);
    size_t met = 0;
    for (size_t k = 0; k < state->conditions.first_mirror; k++)
        assert_condition(state, &state->conditions.active[k]);
    for (size_t k = state->conditions.first_mirror; k < state->conditions.active_count; k++)
        assert_mirror(state, &state->conditions.active[k]);
    for (size_t k = 0; k < state->fields.node_count; k++) {
        const struct mpm_crack_node node = mpm_crack_node_of(state, k);
        int massive = 0;
        for (int field = 0; field < 3; field++)
            massive += node.field[field] >= 0 && state->grid.mass[node.field[field]] > 0.0 &&
                       node.held[field] != 0;
        met += massive > 1;
    }
    return met;
}

static void assert_conditions_of(struct settings *settings, int steps)
{
    struct test_run run = test_run_open(PRESSED, settings->texts, 1);
    size_t met = 0;
    for (int step = 0; step < steps; step++) {
        test_run_steps(&run, 1);
        met += assert_conditions(&run);
    }
    ck_assert_uint_gt(met, 0);
    test_run_close(&run);
    settings_clear(settings);
}

/* Oblique cracks at a wall, at rest or moving, and at the rigid bodies. */
static const struct {
    double from[AXES], to[AXES];
    const char *wall;
} met[] = {
    {{0, 3.77}, {2.61, 6.53}, "0"},       {{0, 4.41}, {3.43, 2.37}, "0"},
    {{0, 3.77}, {2.61, 6.53}, "0.001*t"}, {{1.53, 0.37}, {4.61, 3.43}, "0"},
    {{0.17, 2.03}, {0.23, 5.57}, "0"}, /* along the wall: both fields are held along the normal */
};

START_TEST(conditions_hold_to_the_bit_beside_a_crack_in_contact)
{
    const struct wall *const wall = &walls[_i % WALLS];
    const size_t which = (size_t)_i / WALLS;
    for (int method = 0; method < CRACK_BLOCK_METHODS; method++) {
        struct settings settings = crack_block_method(method);
        const char *const law = laws[(method + method / LAWS + _i) % LAWS].settings;
        if (crack_block_amplifies(method))
            settings_add(&settings, "method.shape=ugimp");
        add_bodies(&settings, wall, "0.002*t");
        add_crack(&settings, wall, met[which].from, met[which].to, law);
        add_wall(&settings, wall, met[which].wall);
        assert_conditions_of(&settings, 12);
    }
}
END_TEST

START_TEST(conditions_at_the_axis_hold_to_the_bit_beside_a_crack_in_contact)
{
    static const char *const axes[] = {"", ", axis: planar, axis_nodes: mirrored",
                                       ", axis: planar, axis_nodes: zero"};
    static const char *const shapes[] = {"ugimp", "cpdi"};
    for (int order = 0; order < TEST_ORDERS; order++)
        for (int law = 0; law < LAWS; law++) {
            struct settings settings = {.count = 0};
            settings_add_formatted(&settings, "method={shape: %s, stress_update: %s%s}",
                                   shapes[_i % 2], test_orders[order], axes[_i / 2]);
            settings_add(&settings, "geometry=axisymmetric");
            if (_i / 2 > 0) {
                settings_add(&settings, "grid.origin=[-2, 0]");
                settings_add(&settings, "grid.cells=[10, 8]");
            }
            add_bodies(&settings, &walls[0], "0.002*t");
            add_crack(&settings, &walls[0], met[0].from, met[0].to, laws[law].settings);
            assert_conditions_of(&settings, 12);
        }
}
END_TEST

/* Images of nodes that have been in contact: they are images still. Nodes that rigid bodies drive
 * are not, whose domains end at the plane. */
static void assert_images(const struct test_run *run)
{
    const struct mpm_state *const state = crack_block_state(run);
    struct mpm_symmetry_image images[MPM_SYMMETRY_IMAGES];
    for (size_t n = 0; n < state->fields.node_count; n++) {
        const int64_t node = state->fields.nodes[n].node;
        const int count =
            state->fields.nodes[n].held == 0 ? mpm_symmetry_images(state, node, images) : 0;
        for (int k = 0; k < count; k++)
            for (int axis = 0; axis < AXES; axis++) {
                const int64_t image = images[k].node;
                const double sign = images[k].sign[axis];
                ck_assert(state->grid.start[image][axis] == sign * state->grid.start[node][axis]);
                ck_assert(state->grid.motion[image].end[axis] ==
                          sign * state->grid.motion[node].end[axis]);
                ck_assert(state->grid.gradient[image][axis][0] ==
                          sign * state->grid.gradient[node][axis][0]);
            }
    }
}

/* The crack begins inside, as near to the plane as it may. */
START_TEST(a_plane_of_symmetry_holds_all_fields_beside_a_crack_in_contact)
{
    const struct wall *const wall = &walls[_i % WALLS];
    for (int method = 0; method < CRACK_BLOCK_METHODS; method++)
        for (int law = 0; law < LAWS; law++) {
            struct settings settings = crack_block_method(method);
            if (crack_block_amplifies(method))
                settings_add(&settings, "method.shape=ugimp");
            add_bodies(&settings, wall, "0.002*t");
            add_crack(&settings, wall, (double[]){0.03, 3.77}, (double[]){2.61, 6.33},
                      laws[law].settings);
            add_wall(&settings, wall, NULL);
            struct test_run run = test_run_open(PRESSED, settings.texts, 1);
            size_t fields = 0;
            for (int step = 0; step < 12; step++) {
                test_run_steps(&run, 1);
                fields += assert_conditions(&run);
                assert_images(&run);
            }
            ck_assert_uint_gt(fields, 0);
            test_run_close(&run);
            settings_clear(&settings);
        }
}
END_TEST

/* Sums over 144 particles and 40 steps, and tangents of order 1 of what differs. */
static const double TURNED_ROUND_OFF = 1e-10;

/* The same block at each wall: energies do not depend on where the wall is. */
START_TEST(a_block_at_another_wall_has_the_same_energies)
{
    struct mpm_ledger ledgers[WALLS];
    for (int k = 0; k < WALLS; k++) {
        struct settings settings = {.count = 0};
        settings_add(&settings, "method={shape: ugimp, stress_update: usavg}");
        add_bodies(&settings, &walls[k], "0.002*t");
        add_crack(&settings, &walls[k], met[0].from, met[0].to, laws[_i].settings);
        add_wall(&settings, &walls[k], "0");
        struct test_run run = test_run_open(PRESSED, settings.texts, 1);
        test_run_steps(&run, 40);
        ledgers[k] = test_run_ledger(&run);
        test_run_close(&run);
        settings_clear(&settings);
    }
    const double scale = ledgers[0].external_work;
    ck_assert_double_gt(scale, 0.0);
    for (int k = 1; k < WALLS; k++) {
        ck_assert_near(ledgers[k].strain_energy, ledgers[0].strain_energy,
                       scale * TURNED_ROUND_OFF);
        ck_assert_near(ledgers[k].kinetic_energy, ledgers[0].kinetic_energy,
                       scale * TURNED_ROUND_OFF);
        ck_assert_near(ledgers[k].external_work, scale, scale * TURNED_ROUND_OFF);
    }
}
END_TEST

Suite *suite_contact_conditions(void)
{
    Suite *suite = suite_create("contact_conditions");
    TCase *exchange_case = tcase_create("exchange");
    tcase_add_loop_test(exchange_case, an_exchange_keeps_held_components_and_never_adds_energy, 0,
                        HOLDS);
    tcase_add_loop_test(exchange_case, fields_that_are_held_alike_do_not_approach_after_an_exchange,
                        0, 4);
    tcase_add_loop_test(exchange_case, free_fields_exchange_what_cramp_says, 0, LAWS);
    suite_add_tcase(suite, exchange_case);
    TCase *steps = tcase_create("steps");
    tcase_add_loop_test(steps, conditions_hold_to_the_bit_beside_a_crack_in_contact, 0,
                        WALLS * (int)G_N_ELEMENTS(met));
    tcase_add_loop_test(steps, conditions_at_the_axis_hold_to_the_bit_beside_a_crack_in_contact, 0,
                        2 * 3);
    tcase_add_loop_test(steps, a_plane_of_symmetry_holds_all_fields_beside_a_crack_in_contact, 0,
                        WALLS);
    tcase_add_loop_test(steps, a_block_at_another_wall_has_the_same_energies, 0, LAWS);
    suite_add_tcase(suite, steps);
    return suite;
}

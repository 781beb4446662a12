/* Additional velocity fields without cracks: artificial clients, bodies that each have a field of
 * their own and pass through each other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/combinations.h"
#include "support/near.h"
#include "support/scenes.h"

#include "base/strips.h"
#include "method/contact/exchange.h"
#include "method/fields/fields.h"
#include "method/grid/active_nodes.h"
#include "method/grid/grid_update.h"
#include "method/transfer/transfer.h"
#include "simulation/simulation.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2, BODIES = 3, STEPS = 30 };

/* Bodies that touch, move into each other and stand on one floor; wave speed 1.5. */
#define SCENE(bodies)                                                                              \
    TEST_BLOCK_SCENE("{end: 1000, step: 0.1}",                                                     \
                     "{name: soft, law: neo_hookean, density: 1, bulk: 1.25, shear: 0.75}",        \
                     bodies)                                                                       \
    "boundary: []\n"
#define BODY(name, from, to)                                                                       \
    "  - {name: " name ", material: soft, particles_per_cell: [2, 2], region: {rectangle: "        \
    "{from: " from ", to: " to "}}}\n"
#define LEFT   BODY("left", "[2, 3.2]", "[5, 6.4]")
#define MIDDLE BODY("middle", "[5, 3.2]", "[7, 5.6]")
#define RIGHT  BODY("right", "[7, 3.2]", "[10, 6.4]")
static const char TOGETHER[] = SCENE(LEFT MIDDLE RIGHT);
static const char *const alone[BODIES] = {SCENE(LEFT), SCENE(MIDDLE), SCENE(RIGHT)};
static const char *const names[BODIES] = {"left", "middle", "right"};
static const double speeds[BODIES] = {0.4721, 0.0, -0.5317};

/* Sums of some hundred products over thirty steps, of values of order 1. */
static const double FIELD_ROUND_OFF = 1e-11;

/* ---------------------------------------------------------------- comparing */

static struct mpm_state *state_of(const struct test_run *run)
{
    return &run->simulation->state;
}

/* A field of all particles of one body, in the order of their ids, is that of a run of it alone. */
static void assert_same_field(const struct test_run *together, size_t first,
                              const struct test_run *apart, enum mpm_field field, size_t parts)
{
    size_t all, count;
    double *const of_all = test_run_field(together, field, &all);
    double *const own = test_run_field(apart, field, &count);
    ck_assert_uint_le(first + count, all);
    for (size_t k = 0; k < parts * count; k++)
        ck_assert_near(of_all[parts * first + k], own[k], FIELD_ROUND_OFF);
    free(of_all);
    free(own);
}

static size_t assert_same_body(const struct test_run *together, size_t first,
                               const struct test_run *apart)
{
    assert_same_field(together, first, apart, MPM_FIELD_POSITION, AXES);
    assert_same_field(together, first, apart, MPM_FIELD_VELOCITY, AXES);
    assert_same_field(together, first, apart, MPM_FIELD_DEFORMATION_GRADIENT, MPM_GRADIENT_SIZE);
    return first + mpm_simulation_particle_count(apart->simulation);
}

static double momentum_of(const struct test_run *run, uint32_t body, int axis)
{
    const struct mpm_particles *const particles = &state_of(run)->particles;
    double sum = 0.0;
    for (size_t p = 0; p < particles->count; p++)
        if (particles->body[p] == body)
            sum += particles->mass[p] * particles->velocity[axis][p];
    return sum;
}

/* ------------------------------------------------------------------- memory */

static void layout(struct mpm_state *state, struct mpm_arena *arena)
{
    const size_t rows = (size_t)(state->grid.rows + state->grid.field_rows);
    mpm_grid_layout(&state->grid, state->kernels.smooth != NULL, false, arena);
    state->row_low = MPM_TAKE(arena, int64_t, rows);
    state->row_high = MPM_TAKE(arena, int64_t, rows);
    mpm_fields_layout(state, arena);
    state->row_sums = MPM_TAKE(arena, struct mpm_row_sums, rows);
    state->conditions.active =
        MPM_TAKE(arena, struct mpm_active_condition, BODIES * state->conditions.active_capacity);
}

/* Memory for what has been claimed since the simulation was created: no scene claims it. */
static struct mpm_arena make_room(struct mpm_state *state)
{
    struct mpm_arena arena = {0};
    struct mpm_error error = {.message = ""};
    state->fields.use_capacity = state->particles.count;
    layout(state, &arena);
    ck_assert_msg(mpm_arena_allocate(&arena, &error) == MPM_OK, "%s", error.message);
    layout(state, &arena);
    for (int64_t row = 0; row < state->grid.rows + state->grid.field_rows; row++) {
        state->row_low[row] = state->grid.columns;
        state->row_high[row] = -1;
    }
    return arena;
}

/* ------------------------------------------------------------------- layers */

/* What a step does besides moving particles, as far as it knows nodes by their place. */
static const struct {
    const char *settings[3];
    bool loaded, axisymmetric;
} around[] = {
    {{NULL}, false, false},
    {{"boundary=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, velocity: [free, "
      "'0.02*sin(2*t)']}]"},
     true,
     false},
    {{"boundary=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, symmetry: true}]",
      "method.transfer={kind: xpic, order: 2}"},
     false,
     false},
    {{"damping={grid: '0.1+0.01*x', particle: 0.05}", "method.position_update=midpoint"},
     false,
     false},
    {{"geometry=axisymmetric", "method.axis=untruncated"}, false, true},
    {{"geometry=axisymmetric", "method.axis=planar", "method.axis_nodes=mirrored"}, false, true},
};

/* Shapes, orders and surroundings, with both sets of kernels; the last row has the first two shapes
 * and reference kernels alone. */
enum {
    SHAPES = 4,
    MIRRORED = G_N_ELEMENTS(around) - 1,
    METHODS = SHAPES * TEST_ORDERS,
    SLOW = METHODS * MIRRORED, /* the first run with reference kernels */
    MIRROR_RUNS = 2 * TEST_ORDERS,
    LAYER_RUNS = 2 * SLOW + MIRROR_RUNS,
};

struct layer_run {
    int shape, order, place;
    bool fast;
};

static struct layer_run layer_run(int index)
{
    const int mirrored = index - 2 * SLOW;
    if (mirrored >= 0)
        return (struct layer_run){mirrored % 2, mirrored / 2, MIRRORED, false};
    return (struct layer_run){index % SHAPES, index / SHAPES % TEST_ORDERS,
                              index / METHODS % MIRRORED, index < SLOW};
}

static void add_loads(struct settings *settings, int first, int end)
{
    GString *const loads = g_string_new("loads.tractions=[");
    for (int k = first; k < end; k++)
        g_string_append_printf(loads, "%s{body: %s, edge: all, frame: edge, value: [-0.05, 0]}",
                               k > first ? ", " : "", names[k]);
    settings_add_formatted(settings, "%s]", loads->str);
    g_string_free(loads, TRUE);
}

/* Each body strains and turns as it moves. */
static void add_velocity(struct settings *settings, int body, bool axisymmetric)
{
    settings_add_formatted(settings, "bodies.%s.velocity=['%g+0.1*sin(%s)', '0.1*cos(%s)-0.02']",
                           names[body], speeds[body], axisymmetric ? "z" : "y",
                           axisymmetric ? "r" : "x");
}

static void choose_kernels(struct test_run *run, enum mpm_kernels kernels)
{
    struct mpm_error error = {.message = ""};
    mpm_simulation_free(run->simulation);
    ck_assert_msg(
        mpm_simulation_create(run->scene,
                              &(struct mpm_simulation_options){.threads = 1, .kernels = kernels},
                              &run->simulation, &error) == MPM_OK,
        "%s", error.message);
}

/* `body`: BODIES for all of them. */
static struct test_run open_run(int index, int body)
{
    static const char *const shapes[SHAPES] = {"ugimp", "cpdi", "bspline2", "classic"};
    const struct layer_run of = layer_run(index);
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "method={shape: %s, stress_update: %s}", shapes[of.shape],
                           test_orders[of.order]);
    for (int k = 0; k < 3 && around[of.place].settings[k] != NULL; k++)
        settings_add(&settings, around[of.place].settings[k]);
    const int first = body == BODIES ? 0 : body, end = body == BODIES ? BODIES : body + 1;
    for (int k = first; k < end; k++)
        add_velocity(&settings, k, around[of.place].axisymmetric);
    if (around[of.place].loaded)
        add_loads(&settings, first, end);
    struct test_run run = test_run_open(body == BODIES ? TOGETHER : alone[body], settings.texts, 1);
    settings_clear(&settings);
    choose_kernels(&run, of.fast ? MPM_KERNELS_FAST : MPM_KERNELS_REFERENCE);
    return run;
}

/* Each body in a layer, the first one in the grid itself: none knows of the others, whatever a
 * step does besides, and fast kernels stay. */
START_TEST(bodies_with_layers_of_their_own_move_as_if_each_were_alone)
{
    struct test_run together = open_run(_i, BODIES);
    struct mpm_state *const state = state_of(&together);
    const int64_t first = mpm_fields_claim_layers(state, BODIES - 1);
    struct mpm_arena arena = make_room(state);
    size_t done = 0;
    for (int64_t body = 1; body < BODIES; body++)
        state->bodies[body].layer = first + body - 1;
    mpm_strips_run(state->strip_count, 1, mpm_pass_measure, state);
    test_run_steps(&together, STEPS);
    for (int body = 0; body < BODIES; body++) {
        struct test_run apart = open_run(_i, body);
        test_run_steps(&apart, STEPS);
        done = assert_same_body(&together, done, &apart);
        test_run_close(&apart);
    }
    ck_assert_uint_eq(done, mpm_simulation_particle_count(together.simulation));
    test_run_close(&together);
    mpm_arena_free(&arena);
}
END_TEST

/* --------------------------------------------------------------------- keys */

/* Bodies but the first have a key. They request their field at nodes that another one reaches. */
struct asking {
    struct mpm_state *state;
    uint8_t *reached; /* per node: bits of the bodies */
    bool by_id;       /* else a particle's key is its id's, and it requests fields everywhere */
};

static void look(void *context, int64_t strip, int worker)
{
    const struct asking *const asking = context;
    const struct mpm_state *const state = asking->state;
    (void)worker;
    for (size_t p = state->strips[strip].begin; p < state->strips[strip].end; p++) {
        struct mpm_stencil plain;
        mpm_particle_plain_stencil(state, p, &plain);
        for (int k = 0; k < plain.count; k++)
            asking->reached[state->node_zero + plain.node[k].node] |=
                (uint8_t)(1u << state->particles.body[p]);
    }
}

static int key_of(const struct asking *asking, size_t p)
{
    const struct mpm_particles *const particles = &asking->state->particles;
    return asking->by_id ? (int)(particles->id[p] % (MPM_FIELD_KEYS + 1)) : (int)particles->body[p];
}

static void ask(void *context, int64_t strip, int worker)
{
    const struct asking *const asking = context;
    struct mpm_state *const state = asking->state;
    (void)worker;
    for (size_t p = state->strips[strip].begin; p < state->strips[strip].end; p++) {
        struct mpm_field_use use = {.particle = (uint32_t)p};
        const int key = key_of(asking, p);
        mpm_particle_plain_stencil(state, p, &use.stencil);
        for (int k = 0; key > 0 && k < use.stencil.count; k++) {
            const int64_t node = state->node_zero + use.stencil.node[k].node;
            const int64_t place[AXES] = {node % state->grid.columns, node / state->grid.columns};
            if (asking->by_id || (asking->reached[node] & ~(1u << state->particles.body[p])) != 0)
                mpm_field_ask(state, &use, k, place, key);
        }
        if (use.keys != 0)
            ck_assert_uint_ne(mpm_field_keep(state, strip, &use), SIZE_MAX);
    }
}

static void find_fields(struct mpm_state *state, bool by_id)
{
    const size_t nodes = (size_t)(state->grid.columns * state->grid.rows);
    struct asking asking = {state, g_malloc0(nodes), by_id};
    mpm_fields_begin(state);
    mpm_strips_run(state->strip_count, 1, look, &asking);
    mpm_strips_run(state->strip_count, 1, ask, &asking);
    ck_assert_int_eq(mpm_fields_settle(state), MPM_FIELDS_LACK_NOTHING);
    g_free(asking.reached);
}

static void run_pass(struct mpm_state *state, mpm_pass *pass)
{
    if (pass != NULL)
        mpm_strips_run(state->strip_count, 1, pass, state);
}

/* To the nodes' velocities at the end of the step. The order is that of mpm_step_advance. */
static void half_step(struct mpm_state *state, bool with_fields)
{
    mpm_grid_find_active(state);
    if (with_fields)
        find_fields(state, false);
    mpm_grid_rows_run(state, mpm_row_clear);
    run_pass(state, state->kernels.passes->to_grid);
    mpm_grid_rows_run(state, state->kernels.start_rows);
    run_pass(state, state->kernels.passes->stress_before);
    mpm_grid_rows_run(state, mpm_row_update);
}

static void other_half(struct mpm_state *state)
{
    run_pass(state, state->kernels.passes->to_particles);
    if (state->order->extrapolate)
        mpm_grid_rows_run(state, mpm_row_extrapolated_velocity);
    run_pass(state, state->kernels.passes->finish);
}

static void take_steps(const struct test_run *run, bool with_fields)
{
    struct mpm_state *const state = state_of(run);
    state->time_step = 0.1;
    for (int step = 0; step < STEPS; step++) {
        half_step(state, with_fields);
        other_half(state);
    }
}

enum { KEY_RUNS = METHODS, FAST_KEY_RUNS = METHODS };

/* Up to three fields of a node, packed. */
START_TEST(bodies_with_keys_of_their_own_pass_through_each_other)
{
    const bool fast = _i >= KEY_RUNS;
    const int index = _i % KEY_RUNS, slow = index + SLOW;
    struct test_run together = open_run(fast ? index : slow, BODIES);
    struct mpm_state *const state = state_of(&together);
    ck_assert_int_eq(mpm_fields_claim(state, BODIES - 1, (size_t)mpm_layer_size(state)), 1);
    struct mpm_arena arena = make_room(state);
    double before[BODIES][AXES];
    size_t done = 0;
    for (uint32_t body = 0; body < BODIES; body++)
        for (int axis = 0; axis < AXES; axis++)
            before[body][axis] = momentum_of(&together, body, axis);
    take_steps(&together, true);
    ck_assert_uint_gt(state->fields.node_count, 0);
    for (int body = 0; body < BODIES; body++) {
        struct test_run apart = open_run(slow, body);
        take_steps(&apart, false);
        done = assert_same_body(&together, done, &apart);
        for (int axis = 0; axis < AXES; axis++)
            ck_assert_near(momentum_of(&together, (uint32_t)body, axis), before[body][axis],
                           FIELD_ROUND_OFF);
        test_run_close(&apart);
    }
    test_run_close(&together);
    mpm_arena_free(&arena);
}
END_TEST

/* ----------------------------------------------------------------- exchange */

/* All fields of a node. */
static int list_fields(const struct mpm_state *state, const struct mpm_field_node *node,
                       struct mpm_exchange_field fields[BODIES])
{
    int count = 0;
    for (int key = 0; key < BODIES; key++) {
        const int64_t field = mpm_field_of(state, node, key);
        if (field >= 0 && state->grid.mass[field] > 0.0)
            fields[count++] = (struct mpm_exchange_field){field, 0};
    }
    return count;
}

START_TEST(two_bodies_that_stick_at_a_node_leave_it_with_one_velocity)
{
    static const struct mpm_contact_law stick = {MPM_CONTACT_STICK, 0.0, false};
    static const double normal[AXES] = {0.6, 0.8};
    struct test_run run = open_run(SLOW, BODIES);
    struct mpm_state *const state = state_of(&run);
    (void)mpm_fields_claim(state, BODIES - 1, (size_t)mpm_layer_size(state));
    struct mpm_arena arena = make_room(state);
    size_t pairs = 0;
    state->time_step = 0.1;
    half_step(state, true);
    for (size_t k = 0; k < state->fields.node_count; k++) {
        struct mpm_exchange_field fields[BODIES];
        if (list_fields(state, &state->fields.nodes[k], fields) != 2)
            continue;
        const double mass[2] = {state->grid.mass[fields[0].node], state->grid.mass[fields[1].node]};
        double(*const v[2])[AXES] = {&state->grid.motion[fields[0].node].end,
                                     &state->grid.motion[fields[1].node].end};
        double momentum[AXES];
        for (int axis = 0; axis < AXES; axis++)
            momentum[axis] = mass[0] * (*v[0])[axis] + mass[1] * (*v[1])[axis];
        mpm_exchange(state, MPM_EXCHANGE_END, fields, normal, &stick);
        for (int axis = 0; axis < AXES; axis++) {
            ck_assert_near((*v[0])[axis], (*v[1])[axis], FIELD_ROUND_OFF);
            ck_assert_near(mass[0] * (*v[0])[axis] + mass[1] * (*v[1])[axis], momentum[axis],
                           FIELD_ROUND_OFF);
        }
        pairs++;
    }
    ck_assert_uint_gt(pairs, 4);
    test_run_close(&run);
    mpm_arena_free(&arena);
}
END_TEST

/* ------------------------------------------------------------------- limits */

/* As many keys as there may be, by the particles' ids: nearly every node has all of them. */
START_TEST(a_node_with_every_key_has_the_mass_of_its_particles_in_its_fields)
{
    struct test_run run = open_run(SLOW, BODIES);
    struct mpm_state *const state = state_of(&run);
    const int64_t size = mpm_layer_size(state);
    (void)mpm_fields_claim(state, MPM_FIELD_KEYS, (size_t)size);
    struct mpm_arena arena = make_room(state);
    double *const whole = g_new0(double, (gsize)size);
    int most = 0;
    mpm_grid_find_active(state);
    mpm_fields_begin(state);
    mpm_grid_rows_run(state, mpm_row_clear);
    run_pass(state, mpm_pass_momentum);
    memcpy(whole, state->grid.mass, (size_t)size * sizeof *whole);
    find_fields(state, true);
    mpm_grid_rows_run(state, mpm_row_clear);
    run_pass(state, mpm_pass_momentum);
    for (int64_t field = 0; field < state->fields.count; field++) {
        const int64_t node = mpm_fields_first(state) + field;
        const int64_t parent = mpm_field_parent(state, node);
        ck_assert(parent >= 0 && parent < size);
        state->grid.mass[parent] += state->grid.mass[node];
    }
    for (size_t k = 0; k < state->fields.node_count; k++)
        most = MAX(most, state->fields.nodes[k].count);
    for (int64_t node = 0; node < size; node++)
        ck_assert_near(state->grid.mass[node], whole[node], FIELD_ROUND_OFF);
    ck_assert_int_eq(most, MPM_FIELD_KEYS);
    g_free(whole);
    test_run_close(&run);
    mpm_arena_free(&arena);
}
END_TEST

Suite *suite_fields(void)
{
    Suite *suite = suite_create("fields");
    TCase *layers = tcase_create("layers");
    TCase *keys = tcase_create("keys");
    tcase_add_loop_test(layers, bodies_with_layers_of_their_own_move_as_if_each_were_alone, 0,
                        LAYER_RUNS);
    tcase_add_loop_test(keys, bodies_with_keys_of_their_own_pass_through_each_other, 0,
                        KEY_RUNS + FAST_KEY_RUNS);
    tcase_add_test(keys, two_bodies_that_stick_at_a_node_leave_it_with_one_velocity);
    tcase_add_test(keys, a_node_with_every_key_has_the_mass_of_its_particles_in_its_fields);
    suite_add_tcase(suite, layers);
    suite_add_tcase(suite, keys);
    return suite;
}

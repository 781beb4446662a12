/* Values of particles spread to nodes and gathered back, by both sets of kernels: every family,
 * geometry and order of the stress update, scalars and vectors, also beside cracks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/projection.h"
#include "simulation/simulation.h"
#include "suites.h"
#include "support/combinations.h"
#include "support/crack_block.h"
#include "support/kernel_pair.h"
#include "support/near.h"

#include <glib.h>
#include <string.h>

enum {
    SETS = 2,
    VALUES = MPM_NODE_VALUES,
    COMPONENTS = MPM_PROJECTION_COMPONENTS,
    STEPS = 3,
    CASES = TEST_COMBINATIONS + CRACK_BLOCK_METHODS,
};

/* Sums of about a hundred products of numbers up to 1, and weights by formulas of their own. */
static const double ROUND_OFF = 1e-13;

/* ------------------------------------------------------------ particles and nodes */

/* Whole vectors of four particles and the rest: 3 particles a cell. */
static struct kernel_pair open_pair(int index)
{
    const bool crack = index >= TEST_COMBINATIONS;
    struct settings settings = crack ? crack_block_method(index) : test_combination_settings(index);
    settings_add(&settings, "bodies.block.particles_per_cell=[3, 1]");
    if (crack)
        settings_add(&settings, "cracks=[{points: [[4, 4.1], [7.3, 7]], contact: none}]");
    else
        test_add_wild_velocity(&settings, test_combination(index).axisymmetric);
    const struct kernel_side sides[SETS] = {
        {settings.texts, {.kernels = MPM_KERNELS_REFERENCE, .threads = 1}},
        {settings.texts, {.kernels = MPM_KERNELS_FAST, .threads = 1}},
    };
    struct kernel_pair pair = kernel_pair_open_text(CRACK_BLOCK, sides);
    for (int step = 0; step < STEPS; step++)
        ck_assert(kernel_pair_step(&pair));
    settings_clear(&settings);
    return pair;
}

static struct mpm_state *state_of(const struct kernel_pair *pair, int set)
{
    return &pair->simulation[set]->state;
}

/* In -1 to 1, without order. */
static double number(size_t k)
{
    return (double)(k * 2654435761U % 1021) / 510.0 - 1.0;
}

static size_t node_count(const struct mpm_state *state)
{
    return (size_t)mpm_grid_nodes(&state->grid) + MPM_ROW_PADDING;
}

/* A field that scenes do not have yet, with so many components; g_free the memory. */
static double *add_field(struct mpm_state *state, size_t components)
{
    struct mpm_particles *const particles = &state->particles;
    double *const memory = g_new(double, particles->count *components);
    particles->components[MPM_PARTICLE_LAW_STATE] = (uint8_t)components;
    particles->law_state = memory;
    for (size_t k = 0; k < components; k++) {
        double *const array = memory + k * particles->count;
        for (size_t p = 0; p < particles->count; p++)
            array[p] = number(particles->id[p] * COMPONENTS + k);
    }
    return memory;
}

static double *field(const struct mpm_state *state, size_t k)
{
    return mpm_particle_array(&state->particles, MPM_PARTICLE_LAW_STATE, k);
}

/* Nodal values that particles may read. */
static double *nodal_values(const struct mpm_state *state)
{
    double *const nodes = g_new(double, node_count(state) * VALUES);
    for (size_t k = 0; k < node_count(state) * VALUES; k++)
        nodes[k] = number(k);
    return nodes;
}

static void run(struct mpm_state *state, struct mpm_projection projection)
{
    projection.components = state->particles.components[MPM_PARTICLE_LAW_STATE];
    projection.field = MPM_PARTICLE_LAW_STATE;
    mpm_projection_run(state, 1, &projection);
}

static double *spread(struct mpm_state *state)
{
    double *const nodes = g_new0(double, node_count(state) * VALUES);
    run(state, (struct mpm_projection){.to = nodes});
    return nodes;
}

/* sum_p m_p a_p b_p of a component, or without b */
static double particle_sum(const struct mpm_state *state, const double *a, const double *b)
{
    double sum = 0.0;
    for (size_t p = 0; p < state->particles.count; p++)
        sum += state->particles.mass[p] * a[p] * (b == NULL ? 1.0 : b[p]);
    return sum;
}

/* sum_i n_i u_i of a component that was spread, or without u, which particles gather */
static double nodal_sum(const struct mpm_state *state, size_t k, const double *n, const double *u)
{
    double sum = 0.0;
    for (size_t node = 0; node < node_count(state); node++)
        sum += n[VALUES * node + 2 * k] * (u == NULL ? 1.0 : u[VALUES * node + k]);
    return sum;
}

static double total_mass(const struct mpm_state *state)
{
    double mass = 0.0;
    for (size_t p = 0; p < state->particles.count; p++)
        mass += state->particles.mass[p];
    return mass;
}

/* -------------------------------------------------------------------------- tests */

START_TEST(spreading_keeps_the_sum_of_mass_times_value)
{
    struct kernel_pair pair = open_pair(_i);
    for (int set = 0; set < SETS; set++) {
        struct mpm_state *const state = state_of(&pair, set);
        double *const memory = add_field(state, COMPONENTS), *const nodes = spread(state);
        for (size_t k = 0; k < COMPONENTS; k++)
            ck_assert_near(nodal_sum(state, k, nodes, NULL),
                           particle_sum(state, field(state, k), NULL),
                           ROUND_OFF * total_mass(state));
        g_free(nodes);
        g_free(memory);
    }
    kernel_pair_close(&pair);
}
END_TEST

/* sum_i (spread v)_i u_i = sum_p m_p v_p (gather u)_p: one moment of the values, whatever they are,
 * which no sum of weights alone would notice. */
START_TEST(gathering_is_the_transpose_of_spreading)
{
    struct kernel_pair pair = open_pair(_i);
    for (int set = 0; set < SETS; set++) {
        struct mpm_state *const state = state_of(&pair, set);
        double *const memory = add_field(state, COMPONENTS), *const nodes = spread(state);
        double *const read = nodal_values(state);
        const size_t count = state->particles.count;
        double *const before = g_memdup2(memory, COMPONENTS * count * sizeof *before);
        run(state, (struct mpm_projection){.from = read});
        for (size_t k = 0; k < COMPONENTS; k++)
            ck_assert_near(nodal_sum(state, k, nodes, read),
                           particle_sum(state, before + k * count, field(state, k)),
                           ROUND_OFF * total_mass(state));
        g_free(before);
        g_free(read);
        g_free(nodes);
        g_free(memory);
    }
    kernel_pair_close(&pair);
}
END_TEST

/* To the last bit. */
START_TEST(a_scalar_is_exchanged_as_a_component_of_a_vector_is)
{
    struct kernel_pair pair = open_pair(_i);
    for (int set = 0; set < SETS; set++) {
        struct mpm_state *const state = state_of(&pair, set);
        double *const read = nodal_values(state);
        double *memory[2], *nodes[2];
        for (size_t k = 0; k < 2; k++) {
            memory[k] = add_field(state, COMPONENTS - k);
            for (size_t p = 0; p < state->particles.count; p++)
                memory[k][p] = number(7 * state->particles.id[p]);
            nodes[k] = spread(state);
            run(state, (struct mpm_projection){.from = read});
        }
        for (size_t n = 0; n < node_count(state); n++)
            ck_assert(nodes[0][VALUES * n] == nodes[1][VALUES * n]);
        ck_assert_mem_eq(memory[0], memory[1], state->particles.count * sizeof *memory[0]);
        for (size_t k = 0; k < 2; k++) {
            g_free(memory[k]);
            g_free(nodes[k]);
        }
        g_free(read);
    }
    kernel_pair_close(&pair);
}
END_TEST

/* To the last bit. */
START_TEST(a_filter_is_a_gather_and_then_a_spread)
{
    struct kernel_pair pair = open_pair(_i);
    for (int set = 0; set < SETS; set++) {
        struct mpm_state *const state = state_of(&pair, set);
        double *const memory = add_field(state, COMPONENTS), *const read = nodal_values(state);
        double *const at_once = g_new0(double, node_count(state) * VALUES);
        run(state, (struct mpm_projection){.from = read, .to = at_once});
        run(state, (struct mpm_projection){.from = read});
        double *const one_by_one = spread(state);
        ck_assert_mem_eq(at_once, one_by_one, node_count(state) * VALUES * sizeof *at_once);
        g_free(one_by_one);
        g_free(at_once);
        g_free(read);
        g_free(memory);
    }
    kernel_pair_close(&pair);
}
END_TEST

/* Both ways; what particles gather is up to 1, what nodes get up to the mass around them. */
START_TEST(both_sets_of_kernels_project_the_same)
{
    struct kernel_pair pair = open_pair(_i);
    double *memory[SETS], *nodes[SETS], *read[SETS];
    const struct mpm_state *const state = state_of(&pair, 0);
    for (int set = 0; set < SETS; set++) {
        memory[set] = add_field(state_of(&pair, set), COMPONENTS);
        nodes[set] = spread(state_of(&pair, set));
        read[set] = nodal_values(state);
        run(state_of(&pair, set), (struct mpm_projection){.from = read[set]});
    }
    for (size_t n = 0; n < VALUES * node_count(state); n += 2)
        ck_assert_near(nodes[1][n], nodes[0][n], ROUND_OFF * total_mass(state));
    for (size_t p = 0; p < COMPONENTS * state->particles.count; p++)
        ck_assert_near(memory[1][p], memory[0][p], 10.0 * ROUND_OFF);
    for (int set = 0; set < SETS; set++) {
        g_free(memory[set]);
        g_free(nodes[set]);
        g_free(read[set]);
    }
    kernel_pair_close(&pair);
}
END_TEST

Suite *suite_projection(void)
{
    Suite *suite = suite_create("projection");
    TCase *values = tcase_create("values");
    tcase_add_loop_test(values, spreading_keeps_the_sum_of_mass_times_value, 0, CASES);
    tcase_add_loop_test(values, gathering_is_the_transpose_of_spreading, 0, CASES);
    tcase_add_loop_test(values, a_scalar_is_exchanged_as_a_component_of_a_vector_is, 0, CASES);
    tcase_add_loop_test(values, a_filter_is_a_gather_and_then_a_spread, 0, CASES);
    tcase_add_loop_test(values, both_sets_of_kernels_project_the_same, 0, CASES);
    suite_add_tcase(suite, values);
    return suite;
}

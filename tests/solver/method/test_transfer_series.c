/* XPIC and FMPM against their series, by an oracle that knows shape functions and nothing of the
 * step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"
#include "suites.h"
#include "support/near.h"
#include "support/transfer_block.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>

/* The weights of all particles. */
struct weights {
    size_t particles, entries[512];
    struct mpm_stencil_entry entry[512][MPM_STENCIL_MAX];
    double mass[512], node_mass[64][64];
};

static struct weights *weights_of(const struct test_run *run, enum mpm_shape shape)
{
    struct weights *const weights = g_new0(struct weights, 1);
    double *const x = test_run_field(run, MPM_FIELD_POSITION, &weights->particles);
    double *const mass = test_run_field(run, MPM_FIELD_MASS, NULL);
    ck_assert_uint_le(weights->particles, 512);
    for (size_t p = 0; p < weights->particles; p++) {
        const struct mpm_shape_query query = {
            .shape = shape,
            .geometry = MPM_PLANE_STRAIN,
            .cell = {1.0, 0.8},
            .cells = {14, 15},
            .position = {x[2 * p], x[2 * p + 1]},
            .half_size = {0.25, 0.2},
            .deformation_gradient = {1.0, 0.0, 0.0, 1.0},
        };
        weights->mass[p] = mass[p];
        weights->entries[p] = mpm_shape_evaluate(&query, weights->entry[p]);
        for (size_t k = 0; k < weights->entries[p]; k++) {
            const struct mpm_stencil_entry *const e = &weights->entry[p][k];
            weights->node_mass[e->row][e->column] += mass[p] * e->s;
        }
    }
    free(x);
    free(mass);
    return weights;
}

/* one component of S+ v_p */
static void to_nodes(const struct weights *weights, const double *v, double node[64][64])
{
    memset(node, 0, 64 * sizeof node[0]);
    for (size_t p = 0; p < weights->particles; p++)
        for (size_t k = 0; k < weights->entries[p]; k++) {
            const struct mpm_stencil_entry *const e = &weights->entry[p][k];
            node[e->row][e->column] +=
                weights->mass[p] * e->s * v[p] / weights->node_mass[e->row][e->column];
        }
}

/* sum S v_i (along = -1) or sum G v_i */
static double at_particle(const struct weights *weights, size_t p, double node[64][64], int along)
{
    double sum = 0.0;
    for (size_t k = 0; k < weights->entries[p]; k++) {
        const struct mpm_stencil_entry *const e = &weights->entry[p][k];
        sum += (along < 0 ? e->s : e->g[along]) * node[e->row][e->column];
    }
    return sum;
}

/* w_n = sum_{j<n} (1 - S+ S)^j S+ v_p: of particle velocities (1 - S S+)^j v_p, one by one. */
static void series(const struct weights *weights, const double *v, int order, double w[64][64])
{
    double rest[512], term[64][64];
    memcpy(rest, v, weights->particles * sizeof *v);
    memset(w, 0, 64 * sizeof w[0]);
    for (int j = 0; j < order; j++) {
        to_nodes(weights, rest, term);
        for (int k = 0; k < 64 * 64; k++)
            w[k / 64][k % 64] += term[k / 64][k % 64];
        for (size_t p = 0; p < weights->particles; p++)
            rest[p] -= at_particle(weights, p, term, -1);
    }
}

/* The first step of USL has no forces, so that both position updates are the same, and updates F
 * last, with dF = 1 + dt grad v. */
START_TEST(xpic_and_fmpm_are_the_series_of_their_papers)
{
    static const double ROUND_OFF = 1e-13;
    enum { ORDER = 4 };
    const bool fmpm = _i / TEST_SHAPES == 1;
    struct settings settings = {.count = 0};
    settings_add_formatted(
        &settings,
        "method={shape: %s, stress_update: usl, deformation_terms: 1, position_update: %s, "
        "transfer: {kind: %s, order: %d}}",
        test_shapes[_i % TEST_SHAPES], _i % 2 == 0 ? "grid_velocity" : "midpoint",
        fmpm ? "fmpm" : "xpic", ORDER);
    test_add_wild_velocity(&settings, false);
    struct test_run run = block_open(&settings, 1);
    struct weights *const weights = weights_of(&run, (enum mpm_shape)(_i % TEST_SHAPES));
    double *const x0 = test_run_field(&run, MPM_FIELD_POSITION, NULL);
    double *const v0 = test_run_field(&run, MPM_FIELD_VELOCITY, NULL);
    test_run_steps(&run, 1);
    double *const x = test_run_field(&run, MPM_FIELD_POSITION, NULL);
    double *const v = test_run_field(&run, MPM_FIELD_VELOCITY, NULL);
    double *const f = test_run_field(&run, MPM_FIELD_DEFORMATION_GRADIENT, NULL);
    const double dt = mpm_simulation_time_step(run.simulation);
    for (size_t axis = 0; axis < 2; axis++) {
        double start[512] = {0.0}, w[64][64], lumped[64][64];
        for (size_t p = 0; p < weights->particles; p++)
            start[p] = v0[2 * p + axis];
        series(weights, start, ORDER, w);
        series(weights, start, 1, lumped);
        for (size_t p = 0; p < weights->particles; p++) {
            const size_t k = 2 * p + axis;
            ck_assert_near(v[k], at_particle(weights, p, w, -1), ROUND_OFF);
            ck_assert_near(x[k], x0[k] + dt * at_particle(weights, p, fmpm ? w : lumped, -1),
                           10.0 * ROUND_OFF);
            for (int along = 0; along < 2; along++)
                ck_assert_near(f[5 * p + 2 * axis + (size_t)along],
                               ((int)axis == along ? 1.0 : 0.0) +
                                   dt * at_particle(weights, p, fmpm ? w : lumped, along),
                               ROUND_OFF);
        }
    }
    free(x0);
    free(v0);
    free(x);
    free(v);
    free(f);
    g_free(weights);
    test_run_close(&run);
}
END_TEST

/* The extra nodes of planar functions at the axis, mirrored: w_r there is minus that of the node at
 * the other side, w_z their own, in every order. Domains that move inwards reach them. */
START_TEST(nodes_beyond_the_axis_mirror_every_order)
{
    static const char *const transfers[] = {"{kind: xpic, order: 2}", "{kind: xpic, order: 5}",
                                            "{kind: fmpm, order: 2}", "{kind: fmpm, order: 4}"};
    struct settings settings = {.count = 0};
    settings_add(&settings, "geometry=axisymmetric");
    settings_add(&settings, "bodies.block.region.rectangle.from=[0, 3.2]");
    block_add_method(&settings, "ugimp", "stress_update: usl, axis: planar, axis_nodes: mirrored",
                     transfers[_i]);
    settings_add(&settings, "bodies.block.velocity=['-0.3*(1+cos(z)^2)*r', '0.4*cos(r+2*z)']");
    struct test_run run = block_open(&settings, 1);
    test_run_steps(&run, 2);
    const struct mpm_state *const state = &run.simulation->state;
    const struct mpm_grid *const grid = &state->grid;
    int mirrored = 0, other_z = 0;
    for (int64_t row = state->first_row; row <= state->last_row; row++) {
        const int64_t axis = row * grid->columns + state->conditions.mirror_column;
        if (grid->mass[axis - 1] == 0.0)
            continue;
        const double *const beyond = grid->smoothed[axis - 1].acceleration;
        const double *const image = grid->smoothed[axis + 1].acceleration;
        ck_assert_double_ne(image[0], 0.0);
        ck_assert_double_eq(beyond[0], -image[0]);
        mirrored++;
        other_z += beyond[1] != image[1];
    }
    ck_assert_int_gt(mirrored, 4);
    ck_assert_int_gt(other_z, 4);
    test_run_close(&run);
}
END_TEST

Suite *suite_transfer_series(void)
{
    Suite *const suite = suite_create("transfer_series");
    TCase *const series_case = tcase_create("series");
    tcase_add_loop_test(series_case, xpic_and_fmpm_are_the_series_of_their_papers, 0,
                        2 * TEST_SHAPES);
    tcase_add_loop_test(series_case, nodes_beyond_the_axis_mirror_every_order, 0, 4);
    suite_add_tcase(suite, series_case);
    return suite;
}

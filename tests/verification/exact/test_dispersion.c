/* The dispersion of a bar on its grid: the formulas of bar_dispersion.h against a simulation of
 * the tasks of a step, and the momentum form, which has no formula, by the eigenvalues of its step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "verification/exact/waves/bar_dispersion.h"

#include <glib.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stddef.h>

/* -------------------------------------------------------------------- velocity form */

enum { CELLS = 12, PARTICLES_MAX = 4 };

/* The tasks of a step written out for a row of particles that stay where they are; nodes 0
 * and CELLS held. */
struct row {
    unsigned n; /* particles a cell */
    double velocity[CELLS * PARTICLES_MAX], strain[CELLS * PARTICLES_MAX];
};

static double place(const struct row *row, size_t p)
{
    return ((double)(p % row->n) + 0.5) / row->n;
}

static void to_nodes(const struct row *row, double v[CELLS + 1])
{
    double mass[CELLS + 1] = {0}, momentum[CELLS + 1] = {0};
    for (size_t p = 0; p < CELLS * row->n; p++) {
        const double x = place(row, p);
        const size_t i = p / row->n;
        mass[i] += 1 - x;
        mass[i + 1] += x;
        momentum[i] += (1 - x) * row->velocity[p];
        momentum[i + 1] += x * row->velocity[p];
    }
    for (size_t i = 0; i <= CELLS; i++)
        v[i] = i == 0 || i == CELLS ? 0 : momentum[i] / mass[i];
}

static void strain_by(struct row *row, const double v[CELLS + 1], double dt)
{
    for (size_t p = 0; p < CELLS * row->n; p++)
        row->strain[p] += dt * (v[p / row->n + 1] - v[p / row->n]);
}

static void advance(struct row *row, enum bar_dispersion_order order, double fraction, double dt)
{
    double v[CELLS + 1], a[CELLS + 1] = {0}, after[CELLS + 1];
    to_nodes(row, v);
    strain_by(row, v,
              order == BAR_DISPERSION_USF     ? dt
              : order == BAR_DISPERSION_USAVG ? 0.5 * dt
                                              : 0);
    for (size_t p = 0; p < CELLS * row->n; p++) {
        a[p / row->n] += row->strain[p] / row->n;
        a[p / row->n + 1] -= row->strain[p] / row->n;
    }
    a[0] = a[CELLS] = 0;
    for (size_t i = 0; i <= CELLS; i++)
        after[i] = v[i] + dt * a[i];
    for (size_t p = 0; p < CELLS * row->n; p++) {
        const double x = place(row, p);
        const size_t i = p / row->n;
        const double flip = row->velocity[p] + dt * ((1 - x) * a[i] + x * a[i + 1]);
        const double pic = (1 - x) * after[i] + x * after[i + 1];
        row->velocity[p] = fraction * flip + (1 - fraction) * pic;
    }
    if (order == BAR_DISPERSION_MUSL || order == BAR_DISPERSION_USAVG)
        to_nodes(row, after);
    strain_by(row, after,
              order == BAR_DISPERSION_USF     ? 0
              : order == BAR_DISPERSION_USAVG ? 0.5 * dt
                                              : dt);
}

/* The amplitudes of three steps in turn obey a'' = T a' - D a. */
START_TEST(the_dispersion_is_that_of_the_tasks_of_a_step)
{
    static const struct {
        unsigned particles;
        double fraction, dt;
    } cases[] = {{2, 1, 0.4}, {2, 0.9, 0.4}, {1, 1, 0.8}, {4, 0.5, 0.1}, {3, 0, 0.3}};
    for (size_t c = 0; c < sizeof cases / sizeof cases[0]; c++) {
        const enum bar_dispersion_order order = (enum bar_dispersion_order)_i;
        struct row row = {.n = cases[c].particles};
        const double k = 2 * G_PI / CELLS, dt = cases[c].dt;
        double amplitude[4], v[CELLS + 1];
        for (size_t p = 0; p < CELLS * row.n; p++) {
            const double x = place(&row, p);
            const size_t i = p / row.n;
            row.velocity[p] = (1 - x) * sin(k * (double)i) + x * sin(k * (double)(i + 1));
        }
        for (size_t s = 0; s < 4; s++) {
            to_nodes(&row, v);
            amplitude[s] = v[2];
            advance(&row, order, cases[c].fraction, dt);
        }
        const struct bar_dispersion bar = {
            order, cases[c].particles, cases[c].fraction, 1, 1, dt, 0, 0};
        const struct bar_dispersion_result result = bar_dispersion(&bar, k);
        const double radius = exp(-result.decay * dt);
        const double trace = 2 * radius * cos(result.frequency * dt);
        for (size_t s = 0; s < 2; s++)
            ck_assert_msg(fabs(amplitude[s + 2] - trace * amplitude[s + 1] +
                               radius * radius * amplitude[s]) < 1e-14,
                          "order %d, case %zu, step %zu", _i, c, s);
    }
}
END_TEST

START_TEST(fine_grids_and_steps_give_the_exact_frequency_at_second_order)
{
    for (int order = 0; order < BAR_DISPERSION_ORDERS; order++) {
        const struct bar_dispersion bar = {
            (enum bar_dispersion_order)order, 2, 1, 3, 0.01, 0.001, 0, 0};
        const double kh = 0.02;
        const double courant = 0.3, error = 1.0 / 24 + 3.0 / 32 - courant * courant / 24;
        const struct bar_dispersion_result result = bar_dispersion(&bar, kh / bar.cell);
        /* the next term is (k h)^2 of this one; for USL (1 - s) q/2 is of fourth order too */
        ck_assert_double_eq_tol(result.frequency / (3 * kh / bar.cell), 1 - kh * kh * error, 1e-7);
    }
}
END_TEST

/* The bar of case E3: 32 cells a wavelength, 80 steps a period. Its bands rest on these. */
START_TEST(the_numbers_that_case_e3_states_are_those_of_the_theory)
{
    static const struct {
        enum bar_dispersion_order order;
        double fraction, frequency, decay; /* % of the exact frequency, % a period */
    } stated[] = {
        {BAR_DISPERSION_USAVG, 1, -0.49559, 0},
        {BAR_DISPERSION_MUSL, 1, -0.49559, 0},
        {BAR_DISPERSION_USF, 1, -0.49559, 0},
        {BAR_DISPERSION_USL, 1, -0.49449, 0.17722},
        {BAR_DISPERSION_USAVG, 0.99, -0.4938, 0.28824},
        {BAR_DISPERSION_MUSL, 0.99, -0.4938, 0.28824},
    };
    for (size_t k = 0; k < sizeof stated / sizeof stated[0]; k++) {
        const struct bar_dispersion bar = {stated[k].order, 2, stated[k].fraction, 1, 1, 0.4, 0, 0};
        const struct bar_dispersion_result result = bar_dispersion(&bar, G_PI / 16);
        ck_assert_double_eq_tol(100 * (result.frequency / (G_PI / 16) - 1), stated[k].frequency,
                                1e-5);
        ck_assert_double_eq_tol(100 * 32 * result.decay, stated[k].decay, 1e-5);
    }
}
END_TEST

/* -------------------------------------------------------------------- momentum form */

/* A bar of `cells` cells of width 1 held at both ends, two particles a cell, M = rho = 1: weights
 * of particles at each node, and how the form takes a field of the nodes to the particles. */
enum { CELL_PARTICLES = 2, HELD_GRIDS = 4 }; /* 8, 16, 32 and 64 cells */
static const double COURANT = 0.4, PARTICLE_VOLUME = 1.0 / CELL_PARTICLES;

struct particle_weights {
    double s[2], g[2]; /* S and its gradient, at the node before the particle and behind it */
};

static struct particle_weights particle_weights(size_t p)
{
    const double x = ((double)(p % CELL_PARTICLES) + 0.5) / CELL_PARTICLES;
    return (struct particle_weights){{1.0 - x, x}, {-1.0, 1.0}};
}

/* Half of that of the others at the ends, where there is a cell at one side only. */
static double node_mass(size_t node, size_t cells)
{
    return node == 0 || node == cells ? 0.5 : 1.0;
}

/* What takes nodal velocities to a particle: S and G, or in the momentum form, which divides by
 * the particle's share of the nodes' masses (equation 67), S m / sum S m and G m / sum S m. */
static struct particle_weights from_nodes(size_t p, size_t cells, bool momentum)
{
    struct particle_weights w = particle_weights(p);
    if (!momentum)
        return w;
    const size_t node = p / CELL_PARTICLES;
    const double m[2] = {node_mass(node, cells), node_mass(node + 1, cells)};
    const double mass = w.s[0] * m[0] + w.s[1] * m[1];
    for (int side = 0; side < 2; side++) {
        w.s[side] *= m[side] / mass;
        w.g[side] *= m[side] / mass;
    }
    return w;
}

/* One step takes free nodes' displacements u by u'' = -T K u: K their forces over masses, with
 * the strains of the particles, T the way of an acceleration to the particles and back. */
static void add_particle(gsl_matrix *t, gsl_matrix *k, size_t p, size_t cells, bool momentum)
{
    const struct particle_weights to = particle_weights(p), from = from_nodes(p, cells, momentum);
    const size_t node = p / CELL_PARTICLES;
    for (size_t row = 0; row < 2; row++)
        for (size_t column = 0; column < 2; column++) {
            const size_t i = node + row, j = node + column;
            if (i == 0 || i == cells || j == 0 || j == cells)
                continue;
            const double volume = PARTICLE_VOLUME / node_mass(i, cells);
            *gsl_matrix_ptr(t, i - 1, j - 1) += volume * to.s[row] * from.s[column];
            *gsl_matrix_ptr(k, i - 1, j - 1) += volume * to.g[row] * from.g[column];
        }
}

/* The smallest eigenvalue of T K, which is not symmetric; all of them are real. */
static double lowest_eigenvalue(size_t cells, bool momentum)
{
    const size_t free_nodes = cells - 1;
    gsl_matrix *const t = gsl_matrix_calloc(free_nodes, free_nodes);
    gsl_matrix *const k = gsl_matrix_calloc(free_nodes, free_nodes);
    gsl_matrix *const step = gsl_matrix_calloc(free_nodes, free_nodes);
    gsl_vector_complex *const values = gsl_vector_complex_alloc(free_nodes);
    gsl_eigen_nonsymm_workspace *const work = gsl_eigen_nonsymm_alloc(free_nodes);
    for (size_t p = 0; p < CELL_PARTICLES * cells; p++)
        add_particle(t, k, p, cells, momentum);
    gsl_blas_dgemm(CblasNoTrans, CblasNoTrans, 1.0, t, k, 0.0, step);
    ck_assert_int_eq(gsl_eigen_nonsymm(step, values, work), 0);
    double lowest = HUGE_VAL;
    for (size_t n = 0; n < free_nodes; n++) {
        const gsl_complex value = gsl_vector_complex_get(values, n);
        ck_assert_near(GSL_IMAG(value), 0.0, 1e-12);
        lowest = fmin(lowest, GSL_REAL(value));
    }
    gsl_eigen_nonsymm_free(work);
    gsl_vector_complex_free(values);
    gsl_matrix_free(step);
    gsl_matrix_free(k);
    gsl_matrix_free(t);
    return lowest;
}

/* In %, of the first mode, pi c over the length of the bar, by central steps. */
static double frequency_error(size_t cells, bool momentum)
{
    const double root = sqrt(lowest_eigenvalue(cells, momentum));
    const double frequency = 2.0 / COURANT * asin(0.5 * root * COURANT);
    return 100.0 * (frequency / (G_PI / (double)cells) - 1.0);
}

/* An eigenvalue of (pi/64)^2 = 2e-3 with the round-off of the largest, 4 times n eps: 1e-11, 1e-9
 * in %. */
START_TEST(the_velocity_form_of_a_held_bar_has_the_frequency_of_its_dispersion)
{
    const size_t cells = (size_t)8 << _i;
    const struct bar_dispersion bar = {
        BAR_DISPERSION_USAVG, CELL_PARTICLES, 1, 1, 1, COURANT, 0, 0};
    const double k = G_PI / (double)cells;
    const double stated = 100.0 * (bar_dispersion(&bar, k).frequency / k - 1.0);
    static const double ROUND_OFF_PERCENT = 1e-9;
    ck_assert_near(frequency_error(cells, false), stated, ROUND_OFF_PERCENT);
}
END_TEST

/* The bar of case E3 on its four grids: the bands of the momentum form rest on these. */
START_TEST(the_momentum_form_of_a_held_bar_has_the_frequency_that_case_e3_states)
{
    static const double STATED[] = {5.021946, 2.976008, 1.593811, 0.822062};
    static const double LAST_DIGIT = 5.1e-7;
    ck_assert_near(frequency_error((size_t)8 << _i, true), STATED[_i], LAST_DIGIT);
}
END_TEST

START_TEST(the_momentum_form_is_too_stiff_beside_a_held_end_and_nowhere_else)
{
    static const double FACTOR[] = {8.0 / 5.0, 8.0 / 7.0, 1.0, 1.0};
    enum { NEAR = sizeof FACTOR / sizeof FACTOR[0] };
    const size_t cells = 16;
    for (size_t p = 0; p < NEAR; p++) {
        ck_assert_near(from_nodes(p, cells, true).g[1], FACTOR[p], 1e-15);
        ck_assert_near(from_nodes(CELL_PARTICLES * cells - 1 - p, cells, true).g[0], -FACTOR[p],
                       1e-15);
    }
}
END_TEST

Suite *suite_dispersion(void)
{
    Suite *const suite = suite_create("dispersion");
    TCase *const velocity = tcase_create("velocity form"), *const held = tcase_create("held bar");
    tcase_add_loop_test(velocity, the_dispersion_is_that_of_the_tasks_of_a_step, 0,
                        BAR_DISPERSION_ORDERS);
    tcase_add_test(velocity, fine_grids_and_steps_give_the_exact_frequency_at_second_order);
    tcase_add_test(velocity, the_numbers_that_case_e3_states_are_those_of_the_theory);
    suite_add_tcase(suite, velocity);
    tcase_add_loop_test(held, the_velocity_form_of_a_held_bar_has_the_frequency_of_its_dispersion,
                        0, HELD_GRIDS);
    tcase_add_loop_test(held, the_momentum_form_of_a_held_bar_has_the_frequency_that_case_e3_states,
                        0, HELD_GRIDS);
    tcase_add_test(held, the_momentum_form_is_too_stiff_beside_a_held_end_and_nowhere_else);
    suite_add_tcase(suite, held);
    return suite;
}

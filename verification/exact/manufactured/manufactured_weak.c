/* The weak form and the edges: what a field must satisfy, without derivatives of P.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/manufactured/manufactured_sample.h"

#include <gsl/gsl_integration.h>

/* Gauss points along each axis, and test functions: monomials of X/L and Y/L, each in either
 * component; in axisymmetry w_r has X in it, so that w_r / R is finite. */
enum { POINTS = 64, MONOMIALS = 6, TESTS = 2 * MONOMIALS, TERMS = 3 };
static const int exponents[MONOMIALS][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 1}, {1, 3}, {4, 2}};

/* A test function at a place: its component, value and gradient. */
struct test_function {
    int component;
    double value, gradient[2], over_radius;
};

/* x^n and its derivative */
static double power(double x, int n, double *slope)
{
    *slope = n == 0 ? 0.0 : n * pow(x, n - 1);
    return pow(x, n);
}

static struct test_function test_at(const struct manufactured_problem *problem, int number,
                                    const double place[2])
{
    const double length = problem->domain.high[0];
    const int component = number / MONOMIALS;
    const bool radial = problem->geometry == MPM_AXISYMMETRIC && component == 0;
    const int *const n = exponents[number % MONOMIALS];
    const double x = place[0] / length, y = place[1] / length;
    double slope[2];
    const double of_x = power(x, n[0] + radial, &slope[0]), of_y = power(y, n[1], &slope[1]);
    return (struct test_function){
        .component = component,
        .value = of_x * of_y,
        .gradient = {slope[0] * of_y / length, of_x * slope[1] / length},
        .over_radius = radial ? pow(x, n[0]) * of_y / length : 0.0,
    };
}

/* P : Grad w, rho0 (a - b) . w, and P N . w over an edge */
struct weak_sums {
    double term[TESTS][TERMS], size[TESTS][TERMS];
};

static void add(struct weak_sums *sums, int test, int term, double value)
{
    sums->term[test][term] += value;
    sums->size[test][term] += fabs(value);
}

static void add_inside(const struct manufactured_problem *problem, double time,
                       const double place[2], double weight, struct weak_sums *sums)
{
    struct manufactured_state state;
    manufactured_evaluate(problem, place, time, &state);
    for (int test = 0; test < TESTS; test++) {
        const struct test_function w = test_at(problem, test, place);
        const double *const p = &state.nominal[2 * w.component];
        const double inertia =
            problem->density * (state.acceleration[w.component] - state.body_force[w.component]);
        add(sums, test, 0,
            weight *
                (p[0] * w.gradient[0] + p[1] * w.gradient[1] + state.nominal[4] * w.over_radius));
        add(sums, test, 1, weight * inertia * w.value);
    }
}

static void add_edge(const struct manufactured_problem *problem, double time, const double place[2],
                     const double normal[2], double weight, struct weak_sums *sums)
{
    struct manufactured_state state;
    manufactured_evaluate(problem, place, time, &state);
    for (int test = 0; test < TESTS; test++) {
        const struct test_function w = test_at(problem, test, place);
        const double *const p = &state.nominal[2 * w.component];
        add(sums, test, 2, -weight * (p[0] * normal[0] + p[1] * normal[1]) * w.value);
    }
}

static double worst(const struct weak_sums *sums)
{
    double residual = 0.0, size = 0.0;
    for (int test = 0; test < TESTS; test++) {
        const double *const term = sums->term[test];
        residual = fmax(residual, fabs(term[0] + term[1] + term[2]));
        for (int k = 0; k < TERMS; k++)
            size = fmax(size, sums->size[test][k]);
    }
    return residual / size;
}

double manufactured_weak_residual(const struct manufactured_problem *problem, double time)
{
    gsl_integration_glfixed_table *const table = gsl_integration_glfixed_table_alloc(POINTS);
    struct weak_sums sums = {0};
    if (table == NULL)
        return (double)NAN;
    for (size_t i = 0; i < POINTS; i++) {
        double part[2], weight[2], place[2], normal[2];
        (void)gsl_integration_glfixed_point(0.0, 1.0, i, &part[0], &weight[0], table);
        for (int edge = 0; edge < MANUFACTURED_EDGES; edge++) {
            const double length = manufactured_edge_place(problem, (enum manufactured_edge)edge,
                                                          part[0], place, normal);
            add_edge(problem, time, place, normal, length * weight[0], &sums);
        }
        for (size_t j = 0; j < POINTS; j++) {
            (void)gsl_integration_glfixed_point(0.0, 1.0, j, &part[1], &weight[1], table);
            const double area = manufactured_place(problem, part, place);
            add_inside(problem, time, place, area * weight[0] * weight[1], &sums);
        }
    }
    gsl_integration_glfixed_table_free(table);
    return worst(&sums);
}

/* -------------------------------------------------------------------- edges */

enum { SAMPLES = 32 };

static double largest_of(const double *values, int count)
{
    double largest = 0.0;
    for (int k = 0; k < count; k++)
        largest = fmax(largest, fabs(values[k]));
    return largest;
}

static void edge_left(const struct manufactured_state *state, const double n[2], unsigned flags,
                      struct manufactured_edges_left *left)
{
    const double *const p = state->nominal, *const u = state->displacement;
    const double traction[2] = {p[0] * n[0] + p[1] * n[1], p[2] * n[0] + p[3] * n[1]};
    const double along[2] = {fabs(u[0] * n[0] + u[1] * n[1]), fabs(u[1] * n[0] - u[0] * n[1])};
    const double pull[2] = {fabs(traction[0] * n[0] + traction[1] * n[1]),
                            fabs(traction[1] * n[0] - traction[0] * n[1])};
    if (flags & MANUFACTURED_HELD_NORMAL)
        left->displacement = fmax(left->displacement, along[0]);
    if (flags & MANUFACTURED_HELD_TANGENT)
        left->displacement = fmax(left->displacement, along[1]);
    if (flags & MANUFACTURED_FREE_NORMAL)
        left->traction = fmax(left->traction, pull[0]);
    if (flags & MANUFACTURED_FREE_TANGENT)
        left->traction = fmax(left->traction, pull[1]);
}

void manufactured_edges(const struct manufactured_problem *problem, double time,
                        struct manufactured_edges_left *left)
{
    struct manufactured_state state;
    double place[2], normal[2], displacement = 0.0, stress = 0.0;
    *left = (struct manufactured_edges_left){0};
    for (int i = 0; i <= SAMPLES; i++) {
        for (int edge = 0; edge < MANUFACTURED_EDGES; edge++) {
            (void)manufactured_edge_place(problem, (enum manufactured_edge)edge,
                                          (double)i / SAMPLES, place, normal);
            manufactured_evaluate(problem, place, time, &state);
            edge_left(&state, normal, problem->edge[edge], left);
        }
        for (int j = 0; j <= SAMPLES; j++) {
            const double part[2] = {(double)i / SAMPLES, (double)j / SAMPLES};
            (void)manufactured_place(problem, part, place);
            manufactured_evaluate(problem, place, time, &state);
            displacement = fmax(displacement, largest_of(state.displacement, 2));
            stress = fmax(stress, largest_of(state.nominal, 5));
        }
    }
    left->displacement /= displacement;
    left->traction /= stress;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/stretched_column.h"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <string.h>

enum { MAX = STRETCHED_PARTICLES_MAX, NODES = MAX + 3, STATE = 3 };

static const struct {
    double before, after;
    bool extrapolated;
} orders[] = {
    [STRETCHED_USL] = {0.0, 1.0, false},        [STRETCHED_MUSL] = {0.0, 1.0, true},
    [STRETCHED_USF] = {1.0, 0.0, false},        [STRETCHED_USAVG] = {0.5, 0.5, true},
    [STRETCHED_USAVG_ONCE] = {0.5, 0.5, false},
};

/* Hat functions of the two nodes below and above one end of a domain. */
struct end {
    size_t node; /* the lower one */
    double n[2], slope[2];
};

struct chain {
    const struct stretched_column *column;
    double dt;
    struct end ends[MAX + 1]; /* p and p + 1 are those of particle p */
    double inverse_mass[NODES];
};

/* Fields of the nodes. */
struct nodes {
    double value[NODES];
};

static struct end end_at(double place)
{
    const double below = floor(place), part = place - below;
    return (struct end){(size_t)below, {1.0 - part, part}, {-1.0, 1.0}};
}

static void add(struct nodes *nodes, const struct end *end, const double weight[2], double value)
{
    nodes->value[end->node] += weight[0] * value;
    nodes->value[end->node + 1] += weight[1] * value;
}

static double at(const struct nodes *nodes, const struct end *end)
{
    return end->n[0] * nodes->value[end->node] + end->n[1] * nodes->value[end->node + 1];
}

/* S_p v and G_p v */
static double mean(const struct chain *chain, const struct nodes *nodes, size_t p)
{
    return 0.5 * (at(nodes, &chain->ends[p]) + at(nodes, &chain->ends[p + 1]));
}

static double gradient(const struct chain *chain, const struct nodes *nodes, size_t p)
{
    return (at(nodes, &chain->ends[p + 1]) - at(nodes, &chain->ends[p])) / chain->column->length;
}

/* sum_p S_ip value_p, by the lower and upper ends' halves */
static struct nodes gather(const struct chain *chain, const double *value, double factor)
{
    struct nodes sum = {{0.0}};
    for (size_t p = 0; p < chain->column->particles; p++)
        for (size_t side = 0; side < 2; side++)
            add(&sum, &chain->ends[p + side], chain->ends[p + side].n, 0.5 * factor * value[p]);
    return sum;
}

static struct nodes velocity(const struct chain *chain, const double *v)
{
    const double mass = chain->column->density * chain->column->length;
    struct nodes nodes = gather(chain, v, mass);
    for (size_t i = 0; i < NODES; i++)
        nodes.value[i] *= chain->inverse_mass[i];
    return nodes;
}

/* Node 0 is held: its inverse mass is zero. */
static void find_masses(struct chain *chain)
{
    double ones[MAX];
    for (size_t p = 0; p < MAX; p++)
        ones[p] = 1.0;
    const struct nodes mass = gather(chain, ones, chain->column->density * chain->column->length);
    for (size_t i = 0; i < NODES; i++)
        chain->inverse_mass[i] = i > 0 && mass.value[i] > 0.0 ? 1.0 / mass.value[i] : 0.0;
}

/* `e_now` strains the material, `e_start` the domains. */
static struct nodes acceleration(const struct chain *chain, const double *xi, const double *e_now,
                                 const double *e_start)
{
    const struct stretched_column *const c = chain->column;
    struct nodes a = {{0.0}};
    for (size_t p = 0; p < c->particles; p++) {
        const double pull = c->tangent * e_now[p] + c->stress * (e_now[p] - e_start[p]);
        for (size_t side = 0; side < 2; side++) {
            const double sign = side == 0 ? 1.0 : -1.0;
            const double moved = xi[p] - sign * 0.5 * c->length * e_start[p];
            add(&a, &chain->ends[p + side], chain->ends[p + side].n, sign * pull);
            add(&a, &chain->ends[p + side], chain->ends[p + side].slope, sign * c->stress * moved);
        }
    }
    const size_t last = c->particles - 1;
    add(&a, &chain->ends[last + 1], chain->ends[last + 1].slope,
        c->stress * (xi[last] + 0.5 * c->length * e_start[last]));
    for (size_t i = 0; i < NODES; i++)
        a.value[i] *= chain->inverse_mass[i];
    return a;
}

static struct nodes sum_of(double a, const struct nodes *x, double b, const struct nodes *y)
{
    struct nodes sum;
    for (size_t i = 0; i < NODES; i++)
        sum.value[i] = a * x->value[i] + b * y->value[i];
    return sum;
}

/* state: xi, v, e of all particles */
static void take_step(const struct chain *chain, double *state)
{
    const struct stretched_column *const c = chain->column;
    const size_t n = c->particles;
    const double dt = chain->dt, before = orders[c->order].before, after = orders[c->order].after;
    double *const xi = state, *const v = state + n, *const e = state + 2 * n;
    double e_start[MAX];
    memcpy(e_start, e, n * sizeof *e);
    const struct nodes start = velocity(chain, v);
    for (size_t p = 0; p < n; p++)
        e[p] += before * dt * gradient(chain, &start, p);
    const struct nodes a = acceleration(chain, xi, e, e_start);
    for (size_t p = 0; p < n; p++)
        v[p] += dt * mean(chain, &a, p) - (1.0 - c->fraction) * (v[p] - mean(chain, &start, p));
    const struct nodes end = sum_of(1.0, &start, dt, &a);
    const struct nodes of_strain = orders[c->order].extrapolated ? velocity(chain, v) : end;
    const struct nodes moves[] = {
        [STRETCHED_GRID_VELOCITY] = end,
        [STRETCHED_MIDPOINT] = sum_of(1.0, &start, 0.5 * dt, &a),
        [STRETCHED_STRAIN_VELOCITY] = sum_of(before, &start, after, &of_strain),
    };
    for (size_t p = 0; p < n; p++) {
        e[p] += after * dt * gradient(chain, &of_strain, p);
        xi[p] += dt * mean(chain, &moves[c->position], p);
    }
}

static void fill_matrix(const struct chain *chain, gsl_matrix *matrix)
{
    const size_t size = STATE * chain->column->particles;
    for (size_t column = 0; column < size; column++) {
        double state[STATE * MAX] = {0.0};
        state[column] = 1.0;
        take_step(chain, state);
        for (size_t row = 0; row < size; row++)
            gsl_matrix_set(matrix, row, column, state[row]);
    }
}

static double largest_modulus(const struct chain *chain)
{
    const size_t size = STATE * chain->column->particles;
    gsl_matrix *const matrix = gsl_matrix_alloc(size, size);
    gsl_vector_complex *const values = gsl_vector_complex_alloc(size);
    gsl_eigen_nonsymm_workspace *const workspace = gsl_eigen_nonsymm_alloc(size);
    double largest = (double)NAN;
    if (matrix != NULL && values != NULL && workspace != NULL) {
        fill_matrix(chain, matrix);
        if (gsl_eigen_nonsymm(matrix, values, workspace) == 0)
            largest = 0.0;
    }
    for (size_t k = 0; largest >= 0.0 && k < size; k++)
        largest = fmax(largest, gsl_complex_abs(gsl_vector_complex_get(values, k)));
    gsl_eigen_nonsymm_free(workspace);
    gsl_vector_complex_free(values);
    gsl_matrix_free(matrix);
    return largest;
}

double stretched_column_rate(const struct stretched_column *column, double time_step)
{
    const double height = (double)column->particles * column->length;
    if (column->particles < 2 || column->particles > MAX || !(column->length > 0.0) ||
        !(height < MAX) || !(time_step > 0.0))
        return (double)NAN;
    struct chain chain = {.column = column, .dt = time_step};
    for (size_t p = 0; p <= column->particles; p++)
        chain.ends[p] = end_at((double)p * column->length);
    find_masses(&chain);
    return log(largest_modulus(&chain)) / time_step;
}

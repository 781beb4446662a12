/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/waves/linear_step.h"

#include <complex.h>
#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_eigen.h>
#include <math.h>

static const double PI = 3.14159265358979323846;

enum { REACH = 4, MAX = LINEAR_PARTICLES_MAX, STATE = 2 * MAX };

/* ------------------------------------------------------- functions of a node at 0 */

struct weight {
    double s, g;
};

static double hat(double x)
{
    return fmax(0.0, 1.0 - fabs(x));
}

/* Integral of the hat from minus infinity. */
static double hat_integral(double x)
{
    if (x <= 0.0)
        return x <= -1.0 ? 0.0 : 0.5 * (1.0 + x) * (1.0 + x);
    return 1.0 - hat_integral(-x);
}

static struct weight weight_classic(double x, double half)
{
    (void)half;
    return (struct weight){hat(x), fabs(x) >= 1.0 ? 0.0 : x > 0.0 ? -1.0 : 1.0};
}

static struct weight weight_ugimp(double x, double half)
{
    return (struct weight){(hat_integral(x + half) - hat_integral(x - half)) / (2.0 * half),
                           (hat(x + half) - hat(x - half)) / (2.0 * half)};
}

static struct weight weight_bspline2(double x, double half)
{
    (void)half;
    const double distance = fabs(x), rest = fmax(0.0, 1.5 - distance);
    if (distance < 0.5)
        return (struct weight){0.75 - x * x, -2.0 * x};
    return (struct weight){0.5 * rest * rest, copysign(rest, -x)};
}

static struct weight weight_bspline3(double x, double half)
{
    (void)half;
    const double distance = fabs(x), rest = fmax(0.0, 2.0 - distance);
    if (distance < 1.0)
        return (struct weight){2.0 / 3.0 - x * x * (1.0 - 0.5 * distance),
                               x * (1.5 * distance - 2.0)};
    return (struct weight){rest * rest * rest / 6.0, copysign(0.5 * rest * rest, -x)};
}

static struct weight (*const weights[])(double x, double half) = {
    [LINEAR_CLASSIC] = weight_classic,
    [LINEAR_UGIMP] = weight_ugimp,
    [LINEAR_BSPLINE2] = weight_bspline2,
    [LINEAR_BSPLINE3] = weight_bspline3,
};

/* ---------------------------------------------------------------------- one step */

/* Parts of a step with strains updated, as multiples of C. */
static const struct {
    double before;     /* with the velocity of the start */
    double after;      /* after the momentum update, */
    bool extrapolated; /* with the velocity extrapolated again */
} orders[] = {
    [LINEAR_USL] = {0.0, 1.0, false},
    [LINEAR_MUSL] = {0.0, 1.0, true},
    [LINEAR_USF] = {1.0, 0.0, false},
    [LINEAR_USAVG] = {0.5, 0.5, true},
};

struct wave {
    size_t n;
    double complex s[MAX], g[MAX];
};

static struct wave wave_of(const struct linear_row *row, double theta)
{
    struct wave wave = {.n = row->particles};
    const double spacing = 1.0 / (double)row->particles;
    for (size_t p = 0; p < row->particles; p++)
        for (int node = -REACH; node <= REACH; node++) {
            const double place = ((double)p + 0.5) * spacing + row->offset;
            const struct weight weight = weights[row->shape](place - node, 0.5 * spacing);
            const double complex phase = cexp((double complex)I * (theta * node));
            wave.s[p] += weight.s * phase;
            wave.g[p] += weight.g * phase;
        }
    return wave;
}

/* sum_p conj(weight_p) value_p / n */
static double complex gather(const struct wave *wave, const double complex *weight,
                             const double complex *value)
{
    double complex sum = 0.0;
    for (size_t p = 0; p < wave->n; p++)
        sum += conj(weight[p]) * value[p];
    return sum / (double)wave->n;
}

/* state: v_p, then e_p */
static void take_step(const struct wave *wave, enum linear_order order, double courant,
                      double complex state[STATE])
{
    const size_t n = wave->n;
    double complex *const velocity = state, *const strain = state + n;
    const double complex start = gather(wave, wave->s, velocity);
    for (size_t p = 0; p < n; p++)
        strain[p] += orders[order].before * courant * wave->g[p] * start;
    const double complex acceleration = -gather(wave, wave->g, strain);
    for (size_t p = 0; p < n; p++)
        velocity[p] += courant * wave->s[p] * acceleration;
    const double complex end = orders[order].extrapolated ? gather(wave, wave->s, velocity)
                                                          : start + courant * acceleration;
    for (size_t p = 0; p < n; p++)
        strain[p] += orders[order].after * courant * wave->g[p] * end;
}

/* ------------------------------------------------------------------- eigenvalues */

/* The complex matrix A + iB has, as the real one [A -B; B A], its eigenvalues and their
 * conjugates. */
static void fill_matrix(const struct wave *wave, enum linear_order order, double courant,
                        gsl_matrix *matrix)
{
    const size_t size = 2 * wave->n;
    for (size_t column = 0; column < size; column++) {
        double complex state[STATE] = {0};
        state[column] = 1.0;
        take_step(wave, order, courant, state);
        for (size_t row = 0; row < size; row++) {
            gsl_matrix_set(matrix, row, column, creal(state[row]));
            gsl_matrix_set(matrix, row, column + size, -cimag(state[row]));
            gsl_matrix_set(matrix, row + size, column, cimag(state[row]));
            gsl_matrix_set(matrix, row + size, column + size, creal(state[row]));
        }
    }
}

static double largest_modulus(gsl_matrix *matrix, gsl_vector_complex *values,
                              gsl_eigen_nonsymm_workspace *workspace)
{
    if (gsl_eigen_nonsymm(matrix, values, workspace) != 0)
        return (double)NAN;
    double largest = 0.0;
    for (size_t k = 0; k < values->size; k++)
        largest = fmax(largest, gsl_complex_abs(gsl_vector_complex_get(values, k)));
    return largest;
}

double linear_step_growth(const struct linear_row *row, double courant, double theta)
{
    const struct wave wave = wave_of(row, theta);
    const size_t size = 4 * wave.n;
    gsl_matrix *const matrix = gsl_matrix_alloc(size, size);
    gsl_vector_complex *const values = gsl_vector_complex_alloc(size);
    gsl_eigen_nonsymm_workspace *const workspace = gsl_eigen_nonsymm_alloc(size);
    double growth = (double)NAN;
    if (matrix != NULL && values != NULL && workspace != NULL) {
        fill_matrix(&wave, row->order, courant, matrix);
        growth = largest_modulus(matrix, values, workspace);
    }
    gsl_eigen_nonsymm_free(workspace);
    gsl_vector_complex_free(values);
    gsl_matrix_free(matrix);
    return growth;
}

static bool is_stable(const struct linear_row *row, int cells, double courant)
{
    static const double NOISE = 1e-6;
    for (int k = 1; k < cells; k++)
        if (!(linear_step_growth(row, courant, PI * k / cells) <= 1.0 + NOISE))
            return false;
    return true;
}

double linear_step_limit(const struct linear_row *row, int cells)
{
    static const double SMALLEST = 0.01, LARGEST = 10.0, STRIDE = 1.05, PRECISION = 1e-4;
    double stable = 0.0, unstable = SMALLEST;
    while (unstable < LARGEST && is_stable(row, cells, unstable)) {
        stable = unstable;
        unstable *= STRIDE;
    }
    if (unstable >= LARGEST)
        return (double)INFINITY;
    while (stable > 0.0 && unstable - stable > PRECISION * stable) {
        const double middle = 0.5 * (stable + unstable);
        *(is_stable(row, cells, middle) ? &stable : &unstable) = middle;
    }
    return stable;
}

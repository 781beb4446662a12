/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/waves/damped_bar.h"

#include <complex.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

enum { MODES = 12, ITERATIONS = 50 };
static const double PI = 3.14159265358979323846;

/* The unit, in double precision */
#define IMAGINARY ((double complex)I)

static double rate_at(const struct damped_bar *bar, double place)
{
    switch (bar->profile) {
    case DAMPED_BAR_COSINE:
        return bar->rate * (1.0 - cos(2.0 * PI * place / bar->length));
    case DAMPED_BAR_BAND:
        return fabs(place - 0.5 * bar->length) < bar->width ? bar->rate : 0.0;
    case DAMPED_BAR_UNIFORM:
    case DAMPED_BAR_PROFILES:
    default:
        return bar->rate;
    }
}

/* ------------------------------------------------------------------ the bar */

/* l from l^2 + a' l + w_1^2 - rest = 0, with the continued fraction of the last l in `rest`. */
static double complex next_root(const struct damped_bar *bar, double complex l)
{
    const double a = bar->rate, w = PI / bar->length * bar->speed;
    const bool varying = bar->profile == DAMPED_BAR_COSINE;
    const double complex link = 0.5 * a * l;
    double complex rest = 0.0;
    for (int n = 2 * MODES + 1; varying && n >= 3; n -= 2)
        rest = link * link / (l * l + (double)(n * n) * w * w + a * l - rest);
    const double own = varying ? 1.5 * a : a;
    return -0.5 * own + IMAGINARY * csqrt(w * w - rest - 0.25 * own * own);
}

struct bar_dispersion_result damped_bar_mode(const struct damped_bar *bar)
{
    double complex l = IMAGINARY * (PI / bar->length * bar->speed), last = 0.0;
    for (int k = 0; k < ITERATIONS && cabs(l - last) > 1e-15 * cabs(l); k++) {
        last = l;
        l = next_root(bar, l);
    }
    if (cabs(l - last) > 1e-13 * cabs(l) || bar->profile == DAMPED_BAR_BAND)
        return (struct bar_dispersion_result){(double)NAN, (double)NAN};
    return (struct bar_dispersion_result){.frequency = cimag(l), .decay = -creal(l)};
}

/* ----------------------------------------------------------------- the grid */

/* Sums over the particles: of what node i gets of alpha v by them, times v_i. */
struct sums {
    double read;   /* sum_i v_i sum_p S_ip u_p */
    double square; /* sum_i v_i^2 m_i, m_i of the same weights */
};

static void add_particle(const struct damped_bar *bar, enum damped_bar_form form, double left,
                         double cell, double x, struct sums *sums)
{
    const double k = PI / bar->length, weight[2] = {1.0 - x, x};
    const double place[2] = {left, left + cell};
    const double v[2] = {sin(k * place[0]), sin(k * place[1])};
    double u = 0.0;
    for (size_t i = 0; i < 2; i++)
        u += weight[i] * v[i] * (form == DAMPED_BAR_PARTICLE_RATE ? 1.0 : rate_at(bar, place[i]));
    if (form == DAMPED_BAR_PARTICLE_RATE)
        u *= rate_at(bar, left + x * cell);
    for (size_t i = 0; i < 2; i++) {
        sums->read += weight[i] * v[i] * u;
        sums->square += weight[i] * v[i] * v[i];
    }
}

/* sum alpha(x_i) v_i^2 / sum v_i^2 */
static double on_grid(const struct damped_bar *bar, double cell)
{
    double damped = 0.0, square = 0.0;
    for (double x = cell; x < bar->length - 0.5 * cell; x += cell) {
        const double v = sin(PI * x / bar->length);
        damped += rate_at(bar, x) * v * v;
        square += v * v;
    }
    return damped / square;
}

void damped_bar_set_drag(const struct damped_bar *bar, enum damped_bar_form form,
                         struct bar_dispersion *grid)
{
    struct sums sums = {0.0, 0.0};
    grid->drag_end = form == DAMPED_BAR_NODES ? on_grid(bar, grid->cell) : 0.0;
    if (form == DAMPED_BAR_OWN) {
        grid->drag = bar->profile == DAMPED_BAR_UNIFORM ? bar->rate : (double)NAN;
        return;
    }
    for (double left = 0.0; left < bar->length - 0.5 * grid->cell; left += grid->cell)
        for (unsigned p = 0; p < grid->particles; p++)
            add_particle(bar, form, left, grid->cell, (p + 0.5) / grid->particles, &sums);
    grid->drag = sums.read / sums.square;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/oscillation.h"

#include <math.h>

static const double TWO_PI = 6.28318530717958647692;

enum { UNKNOWNS = 4, COS = 0, SIN = 1, FREQUENCY = 2, DECAY = 3, ROUNDS = 12, SAMPLES_LEAST = 8 };

struct samples {
    size_t count;
    const double *time, *value;
};

/* The model and its derivatives; times from the first sample of the window, so that the
 * exponential stays of order one where amplitude is. */
static double model(const double p[UNKNOWNS], double t, double slope[UNKNOWNS])
{
    const double fading = exp(-p[DECAY] * t);
    const double c = fading * cos(p[FREQUENCY] * t), s = fading * sin(p[FREQUENCY] * t);
    const double y = p[COS] * c + p[SIN] * s;
    slope[COS] = c;
    slope[SIN] = s;
    slope[FREQUENCY] = t * (p[SIN] * c - p[COS] * s);
    slope[DECAY] = -t * y;
    return y;
}

/* Solves the first n rows and columns of a symmetric positive system by elimination;
 * the result replaces `right`. */
static bool solve(size_t n, double matrix[UNKNOWNS][UNKNOWNS], double right[UNKNOWNS])
{
    for (size_t k = 0; k < n; k++) {
        if (!(matrix[k][k] > 0.0))
            return false;
        for (size_t i = k + 1; i < n; i++) {
            const double factor = matrix[i][k] / matrix[k][k];
            for (size_t j = k; j < n; j++)
                matrix[i][j] -= factor * matrix[k][j];
            right[i] -= factor * right[k];
        }
    }
    for (size_t k = n; k-- > 0;) {
        for (size_t j = k + 1; j < n; j++)
            right[k] -= matrix[k][j] * right[j];
        right[k] /= matrix[k][k];
    }
    return true;
}

/* One Gauss-Newton step in the first n unknowns (two: amplitudes alone, which are linear). */
static bool improve(const struct samples *samples, size_t n, double p[UNKNOWNS])
{
    double matrix[UNKNOWNS][UNKNOWNS] = {{0}}, right[UNKNOWNS] = {0}, slope[UNKNOWNS];
    for (size_t k = 0; k < samples->count; k++) {
        const double rest =
            samples->value[k] - model(p, samples->time[k] - samples->time[0], slope);
        for (size_t i = 0; i < n; i++) {
            right[i] += slope[i] * rest;
            for (size_t j = 0; j < n; j++)
                matrix[i][j] += slope[i] * slope[j];
        }
    }
    if (!solve(n, matrix, right))
        return false;
    for (size_t i = 0; i < n; i++)
        p[i] += right[i];
    return isfinite(p[COS]) && isfinite(p[SIN]) && isfinite(p[FREQUENCY]) && isfinite(p[DECAY]);
}

/* Both amplitudes are linear: they come first, for the frequency and the decay at hand. */
static bool settle(const struct samples *samples, double p[UNKNOWNS])
{
    p[COS] = p[SIN] = 0.0;
    bool sound = improve(samples, 2, p);
    for (int round = 0; sound && round < ROUNDS; round++)
        sound = improve(samples, UNKNOWNS, p);
    return sound;
}

static double deviation(const struct samples *samples, const double p[UNKNOWNS])
{
    double sum = 0.0, slope[UNKNOWNS];
    for (size_t k = 0; k < samples->count; k++) {
        const double rest =
            samples->value[k] - model(p, samples->time[k] - samples->time[0], slope);
        sum += rest * rest;
    }
    return sqrt(sum / (double)samples->count);
}

static bool fit_windows(const struct samples *all, double guess, double p[UNKNOWNS])
{
    if (all->count < SAMPLES_LEAST || !(guess > 0.0))
        return false;
    const double span = all->time[all->count - 1] - all->time[0];
    p[FREQUENCY] = guess;
    p[DECAY] = 0.0;
    for (double window = TWO_PI / guess;; window *= 2.0) {
        struct samples part = *all;
        while (part.count > SAMPLES_LEAST && part.time[part.count - 1] - part.time[0] > window)
            part.count--;
        if (!settle(&part, p))
            return false;
        if (window >= span)
            return true;
    }
}

bool oscillation_fit(size_t count, const double *time, const double *value, double guess,
                     struct oscillation *fit)
{
    const struct samples all = {count, time, value};
    const struct samples half[2] = {{count / 2, time, value},
                                    {count - count / 2, time + count / 2, value + count / 2}};
    double p[UNKNOWNS];
    *fit = (struct oscillation){nan(""), nan(""), nan(""), nan(""), nan("")};
    if (!fit_windows(&all, guess, p))
        return false;
    fit->frequency = p[FREQUENCY];
    fit->decay = p[DECAY];
    fit->amplitude = hypot(p[COS], p[SIN]);
    fit->residual = deviation(&all, p) / fit->amplitude;
    fit->bound = 0.0;
    for (size_t h = 0; h < 2; h++) {
        if (!fit_windows(&half[h], fit->frequency, p))
            return false;
        fit->bound = fmax(fit->bound, fabs(p[FREQUENCY] - fit->frequency));
    }
    return true;
}

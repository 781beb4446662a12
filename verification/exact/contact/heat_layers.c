/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/contact/heat_layers.h"

#include "verification/exact/root.h"

#include <gsl/gsl_sf_bessel.h>
#include <math.h>

static const double PI = 3.14159265358979323846;
/* exp(-40) is 4e-18. */
static const double NOTHING = 40.0, EXACT = 1e-14, BESIDE = 1e-9;

/* ------------------------------------------------------------------- the functions */

static double outside(const struct heat_layers *layers)
{
    return layers->width[0] + layers->width[1];
}

static double root_of(const struct heat_layers *layers, int body, double rate)
{
    return sqrt(rate * layers->capacity[body] / layers->conductivity[body]);
}

/* Of the tube, by orders 0 and 1: p and -p'/z. */
static double tube(int order, double z, double place, double end)
{
    const double j = order == 0 ? gsl_sf_bessel_J0(z * place) : gsl_sf_bessel_J1(z * place);
    const double y = order == 0 ? gsl_sf_bessel_Y0(z * place) : gsl_sf_bessel_Y1(z * place);
    return j * gsl_sf_bessel_Y1(z * end) - y * gsl_sf_bessel_J1(z * end);
}

/* p of a body */
static double shape(const struct heat_layers *layers, int body, double z, double place)
{
    const double end = outside(layers);
    if (!layers->cylinder)
        return cos(z * (body == 0 ? place : end - place));
    return body == 0 ? gsl_sf_bessel_J0(z * place) : tube(0, z, place, end);
}

/* p' at the contact */
static double slope(const struct heat_layers *layers, int body, double z)
{
    const double at = layers->width[0];
    if (!layers->cylinder)
        return body == 0 ? -z * sin(z * at) : z * sin(z * layers->width[1]);
    return -z * (body == 0 ? gsl_sf_bessel_J1(z * at) : tube(1, z, at, outside(layers)));
}

/* Integral of p^2 over the body, with r in a cylinder. */
static double norm(const struct heat_layers *layers, int body, double z)
{
    const double at = layers->width[0], end = outside(layers), width = layers->width[body];
    if (!layers->cylinder)
        return 0.5 * width + sin(2.0 * z * width) / (4.0 * z);
    if (body == 0)
        return 0.5 * at * at *
               (pow(gsl_sf_bessel_J0(z * at), 2) + pow(gsl_sf_bessel_J1(z * at), 2));
    return 0.5 * end * end * pow(tube(0, z, end, end), 2) -
           0.5 * at * at * (pow(tube(0, z, at, end), 2) + pow(tube(1, z, at, end), 2));
}

static double volume(const struct heat_layers *layers, int body)
{
    const double at = layers->width[0], end = outside(layers);
    if (!layers->cylinder)
        return layers->width[body];
    return 0.5 * (body == 0 ? at * at : end * end - at * at);
}

/* ----------------------------------------------------------------------- the modes */

/* 0 at the rates of modes */
static double condition(double rate, void *context)
{
    const struct heat_layers *const layers = context;
    double p[2], flux[2];
    for (int body = 0; body < 2; body++) {
        const double z = root_of(layers, body, rate);
        p[body] = shape(layers, body, z, layers->width[0]);
        flux[body] = layers->conductivity[body] * slope(layers, body, z);
    }
    return flux[0] * flux[1] / layers->conductance + p[0] * flux[1] - p[1] * flux[0];
}

struct alone {
    const struct heat_layers *layers;
    int body;
};

static double slope_alone(double z, void *context)
{
    const struct alone *const alone = context;
    return slope(alone->layers, alone->body, z) / z;
}

/* The rate of mode n >= 1 of a body alone. The roots of a tube are a little above n pi/width. */
static double rate_alone(const struct heat_layers *layers, int body, unsigned n)
{
    struct alone alone = {layers, body};
    const double usual = PI / layers->width[body];
    double z = n * usual;
    if (layers->cylinder && body == 0)
        z = gsl_sf_bessel_zero_J1(n) / layers->width[0];
    else if (layers->cylinder)
        z = root_between(slope_alone, &alone, (n - 0.2) * usual, (n + 0.6) * usual, EXACT);
    return z * z * layers->conductivity[body] / layers->capacity[body];
}

/* Of a mode at t = 0, its rate being known. */
static struct heat_layers_mode mode_of(const struct heat_layers *layers, double rate)
{
    struct heat_layers_mode mode = {.rate = rate};
    double flux[2], square = 0.0;
    for (int body = 0; body < 2; body++) {
        mode.root[body] = root_of(layers, body, rate);
        flux[body] = layers->conductivity[body] * slope(layers, body, mode.root[body]);
    }
    for (int body = 0; body < 2; body++) {
        mode.amplitude[body] = flux[1 - body];
        square += layers->capacity[body] * pow(mode.amplitude[body], 2) *
                  norm(layers, body, mode.root[body]);
    }
    const double area = layers->cylinder ? layers->width[0] : 1.0;
    const double content = -area * mode.amplitude[0] * flux[0] / rate;
    mode.factor = square == 0.0 ? 0.0 : (layers->start[0] - layers->start[1]) * content / square;
    mode.content = mode.factor * content;
    return mode;
}

static double mean(const struct heat_layers *layers)
{
    double content = 0.0, capacity = 0.0;
    for (int body = 0; body < 2; body++) {
        content += layers->capacity[body] * volume(layers, body) * layers->start[body];
        capacity += layers->capacity[body] * volume(layers, body);
    }
    return content / capacity;
}

bool heat_layers_solve(const struct heat_layers *layers, double from,
                       struct heat_layers_series *series)
{
    struct heat_layers own = *layers;
    unsigned next[2] = {1, 1};
    double low = 0.0; /* the rates of both alone that are 0 */
    series->layers = own;
    series->end = mean(&own);
    series->count = 0;
    while (low * from <= NOTHING) {
        const double of[2] = {rate_alone(&own, 0, next[0]), rate_alone(&own, 1, next[1])};
        const int first = of[0] <= of[1] ? 0 : 1;
        const double high = of[first];
        next[first]++;
        if (!isfinite(of[0]) || !isfinite(of[1]) || series->count == HEAT_LAYERS_MODES)
            return false;
        if (high - low > EXACT * high) { /* of equal ones the mode has no content */
            /* there the condition may be 0 too, for modes that do not decay or have no content */
            const double margin = BESIDE * (high - low);
            const double rate = root_between(condition, &own, low + margin, high - margin, EXACT);
            if (!isfinite(rate))
                return false;
            series->modes[series->count++] = mode_of(&own, rate);
        }
        low = high;
    }
    return true;
}

double heat_layers_value(const struct heat_layers_series *series, int body, double place,
                         double time)
{
    double sum = series->end;
    for (size_t k = 0; k < series->count; k++) {
        const struct heat_layers_mode *const mode = &series->modes[k];
        sum += mode->factor * mode->amplitude[body] * exp(-mode->rate * time) *
               shape(&series->layers, body, mode->root[body], place);
    }
    return sum;
}

double heat_layers_passed(const struct heat_layers_series *series, double time)
{
    const struct heat_layers *const layers = &series->layers;
    double sum = layers->capacity[0] * volume(layers, 0) * (layers->start[0] - series->end);
    for (size_t k = 0; k < series->count; k++)
        sum -= series->modes[k].content * exp(-series->modes[k].rate * time);
    return sum;
}

double heat_layers_between(const struct heat_layers *layers)
{
    double e[2];
    for (int body = 0; body < 2; body++)
        e[body] = sqrt(layers->conductivity[body] * layers->capacity[body]);
    return (e[0] * layers->start[0] + e[1] * layers->start[1]) / (e[0] + e[1]);
}

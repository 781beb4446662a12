/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/quantities.h"

#include "verification/measures/fields.h"

#include <math.h>
#include <string.h>

#define F MPM_FIELD_DEFORMATION_GRADIENT
#define FIELDS(X)                                                                                  \
    X("displacement_x", MPM_FIELD_POSITION, 0, true)                                               \
    X("displacement_y", MPM_FIELD_POSITION, 1, true)                                               \
    X("velocity_x", MPM_FIELD_VELOCITY, 0, false)                                                  \
    X("velocity_y", MPM_FIELD_VELOCITY, 1, false)                                                  \
    X("stress_xx", MPM_FIELD_STRESS, 0, false)                                                     \
    X("stress_yy", MPM_FIELD_STRESS, 1, false)                                                     \
    X("stress_zz", MPM_FIELD_STRESS, 2, false)                                                     \
    X("stress_xy", MPM_FIELD_STRESS, 3, false)                                                     \
    X("deformation_gradient_xx", F, 0, false)                                                      \
    X("deformation_gradient_xy", F, 1, false)                                                      \
    X("deformation_gradient_yx", F, 2, false)                                                      \
    X("deformation_gradient_yy", F, 3, false)                                                      \
    X("deformation_gradient_zz", F, 4, false)                                                      \
    X("temperature", MPM_FIELD_TEMPERATURE, 0, false)                                              \
    X("concentration", MPM_FIELD_CONCENTRATION, 0, false)                                          \
    X("plastic_strain", MPM_FIELD_PLASTIC_STRAIN, 0, false)

#define ROW(name, field, component, displacement) {name, field, component, displacement},
static const struct field_quantity fields[] = {FIELDS(ROW)};
#define NAME(name, field, component, displacement) ", " name

const struct field_quantity *field_quantity_find(const char *name)
{
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++)
        if (strcmp(fields[i].name, name) == 0)
            return &fields[i];
    return NULL;
}

const char *field_quantity_names(void)
{
    static const char names[] = FIELDS(NAME);
    return names + 2;
}

static const char *const takes[TAKE_COUNT] = {"last", "max", "min", "mean",
                                              "at",   "l1",  "l2",  "linf"};

const char *take_name(enum take take)
{
    return takes[take];
}

bool take_find(const char *name, enum take *take)
{
    for (int i = 0; i < TAKE_COUNT; i++)
        if (strcmp(takes[i], name) == 0) {
            *take = (enum take)i;
            return true;
        }
    return false;
}

const char *take_names(void)
{
    return "last, max, min, mean, at, l1, l2, linf";
}

bool take_is_norm(enum take take)
{
    return take >= TAKE_L1;
}

/* ------------------------------------------------------------------------ curves */

double curve_at(size_t count, const double *time, const double *values, double at)
{
    if (count == 0 || !(at >= time[0] && at <= time[count - 1]))
        return (double)NAN;
    size_t next = 0;
    while (time[next] < at)
        next++;
    if (next == 0 || time[next] == at)
        return values[next];
    const double part = (at - time[next - 1]) / (time[next] - time[next - 1]);
    return values[next - 1] + part * (values[next] - values[next - 1]);
}

/* What the trapezoidal rule adds up. */
static double integrand(enum take take, double value)
{
    return take == TAKE_L2 ? value * value : take == TAKE_L1 ? fabs(value) : value;
}

static double curve_mean(enum take take, size_t count, const double *time, const double *values)
{
    double sum = 0.0;
    if (count == 1)
        return integrand(take, values[0]);
    for (size_t k = 1; k < count; k++)
        sum += 0.5 * (time[k] - time[k - 1]) *
               (integrand(take, values[k]) + integrand(take, values[k - 1]));
    return sum / (time[count - 1] - time[0]);
}

double curve_take(enum take take, size_t count, const double *time, const double *values)
{
    if (count == 0)
        return (double)NAN;
    double low = values[0], high = values[0];
    for (size_t k = 1; k < count; k++) {
        low = -field_larger(-low, -values[k]);
        high = field_larger(high, values[k]);
    }
    switch (take) {
    case TAKE_MAX:
        return high;
    case TAKE_MIN:
        return low;
    case TAKE_LINF:
        return field_larger(high, -low);
    case TAKE_MEAN:
    case TAKE_L1:
        return curve_mean(take, count, time, values);
    case TAKE_L2:
        return sqrt(curve_mean(take, count, time, values));
    case TAKE_LAST:
    case TAKE_AT:
        break;
    }
    return values[count - 1];
}

/* ------------------------------------------------------------------------ places */

enum { NEAREST = 6 };

struct near {
    size_t index[NEAREST];
    double distance[NEAREST]; /* squared, rising */
    size_t count;
};

static void take_near(struct near *near, size_t index, double distance)
{
    size_t place = near->count < NEAREST ? near->count++ : NEAREST;
    if (place == NEAREST && !(distance < near->distance[NEAREST - 1]))
        return;
    place = place == NEAREST ? NEAREST - 1 : place;
    for (; place > 0 && near->distance[place - 1] > distance; place--) {
        near->distance[place] = near->distance[place - 1];
        near->index[place] = near->index[place - 1];
    }
    near->distance[place] = distance;
    near->index[place] = index;
}

/* Largest squared distance between two of them. */
static double extent(const struct near *near, const double *places)
{
    double largest = 0.0;
    for (size_t i = 0; i < near->count; i++)
        for (size_t j = 0; j < i; j++) {
            const double *const a = &places[2 * near->index[i]], *const b =
                                                                     &places[2 * near->index[j]];
            largest = fmax(largest, (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
        }
    return largest;
}

/* With means of place and value taken away, two equations are left for the slopes. */
static double plane_through(const struct near *near, const double *places, const double *values,
                            const double at[2])
{
    const double n = NEAREST;
    double mx = 0.0, my = 0.0, mv = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, xv = 0.0, yv = 0.0;
    for (size_t i = 0; i < NEAREST; i++) {
        mx += places[2 * near->index[i]] / n;
        my += places[2 * near->index[i] + 1] / n;
        mv += values[near->index[i]] / n;
    }
    for (size_t i = 0; i < NEAREST; i++) {
        const double x = places[2 * near->index[i]] - mx, y = places[2 * near->index[i] + 1] - my;
        const double v = values[near->index[i]] - mv;
        xx += x * x;
        xy += x * y;
        yy += y * y;
        xv += x * v;
        yv += y * v;
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-9 * (xx + yy) * (xx + yy)))
        return (double)NAN;
    return mv +
           ((at[0] - mx) * (yy * xv - xy * yv) + (at[1] - my) * (xx * yv - xy * xv)) / determinant;
}

double plane_at(size_t count, const double *places, const double *weight, const double *values,
                const double at[2])
{
    struct near near = {.count = 0};
    for (size_t p = 0; p < count; p++) {
        const double x = places[2 * p] - at[0], y = places[2 * p + 1] - at[1];
        if (weight[p] > 0.0)
            take_near(&near, p, x * x + y * y);
    }
    if (near.count < NEAREST || near.distance[0] > extent(&near, places))
        return (double)NAN;
    return plane_through(&near, places, values, at);
}

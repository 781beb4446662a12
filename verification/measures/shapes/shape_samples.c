/* Seeded random particle domains; see shape_samples.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/shapes/shape_samples.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_rng.h>
#include <stdlib.h>

struct shape_sampler {
    gsl_rng *random;
};

struct shape_sampler *shape_sampler_create(unsigned long seed)
{
    struct shape_sampler *sampler = calloc(1, sizeof *sampler);
    if (sampler == NULL) {
        return NULL;
    }
    sampler->random = gsl_rng_alloc(gsl_rng_mt19937);
    if (sampler->random == NULL) {
        free(sampler);
        return NULL;
    }
    gsl_rng_set(sampler->random, seed);
    return sampler;
}

void shape_sampler_free(struct shape_sampler *sampler)
{
    if (sampler != NULL) {
        gsl_rng_free(sampler->random);
        free(sampler);
    }
}

static double uniform(struct shape_sampler *sampler, double from, double to)
{
    return from + (to - from) * gsl_rng_uniform(sampler->random);
}

static size_t pick(struct shape_sampler *sampler, size_t count)
{
    return gsl_rng_uniform_int(sampler->random, count);
}

/* To the nearest multiple of 2^-bits, so that sums and products stay exact. */
static double snapped(double value, int bits)
{
    return ldexp(rint(ldexp(value, bits)), -bits);
}

static const int POSITION_BITS = 20, SIZE_BITS = 7, GRADIENT_BITS = 10;

static void draw_grid(struct shape_sampler *sampler, bool exact, struct mpm_shape_query *query)
{
    if (exact) { /* powers of two */
        query->cell[0] = ldexp(1, (int)pick(sampler, 3) - 1);
        query->cell[1] = query->cell[0] * (pick(sampler, 2) == 0 ? 0.5 : 2);
    } else {
        query->cell[0] = uniform(sampler, 0.5, 2);
        query->cell[1] = query->cell[0] * uniform(sampler, 0.4, 2.5);
    }
    for (size_t k = 0; k < 2; k++) {
        double shift = -(double)pick(sampler, 3);
        if (!exact && (k == 1 || query->geometry != MPM_AXISYMMETRIC)) {
            shift = uniform(sampler, -2, 2);
        }
        query->origin[k] = shift * query->cell[k];
    }
}

static void draw_size(struct shape_sampler *sampler, bool exact, struct mpm_shape_query *query)
{
    static const double common[] = {1, 0.5, 1. / 3, 0.25};
    for (size_t k = 0; k < 2; k++) {
        double size = uniform(sampler, 0.05, 1);
        if (exact) {
            size = snapped(uniform(sampler, 0.055, 1), SIZE_BITS);
        } else if (pick(sampler, 4) == 0) {
            size = common[pick(sampler, 4)];
        }
        query->half_size[k] = size * query->cell[k] / 2;
    }
}

static void draw_gradient(struct shape_sampler *sampler, bool exact, struct mpm_shape_query *query)
{
    const double angle = uniform(sampler, -M_PI, M_PI);
    const double a = uniform(sampler, 0.6, 1.8), b = uniform(sampler, 0.6, 1.8);
    const double c = uniform(sampler, -0.6, 0.6);
    const double gradient[4] = {cos(angle) * a, cos(angle) * c - sin(angle) * b, sin(angle) * a,
                                sin(angle) * c + cos(angle) * b};
    for (size_t i = 0; i < 4; i++) {
        query->deformation_gradient[i] = exact ? snapped(gradient[i], GRADIENT_BITS) : gradient[i];
    }
}

/* A corner's (CPDI) or edge's (uGIMP) offset from the centre along axis k, in cells. */
static double corner_offset(const struct mpm_shape_query *query, size_t k, double sign_1,
                            double sign_2)
{
    if (query->shape == MPM_UGIMP) {
        return sign_1 * query->half_size[k] / query->cell[k];
    }
    if (query->shape != MPM_CPDI) {
        return 0;
    }
    const double *f = query->deformation_gradient;
    return (sign_1 * f[2 * k] * query->half_size[0] + sign_2 * f[2 * k + 1] * query->half_size[1]) /
           query->cell[k];
}

/* Half the domain's extent along r, in cells. */
static double radial_reach(const struct mpm_shape_query *query)
{
    return GSL_MAX_DBL(fabs(corner_offset(query, 0, 1, 1)), fabs(corner_offset(query, 0, 1, -1)));
}

static bool is_spline(const struct mpm_shape_query *query)
{
    return query->shape == MPM_BSPLINE2 || query->shape == MPM_BSPLINE3;
}

/* A point on a knot of a B-spline or an edge, or beside it; r > 0 in axisymmetry. */
static double draw_knot(struct shape_sampler *sampler, const struct mpm_shape_query *query,
                        size_t k, double beside)
{
    const bool radial = k == 0 && query->geometry == MPM_AXISYMMETRIC;
    return fabs(0.5 * (double)(pick(sampler, 11) + radial) + beside);
}

/* Most grids end zero to four cells above the point, and begin at node 0; some do not end. */
static void draw_edges(struct shape_sampler *sampler, struct mpm_shape_query *query)
{
    for (size_t k = 0; k < 2; k++) {
        const double place = (query->position[k] - query->origin[k]) / query->cell[k];
        const double above = (double)pick(sampler, 4);
        if (pick(sampler, 5) > 0) {
            query->cells[k] = (int64_t)(fmax(1, ceil(place)) + above);
        }
    }
}

/* A coordinate that puts centre, edge or corner on or beside a grid line. */
static double draw_boundary(struct shape_sampler *sampler, const struct mpm_shape_query *query,
                            size_t k)
{
    static const double beside[] = {0, 1e-12, -1e-12, 1e-13, -1e-13, 1e-15, -1e-15, 0};
    const double line = 1 + (double)pick(sampler, 5);
    if (query->shape == MPM_CLASSIC) {
        return line + (pick(sampler, 2) == 0 ? 1e-12 : -1e-12) * (double)(1 + pick(sampler, 9));
    }
    if (is_spline(query)) {
        return draw_knot(sampler, query, k, beside[pick(sampler, 8)]);
    }
    const double sign_1 = (double)pick(sampler, 3) - 1;
    const double sign_2 = sign_1 * (pick(sampler, 2) == 0 ? 1 : -1);
    const double place = line - corner_offset(query, k, sign_1, sign_2);
    return fabs(place) + beside[pick(sampler, 8)];
}

/* A shrunk domain (CPDI, truncated) is as small as r_p: keep it to a fifth of its size. */
static double clear_of_axis(const struct mpm_shape_query *query, double place)
{
    const bool shrinks = query->shape == MPM_CPDI && query->geometry == MPM_AXISYMMETRIC;
    return shrinks && place < 0.2 * radial_reach(query) ? place + 1 : place;
}

static double draw_near_axis(struct shape_sampler *sampler, const struct mpm_shape_query *query)
{
    const double reach = radial_reach(query);
    const bool cut_rectangle = query->shape == MPM_UGIMP && query->axis == MPM_TRUNCATED;
    if (query->shape == MPM_CLASSIC || is_spline(query)) {
        return uniform(sampler, 0.01, 0.5);
    }
    switch (pick(sampler, 4)) {
    case 0: /* just touching the axis */
        return reach * (1 + 1e-12 * uniform(sampler, -1, 1));
    case 1:
        return cut_rectangle ? reach * 1e-12 * (double)pick(sampler, 4)
                             : reach * uniform(sampler, 0.2, 0.4);
    default:
        return reach * uniform(sampler, query->shape == MPM_UGIMP ? 0.01 : 0.2, 1.2);
    }
}

void shape_sampler_draw(struct shape_sampler *sampler, const struct mpm_shape_query *kind,
                        enum shape_region region, struct mpm_shape_query *query)
{
    const bool axisymmetric = kind->geometry == MPM_AXISYMMETRIC;
    const bool exact = region == SHAPE_REGION_FAR;
    *query = (struct mpm_shape_query){
        .shape = kind->shape, .geometry = kind->geometry, .axis = kind->axis};
    draw_grid(sampler, exact, query);
    draw_size(sampler, exact, query);
    draw_gradient(sampler, exact, query);
    const double far = region == SHAPE_REGION_FAR || region == SHAPE_REGION_FAR_ANYWHERE ? 1000 : 0;
    for (size_t k = 0; k < 2; k++) {
        double place = uniform(sampler, 0.02, 5.5);
        if (region == SHAPE_REGION_BOUNDARY) {
            place = draw_boundary(sampler, query, k);
        } else if (region == SHAPE_REGION_AXIS && k == 0 && axisymmetric) {
            place = draw_near_axis(sampler, query);
        } else if (far > 0) {
            place = uniform(sampler, 0.02, 1) + (k == 0 || pick(sampler, 2) == 0 ? far : 0);
            place = exact ? snapped(place, POSITION_BITS) : place;
        }
        place = k == 0 ? clear_of_axis(query, place) : place;
        const double base = axisymmetric && k == 0 ? 0 : query->origin[k];
        query->position[k] = base + place * query->cell[k];
    }
    if (is_spline(query)) {
        draw_edges(sampler, query);
    }
}

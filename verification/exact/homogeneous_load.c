/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/homogeneous_load.h"

#include "verification/exact/root.h"

#include <math.h>

/* The interval of the search for a root. */
struct problem {
    const struct compression_material *material;
    double axial, traction, power;
};

static double stress_along(const struct compression_material *m, double radial, double axial,
                           double along)
{
    const double j = radial * radial * axial;
    const double deviator = along * along - (2.0 * radial * radial + axial * axial) / 3.0;
    return m->bulk / 2.0 * (j - 1.0 / j) + m->shear * deviator / (j * cbrt(j * j));
}

/* A stretch; NaN if there is none. */
static double find_stretch(double (*function)(double, void *), struct problem *problem)
{
    static const double LOWEST = 0.2, HIGHEST = 5.0, TOLERANCE = 1e-13;
    return root_between(function, problem, LOWEST, HIGHEST, TOLERANCE);
}

static double side_stress(double radial, void *context)
{
    const struct problem *const p = context;
    return stress_along(p->material, radial, p->axial, radial) - p->traction;
}

/* l_r of a bar stretched to l_z whose sides are free */
static double free_radius(const struct compression_material *material, double axial)
{
    struct problem side = {.material = material, .axial = axial};
    return find_stretch(side_stress, &side);
}

static double end_stress(double axial, void *context)
{
    const struct problem *const p = context;
    const double radial = free_radius(p->material, axial);
    return stress_along(p->material, radial, axial, axial) * pow(radial, p->power) - p->traction;
}

static bool fill(const struct compression_material *material, struct homogeneous_state *state)
{
    const double side = stress_along(material, state->radial, state->axial, state->radial);
    const double along = stress_along(material, state->radial, state->axial, state->axial);
    state->stress = (struct compression_stress){.rr = side, .zz = along, .tt = side};
    return isfinite(side) && isfinite(along);
}

bool homogeneous_end_load(const struct compression_material *material, double traction,
                          double power, struct homogeneous_state *state)
{
    struct problem end = {.material = material, .traction = traction, .power = power};
    state->axial = find_stretch(end_stress, &end);
    state->radial = free_radius(material, state->axial);
    return fill(material, state);
}

bool homogeneous_rim_load(const struct compression_material *material, double traction,
                          struct homogeneous_state *state)
{
    struct problem side = {.material = material, .axial = 1.0, .traction = traction};
    state->axial = 1.0;
    state->radial = find_stretch(side_stress, &side);
    return fill(material, state);
}

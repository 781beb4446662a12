/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_impulse.h"

#include <math.h>

/* A direction along which less than this part of the mobility is left, where the crack makes an
 * angle of less than 1e-6 with it, counts as held: below, round-off would decide which way it goes.
 */
static const double HELD_ALONG = 1e-12;

/* S and dv. */
struct difference {
    double mobility[2], velocity[2];
};

static struct difference difference_of(const struct mpm_contact_side sides[2])
{
    struct difference made;
    for (int axis = 0; axis < 2; axis++) {
        made.mobility[axis] = sides[0].mobility[axis] + sides[1].mobility[axis];
        made.velocity[axis] =
            made.mobility[axis] > 0.0 ? sides[0].velocity[axis] - sides[1].velocity[axis] : 0.0;
    }
    return made;
}

/* The impulse along a direction after which there is no velocity along it; 0 where it is held. */
static double stopping(const struct difference *difference, const double along[2])
{
    const double *const s = difference->mobility, *const v = difference->velocity;
    const double mobility = s[0] * along[0] * along[0] + s[1] * along[1] * along[1];
    if (!(mobility > HELD_ALONG * fmax(s[0], s[1])))
        return 0.0;
    return -(v[0] * along[0] + v[1] * along[1]) / mobility;
}

double mpm_contact_approach(const struct mpm_contact_side sides[2], const double normal[2])
{
    const struct difference between = difference_of(sides);
    return between.velocity[0] * normal[0] + between.velocity[1] * normal[1];
}

double mpm_contact_drag(double stopping, double pressure, double at_rest, double sliding)
{
    return fabs(stopping) <= at_rest * pressure ? stopping : copysign(sliding * pressure, stopping);
}

void mpm_contact_impulse(const struct mpm_contact_law *law, const struct mpm_contact_side sides[2],
                         const double normal[2], double impulse[2])
{
    const double along[2] = {-normal[1], normal[0]};
    struct difference left = difference_of(sides);
    double dragged = 0.0;
    const double pressed = stopping(&left, normal);
    for (int axis = 0; axis < 2; axis++)
        left.velocity[axis] += left.mobility[axis] * pressed * normal[axis];
    if (law->kind != MPM_CONTACT_FRICTIONLESS)
        dragged = stopping(&left, along);
    if (law->kind == MPM_CONTACT_FRICTION)
        dragged = mpm_contact_drag(dragged, fabs(pressed), law->friction, law->friction);
    for (int axis = 0; axis < 2; axis++)
        impulse[axis] = pressed * normal[axis] + dragged * along[axis];
}

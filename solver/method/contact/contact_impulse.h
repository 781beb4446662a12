/* The impulse that two velocity fields of a node exchange in contact: CRAMP (13)-(19), with
 * velocity conditions.
 *
 * CRAMP resolves contact after the conditions, as if both fields were free. Here each field has a
 * mobility, one value for each axis: 1/m where the field is free, and 0 where a condition holds it,
 * which then has infinite mass. With S the sum of both mobilities, dv the velocity above minus that
 * below, n the normal from above to below and t along the crack, the impulse on the field above is
 * p n + q t, and that on the field below the opposite:
 *     p = -(n . dv) / (n . S n)               no approach is left
 *     q = -(t . (dv + S p n)) / (t . S t)     no sliding is left: stick
 * with q = 0 without friction, and |q| <= mu |p| with it. With free fields S is 1/m_a + 1/m_b along
 * both axes, and this is CRAMP's exchange. Held components do not change, since S is 0 there; their
 * difference is left out of dv. Each of both parts ends at the least kinetic energy along its
 * direction, or on the way to it, so that contact never adds any.
 *
 * Where conditions hold both fields along n (n . S n is 0), no impulse can change the approach: the
 * conditions bear the pressure, p = 0, and friction has nothing to act by.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CONTACT_IMPULSE_H
#define MPM_METHOD_CONTACT_IMPULSE_H

#include "model/scene.h"

/* How two fields exchange momentum. */
struct mpm_contact_law {
    enum mpm_crack_contact kind; /* not MPM_CONTACT_NONE */
    double friction;             /* of MPM_CONTACT_FRICTION */
    bool if_approaching;         /* only fields that approach each other are in contact */
};

struct mpm_contact_side {
    double velocity[2];
    double mobility[2]; /* 1/mass, or 0 for a component that a condition holds */
};

/* The speed at which two fields, the one above first, approach each other along the normal, in the
 * components that can change. */
double mpm_contact_approach(const struct mpm_contact_side sides[2], const double normal[2]);

/* Coulomb's law: the impulse along the surface that `pressure` (0 or more) allows where `stopping`
 * would end all sliding. That, up to `at_rest` times the pressure; beyond it, `sliding` times it.
 */
double mpm_contact_drag(double stopping, double pressure, double at_rest, double sliding);

/* The impulse on the field above, for fields that are in contact. */
void mpm_contact_impulse(const struct mpm_contact_law *law, const struct mpm_contact_side sides[2],
                         const double normal[2], double impulse[2]);

#endif

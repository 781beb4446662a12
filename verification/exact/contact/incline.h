/* A body on an incline under gravity with Coulomb's law, as a rigid body.
 *
 * Along the incline m a = m g sin(theta) - F and across it N = m g cos(theta), with the friction F.
 * A block sticks as long as F = m g sin(theta) <= mu_s N, and slides with F = mu N:
 *     a = 0 if tan(theta) <= mu_s, else a = g (sin(theta) - mu cos(theta)).
 * A round body of radius R and moment of inertia k m R^2 turns with k m R^2 alpha = F R. It rolls,
 * a = alpha R, with F = m g sin(theta) k/(1 + k), as long as that is at most mu_s N:
 *     a = g sin(theta)/(1 + k)                  if tan(theta) <= mu_s (1 + k)/k,
 *     a = g (sin(theta) - mu cos(theta)),  alpha = mu g cos(theta)/(k R)   else.
 * A disk has k = 1/2, so it rolls up to tan(theta) = 3 mu_s.
 *
 * No term holds g alone: where gravity comes on as s(t), velocities are a and alpha times the
 * integral of s.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_INCLINE_H
#define VERIFICATION_EXACT_INCLINE_H

#include <stdbool.h>

struct incline {
    double gravity, angle; /* acceleration >= 0; radians, 0 to pi/2 */
    double friction, static_friction;
};

struct incline_motion {
    double acceleration; /* down the incline */
    double spin;         /* angular acceleration; 0 of a block */
    bool slips;
};

struct incline_motion incline_block(const struct incline *incline);

/* Of a round body; inertia: k > 0; radius: R > 0. */
struct incline_motion incline_round(const struct incline *incline, double inertia, double radius);

#endif

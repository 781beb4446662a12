/* The impulses between several velocity fields of a node, pair by pair.
 *
 * Each field has a velocity and a mobility along each axis, 1/m or 0 where it is held
 * (contact_impulse.h). With dv the velocity of a pair's first field minus that of its second one, n
 * the normal from the first to the second, S the sum of both mobilities, the impulse on the first
 * field is p n + q t, with
 *     n . dv <= a,  p <= 0,  p (n . dv - a) = 0     contact; a: the approach that a gap allows
 *     p <= c                                        adhesion, c its strength times area times dt:
 *                                                   a pair that would need more is not held at all
 *     t . dv = 0 if p is not 0                      stick
 *     t . dv = 0 if |q| <= mu_s |p|,                friction; mu_s: static
 *     else |q| = mu |p| against the sliding
 *     dv = 0                                        bonded
 *     p = f_n - c_n n . dv,  q = f_t - c_t t . dv   interface; f, c: interface_law.h
 * One pair: this is one exchange, as for cracks. More of them: all pairs change at once, each by a
 * part of what would do for it alone, until nothing changes; so the result does not depend on the
 * order of fields or pairs, but for round-off. With k pairs at each field the part is
 * (S_1 + S_2)/(k_1 S_1 + k_2 S_2), which makes the sweeps converge: pairs of a rigid body do not
 * hinder each other. Where fields are held along one axis, p and q both act along the other one;
 * the part is less by up to a half then, 1/(1 + |n.St|/sqrt(n.Sn t.St)).
 *
 * Stick with p near 0 is friction without a limit, so more than one set of impulses can obey these
 * laws, and sweeps can go round in circles between them. Where 200 sweeps have not settled and are
 * not about to, they begin again with |q| <= 10 |p| for stick: what settles below this limit obeys
 * stick itself. If that has not settled after 200 either, they begin a last time, in rounds, with
 * |q| <= b for stick and friction. In the first round b is 0; then it is min(mu, 1) times the
 * pressure that the round before has found, with mu = 1 for stick. An adhesion that reaches c in a
 * round has p <= 0 from then on. Each round is a convex problem, of the least kinetic energy: its
 * velocities are unique, round-off changes them by round-off, and it makes no energy. After 10
 * rounds of up to 150 sweeps, fields of a ten-millionth of the mass of others can keep a part of
 * their approach.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CONTACT_SOLVE_H
#define MPM_METHOD_CONTACT_SOLVE_H

#include "method/contact/contact_impulse.h"
#include "model/contact.h"

/* The impulse of an interface along a direction: `free` - `damped` times the part of dv there. */
struct mpm_solve_line {
    double free, damped;
};

struct mpm_solve_pair {
    int of[2];        /* sides */
    double normal[2]; /* unit vector from the first to the second */
    enum mpm_pair_law law;
    double friction, static_friction;
    double pull;                    /* c */
    double approach;                /* a */
    struct mpm_solve_line lines[2]; /* of an interface: along the normal, along the surface */
    double impulse[2];              /* out: on the first side */
};

/* Finds all impulses; the sides' velocities become those after them. */
void mpm_contact_solve(struct mpm_contact_side *sides, struct mpm_solve_pair *pairs, int count);

#endif

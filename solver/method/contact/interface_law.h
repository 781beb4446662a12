/* Imperfect interfaces: tractions by the jump of displacement between two fields.
 *
 * The tractions are D_n [u_n] n + D_t [u_t] t on the first field and the opposite on the second,
 * with the jump [u] of the displacement between the second field and the first at the surface, and
 * separate D_n for opening and overlap, Nairn 2013. At a node with k = D times its area of contact
 * and the mobility S along a direction, kappa = k S dt^2 decides whether an explicit force is
 * stable. The impulse along the direction is
 *     dt k ([u] + alpha dt [v]),   alpha = kappa^2 / (1 + kappa^2),
 * with the difference [v] of the velocities after the impulse: explicit where kappa is small,
 * implicit (backward Euler) where it is large. There the interface dissipates; the history counts
 * nodes with kappa > 1.
 *
 * N&G have the law for small displacements. Here [u] is the jump of the material in the current
 * frame and lengths, along the current normal, and the area is the current one: bodies that turn
 * keep their energy. Where the surface is stretched while its jump is not zero, the area grows and
 * the law has no energy: what this works counts as dissipated.
 *
 * [u] is that of the particles' places (displacement_fit.h), less what places are ahead of the
 * strains by in orders of update that strain by other velocities than those that move particles. A
 * free vibration across a straight interface between planes of symmetry then keeps its energy while
 * kappa is not far above 1. At free ends of an interface and where three bodies meet, diagonal
 * normals make energy, to twice the start's in 3000 steps, and with kappa = 16 short waves grow:
 * case C13 and docs/scenes.md have numbers; the energy guard judges it as any other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_INTERFACE_LAW_H
#define MPM_METHOD_INTERFACE_LAW_H

#include "method/contact/contact_solve.h"
#include "method/state.h"

/* Task 4: the impulses of a pair along its normal and along the surface. `sides` are its fields
 * before any impulse. Returns whether kappa > 1 in a direction. */
bool mpm_interface_lines(const struct mpm_state *state, const struct mpm_contact_pair *pair,
                         const struct mpm_contact_side *const sides[2],
                         struct mpm_solve_line lines[2]);
/* After the exchanges of task 4: energy that the pair stores at the end of the step. */
double mpm_interface_stored(const struct mpm_state *state, const struct mpm_contact_pair *pair);

#endif

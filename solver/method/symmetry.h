/* Planes of symmetry: `symmetry: true` of a boundary.
 *
 * Bodies lie on one side of a line of nodes. What their particles spread to nodes beyond is what a
 * mirrored body would spread to the nodes on this side: it is added there, with the component along
 * the plane's normal reversed, and the nodes beyond become images of those on this side. Nodes on
 * the plane do not move along its normal. A half model then gives what the whole one does, to
 * round-off, for functions that reach beyond the plane too.
 *
 * Further velocity fields of nodes near a crack are left as they are: a particle whose line to a
 * node beyond the plane crosses a crack is on a free surface there. Points of cracks that lie on
 * the plane stay on it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_SYMMETRY_H
#define MPM_METHOD_SYMMETRY_H

#include "method/state.h"

/* After masses and momenta are spread. */
void mpm_symmetries_reflect_momentum(struct mpm_state *state);
/* Once all forces are. */
void mpm_symmetries_reflect_force(struct mpm_state *state);
/* After each pass that sums momenta up in grid.gradient: the re-extrapolation, and those of XPIC
 * and FMPM. */
void mpm_symmetries_reflect_extrapolated(struct mpm_state *state);

#endif

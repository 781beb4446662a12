/* What flows across cracks, of scalars that are conducted: passages between the fields of nodes
 * near them. As for contact, fields of a node follow each other as above, own, below, those with
 * mass, and each has a passage to the next one, by the law of the crack between them: of several
 * cracks the one that lets through least. The area of a crack at a node follows from the surface of
 * the particles beyond it, as that of contact between bodies (contact_detection.h):
 *
 *     A = |n . sum_p V_p (G_ip + T_ip e_r)|,   n the mean normal of the segments between,
 *
 * which is the crack's alone inside of a body and at edges across it. It is that of the crack as it
 * is closed; at a tip the surface ahead of it, along its normal, takes part.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CRACK_PASSAGES_H
#define MPM_METHOD_CRACK_PASSAGES_H

#include "method/cracks/crack_fields.h"

/* Takes the memory of scenes with a conductance. */
void mpm_crack_passages_layout(struct mpm_state *state, struct mpm_arena *arena);

/* Lists them for all scalars, once nodes have mass. Cost: a look at the fields near cracks; with a
 * conductance also at the stencils of their particles. */
void mpm_crack_passages_list(struct mpm_state *state);

#endif

/* How far the particles of two fields go towards each other at a node.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CONTACT_EDGES_H
#define MPM_METHOD_CONTACT_EDGES_H

#include "method/contact/contact_particles.h"

/* The edges of both fields of pairs with a normal: how far their particles, with the domains that F
 * carries, go along the line through the node along the normal. What lies beside that line counts
 * for less, by MPM_EDGE_SLOPE of its distance: of curved surfaces and corners the part at the node
 * is meant. Cost: the same particles, without stencils. */
void mpm_contact_edges_find(struct mpm_state *state, int workers);
#define MPM_EDGE_SLOPE 1.0

#endif

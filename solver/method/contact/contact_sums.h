/* Sums over the particles at nodes that several fields reach, from which normals and areas of their
 * surfaces follow.
 *
 * They are those of the whole model where a plane of symmetry is near: what mirrored particles
 * would add is folded in, and what is odd along the plane's normal is zero on the plane, as on
 * r = 0 (N&G 3.3).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CONTACT_SUMS_H
#define MPM_METHOD_CONTACT_SUMS_H

#include "method/contact/shared_nodes.h"

/* Fills the sums of the fields that were listed. Cost: the stencils of the particles that reach
 * such nodes. */
void mpm_contact_sums_find(struct mpm_state *state, int workers);

/* The sums of a field of the node with those of all sides of a crack that cuts it, for normals: the
 * crack's own surfaces are none of contact between bodies. Of areas, volume, their normals and
 * the moments only. `room`: memory for them. */
const struct mpm_contact_sums *mpm_contact_whole_sums(const struct mpm_state *state,
                                                      const struct mpm_contact_node *node,
                                                      uint32_t place,
                                                      struct mpm_contact_sums *room);

/* Calls `visit` for each listed node beyond a plane of symmetry and the one that it is an image of,
 * plane by plane; `axis` is that of the plane's normal. */
typedef void mpm_contact_image_visit(struct mpm_state *state, int axis,
                                     struct mpm_contact_node *inside,
                                     const struct mpm_contact_node *beyond);
void mpm_contact_images_visit(struct mpm_state *state, mpm_contact_image_visit *visit);

/* Are the pairs, of a node and of its image, of the same fields? */
bool mpm_contact_is_image(const struct mpm_state *state, const struct mpm_contact_pair *one,
                          const struct mpm_contact_pair *other);

/* Is the node, of the grid, on a plane of symmetry across this axis, or on r = 0? */
bool mpm_contact_is_on_plane(const struct mpm_state *state, int64_t node, int axis);

#endif

/* Planes of symmetry: `symmetry: true` of a boundary.
 *
 * Bodies lie on one side of a line of nodes. What their particles spread to nodes beyond is what a
 * mirrored body would spread to the nodes on this side: it is added there, with the component along
 * the plane's normal reversed, and the nodes beyond become images of those on this side. Nodes on
 * the plane do not move along its normal. A half model then gives what the whole one does, to
 * round-off, for functions that reach beyond the plane too.
 *
 * A crack may pass a plane at a right angle: it goes on beyond it as its own image, and its packed
 * velocity fields are folded like the nodes' own. A particle that requests a field at a node beyond
 * requests it at the image inside too, which is nearer.
 *
 * Packed fields of other cracks are not folded: a particle whose line to a node beyond the plane
 * crosses such a crack is on a free surface there, and so is one at a node on the plane if the
 * crack lies on the plane. Fields at nodes on the plane that belong to other cracks are held by
 * conditions.c. Points of cracks that lie on the plane stay on it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_SYMMETRY_H
#define MPM_METHOD_SYMMETRY_H

#include "method/state.h"

/* The node that this one of the grid is an image of; itself if it is none. *sign[axis] is -1 where
 * the component changes its sign. What depends on a node's place is taken at the former, so that
 * images stay images. */
int64_t mpm_symmetry_original(const struct mpm_state *state, int64_t node, double sign[2]);

/* The node's mass in the whole model: on a plane the sum over particles has half of it, unless the
 * node is a field on the free surface of a crack that lies there. */
double mpm_symmetry_whole_mass(const struct mpm_state *state, int64_t node);

/* The images of a node of the grid, or of a layer, across all planes, those that are active, with
 * the signs of their velocities. Returns how many they are: 0 of a node on a plane or far from all.
 */
enum { MPM_SYMMETRY_IMAGES = 16 };
struct mpm_symmetry_image {
    int64_t node;
    double sign[2];
};
int mpm_symmetry_images(const struct mpm_state *state, int64_t node,
                        struct mpm_symmetry_image images[MPM_SYMMETRY_IMAGES]);

/* Where a crack passes a plane: calls `visit` for each node with packed fields beyond it and the
 * one that it is an image of; and for each such node on the plane, `beyond` being NULL. */
typedef void mpm_symmetry_visit(struct mpm_state *state, int axis,
                                const struct mpm_field_node *inside,
                                const struct mpm_field_node *beyond, const void *context);
void mpm_symmetries_visit(struct mpm_state *state, mpm_symmetry_visit *visit, const void *context);

/* The image of a packed field at the image of its parent, or -1. */
int64_t mpm_symmetry_packed_image(const struct mpm_state *state, int64_t field,
                                  const struct mpm_symmetry_image *image);

/* After masses and momenta are spread. */
void mpm_symmetries_reflect_momentum(struct mpm_state *state);
/* Once all forces are. */
void mpm_symmetries_reflect_force(struct mpm_state *state);
/* After each pass that sums momenta up in grid.gradient: the re-extrapolation, and those of XPIC
 * and FMPM. */
void mpm_symmetries_reflect_extrapolated(struct mpm_state *state);
/* Of sums of scalars, in all numbers of a node. */
void mpm_symmetries_reflect_scalar(struct mpm_state *state, double *nodes);

#endif

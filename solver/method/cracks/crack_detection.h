/* Are the surfaces of a crack in contact at a node? By its relative volume, CRAMP (8)-(10): areas
 * in axisymmetry too, N&G 3.3.
 *
 * CRAMP divides the areas sum A_p S_ip that a node sees by the area of a cell, and names what is
 * wrong with it: a node at an edge of the body sees less than a cell though the surfaces touch.
 * That is `detection: cell`.
 *
 * Here the distance of the surfaces is found first. Each particle knows where it was at t = 0, and
 * from there the way w_p to the nearest point of a crack in the undeformed body, which has the
 * points that a crack has grown by as well, where its surface along that crack began; today that
 * point is at x_p + F_p w_p, exactly so if its body was moved, turned and strained evenly. A
 * particle between two cracks has a surface along each. The mean of these points, weighted with A_p
 * S_ip, is where a field has its surface, whatever part of the node's reach it fills; and the gap
 * is how far that of the field below lies beyond that of the field above, along the crack's normal
 * n, which points from above to below: gap = n . (<x_p + F_p w_p>_below - <x_p + F_p w_p>_above)
 * `detection: displacement` compares 1 - gap/h with the limits, h the cell's size along n.
 * `detection: volume` compares sum A_p S_ip with what it would be if both sides moved by gap/2 to
 * meet: sum A_p S_ip + gap n/2 . (sum_above A_p G_ip - sum_below A_p G_ip), where that is more for
 * an open crack and less for surfaces that have passed each other; else the sum as it is.
 * `detection: cell` compares the area with that which a node can see of a grid full of material: a
 * cell's, and half of it along each of r = 0, planes of symmetry and edges of the grid that the
 * node lies on. N&G 3.3 doubles the area found at r = 0 and on planes of symmetry, which is the
 * same. Axisymmetric S_ip have more weight at larger r, by which a node at r = 0 would lack a ninth
 * with two particles a cell: here the means of N_i over the domains, T_ip/sum_i T_ip, are taken
 * instead.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CRACK_DETECTION_H
#define MPM_METHOD_CRACK_DETECTION_H

#include "method/cracks/crack_fields.h"

/* Is contact of any crack detected from where its surfaces are? Particles carry their place at t =
 * 0 then. */
bool mpm_crack_detection_needs_surfaces(const struct mpm_scene *scene);

/* Task 1, second part: normals and sums of the nodes with several fields. Cost: the stencils of the
 * particles that reach such nodes, and for each such particle some ns for each segment of the
 * scene's chain of each crack there. */
void mpm_crack_detection_measure(struct mpm_state *state, int workers);

/* Two fields of a node on both sides of a crack. */
struct mpm_crack_pair {
    enum mpm_crack_side side[2]; /* the field above, the field below */
    uint32_t crack;
    double normal[2]; /* of unit length, from above to below */
    const double
        *surface[2]; /* of each: sum A_p S_ip times the place of its surface, from the node */
};

/* Two sides of a node of which one at least is not its own, in this order. False: no normal. */
bool mpm_crack_pair_find(const struct mpm_crack_node *node, enum mpm_crack_side above,
                         enum mpm_crack_side below, struct mpm_crack_pair *pair);

/* V_rel = found / closed of a pair. `closed` may be 0 or less where surfaces have passed through
 * each other by more than the node sees: V_rel is then beyond every limit, as
 * found < limit * closed says. */
struct mpm_crack_volume {
    double found, closed;
};
struct mpm_crack_volume mpm_crack_volume_at(const struct mpm_state *state,
                                            const struct mpm_crack_node *node,
                                            const struct mpm_crack_pair *pair);

#endif

/* Integrals of the nodes' functions over one edge of a particle's domain: what a traction, or a
 * flux, on that edge gives to the nodes.
 *
 *     w_i = integral of N_i dS,    dS = B dl in planar geometry, r dl (per radian) in axisymmetry,
 *
 * so that sum w_i is the area of the edge and f_i = w_i T, N&G (5), (40), (49). Edges are N&G's,
 * Fig. 4: 1 bottom, 2 right, 3 top, 4 left of the undeformed domain, counter clockwise.
 *
 *   cpdi      the edge that F carries; N_i between its two corners is interpolated, which is
 *             what CPDI takes it for inside the domain too: N&G (41)-(44), (50)-(53)
 *   ugimp     the same with the undeformed domain, (45)-(48): there it is the trapezoidal rule
 *   classic,  points have no domain: the edge is that of CPDI, and N_i is taken at its middle, by
 *   bsplines  the functions of the cells that the particle is in. One point for the edge, since
 *             the particle is one for its volume: integrated exactly, a uniform stress would be out
 *             of balance along every edge (quadratic splines: by half of it in corners). Where the
 *             middle lies past these cells, functions are continued as the polynomials they are:
 *             the particle gives to nodes that it reaches with its mass, as everywhere in the
 *             method, and the force's sum and moment are those of the edge's middle. Splines: the
 *             term of the polynomials that jumps at a knot (quadratic: S'', cubic: S''') fades out
 *             where the particle is nearer to the knot than to the edge, so that weights vary
 *             continuously with its place
 *
 * Domains that would pass r = 0 are cut or shrunk first, as the shape functions' own are; those
 * that are not (axis: untruncated, planar) keep the sign of r, as their mass does. Edges of points
 * always shrink.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_EDGE_H
#define MPM_METHOD_EDGE_H

#include "method/shape/shape.h"
#include "model/scene.h"

/* middle + rho half, rho from -1 to 1, runs counter clockwise around the domain. */
struct mpm_edge_line {
    double middle[2], half[2];
};

/* Where an edge is. `domain` must have both half_size and, unless the family is uGIMP, edge. */
struct mpm_edge_line mpm_edge_find(const struct mpm_shape_family *family,
                                   const struct mpm_shape_grid *grid,
                                   const struct mpm_shape_domain *domain, enum mpm_edge edge);

/* Its area, for the depth B or (there B is not used) per radian. */
double mpm_edge_area(const struct mpm_shape_grid *grid, const struct mpm_edge_line *line,
                     double depth);

struct mpm_edge_weights {
    int count;
    struct {
        int64_t node; /* offset from node (0, 0), as in a stencil; each once */
        double w;     /* area */
    } entry[MPM_STENCIL_MAX];
};

/* w_i += area S_i for the nodes of a stencil. They and those at hand must all be nodes that one
 * particle reaches: there is room for no more. */
void mpm_edge_weights_add(struct mpm_edge_weights *weights, const struct mpm_stencil *stencil,
                          double area);

/* w_i of every node that the edge reaches: a subset of the nodes that the particle's domain
 * reaches. Cost: some 0.1 us. */
void mpm_edge_integrate(const struct mpm_shape_family *family, const struct mpm_shape_grid *grid,
                        const struct mpm_shape_domain *domain, enum mpm_edge edge, double depth,
                        struct mpm_edge_weights *weights);

#endif

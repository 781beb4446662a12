/* Shape functions, one particle at a time. Part of the public interface: mpm.h includes it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_SHAPE_H
#define MPM_SHAPE_H

#include "mpm_api.h"

#include <stddef.h>
#include <stdint.h>

MPM_API_BEGIN

enum mpm_geometry { MPM_PLANE_STRAIN, MPM_PLANE_STRESS, MPM_AXISYMMETRIC };
/* Families of shape functions, S(value of method.shape in scenes, enumerator). */
#define MPM_SHAPES(S)                                                                              \
    S("classic", MPM_CLASSIC)                                                                      \
    S("ugimp", MPM_UGIMP)                                                                          \
    S("cpdi", MPM_CPDI)                                                                            \
    S("bspline2", MPM_BSPLINE2)                                                                    \
    S("bspline3", MPM_BSPLINE3)
#define MPM_SHAPE(name, shape) shape,
enum mpm_shape { MPM_SHAPES(MPM_SHAPE) MPM_SHAPE_COUNT };
#undef MPM_SHAPE
/* What becomes of a domain at r = 0. Points are the same with all of them. */
enum mpm_axis {
    MPM_TRUNCATED,
    MPM_UNTRUNCATED,
    MPM_PLANAR, /* the planar S and G, not truncated, and T = S / r_p */
};

/* One particle domain over a regular grid whose node (0, 0) is at `origin`. */
struct mpm_shape_query {
    enum mpm_shape shape;
    enum mpm_geometry geometry;
    enum mpm_axis axis;             /* axisymmetric only */
    double origin[2];               /* position of node (0, 0) */
    double cell[2];                 /* cell size */
    int64_t cells[2];               /* along each axis; 0: the grid has no edges there */
    double position[2];             /* particle centre */
    double half_size[2];            /* half the undeformed size, l_p * cell / 2 */
    double deformation_gradient[4]; /* xx xy yx yy; used by CPDI */
};

enum { MPM_STENCIL_MAX = 16 };

struct mpm_stencil_entry {
    int64_t column, row; /* node, relative to node (0, 0); may be negative */
    double s;            /* S_ip, N&G (6) */
    double g[2];         /* G_ip, N&G (7), 1/length */
    double t;            /* T_ip, N&G (8), 1/length; 0 in planar geometry */
};

/* S, G and T of every node that a particle reaches; each node at most once, entries
 * with S = 0, G = 0 and T = 0 left out. B-splines are adapted to the edges: the first and
 * the last node and, in axisymmetry, r = 0 where nodes lie on it; the particle must be
 * inside. Returns the number of entries. */
size_t mpm_shape_evaluate(const struct mpm_shape_query *query,
                          struct mpm_stencil_entry entries[MPM_STENCIL_MAX]);

MPM_API_END

#endif

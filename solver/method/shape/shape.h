/* Shape functions: what a particle spreads over the nodes it reaches.
 *
 * A family is one file and one line of the table in shape.c. Every family fills a
 * stencil: node by node S_ip, G_ip and T_ip of N&G (6)-(8). A node that the particle
 * does not reach is not in the stencil: weights are exact zeros beyond the edge of the
 * domain, never round-off left by a difference, which would make tiny nodal masses and
 * arbitrary nodal velocities.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_SHAPE_H
#define MPM_METHOD_SHAPE_H

#include "mpm.h"

#include <math.h>

struct mpm_stencil_node {
    int64_t node; /* offset from node (0, 0): row * columns + column */
    double s;     /* S_ip */
    double g[2];  /* G_ip */
    double t;     /* T_ip; 0 in planar geometry */
};

struct mpm_stencil {
    int count;
    struct mpm_stencil_node node[MPM_STENCIL_MAX];
};

/* What is the same for all particles of a scene. */
struct mpm_shape_grid {
    double origin[2];       /* of node (0, 0) */
    double inverse_cell[2]; /* 1 / cell size */
    int64_t columns;        /* distance of two node rows in offsets */
    int64_t edge_low[2];    /* first and last node along each axis: B-splines fold there; */
    int64_t edge_high[2];   /* in axisymmetry r = 0 is an edge */
    bool axisymmetric;
    bool radial;    /* means are weighted with r, N&G (6)-(8); else planar S and G, T = S / r_p */
    bool truncated; /* domains are cut or shrunk at r = 0 */
};

/* The shape functions' view of a grid; `cells` 0: no edges along that axis. */
struct mpm_shape_grid mpm_shape_grid_describe(const double origin[2], const double cell[2],
                                              const int64_t cells[2], enum mpm_geometry geometry,
                                              enum mpm_axis axis);

/* One particle's domain. */
struct mpm_shape_domain {
    double position[2];
    double half_size[2]; /* half the undeformed size: uGIMP */
    double edge[4];      /* domain vectors d1x d1y d2x d2y, half of its edges: CPDI */
};

struct mpm_shape_family {
    const char *name;
    bool convected;   /* the domain deforms with F */
    bool point;       /* there is no domain: functions of the particle's place alone */
    bool lone_node;   /* a particle on a node reaches that one alone */
    double past_next; /* the part of N_i, along an axis, that lies past the next node */
    /* Along an axis, the nodes that kernels visit past the cell in which the reach ends. Fast
     * kernels of domains visit three from the first one on, the last with weight zero where
     * the domain ends before. */
    int nodes_past_end;
    void (*evaluate)(const struct mpm_shape_grid *grid, const struct mpm_shape_domain *domain,
                     struct mpm_stencil *stencil);
    /* Points: the S of another place by the polynomials of the span of cells that the particle at
     * `home` is in, so that the nodes are the particle's own: sum S = 1 and sum x_i S = place
     * hold, S < 0 is possible beyond the span. Of splines S is a continuous function of `home`: see
     * shape_bspline.c. G and T are not of use. Domains: NULL. */
    void (*continue_to)(const struct mpm_shape_grid *grid, const double home[2],
                        const double place[2], struct mpm_stencil *stencil);
    /* Largest distance of the domain from its centre along each axis; of a point, that at
     * which the cells lie whose nodes it reaches. */
    void (*reach)(const struct mpm_shape_grid *grid, const struct mpm_shape_domain *domain,
                  double reach[2]);
};

const struct mpm_shape_family *mpm_shape_family(enum mpm_shape shape);

/* Do the edges of a particle, to which loads are applied, follow F? See edge.h. */
static inline bool mpm_shape_edges_deform(const struct mpm_shape_family *family)
{
    return family->convected || family->point;
}

/* The reach of an undeformed domain. */
void mpm_shape_reach(const struct mpm_shape_family *family, const struct mpm_shape_grid *grid,
                     const double half_size[2], double reach[2]);

extern const struct mpm_shape_family mpm_shape_classic;
extern const struct mpm_shape_family mpm_shape_ugimp;
extern const struct mpm_shape_family mpm_shape_cpdi;
extern const struct mpm_shape_family mpm_shape_bspline2;
extern const struct mpm_shape_family mpm_shape_bspline3;

/* Domain vectors that would pass r = 0 shrink, both, until the domain touches the axis. The
 * smallest radius of its corners is r - (|d1r| + |d2r|). */
static inline void mpm_shape_shrink_to_axis(double r, double d[4])
{
    const double extent = fabs(d[0]) + fabs(d[2]);
    if (extent <= r)
        return;
    const double scale = r / extent;
    for (int k = 0; k < 4; k++)
        d[k] *= scale;
}

/* Domain vectors of a convected domain: the initial ones, half_size along each axis, pushed
 * forward by F (xx xy yx yy first). N&G (31) prints this for square cells and l_p = 1/2. */
static inline void mpm_shape_push_forward(const double f[], const double half_size[2],
                                          double edge[4])
{
    edge[0] = f[0] * half_size[0];
    edge[1] = f[2] * half_size[0];
    edge[2] = f[1] * half_size[1];
    edge[3] = f[3] * half_size[1];
}

/* The largest integer not above x, for |x| < 2^62. */
static inline int64_t mpm_floor(double x)
{
    const int64_t truncated = (int64_t)x;
    return truncated - (x < (double)truncated);
}

/* A coordinate in cells, |x| < 2^51; a value within round-off of a grid line is put on
 * it. Adding and taking away 1.5 2^52 rounds to the nearest integer. */
static inline double mpm_shape_cells(double x)
{
    const double nearest = (x + 0x1.8p52) - 0x1.8p52;
    return fabs(x - nearest) < 0x1p-51 * (1.0 + fabs(nearest)) ? nearest : x;
}

#endif

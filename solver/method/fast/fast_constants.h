/* Fast kernels: what is known when a kernel is compiled, and what stays the same for all
 * particles of one body in a strip.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_CONSTANTS_H
#define MPM_METHOD_FAST_CONSTANTS_H

#include "base/simd.h"
#include "method/state.h"

/* Which kernel: constants of an instance, so that what is off leaves no trace. */
struct fast_spec {
    enum mpm_shape shape;
    bool axisymmetric;
    bool momentum;   /* spread mass and momentum */
    bool affine;     /* with APIC: see fast_affine.h; not of CPDI */
    bool force;      /* spread internal forces */
    bool finish;     /* the last pass, which only reads */
    bool scalars;    /* exchange scalars with nodes, by S: see fast_scalars.h */
    bool conducts;   /* and by G */
    bool alone;      /* nothing else than scalars */
    bool spreads;    /* spread them anew once they are updated */
    bool undeformed; /* F = 1 */
};

/* Nodal arrays of a scalar, one number each. */
enum fast_numbers {
    FAST_CONTENT,
    FAST_CAPACITY,
    FAST_VALUE,
    FAST_INFLOW,
    FAST_RESULT,
    FAST_NUMBERS,
};

/* A scalar that a pass works on, for the particles of a body; see struct mpm_nodal_scalar. */
struct fast_scalar {
    double *nodes[FAST_NUMBERS];
    size_t field;           /* of the particles */
    double weight;          /* c */
    double inverse_density; /* of sources; 0: there are none */
    double kept, part;      /* v_p = kept v_p + part sum S result */
    bool follows_mass;      /* capacities are c times the nodes' masses, which others spread */
    struct mpm_scalar_body conduction;
};

struct fast_constants {
    double origin[2], end[2]; /* of the cells: where particles may be */
    double inverse_cell[2];
    double half[2];                   /* half edges of the undeformed domain; the reach of points */
    double edge_low[2], edge_high[2]; /* first and last node, where B-splines fold */
    double axis;                      /* place of r = 0, in cells */
    double cut;        /* domains are cut off there (uGIMP), in cells; or minus infinity */
    double cut_cell;   /* the cell of that place */
    bool truncated;    /* domains shrink to r = 0 (CPDI) */
    double columns;    /* distance of two rows of nodes in offsets, */
    int64_t stride;    /* the same, */
    int64_t pitch;     /* and in bytes of a nodal vector */
    int64_t node_zero; /* index of node (0, 0) */
    double *mass;      /* arrays of the grid, by node index */
    struct mpm_node_sum (*sum)[2];
    double *read; /* nodal vectors that are read with S: motion; of a projection `from`, or NULL */
    double (*gradient)[2][2];      /* in a projection its `to`, if it has one */
    struct fast_scalar scalar;     /* that is conducted, if one is */
    double time_step, stress_step; /* the latter is the part that this update stands for */
    double part;                   /* stress_step of time_step */
    double back;                   /* of the midpoint update: v^{n+1} - back a */
    int deformation_terms;
    double lowest_reach[2], highest_reach[2]; /* where their domains may be */
    double cell[2];                           /* the longest step, too */
    struct mpm_material material;
    const struct mpm_viscosity *viscosity; /* of the body */
};

struct fast_sums;

/* Of particles first..end - 1: F := dF F of velocity gradients, one for each vector, and the stress
 * of the new F. Without gradients (NULL): the stress of the F at hand. */
typedef void mpm_fast_update(const struct fast_constants *k, const struct mpm_particles *particles,
                             size_t first, size_t end, struct fast_sums *sums,
                             const mpm_vector (*gradient)[MPM_GRADIENT_SIZE]);

/* The nodal vector of a node j rows further. */
MPM_INLINE double *fast_row(const void *array, int64_t node, int64_t j,
                            const struct fast_constants *k)
{
    return (void *)((char *)array + node * (int64_t)sizeof(mpm_vector) + j * k->pitch);
}

/* What four particles spread. */
struct fast_load {
    mpm_vector mass;
    mpm_vector momentum[2];
    mpm_vector affine[4];                  /* m_p C_p, of APIC */
    mpm_vector stress[MPM_SYMMETRIC_SIZE]; /* -m tau / rho_0 */
};

/* See mpm_shape_cells; *cell is the largest integer not above. */
MPM_INLINE mpm_vector fast_cells(mpm_vector x, mpm_vector *cell)
{
    const mpm_vector nearest = mpm_nearest(x);
    const mpm_vector slack = 0x1p-51 * (1.0 + mpm_absolute(nearest));
    const mpm_mask close = mpm_less(mpm_absolute(x - nearest), slack);
    const mpm_vector place = mpm_select(close, nearest, x);
    *cell = mpm_down_to_integer(place, nearest);
    return place;
}

/* The same without the cell. */
MPM_INLINE mpm_vector fast_snap(mpm_vector x)
{
    mpm_vector unused;
    return fast_cells(x, &unused);
}

#endif

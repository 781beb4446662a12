/* The contour of a J integral: what its nodes hold and the integral along it. See j_integral.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_J_CONTOUR_H
#define MPM_METHOD_J_CONTOUR_H

#include "method/state.h"

/* Sums over the particles of one field of a node, with A_p S_ip, the last three with S_ip. */
struct mpm_j_sums {
    double area;
    double stress[3];                   /* s: xx yy xy */
    double gradient[MPM_GRADIENT_SIZE]; /* F - I */
    double energy;                      /* e */
    double free_strain;
    double mass, momentum[2], force[2];
};

/* A node: by mpm_crack_side. */
struct mpm_j_node {
    struct mpm_j_sums side[3];
};

/* Where a tip is in the undeformed body, and in which direction it points there. */
struct mpm_j_tip {
    double place[2], direction[2];
};

/* What a particle carries, per undeformed area. */
struct mpm_j_particle {
    size_t p;
    double place[2], v[2];
    double f[MPM_GRADIENT_SIZE];
    double tau[MPM_SYMMETRIC_SIZE];
    double energy;      /* W + K */
    double free_strain; /* transfer/law_state.h; 0 of materials that do not expand */
    double plane;       /* J_2 */
    double area;        /* undeformed */
    double density;
};

/* Nodes stored around the rectangle: those of particles that reach it. */
enum { MPM_J_MARGIN = 4 };

struct mpm_j_contour {
    const struct mpm_state *state;
    const struct mpm_j_integral_spec *spec;
    const struct mpm_j_tip *tip;
    struct mpm_j_node *nodes;     /* of the rectangle and its margin, row by row */
    struct mpm_crack_part *parts; /* per crack; first == end: nothing of it is near */
    int64_t low[2], high[2];      /* columns and rows of the rectangle, ghosts counted */
    int64_t width;                /* nodes of a row, margin included */
    double common[4];             /* C of j_integral.h, less the unit tensor: xx xy yx yy */
};

/* Is this column or row within so many of the rectangle? */
static inline bool mpm_j_is_within(const struct mpm_j_contour *contour, const int64_t at[2],
                                   int64_t margin)
{
    return at[0] >= contour->low[0] - margin && at[0] <= contour->high[0] + margin &&
           at[1] >= contour->low[1] - margin && at[1] <= contour->high[1] + margin;
}

static inline struct mpm_j_node *mpm_j_node_at(const struct mpm_j_contour *contour,
                                               const int64_t at[2])
{
    return &contour->nodes[(at[1] - contour->low[1] + MPM_J_MARGIN) * contour->width +
                           (at[0] - contour->low[0] + MPM_J_MARGIN)];
}

static inline void mpm_j_place(const struct mpm_j_contour *contour, const int64_t at[2],
                               double place[2])
{
    mpm_grid_position(&contour->state->grid, at[1] * contour->state->grid.columns + at[0], place);
}

/* The place of a tip now. */
void mpm_j_tip_place(const struct mpm_state *state, const struct mpm_j_integral_spec *spec,
                     double place[2]);

/* From which side, of the first crack that decides it, is the place `to` seen from `from`? `crack`,
 * unless NULL, gets that crack. */
enum mpm_crack_side mpm_j_side(const struct mpm_j_contour *contour, const double from[2],
                               const double to[2], size_t *crack);

/* Sets `common` once the nodes are filled. */
void mpm_j_contour_find_common(struct mpm_j_contour *contour);

/* Integral of [...] dS in both directions of the axes; `met` as in struct mpm_j_value. */
enum mpm_status mpm_j_contour_integrate(const struct mpm_j_contour *contour, double j[2],
                                        size_t *met, struct mpm_error *error);

#endif

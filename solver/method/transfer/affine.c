/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/affine.h"

#include "method/fields/fields.h"
#include "method/transfer/particle_updates.h"
#include "method/transfer/transfer.h"

/* A particle's nodes as seen from the mean of their places. */
struct surroundings {
    const struct mpm_stencil *stencil;
    double away[MPM_STENCIL_MAX][2]; /* x_i - y_p */
    double moment[3];                /* D_p: xx, yy, xy */
};

/* An additional field of a node is where its parent is. Places count from the first node: far from
 * the grid's origin digits of the distances would be lost. */
static void look_around(const struct mpm_state *state, const struct mpm_stencil *stencil,
                        struct surroundings *around)
{
    const struct mpm_grid *const grid = &state->grid;
    const int64_t first = mpm_field_parent(state, state->node_zero + stencil->node[0].node);
    double mean[2] = {0.0, 0.0};
    around->stencil = stencil;
    for (int k = 0; k < stencil->count; k++) {
        const int64_t node = mpm_field_parent(state, state->node_zero + stencil->node[k].node);
        const int64_t columns = node % grid->columns - first % grid->columns;
        const int64_t rows = node / grid->columns - first / grid->columns;
        around->away[k][0] = grid->cell[0] * (double)columns;
        around->away[k][1] = grid->cell[1] * (double)rows;
        for (int axis = 0; axis < 2; axis++)
            mean[axis] += stencil->node[k].s * around->away[k][axis];
    }
    double xx = 0.0, yy = 0.0, xy = 0.0;
    for (int k = 0; k < stencil->count; k++) {
        for (int axis = 0; axis < 2; axis++)
            around->away[k][axis] -= mean[axis];
        const double x = around->away[k][0], y = around->away[k][1];
        xx += stencil->node[k].s * x * x;
        yy += stencil->node[k].s * y * y;
        xy += stencil->node[k].s * x * y;
    }
    around->moment[0] = xx;
    around->moment[1] = yy;
    around->moment[2] = xy;
}

/* C_p, xx xy yx yy: stored as it is where D_p may be singular, B_p D_p^{-1} for others */
static void affine_of(const struct mpm_state *state, size_t p, const struct surroundings *around,
                      double c[4])
{
    double kept[4];
    for (int k = 0; k < 4; k++)
        c[k] = kept[k] = state->particles.affine[k][p];
    if (state->family->lone_node)
        return;
    const double xx = around->moment[0], yy = around->moment[1], xy = around->moment[2];
    const double inverse = 1.0 / (xx * yy - xy * xy);
    for (int row = 0; row < 4; row += 2) {
        const double along_x = kept[row], along_y = kept[row + 1];
        if (xx == 0.0 || yy == 0.0) { /* no node at a distance along that axis */
            c[row] = xx == 0.0 ? 0.0 : along_x / xx;
            c[row + 1] = yy == 0.0 ? 0.0 : along_y / yy;
        } else {
            c[row] = (along_x * yy - along_y * xy) * inverse;
            c[row + 1] = (along_y * xx - along_x * xy) * inverse;
        }
    }
}

/* m_p (v_p + C_p (x_i - y_p)) S_ip */
static void node_momentum(const struct mpm_state *state, size_t p,
                          const struct surroundings *around, const double c[4], int k,
                          double momentum[2])
{
    const double weight = state->particles.mass[p] * around->stencil->node[k].s;
    for (int axis = 0; axis < 2; axis++) {
        const double v = state->particles.velocity[axis][p];
        const double change =
            c[2 * axis] * around->away[k][0] + c[2 * axis + 1] * around->away[k][1];
        momentum[axis] = weight * (v + change);
    }
}

static void add_momentum(const struct mpm_state *state, size_t p, const struct surroundings *around)
{
    double c[4];
    affine_of(state, p, around, c);
    for (int k = 0; k < around->stencil->count; k++) {
        const struct mpm_stencil_node *const entry = &around->stencil->node[k];
        const int64_t node = state->node_zero + entry->node;
        double momentum[2];
        node_momentum(state, p, around, c, k, momentum);
        state->grid.mass[node] += state->particles.mass[p] * entry->s;
        for (int axis = 0; axis < 2; axis++)
            state->grid.sum[node][axis].momentum += momentum[axis];
    }
}

static inline void to_grid(const struct mpm_state *state, int64_t index, bool force)
{
    const struct mpm_strip *const strip = &state->strips[index];
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room;
        struct surroundings around;
        look_around(state, mpm_particle_stencil(state, p, &room), &around);
        add_momentum(state, p, &around);
        if (force)
            mpm_particle_add_internal_force(state, p, around.stencil);
    }
}

MPM_PASS(mpm_pass_affine_momentum, to_grid, false)
MPM_PASS(mpm_pass_affine_momentum_and_force, to_grid, true)

/* B_p, or sum v_i G_ip^T */
static void update_affine(const struct mpm_state *state, size_t p,
                          const struct surroundings *around)
{
    const bool lone = state->family->lone_node;
    double sum[4] = {0.0, 0.0, 0.0, 0.0};
    for (int k = 0; k < around->stencil->count; k++) {
        const struct mpm_stencil_node *const entry = &around->stencil->node[k];
        const double *const v = state->grid.motion[state->node_zero + entry->node].end;
        for (int axis = 0; axis < 2; axis++) {
            const double along = lone ? entry->g[axis] : entry->s * around->away[k][axis];
            sum[axis] += v[0] * along;
            sum[2 + axis] += v[1] * along;
        }
    }
    for (int k = 0; k < 4; k++)
        state->particles.affine[k][p] = sum[k];
}

static void add_extrapolated(const struct mpm_state *state, size_t p,
                             const struct surroundings *around)
{
    double c[4];
    affine_of(state, p, around, c);
    for (int k = 0; k < around->stencil->count; k++) {
        double momentum[2];
        double(*const sum)[2] =
            state->grid.gradient[state->node_zero + around->stencil->node[k].node];
        node_momentum(state, p, around, c, k, momentum);
        for (int axis = 0; axis < 2; axis++)
            sum[axis][0] += momentum[axis];
    }
}

static inline void to_particles(struct mpm_state *state, int64_t index, bool extrapolate)
{
    struct mpm_strip *const strip = &state->strips[index];
    strip->kinetic_energy = 0.0;
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room;
        struct surroundings around;
        look_around(state, mpm_particle_stencil(state, p, &room), &around);
        mpm_particle_update_velocity(state, p, around.stencil, strip);
        update_affine(state, p, &around);
        if (extrapolate)
            add_extrapolated(state, p, &around);
    }
}

MPM_PASS(mpm_pass_affine_velocity, to_particles, false)
MPM_PASS(mpm_pass_affine_velocity_and_momentum, to_particles, true)

double mpm_particle_spin(const struct mpm_state *state, size_t p)
{
    double *const *const kept = state->particles.affine;
    if (!state->family->lone_node)
        return kept[2][p] - kept[1][p];
    struct mpm_stencil room;
    struct surroundings around;
    mpm_particle_plain_stencil(state, p, &room); /* places of nodes alone count */
    look_around(state, &room, &around);
    const double xx = around.moment[0], yy = around.moment[1], xy = around.moment[2];
    return (kept[2][p] * xx + kept[3][p] * xy) - (kept[0][p] * xy + kept[1][p] * yy);
}

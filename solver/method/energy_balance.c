/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/energy_balance.h"

#include "base/strips.h"
#include "method/cracks/cohesive_traction.h"
#include "method/fields/fields.h"
#include "method/grid/grid_update.h"
#include "method/transfer/transfer.h"

/* ------------------------------------------------------------------- nodes */

static void row_kinetic(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span_inside(state, row);
    double start = 0.0, end = 0.0;
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++)
        for (int axis = 0; axis < 2; axis++) {
            const double m = state->grid.mass[node], s = state->grid.start[node][axis];
            const double e = state->grid.motion[node].end[axis];
            start += 0.5 * m * s * s;
            end += 0.5 * m * e * e;
        }
    state->row_sums[row].kinetic[0] = start;
    state->row_sums[row].kinetic[1] = end;
}

/* K_i at both ends of the step. */
static void nodal_kinetic(struct mpm_state *state, double kinetic[2])
{
    kinetic[0] = kinetic[1] = 0.0;
    mpm_grid_rows_run(state, row_kinetic);
    for (int64_t row = state->first_row; row >= 0; row = mpm_grid_next_row(state, row))
        for (int k = 0; k < 2; k++)
            kinetic[k] += state->row_sums[row].kinetic[k];
}

/* Contact changes v_i^{n+1} alone, by d: K_i by m (v_i^{n+1} + d/2) . d, of which dt f_i . d/2 is
 * work of the forces, which is measured with the changed velocity. Mirror nodes get theirs after
 * contact, whatever it did to them. */
static void row_free_energy(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span_inside(state, row);
    double sum = 0.0;
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++) {
        if (mpm_field_parent(state, node) % state->grid.columns < state->conditions.mirror_column)
            continue;
        for (int axis = 0; axis < 2; axis++) {
            const double e = state->grid.motion[node].end[axis];
            const double f = state->grid.sum[node][axis].force;
            sum += 0.5 * e * (state->grid.mass[node] * e - state->time_step * f);
        }
    }
    state->row_sums[row].kinetic[1] = sum;
}

/* What contact has lowered less what conditions did meanwhile, and what damping took of it, where
 * that follows contact (damping.h). */
static double before_less_after(struct mpm_state *state)
{
    double sum = state->damping.totals.dissipated - state->external_work;
    mpm_grid_rows_run(state, row_free_energy);
    for (int64_t row = state->first_row; row >= 0; row = mpm_grid_next_row(state, row))
        sum += state->row_sums[row].kinetic[1];
    return sum;
}

static bool measures_contact(const struct mpm_state *state)
{
    return state->energy.measured &&
           (state->fields.node_count > 0 || state->contact.node_count > 0);
}

void mpm_energy_before_contact(struct mpm_state *state)
{
    if (measures_contact(state))
        state->energy.contact += before_less_after(state);
}

void mpm_energy_after_contact(struct mpm_state *state)
{
    if (measures_contact(state))
        state->energy.contact -= before_less_after(state);
}

/* ---------------------------------------------------------- internal forces */

/* -sum_i f_i . (v_i^n + v_i^{n+1}) of the forces that the particle's stress gives to the nodes */
static double stress_power(const struct mpm_state *state, size_t p,
                           const struct mpm_stencil *stencil)
{
    double *const *const stress = state->particles.stress;
    double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0;
    for (int k = 0; k < stencil->count; k++) {
        const struct mpm_stencil_node *const entry = &stencil->node[k];
        const int64_t node = state->node_zero + entry->node;
        const double *const start = state->grid.start[node];
        const double *const end = state->grid.motion[node].end;
        const double v[2] = {start[0] + end[0], start[1] + end[1]};
        xx += v[0] * entry->g[0];
        yy += v[1] * entry->g[1];
        zz += v[0] * entry->t;
        xy += v[0] * entry->g[1] + v[1] * entry->g[0];
    }
    return state->particles.mass[p] * (stress[MPM_SYM_XX][p] * xx + stress[MPM_SYM_YY][p] * yy +
                                       stress[MPM_SYM_ZZ][p] * zz + stress[MPM_SYM_XY][p] * xy);
}

static void internal_work_strip(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    struct mpm_strip *const strip = &state->strips[index];
    double power = 0.0;
    (void)worker;
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room;
        power += stress_power(state, p, mpm_particle_stencil(state, p, &room));
    }
    strip->internal_work = 0.5 * state->time_step * power;
}

void mpm_energy_measure_nodes(struct mpm_state *state, int workers)
{
    struct mpm_energy_balance *const energy = &state->energy;
    double kinetic[2];
    if (!energy->measured)
        return;
    nodal_kinetic(state, kinetic);
    mpm_strips_run(state->strip_count, workers, internal_work_strip, state);
    energy->lost += energy->particles - kinetic[0] + kinetic[1];
    for (int64_t s = 0; s < state->strip_count; s++)
        energy->internal_work += state->strips[s].internal_work;
    energy->internal_work += mpm_cohesive_nodal_work(state);
    energy->dissipated = state->damping.totals.dissipated;
}

/* --------------------------------------------------------------- particles */

void mpm_energy_measure_particles(struct mpm_state *state)
{
    struct mpm_energy_balance *const energy = &state->energy;
    if (!energy->measured)
        return;
    energy->particles = 0.0;
    for (int64_t s = 0; s < state->strip_count; s++)
        energy->particles += state->strips[s].kinetic_energy;
    energy->lost -= energy->particles + state->damping.totals.dissipated - energy->dissipated;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/transfer.h"

#include "method/fields/fields.h"
#include "method/grid/symmetry.h"
#include "method/transfer/law_state.h"
#include "method/transfer/particle_updates.h"

#include <float.h>

/* ------------------------------------------------------------ the particle */

static void edges_of(const struct mpm_state *state, size_t p, double edge[4])
{
    const struct mpm_particles *const particles = &state->particles;
    double f[MPM_GRADIENT_SIZE];
    mpm_particle_deformation(particles, p, f);
    mpm_shape_push_forward(f, state->bodies[particles->body[p]].half_size, edge);
}

static struct mpm_shape_domain undeformed_domain(const struct mpm_state *state, size_t p)
{
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_body *const body = &state->bodies[particles->body[p]];
    return (struct mpm_shape_domain){
        .position = {particles->position[0][p], particles->position[1][p]},
        .half_size = {body->half_size[0], body->half_size[1]},
    };
}

struct mpm_shape_domain mpm_particle_carried_domain(const struct mpm_state *state, size_t p)
{
    struct mpm_shape_domain domain = undeformed_domain(state, p);
    edges_of(state, p, domain.edge);
    return domain;
}

MPM_INLINE struct mpm_shape_domain domain_of(const struct mpm_state *state, size_t p)
{
    const struct mpm_particles *const particles = &state->particles;
    struct mpm_shape_domain domain = undeformed_domain(state, p);
    if (particles->domain[0] != NULL)
        for (int k = 0; k < 4; k++)
            domain.edge[k] = particles->domain[k][p];
    else if (state->family->convected)
        edges_of(state, p, domain.edge);
    return domain;
}

void mpm_particle_set_domain(const struct mpm_state *state, size_t p)
{
    double edge[4];
    if (state->particles.domain[0] == NULL)
        return;
    edges_of(state, p, edge);
    for (int k = 0; k < 4; k++)
        state->particles.domain[k][p] = edge[k];
}

static inline void evaluate(const struct mpm_state *state, size_t p, struct mpm_stencil *stencil)
{
    const struct mpm_shape_domain domain = domain_of(state, p);
    state->family->evaluate(&state->shape_grid, &domain, stencil);
}

void mpm_particle_grid_stencil(const struct mpm_state *state, size_t p, struct mpm_stencil *stencil)
{
    evaluate(state, p, stencil);
}

void mpm_particle_plain_stencil(const struct mpm_state *state, size_t p,
                                struct mpm_stencil *stencil)
{
    const int64_t shift = mpm_layer_shift(state, state->bodies[state->particles.body[p]].layer);
    evaluate(state, p, stencil);
    for (int k = 0; shift != 0 && k < stencil->count; k++)
        stencil->node[k].node += shift;
}

/* Of scenes with additional velocity fields. */
static const struct mpm_stencil *stencil_in_fields(const struct mpm_state *state, size_t p,
                                                   struct mpm_stencil *room)
{
    const struct mpm_field_use *const use = mpm_field_use_of(state, p);
    if (use != NULL)
        return &use->stencil;
    mpm_particle_plain_stencil(state, p, room);
    return room;
}

const struct mpm_stencil *mpm_particle_stencil(const struct mpm_state *state, size_t p,
                                               struct mpm_stencil *room)
{
    if (state->grid.field_rows > 0)
        return stencil_in_fields(state, p, room);
    evaluate(state, p, room);
    return room;
}

MPM_SEPARATE const struct mpm_stencil *momentum_weights(const struct mpm_state *state,
                                                        const struct mpm_stencil *stencil,
                                                        struct mpm_stencil *weights)
{
    double mass = 0.0;
    for (int k = 0; k < stencil->count; k++)
        mass += stencil->node[k].s *
                mpm_symmetry_whole_mass(state, state->node_zero + stencil->node[k].node);
    weights->count = stencil->count;
    for (int k = 0; k < stencil->count; k++) {
        const struct mpm_stencil_node *const entry = &stencil->node[k];
        const double part = mpm_symmetry_whole_mass(state, state->node_zero + entry->node) / mass;
        weights->node[k] = (struct mpm_stencil_node){
            .node = entry->node,
            .s = part * entry->s,
            .g = {part * entry->g[0], part * entry->g[1]},
            .t = part * entry->t,
        };
    }
    return weights;
}

static bool reads_by_momentum(const struct mpm_state *state)
{
    return state->scene->form == MPM_FORM_MOMENTUM;
}

/* The weights of what a particle reads back: the stencil itself, or `weights` in the momentum form,
 * Notes 5.2, (67), (73)-(78). With the mass M = sum S m_i that the nodes have at the particle,
 * (sum S p_i) / M is sum (S m_i / M) v_i, and so for gradients and for forces, f_i = m_i a_i:
 * velocities with other weights. M > 0, since the particle is part of it; p_i = m_i v_i of held
 * nodes is that of the velocity they are held at.
 *
 * (79) read to the letter adds the nodes' force to the particle's momentum, which divides by m_p:
 * dt (sum S f_i) / m_p, a velocity that grows with the number of particles in a cell. Taken
 * instead, as in (76): v_p += dt (sum S f_i) / M.
 *
 * What it is not: nodes at a body's edge have little mass, so that sum G p_i / M has the slope of
 * the mass in it, and a rigid translation strains there (of the order v / cell); and the sum of
 * the particles' momenta is not conserved. Where m_i is the same at all nodes of a particle both
 * forms are one. */
MPM_INLINE const struct mpm_stencil *read_weights(const struct mpm_state *state, bool by_momentum,
                                                  const struct mpm_stencil *stencil,
                                                  struct mpm_stencil *weights)
{
    return by_momentum ? momentum_weights(state, stencil, weights) : stencil;
}

/* ------------------------------------------------------ particles to grid */

static void add_momentum(const struct mpm_state *state, size_t p, const struct mpm_stencil *stencil)
{
    const double mass = state->particles.mass[p];
    const double px = mass * state->particles.velocity[0][p];
    const double py = mass * state->particles.velocity[1][p];
    for (int k = 0; k < stencil->count; k++) {
        const struct mpm_stencil_node *const entry = &stencil->node[k];
        const int64_t node = state->node_zero + entry->node;
        state->grid.mass[node] += mass * entry->s;
        state->grid.sum[node][0].momentum += px * entry->s;
        state->grid.sum[node][1].momentum += py * entry->s;
    }
}

MPM_INLINE void to_grid(const struct mpm_state *state, int64_t index, bool force)
{
    for (size_t p = state->strips[index].begin; p < state->strips[index].end; p++) {
        struct mpm_stencil room;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        add_momentum(state, p, stencil);
        if (force)
            mpm_particle_add_internal_force(state, p, stencil);
    }
}

MPM_PASS(mpm_pass_momentum, to_grid, false)
MPM_PASS(mpm_pass_momentum_and_force, to_grid, true)

/* ------------------------------------------------------------ body forces */

bool mpm_particle_body_force(const struct mpm_state *state, size_t p, int worker,
                             struct mpm_strip *strip, double b[2])
{
    const double position[2] = {state->particles.position[0][p], state->particles.position[1][p]};
    for (int axis = 0; axis < 2; axis++) {
        const struct mpm_expression *const force = state->body_force.component[axis];
        b[axis] = force == NULL ? 0.0 : mpm_expression_value(force, worker, position, state->time);
        if (!isfinite(b[axis])) {
            mpm_strip_record(strip, MPM_LOAD_NOT_FINITE, state->particles.id[p], axis, b[axis]);
            return false;
        }
    }
    return true;
}

void mpm_pass_body_force(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    struct mpm_strip *const strip = &state->strips[index];
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room;
        double b[2];
        if (!mpm_particle_body_force(state, p, worker, strip, b))
            continue;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        for (int k = 0; k < stencil->count; k++) {
            struct mpm_node_sum *const sum =
                state->grid.sum[state->node_zero + stencil->node[k].node];
            const double weight = state->particles.mass[p] * stencil->node[k].s;
            sum[0].force += weight * b[0];
            sum[1].force += weight * b[1];
        }
    }
}

void mpm_pass_body_work(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    struct mpm_strip *const strip = &state->strips[index];
    strip->external_work = 0.0;
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room;
        double b[2], power = 0.0;
        if (!mpm_particle_body_force(state, p, worker, strip, b))
            continue;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        for (int k = 0; k < stencil->count; k++) {
            const int64_t node = state->node_zero + stencil->node[k].node;
            const double *const start = state->grid.start[node];
            const double *const end = state->grid.motion[node].end;
            power += stencil->node[k].s * (b[0] * (start[0] + end[0]) + b[1] * (start[1] + end[1]));
        }
        strip->external_work += 0.5 * state->time_step * state->particles.mass[p] * power;
    }
}

/* -------------------------------------------------------- velocity update */

void mpm_particle_gather(const struct mpm_state *state, size_t p, double (*const nodes)[2],
                         double value[2])
{
    struct mpm_stencil room, weights;
    const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
    const struct mpm_stencil *const read =
        read_weights(state, reads_by_momentum(state), stencil, &weights);
    value[0] = value[1] = 0.0;
    for (int k = 0; k < read->count; k++) {
        const double *const node = nodes[state->node_zero + read->node[k].node];
        value[0] += read->node[k].s * node[0];
        value[1] += read->node[k].s * node[1];
    }
}

void mpm_pass_flip_fraction(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_strip *const strip = &state->strips[index];
    const double part = 1.0 - state->scene->flip_fraction;
    (void)worker;
    for (size_t p = strip->begin; p < strip->end; p++) {
        double grid[2];
        mpm_particle_gather(state, p, state->grid.start, grid);
        for (int axis = 0; axis < 2; axis++) {
            double *const v = &state->particles.velocity[axis][p];
            *v -= part * (*v - grid[axis]);
        }
    }
}

void mpm_pass_keep_fraction(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_strip *const strip = &state->strips[index];
    const double kept = state->scene->flip_fraction;
    (void)worker;
    for (int axis = 0; axis < 2; axis++) {
        double *const velocity = state->particles.velocity[axis];
        for (size_t p = strip->begin; p < strip->end; p++)
            velocity[p] *= kept;
    }
}

MPM_INLINE void to_particles(struct mpm_state *state, int64_t index, bool extrapolate)
{
    struct mpm_strip *const strip = &state->strips[index];
    const bool by_momentum = reads_by_momentum(state);
    strip->kinetic_energy = 0.0;
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room, weights;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        const struct mpm_stencil *const read = read_weights(state, by_momentum, stencil, &weights);
        mpm_particle_update_velocity(state, p, read, strip);
        if (!extrapolate)
            continue;
        const double px = state->particles.mass[p] * state->particles.velocity[0][p];
        const double py = state->particles.mass[p] * state->particles.velocity[1][p];
        mpm_particle_add_extrapolated(state, stencil, (const double[2]){px, py});
    }
}

MPM_PASS(mpm_pass_velocity, to_particles, false)
MPM_PASS(mpm_pass_velocity_and_momentum, to_particles, true)

/* ---------------------------------------------------------- stress update */

/* dt grad v at the particle, N&G (10), (12)-(14) */
static void displacement_gradient(const struct mpm_state *state, const struct mpm_stencil *stencil,
                                  double dt, double h[MPM_GRADIENT_SIZE])
{
    double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0, zz = 0.0;
    for (int k = 0; k < stencil->count; k++) {
        const struct mpm_stencil_node *const entry = &stencil->node[k];
        const double(*const v)[2] =
            (const double(*)[2])state->grid.gradient[state->node_zero + entry->node];
        xx += v[0][0] * entry->g[0];
        xy += v[0][0] * entry->g[1];
        yx += v[1][0] * entry->g[0];
        yy += v[1][0] * entry->g[1];
        zz += v[0][0] * entry->t;
    }
    h[MPM_XX] = dt * xx;
    h[MPM_XY] = dt * xy;
    h[MPM_YX] = dt * yx;
    h[MPM_YY] = dt * yy;
    h[MPM_ZZ] = dt * zz;
}

/* F := dF F, N&G (9), its F_zz that of plane strain; the determinant */
MPM_INLINE double deform(const struct mpm_state *state, size_t p, const struct mpm_stencil *stencil,
                         double part, double f[MPM_GRADIENT_SIZE])
{
    double h[MPM_GRADIENT_SIZE], df[MPM_GRADIENT_SIZE];
    displacement_gradient(state, stencil, part * state->time_step, h);
    mpm_deformation_increment(h, state->scene->deformation_terms, df);
    mpm_particle_deformation(&state->particles, p, f);
    mpm_deformation_compose(df, f);
    return mpm_determinant(f);
}

/* False, with the failure in `strip`, if det F is not above 0. */
MPM_INLINE bool set_deformation(const struct mpm_particles *particles, size_t p,
                                const double f[MPM_GRADIENT_SIZE], double j,
                                struct mpm_strip *strip)
{
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        particles->deformation[k][p] = f[k];
    if (!(j > 0.0))
        mpm_strip_record(strip, MPM_INVERTED, particles->id[p], 0, j);
    return j > 0.0;
}

void mpm_particle_take_deformation(const struct mpm_state *state, size_t p, double part,
                                   double f[MPM_GRADIENT_SIZE], struct mpm_strip *strip)
{
    double stress[MPM_SYMMETRIC_SIZE] = {0.0}, wave_speed_squared = 0.0;
    double j = mpm_determinant(f);
    if (j > 0.0) {
        if (!mpm_particle_update_law(state, p, part, f, strip, stress, &wave_speed_squared))
            return;
        j = mpm_determinant(f);
    }
    if (set_deformation(&state->particles, p, f, j, strip))
        mpm_particle_set_stress(&state->particles, p, stress, wave_speed_squared, strip);
}

/* Not inlined: scenes without such laws would pay for it. */
MPM_SEPARATE void update_with_state(const struct mpm_state *state, size_t p,
                                    const struct mpm_stencil *stencil, double part,
                                    struct mpm_strip *strip)
{
    double f[MPM_GRADIENT_SIZE];
    (void)deform(state, p, stencil, part, f);
    mpm_particle_take_deformation(state, p, part, f, strip);
}

static void update_stress(const struct mpm_state *state, size_t p,
                          const struct mpm_stencil *stencil, double part, struct mpm_strip *strip)
{
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_material *const material = &state->bodies[particles->body[p]].material;
    double f[MPM_GRADIENT_SIZE], stress[MPM_SYMMETRIC_SIZE], wave_speed_squared;
    if (state->law_states) {
        update_with_state(state, p, stencil, part, strip);
        return;
    }
    double j = deform(state, p, stencil, part, f);
    if (j > 0.0 && state->scene->geometry == MPM_PLANE_STRESS) {
        f[MPM_ZZ] = material->law->thickness_stretch(material, f);
        j = mpm_determinant(f);
    }
    if (!set_deformation(particles, p, f, j, strip))
        return;
    material->law->stress(material, f, stress, &wave_speed_squared);
    mpm_particle_set_stress(particles, p, stress, wave_speed_squared, strip);
}

void mpm_pass_stress_and_force(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    struct mpm_strip *const strip = &state->strips[index];
    const bool by_momentum = reads_by_momentum(state);
    (void)worker;
    strip->wave_speed_squared = 0.0;
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room, weights;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        const struct mpm_stencil *const read = read_weights(state, by_momentum, stencil, &weights);
        update_stress(state, p, read, state->order->before, strip);
        mpm_particle_add_internal_force(state, p, stencil);
    }
}

/* -------------------------------------------------------- position update */

static struct mpm_placement placement_of(const struct mpm_state *state, size_t p)
{
    const struct mpm_shape_domain domain = domain_of(state, p);
    struct mpm_placement placement = {.position = {domain.position[0], domain.position[1]}};
    state->family->reach(&state->shape_grid, &domain, placement.reach);
    if (state->shape_grid.axisymmetric && state->shape_grid.truncated && !state->family->point &&
        placement.reach[0] > domain.position[0])
        placement.reach[0] = domain.position[0];
    return placement;
}

struct mpm_placement mpm_particle_placement(const struct mpm_state *state, size_t p)
{
    return placement_of(state, p);
}

/* The grid's velocity at the particle over the step: v^{n+1}, or the mean of start and
 * end for the midpoint update (Notes (37), without damping). */
static void update_position(const struct mpm_state *state, size_t p,
                            const struct mpm_stencil *stencil, struct mpm_strip *strip,
                            struct mpm_extents *extents)
{
    const struct mpm_particles *const particles = &state->particles;
    const double back =
        state->scene->position_update == MPM_MIDPOINT ? 0.5 * state->time_step : 0.0;
    const bool hoop = state->scene->radius_update == MPM_RADIUS_HOOP;
    double v[2] = {0.0, 0.0}, hoop_rate = 0.0;
    for (int k = 0; k < stencil->count; k++) {
        const struct mpm_stencil_node *const entry = &stencil->node[k];
        const struct mpm_node_motion *const motion =
            &state->grid.motion[state->node_zero + entry->node];
        const double vx = motion->end[0] - back * motion->acceleration[0];
        v[0] += entry->s * vx;
        v[1] += entry->s * (motion->end[1] - back * motion->acceleration[1]);
        hoop_rate += entry->t * vx;
    }
    const double rate = hoop ? particles->position[0][p] * hoop_rate : v[0];
    const double step[2] = {state->time_step * rate, state->time_step * v[1]};
    particles->position[0][p] += step[0];
    particles->position[1][p] += step[1];
    mpm_particle_set_domain(state, p);
    struct mpm_placement placement = placement_of(state, p);
    placement.step[0] = step[0];
    placement.step[1] = step[1];
    if (mpm_placement_check(state, &placement, particles->id[p], strip))
        mpm_extents_add(extents, state->bodies[particles->body[p]].layer, &placement);
}

MPM_INLINE void finish(struct mpm_state *state, int64_t index, bool stress)
{
    struct mpm_strip *const strip = &state->strips[index];
    struct mpm_extents extents;
    const bool by_momentum = reads_by_momentum(state);
    mpm_extents_begin(state, &extents);
    if (stress)
        strip->wave_speed_squared = 0.0;
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room, weights;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        const struct mpm_stencil *const read = read_weights(state, by_momentum, stencil, &weights);
        if (stress)
            update_stress(state, p, read, state->order->after, strip);
        update_position(state, p, read, strip, &extents);
    }
    if (strip->failure.kind == MPM_NO_FAILURE)
        mpm_strip_set_boxes(state, strip, &extents);
}

MPM_PASS(mpm_pass_position, finish, false)
MPM_PASS(mpm_pass_stress_and_position, finish, true)

/* Fast kernels: what a pass does with a block of particles, vector by vector. Compare
 * transfer.c, which does the same one particle at a time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_PASSES_H
#define MPM_METHOD_FAST_PASSES_H

#include "method/fast/fast_block.h"
#include "method/fast/fast_patches.h"
#include "method/fast/fast_scalars.h"
#include "method/transfer/extent.h"

/* ----------------------------------------------------------- either stencil */

/* Half edges of the CPDI domains of F */
MPM_INLINE void edges_of(const struct fast_constants *k, const mpm_vector f[MPM_GRADIENT_SIZE],
                         mpm_vector edge[4])
{
    edge[0] = f[MPM_XX] * k->half[0];
    edge[1] = f[MPM_YX] * k->half[0];
    edge[2] = f[MPM_XY] * k->half[1];
    edge[3] = f[MPM_YY] * k->half[1];
}

/* Where a block's half edges are read, and times what: kept where F changes within a step, else
 * columns of F. */
struct fast_edges {
    const double *from[4];
    double scale[2];
};

MPM_INLINE struct fast_edges edges_of_block(const struct fast_block *block)
{
    double *const *const f = block->particles->deformation, *const *const kept =
                                                                block->particles->domain;
    if (kept[0] != NULL)
        return (struct fast_edges){{kept[0], kept[1], kept[2], kept[3]}, {1.0, 1.0}};
    return (struct fast_edges){{f[MPM_XX], f[MPM_YX], f[MPM_XY], f[MPM_YY]},
                               {block->k->half[0], block->k->half[1]}};
}

MPM_INLINE void evaluate(const struct fast_spec *spec, const struct fast_constants *k,
                         const struct mpm_particles *particles, const struct fast_edges *edges,
                         size_t p, union fast_stencil *stencil)
{
    const mpm_vector position[2] = {mpm_load(particles->position[0] + p),
                                    mpm_load(particles->position[1] + p)};
    if (spec->shape != MPM_CPDI) {
        fast_lines_evaluate(spec, k, position, &stencil->lines);
        return;
    }
    mpm_vector edge[4];
    for (int i = 0; i < 4; i++)
        edge[i] = mpm_load(edges->from[i] + p) * edges->scale[i / 2];
    fast_cpdi_evaluate(spec, k, position, edge, &stencil->cpdi);
}

/* Forces, and with them momentum and mass. */
MPM_INLINE void spread(const struct fast_spec *spec, const struct fast_constants *k,
                       const union fast_stencil *stencil, const struct fast_load *load)
{
    if (spec->shape == MPM_CPDI)
        fast_cpdi_spread(spec, k, &stencil->cpdi, load);
    else
        fast_lines_spread(spec, k, &stencil->lines, load);
}

/* Values that go with S only, to the nodal vectors of an array; turn: of APIC, or NULL. */
MPM_INLINE void spread_values(const struct fast_spec *spec, const struct fast_constants *k,
                              const union fast_stencil *stencil, void *array,
                              const mpm_vector values[4], const struct fast_turn *turn)
{
    if (spec->shape == MPM_CPDI)
        fast_cpdi_spread_values(k, &stencil->cpdi, array, values);
    else
        fast_lines_spread_values(spec, k, &stencil->lines, array, values, turn);
}

/* (p_x, p_x, p_y, p_y), to make a velocity of which a gradient can be taken */
MPM_INLINE void spread_momentum(const struct fast_spec *spec, const struct fast_constants *k,
                                const struct mpm_particles *particles, size_t p,
                                const union fast_stencil *stencil, const mpm_vector momentum[2])
{
    const mpm_vector values[4] = {momentum[0], momentum[0], momentum[1], momentum[1]};
    if (!spec->affine) {
        spread_values(spec, k, stencil, k->gradient, values, NULL);
        return;
    }
    mpm_vector affine[4];
    fast_affine_momentum(spec, particles, p, &stencil->lines.moments, mpm_load(particles->mass + p),
                         affine);
    const struct fast_turn turn = fast_turn_of(affine, true);
    spread_values(spec, k, stencil, k->gradient, values, &turn);
}

/* sum S and sum T of (a_x, a_y, v_x, v_y); B_p, where it is asked for */
MPM_INLINE void gather_motion(const struct fast_spec *spec, const struct fast_constants *k,
                              const struct mpm_particles *particles, size_t p,
                              const union fast_stencil *stencil, bool wants_hoop,
                              mpm_vector motion[4], mpm_vector hoop[4])
{
    if (spec->shape == MPM_CPDI) {
        fast_cpdi_gather(spec, k, &stencil->cpdi, k->read, wants_hoop, motion, hoop);
    } else if (spec->affine) {
        mpm_vector columns[2][4];
        fast_lines_gather(spec, k, &stencil->lines, k->read, wants_hoop, motion, hoop, columns);
        fast_affine_keep(particles, p, columns);
    } else {
        fast_lines_gather(spec, k, &stencil->lines, k->read, wants_hoop, motion, hoop, NULL);
    }
}

/* sum S of an array's nodal vectors */
MPM_INLINE void gather_values(const struct fast_spec *spec, const struct fast_constants *k,
                              const union fast_stencil *stencil, const void *array,
                              mpm_vector values[4])
{
    mpm_vector unused[4];
    if (spec->shape == MPM_CPDI)
        fast_cpdi_gather(spec, k, &stencil->cpdi, array, false, values, unused);
    else
        fast_lines_gather(spec, k, &stencil->lines, array, false, values, unused, NULL);
}

MPM_INLINE void gather_gradient(const struct fast_spec *spec, const struct fast_constants *k,
                                const union fast_stencil *stencil,
                                mpm_vector gradient[MPM_GRADIENT_SIZE])
{
    if (spec->shape == MPM_CPDI)
        fast_cpdi_gradient(spec, k, &stencil->cpdi, gradient);
    else
        fast_lines_gradient(spec, k, &stencil->lines, gradient);
}

/* ------------------------------------------------------- parts of the passes */

MPM_INLINE void load_stress(const struct mpm_particles *particles, size_t p, struct fast_load *load)
{
    for (int i = 0; i < MPM_SYMMETRIC_SIZE; i++)
        load->stress[i] = -load->mass * mpm_load(particles->stress[i] + p);
}

MPM_INLINE void update_velocity_vector(const struct fast_constants *k,
                                       const struct mpm_particles *particles, size_t p,
                                       const mpm_vector motion[4], struct fast_sums *sums,
                                       mpm_vector momentum[2])
{
    const mpm_vector mass = mpm_load(particles->mass + p);
    mpm_vector v[2];
    for (int axis = 0; axis < 2; axis++) {
        v[axis] = mpm_load(particles->velocity[axis] + p) + k->time_step * motion[axis];
        mpm_store(particles->velocity[axis] + p, v[axis]);
        momentum[axis] = mass * v[axis];
    }
    const mpm_vector square = v[0] * v[0] + v[1] * v[1];
    sums->kinetic += 0.5 * mass * square;
    if (mpm_any(~mpm_at_most(square, mpm_splat(DBL_MAX))))
        mpm_fast_report_velocity(sums->strip, particles, p);
}

/* x + dt v */
MPM_INLINE void next_position(const struct fast_constants *k, const struct mpm_particles *particles,
                              size_t p, bool hoop_radius, const mpm_vector motion[4],
                              const mpm_vector hoop[4], mpm_vector next[2])
{
    for (int axis = 0; axis < 2; axis++) {
        const mpm_vector position = mpm_load(particles->position[axis] + p);
        mpm_vector rate = motion[2 + axis] - k->back * motion[axis];
        if (hoop_radius && axis == 0)
            rate = position * (hoop[2] - k->back * hoop[0]);
        next[axis] = position + k->time_step * rate;
    }
}

/* Goes there; the box of the next step. */
MPM_INLINE void update_position_vector(const struct fast_spec *spec, const struct fast_constants *k,
                                       const struct mpm_particles *particles, size_t p,
                                       struct fast_sums *sums)
{
    mpm_vector position[2], step[2], reach[2];
    for (int axis = 0; axis < 2; axis++) {
        position[axis] = mpm_load(particles->carried[axis] + p);
        step[axis] = position[axis] - mpm_load(particles->position[axis] + p);
        mpm_store(particles->position[axis] + p, position[axis]);
        reach[axis] = mpm_splat(spec->shape == MPM_CLASSIC ? 0.0 : k->half[axis]);
    }
    if (spec->shape == MPM_CPDI) {
        mpm_vector f[MPM_GRADIENT_SIZE], edge[4];
        load_deformation(particles, p, f);
        edges_of(k, f, edge);
        for (int axis = 0; axis < 2; axis++)
            reach[axis] = mpm_absolute(edge[axis]) + mpm_absolute(edge[2 + axis]);
    }
    if (spec->axisymmetric && k->truncated)
        reach[0] = mpm_smaller(position[0], reach[0]);
    mpm_mask sound = {-1, -1, -1, -1};
    for (int axis = 0; axis < 2; axis++) {
        const mpm_vector low = position[axis] - reach[axis], high = position[axis] + reach[axis];
        sums->low[axis] = mpm_smaller(low, sums->low[axis]);
        sums->high[axis] = mpm_larger(high, sums->high[axis]);
        sound &= mpm_at_most(mpm_splat(k->origin[axis]), position[axis]);
        sound &= mpm_less(position[axis], mpm_splat(k->end[axis]));
        if (spec->shape == MPM_CPDI) { /* others reach a cell at most */
            sound &= mpm_less(mpm_splat(k->lowest_reach[axis]), low);
            sound &= mpm_less(high, mpm_splat(k->highest_reach[axis]));
        }
        sound &= mpm_at_most(mpm_absolute(step[axis]), mpm_splat(k->cell[axis]));
    }
    if (spec->axisymmetric)
        sound &= mpm_less(mpm_splat(0.0), position[0]);
    if (mpm_any(~sound)) {
        double values[6][MPM_VECTOR_SIZE];
        for (int axis = 0; axis < 2; axis++) {
            mpm_store(values[axis], position[axis]);
            mpm_store(values[2 + axis], step[axis]);
            mpm_store(values[4 + axis], reach[axis]);
        }
        mpm_fast_report_position(sums->state, sums->strip, particles, p,
                                 (const double(*)[MPM_VECTOR_SIZE])values);
    }
}

/* --------------------------------------------------------------- the passes
 *
 * A pass takes a block of particles stage by stage, each stage a loop over its vectors:
 * what follows one vector's long chains of operations is the same stage of the next one,
 * which does not depend on it. */

MPM_INLINE void evaluate_block(const struct fast_spec *spec, const struct fast_block *block,
                               union fast_stencil stencil[MPM_BLOCK_VECTORS])
{
    struct fast_edges edges = {.scale = {0.0}};
    if (spec->shape == MPM_CPDI)
        edges = edges_of_block(block);
    FOR_VECTORS(block, p, v)
    evaluate(spec, block->k, block->particles, &edges, p, &stencil[v]);
    mpm_keep_in_memory(stencil);
    if (block->sums->patches != NULL)
        fast_patches_begin(spec, block->sums->patches, stencil);
}

MPM_INLINE void update_stress_block(const struct fast_spec *spec, const struct fast_block *block,
                                    const union fast_stencil stencil[MPM_BLOCK_VECTORS])
{
    mpm_vector gradient[MPM_BLOCK_VECTORS][MPM_GRADIENT_SIZE];
    FOR_VECTORS(block, p, v)
    gather_gradient(spec, block->k, &stencil[v], gradient[v]);
    block->update(block->k, block->particles, block->first, block->end, block->sums,
                  (const mpm_vector(*)[MPM_GRADIENT_SIZE])gradient);
}

/* Without `affine`, which passes of APIC set: zeros there take a loop for each vector. */
MPM_INLINE void begin_load(const struct mpm_particles *particles, size_t p, struct fast_load *load)
{
    load->mass = mpm_load(particles->mass + p);
    load->momentum[0] = load->momentum[1] = mpm_splat(0.0);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        load->stress[k] = mpm_splat(0.0);
}

/* Momentum and mass */
MPM_INLINE void spread_sums(const struct fast_spec *spec, const struct fast_constants *k,
                            const union fast_stencil *stencil, const struct fast_load *load)
{
    const mpm_vector values[4] = {load->momentum[0], load->mass, load->momentum[1]};
    struct fast_turn turn;
    if (spec->affine)
        turn = fast_turn_of(load->affine, false);
    spread_values(spec, k, stencil, k->sum, values, spec->affine ? &turn : NULL);
}

/* Task 1, with the stress at hand also Task 3 */
MPM_INLINE void block_to_grid(const struct fast_spec *spec, const struct fast_block *block)
{
    union fast_stencil stencil[MPM_BLOCK_VECTORS];
    evaluate_block(spec, block, stencil);
    FOR_VECTORS(block, p, v)
    {
        struct fast_load load;
        begin_load(block->particles, p, &load);
        for (int axis = 0; axis < 2; axis++)
            load.momentum[axis] = load.mass * mpm_load(block->particles->velocity[axis] + p);
        if (spec->affine)
            fast_affine_momentum(spec, block->particles, p, &stencil[v].lines.moments, load.mass,
                                 load.affine);
        if (spec->force) {
            load_stress(block->particles, p, &load);
            spread(spec, block->k, &stencil[v], &load);
        } else { /* no forces yet: masses, see struct mpm_node_sum */
            spread_sums(spec, block->k, &stencil[v], &load);
        }
    }
    if (spec->scalars)
        spread_scalar(spec, block, stencil);
}

/* Tasks 2 and 3 of USF and USAVG */
MPM_INLINE void block_stress_before(const struct fast_spec *spec, const struct fast_block *block)
{
    union fast_stencil stencil[MPM_BLOCK_VECTORS];
    evaluate_block(spec, block, stencil);
    if (spec->conducts) /* with the F of the start */
        conduct_scalar(spec, block, stencil);
    update_stress_block(spec, block, stencil);
    FOR_VECTORS(block, p, v)
    {
        struct fast_load load;
        begin_load(block->particles, p, &load);
        load_stress(block->particles, p, &load);
        spread(spec, block->k, &stencil[v], &load);
    }
}

/* Velocities and, for later, positions; *momentum of the former */
MPM_INLINE void move_vector(const struct fast_spec *spec, const struct fast_block *block, size_t p,
                            bool hoop_radius, const union fast_stencil *stencil,
                            mpm_vector momentum[2])
{
    mpm_vector motion[4], hoop[4], next[2];
    gather_motion(spec, block->k, block->particles, p, stencil, hoop_radius, motion, hoop);
    update_velocity_vector(block->k, block->particles, p, motion, block->sums, momentum);
    next_position(block->k, block->particles, p, hoop_radius, motion, hoop, next);
    for (int axis = 0; axis < 2; axis++)
        mpm_store(block->particles->carried[axis] + p, next[axis]);
}

MPM_INLINE void move_block(const struct fast_spec *spec, const struct fast_block *block,
                           const union fast_stencil stencil[MPM_BLOCK_VECTORS],
                           mpm_vector momentum[MPM_BLOCK_VECTORS][2])
{
    if (spec->axisymmetric && block->hoop_radius)
        FOR_VECTORS(block, p, v)
    move_vector(spec, block, p, true, &stencil[v], momentum[v]);
    else FOR_VECTORS(block, p, v) move_vector(spec, block, p, false, &stencil[v], momentum[v]);
}

/* What the particles have of a projection's field, in vectors; 0 beyond its components. */
MPM_INLINE void load_values(const struct mpm_projection *projection,
                            const struct mpm_particles *particles, size_t p, mpm_vector values[4])
{
    for (size_t i = 0; i < MPM_PROJECTION_COMPONENTS; i++) {
        values[i] = mpm_splat(0.0);
        if (i < projection->components)
            values[i] = mpm_load((double *)mpm_particle_array(particles, projection->field, i) + p);
    }
}

MPM_INLINE void store_values(const struct mpm_projection *projection,
                             const struct mpm_particles *particles, size_t p,
                             const mpm_vector values[4])
{
    for (size_t i = 0; i < projection->components; i++)
        mpm_store((double *)mpm_particle_array(particles, projection->field, i) + p, values[i]);
}

/* See projection.h. */
MPM_INLINE void block_project(const struct fast_spec *spec, const struct fast_block *block)
{
    const struct mpm_projection *const projection = block->sums->state->projection;
    const bool from_nodes = projection->from != NULL, to_nodes = projection->to != NULL;
    union fast_stencil stencil[MPM_BLOCK_VECTORS];
    mpm_vector sums[MPM_BLOCK_VECTORS][MPM_PROJECTION_COMPONENTS];
    evaluate_block(spec, block, stencil);
    FOR_VECTORS(block, p, v)
    {
        const mpm_vector mass = mpm_load(block->particles->mass + p);
        mpm_vector values[4];
        if (from_nodes)
            gather_values(spec, block->k, &stencil[v], block->k->read, values);
        else
            load_values(projection, block->particles, p, values);
        if (!to_nodes)
            store_values(projection, block->particles, p, values);
        for (int i = 0; i < MPM_PROJECTION_COMPONENTS; i++)
            sums[v][i] = mass * values[i];
    }
    if (!to_nodes)
        return;
    FOR_VECTORS(block, p, v)
    {
        const mpm_vector values[4] = {sums[v][0], sums[v][0], sums[v][1], sums[v][1]};
        spread_values(spec, block->k, &stencil[v], block->k->gradient, values, NULL);
    }
}

/* Passes of scalars alone: see transport_passes.h. */
#define MPM_SCALAR_BLOCK(name, work)                                                               \
    MPM_INLINE void name(const struct fast_spec *spec, const struct fast_block *block)             \
    {                                                                                              \
        union fast_stencil stencil[MPM_BLOCK_VECTORS];                                             \
        evaluate_block(spec, block, stencil);                                                      \
        work(spec, block, stencil);                                                                \
    }
MPM_SCALAR_BLOCK(block_spread_scalar, spread_scalar)
MPM_SCALAR_BLOCK(block_conduct, conduct_scalar)
MPM_SCALAR_BLOCK(block_update_scalar, update_scalar)
MPM_SCALAR_BLOCK(block_filter, filter_scalar)

/* Task 5, velocities, and (31) */
MPM_INLINE void block_to_particles(const struct fast_spec *spec, const struct fast_block *block)
{
    union fast_stencil stencil[MPM_BLOCK_VECTORS];
    mpm_vector momentum[MPM_BLOCK_VECTORS][2];
    evaluate_block(spec, block, stencil);
    move_block(spec, block, stencil, momentum);
    FOR_VECTORS(block, p, v)
    spread_momentum(spec, block->k, block->particles, p, &stencil[v], momentum[v]);
    if (spec->conducts)
        conduct_scalar(spec, block, stencil);
}

MPM_INLINE void keep_edges(const struct fast_constants *k, const struct mpm_particles *particles,
                           size_t p)
{
    mpm_vector f[MPM_GRADIENT_SIZE], edge[4];
    load_deformation(particles, p, f);
    edges_of(k, f, edge);
    for (int i = 0; i < 4; i++)
        mpm_store(particles->domain[i] + p, edge[i]);
}

/* The rest of the step, with the velocities where (31) is not asked for. */
MPM_INLINE void block_finish(const struct fast_spec *spec, const struct fast_block *block)
{
    union fast_stencil stencil[MPM_BLOCK_VECTORS];
    mpm_vector momentum[MPM_BLOCK_VECTORS][2];
    evaluate_block(spec, block, stencil);
    if (spec->scalars)
        update_scalar(spec, block, stencil);
    if (block->moves)
        move_block(spec, block, stencil, momentum);
    if (block->update != NULL)
        update_stress_block(spec, block, stencil);
    FOR_VECTORS(block, p, v)
    update_position_vector(spec, block->k, block->particles, p, block->sums);
    if (spec->shape == MPM_CPDI && block->particles->domain[0] != NULL)
        FOR_VECTORS(block, p, v)
    keep_edges(block->k, block->particles, p);
}

/* Not part of a step: stress and domain of F. */
MPM_INLINE void block_recompute(const struct fast_spec *spec, const struct fast_block *block)
{
    const struct mpm_particles *const particles = block->particles;
    (void)spec;
    block->update(block->k, particles, block->first, block->end, block->sums, NULL);
    if (particles->domain[0] != NULL)
        FOR_VECTORS(block, p, v)
    keep_edges(block->k, particles, p);
}

#endif

/* Laws of metals in fast kernels: a step of four particles, strength, pressure and viscosity, to
 * the bits of the laws particle by particle (model/laws/, method/transfer/law_state.c). What is
 * rare has no equations here: a state at the cut-off of pressure, a temperature beyond its series,
 * no strength, a step without end. Four particles with one of these are taken particle by particle,
 * which also finds what has failed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_METALS_H
#define MPM_METHOD_FAST_METALS_H

#include "method/fast/fast_block.h"
#include "method/fast/metals/flow_vector.h"
#include "method/fast/metals/gruneisen_vector.h"
#include "model/laws/gruneisen_solid.h"

/* Is the plastic work a state variable? That of von_mises is a function of p. */
MPM_INLINE bool metal_keeps_work(struct metal_law law)
{
    return law.gruneisen || law.johnson_cook;
}

MPM_INLINE size_t metal_place_of_work(struct metal_law law)
{
    return law.gruneisen ? (size_t)MPM_SOLID_WORK : (size_t)MPM_PLASTIC_VARIABLES;
}

MPM_INLINE void load_metal(struct metal_law law, const struct mpm_particles *particles, size_t p,
                           struct metal_points *points)
{
    const mpm_vector none = mpm_splat(0.0);
    load_deformation(particles, p, points->old_f);
    for (size_t k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        points->inverse[k] =
            mpm_load(mpm_particle_law_state(particles, p, MPM_PLASTIC_INVERSE + k));
    points->plastic = mpm_load(mpm_particle_law_state(particles, p, MPM_PLASTIC_STRAIN));
    points->energy =
        law.gruneisen ? mpm_load(mpm_particle_law_state(particles, p, MPM_SOLID_ENERGY)) : none;
    points->work = metal_keeps_work(law)
                       ? mpm_load(mpm_particle_law_state(particles, p, metal_place_of_work(law)))
                       : none;
    points->viscous[0] = points->viscous[1] = none;
    if (particles->viscous[0] != NULL) {
        points->viscous[0] = mpm_load(particles->viscous[0] + p);
        points->viscous[1] = mpm_load(particles->viscous[1] + p);
    }
}

MPM_INLINE void store_metal(struct metal_law law, const struct mpm_particles *particles, size_t p,
                            const struct metal_points *points)
{
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        mpm_store(particles->deformation[k] + p, points->f[k]);
    for (size_t k = 0; k < MPM_SYMMETRIC_SIZE; k++) {
        const mpm_vector pressure = k == MPM_SYM_XY ? mpm_splat(0.0) : points->viscous[0];
        mpm_store(particles->stress[k] + p, points->tau[k] - pressure);
        mpm_store(mpm_particle_law_state(particles, p, MPM_PLASTIC_INVERSE + k),
                  points->inverse[k]);
    }
    mpm_store(mpm_particle_law_state(particles, p, MPM_PLASTIC_STRAIN), points->plastic);
    if (law.gruneisen)
        mpm_store(mpm_particle_law_state(particles, p, MPM_SOLID_ENERGY), points->energy);
    if (metal_keeps_work(law))
        mpm_store(mpm_particle_law_state(particles, p, metal_place_of_work(law)), points->work);
    if (particles->viscous[0] != NULL) {
        mpm_store(particles->viscous[0] + p, points->viscous[0]);
        mpm_store(particles->viscous[1] + p, points->viscous[1]);
    }
}

/* The factor of strength at the start of the step. */
MPM_INLINE mpm_vector softening_vector(struct metal_law law, const struct metal *metal,
                                       struct metal_points *points)
{
    const double *const given = metal->material->parameter;
    mpm_vector temperature;
    if (!law.johnson_cook || !metal->softens)
        return mpm_splat(1.0);
    if (law.gruneisen) {
        temperature = gruneisen_temperature_vector(
            metal->material, determinant_vector(points->old_f), points->energy, &points->found);
        points->found &= mpm_at_most(mpm_splat(0.0), temperature);
    } else {
        temperature =
            given[MPM_PARAMETER_START_TEMPERATURE] +
            given[MPM_PARAMETER_TAYLOR_QUINNEY] * points->work / given[MPM_PARAMETER_SPECIFIC_HEAT];
    }
    return of_temperature_vector(metal, temperature);
}

MPM_INLINE void add_mean_vector(mpm_vector mean, mpm_vector tau[MPM_SYMMETRIC_SIZE])
{
    tau[MPM_SYM_XX] += mean;
    tau[MPM_SYM_YY] += mean;
    tau[MPM_SYM_ZZ] += mean;
}

/* Adds the pressure of the step with this heat, from the energy of its start. */
MPM_INLINE void add_pressure_vector(struct metal_law law, const struct metal *metal,
                                    mpm_vector heat, struct metal_points *points)
{
    const struct mpm_material *const m = metal->material;
    const mpm_vector j = determinant_vector(points->f);
    mpm_vector mean, bulk = mpm_splat(m->bulk);
    if (law.gruneisen) {
        const mpm_vector pressure = gruneisen_advance_vector(
            m, determinant_vector(points->old_f), j, heat, &points->energy, &bulk, &points->found);
        mean = -j * pressure;
        bulk = bulk + mean;
    } else {
        mean = m->bulk * mpm_logarithm_vector(j);
    }
    add_mean_vector(mean, points->tau);
    points->wave_squared = metal_wave_squared(metal, bulk, points);
}

/* See add_viscosity in law_state.c. `work`: plastic work of the step. */
MPM_INLINE void add_viscosity_vector(struct metal_law law, const struct metal *metal,
                                     const struct fast_constants *k, mpm_vector old_energy,
                                     mpm_vector work, struct metal_points *points)
{
    const struct mpm_viscosity *const viscosity = k->viscosity;
    const double cell = k->cell[0] < k->cell[1] ? k->cell[0] : k->cell[1];
    const mpm_vector zero = mpm_splat(0.0);
    const mpm_vector strain =
        mpm_logarithm_vector(determinant_vector(points->f) / determinant_vector(points->old_f));
    const mpm_vector speed = cell * mpm_larger(-(strain / metal->duration), zero);
    const mpm_vector sound = mpm_square_root(points->wave_squared);
    const mpm_vector pressure = speed * (viscosity->linear * sound + viscosity->quadratic * speed);
    const mpm_vector heat = -pressure * strain;
    const mpm_mask heated = mpm_less(zero, heat);
    if (law.gruneisen && mpm_any(heated)) {
        struct metal_points again = *points;
        const mpm_vector *const tau = points->tau;
        const mpm_vector mean = (tau[MPM_SYM_XX] + tau[MPM_SYM_YY] + tau[MPM_SYM_ZZ]) / 3.0;
        again.energy = old_energy;
        add_mean_vector(-mean, again.tau);
        add_pressure_vector(law, metal, heat + metal->heating * work, &again);
        points->found &= again.found | ~heated;
        points->energy = mpm_select(heated, again.energy, points->energy);
        points->wave_squared = mpm_select(heated, again.wave_squared, points->wave_squared);
        select_symmetric(heated, again.tau, points->tau);
    }
    const mpm_vector wave = mpm_square_root(points->wave_squared);
    const mpm_vector viscous = viscosity->linear * wave + 2.0 * viscosity->quadratic * speed;
    const mpm_vector sum = viscous + mpm_square_root(viscous * viscous + points->wave_squared);
    points->wave_squared = sum * sum;
    points->viscous[0] = pressure;
    points->viscous[1] += heat;
}

/* The step of particles p to p + 3 to the F in points->f. False: not here, nothing is changed. */
MPM_INLINE bool update_metal(struct metal_law law, const struct fast_constants *k,
                             const struct metal *metal, const struct mpm_particles *particles,
                             size_t p, struct metal_points *points, mpm_vector *largest)
{
    load_metal(law, particles, p, points);
    points->found = mpm_less(mpm_splat(0.0), determinant_vector(points->f));
    points->softening = softening_vector(law, metal, points);
    const mpm_vector before = points->plastic, energy = points->energy, start = points->work;
    return_vector(law, metal, points);
    const mpm_mask flows = mpm_less(before, points->plastic);
    mpm_vector work = mpm_splat(0.0);
    if (metal_keeps_work(law) && mpm_any(flows))
        work = mpm_select(
            flows,
            metal_work(law, metal, points->plastic, points->plastic - before, points->softening),
            work);
    points->work += work;
    add_pressure_vector(law, metal, metal->heating * work, points);
    if (k->viscosity->given)
        add_viscosity_vector(law, metal, k, energy, points->work - start, points);
    points->found &= mpm_at_most(points->wave_squared, mpm_splat(DBL_MAX)) &
                     mpm_at_most(mpm_absolute(points->work), mpm_splat(DBL_MAX));
    if (mpm_any(~points->found))
        return false;
    store_metal(law, particles, p, points);
    *largest = mpm_larger(points->wave_squared, *largest);
    return true;
}

#endif

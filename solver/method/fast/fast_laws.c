/* The stress updates of fast kernels for one level of SIMD: this file is compiled for each, with
 * FAST_LEVEL (baseline, v3).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/fast/fast_laws.h"

#include "method/fast/fast_block.h"
#include "method/fast/fast_stress.h"
#include "method/fast/metals/metals.h"

typedef void stress_of(const struct mpm_material *material, const mpm_vector f[MPM_GRADIENT_SIZE],
                       mpm_vector tau[MPM_SYMMETRIC_SIZE], mpm_vector *wave_speed_squared);
typedef mpm_vector thickness_of(const struct mpm_material *material,
                                const mpm_vector f[MPM_GRADIENT_SIZE]);

/* F := dF F */
MPM_INLINE void update_deformation(enum mpm_geometry geometry, thickness_of *thickness,
                                   const struct fast_constants *k, double *const deformation[],
                                   size_t p, const mpm_vector gradient[MPM_GRADIENT_SIZE])
{
    mpm_vector f[MPM_GRADIENT_SIZE], h[MPM_GRADIENT_SIZE];
    for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
        f[i] = mpm_load(deformation[i] + p);
    for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
        h[i] = k->stress_step * gradient[i];
    deform_vector(h, k->deformation_terms, geometry == MPM_AXISYMMETRIC, f);
    if (geometry == MPM_PLANE_STRESS)
        f[MPM_ZZ] = mpm_select(mpm_less(mpm_splat(0.0), determinant_vector(f)),
                               thickness(&k->material, f), f[MPM_ZZ]);
    for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
        if (i != MPM_ZZ || geometry != MPM_PLANE_STRAIN)
            mpm_store(deformation[i] + p, f[i]);
}

MPM_INLINE void update_deformations(enum mpm_geometry geometry, thickness_of *thickness,
                                    const struct fast_constants *k,
                                    const struct mpm_particles *particles, size_t first, size_t end,
                                    const mpm_vector (*gradient)[MPM_GRADIENT_SIZE])
{
    double *deformation[MPM_GRADIENT_SIZE]; /* copies: stores may not change them */
    for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
        deformation[i] = particles->deformation[i];
    for (size_t p = first; p < end; p += MPM_VECTOR_SIZE)
        update_deformation(geometry, thickness, k, deformation, p, *gradient++);
}

/* The stress of the F at hand. */
MPM_INLINE void update_stresses(stress_of *stress, const struct fast_constants *k,
                                const struct mpm_particles *particles, size_t first, size_t end,
                                struct fast_sums *sums)
{
    const struct mpm_material material = k->material;
    double *deformation[MPM_GRADIENT_SIZE], *target[MPM_SYMMETRIC_SIZE];
    mpm_vector largest = sums->wave;
    for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
        deformation[i] = particles->deformation[i];
    for (int i = 0; i < MPM_SYMMETRIC_SIZE; i++)
        target[i] = particles->stress[i];
    for (size_t p = first; p < end; p += MPM_VECTOR_SIZE) {
        mpm_vector f[MPM_GRADIENT_SIZE], tau[MPM_SYMMETRIC_SIZE], wave;
        for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
            f[i] = mpm_load(deformation[i] + p);
        stress(&material, f, tau, &wave);
        for (int i = 0; i < MPM_SYMMETRIC_SIZE; i++)
            mpm_store(target[i] + p, tau[i]);
        largest = mpm_larger(wave, largest);
        const mpm_vector j = determinant_vector(f);
        const mpm_mask sound = mpm_less(mpm_splat(0.0), j) & mpm_at_most(wave, mpm_splat(DBL_MAX));
        if (mpm_any(~sound)) {
            double values[2][MPM_VECTOR_SIZE];
            mpm_store(values[0], j);
            mpm_store(values[1], wave);
            mpm_fast_report_stress(sums->strip, particles, p, values[0], values[1]);
        }
    }
    sums->wave = largest;
}

/* -------------------------------------------------------- laws without vectors */

/* F in vectors, into the places of particles; their stresses one by one. */
MPM_INLINE void update_by_particle(enum mpm_geometry geometry, const struct fast_constants *k,
                                   const struct mpm_particles *particles, size_t first, size_t end,
                                   struct fast_sums *sums,
                                   const mpm_vector (*gradient)[MPM_GRADIENT_SIZE])
{
    struct fast_deformations next;
    for (size_t p = first; p < end; p += MPM_VECTOR_SIZE) {
        mpm_vector f[MPM_GRADIENT_SIZE], h[MPM_GRADIENT_SIZE];
        load_deformation(particles, p, f);
        for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
            h[i] = k->stress_step * (*gradient)[i];
        deform_vector(h, k->deformation_terms, geometry == MPM_AXISYMMETRIC, f);
        for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
            /* cppcheck-suppress uninitvar ; it is written to */
            mpm_store(next.f[i] + (p - first), f[i]);
        gradient++;
    }
    mpm_fast_update_particles(sums, k->part, particles, first, end, &next);
}

/* ------------------------------------------------------------------------- metals */

/* One copy for all geometries. */
typedef bool metal_step(const struct fast_constants *k, const struct metal *metal,
                        const struct mpm_particles *particles, size_t p,
                        struct metal_points *points, mpm_vector *largest);
struct metal_kind {
    struct metal_law law;
    metal_step *step;
};
#define METAL_STEP(law, johnson_cook, gruneisen)                                                   \
    MPM_SEPARATE bool law##_step(const struct fast_constants *k, const struct metal *metal,        \
                                 const struct mpm_particles *particles, size_t p,                  \
                                 struct metal_points *points, mpm_vector *largest)                 \
    {                                                                                              \
        return update_metal((struct metal_law){johnson_cook, gruneisen}, k, metal, particles, p,   \
                            points, largest);                                                      \
    }
MPM_VECTOR_METALS(METAL_STEP)

/* Four particles that have no end of the step on vectors are taken one by one. */
MPM_INLINE void update_metals(enum mpm_geometry geometry, struct metal_kind kind,
                              const struct fast_constants *k, const struct mpm_particles *particles,
                              size_t first, size_t end, struct fast_sums *sums,
                              const mpm_vector (*gradient)[MPM_GRADIENT_SIZE])
{
    const struct metal metal = metal_of(kind.law, &k->material, k->stress_step);
    mpm_vector largest = sums->wave;
    for (size_t p = first; p < end; p += MPM_VECTOR_SIZE, gradient++) {
        struct metal_points points;
        mpm_vector h[MPM_GRADIENT_SIZE];
        load_deformation(particles, p, points.f);
        for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
            h[i] = k->stress_step * (*gradient)[i];
        deform_vector(h, k->deformation_terms, geometry == MPM_AXISYMMETRIC, points.f);
        if (kind.step(k, &metal, particles, p, &points, &largest))
            continue;
        struct fast_deformations next;
        for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
            /* cppcheck-suppress uninitvar ; it is written to */
            mpm_store(next.f[i], points.f[i]);
        mpm_fast_update_particles(sums, k->part, particles, p, p + MPM_VECTOR_SIZE, &next);
    }
    sums->wave = largest;
}

/* ------------------------------------------------------------- the instances */

#define FUNCTION(name)                                                                             \
    static void name(const struct fast_constants *k, const struct mpm_particles *particles,        \
                     size_t first, size_t end, struct fast_sums *sums,                             \
                     const mpm_vector(*gradient)[MPM_GRADIENT_SIZE])

#define UPDATE(law, geometry)                                                                      \
    FUNCTION(law##_##geometry)                                                                     \
    {                                                                                              \
        update_deformations(geometry, law##_thickness_vector, k, particles, first, end, gradient); \
        update_stresses(law##_stress_vector, k, particles, first, end, sums);                      \
    }

#define LAW(law)                                                                                   \
    UPDATE(law, MPM_PLANE_STRAIN)                                                                  \
    UPDATE(law, MPM_PLANE_STRESS)                                                                  \
    UPDATE(law, MPM_AXISYMMETRIC)                                                                  \
    FUNCTION(law##_recompute)                                                                      \
    {                                                                                              \
        (void)gradient;                                                                            \
        update_stresses(law##_stress_vector, k, particles, first, end, sums);                      \
    }
MPM_VECTOR_LAWS(LAW)

#define BY_PARTICLE(geometry)                                                                      \
    FUNCTION(particle_##geometry)                                                                  \
    {                                                                                              \
        update_by_particle(geometry, k, particles, first, end, sums, gradient);                    \
    }
BY_PARTICLE(MPM_PLANE_STRAIN)
BY_PARTICLE(MPM_PLANE_STRESS)
BY_PARTICLE(MPM_AXISYMMETRIC)
FUNCTION(particle_recompute)
{
    (void)gradient;
    mpm_fast_update_particles(sums, k->part, particles, first, end, NULL);
}

#define METAL(name, geometry, johnson_cook, gruneisen)                                             \
    FUNCTION(name##_##geometry)                                                                    \
    {                                                                                              \
        update_metals(geometry, (struct metal_kind){{johnson_cook, gruneisen}, name##_step}, k,    \
                      particles, first, end, sums, gradient);                                      \
    }
#define METALS(name, johnson_cook, gruneisen)                                                      \
    METAL(name, MPM_PLANE_STRAIN, johnson_cook, gruneisen)                                         \
    METAL(name, MPM_AXISYMMETRIC, johnson_cook, gruneisen)
MPM_VECTOR_METALS(METALS)

#define ROW(name)                                                                                  \
    {                                                                                              \
        .law = &mpm_##name,                                                                        \
        .update = {[MPM_PLANE_STRAIN] = name##_MPM_PLANE_STRAIN,                                   \
                   [MPM_PLANE_STRESS] = name##_MPM_PLANE_STRESS,                                   \
                   [MPM_AXISYMMETRIC] = name##_MPM_AXISYMMETRIC,                                   \
                   [MPM_FAST_RECOMPUTE] = name##_recompute},                                       \
    },
#define METAL_ROW(name, johnson_cook, gruneisen)                                                   \
    {                                                                                              \
        .law = &mpm_##name,                                                                        \
        .metal = true,                                                                             \
        .update = {[MPM_PLANE_STRAIN] = name##_MPM_PLANE_STRAIN,                                   \
                   [MPM_PLANE_STRESS] = particle_MPM_PLANE_STRESS,                                 \
                   [MPM_AXISYMMETRIC] = name##_MPM_AXISYMMETRIC,                                   \
                   [MPM_FAST_RECOMPUTE] = particle_recompute},                                     \
    },
const struct mpm_fast_law FAST_NAME(laws)[] = {MPM_VECTOR_LAWS(ROW) MPM_VECTOR_METALS(METAL_ROW){
    .law = NULL,
    .update = {[MPM_PLANE_STRAIN] = particle_MPM_PLANE_STRAIN,
               [MPM_PLANE_STRESS] = particle_MPM_PLANE_STRESS,
               [MPM_AXISYMMETRIC] = particle_MPM_AXISYMMETRIC,
               [MPM_FAST_RECOMPUTE] = particle_recompute}}};

/* Particles, as a structure of arrays: the deformable ones in stable cell order, and the rigid
 * ones, which only drive nodes.
 *
 * The fields of a particle are the rows of one table. The members of struct mpm_particles, their
 * layout, the sort, the copies in the last good state, the copies that fill the last vector of the
 * fast kernels (fast_block.c) and the plain fields of snapshots (simulation/fields.c) follow from
 * it. A new field is one row, and one value of enum mpm_field if snapshots have it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_PARTICLES_H
#define MPM_MODEL_PARTICLES_H

#include "base/arena.h"
#include "base/tensor.h"
#include "model/grid.h"

#include <stddef.h>
#include <string.h>

/* What particles are for; bits. */
enum mpm_particle_use {
    MPM_USE_DEFORMABLE = 1,
    MPM_USE_RIGID = 2,
    MPM_USE_ALL = MPM_USE_DEFORMABLE | MPM_USE_RIGID,
    MPM_USE_APIC = 4,
    MPM_USE_DOMAINS = 8,    /* F changes while domains must not */
    MPM_USE_ORIGINS = 16,   /* see crack_detection.h */
    MPM_USE_LAW_STATE = 32, /* laws with state variables */
    MPM_USE_USER_FORCE = 64,
    MPM_USE_DRAG = 128,             /* damping at the particles */
    MPM_USE_TEMPERATURE = 256,      /* a scalar of the scene */
    MPM_USE_SOURCE = 512,           /* one of its scalars has a source */
    MPM_USE_FREE_STRAIN = 1024,     /* materials expand with a scalar */
    MPM_USE_LAW_TEMPERATURE = 2048, /* stresses and temperature depend on each other */
    MPM_USE_CONCENTRATION = 4096,   /* a scalar of the scene */
    MPM_USE_VISCOSITY = 8192,       /* a material has artificial viscosity */
};

/* State variables of a law, at most: two tensors of four components and two scalars. */
enum { MPM_LAW_STATES = 10 };

/* The table. Columns: name of the row; type, member, and [components] where there are several,
 * a pointer each (as many as law_state has depends on the scene, and one follows the other behind
 * one pointer); its dimension, MPM_DIMENSION_... without the prefix; uses that need the field; uses
 * that need a copy in the last good state, since the field changes and cannot be computed from
 * others; bits of the components that are 1 for a rigid particle, which does not carry the field,
 * the others being 0; name and description for users. */
#define MPM_RIGID_PARTICLE_FIELDS(ROW) /* rigid particles have these, and no others */             \
    ROW(ID, uint32_t, id, , NONE, MPM_USE_ALL, 0, 0, "id",                                         \
        "number of the particle in creation order")                                                \
    ROW(BODY, uint32_t, body, , NONE, MPM_USE_ALL, 0, 0, "body",                                   \
        "index of the particle's body in the scene")                                               \
    ROW(POSITION, double, position, [2], LENGTH, MPM_USE_ALL, MPM_USE_ALL, 0, "position",          \
        "centre of the particle: x y, or r z")                                                     \
    ROW(VELOCITY, double, velocity, [2], VELOCITY, MPM_USE_ALL, MPM_USE_ALL, 0, "velocity",        \
        "velocity of the particle")
#define MPM_WRITTEN_PARTICLE_FIELDS(ROW) /* snapshots have these: MPM_FIELD_<name> */              \
    MPM_RIGID_PARTICLE_FIELDS(ROW)                                                                 \
    ROW(DEFORMATION_GRADIENT, double, deformation, [MPM_GRADIENT_SIZE], NONE, MPM_USE_DEFORMABLE,  \
        MPM_USE_DEFORMABLE, 1 << MPM_XX | 1 << MPM_YY | 1 << MPM_ZZ, "deformation_gradient",       \
        "xx xy yx yy zz; in axisymmetry rr rz zr zz tt")                                           \
    ROW(MASS, double, mass, , MASS, MPM_USE_DEFORMABLE, 0, 0, "mass",                              \
        "mass, for the thickness or per radian")                                                   \
    ROW(TEMPERATURE, double, temperature, , TEMPERATURE, MPM_USE_TEMPERATURE, MPM_USE_TEMPERATURE, \
        0, "temperature", "temperature that the particle carries, N&G (62)")                       \
    ROW(CONCENTRATION, double, concentration, , NONE, MPM_USE_CONCENTRATION,                       \
        MPM_USE_CONCENTRATION, 0, "concentration",                                                 \
        "concentration of solvent that the particle carries, 1 where it is saturated")
#define MPM_INNER_PARTICLE_FIELDS(ROW)                                                             \
    ROW(STRESS, double, stress, [MPM_SYMMETRIC_SIZE], SPECIFIC_ENERGY, MPM_USE_DEFORMABLE,         \
        MPM_USE_LAW_STATE | MPM_USE_VISCOSITY | MPM_USE_FREE_STRAIN, 0, "kirchhoff_stress",        \
        "Kirchhoff stress over initial density")                                                   \
    ROW(AFFINE, double, affine, [4], AREA_RATE, MPM_USE_APIC, MPM_USE_APIC, 0, "affine",           \
        "xx xy yx yy; see method/transfer/affine.h")                                               \
    ROW(DOMAIN, double, domain, [4], LENGTH, MPM_USE_DOMAINS, 0, 0, "domain",                      \
        "half edges d1x d1y d2x d2y of the domain")                                                \
    ROW(ORIGIN, double, origin, [2], LENGTH, MPM_USE_ORIGINS, 0, 0, "origin",                      \
        "centre of the particle at t = 0")                                                         \
    ROW(LAW_STATE, double, law_state, , NONE, MPM_USE_LAW_STATE, MPM_USE_LAW_STATE, 0,             \
        "law_state", "state variables of the particle's law")                                      \
    ROW(FREE_STRAIN, double, free_strain, , NONE, MPM_USE_FREE_STRAIN, MPM_USE_FREE_STRAIN, 0,     \
        "free_strain", "logarithm of the stretch without stress, in the stress at hand")           \
    ROW(LAW_TEMPERATURE, double, law_temperature, , TEMPERATURE, MPM_USE_LAW_TEMPERATURE,          \
        MPM_USE_LAW_TEMPERATURE, 0, "law_temperature", "temperature in the stress at hand")        \
    ROW(VISCOUS, double, viscous, [2], SPECIFIC_ENERGY, MPM_USE_VISCOSITY, MPM_USE_VISCOSITY, 0,   \
        "viscous", "artificial viscosity: q J / rho_0 in the stress at hand; work since t = 0")
#define MPM_STEP_PARTICLE_FIELDS(ROW) /* of a step, not sorted: the sort works in their memory */  \
    ROW(CARRIED, double, carried, [2], LENGTH, MPM_USE_DEFORMABLE, 0, 0, "carried",                \
        "position at the end of the step, known before its last task")                             \
    ROW(USER_FORCE, double, user_force, [2], ACCELERATION, MPM_USE_USER_FORCE, 0, 0, "user_force", \
        "user force of the step, per mass; see user_force.h")                                      \
    ROW(DRAG, double, drag, [2], ACCELERATION, MPM_USE_DRAG, 0, 0, "drag",                         \
        "deceleration of the step by damping; see damping.h")                                      \
    ROW(SOURCE, double, source, , NONE, MPM_USE_SOURCE, 0, 0, "source",                            \
        "source of the scalar at hand, content per volume and time")                               \
    ROW(FREE_STRAIN_STEP, double, free_strain_step, , NONE, MPM_USE_FREE_STRAIN, 0, 0,             \
        "free_strain_step", "what transport changes free_strain by")                               \
    ROW(LAW_TEMPERATURE_STEP, double, law_temperature_step, , TEMPERATURE,                         \
        MPM_USE_LAW_TEMPERATURE, 0, 0, "law_temperature_step",                                     \
        "what transport changes law_temperature by")
#define MPM_PARTICLE_FIELDS(ROW)                                                                   \
    MPM_WRITTEN_PARTICLE_FIELDS(ROW)                                                               \
    MPM_INNER_PARTICLE_FIELDS(ROW)                                                                 \
    MPM_STEP_PARTICLE_FIELDS(ROW)

#define MPM_ROW(name, ...) MPM_PARTICLE_##name,
enum mpm_particle_field {
    MPM_WRITTEN_PARTICLE_FIELDS(MPM_ROW) /**/
    MPM_PARTICLE_WRITTEN_COUNT,
    MPM_PARTICLE_LAST_WRITTEN = MPM_PARTICLE_WRITTEN_COUNT - 1, /* no gap in the numbers */
    MPM_INNER_PARTICLE_FIELDS(MPM_ROW)                          /**/
    MPM_PARTICLE_LASTING_COUNT,                                 /* that the sort takes along */
    MPM_PARTICLE_LAST_LASTING = MPM_PARTICLE_LASTING_COUNT - 1,
    MPM_STEP_PARTICLE_FIELDS(MPM_ROW) /**/
    MPM_PARTICLE_FIELD_COUNT,
};
#undef MPM_ROW

/* Which fields a set of particles has. */
struct mpm_particle_needs {
    unsigned uses;      /* bits of enum mpm_particle_use */
    uint8_t law_states; /* components of law_state, with MPM_USE_LAW_STATE; up to MPM_LAW_STATES */
};

struct mpm_particles {
    size_t count;
    struct mpm_particle_needs needs;
    /* Arrays of each field in use, the first ones of its member; the others are NULL. A field that
     * the particles do not have has none. */
    uint8_t components[MPM_PARTICLE_FIELD_COUNT];
    uint8_t fields; /* up to the last one in use: others need not be looked at */
#define MPM_ROW(name, type, member, several, ...) type *member several;
    MPM_PARTICLE_FIELDS(MPM_ROW)
#undef MPM_ROW
};

/* Particles of rigid bodies. */
struct mpm_rigid_particles {
    size_t count;
#define MPM_ROW(name, type, member, several, ...) type *member several;
    MPM_RIGID_PARTICLE_FIELDS(MPM_ROW)
#undef MPM_ROW
};

/* Components that all fields have together, at most. */
enum {
    MPM_PARTICLE_ARRAYS =
        (sizeof(struct mpm_particles) - offsetof(struct mpm_particles, id)) / sizeof(void *) - 1 +
        MPM_LAW_STATES
};

struct mpm_particle_row {
    struct mpm_field_info info; /* components: those that have a pointer */
    size_t place;               /* of the member in struct mpm_particles */
    size_t size;                /* of one value */
    unsigned present, kept;     /* bits of enum mpm_particle_use */
    unsigned ones;              /* bits of components */
};
extern const struct mpm_particle_row mpm_particle_rows[MPM_PARTICLE_FIELD_COUNT];

/* The array of a component of a field, an enum mpm_particle_field: of doubles, or of uint32_t where
 * its info says integer. */
static inline void *mpm_particle_array(const struct mpm_particles *particles, size_t field,
                                       size_t component)
{
    const struct mpm_particle_row *const row = &mpm_particle_rows[field];
    const bool has_pointer = component < row->info.components;
    unsigned char *array;
    memcpy(&array,
           (const unsigned char *)particles + row->place +
               (has_pointer ? component * sizeof array : 0),
           sizeof array);
    return has_pointer ? array : array + component * particles->count * row->size;
}

static inline void mpm_particle_set_array(struct mpm_particles *particles, size_t field,
                                          size_t component, void *array)
{
    memcpy((unsigned char *)particles + mpm_particle_rows[field].place + component * sizeof array,
           &array, sizeof array);
}

/* Takes arrays for a field's first components; no others of it are there from now on. */
void mpm_particles_layout_field(struct mpm_particles *particles, size_t field, size_t components,
                                struct mpm_arena *arena);

static inline void mpm_particle_deformation(const struct mpm_particles *particles, size_t p,
                                            double f[MPM_GRADIENT_SIZE])
{
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        f[k] = particles->deformation[k][p];
}

/* State variable k of a particle. */
static inline double *mpm_particle_law_state(const struct mpm_particles *particles, size_t p,
                                             size_t k)
{
    return &particles->law_state[k * particles->count + p];
}

/* Takes all arrays of the fields that are needed. */
void mpm_particles_layout(struct mpm_particles *particles, size_t count,
                          struct mpm_particle_needs needs, struct mpm_arena *arena);
void mpm_rigid_particles_layout(struct mpm_rigid_particles *rigid, size_t count,
                                struct mpm_arena *arena);

/* The arrays of rigid particles, for what works on any set. */
struct mpm_particles mpm_rigid_particles_set(const struct mpm_rigid_particles *rigid);

/* The last good state of particles: how many components of a field have copies, and bytes from one
 * copy to the next, field by field in one block; bytes of all; copies them there, and back. */
size_t mpm_particles_kept_components(const struct mpm_particles *particles, size_t field);
size_t mpm_particles_kept_distance(const struct mpm_particles *particles, size_t field);
size_t mpm_particles_kept_bytes(const struct mpm_particles *particles);
void mpm_particles_keep(const struct mpm_particles *particles, unsigned char *kept);
void mpm_particles_put_back(const struct mpm_particles *particles, unsigned char *kept);

/* Room for one number a particle between steps, in the memory of `carried`: the sort's order, and
 * what is made after it until the next step. */
static inline uint32_t *mpm_particles_order(const struct mpm_particles *particles)
{
    return (void *)particles->carried[1];
}

/* Brings deformable particles into an order: their places until now. It may be in
 * mpm_particles_order. */
void mpm_particles_arrange(struct mpm_particles *particles, const uint32_t *order);

/* The cell that a particle is sorted into along one axis: that of the lower end of its
 * domain, whose nodes begin there, so that neighbours in the order have the same nodes. One
 * outside by less than a domain belongs to the first or last cell. */
static inline int64_t mpm_particle_cell(const struct mpm_grid *grid, int axis, double coordinate,
                                        const double half_size[2])
{
    const double low = coordinate - half_size[axis] - grid->origin[axis];
    const int64_t cell = (int64_t)(low * grid->inverse_cell[axis]);
    return cell < 0 ? 0 : cell < grid->cells[axis] ? cell : grid->cells[axis] - 1;
}

/* Sorts deformable particles by cell, row by row; particles of one cell keep their order.
 * `half_size` is that of their domains, or the smallest.
 * `counts` is scratch for max(rows, columns) + 1 counters; `kept` gets the copies of
 * mpm_particles_keep on the way. Cost: O(particles + rows + columns), independent of the
 * number of cells. */
void mpm_particles_sort(struct mpm_particles *particles, const struct mpm_grid *grid,
                        const double half_size[2], uint32_t *counts, unsigned char *kept);

#endif

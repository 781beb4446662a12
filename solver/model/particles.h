/* The deformable particles: structure of arrays in stable cell order, and the rigid
 * ones, which only drive nodes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_PARTICLES_H
#define MPM_MODEL_PARTICLES_H

#include "base/arena.h"
#include "base/tensor.h"
#include "model/grid.h"

struct mpm_particles {
    size_t count;
    double *position[2];
    double *velocity[2];
    double *deformation[MPM_GRADIENT_SIZE];
    double *stress[MPM_SYMMETRIC_SIZE]; /* Kirchhoff over initial density */
    double *mass;                       /* for the thickness, or per radian */
    double *affine[4]; /* APIC, else NULL: xx xy yx yy; see method/transfer/affine.h */
    double *domain[4]; /* half edges d1x d1y d2x d2y, where F does not tell them; else NULL */
    double *origin[2]; /* places at t = 0, else NULL; see crack_detection.h */
    uint32_t *id;      /* creation order over all bodies */
    uint32_t *body;    /* index in the scene */
    size_t kept;       /* so many of mpm_particles_arrays, the first, cannot be recomputed */
    /* scratch of the sort */
    uint32_t *order, *order_scratch;
    double *scratch;
    /* within a step: positions at its end, known before the last task; in the memory of the
     * sort's scratch */
    double *carried[2];
};

/* Particles of rigid bodies: no mass, no stress. */
struct mpm_rigid_particles {
    size_t count;
    double *position[2];
    double *velocity[2];
    uint32_t *id;
    uint32_t *body;
};

/* Arrays that only some methods need; `stress`: is it from more than one set of kernels? */
struct mpm_particle_extras {
    bool domains, affine, origins, stress;
};

void mpm_particles_layout(struct mpm_particles *particles, size_t count,
                          struct mpm_particle_extras extras, struct mpm_arena *arena);
void mpm_rigid_particles_layout(struct mpm_rigid_particles *particles, size_t count,
                                struct mpm_arena *arena);

/* Every array of doubles that a particle carries, for passes that treat all alike.
 * Returns the number of arrays (at most MPM_PARTICLE_ARRAYS). */
enum { MPM_PARTICLE_ARRAYS = 24 };
/* The first ones of them, position, velocity, deformation, the affine part if any, and stress if it
 * comes from several sets of kernels, whose bits differ: all else of a particle that changes can be
 * recomputed. particles->kept of them, at most so many. */
enum { MPM_KEPT_ARRAYS = 8 + MPM_GRADIENT_SIZE + MPM_SYMMETRIC_SIZE };
size_t mpm_particles_arrays(const struct mpm_particles *particles,
                            double *arrays[MPM_PARTICLE_ARRAYS]);

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

/* Sorts the particles by cell, row by row; particles of one cell keep their order.
 * `half_size` is that of their domains, or the smallest.
 * `counts` is scratch for max(rows, columns) + 1 counters; `kept` gets copies of the arrays
 * that are to be kept, on the way. Cost: O(particles + rows + columns), independent of the
 * number of cells. */
void mpm_particles_sort(struct mpm_particles *particles, const struct mpm_grid *grid,
                        const double half_size[2], uint32_t *counts,
                        double *const kept[MPM_KEPT_ARRAYS]);

#endif

/* One snapshot: all particles at one instant in one HDF5 file.
 *
 * /mpm            attributes: format, title, geometry, thickness, units_*, time, step,
 *                 staggered, body_names, body_domains, settings and the facts of
 *                 io/results/provenance.h
 *
 * /mpm/particles  one dataset per field of mpm_field_describe, with attributes unit,
 *                 description and components; integers are int64, the rest double; fringe
 *                 only where the scene selects it; with output.derived also a dataset for
 *                 each component of the stress and the deformation gradient
 *
 * /mpm/cracks     in scenes with cracks: position and crack of the points of
 *                 mpm_simulation_crack_point, with the same attributes
 *
 * /VTKHDF         version 1.0, UnstructuredGrid of vertices: Points is a dataset of its
 *                 own (three components), PointData holds hard links to /mpm/particles,
 *                 FieldData holds TimeValue and step
 *
 * Data is chunked, shuffled and carries Fletcher-32 checksums. Particle data is not
 * compressed: deflate at level 1 halves the file of a moving body (163 MB for 10^6
 * particles) and takes two and a half times as long (0.8 s instead of 0.3 s); h5repack
 * does it afterwards. The numbers that only say "particle i is vertex i" are
 * compressed to almost nothing.
 * Nothing in the file depends on the date, the machine or the number of threads.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SNAPSHOT_H
#define MPM_IO_SNAPSHOT_H

#include "model/scene.h"

/* The names of a field's components, in order: "xx, yy, zz, xy". */
const char *mpm_snapshot_components(enum mpm_geometry geometry, size_t components);

/* Number of doubles that mpm_snapshot_write needs as working space: data is written in
 * blocks, so that it does not grow with the number of particles beyond 0.7 MB. */
size_t mpm_snapshot_work_size(const struct mpm_scene *scene, size_t particle_count);

/* Writes the state of `simulation` to `path`: to `path`.partial first, synced, then
 * renamed, so that `path` is complete or absent. `work` has mpm_snapshot_work_size
 * elements. MPM_ENVIRONMENT_FAILED names the file and the system's reason. HDF5 is
 * not for several threads at a time: one caller at a time in a process. */
enum mpm_status mpm_snapshot_write(const char *path, const struct mpm_scene *scene,
                                   const struct mpm_simulation *simulation, double *work,
                                   struct mpm_error *error);

#endif

/* The snapshots of a run: particles-000000.hdf, particles-000001.hdf, … numbered in
 * the order in which they are written, and particles.hdf.series, ParaView's list of
 * them with their times, rewritten after each.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SERIES_H
#define MPM_IO_SERIES_H

#include "base/piece.h"
#include "model/scene.h"

enum { MPM_SERIES_DIGITS = 6 }; /* more if there are more than a million */

#define MPM_SERIES_PREFIX "particles-"
#define MPM_SERIES_SUFFIX ".hdf"
#define MPM_SERIES_LIST   "particles.hdf.series"

struct mpm_series;

/* Takes the working space for snapshots of `particle_count` particles; writes nothing
 * yet. `folder` and `scene` must outlive the series. */
enum mpm_status mpm_series_create(const char *folder, const struct mpm_scene *scene,
                                  size_t particle_count, struct mpm_series **series,
                                  struct mpm_error *error);
void mpm_series_free(struct mpm_series *series);

/* Writes the next snapshot and the list; nothing if the last snapshot is of the same
 * step. After a failure the files of before are as they were. */
enum mpm_status mpm_series_write(struct mpm_series *series, const struct mpm_simulation *simulation,
                                 struct mpm_error *error);

/* What a checkpoint has of it: the times of the snapshots, which follow each other in their names.
 * One that is read into has written nothing yet. */
void mpm_series_visit(struct mpm_series *series, struct mpm_piece_visitor *visitor);

/* How many snapshots it has. */
size_t mpm_series_count(const struct mpm_series *series);

/* Writes the list as it is, after it was read. */
enum mpm_status mpm_series_write_list(const struct mpm_series *series, struct mpm_error *error);

/* Is it a name of `prefix`, digits and `suffix`, as particles-000012.hdf? *number is that. */
bool mpm_series_number(const char *name, const char *prefix, const char *suffix, uint64_t *number);

/* Bytes of working space held. */
size_t mpm_series_bytes(const struct mpm_series *series);

/* Name of the last complete snapshot in the folder and its time; NULL before the first. */
const char *mpm_series_last(const struct mpm_series *series, double *time);

#endif

/* Groups, attributes and datasets of a snapshot's file.
 *
 * Every HDF5 call goes through mpm_snapshot_checked: the first failure is stored as text, the calls
 * after it fail without harm, and the file is thrown away at the end. HDF5's hid_t is int64_t and
 * its hsize_t unsigned long long, written so here to keep its header out of this one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SNAPSHOT_DATA_H
#define MPM_IO_SNAPSHOT_DATA_H

#include "model/scene.h"

#include <stdint.h>

/* Rows of a chunk, which are written at a time: 0.6 MiB of the widest field, within HDF5's chunk
 * cache. */
enum { MPM_SNAPSHOT_BLOCK = 16384 };

enum mpm_snapshot_compression { MPM_STORED, MPM_DEFLATED };

struct mpm_snapshot {
    const struct mpm_scene *scene;
    const struct mpm_simulation *simulation;
    double *work;             /* of mpm_snapshot_work_size */
    unsigned long long count; /* particles */
    char *failure;            /* first failure of HDF5, or NULL */
    int64_t file, scalar, text;
};

/* Returns `result`, and keeps the reason if it is a failure. */
int64_t mpm_snapshot_checked(struct mpm_snapshot *snapshot, int64_t result);

/* A new group, open. */
int64_t mpm_snapshot_group(struct mpm_snapshot *snapshot, int64_t parent, const char *name);

/* `rank` dimensions of `size`; rank 0 is a scalar. */
void mpm_snapshot_attribute(struct mpm_snapshot *snapshot, int64_t object, const char *name,
                            int64_t file_type, int64_t memory_type, unsigned long long size,
                            int rank, const void *data);
void mpm_snapshot_text(struct mpm_snapshot *snapshot, int64_t object, const char *name,
                       const char *text);
void mpm_snapshot_texts(struct mpm_snapshot *snapshot, int64_t object, const char *name,
                        const char *const *texts, size_t count);

/* What the rows of a dataset come from: puts rows first .. first + count - 1 into `work`. */
struct mpm_snapshot_source {
    void (*fill)(const struct mpm_snapshot *snapshot, const struct mpm_snapshot_source *source,
                 size_t first, size_t count);
    enum mpm_field field;
    size_t component; /* of the field, where only one is written */
    double value;
};

/* Writes a new dataset of `type`, a block at a time; returns it open. */
int64_t mpm_snapshot_dataset(struct mpm_snapshot *snapshot, int64_t parent, const char *name,
                             int64_t type, unsigned long long rows, unsigned long long columns,
                             enum mpm_snapshot_compression compression,
                             const struct mpm_snapshot_source *source);

/* Fills with the source's `value`. */
void mpm_snapshot_fill_value(const struct mpm_snapshot *snapshot,
                             const struct mpm_snapshot_source *source, size_t first, size_t count);

/* A dataset of one number. */
void mpm_snapshot_number(struct mpm_snapshot *snapshot, int64_t parent, const char *name,
                         int64_t type, double value);

#endif

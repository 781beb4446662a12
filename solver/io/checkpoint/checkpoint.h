/* The checkpoints of a run: checkpoint.h5 and checkpoint-previous.h5, the one before it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_CHECKPOINT_H
#define MPM_IO_CHECKPOINT_H

#include "io/checkpoint/checkpoint_file.h"
#include "model/scene.h"

#define MPM_CHECKPOINT_NAME     "checkpoint.h5"
#define MPM_CHECKPOINT_PREVIOUS "checkpoint-previous.h5"

/* Writes the pieces that `visit` lists, with the scene, its settings, the kernels and the build, to
 * a temporary file, and then renames: a run that is killed at any moment leaves the new checkpoint
 * or the one before. */
enum mpm_status
mpm_checkpoint_write(const char *folder, const struct mpm_scene *scene, const char *kernels,
                     void (*visit)(void *context, struct mpm_piece_visitor *visitor), void *context,
                     struct mpm_error *error);

/* A checkpoint that a run can go on from. */
struct mpm_checkpoint {
    struct mpm_checkpoint_file *file;
    const char *name;         /* in the folder */
    enum mpm_kernels kernels; /* with which it was written */
    /* what a user should know; may be empty */
    char older_warning[MPM_MESSAGE_SIZE]; /* the newest one is damaged */
    char build_warning[MPM_MESSAGE_SIZE]; /* another build wrote it */
};

/* Opens the newest one that is sound. MPM_BAD_INPUT: there is none, or it is of another scene,
 * of other settings, or of other kernels than those asked for. */
enum mpm_status mpm_checkpoint_open(const char *folder, const struct mpm_scene *scene,
                                    enum mpm_kernels asked, struct mpm_checkpoint *checkpoint,
                                    struct mpm_error *error);
void mpm_checkpoint_close(struct mpm_checkpoint *checkpoint);

#endif

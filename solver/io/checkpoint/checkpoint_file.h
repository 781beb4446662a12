/* A file of pieces: HDF5 behind a head of 512 bytes, text that has the format's number, the file's
 * length and the MD5 sum of all that follows. The sum is checked before HDF5 reads anything.
 *
 * A piece is a dataset of one dimension, by its name; h5dump and h5py read the file as it is.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_CHECKPOINT_FILE_H
#define MPM_IO_CHECKPOINT_FILE_H

#include "base/piece.h"

enum { MPM_CHECKPOINT_FORMAT = 1 };

/* Writes the pieces that `visit` lists to a file and syncs it. MPM_ENVIRONMENT_FAILED names the
 * file and the system's reason; nothing is left at `path` then. */
enum mpm_status mpm_checkpoint_file_write(const char *path,
                                          void (*visit)(void *context,
                                                        struct mpm_piece_visitor *visitor),
                                          void *context, struct mpm_error *error);

struct mpm_checkpoint_file;

/* MPM_BAD_INPUT: there is no such file, it is no checkpoint, of another format, or damaged. */
enum mpm_status mpm_checkpoint_file_open(const char *path, struct mpm_checkpoint_file **file,
                                         struct mpm_error *error);
void mpm_checkpoint_file_close(struct mpm_checkpoint_file *file);

/* Fills the piece's data: a visitor's `take`, with the file as its context. MPM_BAD_INPUT: the file
 * has no such piece, or of another length. */
enum mpm_status mpm_checkpoint_file_read(void *file, const struct mpm_piece *piece,
                                         struct mpm_error *error);

#endif

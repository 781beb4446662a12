/* A file that rows are appended to while a run goes on: history.csv, probes.csv.
 *
 * It has whole rows only. A checkpoint has its length, so that a run that goes on takes away what
 * was written after the checkpoint, and the step of its last row, so that no step is written twice.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_ROWS_H
#define MPM_IO_ROWS_H

#include "base/piece.h"

#include <glib.h>

struct mpm_rows {
    char *path;
    int file;
    int64_t size; /* of the complete rows, in bytes */
    bool has_row;
    uint64_t last_step;
};

/* Makes the file, in place of one that may be there, with the lines of its head.
 * MPM_ENVIRONMENT_FAILED names the file and the system's reason. */
enum mpm_status mpm_rows_create(const char *folder, const char *name, const GString *head,
                                struct mpm_rows *rows, struct mpm_error *error);
/* Opens that of a run that was interrupted. What mpm_rows_visit reads is then put into force by
 * mpm_rows_cut, which takes away the rows after it. MPM_BAD_INPUT: there is no such file, or it is
 * shorter. */
enum mpm_status mpm_rows_reopen(const char *folder, const char *name, struct mpm_rows *rows,
                                struct mpm_error *error);
/* `names`: of the pieces size, has_row and last_step. */
void mpm_rows_visit(struct mpm_rows *rows, const char *const names[3],
                    struct mpm_piece_visitor *visitor);
enum mpm_status mpm_rows_cut(struct mpm_rows *rows, struct mpm_error *error);
void mpm_rows_close(struct mpm_rows *rows);

/* Is the last row of that step? */
bool mpm_rows_have(const struct mpm_rows *rows, uint64_t step);
/* Appends the rows of a step; they are handed to the system at once, so a run that ends badly keeps
 * them. What does not fit on the disk is taken away again. */
enum mpm_status mpm_rows_append(struct mpm_rows *rows, const GString *text, uint64_t step,
                                struct mpm_error *error);

/* Brings them to the disk. */
enum mpm_status mpm_rows_sync(const struct mpm_rows *rows, struct mpm_error *error);

#endif

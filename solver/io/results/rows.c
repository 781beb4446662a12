/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/rows.h"

#include "mpm_file.h"

#include <errno.h>
#include <fcntl.h>

static enum mpm_status append(struct mpm_rows *rows, const GString *text, struct mpm_error *error)
{
    if (mpm_file_write_at(rows->file, text->str, text->len, rows->size) == 0) {
        rows->size += (int64_t)text->len;
        return MPM_OK;
    }
    const int failure = errno;
    (void)mpm_file_cut(rows->file, rows->size); /* the first failure is the one to report */
    return mpm_file_failed(rows->path, failure, error);
}

/* Returns false, and errno has the reason. */
static bool open_file(const char *folder, const char *name, int flags, struct mpm_rows *rows)
{
    *rows = (struct mpm_rows){.path = g_build_filename(folder, name, NULL)};
    rows->file = mpm_file_open(rows->path, flags | O_WRONLY);
    return rows->file >= 0;
}

enum mpm_status mpm_rows_create(const char *folder, const char *name, const GString *head,
                                struct mpm_rows *rows, struct mpm_error *error)
{
    return open_file(folder, name, O_CREAT | O_TRUNC, rows)
               ? append(rows, head, error)
               : mpm_file_failed(rows->path, errno, error);
}

enum mpm_status mpm_rows_reopen(const char *folder, const char *name, struct mpm_rows *rows,
                                struct mpm_error *error)
{
    if (open_file(folder, name, 0, rows))
        return MPM_OK;
    struct mpm_error own = {.status = MPM_OK};
    const enum mpm_status status = mpm_file_unread(rows->path, errno, NULL, &own);
    return mpm_error_set(error, status, "--resume: %s", own.message);
}

void mpm_rows_visit(struct mpm_rows *rows, const char *const names[3],
                    struct mpm_piece_visitor *visitor)
{
    mpm_piece_visit(visitor, MPM_PIECE_INT64, &rows->size, 1, names[0], -1);
    mpm_piece_visit(visitor, MPM_PIECE_BOOL, &rows->has_row, 1, names[1], -1);
    mpm_piece_visit(visitor, MPM_PIECE_UINT64, &rows->last_step, 1, names[2], -1);
}

enum mpm_status mpm_rows_cut(struct mpm_rows *rows, struct mpm_error *error)
{
    struct stat facts;
    if (mpm_file_facts(rows->file, &facts) != 0)
        return mpm_file_failed(rows->path, errno, error);
    if (rows->size < 0 || rows->size > facts.st_size)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "--resume: %s has %lld bytes, fewer than when the checkpoint was "
                             "written; allowed: from %lld on",
                             rows->path, (long long)facts.st_size, (long long)rows->size);
    return mpm_file_cut(rows->file, rows->size) == 0 ? MPM_OK
                                                     : mpm_file_failed(rows->path, errno, error);
}

void mpm_rows_close(struct mpm_rows *rows)
{
    if (rows->file >= 0)
        (void)mpm_file_close(rows->file);
    g_free(rows->path);
}

bool mpm_rows_have(const struct mpm_rows *rows, uint64_t step)
{
    return rows->has_row && rows->last_step == step;
}

enum mpm_status mpm_rows_append(struct mpm_rows *rows, const GString *text, uint64_t step,
                                struct mpm_error *error)
{
    const enum mpm_status status = append(rows, text, error);
    rows->has_row = rows->has_row || status == MPM_OK;
    rows->last_step = status == MPM_OK ? step : rows->last_step;
    return status;
}

enum mpm_status mpm_rows_sync(const struct mpm_rows *rows, struct mpm_error *error)
{
    return mpm_file_sync(rows->file) == 0 ? MPM_OK : mpm_file_failed(rows->path, errno, error);
}

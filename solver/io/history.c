/* history.csv: the sums over all particles, one row per sample.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/history.h"

#include "io/file_write.h"
#include "io/units.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <stddef.h>
#include <unistd.h>

struct mpm_history {
    char *path;
    int file;
    off_t size; /* of the complete rows */
    size_t column_count;
    bool has_row;
    uint64_t last_step;
};

static const struct column {
    const char *name;
    size_t offset;          /* in struct mpm_ledger */
    bool counts;            /* uint64_t instead of double */
    int length, mass, time; /* exponents of the unit */
} columns[] = {
    {"time", offsetof(struct mpm_ledger, time), false, 0, 0, 1},
    {"step", offsetof(struct mpm_ledger, step), true, 0, 0, 0},
    {"mass", offsetof(struct mpm_ledger, mass), false, 0, 1, 0},
    {"momentum_x", offsetof(struct mpm_ledger, momentum[0]), false, 1, 1, -1},
    {"momentum_y", offsetof(struct mpm_ledger, momentum[1]), false, 1, 1, -1},
    {"angular_momentum", offsetof(struct mpm_ledger, angular_momentum), false, 2, 1, -1},
    {"kinetic_energy", offsetof(struct mpm_ledger, kinetic_energy), false, 2, 1, -2},
    {"strain_energy", offsetof(struct mpm_ledger, strain_energy), false, 2, 1, -2},
    {"external_work", offsetof(struct mpm_ledger, external_work), false, 2, 1, -2},
    {"total_energy", offsetof(struct mpm_ledger, total_energy), false, 2, 1, -2},
    {"j_min", offsetof(struct mpm_ledger, j_min), false, 0, 0, 0},
    {"j_max", offsetof(struct mpm_ledger, j_max), false, 0, 0, 0},
    /* of damped scenes only */
    {"damping_dissipation", offsetof(struct mpm_ledger, damping_dissipation), false, 2, 1, -2},
};

static void append_value(GString *row, const struct column *column, const struct mpm_ledger *ledger)
{
    const char *value = (const char *)ledger + column->offset;
    if (column->counts) {
        g_string_append_printf(row, "%" G_GUINT64_FORMAT, *(const uint64_t *)(const void *)value);
        return;
    }
    char text[G_ASCII_DTOSTR_BUF_SIZE]; /* a decimal point in every locale */
    g_string_append(
        row, g_ascii_formatd(text, sizeof text, "%.17g", *(const double *)(const void *)value));
}

static enum mpm_status append_line(struct mpm_history *history, const GString *line,
                                   struct mpm_error *error)
{
    const int failure = mpm_file_write_at(history->file, line->str, line->len, history->size);
    if (failure == 0) {
        history->size += (off_t)line->len;
        return MPM_OK;
    }
    const int kept = ftruncate(history->file, history->size);
    (void)kept; /* the failure to report is the first one */
    return mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be written: %s", history->path,
                         g_strerror(failure));
}

static enum mpm_status write_head(struct mpm_history *history, const struct mpm_scene *scene,
                                  struct mpm_error *error)
{
    GString *head = g_string_new(NULL);
    for (size_t i = 0; i < history->column_count; i++)
        g_string_append_printf(head, "%s%s", i == 0 ? "" : ",", columns[i].name);
    for (size_t i = 0; i < history->column_count; i++) {
        char unit[MPM_UNIT_SIZE];
        mpm_unit_text(scene, columns[i].length, columns[i].mass, columns[i].time, unit);
        g_string_append_printf(head, "%s%s", i == 0 ? "\n# " : ",", unit);
    }
    g_string_append_c(head, '\n');
    const enum mpm_status status = append_line(history, head, error);
    g_string_free(head, TRUE);
    return status;
}

enum mpm_status mpm_history_create(const char *folder, const struct mpm_scene *scene,
                                   struct mpm_history **history, struct mpm_error *error)
{
    struct mpm_history *created = g_new0(struct mpm_history, 1);
    *history = NULL;
    created->path = g_build_filename(folder, MPM_HISTORY_NAME, NULL);
    created->column_count = G_N_ELEMENTS(columns) - (mpm_scene_is_damped(scene) ? 0 : 1);
    created->file = open(created->path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    const enum mpm_status status =
        created->file < 0
            ? mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be written: %s",
                            created->path, g_strerror(errno))
            : write_head(created, scene, error);
    if (status != MPM_OK)
        mpm_history_free(created);
    else
        *history = created;
    return status;
}

void mpm_history_free(struct mpm_history *history)
{
    if (history == NULL)
        return;
    if (history->file >= 0)
        (void)close(history->file);
    g_free(history->path);
    g_free(history);
}

enum mpm_status mpm_history_write(struct mpm_history *history, const struct mpm_ledger *ledger,
                                  struct mpm_error *error)
{
    if (history->has_row && history->last_step == ledger->step)
        return MPM_OK;
    GString *row = g_string_new(NULL);
    for (size_t i = 0; i < history->column_count; i++) {
        if (i > 0)
            g_string_append_c(row, ',');
        append_value(row, &columns[i], ledger);
    }
    g_string_append_c(row, '\n');
    const enum mpm_status status = append_line(history, row, error);
    g_string_free(row, TRUE);
    if (status == MPM_OK) {
        history->has_row = true;
        history->last_step = ledger->step;
    }
    return status;
}

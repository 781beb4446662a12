/* history.csv: the sums over all particles, one row per sample.
 *
 * The first line names the columns, the second, a comment, their units. Numbers have
 * 17 significant digits, so that they read back as the same bits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_HISTORY_H
#define MPM_IO_HISTORY_H

#include "base/piece.h"
#include "model/scene.h"

#define MPM_HISTORY_NAME "history.csv"

struct mpm_history;

/* Makes the file in `folder`, in place of one that may be there, with its two first
 * lines; the scene must outlive it. MPM_ENVIRONMENT_FAILED names the file and the system's reason.
 */
enum mpm_status mpm_history_create(const char *folder, const struct mpm_scene *scene,
                                   struct mpm_history **history, struct mpm_error *error);
/* Opens that of a run that was interrupted. What mpm_history_visit reads is then put into force by
 * mpm_history_cut, which takes away the rows after it. MPM_BAD_INPUT: there is no such file, or it
 * is shorter. */
enum mpm_status mpm_history_reopen(const char *folder, const struct mpm_scene *scene,
                                   struct mpm_history **history, struct mpm_error *error);
void mpm_history_visit(struct mpm_history *history, struct mpm_piece_visitor *visitor);
enum mpm_status mpm_history_cut(struct mpm_history *history, struct mpm_error *error);

/* Brings its rows to the disk. */
enum mpm_status mpm_history_sync(const struct mpm_history *history, struct mpm_error *error);

void mpm_history_free(struct mpm_history *history);

/* Appends a row: the ledger, and the simulation's values of cracks, which may be NULL where the
 * scene has no such quantities; nothing if the last row is of the same step. MPM_RUN_FAILED: a J
 * integral has no value any more; its columns are nan, and the row is there. The row is handed to
 * the system at once, so a run that ends badly keeps it. A row that does not fit on the disk is
 * taken away again: the file holds whole rows only. */
enum mpm_status mpm_history_write(struct mpm_history *history, const struct mpm_ledger *ledger,
                                  const struct mpm_simulation *simulation, struct mpm_error *error);

#endif

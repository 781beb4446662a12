/* What a run consists of, as it is kept in its output folder (.run/run.json): a run that goes on,
 * the tasks of a campaign and their collection are of the same selection.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_RUN_STATE_H
#define VERIFICATION_SUITE_RUN_STATE_H

#include "verification/common/record.h"
#include "verification/suite/output_folder.h"

/* Texts as on the command line; NULL: not given. Each is freed with g_free. */
struct run_texts {
    char *tier, *case_globs, *variant_globs, *only, *kernels, *baseline, *api, *catalogue;
};

/* As they are kept: paths from the root on, and what not giving one means. */
void run_texts_complete(struct run_texts *texts);
void run_texts_clear(struct run_texts *texts);

/* Begins a run: results of the run before are removed, and the texts, completed, are kept with the
 * command that was typed and the time. Call it with the folder opened. */
enum mpm_status run_state_begin(const struct output_folder *output, const struct run_texts *texts,
                                const char *command, struct mpm_error *error);

/* For a run that goes on: fills in what is not given as the run was begun; *state is run.json, with
 * the texts `command` and `started` and the number `seconds` (released with json_decref).
 * MPM_BAD_INPUT: no run was begun there, or something given differs from it. */
enum mpm_status run_state_adopt(const char *folder, struct run_texts *texts, json_t **state,
                                struct mpm_error *error);

/* Keeps how many seconds the run has taken so far. */
enum mpm_status run_state_add_seconds(const struct output_folder *output, double seconds,
                                      struct mpm_error *error);

#endif

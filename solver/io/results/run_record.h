/* run.json: how a run ended, what it cost and where it comes from.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_RUN_RECORD_H
#define MPM_IO_RUN_RECORD_H

#include "model/scene.h"

#define MPM_RUN_RECORD_NAME "run.json"

struct mpm_run_record {
    const struct mpm_simulation *simulation; /* at its end */
    enum mpm_status status;
    enum mpm_cause cause;       /* of a failed run */
    const char *reason;         /* why the run ended */
    const char *growth_warning; /* of a run that went on; "" where there is none */
    const char *parted_warning; /* the same */
    const char *melted_warning; /* the same */
    const char *older_warning;  /* of the checkpoint that it has gone on from last; the same */
    const char *build_warning;  /* the same */
    const char *scene_path;     /* NULL: as the scene names itself */
    size_t output_bytes;        /* working space of the output */
    double seconds_setup, seconds_step, seconds_output, seconds_checkpoint;
    uint64_t checkpoints;    /* written, */
    size_t checkpoint_bytes; /* of one */
    uint64_t resumes;        /* how often the run has gone on from one, */
    uint64_t resumed_step;   /* and where it did last */
    int signal;              /* of a run that was interrupted */
};

/* Writes run.json into `folder`, whole or not at all. `outcome` is "done" for MPM_OK,
 * "interrupted" for MPM_INTERRUPTED and "failed" otherwise; `cause` is null unless the run has
 * failed with one, `energy_growth` null unless it was seen; `ended_tips` lists the tips of cracks
 * that may grow and have ended. MPM_ENVIRONMENT_FAILED names the file and the reason. */
enum mpm_status mpm_run_record_write(const char *folder, const struct mpm_scene *scene,
                                     const struct mpm_run_record *record, struct mpm_error *error);

#endif

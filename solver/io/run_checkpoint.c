/* Checkpoints of a run: when one is due, what it has beside the simulation, and going on from one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/checkpoint/checkpoint.h"
#include "io/run_state.h"
#include "simulation/checkpoint.h"

#include <glib.h>
#include <inttypes.h>

/* Of the run alone. */
static void visit_results(struct mpm_run *run, struct mpm_piece_visitor *visitor)
{
    struct mpm_run_record *const record = &run->record;
    double *const seconds[] = {&record->seconds_setup, &record->seconds_step,
                               &record->seconds_output, &record->seconds_checkpoint};
    mpm_history_visit(run->history, visitor);
    mpm_probes_visit(run->probes, visitor);
    mpm_series_visit(run->series, visitor);
    for (int k = 0; k < (int)G_N_ELEMENTS(seconds); k++)
        mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, seconds[k], 1, "run.seconds", k);
    mpm_piece_visit(visitor, MPM_PIECE_UINT64, &record->checkpoints, 1, "run.checkpoints", -1);
    mpm_piece_visit(visitor, MPM_PIECE_UINT64, &record->resumes, 1, "run.resumes", -1);
    mpm_piece_visit(visitor, MPM_PIECE_UINT8, run->growth_warning, MPM_MESSAGE_SIZE,
                    "run.growth_warning", -1);
    mpm_piece_visit(visitor, MPM_PIECE_UINT8, run->parted_warning, MPM_MESSAGE_SIZE,
                    "run.parted_warning", -1);
    mpm_piece_visit(visitor, MPM_PIECE_UINT8, run->melted_warning, MPM_MESSAGE_SIZE,
                    "run.melted_warning", -1);
    mpm_piece_visit(visitor, MPM_PIECE_BOOL, run->tip_told, mpm_scene_j_integral_count(run->scene),
                    "run.tip_told", -1);
    run->growth_warning[MPM_MESSAGE_SIZE - 1] = '\0';
    run->parted_warning[MPM_MESSAGE_SIZE - 1] = '\0';
    run->melted_warning[MPM_MESSAGE_SIZE - 1] = '\0';
}

static void visit_run(void *context, struct mpm_piece_visitor *visitor)
{
    struct mpm_run *const run = context;
    visit_results(run, visitor);
    mpm_checkpoint_visit(run->simulation, visitor);
}

/* ------------------------------------------------------------------ writing */

enum mpm_status mpm_run_checkpoint(struct mpm_run *run, struct mpm_error *error)
{
    const double start = mpm_run_seconds();
    run->record.checkpoints++;
    MPM_TRY(mpm_probes_sync(run->probes, error));
    MPM_TRY(mpm_history_sync(run->history, error)); /* its rows are older than the checkpoint */
    MPM_TRY(mpm_checkpoint_write(run->options->output, run->scene,
                                 mpm_simulation_kernels(run->simulation), visit_run, run, error));
    run->checkpoint_time = mpm_run_seconds();
    run->record.checkpoint_bytes = mpm_checkpoint_bytes(run->simulation);
    run->record.seconds_checkpoint += run->checkpoint_time - start;
    return MPM_OK;
}

enum mpm_status mpm_run_checkpoint_due(struct mpm_run *run, struct mpm_error *error)
{
    const struct mpm_scene *const scene = run->scene;
    const double instant =
        mpm_run_instant(mpm_simulation_time(run->simulation), scene->checkpoint_interval);
    const bool passed = instant > run->checkpoint_instant;
    const bool waited = scene->checkpoint_seconds > 0.0 &&
                        mpm_run_seconds() - run->checkpoint_time >= scene->checkpoint_seconds;
    run->checkpoint_instant = instant;
    return run->series != NULL && (passed || waited) ? mpm_run_checkpoint(run, error) : MPM_OK;
}

/* ----------------------------------------------------------------- going on */

/* A value in the file that cannot be: the message names the file. */
static enum mpm_status refuse(const struct mpm_checkpoint *checkpoint, enum mpm_status status,
                              struct mpm_error *error)
{
    const struct mpm_error why = *error;
    return status == MPM_BAD_INPUT
               ? mpm_error_set(error, status, "--resume: %s: %.900s", checkpoint->name, why.message)
               : status;
}

static enum mpm_status load(struct mpm_run *run, const struct mpm_checkpoint *checkpoint,
                            struct mpm_error *error)
{
    struct mpm_simulation_options options = run->options->simulation;
    struct mpm_piece_visitor visitor = {
        .take = mpm_checkpoint_file_read, .context = checkpoint->file, .error = error};
    options.kernels = checkpoint->kernels;
    MPM_TRY(mpm_simulation_create(run->scene, &options, &run->simulation, error));
    const enum mpm_status loaded = mpm_checkpoint_load(run->simulation, &visitor);
    if (loaded != MPM_OK)
        return refuse(checkpoint, loaded, error);
    MPM_TRY(mpm_series_create(run->options->output, run->scene,
                              mpm_simulation_particle_count(run->simulation), &run->series, error));
    MPM_TRY(mpm_history_reopen(run->options->output, run->scene, &run->history, error));
    MPM_TRY(mpm_probes_reopen(run->options->output, run->scene, &run->probes, error));
    visit_results(run, &visitor);
    return refuse(checkpoint, visitor.status, error);
}

/* Results are those of the checkpoint from now on. */
static enum mpm_status rewind_results(struct mpm_run *run, struct mpm_error *error)
{
    const char *const folder = run->options->output;
    MPM_TRY(mpm_history_cut(run->history, error));
    MPM_TRY(mpm_probes_cut(run->probes, error));
    MPM_TRY(mpm_results_folder_rewind(folder, mpm_series_count(run->series), error));
    return mpm_series_count(run->series) > 0 ? mpm_series_write_list(run->series, error) : MPM_OK;
}

enum mpm_status mpm_run_resume(struct mpm_run *run, struct mpm_error *error)
{
    struct mpm_checkpoint checkpoint;
    MPM_TRY(mpm_checkpoint_open(run->options->output, run->scene, run->options->simulation.kernels,
                                &checkpoint, error));
    (void)g_strlcpy(run->older_warning, checkpoint.older_warning, MPM_MESSAGE_SIZE);
    (void)g_strlcpy(run->build_warning, checkpoint.build_warning, MPM_MESSAGE_SIZE);
    enum mpm_status status = load(run, &checkpoint, error);
    mpm_checkpoint_close(&checkpoint);
    if (status == MPM_OK)
        status = rewind_results(run, error);
    if (status != MPM_OK)
        return status;
    const double time = mpm_simulation_time(run->simulation);
    run->history_instant = mpm_run_instant(time, run->scene->history_interval);
    run->snapshot_instant = mpm_run_instant(time, run->scene->snapshot_interval);
    run->checkpoint_instant = mpm_run_instant(time, run->scene->checkpoint_interval);
    run->record.resumes++;
    run->record.resumed_step = mpm_simulation_step(run->simulation);
    if (run->older_warning[0] != '\0')
        mpm_run_warn(run, run->older_warning);
    if (run->build_warning[0] != '\0')
        mpm_run_warn(run, run->build_warning);
    return MPM_OK;
}

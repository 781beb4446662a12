/* A scene run to its end, with its result files: mpm_scene_run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/run_state.h"
#include "mpm_file.h"

#include <errno.h>
#include <glib.h>
#include <inttypes.h>
#include <math.h>

/* An instant this close to the next one, in intervals, is taken to be it: products of
 * the interval carry round-off, and a last sliver of a step would serve nobody. */
static const double instant_tolerance = 1e-9;

double mpm_run_seconds(void)
{
    return 1e-6 * (double)g_get_monotonic_time();
}

/* ---------------------------------------------------------------- instants */

double mpm_run_instant(double time, double interval)
{
    return interval > 0.0 ? floor(time / interval + instant_tolerance) : 0.0;
}

/* Time that the next step must not pass: the next snapshot, that of an observer, or the end.
 * Counted from t = 0, so that no error adds up. */
static double time_limit(const struct mpm_run *run)
{
    const double interval = run->scene->snapshot_interval, end = run->scene->end;
    const double next = (run->snapshot_instant + 1.0) * interval;
    const double limit = interval > 0.0 && next < end - instant_tolerance * interval ? next : end;
    return mpm_observers_limit(run->observers, limit);
}

static bool has_taken_all_steps(const struct mpm_run *run)
{
    return run->scene->steps > 0 &&
           mpm_simulation_step(run->simulation) >= (uint64_t)run->scene->steps;
}

static bool is_finished(const struct mpm_run *run)
{
    return mpm_simulation_time(run->simulation) >= run->scene->end || has_taken_all_steps(run) ||
           mpm_simulation_at_rest(run->simulation, NULL) ||
           mpm_simulation_stagnates(run->simulation);
}

static const char *end_reason(const struct mpm_run *run)
{
    if (mpm_simulation_at_rest(run->simulation, NULL))
        return "at rest";
    if (mpm_simulation_stagnates(run->simulation))
        return "time.rest.patience is over";
    return has_taken_all_steps(run) ? "time.steps taken" : "time.end reached";
}

/* ------------------------------------------------------------------ output */

void mpm_run_warn(const struct mpm_run *run, const char *warning)
{
    if (run->options->warn != NULL)
        run->options->warn(run->options->progress_context, warning);
}

/* Once, when it is first seen. */
static void warn_of_growth(struct mpm_run *run)
{
    struct mpm_energy_growth growth;
    if (run->growth_warning[0] != '\0' || !mpm_simulation_energy_growth(run->simulation, &growth))
        return;
    (void)g_snprintf(run->growth_warning, sizeof run->growth_warning,
                     "growing energy, first seen at step %" PRIu64
                     ", time %g: %.3g times what the start and "
                     "the work since have put in; the run goes on up to 10 times",
                     growth.step, growth.time, growth.factor);
    mpm_run_warn(run, run->growth_warning);
}

/* Once, at the first row of the history that has parted pairs. */
static void warn_of_parting(struct mpm_run *run, const struct mpm_ledger *ledger)
{
    if (ledger->parted_pairs == 0 || run->parted_warning[0] != '\0')
        return;
    (void)g_snprintf(
        run->parted_warning, sizeof run->parted_warning,
        "numerical fracture, first seen at step %" PRIu64 ", time %g: %" PRIu64
        " pairs of neighbouring particles have no node in common; see parted_pairs of history.csv",
        ledger->step, ledger->time, ledger->parted_pairs);
    mpm_run_warn(run, run->parted_warning);
}

/* The same for melted particles. */
static void warn_of_melting(struct mpm_run *run, const struct mpm_ledger *ledger)
{
    if (ledger->melted_particles == 0 || run->melted_warning[0] != '\0')
        return;
    (void)g_snprintf(run->melted_warning, sizeof run->melted_warning,
                     "melting, first seen at step %" PRIu64 ", time %g: %" PRIu64
                     " particles at their melting temperature or above have no strength; see "
                     "melted_particles of history.csv",
                     ledger->step, ledger->time, ledger->melted_particles);
    mpm_run_warn(run, run->melted_warning);
}

/* Each once. */
static void warn_of_tips(struct mpm_run *run)
{
    const size_t count = mpm_scene_j_integral_count(run->scene);
    for (size_t k = 0; k < count; k++) {
        struct mpm_tip_end end;
        char message[MPM_MESSAGE_SIZE];
        if (run->tip_told[k] || !mpm_simulation_tip_end(run->simulation, k, &end, message))
            continue;
        run->tip_told[k] = true;
        mpm_run_warn(run, message);
    }
}

static enum mpm_status write_history(struct mpm_run *run, struct mpm_error *error)
{
    struct mpm_ledger ledger;
    mpm_simulation_ledger(run->simulation, &ledger);
    warn_of_parting(run, &ledger);
    warn_of_melting(run, &ledger);
    const enum mpm_status status = mpm_history_write(run->history, &ledger, run->simulation, error);
    if (status == MPM_RUN_FAILED)
        mpm_error_locate(error, ledger.step, ledger.time);
    return status;
}

/* A failure to write says at which state of the run that was and what there is. */
static enum mpm_status add_state(const struct mpm_run *run, enum mpm_status status,
                                 struct mpm_error *error)
{
    double time = 0.0;
    const char *last = mpm_series_last(run->series, &time);
    const struct mpm_error why = *error;
    char complete[64] = "none";
    if (last != NULL)
        g_snprintf(complete, sizeof complete, "%s of time %.9g", last, time);
    (void)mpm_error_set(error, status,
                        "%s; the run stopped at step %" PRIu64
                        ", time %.9g; last complete snapshot: %s",
                        why.message, mpm_simulation_step(run->simulation),
                        mpm_simulation_time(run->simulation), complete);
    return status;
}

/* Writes what is due; what is there already for this step is not written twice.
 * MPM_RUN_FAILED: all is written, but a row of the history has a quantity without a value. */
static enum mpm_status write_results(struct mpm_run *run, bool history, bool snapshot,
                                     struct mpm_error *error)
{
    if (run->series == NULL || !(history || snapshot))
        return MPM_OK;
    const double start = mpm_run_seconds();
    const enum mpm_status row = history ? write_history(run, error) : MPM_OK;
    enum mpm_status status = row == MPM_RUN_FAILED ? MPM_OK : row;
    if (status == MPM_OK && history)
        status = mpm_probes_write(run->probes, run->simulation, error);
    if (status == MPM_OK && snapshot)
        status = mpm_series_write(run->series, run->simulation, error);
    run->record.seconds_output += mpm_run_seconds() - start;
    return status == MPM_OK ? row : add_state(run, status, error);
}

static enum mpm_status write_due_results(struct mpm_run *run, struct mpm_error *error)
{
    const double time = mpm_simulation_time(run->simulation);
    const double history = mpm_run_instant(time, run->scene->history_interval);
    const double snapshot = mpm_run_instant(time, run->scene->snapshot_interval);
    const bool history_due = history > run->history_instant;
    const bool snapshot_due = snapshot > run->snapshot_instant;
    const bool finished = is_finished(run);
    const bool observed = mpm_observers_due(run->observers, finished);
    run->history_instant = history;
    run->snapshot_instant = snapshot;
    if (!(history_due || snapshot_due || finished || observed))
        return MPM_OK;
    MPM_TRY(mpm_simulation_judge(run->simulation, error));
    MPM_TRY(write_results(run, history_due || finished, snapshot_due || finished, error));
    return observed ? mpm_observers_call(run->observers, false, error) : MPM_OK;
}

/* The simulation still shows the last good step; the first failure stays the reason. */
static enum mpm_status keep_last_good_state(struct mpm_run *run, enum mpm_status failed,
                                            struct mpm_error *error)
{
    const struct mpm_error first = *error;
    struct mpm_error second = {.status = MPM_OK};
    const enum mpm_status status = write_results(run, true, true, &second);
    if (status == MPM_OK || status == MPM_RUN_FAILED)
        return failed;
    (void)mpm_error_set(error, failed, "%s; and the last good state cannot be written: %s",
                        first.message, second.message);
    error->cause = first.cause;
    return failed;
}

/* --------------------------------------------------------------------- run */

static void report_progress(const struct mpm_run *run)
{
    if (run->options->progress == NULL)
        return;
    double fraction = mpm_simulation_time(run->simulation) / run->scene->end;
    if (run->scene->steps > 0)
        fraction =
            MAX(fraction, (double)mpm_simulation_step(run->simulation) / (double)run->scene->steps);
    run->options->progress(run->options->progress_context, MIN(fraction, 1.0), run->simulation);
}

/* What may bring a scene to rest that has not come there, by what keeps it from it. */
static const char *rest_advice(const struct mpm_run *run, const struct mpm_rest *rest)
{
    const struct mpm_rest_spec *const asked = &run->scene->rest;
    const enum mpm_stress_update order = run->scene->stress_update;
    const bool balanced = rest->residual < asked->residual;
    const bool still = rest->kinetic_energy < asked->kinetic_energy;
    const bool falls = rest->fallen_time > 0.75 * mpm_simulation_time(run->simulation) &&
                       !mpm_simulation_stagnates(run->simulation);
    if (mpm_scene_is_at_rest(run->scene))
        return "the flow still changes: run longer";
    if (balanced && still)
        return "both are below now: run longer";
    if (balanced)
        return "nodes are balanced, particles move: damping.grid does not reach what nodes do not "
               "carry, damping.particle and damping.pic do";
    if (falls)
        return "the residual still falls: run longer, or damp more";
    if (still && (order == MPM_USL || order == MPM_USAVG_ONCE))
        return "particles do not move, nodes are not balanced: allow a larger residual";
    if (still)
        return "particles do not move, nodes are not balanced: with stress_update musl, usf and "
               "usavg the strain does not follow nodes of little mass at an edge; with usl it "
               "does, and with usavg and extrapolate: false; or allow a larger residual";
    if (mpm_simulation_stagnates(run->simulation))
        return "damp more, or give time.rest.patience more steps";
    return "damp more, or run longer";
}

/* A scene with `time.rest` that ends without rest has failed; its last state is written. */
static enum mpm_status check_rest(const struct mpm_run *run, struct mpm_error *error)
{
    const struct mpm_rest_spec *const asked = &run->scene->rest;
    struct mpm_rest rest;
    if (mpm_simulation_at_rest(run->simulation, &rest) || !rest.asked)
        return MPM_OK;
    return mpm_error_fail(error, MPM_CAUSE_NOT_AT_REST,
                          "not at rest when %s, at step %" PRIu64
                          ", time %g: residual %g, kinetic energy %g; allowed: below %g and %g for "
                          "%" PRId64 " steps; the residual was lowest at time %g, %g; %s",
                          end_reason(run), mpm_simulation_step(run->simulation),
                          mpm_simulation_time(run->simulation), rest.residual, rest.kinetic_energy,
                          asked->residual, asked->kinetic_energy, asked->steps, rest.lowest_time,
                          rest.lowest_residual, rest_advice(run, &rest));
}

/* The checkpoint is of the state as the run would go on from it; the row of the history after it
 * belongs to the interruption alone. */
static enum mpm_status interrupt(struct mpm_run *run, int signal, struct mpm_error *error)
{
    run->record.signal = signal;
    if (run->series != NULL) {
        const enum mpm_status written = mpm_run_checkpoint(run, error);
        if (written != MPM_OK)
            return add_state(run, written, error);
        const enum mpm_status judged = mpm_simulation_judge(run->simulation, error);
        if (judged != MPM_OK)
            return keep_last_good_state(run, judged, error);
        MPM_TRY(write_results(run, true, false, error));
        MPM_TRY(mpm_history_sync(run->history, error));
        MPM_TRY(mpm_probes_sync(run->probes, error));
    }
    return mpm_error_set(error, MPM_INTERRUPTED,
                         "interrupted by signal %d (%s) at step %" PRIu64 ", time %.9g%s", signal,
                         g_strsignal(signal), mpm_simulation_step(run->simulation),
                         mpm_simulation_time(run->simulation),
                         run->series != NULL ? "; --resume goes on from there" : "");
}

static enum mpm_status march(struct mpm_run *run, struct mpm_error *error)
{
    const char *const advice = mpm_simulation_advice(run->simulation);
    if (advice[0] != '\0')
        mpm_run_warn(run, advice);
    if (!run->options->resume) {
        MPM_TRY(write_results(run, true, true, error));
        MPM_TRY(mpm_observers_call(run->observers, true, error));
    }
    while (!is_finished(run)) {
        const int signal = run->options->interrupted != NULL ? run->options->interrupted() : 0;
        if (signal != 0)
            return interrupt(run, signal, error);
        const double start = mpm_run_seconds();
        const enum mpm_status status =
            mpm_simulation_advance(run->simulation, time_limit(run), error);
        run->record.seconds_step += mpm_run_seconds() - start;
        if (status != MPM_OK)
            return keep_last_good_state(run, status, error);
        const enum mpm_status written = write_due_results(run, error);
        if (written == MPM_RUN_FAILED)
            return keep_last_good_state(run, written, error);
        MPM_TRY(written);
        warn_of_growth(run);
        warn_of_tips(run);
        report_progress(run);
        const enum mpm_status kept = is_finished(run) ? MPM_OK : mpm_run_checkpoint_due(run, error);
        if (kept != MPM_OK)
            return add_state(run, kept, error);
    }
    return check_rest(run, error);
}

static enum mpm_status open_results(struct mpm_run *run, struct mpm_error *error)
{
    const char *folder = run->options->output;
    if (folder == NULL)
        return MPM_OK;
    MPM_TRY(mpm_results_folder_prepare(folder, run->options->overwrite, &run->lock, error));
    MPM_TRY(mpm_series_create(folder, run->scene, mpm_simulation_particle_count(run->simulation),
                              &run->series, error));
    MPM_TRY(mpm_probes_create(folder, run->scene, &run->probes, error));
    return mpm_history_create(folder, run->scene, &run->history, error);
}

static enum mpm_status start(struct mpm_run *run, struct mpm_error *error)
{
    MPM_TRY(mpm_simulation_create(run->scene, &run->options->simulation, &run->simulation, error));
    return open_results(run, error);
}

/* The folder of a run to go on with: there is no other writer while its checkpoint is read. */
static enum mpm_status go_on(struct mpm_run *run, struct mpm_error *error)
{
    const char *const folder = run->options->output;
    const enum mpm_path kind = mpm_path_kind(folder);
    if (kind == MPM_PATH_UNKNOWN)
        return mpm_file_unread(folder, errno, NULL, error);
    if (kind != MPM_PATH_FOLDER)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "--resume: there is no checkpoint in '%s': there is no such folder",
                             folder);
    MPM_TRY(mpm_results_folder_lock(folder, &run->lock, error));
    return mpm_run_resume(run, error);
}

static enum mpm_status set_up(struct mpm_run *run, struct mpm_error *error)
{
    const double begin = mpm_run_seconds();
    const bool resume = run->options->resume;
    if (!resume && run->options->output != NULL)
        MPM_TRY(mpm_results_folder_check(run->options->output, run->options->overwrite, error));
    MPM_TRY(resume ? go_on(run, error) : start(run, error));
    MPM_TRY(mpm_observers_create(run->options->observers, run->options->observer_count, run->scene,
                                 run->simulation, &run->observers, error));
    run->checkpoint_time = mpm_run_seconds();
    run->record.seconds_setup += run->checkpoint_time - begin;
    return MPM_OK;
}

/* Written however the run ended; a failure to do so counts only if all else went well. */
static enum mpm_status write_record(struct mpm_run *run, enum mpm_status status,
                                    struct mpm_error *error)
{
    if (run->series == NULL)
        return status;
    struct mpm_run_record *record = &run->record;
    record->simulation = run->simulation;
    record->status = status;
    record->cause = status == MPM_OK ? MPM_CAUSE_NONE : error->cause;
    record->signal = status == MPM_INTERRUPTED ? record->signal : 0;
    record->reason = status != MPM_OK ? error->message : end_reason(run);
    record->growth_warning = run->growth_warning;
    record->parted_warning = run->parted_warning;
    record->melted_warning = run->melted_warning;
    record->older_warning = run->older_warning;
    record->build_warning = run->build_warning;
    record->scene_path = run->options->scene_path;
    record->output_bytes = mpm_series_bytes(run->series);
    struct mpm_error second = {.status = MPM_OK};
    if (mpm_run_record_write(run->options->output, run->scene, record, &second) == MPM_OK ||
        status != MPM_OK)
        return status;
    *error = second;
    return add_state(run, second.status, error);
}

enum mpm_status mpm_scene_run(const struct mpm_scene *scene, const struct mpm_run_options *options,
                              struct mpm_error *error)
{
    struct mpm_error failure = {.status = MPM_OK};
    struct mpm_run run = {.scene = scene, .options = options, .lock = {.file = -1}};
    run.tip_told = g_new0(bool, mpm_scene_j_integral_count(scene) + 1);
    enum mpm_status status = set_up(&run, &failure);
    if (status == MPM_OK)
        status = write_record(&run, march(&run, &failure), &failure);
    g_free(run.tip_told);
    mpm_observers_free(run.observers);
    mpm_history_free(run.history);
    mpm_probes_free(run.probes);
    mpm_series_free(run.series);
    mpm_simulation_free(run.simulation);
    mpm_results_folder_unlock(&run.lock);
    if (error != NULL && status != MPM_OK)
        *error = failure;
    return status;
}

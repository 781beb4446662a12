/* A run of the suite on this machine.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/run.h"

#include "verification/common/machine.h"
#include "verification/suite/interruption.h"
#include "verification/suite/schedule.h"
#include "verification/suite/session.h"

#include <glib.h>

static void show_progress(void *context, size_t done, size_t total)
{
    const struct session *session = context;
    console_progress(session->console, done, total);
}

static enum mpm_status keep(void *context, size_t job, const struct job_result *result,
                            struct mpm_error *error)
{
    const struct session *session = context;
    struct mpm_error cause;
    enum mpm_status status = MPM_OK;
    console_finished(session->console, job, result);
    if (kept_is_result(result))
        status = kept_write(&session->place, session->keys[job], &session->plan.jobs[job], result,
                            &cause);
    return status == MPM_OK ? MPM_OK
                            : failure_set(error, status,
                                          "%s; programs that had ended before are kept, and "
                                          "mpm-verify run --resume goes on",
                                          cause.message);
}

static enum mpm_status run_programs(struct session *session, struct record_counts *counts,
                                    int *signal_number, struct mpm_error *error)
{
    const struct run_options *options = session->options;
    const unsigned places = MIN(options->jobs, (unsigned)session->plan.job_count);
    const struct schedule_options schedule = {
        .output = session->output.stage,
        .jobs = places,
        .simulation = {.threads = (int)MAX(1, machine_processor_count() / places),
                       .kernels = options->kernels},
        .progress = show_progress,
        .finished = keep,
        .context = session,
    };
    struct interruption interruption;
    console_begin(session->console, &session->plan);
    session_expect_costs(session);
    TRY(session_take_kept(session, error));
    console_start(session->console);
    interruption_await(&interruption);
    const enum mpm_status status = schedule_run(&session->plan, &schedule, session->results, error);
    *signal_number = interruption_received();
    interruption_forget(&interruption); /* a signal from now on ends the process */
    if (status == MPM_INTERRUPTED)
        return session_report_interrupted(session, counts, error);
    TRY(status);
    return session_report(session, counts, error);
}

enum mpm_status suite_run(const struct run_options *options, struct program_table programs,
                          struct console *console, struct record_counts *counts, int *signal_number,
                          struct mpm_error *error)
{
    struct session session;
    *counts = (struct record_counts){.total = 0};
    *signal_number = 0;
    TRY(session_open(options, programs, console, &session, error));
    enum mpm_status status = session_take_folder(&session, error);
    if (status == MPM_OK)
        status = output_stage(&session.output, &session.plan, error);
    if (status == MPM_OK)
        status = run_programs(&session, counts, signal_number, error);
    session_close(&session);
    return status;
}

/* The report of a session.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/session.h"

#include "verification/report/report_stored.h"
#include "verification/suite/records_make.h"
#include "verification/suite/unchecked.h"

static double seconds_of(const struct session *session)
{
    return (double)(g_get_monotonic_time() - session->start) * 1e-6;
}

static void say_unchecked(const struct session *session, const struct records *records)
{
    GPtrArray *const quantities =
        unchecked_quantities(session->catalogue, &session->plan, records->measurements);
    console_unchecked(session->console, quantities);
    g_ptr_array_unref(quantities);
}

/* ----------------------------------------------------------------------- report */

static struct records make_records(const struct session *session)
{
    const struct run_options *options = session->options;
    const json_t *resumed = options->resumed;
    GDateTime *now = g_date_time_new_now_utc();
    GDateTime *start = g_date_time_add_seconds(now, -seconds_of(session));
    char *started = g_date_time_format(start, "%Y-%m-%dT%H:%M:%SZ");
    const struct record_context context = {
        .output = session->output.stage,
        .command = resumed == NULL ? options->command : record_text(resumed, "command"),
        .selection = &options->selection,
        .kernels = options->kernels,
        .jobs = options->jobs,
        .started = resumed == NULL ? started : record_text(resumed, "started"),
        .seconds = seconds_of(session) + (resumed == NULL ? 0 : record_number(resumed, "seconds")),
        .incomplete = session->incomplete,
    };
    const struct records records = records_make(&session->plan, session->results, &context);
    g_free(started);
    g_date_time_unref(start);
    g_date_time_unref(now);
    return records;
}

static enum mpm_status write_report(const struct session *session, const struct records *records,
                                    struct mpm_error *error)
{
    const struct run_options *options = session->options;
    const struct report_additions additions = {.baseline = options->texts.baseline,
                                               .api = options->texts.api};
    TRY(records_write(session->output.stage, records, error));
    TRY(report_store(session->output.stage, &additions, error));
    TRY(run_state_add_seconds(&session->output, seconds_of(session), error));
    return output_report(&session->output,
                         &(struct report_sources){.reports = options->reports,
                                                  .catalogue = options->texts.catalogue},
                         error);
}

enum mpm_status session_report(const struct session *session, struct record_counts *counts,
                               struct mpm_error *error)
{
    struct records records = make_records(session);
    *counts = records_count(&records, NULL, NULL);
    const enum mpm_status status = write_report(session, &records, error);
    say_unchecked(session, &records);
    /* printed on any outcome: the counts are known even if they could not be written */
    console_end(session->console, &records, status == MPM_OK ? session->options->output : NULL);
    records_clear(&records);
    return status;
}

/* Has any program ended? Else an earlier report is worth more than one without results. */
static bool has_results(const struct session *session)
{
    for (size_t i = 0; i < session->plan.job_count; i++)
        if (session->results[i].outcome != JOB_NOT_RUN)
            return true;
    return false;
}

/* The report of what there is; what went wrong with it is worth more than the signal. */
enum mpm_status session_report_interrupted(struct session *session, struct record_counts *counts,
                                           struct mpm_error *error)
{
    char *reason = g_strdup(error->message);
    session->incomplete = reason;
    enum mpm_status status = MPM_INTERRUPTED;
    const enum mpm_status reported =
        has_results(session) ? session_report(session, counts, error) : MPM_OK;
    if (reported == MPM_OK)
        failure_set(error, MPM_INTERRUPTED, "%s; mpm-verify run --resume goes on", reason);
    else
        status = reported;
    session->incomplete = NULL;
    g_free(reason);
    return status;
}

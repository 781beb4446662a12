/* A run of the suite.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/run.h"

#include "verification/common/machine.h"
#include "verification/report/report.h"
#include "verification/report/report_stored.h"
#include "verification/suite/output_folder.h"
#include "verification/suite/records_make.h"
#include "verification/suite/schedule.h"
#include "verification/suite/unchecked.h"

#include <glib.h>

static char *now(void)
{
    GDateTime *time = g_date_time_new_now_utc();
    char *text = g_date_time_format(time, "%Y-%m-%dT%H:%M:%SZ");
    g_date_time_unref(time);
    return text;
}

/* Said before anything runs: the run is to be compared with another one's results. */
static enum mpm_status check_baseline(const struct run_options *options, struct mpm_error *error)
{
    struct records baseline;
    if (options->baseline == NULL)
        return MPM_OK;
    char *one = g_canonicalize_filename(options->baseline, NULL);
    char *other = g_canonicalize_filename(options->output, NULL);
    const bool same = g_strcmp0(one, other) == 0;
    g_free(one);
    g_free(other);
    if (same)
        return failure_set(error, MPM_BAD_INPUT,
                           "--baseline %s: is the output folder, whose results this run replaces",
                           options->baseline);
    TRY(records_read(options->baseline, &baseline, error));
    records_clear(&baseline);
    return MPM_OK;
}

static void say_unchecked(struct console *console, const struct catalogue *catalogue,
                          const struct plan *plan, const struct records *records)
{
    GPtrArray *const quantities = unchecked_quantities(catalogue, plan, records->measurements);
    console_unchecked(console, quantities);
    g_ptr_array_unref(quantities);
}

/* What the jobs left, when they started and how long they took. */
struct outcome {
    const struct job_result *results;
    const char *started;
    double seconds;
};

/* Records and reports it. */
static enum mpm_status conclude(const struct run_options *options,
                                const struct catalogue *catalogue, const struct plan *plan,
                                const struct outcome *outcome, struct console *console,
                                struct record_counts *counts, struct mpm_error *error)
{
    const struct record_context context = {
        .output = options->output,
        .command = options->command,
        .selection = &options->selection,
        .kernels = options->kernels,
        .jobs = options->jobs,
        .started = outcome->started,
        .seconds = outcome->seconds,
    };
    struct records records = records_make(plan, outcome->results, &context);
    *counts = records_count(&records, NULL, NULL);
    enum mpm_status status = records_write(options->output, &records, error);
    const struct report_additions additions = {.baseline = options->baseline};
    if (status == MPM_OK)
        status = report_store(options->output, &additions, error);
    if (status == MPM_OK)
        status = report_render(
            options->output,
            &(struct report_sources){.reports = options->reports, .catalogue = options->catalogue},
            error);
    say_unchecked(console, catalogue, plan, &records);
    /* printed on any outcome: the counts are known even if they could not be written */
    console_end(console, &records, status == MPM_OK ? options->output : NULL);
    records_clear(&records);
    return status;
}

static enum mpm_status run_plan(const struct run_options *options,
                                const struct catalogue *catalogue, const struct plan *plan,
                                struct console *console, struct record_counts *counts,
                                struct mpm_error *error)
{
    const unsigned places = MIN(options->jobs, (unsigned)plan->job_count);
    const struct schedule_options schedule = {
        .output = options->output,
        .jobs = places,
        .simulation = {.threads = (int)MAX(1, machine_processor_count() / places),
                       .kernels = options->kernels},
        .progress = console_progress,
        .finished = console_finished,
        .context = console,
    };
    struct job_result *results = g_new0(struct job_result, plan->job_count);
    char *started = now();
    const gint64 start = g_get_monotonic_time();
    console_begin(console, plan);
    enum mpm_status status = schedule_run(plan, &schedule, results, error);
    const struct outcome outcome = {
        .results = results,
        .started = started,
        .seconds = (double)(g_get_monotonic_time() - start) * 1e-6,
    };
    if (status == MPM_OK)
        status = conclude(options, catalogue, plan, &outcome, console, counts, error);
    schedule_clear(results, plan->job_count);
    g_free(results);
    g_free(started);
    return status;
}

enum mpm_status suite_run(const struct run_options *options, struct program_table programs,
                          struct console *console, struct record_counts *counts,
                          struct mpm_error *error)
{
    struct catalogue *catalogue;
    struct plan plan;
    *counts = (struct record_counts){.total = 0};
    TRY(check_baseline(options, error));
    TRY(catalogue_read(options->catalogue, programs, &catalogue, error));
    enum mpm_status status = plan_make(catalogue, &options->selection, &plan, error);
    int lock = -1;
    if (status == MPM_OK) {
        status = plan_check_methods(&plan, error);
        if (status == MPM_OK)
            status = output_prepare(options->output, &plan, &lock, error);
        if (status == MPM_OK)
            status = run_plan(options, catalogue, &plan, console, counts, error);
        output_release(lock);
        plan_clear(&plan);
    }
    catalogue_free(catalogue);
    return status;
}

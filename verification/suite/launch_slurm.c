/* A run on Slurm: submits, waits, collects.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/launch_slurm.h"

#include "verification/suite/campaign.h"
#include "verification/suite/interruption.h"
#include "verification/suite/slurm.h"

#include <math.h>

enum { ROUNDS = 3, POLL_SECONDS = 2, POLLS_PER_SECOND = 10 };

/* ------------------------------------------------------------------------ costs */

/* Twice what was measured, in classes: an array asks the same for all of its tasks. */
static const double measured_times = 2, start_seconds = 60;
static const double class_minutes = 5, class_mebibytes = 128, class_factor = 4;

static double class_of(double need, double least)
{
    double found = least;
    while (found < need)
        found *= class_factor;
    return found;
}

/* measurements.jsonl of a report by case, quantity, variant; NULL if there is none. */
static GHashTable *index_costs(struct records *records)
{
    return records->measurements == NULL ? NULL : record_index(records->measurements, "quantity");
}

static double cost_of(GHashTable *costs, const struct planned_job *job, const char *quantity)
{
    char *key = g_strjoin("/", job->entry->file->name, quantity, job->variant->name, NULL);
    const json_t *line = costs == NULL ? NULL : g_hash_table_lookup(costs, key);
    const double value = line == NULL ? (double)NAN : record_number(line, "value");
    g_free(key);
    return value;
}

static struct slurm_task task_of(const struct planned_job *job, GHashTable *costs)
{
    const double mebibyte = 1048576;
    const double seconds = cost_of(costs, job, "seconds"),
                 bytes = cost_of(costs, job, "peak_bytes");
    const double longest = job->variant->timeout + start_seconds;
    const double need =
        isfinite(seconds) ? fmin(measured_times * seconds + start_seconds, longest) : longest;
    return (struct slurm_task){
        .name = campaign_task_name(job),
        .minutes = class_of(need / 60, class_minutes),
        .mebibytes =
            isfinite(bytes) ? class_of(measured_times * bytes / mebibyte, class_mebibytes) : 0,
    };
}

static void clear_task(void *element)
{
    struct slurm_task *task = element;
    g_free(task->name);
}

static int compare_tasks(const void *one, const void *other)
{
    const struct slurm_task *a = one, *b = other;
    const int by_time = (a->minutes > b->minutes) - (a->minutes < b->minutes);
    const int by_memory = (a->mebibytes > b->mebibytes) - (a->mebibytes < b->mebibytes);
    return by_time != 0 ? by_time : by_memory;
}

/* What has no result and is not in the queue. */
static GArray *missing_tasks(const struct session *session, GHashTable *queue, GHashTable *costs)
{
    GArray *tasks = g_array_new(FALSE, FALSE, sizeof(struct slurm_task));
    g_array_set_clear_func(tasks, clear_task);
    for (size_t i = 0; i < session->plan.job_count; i++) {
        struct slurm_task task = task_of(&session->plan.jobs[i], costs);
        if (session_has(session, i) || (queue != NULL && g_hash_table_contains(queue, task.name)))
            g_free(task.name);
        else
            g_array_append_val(tasks, task);
    }
    g_array_sort(tasks, compare_tasks);
    return tasks;
}

/* ------------------------------------------------------------------------- wait */

static size_t count_results(const struct session *session)
{
    size_t count = 0;
    for (size_t i = 0; i < session->plan.job_count; i++)
        count += session_has(session, i) ? 1 : 0;
    return count;
}

static void pause_a_poll(void)
{
    for (int i = 0; i < POLL_SECONDS * POLLS_PER_SECOND && interruption_received() == 0; i++)
        g_usleep(G_USEC_PER_SEC / POLLS_PER_SECOND);
}

/* Until all results are there or nothing is in the queue. Slurm that does not answer is waited for,
 * as its controller is when it is started again. */
static enum mpm_status wait_for_tasks(const struct session *session, struct mpm_error *error)
{
    bool silent = false;
    for (;;) {
        GHashTable *queue = NULL;
        struct mpm_error cause;
        const enum mpm_status asked = slurm_queue(&session->output, &queue, &cause);
        const bool idle = asked == MPM_OK && (queue == NULL || g_hash_table_size(queue) == 0);
        const size_t done = count_results(session);
        if (queue != NULL)
            g_hash_table_unref(queue);
        if (asked != MPM_OK && !silent)
            console_say(session->console, "Slurm does not answer (%s): waiting", cause.message);
        silent = asked != MPM_OK;
        console_progress(session->console, done, session->plan.job_count);
        if (idle || done == session->plan.job_count)
            return MPM_OK;
        if (interruption_received() != 0)
            break;
        pause_a_poll();
    }
    char *jobs = slurm_jobs(&session->output);
    const enum mpm_status status =
        failure_set(error, MPM_INTERRUPTED,
                    "interrupted by signal %d: the programs go on in Slurm (scancel %s ends them); "
                    "mpm-verify run "
                    "--launcher slurm --resume waits for them and makes the report",
                    interruption_received(), jobs);
    g_free(jobs);
    return status;
}

/* ----------------------------------------------------------------------- rounds */

static enum mpm_status submit_missing(const struct session *session, const char *program,
                                      GHashTable *costs, unsigned *submitted,
                                      struct mpm_error *error)
{
    GHashTable *queue = NULL;
    TRY(slurm_queue(&session->output, &queue, error));
    GArray *tasks = missing_tasks(session, queue, costs);
    *submitted = tasks->len;
    enum mpm_status status = MPM_OK;
    if (tasks->len > 0)
        status = slurm_submit(&session->output, program, tasks, error);
    if (status == MPM_OK && tasks->len > 0)
        console_say(session->console, "%u programs submitted to Slurm", tasks->len);
    g_array_unref(tasks);
    if (queue != NULL)
        g_hash_table_unref(queue);
    return status;
}

static enum mpm_status run_rounds(const struct session *session, const char *program,
                                  const char *costs_folder, struct mpm_error *error)
{
    struct records records = {.run = NULL};
    const bool known = records_read(costs_folder, &records, NULL) == MPM_OK;
    GHashTable *costs = known ? index_costs(&records) : NULL;
    enum mpm_status status = MPM_OK;
    for (int round = 0; status == MPM_OK && round < ROUNDS; round++) {
        unsigned submitted = 0;
        /* what was measured may have been too little: the time-out is what a case may take */
        status = submit_missing(session, program, round == 0 ? costs : NULL, &submitted, error);
        if (status == MPM_OK)
            status = wait_for_tasks(session, error);
        if (count_results(session) == session->plan.job_count)
            break;
    }
    if (costs != NULL)
        g_hash_table_unref(costs);
    if (known)
        records_clear(&records);
    return status;
}

enum mpm_status launch_slurm(const struct run_options *options, struct program_table programs,
                             const char *program, const char *costs, struct console *console,
                             struct record_counts *counts, int *signal_number,
                             struct mpm_error *error)
{
    struct session session;
    struct interruption interruption;
    *counts = (struct record_counts){.total = 0};
    TRY(session_open(options, programs, console, &session, error));
    enum mpm_status status = session_take_folder(&session, error);
    if (status == MPM_OK) {
        interruption_await(&interruption);
        status = run_rounds(&session, program, costs == NULL ? options->output : costs, error);
        *signal_number = interruption_received();
        interruption_forget(&interruption);
    }
    if (status == MPM_OK)
        status = campaign_report(&session, counts, error);
    session_close(&session);
    return status;
}

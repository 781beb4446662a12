/* The programs of a run as tasks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/campaign.h"

#include "mpm_file.h"
#include "verification/common/folders.h"
#include "verification/common/rows.h"
#include "verification/suite/interruption.h"
#include "verification/suite/schedule.h"
#include "verification/suite/slurm.h"

#include <string.h>
#include <unistd.h>

char *campaign_task_name(const struct planned_job *job)
{
    return g_strconcat(job->entry->file->name, "/", job->variant->name, NULL);
}

/* ------------------------------------------------------------------------ tasks */

enum mpm_status campaign_tasks(const struct run_options *options, struct program_table programs,
                               const char *program, FILE *out, struct mpm_error *error)
{
    struct session session;
    TRY(session_open(options, programs, NULL, &session, error));
    const enum mpm_status status = session_take_folder(&session, error);
    char *folder = g_canonicalize_filename(options->output, NULL);
    char *quoted_folder = g_shell_quote(folder), *quoted_program = g_shell_quote(program);
    for (size_t i = 0; status == MPM_OK && i < session.plan.job_count; i++) {
        if (session_has(&session, i))
            continue;
        char *name = campaign_task_name(&session.plan.jobs[i]);
        fprintf(out, "%s task %s %s\n", quoted_program, quoted_folder, name);
        g_free(name);
    }
    g_free(quoted_program);
    g_free(quoted_folder);
    g_free(folder);
    session_close(&session);
    return status;
}

/* ------------------------------------------------------------------------- task */

/* The place of CASE/VARIANT in the plan. */
static enum mpm_status find_task(const struct session *session, const char *task, size_t *found,
                                 struct mpm_error *error)
{
    for (size_t i = 0; i < session->plan.job_count; i++) {
        char *name = campaign_task_name(&session->plan.jobs[i]);
        const bool same = strcmp(name, task) == 0;
        g_free(name);
        *found = i;
        if (same)
            return MPM_OK;
    }
    return failure_set(error, MPM_BAD_INPUT,
                       "\"%s\": the run in %s has no such task; allowed are the CASE/VARIANT that "
                       "mpm-verify tasks prints",
                       task, session->options->output);
}

/* A folder of this process's own for the files of the program. */
static char *work_folder(const struct session *session, size_t job)
{
    char *name =
        g_strdup_printf("%s.%s.%ld", session->keys[job], g_get_host_name(), (long)getpid());
    char *path = g_build_filename(session->output.state, "work", name, NULL);
    g_free(name);
    return path;
}

static enum mpm_status keep_result(const struct session *session, size_t job, const char *work,
                                   const struct job_result *result, struct mpm_error *error)
{
    const struct planned_job *planned = &session->plan.jobs[job];
    const struct kept_place place = {session->output.results, work};
    if (kept_is_result(result))
        return kept_write(&place, session->keys[job], planned, result, error);
    return failure_set(error, MPM_ENVIRONMENT_FAILED,
                       "%s/%s has no result: the program %s %d, which is not its own doing",
                       planned->entry->file->name, planned->variant->name,
                       result->outcome == JOB_CRASHED ? "was ended by signal"
                                                      : "ended with exit status",
                       result->code);
}

static enum mpm_status run_in(const struct session *session, size_t job, const char *work,
                              int *signal_number, struct mpm_error *error)
{
    struct planned_job *planned = &session->plan.jobs[job];
    const struct plan alone = {.jobs = planned, .job_count = 1};
    const struct schedule_options schedule = {
        .output = work,
        .jobs = 1,
        .simulation = {.threads = 1, .kernels = session->options->kernels},
    };
    struct job_result result = {.rows = NULL};
    struct interruption interruption;
    char *folder = g_build_filename(work, "cases", planned->entry->file->name, NULL);
    enum mpm_status status = folder_make(folder, error);
    if (status == MPM_OK) {
        interruption_await(&interruption);
        status = schedule_run(&alone, &schedule, &result, error);
        *signal_number = interruption_received();
        interruption_forget(&interruption);
    }
    if (status == MPM_OK)
        status = keep_result(session, job, work, &result, error);
    schedule_clear(&result, 1);
    g_free(folder);
    return status;
}

static enum mpm_status run_task(const struct session *session, const char *task, int *signal_number,
                                struct mpm_error *error)
{
    size_t job = 0;
    TRY(find_task(session, task, &job, error));
    if (session_has(session, job))
        return MPM_OK;
    char *work = work_folder(session, job);
    const enum mpm_status status = run_in(session, job, work, signal_number, error);
    (void)folder_remove(work, NULL); /* what is left is removed with the run */
    g_free(work);
    return status;
}

enum mpm_status campaign_task(const struct run_options *options, struct program_table programs,
                              const char *task, int *signal_number, struct mpm_error *error)
{
    struct session session;
    *signal_number = 0;
    TRY(session_open(options, programs, NULL, &session, error));
    const enum mpm_status status = run_task(&session, task, signal_number, error);
    session_close(&session);
    return status;
}

/* ---------------------------------------------------------------------- collect */

/* Programs without a result are not run; how many they are. */
static size_t give_up_missing(struct session *session)
{
    size_t missing = 0;
    for (size_t i = 0; i < session->plan.job_count; i++) {
        struct job_result *result = &session->results[i];
        if (result->rows != NULL)
            continue;
        *result = (struct job_result){.outcome = JOB_NOT_RUN,
                                      .timeout = session->plan.jobs[i].variant->timeout,
                                      .rows = row_line(ROW_FAILURE, "", "it has left no result")};
        missing++;
    }
    return missing;
}

enum mpm_status campaign_report(struct session *session, struct record_counts *counts,
                                struct mpm_error *error)
{
    TRY(output_stage(&session->output, &session->plan, error));
    console_begin(session->console, &session->plan);
    TRY(session_take_kept(session, error));
    const size_t missing = give_up_missing(session);
    char *reason = g_strdup_printf("collected when %zu of %zu programs had left no result", missing,
                                   session->plan.job_count);
    session->incomplete = missing > 0 ? reason : NULL;
    const enum mpm_status status = session_report(session, counts, error);
    session->incomplete = NULL;
    g_free(reason);
    return status;
}

enum mpm_status campaign_collect(const struct run_options *options, struct program_table programs,
                                 struct console *console, struct record_counts *counts,
                                 struct mpm_error *error)
{
    struct session session;
    *counts = (struct record_counts){.total = 0};
    TRY(session_open(options, programs, console, &session, error));
    enum mpm_status status = session_take_folder(&session, error);
    if (status == MPM_OK)
        status = campaign_report(&session, counts, error);
    session_close(&session);
    return status;
}

/* ----------------------------------------------------------------------- status */

enum task_state { TASK_DONE, TASK_FAILED, TASK_RUNNING, TASK_WAITING, TASK_MISSING, TASK_STATES };
static const char *const state_names[TASK_STATES] = {"done", "failed", "running", "waiting",
                                                     "missing"};

/* Has a task left, or is it at work in, a folder of its own? */
static bool has_work_folder(const struct session *session, size_t job)
{
    char *folder = g_build_filename(session->output.state, "work", NULL);
    GPtrArray *names;
    (void)folder_names(folder, &names, NULL); /* one that cannot be read shows no work */
    bool found = false;
    for (unsigned i = 0; names != NULL && i < names->len; i++)
        found = found || g_str_has_prefix(names->pdata[i], session->keys[job]);
    if (names != NULL)
        g_ptr_array_unref(names);
    g_free(folder);
    return found;
}

/* Has a run on this machine begun it? */
static bool has_rows(const struct session *session, size_t job)
{
    char *path = schedule_path(session->output.stage, &session->plan.jobs[job], "rows", ".jsonl");
    const bool there = mpm_path_exists(path);
    g_free(path);
    return there;
}

static enum task_state state_of(const struct session *session, size_t job, GHashTable *queue)
{
    const struct kept_place nowhere = {session->output.results, NULL};
    struct job_result result = {.rows = NULL};
    enum kept_state kept;
    char *name = campaign_task_name(&session->plan.jobs[job]);
    const char *queued = queue == NULL ? NULL : g_hash_table_lookup(queue, name);
    enum task_state state = TASK_MISSING;
    (void)kept_read(&nowhere, session->keys[job], &session->plan.jobs[job], &result, &kept, NULL);
    if (kept == KEPT_SOUND)
        state = result.outcome == JOB_RETURNED && result.code == 0 ? TASK_DONE : TASK_FAILED;
    else if (queued != NULL)
        state = strcmp(queued, "RUNNING") == 0 ? TASK_RUNNING : TASK_WAITING;
    else if (queue == NULL && (has_rows(session, job) || has_work_folder(session, job)))
        state = TASK_RUNNING;
    g_free(result.rows);
    g_free(name);
    return state;
}

static void print_status(const struct session *session, GHashTable *queue, FILE *out)
{
    size_t counts[TASK_STATES] = {0};
    for (size_t i = 0; i < session->plan.job_count; i++) {
        const enum task_state state = state_of(session, i, queue);
        char *name = campaign_task_name(&session->plan.jobs[i]);
        if (state != TASK_DONE)
            fprintf(out, "%-8s %s\n", state_names[state], name);
        counts[state]++;
        g_free(name);
    }
    for (int state = 0; state < TASK_STATES; state++)
        fprintf(out, "%s%zu %s", state == 0 ? "" : ", ", counts[state], state_names[state]);
    fputc('\n', out);
}

enum mpm_status campaign_status(const struct run_options *options, struct program_table programs,
                                FILE *out, struct mpm_error *error)
{
    struct session session;
    GHashTable *queue = NULL;
    TRY(session_open(options, programs, NULL, &session, error));
    const enum mpm_status status = slurm_queue(&session.output, &queue, error);
    if (status == MPM_OK)
        print_status(&session, queue, out);
    if (queue != NULL)
        g_hash_table_unref(queue);
    session_close(&session);
    return status;
}

/* The scheduler.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/schedule.h"

#include "mpm_file.h"
#include "verification/common/input.h"
#include "verification/common/rows.h"
#include "verification/suite/interruption.h"
#include "verification/suite/measurement.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

/* ------------------------------------------------------------------- a child */

char *schedule_path(const char *output, const struct planned_job *job, const char *prefix,
                    const char *suffix)
{
    char *name = g_strconcat(prefix, "-", job->variant->name, suffix, NULL);
    char *path = g_build_filename(output, "cases", job->entry->file->name, name, NULL);
    g_free(name);
    return path;
}

/* The files of its rows and its log, open; or false with a reason, to be freed. */
static bool create_files(const char *output, const struct planned_job *job, int files[2],
                         char **reason)
{
    char *paths[2] = {schedule_path(output, job, "rows", ".jsonl"),
                      schedule_path(output, job, "log", ".txt")};
    files[1] = -1;
    for (int i = 0; i < 2 && (i == 0 || files[0] >= 0); i++) {
        files[i] = mpm_file_open(paths[i], O_CREAT | O_TRUNC | O_WRONLY);
        if (files[i] < 0)
            *reason = g_strdup_printf("%s: cannot be created: %s", paths[i], g_strerror(errno));
    }
    g_free(paths[0]);
    g_free(paths[1]);
    return files[1] >= 0;
}

/* It ends with its parent, however that ends: two runs must never write the same files. */
static void child_detach(int log, pid_t parent)
{
    setpgid(0, 0);
    interruption_default();
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (getppid() != parent)
        _exit(MPM_ENVIRONMENT_FAILED);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    close(nothing);
}

static void child_run(const struct planned_job *job, const struct schedule_options *options,
                      int rows, int log, pid_t parent)
{
    child_detach(log, parent);
    char *folder = g_build_filename(options->output, "cases", job->entry->file->name, NULL);
    const struct measurement_setup setup = {.entry = job->entry,
                                            .variant = job->variant,
                                            .data_folder = folder,
                                            .simulation = options->simulation,
                                            .rows = rows,
                                            .unfinished = job->unfinished};
    struct mpm_error error = {.status = MPM_OK};
    const enum mpm_status status = measurement_run(&setup, &error);
    if (status != MPM_OK)
        fprintf(stderr, "%s\n", error.message);
    g_free(folder);
    fflush(NULL);
    _exit((int)status);
}

/* ----------------------------------------------------------------- the parent */

struct child {
    pid_t process; /* 0: a free place */
    size_t job;
    gint64 started; /* microseconds */
};

struct scheduler {
    const struct plan *plan;
    const struct schedule_options *options;
    struct job_result *results;
    struct child *children; /* options->jobs places */
    size_t next, done;
    enum mpm_status status; /* of the callers' `finished` */
    struct mpm_error *error;
};

static void finish(struct scheduler *scheduler, size_t job)
{
    scheduler->done++;
    if (scheduler->options->finished != NULL && scheduler->status == MPM_OK)
        scheduler->status = scheduler->options->finished(
            scheduler->options->context, job, &scheduler->results[job], scheduler->error);
}

static void start_failed(struct scheduler *scheduler, size_t job, char *reason)
{
    struct job_result *result = &scheduler->results[job];
    result->outcome = JOB_NOT_RUN;
    result->rows = row_line(ROW_FAILURE, "", reason);
    g_free(reason);
    finish(scheduler, job);
}

static void start(struct scheduler *scheduler, struct child *child)
{
    const size_t job = scheduler->next++;
    const struct planned_job *planned = &scheduler->plan->jobs[job];
    const char *output = scheduler->options->output;
    int files[2];
    char *reason = NULL;
    if (!create_files(output, planned, files, &reason)) {
        start_failed(scheduler, job, reason);
    } else {
        fflush(NULL); /* or the child would write our buffers a second time */
        const pid_t parent = getpid(), process = fork();
        if (process == 0)
            child_run(planned, scheduler->options, files[0], files[1], parent);
        if (process < 0)
            start_failed(scheduler, job,
                         g_strdup_printf("no process could be created: %s", g_strerror(errno)));
        else
            *child = (struct child){process, job, g_get_monotonic_time()};
        if (process > 0)
            setpgid(process, process); /* also here: whoever comes first */
    }
    for (int i = 0; i < 2; i++)
        if (files[i] >= 0)
            (void)mpm_file_close(files[i]);
}

static double seconds_since(gint64 start_time)
{
    return (double)(g_get_monotonic_time() - start_time) * 1e-6;
}

/* Rows that cannot be read are no result of the program. */
static void read_rows(const struct scheduler *scheduler, size_t job, struct job_result *result)
{
    char *path =
        schedule_path(scheduler->options->output, &scheduler->plan->jobs[job], "rows", ".jsonl");
    struct mpm_error error = {.status = MPM_OK};
    if (input_text(path, NULL, &result->rows, NULL, &error) != MPM_OK) {
        result->outcome = JOB_RETURNED;
        result->code = MPM_ENVIRONMENT_FAILED;
        result->rows = row_line(ROW_FAILURE, "", error.message);
    }
    g_free(path);
}

/* Kills what is left of the group before the leader's number can be used again. */
static void reap(struct scheduler *scheduler, struct child *child, bool timed_out)
{
    int state = 0;
    kill(-child->process, SIGKILL);
    while (waitpid(child->process, &state, 0) < 0 && errno == EINTR)
        ;
    struct job_result *result = &scheduler->results[child->job];
    result->seconds = seconds_since(child->started);
    if (timed_out) {
        result->outcome = JOB_TIMED_OUT;
    } else if (WIFSIGNALED(state)) {
        result->outcome = JOB_CRASHED;
        result->code = WTERMSIG(state);
    } else {
        result->outcome = JOB_RETURNED;
        result->code = WEXITSTATUS(state);
    }
    read_rows(scheduler, child->job, result);
    child->process = 0;
    finish(scheduler, child->job);
}

static bool has_ended(const struct child *child)
{
    siginfo_t information = {.si_pid = 0};
    const int flags = WEXITED | WNOHANG | WNOWAIT;
    return waitid(P_PID, (id_t)child->process, &information, flags) == 0 && information.si_pid != 0;
}

static void pass_over_known(struct scheduler *scheduler)
{
    while (scheduler->next < scheduler->plan->job_count &&
           scheduler->results[scheduler->next].rows != NULL)
        scheduler->next++;
}

static void attend(struct scheduler *scheduler, struct child *child)
{
    if (child->process == 0) {
        pass_over_known(scheduler);
        if (scheduler->next < scheduler->plan->job_count)
            start(scheduler, child);
    } else if (has_ended(child)) {
        reap(scheduler, child, false);
    } else if (seconds_since(child->started) > scheduler->results[child->job].timeout) {
        reap(scheduler, child, true);
    }
}

static void kill_all(struct scheduler *scheduler)
{
    for (unsigned i = 0; i < scheduler->options->jobs; i++)
        if (scheduler->children[i].process != 0) {
            kill(-scheduler->children[i].process, SIGKILL);
            while (waitpid(scheduler->children[i].process, NULL, 0) < 0 && errno == EINTR)
                ;
        }
}

/* What is left to say of a job that has not ended when the run does. */
static void give_up(struct scheduler *scheduler, const char *why)
{
    for (size_t i = 0; i < scheduler->plan->job_count; i++)
        if (scheduler->results[i].rows == NULL)
            scheduler->results[i].rows = row_line(ROW_FAILURE, "", why);
}

enum { POLL_MICROSECONDS = 5000, POLLS_PER_PROGRESS = 20 };

static void loop(struct scheduler *scheduler)
{
    for (unsigned round = 0; scheduler->done < scheduler->plan->job_count &&
                             scheduler->status == MPM_OK && interruption_received() == 0;
         round++) {
        const size_t before = scheduler->done;
        for (unsigned i = 0; i < scheduler->options->jobs; i++)
            attend(scheduler, &scheduler->children[i]);
        if (scheduler->options->progress != NULL &&
            (scheduler->done != before || round % POLLS_PER_PROGRESS == 0))
            scheduler->options->progress(scheduler->options->context, scheduler->done,
                                         scheduler->plan->job_count);
        if (scheduler->done == before)
            g_usleep(POLL_MICROSECONDS);
    }
}

static size_t prepare(const struct plan *plan, struct job_result *results)
{
    size_t known = 0;
    for (size_t i = 0; i < plan->job_count; i++)
        if (results[i].rows != NULL)
            known++;
        else
            results[i] = (struct job_result){.outcome = JOB_NOT_RUN,
                                             .timeout = plan->jobs[i].variant->timeout};
    return known;
}

enum mpm_status schedule_run(const struct plan *plan, const struct schedule_options *options,
                             struct job_result *results, struct mpm_error *error)
{
    struct scheduler scheduler = {
        .plan = plan,
        .options = options,
        .results = results,
        .children = g_new0(struct child, options->jobs),
        .done = prepare(plan, results),
        .status = MPM_OK,
        .error = error,
    };
    loop(&scheduler);
    kill_all(&scheduler);
    g_free(scheduler.children);
    const int signal_number = interruption_received();
    if (scheduler.status == MPM_OK && scheduler.done < plan->job_count && signal_number != 0)
        scheduler.status = failure_set(
            error, MPM_INTERRUPTED, "interrupted by signal %d (%s) after %zu of %zu programs",
            signal_number, g_strsignal(signal_number), scheduler.done, plan->job_count);
    if (scheduler.status != MPM_OK)
        give_up(&scheduler, error->message);
    return scheduler.status;
}

void schedule_clear(struct job_result *results, size_t count)
{
    for (size_t i = 0; i < count; i++)
        g_free(results[i].rows);
}

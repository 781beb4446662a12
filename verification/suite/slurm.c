/* Slurm's commands. What was submitted is in .run/slurm/: <job>.tasks has the tasks of a job array,
 * one a line: the task of array index N is line N.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/slurm.h"

#include "mpm_file.h"
#include "verification/common/folders.h"
#include "verification/common/output.h"

#include <glib.h>
#include <string.h>

enum { ARRAY_MOST = 1000 }; /* Slurm's MaxArraySize is 1001 unless set */

static char *slurm_folder(const struct output_folder *output)
{
    return g_build_filename(output->state, "slurm", NULL);
}

/* Runs a command of Slurm's; what it prints is *said (g_free). */
static enum mpm_status ask(char **command, char **said, struct mpm_error *error)
{
    char *complaint = NULL;
    GError *failure = NULL;
    int state = 0;
    enum mpm_status status = MPM_OK;
    *said = NULL;
    if (!g_spawn_sync(NULL, command, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL, said, &complaint,
                      &state, &failure))
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: %s", command[0], failure->message);
    else if (!g_spawn_check_wait_status(state, NULL))
        status =
            failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: %s", command[0], g_strstrip(complaint));
    g_clear_error(&failure);
    g_free(complaint);
    if (status != MPM_OK) {
        g_free(*said);
        *said = NULL;
    }
    return status;
}

/* ----------------------------------------------------------------------- submit */

/* The pattern of a file's name in which % is itself. */
static char *without_patterns(const char *path)
{
    char **parts = g_strsplit(path, "%", -1);
    char *text = g_strjoinv("%%", parts);
    g_strfreev(parts);
    return text;
}

/* The list of the array is named by the job, which the script knows when it runs. It is renamed
 * after sbatch has given the number, so the script may have to wait for it. */
static char *script_text(const struct output_folder *output, const char *program)
{
    char *folder = slurm_folder(output);
    char *whole = g_canonicalize_filename(folder, NULL);
    char *home = g_canonicalize_filename(output->folder, NULL);
    char *quoted = g_shell_quote(whole), *quoted_home = g_shell_quote(home);
    char *quoted_program = g_shell_quote(program);
    char *text =
        g_strdup_printf("#!/bin/sh\n"
                        "list=%s/$SLURM_ARRAY_JOB_ID.tasks\n"
                        "for second in 1 2 3 4 5 6 7 8 9; do\n"
                        "    [ -e \"$list\" ] || sleep 1\n"
                        "done\n"
                        "exec %s task %s \"$(sed -n \"${SLURM_ARRAY_TASK_ID}p\" \"$list\")\"\n",
                        quoted, quoted_program, quoted_home);
    g_free(quoted_program);
    g_free(quoted_home);
    g_free(quoted);
    g_free(home);
    g_free(whole);
    g_free(folder);
    return text;
}

static enum mpm_status submit_array(const struct output_folder *output, const GArray *tasks,
                                    unsigned first, unsigned count, struct mpm_error *error)
{
    const struct slurm_task *asks = &g_array_index(tasks, struct slurm_task, first);
    char *folder = slurm_folder(output), *plain = without_patterns(folder);
    char *script = g_build_filename(folder, "task.sh", NULL);
    char *array = g_strdup_printf("--array=1-%u", count);
    char *time = g_strdup_printf("--time=%.0f", asks->minutes);
    char *memory = g_strdup_printf("--mem=%.0fM", asks->mebibytes);
    char *log = g_strconcat("--output=", plain, "/%A_%a.txt", NULL);
    char *command[] = {"sbatch",
                       "--parsable",
                       "--requeue",
                       "--open-mode=append",
                       "--job-name=mpm-verify",
                       "--ntasks=1",
                       "--cpus-per-task=1",
                       array,
                       time,
                       log,
                       asks->mebibytes > 0 ? memory : script,
                       asks->mebibytes > 0 ? script : NULL,
                       NULL};
    char *said = NULL;
    enum mpm_status status = ask(command, &said, error);
    if (status == MPM_OK) {
        GString *names = g_string_new(NULL);
        said[strcspn(said, ";\n")] = '\0';
        for (unsigned i = 0; i < count; i++)
            g_string_append_printf(names, "%s\n",
                                   g_array_index(tasks, struct slurm_task, first + i).name);
        char *list = g_strconcat(said, ".tasks", NULL);
        status = output_write(folder, list, names->str, error);
        g_free(list);
        g_string_free(names, TRUE);
    }
    g_free(said);
    g_free(log);
    g_free(memory);
    g_free(time);
    g_free(array);
    g_free(script);
    g_free(plain);
    g_free(folder);
    return status;
}

static unsigned same_class(const GArray *tasks, unsigned first)
{
    const struct slurm_task *one = &g_array_index(tasks, struct slurm_task, first);
    unsigned count = 1;
    while (first + count < tasks->len && count < ARRAY_MOST) {
        const struct slurm_task *next = &g_array_index(tasks, struct slurm_task, first + count);
        if (next->minutes < one->minutes || next->minutes > one->minutes ||
            next->mebibytes < one->mebibytes || next->mebibytes > one->mebibytes)
            break;
        count++;
    }
    return count;
}

enum mpm_status slurm_submit(const struct output_folder *output, const char *program,
                             const GArray *tasks, struct mpm_error *error)
{
    char *folder = slurm_folder(output), *text = script_text(output, program);
    enum mpm_status status = folder_make(folder, error);
    if (status == MPM_OK)
        status = output_write(folder, "task.sh", text, error);
    for (unsigned first = 0; status == MPM_OK && first < tasks->len;) {
        const unsigned count = same_class(tasks, first);
        status = submit_array(output, tasks, first, count, error);
        first += count;
    }
    g_free(text);
    g_free(folder);
    return status;
}

/* ------------------------------------------------------------------------ queue */

/* The numbers of the jobs that were submitted. */
static GPtrArray *jobs_of(const struct output_folder *output)
{
    char *folder = slurm_folder(output);
    GPtrArray *names;
    (void)folder_names(folder, &names, NULL); /* one that cannot be read has no jobs */
    GPtrArray *jobs = g_ptr_array_new_with_free_func(g_free);
    for (unsigned i = 0; names != NULL && i < names->len; i++)
        if (g_str_has_suffix(names->pdata[i], ".tasks"))
            g_ptr_array_add(jobs,
                            g_strndup(names->pdata[i], strlen(names->pdata[i]) - strlen(".tasks")));
    if (names != NULL)
        g_ptr_array_unref(names);
    g_free(folder);
    return jobs;
}

char *slurm_jobs(const struct output_folder *output)
{
    GPtrArray *jobs = jobs_of(output);
    g_ptr_array_add(jobs, NULL);
    char *text = g_strjoinv(" ", (char **)jobs->pdata);
    g_ptr_array_unref(jobs);
    return text;
}

static void add_job(const struct output_folder *output, const char *job, char *const *lines,
                    GHashTable *queue)
{
    char *folder = slurm_folder(output), *name = g_strconcat(job, ".tasks", NULL);
    char *path = g_build_filename(folder, name, NULL);
    char *text = mpm_file_load(path, NULL);
    if (text == NULL)
        text = g_strdup("");
    char **tasks = g_strsplit(text, "\n", -1);
    for (; *lines != NULL; lines++) {
        char **words = g_strsplit(*lines, " ", 3); /* job, index, state */
        const guint64 index = g_strv_length(words) == 3 ? g_ascii_strtoull(words[1], NULL, 10) : 0;
        if (index > 0 && index <= g_strv_length(tasks) && strcmp(words[0], job) == 0)
            g_hash_table_insert(queue, g_strdup(tasks[index - 1]), g_strdup(words[2]));
        g_strfreev(words);
    }
    g_strfreev(tasks);
    g_free(text);
    g_free(path);
    g_free(name);
    g_free(folder);
}

enum mpm_status slurm_queue(const struct output_folder *output, GHashTable **queue,
                            struct mpm_error *error)
{
    GPtrArray *jobs = jobs_of(output);
    char *user = g_strconcat("--user=", g_get_user_name(), NULL), *said = NULL;
    char *command[] = {"squeue", "--noheader", "--array", user, "--format=%F %K %T", NULL};
    enum mpm_status status = MPM_OK;
    *queue = NULL;
    if (jobs->len > 0)
        status = ask(command, &said, error);
    if (said != NULL) {
        char **lines = g_strsplit(said, "\n", -1);
        *queue = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free);
        for (unsigned i = 0; i < jobs->len; i++)
            add_job(output, jobs->pdata[i], lines, *queue);
        g_strfreev(lines);
    }
    g_free(said);
    g_free(user);
    g_ptr_array_unref(jobs);
    return status;
}

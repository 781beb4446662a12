/* A run of mpm-bench.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/cli/run.h"

#include "benchmarks/measuring/timing.h"
#include "benchmarks/report/report.h"
#include "verification/common/failure.h"
#include "verification/common/input.h"
#include "verification/common/machine.h"
#include "verification/common/resources.h"

#include "mpm_words.h"

#include <errno.h>
#include <glib.h>
#include <glib/gstdio.h>
#include <string.h>

/* ------------------------------------------------------------------- groups */

static bool is_chosen(const struct bench_run *run, const char *name)
{
    return run->groups == NULL || g_strv_contains((const char *const *)run->groups, name);
}

static enum mpm_status check_groups(const struct bench_run *run, struct mpm_error *error)
{
    size_t count;
    const struct bench_group *groups = bench_groups(&count);
    for (char *const *name = run->groups; name != NULL && *name != NULL; name++) {
        struct mpm_nearest nearest = {.word = *name};
        char hint[MPM_HINT_SIZE];
        size_t i = 0;
        for (; i < count && strcmp(*name, groups[i].name) != 0; i++)
            mpm_nearest_offer(&nearest, groups[i].name);
        if (i == count)
            return failure_set(error, MPM_BAD_INPUT,
                               "--group \"%s\": allowed are those of mpm-bench list%s", *name,
                               mpm_nearest_hint(&nearest, hint));
    }
    return MPM_OK;
}

static enum mpm_status run_groups(const struct bench_run *run, struct bench_context *context,
                                  struct mpm_error *error)
{
    size_t count;
    const struct bench_group *groups = bench_groups(&count);
    for (size_t i = 0; i < count; i++) {
        if (!is_chosen(run, groups[i].name))
            continue;
        bench_console_group(context->console, groups[i].title, groups[i].description);
        TRY(groups[i].run(context, error));
        TRY(bench_records_write(context->output, context->records, error));
    }
    return MPM_OK;
}

/* ------------------------------------------------------------------- folder */

/* But for what a run has left that never came to its first results. */
static bool is_empty(char **names)
{
    for (; names != NULL && *names != NULL; names++)
        if (strcmp(*names, BENCH_RECORDS_FILE MPM_PARTIAL_SUFFIX) != 0)
            return false;
    return true;
}

/* A folder is ours if it is empty or holds results of an earlier run. */
static enum mpm_status prepare(const char *folder, struct mpm_error *error)
{
    char *records = g_build_filename(folder, BENCH_RECORDS_FILE, NULL);
    enum mpm_path kind, kind_of_records = MPM_PATH_NONE;
    enum mpm_status status = input_kind(folder, &kind, error);
    if (status == MPM_OK)
        status = input_kind(records, &kind_of_records, error);
    g_free(records);
    TRY(status);
    if (kind != MPM_PATH_NONE && kind != MPM_PATH_FOLDER)
        return failure_set(error, MPM_BAD_INPUT, "--output %s: is a file; allowed: a folder",
                           folder);
    char **const names = mpm_folder_list(folder);
    if (names == NULL && errno != ENOENT)
        return mpm_file_unread(folder, errno, NULL, error);
    const bool empty = is_empty(names);
    mpm_folder_list_free(names);
    if (!empty && kind_of_records != MPM_PATH_FILE)
        return failure_set(error, MPM_BAD_INPUT,
                           "--output %s: holds something else; allowed: a new or empty folder, "
                           "or results of mpm-bench",
                           folder);
    if (mpm_folder_make(folder) != 0)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be made: %s", folder,
                           g_strerror(errno));
    return MPM_OK;
}

static char *usual_output(void)
{
    const bool repository = mpm_path_is_file("Makefile") && mpm_path_is_folder("benchmarks/scenes");
    return g_strdup(repository ? "build/reports/bench" : "bench-report");
}

/* Kernels or instructions that this machine or build does not have are bad input: found out
 * before anything is written. */
static enum mpm_status check_options(const struct bench_context *context, struct mpm_error *error)
{
    struct mpm_scene *scene = NULL;
    struct mpm_plan plan;
    char *path = bench_scene(context, "block.yaml");
    enum mpm_status status = mpm_scene_read(path, NULL, 0, &scene, error);
    if (status == MPM_OK)
        status = mpm_scene_plan(scene, &context->simulation, &plan, error);
    mpm_scene_free(scene);
    g_free(path);
    return status;
}

static enum mpm_status run_in(const struct bench_run *run, struct bench_context *context,
                              struct mpm_error *error)
{
    if (context->benchmarks == NULL || context->catalogue == NULL)
        return failure_set(error, MPM_ENVIRONMENT_FAILED,
                           "the scenes are found neither in benchmarks/ and "
                           "verification/catalogue/ nor beside the program");
    TRY(check_options(context, error));
    TRY(prepare(context->output, error));
    *context->records =
        bench_records_make(bench_tier_name(run->tier), run->command, BENCH_ROUNDS_MAX);
    bench_console_load(context->console, context->records);
    /* before the first group: a folder that cannot be written is found out now */
    enum mpm_status status = bench_records_write(context->output, context->records, error);
    if (status == MPM_OK)
        status = run_groups(run, context, error);
    if (status == MPM_OK)
        status = bench_report_write(context->output, error);
    bench_records_clear(context->records);
    return status;
}

enum mpm_status bench_run(const struct bench_run *run, struct bench_console *console,
                          struct mpm_error *error)
{
    TRY(check_groups(run, error));
    char *benchmarks = resources_benchmarks(run->executable);
    char *catalogue = resources_catalogue(run->executable);
    char *output = run->output == NULL ? usual_output() : g_strdup(run->output);
    struct bench_records records = {NULL, NULL};
    struct bench_context context = {
        .tier = run->tier,
        .simulation = run->simulation,
        .processors = machine_processor_count(),
        .executable = run->executable,
        .benchmarks = benchmarks,
        .catalogue = catalogue,
        .output = output,
        .records = &records,
        .console = console,
    };
    const enum mpm_status status = run_in(run, &context, error);
    if (status == MPM_OK)
        bench_console_end(console, output);
    g_free(benchmarks);
    g_free(catalogue);
    g_free(output);
    return status;
}

/* mpm-verify study: a study becomes a catalogue in the output folder, which is run as any other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cli/commands.h"
#include "verification/common/input.h"
#include "verification/common/resources.h"
#include "verification/study/study_catalogue.h"
#include "verification/study/study_write.h"

#include <string.h>

static const char default_output[] = "mpm-study";

static bool has_arguments(const struct command_options *given)
{
    return given->refine != NULL || given->vary != NULL || given->settings != NULL ||
           given->measures != NULL || given->timeout != NULL;
}

/* A scene alone goes on with the study that is stored; it has to be of that scene. */
static enum mpm_status read_stored(const char *scene, const char *output, struct study **study,
                                   struct mpm_error *error)
{
    char *path = study_file_path(output), *whole = g_canonicalize_filename(scene, NULL);
    enum mpm_path kind;
    enum mpm_status status = input_kind(path, &kind, error);
    if (status == MPM_OK && kind != MPM_PATH_FILE)
        status =
            failure_set(error, MPM_BAD_INPUT,
                        "%s: no study was begun here that could go on: allowed is the --output "
                        "of an earlier one",
                        output);
    if (status == MPM_OK)
        status = study_read(path, study, error);
    if (status == MPM_OK && strcmp((*study)->scene, whole) != 0) {
        status = failure_set(error, MPM_BAD_INPUT, "%s: the study in %s is of the scene %s", scene,
                             output, (*study)->scene);
        study_free(*study);
        *study = NULL;
    }
    g_free(whole);
    g_free(path);
    return status;
}

static enum mpm_status read_study(const struct command_options *given, const char *output,
                                  struct study **study, struct mpm_error *error)
{
    const char *path = given->rest[0];
    bool is_study;
    *study = NULL;
    TRY(study_is_file(path, &is_study, error));
    if (!is_study && given->resume && !has_arguments(given))
        return read_stored(path, output, study, error);
    if (is_study)
        TRY(study_read(path, study, error));
    else
        *study = study_of_scene(path);
    const struct study_arguments arguments = {.refine = given->refine,
                                              .timeout = given->timeout,
                                              .vary = given->vary,
                                              .settings = given->settings,
                                              .measures = given->measures};
    return study_take_arguments(*study, &arguments, error);
}

/* What would end the run before it begins: nothing is written then. */
static enum mpm_status check_options(const struct command *command, const char *output,
                                     struct mpm_error *error)
{
    const struct command_options *given = &command->options;
    char *state = g_build_filename(output, ".run", "run.json", NULL);
    const bool begun = mpm_path_kind(state) != MPM_PATH_NONE; /* unknown: reading it gives why */
    char *reports = resources_reports(command->argv[0]);
    enum mpm_kernels kernels;
    enum mpm_status status = MPM_OK;
    g_free(state);
    if (given->resume && !begun)
        status =
            failure_set(error, MPM_BAD_INPUT,
                        "%s: no study was begun here that could go on: allowed is the --output "
                        "of an earlier one",
                        output);
    else if (given->launcher != NULL && strcmp(given->launcher, "local") != 0 &&
             strcmp(given->launcher, "slurm") != 0)
        status = failure_set(error, MPM_BAD_INPUT, "--launcher \"%s\": allowed are local and slurm",
                             given->launcher);
    else if (reports == NULL)
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, RESOURCES_NO_REPORTS);
    else if (given->kernels != NULL)
        status = mpm_kernels_find(given->kernels, &kernels, error);
    g_free(reports);
    return status;
}

enum mpm_status command_study(struct command *command, struct mpm_error *error)
{
    const struct command_options *given = &command->options;
    struct command_options of_run = *given;
    struct study *study;
    of_run.output = given->output != NULL ? given->output : (char *)(uintptr_t)default_output;
    TRY(check_options(command, of_run.output, error));
    enum mpm_status status = read_study(given, of_run.output, &study, error);
    if (status == MPM_OK)
        status = study_check(study, error);
    if (status == MPM_OK)
        status = study_catalogue_write(study, of_run.output, error);
    study_free(study);
    TRY(status);
    of_run.catalogue = study_catalogue(of_run.output);
    status = given->tasks ? command_tasks_given(command, &of_run, error)
                          : command_run_given(command, &of_run, error);
    g_free(of_run.catalogue);
    return status;
}

enum mpm_status command_study_tables(struct command *command, const char *output,
                                     const char *catalogue, struct mpm_error *error)
{
    char *own = study_catalogue(output), *whole = g_canonicalize_filename(own, NULL);
    const bool is_study = strcmp(whole, catalogue) == 0;
    bool holds = true;
    g_free(whole);
    g_free(own);
    if (!is_study)
        return MPM_OK;
    char *reports = resources_reports(command->argv[0]);
    const enum mpm_status status = study_write(output, reports, command->world->out, &holds, error);
    command->checks_failed = command->checks_failed || !holds;
    g_free(reports);
    return status;
}

/* What the commands have in common: kernels, threads, the scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include "base/status.h"
#include "mpm_yaml.h"

#include <glib.h>
#include <stdio.h>
#include <string.h>

enum { THREADS_MAX = 1024 };

static enum mpm_status bad_threads(const char *name, const char *where, const char *text,
                                   struct mpm_error *error)
{
    return mpm_error_set(error, MPM_BAD_INPUT,
                         "%s: %s: '%s' is not a whole number from 1 to %d; see 'mpm %s --help'",
                         name, where, text, THREADS_MAX, name);
}

static bool read_threads(const char *text, int *threads)
{
    guint64 number = 0;
    if (!g_ascii_string_to_unsigned(text, 10, 1, THREADS_MAX, &number, NULL))
        return false;
    *threads = (int)number;
    return true;
}

/* OMP_NUM_THREADS may be a list: the first number of it. Without it all processors. */
static enum mpm_status default_threads(const char *name, int *threads, struct mpm_error *error)
{
    const char *text = g_getenv("OMP_NUM_THREADS");
    *threads = (int)MIN(g_get_num_processors(), (guint)THREADS_MAX);
    if (text == NULL)
        return MPM_OK;
    char **list = g_strsplit(text, ",", 2);
    const bool read = list[0] != NULL && read_threads(g_strstrip(list[0]), threads);
    g_strfreev(list);
    return read ? MPM_OK : bad_threads(name, "OMP_NUM_THREADS", text, error);
}

static enum mpm_status bad_choice(const char *name, const char *option,
                                  const struct mpm_error *cause, struct mpm_error *error)
{
    return mpm_error_set(error, MPM_BAD_INPUT, "%s: %s: %s; see 'mpm %s --help'", name, option,
                         cause->message, name);
}

enum mpm_status cli_take_simulation(struct command *command, const char *name,
                                    struct mpm_error *error)
{
    const struct cli_arguments *const given = &command->arguments;
    struct mpm_simulation_options *const simulation = &command->simulation;
    struct mpm_error cause = {.status = MPM_OK};
    command->scene = given->operands[0];
    if (given->kernels != NULL &&
        mpm_kernels_find(given->kernels, &simulation->kernels, &cause) != MPM_OK)
        return bad_choice(name, "--kernels", &cause, error);
    if (given->simd != NULL && mpm_simd_find(given->simd, &simulation->simd, &cause) != MPM_OK)
        return bad_choice(name, "--simd", &cause, error);
    if (given->threads == NULL)
        return default_threads(name, &simulation->threads, error);
    return read_threads(given->threads, &simulation->threads)
               ? MPM_OK
               : bad_threads(name, "--threads", given->threads, error);
}

/* One mistake is told as it is; several, each on a line, and how many there are. */
static enum mpm_status report_faults(const struct command *command, const struct mpm_faults *faults,
                                     enum mpm_status status, struct mpm_error *error)
{
    *error = faults->list[0];
    if (faults->count == 1)
        return status;
    const size_t shown = MIN(faults->count, (size_t)MPM_FAULTS_MAX);
    for (size_t i = 0; i < shown; i++)
        (void)fprintf(stderr, "mpm: %s\n", faults->list[i].message);
    return mpm_error_set(error, status, "%s: %zu mistakes%s",
                         strcmp(command->scene, "-") == 0 ? "standard input" : command->scene,
                         faults->count, shown < faults->count ? ", the first 10 shown" : "");
}

enum mpm_status cli_scene_read(const struct command *command, struct mpm_scene **scene,
                               struct mpm_error *error)
{
    const char *const *settings = (const char *const *)command->arguments.settings;
    size_t count = 0;
    while (settings != NULL && settings[count] != NULL)
        count++;
    struct mpm_faults faults;
    const enum mpm_status status =
        mpm_scene_read_all(command->scene, settings, count, scene, &faults);
    return status == MPM_OK ? MPM_OK : report_faults(command, &faults, status, error);
}

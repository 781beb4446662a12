/* mpm new: a commented scene to begin with.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include "base/status.h"
#include "mpm_file.h"
#include "mpm_words.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static const struct scene {
    const char *name, *summary;
    const char *const *lines;
} scenes[] = {
#include "scenes.inc"
};

static enum mpm_status list(bool names_alone)
{
    for (size_t k = 0; k < G_N_ELEMENTS(scenes); k++)
        if (names_alone)
            (void)printf("%s\n", scenes[k].name);
        else
            (void)printf("%-12s %s\n", scenes[k].name, scenes[k].summary);
    return MPM_OK;
}

static const struct scene *find(const char *name)
{
    for (size_t k = 0; k < G_N_ELEMENTS(scenes); k++)
        if (strcmp(scenes[k].name, name) == 0)
            return &scenes[k];
    return NULL;
}

static enum mpm_status refuse_kind(const char *name, struct mpm_error *error)
{
    GString *const names = g_string_new(NULL);
    struct mpm_nearest nearest = {.word = name};
    char hint[MPM_HINT_SIZE];
    for (size_t k = 0; k < G_N_ELEMENTS(scenes); k++) {
        g_string_append_printf(names, "%s%s", k > 0 ? ", " : "", scenes[k].name);
        if (name != NULL)
            mpm_nearest_offer(&nearest, scenes[k].name);
    }
    const enum mpm_status status =
        name == NULL
            ? mpm_error_set(error, MPM_BAD_INPUT,
                            "new: a kind is missing; allowed: %s; see 'mpm new --list'", names->str)
            : mpm_error_set(error, MPM_BAD_INPUT,
                            "new: unknown kind '%s'; allowed: %s%s; see 'mpm new --list'", name,
                            names->str, mpm_nearest_hint(&nearest, hint));
    g_string_free(names, TRUE);
    return status;
}

/* Only where there is nothing of that name: a scene may be the work of days. */
static enum mpm_status write_scene(const struct scene *scene, const char *path,
                                   struct mpm_error *error)
{
    char *const text = g_strjoinv("", (char **)(uintptr_t)scene->lines);
    const enum mpm_path kind = mpm_path_own_kind(path);
    struct mpm_error cause = {.status = MPM_OK};
    enum mpm_status status = MPM_OK;
    if (kind == MPM_PATH_UNKNOWN)
        status =
            mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "new: %s: %s", path, g_strerror(errno));
    else if (kind != MPM_PATH_NONE)
        status = mpm_error_set(error, MPM_BAD_INPUT,
                               "new: %s: is there already, and not overwritten; allowed: another "
                               "name, by --output",
                               path);
    else if (mpm_file_save(path, text, strlen(text)) != 0)
        status =
            mpm_error_set(error, mpm_file_failed(path, errno, &cause), "new: %s", cause.message);
    g_free(text);
    return status;
}

/* A line that can be typed again, whatever the name. */
static void print_next(const char *path, const char *summary)
{
    static const char plain[] = G_CSET_A_2_Z G_CSET_a_2_z G_CSET_DIGITS "_-./";
    char *const quoted = path[strspn(path, plain)] == '\0' ? g_strdup(path) : g_shell_quote(path);
    (void)printf("%s: %s\nnext: mpm run %s%s\n", path, summary, path[0] == '-' ? "-- " : "",
                 quoted);
    g_free(quoted);
}

enum mpm_status cli_new(struct command *command, struct mpm_error *error)
{
    const struct cli_arguments *const given = &command->arguments;
    const char *const kind = given->operands != NULL ? given->operands[0] : NULL;
    if (given->list && given->names)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "new: allowed: one of --list and --names; see 'mpm new --help'");
    if (given->list || given->names)
        return list(given->names);
    const struct scene *const scene = kind != NULL ? find(kind) : NULL;
    if (scene == NULL)
        return refuse_kind(kind, error);
    char *const path =
        given->output != NULL ? g_strdup(given->output) : g_strconcat(scene->name, ".yaml", NULL);
    const enum mpm_status status = write_scene(scene, path, error);
    if (status == MPM_OK && !given->quiet)
        print_next(path, scene->summary);
    g_free(path);
    return status;
}

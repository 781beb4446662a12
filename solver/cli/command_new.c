/* mpm new: a commented scene to begin with.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include "mpm_file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static const struct scene {
    const char *name, *summary;
    const char *const *lines;
} scenes[] = {
#include "scenes.inc"
};

static int list(void)
{
    for (size_t k = 0; k < G_N_ELEMENTS(scenes); k++)
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

static int refuse_kind(const char *name)
{
    GString *const names = g_string_new(NULL);
    for (size_t k = 0; k < G_N_ELEMENTS(scenes); k++)
        g_string_append_printf(names, "%s%s", k > 0 ? ", " : "", scenes[k].name);
    const int status = name == NULL ? cli_fail(MPM_BAD_INPUT,
                                               "new: a kind is missing; allowed: %s; see "
                                               "'mpm new --list'",
                                               names->str)
                                    : cli_fail(MPM_BAD_INPUT,
                                               "new: unknown kind '%s'; allowed: %s; see "
                                               "'mpm new --list'",
                                               name, names->str);
    g_string_free(names, TRUE);
    return status;
}

/* Only where there is nothing of that name: a scene may be the work of days. */
static int write_scene(const struct scene *scene, const char *path)
{
    char *const text = g_strjoinv("", (char **)(uintptr_t)scene->lines);
    const enum mpm_path kind = mpm_path_own_kind(path);
    struct mpm_error error = {.status = MPM_OK};
    int status = MPM_OK;
    if (kind == MPM_PATH_UNKNOWN)
        status = cli_fail(MPM_ENVIRONMENT_FAILED, "new: %s: %s", path, g_strerror(errno));
    else if (kind != MPM_PATH_NONE)
        status = cli_fail(MPM_BAD_INPUT,
                          "new: %s: is there already, and not overwritten; allowed: another name, "
                          "by --output",
                          path);
    else if (mpm_file_save(path, text, strlen(text)) != 0)
        status = cli_fail(mpm_file_failed(path, errno, &error), "new: %s", error.message);
    g_free(text);
    return status;
}

int cli_new(struct cli_arguments *arguments)
{
    if (arguments->list)
        return list();
    const struct scene *const scene = arguments->scene != NULL ? find(arguments->scene) : NULL;
    if (scene == NULL)
        return refuse_kind(arguments->scene);
    char *const path = arguments->output != NULL ? g_strdup(arguments->output)
                                                 : g_strconcat(scene->name, ".yaml", NULL);
    const int status = write_scene(scene, path);
    if (status == MPM_OK && !arguments->quiet)
        (void)printf("%s: %s\nnext: mpm run %s\n", path, scene->summary, path);
    g_free(path);
    return status;
}

/* mpm info and mpm schema.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include "base/status.h"
#include "io/scene/schema.h"

#include <glib.h>
#include <stdio.h>
#include <stdlib.h>

enum mpm_status cli_info(struct command *command, struct mpm_error *error)
{
    (void)command;
    (void)error;
    const struct mpm_build_info *build = mpm_build_info();
    const struct {
        const char *name, *value;
    } facts[] = {
        {"version", build->version}, {"revision", build->revision},   {"compiler", build->compiler},
        {"flags", build->flags},     {"libraries", build->libraries}, {"simd", build->simd},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(facts); i++)
        (void)printf("%-10s %s\n", facts[i].name, facts[i].value);
    return MPM_OK;
}

enum mpm_status cli_schema(struct command *command, struct mpm_error *error)
{
    const struct cli_arguments *const given = &command->arguments;
    const bool json = given->json || given->list;
    size_t count = 1;
    if (given->json + given->list + (given->filter != NULL) > 1)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "schema: allowed: one of --filter, --json and --list; see "
                             "'mpm schema --help'");
    char *text = given->json   ? mpm_schema_document()
                 : given->list ? mpm_schema_list()
                               : mpm_schema_text(given->filter, &count);
    if (text == NULL)
        return mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for the schema");
    if (count > 0)
        (void)printf("%s%s", text, json ? "\n" : "");
    free(text);
    return count > 0 ? MPM_OK
                     : mpm_error_set(error, MPM_BAD_INPUT,
                                     "schema: no key has \"%s\" in its name, type, range or "
                                     "meaning; 'mpm schema' lists all",
                                     given->filter);
}

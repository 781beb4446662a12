/* mpm info and mpm schema.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include "io/scene/schema.h"

#include <stdio.h>
#include <stdlib.h>

int cli_info(const struct cli_command *command, int argc, char **argv)
{
    const struct cli_arguments arguments = {.command = command};
    const enum cli_outcome outcome = cli_arguments_read(&arguments, argc, argv, NULL);
    if (outcome != CLI_GO_ON)
        return outcome == CLI_BAD_USAGE ? MPM_BAD_INPUT : MPM_OK;
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

int cli_schema(const struct cli_command *command, int argc, char **argv)
{
    gboolean json = FALSE;
    const GOptionEntry options[] = {
        {"json", 0, 0, G_OPTION_ARG_NONE, &json, "Print the keys as JSON, for programs", NULL},
        {NULL, 0, 0, G_OPTION_ARG_NONE, NULL, NULL, NULL},
    };
    const struct cli_arguments arguments = {.command = command, .options = options};
    const enum cli_outcome outcome = cli_arguments_read(&arguments, argc, argv, NULL);
    if (outcome != CLI_GO_ON)
        return outcome == CLI_BAD_USAGE ? MPM_BAD_INPUT : MPM_OK;
    char *text = json ? mpm_schema_json() : mpm_schema_text();
    if (text == NULL)
        return cli_fail(MPM_ENVIRONMENT_FAILED, "out of memory for the schema");
    (void)fputs(text, stdout);
    if (json)
        (void)fputc('\n', stdout);
    free(text);
    return MPM_OK;
}

/* mpm info and mpm schema.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include "io/scene/schema.h"

#include <stdio.h>
#include <stdlib.h>

int cli_info(struct cli_arguments *arguments)
{
    (void)arguments;
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

int cli_schema(struct cli_arguments *arguments)
{
    char *text = arguments->json ? mpm_schema_json() : mpm_schema_text();
    if (text == NULL)
        return cli_fail(MPM_ENVIRONMENT_FAILED, "out of memory for the schema");
    (void)printf("%s%s", text, arguments->json ? "\n" : "");
    free(text);
    return MPM_OK;
}

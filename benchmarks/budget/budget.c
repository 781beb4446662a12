/* The budget: verdicts and the file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/budget/budget.h"

#include "verification/common/failure.h"
#include "verification/common/input.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>

/* ------------------------------------------------------------------- verdicts */

const struct budget_figure_kind budget_figures[BUDGET_FIGURES] = {
    [BUDGET_INSTRUCTIONS] = {"instructions", BUDGET_INSTRUCTIONS_TOLERANCE},
    [BUDGET_BRANCHES] = {"branches", BUDGET_BRANCHES_TOLERANCE},
    [BUDGET_BYTES] = {"bytes", BUDGET_BYTES_TOLERANCE},
};

enum budget_verdict budget_judge(double measured, double stored, double tolerance)
{
    if (!(measured <= stored * (1.0 + tolerance)))
        return BUDGET_EXCEEDED;
    return measured < stored * (1.0 - tolerance) ? BUDGET_BETTER : BUDGET_KEPT;
}

struct budget_cost budget_cost_of(const struct instructions *counted)
{
    struct budget_cost cost = {.figures = {
                                   [BUDGET_INSTRUCTIONS] = instructions_rate(counted),
                                   [BUDGET_BRANCHES] = instructions_branch_rate(counted),
                                   [BUDGET_BYTES] = counted->bytes_per_particle,
                               }};
    g_strlcpy(cost.kernels, counted->kernels, sizeof cost.kernels);
    g_strlcpy(cost.simd, counted->simd, sizeof cost.simd);
    return cost;
}

/* ---------------------------------------------------------------------- build */

/* "gcc 12" of "gcc 12.2.0": minor versions share a budget. */
static void major_version(const char *compiler, char *major, size_t size)
{
    g_strlcpy(major, compiler, size);
    char *point = strchr(major, '.');
    if (point != NULL)
        *point = '\0';
}

struct budget_build budget_build_here(void)
{
    const struct mpm_build_info *info = mpm_build_info();
    struct budget_build build = {.flags = ""};
    struct utsname machine;
    major_version(info->compiler, build.compiler, sizeof build.compiler);
    g_strlcpy(build.architecture, uname(&machine) == 0 ? machine.machine : "unknown",
              sizeof build.architecture);
    g_strlcpy(build.flags, info->flags, sizeof build.flags);
    g_strchomp(build.flags);
    return build;
}

/* ------------------------------------------------------------------- the file */

struct budget budget_make(const struct budget_build *build)
{
    return (struct budget){.build = *build, .runs = json_object()};
}

void budget_clear(struct budget *budget)
{
    json_decref(budget->runs);
    budget->runs = NULL;
}

static bool read_cost(json_t *object, struct budget_cost *cost, json_error_t *failure)
{
    const char *kernels = NULL, *simd = NULL;
    if (json_unpack_ex(object, failure, JSON_STRICT, "{s:s, s:s, s:F, s:F, s:F}", "kernels",
                       &kernels, "simd", &simd, budget_figures[0].name, &cost->figures[0],
                       budget_figures[1].name, &cost->figures[1], budget_figures[2].name,
                       &cost->figures[2]) != 0)
        return false;
    g_strlcpy(cost->kernels, kernels, sizeof cost->kernels);
    g_strlcpy(cost->simd, simd, sizeof cost->simd);
    return true;
}

static enum mpm_status unpack(const char *path, json_t *root, struct budget *budget,
                              struct mpm_error *error)
{
    json_error_t failure;
    const char *compiler = "", *architecture = "", *flags = "", *name = NULL;
    json_t *runs = NULL, *run = NULL;
    if (json_unpack_ex(root, &failure, JSON_STRICT, "{s:s, s:s, s:s, s:o}", "compiler", &compiler,
                       "architecture", &architecture, "flags", &flags, "runs", &runs) != 0)
        return failure_set(error, MPM_BAD_INPUT, "%s: %s", path, failure.text);
    json_object_foreach(runs, name, run)
    {
        struct budget_cost cost;
        if (!read_cost(run, &cost, &failure))
            return failure_set(error, MPM_BAD_INPUT, "%s: runs: \"%s\": %s", path, name,
                               failure.text);
    }
    g_strlcpy(budget->build.compiler, compiler, sizeof budget->build.compiler);
    g_strlcpy(budget->build.architecture, architecture, sizeof budget->build.architecture);
    g_strlcpy(budget->build.flags, flags, sizeof budget->build.flags);
    budget->runs = json_incref(runs);
    return MPM_OK;
}

enum mpm_status budget_read(const char *path, struct budget *budget, struct mpm_error *error)
{
    json_t *root;
    *budget = (struct budget){.runs = NULL};
    TRY(input_json(path, JSON_REJECT_DUPLICATES, &root, error));
    const enum mpm_status status = unpack(path, root, budget, error);
    json_decref(root);
    return status;
}

enum mpm_status budget_write(const char *path, const struct budget *budget, struct mpm_error *error)
{
    json_t *root =
        json_pack("{s:s, s:s, s:s, s:O}", "compiler", budget->build.compiler, "architecture",
                  budget->build.architecture, "flags", budget->build.flags, "runs", budget->runs);
    char *dumped = json_dumps(root, JSON_INDENT(2) | JSON_REAL_PRECISION(6));
    char *text = g_strconcat(dumped, "\n", NULL);
    const enum mpm_status status =
        mpm_file_save(path, text, strlen(text)) == 0 ? MPM_OK : mpm_file_failed(path, errno, error);
    g_free(text);
    free(dumped);
    json_decref(root);
    return status;
}

bool budget_find(const struct budget *budget, const char *run, struct budget_cost *cost)
{
    json_error_t failure;
    json_t *object = json_object_get(budget->runs, run);
    return object != NULL && read_cost(object, cost, &failure);
}

void budget_store(struct budget *budget, const char *run, const struct budget_cost *cost)
{
    json_t *object = json_pack("{s:s, s:s}", "kernels", cost->kernels, "simd", cost->simd);
    for (size_t i = 0; i < BUDGET_FIGURES; i++)
        json_object_set_new(object, budget_figures[i].name, json_real(cost->figures[i]));
    json_object_set_new(budget->runs, run, object);
}

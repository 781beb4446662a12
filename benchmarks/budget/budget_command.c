/* `mpm-bench budget`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/budget/budget_command.h"

#include "verification/common/failure.h"

#include <string.h>

#define UPDATE_COMMAND "mpm-bench budget --update"

/* ----------------------------------------------------------------- skipping */

char *budget_reason_to_skip(const struct budget_build *stored, const struct budget_build *here)
{
    if (strcmp(stored->compiler, here->compiler) == 0 &&
        strcmp(stored->architecture, here->architecture) == 0)
        return NULL;
    return g_strdup_printf("budget: skipped: stored for %s on %s; this is %s on %s",
                           stored->compiler, stored->architecture, here->compiler,
                           here->architecture);
}

/* ------------------------------------------------------------------ the table */

struct tally {
    size_t exceeded, better, skipped;
};

static void print_heading(FILE *out)
{
    (void)fprintf(out, "%-44s %-10s", "instructions, branches: per particle-step", "kernels");
    for (size_t i = 0; i < BUDGET_FIGURES; i++)
        (void)fprintf(out, " %12s %8s", budget_figures[i].name, "change");
    (void)fprintf(out, "\n");
}

static void print_row(FILE *out, const char *name, const struct budget_cost *cost,
                      const struct budget_cost *stored, const char *verdict)
{
    (void)fprintf(out, "%-44s %-10s", name, cost->kernels);
    for (size_t i = 0; i < BUDGET_FIGURES; i++) {
        char change[16] = "-";
        if (stored != NULL)
            g_snprintf(change, sizeof change, "%+.2f %%",
                       100.0 * (cost->figures[i] / stored->figures[i] - 1.0));
        (void)fprintf(out, " %12.2f %8s", cost->figures[i], change);
    }
    (void)fprintf(out, "  %s\n", verdict);
    (void)fflush(out);
}

/* The names of the figures with that verdict, "" for none. */
static void list_figures(const struct budget_cost *cost, const struct budget_cost *stored,
                         enum budget_verdict verdict, char *list, size_t size)
{
    list[0] = '\0';
    for (size_t i = 0; i < BUDGET_FIGURES; i++)
        if (budget_judge(cost->figures[i], stored->figures[i], budget_figures[i].tolerance) ==
            verdict) {
            g_strlcat(list, list[0] == '\0' ? "" : ", ", size);
            g_strlcat(list, budget_figures[i].name, size);
        }
}

/* "OVER BUDGET: instructions, bytes", "better: branches", "met"; g_free. */
static char *verdict_text(const struct budget_cost *cost, const struct budget_cost *stored,
                          struct tally *tally)
{
    char over[80], under[80];
    list_figures(cost, stored, BUDGET_EXCEEDED, over, sizeof over);
    list_figures(cost, stored, BUDGET_BETTER, under, sizeof under);
    if (over[0] != '\0') {
        tally->exceeded++;
        return g_strconcat("OVER BUDGET: ", over, NULL);
    }
    if (under[0] != '\0') {
        tally->better++;
        return g_strconcat("better: ", under, NULL);
    }
    return g_strdup("met");
}

static void judge_run(const struct budget *budget, const char *name, const struct budget_cost *cost,
                      struct tally *tally, FILE *out)
{
    struct budget_cost stored;
    char *verdict = NULL;
    bool comparable = false;
    if (!budget_find(budget, name, &stored)) {
        verdict = g_strdup("NO BUDGET STORED");
        tally->exceeded++;
    } else if (strcmp(stored.kernels, cost->kernels) != 0) {
        verdict = g_strdup_printf("OTHER KERNELS: stored for %s", stored.kernels);
        tally->exceeded++;
    } else if (strcmp(stored.simd, cost->simd) != 0) {
        verdict = g_strdup_printf("skipped: stored for %s, this is %s", stored.simd, cost->simd);
        tally->skipped++;
    } else {
        comparable = true;
        verdict = verdict_text(cost, &stored, tally);
    }
    print_row(out, name, cost, comparable ? &stored : NULL, verdict);
    g_free(verdict);
}

static void print_sum(const struct tally *tally, FILE *out)
{
    const size_t met = budget_runs_count - tally->exceeded - tally->better - tally->skipped;
    (void)fprintf(out, "budget: %zu met, %zu better, %zu over, %zu skipped\n", met, tally->better,
                  tally->exceeded, tally->skipped);
    if (tally->better > 0)
        (void)fprintf(out, "budget: store the better figures with `" UPDATE_COMMAND "`\n");
    if (tally->exceeded > 0)
        (void)fprintf(out, "budget: if the cost is meant, store it with `" UPDATE_COMMAND
                           "` and give the reason in the commit\n");
}

/* What each of the costliest functions executes itself, for each particle and step. */
static void print_functions(FILE *out, const struct instructions *counted)
{
    const double steps = (double)counted->particle_steps;
    for (size_t i = 0; i < CALLGRIND_TOP && counted->counts.top[i].name[0] != '\0'; i++) {
        const struct callgrind_function *function = &counted->counts.top[i];
        (void)fprintf(out, "  %-53s %12.2f %8s %12.2f\n", function->name,
                      (double)function->instructions / steps, "",
                      (double)function->branches / steps);
    }
}

/* ---------------------------------------------------------------- the command */

static enum mpm_status count_run(const struct budget_options *options, const struct budget_run *run,
                                 struct instructions *counted, struct mpm_error *error)
{
    const enum mpm_status status = budget_run_count(run, options->places, counted, error);
    const struct mpm_error cause = *error;
    return status == MPM_OK ? MPM_OK
                            : failure_set(error, status, "%s: %s", run->name, cause.message);
}

static enum mpm_status check(const struct budget_options *options, const struct budget *budget,
                             bool *exceeded, struct mpm_error *error)
{
    struct tally tally = {0, 0, 0};
    print_heading(options->out);
    for (size_t i = 0; i < budget_runs_count; i++) {
        struct instructions counted;
        TRY(count_run(options, &budget_runs[i], &counted, error));
        const struct budget_cost cost = budget_cost_of(&counted);
        judge_run(budget, budget_runs[i].name, &cost, &tally, options->out);
        if (options->functions)
            print_functions(options->out, &counted);
    }
    print_sum(&tally, options->out);
    *exceeded = tally.exceeded > 0;
    return MPM_OK;
}

static enum mpm_status count_all(const struct budget_options *options, struct budget *budget,
                                 struct mpm_error *error)
{
    print_heading(options->out);
    for (size_t i = 0; i < budget_runs_count; i++) {
        struct instructions counted;
        TRY(count_run(options, &budget_runs[i], &counted, error));
        const struct budget_cost cost = budget_cost_of(&counted);
        budget_store(budget, budget_runs[i].name, &cost);
        print_row(options->out, budget_runs[i].name, &cost, NULL, "stored");
        if (options->functions)
            print_functions(options->out, &counted);
    }
    return MPM_OK;
}

static enum mpm_status update_file(const struct budget_options *options, const char *path,
                                   struct mpm_error *error)
{
    const struct budget_build here = budget_build_here();
    struct budget budget = budget_make(&here);
    enum mpm_status status = count_all(options, &budget, error);
    if (status == MPM_OK)
        status = budget_write(path, &budget, error);
    budget_clear(&budget);
    return status;
}

/* Can the budget be held against this build? Other flags make another program: that is no
 * reason to skip, or a change of flags would end the checks unseen. */
static bool applies(const struct budget *budget, FILE *out, bool *exceeded)
{
    const struct budget_build here = budget_build_here();
    char *reason = budget_reason_to_skip(&budget->build, &here);
    const bool skipped = reason != NULL;
    *exceeded = !skipped && strcmp(budget->build.flags, here.flags) != 0;
    if (skipped)
        (void)fprintf(out, "%s\n", reason);
    else if (*exceeded)
        (void)fprintf(out,
                      "budget: stored for a build with '%s', this one has '%s': store it anew "
                      "with `" UPDATE_COMMAND "` if they are to stay\n",
                      budget->build.flags, here.flags);
    g_free(reason);
    return !skipped && !*exceeded;
}

static enum mpm_status check_file(const struct budget_options *options, const char *path,
                                  bool *exceeded, struct mpm_error *error)
{
    struct budget budget;
    TRY(budget_read(path, &budget, error));
    const enum mpm_status status = applies(&budget, options->out, exceeded)
                                       ? check(options, &budget, exceeded, error)
                                       : MPM_OK;
    budget_clear(&budget);
    return status;
}

enum mpm_status budget_command(const struct budget_options *options, bool *exceeded,
                               struct mpm_error *error)
{
    *exceeded = false;
    char *path = g_build_filename(options->places->benchmarks, BUDGET_FILE, NULL);
    const enum mpm_status status = options->update ? update_file(options, path, error)
                                                   : check_file(options, path, exceeded, error);
    g_free(path);
    return status;
}

/* The judge.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/judge.h"

#include "verification/common/rows.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* ------------------------------------------------------------------ judging */

static const struct row *row_of(const GArray *rows, enum row_kind kind, const char *name,
                                unsigned *count)
{
    const struct row *found = NULL;
    *count = 0;
    for (unsigned i = 0; i < rows->len; i++) {
        const struct row *row = &g_array_index(rows, struct row, i);
        if (row->kind == kind && (name == NULL || strcmp(row->name, name) == 0)) {
            found = row;
            ++*count;
        }
    }
    return found;
}

static struct verdict judge_value(const struct case_check *check, const GArray *rows,
                                  struct check_verdict *result)
{
    unsigned count, open_count;
    const struct row *row = row_of(rows, ROW_VALUE, check->quantity, &count);
    const struct row *open = row_of(rows, ROW_INCONCLUSIVE, check->quantity, &open_count);
    if (count + open_count > 1)
        return verdict_without_value(VERDICT_ERROR, "%s was reported %u times", check->quantity,
                                     count + open_count);
    if (open != NULL)
        return verdict_without_value(VERDICT_INCONCLUSIVE, "%s", open->text);
    if (row == NULL)
        return verdict_without_value(VERDICT_ERROR, "%s was not reported", check->quantity);
    double value;
    if (!row_number(row->text, &value))
        return verdict_without_value(VERDICT_ERROR, "%s: \"%s\" is not a number", check->quantity,
                                     row->text);
    result->has_value = isfinite(value);
    result->value = value;
    return verdict_judge(&check->band, value);
}

static struct verdict judge_rows(const struct case_check *check, const GArray *rows,
                                 struct check_verdict *result)
{
    unsigned count;
    const struct row *work = row_of(rows, ROW_WORK, NULL, &count);
    if (work != NULL)
        result->particle_steps = g_ascii_strtoull(work->text, NULL, 10);
    if (row_of(rows, ROW_END, NULL, &count) == NULL)
        return verdict_without_value(VERDICT_ERROR, "the results are cut short");
    const struct row *skip = row_of(rows, ROW_SKIP, NULL, &count);
    if (skip != NULL)
        return verdict_without_value(VERDICT_SKIP, "%s", skip->text);
    return judge_value(check, rows, result);
}

static struct verdict judge_failure(const struct job_result *result, const GArray *rows)
{
    unsigned count = 0;
    const struct row *failure = rows == NULL ? NULL : row_of(rows, ROW_FAILURE, NULL, &count);
    const char *said = failure == NULL ? "see the log" : failure->text;
    switch (result->outcome) {
    case JOB_TIMED_OUT:
        return verdict_without_value(VERDICT_TIMEOUT, "stopped after its time-out of %g s",
                                     result->timeout);
    case JOB_CRASHED:
        return verdict_without_value(VERDICT_ERROR, "the program crashed: signal %d (%s)",
                                     result->code, g_strsignal(result->code));
    case JOB_NOT_RUN:
        return verdict_without_value(VERDICT_ERROR, "the program was not run: %s", said);
    case JOB_RETURNED:
        break;
    }
    return verdict_without_value(VERDICT_ERROR, "the program failed with status %d: %s",
                                 result->code, said);
}

struct check_verdict judge_check(const struct case_check *check, const struct job_result *result)
{
    struct check_verdict judged = {.has_value = false};
    unsigned bad_line = 0;
    GArray *rows = rows_parse(result->rows, &bad_line);
    if (result->outcome != JOB_RETURNED || result->code != 0)
        judged.verdict = judge_failure(result, rows);
    else if (rows == NULL)
        judged.verdict =
            verdict_without_value(VERDICT_ERROR, "line %u of the results cannot be read", bad_line);
    else
        judged.verdict = judge_rows(check, rows, &judged);
    if (rows != NULL)
        g_array_unref(rows);
    return judged;
}

/* -------------------------------------------------------------------- proof */

/* The rows without those of the quantity, without skips and without the end, followed
 * by `replacement` and an end: as if the program had run to its end and said that. */
static char *rows_with(const char *text, const char *quantity, const char *replacement)
{
    GString *changed = g_string_new(NULL);
    unsigned bad_line;
    GArray *rows = rows_parse(text, &bad_line);
    for (unsigned i = 0; rows != NULL && i < rows->len; i++) {
        const struct row *row = &g_array_index(rows, struct row, i);
        if (row->kind == ROW_SKIP || row->kind == ROW_END || row->kind == ROW_FAILURE ||
            strcmp(row->name, quantity) == 0)
            continue;
        char *line = row_line(row->kind, row->name, row->text);
        g_string_append(changed, line);
        g_free(line);
    }
    if (rows != NULL)
        g_array_unref(rows);
    char *end = row_line(ROW_END, "", "");
    g_string_append(changed, replacement);
    g_string_append(changed, end);
    g_free(end);
    return g_string_free(changed, FALSE);
}

/* Judges a changed result; a mutation that is not red spoils the real verdict. */
static void prove(const struct case_check *check, const struct job_result *changed,
                  const char *name, struct check_verdict *judged)
{
    const struct check_verdict mutated = judge_check(check, changed);
    judged->mutations++;
    if (verdict_is_red(mutated.verdict.status))
        judged->mutations_red++;
    else
        judged->verdict =
            verdict_without_value(VERDICT_ERROR, "cannot fail: %s in place of the result gave %s",
                                  name, verdict_status_name(mutated.verdict.status));
}

static void prove_rows(const struct case_check *check, const struct job_result *result,
                       const char *replacement, const char *name, struct check_verdict *judged)
{
    char *rows = rows_with(result->rows, check->quantity, replacement);
    const struct job_result changed = {JOB_RETURNED, 0, result->seconds, result->timeout, rows};
    prove(check, &changed, name, judged);
    g_free(rows);
}

static void prove_values(const struct case_check *check, const struct job_result *result,
                         struct check_verdict *judged)
{
    for (int m = 0; m < VERDICT_MUTATION_COUNT; m++) {
        double value;
        const char *name;
        if (!verdict_mutation_value(&check->band, (enum verdict_mutation)m, &value, &name))
            continue;
        char *line = row_line_value(check->quantity, value);
        prove_rows(check, result, line, name, judged);
        g_free(line);
    }
}

static void prove_jobs(const struct case_check *check, const struct job_result *result,
                       struct check_verdict *judged)
{
    const struct {
        const char *name;
        enum job_outcome outcome;
        int code;
    } jobs[] = {{"a crash", JOB_CRASHED, 11},
                {"a failed program", JOB_RETURNED, MPM_RUN_FAILED},
                {"a time-out", JOB_TIMED_OUT, 0}};
    for (size_t i = 0; i < G_N_ELEMENTS(jobs); i++) {
        const struct job_result changed = {jobs[i].outcome, jobs[i].code, result->seconds,
                                           result->timeout, result->rows};
        prove(check, &changed, jobs[i].name, judged);
    }
}

struct check_verdict judge_check_with_proof(const struct case_check *check,
                                            const struct job_result *result)
{
    struct check_verdict judged = judge_check(check, result);
    char *good = row_line_value(check->quantity, check->band.expected);
    char *twice = g_strconcat(good, good, NULL);
    prove_rows(check, result, "", "a missing row", &judged);
    prove_rows(check, result, twice, "a doubled row", &judged);
    /* no row of an end: as if the process had been cut off */
    const struct job_result cut = {JOB_RETURNED, 0, result->seconds, result->timeout, good};
    prove(check, &cut, "a text cut short", &judged);
    prove_values(check, result, &judged);
    prove_jobs(check, result, &judged);
    g_free(good);
    g_free(twice);
    return judged;
}

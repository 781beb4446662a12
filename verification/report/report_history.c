/* The page of history: each check's value and each benchmark over earlier runs, and where it steps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/text.h"
#include "verification/measures/comparison/series_steps.h"
#include "verification/pages/html.h"
#include "verification/records/check_text.h"
#include "verification/records/history.h"
#include "verification/report/report_site.h"

#include <math.h>
#include <string.h>

struct series {
    char *name; /* as the reports name a check, or a benchmark */
    char *href; /* NULL: a benchmark */
    const char *unit;
    double *numbers;
    double noise;
    struct series_step *steps;
    size_t step_count;
};

struct history_view {
    const json_t *runs;
    size_t length; /* of each series: the earlier runs and this one */
    const char *own;
    GArray *checks, *benchmarks; /* struct series */
};

static void clear_series(void *element)
{
    struct series *series = element;
    g_free(series->name);
    g_free(series->href);
    g_free(series->numbers);
    g_free(series->steps);
}

/* -------------------------------------------------------------------- gathering */

static void judge(struct series *series, size_t length)
{
    double *work = g_new(double, length);
    series->steps = g_new(struct series_step, length);
    series->noise = series_noise(series->numbers, length, work);
    series->step_count =
        series_steps(series->numbers, length, series->noise,
                     series->href == NULL ? SERIES_LEAST_TIME : SERIES_LEAST_VALUE, series->steps);
    g_free(work);
}

static size_t known_numbers(const struct series *series, size_t length)
{
    size_t known = 0;
    for (size_t i = 0; i < length; i++)
        known += isfinite(series->numbers[i]) ? 1 : 0;
    return known;
}

/* A series of fewer than two numbers has no course. Takes the texts over. */
static void add_series(GArray *all, const struct history_view *view, struct series series)
{
    judge(&series, view->length);
    if (known_numbers(&series, view->length) < 2)
        clear_series(&series);
    else
        g_array_append_val(all, series);
}

static void gather_checks(struct history_view *view, const struct report_site *site)
{
    for (size_t i = 0; i < json_array_size(site->records->checks); i++) {
        const json_t *check = json_array_get(site->records->checks, i);
        struct series series = {
            .name = text_check_name(check),
            .href = g_strdup_printf("cases/%s/index.html#checks", record_text(check, "case")),
            .unit = record_text(check, "unit"),
            .numbers = g_new(double, view->length),
        };
        char *key = record_key(check, "check");
        history_series(site->history, "values", key, record_number(check, "value"), series.numbers);
        g_free(key);
        add_series(view->checks, view, series);
    }
}

/* Benchmarks of any run, each once; this run's own are those beside it. */
static void gather_benchmarks(struct history_view *view, const json_t *history)
{
    const json_t *own = json_object_get(history, "benchmarks");
    GHashTable *known = g_hash_table_new(g_str_hash, g_str_equal);
    for (size_t i = 0; i <= json_array_size(view->runs); i++) {
        const char *key;
        json_t *number,
            *numbers = i < json_array_size(view->runs)
                           ? json_object_get(json_array_get(view->runs, i), "benchmarks")
                           : json_object_get(history, "benchmarks");
        json_object_foreach(numbers, key, number)
        {
            if (!g_hash_table_add(known, (void *)(uintptr_t)key))
                continue;
            struct series series = {
                .name = g_strdup(key), .unit = "", .numbers = g_new(double, view->length)};
            history_series(history, "benchmarks", key, record_number(own, key), series.numbers);
            add_series(view->benchmarks, view, series);
        }
    }
    g_hash_table_unref(known);
}

static const char *revision_of(const struct history_view *view, size_t place)
{
    return place < json_array_size(view->runs)
               ? record_text(json_array_get(view->runs, place), "revision")
               : view->own;
}

/* ----------------------------------------------------------------------- drawing */

enum { COURSE_WIDTH = 180, COURSE_HEIGHT = 36, COURSE_EDGE = 5 };

static double place_across(const struct history_view *view, size_t i)
{
    return COURSE_EDGE +
           (double)i * (COURSE_WIDTH - 2 * COURSE_EDGE) / fmax(1, (double)view->length - 1);
}

/* From the least to the largest number of the series; one that stays the same is in the middle. */
static double place_up(const struct series *series, size_t length, double value)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (size_t i = 0; i < length; i++)
        if (isfinite(series->numbers[i])) {
            low = fmin(low, series->numbers[i]);
            high = fmax(high, series->numbers[i]);
        }
    const double part = high > low ? (value / 2 - low / 2) / (high / 2 - low / 2) : 0.5;
    return COURSE_HEIGHT - COURSE_EDGE - part * (COURSE_HEIGHT - 2 * COURSE_EDGE);
}

static void add_place(GString *html, const char *format, double x, double y)
{
    char across[G_ASCII_DTOSTR_BUF_SIZE], up[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_formatd(across, sizeof across, "%.1f", x);
    g_ascii_formatd(up, sizeof up, "%.1f", y);
    g_string_append_printf(html, format, across, up);
}

/* The course as a line with a point for each run, steps as full marks; in words for those who do
 * not see it. */
static GString *course(const struct history_view *view, const struct series *series)
{
    GString *html = g_string_new(NULL);
    char *steps = text_count(series->step_count, "step");
    g_string_append_printf(html,
                           "<svg class=\"course\" role=\"img\" viewBox=\"0 0 %d %d\" width=\"%d\" "
                           "height=\"%d\" aria-label=\"%zu runs, %s\"><polyline points=\"",
                           COURSE_WIDTH, COURSE_HEIGHT, COURSE_WIDTH, COURSE_HEIGHT, view->length,
                           steps);
    g_free(steps);
    for (size_t i = 0; i < view->length; i++)
        if (isfinite(series->numbers[i]))
            add_place(html, "%s,%s ", place_across(view, i),
                      place_up(series, view->length, series->numbers[i]));
    g_string_append(html, "\"/>");
    for (size_t s = 0; s < series->step_count; s++) {
        const size_t at = series->steps[s].to;
        add_place(html, "<circle r=\"4\" cx=\"%s\" cy=\"%s\">", place_across(view, at),
                  place_up(series, view->length, series->numbers[at]));
        text_markup(html, "<title>%s</title></circle>", revision_of(view, at));
    }
    g_string_append(html, "</svg>");
    return html;
}

static void add_course(struct report_table *table, const struct history_view *view,
                       const struct series *series)
{
    char *steps = g_strdup_printf("%zu", series->step_count);
    report_table_markup(table, steps, course(view, series));
    g_free(steps);
}

static void add_name(struct report_table *table, const struct series *series)
{
    if (series->href == NULL)
        report_table_name(table, series->name);
    else
        report_table_link(table, series->href, series->name);
}

static void add_percent(struct report_table *table, double part)
{
    report_table_number(table, 100 * part, text_number(100 * part));
}

/* ------------------------------------------------------------------------ tables */

static size_t known_values(const struct records *records)
{
    size_t known = 0;
    for (size_t i = 0; i < json_array_size(records->checks); i++)
        known += json_is_number(json_object_get(json_array_get(records->checks, i), "value"));
    return known;
}

/* A folder of benchmarks alone has no checks, and none that failed. */
static void add_count_of_checks(struct report_table *table, bool checks, size_t count)
{
    report_table_number(table, checks ? (double)count : (double)NAN,
                        checks ? g_strdup_printf("%zu", count) : g_strdup("no checks"));
}

static void add_runs(GString *html, struct report_site *site, const struct history_view *view)
{
    static const struct report_column columns[] = {
        {"Run", NULL, CELLS_NUMBER, false},       {"Revision", NULL, CELLS_TEXT, false},
        {"Started", NULL, CELLS_TEXT, false},     {"Size", NULL, CELLS_TEXT, false},
        {"Failed", NULL, CELLS_NUMBER, true},     {"Values", NULL, CELLS_NUMBER, true},
        {"Benchmarks", NULL, CELLS_NUMBER, true}, {"Compiler", NULL, CELLS_TEXT, false},
        {"Processor", NULL, CELLS_WIDE, false},
    };
    const struct record_counts counts = records_count(site->records, NULL, NULL);
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (size_t i = 0; i < view->length; i++) {
        const bool own = i + 1 == view->length;
        const json_t *run = own ? site->records->run : json_array_get(view->runs, i);
        const bool checks = own || json_object_get(run, "failed") != NULL;
        const size_t failed =
            own ? counts.failed : (size_t)json_integer_value(json_object_get(run, "failed"));
        const size_t values =
            own ? known_values(site->records) : json_object_size(json_object_get(run, "values"));
        const size_t benchmarks =
            json_object_size(json_object_get(own ? site->history : run, "benchmarks"));
        report_table_number(table, (double)i + 1, g_strdup_printf("%zu", i + 1));
        report_table_text(table, record_text(run, "revision"));
        report_table_text(table, record_text(run, "started"));
        report_table_text(table, record_text(run, "tier"));
        add_count_of_checks(table, checks, failed);
        add_count_of_checks(table, checks, values);
        report_table_number(table, (double)benchmarks, g_strdup_printf("%zu", benchmarks));
        report_table_text(table, record_text(run, "compiler"));
        report_table_text(table, record_text(run, "processor"));
    }
    g_string_append(html, "<h2 id=\"runs\">Runs</h2>\n");
    report_site_table(site, table, "The runs, oldest first; the last is this report’s",
                      "history-runs.csv", html);
}

static void add_step(struct report_table *table, const struct history_view *view,
                     const struct series *series, const struct series_step *step)
{
    const double before = series->numbers[step->from], after = series->numbers[step->to];
    add_name(table, series);
    report_table_text(table, revision_of(view, step->to));
    report_table_number(table, before, text_quantity(before, series->unit));
    report_table_number(table, after, text_quantity(after, series->unit));
    add_percent(table, step->change);
    add_percent(table, series->noise);
    add_course(table, view, series);
}

static size_t add_steps_of(struct report_table *table, const struct history_view *view,
                           const GArray *all)
{
    size_t count = 0;
    for (unsigned i = 0; i < all->len; i++) {
        const struct series *series = &g_array_index(all, struct series, i);
        for (size_t s = 0; s < series->step_count; s++, count++)
            add_step(table, view, series, &series->steps[s]);
    }
    return count;
}

static void add_steps(GString *html, struct report_site *site, const struct history_view *view)
{
    static const struct report_column columns[] = {
        {"Check or benchmark", NULL, CELLS_TEXT, false},
        {"At revision", NULL, CELLS_TEXT, false},
        {"Before", NULL, CELLS_NUMBER, false},
        {"After", NULL, CELLS_NUMBER, false},
        {"Change", "%", CELLS_NUMBER, true},
        {"Noise", "%", CELLS_NUMBER, true},
        {"Course", NULL, CELLS_TEXT, false},
    };
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    const size_t count =
        add_steps_of(table, view, view->checks) + add_steps_of(table, view, view->benchmarks);
    g_string_append(html, "<h2 id=\"steps\">Steps</h2>\n");
    if (count > 0) {
        report_site_table(site, table, "Every step, and the revision at which it is first seen",
                          "history-steps.csv", html);
        return;
    }
    g_string_append(html, "<p class=\"notice good\">No value and no benchmark steps.</p>\n");
    report_table_free(table);
}

static void add_courses(GString *html, struct report_site *site, const struct history_view *view,
                        const GArray *all, const char *caption, const char *csv)
{
    static const struct report_column columns[] = {
        {"Name", NULL, CELLS_TEXT, false},  {"Oldest", NULL, CELLS_NUMBER, false},
        {"Now", NULL, CELLS_NUMBER, false}, {"Steps", NULL, CELLS_NUMBER, true},
        {"Noise", "%", CELLS_NUMBER, true}, {"Course", NULL, CELLS_TEXT, false},
    };
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (unsigned i = 0; i < all->len; i++) {
        const struct series *series = &g_array_index(all, struct series, i);
        const double first = series->numbers[0], last = series->numbers[view->length - 1];
        add_name(table, series);
        report_table_number(table, first, text_quantity(first, series->unit));
        report_table_number(table, last, text_quantity(last, series->unit));
        report_table_number(table, (double)series->step_count,
                            g_strdup_printf("%zu", series->step_count));
        add_percent(table, series->noise);
        add_course(table, view, series);
    }
    report_site_table(site, table, caption, csv, html);
}

static void add_all_courses(GString *html, struct report_site *site,
                            const struct history_view *view)
{
    if (view->benchmarks->len > 0) {
        g_string_append(html, "<h2 id=\"benchmarks\">Benchmarks</h2>\n");
        add_courses(html, site, view, view->benchmarks, "Every benchmark over the runs",
                    "history-benchmarks.csv");
    }
    if (view->checks->len == 0)
        return;
    /* thousands of rows: closed, they cost a reader and a browser nothing */
    g_string_append_printf(html,
                           "<h2 id=\"values\">Values of checks</h2>\n<details>"
                           "<summary>The course of each of %u values</summary>\n",
                           view->checks->len);
    add_courses(html, site, view, view->checks, "Every check’s value over the runs",
                "history-checks.csv");
    g_string_append(html, "</details>\n");
}

static void add_rule(GString *html)
{
    g_string_append_printf(
        html,
        "<p class=\"lead\">Values of the checks and benchmarks over earlier runs.</p>\n<p "
        "class=\"about\">A step is a change from one run to the next that is more than %.0f times "
        "the noise of its series, and more than %.1f %% of a check’s value or %.0f %% of a "
        "benchmark. The noise is the median of all changes of the series; with fewer than %d "
        "changes it is taken as zero. Changes are relative to the larger number. Benchmarks of "
        "different machines are not comparable: see the processors below.</p>\n",
        SERIES_NOISES, 100 * SERIES_LEAST_VALUE, 100 * SERIES_LEAST_TIME, SERIES_CHANGES);
}

void report_history_page(struct report_site *site)
{
    if (site->history == NULL)
        return;
    struct history_view view = {
        .runs = json_object_get(site->history, "runs"),
        .length = history_length(site->history),
        .own = record_text(site->records->run, "revision"),
        .checks = g_array_new(FALSE, TRUE, sizeof(struct series)),
        .benchmarks = g_array_new(FALSE, TRUE, sizeof(struct series)),
    };
    GString *html = g_string_new("<h1>History</h1>\n");
    g_array_set_clear_func(view.checks, clear_series);
    g_array_set_clear_func(view.benchmarks, clear_series);
    gather_checks(&view, site);
    gather_benchmarks(&view, site->history);
    add_rule(html);
    add_runs(html, site, &view);
    add_steps(html, site, &view);
    add_all_courses(html, site, &view);
    g_array_unref(view.benchmarks);
    g_array_unref(view.checks);
    report_site_page(site, "history.html", "History", html);
}

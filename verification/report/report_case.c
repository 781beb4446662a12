/* The page of a case: problem, pictures, checks, commands, runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/html.h"
#include "verification/pages/markdown.h"
#include "verification/records/check_text.h"
#include "verification/report/report_site.h"
#include "verification/report/verdict_html.h"

#include <math.h>
#include <string.h>

static void add_head(GString *html, const struct report_site *site, const json_t *entry,
                     const char *scene)
{
    const struct records *records = site->records;
    const struct record_counts counts = records_count(records, NULL, record_text(entry, "case"));
    text_markup(html, "<h1 class=\"verdict %s\">%s: %s</h1>\n<p class=\"lead\">%s</p>\n",
                counts.failed > 0 ? "bad" : "good", record_text(entry, "case"),
                record_text(entry, "title"), record_text(entry, "summary"));
    html_counts(html, &counts);
    g_string_append(html, scene);
    if (json_is_object(json_object_get(entry, "comparison")))
        g_string_append(html, "<p><a href=\"comparison.html\">Its variants compared</a>: which to "
                              "use for what</p>\n");
    static const struct {
        const char *place, *title;
    } parts[] = {{"pictures", "Pictures"}, {"text", "Problem, source, criterion"},
                 {"checks", "Checks"},     {"cite", "Cite and reproduce"},
                 {"data", "Data"},         {"runs", "Runs"}};
    const bool pictures = json_array_size(json_object_get(entry, "figures")) > 0;
    g_string_append(html, "<nav aria-label=\"On this page\"><ul class=\"here\">");
    for (size_t i = pictures ? 0 : 1; i < G_N_ELEMENTS(parts); i++)
        text_markup(html, "<li><a href=\"#%s\">%s</a></li>", parts[i].place, parts[i].title);
    g_string_append(html, "</ul></nav>\n");
}

/* After the pictures: they show what it explains. */
static void add_readme(GString *html, const struct report_site *site, const json_t *entry)
{
    char *readme = markdown_html(record_text(entry, "readme"), site->style->equations);
    g_string_append_printf(html, "<section class=\"readme\" id=\"text\">\n%s</section>\n", readme);
    g_free(readme);
}

/* ------------------------------------------------------------------- figures */

/* px; a figure that is wider has both columns. */
enum { COLUMN_WIDTH = 780 };

static void add_figure(GString *html, const json_t *figure, const struct figure_result *result)
{
    const char *title = record_text(figure, "title");
    if (result->state == FIGURE_DRAWN)
        text_markup(html,
                    "<figure class=\"wide%s\" tabindex=\"0\">\n<img src=\"figure-%s.svg\" "
                    "width=\"%d\" height=\"%d\" "
                    "alt=\"%s. %s\" />\n",
                    result->width > COLUMN_WIDTH ? " whole" : "", record_text(figure, "figure"),
                    result->width, result->height, title, record_text(figure, "caption"));
    else
        text_markup(html, "<figure>\n<p class=\"notice%s\"><strong>%s</strong> %s</p>\n",
                    result->state == FIGURE_FAILED ? "" : " quiet",
                    result->state == FIGURE_FAILED ? "This figure could not be drawn."
                                                   : "This figure is not drawn:",
                    result->reason);
    text_markup(html,
                "<figcaption><strong>%s.</strong> %s<span class=\"about\">Reference: "
                "%s%s%s</span></figcaption>\n</figure>\n",
                title, record_text(figure, "caption"), record_text(figure, "reference"),
                result->note == NULL ? "" : ". ", result->note == NULL ? "" : result->note);
}

static void add_figures(GString *html, const json_t *entry, const struct figure_result *results)
{
    const json_t *figures = json_object_get(entry, "figures");
    if (json_array_size(figures) == 0)
        return;
    g_string_append(html, "<h2 id=\"pictures\">Pictures</h2>\n<div class=\"figures\">\n");
    for (int missing = 0; missing < 2; missing++) /* those that are not drawn come last */
        for (size_t i = 0; i < json_array_size(figures); i++)
            if ((results[i].state != FIGURE_DRAWN) == missing)
                add_figure(html, json_array_get(figures, i), &results[i]);
    g_string_append(html, "</div>\n");
}

/* --------------------------------------------------------------------- checks */

static void add_declaration(GString *html, const json_t *check)
{
    const char *unit = record_text(check, "unit");
    const bool weakness = json_is_number(json_object_get(check, "fails_low"));
    text_markup(html,
                "<tr><th scope=\"rowgroup\" colspan=\"6\"><div class=\"stay\">%s "
                "<code>%s</code><span class=\"facts\">"
                "<span>Quantity <code>%s</code></span><span>Norm: %s</span><span>Expected: ",
                record_text(check, "title"), record_text(check, "check"),
                record_text(check, "quantity"), record_text(check, "norm"));
    html_numbers(html, text_quantity(record_number(check, "expected"), unit));
    if (weakness) {
        g_string_append(html, "</span><span>A good method: ");
        html_numbers(html,
                     text_range(record_number(check, "low"), record_number(check, "high"), unit));
    }
    text_markup(html, "</span><span>%s: ", weakness ? "Known weakness, fails in" : "Band");
    html_numbers(html, text_band(check));
    text_markup(html, "</span><span>Band from: %s</span>", record_text(check, "basis"));
    if (*record_text(check, "evidence") != '\0')
        text_markup(html, "<span>Evidence: %s</span>", record_text(check, "evidence"));
    text_markup(html, "</span><span class=\"why about\">%s</span></div></th></tr>\n",
                record_text(check, "why"));
}

/* A number as the text that sorts a cell; "" if it is not finite. */
static void add_key(GString *html, double value)
{
    char key[G_ASCII_DTOSTR_BUF_SIZE] = "";
    if (isfinite(value))
        g_ascii_formatd(key, sizeof key, "%.17g", value);
    g_string_append_printf(html, " data-key=\"%s\"", key);
}

static void add_check(GString *html, const json_t *check)
{
    const double red = record_number(check, "mutations_red");
    g_string_append(html, "<tr><th scope=\"row\">");
    html_name(html, record_text(check, "variant"));
    g_string_append(html, "</th><td");
    add_key(html, html_status_rank(record_status(check)));
    g_string_append_c(html, '>');
    html_status(html, record_status(check));
    g_string_append(html, "</td><td class=\"n\"");
    add_key(html, record_number(check, "value"));
    g_string_append_c(html, '>');
    html_numbers(html, text_value(check));
    g_string_append(html, "</td><td");
    add_key(html, record_number(check, "margin"));
    g_string_append_c(html, '>');
    html_margin(html, record_number(check, "margin"));
    g_string_append(html, "</td><td class=\"n\"");
    add_key(html, red);
    char *proof = g_strdup_printf("%.0f of %.0f", red, record_number(check, "mutations"));
    text_markup(html, ">%s</td><td class=\"wide\">%s</td></tr>\n", proof,
                record_text(check, "reason"));
    g_free(proof);
}

static GPtrArray *checks_of(const struct records *records, const char *name)
{
    GPtrArray *checks = g_ptr_array_new();
    for (size_t i = 0; i < json_array_size(records->checks); i++) {
        json_t *check = json_array_get(records->checks, i);
        if (strcmp(record_text(check, "case"), name) == 0)
            g_ptr_array_add(checks, check);
    }
    return checks;
}

static void add_checks(GString *html, const struct records *records, const char *name)
{
    const char *calculation = record_text(records_case(records, name), "calculation");
    GPtrArray *checks = checks_of(records, name);
    g_string_append(
        html,
        "<h2 id=\"checks\">Checks</h2>\n<p class=\"about\">Each check with its band and the "
        "reason for it, then one row per variant; a heading sorts within each check. “Proven” "
        "counts the spoiled results that turned the check red on this run.</p>\n");
    if (*calculation != '\0')
        text_markup(html, "<p class=\"about\">Independent calculation: %s</p>\n", calculation);
    g_string_append(
        html,
        "<div class=\"scroll tall\" tabindex=\"0\" role=\"region\" aria-label=\"Checks\"><table "
        "class=\"sortable groups\">\n<thead><tr><th scope=\"col\">Variant</th>"
        "<th scope=\"col\">Status</th><th scope=\"col\" class=\"n\">Value</th>"
        "<th scope=\"col\">Margin</th><th scope=\"col\" class=\"n\" data-first=\"descending\">"
        "Proven</th><th scope=\"col\">Remark</th></tr></thead>\n");
    for (unsigned i = 0; i < checks->len; i++) {
        if (checks->pdata[i] == NULL)
            continue;
        const json_t *first = checks->pdata[i];
        g_string_append(html, "<tbody class=\"group\">\n");
        add_declaration(html, first);
        for (unsigned j = i; j < checks->len; j++)
            if (checks->pdata[j] != NULL && record_same_declaration(first, checks->pdata[j])) {
                add_check(html, checks->pdata[j]);
                checks->pdata[j] = NULL;
            }
        g_string_append(html, "</tbody>\n");
    }
    g_string_append(html, "</table></div>\n<p class=\"csv\"><a "
                          "href=\"checks.csv\">checks.csv</a></p>\n");
    g_ptr_array_unref(checks);
}

/* Every fact of the checks of a case, a row for each variant. */
static char *checks_csv(const struct records *records, const char *name)
{
    static const char *const texts[] = {"case", "check",  "variant", "title",    "quantity", "unit",
                                        "norm", "status", "basis",   "evidence", "reason"};
    static const char *const numbers[] = {"value",     "expected",   "low",   "high",
                                          "fails_low", "fails_high", "margin"};
    GPtrArray *checks = checks_of(records, name);
    GString *csv = g_string_new(NULL);
    for (size_t i = 0; i < G_N_ELEMENTS(texts); i++)
        g_string_append_printf(csv, "%s\"%s\"", i == 0 ? "" : ",", texts[i]);
    for (size_t i = 0; i < G_N_ELEMENTS(numbers); i++)
        g_string_append_printf(csv, ",\"%s\"", numbers[i]);
    for (unsigned row = 0; row < checks->len; row++) {
        for (size_t i = 0; i < G_N_ELEMENTS(texts); i++) {
            g_string_append(csv, i == 0 ? "\r\n" : ",");
            report_csv_text(csv, record_text(checks->pdata[row], texts[i]));
        }
        for (size_t i = 0; i < G_N_ELEMENTS(numbers); i++) {
            char number[G_ASCII_DTOSTR_BUF_SIZE] = "";
            const double value = record_number(checks->pdata[row], numbers[i]);
            if (isfinite(value))
                g_ascii_formatd(number, sizeof number, "%.17g", value);
            g_string_append_printf(csv, ",%s", number);
        }
    }
    g_string_append(csv, "\r\n");
    g_ptr_array_unref(checks);
    return g_string_free(csv, FALSE);
}

/* A file in the folder of the case. */
static void add_file(struct report_site *site, const json_t *entry, const char *name, char *text)
{
    char *path = g_strdup_printf("cases/%s/%s", record_text(entry, "case"), name);
    report_site_file(site, path, text);
    g_free(path);
}

/* ----------------------------------------------------------------------- runs */

static bool is_full(const json_t *variant)
{
    return strcmp(record_text(variant, "tier"), "full") == 0;
}

/* An array of texts, one below the other. */
static void add_lines(GString *html, const json_t *texts, const char *element)
{
    for (size_t i = 0; i < json_array_size(texts); i++) {
        g_string_append_printf(html, "%s<%s>", i == 0 ? "" : "<br />", element);
        html_name(html, json_string_value(json_array_get(texts, i)));
        g_string_append_printf(html, "</%s>", element);
    }
}

static char *joined(const json_t *texts)
{
    GString *text = g_string_new(NULL);
    for (size_t i = 0; i < json_array_size(texts); i++)
        g_string_append_printf(text, "%s%s", i == 0 ? "" : "; ",
                               json_string_value(json_array_get(texts, i)));
    return g_string_free(text, FALSE);
}

/* Texts as a cell: as lines in the page, joined in CSV. */
static void add_texts(struct report_table *table, const json_t *texts, const char *element,
                      GString *after)
{
    GString *markup = g_string_new(NULL);
    char *text = joined(texts);
    add_lines(markup, texts, element);
    g_string_append(markup, after->str);
    report_table_markup(table, text, markup);
    g_string_free(after, TRUE);
    g_free(text);
}

static GString *log_end(const json_t *variant)
{
    GString *html = g_string_new(NULL);
    const bool returned = strcmp(record_text(variant, "outcome"), "returned") == 0;
    const char *log = record_text(variant, "log_tail");
    if (!returned && *log != '\0')
        text_markup(
            html, "<details open=\"open\"><summary>End of the log</summary><pre>%s</pre></details>",
            log);
    return html;
}

static void add_variant(struct report_table *table, const json_t *variant)
{
    const double work = record_number(variant, "particle_steps");
    const double seconds = record_number(variant, "seconds");
    const double known = work > 0 ? work : (double)NAN;
    const double rate = seconds > 0 ? known / seconds : (double)NAN;
    report_table_name(table, record_text(variant, "variant"));
    add_texts(table, json_object_get(variant, "settings"), "code", g_string_new(NULL));
    report_table_text(table, record_text(variant, "outcome"));
    report_table_number(table, seconds, text_seconds(seconds));
    report_table_number(table, known, work > 0 ? text_number(work) : g_strdup(""));
    report_table_number(table, rate, isfinite(rate) ? text_number(rate) : g_strdup(""));
    add_texts(table, json_object_get(variant, "notes"), "span", log_end(variant));
}

static void add_variants(GString *html, struct report_site *site, const json_t *entry)
{
    static const struct report_column columns[] = {
        {"Variant", NULL, CELLS_TEXT, false},         {"Settings", NULL, CELLS_TEXT, false},
        {"Program", NULL, CELLS_TEXT, false},         {"Time", NULL, CELLS_NUMBER, true},
        {"Particle-steps", NULL, CELLS_NUMBER, true}, {"Rate", "1/s", CELLS_NUMBER, true},
        {"Notes", NULL, CELLS_WIDE, false},
    };
    const json_t *variants = json_object_get(entry, "variants");
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (size_t i = 0; i < json_array_size(variants); i++)
        add_variant(table, json_array_get(variants, i));
    g_string_append(html, "<h2 id=\"runs\">Runs</h2>\n<p class=\"about\">One process per variant. "
                          "Times, in s in the CSV, are shown, never judged.</p>\n");
    report_table_html(table, "Runs of this case", "runs.csv", html);
    add_file(site, entry, "runs.csv", report_table_csv(table));
    report_table_free(table);
}

static void add_commands(GString *html, const json_t *entry, const json_t *run)
{
    const json_t *variants = json_object_get(entry, "variants");
    g_string_append(html, "<h3 id=\"reproduce\">Commands</h3>\n");
    if (!json_is_true(json_object_get(run, "score")))
        text_markup(html,
                    "<p class=\"about\">In a checkout of revision %s, <code>make</code> builds "
                    "<code>build/release/bin/mpm-verify</code>. The first command runs the whole "
                    "case, each of the next one variant, the last states what is checked and "
                    "why.</p>\n<pre tabindex=\"0\"><code>mpm-verify run --tier %s --case %s "
                    "--output DIR\n",
                    record_text(run, "revision"), record_text(run, "tier"),
                    record_text(entry, "case"));
    else
        g_string_append(html, "<pre tabindex=\"0\"><code>");
    for (size_t i = 0; i < json_array_size(variants); i++) {
        const json_t *variant = json_array_get(variants, i);
        char *command = text_command(record_text(entry, "case"), record_text(variant, "variant"),
                                     is_full(variant), run);
        text_markup(html, "%s\n", command);
        g_free(command);
    }
    char *name = g_strdup_printf("%s/*", record_text(entry, "case"));
    text_markup(html, "mpm-verify explain '%s'\n</code></pre>\n", name);
    g_free(name);
}

/* What to write where the case is referred to. */
static void add_citation(GString *html, const json_t *entry, const json_t *run)
{
    const char *name = record_text(entry, "case"), *started = record_text(run, "started");
    char *day = g_strndup(started, 10); /* the date of ISO 8601 */
    text_markup(
        html,
        "<h2 id=\"cite\">Cite and reproduce</h2>\n<p class=\"cite\">Touchstone %s, case %s: "
        "%s. Revision %s, size %s, run of %s, %s. Page <code>cases/%s/index.html</code> of "
        "the verification report.</p>\n<p class=\"about\">The address of the page and of its "
        "parts stays the same from report to report; the revision states which solver it "
        "is about.</p>\n",
        record_text(run, "version"), name, record_text(entry, "title"),
        record_text(run, "revision"), record_text(run, "tier"), day, record_text(run, "compiler"),
        name);
    g_free(day);
}

static void add_data(GString *html, const GPtrArray *files, bool compares)
{
    static const char *const always[][2] = {
        {"checks.csv", "every check of this case"},
        {"runs.csv", "its runs"},
        {"../../checks.jsonl", "all checks of the whole run, with its provenance"},
    };
    g_string_append(html, "<h2 id=\"data\">Data</h2>\n<ul class=\"pages\">\n");
    for (size_t i = 0; i < G_N_ELEMENTS(always); i++)
        text_markup(html, "<li><a href=\"%s\">%s</a>: %s</li>\n", always[i][0],
                    strrchr(always[i][0], '/') == NULL ? always[i][0]
                                                       : strrchr(always[i][0], '/') + 1,
                    always[i][1]);
    if (compares)
        g_string_append(html, "<li><a href=\"comparison.csv\">comparison.csv</a>: the table of the "
                              "comparison</li>\n");
    g_string_append(html, "</ul>\n");
    if (files->len == 0)
        return;
    g_string_append_printf(html,
                           "<details><summary>%u files that the runs wrote: curves "
                           "(.dat), reported values (.jsonl), and what pictures show "
                           "(.json)</summary>\n<ul class=\"files\">\n",
                           files->len);
    for (unsigned i = 0; i < files->len; i++)
        text_markup(html, "<li><a href=\"%s\">%s</a></li>\n", (const char *)files->pdata[i],
                    (const char *)files->pdata[i]);
    g_string_append(html, "</ul></details>\n");
}

char *report_case(struct report_site *site, const json_t *entry, const char *scene,
                  const struct figure_result *figures, const GPtrArray *files)
{
    GString *html = g_string_new(NULL), *navigation = g_string_new(NULL);
    const struct records *records = site->records;
    const char *name = record_text(entry, "case");
    report_site_links(navigation, site, "../../", NULL);
    text_markup(navigation,
                "<p class=\"path\"><a href=\"../../index.html#cases\">family %s</a> / %s</p>",
                record_text(entry, "family"), name);
    add_head(html, site, entry, scene);
    add_figures(html, entry, figures);
    add_readme(html, site, entry);
    add_checks(html, records, name);
    add_file(site, entry, "checks.csv", checks_csv(records, name));
    add_citation(html, entry, records->run);
    add_commands(html, entry, records->run);
    add_data(html, files, json_is_object(json_object_get(entry, "comparison")));
    add_variants(html, site, entry);
    char *title = g_strdup_printf("%s: %s", name, record_text(entry, "title"));
    char *page = html_page(records, site->style, title, navigation, html);
    g_free(title);
    return page;
}

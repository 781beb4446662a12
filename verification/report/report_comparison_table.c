/* The table of a comparison page: a row for each variant, what its columns are, what the parts of
 * names mean; and the same as CSV.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/record.h"
#include "verification/common/text.h"
#include "verification/measures/comparison/comparison_words.h"
#include "verification/pages/html.h"
#include "verification/report/comparison_view.h"
#include "verification/report/report.h"
#include "verification/report/report_table.h"

#include <math.h>
#include <string.h>

/* -------------------------------------------------------------------- heading */

static const char *better_words(enum comparison_better better)
{
    static const char *const words[] = {"less is better", "more is better", "zero is best"};
    return words[better];
}

static const json_t *declared_column(const struct comparison_view *view, size_t column)
{
    return json_array_get(json_object_get(view->declared, "columns"), column);
}

static void add_heading(GString *html, const struct comparison_view *view, size_t column)
{
    const struct comparison_column *rule = &view->columns[column];
    const char *other = record_text(declared_column(view, column), "case");
    const bool bare = strcmp(rule->unit, "1") == 0;
    text_markup(html,
                "<th scope=\"col\" class=\"n\" data-first=\"%s\">%s%s%s<span "
                "class=\"about\">%s%s%s</span></th>",
                rule->better == COMPARISON_HIGH ? "descending" : "ascending", rule->title,
                bare ? "" : ", ", bare ? "" : rule->unit, better_words(rule->better),
                *other == '\0' ? "" : "; case ", other);
}

static void add_head(GString *html, const struct comparison_view *view)
{
    g_string_append(html, "<thead><tr><th scope=\"col\" aria-sort=\"ascending\">Variant</th>"
                          "<th scope=\"col\">Run</th>");
    for (size_t column = 0; column < view->table.column_count; column++)
        if (!comparison_is_constant(&view->table, column))
            add_heading(html, view, column);
    g_string_append(html, "</tr></thead>\n");
}

/* ----------------------------------------------------------------------- rows */

/* Rank as a mark and words: no colour needed to tell the best. */
static char *standing_of(const struct comparison_table *table, size_t row, size_t column)
{
    const size_t level = comparison_level_count(table, column);
    if (comparison_is_beyond(table, row, column))
        return g_strdup("beyond the limit");
    if (!comparison_takes_part(table, row))
        return g_strdup("no rank");
    if (comparison_is_level(table, row, column))
        return g_strdup(level == 1                                 ? "★ best"
                        : level == comparison_count(table, column) ? "all equal"
                                                                   : "☆ equal best");
    const bool high = table->columns[column].better == COMPARISON_HIGH;
    char *factor = comparison_factor_words(table, row, column);
    char *rank = comparison_rank_words(table, row, column);
    const char *place = g_str_has_prefix(rank, "rank ") ? rank + strlen("rank ") : rank;
    char *text = g_strconcat(place,
                             *factor == '\0' ? ""
                             : high          ? ", ÷\u00a0"
                                             : ", ×\u00a0",
                             factor, NULL);
    g_free(rank);
    g_free(factor);
    return text;
}

static void add_missing(GString *html, const struct comparison_table *table, size_t row,
                        size_t column)
{
    const struct comparison_cell *cell = comparison_cell(table, row, column);
    const char *missing = table->columns[column].missing;
    const bool failed = cell->state == COMPARISON_FAILED && comparison_takes_part(table, row);
    const char *words = cell->state == COMPARISON_ABSENT ? "not measured"
                        : !failed || *missing == '\0'    ? "no number"
                                                         : missing;
    text_markup(html,
                "<td class=\"n\" data-key=\"\" title=\"%s\"><span class=\"%s\"><span "
                "aria-hidden=\"true\">%s</span> %s</span></td>",
                cell->reason, failed ? "bad" : "idle", failed ? "✗" : "–", words);
}

void comparison_cell_html(GString *html, const struct comparison_table *table, size_t row,
                          size_t column, bool bad, char *words)
{
    const double value = comparison_cell(table, row, column)->value;
    /* who takes no part stays last in any order */
    char key[G_ASCII_DTOSTR_BUF_SIZE] = "";
    const bool zero = table->columns[column].better == COMPARISON_ZERO;
    if (comparison_takes_part(table, row))
        g_ascii_formatd(key, sizeof key, "%.17g", zero ? fabs(value) : value);
    text_markup(html, "<td class=\"n\" data-key=\"%s\">", key);
    html_numbers(html, comparison_number(value, "1"));
    g_string_append(html, bad ? "<span class=\"about bad\">✗ " : "<span class=\"about\">");
    html_numbers(html, words);
    g_string_append(html, "</span></td>");
}

static void add_cell(GString *html, const struct comparison_table *table, size_t row, size_t column)
{
    if (comparison_cell(table, row, column)->state == COMPARISON_NUMBER)
        comparison_cell_html(html, table, row, column, comparison_is_beyond(table, row, column),
                             standing_of(table, row, column));
    else
        add_missing(html, table, row, column);
}

static void add_outcome(GString *html, const struct comparison_view *view, size_t row)
{
    const char *outcome = record_text(view->variants[row], "outcome");
    const bool good = comparison_takes_part(&view->table, row);
    const bool returned = strcmp(outcome, "returned") == 0;
    g_string_append_printf(html,
                           "<td class=\"run\"><span class=\"%s\"><span class=\"mark\" "
                           "aria-hidden=\"true\">%s</span> ",
                           good ? "good" : "bad", good ? "✓" : "✗");
    html_numbers(html, returned ? comparison_run_words(&view->table, row) : g_strdup(outcome));
    g_string_append(html, "</span></td>");
}

/* A name may be broken after each underscore. */
static void add_name(GString *html, const char *name)
{
    char **parts = g_strsplit(name, "_", -1);
    for (char **part = parts; *part != NULL; part++)
        text_markup(html, part[1] == NULL ? "%s" : "%s_<wbr />", *part);
    g_strfreev(parts);
}

static void add_row(GString *html, const struct comparison_view *view, size_t row)
{
    const char *name = view->names[row], *title = record_text(view->variants[row], "title");
    char *number = g_strdup_printf("%zu", row + 1);
    text_markup(html,
                "<tr><th scope=\"row\" data-name=\"%s\" data-key=\"%s\"><span "
                "class=\"number\">%s</span> <a href=\"#%s\">",
                name, number, number, name);
    add_name(html, name);
    text_markup(html, "</a><span class=\"about\">%s</span></th>", title);
    add_outcome(html, view, row);
    for (size_t column = 0; column < view->table.column_count; column++)
        if (!comparison_is_constant(&view->table, column))
            add_cell(html, &view->table, row, column);
    g_string_append(html, "</tr>\n");
    g_free(number);
}

/* -------------------------------------------------------------- what it means */

/* The columns without information, in one sentence. */
static void add_left_out(GString *html, const struct comparison_view *view)
{
    const struct comparison_table *table = &view->table;
    GString *text = g_string_new(NULL);
    for (size_t column = 0; column < table->column_count; column++) {
        if (!comparison_is_constant(table, column))
            continue;
        const size_t best = comparison_best(table, column);
        char *number = comparison_number(comparison_cell(table, best, column)->value,
                                         table->columns[column].unit);
        text_markup(text, "%s%s (%s)", text->len == 0 ? "" : ", ", table->columns[column].title,
                    number);
        g_free(number);
    }
    if (text->len > 0)
        g_string_append_printf(html,
                               "<p class=\"about\">Left out, the same for every valid run: "
                               "%s.</p>\n",
                               text->str);
    g_string_free(text, TRUE);
}

/* "less is better; equal within 20 % or 0.001 %; at most 5 %" */
static char *rules_of(const struct comparison_column *rule)
{
    char *percent = comparison_number(100 * rule->tolerance, "%");
    char *least = comparison_number(rule->floor, rule->unit);
    char *limit = comparison_number(rule->limited ? rule->limit : 0, rule->unit);
    char *text = g_strdup_printf("%s; equal within %s%s%s%s%s", better_words(rule->better), percent,
                                 rule->floor > 0 ? " or " : "", rule->floor > 0 ? least : "",
                                 !rule->limited                    ? ""
                                 : rule->better == COMPARISON_HIGH ? "; counts from "
                                                                   : "; counts up to ",
                                 rule->limited ? limit : "");
    g_free(limit);
    g_free(least);
    g_free(percent);
    return text;
}

static void add_definitions(GString *html, const struct comparison_view *view)
{
    g_string_append(html, "<h3>The columns</h3>\n<dl class=\"facts\">\n");
    for (size_t column = 0; column < view->table.column_count; column++) {
        const char *about = record_text(declared_column(view, column), "about");
        const char *other = record_text(declared_column(view, column), "case");
        text_markup(html, "<dt>%s</dt><dd>%s%s", view->columns[column].title, about,
                    *about == '\0' ? "" : " ");
        g_string_append(html, "<span class=\"rule\">");
        html_numbers(html, rules_of(&view->columns[column]));
        if (records_case(view->records, other) != NULL)
            text_markup(html, "; from case <a href=\"../%s/index.html\">%s</a>", other, other);
        else if (*other != '\0') /* the run was of fewer cases */
            text_markup(html, "; from case %s", other);
        g_string_append(html, "</span></dd>\n");
    }
    g_string_append(html, "</dl>\n");
}

/* The parts of names that occur on this page. */
static void add_legend(GString *html, const struct comparison_view *view)
{
    const json_t *parts = json_object_get(view->declared, "parts");
    bool any = false;
    for (size_t i = 0; i < json_array_size(parts); i++) {
        const json_t *part = json_array_get(parts, i);
        bool used = false;
        for (size_t row = 0; !used && row < view->table.row_count; row++)
            used = comparison_view_has_part(view->names[row], part);
        if (!used)
            continue;
        if (!any)
            g_string_append(html, "<h3>The parts of names</h3>\n<dl class=\"facts\">\n");
        any = true;
        char *shown = g_strdelimit(g_strdup(record_text(part, "part")), "?", 'N');
        text_markup(html, "<dt><code>%s</code></dt><dd>%s</dd>\n", shown,
                    record_text(part, "title"));
        g_free(shown);
    }
    g_string_append(html, any ? "</dl>\n" : "");
}

void comparison_table_html(GString *html, const struct comparison_view *view)
{
    g_string_append(
        html,
        "<h2 id=\"table\">Every variant</h2>\n<p class=\"about\" id=\"how\">Run: valid is to its "
        "end "
        "and within every limit; others have no rank and stay last. A heading sorts, best first; "
        "again turns round. Under each number: its rank among the valid runs, and how "
        "many "
        "times the best it is (×) or, where more is better, the best is it (÷); where the best is "
        "smaller than the difference that counts as equal, how many times that.</p>\n<div "
        "class=\"scroll tall\" tabindex=\"0\" role=\"region\" aria-label=\"Every variant\"><table "
        "class=\"sortable\" aria-describedby=\"how\">\n");
    add_head(html, view);
    g_string_append(html, "<tbody>\n");
    for (size_t row = 0; row < view->table.row_count; row++)
        add_row(html, view, row);
    g_string_append(html, "</tbody>\n</table></div>\n");
    add_left_out(html, view);
    g_string_append(html,
                    "<p class=\"about\"><a href=\"comparison.csv\">The table as CSV</a>, with "
                    "all digits and every column</p>\n");
    add_definitions(html, view);
    add_legend(html, view);
}

/* ------------------------------------------------------------------------ csv */

static void csv_row(GString *csv, const struct comparison_view *view, size_t row)
{
    const struct comparison_table *table = &view->table;
    GString *missing = g_string_new(NULL);
    report_csv_text(csv, view->names[row]);
    g_string_append_c(csv, ',');
    report_csv_text(csv, record_text(view->variants[row], "outcome"));
    for (size_t column = 0; column < table->column_count; column++) {
        const struct comparison_cell *cell = comparison_cell(table, row, column);
        char number[G_ASCII_DTOSTR_BUF_SIZE] = "";
        if (cell->state == COMPARISON_NUMBER)
            g_ascii_formatd(number, sizeof number, "%.17g", cell->value);
        else
            g_string_append_printf(missing, "%s%s: %s", missing->len == 0 ? "" : "; ",
                                   table->columns[column].title, cell->reason);
        g_string_append_printf(csv, ",%s", number);
    }
    g_string_append_c(csv, ',');
    report_csv_text(csv, missing->str);
    g_string_append(csv, "\r\n");
    g_string_free(missing, TRUE);
}

char *comparison_csv(const struct comparison_view *view)
{
    GString *csv = g_string_new("\"variant\",\"run\"");
    for (size_t column = 0; column < view->table.column_count; column++) {
        char *title =
            g_strdup_printf("%s (%s)", view->columns[column].title, view->columns[column].unit);
        g_string_append_c(csv, ',');
        report_csv_text(csv, title);
        g_free(title);
    }
    g_string_append(csv, ",\"missing\"\r\n");
    for (size_t row = 0; row < view->table.row_count; row++)
        csv_row(csv, view, row);
    return g_string_free(csv, FALSE);
}

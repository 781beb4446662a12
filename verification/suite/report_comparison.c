/* The page of a comparison: which variant to use for what, a picture, the table, and where
 * each variant loses.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison_words.h"
#include "verification/suite/comparison_view.h"
#include "verification/suite/html.h"

#include <math.h>
#include <string.h>

/* ------------------------------------------------------------------- summary */

static const char *better_words(enum comparison_better better)
{
    static const char *const words[] = {"less is better", "more is better", "zero is best"};
    return words[better];
}

/* "less is better", and where the column is from if not from this case. */
static char *column_about(const struct comparison_view *view, size_t column)
{
    const json_t *declared = json_array_get(json_object_get(view->declared, "columns"), column);
    const char *other = record_text(declared, "case");
    return g_strconcat(better_words(view->columns[column].better), *other == '\0' ? "" : "; case ",
                       other, NULL);
}

static void add_fact(GString *html, const char *term, char *text)
{
    if (*text != '\0') {
        text_markup(html, "<dt>%s</dt><dd>", term);
        html_numbers(html, text);
        g_string_append(html, "</dd>\n");
    } else {
        g_free(text);
    }
}

static void add_summary(GString *html, const struct comparison_view *view)
{
    const struct comparison_table *table = &view->table;
    g_string_append(html, "<h2 id=\"which\">Which to use for what</h2>\n<dl class=\"facts\">\n");
    add_fact(html, "For everything at once", comparison_all_round_words(table));
    add_fact(html, "On the front", comparison_front_names(table));
    for (size_t column = 0; column < table->column_count; column++) {
        char *advice = comparison_advice(table, column);
        add_fact(html, table->columns[column].title,
                 *advice == '\0' ? g_strdup("no number in this run") : g_strdup(advice));
        g_free(advice);
    }
    g_string_append(html, "</dl>\n<p class=\"about\">The front: variants for which there is no "
                          "other that is nowhere worse and somewhere better. Equal: within the "
                          "tolerance stated below the table.</p>\n");
}

/* ------------------------------------------------------------------- picture */

static void add_picture(GString *html, const struct comparison_view *view,
                        const struct figure_result *picture)
{
    if (picture->state == FIGURE_WITHOUT_DATA && *picture->reason == '\0')
        return;
    g_string_append(html, "<figure>\n");
    if (picture->state == FIGURE_DRAWN)
        text_markup(html,
                    "<img src=\"figure-comparison.svg\" width=\"760\" height=\"470\" alt=\"%s: "
                    "one quantity over the other for every variant; the table below has the "
                    "numbers\" />\n",
                    record_text(view->declared, "title"));
    else
        text_markup(html,
                    "<p class=\"notice%s\"><strong>The picture is not drawn:</strong> %s</p>\n",
                    picture->state == FIGURE_FAILED ? "" : " quiet", picture->reason);
    g_string_append(html,
                    "<figcaption>Blue, joined and named: variants that no other beats in both "
                    "quantities. Grey rings: the others.</figcaption>\n</figure>\n");
}

/* --------------------------------------------------------------------- table */

static void add_heading(GString *html, const struct comparison_view *view, size_t column)
{
    const struct comparison_column *rule = &view->columns[column];
    char *about = column_about(view, column);
    const bool bare = strcmp(rule->unit, "1") == 0;
    text_markup(html,
                "<th scope=\"col\" class=\"n\" data-first=\"%s\">%s%s%s<span "
                "class=\"about\">%s</span></th>",
                rule->better == COMPARISON_HIGH ? "descending" : "ascending", rule->title,
                bare ? "" : ", ", bare ? "" : rule->unit, about);
    g_free(about);
}

static void add_head(GString *html, const struct comparison_view *view)
{
    g_string_append(html, "<thead><tr><th scope=\"col\" aria-sort=\"ascending\">Variant</th>"
                          "<th scope=\"col\">Run</th>");
    for (size_t column = 0; column < view->table.column_count; column++)
        add_heading(html, view, column);
    g_string_append(html, "</tr></thead>\n");
}

/* Rank as a mark and words: no colour needed to tell the best. */
static void add_standing(GString *html, const struct comparison_table *table, size_t row,
                         size_t column)
{
    const size_t best = comparison_best(table, column);
    const int order =
        comparison_order(&table->columns[column], comparison_cell(table, best, column),
                         comparison_cell(table, row, column));
    if (order >= 0) {
        text_markup(html, "<span class=\"about\"><span aria-hidden=\"true\">%s</span> %s</span>",
                    row == best ? "★" : "☆", row == best ? "best" : "equal");
        return;
    }
    const double factor = comparison_factor(table, row, column);
    const bool high = table->columns[column].better == COMPARISON_HIGH;
    char *times = isfinite(factor) ? comparison_number(factor, "1") : g_strdup("");
    char *rank = g_strdup_printf("rank %zu%s%s", comparison_rank(table, row, column),
                                 *times == '\0' ? ""
                                 : high         ? ", ÷ "
                                                : ", × ",
                                 times);
    g_string_append(html, "<span class=\"about\">");
    html_numbers(html, rank);
    g_string_append(html, "</span>");
    g_free(times);
}

static void add_cell(GString *html, const struct comparison_table *table, size_t row, size_t column)
{
    const struct comparison_cell *cell = comparison_cell(table, row, column);
    const bool failed = cell->state == COMPARISON_FAILED;
    if (cell->state != COMPARISON_NUMBER) {
        text_markup(html,
                    "<td class=\"n\" data-key=\"\"><span class=\"%s\"><span "
                    "aria-hidden=\"true\">%s</span> %s</span></td>",
                    failed ? "bad" : "idle", failed ? "✗" : "–",
                    failed ? "failed" : "not measured");
        return;
    }
    char key[G_ASCII_DTOSTR_BUF_SIZE];
    const bool zero = table->columns[column].better == COMPARISON_ZERO;
    g_ascii_formatd(key, sizeof key, "%.17g", zero ? fabs(cell->value) : cell->value);
    text_markup(html, "<td class=\"n\" data-key=\"%s\">", key);
    html_numbers(html, comparison_number(cell->value, "1"));
    add_standing(html, table, row, column);
    g_string_append(html, "</td>");
}

static void add_outcome(GString *html, const json_t *variant)
{
    const char *outcome = record_text(variant, "outcome");
    const bool good = strcmp(outcome, "returned") == 0;
    text_markup(html,
                "<td><span class=\"state %s\"><span class=\"mark\" aria-hidden=\"true\">%s</span>"
                "%s</span></td>",
                good ? "good" : "bad", good ? "✓" : "✗", good ? "ran" : outcome);
}

static void add_row(GString *html, const struct comparison_view *view, size_t row)
{
    const char *name = view->names[row], *title = record_text(view->variants[row], "title");
    text_markup(html,
                "<tr><th scope=\"row\" data-name=\"%s\"><a href=\"#%s\">%s</a><span "
                "class=\"about\">%s</span></th>",
                name, name, name, title);
    add_outcome(html, view->variants[row]);
    for (size_t column = 0; column < view->table.column_count; column++)
        add_cell(html, &view->table, row, column);
    g_string_append(html, "</tr>\n");
}

static void add_tolerances(GString *html, const struct comparison_view *view)
{
    g_string_append(html, "<p class=\"about\">Counted as equal: ");
    for (size_t column = 0; column < view->table.column_count; column++) {
        const struct comparison_column *rule = &view->columns[column];
        char *percent = comparison_number(100 * rule->tolerance, "%");
        char *least = comparison_number(rule->floor, rule->unit);
        char *text =
            g_strdup_printf("%s%s within %s%s%s", column == 0 ? "" : "; ", rule->title, percent,
                            rule->floor > 0 ? " or " : "", rule->floor > 0 ? least : "");
        html_numbers(html, text);
        g_free(least);
        g_free(percent);
    }
    g_string_append(html, ". <a href=\"comparison.csv\">The table as CSV</a></p>\n");
}

static void add_table(GString *html, const struct comparison_view *view)
{
    g_string_append(
        html, "<h2 id=\"table\">Every variant</h2>\n<div class=\"scroll\" tabindex=\"0\" "
              "role=\"region\" aria-label=\"Every variant\"><table class=\"sortable\">\n"
              "<caption>A heading sorts, best first; again turns round. Under each number: its "
              "rank, and how many times the best it is (×) or, where more is better, the best is "
              "it (÷).</caption>\n");
    add_head(html, view);
    g_string_append(html, "<tbody>\n");
    for (size_t row = 0; row < view->table.row_count; row++)
        add_row(html, view, row);
    g_string_append(html, "</tbody>\n</table></div>\n");
    add_tolerances(html, view);
}

/* ----------------------------------------------------------------- sentences */

static void add_absences(GString *html, const struct comparison_view *view)
{
    const struct comparison_table *table = &view->table;
    for (size_t column = 0; column < table->column_count; column++) {
        for (size_t row = 0; row < table->row_count; row++) {
            const struct comparison_cell *cell = comparison_cell(table, row, column);
            if (cell->state == COMPARISON_ABSENT)
                text_markup(html, "<li>%s, %s: %s</li>\n", table->columns[column].title,
                            table->names[row], cell->reason);
        }
    }
}

static void add_sentences(GString *html, const struct comparison_view *view)
{
    g_string_append(html, "<h2 id=\"loses\">Where each one loses</h2>\n<dl class=\"words\">\n");
    for (size_t row = 0; row < view->table.row_count; row++) {
        text_markup(html, "<dt id=\"%s\">%s</dt><dd>", view->names[row], view->names[row]);
        html_numbers(html, comparison_sentence(&view->table, row));
        g_string_append(html, "</dd>\n");
    }
    g_string_append(html, "</dl>\n");
    GString *absences = g_string_new(NULL);
    add_absences(absences, view);
    if (absences->len > 0)
        g_string_append_printf(html,
                               "<details><summary>What was not measured, and why</summary>"
                               "<ul>\n%s</ul></details>\n",
                               absences->str);
    g_string_free(absences, TRUE);
}

/* ---------------------------------------------------------------------- page */

char *comparison_page(const struct records *records, const json_t *entry,
                      const struct comparison_view *view, const struct figure_result *picture,
                      const struct report_style *style)
{
    const char *name = record_text(entry, "case"), *said = record_text(view->declared, "title");
    GString *html = g_string_new(NULL), *navigation = g_string_new(NULL);
    text_markup(navigation,
                "<a href=\"../../index.html\"><strong>Touchstone</strong> verification report</a> "
                "/ family %s / <a href=\"index.html\">%s</a> / comparison",
                record_text(entry, "family"), name);
    text_markup(html, "<h1>%s: %s</h1>\n<p class=\"lead\">%s</p>\n", name, said,
                *record_text(view->declared, "summary") == '\0'
                    ? record_text(entry, "summary")
                    : record_text(view->declared, "summary"));
    add_summary(html, view);
    add_picture(html, view, picture);
    add_table(html, view);
    add_sentences(html, view);
    g_string_append_printf(html, "<script>\n%s</script>\n", style->script);
    char *title = g_strdup_printf("%s: %s", name, said);
    char *page = html_page(records, style, title, navigation, html);
    g_free(title);
    return page;
}

/* Quoted as RFC 4180 says. */
static void csv_field(GString *csv, const char *text, bool first)
{
    g_string_append(csv, first ? "\"" : ",\"");
    for (const char *c = text; *c != '\0'; c++) {
        if (*c == '"')
            g_string_append_c(csv, '"');
        g_string_append_c(csv, *c);
    }
    g_string_append_c(csv, '"');
}

static void csv_row(GString *csv, const struct comparison_view *view, size_t row)
{
    const struct comparison_table *table = &view->table;
    GString *missing = g_string_new(NULL);
    csv_field(csv, view->names[row], true);
    csv_field(csv, record_text(view->variants[row], "outcome"), false);
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
    csv_field(csv, missing->str, false);
    g_string_append(csv, "\r\n");
    g_string_free(missing, TRUE);
}

char *comparison_csv(const struct comparison_view *view)
{
    GString *csv = g_string_new("\"variant\",\"run\"");
    for (size_t column = 0; column < view->table.column_count; column++) {
        char *title =
            g_strdup_printf("%s (%s)", view->columns[column].title, view->columns[column].unit);
        csv_field(csv, title, false);
        g_free(title);
    }
    g_string_append(csv, ",\"missing\"\r\n");
    for (size_t row = 0; row < view->table.row_count; row++)
        csv_row(csv, view, row);
    return g_string_free(csv, FALSE);
}

/* The page of a comparison: which variant to use, a picture, the table, and where each variant
 * loses.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison/comparison_guide.h"
#include "verification/measures/comparison/comparison_words.h"
#include "verification/pages/html.h"
#include "verification/report/comparison_plot.h"
#include "verification/report/comparison_view.h"
#include "verification/report/report_site.h"
#include "verification/report/verdict_html.h"

#include <string.h>

/* ------------------------------------------------------------------- summary */

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

/* A text from the numbers as a paragraph of that class; taken over. */
static void add_paragraph(GString *html, const char *class, const char *before, char *text)
{
    if (*text != '\0') {
        text_markup(html, "<p class=\"%s\">%s", class, before);
        html_numbers(html, text);
        g_string_append(html, "</p>\n");
    } else {
        g_free(text);
    }
}

static void add_notes(GString *html, const struct comparison_view *view)
{
    const json_t *notes = json_object_get(view->declared, "notes");
    if (json_array_size(notes) == 0)
        return;
    g_string_append(html, "<ul class=\"notes\">\n");
    for (size_t i = 0; i < json_array_size(notes); i++)
        text_markup(html, "<li>%s</li>\n", json_string_value(json_array_get(notes, i)));
    g_string_append(html, "</ul>\n");
}

static void add_columns(GString *html, const struct comparison_table *table)
{
    g_string_append(html, "<h3>The best in each column</h3>\n<dl class=\"facts\">\n");
    for (size_t column = 0; column < table->column_count; column++) {
        char *advice = comparison_advice(table, column);
        if (!comparison_is_constant(table, column))
            add_fact(html, table->columns[column].title,
                     *advice == '\0' ? g_strdup("no number in this run") : g_strdup(advice));
        g_free(advice);
    }
    add_fact(html, "On the front", comparison_front_names(table));
    g_string_append(
        html, "</dl>\n<p class=\"about\">The front: variants for which there is no other that "
              "is measured wherever they are, nowhere worse and somewhere better.</p>\n");
}

static void add_summary(GString *html, const struct comparison_view *view)
{
    const struct comparison_table *table = &view->table;
    g_string_append(html, "<h2 id=\"which\">Which to use</h2>\n");
    add_paragraph(html, "guide", "",
                  comparison_guide(table, comparison_view_main(view), comparison_view_cost(view)));
    add_notes(html, view);
    add_paragraph(html, "about", "A run counts with: ", comparison_limits(table));
    add_columns(html, table);
}

/* ------------------------------------------------------------------- picture */

/* The figure of the case that the page shows in place of a picture of its own. */
static const json_t *own_figure(const json_t *entry, const struct comparison_view *view)
{
    const json_t *figures = json_object_get(entry, "figures");
    const char *name = record_text(view->declared, "figure");
    for (size_t i = 0; *name != '\0' && i < json_array_size(figures); i++)
        if (strcmp(record_text(json_array_get(figures, i), "figure"), name) == 0)
            return json_array_get(figures, i);
    return NULL;
}

static void add_own_figure(GString *html, const json_t *figure)
{
    text_markup(html,
                "<figure class=\"wide\" tabindex=\"0\">\n<img src=\"figure-%s.svg\" width=\"760\" "
                "alt=\"%s; the "
                "table below has the numbers\" />\n<figcaption>%s</figcaption>\n</figure>\n",
                record_text(figure, "figure"), record_text(figure, "title"),
                record_text(figure, "caption"));
}

static void add_picture(GString *html, const struct comparison_view *view,
                        const struct figure_result *picture)
{
    if (picture->state == FIGURE_WITHOUT_DATA && *picture->reason == '\0')
        return;
    g_string_append(html, "<figure class=\"wide\" tabindex=\"0\">\n");
    if (picture->state == FIGURE_DRAWN) {
        text_markup(
            html,
            "<div class=\"marked\"><img src=\"figure-comparison.svg\" width=\"760\" height=\"520\" "
            "alt=\"%s: "
            "one quantity over the other for every variant that counts; the table below has "
            "the numbers\" />\n",
            record_text(view->declared, "title"));
        comparison_plot_marks(view, html);
        g_string_append(html, "</div>\n");
    } else
        text_markup(html,
                    "<p class=\"notice%s\"><strong>The picture is not drawn:</strong> %s</p>\n",
                    picture->state == FIGURE_FAILED ? "" : " quiet", picture->reason);
    g_string_append(
        html,
        "<figcaption>One point for each run that counts; those that do not are not "
        "drawn. Colour: when stress is updated. Shape of the mark: the shape functions. "
        "Filled and named: on the front as stated above, of all columns. Numbers: those "
        "of the table; where points are too close for a number, it is left out.</figcaption>\n"
        "</figure>\n");
}

/* ----------------------------------------------------------------- sentences */

static void add_absences(GString *html, const struct comparison_view *view)
{
    const struct comparison_table *table = &view->table;
    GString *items = g_string_new(NULL);
    for (size_t column = 0; column < table->column_count; column++) {
        for (size_t row = 0; row < table->row_count; row++) {
            const struct comparison_cell *cell = comparison_cell(table, row, column);
            if (cell->state == COMPARISON_ABSENT)
                text_markup(items, "<li>%s, %s: %s</li>\n", table->columns[column].title,
                            table->names[row], cell->reason);
        }
    }
    if (items->len > 0)
        g_string_append_printf(html,
                               "<details><summary>What was not measured, and why</summary>"
                               "<ul>\n%s</ul></details>\n",
                               items->str);
    g_string_free(items, TRUE);
}

/* Everything about every row, on demand. */
static void add_details(GString *html, const struct comparison_view *view)
{
    g_string_append(html, "<details><summary>Every variant in every column</summary>\n"
                          "<dl class=\"words\">\n");
    for (size_t row = 0; row < view->table.row_count; row++) {
        text_markup(html, "<dt id=\"%s\">%s</dt><dd>", view->names[row], view->names[row]);
        html_numbers(html, comparison_sentence(&view->table, row));
        g_string_append(html, "</dd>\n");
    }
    g_string_append(html, "</dl>\n</details>\n");
}

static void add_losses(GString *html, const struct comparison_view *view)
{
    const struct comparison_table *table = &view->table;
    g_string_append(html,
                    "<h2 id=\"loses\">Where each one loses</h2>\n<p class=\"about\">Each variant "
                    "is listed once, by the column in which it is behind the best by the largest "
                    "factor.</p>\n<dl class=\"words\">\n");
    for (size_t column = 0; column < table->column_count; column++) {
        const size_t best = comparison_best(table, column);
        char *losses = comparison_losses(table, column);
        if (*losses != '\0') {
            char *number = comparison_number(comparison_cell(table, best, column)->value,
                                             table->columns[column].unit);
            text_markup(html, "<dt>%s (best: ", table->columns[column].title);
            html_numbers(html, number);
            g_string_append(html, ")</dt><dd>");
            html_numbers(html, g_strdup(losses));
            g_string_append(html, "</dd>\n");
        }
        g_free(losses);
    }
    add_fact(html, "Behind in nothing that was measured of them",
             comparison_losses(table, COMPARISON_NONE));
    add_fact(html, "Does not count", comparison_outside(table));
    g_string_append(html, "</dl>\n");
    add_details(html, view);
    add_absences(html, view);
}

/* ---------------------------------------------------------------------- page */

char *comparison_page(const struct report_site *site, const json_t *entry,
                      const struct comparison_view *view, const struct figure_result *picture)
{
    const char *name = record_text(entry, "case"), *said = record_text(view->declared, "title");
    const char *summary = record_text(view->declared, "summary");
    const char *setup = record_text(view->declared, "setup");
    const json_t *figure = own_figure(entry, view);
    GString *html = g_string_new(NULL), *navigation = g_string_new(NULL);
    report_site_links(navigation, site, "../../", NULL);
    text_markup(navigation,
                "<p class=\"path\"><a href=\"../../index.html#cases\">family %s</a> / "
                "<a href=\"index.html\">%s</a> / comparison</p>",
                record_text(entry, "family"), name);
    text_markup(html, "<h1>%s: %s</h1>\n<p class=\"lead\">%s</p>\n", name, said,
                *summary == '\0' ? record_text(entry, "summary") : summary);
    if (*setup != '\0')
        text_markup(html, "<p class=\"setup\"><strong>The problem.</strong> %s</p>\n", setup);
    add_summary(html, view);
    if (figure != NULL)
        add_own_figure(html, figure);
    add_picture(html, view, picture);
    comparison_table_html(html, view);
    add_losses(html, view);
    char *title = g_strdup_printf("%s: %s", name, said);
    char *page = html_page(site->records, site->style, title, navigation, html);
    g_free(title);
    return page;
}

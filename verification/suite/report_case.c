/* The page of a case: problem, pictures, checks, commands, runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/html.h"
#include "verification/suite/markdown.h"

#include <math.h>
#include <string.h>

static void add_head(GString *html, const struct records *records, const json_t *entry)
{
    const struct record_counts counts = records_count(records, NULL, record_text(entry, "case"));
    text_markup(html, "<h1 class=\"verdict %s\">%s: %s</h1>\n<p class=\"lead\">%s</p>\n",
                counts.failed > 0 ? "bad" : "good", record_text(entry, "case"),
                record_text(entry, "title"), record_text(entry, "summary"));
    html_counts(html, &counts);
    if (json_is_object(json_object_get(entry, "comparison")))
        g_string_append(html, "<p><a href=\"comparison.html\">Its variants compared</a>: which to "
                              "use for what</p>\n");
    char *readme = markdown_html(record_text(entry, "readme"));
    g_string_append_printf(html, "<section class=\"readme\">\n%s</section>\n", readme);
    g_free(readme);
}

/* ------------------------------------------------------------------- figures */

static void add_figure(GString *html, const json_t *figure, const struct figure_result *result)
{
    const char *title = record_text(figure, "title");
    if (result->state == FIGURE_DRAWN)
        text_markup(
            html,
            "<figure>\n<img src=\"figure-%s.svg\" width=\"760\" height=\"470\" alt=\"%s. %s\" />\n",
            record_text(figure, "figure"), title, record_text(figure, "caption"));
    else
        text_markup(html, "<figure>\n<p class=\"notice%s\"><strong>%s</strong> %s</p>\n",
                    result->state == FIGURE_FAILED ? "" : " quiet",
                    result->state == FIGURE_FAILED ? "This figure could not be drawn."
                                                   : "This figure is not drawn:",
                    result->reason);
    text_markup(html,
                "<figcaption><strong>%s.</strong> %s<span class=\"about\">Reference: "
                "%s</span></figcaption>\n</figure>\n",
                title, record_text(figure, "caption"), record_text(figure, "reference"));
}

static void add_figures(GString *html, const json_t *entry, const struct figure_result *results)
{
    const json_t *figures = json_object_get(entry, "figures");
    if (json_array_size(figures) == 0)
        return;
    g_string_append(html, "<h2 id=\"pictures\">Pictures</h2>\n");
    for (size_t i = 0; i < json_array_size(figures); i++)
        add_figure(html, json_array_get(figures, i), &results[i]);
}

/* --------------------------------------------------------------------- checks */

/* Whether two rows come from one declaration. */
static bool same_declaration(const json_t *one, const json_t *other)
{
    static const char *const keys[] = {"check", "title", "expected",  "low",       "high",
                                       "basis", "why",   "fails_low", "fails_high"};
    for (size_t i = 0; i < G_N_ELEMENTS(keys); i++)
        if (!json_equal(json_object_get(one, keys[i]), json_object_get(other, keys[i])))
            return false;
    return true;
}

static void add_declaration(GString *html, const json_t *check)
{
    const char *unit = record_text(check, "unit");
    const bool weakness = json_is_number(json_object_get(check, "fails_low"));
    text_markup(html,
                "<tr><th scope=\"rowgroup\" colspan=\"6\">%s <code>%s</code><span class=\"facts\">"
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
    text_markup(
        html,
        "</span><span>Band from: %s</span></span><span class=\"why about\">%s</span></th></tr>\n",
        record_text(check, "basis"), record_text(check, "why"));
}

static void add_check(GString *html, const json_t *check)
{
    g_string_append(html, "<tr><td>");
    html_status(html, record_status(check));
    text_markup(html, "</td><td>%s</td><td class=\"n\">", record_text(check, "variant"));
    html_numbers(html, text_value(check));
    g_string_append(html, "</td><td>");
    html_margin(html, record_number(check, "margin"));
    char *proof = g_strdup_printf("%.0f of %.0f", record_number(check, "mutations_red"),
                                  record_number(check, "mutations"));
    text_markup(html, "</td><td class=\"n\">%s</td><td class=\"wide\">%s</td></tr>\n", proof,
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
    GPtrArray *checks = checks_of(records, name);
    g_string_append(html,
                    "<h2 id=\"checks\">Checks</h2>\n<div class=\"scroll\"><table>\n<caption>Each "
                    "check with its "
                    "band and the reason for it, then one row per variant. “Proven” counts the "
                    "spoiled results that turned the check red on this run.</caption>\n"
                    "<thead><tr><th scope=\"col\">Status</th><th scope=\"col\">Variant</th>"
                    "<th scope=\"col\" class=\"n\">Value</th><th scope=\"col\">Margin</th>"
                    "<th scope=\"col\" class=\"n\">Proven</th><th scope=\"col\">Remark</th>"
                    "</tr></thead>\n");
    for (unsigned i = 0; i < checks->len; i++) {
        if (checks->pdata[i] == NULL)
            continue;
        const json_t *first = checks->pdata[i];
        g_string_append(html, "<tbody class=\"group\">\n");
        add_declaration(html, first);
        for (unsigned j = i; j < checks->len; j++)
            if (checks->pdata[j] != NULL && same_declaration(first, checks->pdata[j])) {
                add_check(html, checks->pdata[j]);
                checks->pdata[j] = NULL;
            }
        g_string_append(html, "</tbody>\n");
    }
    g_string_append(html, "</table></div>\n");
    g_ptr_array_unref(checks);
}

/* ----------------------------------------------------------------------- runs */

static bool is_full(const json_t *variant)
{
    return strcmp(record_text(variant, "tier"), "full") == 0;
}

static void add_settings(GString *html, const json_t *variant)
{
    const json_t *settings = json_object_get(variant, "settings");
    for (size_t i = 0; i < json_array_size(settings); i++)
        text_markup(html, "%s<code>%s</code>", i == 0 ? "" : "<br />",
                    json_string_value(json_array_get(settings, i)));
}

static void add_notes(GString *html, const json_t *variant)
{
    const json_t *notes = json_object_get(variant, "notes");
    for (size_t i = 0; i < json_array_size(notes); i++)
        text_markup(html, "%s%s", i == 0 ? "" : "<br />",
                    json_string_value(json_array_get(notes, i)));
    const bool returned = strcmp(record_text(variant, "outcome"), "returned") == 0;
    const char *log = record_text(variant, "log_tail");
    if (!returned && *log != '\0')
        text_markup(
            html, "<details open=\"open\"><summary>End of the log</summary><pre>%s</pre></details>",
            log);
}

static void add_variant(GString *html, const json_t *variant)
{
    const double work = record_number(variant, "particle_steps");
    const double seconds = record_number(variant, "seconds");
    char *time = text_seconds(seconds);
    text_markup(html, "<tr><th scope=\"row\">%s</th><td>", record_text(variant, "variant"));
    add_settings(html, variant);
    text_markup(html, "</td><td>%s</td><td class=\"n\">%s</td><td class=\"n\">",
                record_text(variant, "outcome"), time);
    if (work > 0)
        html_numbers(html, text_number(work));
    g_string_append(html, "</td><td class=\"n\">");
    if (work > 0 && seconds > 0)
        html_numbers(html, text_quantity(work / seconds, "1/s"));
    g_string_append(html, "</td><td class=\"wide\">");
    add_notes(html, variant);
    g_string_append(html, "</td></tr>\n");
    g_free(time);
}

static void add_variants(GString *html, const json_t *entry)
{
    const json_t *variants = json_object_get(entry, "variants");
    g_string_append(
        html, "<h2 id=\"runs\">Runs</h2>\n<div class=\"scroll\"><table>\n<caption>One process per "
              "variant. Times are shown, never judged.</caption>\n<thead><tr>"
              "<th scope=\"col\">Variant</th><th scope=\"col\">Settings</th>"
              "<th scope=\"col\">Program</th><th scope=\"col\" class=\"n\">Time</th>"
              "<th scope=\"col\" class=\"n\">Particle-steps</th>"
              "<th scope=\"col\" class=\"n\">Rate</th>"
              "<th scope=\"col\">Notes</th></tr></thead>\n<tbody>\n");
    for (size_t i = 0; i < json_array_size(variants); i++)
        add_variant(html, json_array_get(variants, i));
    g_string_append(html, "</tbody>\n</table></div>\n");
}

static void add_commands(GString *html, const json_t *entry, const json_t *run)
{
    const json_t *variants = json_object_get(entry, "variants");
    g_string_append(html, "<h2 id=\"reproduce\">Reproduce</h2>\n<pre><code>");
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

char *report_case(const struct records *records, const json_t *entry,
                  const struct figure_result *figures, const struct report_style *style)
{
    GString *html = g_string_new(NULL), *navigation = g_string_new(NULL);
    const char *name = record_text(entry, "case");
    text_markup(navigation,
                "<a href=\"../../index.html\"><strong>Touchstone</strong> verification report</a> "
                "/ family %s / %s",
                record_text(entry, "family"), name);
    add_head(html, records, entry);
    add_figures(html, entry, figures);
    add_checks(html, records, name);
    add_commands(html, entry, records->run);
    add_variants(html, entry);
    char *title = g_strdup_printf("%s: %s", name, record_text(entry, "title"));
    char *page = html_page(records, style, title, navigation, html);
    g_free(title);
    return page;
}

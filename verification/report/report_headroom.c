/* The page of headroom: how far each check's values keep from its band's ends, over builds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/text.h"
#include "verification/pages/html.h"
#include "verification/records/check_text.h"
#include "verification/records/headroom_table.h"
#include "verification/report/report_site.h"

#include <math.h>
#include <string.h>

/* ------------------------------------------------------------------------ rows */

/* In the order of urgency. */
static const struct {
    enum headroom judged;
    const char *word, *mark, *class;
} looks[] = {
    {HEADROOM_FLAKY, "flaky", "⚑", "bad"},       {HEADROOM_SLACK, "slack", "◇", "known"},
    {HEADROOM_UNKNOWN, "no value", "–", "idle"}, {HEADROOM_FINE, "fine", "✓", "good"},
    {HEADROOM_EXACT, "exact", "=", "good"},
};

static size_t look_of(double headroom)
{
    size_t i = 0;
    while (looks[i].judged != headroom_judge(headroom))
        i++;
    return i;
}

static void add_row(struct report_table *table, const struct headroom_table *headroom,
                    const struct declared_headroom *declared)
{
    const json_t *check = declared->first;
    const double least = declared_headroom_least(declared);
    const size_t look = look_of(least);
    const char *reason = record_text(check, "headroom"),
               *fault = headroom_fault_words(declared->fault);
    char *href = g_strdup_printf("cases/%s/index.html#checks", record_text(check, "case"));
    char *name = g_strdup_printf("%s/%s", record_text(check, "case"), record_text(check, "check"));
    char *band = text_band(check);
    GString *title = g_string_new(NULL), *wrong = g_string_new(NULL);
    text_markup(title, "%s<span class=\"about\">%s</span>", record_text(check, "title"), reason);
    if (*fault != '\0')
        html_state(wrong, "bad", "✗", fault);
    if (declared->missing != NULL)
        text_markup(wrong, " <span class=\"about\">%s, %s</span>",
                    record_text(declared->missing, "variant"),
                    headroom->names[declared->missing_in]);
    report_table_link(table, href, name);
    report_table_state(table, *reason == '\0' ? looks[look].class : "idle", looks[look].mark,
                       looks[look].word);
    report_table_number(table, least, isinf(least) ? g_strdup("∞") : text_number(least));
    report_table_name(table, record_text(declared->variant, "variant"));
    report_table_text(table, declared->variant == NULL ? "" : headroom->names[declared->nearest]);
    report_table_number(table, 100 * declared->spread, text_number(100 * declared->spread));
    report_table_text(table, band);
    report_table_text(table, record_text(check, "basis"));
    report_table_markup(table, fault, wrong);
    report_table_markup(table, reason, title);
    g_free(band);
    g_free(name);
    g_free(href);
}

/* How many checks are judged so; those that state why are apart, and no alarm. */
static void add_count(GString *html, const struct headroom_table *table, size_t look)
{
    const size_t all = headroom_table_count(table, table->build_count, looks[look].judged);
    const bool outside =
        looks[look].judged == HEADROOM_FLAKY || looks[look].judged == HEADROOM_SLACK;
    const size_t reasoned = outside ? headroom_table_reasoned(table, looks[look].judged) : 0;
    if (all > reasoned)
        html_state_count(html, looks[look].class, looks[look].mark, all - reasoned,
                         looks[look].word);
    if (reasoned > 0) {
        char *word = g_strdup_printf("%s for a stated reason", looks[look].word);
        html_state_count(html, "idle", looks[look].mark, reasoned, word);
        g_free(word);
    }
}

/* Verdicts, and what is wrong: in words, since one build alone does not show it. */
static void add_counts(GString *html, const struct headroom_table *table, bool compared)
{
    g_string_append(html, "<ul class=\"counts\">");
    for (size_t look = 0; look < G_N_ELEMENTS(looks); look++)
        add_count(html, table, look);
    g_string_append(html, "</ul>\n");
    bool sound = true;
    for (int fault = HEADROOM_SOUND + 1; fault < HEADROOM_FAULTS; fault++) {
        const size_t number = headroom_table_faults(table, (enum headroom_fault)fault);
        sound = sound && number == 0;
        if (number > 0)
            text_markup(html, "<p class=\"notice%s\">%zu of %u checks: %s.</p>\n",
                        compared ? "" : " quiet", number, table->checks->len,
                        headroom_fault_words((enum headroom_fault)fault));
    }
    if (sound)
        g_string_append(html,
                        "<p class=\"notice good\">Every check has a value in every build that "
                        "ran it, and is within 1.5 to 100 or states why not.</p>\n");
    if (!compared)
        g_string_append(html, "<p class=\"about\">This run alone; <code>make headroom</code> "
                              "compares builds.</p>\n");
}

/* How many declared checks a build alone judges so. */
static void add_judged(struct report_table *cells, const struct headroom_table *table,
                       unsigned build)
{
    static const enum headroom judged[] = {HEADROOM_FLAKY, HEADROOM_SLACK};
    for (size_t i = 0; i < G_N_ELEMENTS(judged); i++) {
        const size_t number = headroom_table_count(table, build, judged[i]);
        report_table_number(cells, (double)number, g_strdup_printf("%zu", number));
    }
    report_table_number(cells, (double)table->values[build],
                        g_strdup_printf("%zu", table->values[build]));
    report_table_number(cells, (double)table->without[build],
                        g_strdup_printf("%zu", table->without[build]));
}

static void add_builds(GString *html, struct report_site *site, const struct headroom_table *table)
{
    static const struct report_column columns[] = {
        {"Build", NULL, CELLS_TEXT, false},    {"Flaky", NULL, CELLS_NUMBER, true},
        {"Slack", NULL, CELLS_NUMBER, true},   {"Values", NULL, CELLS_NUMBER, true},
        {"Missing", NULL, CELLS_NUMBER, true}, {"Compiler", NULL, CELLS_TEXT, false},
        {"SIMD", NULL, CELLS_TEXT, false},     {"Kernels", NULL, CELLS_TEXT, false},
        {"Revision", NULL, CELLS_TEXT, false}, {"Flags", NULL, CELLS_WIDE, false},
    };
    static const char *const keys[] = {"compiler", "simd", "kernels", "revision", "flags"};
    const json_t *builds = json_object_get(site->headroom, "builds");
    struct report_table *cells = report_table_new(columns, G_N_ELEMENTS(columns));
    for (unsigned i = 0; i < table->build_count; i++) {
        const json_t *build = i == 0 ? site->records->run : json_array_get(builds, i - 1);
        report_table_text(cells, table->names[i]);
        add_judged(cells, table, i);
        for (size_t k = 0; k < G_N_ELEMENTS(keys); k++)
            report_table_text(cells, record_text(build, keys[k]));
    }
    report_table_sort(cells);
    g_string_append(html, "<h2 id=\"builds\">Builds</h2>\n<p class=\"about\">Flaky and slack: "
                          "declared checks, by the values of that build alone. Values: of "
                          "variants. A slow build may run a selection.</p>\n");
    report_site_table(site, cells, "The builds whose values are compared", "builds.csv", html);
}

void report_headroom_page(struct report_site *site)
{
    static const struct report_column columns[] = {
        {"Check", NULL, CELLS_TEXT, false},
        {"Verdict", NULL, CELLS_TEXT, false},
        {"Headroom", "1", CELLS_NUMBER, false},
        {"Nearest variant", NULL, CELLS_TEXT, false},
        {"Build", NULL, CELLS_TEXT, false},
        {"Spread over builds", "%", CELLS_NUMBER, true},
        {"Band", NULL, CELLS_BAND, false},
        {"Band from", NULL, CELLS_TEXT, false},
        {"Fault", NULL, CELLS_TEXT, false},
        {"What it is, and why the band", NULL, CELLS_WIDE, false},
    };
    GString *html =
        g_string_new("<h1>Headroom</h1>\n<p class=\"lead\">How many times the deviation "
                     "of a check’s values fits into its band.</p>\n");
    struct headroom_table headroom =
        headroom_table_make(site->records->checks, json_object_get(site->headroom, "builds"));
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (unsigned i = 0; i < headroom.checks->len; i++)
        add_row(table, &headroom, &g_array_index(headroom.checks, struct declared_headroom, i));
    report_table_sort(table);
    add_counts(html, &headroom, site->headroom != NULL);
    g_string_append(
        html,
        "<p class=\"about\">Headroom: the room from the expected value to the end of the "
        "band, over the distance of the value from the expected one (in a band of a decade or "
        "more: the far end over the value); the least over the "
        "variants of the check and over builds. Below 1.5 a check is flagged as flaky: a "
        "change that is none may turn it red. Above 100 as slack: an error may grow a "
        "hundredfold unseen. Either needs a reason, written beside it. Exact: every value "
        "is the expected one. Spread: the largest difference between builds over half the "
        "width of the band.</p>\n");
    report_site_table(site, table, "Headroom of every declared check", "headroom.csv", html);
    add_builds(html, site, &headroom);
    headroom_table_clear(&headroom);
    report_site_page(site, "headroom.html", "Headroom", html);
}

/* The page of headroom: how far each check's values keep from its band's ends, over builds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/headroom.h"
#include "verification/suite/html.h"
#include "verification/suite/report_site.h"

#include <math.h>
#include <string.h>

/* A declared check with its variants. */
struct declared {
    const json_t *first; /* of its records */
    struct verdict_band band;
    double least; /* headroom */
    const json_t *variant;
    const char *build;
    double spread; /* largest of a variant */
};

static struct verdict_band band_of(const json_t *check)
{
    return (struct verdict_band){
        .expected = record_number(check, "expected"),
        .low = record_number(check, "low"),
        .high = record_number(check, "high"),
        .fails_low = record_number(check, "fails_low"),
        .fails_high = record_number(check, "fails_high"),
        .weakness = json_is_number(json_object_get(check, "fails_low")),
    };
}

/* Takes a value of a check in: the least headroom, and where it was. */
static void take(struct declared *declared, const json_t *check, const char *build, double value)
{
    const double room = headroom_of(&declared->band, value);
    if (isnan(room) || (!isnan(declared->least) && room >= declared->least))
        return;
    declared->least = room;
    declared->variant = check;
    declared->build = build;
}

static void take_check(struct declared *declared, const json_t *check, const json_t *builds)
{
    double least = record_number(check, "value"), largest = least;
    char *key = record_key(check, "check");
    take(declared, check, "this run", least);
    for (size_t i = 0; i < json_array_size(builds); i++) {
        const json_t *build = json_array_get(builds, i);
        const double value = record_number(json_object_get(build, "values"), key);
        take(declared, check, record_text(build, "name"), value);
        least = fmin(least, value);
        largest = fmax(largest, value);
    }
    declared->spread = fmax(declared->spread, headroom_spread(&declared->band, least, largest));
    g_free(key);
}

/* Records of one declaration need not follow each other, those of one case do. */
static GArray *declared_of(const struct report_site *site)
{
    const json_t *checks = site->records->checks;
    const json_t *builds = json_object_get(site->headroom, "builds");
    GArray *all = g_array_new(FALSE, TRUE, sizeof(struct declared));
    for (size_t i = 0; i < json_array_size(checks); i++) {
        const json_t *check = json_array_get(checks, i);
        struct declared *found = NULL;
        for (unsigned k = all->len; found == NULL && k > 0; k--) {
            struct declared *other = &g_array_index(all, struct declared, k - 1);
            if (strcmp(record_text(other->first, "case"), record_text(check, "case")) != 0)
                break;
            if (record_same_declaration(other->first, check))
                found = other;
        }
        if (found == NULL) {
            const struct declared fresh = {
                .first = check, .band = band_of(check), .least = (double)NAN};
            g_array_append_val(all, fresh);
            found = &g_array_index(all, struct declared, all->len - 1);
        }
        take_check(found, check, builds);
    }
    return all;
}

/* ------------------------------------------------------------------------ rows */

/* In the order of what to look at first. */
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

static bool needs_reason(const struct declared *declared)
{
    const enum headroom judged = headroom_judge(declared->least);
    return (judged == HEADROOM_FLAKY || judged == HEADROOM_SLACK) &&
           *record_text(declared->first, "headroom") == '\0';
}

static void add_row(struct report_table *table, const struct declared *declared)
{
    const json_t *check = declared->first;
    const size_t look = look_of(declared->least);
    char *href = g_strdup_printf("cases/%s/index.html#checks", record_text(check, "case"));
    char *name = g_strdup_printf("%s/%s", record_text(check, "case"), record_text(check, "check"));
    char *band = text_band(check);
    GString *mark = g_string_new(NULL), *title = g_string_new(NULL);
    text_markup(
        mark,
        "<span class=\"state %s\"><span class=\"mark\" aria-hidden=\"true\">%s</span>%s</span>",
        looks[look].class, looks[look].mark, looks[look].word);
    text_markup(title, "%s<span class=\"about\">%s</span>", record_text(check, "title"),
                needs_reason(declared) ? "no reason written" : record_text(check, "headroom"));
    report_table_link(table, href, name);
    report_table_markup(table, looks[look].word, mark);
    report_table_number(table, declared->least,
                        isinf(declared->least) ? g_strdup("∞") : text_number(declared->least));
    report_table_name(table, record_text(declared->variant, "variant"));
    report_table_text(table, declared->build == NULL ? "" : declared->build);
    report_table_number(table, 100 * declared->spread, text_number(100 * declared->spread));
    report_table_text(table, band);
    report_table_text(table, record_text(check, "basis"));
    report_table_markup(table, record_text(check, "headroom"), title);
    g_free(band);
    g_free(name);
    g_free(href);
}

static void add_counts(GString *html, const GArray *all)
{
    size_t unreasoned = 0;
    g_string_append(html, "<ul class=\"counts\">");
    for (size_t look = 0; look < G_N_ELEMENTS(looks); look++) {
        size_t number = 0;
        for (unsigned i = 0; i < all->len; i++)
            number += look_of(g_array_index(all, struct declared, i).least) == look;
        if (number > 0)
            g_string_append_printf(html,
                                   "<li class=\"%s\"><span aria-hidden=\"true\">%s</span> "
                                   "<b>%zu</b> %s</li>",
                                   looks[look].class, looks[look].mark, number, looks[look].word);
    }
    for (unsigned i = 0; i < all->len; i++)
        unreasoned += needs_reason(&g_array_index(all, struct declared, i));
    g_string_append_printf(html,
                           "</ul>\n<p>%zu of those outside have no reason written in their "
                           "case.</p>\n",
                           unreasoned);
}

static void add_builds(GString *html, struct report_site *site)
{
    static const struct report_column columns[] = {
        {"Build", NULL, CELLS_TEXT, false},    {"Compiler", NULL, CELLS_TEXT, false},
        {"SIMD", NULL, CELLS_TEXT, false},     {"Kernels", NULL, CELLS_TEXT, false},
        {"Revision", NULL, CELLS_TEXT, false}, {"Flags", NULL, CELLS_WIDE, false},
    };
    static const char *const keys[] = {"compiler", "simd", "kernels", "revision", "flags"};
    const json_t *builds = json_object_get(site->headroom, "builds");
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (size_t i = 0; i <= json_array_size(builds); i++) {
        const json_t *build = i == 0 ? site->records->run : json_array_get(builds, i - 1);
        report_table_text(table, i == 0 ? "this run" : record_text(build, "name"));
        for (size_t k = 0; k < G_N_ELEMENTS(keys); k++)
            report_table_text(table, record_text(build, keys[k]));
    }
    g_string_append(html, "<h2 id=\"builds\">Builds</h2>\n");
    report_site_table(site, table, "The builds whose values are compared", "builds.csv", html);
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
        {"What it is, and why the band", NULL, CELLS_WIDE, false},
    };
    GString *html =
        g_string_new("<h1>Headroom</h1>\n<p class=\"lead\">How many times the deviation "
                     "of a check’s values fits into its band.</p>\n");
    GArray *all = declared_of(site);
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (unsigned i = 0; i < all->len; i++)
        add_row(table, &g_array_index(all, struct declared, i));
    report_table_sort(table);
    add_counts(html, all);
    g_string_append(
        html, "<p class=\"about\">Headroom: the room from the expected value to the end of the "
              "band, over the distance of the value from the expected one; the least over the "
              "variants of the check and over builds. Below 1.5 a check is flagged as flaky: a "
              "change that is none may turn it red. Above 100 as slack: an error may grow a "
              "hundredfold unseen. Exact: every value is the expected one. Spread: the largest "
              "difference between builds over half the width of the band.</p>\n");
    report_site_table(site, table, "Headroom of every declared check", "headroom.csv", html);
    add_builds(html, site);
    g_array_unref(all);
    report_site_page(site, "headroom.html", "Headroom", html);
}

/* The front page's grid: what is checked, by what kind of evidence, and where nothing is.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/record.h"
#include "verification/measures/comparison/evidence.h"
#include "verification/report/comparison_view.h"
#include "verification/report/report_site.h"

#include <string.h>

/* Tags that state what kind of thing a feature is. A tag that is not here is a subject of its own.
 */
static const struct {
    const char *tag, *kind; /* "": no feature, but a kind of evidence or of case */
} tags[] = {
    {"planar", "geometry"},
    {"axisymmetric", "geometry"},
    {"neo_hookean", "material"},
    {"linear_elastic", "material"},
    {"rigid", "material"},
    {"traction", "load"},
    {"body_force", "load"},
    {"exact", ""},
    {"manufactured", ""},
    {"quadrature", ""},
    {"identities", ""},
    {"figure", ""},
    {"fast", ""},
    {"tutorial", ""},
    {"weakness", ""},
    {"finite_elements", ""},
};

struct feature {
    const char *name, *kind;
    const json_t *part; /* of methods' names; NULL for a tag */
    size_t counts[EVIDENCE_COUNT];
};

static const char *kind_of_tag(const char *tag)
{
    for (size_t i = 0; i < G_N_ELEMENTS(tags); i++)
        if (strcmp(tags[i].tag, tag) == 0)
            return tags[i].kind;
    return "subject";
}

static bool has_feature(const GArray *features, const char *name)
{
    for (unsigned i = 0; i < features->len; i++)
        if (strcmp(g_array_index(features, struct feature, i).name, name) == 0)
            return true;
    return false;
}

static void add_feature(GArray *features, const char *name, const char *kind, const json_t *part)
{
    const struct feature feature = {.name = name, .kind = kind, .part = part};
    if (*kind != '\0' && !has_feature(features, name))
        g_array_append_val(features, feature);
}

/* The tags of all cases and, where a comparison declares them, the parts of methods' names. */
static GArray *features_of(const json_t *cases)
{
    GArray *features = g_array_new(FALSE, TRUE, sizeof(struct feature));
    for (size_t i = 0; i < json_array_size(cases); i++) {
        const json_t *entry = json_array_get(cases, i);
        const json_t *own = json_object_get(entry, "tags");
        const json_t *parts = json_object_get(json_object_get(entry, "comparison"), "parts");
        for (size_t t = 0; t < json_array_size(own); t++) {
            const char *tag = json_string_value(json_array_get(own, t));
            if (tag != NULL)
                add_feature(features, tag, kind_of_tag(tag), NULL);
        }
        for (size_t p = 0; p < json_array_size(parts); p++) {
            const json_t *part = json_array_get(parts, p);
            add_feature(features, record_text(part, "part"), record_text(part, "kind"), part);
        }
    }
    return features;
}

static enum case_evidence evidence_of(const json_t *check)
{
    enum case_evidence evidence = EVIDENCE_NOT_STATED;
    for (int i = 0; i < EVIDENCE_COUNT; i++)
        if (strcmp(record_text(check, "evidence"), evidence_name((enum case_evidence)i)) == 0)
            evidence = (enum case_evidence)i;
    return evidence;
}

static void count(GArray *features, const struct records *records)
{
    const json_t *entry = NULL;
    for (size_t i = 0; i < json_array_size(records->checks); i++) {
        const json_t *check = json_array_get(records->checks, i);
        const enum case_evidence evidence = evidence_of(check);
        if (record_status(check) == VERDICT_SKIP)
            continue;
        if (strcmp(record_text(entry, "case"), record_text(check, "case")) != 0)
            entry = records_case(records, record_text(check, "case"));
        for (unsigned f = 0; f < features->len; f++) {
            struct feature *feature = &g_array_index(features, struct feature, f);
            if (feature->part == NULL
                    ? record_has_tag(entry, feature->name)
                    : comparison_view_has_part(record_text(check, "variant"), feature->part))
                feature->counts[evidence]++;
        }
    }
}

static void add_count(struct report_table *table, size_t number)
{
    GString *markup = g_string_new(NULL);
    if (number == 0)
        g_string_append(markup, "<span class=\"hole\">none</span>");
    else
        g_string_append_printf(markup, "%zu", number);
    report_table_value(table, (double)number, markup);
}

/* A column for checks of which nothing is stated is there only where there are some. */
static bool any_not_stated(const GArray *features)
{
    for (unsigned i = 0; i < features->len; i++)
        if (g_array_index(features, struct feature, i).counts[EVIDENCE_NOT_STATED] > 0)
            return true;
    return false;
}

static void add_row(struct report_table *table, const struct feature *feature, bool all)
{
    size_t holes = 0;
    char *shown = g_strdelimit(g_strdup(feature->name), "?_", ' ');
    report_table_text(table, g_strchomp(shown));
    report_table_text(table, feature->kind);
    for (int e = EVIDENCE_NOT_STATED + 1; e < EVIDENCE_COUNT; e++) {
        add_count(table, feature->counts[e]);
        holes += feature->counts[e] == 0;
    }
    report_table_number(table, (double)holes, g_strdup_printf("%zu", holes));
    if (all)
        add_count(table, feature->counts[EVIDENCE_NOT_STATED]);
    g_free(shown);
}

void report_coverage(GString *html, struct report_site *site)
{
    static const struct report_column columns[] = {
        {"Feature", NULL, CELLS_TEXT, false},        {"Kind", NULL, CELLS_TEXT, false},
        {"Quadrature", NULL, CELLS_NUMBER, true},    {"Exact solution", NULL, CELLS_NUMBER, true},
        {"Manufactured", NULL, CELLS_NUMBER, true},  {"Invariant", NULL, CELLS_NUMBER, true},
        {"Cross-variant", NULL, CELLS_NUMBER, true}, {"Reference data", NULL, CELLS_NUMBER, true},
        {"Holes", NULL, CELLS_NUMBER, true},         {"Not stated", NULL, CELLS_NUMBER, true},
    };
    GArray *features = features_of(json_object_get(site->records->run, "cases"));
    count(features, site->records);
    const bool all = any_not_stated(features);
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns) - (all ? 0 : 1));
    for (unsigned i = 0; i < features->len; i++)
        add_row(table, &g_array_index(features, struct feature, i), all);
    report_table_sort(table);
    g_string_append(html, "<h2 id=\"coverage\">What is covered by which evidence</h2>\n"
                          "<p class=\"about\">Checks of this run, by what is compared with the "
                          "solver’s number: its <a href=\"glossary.html#evidence\">evidence</a>. "
                          "“none” is a hole. A check counts for every feature that its case or "
                          "its variant has.</p>\n");
    report_site_table(site, table, "Checks by feature and kind of evidence", "coverage.csv", html);
    g_array_unref(features);
}

/* The page of mutants: spoiled solvers, and which checks and tests noticed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/record.h"
#include "verification/common/text.h"
#include "verification/pages/html.h"
#include "verification/report/report_site.h"
#include "verification/report/report_stored.h"

#include <string.h>

/* In the order of urgency. */
static const struct {
    const char *outcome, *mark, *class;
} looks[] = {
    {"survived", "✗", "bad"},
    {"not-built", "!", "bad"},
    {"equivalent", "◇", "known"},
    {"killed", "✓", "good"},
};
enum { SURVIVED, NOT_BUILT, EQUIVALENT, KILLED, OUTCOMES };

static size_t outcome_of(const json_t *mutant)
{
    size_t i = 0;
    while (i < OUTCOMES && strcmp(looks[i].outcome, record_text(mutant, "outcome")) != 0)
        i++;
    return i;
}

enum mpm_status mutants_check(const json_t *object, const char *path, struct mpm_error *error)
{
    static const char *const keys[] = {"name", "room", "what", "patch", "outcome"};
    const json_t *mutants = json_object_get(object, "mutants");
    if (!json_is_array(mutants))
        return failure_set(error, MPM_BAD_INPUT, "%s: mutants: a list is missing", path);
    for (size_t i = 0; i < json_array_size(mutants); i++) {
        const json_t *mutant = json_array_get(mutants, i);
        const json_t *killers = json_object_get(mutant, "killed_by");
        for (size_t k = 0; k < G_N_ELEMENTS(keys); k++)
            if (!json_is_string(json_object_get(mutant, keys[k])))
                return failure_set(error, MPM_BAD_INPUT, "%s: mutants.%zu: %s: a text is missing",
                                   path, i, keys[k]);
        if (outcome_of(mutant) == OUTCOMES)
            return failure_set(error, MPM_BAD_INPUT,
                               "%s: mutants.%zu: outcome: \"%s\": allowed are killed, survived, "
                               "equivalent and not-built",
                               path, i, record_text(mutant, "outcome"));
        bool texts = json_is_array(killers);
        for (size_t k = 0; k < json_array_size(killers); k++)
            texts = texts && json_is_string(json_array_get(killers, k));
        if (!texts || (outcome_of(mutant) == KILLED) != (json_array_size(killers) > 0))
            return failure_set(error, MPM_BAD_INPUT,
                               "%s: mutants.%zu: killed_by: allowed is a list of names, empty "
                               "unless the outcome is killed",
                               path, i);
        if (outcome_of(mutant) == EQUIVALENT && *record_text(mutant, "equivalent") == '\0')
            return failure_set(error, MPM_BAD_INPUT,
                               "%s: mutants.%zu: equivalent: the reason is missing", path, i);
    }
    return MPM_OK;
}

/* --------------------------------------------------------------------- mutants */

/* The first three, then how many more. */
static char *killers_text(const json_t *killers)
{
    enum { SHOWN = 3 };
    GString *text = g_string_new(NULL);
    for (size_t i = 0; i < MIN(json_array_size(killers), SHOWN); i++)
        g_string_append_printf(text, "%s%s", i == 0 ? "" : ", ",
                               json_string_value(json_array_get(killers, i)));
    if (json_array_size(killers) > SHOWN)
        g_string_append_printf(text, " and %zu more", json_array_size(killers) - SHOWN);
    return g_string_free(text, FALSE);
}

static void add_mutant(struct report_table *table, const json_t *mutant)
{
    const json_t *killers = json_object_get(mutant, "killed_by");
    const size_t look = outcome_of(mutant);
    const char *patch = record_text(mutant, "patch"), *what = record_text(mutant, "what");
    const char *fault = record_text(mutant, "fault") /* of the build */;
    char *names = killers_text(killers);
    GString *about = g_string_new(NULL);
    text_markup(about, "%s", what);
    if (*patch != '\0')
        text_markup(about, "<details><summary>the change</summary><pre>%s</pre></details>", patch);
    report_table_name(table, record_text(mutant, "name"));
    report_table_name(table, record_text(mutant, "room"));
    report_table_markup(table, what, about);
    report_table_state(table, looks[look].class, looks[look].mark, looks[look].outcome);
    report_table_number(table, (double)json_array_size(killers),
                        g_strdup_printf("%zu", json_array_size(killers)));
    report_table_text(table, names);
    report_table_text(table, *fault == '\0' ? record_text(mutant, "equivalent") : fault);
    g_free(names);
}

static void add_mutants(GString *html, struct report_site *site, const json_t *mutants)
{
    static const struct report_column columns[] = {
        {"Mutant", NULL, CELLS_TEXT, false},
        {"Room", NULL, CELLS_TEXT, false},
        {"What is wrong in it", NULL, CELLS_WIDE, false},
        {"Outcome", NULL, CELLS_TEXT, false},
        {"Killed by", NULL, CELLS_NUMBER, true},
        {"Which", NULL, CELLS_WIDE, false},
        {"Remark", NULL, CELLS_WIDE, false},
    };
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (size_t i = 0; i < json_array_size(mutants); i++)
        add_mutant(table, json_array_get(mutants, i));
    report_table_sort(table);
    g_string_append(html, "<h2 id=\"mutants\">Every mutant</h2>\n");
    report_site_table(site, table, "Mutants and what became of them", "mutants.csv", html);
}

/* ---------------------------------------------------------------------- checks */

struct killer {
    const char *name;
    size_t kills, alone;
};

static GArray *killers_of(const json_t *mutants)
{
    GArray *all = g_array_new(FALSE, TRUE, sizeof(struct killer));
    GHashTable *places = g_hash_table_new(g_str_hash, g_str_equal);
    for (size_t i = 0; i < json_array_size(mutants); i++) {
        const json_t *names = json_object_get(json_array_get(mutants, i), "killed_by");
        for (size_t k = 0; k < json_array_size(names); k++) {
            const char *name = json_string_value(json_array_get(names, k));
            const struct killer fresh = {.name = name};
            if (!g_hash_table_contains(places, name)) {
                g_hash_table_insert(places, (void *)name, GUINT_TO_POINTER(all->len));
                g_array_append_val(all, fresh);
            }
            struct killer *killer = &g_array_index(
                all, struct killer, GPOINTER_TO_UINT(g_hash_table_lookup(places, name)));
            killer->kills++;
            killer->alone += json_array_size(names) == 1;
        }
    }
    g_hash_table_unref(places);
    return all;
}

static int compare_killers(const void *a, const void *b)
{
    return strcmp(((const struct killer *)a)->name, ((const struct killer *)b)->name);
}

static void add_killers(GString *html, struct report_site *site, const json_t *mutants)
{
    static const struct report_column columns[] = {
        {"Check or test", NULL, CELLS_TEXT, false},
        {"Mutants killed", NULL, CELLS_NUMBER, true},
        {"By it alone", NULL, CELLS_NUMBER, true},
    };
    GArray *killers = killers_of(mutants);
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    g_array_sort(killers, compare_killers);
    for (unsigned i = 0; i < killers->len; i++) {
        const struct killer *killer = &g_array_index(killers, struct killer, i);
        report_table_name(table, killer->name);
        report_table_number(table, (double)killer->kills, g_strdup_printf("%zu", killer->kills));
        report_table_number(table, (double)killer->alone, g_strdup_printf("%zu", killer->alone));
    }
    g_string_append(
        html, "<h2 id=\"killers\">What each check is worth</h2>\n<p class=\"about\">"
              "A mutant meets the slower tests and checks only while quicker ones leave it alive: "
              "of one that alone kills a mutant here, see first what all of them report "
              "(<code>mutants.py run --thorough</code>).</p>\n");
    report_site_table(site, table, "Mutants killed by each check and test", "killers.csv", html);
    g_array_unref(killers);
}

/* ------------------------------------------------------------------------ page */

static void add_score(GString *html, const json_t *mutants)
{
    size_t counts[OUTCOMES + 1] = {0};
    for (size_t i = 0; i < json_array_size(mutants); i++)
        counts[outcome_of(json_array_get(mutants, i))]++;
    const size_t judged = counts[KILLED] + counts[SURVIVED];
    char *score = judged == 0
                      ? g_strdup("none")
                      : g_strdup_printf("%.1f %%", 100.0 * (double)counts[KILLED] / (double)judged);
    text_markup(html,
                "<p>Score: <strong>%s</strong> of the mutants that can be told from the "
                "solver are killed.</p>\n<ul class=\"counts\">",
                score);
    for (size_t i = 0; i < OUTCOMES; i++)
        if (counts[i] > 0)
            html_state_count(html, looks[i].class, looks[i].mark, counts[i], looks[i].outcome);
    g_string_append(html, "</ul>\n");
    g_free(score);
}

void report_mutants_page(struct report_site *site)
{
    const json_t *mutants = json_object_get(site->mutants, "mutants");
    GString *html = g_string_new("<h1>Mutants</h1>\n<p class=\"lead\">Copies of the solver and the "
                                 "suite with one fault each: do the checks notice?</p>\n");
    if (site->mutants == NULL) {
        g_string_append(html, "<p class=\"notice quiet\">This report holds no run of mutants. "
                              "<code>mpm-verify report DIR --mutants FILE</code> adds one.</p>\n");
    } else {
        add_score(html, mutants);
        text_markup(html, "<p class=\"about\">Revision %s.</p>\n",
                    record_text(site->mutants, "revision"));
        add_mutants(html, site, mutants);
        add_killers(html, site, mutants);
    }
    report_site_page(site, "mutants.html", "Mutants", html);
}

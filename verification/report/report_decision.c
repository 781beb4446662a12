/* The page of decisions: for each purpose the methods that were measured, what they hold, what they
 * cost and where they fall short, from the numbers of the run alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/text.h"
#include "verification/measures/comparison/comparison_guide.h"
#include "verification/measures/comparison/comparison_words.h"
#include "verification/pages/html.h"
#include "verification/records/check_text.h"
#include "verification/report/comparison_view.h"
#include "verification/report/report_site.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <string.h>

/* What a user comes with, and the tag of the cases that are about it. */
static const struct {
    const char *tag, *title;
} purposes[] = {
    {"impact", "Impact"},           {"large-tension", "Large tension"},
    {"compression", "Compression"}, {"statics", "Statics"},
    {"vibration", "Vibration"},     {"fracture", "Fracture"},
    {"contact", "Contact"},         {"heat", "Heat"},
};

/* A pair of shape functions and order of the stress update, over the cases of a purpose. */
struct method {
    char *name;
    GPtrArray *cases;   /* names, each once; they belong to the records */
    GPtrArray *falling; /* checks that it does not hold */
    GArray *costs;      /* times of the cheapest method in the same case and setting */
    size_t checks;
    double cost; /* the median of them; NaN: none */
};

struct decision {
    const struct records *records;
    const json_t *parts; /* of methods' names */
    GPtrArray *methods;  /* struct method */
    GPtrArray *entries;  /* cases of the purpose */
    size_t most_cases;   /* of a method */
};

static void free_method(void *element)
{
    struct method *method = element;
    g_free(method->name);
    g_ptr_array_unref(method->cases);
    g_ptr_array_unref(method->falling);
    g_array_unref(method->costs);
    g_free(method);
}

/* The parts of methods' names, as any comparison of the run has them; NULL without one. */
static const json_t *parts_of(const json_t *cases)
{
    for (size_t i = 0; i < json_array_size(cases); i++) {
        const json_t *parts =
            json_object_get(json_object_get(json_array_get(cases, i), "comparison"), "parts");
        if (json_array_size(parts) > 0)
            return parts;
    }
    return NULL;
}

/* The variant's part of that kind; NULL if its name has none. */
static const char *part_of(const json_t *parts, const char *variant, const char *kind)
{
    for (size_t i = 0; i < json_array_size(parts); i++) {
        const json_t *part = json_array_get(parts, i);
        if (strcmp(record_text(part, "kind"), kind) == 0 && comparison_view_has_part(variant, part))
            return record_text(part, "part");
    }
    return NULL;
}

/* The method of a variant; NULL if its name states no shape functions. g_free. */
static char *method_of(const json_t *parts, const char *variant)
{
    const char *shape = part_of(parts, variant, "shape"), *order = part_of(parts, variant, "order");
    return shape == NULL   ? NULL
           : order == NULL ? g_strdup(shape)
                           : g_strconcat(shape, "_", order, NULL);
}

/* What is left of a variant's name without its method: runs of the same setting have the same. */
static char *setting_of(const json_t *parts, const char *variant)
{
    const char *own[] = {part_of(parts, variant, "shape"), part_of(parts, variant, "order")};
    char **words = g_strsplit(variant, "_", -1);
    GString *rest = g_string_new(NULL);
    for (char **word = words; *word != NULL; word++)
        if (g_strcmp0(*word, own[0]) != 0 && g_strcmp0(*word, own[1]) != 0)
            g_string_append_printf(rest, "_%s", *word);
    g_strfreev(words);
    return g_string_free(rest, FALSE);
}

static struct method *find_method(struct decision *decision, char *name)
{
    for (unsigned i = 0; i < decision->methods->len; i++) {
        struct method *method = decision->methods->pdata[i];
        if (strcmp(method->name, name) == 0) {
            g_free(name);
            return method;
        }
    }
    struct method *fresh = g_new0(struct method, 1);
    fresh->name = name;
    fresh->cases = g_ptr_array_new();
    fresh->falling = g_ptr_array_new();
    fresh->costs = g_array_new(FALSE, FALSE, sizeof(double));
    fresh->cost = (double)NAN;
    g_ptr_array_add(decision->methods, fresh);
    return fresh;
}

/* --------------------------------------------------------------------- gathering */

static void take_check(struct decision *decision, json_t *check)
{
    const enum verdict_status status = record_status(check);
    char *name = method_of(decision->parts, record_text(check, "variant"));
    if (name == NULL || status == VERDICT_SKIP) {
        g_free(name);
        return;
    }
    struct method *method = find_method(decision, name);
    const char *of = record_text(check, "case");
    if (!g_ptr_array_find_with_equal_func(method->cases, of, g_str_equal, NULL))
        g_ptr_array_add(method->cases, (void *)(uintptr_t)of);
    method->checks++;
    if (status != VERDICT_PASS)
        g_ptr_array_add(method->falling, check);
    decision->most_cases = MAX(decision->most_cases, method->cases->len);
}

/* The runs of one setting of a case. */
struct setting {
    const struct method *first;
    double least;  /* seconds */
    bool compared; /* are there runs of another method as well? */
};

static struct setting *find_setting(GHashTable *settings, char *name, const struct method *method)
{
    struct setting *setting = g_hash_table_lookup(settings, name);
    if (setting != NULL) {
        g_free(name);
        return setting;
    }
    setting = g_new(struct setting, 1);
    *setting = (struct setting){.first = method, .least = HUGE_VAL};
    g_hash_table_insert(settings, name, setting);
    return setting;
}

/* Seconds of each variant of a case over the least of the same setting, if several methods ran it:
 * one that is alone in its setting would be the cheapest. */
static void take_costs(struct decision *decision, const json_t *entry)
{
    const json_t *variants = json_object_get(entry, "variants");
    GHashTable *settings = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free);
    for (int pass = 0; pass < 2; pass++)
        for (size_t i = 0; i < json_array_size(variants); i++) {
            const json_t *variant = json_array_get(variants, i);
            const char *name = record_text(variant, "variant");
            const double seconds = record_number(variant, "seconds");
            char *known = method_of(decision->parts, name);
            if (known == NULL || !(seconds > 0)) {
                g_free(known);
                continue;
            }
            struct method *method = find_method(decision, known);
            struct setting *setting =
                find_setting(settings, setting_of(decision->parts, name), method);
            const double ratio = seconds / setting->least;
            setting->least = fmin(setting->least, seconds);
            setting->compared = setting->compared || setting->first != method;
            if (pass == 1 && setting->compared)
                g_array_append_val(method->costs, ratio);
        }
    g_hash_table_unref(settings);
}

/* Share of the checks that it does not hold, then cost. Of methods with fewer than half of the
 * cases of the most measured one a share says little: they come last. */
static int compare_methods(const void *a, const void *b, void *data)
{
    const struct decision *decision = data;
    const struct method *one = *(struct method *const *)a, *other = *(struct method *const *)b;
    const bool few = 2 * one->cases->len < decision->most_cases;
    const bool other_few = 2 * other->cases->len < decision->most_cases;
    if (few != other_few)
        return few ? 1 : -1;
    const double share = (double)one->falling->len / fmax(1, (double)one->checks);
    const double other_share = (double)other->falling->len / fmax(1, (double)other->checks);
    if (share < other_share || share > other_share)
        return share < other_share ? -1 : 1;
    const double cost = isfinite(one->cost) ? one->cost : HUGE_VAL;
    const double other_cost = isfinite(other->cost) ? other->cost : HUGE_VAL;
    if (cost < other_cost || cost > other_cost)
        return cost < other_cost ? -1 : 1;
    return strcmp(one->name, other->name);
}

static struct decision decide(const struct records *records, const char *tag)
{
    const json_t *cases = json_object_get(records->run, "cases");
    struct decision decision = {.records = records,
                                .parts = parts_of(cases),
                                .methods = g_ptr_array_new_with_free_func(free_method),
                                .entries = g_ptr_array_new()};
    for (size_t i = 0; i < json_array_size(cases); i++)
        if (record_has_tag(json_array_get(cases, i), tag))
            g_ptr_array_add(decision.entries, json_array_get(cases, i));
    for (size_t i = 0; i < json_array_size(records->checks); i++) {
        json_t *check = json_array_get(records->checks, i);
        if (record_has_tag(records_case(records, record_text(check, "case")), tag))
            take_check(&decision, check);
    }
    for (unsigned i = 0; i < decision.entries->len; i++)
        take_costs(&decision, decision.entries->pdata[i]);
    for (unsigned i = decision.methods->len; i > 0; i--) { /* those that no check judges */
        struct method *method = decision.methods->pdata[i - 1];
        if (method->checks == 0) {
            g_ptr_array_remove_index(decision.methods, i - 1);
            continue;
        }
        if (method->costs->len > 0)
            method->cost =
                gsl_stats_median((double *)(void *)method->costs->data, 1, method->costs->len);
    }
    g_ptr_array_sort_with_data(decision.methods, compare_methods, &decision);
    return decision;
}

static void decision_clear(struct decision *decision)
{
    g_ptr_array_unref(decision->methods);
    g_ptr_array_unref(decision->entries);
}

/* ------------------------------------------------------------------------- words */

static void add_case_link(GString *html, const char *name, const char *page)
{
    text_markup(html, "<a href=\"cases/%s/%s\">%s</a>", name, page, name);
}

static GString *case_links(const GPtrArray *names)
{
    GString *html = g_string_new(NULL);
    for (unsigned i = 0; i < names->len; i++) {
        g_string_append(html, i == 0 ? "" : " ");
        add_case_link(html, names->pdata[i], "index.html#checks");
    }
    return html;
}

enum { FALLING_SHOWN = 4 };

static bool same_check(const json_t *one, const json_t *other)
{
    return strcmp(record_text(one, "case"), record_text(other, "case")) == 0 &&
           strcmp(record_text(one, "check"), record_text(other, "check")) == 0;
}

/* Whether one before `place` is of the same check. */
static bool is_told(const GPtrArray *falling, unsigned place)
{
    for (unsigned i = 0; i < place; i++)
        if (same_check(falling->pdata[i], falling->pdata[place]))
            return true;
    return false;
}

/* The least and the largest value with four digits; one number where these do not differ. */
static char *values_text(double low, double high, const char *unit)
{
    char *first = text_number(low), *last = text_quantity(high, unit), *end = text_number(high);
    char *text = strcmp(first, end) == 0 ? g_strdup(last) : g_strconcat(first, " .. ", last, NULL);
    g_free(end);
    g_free(last);
    g_free(first);
    return text;
}

/* Case, title, values, the band of a good method, and variants of a check that it does not hold. */
static void add_fall(GString *html, const GPtrArray *falling, unsigned place)
{
    const json_t *check = falling->pdata[place];
    double low = HUGE_VAL, high = -HUGE_VAL;
    GString *variants = g_string_new(NULL);
    for (unsigned i = place; i < falling->len; i++) {
        const double value = record_number(falling->pdata[i], "value");
        if (!same_check(check, falling->pdata[i]))
            continue;
        g_string_append_printf(variants, "%s%s", variants->len == 0 ? "" : ", ",
                               record_text(falling->pdata[i], "variant"));
        if (isfinite(value)) {
            low = fmin(low, value);
            high = fmax(high, value);
        }
    }
    g_string_append(html, "<li>");
    add_case_link(html, record_text(check, "case"), "index.html#checks");
    text_markup(html, ": %s, ", record_text(check, "title"));
    const char *unit = record_text(check, "unit");
    html_numbers(html, low < high ? values_text(low, high, unit) : text_value(check));
    g_string_append(html, " <span class=\"about\">(good: ");
    html_numbers(html, text_range(record_number(check, "low"), record_number(check, "high"), unit));
    text_markup(html, ") %s</span></li>", variants->str);
    g_string_free(variants, TRUE);
}

/* What it does not hold, the first few in sight. */
static void add_falling(GString *html, const GPtrArray *falling)
{
    unsigned told = 0, kinds = 0;
    for (unsigned i = 0; i < falling->len; i++)
        kinds += !is_told(falling, i);
    g_string_append(html, "<ul class=\"falling\">");
    for (unsigned i = 0; i < falling->len; i++) {
        if (is_told(falling, i))
            continue;
        if (told++ == FALLING_SHOWN)
            g_string_append_printf(html,
                                   "</ul><details><summary>and %u more</summary><ul "
                                   "class=\"falling\">",
                                   kinds - FALLING_SHOWN);
        add_fall(html, falling, i);
    }
    g_string_append(html, kinds > FALLING_SHOWN ? "</ul></details>" : "</ul>");
}

static void add_method(struct report_table *table, const struct method *method)
{
    const size_t held = method->checks - method->falling->len;
    GString *links = case_links(method->cases), *falling = g_string_new(NULL);
    char *names = g_strdup_printf("%u", method->cases->len);
    char *short_of = g_strdup_printf("%u", method->falling->len);
    if (method->falling->len > 0)
        add_falling(falling, method->falling);
    else
        g_string_append(falling, "in none of these");
    report_table_name(table, method->name);
    report_table_number(table, (double)held / (double)method->checks,
                        g_strdup_printf("%zu of %zu", held, method->checks));
    report_table_number(table, method->cost,
                        isfinite(method->cost) ? text_number(round(100 * method->cost) / 100)
                                               : g_strdup("not compared"));
    report_table_markup(table, short_of, falling);
    report_table_markup(table, names, links);
    g_free(short_of);
    g_free(names);
}

/* The first of the order, and the cheapest that holds as much, in a sentence. */
static void add_choice(GString *html, const struct decision *decision)
{
    const struct method *best = decision->methods->pdata[0];
    text_markup(html, "<p class=\"guide\"><strong>%s</strong> holds %zu of %zu checks in ",
                best->name, best->checks - best->falling->len, best->checks);
    char *cases = text_count(best->cases->len, "case");
    text_markup(html, "%s of %u", cases, decision->entries->len);
    if (isfinite(best->cost)) {
        g_string_append(html, "; it takes ");
        html_numbers(html, text_number(round(100 * best->cost) / 100));
        g_string_append(html, " times the time of the cheapest method in the same settings");
    }
    g_string_append(html, best->falling->len == 0 ? "." : ". It falls short in:");
    g_string_append(html, "</p>\n");
    if (best->falling->len > 0)
        add_falling(html, best->falling);
    g_free(cases);
}

/* What the comparisons of the purpose's cases state, each with its case. */
static void add_comparisons(GString *html, const struct decision *decision)
{
    for (unsigned i = 0; i < decision->entries->len; i++) {
        const json_t *entry = decision->entries->pdata[i];
        if (comparison_declared(entry) == NULL)
            continue;
        struct comparison_view view = comparison_view_make(decision->records, entry);
        const size_t leading = comparison_view_main(&view);
        char *guide = comparison_guide(&view.table, leading, comparison_view_cost(&view));
        char *outside = comparison_outside(&view.table);
        g_string_append(html, "<p>");
        add_case_link(html, record_text(entry, "case"), "comparison.html");
        text_markup(html, " <strong>%s.</strong> ", record_text(view.declared, "title"));
        html_numbers(html, g_strdup(guide));
        if (*outside != '\0') {
            g_string_append(html, " Not counted: ");
            html_numbers(html, g_strdup(outside));
            g_string_append_c(html, '.');
        }
        g_string_append(html, "</p>\n");
        g_free(outside);
        g_free(guide);
        comparison_view_clear(&view);
    }
}

static void add_purpose(GString *html, struct report_site *site, size_t place)
{
    static const struct report_column columns[] = {
        {"Method", NULL, CELLS_TEXT, false},
        {"Checks held", NULL, CELLS_NUMBER, true},
        {"Cost", "times the cheapest", CELLS_NUMBER, false},
        {"Falls short in", NULL, CELLS_WIDE, false},
        {"Measured in", NULL, CELLS_WIDE, false},
    };
    const char *tag = purposes[place].tag, *title = purposes[place].title;
    struct decision decision = decide(site->records, tag);
    text_markup(html, "<h2 id=\"%s\">%s</h2>\n", tag, title);
    if (decision.methods->len == 0) {
        g_string_append(html, "<p class=\"notice quiet\">This run has no case of it.</p>\n");
    } else {
        char *caption = g_strdup_printf("%s: methods by what they hold", title);
        char *csv = g_strdup_printf("decision-%s.csv", tag);
        struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
        for (unsigned i = 0; i < decision.methods->len; i++)
            add_method(table, decision.methods->pdata[i]);
        add_choice(html, &decision);
        add_comparisons(html, &decision);
        report_site_table(site, table, caption, csv, html);
        g_free(csv);
        g_free(caption);
    }
    decision_clear(&decision);
}

void report_decision_page(struct report_site *site)
{
    if (!site->compares)
        return;
    GString *html = g_string_new(
        "<h1>Which method for what</h1>\n<p class=\"lead\">For each purpose: which checks each "
        "method holds, what it costs, and where it falls short. All numbers are measured in this "
        "run.</p>\n<p class=\"about\">A method is a family of shape functions (classic, ugimp, "
        "cpdi, bspline2, bspline3) with an order of the stress update (usl, musl, usf, usavg), "
        "with "
        "all its variants in the cases of that purpose. It holds a check if the value is in the "
        "band of a good method; a check that is expected to fail is not held. The method with the "
        "largest share of checks held comes first, and of equal ones the cheapest; methods with "
        "fewer than half as many cases as the most measured one come last. Cost is the time of a "
        "run over that of the cheapest method in the same case and setting, as the median of all "
        "settings that two methods or more ran.</p>\n<nav "
        "aria-label=\"Purposes\"><ul class=\"here\">");
    for (size_t i = 0; i < G_N_ELEMENTS(purposes); i++)
        text_markup(html, "<li><a href=\"#%s\">%s</a></li>", purposes[i].tag, purposes[i].title);
    g_string_append(html, "</ul></nav>\n");
    for (size_t i = 0; i < G_N_ELEMENTS(purposes); i++)
        add_purpose(html, site, i);
    report_site_page(site, "decision.html", "Which method for what", html);
}

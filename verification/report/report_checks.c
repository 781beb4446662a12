/* The page of checks: every declared one with its variants, in one table to search.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/text.h"
#include "verification/pages/html.h"
#include "verification/records/check_text.h"
#include "verification/report/report_site.h"
#include "verification/report/verdict_html.h"

#include <math.h>
#include <string.h>

/* The checks of one declaration. */
struct declared {
    GPtrArray *checks;
    enum verdict_status worst;
    double least, margin; /* the worst margin, and the value with it */
};

static void free_declared(void *element)
{
    struct declared *declared = element;
    g_ptr_array_unref(declared->checks);
    g_free(declared);
}

/* Records of one case follow each other. */
static struct declared *find(const GPtrArray *all, const json_t *check)
{
    for (unsigned i = all->len; i > 0; i--) {
        struct declared *declared = all->pdata[i - 1];
        const json_t *first = declared->checks->pdata[0];
        if (strcmp(record_text(first, "case"), record_text(check, "case")) != 0)
            return NULL;
        if (record_same_declaration(first, check))
            return declared;
    }
    return NULL;
}

static GPtrArray *gather(const json_t *checks)
{
    GPtrArray *all = g_ptr_array_new_with_free_func(free_declared);
    for (size_t i = 0; i < json_array_size(checks); i++) {
        json_t *check = json_array_get(checks, i);
        struct declared *declared = find(all, check);
        if (declared == NULL) {
            declared = g_new0(struct declared, 1);
            declared->checks = g_ptr_array_new();
            declared->worst = record_status(check);
            declared->least = declared->margin = (double)NAN;
            g_ptr_array_add(all, declared);
        }
        const double margin = record_number(check, "margin");
        g_ptr_array_add(declared->checks, check);
        if (html_status_rank(record_status(check)) < html_status_rank(declared->worst))
            declared->worst = record_status(check);
        if (isfinite(margin) && !(declared->margin <= margin)) {
            declared->margin = margin;
            declared->least = record_number(check, "value");
        }
    }
    return all;
}

static void add_row(struct report_table *table, const struct declared *declared)
{
    const json_t *first = declared->checks->pdata[0];
    char *name = g_strdup_printf("%s/%s", record_text(first, "case"), record_text(first, "check"));
    char *href = g_strdup_printf("cases/%s/index.html#checks", record_text(first, "case"));
    char *band = text_band(first);
    GString *variants = g_string_new(NULL), *shown = g_string_new(NULL),
            *margin = g_string_new(NULL);
    for (unsigned i = 0; i < declared->checks->len; i++)
        g_string_append_printf(variants, "%s%s", i == 0 ? "" : " ",
                               record_text(declared->checks->pdata[i], "variant"));
    text_markup(shown, "<details><summary>%u</summary>%s</details>", declared->checks->len,
                variants->str);
    html_margin(margin, declared->margin);
    report_table_link(table, href, name);
    report_table_status(table, declared->worst);
    report_table_text(table, record_text(first, "title"));
    report_table_markup(table, variants->str, shown);
    report_table_number(table, declared->least,
                        text_quantity(declared->least, record_text(first, "unit")));
    report_table_text(table, band);
    report_table_value(table, declared->margin, margin);
    report_table_text(table, record_text(first, "basis"));
    report_table_text(table, record_text(first, "evidence"));
    g_string_free(variants, TRUE);
    g_free(band);
    g_free(href);
    g_free(name);
}

void report_checks_page(struct report_site *site)
{
    static const struct report_column columns[] = {
        {"Check", NULL, CELLS_TEXT, false},      {"Worst status", NULL, CELLS_TEXT, false},
        {"What it is", NULL, CELLS_WIDE, false}, {"Variants", NULL, CELLS_TEXT, false},
        {"Value", NULL, CELLS_NUMBER, false},    {"Band", NULL, CELLS_BAND, false},
        {"Margin", NULL, CELLS_TEXT, false},     {"Band from", NULL, CELLS_TEXT, false},
        {"Evidence", NULL, CELLS_TEXT, false},
    };
    GPtrArray *all = gather(site->records->checks);
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    GString *html = g_string_new(
        "<h1>Every check</h1>\n<p class=\"lead\">Search by case, check, variant, band, evidence or "
        "any word of what a check is.</p>\n<p class=\"about\">One row for each check as declared. "
        "Value and margin are those of the variant that is nearest to an end of the band.</p>\n");
    for (unsigned i = 0; i < all->len; i++)
        add_row(table, all->pdata[i]);
    report_table_sort(table);
    report_site_table(site, table, "Checks with their variants", "all-checks.csv", html);
    g_ptr_array_unref(all);
    report_site_page(site, "checks.html", "Every check", html);
}

void report_search(GString *html)
{
    g_string_append(html, "<form class=\"filter\" action=\"checks.html\" role=\"search\"><label "
                          "for=\"find\">Find checks</label><input type=\"search\" id=\"find\" "
                          "name=\"find\" /><button type=\"submit\">Search</button> <span>by case, "
                          "variant, band, evidence or any word</span></form>\n");
}

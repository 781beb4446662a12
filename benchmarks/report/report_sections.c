/* What the sections of the report share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/report/report_sections.h"

#include "verification/common/output.h"
#include "verification/common/record.h"
#include "verification/pages/figure.h"

#include <math.h>
#include <string.h>

/* -------------------------------------------------------------------- lines */

static bool has(const json_t *line, const char *key, const char *text)
{
    return text == NULL || strcmp(record_text(line, key), text) == 0;
}

GPtrArray *report_lines(const struct report *report, const char *kind, const char *group,
                        const char *quantity)
{
    GPtrArray *lines = g_ptr_array_new();
    const json_t *all = report->records->lines;
    for (size_t i = 0; i < json_array_size(all); i++) {
        json_t *line = json_array_get(all, i);
        if (has(line, "kind", kind) && has(line, "group", group) && has(line, "quantity", quantity))
            g_ptr_array_add(lines, line);
    }
    return lines;
}

const json_t *report_comparison(const struct report *report, const json_t *line)
{
    return bench_records_find(report->records, "comparison", record_text(line, "group"),
                              record_text(line, "point"), record_text(line, "quantity"));
}

const char *report_setting(const json_t *line, const char *key)
{
    return record_text(json_object_get(line, "settings"), key);
}

double report_number(const json_t *line, const char *key)
{
    return record_number(json_object_get(line, "settings"), key);
}

bool report_has(struct report *report, const char *group, const char *what)
{
    const bool found = bench_records_find(report->records, NULL, group, NULL, NULL) != NULL;
    if (!found)
        document_notice(report->document, "%s: this run did not select the group %s.", what, group);
    return found;
}

/* -------------------------------------------------------------------- words */

const char *report_word(const char *name)
{
    static const char *const words[][2] = {
        {"classic", "classic"},
        {"ugimp", "uGIMP"},
        {"cpdi", "CPDI"},
        {"bspline2", "B-spline 2"},
        {"bspline3", "B-spline 3"},
        {"usl", "USL"},
        {"musl", "MUSL"},
        {"usf", "USF"},
        {"usavg", "USAVG"},
        {"plane_strain", "plane strain"},
        {"plane_stress", "plane stress"},
        {"axisymmetric", "axisymmetric"},
        {"apic", "APIC"},
        {"xpic2", "XPIC(2)"},
        {"fmpm2", "FMPM(2)"},
        {"flip99", "FLIP 0.99"},
        {"momentum", "momentum form"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(words); i++)
        if (strcmp(name, words[i][0]) == 0)
            return words[i][1];
    return name;
}

char *report_variant_words(const struct bench_variant *variant)
{
    return g_strdup_printf("%s, %s%s%s", report_word(variant->shape),
                           report_word(variant->stress_update),
                           *variant->change == '\0' ? "" : ", ", report_word(variant->change));
}

char *report_variant(const json_t *line)
{
    static const char *const keys[] = {"shape", "stress_update", "geometry", "heat"};
    GString *text = g_string_new(NULL);
    for (size_t i = 0; i < G_N_ELEMENTS(keys); i++) {
        const char *word = report_word(report_setting(line, keys[i]));
        g_string_append_printf(text, "%s%s", text->len > 0 && *word != '\0' ? ", " : "", word);
    }
    return g_string_free(text, FALSE);
}

/* Thousands set apart, from five digits on. */
static void group_digits(GString *number)
{
    const gssize start = number->str[0] == '-' ? 1 : 0;
    if ((gssize)number->len - start < 5)
        return;
    for (gssize place = (gssize)number->len - 3; place > start; place -= 3)
        g_string_insert(number, place, "\u202f");
}

char *report_digits(double value, double scale)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE];
    const double scaled = value / scale, size = fabs(scaled);
    if (!isfinite(scaled))
        return g_strdup("none");
    if (size < 1 || size >= 1e12)
        return g_strdup(g_ascii_formatd(text, sizeof text, size > 0 ? "%#.3g" : "%.0f", scaled));
    /* three digits, zeros at the end included; large numbers whole */
    const char *format = size < 9.995 ? "%.2f" : size < 99.95 ? "%.1f" : "%.0f";
    GString *number = g_string_new(g_ascii_formatd(text, sizeof text, format, scaled));
    if (size >= 99.95)
        group_digits(number);
    return g_string_free(number, FALSE);
}

/* "10^4" with a raised 4. */
static void raise_exponents(GString *text)
{
    static const char *const raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    for (char *mark = strchr(text->str, '^'); mark != NULL; mark = strchr(text->str, '^')) {
        gssize place = mark - text->str;
        g_string_erase(text, place, 1);
        while (g_ascii_isdigit(text->str[place])) {
            const char *digit = raised[text->str[place] - '0'];
            g_string_erase(text, place, 1);
            g_string_insert(text, place, digit);
            place += (gssize)strlen(digit);
        }
    }
}

char *report_point(const struct report *report, const char *group, const char *point)
{
    const json_t *line = bench_records_find(report->records, "result", group, point, NULL);
    char *variant = report_variant(line);
    const char *more = strstr(point, ", ");
    GString *text = g_string_new(NULL);
    if (*variant == '\0')
        g_string_append(text, point);
    else
        g_string_append_printf(text, "%s%s", variant, more == NULL ? "" : more);
    raise_exponents(text);
    g_free(variant);
    return g_string_free(text, FALSE);
}

void report_cell_point(struct report *report, const json_t *line, const char *key, char *about)
{
    const char *point = record_text(line, key);
    document_cell(report->document,
                  *point == '\0' ? g_strdup("")
                                 : report_point(report, record_text(line, "group"), point),
                  about);
}

static char *interval(double low, double high, double scale)
{
    char *first = report_digits(low, scale), *last = report_digits(high, scale);
    char *text = g_strdup_printf("%s .. %s", first, last);
    g_free(first);
    g_free(last);
    return text;
}

void report_cell(struct report *report, const char *text)
{
    document_cell(report->document, g_strdup(text), NULL);
}

void report_cell_result(struct report *report, const json_t *line, double scale)
{
    if (line == NULL)
        report_cell(report, "none");
    else
        document_cell(report->document, report_digits(record_number(line, "median"), scale),
                      interval(record_number(line, "low"), record_number(line, "high"), scale));
}

void report_cell_ratio(struct report *report, const json_t *comparison, bool inverted)
{
    if (comparison == NULL) {
        report_cell(report, "");
        return;
    }
    const char *verdict = record_text(comparison, "verdict");
    const double ratio = record_number(comparison, "ratio");
    const double low = record_number(comparison, "low"), high = record_number(comparison, "high");
    char *range = inverted ? interval(1 / high, 1 / low, 1) : interval(low, high, 1);
    if (strcmp(verdict, "faster") != 0 && strcmp(verdict, "slower") != 0) {
        document_cell(report->document, g_strdup("not resolved"), range);
        return;
    }
    char *number = report_digits(inverted ? 1 / ratio : ratio, 1);
    document_cell(report->document, g_strdup_printf("%s %s", number, verdict), range);
    g_free(number);
}

/* ------------------------------------------------------------------ figures */

static char *settings_of(const struct report *report, const struct report_figure *figure,
                         const char *data)
{
    char *path = g_canonicalize_filename(data, NULL);
    char *texts[] = {figure_quoted(figure->name), figure_quoted(path),
                     figure_quoted(report->stamp)};
    char *settings = g_strdup_printf("name=%s; data=%s; variants=''; stamp=%s; %s", texts[0],
                                     texts[1], texts[2], figure->settings);
    for (size_t i = 0; i < G_N_ELEMENTS(texts); i++)
        g_free(texts[i]);
    g_free(path);
    return settings;
}

static struct figure_result plot(const struct report *report, const struct report_figure *figure,
                                 const char *data)
{
    char *settings = settings_of(report, figure, data);
    char *file = g_strconcat(figure->name, ".svg", NULL);
    char *name = g_strconcat("bench_", figure->script, ".gp", NULL);
    char *script = g_build_filename(report->scripts, name, NULL);
    char *style = g_build_filename(report->scripts, "style.gp", NULL);
    const struct figure_result result =
        figure_plot(&(struct figure_plot){.script = script,
                                          .style = style,
                                          .settings = settings,
                                          .folder = report->figures,
                                          .output = file,
                                          .title = figure->title,
                                          .description = figure->caption});
    g_free(settings);
    g_free(file);
    g_free(name);
    g_free(script);
    g_free(style);
    return result;
}

static struct figure_result draw(struct report *report, const struct report_figure *figure)
{
    struct figure_result result = {.state = FIGURE_FAILED};
    struct mpm_error error = {.status = MPM_OK};
    char *name = g_strconcat(figure->name, ".dat", NULL);
    char *path = g_build_filename(report->figures, name, NULL);
    if (output_write(report->figures, name, figure->data, &error) == MPM_OK)
        result = plot(report, figure, path);
    else
        g_strlcpy(result.reason, error.message, sizeof result.reason);
    g_free(path);
    g_free(name);
    return result;
}

void report_add_figure(struct report *report, const struct report_figure *figure)
{
    const struct figure_result result = draw(report, figure);
    if (result.state == FIGURE_DRAWN) {
        char *file = g_strdup_printf("figures/%s.svg", figure->name);
        document_figure(report->document, file, figure->title, figure->caption);
        g_free(file);
        return;
    }
    document_notice(report->document, "%s: the figure could not be drawn: %s", figure->title,
                    result.reason);
    if (report->failure == NULL)
        report->failure = g_strdup_printf("figure %s: %s", figure->name, result.reason);
}

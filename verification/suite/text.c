/* Small texts that the renderers share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/text.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

char *text_number(double value)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE];
    if (!isfinite(value))
        return g_strdup("none");
    return g_strdup(g_ascii_formatd(text, sizeof text, "%.4g", value));
}

char *text_quantity(double value, const char *unit)
{
    char *number = text_number(value);
    char *text = !isfinite(value) || strcmp(unit, "1") == 0 || *unit == '\0'
                     ? g_strdup(number)
                     : g_strdup_printf("%s %s", number, unit);
    g_free(number);
    return text;
}

char *text_band(const json_t *check)
{
    const bool weakness = json_is_number(json_object_get(check, "fails_low"));
    char *low = text_number(record_number(check, weakness ? "fails_low" : "low"));
    char *high = text_quantity(record_number(check, weakness ? "fails_high" : "high"),
                               record_text(check, "unit"));
    char *band = g_strdup_printf("%s .. %s", low, high);
    g_free(low);
    g_free(high);
    return band;
}

char *text_seconds(double seconds)
{
    if (seconds < 1)
        return g_strdup_printf("%.0f ms", 1000 * seconds);
    if (seconds < 60)
        return g_strdup_printf("%.1f s", seconds);
    return g_strdup_printf("%.0f min %.0f s", floor(seconds / 60), floor(fmod(seconds, 60)));
}

char *text_count(size_t count, const char *noun)
{
    return g_strdup_printf("%zu %s%s", count, noun, count == 1 ? "" : "s");
}

char *text_verdict(const struct record_counts *counts)
{
    const size_t judged = counts->total - counts->skipped;
    const size_t known = counts->of[VERDICT_EXPECTED_FAIL];
    char *total = text_count(judged, "check");
    GString *text = g_string_new(NULL);
    if (counts->failed > 0)
        g_string_append_printf(text, "%zu of %s %s not hold", counts->failed, total,
                               counts->failed == 1 ? "does" : "do");
    else if (judged == 0)
        g_string_append(text, "Nothing was verified: every check was skipped");
    else
        g_string_append_printf(text, judged == 1 ? "The one check holds" : "All %s hold", total);
    if (counts->failed == 0 && known > 0)
        g_string_append_printf(text, ", %zu of them by showing a known weakness", known);
    if (judged > 0 && counts->skipped > 0)
        g_string_append_printf(text, " (%zu skipped)", counts->skipped);
    g_free(total);
    return g_string_free(text, FALSE);
}

char *text_check_name(const json_t *check)
{
    return g_strdup_printf("%s/%s [%s]", record_text(check, "case"), record_text(check, "check"),
                           record_text(check, "variant"));
}

char *text_command(const char *name, const char *variant, bool full)
{
    return g_strdup_printf("mpm-verify run%s --case %s%s%s --output DIR",
                           full ? " --tier full" : "", name, variant == NULL ? "" : " --variant ",
                           variant == NULL ? "" : variant);
}

void text_markup(GString *string, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *text = g_markup_vprintf_escaped(format, arguments);
    va_end(arguments);
    g_string_append(string, text);
    g_free(text);
}

/* Small texts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/text.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

static char *number_with(double value, int digits)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE], format[16];
    if (!isfinite(value))
        return g_strdup("none");
    /* counts are written out: 12000, not 1.2e+04 */
    const bool count = value == floor(value) && fabs(value) < 1e7;
    g_snprintf(format, sizeof format, count ? "%%.0f" : "%%.%dg", digits);
    return g_strdup(g_ascii_formatd(text, sizeof text, format, value));
}

/* Takes the number over. */
static char *with_unit(char *number, const char *unit)
{
    if (strcmp(unit, "1") == 0 || *unit == '\0' || strcmp(number, "none") == 0)
        return number;
    char *text = g_strdup_printf("%s %s", number, unit);
    g_free(number);
    return text;
}

enum { DIGITS = 4, DIGITS_MAX = 15 };

char *text_number(double value)
{
    return number_with(value, DIGITS);
}

char *text_quantity(double value, const char *unit)
{
    return with_unit(text_number(value), unit);
}

/* Width of a band over its larger end: what a number needs digits for. */
static double relative_width(double low, double high)
{
    return (high - low) / fmax(fabs(low), fabs(high));
}

char *text_range(double low, double high, const char *unit)
{
    const bool narrow = relative_width(low, high) < 1e-3;
    char *first = narrow ? number_with(0.5 * (low + high), DIGITS_MAX) : text_number(low);
    char *last = narrow ? number_with(0.5 * (high - low), 2) : text_number(high);
    char *text = g_strconcat(first, narrow ? " ± " : " .. ", last, NULL);
    g_free(first);
    g_free(last);
    return with_unit(text, unit);
}

char *text_beside_range(double value, double low, double high, const char *unit)
{
    const double width = relative_width(low, high);
    const bool narrow = width > 0 && width < 1e-2;
    const int digits = narrow ? (int)fmin(DIGITS_MAX, 2 + ceil(-log10(width))) : DIGITS;
    return with_unit(number_with(value, MAX(digits, DIGITS)), unit);
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

void text_markup(GString *string, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *text = g_markup_vprintf_escaped(format, arguments);
    va_end(arguments);
    g_string_append(string, text);
    g_free(text);
}

void text_markdown(GString *markdown, const char *text)
{
    for (const char *c = text; *c != '\0'; c++) {
        if (*c == '<')
            g_string_append(markdown, "&lt;");
        else if (*c == '&')
            g_string_append(markdown, "&amp;");
        else if (*c == '\n' || *c == '\r')
            g_string_append_c(markdown, ' ');
        else if (strchr("\\`*_[]|~#>!", *c) != NULL)
            g_string_append_printf(markdown, "\\%c", *c);
        else
            g_string_append_c(markdown, *c);
    }
}

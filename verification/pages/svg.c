/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/svg.h"

#include "verification/common/text.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* ---------------------------------------------------------------------- view */

struct svg_view svg_view_of(const double low[2], const double high[2], double left, double top,
                            double width, double height)
{
    static const double least = 1e-9; /* of the coordinates: less has no digits left for tics */
    struct svg_view view = {.low = {low[0], low[1]}, .high = {high[0], high[1]}, .top = top};
    for (int axis = 0; axis < 2; axis++) {
        const double extent = least * fmax(fabs(low[axis]), fabs(high[axis]));
        if (high[axis] - low[axis] < extent)
            view.high[axis] = low[axis] + extent;
    }
    view.scale = fmin(width / (view.high[0] - view.low[0]), height / (view.high[1] - view.low[1]));
    view.left = left + 0.5 * (width - svg_width(&view));
    return view;
}

double svg_x(const struct svg_view *view, double x)
{
    return view->left + view->scale * (x - view->low[0]);
}

double svg_y(const struct svg_view *view, double y)
{
    return view->top + view->scale * (view->high[1] - y);
}

double svg_width(const struct svg_view *view)
{
    return view->scale * (view->high[0] - view->low[0]);
}

double svg_height(const struct svg_view *view)
{
    return view->scale * (view->high[1] - view->low[1]);
}

/* ---------------------------------------------------------------------- text */

void svg_number(GString *svg, double value)
{
    char number[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_formatd(number, sizeof number, "%.1f", value);
    char *const point = strchr(number, '.');
    if (point != NULL && strcmp(point, ".0") == 0)
        *point = '\0';
    g_string_append(svg, strcmp(number, "-0") == 0 ? "0" : number);
}

/* "1e-05" as "10⁻⁵", "2.5e+06" as "2.5·10⁶" */
static char *with_power(const char *number)
{
    static const char *const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    const char *const e = strchr(number, 'e');
    if (e == NULL)
        return g_strdup(number);
    GString *text = g_string_new_len(number, e - number);
    if (strcmp(text->str, "1") == 0)
        g_string_assign(text, "10");
    else if (strcmp(text->str, "-1") == 0)
        g_string_assign(text, "−10");
    else
        g_string_append(text, "·10");
    if (e[1] == '-')
        g_string_append(text, "⁻");
    const char *digit = e + 1 + strspn(e + 1, "+-");
    for (digit += strspn(digit, "0"); *digit != '\0'; digit++)
        g_string_append(text, digits[*digit - '0']);
    return g_string_free(text, FALSE);
}

static char *number_text(double value, const char *format)
{
    char number[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_formatd(number, sizeof number, format, value);
    char *text = with_power(number);
    if (text[0] != '-')
        return text;
    char *minus = g_strconcat("−", text + 1, NULL);
    g_free(text);
    return minus;
}

char *svg_value_text(double value)
{
    return number_text(value, "%.4g");
}

/* ------------------------------------------------------------------- elements */

void svg_begin(GString *svg, double width, double height, const char *kind, const char *title,
               const char *description, const char *style)
{
    g_string_append_printf(
        svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 "
        "%.0f %.0f\" class=\"%s\" role=\"img\" aria-labelledby=\"title description\">\n",
        width, height, width, height, kind);
    text_markup(svg, "<title id=\"title\">%s</title>\n<desc id=\"description\">%s</desc>\n", title,
                description);
    g_string_append_printf(
        svg,
        "<style>svg{color:#1f2328;background:#fff;font:13px Helvetica,Arial,sans-serif}"
        "text{fill:currentColor}.soft{fill:#59636e}.line,.thin{stroke:currentColor;fill:none}"
        ".thin{stroke-width:.6;opacity:.7}%s"
        "@media(prefers-color-scheme:dark){svg{color:#d8dee6;background:#15181c}"
        ".soft{fill:#98a3af}}</style>\n",
        style);
}

void svg_end(GString *svg)
{
    g_string_append(svg, "</svg>\n");
}

void svg_text(GString *svg, double x, double y, const char *anchor, const char *class,
              const char *text)
{
    g_string_append(svg, "<text x=\"");
    svg_number(svg, x);
    g_string_append(svg, "\" y=\"");
    svg_number(svg, y);
    text_markup(svg, "\" text-anchor=\"%s\" class=\"%s\">%s</text>\n", anchor, class, text);
}

void svg_line(GString *svg, const char *class, double x1, double y1, double x2, double y2)
{
    g_string_append_printf(svg, "<path class=\"%s\" d=\"M", class);
    svg_number(svg, x1);
    g_string_append_c(svg, ' ');
    svg_number(svg, y1);
    g_string_append_c(svg, 'L');
    svg_number(svg, x2);
    g_string_append_c(svg, ' ');
    svg_number(svg, y2);
    g_string_append(svg, "\"/>\n");
}

/* ----------------------------------------------------------------------- axes */

double svg_step(double range, double most)
{
    const double least = range / fmax(most, 1), ten = pow(10, floor(log10(least)));
    return least <= ten ? ten : least <= 2 * ten ? 2 * ten : least <= 5 * ten ? 5 * ten : 10 * ten;
}

char *svg_tic_text(double value, double step, double largest)
{
    enum { DIGITS_MAX = 9 };
    static const double small = 1e-3, large = 1e5; /* powers of ten are written out beyond */
    char format[8];
    const int decimals = (int)-floor(log10(step) + 1e-9);
    const double number = fabs(value) < 1e-9 * step ? 0 : value;
    if (largest >= small && largest < large && decimals <= DIGITS_MAX)
        g_snprintf(format, sizeof format, "%%.%df", MAX(decimals, 0));
    else if (fabs(number) > 0) /* every one: 0.0001 beside 5·10⁻⁵ is hard to compare */
        g_snprintf(format, sizeof format, "%%.%de",
                   CLAMP((int)floor(log10(fabs(number)) + 1e-9) + decimals, 0, DIGITS_MAX));
    else
        return g_strdup("0");
    return number_text(number, format);
}

static void add_tics(GString *svg, const struct svg_view *view, int axis)
{
    enum { TIC = 5, APART_X = 64, APART_Y = 34 };
    const double low = view->low[axis], high = view->high[axis];
    const double length = axis == 0 ? svg_width(view) : svg_height(view);
    const double step = svg_step(high - low, length / (axis == 0 ? APART_X : APART_Y));
    const double bottom = view->top + svg_height(view);
    for (double k = ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) {
        char *text = svg_tic_text(k * step, step, fmax(fabs(low), fabs(high)));
        const double x = svg_x(view, k * step), y = svg_y(view, k * step);
        if (axis == 0) {
            svg_line(svg, "line", x, bottom, x, bottom + TIC);
            svg_text(svg, x, bottom + TIC + 13, "middle", "", text);
        } else {
            svg_line(svg, "line", view->left, y, view->left - TIC, y);
            svg_text(svg, view->left - TIC - 4, y + 4.5, "end", "", text);
        }
        g_free(text);
    }
}

void svg_turned_text(GString *svg, double x, double y, const char *text)
{
    g_string_append(svg, "<g transform=\"translate(");
    svg_number(svg, x);
    g_string_append_c(svg, ' ');
    svg_number(svg, y);
    g_string_append(svg, ") rotate(-90)\">");
    svg_text(svg, 0, 0, "middle", "", text);
    g_string_append(svg, "</g>\n");
}

void svg_axes(GString *svg, const struct svg_view *view, char *const names[2])
{
    enum { TITLE = 60 };
    const double bottom = view->top + svg_height(view);
    g_string_append(svg, "<path class=\"line\" d=\"M");
    svg_number(svg, view->left);
    g_string_append_c(svg, ' ');
    svg_number(svg, view->top);
    g_string_append_c(svg, 'V');
    svg_number(svg, bottom);
    g_string_append_c(svg, 'h');
    svg_number(svg, svg_width(view));
    g_string_append(svg, "\"/>\n");
    for (int axis = 0; axis < 2; axis++)
        add_tics(svg, view, axis);
    svg_text(svg, view->left + svg_width(view) / 2, bottom + 36, "middle", "", names[0]);
    svg_turned_text(svg, view->left - TITLE, view->top + svg_height(view) / 2, names[1]);
}

/* Ranges of axes and their tics.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison/axis_tics.h"

#include <glib.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* -------------------------------------------------------------------- widths */

/* Widths of letters in sizes of the font: what is wider of Verdana and DejaVu Sans, rounded up.
 * Helvetica, Arial, Liberation Sans and Noto Sans are narrower. */
static const struct {
    const char *letters;
    double width;
} letters[] = {
    {"ijl.,'", 0.4},
    {"frtI()[]- /:;|!", 0.48},
    {"mMwW%@", 1.08},
    {"+=<>~^ABCDEFGHJKLNOPQRSTUVXYZ&#", 0.85},
};
static const double OTHER_LETTER = 0.66, OTHER_SIGN = 1.0, SMALLER = 0.8;

static double letter_width(unsigned char letter)
{
    if (letter >= 0x80) /* the first byte of a sign counts, the others do not */
        return letter >= 0xC0 ? OTHER_SIGN : 0.0;
    for (size_t i = 0; i < G_N_ELEMENTS(letters); i++)
        if (strchr(letters[i].letters, letter) != NULL)
            return letters[i].width;
    return OTHER_LETTER;
}

double axis_text_width(const char *text, double font)
{
    double width = 0.0, size = font;
    for (const char *c = text; *c != '\0'; c++) {
        if (c[0] == '^' && c[1] == '{') {
            size = SMALLER * font;
            c++;
        } else if (*c == '}' && size < font) {
            size = font;
        } else {
            width += size * letter_width((unsigned char)*c);
        }
    }
    return width;
}

/* -------------------------------------------------------------------- ranges */

static const double MARGIN = 0.08, SAME = 1e-6, LARGEST = 1e300;

struct axis_range axis_range_of(double low, double high)
{
    struct axis_range range = {fmax(low, -LARGEST), fmin(high, LARGEST), false};
    /* outside of these gnuplot has no tics */
    range.logarithmic = low > 1 / LARGEST && high < LARGEST && high / 10 > low;
    const double largest = fmax(fabs(range.low), fabs(range.high));
    if (range.logarithmic) {
        const double margin = exp(MARGIN * (log(high) - log(low)));
        range.low = fmax(low / margin, 1 / LARGEST);
        range.high = fmin(high * margin, LARGEST);
    } else if (range.high / 2 - range.low / 2 > SAME * largest / 2) {
        const double margin = MARGIN * (range.high - range.low);
        range.low -= margin;
        range.high += margin;
    } else {
        const double margin = largest > 1 / LARGEST ? 0.1 * largest : 1.0;
        range.low -= margin;
        range.high += margin;
    }
    return range;
}

double axis_place(const struct axis_range *range, double value)
{
    const double place = range->logarithmic
                             ? (log(value) - log(range->low)) / (log(range->high) - log(range->low))
                             : (value / 2 - range->low / 2) / (range->high / 2 - range->low / 2);
    return fmin(fmax(place, 0.0), 1.0);
}

/* ---------------------------------------------------------------------- tics */

static const double GAP = 8; /* pixels between labels */

static double ten_to(int power)
{
    char text[16];
    (void)snprintf(text, sizeof text, "1e%d", power);
    return g_ascii_strtod(text, NULL); /* pow(10, power) is off by round-off */
}

/* "5e+06" as "5·10^{6}", "1e+06" as "10^{6}" */
static void write_out_power(char text[AXIS_TIC_TEXT])
{
    char *const e = strchr(text, 'e');
    if (e == NULL)
        return;
    const int power = (int)g_ascii_strtoll(e + 1, NULL, 10);
    *e = '\0';
    const bool one = strcmp(text, "1") == 0 || strcmp(text, "-1") == 0;
    char *const number = g_strndup(text, strlen(text) - (one ? 1 : 0));
    (void)snprintf(text, AXIS_TIC_TEXT, "%s%s10^{%d}", number, one ? "" : "·", power);
    g_free(number);
}

static void write_number(char text[AXIS_TIC_TEXT], double value, int digits)
{
    char format[8];
    (void)snprintf(format, sizeof format, "%%.%dg", digits);
    (void)g_ascii_formatd(text, AXIS_TIC_TEXT, format, value);
    write_out_power(text);
}

static void write_power(char text[AXIS_TIC_TEXT], int step, int power)
{
    if (power >= -3 && power <= 3)
        write_number(text, step * ten_to(power), 6);
    else if (step > 1)
        (void)snprintf(text, AXIS_TIC_TEXT, "%d·10^{%d}", step, power);
    else
        (void)snprintf(text, AXIS_TIC_TEXT, "10^{%d}", power);
}

static bool is_within(const struct axis_range *range, double value)
{
    return value >= range->low && value <= range->high;
}

static double position(const struct axis_range *range, const struct axis_room *room,
                       const struct axis_tic *tic)
{
    return room->length * axis_place(range, tic->value);
}

/* Labels that would leave the picture at an end of the axis are left out. */
static bool add(const struct axis_range *range, const struct axis_room *room,
                struct axis_tic tics[AXIS_TICS_MAX], size_t *count, struct axis_tic tic)
{
    tic.width = axis_text_width(tic.text, room->font);
    const double at = position(range, room, &tic);
    if (room->along &&
        (at - tic.width / 2 < -room->beyond || at + tic.width / 2 > room->length + room->beyond))
        return true;
    if (*count == AXIS_TICS_MAX)
        return false;
    tics[(*count)++] = tic;
    return true;
}

static bool fit(const struct axis_range *range, const struct axis_room *room,
                const struct axis_tic tics[AXIS_TICS_MAX], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (!room->along && tics[i].width > room->across)
            return false;
        if (i == 0)
            continue;
        const double apart = position(range, room, &tics[i]) - position(range, room, &tics[i - 1]);
        const double needed = room->along ? (tics[i].width + tics[i - 1].width) / 2 : room->font;
        if (apart < needed + GAP)
            return false;
    }
    return true;
}

static size_t logarithmic_tics(const struct axis_range *range, const struct axis_room *room,
                               bool between, int every, struct axis_tic tics[AXIS_TICS_MAX])
{
    static const int steps[] = {1, 2, 5};
    size_t count = 0;
    for (int power = (int)floor(log10(range->low)); power <= (int)ceil(log10(range->high)); power++)
        for (size_t i = 0; i < (between ? G_N_ELEMENTS(steps) : 1); i++) {
            struct axis_tic tic = {.value = steps[i] * ten_to(power)};
            if (!is_within(range, tic.value) || power % every != 0)
                continue;
            write_power(tic.text, steps[i], power);
            if (!add(range, room, tics, &count, tic))
                return 0;
        }
    return fit(range, room, tics, count) ? count : 0;
}

/* Multiples of step 10^power, with the digits that tell them apart. */
static size_t linear_tics(const struct axis_range *range, const struct axis_room *room, int step,
                          int power, struct axis_tic tics[AXIS_TICS_MAX])
{
    enum { DIGITS_MAX = 15 };
    const double unit = step * ten_to(power);
    const double largest = fmax(fabs(range->low), fabs(range->high));
    const int digits = (int)floor(log10(largest)) - power + 1;
    if (digits > DIGITS_MAX)
        return 0;
    size_t count = 0;
    const double first = ceil(range->low / unit), last = floor(range->high / unit);
    for (double k = first; k <= last; k++) {
        struct axis_tic tic = {.value = power < 0 ? k * step / ten_to(-power) : k * unit};
        write_number(tic.text, tic.value == 0 ? 0 : tic.value, digits < 1 ? 1 : digits);
        if (is_within(range, tic.value) && !add(range, room, tics, &count, tic))
            return 0;
    }
    return fit(range, room, tics, count) ? count : 0;
}

size_t axis_tics(const struct axis_range *range, const struct axis_room *room,
                 struct axis_tic tics[AXIS_TICS_MAX])
{
    static const int steps[] = {1, 2, 5};
    size_t count = 0;
    if (range->logarithmic) {
        const int decades = (int)ceil(log10(range->high) - log10(range->low));
        count = logarithmic_tics(range, room, true, 1, tics);
        for (int every = 1; count == 0 && every <= decades; every++)
            count = logarithmic_tics(range, room, false, every, tics);
        return count;
    }
    /* from a tenth of the range to all of it */
    const int power = (int)floor(log10(range->high / 2 - range->low / 2)) - 1;
    for (int k = 0; count == 0 && k < 8; k++)
        count = linear_tics(range, room, steps[k % 3], MAX(power, -300) + k / 3, tics);
    return count;
}

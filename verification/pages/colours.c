/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/colours.h"

#include <glib.h>
#include <math.h>

/* Lightness, chroma, hue in degrees. */
struct colour {
    double lightness, chroma, hue;
};

static double between(double from, double to, double place)
{
    return from + (to - from) * place;
}

/* A component of sRGB, 0 to 1, from a linear one. */
static double curve(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

/* Ottosson, "A perceptual color space for image processing" (2020). */
static void to_rgb(struct colour colour, double rgb[3])
{
    const double hue = colour.hue * G_PI / 180;
    const double a = colour.chroma * cos(hue), b = colour.chroma * sin(hue);
    const double l = pow(colour.lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = pow(colour.lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = pow(colour.lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    rgb[0] = 4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s;
    rgb[1] = -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s;
    rgb[2] = -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s;
}

static bool is_shown(const double rgb[3])
{
    for (int i = 0; i < 3; i++)
        if (!(rgb[i] >= 0 && rgb[i] <= 1))
            return false;
    return true;
}

static struct colour sequential(double place)
{
    return (struct colour){between(0.33, 0.93, place), between(0.17, 0.16, place),
                           between(295, 105, place)};
}

/* Lightest in the middle; both ends are as dark. */
static struct colour both_ways(double place)
{
    const double far = fabs(2 * place - 1);
    return (struct colour){between(0.95, 0.42, far), between(0.0, 0.17, pow(far, 0.8)),
                           place < 0.5 ? 255.0 : 45.0};
}

void colour_at(double place, bool diverging, char text[COLOUR_SIZE])
{
    const double bounded = fmin(fmax(place, 0), 1);
    struct colour colour = diverging ? both_ways(bounded) : sequential(bounded);
    double rgb[3];
    /* what a screen cannot show loses chroma, not lightness */
    for (to_rgb(colour, rgb); !is_shown(rgb) && colour.chroma > 0.001; to_rgb(colour, rgb))
        colour.chroma *= 0.97;
    int bytes[3];
    for (int i = 0; i < 3; i++)
        bytes[i] = (int)lround(255 * curve(fmin(fmax(rgb[i], 0), 1)));
    g_snprintf(text, COLOUR_SIZE, "#%02x%02x%02x", (unsigned)bytes[0], (unsigned)bytes[1],
               (unsigned)bytes[2]);
}

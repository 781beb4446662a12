/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/units.h"

#include <glib.h>

enum { FACTORS = 4 };

struct factor {
    const char *name;
    int exponent;
};

/* Appends the factors whose exponents have the sign, or all with 0; returns how many. */
static int append_factors(const struct factor factors[FACTORS], int sign, char text[MPM_UNIT_SIZE])
{
    int appended = 0;
    for (int i = 0; i < FACTORS; i++) {
        const int exponent = sign == 0 ? factors[i].exponent : sign * factors[i].exponent;
        if (exponent == 0 || (sign != 0 && exponent < 0))
            continue;
        char power[16] = "";
        if (exponent != 1)
            g_snprintf(power, sizeof power, "^%d", exponent);
        if (appended++ > 0)
            g_strlcat(text, " ", MPM_UNIT_SIZE);
        g_strlcat(text, factors[i].name, MPM_UNIT_SIZE);
        g_strlcat(text, power, MPM_UNIT_SIZE);
    }
    return appended;
}

void mpm_unit_text(const struct mpm_scene *scene, struct mpm_dimension dimension,
                   char text[MPM_UNIT_SIZE])
{
    const struct factor factors[FACTORS] = {
        {scene->units_mass[0] != '\0' ? scene->units_mass : "mass", dimension.mass},
        {scene->units_length[0] != '\0' ? scene->units_length : "length", dimension.length},
        {scene->units_time[0] != '\0' ? scene->units_time : "time", dimension.time},
        {scene->units_temperature[0] != '\0' ? scene->units_temperature : "temperature",
         dimension.temperature},
    };
    text[0] = '\0';
    if (append_factors(factors, 0, text) == 0)
        g_strlcpy(text, "1", MPM_UNIT_SIZE);
}

/* No field's dimension has all four units. */
_Static_assert((int)MPM_UNIT_SIZE / 4 * 3 <= (int)MPM_FIELD_UNIT_SIZE, "units would be cut");

void mpm_scene_field_unit(const struct mpm_scene *scene, enum mpm_field field,
                          char text[MPM_FIELD_UNIT_SIZE])
{
    char whole[MPM_UNIT_SIZE];
    mpm_unit_text(scene, mpm_field_describe(field)->dimension, whole);
    g_strlcpy(text, whole, MPM_FIELD_UNIT_SIZE);
}

void mpm_dimension_text(struct mpm_dimension dimension, char text[MPM_UNIT_SIZE])
{
    const struct factor factors[FACTORS] = {{"mass", dimension.mass},
                                            {"length", dimension.length},
                                            {"time", dimension.time},
                                            {"temperature", dimension.temperature}};
    char below[MPM_UNIT_SIZE] = "";
    const int under = append_factors(factors, -1, below);
    text[0] = '\0';
    if (append_factors(factors, 1, text) == 0 && under > 0)
        g_strlcpy(text, "1", MPM_UNIT_SIZE);
    if (under == 0)
        return;
    g_strlcat(text, under > 1 ? "/(" : "/", MPM_UNIT_SIZE);
    g_strlcat(text, below, MPM_UNIT_SIZE);
    if (under > 1)
        g_strlcat(text, ")", MPM_UNIT_SIZE);
}

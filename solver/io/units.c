/* Names of units, made of the scene's own units.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/units.h"

#include <glib.h>

void mpm_unit_text(const struct mpm_scene *scene, int length, int mass, int time,
                   char text[MPM_UNIT_SIZE])
{
    const struct {
        const char *name, *unnamed;
        int exponent;
    } factors[] = {
        {scene->units_mass, "mass", mass},
        {scene->units_length, "length", length},
        {scene->units_time, "time", time},
    };
    text[0] = '\0';
    for (size_t i = 0; i < G_N_ELEMENTS(factors); i++) {
        if (factors[i].exponent == 0)
            continue;
        char factor[MPM_NAME_SIZE + 16];
        const char *name = factors[i].name[0] != '\0' ? factors[i].name : factors[i].unnamed;
        if (factors[i].exponent == 1)
            g_strlcpy(factor, name, sizeof factor);
        else
            g_snprintf(factor, sizeof factor, "%s^%d", name, factors[i].exponent);
        if (text[0] != '\0')
            g_strlcat(text, " ", MPM_UNIT_SIZE);
        g_strlcat(text, factor, MPM_UNIT_SIZE);
    }
    if (text[0] == '\0')
        g_strlcpy(text, "1", MPM_UNIT_SIZE);
}

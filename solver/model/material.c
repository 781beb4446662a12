/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/material.h"

#include <string.h>

#define LAW_ADDRESS(name) &mpm_##name,
static const struct mpm_material_law *const laws[] = {MPM_MATERIAL_LAWS(LAW_ADDRESS)};

const struct mpm_material_law *mpm_material_law_find(const char *name)
{
    for (size_t k = 0; k < sizeof laws / sizeof laws[0]; k++)
        if (strcmp(laws[k]->name, name) == 0)
            return laws[k];
    return NULL;
}

const char *mpm_material_law_names(void)
{
#define LAW_NAME(name) ", " #name
    static const char names[] = MPM_MATERIAL_LAWS(LAW_NAME);
    return names + strlen(", ");
}

struct mpm_material mpm_material_make(const struct mpm_material_law *law, double density,
                                      double bulk, double shear)
{
    return (struct mpm_material){
        .law = law,
        .density = density,
        .bulk = bulk / density,
        .shear = shear / density,
        .lame = (bulk - 2.0 / 3.0 * shear) / density,
    };
}

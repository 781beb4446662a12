/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/contact/contact_history.h"

#include <stdio.h>
#include <string.h>

enum mpm_status contact_history_find(const struct mpm_scene *scene, size_t first, size_t second,
                                     const char *what, size_t *index, struct mpm_error *error)
{
    char name[MPM_QUANTITY_NAME_SIZE];
    (void)snprintf(name, sizeof name, "contact_%zu_%zu_%s", first, second, what);
    for (*index = 0; *index < mpm_scene_contact_quantity_count(scene); ++*index)
        if (strcmp(mpm_scene_contact_quantity(scene, *index).name, name) == 0)
            return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT, "the scene's history has no %s", name);
}

/* Is the name "contact_<first>_<second>_<what>"? */
static bool is_of(const char *name, const char *what)
{
    for (int k = 0; k < 3 && name != NULL; k++) {
        name = strchr(name, '_');
        name += name != NULL;
    }
    return name != NULL && strcmp(name, what) == 0;
}

double contact_history_sum(const struct mpm_scene *scene, const struct mpm_simulation *simulation,
                           const char *what)
{
    double sum = 0.0;
    for (size_t k = 0; k < mpm_scene_contact_quantity_count(scene); k++)
        if (is_of(mpm_scene_contact_quantity(scene, k).name, what))
            sum += mpm_simulation_contact_quantity(simulation, k);
    return sum;
}

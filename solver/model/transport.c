/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/transport.h"

#include "model/particles.h"
#include "model/scene.h"
#include "mpm_transport.h"

const struct mpm_scalar_row mpm_scalar_rows[MPM_SCALAR_COUNT] = {
    [MPM_TEMPERATURE] = {.name = "temperature",
                         .use = MPM_USE_TEMPERATURE,
                         .field = MPM_PARTICLE_TEMPERATURE,
                         .content = MPM_DIMENSION_ENERGY,
                         .content_name = "thermal_energy",
                         .flow_name = "heat",
                         .tables = {"heat_capacity_table", "conductivity_table"}},
    [MPM_CONCENTRATION] = {.name = "concentration",
                           .use = MPM_USE_CONCENTRATION,
                           .field = MPM_PARTICLE_CONCENTRATION,
                           .content = MPM_DIMENSION_MASS,
                           .content_name = "solvent_mass",
                           .flow_name = "solvent",
                           .tables = {[MPM_TABLE_CONDUCTIVITY] = "diffusivity_table"}},
};

bool mpm_scene_expands(const struct mpm_scene *scene)
{
    bool any = false;
    for (size_t k = 0; k < scene->material_count; k++)
        for (size_t which = 0; which < MPM_SCALAR_COUNT; which++)
            any = any || scene->materials[k].expansion[which].coefficient != 0.0;
    return any;
}

bool mpm_scene_reads_temperature(const struct mpm_scene *scene)
{
    bool any = false;
    for (size_t k = 0; k < scene->material_count; k++)
        any = any || scene->materials[k].law->reads_temperature;
    return any;
}

bool mpm_scene_has_tables(const struct mpm_scene *scene)
{
    bool any = false;
    for (size_t k = 0; k < scene->material_count; k++)
        for (int which = 0; which < MPM_SCALAR_COUNT; which++)
            for (int table = 0; table < MPM_TABLE_COUNT; table++)
                any = any || scene->materials[k].conduction[which].tables[table].count > 0;
    return any;
}

bool mpm_scene_has_plastic_heat(const struct mpm_scene *scene)
{
    bool any = false;
    for (size_t k = 0; k < scene->material_count; k++)
        any = any || mpm_material_plastic_heating(scene->materials[k].law,
                                                  scene->materials[k].parameter) > 0.0;
    return any;
}

bool mpm_scene_softens(const struct mpm_scene *scene)
{
    bool any = false;
    for (size_t k = 0; k < scene->material_count; k++)
        any = any || mpm_material_softens(scene->materials[k].law, scene->materials[k].parameter);
    return any;
}

bool mpm_scene_couples(const struct mpm_scene *scene)
{
    return mpm_scene_expands(scene) || mpm_scene_reads_temperature(scene) ||
           mpm_scene_has_plastic_heat(scene) || mpm_scene_softens(scene);
}

bool mpm_scene_heats(const struct mpm_scene *scene)
{
    return scene->scalars[MPM_TEMPERATURE].heats;
}

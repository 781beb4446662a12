/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/material.h"

#include "model/particles.h"

#include <math.h>
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

bool mpm_material_law_has_plane_stress(const struct mpm_material_law *law)
{
    return law->thickness_stretch != NULL || law->plane_stress;
}

const char *mpm_material_law_names(void)
{
#define LAW_NAME(name) ", " #name
    static const char names[] = MPM_MATERIAL_LAWS(LAW_NAME);
    return names + strlen(", ");
}

const struct mpm_material_law *mpm_material_law_at(size_t index)
{
    return index < sizeof laws / sizeof laws[0] ? laws[index] : NULL;
}

const char *mpm_parameter_key(enum mpm_parameter parameter)
{
#define PARAMETER_KEY(a, b, name, key, ...) [MPM_PARAMETER_##name] = #key,
    static const char *const keys[] = {MPM_LAW_PARAMETERS(PARAMETER_KEY, , )};
    return keys[parameter];
}

const struct mpm_law_parameter *mpm_law_parameter(const struct mpm_material_law *law,
                                                  enum mpm_parameter which)
{
    for (size_t k = 0; k < law->parameter_count; k++)
        if (law->parameters[k].which == which)
            return &law->parameters[k];
    return NULL;
}

size_t mpm_law_state_count(const struct mpm_material_law *law)
{
    return law->variable_count + (law->energy == NULL ? 1 : 0);
}

struct mpm_material mpm_material_make(const struct mpm_material_law *law, double density,
                                      const double *parameter, const struct mpm_property *hardening)
{
    const double bulk = parameter[MPM_PARAMETER_BULK], shear = parameter[MPM_PARAMETER_SHEAR];
    return (struct mpm_material){
        .law = law,
        .density = density,
        .bulk = bulk / density,
        .shear = shear / density,
        .lame = (bulk - 2.0 / 3.0 * shear) / density,
        .parameter = parameter,
        .hardening = hardening != NULL && hardening->count > 0 ? hardening : NULL,
    };
}

void mpm_material_start(const struct mpm_material *material, double *state)
{
    for (size_t k = 0; k < material->law->variable_count; k++)
        state[k] = material->law->variables[k].start;
    if (material->law->start != NULL)
        material->law->start(material, state);
}

bool mpm_material_has_temperature(const struct mpm_material_law *law, const double *parameter)
{
    return law->temperature != NULL && parameter[MPM_PARAMETER_SPECIFIC_HEAT] > 0.0;
}

double mpm_material_plastic_heating(const struct mpm_material_law *law, const double *parameter)
{
    const bool conducted = law->dissipation != NULL && !law->keeps_heat &&
                           !mpm_material_has_temperature(law, parameter);
    return conducted && parameter[MPM_PARAMETER_TAYLOR_QUINNEY] > 0.0
               ? parameter[MPM_PARAMETER_TAYLOR_QUINNEY]
               : 0.0;
}

bool mpm_material_softens(const struct mpm_material_law *law, const double *parameter)
{
    return parameter[MPM_PARAMETER_MELTING_TEMPERATURE] > 0.0 &&
           !mpm_material_has_temperature(law, parameter);
}

double mpm_material_start_wave(const struct mpm_material *material)
{
    static const double f[MPM_GRADIENT_SIZE] = {[MPM_XX] = 1.0, [MPM_YY] = 1.0, [MPM_ZZ] = 1.0};
    static const struct mpm_law_step none = {.old_f = f,
                                             .f = f,
                                             .temperature = (double)NAN,
                                             .heat_capacity = (double)NAN,
                                             .start_temperature = (double)NAN};
    const struct mpm_material_law *const law = material->law;
    double stress[MPM_SYMMETRIC_SIZE], state[MPM_LAW_STATES], square;
    if (law->update == NULL) {
        law->stress(material, f, stress, &square);
        return square;
    }
    mpm_material_start(material, state);
    (void)law->update(material, &none, state, stress, &square);
    return square;
}

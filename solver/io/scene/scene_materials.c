/* The materials of a scene: density, law, and what the law has as parameters.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"
#include "io/scene/scene_schema.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The parameters of a material as the scene has them, by enum mpm_parameter; NULL where missing. */
struct given {
    const char *text[MPM_PARAMETER_COUNT];
};

static struct given parameters_of(const struct mpm_raw_material *raw)
{
#define PARAMETER_TEXT(a, b, name, key, ...) [MPM_PARAMETER_##name] = raw->key,
    return (struct given){.text = {MPM_LAW_PARAMETERS(PARAMETER_TEXT, , )}};
}

/* "bulk, shear" */
static const char *keys_of(const struct mpm_material_law *law, char *text, size_t size)
{
    size_t used = 0;
    for (size_t k = 0; k < law->parameter_count && used < size; k++)
        used += (size_t)snprintf(text + used, size - used, "%s%s", k > 0 ? ", " : "",
                                 mpm_parameter_key(law->parameters[k].which));
    return law->parameter_count > 0 ? text : "none";
}

static bool is_elastic(const struct mpm_material_law *law)
{
    return mpm_law_parameter(law, MPM_PARAMETER_BULK) != NULL &&
           mpm_law_parameter(law, MPM_PARAMETER_SHEAR) != NULL;
}

static enum mpm_status refuse_others(const struct mpm_reading *reading, const char *path,
                                     const struct mpm_material_law *law,
                                     const struct mpm_raw_material *raw)
{
    const struct given given = parameters_of(raw);
    const char *other = NULL;
    for (int k = 0; k < MPM_PARAMETER_COUNT; k++)
        if (given.text[k] != NULL && mpm_law_parameter(law, (enum mpm_parameter)k) == NULL)
            other = mpm_parameter_key((enum mpm_parameter)k);
    if (!is_elastic(law) && (raw->young != NULL || raw->poisson != NULL))
        other = raw->young != NULL ? "young" : "poisson";
    if (other == NULL)
        return MPM_OK;
    char allowed[MPM_PATH_SIZE];
    return mpm_reading_fault(reading, path, "the law %s has no parameter %s; allowed: %s%s",
                             law->name, other, keys_of(law, allowed, sizeof allowed),
                             is_elastic(law) ? ", or young, poisson for the moduli" : "");
}

/* ------------------------------------------------------------ elastic constants */

static enum mpm_status check_pairs(const struct mpm_reading *reading, const char *path,
                                   const struct mpm_raw_material *raw)
{
    const bool bulk = raw->bulk != NULL, shear = raw->shear != NULL;
    const bool young = raw->young != NULL, poisson = raw->poisson != NULL;
    if (bulk == shear && young == poisson && bulk != young)
        return MPM_OK;
    return mpm_reading_fault(reading, path,
                             "wrong elastic constants, got%s%s%s%s%s; allowed: bulk and shear, or "
                             "young and poisson",
                             bulk ? " bulk" : "", shear ? " shear" : "", young ? " young" : "",
                             poisson ? " poisson" : "",
                             bulk || shear || young || poisson ? "" : " none");
}

static enum mpm_status build_moduli(const struct mpm_reading *reading, const char *path,
                                    const struct mpm_raw_material *raw, double *parameter)
{
    double *const bulk = &parameter[MPM_PARAMETER_BULK];
    double *const shear = &parameter[MPM_PARAMETER_SHEAR];
    MPM_TRY(check_pairs(reading, path, raw));
    if (raw->bulk == NULL) {
        const double young = mpm_raw_double(raw->young), poisson = mpm_raw_double(raw->poisson);
        *bulk = young / (3.0 * (1.0 - 2.0 * poisson));
        *shear = young / (2.0 * (1.0 + poisson));
    }
    if (isfinite(*bulk) && *bulk > 0.0 && isfinite(*shear) && *shear > 0.0)
        return MPM_OK;
    return mpm_reading_fault(reading, path,
                             "elastic constants beyond what numbers hold, got bulk modulus %g and "
                             "shear modulus %g; allowed: finite, above 0",
                             *bulk, *shear);
}

/* ------------------------------------------------------------------- parameters */

static enum mpm_status check_required(const struct mpm_reading *reading, const char *path,
                                      const struct mpm_material_law *law, const double *parameter)
{
    for (size_t k = 0; k < law->parameter_count; k++)
        if (isnan(parameter[law->parameters[k].which]))
            return mpm_reading_fault(reading, path, "the law %s requires %s, which is missing",
                                     law->name, mpm_parameter_key(law->parameters[k].which));
    return MPM_OK;
}

static enum mpm_status build_parameters(const struct mpm_reading *reading, const char *path,
                                        const struct mpm_material_law *law,
                                        const struct mpm_raw_material *raw, double *parameter)
{
    const struct given given = parameters_of(raw);
    MPM_TRY(refuse_others(reading, path, law, raw));
    for (int k = 0; k < MPM_PARAMETER_COUNT; k++) {
        const struct mpm_law_parameter *const own = mpm_law_parameter(law, (enum mpm_parameter)k);
        parameter[k] = given.text[k] != NULL          ? mpm_raw_double(given.text[k])
                       : own != NULL && own->optional ? own->fallback
                                                      : (double)NAN;
    }
    if (is_elastic(law))
        MPM_TRY(build_moduli(reading, path, raw, parameter));
    return check_required(reading, path, law, parameter);
}

static enum mpm_status build_material(const struct mpm_reading *reading, size_t index)
{
    const struct mpm_raw_material *const raw = &reading->raw->materials[index];
    const struct mpm_material_law *const law = mpm_material_law_find(raw->law);
    struct mpm_material_spec *const material = &reading->scene->materials[index];
    char path[MPM_PATH_SIZE];
    (void)mpm_path_entry("materials", index, path);
    (void)snprintf(material->name, MPM_NAME_SIZE, "%s", raw->name);
    material->law = law;
    material->density = mpm_raw_double(raw->density);
    material->line = mpm_reading_line(reading, path);
    if (law->thickness_stretch == NULL && reading->scene->geometry == MPM_PLANE_STRESS)
        return mpm_reading_fault(reading, path,
                                 "the law %s has no plane stress; allowed geometry: plane_strain, "
                                 "axisymmetric",
                                 law->name);
    return build_parameters(reading, path, law, raw, material->parameter);
}

enum mpm_status mpm_build_materials(const struct mpm_reading *reading)
{
    struct mpm_scene *scene = reading->scene;
    const size_t count = reading->raw->materials_count;
    scene->materials = mpm_reading_allocate(reading, count, sizeof *scene->materials, "materials");
    if (scene->materials == NULL)
        return MPM_ENVIRONMENT_FAILED;
    scene->material_count = count;
    for (size_t i = 0; i < count; i++)
        MPM_TRY(build_material(reading, i));
    struct mpm_indexed_name *names = NULL;
    MPM_TRY(mpm_reading_index(reading, "materials", count, scene->materials[0].name,
                              sizeof scene->materials[0], &names));
    free(names);
    return MPM_OK;
}

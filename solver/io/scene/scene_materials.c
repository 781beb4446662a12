/* The materials of a scene: density, law, and what the law has as parameters.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include <math.h>
#include <stdio.h>

/* A key of a material that belongs to a parameter of laws; its text is NULL where it is missing. */
struct given {
    const char *key, *text;
    enum mpm_parameter of;
};

/* ---------------------------------------------------------------------- parameters */

/* The law has all of them to which a key belongs that is given. */
static enum mpm_status check_keys(const struct mpm_reading *reading, const char *path,
                                  const struct mpm_material_law *law, const struct given *list,
                                  size_t count)
{
    char allowed[MPM_ALLOWED_SIZE] = "none";
    const char *other = NULL;
    for (size_t k = 0, used = 0; k < count && used < sizeof allowed; k++)
        if (mpm_law_parameter(law, list[k].of) != NULL)
            used += (size_t)snprintf(allowed + used, sizeof allowed - used, "%s%s",
                                     used > 0 ? ", " : "", list[k].key);
        else if (list[k].text != NULL)
            other = list[k].key;
    if (other == NULL)
        return MPM_OK;
    return mpm_reading_fault(reading, path, "the law %s has no parameter %s; allowed: %s",
                             law->name, other, allowed);
}

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

enum mpm_status mpm_build_parameters(const struct mpm_reading *reading, const char *path,
                                     const struct mpm_material_law *law,
                                     const struct mpm_raw_material *raw, double *parameter)
{
#define GIVEN(a, b, name, key, ...) {#key, raw->key, MPM_PARAMETER_##name},
    const struct given list[] = {
        MPM_LAW_PARAMETERS(GIVEN, , ){"young", raw->young, MPM_PARAMETER_BULK},
        {"poisson", raw->poisson, MPM_PARAMETER_BULK}};
    MPM_TRY(check_keys(reading, path, law, list, sizeof list / sizeof list[0]));
    for (int k = 0; k < MPM_PARAMETER_COUNT; k++) {
        const struct mpm_law_parameter *const own = mpm_law_parameter(law, (enum mpm_parameter)k);
        parameter[k] = list[k].text != NULL           ? mpm_raw_double(list[k].text)
                       : own != NULL && own->optional ? own->fallback
                                                      : (double)NAN;
    }
    if (mpm_law_parameter(law, MPM_PARAMETER_BULK) != NULL)
        MPM_TRY(build_moduli(reading, path, raw, parameter));
    for (size_t k = 0; k < law->parameter_count; k++)
        if (isnan(parameter[law->parameters[k].which]))
            return mpm_reading_fault(reading, path, "the law %s requires %s, which is missing",
                                     law->name, mpm_parameter_key(law->parameters[k].which));
    const char *const fault = law->fault == NULL ? NULL : law->fault(parameter);
    return fault == NULL ? MPM_OK : mpm_reading_fault(reading, path, "%s", fault);
}

/* ---------------------------------------------------------------------- hardening */

static enum mpm_status build_point(const struct mpm_reading *reading, const char *path,
                                   char *const given[2], const double *before, double point[2])
{
    for (int i = 0; i < 2; i++)
        point[i] = mpm_raw_double(given[i]);
    if (before == NULL && point[0] != 0.0)
        return mpm_reading_fault(reading, path, "got plastic strain %g; allowed for the first: 0",
                                 point[0]);
    if (before != NULL && !(point[0] > before[0]))
        return mpm_reading_fault(reading, path, "got plastic strain %g after %g; allowed: above it",
                                 point[0], before[0]);
    if (!(point[1] > 0.0))
        return mpm_reading_fault(reading, path, "got yield stress %g; allowed: above 0", point[1]);
    if (before != NULL && !(point[1] >= before[1]))
        return mpm_reading_fault(reading, path,
                                 "got yield stress %g after %g; allowed: not below it", point[1],
                                 before[1]);
    return MPM_OK;
}

/* The keys that a table takes the place of. */
static enum mpm_status check_instead(const struct mpm_reading *reading, const char *path,
                                     const struct mpm_material_law *law,
                                     const struct mpm_raw_material *raw)
{
    const struct given list[] = {
        {"yield_stress", raw->yield_stress, MPM_PARAMETER_YIELD_STRESS},
        {"hardening_modulus", raw->hardening_modulus, MPM_PARAMETER_HARDENING_MODULUS},
        {"hardening_strain", raw->hardening_strain, MPM_PARAMETER_HARDENING_STRAIN},
        {"hardening_exponent", raw->hardening_exponent, MPM_PARAMETER_HARDENING_EXPONENT}};
    if (!law->hardening_table)
        return mpm_reading_fault(reading, path,
                                 "given for the law %s; allowed: von_mises, von_mises_gruneisen",
                                 law->name);
    for (size_t k = 0; k < sizeof list / sizeof list[0]; k++)
        if (list[k].text != NULL)
            return mpm_reading_fault(reading, path, "given with %s; allowed: instead of it",
                                     list[k].key);
    return MPM_OK;
}

/* The table, if there is one. Its first stress is also the parameter yield_stress, `raw` without
 * it is changed. */
static enum mpm_status build_hardening(const struct mpm_reading *reading, const char *path,
                                       struct mpm_raw_material *raw,
                                       struct mpm_material_spec *material)
{
    struct mpm_property *const table = &material->hardening;
    const size_t count = raw->hardening_table_count;
    if (raw->hardening_table == NULL)
        return MPM_OK;
    const struct mpm_path key = mpm_path_join(path, "hardening_table");
    MPM_TRY(check_instead(reading, key.text, material->law, raw));
    MPM_TRY(mpm_reading_allocate(reading, count, sizeof *table->points, "a table", &table->points));
    MPM_TRY(
        mpm_reading_allocate(reading, count, sizeof *table->integral, "a table", &table->integral));
    table->count = count;
    for (size_t k = 0; k < count; k++)
        MPM_TRY(build_point(reading, mpm_path_entry(key.text, k).text, raw->hardening_table[k],
                            k == 0 ? NULL : table->points[k - 1], table->points[k]));
    mpm_property_prepare(table);
    raw->yield_stress = raw->hardening_table[0][1];
    return MPM_OK;
}

static enum mpm_status build_viscosity(const struct mpm_reading *reading, const char *path,
                                       const struct mpm_raw_viscosity *raw,
                                       struct mpm_material_spec *material)
{
    if (raw == NULL)
        return MPM_OK;
    material->viscosity =
        (struct mpm_viscosity){true, mpm_raw_double(raw->linear), mpm_raw_double(raw->quadratic)};
    if (material->law->reads_temperature || material->law == &mpm_none)
        return mpm_reading_fault(reading, mpm_path_join(path, "viscosity").text,
                                 "given for the law %s, which cannot take its heat; allowed: for "
                                 "solids, mie_gruneisen and stiffened_gas",
                                 material->law->name);
    if (reading->scene->geometry == MPM_PLANE_STRESS)
        return mpm_reading_fault(reading, mpm_path_join(path, "viscosity").text,
                                 "given in plane stress, whose pressure it is no part of; allowed "
                                 "geometry: plane_strain, axisymmetric");
    return MPM_OK;
}

static enum mpm_status build_material(const struct mpm_reading *reading, size_t index)
{
    const struct mpm_path key = mpm_path_entry("materials", index);
    struct mpm_raw_material raw_one = reading->raw->materials[index], *const raw = &raw_one;
    const struct mpm_material_law *const law = mpm_material_law_find(raw->law);
    struct mpm_material_spec *const material = &reading->scene->materials[index];
    const char *const path = key.text;
    (void)snprintf(material->name, MPM_NAME_SIZE, "%s", raw->name);
    material->law = law;
    material->density = mpm_raw_double(raw->density);
    material->line = mpm_reading_line(reading, path);
    if (!mpm_material_law_has_plane_stress(law) && reading->scene->geometry == MPM_PLANE_STRESS)
        return mpm_reading_fault(reading, path,
                                 "the law %s has no plane stress; allowed geometry: plane_strain, "
                                 "axisymmetric",
                                 law->name);
    MPM_TRY(build_viscosity(reading, path, raw->viscosity, material));
    MPM_TRY(build_hardening(reading, path, raw, material));
    return mpm_build_parameters(reading, path, law, raw, material->parameter);
}

enum mpm_status mpm_build_materials(const struct mpm_reading *reading)
{
    struct mpm_scene *scene = reading->scene;
    const size_t count = reading->raw->materials_count;
    MPM_TRY(mpm_reading_allocate(reading, count, sizeof *scene->materials, "materials",
                                 &scene->materials));
    scene->material_count = count;
    for (size_t i = 0; i < count; i++)
        MPM_TRY(mpm_reading_note(reading, build_material(reading, i)));
    return mpm_reading_check_names(reading, "materials", count, scene->materials[0].name,
                                   sizeof scene->materials[0]);
}

/* What materials say of scalars that are conducted: capacity, conductivity, expansion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_conduction.h"

#include <math.h>
#include <stdio.h>

/* ------------------------------------------------------------------------ names */

/* The keys of a scalar's properties. */
static const struct names {
    const char *capacity, *one, *two, *angle, *expansion, *stress_free;
    const char *ways; /* to give a conductivity */
} names[MPM_SCALAR_COUNT] = {
    [MPM_TEMPERATURE] = {"heat_capacity", "conductivity", "principal_conductivities",
                         "conductivity_angle", "thermal_expansion", "stress_free_temperature",
                         "conductivity, principal_conductivities and conductivity_table"},
    [MPM_CONCENTRATION] = {"saturation", "diffusivity", "principal_diffusivities",
                           "diffusivity_angle", "swelling", "stress_free_concentration",
                           "diffusivity, principal_diffusivities and diffusivity_table"},
};

/* Points of a table; NULL: missing. */
struct given_table {
    char *(*points)[2];
    size_t count;
};

/* Their texts of one material; NULL: missing. */
struct given {
    const char *capacity, *one, *const *two, *angle, *expansion, *stress_free;
    struct given_table tables[MPM_TABLE_COUNT];
};

static struct given given_by(const struct mpm_raw_material *raw, enum mpm_scalar which)
{
    static const char *const none[2] = {NULL, NULL};
    switch (which) {
    case MPM_TEMPERATURE:
        return (struct given){raw->heat_capacity,
                              raw->conductivity,
                              (const char *const *)raw->principal_conductivities,
                              raw->conductivity_angle,
                              raw->thermal_expansion,
                              raw->stress_free_temperature,
                              {{raw->heat_capacity_table, raw->heat_capacity_table_count},
                               {raw->conductivity_table, raw->conductivity_table_count}}};
    case MPM_CONCENTRATION:
        return (struct given){
            .capacity = raw->saturation,
            .one = raw->diffusivity,
            .two = (const char *const *)raw->principal_diffusivities,
            .angle = raw->diffusivity_angle,
            .expansion = raw->swelling,
            .stress_free = raw->stress_free_concentration,
            .tables = {
                [MPM_TABLE_CONDUCTIVITY] = {raw->diffusivity_table, raw->diffusivity_table_count}}};
    case MPM_SCALAR_COUNT:
        break;
    }
    return (struct given){.two = none};
}

/* ------------------------------------------------------------------------ tables */

static enum mpm_status build_point(const struct mpm_reading *reading, const char *path,
                                   const char *scalar, char *const given[2], const double *before,
                                   double point[2])
{
    for (int i = 0; i < 2; i++)
        point[i] = mpm_raw_double(given[i]);
    if (before != NULL && !(point[0] > before[0]))
        return mpm_reading_fault(reading, path, "got %s %g after %g; allowed: above it", scalar,
                                 point[0], before[0]);
    if (!(point[1] > 0.0))
        return mpm_reading_fault(reading, path, "got %g at %s %g; allowed: above 0", point[1],
                                 scalar, point[0]);
    return MPM_OK;
}

/* `scale`: what the numbers of the scene are multiplied with. */
static enum mpm_status build_table(const struct mpm_reading *reading, const char *path,
                                   const struct mpm_scalar_row *row, const struct given *all,
                                   enum mpm_table which, double scale, struct mpm_property *table)
{
    const struct given_table *const given = &all->tables[which];
    if (given->points == NULL)
        return MPM_OK;
    const struct mpm_path key = mpm_path_join(path, row->tables[which]);
    MPM_TRY(mpm_reading_allocate(reading, given->count, sizeof *table->points, "a table",
                                 &table->points));
    MPM_TRY(mpm_reading_allocate(reading, given->count, sizeof *table->integral, "a table",
                                 &table->integral));
    table->count = given->count;
    for (size_t k = 0; k < given->count; k++)
        MPM_TRY(build_point(reading, mpm_path_entry(key.text, k).text, row->name, given->points[k],
                            k == 0 ? NULL : table->points[k - 1], table->points[k]));
    for (size_t k = 0; k < given->count; k++)
        table->points[k][1] *= scale;
    mpm_property_prepare(table);
    return MPM_OK;
}

/* A temperature at which the material has both properties. */
static enum mpm_status check_common(const struct mpm_reading *reading, const char *path,
                                    const struct mpm_conduction *conduction)
{
    const struct mpm_property *const one = &conduction->tables[MPM_TABLE_CAPACITY],
                                     *const other = &conduction->tables[MPM_TABLE_CONDUCTIVITY];
    if (one->count == 0 || other->count == 0 || mpm_property_largest_ratio(other, one) > 0.0)
        return MPM_OK;
    return mpm_reading_fault(reading, path,
                             "heat_capacity_table from %g to %g and conductivity_table from %g to "
                             "%g; allowed: tables with temperatures in common",
                             one->points[0][0], one->points[one->count - 1][0], other->points[0][0],
                             other->points[other->count - 1][0]);
}

/* ---------------------------------------------------------------------- capacity */

static enum mpm_status build_capacity(const struct mpm_reading *reading, const char *path,
                                      enum mpm_scalar which, const struct given *given,
                                      struct mpm_material_spec *material)
{
    const struct names *const name = &names[which];
    struct mpm_conduction *const conduction = &material->conduction[which];
    const bool one = given->capacity != NULL;
    const bool table = given->tables[MPM_TABLE_CAPACITY].points != NULL;
    if (one && table)
        return mpm_reading_fault(reading, path, "both of %s and %s given; allowed: exactly one",
                                 name->capacity, mpm_scalar_rows[which].tables[MPM_TABLE_CAPACITY]);
    if (!one && !table)
        return mpm_reading_fault(reading, path,
                                 "no %s, in a scene with transport.%s; allowed: a number above 0",
                                 name->capacity, mpm_scalar_rows[which].name);
    if (one) {
        const double capacity = mpm_raw_double(given->capacity);
        conduction->capacity =
            which == MPM_TEMPERATURE ? capacity : capacity / material->density; /* per mass */
        return MPM_OK;
    }
    if (reading->raw->transport->temperature->heating)
        return mpm_reading_fault(
            reading, mpm_path_join(path, mpm_scalar_rows[which].tables[MPM_TABLE_CAPACITY]).text,
            "given with transport.temperature.heating; allowed: %s", name->capacity);
    MPM_TRY(build_table(reading, path, &mpm_scalar_rows[which], given, MPM_TABLE_CAPACITY, 1.0,
                        &conduction->tables[MPM_TABLE_CAPACITY]));
    conduction->capacity = mpm_property_least(&conduction->tables[MPM_TABLE_CAPACITY]);
    return MPM_OK;
}

/* ------------------------------------------------------------------ conductivity */

/* Along both axes, turned by an angle: a number times the unit tensor if they are equal. */
static void set_principal(struct mpm_conduction *conduction, double first, double second,
                          double degrees)
{
    static const double radians = 3.14159265358979323846 / 180.0;
    const double mean = 0.5 * (first + second), half = 0.5 * (first - second);
    const double cosine = cos(2.0 * radians * degrees), sine = sin(2.0 * radians * degrees);
    conduction->k[0] = mean + half * cosine;
    conduction->k[1] = mean - half * cosine;
    conduction->k[2] = half * sine;
    conduction->anisotropic = first != second;
}

/* `scale`: what the numbers of the scene are multiplied with. */
static enum mpm_status build_conductivity(const struct mpm_reading *reading, const char *path,
                                          enum mpm_scalar which, const struct given *given,
                                          double scale, struct mpm_conduction *conduction)
{
    const struct names *const name = &names[which];
    const bool one = given->one != NULL, two = given->two[0] != NULL;
    const bool table = given->tables[MPM_TABLE_CONDUCTIVITY].points != NULL;
    if (one + two + table != 1)
        return mpm_reading_fault(reading, path, "%d of %s given; allowed: exactly one",
                                 one + two + table, name->ways);
    if (!two && given->angle != NULL)
        return mpm_reading_fault(reading, mpm_path_join(path, name->angle).text,
                                 "got %s, for a %s without directions; allowed: with %s only",
                                 given->angle, name->one, name->two);
    if (table)
        set_principal(conduction, 1.0, 1.0, 0.0);
    else if (one)
        set_principal(conduction, scale * mpm_raw_double(given->one),
                      scale * mpm_raw_double(given->one), 0.0);
    else
        set_principal(conduction, scale * mpm_raw_double(given->two[0]),
                      scale * mpm_raw_double(given->two[1]), mpm_raw_double(given->angle));
    MPM_TRY(build_table(reading, path, &mpm_scalar_rows[which], given, MPM_TABLE_CONDUCTIVITY,
                        scale, &conduction->tables[MPM_TABLE_CONDUCTIVITY]));
    return check_common(reading, path, conduction);
}

/* --------------------------------------------------------------------- expansion */

static enum mpm_status build_expansion(const struct mpm_reading *reading, const char *path,
                                       const struct names *name, const struct given *given,
                                       const struct mpm_material_law *law,
                                       struct mpm_expansion *expansion)
{
    const bool one = given->expansion != NULL, two = given->stress_free != NULL;
    if (one != two)
        return mpm_reading_fault(reading, path, "%s without %s; allowed: both or none",
                                 one ? name->expansion : name->stress_free,
                                 one ? name->stress_free : name->expansion);
    if (!one)
        return MPM_OK;
    if (law->reads_temperature || law->keeps_heat || law == &mpm_none)
        return mpm_reading_fault(reading, mpm_path_join(path, name->expansion).text,
                                 "given for the law %s; allowed: for laws of solids", law->name);
    *expansion = (struct mpm_expansion){mpm_raw_double(given->expansion),
                                        mpm_raw_double(given->stress_free)};
    return MPM_OK;
}

/* ---------------------------------------------------------------------- materials */

enum mpm_status mpm_build_conduction(const struct mpm_reading *reading, enum mpm_scalar which,
                                     size_t index)
{
    const struct mpm_path path = mpm_path_entry("materials", index);
    struct mpm_material_spec *const material = &reading->scene->materials[index];
    struct mpm_conduction *const conduction = &material->conduction[which];
    const struct given given = given_by(&reading->raw->materials[index], which);
    conduction->given = true;
    MPM_TRY(build_capacity(reading, path.text, which, &given, material));
    MPM_TRY(build_expansion(reading, path.text, &names[which], &given, material->law,
                            &material->expansion[which]));
    return build_conductivity(reading, path.text, which, &given,
                              which == MPM_TEMPERATURE ? 1.0 : mpm_raw_double(given.capacity),
                              conduction);
}

enum mpm_status mpm_refuse_conduction(const struct mpm_reading *reading, enum mpm_scalar which)
{
    const struct names *const name = &names[which];
    const char *const keys[] = {name->capacity,
                                name->one,
                                name->two,
                                name->angle,
                                name->expansion,
                                name->stress_free,
                                mpm_scalar_rows[which].tables[MPM_TABLE_CONDUCTIVITY],
                                mpm_scalar_rows[which].tables[MPM_TABLE_CAPACITY]};
    const size_t own = sizeof keys / sizeof keys[0] - (which == MPM_TEMPERATURE ? 0 : 1);
    for (size_t m = 0; m < reading->scene->material_count; m++)
        for (size_t k = 0; k < own; k++) {
            const struct mpm_path path = mpm_path_entry("materials", m);
            const struct mpm_path key = mpm_path_join(path.text, keys[k]);
            if (mpm_reading_given(reading, key.text))
                return mpm_reading_fault(reading, key.text,
                                         "given in a scene without transport.%s; allowed: with it",
                                         mpm_scalar_rows[which].name);
        }
    return MPM_OK;
}

/* The key is for heat of deformation alone. */
static enum mpm_status check_plastic_heat(const struct mpm_reading *reading)
{
    const struct mpm_scene *const scene = reading->scene;
    for (size_t m = 0; !scene->scalars[MPM_TEMPERATURE].heats && m < scene->material_count; m++)
        if (mpm_material_plastic_heating(scene->materials[m].law, scene->materials[m].parameter) >
            0.0)
            return mpm_reading_fault(
                reading, mpm_path_join(mpm_path_entry("materials", m).text, "taylor_quinney").text,
                "given without transport.temperature.heating, where plastic work heats nothing; "
                "allowed: with heating: true");
    return MPM_OK;
}

enum mpm_status mpm_check_own_heat(const struct mpm_reading *reading)
{
    const struct mpm_scene *const scene = reading->scene;
    for (size_t m = 0; m < scene->material_count; m++) {
        if (scene->scalars[MPM_TEMPERATURE].heats && scene->materials[m].viscosity.given)
            return mpm_reading_fault(
                reading, mpm_path_join(mpm_path_entry("materials", m).text, "viscosity").text,
                "given in a scene with transport.temperature.heating, which does not have its "
                "heat; allowed: without heating");
        if (scene->materials[m].law->keeps_heat)
            return mpm_reading_fault(
                reading, mpm_path_join(mpm_path_entry("materials", m).text, "law").text,
                "got %s, whose equation of state keeps its own heat, in a scene with "
                "transport.temperature; allowed: without it",
                scene->materials[m].law->name);
    }
    for (size_t m = 0; m < scene->material_count; m++)
        if (scene->materials[m].parameter[MPM_PARAMETER_SPECIFIC_HEAT] > 0.0 ||
            scene->materials[m].parameter[MPM_PARAMETER_START_TEMPERATURE] > 0.0)
            return mpm_reading_fault(
                reading, mpm_path_join(mpm_path_entry("materials", m).text, "law").text,
                "got %s with start_temperature or specific_heat, a temperature of its own, in a "
                "scene with "
                "transport.temperature; allowed: without start_temperature and specific_heat",
                scene->materials[m].law->name);
    return check_plastic_heat(reading);
}

enum mpm_status mpm_refuse_heated_laws(const struct mpm_reading *reading)
{
    const struct mpm_scene *const scene = reading->scene;
    for (size_t m = 0; m < scene->material_count; m++) {
        const struct mpm_material_law *const law = scene->materials[m].law;
        const char *const fault = law->fault_without_heat == NULL
                                      ? NULL
                                      : law->fault_without_heat(scene->materials[m].parameter);
        if (fault != NULL)
            return mpm_reading_fault(reading, mpm_path_entry("materials", m).text, "%s", fault);
    }
    return MPM_OK;
}

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
} names[MPM_SCALAR_COUNT] = {
    [MPM_TEMPERATURE] = {"heat_capacity", "conductivity", "principal_conductivities",
                         "conductivity_angle", "thermal_expansion", "stress_free_temperature"},
    [MPM_CONCENTRATION] = {"saturation", "diffusivity", "principal_diffusivities",
                           "diffusivity_angle", "swelling", "stress_free_concentration"},
};

/* Their texts of one material; NULL: missing. */
struct given {
    const char *capacity, *one, *const *two, *angle, *expansion, *stress_free;
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
                              raw->stress_free_temperature};
    case MPM_CONCENTRATION:
        return (struct given){raw->saturation,
                              raw->diffusivity,
                              (const char *const *)raw->principal_diffusivities,
                              raw->diffusivity_angle,
                              raw->swelling,
                              raw->stress_free_concentration};
    case MPM_SCALAR_COUNT:
        break;
    }
    return (struct given){.two = none};
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
                                          const struct names *name, const struct given *given,
                                          double scale, struct mpm_conduction *conduction)
{
    const bool one = given->one != NULL, two = given->two[0] != NULL;
    if (one == two)
        return mpm_reading_fault(reading, path, "%s of %s and %s given; allowed: exactly one",
                                 one ? "both" : "none", name->one, name->two);
    if (one && given->angle != NULL)
        return mpm_reading_fault(reading, mpm_path_join(path, name->angle).text,
                                 "got %s, for a %s without directions; allowed: with %s only",
                                 given->angle, name->one, name->two);
    if (one)
        set_principal(conduction, scale * mpm_raw_double(given->one),
                      scale * mpm_raw_double(given->one), 0.0);
    else
        set_principal(conduction, scale * mpm_raw_double(given->two[0]),
                      scale * mpm_raw_double(given->two[1]), mpm_raw_double(given->angle));
    return MPM_OK;
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
    if (law->reads_temperature || law == &mpm_none)
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
    if (given.capacity == NULL)
        return mpm_reading_fault(reading, path.text,
                                 "no %s, in a scene with transport.%s; allowed: a number above 0",
                                 names[which].capacity, mpm_scalar_rows[which].name);
    const double capacity = mpm_raw_double(given.capacity);
    const bool heat = which == MPM_TEMPERATURE; /* capacity per mass, else per volume */
    conduction->given = true;
    conduction->capacity = heat ? capacity : capacity / material->density;
    MPM_TRY(build_expansion(reading, path.text, &names[which], &given, material->law,
                            &material->expansion[which]));
    return build_conductivity(reading, path.text, &names[which], &given, heat ? 1.0 : capacity,
                              conduction);
}

enum mpm_status mpm_refuse_conduction(const struct mpm_reading *reading, enum mpm_scalar which)
{
    const struct names *const name = &names[which];
    const char *const keys[] = {name->capacity, name->one,       name->two,
                                name->angle,    name->expansion, name->stress_free};
    for (size_t m = 0; m < reading->scene->material_count; m++)
        for (size_t k = 0; k < sizeof keys / sizeof keys[0]; k++) {
            const struct mpm_path path = mpm_path_entry("materials", m);
            const struct mpm_path key = mpm_path_join(path.text, keys[k]);
            if (mpm_reading_given(reading, key.text))
                return mpm_reading_fault(reading, key.text,
                                         "given in a scene without transport.%s; allowed: with it",
                                         mpm_scalar_rows[which].name);
        }
    return MPM_OK;
}

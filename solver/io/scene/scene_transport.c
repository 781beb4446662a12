/* Scalars that are conducted: what materials, bodies and the key transport say of them, and scenes
 * in which nothing else happens.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include <math.h>
#include <stdio.h>

/* ------------------------------------------------------------------- materials */

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

static enum mpm_status build_conductivity(const struct mpm_reading *reading, const char *path,
                                          const struct mpm_raw_material *raw,
                                          struct mpm_conduction *conduction)
{
    const bool one = raw->conductivity != NULL, two = raw->principal_conductivities[0] != NULL;
    if (one == two)
        return mpm_reading_fault(reading, path,
                                 "%s of conductivity and principal_conductivities given; allowed: "
                                 "exactly one",
                                 one ? "both" : "none");
    if (one && raw->conductivity_angle != NULL)
        return mpm_reading_fault(reading, mpm_path_join(path, "conductivity_angle").text,
                                 "got %s, for a conductivity without directions; allowed: with "
                                 "principal_conductivities only",
                                 raw->conductivity_angle);
    const double single = mpm_raw_double(raw->conductivity);
    if (one)
        set_principal(conduction, single, single, 0.0);
    else
        set_principal(conduction, mpm_raw_double(raw->principal_conductivities[0]),
                      mpm_raw_double(raw->principal_conductivities[1]),
                      mpm_raw_double(raw->conductivity_angle));
    return MPM_OK;
}

static enum mpm_status build_material(const struct mpm_reading *reading, size_t index)
{
    const struct mpm_path path = mpm_path_entry("materials", index);
    const struct mpm_raw_material *const raw = &reading->raw->materials[index];
    struct mpm_conduction *const conduction =
        &reading->scene->materials[index].conduction[MPM_TEMPERATURE];
    if (raw->heat_capacity == NULL)
        return mpm_reading_fault(reading, path.text,
                                 "no heat_capacity, in a scene with transport.temperature; "
                                 "allowed: a number above 0");
    conduction->given = true;
    conduction->capacity = mpm_raw_double(raw->heat_capacity);
    return build_conductivity(reading, path.text, raw, conduction);
}

/* ------------------------------------------------------------ the scalar itself */

static enum mpm_status build_condition(const struct mpm_reading *reading, size_t index)
{
    const struct mpm_path path = mpm_path_entry("transport.temperature.conditions", index);
    const struct mpm_raw_temperature_condition *const raw =
        &reading->raw->transport->temperature->conditions[index];
    struct mpm_scalar_condition_spec *const condition =
        &reading->scene->scalars[MPM_TEMPERATURE].conditions[index];
    double place[2], value;
    condition->line = mpm_reading_line(reading, path.text);
    MPM_TRY(mpm_build_boundary_region(reading, mpm_path_join(path.text, "region").text, raw->region,
                                      &condition->region));
    mpm_region_sample(reading->scene, &condition->region, place);
    return mpm_build_expression(reading, mpm_path_join(path.text, "value").text, raw->value, true,
                                place, &condition->value, &value);
}

/* The kind of a flux, with its coefficient; *text is its value or the surroundings' temperature. */
static enum mpm_status find_flux_kind(const struct mpm_reading *reading, const char *path,
                                      const struct mpm_raw_heat_flux *raw,
                                      struct mpm_edge_load_spec *flux, const char **text)
{
    const int given = (raw->value != NULL) + (raw->convection != NULL) + (raw->radiation != NULL);
    if (given != 1)
        return mpm_reading_fault(
            reading, path, "%d of value, convection and radiation given; allowed: exactly one",
            given);
    flux->flux = raw->value != NULL        ? MPM_FLUX_GIVEN
                 : raw->convection != NULL ? MPM_FLUX_CONVECTS
                                           : MPM_FLUX_RADIATES;
    *text = raw->value;
    if (raw->convection != NULL) {
        flux->coefficient = mpm_raw_double(raw->convection->coefficient);
        *text = raw->convection->ambient;
    }
    if (raw->radiation != NULL) {
        flux->coefficient =
            mpm_raw_double(raw->radiation->emissivity) * mpm_raw_double(raw->radiation->sigma);
        *text = raw->radiation->ambient;
    }
    return MPM_OK;
}

/* Beside the scene's forces on edges, which it has room after. */
static enum mpm_status build_flux(const struct mpm_reading *reading, size_t index)
{
    const struct mpm_path path = mpm_path_entry("transport.temperature.fluxes", index);
    const struct mpm_raw_heat_flux *const raw =
        &reading->raw->transport->temperature->fluxes[index];
    struct mpm_scene *const scene = reading->scene;
    struct mpm_edge_load_spec *const flux = &scene->edge_loads[scene->edge_load_count++];
    const char *text = NULL;
    double place[2], value;
    (void)snprintf(flux->key, sizeof flux->key, "transport.temperature.fluxes.%zu", index);
    flux->scalar = MPM_TEMPERATURE;
    flux->edge = (enum mpm_edge)raw->edge;
    flux->line = mpm_reading_line(reading, path.text);
    MPM_TRY(find_flux_kind(reading, path.text, raw, flux, &text));
    MPM_TRY(mpm_build_loaded_body(reading, mpm_path_join(path.text, "body").text, raw->body,
                                  &flux->body));
    mpm_region_sample(scene, &scene->bodies[flux->body].region, place);
    return mpm_build_expression(reading, path.text, text, true, place, &flux->value.text[0],
                                &value);
}

/* Initial values, in the coordinates, of the body of that region. */
static enum mpm_status build_start(const struct mpm_reading *reading, const char *path,
                                   const struct mpm_region *region, const char *raw, char **start)
{
    double place[2], value;
    mpm_region_sample(reading->scene, region, place);
    return mpm_build_expression(reading, path, raw, false, place, start, &value);
}

static enum mpm_status build_body(const struct mpm_reading *reading, size_t index)
{
    const struct mpm_path path = mpm_path_entry("bodies", index);
    const struct mpm_path key = mpm_path_join(path.text, "temperature");
    const char *const raw = reading->raw->bodies[index].temperature;
    struct mpm_body_spec *const body = &reading->scene->bodies[index];
    if (raw == NULL)
        return MPM_OK;
    if (body->rigid)
        return mpm_reading_fault(reading, key.text,
                                 "a temperature for a rigid body, which does not conduct; allowed: "
                                 "for a body with a material");
    return build_start(reading, key.text, &body->region, raw, &body->start[MPM_TEMPERATURE]);
}

static enum mpm_status build_temperature(const struct mpm_reading *reading)
{
    const struct mpm_raw_temperature *const raw = reading->raw->transport->temperature;
    struct mpm_scene *const scene = reading->scene;
    struct mpm_scalar_spec *const scalar = &scene->scalars[MPM_TEMPERATURE];
    const struct mpm_region *region = NULL;
    scalar->asked = true;
    scalar->line = mpm_reading_line(reading, "transport.temperature");
    scalar->transfer = (enum mpm_scalar_transfer)raw->transfer;
    for (size_t k = 0; k < scene->material_count; k++)
        MPM_TRY(build_material(reading, k));
    for (size_t k = 0; k < scene->body_count; k++) {
        region = region == NULL && !scene->bodies[k].rigid ? &scene->bodies[k].region : region;
        MPM_TRY(build_body(reading, k));
    }
    MPM_TRY(
        build_start(reading, "transport.temperature.start", region, raw->start, &scalar->start));
    if (raw->source != NULL) {
        double place[2], value;
        mpm_region_sample(scene, region, place);
        MPM_TRY(mpm_build_expression(reading, "transport.temperature.source", raw->source, true,
                                     place, &scalar->source, &value));
        mpm_drop_constant(&scalar->source, 0.0);
    }
    MPM_TRY(mpm_reading_allocate(reading, raw->conditions_count, sizeof *scalar->conditions,
                                 "conditions", &scalar->conditions));
    scalar->condition_count = raw->conditions_count;
    for (size_t k = 0; k < raw->conditions_count; k++)
        MPM_TRY(build_condition(reading, k));
    for (size_t k = 0; k < raw->fluxes_count; k++)
        MPM_TRY(build_flux(reading, k));
    return MPM_OK;
}

/* ------------------------------------------------------ keys that do not fit */

static enum mpm_status refuse_key(const struct mpm_reading *reading, const char *path)
{
    return mpm_reading_fault(reading, path,
                             "given in a scene without transport.temperature; allowed: with it");
}

/* What only conduction reads. */
static enum mpm_status check_without(const struct mpm_reading *reading)
{
    static const char *const keys[] = {"heat_capacity", "conductivity", "principal_conductivities",
                                       "conductivity_angle"};
    for (size_t m = 0; m < reading->scene->material_count; m++)
        for (size_t k = 0; k < sizeof keys / sizeof keys[0]; k++) {
            const struct mpm_path path = mpm_path_entry("materials", m);
            const struct mpm_path key = mpm_path_join(path.text, keys[k]);
            if (mpm_reading_given(reading, key.text))
                return refuse_key(reading, key.text);
        }
    for (size_t b = 0; b < reading->scene->body_count; b++)
        if (reading->raw->bodies[b].temperature != NULL)
            return refuse_key(reading,
                              mpm_path_join(mpm_path_entry("bodies", b).text, "temperature").text);
    return MPM_OK;
}

/* What has no meaning where nothing moves. */
static enum mpm_status check_at_rest(const struct mpm_reading *reading)
{
    static const char *const keys[] = {
        "method.stress_update",
        "method.extrapolate",
        "method.position_update",
        "method.radius_update",
        "method.axis_nodes",
        "method.form",
        "method.transfer",
        "method.cracks",
        "method.deformation_terms",
        "loads",
        "damping",
        "time.rest",
        "output.energy_balance",
        "output.fringe",
    };
    const struct mpm_scene *const scene = reading->scene;
    for (size_t k = 0; k < sizeof keys / sizeof keys[0]; k++)
        if (mpm_reading_given(reading, keys[k]))
            return mpm_reading_fault(reading, keys[k],
                                     "given in a scene where nothing moves, since its materials "
                                     "have law: none; allowed: with laws that have a stress");
    for (size_t k = 0; k < scene->body_count; k++) {
        const struct mpm_path path = mpm_path_entry("bodies", k);
        if (scene->bodies[k].rigid ||
            mpm_reading_given(reading, mpm_path_join(path.text, "velocity").text))
            return mpm_reading_fault(reading, path.text,
                                     "%s in a scene where nothing moves, since its materials have "
                                     "law: none; allowed: with laws that have a stress",
                                     scene->bodies[k].rigid ? "a rigid body" : "a velocity");
    }
    for (size_t k = 0; k < scene->boundary_count; k++)
        if (!scene->boundaries[k].symmetry)
            return mpm_reading_fault(reading, mpm_path_entry("boundary", k).text,
                                     "a velocity in a scene where nothing moves, since its "
                                     "materials have law: none; allowed: symmetry: true");
    return MPM_OK;
}

/* Laws of contact say where bodies touch, and no more. */
static enum mpm_status check_contact_at_rest(const struct mpm_reading *reading)
{
    const struct mpm_contact_spec *const contact = &reading->scene->contact;
    for (size_t k = 0; k < contact->pair_count; k++) {
        const struct mpm_pair_spec *const pair = &contact->pairs[k];
        if ((pair->law != MPM_PAIR_BONDED && pair->law != MPM_PAIR_STICK) || pair->adhesion != 0.0)
            return mpm_reading_fault(reading, pair->key,
                                     "%s in a scene where nothing moves, since its materials have "
                                     "law: none; allowed: law: bonded, or stick where their "
                                     "distance decides whether bodies touch",
                                     pair->adhesion != 0.0 ? "adhesion" : "a law of motion");
    }
    return MPM_OK;
}

/* Of cracks only what flows across has a meaning. */
static enum mpm_status check_cracks_at_rest(const struct mpm_reading *reading)
{
    static const char *const keys[] = {"contact",  "detection", "friction", "separated",
                                       "touching", "opening",   "cohesive", "j_integral"};
    for (size_t c = 0; c < reading->scene->crack_count; c++)
        for (size_t k = 0; k < sizeof keys / sizeof keys[0]; k++) {
            const struct mpm_path path = mpm_path_join(mpm_path_entry("cracks", c).text, keys[k]);
            if (mpm_reading_given(reading, path.text))
                return mpm_reading_fault(reading, path.text,
                                         "given in a scene where nothing moves, since its "
                                         "materials have law: none; allowed: points, spacing, heat "
                                         "and conductance");
        }
    return MPM_OK;
}

/* Materials without stress: all or none, and only with something to conduct. */
static enum mpm_status find_rest(const struct mpm_reading *reading, bool conducts)
{
    struct mpm_scene *const scene = reading->scene;
    size_t without = 0, first = scene->material_count;
    for (size_t k = 0; k < scene->material_count; k++) {
        const bool none = scene->materials[k].law == &mpm_none;
        without += none;
        first = none && first == scene->material_count ? k : first;
    }
    if (without == 0)
        return MPM_OK;
    if (without < scene->material_count || !conducts)
        return mpm_reading_fault(
            reading, mpm_path_join(mpm_path_entry("materials", first).text, "law").text,
            "got none %s; allowed: none in all materials of a scene with "
            "transport.temperature, or a law with a stress",
            conducts ? "beside materials with a stress" : "in a scene that conducts nothing");
    scene->at_rest = true;
    MPM_TRY(check_at_rest(reading));
    MPM_TRY(check_contact_at_rest(reading));
    return check_cracks_at_rest(reading);
}

/* Nodes with several fields: exchange is between bodies, or across cracks that hide nothing. */
static enum mpm_status check_fields(const struct mpm_reading *reading)
{
    const struct mpm_scene *const scene = reading->scene;
    if (scene->crack_count > 0 && scene->contact.field_count > 0)
        return mpm_reading_fault(reading, "transport.temperature",
                                 "heat conduction with cracks beside contact between bodies; "
                                 "allowed: with one of both");
    if (scene->crack_count > 0 && scene->crack_method == MPM_CRACKS_VISIBILITY)
        return mpm_reading_fault(reading, "transport.temperature",
                                 "heat conduction with method.cracks: visibility, where the shares "
                                 "of a particle's nodes do not add up to 1; allowed: fields");
    return MPM_OK;
}

enum mpm_status mpm_build_transport(const struct mpm_reading *reading)
{
    const bool conducts = reading->raw->transport->temperature != NULL;
    MPM_TRY(find_rest(reading, conducts));
    if (!conducts)
        return check_without(reading);
    MPM_TRY(check_fields(reading));
    return build_temperature(reading);
}

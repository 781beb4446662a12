/* Scalars that are conducted: what bodies and the key transport say of them, and scenes in which
 * nothing else happens.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_conduction.h"
#include "mpm_transport.h"

#include <math.h>
#include <stdio.h>

/* ------------------------------------------------- what the file says of a scalar */

struct given_condition {
    const struct mpm_raw_boundary_region *region;
    const char *value;
};

/* One of value, convection and radiation; radiation is of heat alone. */
struct given_flux {
    const char *body;
    int edge;
    const char *value;
    const char *coefficient, *ambient; /* of convection */
    const struct mpm_raw_radiation *radiation;
};

struct given {
    bool asked;
    const char *start, *source;
    int transfer;
    int order; /* of xpic and fmpm */
    size_t condition_count, flux_count;
};

/* The same of each scalar, whose keys have structs of their own. */
#define READERS(scalar)                                                                            \
    static struct given scalar##_given(const struct mpm_reading *reading)                          \
    {                                                                                              \
        const struct mpm_raw_##scalar *const raw = reading->raw->transport->scalar;                \
        struct given given = {.asked = raw != NULL};                                               \
        if (raw == NULL)                                                                           \
            return given;                                                                          \
        given.start = raw->start;                                                                  \
        given.source = raw->source;                                                                \
        given.transfer = raw->transfer;                                                            \
        given.order = (int)raw->order;                                                             \
        given.condition_count = raw->conditions_count;                                             \
        given.flux_count = raw->fluxes_count;                                                      \
        return given;                                                                              \
    }                                                                                              \
    static struct given_condition scalar##_condition(const struct mpm_reading *reading,            \
                                                     size_t index)                                 \
    {                                                                                              \
        const struct mpm_raw_##scalar##_condition *const raw =                                     \
            &reading->raw->transport->scalar->conditions[index];                                   \
        return (struct given_condition){raw->region, raw->value};                                  \
    }                                                                                              \
    static const char *scalar##_start(const struct mpm_reading *reading, size_t body)              \
    {                                                                                              \
        return reading->raw->bodies[body].scalar;                                                  \
    }
READERS(temperature)
READERS(concentration)

static struct given_flux temperature_flux(const struct mpm_reading *reading, size_t index)
{
    const struct mpm_raw_heat_flux *const raw =
        &reading->raw->transport->temperature->fluxes[index];
    const struct mpm_raw_convection *const convection = raw->convection;
    return (struct given_flux){
        .body = raw->body,
        .edge = raw->edge,
        .value = raw->value,
        .coefficient = convection == NULL ? NULL : convection->coefficient,
        .ambient = convection == NULL ? NULL : convection->ambient,
        .radiation = raw->radiation,
    };
}

static struct given_flux concentration_flux(const struct mpm_reading *reading, size_t index)
{
    const struct mpm_raw_solvent_flux *const raw =
        &reading->raw->transport->concentration->fluxes[index];
    const struct mpm_raw_evaporation *const convection = raw->convection;
    return (struct given_flux){
        .body = raw->body,
        .edge = raw->edge,
        .value = raw->value,
        .coefficient = convection == NULL ? NULL : convection->coefficient,
        .ambient = convection == NULL ? NULL : convection->ambient,
    };
}

static const struct reader {
    struct given (*given)(const struct mpm_reading *reading);
    struct given_condition (*condition)(const struct mpm_reading *reading, size_t index);
    struct given_flux (*flux)(const struct mpm_reading *reading, size_t index);
    const char *(*start)(const struct mpm_reading *reading, size_t body);
    const char *kinds; /* of fluxes */
} readers[MPM_SCALAR_COUNT] = {
    [MPM_TEMPERATURE] = {temperature_given, temperature_condition, temperature_flux,
                         temperature_start, "value, convection and radiation"},
    [MPM_CONCENTRATION] = {concentration_given, concentration_condition, concentration_flux,
                           concentration_start, "value and convection"},
};

/* "transport.temperature", and what is under it. */
static struct mpm_path scalar_path(enum mpm_scalar which)
{
    return mpm_path_join("transport", mpm_scalar_rows[which].name);
}

static struct mpm_path path_under(enum mpm_scalar which, const char *key)
{
    return mpm_path_join(scalar_path(which).text, key);
}

/* ------------------------------------------------------------ the scalar itself */

static enum mpm_status build_condition(const struct mpm_reading *reading, enum mpm_scalar which,
                                       size_t index)
{
    const struct mpm_path path = mpm_path_entry(path_under(which, "conditions").text, index);
    const struct given_condition given = readers[which].condition(reading, index);
    struct mpm_scalar_condition_spec *const condition =
        &reading->scene->scalars[which].conditions[index];
    double place[2], value;
    condition->line = mpm_reading_line(reading, path.text);
    MPM_TRY(mpm_build_boundary_region(reading, mpm_path_join(path.text, "region").text,
                                      given.region, &condition->region));
    mpm_region_sample(reading->scene, &condition->region, place);
    return mpm_build_expression(reading, mpm_path_join(path.text, "value").text, given.value, true,
                                place, &condition->value, &value);
}

/* The kind of a flux, with its coefficient; *text is its value or that of the surroundings. */
static enum mpm_status find_flux_kind(const struct mpm_reading *reading, const char *path,
                                      const struct given_flux *given, const char *kinds,
                                      struct mpm_edge_load_spec *flux, const char **text)
{
    const int count =
        (given->value != NULL) + (given->coefficient != NULL) + (given->radiation != NULL);
    if (count != 1)
        return mpm_reading_fault(reading, path, "%d of %s given; allowed: exactly one", count,
                                 kinds);
    flux->flux = given->value != NULL         ? MPM_FLUX_GIVEN
                 : given->coefficient != NULL ? MPM_FLUX_CONVECTS
                                              : MPM_FLUX_RADIATES;
    *text = given->value;
    if (given->coefficient != NULL) {
        flux->coefficient = mpm_raw_double(given->coefficient);
        *text = given->ambient;
    }
    if (given->radiation != NULL) {
        flux->coefficient =
            mpm_raw_double(given->radiation->emissivity) * mpm_raw_double(given->radiation->sigma);
        *text = given->radiation->ambient;
    }
    return MPM_OK;
}

/* Beside the scene's forces on edges, which it has room after. */
static enum mpm_status build_flux(const struct mpm_reading *reading, enum mpm_scalar which,
                                  size_t index)
{
    const struct mpm_path path = mpm_path_entry(path_under(which, "fluxes").text, index);
    const struct given_flux given = readers[which].flux(reading, index);
    struct mpm_scene *const scene = reading->scene;
    struct mpm_edge_load_spec *const flux = &scene->edge_loads[scene->edge_load_count++];
    const char *text = NULL;
    double place[2], value;
    (void)snprintf(flux->key, sizeof flux->key, "transport.%s.fluxes.%zu",
                   mpm_scalar_rows[which].name, index);
    flux->scalar = which;
    flux->edge = (enum mpm_edge)given.edge;
    flux->line = mpm_reading_line(reading, path.text);
    MPM_TRY(find_flux_kind(reading, path.text, &given, readers[which].kinds, flux, &text));
    MPM_TRY(mpm_build_loaded_body(reading, mpm_path_join(path.text, "body").text, given.body,
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

static enum mpm_status build_body(const struct mpm_reading *reading, enum mpm_scalar which,
                                  size_t index)
{
    const struct mpm_path path = mpm_path_entry("bodies", index);
    const struct mpm_path key = mpm_path_join(path.text, mpm_scalar_rows[which].name);
    const char *const raw = readers[which].start(reading, index);
    struct mpm_body_spec *const body = &reading->scene->bodies[index];
    if (raw == NULL)
        return MPM_OK;
    if (body->rigid)
        return mpm_reading_fault(reading, key.text,
                                 "a %s for a rigid body, which does not conduct; allowed: for a "
                                 "body with a material",
                                 mpm_scalar_rows[which].name);
    return build_start(reading, key.text, &body->region, raw, &body->start[which]);
}

/* Something has to change temperatures where deformation is to. */
static enum mpm_status build_heating(const struct mpm_reading *reading)
{
    struct mpm_scene *const scene = reading->scene;
    const struct mpm_raw_temperature *const raw = reading->raw->transport->temperature;
    scene->scalars[MPM_TEMPERATURE].heats = raw != NULL && raw->heating;
    if (!scene->scalars[MPM_TEMPERATURE].heats || mpm_scene_expands(scene) ||
        mpm_scene_reads_temperature(scene) || mpm_scene_has_plastic_heat(scene))
        return MPM_OK;
    return mpm_reading_fault(reading, "transport.temperature.heating",
                             "got true where no deformation gives heat; allowed: with a material "
                             "that has thermal_expansion, taylor_quinney or the law ideal_gas");
}

/* The region of a body that conducts, for samples of what may be anywhere. */
static const struct mpm_region *conducting_region(const struct mpm_scene *scene)
{
    size_t body = 0;
    while (body + 1 < scene->body_count && scene->bodies[body].rigid)
        body++;
    return &scene->bodies[body].region;
}

static enum mpm_status build_source(const struct mpm_reading *reading, enum mpm_scalar which,
                                    const char *raw)
{
    struct mpm_scalar_spec *const scalar = &reading->scene->scalars[which];
    double place[2], value;
    if (raw == NULL)
        return MPM_OK;
    mpm_region_sample(reading->scene, conducting_region(reading->scene), place);
    MPM_TRY(mpm_build_expression(reading, path_under(which, "source").text, raw, true, place,
                                 &scalar->source, &value));
    mpm_drop_constant(&scalar->source, 0.0);
    return MPM_OK;
}

static enum mpm_status build_transfer(const struct mpm_reading *reading, enum mpm_scalar which,
                                      const struct given *given)
{
    static const char *const with_order[] = {
        [MPM_SCALAR_XPIC] = "xpic", [MPM_SCALAR_FMPM] = "fmpm"};
    struct mpm_scalar_spec *const scalar = &reading->scene->scalars[which];
    const struct mpm_path key = path_under(which, "order");
    const bool has = given->transfer == MPM_SCALAR_XPIC || given->transfer == MPM_SCALAR_FMPM;
    const bool order = mpm_reading_given(reading, key.text);
    scalar->transfer = (enum mpm_scalar_transfer)given->transfer;
    scalar->order = has ? given->order : 1;
    if (order && !has)
        return mpm_reading_fault(reading, key.text,
                                 "given with a transfer that has no order; allowed: with xpic and "
                                 "fmpm");
    if (has && !order)
        return mpm_reading_fault(reading, path_under(which, "transfer").text,
                                 "%s without an order; allowed: with order: 2, or another order "
                                 "from 1",
                                 with_order[given->transfer]);
    return MPM_OK;
}

static enum mpm_status build_scalar(const struct mpm_reading *reading, enum mpm_scalar which,
                                    const struct given *given)
{
    struct mpm_scene *const scene = reading->scene;
    struct mpm_scalar_spec *const scalar = &scene->scalars[which];
    scalar->asked = true;
    scalar->line = mpm_reading_line(reading, scalar_path(which).text);
    MPM_TRY(build_transfer(reading, which, given));
    for (size_t k = 0; k < scene->material_count; k++)
        MPM_TRY(mpm_build_conduction(reading, which, k));
    for (size_t k = 0; k < scene->body_count; k++)
        MPM_TRY(build_body(reading, which, k));
    MPM_TRY(build_start(reading, path_under(which, "start").text, conducting_region(scene),
                        given->start, &scalar->start));
    MPM_TRY(build_source(reading, which, given->source));
    MPM_TRY(mpm_reading_allocate(reading, given->condition_count, sizeof *scalar->conditions,
                                 "conditions", &scalar->conditions));
    scalar->condition_count = given->condition_count;
    for (size_t k = 0; k < given->condition_count; k++)
        MPM_TRY(build_condition(reading, which, k));
    for (size_t k = 0; k < given->flux_count; k++)
        MPM_TRY(build_flux(reading, which, k));
    return MPM_OK;
}

/* ------------------------------------------------------ keys that do not fit */

/* What only the conduction of that scalar reads. */
static enum mpm_status check_without(const struct mpm_reading *reading, enum mpm_scalar which)
{
    const struct mpm_scene *const scene = reading->scene;
    MPM_TRY(mpm_refuse_conduction(reading, which));
    if (which == MPM_TEMPERATURE)
        MPM_TRY(mpm_refuse_heated_laws(reading));
    for (size_t m = 0; which == MPM_TEMPERATURE && m < scene->material_count; m++)
        if (scene->materials[m].law->reads_temperature)
            return mpm_reading_fault(
                reading, mpm_path_join(mpm_path_entry("materials", m).text, "law").text,
                "got %s, whose stress depends on the temperature, in a scene without "
                "transport.temperature; allowed: with it",
                scene->materials[m].law->name);
    for (size_t b = 0; b < scene->body_count; b++)
        if (readers[which].start(reading, b) != NULL)
            return mpm_reading_fault(
                reading,
                mpm_path_join(mpm_path_entry("bodies", b).text, mpm_scalar_rows[which].name).text,
                "given in a scene without transport.%s; allowed: with it",
                mpm_scalar_rows[which].name);
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
        "time.rest.kinetic_energy",
        "transport.substeps",
        "transport.every",
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

/* What moves comes to rest only with its particles. */
static enum mpm_status check_rest(const struct mpm_reading *reading)
{
    const struct mpm_raw_rest *const rest = reading->raw->time->rest;
    if (rest == NULL || rest->kinetic_energy != NULL)
        return MPM_OK;
    return mpm_reading_fault(
        reading, "time.rest.kinetic_energy",
        "missing, in a scene where something moves; allowed: above 0, up to 1");
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
        return check_rest(reading);
    if (without < scene->material_count || !conducts)
        return mpm_reading_fault(
            reading, mpm_path_join(mpm_path_entry("materials", first).text, "law").text,
            "got none %s; allowed: none in all materials of a scene with "
            "transport.temperature or transport.concentration, or a law with a stress",
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
        return mpm_reading_fault(reading, "transport",
                                 "conduction with cracks beside contact between bodies; "
                                 "allowed: with one of both");
    if (scene->crack_count > 0 && scene->crack_method == MPM_CRACKS_VISIBILITY)
        return mpm_reading_fault(reading, "transport",
                                 "conduction with method.cracks: visibility, where the shares "
                                 "of a particle's nodes do not add up to 1; allowed: fields");
    return MPM_OK;
}

static enum mpm_status check_steps(const struct mpm_reading *reading, bool conducts)
{
    static const char *const keys[] = {"transport.substeps", "transport.every"};
    for (size_t k = 0; !conducts && k < sizeof keys / sizeof keys[0]; k++)
        if (mpm_reading_given(reading, keys[k]))
            return mpm_reading_fault(reading, keys[k],
                                     "given in a scene that conducts nothing; allowed: with "
                                     "transport.temperature or transport.concentration");
    return MPM_OK;
}

enum mpm_status mpm_build_transport(const struct mpm_reading *reading)
{
    struct given given[MPM_SCALAR_COUNT];
    bool conducts = false;
    for (int which = 0; which < MPM_SCALAR_COUNT; which++) {
        given[which] = readers[which].given(reading);
        conducts = conducts || given[which].asked;
    }
    reading->scene->transport_substeps = reading->raw->transport->substeps;
    reading->scene->transport_every = reading->raw->transport->every;
    MPM_TRY(find_rest(reading, conducts));
    MPM_TRY(check_steps(reading, conducts));
    if (conducts)
        MPM_TRY(check_fields(reading));
    for (int k = 0; k < MPM_SCALAR_COUNT; k++) {
        const enum mpm_scalar which = (enum mpm_scalar)k;
        MPM_TRY(given[k].asked ? build_scalar(reading, which, &given[k])
                               : check_without(reading, which));
        if (which == MPM_TEMPERATURE) /* which swelling does not count for */
            MPM_TRY(build_heating(reading));
        if (which == MPM_TEMPERATURE && given[k].asked)
            MPM_TRY(mpm_check_own_heat(reading));
    }
    return MPM_OK;
}

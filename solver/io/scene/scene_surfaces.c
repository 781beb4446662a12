/* What surfaces that meet pass on of temperature: keys of contact, of its pairs and of cracks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include <math.h>
#include <string.h>

/* Of the smaller cell side: below it surfaces touch. What bodies at rest against each other keep
 * between them is of the order of a thousandth. */
static const double USUAL_GAP = 0.01;

/* ------------------------------------------------------------------------ a law */

/* Keys as given; NULL: not. */
struct keys {
    const char *path;
    enum mpm_surface_law law;
    const char *conductance, *gap;
};

/* What is the default may be said. */
static enum mpm_status refuse_without(const struct mpm_reading *reading, const struct keys *keys)
{
    static const char *const names[] = {"heat", "conductance", "heat_gap"};
    for (size_t k = 0; k < sizeof names / sizeof names[0]; k++) {
        const struct mpm_path path = mpm_path_join(keys->path, names[k]);
        const bool usual = k == 0 && keys->law == MPM_SURFACE_INSULATES;
        if (!usual && mpm_reading_given(reading, path.text))
            return mpm_reading_fault(reading, path.text,
                                     "given in a scene without transport.temperature; allowed: "
                                     "with it");
    }
    return MPM_OK;
}

static enum mpm_status check_conductance(const struct mpm_reading *reading, const struct keys *keys)
{
    const bool conducts = keys->law == MPM_SURFACE_CONDUCTANCE;
    if (conducts && keys->conductance == NULL)
        return mpm_reading_fault(reading, mpm_path_join(keys->path, "heat").text,
                                 "conductance without its value; allowed: conductance: a number of "
                                 "at least 0 beside it");
    if (!conducts && keys->conductance != NULL)
        return mpm_reading_fault(reading, mpm_path_join(keys->path, "conductance").text,
                                 "got %s, beside another law of heat; allowed: with heat: "
                                 "conductance only",
                                 keys->conductance);
    return MPM_OK;
}

static double usual_gap(const struct mpm_scene *scene)
{
    return USUAL_GAP * fmin(scene->cell[0], scene->cell[1]);
}

static enum mpm_status fill_surface(const struct mpm_reading *reading, const struct keys *keys,
                                    struct mpm_surface_spec *surface)
{
    MPM_TRY(check_conductance(reading, keys));
    surface->law = keys->law;
    surface->conductance = mpm_raw_double(keys->conductance);
    surface->gap = keys->gap == NULL ? usual_gap(reading->scene) : mpm_raw_double(keys->gap);
    return MPM_OK;
}

/* --------------------------------------------------------------------- contact */

static bool uses_gap(const struct mpm_pair_spec *pair, enum mpm_surface_law law)
{
    return law != MPM_SURFACE_INSULATES && pair->detection == MPM_TOUCH_EXTENT &&
           pair->law != MPM_PAIR_BONDED && pair->law != MPM_PAIR_INTERFACE;
}

static enum mpm_status check_pair(const struct mpm_reading *reading, const struct keys *keys,
                                  const struct mpm_pair_spec *pair)
{
    const struct mpm_path heat = mpm_path_join(keys->path, "heat");
    if (pair->law == MPM_PAIR_NONE && keys->law != MPM_SURFACE_INSULATES)
        return mpm_reading_fault(reading, heat.text,
                                 "a law of heat for a pair that shares its fields, law: none; "
                                 "allowed: with another law");
    if (keys->gap != NULL && !uses_gap(pair, keys->law))
        return mpm_reading_fault(reading, mpm_path_join(keys->path, "heat_gap").text,
                                 "got %s, which this pair does not use; allowed: with heat: "
                                 "perfect or conductance, detection: extent and law: friction, "
                                 "stick or frictionless",
                                 keys->gap);
    return MPM_OK;
}

enum mpm_status mpm_build_pair_surface(const struct mpm_reading *reading, const char *path,
                                       const struct mpm_raw_contact_pair *raw, bool rigid,
                                       struct mpm_pair_spec *pair)
{
    const struct mpm_raw_contact *const whole = reading->raw->contact;
    const bool is_whole = strcmp(path, "contact") == 0;
    const bool own = is_whole || mpm_reading_given(reading, mpm_path_join(path, "heat").text);
    const struct keys given = {
        .path = path,
        .law = (enum mpm_surface_law)(own ? raw->heat : whole->heat),
        .conductance = raw->conductance,
        .gap = raw->heat_gap,
    };
    struct keys keys = given;
    if (reading->raw->transport->temperature == NULL)
        return refuse_without(reading, &given);
    if (!own && (raw->conductance != NULL || raw->heat_gap != NULL))
        return mpm_reading_fault(reading, path,
                                 "conductance or heat_gap without heat; allowed: beside heat");
    if (!own && (rigid || pair->law == MPM_PAIR_NONE))
        keys.law = MPM_SURFACE_INSULATES;
    else if (!own)
        keys = (struct keys){path, keys.law, whole->conductance, whole->heat_gap};
    if (own && rigid && keys.law != MPM_SURFACE_INSULATES)
        return mpm_reading_fault(reading, mpm_path_join(path, "heat").text,
                                 "a law of heat with a rigid body, which has no temperature; "
                                 "allowed: insulated");
    if (own && !is_whole)
        MPM_TRY(check_pair(reading, &keys, pair));
    return fill_surface(reading, &keys, &pair->surfaces[MPM_TEMPERATURE]);
}

bool mpm_surfaces_agree(const struct mpm_surface_spec *one, const struct mpm_surface_spec *other)
{
    return one->law == other->law && one->conductance == other->conductance &&
           one->gap == other->gap;
}

/* Does any pair use a key of contact itself? */
enum mpm_status mpm_check_pair_surfaces(const struct mpm_reading *reading)
{
    const struct mpm_raw_contact *const whole = reading->raw->contact;
    const struct mpm_contact_spec *const contact = &reading->scene->contact;
    bool gap = whole->heat_gap == NULL;
    bool law = whole->heat == MPM_SURFACE_INSULATES;
    for (size_t k = 0; k < contact->pair_count; k++) {
        const struct mpm_path path = mpm_path_join(contact->pairs[k].key, "heat");
        const bool own =
            strcmp(contact->pairs[k].key, "contact") != 0 && mpm_reading_given(reading, path.text);
        const bool rigid = contact->pairs[k].of[1] >= contact->deformable_fields;
        law = law || (!own && !rigid);
        gap = gap ||
              (!own && !rigid && uses_gap(&contact->pairs[k], (enum mpm_surface_law)whole->heat));
    }
    if (law && gap)
        return MPM_OK;
    return mpm_reading_fault(reading, law ? "contact.heat_gap" : "contact.heat",
                             "given, and no pair uses it; allowed: where a pair of deformable "
                             "bodies does");
}

/* ----------------------------------------------------------------------- cracks */

enum mpm_status mpm_build_crack_surface(const struct mpm_reading *reading, const char *path,
                                        const struct mpm_raw_crack *raw,
                                        struct mpm_crack_spec *crack)
{
    const struct keys keys = {path, (enum mpm_surface_law)raw->heat, raw->conductance, NULL};
    if (reading->raw->transport->temperature == NULL)
        return refuse_without(reading, &keys);
    return fill_surface(reading, &keys, &crack->surfaces[MPM_TEMPERATURE]);
}

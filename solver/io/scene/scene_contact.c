/* Contact between bodies: groups that have velocity fields of their own, and pairs of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"
#include "simulation/interface_limit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------- groups */

static bool has_deformable(const struct mpm_scene *scene, size_t material)
{
    for (size_t k = 0; k < scene->body_count; k++)
        if (!scene->bodies[k].rigid && scene->bodies[k].material == material)
            return true;
    return false;
}

static void add_group(struct mpm_contact_spec *contact, const char *name, bool rigid, size_t body)
{
    contact->groups[contact->group_count++] =
        (struct mpm_contact_group){.name = name, .rigid = rigid, .body = body};
}

/* Deformable groups come first: the materials that bodies have, or bodies; then rigid bodies. */
static enum mpm_status list_groups(const struct mpm_reading *reading)
{
    struct mpm_scene *const scene = reading->scene;
    struct mpm_contact_spec *const contact = &scene->contact;
    const size_t most = scene->material_count + scene->body_count;
    MPM_TRY(
        mpm_reading_allocate(reading, most, sizeof *contact->groups, "contact", &contact->groups));
    MPM_TRY(mpm_reading_allocate(reading, scene->body_count, sizeof *contact->group_of, "contact",
                                 &contact->group_of));
    for (size_t m = 0; m < scene->material_count && !contact->by_body; m++) {
        if (!has_deformable(scene, m))
            continue;
        for (size_t k = 0; k < scene->body_count; k++)
            if (!scene->bodies[k].rigid && scene->bodies[k].material == m)
                contact->group_of[k] = contact->group_count;
        add_group(contact, scene->materials[m].name, false, 0);
    }
    for (int rigid = 0; rigid < 2; rigid++)
        for (size_t k = 0; k < scene->body_count; k++) {
            if (scene->bodies[k].rigid != (rigid != 0) || (rigid == 0 && !contact->by_body))
                continue;
            contact->group_of[k] = contact->group_count;
            add_group(contact, scene->bodies[k].name, rigid != 0, k);
        }
    return MPM_OK;
}

static enum mpm_status find_group(const struct mpm_reading *reading, const char *path,
                                  const char *name, size_t *group)
{
    const struct mpm_contact_spec *const contact = &reading->scene->contact;
    size_t found = 0;
    for (size_t k = 0; k < contact->group_count; k++)
        if (strcmp(contact->groups[k].name, name) == 0) {
            *group = k;
            found++;
        }
    if (found == 1)
        return MPM_OK;
    if (found > 1)
        return mpm_reading_fault(
            reading, path, "'%s' is a material and a rigid body; allowed: different names", name);
    return mpm_reading_fault(reading, path, "unknown %s '%s'; allowed: %s",
                             contact->by_body ? "body" : "material or rigid body", name,
                             contact->by_body
                                 ? "the name of a body"
                                 : "the name of a material that a body has, or of a rigid body");
}

/* -------------------------------------------------------------------- laws */

/* The keys of a law, at contact itself or at one of its pairs. */
struct given {
    const char *path;
    const char *name, *value;
    bool fits;
    const char *with;
};

static enum mpm_status check_given(const struct mpm_reading *reading, const struct given *given)
{
    if (given->value == NULL || given->fits)
        return MPM_OK;
    return mpm_reading_fault(reading, mpm_path_join(given->path, given->name).text,
                             "got %s, which this pair does not use; allowed: with %s only",
                             given->value, given->with);
}

static enum mpm_status check_keys(const struct mpm_reading *reading, const char *path,
                                  const struct mpm_raw_contact_pair *raw,
                                  const struct mpm_pair_spec *pair)
{
    const bool friction = pair->law == MPM_PAIR_FRICTION;
    const bool interface = pair->law == MPM_PAIR_INTERFACE;
    const bool touches =
        friction || pair->law == MPM_PAIR_STICK || pair->law == MPM_PAIR_FRICTIONLESS;
    const struct given given[] = {
        {path, "friction", raw->friction, friction, "law: friction"},
        {path, "static_friction", raw->static_friction, friction, "law: friction"},
        {path, "adhesion", raw->adhesion, touches, "law: friction, stick or frictionless"},
        {path, "touching", raw->touching, touches && pair->detection == MPM_TOUCH_VOLUME,
         "detection: volume"},
        {path, "tension", raw->tension, interface, "law: interface"},
        {path, "compression", raw->compression, interface, "law: interface"},
        {path, "shear", raw->shear, interface, "law: interface"},
        {path, "ratio_limit", raw->ratio_limit, interface, "law: interface"},
        {path, "direction", raw->direction[0], pair->normal == MPM_NORMAL_GIVEN, "normal: given"},
    };
    for (size_t k = 0; k < sizeof given / sizeof given[0]; k++)
        MPM_TRY(check_given(reading, &given[k]));
    if (friction && raw->friction == NULL)
        return mpm_reading_fault(reading, mpm_path_join(path, "law").text,
                                 "friction without its coefficient; allowed: friction: a number "
                                 "of at least 0 beside it");
    if (interface && (raw->tension == NULL || raw->shear == NULL))
        return mpm_reading_fault(reading, mpm_path_join(path, "law").text,
                                 "an interface without stiffness; allowed: tension and shear, and "
                                 "compression if it differs from tension");
    if (pair->normal == MPM_NORMAL_GIVEN && raw->direction[0] == NULL)
        return mpm_reading_fault(reading, mpm_path_join(path, "normal").text,
                                 "given without direction; allowed: direction: a vector from the "
                                 "first to the second");
    return MPM_OK;
}

static enum mpm_status check_ratio(const struct mpm_reading *reading, const char *path,
                                   const struct mpm_raw_contact_pair *raw,
                                   const struct mpm_pair_spec *pair)
{
    const double ratio = mpm_pair_unevenness(pair);
    const double limit =
        raw->ratio_limit == NULL ? MPM_UNEVEN_MAX : mpm_raw_double(raw->ratio_limit);
    if (ratio <= limit)
        return MPM_OK;
    return mpm_reading_fault(reading, mpm_path_join(path, "shear").text,
                             "stiffnesses along and across the surface differ by a factor of %.3g, "
                             "and errors of this normal make energy of it where bodies turn; "
                             "allowed: up to %g (ratio_limit), or normal: logistic or given",
                             ratio, limit);
}

static enum mpm_status fill_direction(const struct mpm_reading *reading, const char *path,
                                      const struct mpm_raw_contact_pair *raw,
                                      struct mpm_pair_spec *pair)
{
    if (pair->normal != MPM_NORMAL_GIVEN)
        return MPM_OK;
    for (int axis = 0; axis < 2; axis++)
        pair->direction[axis] = mpm_raw_double(raw->direction[axis]);
    const double length = hypot(pair->direction[0], pair->direction[1]);
    if (!(length > 0.0 && isfinite(length)))
        return mpm_reading_fault(reading, mpm_path_join(path, "direction").text,
                                 "got a vector of length %g; allowed: finite, above 0", length);
    for (int axis = 0; axis < 2; axis++)
        pair->direction[axis] /= length;
    return MPM_OK;
}

/* What a pair does not give is that of contact. */
static enum mpm_status fill_law(const struct mpm_reading *reading, const char *path,
                                const struct mpm_raw_contact_pair *raw, struct mpm_pair_spec *pair)
{
    const struct mpm_raw_contact *const whole = reading->raw->contact;
    const bool own_normal = mpm_reading_given(reading, mpm_path_join(path, "normal").text);
    const bool own_detection = mpm_reading_given(reading, mpm_path_join(path, "detection").text);
    pair->law = (enum mpm_pair_law)raw->law;
    pair->normal = (enum mpm_pair_normal)(own_normal ? raw->normal : whole->normal);
    pair->detection = (enum mpm_pair_detection)(own_detection ? raw->detection : whole->detection);
    MPM_TRY(check_keys(reading, path, raw, pair));
    pair->friction = mpm_raw_double(raw->friction);
    pair->static_friction =
        raw->static_friction == NULL ? pair->friction : mpm_raw_double(raw->static_friction);
    pair->adhesion = mpm_raw_double(raw->adhesion);
    pair->touching = raw->touching == NULL ? 0.9 : mpm_raw_double(raw->touching);
    pair->tension = mpm_raw_double(raw->tension);
    pair->compression = raw->compression == NULL ? pair->tension : mpm_raw_double(raw->compression);
    pair->shear = mpm_raw_double(raw->shear);
    MPM_TRY(check_ratio(reading, path, raw, pair));
    if (pair->static_friction < pair->friction)
        return mpm_reading_fault(reading, mpm_path_join(path, "static_friction").text,
                                 "got %g; allowed: at least friction, %g", pair->static_friction,
                                 pair->friction);
    return fill_direction(reading, path, raw, pair);
}

/* ------------------------------------------------------------------- pairs */

/* The law of every pair of groups, before fields are known. */
struct table {
    struct mpm_pair_spec *laws; /* of groups a < b: at a * groups + b */
    size_t groups;
};

static struct mpm_pair_spec *law_of(const struct table *table, size_t one, size_t other)
{
    return &table->laws[one < other ? one * table->groups + other : other * table->groups + one];
}

/* Rigid bodies drive nodes unless a pair is given, and each other never. */
static enum mpm_status fill_defaults(const struct mpm_reading *reading, const struct table *table)
{
    const struct mpm_contact_spec *const contact = &reading->scene->contact;
    const struct mpm_raw_contact *const raw = reading->raw->contact;
    const struct mpm_raw_contact_pair as_pair = {
        .law = raw->law,
        .normal = raw->normal,
        .detection = raw->detection,
        .friction = raw->friction,
        .static_friction = raw->static_friction,
        .adhesion = raw->adhesion,
        .touching = raw->touching,
        .tension = raw->tension,
        .compression = raw->compression,
        .shear = raw->shear,
        .ratio_limit = raw->ratio_limit,
        .heat = raw->heat,
        .conductance = raw->conductance,
        .heat_gap = raw->heat_gap,
    };
    struct mpm_pair_spec usual = {.key = "contact"};
    if (raw->normal == MPM_NORMAL_GIVEN)
        return mpm_reading_fault(reading, "contact.normal",
                                 "given for all pairs; allowed: with pairs, each with its "
                                 "direction");
    MPM_TRY(fill_law(reading, "contact", &as_pair, &usual));
    MPM_TRY(mpm_build_pair_surface(reading, "contact", &as_pair, false, &usual));
    for (size_t a = 0; a < table->groups; a++)
        for (size_t b = a + 1; b < table->groups; b++) {
            struct mpm_pair_spec *const law = law_of(table, a, b);
            *law = usual;
            if (contact->groups[b].rigid)
                law->law = MPM_PAIR_NONE;
            if (law->law == MPM_PAIR_NONE)
                memset(law->surfaces, 0, sizeof law->surfaces);
            law->of[0] = a;
            law->of[1] = b;
        }
    return MPM_OK;
}

static enum mpm_status check_rigid(const struct mpm_reading *reading, const char *path, size_t a,
                                   size_t b, const struct mpm_pair_spec *pair)
{
    const struct mpm_scene *const scene = reading->scene;
    const struct mpm_contact_group *const groups = scene->contact.groups;
    if (groups[a].rigid && groups[b].rigid)
        return mpm_reading_fault(reading, path,
                                 "a pair of rigid bodies, '%s' and '%s'; allowed: one of them "
                                 "deformable",
                                 groups[a].name, groups[b].name);
    for (int k = 0; k < 2; k++) {
        const struct mpm_contact_group *const group = &groups[k == 0 ? a : b];
        const char *const *const velocity =
            (const char *const *)scene->bodies[group->body].velocity.text;
        if (group->rigid && pair->law == MPM_PAIR_INTERFACE)
            return mpm_reading_fault(reading, path,
                                     "an interface with rigid body '%s', whose displacement is not "
                                     "kept; allowed: between deformable ones",
                                     group->name);
        if (group->rigid && pair->law != MPM_PAIR_NONE &&
            (velocity[0] == NULL || velocity[1] == NULL))
            return mpm_reading_fault(reading, path,
                                     "rigid body '%s' has a free component of velocity; allowed in "
                                     "contact: both components",
                                     group->name);
    }
    return MPM_OK;
}

static enum mpm_status fill_pair(const struct mpm_reading *reading, size_t index,
                                 const struct table *table)
{
    const struct mpm_raw_contact_pair *const raw = &reading->raw->contact->pairs[index];
    const struct mpm_path path = mpm_path_entry("contact.pairs", index);
    const struct mpm_path of = mpm_path_join(path.text, "of");
    size_t group[2] = {0, 0};
    for (int k = 0; k < 2; k++)
        MPM_TRY(find_group(reading, of.text, raw->of[k], &group[k]));
    if (group[0] == group[1])
        return mpm_reading_fault(reading, of.text, "'%s' with itself; allowed: two different ones",
                                 raw->of[0]);
    struct mpm_pair_spec *const law = law_of(table, group[0], group[1]);
    if (strcmp(law->key, "contact") != 0)
        return mpm_reading_fault(reading, of.text,
                                 "'%s' and '%s' again, which %s has already; allowed: one law for "
                                 "a pair",
                                 raw->of[0], raw->of[1], law->key);
    MPM_TRY(fill_law(reading, path.text, raw, law));
    MPM_TRY(check_rigid(reading, of.text, group[0], group[1], law));
    const struct mpm_contact_group *const groups = reading->scene->contact.groups;
    MPM_TRY(mpm_build_pair_surface(reading, path.text, raw,
                                   groups[group[0]].rigid || groups[group[1]].rigid, law));
    (void)snprintf(law->key, sizeof law->key, "contact.pairs.%zu", index);
    for (int axis = 0; axis < 2 && group[0] > group[1]; axis++)
        law->direction[axis] = -law->direction[axis];
    return MPM_OK;
}

/* ------------------------------------------------------------------- fields */

/* Groups that share a field get the number of the first of them, and then fields are counted. */
static void number_fields(struct mpm_contact_spec *contact, const struct table *table)
{
    size_t *const field = contact->field_of;
    size_t count = 0;
    for (size_t a = 0; a < table->groups; a++)
        field[a] = a;
    for (size_t a = 0; a < table->groups; a++)
        for (size_t b = a + 1; b < table->groups && !contact->groups[a].rigid; b++) {
            const size_t low = field[a] < field[b] ? field[a] : field[b];
            const size_t high = field[a] < field[b] ? field[b] : field[a];
            if (contact->groups[b].rigid || law_of(table, a, b)->law != MPM_PAIR_NONE)
                continue;
            for (size_t k = 0; k < table->groups; k++)
                if (field[k] == high)
                    field[k] = low;
        }
    for (size_t a = 0; a < table->groups; a++) {
        bool meets = !contact->groups[a].rigid;
        for (size_t b = 0; b < a && !meets; b++)
            meets = law_of(table, b, a)->law != MPM_PAIR_NONE;
        field[a] = !meets ? SIZE_MAX : field[a] == a ? count++ : field[field[a]];
    }
    contact->field_count = count;
    for (size_t a = 0; a < table->groups; a++)
        if (!contact->groups[a].rigid && field[a] + 1 > contact->deformable_fields)
            contact->deformable_fields = field[a] + 1;
}

static bool same_law(const struct mpm_pair_spec *one, const struct mpm_pair_spec *other)
{
    struct mpm_pair_spec a = *one, b = *other;
    memset(a.key, 0, sizeof a.key);
    memset(b.key, 0, sizeof b.key);
    return a.law == b.law && a.normal == b.normal && a.detection == b.detection &&
           a.direction[0] == b.direction[0] && a.direction[1] == b.direction[1] &&
           a.touching == b.touching && a.friction == b.friction &&
           a.static_friction == b.static_friction && a.adhesion == b.adhesion &&
           a.tension == b.tension && a.compression == b.compression && a.shear == b.shear &&
           mpm_surfaces_agree(&a.surfaces[MPM_TEMPERATURE], &b.surfaces[MPM_TEMPERATURE]);
}

/* Puts the law of two groups into the list of pairs of fields, which must agree. */
static enum mpm_status add_pair(const struct mpm_reading *reading, const struct mpm_pair_spec *law)
{
    struct mpm_contact_spec *const contact = &reading->scene->contact;
    const struct mpm_contact_group *const groups = contact->groups;
    const size_t one = contact->field_of[law->of[0]], other = contact->field_of[law->of[1]];
    if (one == SIZE_MAX || other == SIZE_MAX ||
        (groups[law->of[0]].rigid && groups[law->of[1]].rigid))
        return MPM_OK;
    if (one == other && law->law == MPM_PAIR_NONE)
        return MPM_OK;
    if (one == other)
        return mpm_reading_fault(reading, law->key,
                                 "'%s' and '%s' share a velocity field, through pairs without a "
                                 "law; allowed: a law for every pair that links them",
                                 groups[law->of[0]].name, groups[law->of[1]].name);
    for (size_t k = 0; k < contact->pair_count; k++)
        if (contact->pairs[k].of[0] == one && contact->pairs[k].of[1] == other) {
            if (same_law(&contact->pairs[k], law))
                return MPM_OK;
            return mpm_reading_fault(reading, law->key,
                                     "'%s' and '%s' have another law than a pair of the same two "
                                     "velocity fields; allowed: one law for groups that share one",
                                     groups[law->of[0]].name, groups[law->of[1]].name);
        }
    if (law->law == MPM_PAIR_NONE) /* of a rigid body that drives this field's nodes */
        return MPM_OK;
    struct mpm_pair_spec *const pair = &contact->pairs[contact->pair_count++];
    *pair = *law;
    pair->of[0] = one;
    pair->of[1] = other;
    return MPM_OK;
}

static enum mpm_status list_pairs(const struct mpm_reading *reading, const struct table *table)
{
    struct mpm_contact_spec *const contact = &reading->scene->contact;
    MPM_TRY(mpm_reading_allocate(reading, table->groups, sizeof *contact->field_of, "contact",
                                 &contact->field_of));
    number_fields(contact, table);
    if (contact->field_count > MPM_CONTACT_FIELDS)
        return mpm_reading_fault(reading, "contact",
                                 "too many velocity fields, got %zu of %s and rigid bodies; "
                                 "allowed: up to %d",
                                 contact->field_count, contact->by_body ? "bodies" : "materials",
                                 MPM_CONTACT_FIELDS);
    if (contact->field_count < 2)
        return mpm_reading_fault(reading, "contact",
                                 "no pair with a law: all bodies share one velocity field; "
                                 "allowed: a law other than none, and two or more %s or a rigid "
                                 "body in pairs",
                                 contact->by_body ? "bodies" : "materials");
    MPM_TRY(mpm_reading_allocate(reading, table->groups * table->groups, sizeof *contact->pairs,
                                 "contact", &contact->pairs));
    for (size_t a = 0; a < table->groups; a++)
        for (size_t b = a + 1; b < table->groups; b++)
            MPM_TRY(add_pair(reading, law_of(table, a, b)));
    return mpm_check_pair_surfaces(reading);
}

static enum mpm_status build_table(const struct mpm_reading *reading, const struct table *table)
{
    MPM_TRY(fill_defaults(reading, table));
    for (unsigned k = 0; k < reading->raw->contact->pairs_count; k++)
        MPM_TRY(fill_pair(reading, k, table));
    return list_pairs(reading, table);
}

enum mpm_status mpm_build_contact(const struct mpm_reading *reading)
{
    const struct mpm_raw_contact *const raw = reading->raw->contact;
    struct mpm_scene *const scene = reading->scene;
    if (raw == NULL)
        return MPM_OK;
    scene->contact.by_body = raw->fields;
    MPM_TRY(list_groups(reading));
    const size_t groups = scene->contact.group_count;
    struct table table = {.groups = groups};
    MPM_TRY(
        mpm_reading_allocate(reading, groups * groups, sizeof *table.laws, "contact", &table.laws));
    const enum mpm_status status = build_table(reading, &table);
    free(table.laws);
    return status == MPM_OK ? mpm_build_cracked_field(reading) : status;
}

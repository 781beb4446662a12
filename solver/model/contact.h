/* What a scene says of contact between its bodies: which of them have a velocity field of their
 * own, and what each pair of fields does where both meet.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_CONTACT_H
#define MPM_MODEL_CONTACT_H

#include "model/transport.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What two fields do. */
enum mpm_pair_law {
    MPM_PAIR_NONE,         /* they are one field */
    MPM_PAIR_BONDED,       /* one velocity wherever both have mass, in tension too */
    MPM_PAIR_STICK,        /* no sliding while pressed */
    MPM_PAIR_FRICTIONLESS, /* no approach while in contact */
    MPM_PAIR_FRICTION,     /* Coulomb */
    MPM_PAIR_INTERFACE,    /* imperfect interface: traction by the jump of displacement */
};

/* Where the normal comes from; see method/contact/contact_normal.h. */
enum mpm_pair_normal {
    MPM_NORMAL_VOLUME,   /* volume gradients of both, N&G (54) */
    MPM_NORMAL_AREA,     /* area gradients of both, N&G (55) */
    MPM_NORMAL_AVERAGE,  /* the same, each with its own area as weight */
    MPM_NORMAL_LARGER,   /* area gradient of the one that has more area there */
    MPM_NORMAL_LINEAR,   /* a plane through the particles of both: linear regression */
    MPM_NORMAL_LOGISTIC, /* logistic regression */
    MPM_NORMAL_GIVEN,    /* by the scene */
    MPM_NORMAL_COUNT
};

/* By what it is decided whether both are in contact; see method/contact/contact_detection.h. */
enum mpm_pair_detection {
    MPM_TOUCH_EXTENT, /* the distance between their surfaces, from the particles' edges */
    MPM_TOUCH_VOLUME, /* the areas at the node over that which it can see */
    MPM_TOUCH_SHARED, /* they share a node */
};

struct mpm_pair_spec {
    char key[64]; /* "contact.pairs.1", for messages */
    size_t of[2]; /* groups, the first one with the smaller number */
    enum mpm_pair_law law;
    enum mpm_pair_normal normal;
    enum mpm_pair_detection detection;
    double direction[2]; /* of MPM_NORMAL_GIVEN: unit vector from the first to the second */
    double touching;     /* of MPM_TOUCH_VOLUME */
    double friction, static_friction;
    double adhesion; /* stress */
    double tension, compression,
        shear; /* D_n of an opening, of an overlap; D_t: stress over length */
    struct mpm_surface_spec surfaces[MPM_SCALAR_COUNT];
};

/* A group has one velocity field: a material's bodies, or one body; or a rigid body. */
struct mpm_contact_group {
    const char *name;
    bool rigid;
    size_t body; /* of a rigid one */
};

/* Fields that may meet at a node; with the two more that a crack gives to one of them. */
enum { MPM_CONTACT_FIELDS = 8, MPM_CONTACT_SIDES = MPM_CONTACT_FIELDS + 2 };
/* What no field is. */
#define MPM_NO_FIELD SIZE_MAX

struct mpm_contact_spec {
    bool by_body; /* else by material */
    struct mpm_contact_group *groups;
    size_t group_count;
    size_t *group_of;   /* per body of the scene */
    size_t *field_of;   /* per group: SIZE_MAX for a rigid one that only drives nodes */
    size_t field_count; /* 0: no contact in the scene; deformable ones come first */
    size_t deformable_fields;
    size_t cracked_field; /* the one that all cracks cut; MPM_NO_FIELD: there are none */
    /* Pairs of fields between which there is contact, ordered by their first group, then by their
     * second one; `of` are fields here. */
    struct mpm_pair_spec *pairs;
    size_t pair_count;
};

#endif

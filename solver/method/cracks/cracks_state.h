/* What cracks keep: of the scene, and of a step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CRACKS_STATE_H
#define MPM_METHOD_CRACKS_STATE_H

#include "method/shape/shape.h"
#include "model/crack.h"

#include <stdbool.h>
#include <stdint.h>

/* The fields that one surface of a crack moves with at one of its points: nodes of the corners of a
 * cell, weights of sum 1. None where no such field has mass. */
struct mpm_crack_surface {
    int count;
    int64_t node[4];
    double weight[4];
};

/* The surfaces of cracks whose openings are tracked; all NULL where none is. See crack_opening.h.
 */
struct mpm_crack_openings {
    double *vector[2]; /* per point: place of the surface above minus that of the one below */
    double *largest;   /* per point, cohesive: the largest effective opening so far */
    double *area;      /* per point, cohesive: undeformed area, for the thickness or per radian */
    bool (*cuts)[2];   /* per crack: does it cut its body's edge at its first point, at its last? */
    /* per crack: its points, among those of all, where it enters a body from outside, seen from its
     * first point and from its last; SIZE_MAX: that point is no mouth, or in a body itself */
    size_t (*mouths)[2];
    /* Of the step, per point: the surface above, and that below */
    struct mpm_crack_surface (*surfaces)[2];
};

/* The segment that the line from a particle to a node crosses; the latter for contact alone. */
struct mpm_crack_crossing {
    uint32_t crack, segment;
};

/* A point beyond a plane of symmetry that its crack passes: the image of one inside. */
struct mpm_crack_image {
    size_t point, of; /* places among the points of all cracks */
    int axis;         /* of the plane's normal */
    double plane;     /* where it is along that axis */
};

/* Cracks; all empty where a scene has none. */
struct mpm_cracks {
    struct mpm_crack_chain *chains; /* per crack of the scene */
    size_t point_count;
    double *position[2]; /* of all chains' points, one after the other */
    /* The chains at t = 0 as the scene has them, with the points that have grown where these are in
     * the undeformed body. Only with MPM_USE_ORIGINS; else NULL. */
    struct mpm_crack_chain *undeformed;
    double *origin[2]; /* of all their points */
    uint8_t *held;     /* per point: bits of the axes along which a symmetry plane holds it */
    uint8_t *passes;   /* per crack: bits of the axes across which it passes such planes */
    struct mpm_crack_image *images;
    size_t image_count;
    double least_mass; /* of a node that moves cracks; see mpm_cracks_advance */
    struct mpm_crack_openings openings;
    /* Of the step */
    struct mpm_crack_map *map; /* cells near cracks; see crack_map.h */
    /* For additional fields; see crack_fields.h. Per particle in `uses` of mpm_fields, per node of
     * its stencil: */
    struct mpm_crack_crossing (*crossings)[MPM_STENCIL_MAX];
    struct mpm_crack_sums *sums;                 /* per node in `nodes`: of its own field */
    struct mpm_crack_field *fields;              /* per field in `list` */
    struct mpm_crack_surface_sums *surface_sums; /* the same; see crack_passages.h; or NULL */
    struct mpm_exchange_touch *touches; /* pairs of fields that touch; see crack_contact.h */
    uint32_t *touch_of; /* per node in `nodes`, beside contact between bodies: one more than the
                         * place of its first pair, or 0; or NULL */
    size_t touch_count;
};

#endif

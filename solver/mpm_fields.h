/* What particles carry, as snapshots have it. Part of the public interface: mpm.h includes it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_FIELDS_H
#define MPM_FIELDS_H

#include "mpm_api.h"
#include "mpm_dimension.h"
#include "mpm_error.h"

#include <stdbool.h>
#include <stddef.h>

MPM_API_BEGIN

struct mpm_scene;
struct mpm_simulation;

/* What a particle carries, in the order of snapshots. */
enum mpm_field {
    MPM_FIELD_ID,                   /* 1: creation order, body by body, row by row */
    MPM_FIELD_BODY,                 /* 1: index of the body in the scene */
    MPM_FIELD_POSITION,             /* 2 */
    MPM_FIELD_VELOCITY,             /* 2 */
    MPM_FIELD_DEFORMATION_GRADIENT, /* 5: xx xy yx yy zz | rr rz zr zz tt */
    MPM_FIELD_STRESS,               /* 4: Cauchy, xx yy zz xy | rr zz tt rz */
    MPM_FIELD_VOLUME,               /* 1: current (per thickness or per radian) */
    MPM_FIELD_MASS,                 /* 1 */
    MPM_FIELD_TEMPERATURE,          /* 1: of scenes with transport.temperature, else 0 */
    MPM_FIELD_CONCENTRATION,        /* 1: of scenes with transport.concentration, else 0 */
    MPM_FIELD_PLASTIC_STRAIN,       /* 1: equivalent; 0 of materials without it */
    MPM_FIELD_FRINGE,               /* 1: CRAMP (23); not a number without output.fringe */
    MPM_FIELD_INTERNAL_ENERGY,      /* 1: per mass; 0 of materials without an equation of state */
    MPM_FIELD_STATE_TEMPERATURE,    /* 1: of the equation of state; 0 of materials without */
    MPM_FIELD_VISCOUS_PRESSURE,     /* 1: artificial, part of the stress; 0 of materials without */
    MPM_FIELD_DISPLACEMENT,         /* 2: since t = 0; not a number of rigid particles */
    MPM_FIELD_VON_MISES,            /* 1: equivalent stress */
    MPM_FIELD_PRESSURE,             /* 1: minus the mean normal stress */
    MPM_FIELD_COUNT,
};

struct mpm_field_info {
    const char *name;
    size_t components;
    bool integer;
    struct mpm_dimension dimension;
    const char *description;
};

/* The descriptor of a field. Dimensions are per radian as they are for the thickness. */
const struct mpm_field_info *mpm_field_describe(enum mpm_field field);

/* Finds the field of that name. MPM_BAD_INPUT: there is none; the message lists those allowed. */
enum mpm_status mpm_field_find(const char *name, enum mpm_field *field, struct mpm_error *error);

/* Is the field one of the scene's snapshots? All up to mass are always, the others where the scene
 * has them. */
bool mpm_scene_has_field(const struct mpm_scene *scene, enum mpm_field field);

/* The unit of a field in the names of the scene's units, as in snapshots: "g mm^-1 ms^-2". */
enum { MPM_FIELD_UNIT_SIZE = 1024 };
void mpm_scene_field_unit(const struct mpm_scene *scene, enum mpm_field field,
                          char text[MPM_FIELD_UNIT_SIZE]);

/* Copies a field of all particles, sorted by id: particle-major,
 * count * components values. Rigid bodies' particles are included. */
void mpm_simulation_field(const struct mpm_simulation *simulation, enum mpm_field field,
                          double *values);

/* The same for the particles with ids first .. first + count - 1, all of which must be there: a
 * simulation block by block, in a buffer of the caller's choice. Finds the ids' places in memory of
 * the simulation, once after each sort: not for several threads at a time. */
void mpm_simulation_field_range(const struct mpm_simulation *simulation, enum mpm_field field,
                                size_t first, size_t count, double *values);

MPM_API_END

#endif

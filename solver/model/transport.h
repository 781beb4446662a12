/* What a scene says of scalars that are conducted: temperature, and concentration of a solvent.
 *
 * Concentration is N&G's and the Notes' potential mu = c / c_sat. A particle's solvent is c_sat m /
 * rho_0 times mu: the capacity is that of the undeformed volume, so that deformation in a closed
 * box neither makes nor takes solvent.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_TRANSPORT_H
#define MPM_MODEL_TRANSPORT_H

#include "model/property.h"
#include "mpm_dimension.h"

#include <stdbool.h>
#include <stddef.h>

enum mpm_scalar { MPM_TEMPERATURE, MPM_CONCENTRATION, MPM_SCALAR_COUNT };

/* How the particles' values follow the grid. */
enum mpm_scalar_transfer {
    MPM_SCALAR_FLIP, /* by the nodes' rates: N&G (62), Notes (141) */
    MPM_SCALAR_PIC,  /* by the nodes' values, Notes (142): conducts of itself */
    MPM_SCALAR_XPIC, /* by more of their values at the start, and rates: transport_smoothing.h */
    MPM_SCALAR_FMPM, /* by more of their values at the end */
};

/* What flows in through edges of particles: content per area and time, inwards positive. */
enum mpm_flux_kind {
    MPM_NO_FLUX,       /* a force */
    MPM_FLUX_GIVEN,    /* an expression */
    MPM_FLUX_CONVECTS, /* h (v_env - v) */
    MPM_FLUX_RADIATES, /* e sigma (v_env^4 - v^4) */
};

/* What surfaces that meet pass on: those of bodies in contact, or of a crack. */
enum mpm_surface_law {
    MPM_SURFACE_INSULATES,   /* nothing */
    MPM_SURFACE_PERFECT,     /* both have one value at a node */
    MPM_SURFACE_CONDUCTANCE, /* H (v_a - v_b) per area and time */
};

struct mpm_surface_spec {
    enum mpm_surface_law law;
    double conductance; /* H; of other laws 0 */
    double gap;         /* of bodies, detection: extent: the largest one that it acts across */
};

/* What is the same for every scene, one row for each scalar. */
struct mpm_scalar_row {
    const char *name;                    /* of its group of keys: transport.<name> */
    unsigned use;                        /* enum mpm_particle_use: particles carry it */
    size_t field;                        /* enum mpm_particle_field: where they do */
    struct mpm_dimension content;        /* of capacity times value: energy */
    const char *content_name;            /* "thermal_energy": a column of the history */
    const char *flow_name;               /* "heat": what flows, in names of columns */
    const char *tables[MPM_TABLE_COUNT]; /* keys: "heat_capacity_table"; NULL: has none */
};
/* A table of a scalar as one number. */
static inline int mpm_table_place(enum mpm_scalar which, int table)
{
    return (int)which * MPM_TABLE_COUNT + table;
}

extern const struct mpm_scalar_row mpm_scalar_rows[MPM_SCALAR_COUNT];

/* Of a material: free strain = coefficient (v - stress_free); the coefficient is 0 if it has none.
 */
struct mpm_expansion {
    double coefficient, stress_free;
};

/* Of a material: content = capacity per mass times mass times value; flux = - K grad value. With
 * tables they are those of the particle's own value; content is then, with one of the capacity,
 * which temperature alone has, the enthalpy: mass times the integral of the capacity from 0. */
struct mpm_conduction {
    bool given;       /* the material has them */
    double capacity;  /* per mass; of a table the smallest */
    double k[3];      /* conductivity xx yy xy of the undeformed body; with a table 1 1 0, times its
                         value */
    bool anisotropic; /* k is not a number times the unit tensor: it turns with the material */
    struct mpm_property tables[MPM_TABLE_COUNT]; /* without points: constants */
};

#endif

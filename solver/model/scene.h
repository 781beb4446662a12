/* What a scene file says, checked and with defaults filled in: the input of
 * mpm_simulation_create. io/ reads it; the rest of the solver only looks.
 *
 * Lengths, masses and times are in the scene's own units.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_SCENE_H
#define MPM_MODEL_SCENE_H

#include "base/status.h"
#include "model/contact.h"
#include "model/laws/cohesive.h"
#include "model/laws/viscosity.h"
#include "model/material.h"
#include "model/transport.h"

enum { MPM_NAME_SIZE = 257 }; /* names up to 64 characters of UTF-8 */

enum mpm_stress_update {
    MPM_USL,
    MPM_MUSL,
    MPM_USF,
    MPM_USAVG,
    MPM_USAVG_ONCE, /* usavg with extrapolate: false */
    MPM_ORDER_COUNT
};
enum mpm_position_update { MPM_GRID_VELOCITY, MPM_MIDPOINT };
enum mpm_radius_update { MPM_RADIUS_SHAPE, MPM_RADIUS_HOOP };

/* How particle velocities follow the grid: method.transfer.kind in scenes. What belongs to each is
 * a row of method/transfer/transfers.c; solver/README.md has the equations. */
#define MPM_TRANSFERS(T)                                                                           \
    T("flip", MPM_TRANSFER_FLIP)                                                                   \
    T("pic", MPM_TRANSFER_PIC)                                                                     \
    T("xpic", MPM_TRANSFER_XPIC)                                                                   \
    T("fmpm", MPM_TRANSFER_FMPM)                                                                   \
    T("apic", MPM_TRANSFER_APIC)
#define MPM_KIND(name, kind) kind,
enum mpm_transfer_kind { MPM_TRANSFERS(MPM_KIND) MPM_TRANSFER_COUNT };
#undef MPM_KIND

/* What the particles' updates take from the nodes: Notes 5.1 or 5.2. */
enum mpm_form { MPM_FORM_VELOCITY, MPM_FORM_MOMENTUM };

/* v_r of the extra nodes, at r < 0; those on r = 0 have v_r = 0 with each. */
enum mpm_axis_nodes {
    MPM_AXIS_NODES_ZERO,
    MPM_AXIS_NODES_FREE,     /* as it comes */
    MPM_AXIS_NODES_MIRRORED, /* minus that of the node at -r */
};

enum mpm_region_kind {
    MPM_REGION_RECTANGLE, /* a = from, b = to */
    MPM_REGION_DISK,      /* a = center, outer = radius */
    MPM_REGION_ANNULUS,   /* a = center, inner, outer */
    MPM_REGION_POLYGON,   /* points */
    MPM_REGION_LINE,      /* a = from, b = to */
    MPM_REGION_ALL,
};

struct mpm_region {
    enum mpm_region_kind kind;
    double a[2], b[2];
    double inner, outer;
    double (*points)[2];
    size_t point_count;
};

/* A vector of expressions; a NULL component is `free`. */
struct mpm_vector_expression {
    char *text[2];
};

struct mpm_material_spec {
    char name[MPM_NAME_SIZE];
    const struct mpm_material_law *law;
    double density;
    double parameter[MPM_PARAMETER_COUNT]; /* bulk and shear whichever pair of constants the scene
                                              gives; NaN where the law has no such parameter */
    struct mpm_conduction conduction[MPM_SCALAR_COUNT];
    struct mpm_expansion expansion[MPM_SCALAR_COUNT];
    struct mpm_property hardening; /* s over p; count 0: by parameters */
    struct mpm_viscosity viscosity;
    int line; /* in the scene file, for messages */
};

struct mpm_body_spec {
    char name[MPM_NAME_SIZE];
    bool rigid;
    size_t material; /* index; unused for a rigid body */
    struct mpm_region region;
    int particles_per_cell[2];
    struct mpm_vector_expression velocity; /* initial (never NULL components), or a rigid body's */
    char *start[MPM_SCALAR_COUNT];         /* initial value; NULL: that of the scalar */
    int line;
};

struct mpm_boundary_spec {
    struct mpm_region region; /* line or rectangle or all */
    struct mpm_vector_expression velocity;
    bool symmetry; /* instead of a velocity: a plane that reflects; its normal is axis `normal` */
    int normal;
    int line;
};

/* The edges of a particle's domain, counter clockwise from the lower one: N&G Fig. 4, edges 1 to 4.
 * They keep their names as the domain turns. */
enum mpm_edge { MPM_EDGE_BOTTOM, MPM_EDGE_RIGHT, MPM_EDGE_TOP, MPM_EDGE_LEFT, MPM_EDGE_ALL };
enum { MPM_EDGE_COUNT = MPM_EDGE_ALL };

enum mpm_frame {
    MPM_FRAME_GLOBAL, /* components along the axes */
    MPM_FRAME_EDGE,   /* along the outward normal of the deformed edge and, counter clockwise, it */
};

/* A load on the edges of particles on one face of a body, or what flows in there. */
struct mpm_edge_load_spec {
    char key[48];      /* "loads.tractions.0", for messages */
    bool on_particles; /* loads.particle_forces */
    enum mpm_flux_kind flux;
    enum mpm_scalar scalar; /* of a flux */
    double coefficient;     /* h, or e sigma */
    size_t body;
    enum mpm_edge edge;
    enum mpm_frame frame;
    struct mpm_vector_expression value; /* force per area; a NULL component is 0. Of a flux the
                                           first one is its value, or v_env */
    int line;
};

/* How the surfaces of a crack that meet behave. */
enum mpm_crack_contact {
    MPM_CONTACT_FRICTIONLESS,
    MPM_CONTACT_FRICTION,
    MPM_CONTACT_STICK,
    MPM_CONTACT_NONE,
};

/* By what it is told whether the surfaces of a crack meet at a node; see
 * method/cracks/crack_detection.h.
 */
enum mpm_crack_detection {
    MPM_DETECT_VOLUME,       /* areas there, over those with the crack closed */
    MPM_DETECT_DISPLACEMENT, /* the surfaces' distance, in cells */
    MPM_DETECT_CELL,         /* areas there, over a cell's: CRAMP */
};

/* What a particle gives to nodes that a crack hides from it. */
enum mpm_crack_method {
    MPM_CRACKS_FIELDS,     /* a velocity field of its own: CRAMP */
    MPM_CRACKS_VISIBILITY, /* nothing */
};

struct mpm_crack_spec {
    double (*points)[2]; /* the chain, as given */
    size_t point_count;
    enum mpm_crack_contact contact;
    enum mpm_crack_detection detection;
    double friction; /* coefficient, 0 unless MPM_CONTACT_FRICTION */
    double separated,
        touching;   /* relative volumes: apart below, in contact above; CRAMP's V_sep, V_contact */
    double spacing; /* points are set so that no segment is longer than this many of the shorter
                     * cell side */
    bool opening;   /* are its surfaces followed? With a law they always are */
    struct mpm_cohesive cohesive; /* traction between its surfaces; law NULL: none */
    struct mpm_surface_spec surfaces[MPM_SCALAR_COUNT];
    int line;
};

/* The J integral around an axisymmetric crack tip; see method/cracks/j_integral.h. */
enum mpm_j_form {
    MPM_J_BERGKVIST_HUONG, /* weighted with the radius */
    MPM_J_BROBERG,         /* not weighted */
    MPM_J_CONTOUR,         /* not weighted, and without the area term: depends on its contour */
};

/* Where a crack grows. */
enum mpm_growth_direction {
    MPM_GROWS_STRAIGHT,
    MPM_GROWS_HOOP, /* across the largest hoop stress, from K_I and K_II */
};

/* A tip that grows when J_1 reaches the toughness. */
struct mpm_growth_spec {
    double toughness; /* energy per area; 0: it does not grow */
    double increment; /* fraction of the shorter cell side */
    double longest;   /* length that it may grow by in all */
    enum mpm_growth_direction direction;
    int64_t every; /* steps: J is looked at in one of so many */
};

/* A J integral: a rectangle of grid lines around a tip. */
struct mpm_j_integral_spec {
    char key[64]; /* "cracks.0.j_integral.1", for messages */
    size_t crack;
    bool at_start;   /* at the chain's first point, not at its last */
    int64_t contour; /* cells from the node nearest to the tip to each side */
    bool dynamic;    /* with kinetic energy and accelerations */
    enum mpm_j_form form;
    struct mpm_growth_spec growth;
    int line;
};

/* A value that nodes are held at. */
struct mpm_scalar_condition_spec {
    struct mpm_region region; /* line or rectangle or all */
    char *value;              /* in coordinates and t */
    int line;
};

/* A scalar of the scene, transport.<name>; see method/transport/transport.h. */
struct mpm_scalar_spec {
    bool asked;
    enum mpm_scalar_transfer transfer;
    int order;    /* of XPIC and FMPM, 2 or more: with order 1 they are PIC; else 1 */
    char *start;  /* in the coordinates */
    char *source; /* content per volume and time, in coordinates and t; NULL: none */
    bool heats;   /* of the temperature: deformation changes it */
    struct mpm_scalar_condition_spec *conditions;
    size_t condition_count;
    int line;
};

/* Where a body force that varies in space is taken. */
enum mpm_body_force_place {
    MPM_BODY_FORCE_AT_PARTICLES, /* Notes (20) */
    MPM_BODY_FORCE_AT_NODES,     /* Notes (22) */
};

/* Where the rates alpha_g act; see method/loads/damping.h. */
enum mpm_grid_damping {
    MPM_GRID_DAMPING_NODES,         /* in the momentum update, Notes (105) */
    MPM_GRID_DAMPING_PARTICLES,     /* in the update of the particles, (46)-(57), (106) */
    MPM_GRID_DAMPING_PARTICLE_RATE, /* the same with the rate at the particle, (107) */
};

/* Rates are expressions in the coordinates and t, NULL where there is none. */
struct mpm_damping_spec {
    char *grid, *particle; /* alpha_g, alpha_p, 1/time */
    enum mpm_grid_damping grid_form;
    char *pic; /* beta(t), 0 to 1 */
    bool thermostat;
    double gain;   /* 1/time^2 */
    double target; /* kinetic energy to be reached */
    double scale;  /* kinetic energy, or 0: the largest so far */
};

/* When a run counts as being at rest. */
struct mpm_rest_spec {
    bool asked;
    double residual;       /* unbalanced force over internal forces */
    double kinetic_energy; /* over the largest mechanical energy so far */
    double after;          /* time */
    int64_t steps;         /* in a row */
    int64_t patience;      /* steps without a lower residual that end the run; 0: any number */
};

/* Places on a line, at equal distances: one for a point. */
struct mpm_probe_spec {
    char name[MPM_NAME_SIZE];
    double from[2], to[2];
    int64_t points;
};

struct mpm_scene {
    char *path; /* as given, for messages */
    char *title;
    enum mpm_geometry geometry;
    char units_length[MPM_NAME_SIZE], units_mass[MPM_NAME_SIZE], units_time[MPM_NAME_SIZE],
        units_temperature[MPM_NAME_SIZE];
    double thickness; /* planar; 1 in axisymmetry */

    double origin[2], cell[2]; /* refine already applied */
    int64_t cells[2];

    double end;     /* time */
    double courant; /* used when step == 0 */
    double step;    /* fixed step, or 0 */
    int64_t steps;  /* stop after so many, or 0 */
    bool allow_unstable;
    struct mpm_rest_spec rest;

    enum mpm_shape shape;
    enum mpm_axis axis;
    enum mpm_axis_nodes axis_nodes; /* other than zero only with MPM_PLANAR */
    enum mpm_stress_update stress_update;
    enum mpm_position_update position_update;
    enum mpm_radius_update radius_update;
    enum mpm_form form;
    enum mpm_transfer_kind transfer;
    double flip_fraction;  /* 1 is pure FLIP; 0 for the other transfers: all of it from the grid */
    int transfer_order;    /* 1 or more; 1 where the kind has none */
    int deformation_terms; /* of the series for dF, 1 or more */

    struct mpm_material_spec *materials;
    size_t material_count;
    struct mpm_body_spec *bodies;
    size_t body_count;
    struct mpm_boundary_spec *boundaries;
    size_t boundary_count;
    struct mpm_vector_expression body_force; /* NULL components: none */
    enum mpm_body_force_place body_force_at;
    struct mpm_edge_load_spec *edge_loads; /* tractions, then particle forces */
    size_t edge_load_count;
    struct mpm_damping_spec damping;
    enum mpm_crack_method crack_method;
    struct mpm_crack_spec *cracks;
    size_t crack_count;
    struct mpm_contact_spec contact;
    struct mpm_scalar_spec scalars[MPM_SCALAR_COUNT];
    int64_t transport_substeps,
        transport_every; /* method/transport/transport_steps.h; 1: one each */
    bool at_rest;        /* materials have no stress, nothing moves: transport alone */
    struct mpm_j_integral_spec *j_integrals; /* of all cracks, crack by crack */
    size_t j_integral_count;

    double history_interval, snapshot_interval; /* 0: only first and last */
    double checkpoint_interval;                 /* 0: none */
    double checkpoint_seconds;                  /* of the run's own time; 0: none */
    bool energy_balance;                        /* transfer_loss in the history */
    bool derived;                               /* output.derived */
    struct mpm_probe_spec *probes; /* those of output.probes, then those of output.lines */
    size_t probe_count;
    double fringe; /* k_f of CRAMP (23), 1/stress; 0: no fringes asked for */
    int line_grid, line_time, line_body_force, line_damping; /* in the file, for messages */
    unsigned char sha256[32];                                /* of the file's bytes */
    char **settings;                                         /* --set texts, for provenance */
    size_t setting_count;
};

/* Does a material expand with a scalar? Depends the stress of one on the temperature itself? */
bool mpm_scene_expands(const struct mpm_scene *scene);
bool mpm_scene_reads_temperature(const struct mpm_scene *scene);
/* Does a conducted temperature soften one of its materials? */
bool mpm_scene_softens(const struct mpm_scene *scene);
/* Does a property of conduction depend on the temperature? */
bool mpm_scene_has_tables(const struct mpm_scene *scene);

/* The names of the coordinates: x and y, or r and z. */
const char *const *mpm_scene_coordinates(const struct mpm_scene *scene);

/* MPM_BAD_INPUT "path:line: key: message". line 0 leaves the line out. */
enum mpm_status mpm_scene_error(struct mpm_error *error, const struct mpm_scene *scene, int line,
                                const char *key, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

#endif

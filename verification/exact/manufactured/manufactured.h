/* Manufactured solutions: a displacement chosen beforehand, and the body force that makes it the
 * exact motion of a hyperelastic body.
 *
 * A field (one file, field_<name>.c) is its displacement u(X, t), written once on jets (jet.h).
 * All else follows by automatic differentiation:
 *
 *     F = I + Grad u,   F_tt = 1 + u_r / R in axisymmetry,
 *     v = du/dt,   a = d2u/dt2,   P = dW/dF,
 *     b = a - Div P / rho0,      Div P_r = dP_rr/dR + dP_rz/dZ + (P_rr - P_tt) / R,
 *                                Div P_z = dP_zr/dR + dP_zz/dZ + P_zr / R  in axisymmetry.
 *
 * In plane stress F_zz is the one with P_zz = 0, and the sheet's thickness in the initial state is
 * uniform. At R = 0 the quotients are their limits, so that fields are exact there.
 *
 * Laws are the solver's, written here again from their energies: neo_hookean, N&G (64), and
 * linear_elastic, W = G |U - I|^2 + lambda/2 tr(U - I)^2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_MANUFACTURED_H
#define VERIFICATION_EXACT_MANUFACTURED_H

#include <mpm.h>

enum { MANUFACTURED_PARAMETERS = 8, MANUFACTURED_CONSTANTS = 8 };

/* Components: xx xy yx yy zz, or rr rz zr zz tt; of symmetric tensors xx yy zz xy, or rr zz tt rz:
 * those of the solver's fields. */
struct manufactured_state {
    double displacement[2];
    double velocity[2];
    double acceleration[2];
    double deformation[5];
    double nominal[5];    /* P, first Piola-Kirchhoff */
    double stress[4];     /* Cauchy */
    double divergence[2]; /* Div P */
    double hoop[2];       /* its part with 1 / R: (P_rr - P_tt) / R and P_zr / R; 0 in planar */
    double linear[2];     /* Div P by Hooke's law of small strain: what is left is nonlinear */
    double body_force[2]; /* per unit mass */
};

struct manufactured_parameter {
    const char *name;
    double value; /* until the caller sets another */
    double low, high;
    const char *description; /* with the unit */
};

enum manufactured_region {
    MANUFACTURED_RECTANGLE, /* low to high */
    MANUFACTURED_ANNULUS,   /* about the origin: inner to outer radius; planar only */
};

struct manufactured_domain {
    enum manufactured_region region;
    double low[2], high[2]; /* annulus: a quarter of it lies within */
    double inner, outer;
};

/* Edges of a rectangle; of an annulus the first two are inner and outer face. */
enum manufactured_edge {
    MANUFACTURED_LEFT,
    MANUFACTURED_INNER = MANUFACTURED_LEFT,
    MANUFACTURED_RIGHT,
    MANUFACTURED_OUTER = MANUFACTURED_RIGHT,
    MANUFACTURED_BOTTOM,
    MANUFACTURED_TOP,
    MANUFACTURED_EDGES,
};

/* What holds at an edge with the initial normal N and tangent T, at all times. */
enum {
    MANUFACTURED_HELD_NORMAL = 1,  /* u . N = 0 */
    MANUFACTURED_HELD_TANGENT = 2, /* u . T = 0 */
    MANUFACTURED_FREE_NORMAL = 4,  /* N . P N = 0 */
    MANUFACTURED_FREE_TANGENT = 8, /* T . P N = 0 */
    MANUFACTURED_SLIDES = MANUFACTURED_HELD_NORMAL | MANUFACTURED_FREE_TANGENT,
    MANUFACTURED_HELD = MANUFACTURED_HELD_NORMAL | MANUFACTURED_HELD_TANGENT,
    MANUFACTURED_FREE = MANUFACTURED_FREE_NORMAL | MANUFACTURED_FREE_TANGENT,
};

struct manufactured_field;
struct manufactured_kernels;

/* A field with its parameters, material and geometry. */
struct manufactured_problem {
    const struct manufactured_field *field;
    const struct manufactured_kernels *kernels; /* the instructions that evaluate it */
    enum mpm_geometry geometry;
    enum manufactured_law { MANUFACTURED_NEO_HOOKEAN, MANUFACTURED_LINEAR_ELASTIC } law;
    double density, bulk, shear, lame; /* lame = K - 2 G / 3 */
    double parameter[MANUFACTURED_PARAMETERS];
    double constant[MANUFACTURED_CONSTANTS]; /* what the field makes of them */
    struct manufactured_domain domain;
    unsigned edge[MANUFACTURED_EDGES]; /* flags of the above */
    double period;                     /* of the motion; u = 0 at t = 0 */
    double end; /* a sensible end: no turning point, no passage through zero */
};

/* sqrt(E / rho0), of a bar */
double manufactured_bar_speed(const struct manufactured_problem *problem);

/* ------------------------------------------------------------------- fields */

const char *manufactured_name(const struct manufactured_field *field);
/* The fields one by one; NULL past the last. */
const struct manufactured_field *manufactured_at(size_t index);
/* The parameters of a field one by one; NULL past the last. */
const struct manufactured_parameter *
manufactured_parameter_at(const struct manufactured_field *field, size_t index);

/* What goes with a field: its own values of the parameters, and the material `law` (a name of the
 * solver's), density, bulk and shear modulus. MPM_BAD_INPUT: a name or a value that is not allowed;
 * axisymmetry of a field on an annulus. */
struct manufactured_setup {
    const char *field, *law;
    enum mpm_geometry geometry;
    double density, bulk, shear;
};
enum mpm_status manufactured_open(const struct manufactured_setup *setup,
                                  struct manufactured_problem *problem, struct mpm_error *error);

/* Sets a parameter, and anew what depends on it. MPM_BAD_INPUT: none of that name; a value out of
 * its range. */
enum mpm_status manufactured_set(struct manufactured_problem *problem, const char *name,
                                 double value, struct mpm_error *error);

/* --------------------------------------------------------------- evaluation */

/* All of it at the particle that started at `place`, at any time, before 0 as well: staggered
 * quantities of a start need that. Cost: 0.2 us. */
void manufactured_evaluate(const struct manufactured_problem *problem, const double place[2],
                           double time, struct manufactured_state *state);

/* The body force as the solver's callback (mpm_body_force.evaluate): pass a manufactured_load as
 * context. Cost: about 35 ns a particle with the instructions of x86-64-v3, 60 ns without;
 * plane stress three times as much. */
struct manufactured_load {
    const struct manufactured_problem *problem;
    const double *places; /* 2 for each id: where the particles start */
};
void manufactured_load_evaluate(void *load, double time, size_t count, const uint32_t id[],
                                double *const force[2]);

/* Gives the simulation, still at its start, the field's velocities and deformation gradients, each
 * `lags` (mpm_scene_lags; zeros: all at t = 0) times `step` before t = 0. `places` as above.
 * MPM_ENVIRONMENT_FAILED: memory; or the status of mpm_simulation_set_start. */
enum mpm_status manufactured_start(const struct manufactured_problem *problem, const double *places,
                                   const struct mpm_lags *lags, double step,
                                   struct mpm_simulation *simulation, struct mpm_error *error);

/* -------------------------------------------------------------- its activity */

/* What takes part at a time, over a regular sample of the domain: root mean squares over the
 * points. Shares are of the root of the sum of squares of acceleration and Div P / rho0. */
struct manufactured_activity {
    double acceleration[2]; /* share, by component of the motion */
    double divergence[2];
    double hoop[2];         /* of the terms with 1 / R; 0 in planar geometries */
    double nonlinear;       /* of Div P that Hooke's law does not give; any amount is allowed */
    double velocity[2];     /* over its largest in a period: 0 at a turning point */
    double displacement[2]; /* the same: 0 on the way through the undeformed state */
    double nodes[2];        /* displacement at the nodes over that at all points */
};

/* Refuses (MPM_BAD_INPUT, with the reason) a field that turns the body inside out (J <= 0), that is
 * not regular at r = 0 or does not begin with u = 0; a time at which less than 2 % of a term is
 * left that the equation of a component with any motion has, a turning point, a passage through
 * zero (5 % of the largest); cells whose nodes see nothing of the field (10 %). `cell` is the size
 * of cells of a grid with a node at the domain's low corner, or for annuli at the origin; at most
 * 10^6 nodes are tested. Cost: 10 ms, and 0.2 us a node. */
enum mpm_status manufactured_activity(const struct manufactured_problem *problem, double time,
                                      const double cell[2], struct manufactured_activity *activity,
                                      struct mpm_error *error);

/* The weak form at a time, without derivatives of P: for test functions w,
 *     int (P : Grad w + rho0 (a - b) . w) dV0 - int (P N) . w dA0,
 * with the hoop stress P_tt w_r / R in axisymmetry, by Gauss quadrature. Returns the largest
 * residual of all w over the largest of the three integrals' sizes, to be round-off; NaN when out
 * of memory. Cost: 20 ms. */
double manufactured_weak_residual(const struct manufactured_problem *problem, double time);

/* What is left at a time of the field's conditions on its edges: the largest of displacements that
 * are held over the largest displacement, and of tractions P N that are zero over the largest |P|,
 * of both on a sample of the domain and its edges. */
struct manufactured_edges_left {
    double displacement, traction;
};
void manufactured_edges(const struct manufactured_problem *problem, double time,
                        struct manufactured_edges_left *left);

#endif

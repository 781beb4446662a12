/* Touchstone: the public interface of the solver.
 *
 * A scene (one YAML file) becomes a simulation; the simulation advances step by
 * step; its particles and its ledger can be read between steps or written to
 * files by mpm_scene_run. Every function that can fail returns a status and
 * fills a caller-owned error; nothing here prints, exits or aborts.
 *
 * Shapes and units: the scene's own unit system throughout. Axes are x, y in
 * planar scenes and r, z in axisymmetric ones. Planar sums are for the scene's
 * thickness, axisymmetric ones per radian.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_H
#define MPM_H

#include "mpm_api.h"
#include "mpm_contact.h"
#include "mpm_dimension.h"
#include "mpm_draft.h"
#include "mpm_error.h"
#include "mpm_fields.h"
#include "mpm_fracture.h"
#include "mpm_monitor.h"
#include "mpm_observe.h"
#include "mpm_shape.h"
#include "mpm_transport.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

MPM_API_BEGIN

/* ------------------------------------------------------------------- scene */

struct mpm_scene; /* read-only once read; any number of simulations can use it */

/* Reads and validates a scene file; "-" is standard input. `settings` are `PATH=VALUE` texts
 * applied in order before validation (the last wins); `PATH=` unsets. MPM_BAD_INPUT names file,
 * line, key, value and what is allowed; MPM_ENVIRONMENT_FAILED: no memory; *scene is NULL then. */
enum mpm_status mpm_scene_read(const char *path, const char *const *settings, size_t setting_count,
                               struct mpm_scene **scene, struct mpm_error *error);
/* The same of a text in memory. `name` is what messages and records call it by, as a file's path.
 */
enum mpm_status mpm_scene_parse(const char *name, const char *text, size_t length,
                                const char *const *settings, size_t setting_count,
                                struct mpm_scene **scene, struct mpm_error *error);
void mpm_scene_free(struct mpm_scene *scene);

/* Bodies in the scene's order, the name of one of them, and time.end. */
size_t mpm_scene_body_count(const struct mpm_scene *scene);
const char *mpm_scene_body_name(const struct mpm_scene *scene, size_t body);
double mpm_scene_end_time(const struct mpm_scene *scene);

/* By how many time steps the particles' values are behind the time of the simulation, after any
 * step and at the start: velocity and F of a scheme are those of time - lag * step, at a fixed
 * step. Velocities are those of the middle of the last step. F is that of the step's force when the
 * stress is updated last (usl, musl: 0), a step earlier when it is updated first (usf: 1), and
 * between (usavg: 1/2). Positions moved by the mean of old and new velocity (midpoint) lag half a
 * step. Without these lags in its start, a run has one more error of first order in time. */
struct mpm_lags {
    double position, velocity, deformation;
};
/* Those of a scene. */
struct mpm_lags mpm_scene_lags(const struct mpm_scene *scene);
/* Two sets of kernels take a step. The reference kernels go particle by particle, to be read beside
 * the papers; the fast ones take several at once. Both agree to round-off. */
enum mpm_kernels {
    MPM_KERNELS_AUTO, /* fast wherever the scene allows */
    MPM_KERNELS_REFERENCE,
    MPM_KERNELS_FAST, /* MPM_BAD_INPUT, with the reason, where a scene has none */
    MPM_KERNELS_COUNT,
};
const char *mpm_kernels_name(enum mpm_kernels kernels); /* "auto", "reference", "fast" */

/* The instructions that fast kernels are built for; results are the same bits. */
enum mpm_simd {
    MPM_SIMD_AUTO,      /* the widest that build and machine have */
    MPM_SIMD_BASELINE,  /* what every processor of the kind has */
    MPM_SIMD_X86_64_V3, /* AVX2; MPM_BAD_INPUT where build or machine lacks it */
    MPM_SIMD_COUNT,
};
const char *mpm_simd_name(enum mpm_simd simd); /* "auto", "baseline", "x86-64-v3" */

/* Finds the entry of that name. MPM_BAD_INPUT: there is none; the message lists those allowed. */
enum mpm_status mpm_kernels_find(const char *name, enum mpm_kernels *kernels,
                                 struct mpm_error *error);
enum mpm_status mpm_simd_find(const char *name, enum mpm_simd *simd, struct mpm_error *error);

struct mpm_simulation_options {
    int threads; /* at most so many, >= 1; results do not depend on it */
    enum mpm_kernels kernels;
    enum mpm_simd simd;
    const struct mpm_monitor *monitor; /* must outlive the simulation; NULL: none */
};

enum { MPM_REASON_SIZE = 128 };

/* What a scene will cost: printed by `mpm check`. */
struct mpm_plan {
    size_t particles;
    size_t cells;          /* without ghost rows */
    size_t nodes;          /* with ghost rows */
    size_t bytes;          /* of the simulation, in all */
    double time_step;      /* the first one */
    double expected_steps; /* time.end over the first time step, or time.steps if fewer */
    const char *kernels;   /* name of the kernel set chosen: "fast" or "reference" */
    const char *kernels_reason;
    const char *simd;                        /* the instructions that it uses */
    double courant;                          /* of the first step */
    char stability_advice[MPM_MESSAGE_SIZE]; /* see mpm_simulation_advice */
    int threads;                             /* that a run uses, of those that the options allow */
    char threads_reason[MPM_REASON_SIZE];
    size_t checkpoint_bytes; /* of one; a run keeps two */
};

/* Largest Courant numbers at which motions of a scene's method stayed bounded in case G1 of the
 * suite: 2 by 2 particles in a cell, 200 crossings of a cell by a wave. 0: none from 0.1 on did. */
struct mpm_stability {
    double small;  /* least of three problems with velocities of 0.001 of the wave speed */
    double large;  /* the same with 0.3 of it, where strains reach 0.3 and particles cross cells */
    bool measured; /* with all choices of the scene; else the least of what has them one by one */
};
/* Those of a scene's method. */
struct mpm_stability mpm_scene_stability(const struct mpm_scene *scene);

/* Validates all that needs geometry (bodies, boundaries, memory) and estimates the
 * cost. Needs the memory of a simulation for a moment. */
enum mpm_status mpm_scene_plan(const struct mpm_scene *scene,
                               const struct mpm_simulation_options *options, struct mpm_plan *plan,
                               struct mpm_error *error);

/* -------------------------------------------------------------- simulation */

struct mpm_simulation;

/* Takes all memory, fills the bodies, sets t = 0. The scene must outlive the
 * simulation, the options need not. */
enum mpm_status mpm_simulation_create(const struct mpm_scene *scene,
                                      const struct mpm_simulation_options *options,
                                      struct mpm_simulation **simulation, struct mpm_error *error);
void mpm_simulation_free(struct mpm_simulation *simulation);

/* Takes one step, of the Courant number times the time in which the fastest of waves and
 * particles goes through a cell, in the state at hand; or the scene's fixed step. Shortened if
 * need be to land on `time_limit` exactly.
 * MPM_RUN_FAILED: the run cannot go on; the message names cause, step, time, particle and
 * value, time, fields and ledger are those of the last good step, and every further
 * call fails alike. The total energy is judged once in 32 steps (mpm_simulation_judge): a step that
 * is good by all else may be taken back then, with those after it. Cost: one step; once in 32 steps
 * a sort, a copy of the state and the sum of the energy. */
enum mpm_status mpm_simulation_advance(struct mpm_simulation *simulation, double time_limit,
                                       struct mpm_error *error);

/* Judges the energy after the last step: call it before results of that step are used. With E the
 * ledger's total energy, W its external work, E_0 the energy at t = 0 and K_c the kinetic energy of
 * the changes that velocity conditions make in a step,
 *     factor = 1 + (E - W - E_0) / (E_0 + max(largest |W|, 8 largest K_c so far) + 1e-12 m c^2)
 * is 1 in an exact run; m is the mass of all particles, c their wave speed at t = 0; energy.c
 * derives the 8. MPM_RUN_FAILED: it is above 10, or E is not finite; the last good step is
 * then the one before that, of those not judged yet, where this was so first. Cost: up to two
 * passes over the particles; nothing if the step has been judged. */
enum mpm_status mpm_simulation_judge(struct mpm_simulation *simulation, struct mpm_error *error);

/* What of that has been seen so far: has the factor been above 1.5, in a run that went on? */
struct mpm_energy_growth {
    bool seen;
    uint64_t step; /* the first one at which it was seen */
    double time;
    double factor;  /* when judged last, up to 1.5 a bound from above; 0 before */
    double largest; /* of these so far */
};
/* The answer; `growth` may be NULL. */
bool mpm_simulation_energy_growth(const struct mpm_simulation *simulation,
                                  struct mpm_energy_growth *growth);

/* A body force per unit mass that the caller computes, in addition to the scene's. */
enum { MPM_BODY_FORCE_BLOCK = 256 };
struct mpm_body_force {
    /* Sets force[axis][k], length / time^2, for the particles id[k] with k < count, count at most
     * MPM_BODY_FORCE_BLOCK, at the start of a step, `time`. Ids are in creation order and stay with
     * their particles; rigid ones are never passed. Several threads call it at a time, for
     * different particles, and a failed run calls it for times gone by: the force must be a
     * function of id and time alone. Another simulation that it advances gets one thread. */
    void (*evaluate)(void *context, double time, size_t count, const uint32_t id[],
                     double *const force[2]);
    void *context; /* must outlive the simulation */
};

/* Adds f_i += sum m_p S_ip b_p, N&G (4), to each step, whatever the kernels. Its work is in the
 * ledger's external_work. May be set again; NULL takes it away. A value that is not finite fails
 * the run. MPM_BAD_INPUT: after the first step; no function `evaluate`. MPM_ENVIRONMENT_FAILED: no
 * memory. Cost: one more pass of the particles to the grid; 2 numbers a particle, 4 a node. */
enum mpm_status mpm_simulation_set_body_force(struct mpm_simulation *simulation,
                                              const struct mpm_body_force *force,
                                              struct mpm_error *error);

/* Gives all particles, by id, velocities (2 each) and deformation gradients (5 each, of particles
 * in the places where they are) to start with, in the order of mpm_field; NULL keeps those at
 * hand, values of rigid particles are passed over. Stress, domains and the ledger's energy follow
 * from F; in plane stress F_zz is made the one without stress, found from the caller's. With orders
 * that stagger velocity or stress against time, the caller gives each at its own time.
 * MPM_BAD_INPUT, and nothing is changed: after the first step; a value that is not finite; F with
 * F_xx F_yy - F_xy F_yx or F_zz not above 0; F_zz of plane strain other than 1; F other than 1 for
 * a law without energy. MPM_BAD_INPUT, and the simulation can take no step: a fixed time step
 * beyond the stability limit of this start; a domain (CPDI) that F carries beyond the grid's ghost
 * rows. */
enum mpm_status mpm_simulation_set_start(struct mpm_simulation *simulation, const double *velocity,
                                         const double *deformation_gradient,
                                         struct mpm_error *error);

/* One line for a user whose first step has a larger Courant number than mpm_scene_stability knows
 * to be bounded, or whose interface is stiffer than an explicit step follows; else "". */
const char *mpm_simulation_advice(const struct mpm_simulation *simulation);

/* Time and number of the last step, its length, the number of particles, rigid ones included, and
 * the bytes of all memory held. */
double mpm_simulation_time(const struct mpm_simulation *simulation);
uint64_t mpm_simulation_step(const struct mpm_simulation *simulation);
double mpm_simulation_time_step(const struct mpm_simulation *simulation);
size_t mpm_simulation_particle_count(const struct mpm_simulation *simulation);
size_t mpm_simulation_bytes(const struct mpm_simulation *simulation);

/* The massless points that carry the cracks, as they are now: crack by crack in the scene's order,
 * each from its first point to its last, with those set between the scene's own. */
struct mpm_crack_point {
    size_t crack;
    double position[2];
};

/* How many there are, and one of them. */
size_t mpm_simulation_crack_point_count(const struct mpm_simulation *simulation);
struct mpm_crack_point mpm_simulation_crack_point(const struct mpm_simulation *simulation,
                                                  size_t point);

/* Sums over all deformable particles at the end of the last step. */
struct mpm_ledger {
    double time;
    uint64_t step;
    double mass;
    double momentum[2];
    /* About the origin; 0 in axisymmetry. With transfer apic the sum over particles of
     * m_p (x_p cross v_p + B_yx - B_xy), the affine part's own included: what the next step
     * hands to the grid. */
    double angular_momentum;
    double kinetic_energy; /* sum of m_p v_p^2 / 2; an affine part has none in it */
    double strain_energy;
    double external_work;       /* by loads, boundaries and rigid bodies since t = 0 */
    double damping_dissipation; /* taken out by damping since t = 0; 0 without */
    /* Of cohesive cracks since t = 0; 0 without: what their tractions give back as the openings go
     * to zero, and what they do not. */
    double cohesive_stored, cohesive_dissipated;
    /* Of contact between bodies since t = 0; 0 without: what interfaces have stored, and what
     * contact has dissipated. */
    double contact_stored, contact_dissipated;
    /* Of coupling with scalars since t = 0; 0 without. Mechanical energy that free expansion and
     * gases have given; heat that deformation has; and alpha T tr(tau) of all particles, which is
     * energy beside the thermal one: total_energy + expansion_work + thermal_energy +
     * thermoelastic_energy change by external work and inflow of heat alone, but for errors of the
     * time step. */
    double expansion_work, deformation_heat, thermoelastic_energy;
    double plastic_dissipation, plastic_heat; /* plastic work since t = 0, but for this heat */
    /* By artificial viscosity since t = 0; 0 without. With an equation of state it is part of the
     * internal energy, and strain_energy is the rest. */
    double viscous_dissipation;
    /* kinetic + strain + dissipation + cohesive + contact energies - expansion_work */
    double total_energy;
    /* With output.energy_balance, else 0: what went from particles to nodes and back without
     * arriving, and what contact of cracks took, since t = 0. The change of total_energy plus both
     * plus plastic_heat is external_work, to round-off; either may be negative. */
    double transfer_loss, contact_loss;
    double j_min, j_max; /* extremes of det F */
    /* With plastic strain and without cracks, else 0: pairs of particles that were neighbours in
     * the undeformed body and that have no node in common: numerical fracture. */
    uint64_t parted_pairs;
    uint64_t melted_particles; /* at their melting temperature or above: without strength */
};

/* Cost: one pass over the particles; strain energy needs a logarithm each. */
void mpm_simulation_ledger(const struct mpm_simulation *simulation, struct mpm_ledger *ledger);

/* Does the scene damp: does its history have the column damping_dissipation? */
bool mpm_scene_is_damped(const struct mpm_scene *scene);

/* Has one of its materials plastic strain: has its history the column plastic_dissipation? */
bool mpm_scene_is_plastic(const struct mpm_scene *scene);

/* Has its history the columns parted_pairs, melted_particles: plastic strain, a melting point? */
bool mpm_scene_counts_parted(const struct mpm_scene *scene);
bool mpm_scene_melts(const struct mpm_scene *scene);

/* Has one of its materials artificial viscosity: has its history the column viscous_dissipation? */
bool mpm_scene_is_viscous(const struct mpm_scene *scene);

/* Has one of its cracks a cohesive law: has its history the columns of cohesive energies? */
bool mpm_scene_is_cohesive(const struct mpm_scene *scene);

/* Has the scene output.energy_balance, and its history the column transfer_loss? And, with
 * contact of cracks, contact_loss? */
bool mpm_scene_has_energy_balance(const struct mpm_scene *scene);
bool mpm_scene_has_contact_loss(const struct mpm_scene *scene);

/* The history's values of cracks, crack by crack: columns that follow those of the ledger. */
enum { MPM_QUANTITY_NAME_SIZE = 64 };
struct mpm_quantity_info {
    char name[MPM_QUANTITY_NAME_SIZE]; /* "crack_0_opening_first": crack 0 of the scene */
    struct mpm_dimension dimension;
    const char *description;
};
/* How many there are; 0 for scenes without any. */
size_t mpm_scene_crack_quantity_count(const struct mpm_scene *scene);
/* What the one of that index is. */
struct mpm_quantity_info mpm_scene_crack_quantity(const struct mpm_scene *scene, size_t index);
/* Its value now. Cost: one pass over the points of its crack. */
double mpm_simulation_crack_quantity(const struct mpm_simulation *simulation, size_t index);
/* How near to rest a scene with time.rest is after the last step; both 1 before the first. */
struct mpm_rest {
    bool asked;
    /* sum of |f_x| + |f_y| over the free components of nodes, damping left out, over the same of
     * the internal forces of all nodes (or the former, if larger): 0 to 1 */
    double residual;
    /* of the particles, over the largest sum of kinetic and strain energy so far, which is
     * computed in one of 32 steps; 0 if the former is 0. Not over the external work: it goes on at
     * rest, where forces of nodes are out of balance (output.energy_balance) */
    double kinetic_energy;
    /* The lowest residual since time.rest.after, and when it was reached. 1 and 0 before. */
    double lowest_residual, lowest_time;
    double fallen_time; /* the last time when it had fallen by 10 % since the last such time */
};
/* Have both been below the scene's bounds for as many steps in a row, after time.rest.after? False
 * if the scene has no time.rest. `rest` may be NULL. Further steps can be taken after that. */
bool mpm_simulation_at_rest(const struct mpm_simulation *simulation, struct mpm_rest *rest);

/* Has the residual neither fallen by 10 % nor been below its bound for time.rest.patience steps? */
bool mpm_simulation_stagnates(const struct mpm_simulation *simulation);

/* Has the tip ended that the J integral of that index lets grow? Only then *end is its end and the
 * message one line about it. */
bool mpm_simulation_tip_end(const struct mpm_simulation *simulation, size_t index,
                            struct mpm_tip_end *end, char message[MPM_MESSAGE_SIZE]);

/* How many the scene has, crack by crack in its order. */
size_t mpm_scene_j_integral_count(const struct mpm_scene *scene);

/* The one of that index, in the state after the last step. Its J and K are not numbers once its tip
 * has ended, and in scenes with a crack that grows while its contour meets or surrounds another
 * crack, or meets its own more than once. MPM_RUN_FAILED, with the reason: its contour leaves the
 * bodies or the grid, meets another material, or does not meet its own crack; in scenes without
 * growth also those meetings with cracks. Works in scratch memory of the simulation: not for
 * several threads at a time. Cost: one test of each particle, two stencils of those near the
 * contour. */
enum mpm_status mpm_simulation_j_integral(const struct mpm_simulation *simulation, size_t index,
                                          struct mpm_j_integral *value, struct mpm_error *error);

/* Seconds spent in each phase of the step so far. */
enum { MPM_PHASE_MAX = 16 };
struct mpm_phases {
    size_t count;
    const char *name[MPM_PHASE_MAX];
    double seconds[MPM_PHASE_MAX];
};
/* Fills in those of the simulation. */
void mpm_simulation_phases(const struct mpm_simulation *simulation, struct mpm_phases *phases);
const char *mpm_simulation_kernels(const struct mpm_simulation *simulation); /* "fast", ... */
/* Particles of the last step with additional velocity fields in their stencils: those with nodes on
 * both sides of a crack. */
size_t mpm_simulation_field_particles(const struct mpm_simulation *simulation);
const char *mpm_simulation_simd(const struct mpm_simulation *simulation); /* "x86-64-v3", ... */
/* Threads that steps use: as many as the options allow and there is work for at the start. */
int mpm_simulation_threads(const struct mpm_simulation *simulation);

/* --------------------------------------------------------------------- run */

struct mpm_run_options {
    const char *output; /* folder for the results; NULL writes nothing */
    struct mpm_simulation_options simulation;
    bool overwrite;         /* allow a folder that holds results */
    bool resume;            /* go on from the checkpoint in the folder */
    const char *scene_path; /* for provenance; may be NULL */
    /* Called after each step, if not NULL; `fraction` of the run done, 0..1. */
    void (*progress)(void *context, double fraction, const struct mpm_simulation *simulation);
    /* Called with the same context, if not NULL, for warnings of a run that goes on:
     * advice before the first step, growing energy when it is first seen, tips of cracks that have
     * ended. run.json lists them. */
    void (*warn)(void *context, const char *warning);
    void *progress_context;
    /* Called before each step, if not NULL: other than 0, the number of a signal, the run is to end
     * now. */
    int (*interrupted)(void);
    /* Functions that get the particles' fields at steps or times. Steps land on their times as they
     * do on snapshots; the energy is judged before each call. */
    const struct mpm_observer *observers;
    size_t observer_count;
};

/* Runs a scene to its end and writes run.json, history.csv and snapshots. A scene that requires
 * rest ends there; one that is not at rest when its time or its steps are over has failed
 * (MPM_RUN_FAILED: an answer that has not converged must not pass for one). The energy is judged
 * before each row, each snapshot and the end. Refuses (MPM_BAD_INPUT) an output that is a file or
 * holds results. On MPM_RUN_FAILED the last good state has been written and run.json has the
 * reason.
 *
 * With output.checkpoint or output.checkpoint_seconds the run leaves checkpoints, from which a run
 * with `resume` goes on: its files have the same bytes as those of a run without interruption, but
 * for run.json. MPM_INTERRUPTED: `interrupted` has ended the run; a checkpoint, a row of the
 * history and run.json are written. MPM_BAD_INPUT: another run writes to the folder; with `resume`
 * there is no sound checkpoint of the scene, its settings and its kernels (MPM_KERNELS_AUTO takes
 * those of the checkpoint). Cost of a checkpoint: a copy of the particles' kept fields to the disk.
 */
enum mpm_status mpm_scene_run(const struct mpm_scene *scene, const struct mpm_run_options *options,
                              struct mpm_error *error);

/* -------------------------------------------------------------- provenance */

/* Facts compiled into the binary or read from the machine; never a build date. */
struct mpm_build_info {
    const char *version;
    const char *revision; /* git, with "-dirty" if it was */
    const char *compiler;
    const char *flags;
    const char *libraries; /* name version, comma separated */
    const char *simd;      /* the widest that fast kernels have on this machine */
};
/* Those of this library. */
const struct mpm_build_info *mpm_build_info(void);

MPM_API_END

#endif

/* A running simulation: the state that a step works on, the clock, the ledger, and the
 * last good state.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_SIMULATION_SIMULATION_H
#define MPM_SIMULATION_SIMULATION_H

#include "base/arena.h"
#include "method/cracks/j_integral.h"
#include "method/state.h"
#include "method/step.h"

/* The tip of a crack that a J integral goes around. */
struct mpm_crack_tip {
    struct mpm_j_tip undeformed;
    double grown, dissipated; /* length, energy */
    struct mpm_tip_end end;   /* of the one integral that lets the tip grow */
};

/* Where chains of points are now and in the undeformed body. */
struct mpm_chain_extents {
    struct mpm_crack_chain now, undeformed;
};

/* Of the points of cracks: x, y, both components of the opening, the largest opening. */
enum { MPM_CRACK_ARRAYS = 5 };

/* The state after the last sort. A step is undone by going back to it and repeating
 * the steps since: they give the same bits, so nothing has to be copied each step. */
struct mpm_backup {
    unsigned char *particles; /* filled by the sort */
    unsigned char *rigid;
    double *crack_points[MPM_CRACK_ARRAYS];
    struct mpm_crack_tip *tips; /* these and the extents of chains: with J integrals */
    struct mpm_chain_extents *extents;
    double time, external_work, largest_work, sudden_energy, wave_speed, diffusivity, film;
    struct mpm_scalar_totals scalars[MPM_SCALAR_COUNT];
    struct mpm_expansion_totals expansion;
    double transport_waited;
    int64_t transport_steps_waited;
    struct mpm_damping_totals damping;
    struct mpm_contact_totals *contact_totals; /* per pair of fields */
    struct mpm_contact_sample *contact_samples;
    struct mpm_energy_balance energy;
    uint64_t step;
    double time_steps[MPM_STEPS_BETWEEN_SORTS]; /* of the steps since, */
    bool flushed[MPM_STEPS_BETWEEN_SORTS];      /* before results, */
    double times[MPM_STEPS_BETWEEN_SORTS];      /* and where they ended */
};

/* See parting.c. */
struct mpm_parting {
    size_t count;         /* of pairs */
    uint32_t (*pairs)[2]; /* ids of neighbours in the undeformed body */
    int32_t (*box)[4];    /* by id, when they are counted: columns and rows of nodes reached */
};

/* The progress of a simulation to rest; all zero if its scene has no time.rest. */
struct mpm_rest_watch {
    int64_t steps_at_rest; /* in a row */
    double largest_energy; /* kinetic and strain energy, so far */
    double lowest_residual, lowest_time;
    double fallen_residual, fallen_time; /* where it last fell by a tenth */
    uint64_t progress_step; /* the last one where it did, or was below the bound; 0: none */
};

struct mpm_simulation {
    const struct mpm_scene *scene;
    struct mpm_arena arena;
    struct mpm_arena user_force; /* of a user force; empty without */
    struct mpm_state state;
    struct mpm_backup backup;
    struct mpm_crack_tip *tips; /* per J integral of the scene; NULL without */
    struct mpm_j_scratch j_scratch;
    uint64_t step;
    double wave_speed; /* fastest in the material now */
    double wave_speed_start;
    double diffusivity;    /* the largest of all particles now; 0 without conduction */
    double film;           /* the largest of all edges: see transport_state.h */
    double particle_speed; /* of the fastest particle if it outruns waves; else perhaps 0 */
    double mass, lightest; /* of all particles, of the lightest one */
    double strain_start;   /* strain energy at t = 0 */
    double energy_start;   /* kinetic and strain energy at t = 0 */
    double largest_work;   /* |external work| since t = 0 at its largest so far */
    struct mpm_energy_growth growth;
    uint64_t judged_step; /* the last one whose energy has been judged */
    struct mpm_rest_watch rest;
    struct mpm_parting parting;
    double seconds[MPM_PHASE_COUNT];
    char advice[MPM_MESSAGE_SIZE];
    struct mpm_error failure;          /* status MPM_OK while the run is sound */
    const struct mpm_monitor *monitor; /* NULL: none, or not made yet */
};

/* Tells the monitor, if there is one. */
void mpm_simulation_look(const struct mpm_simulation *simulation, enum mpm_moment moment);

/* time_step.c: the next step from the Courant number and what is fastest now, waves in the
 * deformed material or particles, or the fixed one; shortened to land on `limit`. *lands:
 * whether it does. */
double mpm_time_step_next(const struct mpm_simulation *simulation, double limit, bool *lands);
/* Speed of the fastest particle of first..end - 1. */
double mpm_particle_speed(const struct mpm_particles *particles, size_t first, size_t end);
/* Sets wave_speed and particle_speed to those after the step just taken; the latter in each step
 * if it was above half the former, else in one of 32. */
void mpm_speeds_update(struct mpm_simulation *simulation);
/* Refuses a first step that is not a number above 0, more of them than can be taken before
 * time.end, and a fixed one beyond the stability limit unless the scene allows it. */
enum mpm_status mpm_time_step_check(const struct mpm_simulation *simulation,
                                    struct mpm_error *error);

/* advance.c: takes or repeats a step of state.time_step, and judges it. MPM_RUN_FAILED, or the
 * step is over but for its time. */
enum mpm_status mpm_simulation_take_step(struct mpm_simulation *simulation,
                                         struct mpm_error *error);
/* The step just taken, or repeated, is over. */
void mpm_simulation_count_step(struct mpm_simulation *simulation);

/* Courant number of the first step; of a scene at rest its part of the conduction's bound. */
double mpm_time_step_courant(const struct mpm_simulation *simulation);
/* stability.c: writes what mpm_simulation_advice returns. */
void mpm_stability_advise(struct mpm_simulation *simulation);

/* Kinetic energy of the deformable particles after the last step. */
double mpm_kinetic_energy(const struct mpm_state *state);

/* health.c: judges the step just taken. MPM_RUN_FAILED names cause, particle and value. */
enum mpm_status mpm_health_check(const struct mpm_simulation *simulation, struct mpm_error *error);
/* Name of the body that the particle with that id belongs to. */
const char *mpm_body_of_particle(const struct mpm_simulation *simulation, uint32_t id);

/* energy.c: judges the total energy after the last step, once. MPM_RUN_FAILED: it is above the
 * limit, or not finite. Cost: one pass over the particles, with a logarithm for each. */
enum mpm_status mpm_energy_judge(struct mpm_simulation *simulation, struct mpm_error *error);
/* Are the parts of it that each step finds above the limit? Cost: one sum over the strips. */
bool mpm_energy_is_in_doubt(const struct mpm_simulation *simulation);

/* A failure before the first step, such as a domain too long for the grid: MPM_BAD_INPUT. */
enum mpm_status mpm_health_refuse_start(const struct mpm_simulation *simulation,
                                        struct mpm_error *error);

/* damping.c: what the scene damps, and its memory; rates that are not allowed at t = 0 are
 * refused with MPM_BAD_INPUT once the particles are placed and the first time step is known. */
enum mpm_status mpm_damping_create(struct mpm_simulation *simulation, struct mpm_error *error);
void mpm_damping_layout(struct mpm_state *state, struct mpm_arena *arena);
enum mpm_status mpm_damping_check_start(const struct mpm_simulation *simulation,
                                        struct mpm_error *error);
void mpm_damping_free(struct mpm_damping *damping);

/* edge_loads.c: parses the loads and counts the edges that bear them, MPM_BAD_INPUT where one
 * finds none; their memory; which edges they are; values at t = 0 must be finite. */
enum mpm_status mpm_edge_loads_create(struct mpm_simulation *simulation, struct mpm_error *error);
void mpm_edge_loads_layout(struct mpm_state *state, struct mpm_arena *arena);
enum mpm_status mpm_edge_loads_fill(struct mpm_simulation *simulation, struct mpm_error *error);
enum mpm_status mpm_edge_loads_check_start(const struct mpm_simulation *simulation,
                                           struct mpm_error *error);

/* time_step.c: of all particles, by their laws. */
double mpm_fastest_wave(const struct mpm_state *state);

/* transport.c: scalars of the scene, with constants of its bodies; their memory; the particles'
 * values at t = 0, nodes with prescribed ones, all of which must be finite. */
enum mpm_status mpm_transport_create(struct mpm_simulation *simulation, struct mpm_error *error);
unsigned mpm_transport_uses(const struct mpm_scene *scene); /* enum mpm_particle_use */
void mpm_transport_layout(struct mpm_state *state, struct mpm_arena *arena);
enum mpm_status mpm_transport_fill(struct mpm_simulation *simulation, struct mpm_error *error);
void mpm_transport_free(struct mpm_simulation *simulation);

/* cracks.c: how many points cracks get; their memory; where they are; how many the undeformed ones
 * get. */
void mpm_cracks_create(struct mpm_state *state);
void mpm_cracks_layout(struct mpm_state *state, struct mpm_arena *arena);
void mpm_cracks_fill(struct mpm_state *state);
size_t mpm_cracks_undeformed_points(const struct mpm_scene *scene);

/* symmetries.c: planes of symmetry, MPM_BAD_INPUT where a body force acts across one; their inner
 * sides and the cracks on them, once particles and cracks are placed: MPM_BAD_INPUT where bodies
 * are on both sides, or a crack meets a plane. */
enum mpm_status mpm_symmetries_create(struct mpm_simulation *simulation, struct mpm_error *error);
enum mpm_status mpm_symmetries_fill(struct mpm_simulation *simulation, struct mpm_error *error);
/* Its coordinate along the axis of its normal. */
double mpm_symmetry_place(const struct mpm_state *state, const struct mpm_symmetry *plane);

/* j_integrals.c: their memory; their tips, once the particles are placed: MPM_BAD_INPUT where a
 * contour is not one. */
void mpm_j_integrals_layout(struct mpm_simulation *simulation, struct mpm_arena *arena);
enum mpm_status mpm_j_integrals_fill(struct mpm_simulation *simulation, struct mpm_error *error);
/* The value of one now; MPM_RUN_FAILED with MPM_CAUSE_J_INTEGRAL where it has none: value->met is
 * the crack that its contour meets or surrounds, its own one more than once, or SIZE_MAX. */
enum mpm_status mpm_j_integral_evaluate(const struct mpm_simulation *simulation, size_t index,
                                        struct mpm_j_value *value, struct mpm_error *error);

/* openings.c: points of which surfaces are tracked: all of the scene's cracks, or none. */
size_t mpm_openings_points(const struct mpm_state *state);
/* Their memory; what does not change. MPM_BAD_INPUT: a plane of symmetry holds the crack; a
 * cohesive crack that passes the edge of a body between two points. */
void mpm_openings_layout(struct mpm_state *state, struct mpm_arena *arena);
enum mpm_status mpm_openings_fill(struct mpm_simulation *simulation, struct mpm_error *error);
/* Contact between bodies: claims layers, before the grid's memory is taken; fills what the layout
 * has taken. */
void mpm_contacts_create(struct mpm_state *state);
void mpm_contacts_fill(struct mpm_state *state);
/* Follows a pair the jump of displacement? Particles carry their place at t = 0 then. */
bool mpm_contacts_have_interfaces(const struct mpm_scene *scene);
/* May bodies come together that then have one value of a scalar where they touch? */
bool mpm_contacts_join(const struct mpm_scene *scene, enum mpm_scalar which);
/* What interfaces have stored, and contact has dissipated. */
void mpm_contact_energies(const struct mpm_state *state, double *stored, double *dissipated);
/* Their sum; nothing where all pairs together have given more than they have taken. */
double mpm_contact_held(const struct mpm_state *state);

/* The point that a crack has grown by, with a segment of which the ends were there in the
 * undeformed body. The point is closed, with a law that has not been opened. The area of the
 * segment is that of the new point alone: half of it with the last point, which has opened already,
 * would be given a work that no traction has done. */
void mpm_openings_grow(struct mpm_state *state, size_t crack, size_t added,
                       const double undeformed[2][2]);
/* MPM_BAD_INPUT: a cohesive law stiffer than the first time step can follow. */
enum mpm_status mpm_openings_check_start(const struct mpm_simulation *simulation,
                                         struct mpm_error *error);

/* crack_growth.c: points that a chain may get at one of its ends; growth after a step, or its end
 * at a crack; MPM_RUN_FAILED where J has no value for another reason, or there is no room; what of
 * it a step changes, saved and put back. */
size_t mpm_crack_room(const struct mpm_scene *scene, size_t crack, bool at_start);
enum mpm_status mpm_cracks_grow(struct mpm_simulation *simulation, struct mpm_error *error);
void mpm_growth_layout(struct mpm_simulation *simulation, struct mpm_arena *arena);
void mpm_growth_save(struct mpm_simulation *simulation);
void mpm_growth_restore(struct mpm_simulation *simulation);

/* create.c: parses a pair of expressions of a scene; a NULL text stays a NULL component. */
enum mpm_status mpm_vector_field_create(const struct mpm_scene *scene,
                                        const struct mpm_vector_expression *text, bool has_time,
                                        int workers, struct mpm_vector_field *field,
                                        struct mpm_error *error);
void mpm_vector_field_free(struct mpm_vector_field *field);
/* create.c: MPM_BAD_INPUT at the scene's line and key if a component is not finite there at t = 0.
 */
enum mpm_status mpm_vector_field_check(const struct mpm_simulation *simulation,
                                       const struct mpm_vector_field *field,
                                       const double position[2], int line, const char *key,
                                       struct mpm_error *error);

/* time_step.c: the mass of the lightest one. */
double mpm_lightest_particle(const struct mpm_particles *particles);

/* create.c: what follows from the particles' start, whose fastest wave the caller knows: speeds and
 * the checks that need them, the energy against which the run is judged, the first sort and
 * backup. */
enum mpm_status mpm_simulation_open(struct mpm_simulation *simulation, double wave_speed,
                                    struct mpm_error *error);

/* threads.c: how many of the threads that are allowed have work, by the particles and the strips
 * that hold them; why, if `reason` is not NULL. For particles that are sorted. */
int mpm_threads_choose(const struct mpm_state *state, int allowed, char reason[MPM_REASON_SIZE]);

/* parting.c: memory for the pairs of so many particles; the pairs, of particles in the undeformed
 * body; how many of them share no node now. Cost: a stencil for each particle. */
void mpm_parting_layout(struct mpm_simulation *simulation, size_t count, struct mpm_arena *arena);
enum mpm_status mpm_parting_fill(struct mpm_simulation *simulation, struct mpm_error *error);
uint64_t mpm_parting_count(const struct mpm_simulation *simulation);

/* rest.c: judges the step just taken. */
void mpm_rest_judge(struct mpm_simulation *simulation);

/* backup.c */
void mpm_backup_layout(struct mpm_simulation *simulation, struct mpm_arena *arena);
/* After the sort, which has copied the particles. */
void mpm_backup_save(struct mpm_simulation *simulation);
/* Goes back to the state after step `step`, which the backup must cover, or to that before the
 * first step that fails: only steps of a checkpoint do, since all others have succeeded before. */
void mpm_backup_restore(struct mpm_simulation *simulation, uint64_t step);
/* Takes the step after that again. MPM_RUN_FAILED as with mpm_simulation_take_step. */
enum mpm_status mpm_backup_repeat(struct mpm_simulation *simulation);
/* For particles and a backup that come from a checkpoint: sorts, and takes the steps up to `step`.
 * MPM_RUN_FAILED: cracks are where they cannot be, with a message, or one of the steps fails. */
enum mpm_status mpm_backup_resume(struct mpm_simulation *simulation, uint64_t step,
                                  struct mpm_error *error);
/* Length of crack_points[array]. */
size_t mpm_backup_crack_points(const struct mpm_simulation *simulation, int array);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/checkpoint.h"

#include "method/transfer/transfer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Numbers of a struct that has doubles alone. */
#define NUMBERS(pointer) (sizeof *(pointer) / sizeof(double))
_Static_assert(sizeof(struct mpm_damping_totals) == 3 * sizeof(double), "doubles alone");
_Static_assert(sizeof(struct mpm_expansion_totals) == 2 * sizeof(double), "doubles alone");
_Static_assert(sizeof(struct mpm_scalar_totals) == 4 * sizeof(double), "doubles alone");
_Static_assert(sizeof(struct mpm_contact_totals) == (2 + MPM_SCALAR_COUNT) * sizeof(double),
               "doubles alone");
_Static_assert(sizeof(struct mpm_j_tip) == 4 * sizeof(double), "doubles alone");

static void visit_double(struct mpm_piece_visitor *visitor, double *value, const char *name)
{
    mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, value, 1, name, -1);
}

static void visit_count(struct mpm_piece_visitor *visitor, uint64_t *value, const char *name)
{
    mpm_piece_visit(visitor, MPM_PIECE_UINT64, value, 1, name, -1);
}

/* ---------------------------------------------------------------- particles */

/* The fields that the last good state keeps. What else lasts follows from them, and from the id,
 * in a simulation of the same scene. */
static void visit_kept(struct mpm_piece_visitor *visitor, const struct mpm_particles *particles,
                       unsigned char *kept, const char *set)
{
    for (size_t field = 0; field < MPM_PARTICLE_FIELD_COUNT; field++)
        for (size_t k = 0; k < mpm_particles_kept_components(particles, field); k++) {
            char name[MPM_PIECE_NAME_SIZE];
            (void)snprintf(name, sizeof name, "%s.%s", set, mpm_particle_rows[field].info.name);
            mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, kept, particles->count, name, (int)k);
            kept += mpm_particles_kept_distance(particles, field);
        }
}

/* ------------------------------------------------------------------- cracks */

/* The part of all points that a chain has now. */
static void visit_chain(struct mpm_piece_visitor *visitor, struct mpm_crack_chain *chain,
                        double *const all[2], size_t point_count, const char *name, int crack)
{
    uint64_t part[2] = {(uint64_t)(chain->x - all[0]), chain->count};
    mpm_piece_visit(visitor, MPM_PIECE_UINT64, part, 2, name, crack);
    if (part[0] > point_count || part[1] < 2 || part[1] > point_count - part[0]) {
        mpm_piece_refuse(visitor, name);
        return;
    }
    *chain = (struct mpm_crack_chain){all[0] + part[0], all[1] + part[0], part[1]};
}

static void visit_tip_end(struct mpm_piece_visitor *visitor, struct mpm_tip_end *end, size_t cracks,
                          int index)
{
    int32_t reason = (int32_t)end->reason;
    uint64_t met[2] = {end->met, end->step};
    mpm_piece_visit(visitor, MPM_PIECE_INT32, &reason, 1, "tips.reason", index);
    mpm_piece_visit(visitor, MPM_PIECE_UINT64, met, 2, "tips.met", index);
    mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, &end->time, 1, "tips.time", index);
    mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, end->place, 2, "tips.end", index);
    if (reason < MPM_TIP_GOES_ON || reason > MPM_TIP_CONTOUR_MEETS_CRACK ||
        (reason != MPM_TIP_GOES_ON && met[0] >= cracks)) {
        mpm_piece_refuse(visitor, "tips.reason");
        return;
    }
    end->reason = (enum mpm_tip_end_reason)reason;
    end->met = (size_t)met[0];
    end->step = met[1];
}

static void visit_tips(struct mpm_simulation *simulation, struct mpm_piece_visitor *visitor)
{
    const struct mpm_scene *const scene = simulation->scene;
    for (size_t k = 0; k < scene->j_integral_count; k++) {
        struct mpm_crack_tip *const tip = &simulation->backup.tips[k];
        const int index = (int)k;
        mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, &tip->undeformed, NUMBERS(&tip->undeformed),
                        "tips.undeformed", index);
        mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, &tip->grown, 1, "tips.grown", index);
        mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, &tip->dissipated, 1, "tips.dissipated", index);
        visit_tip_end(visitor, &tip->end, scene->crack_count, index);
    }
}

/* Points that have grown since the sort are listed too: they grow again, to the same. */
static void visit_cracks(struct mpm_simulation *simulation, struct mpm_piece_visitor *visitor)
{
    static const char *const names[MPM_CRACK_ARRAYS] = {"cracks.x", "cracks.y", "cracks.opening_x",
                                                        "cracks.opening_y", "cracks.largest"};
    const struct mpm_scene *const scene = simulation->scene;
    struct mpm_cracks *const cracks = &simulation->state.cracks;
    struct mpm_backup *const backup = &simulation->backup;
    const size_t undeformed = cracks->undeformed != NULL ? mpm_cracks_undeformed_points(scene) : 0;
    for (int k = 0; k < MPM_CRACK_ARRAYS; k++)
        if (backup->crack_points[k] != NULL)
            mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, backup->crack_points[k],
                            mpm_backup_crack_points(simulation, k), names[k], -1);
    for (int axis = 0; axis < 2; axis++)
        mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, cracks->origin[axis], undeformed,
                        "cracks.undeformed", axis);
    mpm_piece_visit(visitor, MPM_PIECE_UINT8, cracks->held, cracks->point_count, "cracks.held", -1);
    if (cracks->openings.area != NULL)
        mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, cracks->openings.area,
                        mpm_backup_crack_points(simulation, MPM_CRACK_ARRAYS - 1), "cracks.area",
                        -1);
    for (size_t k = 0; scene->j_integral_count > 0 && k < scene->crack_count; k++) {
        struct mpm_chain_extents *const extents = &backup->extents[k];
        visit_chain(visitor, &extents->now, cracks->position, cracks->point_count, "cracks.chain",
                    (int)k);
        if (cracks->undeformed != NULL)
            visit_chain(visitor, &extents->undeformed, cracks->origin, undeformed,
                        "cracks.undeformed_chain", (int)k);
    }
    visit_tips(simulation, visitor);
}

/* ------------------------------------------------------------------ numbers */

/* What is added up: in the state after the sort. */
static void visit_totals(struct mpm_simulation *simulation, struct mpm_piece_visitor *visitor)
{
    struct mpm_backup *const backup = &simulation->backup;
    struct mpm_energy_balance *const energy = &backup->energy;
    double *const numbers[] = {
        &backup->time,          &backup->external_work,    &backup->largest_work,
        &backup->sudden_energy, &backup->transport_waited, &energy->particles,
        &energy->lost,          &energy->internal_work,    &energy->contact,
        &energy->dissipated,    &backup->diffusivity,      &backup->film,
    };
    static const char *const names[] = {
        "sorted.time",          "sorted.external_work",    "sorted.largest_work",
        "sorted.sudden_energy", "sorted.transport_waited", "energy.particles",
        "energy.lost",          "energy.internal_work",    "energy.contact",
        "energy.dissipated",    "sorted.diffusivity",      "sorted.film",
    };
    for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++)
        visit_double(visitor, numbers[k], names[k]);
    mpm_piece_visit(visitor, MPM_PIECE_INT64, &backup->transport_steps_waited, 1,
                    "sorted.transport_steps_waited", -1);
    mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, &backup->damping, NUMBERS(&backup->damping),
                    "damping", -1);
    mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, &backup->expansion, NUMBERS(&backup->expansion),
                    "expansion", -1);
    for (size_t k = 0; k < simulation->state.transport.count; k++)
        mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, &backup->scalars[k],
                        NUMBERS(&backup->scalars[k]), "scalars", (int)k);
    const size_t pairs = simulation->scene->contact.pair_count;
    mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, backup->contact_totals,
                    pairs * NUMBERS(backup->contact_totals), "contact", -1);
}

/* The steps since, and what is known after the last of them. */
static void visit_steps(struct mpm_simulation *simulation, struct mpm_piece_visitor *visitor)
{
    struct mpm_backup *const backup = &simulation->backup;
    visit_count(visitor, &simulation->step, "step");
    visit_count(visitor, &backup->step, "sorted.step");
    mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, backup->time_steps, MPM_STEPS_BETWEEN_SORTS,
                    "steps.length", -1);
    mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, backup->times, MPM_STEPS_BETWEEN_SORTS, "steps.end",
                    -1);
    mpm_piece_visit(visitor, MPM_PIECE_BOOL, backup->flushed, MPM_STEPS_BETWEEN_SORTS,
                    "steps.flushed", -1);
    visit_double(visitor, &simulation->wave_speed, "wave_speed");
    visit_double(visitor, &simulation->particle_speed, "particle_speed");
    visit_double(visitor, &simulation->diffusivity, "diffusivity");
    visit_double(visitor, &simulation->film, "film");
    mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, simulation->seconds, MPM_PHASE_COUNT, "seconds", -1);
}

/* Of the guards of energy and of rest. */
static void visit_guards(struct mpm_simulation *simulation, struct mpm_piece_visitor *visitor)
{
    struct mpm_energy_growth *const growth = &simulation->growth;
    struct mpm_rest_watch *const rest = &simulation->rest;
    visit_count(visitor, &simulation->judged_step, "judged_step");
    mpm_piece_visit(visitor, MPM_PIECE_BOOL, &growth->seen, 1, "growth.seen", -1);
    visit_count(visitor, &growth->step, "growth.step");
    visit_double(visitor, &growth->time, "growth.time");
    visit_double(visitor, &growth->factor, "growth.factor");
    visit_double(visitor, &growth->largest, "growth.largest");
    mpm_piece_visit(visitor, MPM_PIECE_INT64, &rest->steps_at_rest, 1, "rest.steps", -1);
    visit_double(visitor, &rest->largest_energy, "rest.largest_energy");
    visit_double(visitor, &rest->lowest_residual, "rest.lowest_residual");
    visit_double(visitor, &rest->lowest_time, "rest.lowest_time");
    visit_double(visitor, &rest->fallen_residual, "rest.fallen_residual");
    visit_double(visitor, &rest->fallen_time, "rest.fallen_time");
    visit_count(visitor, &rest->progress_step, "rest.progress_step");
}

static void visit_all(struct mpm_simulation *simulation, uint32_t *ids,
                      struct mpm_piece_visitor *visitor)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    const struct mpm_particles rigid = mpm_rigid_particles_set(&simulation->state.rigid);
    visit_steps(simulation, visitor);
    visit_guards(simulation, visitor);
    visit_totals(simulation, visitor);
    mpm_piece_visit(visitor, MPM_PIECE_UINT32, ids, particles->count, "particles.id", -1);
    visit_kept(visitor, particles, simulation->backup.particles, "particles");
    visit_kept(visitor, &rigid, simulation->backup.rigid, "rigid");
    visit_cracks(simulation, visitor);
}

void mpm_checkpoint_visit(struct mpm_simulation *simulation, struct mpm_piece_visitor *visitor)
{
    visit_all(simulation, simulation->state.particles.id, visitor);
}

static enum mpm_status add_bytes(void *context, const struct mpm_piece *piece,
                                 struct mpm_error *error)
{
    size_t *const bytes = context;
    (void)error;
    *bytes += mpm_piece_bytes(piece);
    return MPM_OK;
}

size_t mpm_checkpoint_bytes(struct mpm_simulation *simulation)
{
    size_t bytes = 0;
    struct mpm_piece_visitor visitor = {.take = add_bytes, .context = &bytes};
    mpm_checkpoint_visit(simulation, &visitor);
    return bytes;
}

/* ------------------------------------------------------------------ loading */

/* A reader whose numbers are checked: each is finite, but for those that say of nothing that it is
 * far away. */
struct checked {
    struct mpm_piece_visitor *from;
};

static enum mpm_status take_finite(void *context, const struct mpm_piece *piece,
                                   struct mpm_error *error)
{
    const struct checked *const checked = context;
    MPM_TRY(checked->from->take(checked->from->context, piece, error));
    const double *const numbers = piece->type == MPM_PIECE_DOUBLE ? piece->data : NULL;
    for (size_t k = 0; numbers != NULL && k < piece->count; k++)
        if (!isfinite(numbers[k]))
            return mpm_error_set(error, MPM_BAD_INPUT, "'%s' has a value that is not finite",
                                 piece->name);
    return MPM_OK;
}

/* The place of each particle before, by its place from now on; ids are replaced by it. */
static enum mpm_status find_order(const struct mpm_simulation *simulation, uint32_t *ids,
                                  struct mpm_error *error)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    const size_t all = mpm_simulation_particle_count(simulation);
    uint32_t *const place_of = malloc((all + 1) * sizeof *place_of);
    enum mpm_status status = MPM_OK;
    if (place_of == NULL)
        return mpm_error_memory(error, all * sizeof *place_of, "the order of particles");
    memset(place_of, 0xff, (all + 1) * sizeof *place_of);
    for (size_t p = 0; p < particles->count; p++)
        place_of[particles->id[p]] = (uint32_t)p;
    for (size_t p = 0; p < particles->count && status == MPM_OK; p++) {
        const uint32_t id = ids[p] < all ? ids[p] : (uint32_t)all;
        ids[p] = place_of[id];
        place_of[id] = UINT32_MAX; /* no particle comes twice */
        if (ids[p] == UINT32_MAX)
            status = mpm_error_set(error, MPM_BAD_INPUT,
                                   "'particles.id' does not have each particle once");
    }
    free(place_of);
    return status;
}

static enum mpm_status check_places(const struct mpm_simulation *simulation,
                                    double *const position[2], size_t count, const char *what,
                                    struct mpm_error *error)
{
    const struct mpm_grid *const grid = &simulation->state.grid;
    for (size_t p = 0; p < count; p++)
        for (int axis = 0; axis < 2; axis++) {
            const double cells =
                (position[axis][p] - grid->origin[axis]) * grid->inverse_cell[axis];
            if (!(cells >= 0.0) || !(cells <= (double)grid->cells[axis]))
                return mpm_error_set(error, MPM_BAD_INPUT, "'%s' has a place outside of the grid",
                                     what);
        }
    return MPM_OK;
}

/* Every particle in the grid, and steps that go on from the sort. */
static enum mpm_status check(const struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_backup *const backup = &simulation->backup;
    const struct mpm_particles *const particles = &simulation->state.particles;
    const uint64_t since = simulation->step - backup->step;
    if (simulation->step < backup->step || since > MPM_STEPS_BETWEEN_SORTS ||
        (since == 0) != (simulation->step == 0))
        return mpm_error_set(error, MPM_BAD_INPUT, "'sorted.step' has a value that no run leaves");
    for (size_t k = 0; k < since; k++)
        if (!(backup->time_steps[k] > 0.0) ||
            !(backup->times[k] > (k > 0 ? backup->times[k - 1] : backup->time)))
            return mpm_error_set(error, MPM_BAD_INPUT, "'steps.length': time does not go on");
    const struct mpm_rigid_particles *const rigid = &simulation->state.rigid;
    MPM_TRY(check_places(simulation, particles->position, particles->count, "particles", error));
    return check_places(simulation, rigid->position, rigid->count, "rigid", error);
}

enum mpm_status mpm_checkpoint_load(struct mpm_simulation *simulation,
                                    struct mpm_piece_visitor *visitor)
{
    struct mpm_particles *const particles = &simulation->state.particles;
    struct mpm_error *const error = visitor->error;
    uint32_t *const ids = mpm_particles_order(particles);
    struct checked checked = {visitor};
    struct mpm_piece_visitor reader = {.take = take_finite, .context = &checked, .error = error};
    visit_all(simulation, ids, &reader);
    MPM_TRY(reader.status);
    MPM_TRY(find_order(simulation, ids, error));
    mpm_particles_arrange(particles, ids);
    const struct mpm_particles rigid = mpm_rigid_particles_set(&simulation->state.rigid);
    mpm_particles_put_back(particles, simulation->backup.particles);
    mpm_particles_put_back(&rigid, simulation->backup.rigid);
    MPM_TRY(check(simulation, error));
    if (simulation->step == 0)
        return MPM_OK;
    const double speeds[] = {simulation->wave_speed, simulation->particle_speed,
                             simulation->diffusivity, simulation->film};
    struct mpm_error why = {.message = "a step since 'sorted.step' fails"};
    if (mpm_backup_resume(simulation, simulation->step, &why) != MPM_OK)
        return mpm_error_set(error, MPM_BAD_INPUT, "%s", why.message);
    simulation->wave_speed = speeds[0];
    simulation->particle_speed = speeds[1];
    simulation->diffusivity = speeds[2];
    simulation->film = speeds[3];
    return MPM_OK;
}

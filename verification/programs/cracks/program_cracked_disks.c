/* D3: two cracked disks collide and part, CRAMP 3.2: do their cracks open and close without
 * crossing, does a closed crack pass the wave on as the whole disk does, what becomes of the
 * energy?
 *
 * Beside it, as far as it is needed, the same disks without cracks (`intact`).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"
#include "verification/programs/motion/impact.h"

#include <glib.h>
#include <math.h>

enum { AXES = 2, COLUMNS = 10, CLOSING = 1 }; /* CLOSING: the crack that the impact closes */

struct study {
    struct impact impact;
    struct measurement *measurement;
    struct mpm_simulation *intact; /* or NULL */
    double until;                  /* comparison with the intact disks ends then */
    double *mass, *body, *velocity;
    double approach, separation; /* of the centres: at the start, now */
    double energy;               /* at the start */
    double behind[2];            /* velocity of what the closing crack hides: now, intact */
    double behind_start;
    double largest, difference; /* change of the intact one's so far; between both */
    struct follow_rows rows;
    enum mpm_status status; /* of the intact run */
    struct mpm_error error;
};

static double separation_speed(const struct study *study)
{
    double mass[2] = {0.0, 0.0}, momentum[2] = {0.0, 0.0};
    for (size_t p = 0; p < study->impact.count; p++) {
        const int side = study->body[p] > 0.5;
        mass[side] += study->mass[p];
        momentum[side] += study->mass[p] * study->velocity[AXES * p];
    }
    return momentum[1] / mass[1] - momentum[0] / mass[0];
}

/* Mean velocity along x of the particles of the face below the closing crack. */
static double velocity_behind(const struct study *study, const struct mpm_simulation *simulation)
{
    const struct crack_faces *const faces = &study->impact.cracks[CLOSING].faces;
    double sum = 0.0, count = 0.0;
    mpm_simulation_field(simulation, MPM_FIELD_VELOCITY, study->velocity);
    for (size_t i = 0; i < faces->count; i++)
        if (faces->particles[i].side < 0.0) {
            sum += study->velocity[AXES * faces->particles[i].index];
            count += 1.0;
        }
    return sum / count;
}

/* The intact disks are brought to the same instant. */
static void compare_with_intact(struct study *study, double time)
{
    bool alive = true;
    if (study->intact == NULL || time > study->until || study->status != MPM_OK)
        return;
    study->status = follow_to(study->measurement, study->intact, time, &alive, &study->error);
    study->behind[1] = velocity_behind(study, study->intact);
    if (study->rows.count == 0)
        study->behind_start = study->behind[1];
    study->largest = fmax(study->largest, fabs(study->behind[1] - study->behind_start));
    study->difference = fmax(study->difference, fabs(study->behind[1] - study->behind[0]));
}

static void look(void *context, const struct mpm_simulation *simulation,
                 const struct mpm_ledger *ledger)
{
    struct study *const study = context;
    impact_look(&study->impact);
    study->behind[0] = velocity_behind(study, simulation);
    study->separation = separation_speed(study);
    if (study->rows.count == 0) {
        study->approach = -study->separation;
        study->energy = ledger->total_energy;
    }
    compare_with_intact(study, ledger->time);
    const struct crack_gap *const first = &study->impact.cracks[0].now,
                                  *const second = &study->impact.cracks[CLOSING].now;
    const double cell = study->impact.cell;
    const double row[COLUMNS] = {ledger->time,
                                 ledger->total_energy / study->energy,
                                 ledger->kinetic_energy / study->energy,
                                 study->separation / study->approach,
                                 first->widest / cell,
                                 first->narrowest / cell,
                                 second->widest / cell,
                                 second->narrowest / cell,
                                 study->behind[0],
                                 study->behind[1]};
    follow_rows_add(&study->rows, row);
}

static enum mpm_status report(const struct study *study, const struct follow_result *result,
                              double arm, struct mpm_error *error)
{
    struct measurement *const m = study->measurement;
    const struct conservation *const conservation = &result->conservation;
    follow_report(m, result, arm);
    measurement_report(m, "end_drift", 100.0 * conservation_energy_now(conservation));
    measurement_report(m, "slowest", 100.0 * conservation->smallest_kinetic);
    measurement_report(m, "restitution", study->separation / study->approach);
    if (study->intact != NULL)
        measurement_report(m, "shadow", 100.0 * study->difference / study->largest);
    TRY(impact_report(&study->impact, error));
    TRY(follow_rows_check(&study->rows, error));
    return measurement_series(m, "collision",
                              "time total_over_start kinetic_over_start speed widest_1 narrowest_1 "
                              "widest_2 narrowest_2 behind behind_intact",
                              COLUMNS, study->rows.count, study->rows.values, error);
}

static enum mpm_status follow_both(struct study *study, struct mpm_simulation *simulation,
                                   double end, struct mpm_error *error)
{
    double interval, radius;
    struct follow_result result;
    TRY(measurement_number(study->measurement, "interval", &interval, error));
    TRY(measurement_number(study->measurement, "radius", &radius, error));
    const struct follow follow = {.measurement = study->measurement,
                                  .end = end,
                                  .interval = interval,
                                  .sample = look,
                                  .context = study};
    TRY(follow_run(&follow, simulation, &result, error));
    if (study->status != MPM_OK)
        *error = study->error;
    TRY(study->status);
    return report(study, &result, radius, error);
}

static enum mpm_status open_study(struct study *study, const struct mpm_simulation *simulation,
                                  struct mpm_error *error)
{
    const size_t n = mpm_simulation_particle_count(simulation);
    study->mass = g_new(double, n);
    study->body = g_new(double, n);
    study->velocity = g_new(double, AXES *n);
    study->rows.columns = COLUMNS;
    mpm_simulation_field(simulation, MPM_FIELD_MASS, study->mass);
    mpm_simulation_field(simulation, MPM_FIELD_BODY, study->body);
    TRY(impact_open(&study->impact, study->measurement, simulation, MPM_FIELD_STRESS, error));
    if (study->impact.crack_count <= CLOSING)
        return failure_set(error, MPM_BAD_INPUT, "the scene has %zu cracks; allowed: two",
                           study->impact.crack_count);
    return MPM_OK;
}

static void close_study(struct study *study)
{
    impact_close(&study->impact);
    follow_rows_free(&study->rows);
    g_free(study->mass);
    g_free(study->body);
    g_free(study->velocity);
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    (void)m;
    enum mpm_status status = open_study(study, simulation, error);
    if (status == MPM_OK)
        status = follow_both(study, simulation, mpm_scene_end_time(scene), error);
    close_study(study);
    return status;
}

/* Variants that are compared with the disks without cracks state how to take these away. */
static enum mpm_status open_intact(struct study *study, struct mpm_scene **scene,
                                   struct mpm_error *error)
{
    struct measurement *const m = study->measurement;
    const char *setting;
    if (!measurement_has(m, "intact"))
        return MPM_OK;
    TRY(measurement_text(m, "intact", &setting, error));
    TRY(measurement_number(m, "until", &study->until, error));
    TRY(measurement_scene(m, &setting, 1, scene, error));
    return mpm_simulation_create(*scene, measurement_options(m), &study->intact, error);
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {.measurement = measurement};
    struct mpm_scene *intact = NULL;
    enum mpm_status status = open_intact(&study, &intact, error);
    if (status == MPM_OK)
        status = follow_scene(measurement, NULL, 0, measure, &study, error);
    mpm_simulation_free(study.intact);
    mpm_scene_free(intact);
    return status;
}

const struct measure_program program_cracked_disks = {
    .name = "cracked_disks",
    .summary = "two cracked disks collide: faces of their cracks, energy, the disks without cracks",
    .run = run,
};

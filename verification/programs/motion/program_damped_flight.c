/* E5: a free body that damping slows down, against the exact decay and against the decay of the
 * solver's own steps.
 *
 * All particles start with one velocity. After each step the velocity and the way of each are
 * compared with damped_flight.h, and the dissipated energy with the kinetic energy that is gone. At
 * the end the velocity is compared with the exact one, on each level (of the time step).
 *
 * Parameters: grid, growth, particle, feedback, target, midpoint (0 or 1) of struct damped_flight.
 * Series: decay, the velocity over time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/waves/damped_flight.h"
#include "verification/measures/fields.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>

enum { AXES = 2, COLUMNS = 3 };
static const double NOTHING = 1e-17; /* where both agree to the last bit */

/* Largest errors of a run. */
struct errors {
    double step, way, energy; /* over the start's velocity, its way, its energy */
    double decay;             /* velocity at the end over the exact one, less one */
};

struct study {
    struct damped_flight flight;
    struct errors errors;
    size_t count;
    double *velocity_start, *position_start, *now;
    double speed, energy_start;
    struct follow_rows rows;
};

static double distance(const double *one, const double *other, double part)
{
    return hypot(one[0] - part * other[0], one[1] - part * other[1]);
}

static void open_study(struct study *study, const struct mpm_simulation *simulation)
{
    struct mpm_ledger ledger;
    study->count = mpm_simulation_particle_count(simulation);
    study->velocity_start = g_new(double, AXES * study->count);
    study->position_start = g_new(double, AXES * study->count);
    study->now = g_new(double, AXES * study->count);
    mpm_simulation_field(simulation, MPM_FIELD_VELOCITY, study->velocity_start);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, study->position_start);
    mpm_simulation_ledger(simulation, &ledger);
    study->energy_start = ledger.kinetic_energy;
    study->speed = hypot(study->velocity_start[0], study->velocity_start[1]);
    study->errors = (struct errors){NOTHING, NOTHING, NOTHING, (double)NAN};
    study->rows = (struct follow_rows){.columns = COLUMNS};
}

static void close_study(struct study *study)
{
    g_free(study->velocity_start);
    g_free(study->position_start);
    g_free(study->now);
    follow_rows_free(&study->rows);
}

static void compare(struct study *study, const struct mpm_simulation *simulation,
                    const struct damped_flight_state *state)
{
    struct errors *const errors = &study->errors;
    struct mpm_ledger ledger;
    double way[AXES];
    mpm_simulation_field(simulation, MPM_FIELD_VELOCITY, study->now);
    for (size_t k = 0; k < AXES * study->count; k += AXES)
        errors->step = field_larger(
            errors->step,
            distance(&study->now[k], &study->velocity_start[k], state->velocity) / study->speed);
    mpm_simulation_ledger(simulation, &ledger);
    const double time = ledger.time, exact = damped_flight_velocity(&study->flight, time);
    const double along =
        study->now[0] * study->velocity_start[0] + study->now[1] * study->velocity_start[1];
    const double part = along / (study->speed * study->speed);
    follow_rows_add(&study->rows, (const double[COLUMNS]){time, part, exact});
    errors->decay = part / exact - 1.0;
    const double gone = study->energy_start - ledger.kinetic_energy;
    errors->energy =
        field_larger(errors->energy, fabs(ledger.damping_dissipation - gone) / study->energy_start);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, study->now);
    for (size_t k = 0; k < AXES * study->count; k += AXES) {
        for (size_t axis = 0; axis < AXES; axis++)
            way[axis] = study->now[k + axis] - study->position_start[k + axis];
        errors->way =
            field_larger(errors->way, distance(way, &study->velocity_start[k], state->way) /
                                          (study->speed * state->way));
    }
}

static enum mpm_status fly(void *context, struct measurement *m, const struct mpm_scene *scene,
                           struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    const double end = mpm_scene_end_time(scene);
    struct damped_flight_state state = damped_flight_start;
    enum mpm_status status = MPM_OK;
    bool alive = true;
    close_study(study);
    open_study(study, simulation);
    while (status == MPM_OK && alive && mpm_simulation_time(simulation) < end) {
        const double time = mpm_simulation_time(simulation);
        status = follow_step(m, simulation, end, &alive, error);
        if (status != MPM_OK || !alive)
            break;
        damped_flight_advance(&study->flight, time, mpm_simulation_time(simulation) - time, &state);
        compare(study, simulation, &state);
    }
    if (!alive)
        study->errors = (struct errors){(double)NAN, (double)NAN, (double)NAN, (double)NAN};
    follow_count_work(m, simulation);
    return status == MPM_OK ? follow_rows_check(&study->rows, error) : status;
}

static enum mpm_status read_flight(const struct measurement *m, struct damped_flight *flight,
                                   struct mpm_error *error)
{
    unsigned midpoint;
    const struct measurement_parameter table[] = {
        {"grid", &flight->grid},         {"growth", &flight->growth},
        {"particle", &flight->particle}, {"feedback", &flight->feedback},
        {"target", &flight->target},
    };
    TRY(measurement_numbers(m, table, sizeof table / sizeof *table, error));
    TRY(measurement_count(m, "midpoint", 0, 1, &midpoint, error));
    flight->midpoint = midpoint == 1;
    return MPM_OK;
}

static enum mpm_status run_levels(struct study *study, struct measurement *m,
                                  struct mpm_error *error)
{
    struct levels levels;
    struct errors worst = {NOTHING, NOTHING, NOTHING, (double)NAN};
    double decay[LEVELS_MAX];
    TRY(levels_read(m, &levels, error));
    for (size_t k = 0; k < levels_runs(&levels); k++) {
        TRY(follow_scene(m, &levels.setting[k], levels.count == 0 ? 0 : 1, fly, study, error));
        worst.step = field_larger(worst.step, study->errors.step);
        worst.way = field_larger(worst.way, study->errors.way);
        worst.energy = field_larger(worst.energy, study->errors.energy);
        decay[k] = fabs(study->errors.decay);
    }
    measurement_report(m, "step_error", worst.step);
    measurement_report(m, "way_error", worst.way);
    measurement_report(m, "energy_error", worst.energy);
    TRY(measurement_series(m, "decay", "time velocity exact", COLUMNS, study->rows.count,
                           study->rows.values, error));
    if (study->flight.feedback != 0.0 && study->flight.target != 0.0)
        return MPM_OK; /* no exact decay */
    measurement_report(m, "decay_error", 100.0 * study->errors.decay);
    return levels.count == 0 ? MPM_OK : levels_report(m, &levels, "_decay", decay, error);
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {.count = 0};
    TRY(read_flight(measurement, &study.flight, error));
    const enum mpm_status status = run_levels(&study, measurement, error);
    close_study(&study);
    return status;
}

const struct measure_program program_damped_flight = {
    .name = "damped_flight",
    .summary = "decay of a free body's velocity by damping",
    .run = run,
};

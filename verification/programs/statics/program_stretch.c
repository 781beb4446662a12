/* G4: a column is stretched by a traction, brought to rest with small steps, and left alone with
 * steps of the Courant number of the scene: how fast does it lose its uniform state?
 *
 * The deviation is the root mean square velocity of the particles, sqrt(2 K/M). Parameters: `hold`,
 * the time at which the steps become those of the scene, and `careful`, the longest step before;
 * from then on the deviation is sampled every `interval`. Its growth rate is the slope of its
 * logarithm by least squares, from where it last is below `from` to where it first exceeds `to`.
 * It also reports the rate of stretched_column.h for the state at `hold`, with `modulus`, the
 * slope of the force over the stretch, and the density of the unstretched column, `density`.
 * Series: `deviation` over time and, where it grows, `predicted`: the same growth at that rate.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/stretched_column.h"
#include "verification/measures/fields.h"
#include "verification/measures/particle_set.h"
#include "verification/programs/follow.h"

#include <math.h>

enum { COLUMNS = 2, AXES = 2, STRESS = 4, ALONG = 1, FEWEST = 5 };

static const char *const order_names[] = {[STRETCHED_USL] = "usl",
                                          [STRETCHED_MUSL] = "musl",
                                          [STRETCHED_USF] = "usf",
                                          [STRETCHED_USAVG] = "usavg",
                                          [STRETCHED_USAVG_ONCE] = "usavg_once"};
static const char *const position_names[] = {
    [STRETCHED_GRID_VELOCITY] = "grid_velocity", [STRETCHED_MIDPOINT] = "midpoint"};

struct study {
    double hold, careful, interval, from, to, modulus, density;
    struct stretched_column column;
    struct particle_set set;
    struct follow_rows rows;
};

static enum mpm_status read_parameters(const struct measurement *m, struct study *study,
                                       struct mpm_error *error)
{
    const struct measurement_parameter table[] = {
        {"hold", &study->hold},
        {"careful", &study->careful},
        {"interval", &study->interval},
        {"from", &study->from},
        {"to", &study->to},
        {"modulus", &study->modulus},
        {"density", &study->density},
        {"fraction", &study->column.fraction},
    };
    size_t order, position;
    TRY(measurement_numbers(m, table, sizeof table / sizeof *table, error));
    TRY(measurement_choice(m, "order", order_names, sizeof order_names / sizeof *order_names,
                           &order, error));
    TRY(measurement_choice(m, "position", position_names,
                           sizeof position_names / sizeof *position_names, &position, error));
    study->column.order = (enum stretched_order)order;
    study->column.position = (enum stretched_position)position;
    if (study->careful > 0.0 && study->interval > 0.0)
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT,
                       "case %s: steps of %g, samples every %g; allowed: above 0",
                       measurement_case(m), study->careful, study->interval);
}

static double look(struct study *study, const struct mpm_simulation *simulation)
{
    struct mpm_ledger ledger;
    mpm_simulation_ledger(simulation, &ledger);
    const double deviation = sqrt(2.0 * ledger.kinetic_energy / ledger.mass);
    const double row[COLUMNS] = {mpm_simulation_time(simulation), deviation};
    follow_rows_add(&study->rows, row);
    return deviation;
}

/* The state of the column from its lower half, which the loaded end does not touch. */
static void take_state(struct study *study, const struct mpm_simulation *simulation)
{
    const struct particle_set *const set = &study->set;
    struct stretched_column *const column = &study->column;
    double top = 0.0, stretch = 0.0, stress = 0.0, count = 0.0;
    particle_set_read(&study->set, simulation);
    for (size_t k = 0; k < set->count; k++)
        top = field_larger(top, set->start[AXES * k + ALONG]);
    for (size_t k = 0; k < set->count; k++)
        if (set->start[AXES * k + ALONG] < 0.5 * top) {
            stretch += set->relative_volume[k];
            stress += set->stress[STRESS * k + ALONG];
            count += 1.0;
        }
    stretch /= count;
    column->particles = set->count;
    column->length = stretch * top / ((double)set->count - 0.5);
    column->stress = stress / count;
    column->tangent = study->modulus * stretch;
    column->density = study->density / stretch;
}

/* Slope of ln deviation by least squares; NaN for fewer than FEWEST rows. */
static double slope(const double *rows, size_t count)
{
    double time = 0.0, value = 0.0, above = 0.0, below = 0.0;
    for (size_t k = 0; k < count; k++) {
        time += rows[COLUMNS * k] / (double)count;
        value += log(rows[COLUMNS * k + 1]) / (double)count;
    }
    for (size_t k = 0; k < count; k++) {
        above += (rows[COLUMNS * k] - time) * (log(rows[COLUMNS * k + 1]) - value);
        below += (rows[COLUMNS * k] - time) * (rows[COLUMNS * k] - time);
    }
    return count < FEWEST ? (double)NAN : above / below;
}

static double growth_rate(const struct study *study)
{
    const double *const rows = study->rows.values;
    size_t begin = 0, end = 0;
    while (end < study->rows.count && rows[COLUMNS * end + 1] <= study->to)
        end++;
    for (size_t k = 0; k < end; k++)
        if (rows[COLUMNS * k + 1] < study->from)
            begin = k;
    return end == study->rows.count ? (double)NAN : slope(&rows[COLUMNS * begin], end - begin);
}

/* The line of that rate which ends where the deviation does, from round-off on. */
static enum mpm_status write_predicted(const struct study *study, struct measurement *m,
                                       double rate, struct mpm_error *error)
{
    static const double round_off = 1e-15;
    const size_t last = COLUMNS * (study->rows.count - 1);
    const double time = study->rows.values[last], deviation = study->rows.values[last + 1];
    const double rows[] = {time - log(deviation / round_off) / rate, round_off, time, deviation};
    return measurement_series(m, "predicted", "time deviation", COLUMNS, 2, rows, error);
}

static enum mpm_status report(struct study *study, struct measurement *m, double time_step,
                              struct mpm_error *error)
{
    const double predicted = stretched_column_rate(&study->column, time_step);
    const double rate = growth_rate(study);
    double largest = 0.0;
    for (size_t k = 0; k < study->rows.count; k++)
        largest = field_larger(largest, study->rows.values[COLUMNS * k + 1]);
    measurement_report(m, "deviation", largest);
    measurement_note(m, "rate of the linear step %.5g, measured %.5g", predicted, rate);
    if (!isfinite(rate)) {
        measurement_inconclusive(m, "over_predicted", "the deviation comes to %g only", largest);
        return MPM_OK;
    }
    measurement_report(m, "over_predicted", rate / predicted);
    return predicted > 0.0 ? write_predicted(study, m, predicted, error) : MPM_OK;
}

static enum mpm_status follow(struct study *study, struct measurement *m,
                              struct mpm_simulation *simulation, double end,
                              struct mpm_error *error)
{
    bool alive = true;
    double time = 0.0, time_step = 0.0;
    while (alive && time < study->hold) {
        TRY(follow_step(m, simulation, fmin(time + study->careful, study->hold), &alive, error));
        time = mpm_simulation_time(simulation);
    }
    (void)look(study, simulation);
    take_state(study, simulation);
    double deviation = 0.0;
    for (double next = time; alive && time < end && deviation <= study->to;) {
        TRY(follow_step(m, simulation, end, &alive, error));
        time_step = fmax(time_step, mpm_simulation_time(simulation) - time);
        time = mpm_simulation_time(simulation);
        if (alive && time >= next + study->interval) {
            deviation = look(study, simulation);
            next = time;
        }
    }
    TRY(report(study, m, time_step, error));
    follow_count_work(m, simulation);
    return follow_rows_check(&study->rows, error);
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    TRY(read_parameters(m, study, error));
    study->rows.columns = COLUMNS;
    TRY(particle_set_create(simulation, 0, &study->set, error));
    enum mpm_status status = follow(study, m, simulation, mpm_scene_end_time(scene), error);
    if (status == MPM_OK)
        status = measurement_series(m, "deviation", "time deviation", COLUMNS, study->rows.count,
                                    study->rows.values, error);
    particle_set_free(&study->set);
    follow_rows_free(&study->rows);
    return status;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {.hold = 0.0};
    return follow_scene(measurement, NULL, 0, measure, &study, error);
}

const struct measure_program program_stretch = {
    .name = "stretch",
    .summary = "how fast a stretched column loses its uniform state",
    .run = run,
};

/* E6: frequency and decay of a bar's first axial mode under damping, against the exact damped mode
 * and against what the method makes of it on its grid.
 *
 * The velocities of the particles are projected onto sin(k X) through the run, and the amplitude is
 * fitted by a decaying oscillation. Errors against the exact mode are reported for the finest
 * level, with their orders; those against the method (damped_bar.h) are the largest over all
 * levels.
 *
 * Parameters: length, wave_speed, rate, profile, width of struct damped_bar; form; order,
 * particles, flip of struct bar_dispersion and cell, that of the coarsest level; periods.
 * Series: amplitude, with the exact envelope.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/waves/damped_bar.h"
#include "verification/measures/fields.h"
#include "verification/measures/oscillation.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>

enum { AXES = 2, COLUMNS = 3, SAMPLES_A_PERIOD = 20, PARTICLES_MAX = 16 };
static const double PI = 3.14159265358979323846;

struct study {
    struct damped_bar bar;
    enum damped_bar_form form;
    struct bar_dispersion grid;
    double periods;
    struct bar_dispersion_result exact, measured, method;
    size_t count;
    double *shape; /* sin k X of each particle */
    double *velocity;
    struct follow_rows rows;
};

static void project(void *context, const struct mpm_simulation *simulation,
                    const struct mpm_ledger *ledger)
{
    struct study *const study = context;
    double sum = 0.0, square = 0.0;
    mpm_simulation_field(simulation, MPM_FIELD_VELOCITY, study->velocity);
    for (size_t p = 0; p < study->count; p++) {
        sum += study->shape[p] * study->velocity[AXES * p];
        square += study->shape[p] * study->shape[p];
    }
    const double amplitude = sum / square;
    const double first = study->rows.count == 0 ? amplitude : study->rows.values[1];
    follow_rows_add(&study->rows,
                    (const double[COLUMNS]){ledger->time, amplitude,
                                            first * exp(-study->exact.decay * ledger->time)});
}

/* Without the last sample: its step is shorter, to land on the end. */
static bool fit(struct study *study)
{
    const size_t count = study->rows.count - 1;
    double *const time = g_new(double, count), *const value = g_new(double, count);
    struct oscillation found;
    for (size_t k = 0; k < count; k++) {
        time[k] = study->rows.values[COLUMNS * k];
        value[k] = study->rows.values[COLUMNS * k + 1];
    }
    const bool fitted =
        oscillation_fit(count, time, value, PI * study->bar.speed / study->bar.length, &found);
    study->measured = fitted ? (struct bar_dispersion_result){found.frequency, found.decay}
                             : (struct bar_dispersion_result){(double)NAN, (double)NAN};
    g_free(time);
    g_free(value);
    return fitted;
}

static enum mpm_status vibrate(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    const double period = 2.0 * study->bar.length / study->bar.speed; /* without damping */
    struct follow_result result;
    (void)scene;
    follow_rows_free(&study->rows);
    study->rows = (struct follow_rows){.columns = COLUMNS};
    study->count = mpm_simulation_particle_count(simulation);
    study->velocity = g_new(double, AXES * study->count);
    study->shape = g_new(double, study->count);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, study->velocity);
    for (size_t p = 0; p < study->count; p++)
        study->shape[p] = sin(PI / study->bar.length * study->velocity[AXES * p]);
    const struct follow follow = {.measurement = m,
                                  .end = study->periods * period,
                                  .interval = period / SAMPLES_A_PERIOD,
                                  .sample = project,
                                  .context = study};
    const enum mpm_status status = follow_run(&follow, simulation, &result, error);
    study->grid.step = result.time_step;
    g_free(study->velocity);
    g_free(study->shape);
    TRY(status);
    TRY(follow_rows_check(&study->rows, error));
    if (!result.finished || !fit(study))
        study->measured = (struct bar_dispersion_result){(double)NAN, (double)NAN};
    damped_bar_set_drag(&study->bar, study->form, &study->grid);
    study->method = bar_dispersion(&study->grid, PI / study->bar.length);
    return MPM_OK;
}

static double percent(double value, double exact)
{
    return 100.0 * (value / exact - 1.0);
}

static enum mpm_status read_study(const struct measurement *m, struct study *study,
                                  struct mpm_error *error)
{
    static const char *const orders[BAR_DISPERSION_ORDERS] = {"usl", "musl", "usf", "usavg"};
    static const char *const forms[DAMPED_BAR_FORMS] = {"nodes", "particles", "particle_rate",
                                                        "own"};
    static const char *const profiles[DAMPED_BAR_PROFILES] = {"uniform", "cosine", "band"};
    size_t order, form, profile;
    const struct measurement_parameter table[] = {
        {"length", &study->bar.length}, {"wave_speed", &study->bar.speed},
        {"rate", &study->bar.rate},     {"width", &study->bar.width},
        {"cell", &study->grid.cell},    {"flip", &study->grid.fraction},
        {"periods", &study->periods},
    };
    TRY(measurement_numbers(m, table, sizeof table / sizeof *table, error));
    TRY(measurement_choice(m, "profile", profiles, DAMPED_BAR_PROFILES, &profile, error));
    TRY(measurement_count(m, "particles", 1, PARTICLES_MAX, &study->grid.particles, error));
    TRY(measurement_choice(m, "order", orders, BAR_DISPERSION_ORDERS, &order, error));
    TRY(measurement_choice(m, "form", forms, DAMPED_BAR_FORMS, &form, error));
    study->bar.profile = (enum damped_bar_profile)profile;
    study->form = (enum damped_bar_form)form;
    study->grid.order = (enum bar_dispersion_order)order;
    study->grid.speed = study->bar.speed;
    study->exact = damped_bar_mode(&study->bar);
    return MPM_OK;
}

static enum mpm_status measure(struct study *study, struct measurement *m, struct mpm_error *error)
{
    struct levels levels;
    double decay[LEVELS_MAX], frequency[LEVELS_MAX];
    double worst_decay = 0.0, worst_frequency = 0.0;
    TRY(levels_read(m, &levels, error));
    for (size_t k = 0; k < levels_runs(&levels); k++) {
        TRY(follow_scene(m, &levels.setting[k], levels.count == 0 ? 0 : 1, vibrate, study, error));
        decay[k] = fabs(percent(study->measured.decay, study->exact.decay));
        frequency[k] = fabs(percent(study->measured.frequency, study->exact.frequency));
        worst_decay =
            field_larger(worst_decay, fabs(percent(study->measured.decay, study->method.decay)));
        worst_frequency = field_larger(
            worst_frequency, fabs(percent(study->measured.frequency, study->method.frequency)));
        measurement_note(m, "cell %g: decay %.8g, of the method %.8g, exact %.8g", study->grid.cell,
                         study->measured.decay, study->method.decay, study->exact.decay);
        study->grid.cell *= 0.5;
    }
    measurement_report(m, "decay_over_method", worst_decay);
    measurement_report(m, "frequency_over_method", worst_frequency);
    TRY(measurement_series(m, "amplitude", "time amplitude envelope", COLUMNS, study->rows.count,
                           study->rows.values, error));
    if (study->bar.profile == DAMPED_BAR_BAND)
        return MPM_OK; /* its limit depends on the form */
    measurement_report(m, "decay_error", percent(study->measured.decay, study->exact.decay));
    measurement_report(m, "frequency_error",
                       percent(study->measured.frequency, study->exact.frequency));
    if (levels.count == 0)
        return MPM_OK;
    TRY(levels_report(m, &levels, "_decay", decay, error));
    return levels_report(m, &levels, "_frequency", frequency, error);
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {.count = 0};
    TRY(read_study(measurement, &study, error));
    const enum mpm_status status = measure(&study, measurement, error);
    follow_rows_free(&study.rows);
    return status;
}

const struct measure_program program_damped_bar = {
    .name = "damped_bar",
    .summary = "frequency and decay of a bar under damping against the exact damped mode",
    .run = run,
};

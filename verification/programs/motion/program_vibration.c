/* E3, W2: frequency and decay of small free vibrations against the exact modes of a bar, a
 * cylinder and a disk.
 *
 * The body starts with the velocity of one mode; its particles' velocities are projected onto
 * the shape of that mode through the run, and the amplitude is fitted by a decaying oscillation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/waves/bar_dispersion.h"
#include "verification/exact/waves/radial_mode.h"
#include "verification/exact/waves/vibrating_bar.h"
#include "verification/measures/fields.h"
#include "verification/measures/oscillation.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>

enum {
    AXES = 2,
    MODE_COLUMNS = 3, /* time, amplitude and energy over their starts */
    SERIES_TERMS = 24,
    SAMPLES_A_PERIOD = 20,
    MODES_MAX = 20,
    PARTICLES_MAX = 16,
};

static const double TWO_PI = 6.28318530717958647692;

/* A mode to be measured. */
struct mode {
    double wave_number, frequency;
    void (*shape)(const struct mode *mode, const double start[AXES], double shape[AXES]);
    char *velocity[AXES]; /* settings; NULL where the scene has it */
};

/* Of a family of modes: reads its parameters and fills the mode of that number. */
typedef enum mpm_status family_prepare(const struct measurement *m, unsigned number,
                                       struct mode *mode, struct mpm_error *error);

/* --------------------------------------------------------------- families */

static void bar_shape(const struct mode *mode, const double start[AXES], double shape[AXES])
{
    shape[0] = sin(mode->wave_number * start[0]);
    shape[1] = 0.0;
}

static enum mpm_status bar_prepare(const struct measurement *m, unsigned number, struct mode *mode,
                                   struct mpm_error *error)
{
    struct vibrating_bar bar = {.end = measurement_has(m, "free_end") ? VIBRATING_BAR_FREE
                                                                      : VIBRATING_BAR_HELD};
    const struct measurement_parameter table[] = {
        {"length", &bar.length}, {"modulus", &bar.modulus}, {"density", &bar.density}};
    (void)number; /* the first mode alone; the scene has its velocity */
    TRY(measurement_numbers(m, table, 3, error));
    mode->wave_number = vibrating_bar_wave_number(&bar);
    mode->frequency = TWO_PI / vibrating_bar_period(&bar);
    mode->shape = bar_shape;
    return MPM_OK;
}

static void cylinder_shape(const struct mode *mode, const double start[AXES], double shape[AXES])
{
    shape[0] = radial_mode_displacement(mode->wave_number, start[0]);
    shape[1] = 0.0;
}

static void disk_shape(const struct mode *mode, const double start[AXES], double shape[AXES])
{
    const double r = hypot(start[0], start[1]);
    const double u = radial_mode_displacement(mode->wave_number, r) / r;
    shape[0] = u * start[0];
    shape[1] = u * start[1];
}

/* The setting of one component of speed J1(k r) x/r, a polynomial in Horner's form: expressions
 * know no Bessel functions. */
static char *velocity_setting(int axis, const char *coordinate, const char *square, double speed,
                              double wave_number)
{
    double c[SERIES_TERMS];
    radial_mode_series(wave_number, SERIES_TERMS, c);
    char *text = g_strdup("1");
    for (size_t m = SERIES_TERMS - 1; m > 0; m--) {
        char *const inner = text;
        text = g_strdup_printf("(1%+.17g*%s*%s)", c[m] / c[m - 1], square, inner);
        g_free(inner);
    }
    char *const setting =
        g_strdup_printf("bodies.0.velocity.%d=%.17g*%s*%s", axis, speed * c[0], coordinate, text);
    g_free(text);
    return setting;
}

static enum mpm_status radial_prepare(const struct measurement *m, enum radial_mode_kind kind,
                                      unsigned number, struct mode *mode, double *speed,
                                      struct mpm_error *error)
{
    struct radial_mode_body body = {.kind = kind};
    const struct measurement_parameter table[] = {{"radius", &body.radius},
                                                  {"young", &body.young},
                                                  {"poisson", &body.poisson},
                                                  {"density", &body.density},
                                                  {"speed", speed}};
    TRY(measurement_numbers(m, table, 5, error));
    mode->wave_number = radial_mode_wave_number(&body, number);
    mode->frequency = radial_mode_frequency(&body, mode->wave_number);
    return MPM_OK;
}

static enum mpm_status cylinder_prepare(const struct measurement *m, unsigned number,
                                        struct mode *mode, struct mpm_error *error)
{
    double speed = 0.0;
    TRY(radial_prepare(m, RADIAL_MODE_CYLINDER, number, mode, &speed, error));
    mode->shape = cylinder_shape;
    mode->velocity[0] = velocity_setting(0, "r", "(r*r)", speed, mode->wave_number);
    return MPM_OK;
}

static enum mpm_status disk_prepare(const struct measurement *m, unsigned number, struct mode *mode,
                                    struct mpm_error *error)
{
    static const char *const square = "(x*x+y*y)";
    double speed = 0.0;
    TRY(radial_prepare(m, RADIAL_MODE_THIN_DISK, number, mode, &speed, error));
    mode->shape = disk_shape;
    mode->velocity[0] = velocity_setting(0, "x", square, speed, mode->wave_number);
    mode->velocity[1] = velocity_setting(1, "y", square, speed, mode->wave_number);
    return MPM_OK;
}

enum { BAR, CYLINDER, DISK, FAMILIES };
static const char *const family_names[FAMILIES] = {"bar", "cylinder", "disk"};
static family_prepare *const families[FAMILIES] = {bar_prepare, cylinder_prepare, disk_prepare};

/* ---------------------------------------------------------------- one run */

/* The amplitude of the mode, sum m v.phi / sum m phi^2, over time. */
struct projection {
    size_t count;
    double *shape; /* m phi / sum m phi^2, 2 a particle */
    double *velocity;
    double *times, *amplitudes, *energies;
    size_t samples, capacity;
};

static void project(void *context, const struct mpm_simulation *simulation,
                    const struct mpm_ledger *ledger)
{
    struct projection *const p = context;
    double sum = 0.0;
    if (p->samples == p->capacity)
        return;
    mpm_simulation_field(simulation, MPM_FIELD_VELOCITY, p->velocity);
    for (size_t k = 0; k < AXES * p->count; k++)
        sum += p->shape[k] * p->velocity[k];
    p->times[p->samples] = ledger->time;
    p->energies[p->samples] = ledger->total_energy;
    p->amplitudes[p->samples++] = sum;
}

static void open_projection(struct projection *p, const struct mode *mode,
                            const struct mpm_simulation *simulation, size_t capacity)
{
    const size_t n = mpm_simulation_particle_count(simulation);
    double square = 0.0;
    *p = (struct projection){.count = n,
                             .shape = g_new0(double, AXES *n),
                             .velocity = g_new0(double, AXES *n),
                             .times = g_new0(double, capacity),
                             .amplitudes = g_new0(double, capacity),
                             .energies = g_new0(double, capacity),
                             .capacity = capacity};
    double *const mass = g_new0(double, n);
    mpm_simulation_field(simulation, MPM_FIELD_MASS, mass);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, p->velocity);
    for (size_t k = 0; k < n; k++) {
        double *const phi = &p->shape[AXES * k];
        mode->shape(mode, &p->velocity[AXES * k], phi);
        square += mass[k] * (phi[0] * phi[0] + phi[1] * phi[1]);
    }
    for (size_t k = 0; k < AXES * n; k++)
        p->shape[k] *= mass[k / AXES] / square;
    g_free(mass);
}

static void close_projection(struct projection *p)
{
    g_free(p->shape);
    g_free(p->velocity);
    g_free(p->times);
    g_free(p->amplitudes);
    g_free(p->energies);
}

/* What one run of one mode gives. */
struct outcome {
    struct oscillation fit;
    bool fitted;
    struct follow_result follow;
    double energy_first, energy_last; /* means over the first and the last period, */
};

static enum mpm_status write_amplitudes(struct measurement *m, const char *series,
                                        const struct projection *p, struct mpm_error *error)
{
    double *const rows = g_new(double, MODE_COLUMNS * p->samples);
    for (size_t k = 0; k < p->samples; k++) {
        double *const row = &rows[MODE_COLUMNS * k];
        row[0] = p->times[k];
        row[1] = p->amplitudes[k] / p->amplitudes[0];
        row[2] = p->energies[k] / p->energies[0];
    }
    const enum mpm_status status = measurement_series(m, series, "time amplitude energy_over_start",
                                                      MODE_COLUMNS, p->samples, rows, error);
    g_free(rows);
    return status;
}

/* A run of one mode. */
struct study {
    const struct mode *mode;
    double periods;
    const char *series; /* of the amplitude, or NULL */
    struct outcome *outcome;
};

static enum mpm_status vibrate(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct study *const study = context;
    const struct mode *const mode = study->mode;
    struct outcome *const outcome = study->outcome;
    const double period = TWO_PI / mode->frequency;
    (void)scene;
    struct projection projection;
    open_projection(&projection, mode, simulation, (size_t)(SAMPLES_A_PERIOD * study->periods) + 4);
    const struct follow follow = {.measurement = m,
                                  .end = study->periods * period,
                                  .interval = period / SAMPLES_A_PERIOD,
                                  .sample = project,
                                  .context = &projection};
    enum mpm_status status = follow_run(&follow, simulation, &outcome->follow, error);
    outcome->energy_first = field_mean(projection.energies, 1, SAMPLES_A_PERIOD);
    outcome->energy_last =
        projection.samples < SAMPLES_A_PERIOD
            ? (double)NAN
            : field_mean(projection.energies + projection.samples - SAMPLES_A_PERIOD, 1,
                         SAMPLES_A_PERIOD);
    outcome->fitted = oscillation_fit(projection.samples, projection.times, projection.amplitudes,
                                      mode->frequency, &outcome->fit);
    if (status == MPM_OK && study->series != NULL)
        status = write_amplitudes(m, study->series, &projection, error);
    close_projection(&projection);
    return status;
}

/* Runs one mode on the grid of `level` (a setting, or NULL for the scene's own). */
static enum mpm_status run_mode(struct measurement *m, const struct mode *mode, const char *level,
                                const char *series, struct outcome *outcome,
                                struct mpm_error *error)
{
    const char *settings[AXES + 1];
    size_t count = 0;
    struct study study = {.mode = mode, .series = series, .outcome = outcome};
    if (level != NULL)
        settings[count++] = level;
    for (int axis = 0; axis < AXES; axis++)
        if (mode->velocity[axis] != NULL)
            settings[count++] = mode->velocity[axis];
    TRY(measurement_number(m, "periods", &study.periods, error));
    return follow_scene(m, settings, count, vibrate, &study, error);
}

/* ----------------------------------------------------------------- reports */

/* `name` or, where there are several modes, name_<number>. */
static void report(struct measurement *m, const char *name, unsigned mode, bool several,
                   double value)
{
    char *const quantity =
        several ? g_strdup_printf("%s_%u", name, mode) : g_strdup_printf("%s", name);
    measurement_report(m, quantity, value);
    g_free(quantity);
}

static double percent(double value, double exact)
{
    return 100.0 * (value / exact - 1.0);
}

/* Against what the method itself makes of the bar's mode, if the case names its order. */
static enum mpm_status report_dispersion(struct measurement *m, const struct mode *mode,
                                         const struct outcome *outcome, struct mpm_error *error)
{
    struct bar_dispersion bar = {.step = outcome->follow.time_step};
    static const char *const orders[BAR_DISPERSION_ORDERS] = {
        [BAR_DISPERSION_USL] = "usl",
        [BAR_DISPERSION_MUSL] = "musl",
        [BAR_DISPERSION_USF] = "usf",
        [BAR_DISPERSION_USAVG] = "usavg",
    };
    size_t order;
    const struct measurement_parameter table[] = {
        {"wave_speed", &bar.speed}, {"cell", &bar.cell}, {"flip", &bar.fraction}};
    TRY(measurement_choice(m, "order", orders, BAR_DISPERSION_ORDERS, &order, error));
    TRY(measurement_numbers(m, table, 3, error));
    TRY(measurement_count(m, "particles", 1, PARTICLES_MAX, &bar.particles, error));
    bar.order = (enum bar_dispersion_order)order;
    const struct bar_dispersion_result theory = bar_dispersion(&bar, mode->wave_number);
    measurement_report(m, "dispersion_error",
                       fabs(percent(outcome->fit.frequency, theory.frequency)));
    measurement_note(m, "theory of the method: frequency %+.4f %%, decay %.4g %% a period",
                     percent(theory.frequency, mode->frequency),
                     100.0 * TWO_PI / mode->frequency * theory.decay);
    return MPM_OK;
}

static void report_mode(struct measurement *m, const struct mode *mode, unsigned number,
                        bool several, const struct outcome *outcome)
{
    const struct oscillation *const fit = &outcome->fit;
    const double period = TWO_PI / mode->frequency;
    report(m, "frequency_error", number, several, percent(fit->frequency, mode->frequency));
    report(m, "frequency_bound", number, several, 100.0 * fit->bound / mode->frequency);
    report(m, "decay", number, several, 100.0 * fit->decay * period);
    report(m, "decay_size", number, several, 100.0 * fabs(fit->decay) * period);
    report(m, "energy_change", number, several,
           100.0 * fabs(outcome->energy_last / outcome->energy_first - 1.0));
    report(m, "energy_lost", number, several,
           100.0 * (1.0 - outcome->energy_last / outcome->energy_first));
    measurement_note(m,
                     "mode %u: frequency %.8g, exact %.8g, %+.4f %% with %.2g %% of the fit; "
                     "amplitude %+.3g %% a period; the fit leaves %.2g",
                     number, fit->frequency, mode->frequency,
                     percent(fit->frequency, mode->frequency), 100.0 * fit->bound / mode->frequency,
                     -100.0 * fit->decay * period, fit->residual);
}

/* One mode on the scene's grid, or on each level. */
static enum mpm_status measure_mode(struct measurement *m, const struct mode *mode, unsigned number,
                                    bool several, struct mpm_error *error)
{
    struct levels levels;
    TRY(levels_read(m, &levels, error));
    char *const series = g_strdup_printf("mode_%u", number);
    double errors[LEVELS_MAX] = {0};
    struct outcome outcome = {0};
    enum mpm_status status = MPM_OK;
    for (size_t k = 0; status == MPM_OK && k < levels_runs(&levels); k++) {
        status = run_mode(m, mode, levels.setting[k], levels.count == 0 ? series : NULL, &outcome,
                          error);
        errors[k] = fabs(percent(outcome.fit.frequency, mode->frequency));
    }
    g_free(series);
    TRY(status);
    report_mode(m, mode, number, several, &outcome);
    if (levels.count > 0) {
        char *const suffix = g_strdup_printf("_%u", number);
        status = levels_report(m, &levels, several ? suffix : "", errors, error);
        g_free(suffix);
        TRY(status);
    }
    if (measurement_has(m, "order"))
        TRY(report_dispersion(m, mode, &outcome, error));
    if (number == 1)
        follow_report(m, &outcome.follow, 0.0);
    return MPM_OK;
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    size_t family;
    unsigned modes;
    TRY(measurement_choice(m, "family", family_names, FAMILIES, &family, error));
    TRY(measurement_count(m, "modes", 1, MODES_MAX, &modes, error));
    enum mpm_status status = MPM_OK;
    for (unsigned number = 1; status == MPM_OK && number <= modes; number++) {
        struct mode mode = {0};
        status = families[family](m, number, &mode, error);
        if (status == MPM_OK)
            status = measure_mode(m, &mode, number, modes > 1, error);
        for (int axis = 0; axis < AXES; axis++)
            g_free(mode.velocity[axis]);
    }
    return status;
}

const struct measure_program program_vibration = {
    .name = "vibration",
    .summary = "frequency and decay of small vibrations against exact modes",
    .run = run,
};

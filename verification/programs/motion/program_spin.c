/* E4: a free spinning disk: angular momentum, growth, and strain that should not be there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"

#include <glib.h>
#include <math.h>

enum { AXES = 2, GRADIENT = 5, COLUMNS = 5 };

static const double TWO_PI = 6.28318530717958647692;

struct study {
    size_t count;
    double *mass, *start, *position, *gradient;
    double gyration; /* sum m r^2 at the start */
    double angle;    /* of the last sample */
    struct follow_rows rows;
};

static double gyration(const struct study *study)
{
    double sum = 0.0;
    for (size_t p = 0; p < study->count; p++) {
        const double *const x = &study->position[AXES * p];
        sum += study->mass[p] * (x[0] * x[0] + x[1] * x[1]);
    }
    return sum;
}

/* The turn that takes the start nearest to the positions, on from the last one. */
static double turned(const struct study *study)
{
    double along = 0.0, across = 0.0;
    for (size_t p = 0; p < study->count; p++) {
        const double *const a = &study->start[AXES * p], *const b = &study->position[AXES * p];
        along += study->mass[p] * (a[0] * b[0] + a[1] * b[1]);
        across += study->mass[p] * (a[0] * b[1] - a[1] * b[0]);
    }
    const double angle = atan2(across, along);
    return angle + TWO_PI * round((study->angle - angle) / TWO_PI);
}

static void look_at(void *context, const struct mpm_simulation *simulation,
                    const struct mpm_ledger *ledger)
{
    struct study *const study = context;
    double strain = 0.0, deviatoric = 0.0;
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, study->position);
    mpm_simulation_field(simulation, MPM_FIELD_DEFORMATION_GRADIENT, study->gradient);
    for (size_t p = 0; p < study->count; p++) {
        const double *const f = &study->gradient[GRADIENT * p];
        const double sum = hypot(f[0] + f[3], f[1] - f[2]); /* l1 + l2 */
        const double difference = hypot(f[0] - f[3], f[1] + f[2]);
        strain += 0.5 * log(f[0] * f[3] - f[1] * f[2]);
        deviatoric += difference * difference / (sum * sum);
    }
    study->angle = turned(study);
    const double row[COLUMNS] = {
        ledger->time, study->angle / TWO_PI, 0.5 * log(gyration(study) / study->gyration),
        strain / (double)study->count, sqrt(deviatoric / (double)study->count)};
    follow_rows_add(&study->rows, row);
}

static void open_study(struct study *study, const struct mpm_simulation *simulation)
{
    const size_t n = mpm_simulation_particle_count(simulation);
    *study = (struct study){.count = n,
                            .mass = g_new(double, n),
                            .start = g_new(double, AXES *n),
                            .position = g_new(double, AXES *n),
                            .gradient = g_new(double, GRADIENT *n),
                            .rows = {.columns = COLUMNS}};
    mpm_simulation_field(simulation, MPM_FIELD_MASS, study->mass);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, study->start);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, study->position);
    study->gyration = gyration(study);
}

static void close_study(struct study *study)
{
    g_free(study->mass);
    g_free(study->start);
    g_free(study->position);
    g_free(study->gradient);
    follow_rows_free(&study->rows);
}

/* Slope of a column over the turns by least squares, from turn `from` on. */
static double per_turn(const struct follow_rows *rows, size_t column, double from)
{
    double n = 0.0, sum_x = 0.0, sum_y = 0.0, sum_xx = 0.0, sum_xy = 0.0;
    for (size_t k = 0; k < rows->count; k++) {
        const double *const row = &rows->values[COLUMNS * k];
        if (row[1] < from)
            continue;
        n += 1.0;
        sum_x += row[1];
        sum_y += row[column];
        sum_xx += row[1] * row[1];
        sum_xy += row[1] * row[column];
    }
    return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

/* Growth over what a turn of omega dt a step would give, (omega dt)^2/2 a step: twice the growth
 * over dt times the integral of omega d(angle). Follows the spin as it changes. */
static double growth_factor(const struct follow_rows *rows, double from, double dt)
{
    double growth = 0.0, spun = 0.0;
    for (size_t k = 1; k < rows->count; k++) {
        const double *const row = &rows->values[COLUMNS * k], *const last = row - COLUMNS;
        const double angle = TWO_PI * (row[1] - last[1]);
        if (last[1] < from)
            continue;
        growth += row[2] - last[2];
        spun += angle * angle / (row[0] - last[0]);
    }
    return 2.0 * growth / (dt * spun);
}

static void report(struct measurement *m, const struct follow_rows *rows,
                   const struct follow_result *result, double from, double radius)
{
    double turns = 0.0, radius_growth = 0.0, spread = 0.0;
    const double growth = per_turn(rows, 2, from), strain = per_turn(rows, 3, from);
    for (size_t k = 0; k < rows->count; k++) { /* the last ones stay */
        turns = rows->values[COLUMNS * k + 1];
        radius_growth = rows->values[COLUMNS * k + 2];
        spread = rows->values[COLUMNS * k + 4];
    }
    measurement_report(m, "turns", turns);
    measurement_report(m, "growth", 100.0 * growth);
    measurement_report(m, "growth_factor", growth_factor(rows, from, result->time_step));
    measurement_report(m, "mismatch", 100.0 * (growth - strain));
    measurement_note(m,
                     "strain of F %.4g %% a turn; at the end the radius has grown by %.4g %%, and "
                     "F spreads by %.4g %%",
                     100.0 * strain, 100.0 * (exp(radius_growth) - 1.0), 100.0 * spread);
    follow_report(m, result, radius / sqrt(2.0)); /* L(0) of a disk */
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    const double end = mpm_scene_end_time(scene);
    (void)context;
    double spin, radius, from;
    TRY(measurement_number(m, "spin", &spin, error));
    TRY(measurement_number(m, "radius", &radius, error));
    TRY(measurement_number(m, "from", &from, error));
    struct study study;
    struct follow_result result;
    open_study(&study, simulation);
    const struct follow follow = {.measurement = m,
                                  .end = end,
                                  .interval = TWO_PI / spin / 20.0,
                                  .sample = look_at,
                                  .context = &study};
    enum mpm_status status = follow_run(&follow, simulation, &result, error);
    if (status == MPM_OK)
        status = follow_rows_check(&study.rows, error);
    if (status == MPM_OK) {
        report(m, &study.rows, &result, from, radius);
        status = measurement_series(m, "disk", "time turns growth strain spread", COLUMNS,
                                    study.rows.count, study.rows.values, error);
    }
    close_study(&study);
    return status;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    return follow_scene(measurement, NULL, 0, measure, NULL, error);
}

const struct measure_program program_spin = {
    .name = "spin",
    .summary = "a free spinning disk: angular momentum, growth, strain",
    .run = run,
};

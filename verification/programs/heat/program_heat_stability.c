/* H13: the longest stable step of explicit conduction.
 *
 * A scene with time.step and allow_unstable starts from temperatures of both signs. A step counts
 * as stable while the largest temperature stays below ten times that of the start over `steps`
 * steps. Bisection between the parameters `low` and `high`, times `unit`, the time h^2/(2 kappa) or
 * 1/(2 kappa (1/h_x^2 + 1/h_y^2)), to `width`. Over the offsets of the body in a cell, the scene's
 * setting `offset` in which %s stands for first + cell k/offsets, the least is reported: limit.
 * Series: limits (offset, limit).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"

#include <glib.h>
#include <math.h>

enum { COLUMNS = 2, OFFSETS_MAX = 100 };

struct bisection {
    double low, high, width, unit, steps;
    unsigned offsets;
    const char *offset; /* "bodies.0.region.rectangle={from: [%s, 0], ...": %s is a number */
    double first, cell; /* the number at the first offset; what it grows by to the last */
};

struct trial {
    double steps;
    bool stable;
};

static double largest(struct mpm_simulation *simulation, double *value)
{
    double found = 0.0;
    mpm_simulation_field(simulation, MPM_FIELD_TEMPERATURE, value);
    for (size_t p = 0; p < mpm_simulation_particle_count(simulation); p++)
        found = fabs(value[p]) <= found ? found : fabs(value[p]);
    return found;
}

static enum mpm_status try_step(void *context, struct measurement *m, const struct mpm_scene *scene,
                                struct mpm_simulation *simulation, struct mpm_error *error)
{
    static const double GROWN = 10.0;
    struct trial *const trial = context;
    double *const value = g_new(double, mpm_simulation_particle_count(simulation));
    const double start = largest(simulation, value);
    enum mpm_status status = MPM_OK;
    trial->stable = true;
    for (double k = 0; k < trial->steps && trial->stable && status == MPM_OK; k++) {
        status = follow_step(m, simulation, mpm_scene_end_time(scene), &trial->stable, error);
        trial->stable = trial->stable && largest(simulation, value) <= GROWN * start;
    }
    follow_count_work(m, simulation);
    g_free(value);
    return status;
}

static enum mpm_status is_stable(struct measurement *m, const struct bisection *bisection,
                                 double offset, double step, bool *stable, struct mpm_error *error)
{
    struct trial trial = {.steps = bisection->steps};
    gchar **const parts = g_strsplit(bisection->offset, "%s", -1);
    char place[G_ASCII_DTOSTR_BUF_SIZE];
    (void)g_ascii_formatd(place, sizeof place, "%.17g",
                          bisection->first + offset * bisection->cell);
    char *const settings[] = {g_strjoinv(place, parts),
                              g_strdup_printf("time.step=%.17g", step * bisection->unit)};
    const enum mpm_status status = follow_scene(m, (const char *const *)settings,
                                                G_N_ELEMENTS(settings), try_step, &trial, error);
    *stable = trial.stable;
    for (size_t k = 0; k < G_N_ELEMENTS(settings); k++)
        g_free(settings[k]);
    g_strfreev(parts);
    return status;
}

static enum mpm_status find_limit(struct measurement *m, const struct bisection *bisection,
                                  double offset, double *limit, struct mpm_error *error)
{
    double low = bisection->low, high = bisection->high;
    while (high - low > bisection->width * low) {
        const double middle = sqrt(low * high);
        bool stable;
        TRY(is_stable(m, bisection, offset, middle, &stable, error));
        *(stable ? &low : &high) = middle;
    }
    *limit = low;
    return MPM_OK;
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct bisection bisection = {.offset = NULL};
    double rows[COLUMNS * OFFSETS_MAX], least = HUGE_VAL;
    const struct measurement_parameter table[] = {
        {"low", &bisection.low},     {"high", &bisection.high},   {"width", &bisection.width},
        {"unit", &bisection.unit},   {"steps", &bisection.steps}, {"cell", &bisection.cell},
        {"first", &bisection.first},
    };
    TRY(measurement_numbers(m, table, G_N_ELEMENTS(table), error));
    TRY(measurement_count(m, "offsets", 1, OFFSETS_MAX, &bisection.offsets, error));
    TRY(measurement_text(m, "offset", &bisection.offset, error));
    for (unsigned k = 0; k < bisection.offsets; k++) {
        double *const row = rows + (size_t)(COLUMNS * k);
        row[0] = (double)k / bisection.offsets;
        TRY(find_limit(m, &bisection, row[0], &row[1], error));
        least = fmin(least, row[1]);
    }
    measurement_report(m, "limit", least);
    return measurement_series(m, "limits", "offset limit", COLUMNS, bisection.offsets, rows, error);
}

const struct measure_program program_heat_stability = {
    .name = "heat_stability",
    .summary = "the longest stable step of explicit conduction, by bisection",
    .run = run,
};

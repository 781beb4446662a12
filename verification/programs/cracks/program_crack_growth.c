/* D10: a crack that grows along a strip whose edges are drawn apart, by a toughness.
 *
 * The tip's growth is followed step by step and compared with clamped_strip.h: the energy release
 * rate of the strip over the toughness when the tip first grows, and then the place of the tip at
 * each growth, against where the strip's release rate is the toughness.
 *
 * Parameters: modulus, height, toughness, and rate, gradient, tip of struct clamped_strip.
 * Series: growth, length grown and expected over the opening.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/clamped_strip.h"
#include "verification/measures/fields.h"
#include "verification/programs/follow.h"

#include <math.h>

enum { COLUMNS = 3, FEWEST = 8 };
static const double NOTHING = 1e-17;

struct study {
    struct clamped_strip strip;
    struct follow_rows rows; /* at each growth: time, length before it, expected length */
    double onset;            /* release rate at the first one, over the toughness */
    double grown, work_error;
};

static enum mpm_status look(struct study *study, const struct mpm_simulation *simulation,
                            struct mpm_error *error)
{
    struct mpm_j_integral now;
    const double time = mpm_simulation_time(simulation);
    TRY(mpm_simulation_j_integral(simulation, 0, &now, error));
    if (now.grown == study->grown)
        return MPM_OK;
    const double expected = clamped_strip_growth(&study->strip, time);
    if (study->rows.count == 0)
        study->onset =
            clamped_strip_release(&study->strip, study->strip.tip, time) / study->strip.toughness;
    follow_rows_add(&study->rows, (const double[COLUMNS]){time, study->grown, expected});
    study->grown = now.grown;
    study->work_error = field_larger(
        study->work_error, fabs(now.dissipated / (study->strip.toughness * now.grown) - 1.0));
    return MPM_OK;
}

/* grown = slope * expected + shift, by least squares */
static void fit(const struct study *study, double *slope, double *shift)
{
    double x = 0.0, y = 0.0, above = 0.0, below = 0.0;
    const double count = (double)study->rows.count, *const rows = study->rows.values;
    for (size_t k = 0; k < study->rows.count; k++) {
        x += rows[COLUMNS * k + 2] / count;
        y += rows[COLUMNS * k + 1] / count;
    }
    for (size_t k = 0; k < study->rows.count; k++) {
        above += (rows[COLUMNS * k + 2] - x) * (rows[COLUMNS * k + 1] - y);
        below += (rows[COLUMNS * k + 2] - x) * (rows[COLUMNS * k + 2] - x);
    }
    *slope = above / below;
    *shift = y - x;
}

static void report(const struct study *study, struct measurement *m)
{
    measurement_report(m, "grown", study->grown);
    if (study->rows.count == 0) {
        measurement_inconclusive(m, "onset", "the crack did not grow");
        measurement_inconclusive(m, "work_error", "the crack did not grow");
    } else {
        measurement_report(m, "onset", study->onset);
        measurement_report(m, "work_error", study->work_error);
    }
    if (study->strip.gradient == 0.0)
        return;
    if (study->rows.count < FEWEST) {
        measurement_inconclusive(m, "slope", "the crack grew %zu times", study->rows.count);
        measurement_inconclusive(m, "shift", "the crack grew %zu times", study->rows.count);
        return;
    }
    double slope, shift;
    fit(study, &slope, &shift);
    measurement_report(m, "slope", slope);
    measurement_report(m, "shift", shift);
}

static enum mpm_status grow(void *context, struct measurement *m, const struct mpm_scene *scene,
                            struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    bool alive = true;
    while (alive && mpm_simulation_time(simulation) < mpm_scene_end_time(scene)) {
        TRY(follow_step(m, simulation, mpm_scene_end_time(scene), &alive, error));
        if (alive)
            TRY(look(study, simulation, error));
        if (study->strip.gradient == 0.0 && study->rows.count > 0)
            break; /* it would not stop */
    }
    follow_count_work(m, simulation);
    TRY(follow_rows_check(&study->rows, error));
    report(study, m);
    return measurement_series(m, "growth", "time grown expected", COLUMNS, study->rows.count,
                              study->rows.values, error);
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {.work_error = NOTHING, .rows = {.columns = COLUMNS}};
    const struct measurement_parameter table[] = {
        {"modulus", &study.strip.modulus},     {"height", &study.strip.height},
        {"toughness", &study.strip.toughness}, {"rate", &study.strip.rate},
        {"gradient", &study.strip.gradient},   {"tip", &study.strip.tip},
    };
    TRY(measurement_numbers(measurement, table, sizeof table / sizeof *table, error));
    const enum mpm_status status = follow_scene(measurement, NULL, 0, grow, &study, error);
    follow_rows_free(&study.rows);
    return status;
}

const struct measure_program program_crack_growth = {
    .name = "crack_growth",
    .summary = "growth of a crack along a clamped strip",
    .run = run,
};

/* T2c: a spinning block under tractions that turn with it: its mean stress in its own axes, its
 * angular momentum.
 *
 * The axes are those of the mean deformation gradient: the angle of its first column. The mean
 * Cauchy stress over the volume of a body at rest in these axes is that of its surface tractions,
 * whatever the distribution (mean value theorem of stress), up to the body's spin, rho omega^2 r^2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/fields.h"
#include "verification/programs/follow.h"

#include <glib.h>
#include <math.h>

enum { GRADIENT = 5, STRESS = 4, COLUMNS = 5 };
static const double DEGREES = 57.295779513082320877, TURN = 360.0;

struct study {
    size_t count;
    double *f, *stress, *volume;
    double traction, after;          /* stress that the ends bear; errors count from this time on */
    double axial, transverse, shear; /* largest errors since, over the traction */
    double angle;                    /* turned so far, degrees */
    struct follow_rows rows;
};

/* Mean stress along the block's axis, across it, and shear. */
static void look_at(void *context, const struct mpm_simulation *simulation,
                    const struct mpm_ledger *ledger)
{
    struct study *const study = context;
    double volume = 0.0, f[2] = {0.0, 0.0}, s[STRESS] = {0.0};
    mpm_simulation_field(simulation, MPM_FIELD_DEFORMATION_GRADIENT, study->f);
    mpm_simulation_field(simulation, MPM_FIELD_STRESS, study->stress);
    mpm_simulation_field(simulation, MPM_FIELD_VOLUME, study->volume);
    for (size_t p = 0; p < study->count; p++) {
        volume += study->volume[p];
        f[0] += study->f[GRADIENT * p];
        f[1] += study->f[GRADIENT * p + 2];
        for (int c = 0; c < STRESS; c++)
            s[c] += study->volume[p] * study->stress[STRESS * p + (size_t)c];
    }
    const double length = hypot(f[0], f[1]);
    const double c = f[0] / length, n = f[1] / length;
    const double over = 1.0 / (volume * study->traction);
    const double axial = over * (c * c * s[0] + n * n * s[1] + 2.0 * c * n * s[3]);
    const double transverse = over * (n * n * s[0] + c * c * s[1] - 2.0 * c * n * s[3]);
    const double shear = over * (c * n * (s[1] - s[0]) + (c * c - n * n) * s[3]);
    const double angle = DEGREES * atan2(f[1], f[0]);
    study->angle = angle + TURN * round((study->angle - angle) / TURN); /* on from the last one */
    const double row[COLUMNS] = {ledger->time, study->angle, 100.0 * axial, 100.0 * transverse,
                                 100.0 * shear};
    follow_rows_add(&study->rows, row);
    if (ledger->time < study->after)
        return;
    study->axial = field_larger(study->axial, fabs(axial - 1.0));
    study->transverse = field_larger(study->transverse, fabs(transverse));
    study->shear = field_larger(study->shear, fabs(shear));
}

static enum mpm_status report(struct measurement *m, const struct study *study,
                              const struct follow_result *result, struct mpm_error *error)
{
    const struct conservation *const conservation = &result->conservation;
    const struct {
        const char *name;
        double value;
    } table[] = {
        {"axial_error", 100.0 * study->axial},
        {"transverse", 100.0 * study->transverse},
        {"shear", 100.0 * study->shear},
        {"angle", study->angle},
        {"angular_momentum_change",
         100.0 * conservation->angular_momentum / fabs(conservation->start.angular_momentum)},
    };
    for (size_t k = 0; k < sizeof table / sizeof *table; k++)
        if (result->finished)
            measurement_report(m, table[k].name, table[k].value);
        else
            measurement_inconclusive(m, table[k].name, "the run did not come to its end");
    follow_report(m, result, 0.0);
    TRY(follow_rows_check(&study->rows, error));
    return measurement_series(m, "stress", "time angle axial transverse shear", COLUMNS,
                              study->rows.count, study->rows.values, error);
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    const double end = mpm_scene_end_time(scene);
    (void)context;
    const size_t n = mpm_simulation_particle_count(simulation);
    struct follow_result result;
    struct study study = {.count = n, .rows = {.columns = COLUMNS}};
    TRY(measurement_number(m, "traction", &study.traction, error));
    TRY(measurement_number(m, "after", &study.after, error));
    study.f = g_new(double, GRADIENT *n);
    study.stress = g_new(double, STRESS *n);
    study.volume = g_new(double, n);
    const struct follow follow = {.measurement = m,
                                  .end = end,
                                  .interval = end / 200.0,
                                  .sample = look_at,
                                  .context = &study};
    enum mpm_status status = follow_run(&follow, simulation, &result, error);
    if (status == MPM_OK)
        status = report(m, &study, &result, error);
    follow_rows_free(&study.rows);
    g_free(study.f);
    g_free(study.stress);
    g_free(study.volume);
    return status;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    return follow_scene(measurement, NULL, 0, measure, NULL, error);
}

const struct measure_program program_turning_load = {
    .name = "turning_load",
    .summary = "a spinning block under tractions that turn with it: mean stress, angular momentum",
    .run = run,
};

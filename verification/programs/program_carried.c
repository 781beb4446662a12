/* G2: a uniformly stressed block that moves through the grid at constant velocity. Exactly,
 * nothing changes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/fields.h"
#include "verification/measures/particle_set.h"
#include "verification/programs/follow.h"

#include <math.h>
#include <stdlib.h>

enum { STRESS = 4, COLUMNS = 4, LOOKS_MAX = 1000000 };

struct parameters {
    double speed;    /* of the block along x */
    double stress;   /* exact sigma_xx */
    double energy;   /* exact strain energy of the block, the scale of energies */
    double start;    /* from when on it is measured */
    double interval; /* between two samples */
};

struct study {
    struct parameters parameters;
    struct particle_set set;
    double energy_start;
    double stress_rms, stress_worst; /* largest so far, over the exact stress */
    double noise;                    /* largest so far, over the exact strain energy */
    double drift;                    /* of the total energy, largest so far */
    double *rows;
    size_t row_count;
};

static enum mpm_status read_parameters(const struct measurement *m, struct parameters *p,
                                       struct mpm_error *error)
{
    const struct measurement_parameter table[] = {
        {"speed", &p->speed}, {"stress", &p->stress},     {"energy", &p->energy},
        {"start", &p->start}, {"interval", &p->interval},
    };
    return measurement_numbers(m, table, sizeof table / sizeof *table, error);
}

/* Kinetic energy in the frame that moves with the block: sum m |v - V|^2 / 2. */
static double noise_of(const struct mpm_ledger *ledger, double speed)
{
    return ledger->kinetic_energy - speed * ledger->momentum[0] +
           0.5 * ledger->mass * speed * speed;
}

static void look(struct study *study, const struct mpm_simulation *simulation)
{
    const struct parameters *const p = &study->parameters;
    struct mpm_ledger ledger;
    mpm_simulation_ledger(simulation, &ledger);
    particle_set_read(&study->set, simulation);
    double square = 0.0, worst = 0.0;
    for (size_t k = 0; k < study->set.count; k++) {
        const double error = study->set.stress[STRESS * k] / p->stress - 1.0;
        square += error * error;
        worst = field_larger(worst, fabs(error));
    }
    const double rms = sqrt(square / (double)study->set.count);
    const double noise = noise_of(&ledger, p->speed) / p->energy;
    const double energy = ledger.total_energy - ledger.external_work;
    if (study->row_count == 0)
        study->energy_start = energy;
    const double drift = (energy - study->energy_start) / p->energy;
    study->stress_rms = field_larger(study->stress_rms, rms);
    study->stress_worst = field_larger(study->stress_worst, worst);
    study->noise = field_larger(study->noise, noise);
    study->drift = field_larger(study->drift, fabs(drift));
    const double row[COLUMNS] = {p->speed * (ledger.time - p->start), 100.0 * rms, 100.0 * noise,
                                 100.0 * drift};
    for (size_t c = 0; c < COLUMNS; c++)
        study->rows[COLUMNS * study->row_count + c] = row[c];
    study->row_count++;
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    const struct parameters *const p = &study->parameters;
    const double intervals = (mpm_scene_end_time(scene) - p->start) / p->interval;
    if (!(intervals >= 0.0 && intervals <= LOOKS_MAX))
        return failure_set(error, MPM_BAD_INPUT,
                           "case %s: parameters \"start\" and \"interval\" make %g intervals up to "
                           "the end; allowed: 0 to %d",
                           measurement_case(m), intervals, LOOKS_MAX);
    const size_t looks = (size_t)intervals + 1;
    TRY(particle_set_create(simulation, 0, &study->set, error));
    study->rows = calloc(looks * COLUMNS, sizeof *study->rows);
    if (study->rows == NULL)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for the curve");
    bool alive = true;
    for (size_t k = 0; k < looks; k++) {
        TRY(follow_to(m, simulation, p->start + p->interval * (double)k, &alive, error));
        if (!alive)
            break;
        look(study, simulation);
    }
    measurement_report(m, "distance", p->speed * (mpm_simulation_time(simulation) - p->start));
    measurement_report(m, "stress_error", 100.0 * study->stress_rms);
    measurement_note(m, "largest error of stress %.3g %%", 100.0 * study->stress_worst);
    measurement_report(m, "kinetic_noise", 100.0 * study->noise);
    measurement_report(m, "energy_drift", 100.0 * study->drift);
    follow_count_work(m, simulation);
    return measurement_series(m, "carried", "distance stress_percent noise_percent drift_percent",
                              COLUMNS, study->row_count, study->rows, error);
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {0};
    TRY(read_parameters(measurement, &study.parameters, error));
    const enum mpm_status status = follow_scene(measurement, NULL, 0, measure, &study, error);
    free(study.rows);
    particle_set_free(&study.set);
    return status;
}

const struct measure_program program_carried = {
    .name = "carried",
    .summary = "a uniformly stressed block carried through the grid, which should change nothing",
    .run = run,
};

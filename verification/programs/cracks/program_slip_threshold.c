/* D9b: a body under a uniform stress, cut through by an oblique crack with Coulomb's law: from
 * which coefficient of friction on does the crack hold?
 *
 * In a body without a crack the stress s is uniform; on a plane with the normal n it has the
 * pressure -n.s n and the shear t.s n. A crack there changes nothing as long as mu >= mu* = shear
 * over pressure; below, it slips, in an elastic body by an amount that goes with mu* - mu, as long
 * as it slips everywhere and no surface opens. The scene runs without its crack, and with each of
 * two coefficients, the fractions `low` and `high` of `exact`, mu*. The slip is measured by the
 * root mean square of the difference of displacements to the body without the crack. Reported are
 * - threshold: where the line through both slips is zero, over mu*
 * - slip: the slip at `low`, in percent of displacements
 * - held: the slip at the fraction `above`, in percent of displacements
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { AXES = 2, RUNS = 3, SETTING = 64 };

struct study {
    double exact, fractions[RUNS]; /* low, high, above */
    double *reference, *start;     /* places without the crack, at the end and at first */
    double *now;
    size_t count;
    double difference; /* of the last run, percent */
    bool finished;
};

static enum mpm_status take_memory(struct study *study, size_t count, struct mpm_error *error)
{
    study->count = count;
    study->reference = calloc(AXES * count, sizeof(double));
    study->start = calloc(AXES * count, sizeof(double));
    study->now = calloc(AXES * count, sizeof(double));
    if (study->reference == NULL || study->start == NULL || study->now == NULL)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for fields");
    return MPM_OK;
}

static enum mpm_status follow_to_end(struct study *study, struct measurement *m,
                                     const struct mpm_scene *scene,
                                     struct mpm_simulation *simulation, double *places,
                                     struct mpm_error *error)
{
    bool alive = true;
    TRY(follow_to(m, simulation, mpm_scene_end_time(scene), &alive, error));
    study->finished = study->finished && alive;
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, places);
    follow_count_work(m, simulation);
    return MPM_OK;
}

static enum mpm_status follow_intact(void *context, struct measurement *m,
                                     const struct mpm_scene *scene,
                                     struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    TRY(take_memory(study, mpm_simulation_particle_count(simulation), error));
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, study->start);
    return follow_to_end(study, m, scene, simulation, study->reference, error);
}

static enum mpm_status follow_cracked(void *context, struct measurement *m,
                                      const struct mpm_scene *scene,
                                      struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    double differences = 0.0, displacements = 0.0;
    TRY(follow_to_end(study, m, scene, simulation, study->now, error));
    for (size_t k = 0; k < AXES * study->count; k++) {
        const double difference = study->now[k] - study->reference[k];
        const double displacement = study->reference[k] - study->start[k];
        differences += difference * difference;
        displacements += displacement * displacement;
    }
    study->difference = 100.0 * sqrt(differences / displacements);
    return MPM_OK;
}

static enum mpm_status run_all(struct study *study, struct measurement *m, double slip[RUNS],
                               struct mpm_error *error)
{
    study->finished = true;
    TRY(follow_scene(m, (const char *const[]){"cracks=[]"}, 1, follow_intact, study, error));
    for (int k = 0; k < RUNS; k++) {
        char setting[SETTING];
        snprintf(setting, sizeof setting, "cracks.0.friction=%.12g",
                 study->fractions[k] * study->exact);
        TRY(follow_scene(m, (const char *const[]){setting}, 1, follow_cracked, study, error));
        slip[k] = study->difference;
    }
    return MPM_OK;
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct study study = {0};
    double slip[RUNS];
    const struct measurement_parameter numbers[] = {
        {"exact", &study.exact},
        {"low", &study.fractions[0]},
        {"high", &study.fractions[1]},
        {"above", &study.fractions[2]},
    };
    TRY(measurement_numbers(m, numbers, sizeof numbers / sizeof *numbers, error));
    const enum mpm_status status = run_all(&study, m, slip, error);
    free(study.reference);
    free(study.start);
    free(study.now);
    TRY(status);
    const double *const at = study.fractions;
    measurement_report(m, "finished", study.finished ? 1.0 : 0.0);
    measurement_report(m, "threshold", at[0] + slip[0] * (at[1] - at[0]) / (slip[0] - slip[1]));
    measurement_report(m, "slip", slip[0]);
    measurement_report(m, "held", slip[2]);
    double rows[RUNS][2];
    for (int k = 0; k < RUNS; k++) {
        rows[k][0] = at[k];
        rows[k][1] = slip[k];
    }
    return measurement_series(m, "slip", "friction/threshold slip/%", 2, RUNS, &rows[0][0], error);
}

const struct measure_program program_slip_threshold = {
    .name = "slip_threshold",
    .summary = "the coefficient of friction from which on an oblique crack holds",
    .run = run,
};

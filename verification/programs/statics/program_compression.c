/* R1, R1b, R2: a disk compressed radially against the exact homogeneous solution, N&G
 * 4.1, until a stated compression and on until it breaks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/plastic/compression.h"
#include "verification/measures/comparison/pareto.h"
#include "verification/measures/fields.h"
#include "verification/measures/particle_set.h"
#include "verification/programs/follow.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STRESS = 4, RR = 0, ZZ = 1, CURVE_COLUMNS = 8, RADIAL_COLUMNS = 3 };

struct parameters {
    double radius;       /* R0 */
    double height;       /* of the disk */
    double speed;        /* of the rim */
    double strain;       /* radial compression at which the fields are judged */
    double inner;        /* part of R0 that counts as inside */
    double sampling;     /* radial compression between two samples */
    double spread_limit; /* broken: relative deviation of J above this, */
    double volume_limit; /* or a particle with J below this part of the exact one, */
    double stress_limit; /* or the mean stress off by more than this part */
    struct compression_material material;
};

/* What is seen at one moment in a set of particles. */
struct look {
    double mean;             /* of J */
    double spread;           /* relative deviation of J */
    double smallest;         /* J over the exact J */
    double stress[2];        /* mean sigma_rr, sigma_zz */
    double error_nominal[2]; /* against the exact stress at the nominal J, */
    double error_mean[2];    /* and at the mean J; relative */
};

enum part { ALL, INNER, PARTS };

struct study {
    struct measurement *measurement;
    struct parameters parameters;
    struct mpm_simulation *simulation;
    struct particle_set set;
    size_t count[PARTS]; /* the inner particles come first */
    double strain;       /* now */
    struct look look[PARTS];
    double broken[PARTS]; /* volume compression in % at which the part broke; 0: not yet */
    double start_energy;
    double judged_spread; /* of J over all particles at the stated strain */
    bool judged;          /* the stated strain was reached */
    double *curve;
    size_t curve_rows, curve_capacity;
};

static enum mpm_status read_parameters(const struct measurement *m, struct parameters *p,
                                       struct mpm_error *error)
{
    const struct measurement_parameter table[] = {
        {"radius", &p->radius},
        {"height", &p->height},
        {"speed", &p->speed},
        {"strain", &p->strain},
        {"inner", &p->inner},
        {"sampling", &p->sampling},
        {"spread_limit", &p->spread_limit},
        {"volume_limit", &p->volume_limit},
        {"stress_limit", &p->stress_limit},
        {"bulk", &p->material.bulk},
        {"shear", &p->material.shear},
    };
    TRY(measurement_numbers(m, table, sizeof table / sizeof *table, error));
    if (p->sampling > 0.0)
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT,
                       "case %s: parameter \"sampling\" is %g; allowed: above 0",
                       measurement_case(m), p->sampling);
}

static double relative_error(double value, double exact)
{
    return fabs(value / exact - 1.0);
}

static struct look look_at(const struct study *study, size_t count)
{
    const struct particle_set *const set = &study->set;
    const double nominal = compression_relative_volume(-study->strain);
    struct look look = {
        .mean = field_mean(set->relative_volume, 1, count),
        .spread = field_relative_deviation(set->relative_volume, 1, count),
        .smallest = HUGE_VAL,
        .stress = {field_mean(set->stress + RR, STRESS, count),
                   field_mean(set->stress + ZZ, STRESS, count)},
    };
    for (size_t k = 0; k < count; k++)
        look.smallest = fmin(look.smallest, set->relative_volume[k] / nominal);
    const struct compression_stress at_nominal =
        compression_stress(&study->parameters.material, nominal);
    const struct compression_stress at_mean =
        compression_stress(&study->parameters.material, look.mean);
    const double exact_nominal[2] = {at_nominal.rr, at_nominal.zz};
    const double exact_mean[2] = {at_mean.rr, at_mean.zz};
    for (int c = 0; c < 2; c++) {
        look.error_nominal[c] = relative_error(look.stress[c], exact_nominal[c]);
        look.error_mean[c] = relative_error(look.stress[c], exact_mean[c]);
    }
    return look;
}

static double volume_compression(double strain)
{
    return 100.0 * (1.0 - compression_relative_volume(-strain));
}

static bool is_broken(const struct parameters *p, const struct look *look)
{
    return !(look->spread <= p->spread_limit) || !(look->smallest >= p->volume_limit) ||
           !(look->error_mean[RR] <= p->stress_limit);
}

static enum mpm_status keep_row(struct study *study, struct mpm_error *error)
{
    if (study->curve_rows == study->curve_capacity) {
        const size_t capacity = study->curve_capacity == 0 ? 1024 : 2 * study->curve_capacity;
        double *const grown =
            realloc(study->curve, capacity * CURVE_COLUMNS * sizeof *study->curve);
        if (grown == NULL)
            return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for the curve");
        study->curve = grown;
        study->curve_capacity = capacity;
    }
    const double nominal = compression_relative_volume(-study->strain);
    const struct compression_stress exact =
        compression_stress(&study->parameters.material, nominal);
    const double row[CURVE_COLUMNS] = {
        study->strain,
        100.0 * nominal,
        study->look[ALL].stress[RR],
        study->look[ALL].stress[ZZ],
        exact.rr,
        exact.zz,
        100.0 * study->look[ALL].spread,
        100.0 * study->look[INNER].spread,
    };
    for (size_t c = 0; c < CURVE_COLUMNS; c++)
        study->curve[study->curve_rows * CURVE_COLUMNS + c] = row[c];
    study->curve_rows++;
    return MPM_OK;
}

static enum mpm_status look_now(struct study *study, struct mpm_error *error)
{
    study->strain =
        study->parameters.speed * mpm_simulation_time(study->simulation) / study->parameters.radius;
    particle_set_read(&study->set, study->simulation);
    for (int part = 0; part < PARTS; part++) {
        study->look[part] = look_at(study, study->count[part]);
        if (study->broken[part] == 0.0 && study->strain > study->parameters.sampling &&
            is_broken(&study->parameters, &study->look[part]))
            study->broken[part] = volume_compression(study->strain);
    }
    return study->broken[ALL] == 0.0 ? keep_row(study, error) : MPM_OK;
}

/* Energy: strain energy per radian over the exact density N&G (64) times the volume
 * R0^2/2 height, and the work of ring and supports over the energy gained. */
static void report_energy(struct study *study)
{
    const struct parameters *const p = &study->parameters;
    const double stretch[3] = {1.0 - study->strain, 1.0, 1.0 - study->strain};
    const double volume = 0.5 * p->radius * p->radius * p->height;
    struct mpm_ledger ledger;
    mpm_simulation_ledger(study->simulation, &ledger);
    measurement_report(study->measurement, "strain_energy",
                       100.0 * ledger.strain_energy /
                           (volume * compression_energy(&p->material, stretch)));
    const double gained = ledger.total_energy - study->start_energy;
    measurement_report(study->measurement, "work", 100.0 * ledger.external_work / gained);
    measurement_report(study->measurement, "energy_drift",
                       100.0 * (gained - ledger.external_work) / ledger.external_work);
}

/* A disk that broke before the stated strain has no fields there. */
static void report_unjudged(struct study *study)
{
    static const char *const quantities[] = {"strain_energy",
                                             "work",
                                             "energy_drift",
                                             "interior_sd_j",
                                             "all_sd_j",
                                             "mean_j_error",
                                             "interior_rr_at_mean",
                                             "interior_zz_at_mean",
                                             "interior_rr_at_nominal",
                                             "all_rr_at_nominal"};
    for (size_t k = 0; k < sizeof quantities / sizeof *quantities; k++)
        measurement_inconclusive(study->measurement, quantities[k],
                                 "it ended at %.4g %% compression, before the fields are judged",
                                 volume_compression(study->strain));
}

/* The worst error of J among the particles next to the axis. */
static double innermost_error(const struct study *study)
{
    const struct particle_set *const set = &study->set;
    const double nominal = compression_relative_volume(-study->strain);
    double nearest = HUGE_VAL, error = 0.0;
    for (size_t k = 0; k < set->count; k++)
        nearest = fmin(nearest, set->start[2 * k]);
    for (size_t k = 0; k < set->count; k++)
        if (set->start[2 * k] <= nearest * (1.0 + 1e-9))
            error = field_larger(error, relative_error(set->relative_volume[k], nominal));
    return error;
}

static enum mpm_status report_fields(struct study *study, struct mpm_error *error)
{
    struct measurement *const m = study->measurement;
    const struct look *const all = &study->look[ALL], *const inner = &study->look[INNER];
    measurement_report(m, "interior_sd_j", 100.0 * inner->spread);
    measurement_report(m, "all_sd_j", 100.0 * all->spread);
    measurement_report(m, "innermost_j_error", 100.0 * innermost_error(study));
    measurement_report(m, "mean_j_error",
                       100.0 *
                           relative_error(all->mean, compression_relative_volume(-study->strain)));
    measurement_report(m, "interior_rr_at_mean", 100.0 * inner->error_mean[RR]);
    measurement_report(m, "interior_zz_at_mean", 100.0 * inner->error_mean[ZZ]);
    measurement_report(m, "interior_rr_at_nominal", 100.0 * inner->error_nominal[RR]);
    measurement_report(m, "all_rr_at_nominal", 100.0 * all->error_nominal[RR]);
    double *const rows = malloc(study->set.count * RADIAL_COLUMNS * sizeof *rows);
    if (rows == NULL)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for the radial profile");
    for (size_t k = 0; k < study->set.count; k++) {
        rows[RADIAL_COLUMNS * k] = study->set.start[2 * k];
        rows[RADIAL_COLUMNS * k + 1] = study->set.start[2 * k + 1];
        rows[RADIAL_COLUMNS * k + 2] = 100.0 * study->set.relative_volume[k];
    }
    const enum mpm_status status = measurement_series(
        m, "profile", "r0 z0 J_percent", RADIAL_COLUMNS, study->set.count, rows, error);
    free(rows);
    return status;
}

static void report_breakdown(struct study *study, double last_strain, bool alive)
{
    static const char *const quantity[PARTS] = {"breakdown_all", "breakdown_interior"};
    for (int part = 0; part < PARTS; part++) {
        if (study->broken[part] == 0.0 && !alive)
            study->broken[part] = volume_compression(last_strain);
        if (study->broken[part] > 0.0)
            measurement_report(study->measurement, quantity[part], study->broken[part]);
        else
            measurement_inconclusive(study->measurement, quantity[part],
                                     "not broken at %.4g %% compression, where the run ends",
                                     volume_compression(last_strain));
    }
    const double reached = volume_compression(last_strain);
    measurement_report(study->measurement, "reached", reached);
    measurement_report(study->measurement, "unbroken_to",
                       study->broken[ALL] > 0.0 ? study->broken[ALL] : reached);
}

static enum mpm_status follow(struct study *study, double end, struct mpm_error *error)
{
    const struct parameters *const p = &study->parameters;
    const double unit = p->radius / p->speed; /* time to a strain of one */
    bool alive = true;
    struct mpm_ledger ledger;
    TRY(look_now(study, error));
    mpm_simulation_ledger(study->simulation, &ledger);
    study->start_energy = ledger.total_energy;
    for (size_t k = 1; alive && study->broken[ALL] * study->broken[INNER] == 0.0; k++) {
        double time = unit * p->sampling * (double)k;
        const bool last = time >= end;
        TRY(follow_to(study->measurement, study->simulation, last ? end : time, &alive, error));
        if (!alive)
            break;
        TRY(look_now(study, error));
        if (!study->judged && study->strain >= p->strain * (1.0 - 1e-9)) {
            study->judged = true;
            study->judged_spread = study->look[ALL].spread;
            report_energy(study);
            TRY(report_fields(study, error));
        }
        if (last)
            break;
    }
    if (!study->judged)
        report_unjudged(study);
    report_breakdown(study, p->speed * mpm_simulation_time(study->simulation) / p->radius, alive);
    follow_count_work(study->measurement, study->simulation);
    return measurement_series(study->measurement, "curve",
                              "strain J_percent rr zz exact_rr exact_zz sd_all_percent "
                              "sd_interior_percent",
                              CURVE_COLUMNS, study->curve_rows, study->curve, error);
}

/* Scene, simulation and particles of a study, with one more setting unless NULL. */
static enum mpm_status open_study(struct study *study, const char *setting,
                                  struct mpm_scene **scene, struct mpm_error *error)
{
    const struct parameters *const p = &study->parameters;
    TRY(measurement_scene(study->measurement, &setting, setting == NULL ? 0 : 1, scene, error));
    TRY(mpm_simulation_create(*scene, measurement_options(study->measurement), &study->simulation,
                              error));
    TRY(particle_set_create(study->simulation, 0, &study->set, error));
    study->count[ALL] = study->set.count;
    study->count[INNER] = particle_set_inner_first(&study->set, p->inner * p->radius);
    return MPM_OK;
}

static void close_study(struct study *study, struct mpm_scene *scene)
{
    free(study->curve);
    particle_set_free(&study->set);
    mpm_simulation_free(study->simulation);
    mpm_scene_free(scene);
}

/* A run to the stated strain on another grid. */
struct level {
    double spread; /* relative deviation of J over all particles; NaN if it broke before */
    double particle_steps, seconds; /* of the processor */
};

static enum mpm_status run_level(struct measurement *measurement, const struct parameters *p,
                                 const char *setting, struct level *level, struct mpm_error *error)
{
    struct study study = {.measurement = measurement, .parameters = *p};
    struct mpm_scene *scene = NULL;
    bool alive = true;
    enum mpm_status status = open_study(&study, setting, &scene, error);
    const double start = measurement_processor_seconds();
    if (status == MPM_OK)
        status = follow_to(measurement, study.simulation, p->strain * p->radius / p->speed, &alive,
                           error);
    if (status == MPM_OK) {
        *level = (struct level){
            .particle_steps = (double)mpm_simulation_step(study.simulation) *
                              (double)mpm_simulation_particle_count(study.simulation),
            .seconds = measurement_processor_seconds() - start,
        };
        status = look_now(&study, error);
    }
    level->spread = alive && !is_broken(p, &study.look[ALL]) ? study.look[ALL].spread : (double)NAN;
    close_study(&study, scene);
    return status;
}

/* Rate at which the deviation falls from a coarser grid to this one. */
static enum mpm_status report_rate(struct study *study, struct mpm_error *error)
{
    const char *coarser;
    double ratio;
    struct level coarse;
    TRY(measurement_text(study->measurement, "coarser", &coarser, error));
    TRY(measurement_number(study->measurement, "ratio", &ratio, error));
    TRY(run_level(study->measurement, &study->parameters, coarser, &coarse, error));
    measurement_report(study->measurement, "rate",
                       log(coarse.spread / study->judged_spread) / log(ratio));
    return MPM_OK;
}

/* ------------------------------------------------------------ cost at matched error */

enum { LEVELS_MAX = 8 };

static void report_cost(struct measurement *m, const char *quantity,
                        const struct pareto_point *ladder, size_t count, double error)
{
    const struct pareto_cost cost = pareto_cost_to_reach(ladder, count, error);
    if (cost.reach != PARETO_NOT_REACHED) {
        measurement_report(m, quantity, cost.cost);
        if (cost.reach == PARETO_AT_MOST)
            measurement_note(m, "%s is an upper bound: the coarsest grid that runs is good enough",
                             quantity);
    } else {
        measurement_inconclusive(
            m, quantity, "no grid of the ladder comes down to a spread of %g %%", 100.0 * error);
    }
}

/* What it costs to bring the deviation of J over all particles down to `error`: particle-steps
 * and processor time over a ladder of grids, interpolated between two of them. */
static enum mpm_status report_ladder(struct measurement *m, const struct parameters *p,
                                     struct mpm_error *error)
{
    const char *refinements;
    double threshold;
    struct pareto_point steps[LEVELS_MAX], seconds[LEVELS_MAX];
    size_t count = 0;
    TRY(measurement_text(m, "ladder", &refinements, error));
    TRY(measurement_number(m, "threshold", &threshold, error));
    for (const char *rest = refinements; *rest != '\0';) {
        char *end, setting[64];
        const unsigned long refine = strtoul(rest, &end, 10);
        if (end == rest || refine == 0 || count == LEVELS_MAX)
            return failure_set(error, MPM_BAD_INPUT,
                               "parameter \"ladder\": \"%s\": allowed are 1 to %d refinements "
                               "parted by blanks",
                               refinements, LEVELS_MAX);
        rest = end + strspn(end, " ");
        snprintf(setting, sizeof setting, "grid.refine=%lu", refine);
        struct level level = {.spread = (double)NAN};
        TRY(run_level(m, p, setting, &level, error));
        steps[count] = (struct pareto_point){level.particle_steps, level.spread};
        seconds[count++] = (struct pareto_point){level.seconds, level.spread};
    }
    report_cost(m, "cost_steps", steps, count, threshold);
    report_cost(m, "cost_seconds", seconds, count, threshold);
    return MPM_OK;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {.measurement = measurement};
    struct mpm_scene *scene = NULL;
    TRY(read_parameters(measurement, &study.parameters, error));
    enum mpm_status status = open_study(&study, NULL, &scene, error);
    if (status == MPM_OK)
        status = follow(&study, mpm_scene_end_time(scene), error);
    if (status == MPM_OK && measurement_has(measurement, "coarser"))
        status = report_rate(&study, error);
    if (status == MPM_OK && measurement_has(measurement, "ladder"))
        status = report_ladder(measurement, &study.parameters, error);
    close_study(&study, scene);
    return status;
}

const struct measure_program program_compression = {
    .name = "compression",
    .summary = "radial compression of a disk against its exact solution, until it breaks",
    .run = run,
};

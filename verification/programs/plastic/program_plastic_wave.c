/* P6: a bar in uniaxial strain hits a wall faster than it can stop elastically; both fronts and the
 * states behind them against plastic_wave.h.
 *
 * Parameters: bulk, shear, density, yield, hardening, speed; time of the measurement. Places are
 * those of the undeformed bar, of its first row of particles, ids along it.
 *
 * With C the celerity of a front and t the time, reports
 *   precursor_place    the place where the pressure falls below half of the elastic limit, % of C t
 *   plastic_place      where it falls below the mean of both states, % of C t of the plastic front
 *   limit              mean pressure between the fronts, from 30 to 70 % of the way, % of sigma_Y
 *   pressure, lateral, plastic   mean between 10 and 80 % of the plastic front's way, % of exact
 *   stopped            what the bar has lost of its speed there, mean, % of V
 *   error_l1           integral of |pressure - exact| over the bar, % of that of the exact pressure
 *   overshoot          largest pressure over the exact one behind the plastic front, less one, %
 *   balance            % of plastic_dissipation that total_energy less external work has lost
 * finished, and orders of error_l1 over levels (levels.h). Series: profile.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/plastic/plastic_wave.h"
#include "verification/measures/particle_set.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>

enum { STRESS = 4, AXES = 2, COLUMNS = 6 };

struct problem {
    struct plastic_wave wave;
    struct plastic_wave_fronts fronts;
    double time;
};

/* Along the row. */
struct profile {
    size_t count;
    double *x, *pressure, *lateral, *plastic, *speed;
};

struct study {
    const struct problem *problem;
    struct profile profile;
    double balance;
    bool finished;
};

static const struct plastic_wave_state *state_at(const struct problem *p, double x)
{
    static const struct plastic_wave_state still = {.pressure = 0.0};
    const struct plastic_wave_fronts *const fronts = &p->fronts;
    return x < fronts->plastic.celerity * p->time     ? &fronts->plastic
           : x < fronts->precursor.celerity * p->time ? &fronts->precursor
                                                      : &still;
}

/* --------------------------------------------------------------------- reading */

static void free_profile(struct profile *profile)
{
    g_free(profile->x);
    g_free(profile->pressure);
    g_free(profile->lateral);
    g_free(profile->plastic);
    g_free(profile->speed);
    *profile = (struct profile){0};
}

static double *column_of(struct particle_set *set, const struct mpm_simulation *simulation,
                         enum mpm_field field, size_t components)
{
    double *const column = g_new(double, set->count);
    mpm_simulation_field(simulation, field, set->all);
    for (size_t k = 0; k < set->count; k++)
        column[k] = set->all[components * set->index[k]];
    return column;
}

static enum mpm_status read_profile(const struct mpm_simulation *simulation,
                                    struct profile *profile, struct mpm_error *error)
{
    struct particle_set set;
    TRY(particle_set_create(simulation, 0, &set, error));
    particle_set_read(&set, simulation);
    free_profile(profile);
    *profile = (struct profile){
        .x = g_new(double, set.count),
        .pressure = g_new(double, set.count),
        .lateral = g_new(double, set.count),
        .plastic = column_of(&set, simulation, MPM_FIELD_PLASTIC_STRAIN, 1),
        .speed = column_of(&set, simulation, MPM_FIELD_VELOCITY, AXES),
    };
    for (size_t k = 0; k < set.count; k++) {
        if (k > 0 && set.start[AXES * k] < set.start[AXES * (k - 1)])
            break;
        profile->x[k] = set.start[AXES * k];
        profile->pressure[k] = -set.stress[STRESS * k];
        profile->lateral[k] = -set.stress[STRESS * k + 1];
        profile->count = k + 1;
    }
    particle_set_free(&set);
    return MPM_OK;
}

/* ------------------------------------------------------------------- measuring */

/* Where the pressure last falls below `level`, by a straight line between particles. */
static double place_of(const struct profile *profile, double level)
{
    for (size_t k = profile->count; k-- > 1;)
        if (profile->pressure[k - 1] >= level) {
            const double part = (profile->pressure[k - 1] - level) /
                                (profile->pressure[k - 1] - profile->pressure[k]);
            return profile->x[k - 1] + part * (profile->x[k] - profile->x[k - 1]);
        }
    return (double)NAN;
}

static double mean_between(const struct profile *profile, const double *column, double from,
                           double to)
{
    double sum = 0.0, count = 0.0;
    for (size_t k = 0; k < profile->count; k++)
        if (profile->x[k] >= from && profile->x[k] <= to) {
            sum += column[k];
            count += 1.0;
        }
    return sum / count;
}

static double error_l1(const struct problem *p, const struct profile *profile)
{
    double sum = 0.0, all = 0.0;
    for (size_t k = 0; k < profile->count; k++) {
        const double exact = state_at(p, profile->x[k])->pressure;
        sum += fabs(profile->pressure[k] - exact);
        all += exact;
    }
    return 100.0 * sum / all;
}

static double highest_of(const struct profile *profile)
{
    double highest = 0.0;
    for (size_t k = 0; k < profile->count; k++)
        highest = fmax(highest, profile->pressure[k]);
    return highest;
}

static enum mpm_status write_profile(struct measurement *m, const struct problem *p,
                                     const struct profile *profile, struct mpm_error *error)
{
    double *const rows = g_new(double, COLUMNS * profile->count);
    for (size_t k = 0; k < profile->count; k++) {
        const struct plastic_wave_state *const exact = state_at(p, profile->x[k]);
        const double row[COLUMNS] = {profile->x[k],   profile->pressure[k], profile->lateral[k],
                                     exact->pressure, exact->lateral,       profile->plastic[k]};
        for (size_t c = 0; c < COLUMNS; c++)
            rows[COLUMNS * k + c] = row[c];
    }
    const enum mpm_status status =
        measurement_series(m, "profile", "x pressure lateral exact exact_lateral plastic", COLUMNS,
                           profile->count, rows, error);
    g_free(rows);
    return status;
}

/* --------------------------------------------------------------------- running */

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    struct mpm_ledger start, now;
    (void)scene;
    mpm_simulation_ledger(simulation, &start);
    study->finished = true;
    TRY(follow_to(m, simulation, study->problem->time, &study->finished, error));
    follow_count_work(m, simulation);
    mpm_simulation_ledger(simulation, &now);
    study->balance = 100.0 * (start.total_energy - now.total_energy + now.external_work) /
                     now.plastic_dissipation;
    return read_profile(simulation, &study->profile, error);
}

static void report(struct measurement *m, const struct problem *p, const struct study *study)
{
    const struct profile *const profile = &study->profile;
    const struct plastic_wave_state *const first = &p->fronts.precursor, *const last =
                                                                             &p->fronts.plastic;
    const double way = first->celerity * p->time, slow = last->celerity * p->time;
    const double from = 0.1 * slow, to = 0.8 * slow, missing = study->finished ? 0.0 : (double)NAN;
    const struct {
        const char *name;
        double value, exact;
    } table[] = {
        {"precursor_place", place_of(profile, 0.5 * first->pressure), way},
        {"plastic_place", place_of(profile, 0.5 * (first->pressure + last->pressure)), slow},
        {"limit",
         mean_between(profile, profile->pressure, slow + 0.3 * (way - slow),
                      slow + 0.7 * (way - slow)),
         first->pressure},
        {"pressure", mean_between(profile, profile->pressure, from, to), last->pressure},
        {"lateral", mean_between(profile, profile->lateral, from, to), last->lateral},
        {"plastic", mean_between(profile, profile->plastic, from, to), last->plastic},
        {"stopped", p->wave.speed + mean_between(profile, profile->speed, from, to), p->wave.speed},
        {"overshoot", highest_of(profile) - last->pressure, last->pressure},
        {"error_l1", error_l1(p, profile), 100.0},
        {"balance", study->balance, 100.0},
    };
    for (size_t k = 0; k < G_N_ELEMENTS(table); k++)
        levels_report_value(m, table[k].name, "",
                            missing + 100.0 * table[k].value / table[k].exact);
    measurement_report(m, "finished", study->finished ? 1.0 : 0.0);
}

static enum mpm_status read_problem(const struct measurement *m, struct problem *problem,
                                    struct mpm_error *error)
{
    struct plastic_wave *const wave = &problem->wave;
    const struct measurement_parameter list[] = {
        {"bulk", &wave->bulk},   {"shear", &wave->shear},         {"density", &wave->density},
        {"yield", &wave->yield}, {"hardening", &wave->hardening}, {"speed", &wave->speed},
        {"time", &problem->time}};
    TRY(measurement_numbers(m, list, G_N_ELEMENTS(list), error));
    problem->fronts = plastic_wave_fronts(wave);
    return problem->fronts.precursor.remaining > 0.0
               ? MPM_OK
               : failure_set(error, MPM_BAD_INPUT, "speed %g does not make the bar yield",
                             wave->speed);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct problem problem;
    struct levels levels;
    struct study study = {.problem = &problem};
    double errors[LEVELS_MAX] = {0.0};
    TRY(read_problem(m, &problem, error));
    TRY(levels_read(m, &levels, error));
    enum mpm_status status = MPM_OK;
    for (size_t k = 0; k < levels_runs(&levels) && status == MPM_OK; k++) {
        status =
            follow_scene(m, &levels.setting[k], levels.count > 0 ? 1 : 0, measure, &study, error);
        if (status == MPM_OK)
            errors[k] = study.finished ? error_l1(&problem, &study.profile) : (double)NAN;
    }
    if (status == MPM_OK) {
        report(m, &problem, &study);
        status = write_profile(m, &problem, &study.profile, error);
    }
    if (status == MPM_OK && levels.count > 0)
        status = levels_report(m, &levels, "", errors, error);
    free_profile(&study.profile);
    return status;
}

const struct measure_program program_plastic_wave = {
    .name = "plastic_wave",
    .summary = "an elastic precursor and a plastic front: places, levels, what is behind them",
    .run = run,
};

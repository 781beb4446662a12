/* P9: a rod penetrates a target and erodes: nose and tail over time, against Alekseevskii and
 * Tate's model.
 *
 * The scene has the rod, body 0, below z = 0 and the target, body 1, above it. Parameters: length,
 * speed, rod_density, target_density; row, the height of a row of particles on the scene's own grid
 * (levels halve it); strength_1, resistance_1 up to _3, the pairs of the model; early, late, times
 * at which places are reported, and late_tail, up to which the tail is held against the model.
 *
 * The nose is the z above which lies as much mass of the rod as in half a row; the tail is the
 * median z of its last row: single particles of the debris do not count. Reports
 *   nose_early, nose_late       of the first pair's nose, %
 *   nose_envelope               at `late`: outside of the range of all pairs, % of it; 0 inside
 *   nose_speed                  mean between early and late, % of the first pair's
 *   speed_envelope              as nose_envelope, of these means
 *   tail_off                    largest distance from the first pair's up to late_tail, % of the
 *                               tail's way there
 *   tail_last                   distance from the first pair's at the end, % of the tail's way
 * there nose_last                   at late_tail, of the first pair's nose, % depth largest nose,
 * in the scene's unit lost                        loss of total_energy at the end, % of that at the
 * start plastic, viscous            parts of the ledger, % of the kinetic energy at the start
 *   parted                      pairs of neighbours without a common node at the end
 *   nose_step                   change of the nose at `late` from the last but one of the levels, %
 *   peak                        largest equivalent stress at early, late and the end, in the
 *                               scene's unit
 *   reached                     time at which the run ended, % of the scene's end
 * and finished. Series: course (time nose tail, of the run, then of each pair), energies (% of the
 * kinetic energy at the start: kinetic; elastic, what the pressure has stored included; heat, by
 * viscosity and the part `heating` of plastic work; cold, the rest of that work; friction; lost),
 * and particles_1 to _3 (r z stress body) at early, late and the end, the stress von Mises'.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/plastic/alekseevskii_tate.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>

enum { AXES = 2, STRESS = 4, PAIRS = 3, COURSE = 3 + 2 * PAIRS, PICTURES = 3, DOTS = 4 };
enum { ENERGIES = 7 };
enum { SAMPLES = 120 };

struct study {
    struct penetration pair[PAIRS];
    double row, early, late, late_tail, heating;
    double energy;     /* kinetic, at the start */
    size_t count, rod; /* particles, and those of the rod, which come first */
    double *x, *stress, *mass, *body;
    size_t *order, *tail; /* of the rod; the last row's */
    size_t tail_count;
    double height; /* of a row on this level */
    double nose_early, nose_late, nose_before, depth, tail_off, nose, tail_place;
    double tail_last, nose_last;
    double lost, plastic, viscous, peak, reached, parted;
    bool finished;
    struct follow_rows course, energies, picture[PICTURES];
};

/* --------------------------------------------------------------------- places */

static const double *sorted_by; /* of compare alone */

static int compare(const void *a, const void *b)
{
    const double x = sorted_by[AXES * *(const size_t *)a + 1];
    const double y = sorted_by[AXES * *(const size_t *)b + 1];
    return (x > y) - (x < y);
}

static void sort_by_z(const struct study *study, size_t *list, size_t count)
{
    sorted_by = study->x;
    qsort(list, count, sizeof *list, compare);
}

/* The z above which lies half a row's mass of the rod. */
static double nose_of(struct study *study)
{
    double whole = 0.0, above = 0.0;
    for (size_t k = 0; k < study->rod; k++)
        whole += study->mass[study->order[k]];
    const double wanted = 0.5 * whole * study->height / study->pair[0].length;
    sort_by_z(study, study->order, study->rod);
    for (size_t k = study->rod; k-- > 0;) {
        above += study->mass[study->order[k]];
        if (above >= wanted)
            return study->x[AXES * study->order[k] + 1];
    }
    return (double)NAN;
}

static double tail_of(struct study *study)
{
    sort_by_z(study, study->tail, study->tail_count);
    const size_t middle = study->tail_count / 2;
    return study->x[AXES * study->tail[middle] + 1] - 0.5 * study->height;
}

static void read_fields(struct study *study, const struct mpm_simulation *simulation)
{
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, study->x);
    mpm_simulation_field(simulation, MPM_FIELD_STRESS, study->stress);
    mpm_simulation_field(simulation, MPM_FIELD_MASS, study->mass);
    mpm_simulation_field(simulation, MPM_FIELD_BODY, study->body);
}

/* ------------------------------------------------------------------- sampling */

static double equivalent(const double s[STRESS])
{
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
    return sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * s[3] * s[3]);
}

static void take_picture(struct study *study, int which)
{
    for (size_t k = 0; k < study->count; k++) {
        const double stress = equivalent(&study->stress[STRESS * k]);
        const double dot[DOTS] = {study->x[AXES * k], study->x[AXES * k + 1], stress,
                                  study->body[k]};
        study->peak = fmax(study->peak, stress);
        follow_rows_add(&study->picture[which], dot);
    }
}

static void add_energies(struct study *study, const struct mpm_ledger *ledger)
{
    const double part = 100.0 / study->energy, plastic = ledger->plastic_dissipation;
    const double heat = ledger->viscous_dissipation + study->heating * plastic;
    const double row[ENERGIES] = {
        ledger->time,
        part * ledger->kinetic_energy,
        part * ledger->strain_energy,
        part * heat,
        part * (1.0 - study->heating) * plastic,
        part * ledger->contact_dissipated,
        100.0 - part * ledger->total_energy,
    };
    follow_rows_add(&study->energies, row);
}

static void look_at(void *context, const struct mpm_simulation *simulation,
                    const struct mpm_ledger *ledger)
{
    struct study *const study = context;
    double row[COURSE] = {ledger->time};
    read_fields(study, simulation);
    study->nose = row[1] = nose_of(study);
    study->tail_place = row[2] = tail_of(study);
    for (int k = 0; k < PAIRS; k++) {
        const struct penetration_state model = penetration_at(&study->pair[k], ledger->time);
        row[3 + 2 * k] = model.nose;
        row[4 + 2 * k] = model.tail;
    }
    study->depth = fmax(study->depth, row[1]);
    if (ledger->time > 0.0)
        study->tail_last = 100.0 * fabs(row[2] - row[4]) / (row[4] + study->pair[0].length);
    if (ledger->time > 0.0 && ledger->time <= study->late_tail) {
        study->tail_off = fmax(study->tail_off, study->tail_last);
        study->nose_last = 100.0 * row[1] / row[3];
    }
    follow_rows_add(&study->course, row);
    add_energies(study, ledger);
}

/* ------------------------------------------------------------------- running */

static void begin(struct study *study, const struct mpm_simulation *simulation)
{
    study->count = mpm_simulation_particle_count(simulation);
    study->x = g_new(double, AXES * study->count);
    study->stress = g_new(double, STRESS * study->count);
    study->mass = g_new(double, study->count);
    study->body = g_new(double, study->count);
    study->order = g_new(size_t, study->count);
    study->tail = g_new(size_t, study->count);
    read_fields(study, simulation);
    double last = HUGE_VAL;
    study->rod = study->tail_count = 0;
    for (size_t k = 0; k < study->count; k++)
        if (study->body[k] == 0.0) {
            study->order[study->rod++] = k;
            last = fmin(last, study->x[AXES * k + 1]);
        }
    for (size_t k = 0; k < study->rod; k++)
        if (study->x[AXES * study->order[k] + 1] < last + 0.5 * study->height)
            study->tail[study->tail_count++] = study->order[k];
}

static void close_study(struct study *study)
{
    g_free(study->x);
    g_free(study->stress);
    g_free(study->mass);
    g_free(study->body);
    g_free(study->order);
    g_free(study->tail);
    study->x = study->stress = study->mass = study->body = NULL;
    study->order = study->tail = NULL;
    follow_rows_free(&study->course);
    study->course = (struct follow_rows){.columns = COURSE};
    follow_rows_free(&study->energies);
    study->energies = (struct follow_rows){.columns = ENERGIES};
    for (int k = 0; k < PICTURES; k++) {
        follow_rows_free(&study->picture[k]);
        study->picture[k] = (struct follow_rows){.columns = DOTS};
    }
}

static void read_ledger(struct study *study, const struct mpm_simulation *simulation,
                        const struct mpm_ledger *start)
{
    struct mpm_ledger now;
    mpm_simulation_ledger(simulation, &now);
    const double energy = start->kinetic_energy;
    study->lost = 100.0 * (start->total_energy - now.total_energy) / energy;
    study->plastic = 100.0 * now.plastic_dissipation / energy;
    study->viscous = 100.0 * now.viscous_dissipation / energy;
    study->parted = (double)now.parted_pairs;
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    const double end = mpm_scene_end_time(scene);
    const double stops[PICTURES] = {study->early, study->late, end};
    double *const nose[PICTURES] = {&study->nose_early, &study->nose_late, NULL};
    struct mpm_ledger start;
    struct follow_result result = {.finished = true};
    begin(study, simulation);
    mpm_simulation_ledger(simulation, &start);
    study->energy = start.kinetic_energy;
    for (int k = 0; k < PICTURES && result.finished; k++) {
        const struct follow follow = {.measurement = m,
                                      .end = stops[k],
                                      .interval = end / SAMPLES,
                                      .sample = look_at,
                                      .context = study};
        if (stops[k] > mpm_simulation_time(simulation))
            TRY(follow_run(&follow, simulation, &result, error));
        take_picture(study, k);
        if (nose[k] != NULL)
            *nose[k] = result.finished ? study->nose : (double)NAN;
    }
    study->finished = result.finished;
    study->reached = 100.0 * mpm_simulation_time(simulation) / end;
    read_ledger(study, simulation, &start);
    return MPM_OK;
}

/* -------------------------------------------------------------------- results */

/* How far outside of the range of the models' numbers, % of its nearest end. */
static double outside(double value, const double model[PAIRS])
{
    double low = model[0], high = model[0];
    for (int k = 1; k < PAIRS; k++) {
        low = fmin(low, model[k]);
        high = fmax(high, model[k]);
    }
    if (isnan(value))
        return (double)NAN;
    return 100.0 * fmax(0.0, fmax(value / high - 1.0, 1.0 - value / low));
}

static void report(struct measurement *m, const struct study *study, size_t runs)
{
    double early[PAIRS], late[PAIRS], speed[PAIRS];
    for (int k = 0; k < PAIRS; k++) {
        early[k] = penetration_at(&study->pair[k], study->early).nose;
        late[k] = penetration_at(&study->pair[k], study->late).nose;
        speed[k] = (late[k] - early[k]) / (study->late - study->early);
    }
    const double mean = (study->nose_late - study->nose_early) / (study->late - study->early);
    const struct {
        const char *name;
        double value;
    } table[] = {
        {"nose_early", 100.0 * study->nose_early / early[0]},
        {"nose_late", 100.0 * study->nose_late / late[0]},
        {"nose_envelope", outside(study->nose_late, late)},
        {"nose_speed", 100.0 * mean / speed[0]},
        {"speed_envelope", outside(mean, speed)},
        {"tail_off", study->tail_off},
        {"tail_last", study->tail_last},
        {"nose_last", study->nose_last},
        {"depth", study->depth},
        {"lost", study->lost},
        {"plastic", study->plastic},
        {"viscous", study->viscous},
        {"parted", study->parted},
        {"peak", study->peak},
        {"nose_step", 100.0 * fabs(study->nose_late / study->nose_before - 1.0)},
    };
    for (size_t k = 0; k < G_N_ELEMENTS(table) - (runs > 1 ? 0 : 1); k++)
        levels_report_value(m, table[k].name, "", table[k].value);
    measurement_report(m, "reached", study->reached);
    measurement_report(m, "finished", study->finished ? 1.0 : 0.0);
}

static enum mpm_status write_series(struct measurement *m, const struct study *study,
                                    struct mpm_error *error)
{
    TRY(follow_rows_check(&study->course, error));
    TRY(measurement_series(m, "course", "time nose tail nose_1 tail_1 nose_2 tail_2 nose_3 tail_3",
                           COURSE, study->course.count, study->course.values, error));
    TRY(follow_rows_check(&study->energies, error));
    TRY(measurement_series(m, "energies", "time kinetic elastic heat cold friction lost", ENERGIES,
                           study->energies.count, study->energies.values, error));
    for (int k = 0; k < PICTURES; k++) {
        char name[32];
        (void)g_snprintf(name, sizeof name, "particles_%d", k + 1);
        TRY(follow_rows_check(&study->picture[k], error));
        if (study->picture[k].count > 0)
            TRY(measurement_series(m, name, "r z stress body", DOTS, study->picture[k].count,
                                   study->picture[k].values, error));
    }
    return MPM_OK;
}

static enum mpm_status read_problem(const struct measurement *m, struct study *study,
                                    struct mpm_error *error)
{
    struct penetration *const p = study->pair;
    const struct measurement_parameter table[] = {
        {"length", &p[0].length},
        {"speed", &p[0].speed},
        {"rod_density", &p[0].rod_density},
        {"target_density", &p[0].target_density},
        {"row", &study->row},
        {"early", &study->early},
        {"late", &study->late},
        {"late_tail", &study->late_tail},
        {"heating", &study->heating},
    };
    TRY(measurement_numbers(m, table, G_N_ELEMENTS(table), error));
    for (int k = PAIRS; k-- > 0;) {
        char strength[32], resistance[32];
        p[k] = p[0];
        (void)g_snprintf(strength, sizeof strength, "strength_%d", k + 1);
        (void)g_snprintf(resistance, sizeof resistance, "resistance_%d", k + 1);
        TRY(measurement_number(m, strength, &p[k].strength, error));
        TRY(measurement_number(m, resistance, &p[k].resistance, error));
    }
    return MPM_OK;
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct levels levels;
    struct study study = {.course = {.columns = COURSE}, .energies = {.columns = ENERGIES}};
    TRY(read_problem(m, &study, error));
    TRY(levels_read(m, &levels, error));
    const size_t runs = levels_runs(&levels);
    enum mpm_status status = MPM_OK;
    study.nose_late = (double)NAN;
    for (size_t k = 0; k < runs && status == MPM_OK; k++) {
        study.nose_before = study.nose_late;
        study.nose_early = study.nose_late = (double)NAN;
        study.depth = study.tail_off = study.peak = 0.0;
        study.height = study.row / (double)(1 << k);
        close_study(&study);
        status =
            follow_scene(m, &levels.setting[k], levels.count > 0 ? 1 : 0, measure, &study, error);
        if (status == MPM_OK)
            measurement_note(m, "grid %zu: nose %.5g and %.5g, tail off %.3g %%, depth %.5g%s",
                             k + 1, study.nose_early, study.nose_late, study.tail_off, study.depth,
                             study.finished ? "" : ", when it ended");
    }
    if (status == MPM_OK) {
        report(m, &study, runs);
        status = write_series(m, &study, error);
    }
    close_study(&study);
    return status;
}

const struct measure_program program_penetration = {
    .name = "penetration",
    .summary = "a rod penetrates a target: nose and tail over time, depth, energy",
    .run = run,
};

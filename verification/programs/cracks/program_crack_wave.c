/* D6b: J integrals while waves pass the tip of a crack, with the terms of inertia and without.
 *
 * The scene's crack gets two J integrals for each of the sizes in `contours`, around its end. A
 * wave of tension starts `distance` from the crack at t = 0; J and K_I are held against those of a
 * long crack (verification/exact/cracks/struck_crack.h) from the time `from` after it has arrived,
 * how far they are from contour to contour J from `from` on and K_I from `early` on.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/cracks/struck_crack.h"
#include "verification/programs/follow.h"

#include <glib.h>
#include <math.h>

/* Columns of the series: time, J and K_I of the exact solution; J and then K_I of each contour,
 * with inertia and without. */
enum { CONTOURS_MAX = 4, KINDS = 2, J_FIRST = 3, COLUMNS = J_FIRST + 2 * KINDS * CONTOURS_MAX };

/* With inertia, and without. */
static const struct kind {
    const char *name, *setting;
} KINDS_OF_J[KINDS] = {{"", ""}, {"_static", ", dynamic: false"}};

struct study {
    struct struck_crack crack;
    double arrival, from, early, plane_modulus;
    double contours[CONTOURS_MAX]; /* cells */
    size_t contour_count;
    /* Of J and K_I with inertia: how many, sums of them over the exact ones */
    double values, ratio, mode_one;
    double spread[KINDS], intensity_spread[KINDS]; /* largest so far, of J and K_I */
    double mode_two;                               /* largest so far, of K_II over the exact K_I */
    struct follow_rows rows;
    enum mpm_status status; /* of the samples */
    struct mpm_error error;
};

static enum mpm_status read_study(const struct measurement *m, struct study *study,
                                  double *interval, struct mpm_error *error)
{
    double distance;
    const struct measurement_parameter numbers[] = {
        {"modulus", &study->crack.modulus},
        {"poisson", &study->crack.poisson},
        {"density", &study->crack.density},
        {"stress", &study->crack.stress},
        {"rise", &study->crack.rise},
        {"distance", &distance},
        {"from", &study->from},
        {"early", &study->early},
        {"interval", interval},
    };
    TRY(measurement_numbers(m, numbers, G_N_ELEMENTS(numbers), error));
    TRY(measurement_list(m, "contours", CONTOURS_MAX, study->contours, &study->contour_count,
                         error));
    study->arrival = distance / struck_crack_celerity(&study->crack);
    study->plane_modulus =
        study->crack.modulus / (1.0 - study->crack.poisson * study->crack.poisson);
    return MPM_OK;
}

/* "cracks.0.j_integral=[...]"; g_free it. */
static char *setting_of(const struct study *study)
{
    GString *text = g_string_new("cracks.0.j_integral=[");
    for (size_t kind = 0; kind < KINDS; kind++)
        for (size_t k = 0; k < study->contour_count; k++)
            g_string_append_printf(text, "{contour: %g%s}, ", study->contours[k],
                                   KINDS_OF_J[kind].setting);
    g_string_append_c(text, ']');
    return g_string_free(text, FALSE);
}

/* Least and largest of a few values. */
struct range {
    double least, largest;
};

static void widen(struct range *range, double value)
{
    range->least = fmin(range->least, value);
    range->largest = fmax(range->largest, value);
}

static double width_of(const struct range *range)
{
    return 100.0 * (range->largest - range->least);
}

/* One contour with inertia, at a time that counts. */
static void count_one(struct study *study, const struct mpm_j_integral *value, double exact)
{
    const double *const k = value->stress_intensity;
    study->ratio += value->j[0] * study->plane_modulus / (exact * exact);
    study->mode_one += k[0] / exact;
    study->mode_two = fmax(study->mode_two, 100.0 * fabs(k[1] / exact));
    study->values += 1.0;
}

static void look_at(struct study *study, const struct mpm_simulation *simulation, double time,
                    size_t kind, double row[COLUMNS])
{
    const double exact = struck_crack_intensity(&study->crack, time);
    const double release = exact * exact / study->plane_modulus;
    struct range j = {HUGE_VAL, -HUGE_VAL}, mode_one = {HUGE_VAL, -HUGE_VAL};
    for (size_t k = 0; k < study->contour_count; k++) {
        const size_t index = kind * study->contour_count + k;
        struct mpm_j_integral value = {0};
        if (study->status == MPM_OK)
            study->status = mpm_simulation_j_integral(simulation, index, &value, &study->error);
        row[J_FIRST + index] = value.j[0];
        row[J_FIRST + KINDS * study->contour_count + index] = value.stress_intensity[0];
        widen(&j, value.j[0] / release);
        widen(&mode_one, value.stress_intensity[0] / exact);
        if (time >= study->from && kind == 0)
            count_one(study, &value, exact);
    }
    if (time >= study->from)
        study->spread[kind] = fmax(study->spread[kind], width_of(&j));
    if (time >= study->early)
        study->intensity_spread[kind] = fmax(study->intensity_spread[kind], width_of(&mode_one));
}

static void look(void *context, const struct mpm_simulation *simulation,
                 const struct mpm_ledger *ledger)
{
    struct study *const study = context;
    const double time = ledger->time - study->arrival;
    const double exact = struck_crack_intensity(&study->crack, time);
    double row[COLUMNS] = {time, exact * exact / study->plane_modulus, exact};
    for (size_t kind = 0; kind < KINDS && study->status == MPM_OK; kind++)
        look_at(study, simulation, time, kind, row);
    follow_rows_add(&study->rows, row);
}

static enum mpm_status report(const struct study *study, struct measurement *m, bool finished,
                              struct mpm_error *error)
{
    measurement_report(m, "finished", finished ? 1.0 : 0.0);
    measurement_report(m, "j_ratio", study->ratio / study->values);
    measurement_report(m, "k_1", study->mode_one / study->values);
    measurement_report(m, "k_2", study->mode_two);
    for (size_t kind = 0; kind < KINDS; kind++) {
        char *const name = g_strconcat("spread", KINDS_OF_J[kind].name, NULL);
        char *const intensity = g_strconcat("k_1_spread", KINDS_OF_J[kind].name, NULL);
        measurement_report(m, name, study->spread[kind]);
        measurement_report(m, intensity, study->intensity_spread[kind]);
        g_free(intensity);
        g_free(name);
    }
    TRY(follow_rows_check(&study->rows, error));
    return measurement_series(
        m, "waves",
        "time, exact J and K_I; J of each contour, the same without inertia; K_I likewise",
        study->rows.columns, study->rows.count, study->rows.values, error);
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct follow *const follow = context;
    struct study *const study = follow->context;
    struct follow_result result;
    follow->measurement = m;
    follow->end = mpm_scene_end_time(scene);
    TRY(follow_run(follow, simulation, &result, error));
    if (study->status != MPM_OK)
        *error = study->error;
    return study->status != MPM_OK ? study->status : report(study, m, result.finished, error);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct study study = {.status = MPM_OK};
    struct follow follow = {.sample = look, .context = &study};
    TRY(read_study(m, &study, &follow.interval, error));
    study.rows.columns = J_FIRST + 2 * KINDS * study.contour_count;
    char *const setting = setting_of(&study);
    const enum mpm_status status =
        follow_scene(m, (const char *const[]){setting}, 1, measure, &follow, error);
    g_free(setting);
    follow_rows_free(&study.rows);
    return status;
}

const struct measure_program program_crack_wave = {
    .name = "crack_wave",
    .summary = "J, K_I and K_II while waves pass the tip of a crack, with inertia and without",
    .run = run,
};

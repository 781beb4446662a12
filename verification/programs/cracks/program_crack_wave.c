/* D6b: J integrals while waves pass the tip of a crack, with the terms of inertia and without.
 *
 * The scene's crack gets two J integrals for each of the sizes in `contours`, around its end. A
 * wave of tension starts `distance` from the crack at t = 0; J is held against that of a long crack
 * (verification/exact/struck_crack.h) from the time `from` after it has arrived.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/struck_crack.h"
#include "verification/programs/follow.h"

#include <glib.h>
#include <math.h>

enum { CONTOURS_MAX = 4, KINDS = 2, FIXED = 2, COLUMNS = FIXED + KINDS * CONTOURS_MAX };

/* With inertia, and without. */
static const struct kind {
    const char *name, *setting;
} KINDS_OF_J[KINDS] = {{"", ""}, {"_static", ", dynamic: false"}};

struct study {
    struct struck_crack crack;
    double arrival, from, plane_modulus;
    double contours[CONTOURS_MAX]; /* cells */
    size_t contour_count;
    double values, ratio; /* of J with inertia: how many, sum of it over the exact one */
    double spread[KINDS]; /* largest so far, of J over the exact one */
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

static void look(void *context, const struct mpm_simulation *simulation,
                 const struct mpm_ledger *ledger)
{
    struct study *const study = context;
    const double time = ledger->time - study->arrival;
    const double exact = struck_crack_intensity(&study->crack, time);
    const double release = exact * exact / study->plane_modulus;
    const bool counts = time >= study->from;
    double row[COLUMNS] = {time, release};
    for (size_t kind = 0; kind < KINDS && study->status == MPM_OK; kind++) {
        double least = HUGE_VAL, largest = -HUGE_VAL;
        for (size_t k = 0; k < study->contour_count; k++) {
            const size_t index = kind * study->contour_count + k;
            struct mpm_j_integral value = {0};
            if (study->status == MPM_OK)
                study->status = mpm_simulation_j_integral(simulation, index, &value, &study->error);
            row[FIXED + index] = value.j[0];
            least = fmin(least, value.j[0]);
            largest = fmax(largest, value.j[0]);
            if (counts && kind == 0) {
                study->ratio += value.j[0] / release;
                study->values += 1.0;
            }
        }
        if (counts)
            study->spread[kind] = fmax(study->spread[kind], 100.0 * (largest - least) / release);
    }
    follow_rows_add(&study->rows, row);
}

static enum mpm_status report(const struct study *study, struct measurement *m, bool finished,
                              struct mpm_error *error)
{
    measurement_report(m, "finished", finished ? 1.0 : 0.0);
    measurement_report(m, "j_ratio", study->ratio / study->values);
    for (size_t kind = 0; kind < KINDS; kind++) {
        char *const name = g_strconcat("spread", KINDS_OF_J[kind].name, NULL);
        measurement_report(m, name, study->spread[kind]);
        g_free(name);
    }
    TRY(follow_rows_check(&study->rows, error));
    return measurement_series(m, "waves", "time exact, J of each contour, the same without inertia",
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
    study.rows.columns = FIXED + KINDS * study.contour_count;
    char *const setting = setting_of(&study);
    const enum mpm_status status =
        follow_scene(m, (const char *const[]){setting}, 1, measure, &follow, error);
    g_free(setting);
    follow_rows_free(&study.rows);
    return status;
}

const struct measure_program program_crack_wave = {
    .name = "crack_wave",
    .summary = "J integrals while waves pass the tip of a crack, with inertia and without",
    .run = run,
};

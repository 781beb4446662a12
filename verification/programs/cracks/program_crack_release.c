/* D6d: the energy that a crack releases, found twice: by the J integral, and as the difference of
 * the strain energies of bodies with a shorter and with a longer crack.
 *
 * At constant loads a linear elastic body at rest has the strain energy U(a) with dU = J dA, the
 * area dA being that by which the crack is longer: per unit of thickness, or per radian, r da.
 * Three scenes run to rest: that of the case, and those with its settings `shorter` and `longer`,
 * whose tips are as far from that of the first on both sides. By Simpson's rule U(longer) -
 * U(shorter) = step/3 (J_- r_- + 4 J r + J_+ r_+), with r = 1 in planar scenes. Reported is the
 * right side over the left one, for each form of J and in the mean of `contours`, and how far J of
 * the case's scene is from contour to contour; and the same, `_modes`, with (K_I^2 + K_II^2)/E' in
 * the place of J, E' the `modulus` of plane strain.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"

#include <glib.h>
#include <math.h>

enum { CONTOURS_MAX = 16, FORMS_MAX = 3, MODES = FORMS_MAX, LENGTHS = 3, COLUMNS = 1 + FORMS_MAX };

static const struct form {
    const char *name, *key; /* of quantities; of the scene, "" in planar ones */
} PLANAR_FORMS[] = {{"", ""}}, CURVED_FORMS[] = {{"_bergkvist_huong", ", form: bergkvist_huong"},
                                                 {"_broberg", ", form: broberg"},
                                                 {"_contour", ", form: contour"}};

/* A crack of one length. */
struct body {
    double energy, tip[2];
    double j[FORMS_MAX + 1][CONTOURS_MAX]; /* the last, MODES, by K_I and K_II */
};

struct study {
    enum mpm_geometry geometry;
    double modulus;
    const struct form *forms;
    size_t form_count, contour_count;
    double contours[CONTOURS_MAX]; /* cells */
    struct body bodies[LENGTHS];   /* shorter, that of the scene, longer */
    struct body *now;
    bool finished;
};

/* ------------------------------------------------------------------- running */

/* "cracks.0.j_integral=[...]"; g_free it. */
static char *setting_of(const struct study *study)
{
    GString *text = g_string_new("cracks.0.j_integral=[");
    for (size_t form = 0; form < study->form_count; form++)
        for (size_t k = 0; k < study->contour_count; k++)
            g_string_append_printf(text, "{contour: %g%s}, ", study->contours[k],
                                   study->forms[form].key);
    g_string_append_c(text, ']');
    return g_string_free(text, FALSE);
}

static enum mpm_status follow(void *context, struct measurement *m, const struct mpm_scene *scene,
                              struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    struct body *const body = study->now;
    struct mpm_ledger ledger;
    bool finished;
    TRY(follow_to_rest(m, simulation, mpm_scene_end_time(scene), &finished, error));
    study->finished = study->finished && finished;
    mpm_simulation_ledger(simulation, &ledger);
    body->energy = ledger.strain_energy;
    for (size_t form = 0; form < study->form_count; form++)
        for (size_t k = 0; k < study->contour_count; k++) {
            struct mpm_j_integral value;
            TRY(mpm_simulation_j_integral(simulation, form * study->contour_count + k, &value,
                                          error));
            const double *const intensity = value.stress_intensity;
            body->j[form][k] = value.j[0];
            body->j[MODES][k] =
                (intensity[0] * intensity[0] + intensity[1] * intensity[1]) / study->modulus;
            body->tip[0] = value.tip[0];
            body->tip[1] = value.tip[1];
        }
    return MPM_OK;
}

static enum mpm_status run_bodies(struct study *study, struct measurement *m, const char *contours,
                                  struct mpm_error *error)
{
    const char *shorter, *longer;
    TRY(measurement_text(m, "shorter", &shorter, error));
    TRY(measurement_text(m, "longer", &longer, error));
    const char *const points[LENGTHS] = {shorter, NULL, longer};
    study->finished = true;
    for (size_t k = 0; k < LENGTHS; k++) {
        const char *const settings[] = {contours, points[k]};
        study->now = &study->bodies[k];
        TRY(follow_scene(m, settings, points[k] == NULL ? 1 : 2, follow, study, error));
    }
    return MPM_OK;
}

/* ----------------------------------------------------------------- reporting */

/* J of a contour over the three lengths, by Simpson's rule, over the difference of energies. */
static double release_of(const struct study *study, size_t form, size_t contour)
{
    const struct body *const bodies = study->bodies;
    const double step =
        0.5 * hypot(bodies[2].tip[0] - bodies[0].tip[0], bodies[2].tip[1] - bodies[0].tip[1]);
    static const double weights[LENGTHS] = {1.0, 4.0, 1.0};
    double sum = 0.0;
    for (size_t k = 0; k < LENGTHS; k++) {
        const double radius = study->geometry == MPM_AXISYMMETRIC ? bodies[k].tip[0] : 1.0;
        sum += weights[k] * radius * bodies[k].j[form][contour];
    }
    return step / 3.0 * sum / (bodies[2].energy - bodies[0].energy);
}

static void report_form(struct measurement *m, const struct study *study, size_t form,
                        const char *name)
{
    double least = HUGE_VAL, largest = -HUGE_VAL, mean = 0.0;
    for (size_t k = 0; k < study->contour_count; k++) {
        const double release = release_of(study, form, k);
        least = fmin(least, release);
        largest = fmax(largest, release);
        mean += release / (double)study->contour_count;
    }
    char *const ratio = g_strconcat("release", name, NULL);
    char *const spread = g_strconcat("spread", name, NULL);
    measurement_report(m, ratio, mean);
    measurement_report(m, spread, 100.0 * (largest - least) / mean);
    g_free(ratio);
    g_free(spread);
}

static enum mpm_status write_series(struct measurement *m, const struct study *study,
                                    struct mpm_error *error)
{
    double rows[CONTOURS_MAX][COLUMNS] = {{0.0}};
    for (size_t k = 0; k < study->contour_count; k++) {
        rows[k][0] = study->contours[k];
        for (size_t form = 0; form < study->form_count; form++)
            rows[k][1 + form] = release_of(study, form, k);
    }
    return measurement_series(m, "contours", "contour release release release", COLUMNS,
                              study->contour_count, &rows[0][0], error);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct study study = {0};
    const struct measurement_parameter numbers[] = {{"modulus", &study.modulus}};
    TRY(measurement_geometry(m, &study.geometry, error));
    TRY(measurement_numbers(m, numbers, G_N_ELEMENTS(numbers), error));
    TRY(measurement_list(m, "contours", CONTOURS_MAX, study.contours, &study.contour_count, error));
    const bool curved = study.geometry == MPM_AXISYMMETRIC;
    study.forms = curved ? CURVED_FORMS : PLANAR_FORMS;
    study.form_count = curved ? FORMS_MAX : 1;
    char *const contours = setting_of(&study);
    const enum mpm_status status = run_bodies(&study, m, contours, error);
    g_free(contours);
    TRY(status);
    measurement_report(m, "finished", study.finished ? 1.0 : 0.0);
    for (size_t form = 0; form < study.form_count; form++)
        report_form(m, &study, form, study.forms[form].name);
    report_form(m, &study, MODES, "_modes");
    return write_series(m, &study, error);
}

const struct measure_program program_crack_release = {
    .name = "crack_release",
    .summary = "J and K of a crack at rest against the difference of energies of two lengths",
    .run = run,
};

/* D6: J integrals and stress intensities of a crack at rest, along contours of several sizes,
 * against handbook values.
 *
 * The scene's crack gets a J integral for each of the sizes in `contours`, around its end; in
 * axisymmetry one for each form, too. Reported are, per form, J of each contour over the handbook's
 * value, how far they are from each other, and the means of J and K_I.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/cracks/cantilever_crack.h"
#include "verification/exact/cracks/centre_crack.h"
#include "verification/exact/cracks/penny_crack.h"
#include "verification/programs/follow.h"

#include <glib.h>
#include <math.h>

enum { CONTOURS_MAX = 16, FORMS_MAX = 3, COLUMNS = 2 + 2 * FORMS_MAX };

static const struct form {
    const char *name, *key; /* of quantities; of the scene, NULL in planar ones */
} PLANAR_FORMS[] = {{"", NULL}}, CURVED_FORMS[] = {{"_bergkvist_huong", "bergkvist_huong"},
                                                   {"_broberg", "broberg"},
                                                   {"_contour", "contour"}};

struct study {
    double modulus, poisson;      /* E', nu of the plane */
    double stress, length, width; /* of the handbook's formula */
    double intensity;             /* K_I of the handbook */
    const struct form *forms;
    size_t form_count;
    double contours[CONTOURS_MAX]; /* cells */
    size_t contour_count;
    double j[FORMS_MAX][CONTOURS_MAX], k[FORMS_MAX][CONTOURS_MAX][2];
    bool finished;
};

/* ------------------------------------------------------------------ handbook */

static double beam(const struct study *study)
{
    const struct cantilever_crack crack = {study->length, study->width, study->stress,
                                           study->modulus, study->poisson};
    return sqrt(study->modulus * cantilever_crack_release(&crack));
}

static double plate(const struct study *study)
{
    return centre_crack_tada(&(struct centre_crack){study->length, study->width, study->stress});
}

static double penny(const struct study *study)
{
    return penny_crack_cylinder(&(struct penny_crack){study->length, study->width, study->stress});
}

static const char *const REFERENCES[] = {"beam", "plate", "penny"};
static double (*const INTENSITIES[])(const struct study *) = {beam, plate, penny};
enum { PENNY = 2 };

/* ------------------------------------------------------------------- running */

static enum mpm_status read_study(const struct measurement *m, struct study *study,
                                  struct mpm_error *error)
{
    const struct measurement_parameter numbers[] = {
        {"modulus", &study->modulus}, {"poisson", &study->poisson}, {"stress", &study->stress},
        {"length", &study->length},   {"width", &study->width},
    };
    size_t reference;
    TRY(measurement_numbers(m, numbers, sizeof numbers / sizeof *numbers, error));
    TRY(measurement_choice(m, "reference", REFERENCES, sizeof REFERENCES / sizeof *REFERENCES,
                           &reference, error));
    study->intensity = INTENSITIES[reference](study);
    study->forms = reference == PENNY ? CURVED_FORMS : PLANAR_FORMS;
    study->form_count = reference == PENNY ? FORMS_MAX : 1;
    return measurement_list(m, "contours", CONTOURS_MAX, study->contours, &study->contour_count,
                            error);
}

/* "cracks.0.j_integral=[...]"; g_free it. */
static char *setting_of(const struct study *study)
{
    GString *text = g_string_new("cracks.0.j_integral=[");
    for (size_t form = 0; form < study->form_count; form++)
        for (size_t k = 0; k < study->contour_count; k++) {
            const char *const key = study->forms[form].key;
            g_string_append_printf(text, "{contour: %g%s%s}, ", study->contours[k],
                                   key == NULL ? "" : ", form: ", key == NULL ? "" : key);
        }
    g_string_append_c(text, ']');
    return g_string_free(text, FALSE);
}

static enum mpm_status follow(void *context, struct measurement *m, const struct mpm_scene *scene,
                              struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    TRY(follow_to_rest(m, simulation, mpm_scene_end_time(scene), &study->finished, error));
    measurement_report(m, "reached", mpm_simulation_time(simulation));
    for (size_t form = 0; form < study->form_count; form++)
        for (size_t k = 0; k < study->contour_count; k++) {
            struct mpm_j_integral value;
            TRY(mpm_simulation_j_integral(simulation, form * study->contour_count + k, &value,
                                          error));
            study->j[form][k] = value.j[0];
            for (int mode = 0; mode < 2; mode++)
                study->k[form][k][mode] = value.stress_intensity[mode];
        }
    return MPM_OK;
}

/* ----------------------------------------------------------------- reporting */

static void report_one(struct measurement *m, const char *what, const char *form, double value)
{
    char *const name = g_strconcat(what, form, NULL);
    measurement_report(m, name, value);
    g_free(name);
}

static void report_form(struct measurement *m, const struct study *study, size_t form)
{
    const char *const name = study->forms[form].name;
    const double release = study->intensity * study->intensity / study->modulus;
    double least = HUGE_VAL, largest = -HUGE_VAL, sum = 0.0, intensity = 0.0, sliding = 0.0;
    for (size_t k = 0; k < study->contour_count; k++) {
        const double j = study->j[form][k];
        char *const contour = g_strdup_printf("%s_%g", name, study->contours[k]);
        report_one(m, "j_ratio", contour, j / release);
        g_free(contour);
        least = fmin(least, j);
        largest = fmax(largest, j);
        sum += j;
        intensity += study->k[form][k][0];
        sliding = fmax(sliding, fabs(study->k[form][k][1]));
    }
    const double count = (double)study->contour_count;
    report_one(m, "spread", name, 100.0 * (largest - least) / (sum / count));
    report_one(m, "j_mean", name, sum / count / release);
    report_one(m, "k_ratio", name, intensity / count / study->intensity);
    report_one(m, "mode_two", name, 100.0 * sliding / study->intensity);
}

static enum mpm_status write_series(struct measurement *m, const struct study *study,
                                    struct mpm_error *error)
{
    const double release = study->intensity * study->intensity / study->modulus;
    double rows[CONTOURS_MAX][COLUMNS] = {{0.0}};
    for (size_t k = 0; k < study->contour_count; k++) {
        rows[k][0] = study->contours[k];
        rows[k][1] = study->length / study->width;
        for (size_t form = 0; form < study->form_count; form++) {
            rows[k][2 + 2 * form] = study->j[form][k] / release;
            rows[k][3 + 2 * form] = study->k[form][k][0] / study->intensity;
        }
    }
    return measurement_series(m, "contours", "contour a/W J K J K J K", COLUMNS,
                              study->contour_count, &rows[0][0], error);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct study study = {0};
    TRY(read_study(m, &study, error));
    char *const setting = setting_of(&study);
    const enum mpm_status status =
        follow_scene(m, (const char *const[]){setting}, 1, follow, &study, error);
    g_free(setting);
    TRY(status);
    measurement_report(m, "finished", study.finished ? 1.0 : 0.0);
    for (size_t form = 0; form < study.form_count; form++)
        report_form(m, &study, form);
    return write_series(m, &study, error);
}

const struct measure_program program_fracture = {
    .name = "fracture",
    .summary = "J integrals and stress intensities of a crack at rest against handbook values",
    .run = run,
};

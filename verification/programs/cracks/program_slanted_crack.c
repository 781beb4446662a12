/* D6c: stress intensities of both modes, at both tips of a crack that lies across the grid, at
 * rest, against the exact ones of the plate.
 *
 * The scene is a plate of 2 `width` by 2 `height` with its crack in the middle, of half length
 * `length` at `angle` degrees to x, under tension `stress` along y; plane stress. The crack gets a
 * J integral for each of the sizes in `contours` around each of its tips. Reported are, over the
 * exact values, the means of J, K_I and K_II of all of them; and, in percent of the mean, how far J
 * is from contour to contour (of one tip) and from tip to tip. Beside the solver's K_I and K_II are
 * those of the suite: its own interaction integral over the particles around the tips, from `inner`
 * to `outer` (interaction_integral.h), and how far the two are apart at a tip, in percent of the
 * exact K_I.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/cracks/slanted_crack.h"
#include "verification/measures/interaction_integral.h"
#include "verification/programs/follow.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>

enum { CONTOURS_MAX = 16, TIPS = 2, MODES = 2, COLUMNS = 9, ERRORS = 1 + 2 * MODES };

static const char *const TIP_NAMES[TIPS] = {"end", "start"};

struct study {
    double modulus, poisson;
    struct slanted_crack crack;
    struct slanted_crack_intensity exact;
    double contours[CONTOURS_MAX]; /* cells */
    size_t contour_count;
    struct mpm_j_integral found[TIPS][CONTOURS_MAX];
    double inner, outer;             /* of the interaction integral */
    double interaction[TIPS][MODES]; /* K_I, K_II */
    bool finished;
};

static enum mpm_status read_study(const struct measurement *m, struct study *study,
                                  struct mpm_error *error)
{
    double degrees;
    const struct measurement_parameter numbers[] = {
        {"modulus", &study->modulus},
        {"poisson", &study->poisson},
        {"stress", &study->crack.stress},
        {"length", &study->crack.half_length},
        {"width", &study->crack.half_width},
        {"height", &study->crack.half_height},
        {"angle", &degrees},
        {"inner", &study->inner},
        {"outer", &study->outer},
    };
    TRY(measurement_numbers(m, numbers, sizeof numbers / sizeof *numbers, error));
    study->crack.angle = degrees * acos(-1.0) / 180.0;
    TRY(slanted_crack_solve(&study->crack, &study->exact, error));
    return measurement_list(m, "contours", CONTOURS_MAX, study->contours, &study->contour_count,
                            error);
}

/* "cracks.0.j_integral=[...]"; g_free it. */
static char *setting_of(const struct study *study)
{
    GString *text = g_string_new("cracks.0.j_integral=[");
    for (size_t tip = 0; tip < TIPS; tip++)
        for (size_t k = 0; k < study->contour_count; k++)
            g_string_append_printf(text, "{tip: %s, contour: %g}, ", TIP_NAMES[tip],
                                   study->contours[k]);
    g_string_append_c(text, ']');
    return g_string_free(text, FALSE);
}

/* ------------------------------------------------------------------- fields */

struct fields {
    size_t count;
    double *place, *gradient, *stress, *volume; /* the first and the last of t = 0 */
};

static enum mpm_status open_fields(const struct mpm_simulation *simulation, struct fields *fields,
                                   struct mpm_error *error)
{
    fields->count = mpm_simulation_particle_count(simulation);
    fields->place = calloc(2 * fields->count, sizeof(double));
    fields->gradient = calloc(5 * fields->count, sizeof(double));
    fields->stress = calloc(4 * fields->count, sizeof(double));
    fields->volume = calloc(fields->count, sizeof(double));
    if (fields->place == NULL || fields->gradient == NULL || fields->stress == NULL ||
        fields->volume == NULL)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for fields");
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, fields->place);
    mpm_simulation_field(simulation, MPM_FIELD_VOLUME, fields->volume);
    return MPM_OK;
}

/* Of the particles as they are, with the places that they had at first. */
static void integrate(struct study *study, const struct mpm_simulation *simulation,
                      struct fields *fields)
{
    mpm_simulation_field(simulation, MPM_FIELD_DEFORMATION_GRADIENT, fields->gradient);
    mpm_simulation_field(simulation, MPM_FIELD_STRESS, fields->stress);
    for (size_t tip = 0; tip < TIPS; tip++) {
        const struct mpm_j_integral *const at = &study->found[tip][0];
        struct williams_field field = {
            .shear = 0.5 * study->modulus / (1.0 + study->poisson),
            .kappa = (3.0 - study->poisson) / (1.0 + study->poisson),
            .tip = {at->tip[0], at->tip[1]},
            .direction = {at->direction[0], at->direction[1]},
        };
        interaction_integral(&(struct interaction_particles){fields->count, fields->place,
                                                             fields->gradient, fields->stress,
                                                             fields->volume},
                             &field, study->inner, study->outer, study->interaction[tip]);
    }
}

static enum mpm_status follow_plate(struct study *study, struct measurement *m,
                                    const struct mpm_scene *scene,
                                    struct mpm_simulation *simulation, struct fields *fields,
                                    struct mpm_error *error)
{
    TRY(open_fields(simulation, fields, error));
    TRY(follow_to_rest(m, simulation, mpm_scene_end_time(scene), &study->finished, error));
    for (size_t tip = 0; tip < TIPS; tip++)
        for (size_t k = 0; k < study->contour_count; k++)
            TRY(mpm_simulation_j_integral(simulation, tip * study->contour_count + k,
                                          &study->found[tip][k], error));
    integrate(study, simulation, fields);
    return MPM_OK;
}

static enum mpm_status follow(void *context, struct measurement *m, const struct mpm_scene *scene,
                              struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct fields fields = {0};
    const enum mpm_status status = follow_plate(context, m, scene, simulation, &fields, error);
    free(fields.place);
    free(fields.gradient);
    free(fields.stress);
    free(fields.volume);
    return status;
}

/* J of the exact solution. */
static double release_of(const struct study *study)
{
    const double one = study->exact.mode_1, two = study->exact.mode_2;
    return (one * one + two * two) / study->modulus;
}

/* Of one tip: mean of J and of K_I, K_II of the solver over the contours, and how far J is from
 * contour to contour, in percent. */
struct tip_mean {
    double j, intensity[MODES], spread;
};

static struct tip_mean mean_of(const struct study *study, size_t tip)
{
    const double count = (double)study->contour_count;
    struct tip_mean mean = {.j = 0.0};
    double least = HUGE_VAL, largest = -HUGE_VAL;
    for (size_t k = 0; k < study->contour_count; k++) {
        const struct mpm_j_integral *const at = &study->found[tip][k];
        least = fmin(least, at->j[0]);
        largest = fmax(largest, at->j[0]);
        mean.j += at->j[0] / count;
        for (int mode = 0; mode < MODES; mode++)
            mean.intensity[mode] += at->stress_intensity[mode] / count;
    }
    mean.spread = 100.0 * (largest - least) / mean.j;
    return mean;
}

/* Largest difference of the solver's K from the suite's own at the same tip, in percent. */
static double difference_of(const struct study *study)
{
    double largest = 0.0;
    for (size_t tip = 0; tip < TIPS; tip++) {
        const struct tip_mean mean = mean_of(study, tip);
        for (int mode = 0; mode < MODES; mode++)
            largest = fmax(largest, fabs(mean.intensity[mode] - study->interaction[tip][mode]));
    }
    return 100.0 * largest / study->exact.mode_1;
}

static void report(struct measurement *m, const struct study *study)
{
    const struct tip_mean end = mean_of(study, 0), start = mean_of(study, 1);
    const double exact[MODES] = {study->exact.mode_1, study->exact.mode_2};
    const double scale = study->crack.stress * sqrt(acos(-1.0) * study->crack.half_length);
    static const char *const names[][MODES] = {{"k_1", "k_2"}, {"k_1_solver", "k_2_solver"}};
    for (int mode = 0; mode < MODES; mode++) {
        const double k = study->interaction[0][mode] + study->interaction[1][mode];
        const double solver = end.intensity[mode] + start.intensity[mode];
        measurement_report(m, names[0][mode], 0.5 * k / exact[mode]);
        measurement_report(m, names[1][mode], 0.5 * solver / exact[mode]);
    }
    measurement_report(m, "k_difference", difference_of(study));
    measurement_report(m, "j_mean", 0.5 * (end.j + start.j) / release_of(study));
    measurement_report(m, "spread", fmax(end.spread, start.spread));
    measurement_report(m, "tips", 200.0 * fabs(end.j - start.j) / (end.j + start.j));
    measurement_note(m,
                     "exact: K_I %.5g, K_II %.5g of σ√(πa); tractions on the edges within "
                     "%.1e of σ",
                     exact[0] / scale, exact[1] / scale, study->exact.residual);
}

/* Columns of a contour: K_I and K_II of the solver at the end and at the start, of the suite in the
 * mean of both, and the exact ones; all over sigma sqrt(pi a). */
static enum mpm_status write_contours(struct measurement *m, const struct study *study,
                                      struct mpm_error *error)
{
    const double scale = study->crack.stress * sqrt(acos(-1.0) * study->crack.half_length);
    const double exact[MODES] = {study->exact.mode_1, study->exact.mode_2};
    double rows[CONTOURS_MAX][COLUMNS];
    for (size_t k = 0; k < study->contour_count; k++) {
        rows[k][0] = study->contours[k];
        for (size_t mode = 0; mode < MODES; mode++) {
            for (size_t tip = 0; tip < TIPS; tip++)
                rows[k][1 + MODES * tip + mode] =
                    study->found[tip][k].stress_intensity[mode] / scale;
            rows[k][5 + mode] =
                0.5 * (study->interaction[0][mode] + study->interaction[1][mode]) / scale;
            rows[k][7 + mode] = exact[mode] / scale;
        }
    }
    return measurement_series(m, "contours", "contour K_I K_II K_I K_II K_I K_II K_I K_II", COLUMNS,
                              study->contour_count, &rows[0][0], error);
}

/* Errors in percent: of J and of K_I and K_II of the solver, of K_I and K_II of the suite. */
static enum mpm_status write_errors(struct measurement *m, const struct study *study,
                                    struct mpm_error *error)
{
    const struct tip_mean end = mean_of(study, 0), start = mean_of(study, 1);
    const double exact[MODES] = {study->exact.mode_1, study->exact.mode_2};
    double row[ERRORS] = {100.0 * (0.5 * (end.j + start.j) / release_of(study) - 1.0)};
    for (int mode = 0; mode < MODES; mode++) {
        const double solver = end.intensity[mode] + start.intensity[mode];
        const double suite = study->interaction[0][mode] + study->interaction[1][mode];
        row[1 + mode] = 50.0 * solver / exact[mode] - 100.0;
        row[1 + MODES + mode] = 50.0 * suite / exact[mode] - 100.0;
    }
    return measurement_series(m, "errors", "J K_I K_II K_I K_II", ERRORS, 1, row, error);
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
    report(m, &study);
    TRY(write_contours(m, &study, error));
    return write_errors(m, &study, error);
}

const struct measure_program program_slanted_crack = {
    .name = "slanted_crack",
    .summary = "stress intensities of both modes of a slanted crack at rest against exact ones",
    .run = run,
};

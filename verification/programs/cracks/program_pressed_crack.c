/* D9: a block that is pressed over its cracks, beside another model of it: the whole that it is one
 * half of, or the same block without cracks.
 *
 * `beside` has the settings that make the other model of the scene, with " ; " between them. Body 0
 * is the block. Each of its particles is compared with the one of the other model that began at the
 * same place:
 * - difference: root mean square of the difference of displacements over that of displacements
 * - energy_ratio: energy, what damping took included, over external work; at the end
 * - least_distance: the least distance of a particle from the wall at `wall` across `axis`, ever,
 * over the least at the start
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2, SETTINGS = 8, TEXT = 1024 };

struct parameters {
    double axis, wall; /* place of the wall along that axis */
    double interval;   /* between two samples */
};

struct model {
    struct mpm_scene *scene;
    struct mpm_simulation *simulation;
    size_t count;
    double *start, *now; /* places */
    double *body;
};

struct study {
    struct parameters parameters;
    struct model pressed, beside;
    double least; /* distance from the wall, so far */
};

static enum mpm_status open_model(const struct measurement *m, struct model *model,
                                  struct mpm_error *error)
{
    TRY(mpm_simulation_create(model->scene, measurement_options(m), &model->simulation, error));
    model->count = mpm_simulation_particle_count(model->simulation);
    model->start = calloc(AXES * model->count, sizeof *model->start);
    model->now = calloc(AXES * model->count, sizeof *model->now);
    model->body = calloc(model->count, sizeof *model->body);
    if (model->start == NULL || model->now == NULL || model->body == NULL)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for fields");
    mpm_simulation_field(model->simulation, MPM_FIELD_POSITION, model->start);
    mpm_simulation_field(model->simulation, MPM_FIELD_BODY, model->body);
    return MPM_OK;
}

static void close_model(struct model *model)
{
    free(model->start);
    free(model->now);
    free(model->body);
    mpm_simulation_free(model->simulation);
    mpm_scene_free(model->scene);
}

/* The settings of a text, which is cut at the semicolons. */
static size_t split(char *text, const char *settings[SETTINGS])
{
    static const char between[] = " ; ";
    size_t count = 0;
    for (char *place = text; place != NULL && count < SETTINGS;) {
        settings[count++] = place;
        place = strstr(place, between);
        if (place == NULL)
            continue;
        *place = '\0';
        place += sizeof between - 1;
    }
    return count;
}

static enum mpm_status open_models(struct study *study, struct measurement *m,
                                   struct mpm_error *error)
{
    const char *beside, *settings[SETTINGS];
    char text[TEXT];
    TRY(measurement_text(m, "beside", &beside, error));
    if (strlen(beside) >= sizeof text)
        return failure_set(error, MPM_BAD_INPUT, "beside: %zu characters; allowed: up to %d",
                           strlen(beside), TEXT - 1);
    memcpy(text, beside, strlen(beside) + 1);
    TRY(measurement_scene(m, NULL, 0, &study->pressed.scene, error));
    TRY(measurement_scene(m, settings, split(text, settings), &study->beside.scene, error));
    TRY(open_model(m, &study->pressed, error));
    return open_model(m, &study->beside, error);
}

/* ------------------------------------------------------------------ looking */

static double distance_from_wall(const struct study *study, const double *places)
{
    const struct model *const model = &study->pressed;
    const size_t axis = study->parameters.axis > 0.5 ? 1 : 0;
    double least = HUGE_VAL;
    for (size_t p = 0; p < model->count; p++)
        if (model->body[p] == 0.0)
            least = fmin(least, fabs(places[AXES * p + axis] - study->parameters.wall));
    return least;
}

static void look(struct study *study)
{
    const struct model *const model = &study->pressed;
    mpm_simulation_field(model->simulation, MPM_FIELD_POSITION, model->now);
    study->least = fmin(study->least, distance_from_wall(study, model->now));
}

/* The particle of the other model that began nearest, or -1 if that is not the same place. */
static long counterpart(const struct model *model, const double place[AXES])
{
    static const double SAME = 1e-9; /* of a length of order 1 */
    for (size_t p = 0; p < model->count; p++)
        if (model->body[p] == 0.0 && fabs(model->start[AXES * p] - place[0]) < SAME &&
            fabs(model->start[AXES * p + 1] - place[1]) < SAME)
            return (long)p;
    return -1;
}

/* In percent; not a number where a particle has no counterpart. */
static double difference(const struct study *study)
{
    const struct model *const model = &study->pressed, *const other = &study->beside;
    double differences = 0.0, displacements = 0.0;
    for (size_t p = 0; p < model->count; p++) {
        const long q = counterpart(other, model->start + AXES * p);
        if (model->body[p] != 0.0)
            continue;
        if (q < 0)
            return (double)NAN;
        for (size_t axis = 0; axis < AXES; axis++) {
            const double moved = model->now[AXES * p + axis] - model->start[AXES * p + axis];
            const double there =
                other->now[AXES * (size_t)q + axis] - other->start[AXES * (size_t)q + axis];
            differences += (moved - there) * (moved - there);
            displacements += moved * moved;
        }
    }
    return 100.0 * sqrt(differences / displacements);
}

static void report(struct study *study, struct measurement *m, bool finished)
{
    struct mpm_ledger ledger;
    const double start = distance_from_wall(study, study->pressed.start);
    mpm_simulation_ledger(study->pressed.simulation, &ledger);
    measurement_report(m, "finished", finished ? 1.0 : 0.0);
    measurement_report(m, "least_distance", study->least / start);
    measurement_report(m, "energy_ratio", ledger.total_energy / ledger.external_work);
    if (!finished) {
        measurement_inconclusive(m, "difference", "the run did not reach its end");
        return;
    }
    mpm_simulation_field(study->beside.simulation, MPM_FIELD_POSITION, study->beside.now);
    measurement_report(m, "difference", difference(study));
}

static enum mpm_status follow(struct study *study, struct measurement *m, struct mpm_error *error)
{
    const double end = mpm_scene_end_time(study->pressed.scene);
    const double interval = study->parameters.interval;
    bool alive = true;
    study->least = HUGE_VAL;
    for (size_t k = 0; alive && (double)k * interval <= end * (1.0 + 1e-12); k++) {
        TRY(follow_to(m, study->pressed.simulation, fmin(interval * (double)k, end), &alive,
                      error));
        look(study);
    }
    if (alive)
        TRY(follow_to(m, study->beside.simulation, end, &alive, error));
    report(study, m, alive);
    follow_count_work(m, study->pressed.simulation);
    follow_count_work(m, study->beside.simulation);
    return MPM_OK;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {0};
    const struct measurement_parameter table[] = {
        {"axis", &study.parameters.axis},
        {"wall", &study.parameters.wall},
        {"interval", &study.parameters.interval},
    };
    TRY(measurement_numbers(measurement, table, sizeof table / sizeof *table, error));
    enum mpm_status status = open_models(&study, measurement, error);
    if (status == MPM_OK)
        status = follow(&study, measurement, error);
    close_model(&study.pressed);
    close_model(&study.beside);
    return status;
}

const struct measure_program program_pressed_crack = {
    .name = "pressed_crack",
    .summary = "a block that is pressed over its cracks, beside another model of it",
    .run = run,
};

/* C1, C9: two scenes that must move alike, step by step: bodies with contact and one piece, or the
 * same bodies in another order.
 *
 * Both are the variant's scene, with settings of their own in addition. Particles are those that
 * start at the same place. All fields of all of them are compared at each sample; a difference is
 * divided by the largest value of that field so far.
 *
 * Parameters: first_1, first_2, ... and second_1, ...: the settings of each; interval of samples.
 * Reports difference (the largest one; notes have those of the fields), contact_nodes (the most
 * nodes in contact at a sample), finished; series `difference`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/fields.h"
#include "verification/programs/contact/contact_history.h"
#include "verification/programs/follow.h"

#include <glib.h>
#include <math.h>
#include <stdio.h>

/* Fields that are compared; positions as displacements, whose scale is that of the motion. */
static const struct {
    enum mpm_field field;
    const char *name;
} FIELDS[] = {
    {MPM_FIELD_POSITION, "displacement"},
    {MPM_FIELD_VELOCITY, "velocity"},
    {MPM_FIELD_DEFORMATION_GRADIENT, "gradient"},
    {MPM_FIELD_STRESS, "stress"},
};
enum {
    FIELD_COUNT = sizeof FIELDS / sizeof *FIELDS,
    COLUMNS = 1 + FIELD_COUNT,
    COMPONENTS_MAX = 5,
    SETTINGS_MAX = 4,
    TWINS = 2,
};

struct twin {
    struct mpm_scene *scene;
    struct mpm_simulation *simulation;
    size_t count;
    size_t *order; /* particles by their places at the start */
    double *start; /* their places */
    double *values;
};

struct study {
    struct twin twin[TWINS];
    double largest[FIELD_COUNT], difference[FIELD_COUNT]; /* so far */
    double nodes;                                         /* in contact, most so far */
    struct follow_rows rows;
};

/* ------------------------------------------------------------------- models */

static int compare_places(const void *a, const void *b, void *context)
{
    const double *const start = context;
    const double *const p = &start[2 * *(const size_t *)a], *const q =
                                                                &start[2 * *(const size_t *)b];
    for (int axis = 0; axis < 2; axis++)
        if (p[axis] != q[axis])
            return p[axis] < q[axis] ? -1 : 1;
    return 0;
}

static enum mpm_status open_twin(struct measurement *m, const char *const *settings, size_t count,
                                 struct twin *twin, struct mpm_error *error)
{
    TRY(measurement_scene(m, settings, count, &twin->scene, error));
    TRY(mpm_simulation_create(twin->scene, measurement_options(m), &twin->simulation, error));
    twin->count = mpm_simulation_particle_count(twin->simulation);
    twin->order = g_new(size_t, twin->count);
    twin->start = g_new(double, 2 * twin->count);
    twin->values = g_new(double, COMPONENTS_MAX * twin->count);
    mpm_simulation_field(twin->simulation, MPM_FIELD_POSITION, twin->start);
    for (size_t k = 0; k < twin->count; k++)
        twin->order[k] = k;
    g_qsort_with_data(twin->order, (gint)twin->count, sizeof *twin->order, compare_places,
                      twin->start);
    return MPM_OK;
}

static void close_twin(struct twin *twin)
{
    g_free(twin->order);
    g_free(twin->start);
    g_free(twin->values);
    mpm_simulation_free(twin->simulation);
    mpm_scene_free(twin->scene);
}

static enum mpm_status match(const struct study *study, struct mpm_error *error)
{
    const struct twin *const a = &study->twin[0], *const b = &study->twin[1];
    if (a->count != b->count)
        return failure_set(error, MPM_BAD_INPUT, "one twin has %zu particles, the other %zu",
                           a->count, b->count);
    for (size_t k = 0; k < a->count; k++)
        for (size_t axis = 0; axis < 2; axis++)
            if (a->start[2 * a->order[k] + axis] != b->start[2 * b->order[k] + axis])
                return failure_set(error, MPM_BAD_INPUT, "particle %zu has no twin", a->order[k]);
    return MPM_OK;
}

/* ------------------------------------------------------------------ looking */

static void read_values(struct twin *twin, int k)
{
    mpm_simulation_field(twin->simulation, FIELDS[k].field, twin->values);
    for (size_t i = 0; FIELDS[k].field == MPM_FIELD_POSITION && i < 2 * twin->count; i++)
        twin->values[i] -= twin->start[i];
}

static void compare(struct study *study, int k)
{
    const struct twin *const a = &study->twin[0], *const b = &study->twin[1];
    const size_t components = mpm_field_describe(FIELDS[k].field)->components;
    double difference = 0.0;
    read_values(&study->twin[0], k);
    read_values(&study->twin[1], k);
    for (size_t p = 0; p < a->count; p++)
        for (size_t c = 0; c < components; c++) {
            const double one = a->values[a->order[p] * components + c];
            const double other = b->values[b->order[p] * components + c];
            study->largest[k] = field_larger(study->largest[k], fabs(other));
            difference = field_larger(difference, fabs(one - other));
        }
    if (study->largest[k] > 0.0)
        study->difference[k] = field_larger(study->difference[k], difference / study->largest[k]);
}

static void look(struct study *study)
{
    double row[COLUMNS] = {mpm_simulation_time(study->twin[0].simulation)};
    for (int k = 0; k < FIELD_COUNT; k++) {
        compare(study, k);
        row[1 + k] = study->difference[k];
    }
    study->nodes = fmax(study->nodes, contact_history_sum(study->twin[0].scene,
                                                          study->twin[0].simulation, "nodes"));
    follow_rows_add(&study->rows, row);
}

static void report(const struct study *study, struct measurement *m, bool finished)
{
    measurement_report(m, "finished", finished ? 1.0 : 0.0);
    measurement_report(m, "contact_nodes", study->nodes);
    measurement_note(m, "largest stress %.5g", study->largest[FIELD_COUNT - 1]);
    double largest = 0.0;
    for (int k = 0; k < FIELD_COUNT; k++) {
        largest = field_larger(largest, study->difference[k]);
        measurement_note(m, "difference of the %s %.3g", FIELDS[k].name, study->difference[k]);
    }
    if (finished)
        measurement_report(m, "difference", largest);
    else
        measurement_inconclusive(m, "difference", "a twin did not reach its end");
}

static enum mpm_status follow(struct study *study, struct measurement *m, struct mpm_error *error)
{
    double interval;
    bool alive = true;
    TRY(measurement_number(m, "interval", &interval, error));
    const double end = mpm_scene_end_time(study->twin[0].scene);
    study->rows.columns = COLUMNS;
    for (size_t k = 1; alive && (double)(k - 1) * interval < end; k++) {
        for (int i = 0; alive && i < TWINS; i++)
            TRY(follow_to(m, study->twin[i].simulation, fmin(interval * (double)k, end), &alive,
                          error));
        if (alive)
            look(study);
    }
    report(study, m, alive);
    for (int i = 0; i < TWINS; i++)
        follow_count_work(m, study->twin[i].simulation);
    TRY(follow_rows_check(&study->rows, error));
    return measurement_series(m, "difference", "time displacement velocity gradient stress",
                              COLUMNS, study->rows.count, study->rows.values, error);
}

static enum mpm_status open_with_settings(struct measurement *m, const char *name,
                                          struct twin *twin, struct mpm_error *error)
{
    const char *settings[SETTINGS_MAX];
    size_t count = 0;
    for (; count < SETTINGS_MAX; count++) {
        char parameter[32];
        (void)snprintf(parameter, sizeof parameter, "%s_%zu", name, count + 1);
        if (!measurement_has(m, parameter))
            break;
        TRY(measurement_text(m, parameter, &settings[count], error));
    }
    return open_twin(m, settings, count, twin, error);
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {.nodes = 0.0};
    enum mpm_status status = open_with_settings(measurement, "first", &study.twin[0], error);
    if (status == MPM_OK)
        status = open_with_settings(measurement, "second", &study.twin[1], error);
    if (status == MPM_OK)
        status = match(&study, error);
    if (status == MPM_OK)
        status = follow(&study, measurement, error);
    follow_rows_free(&study.rows);
    close_twin(&study.twin[0]);
    close_twin(&study.twin[1]);
    return status;
}

const struct measure_program program_contact_twins = {
    .name = "contact_twins",
    .summary = "two scenes with contact that must move alike",
    .run = run,
};

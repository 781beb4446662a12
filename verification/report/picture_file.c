/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/picture_file.h"

#include "verification/common/input.h"
#include "verification/common/record.h"
#include "verification/common/result_path.h"

#include <glib.h>
#include <math.h>

enum { FORMAT = 1, COUNT_MAX = 100000, FRAMES_MAX = 100, BODIES_MAX = 10000 };

/* Larger numbers are none of a scene, and would not fit into a picture's coordinates. */
static const double LARGEST = 1e100;

static bool is_number(const json_t *value)
{
    return json_is_number(value) && fabs(json_number_value(value)) < LARGEST;
}

bool picture_point(const json_t *list, double point[2])
{
    bool good = json_array_size(list) == 2;
    for (size_t i = 0; good && i < 2; i++) {
        point[i] = json_number_value(json_array_get(list, i));
        good = is_number(json_array_get(list, i));
    }
    return good;
}

bool picture_pair(const json_t *object, const char *key, double pair[2])
{
    return picture_point(json_object_get(object, key), pair);
}

bool picture_number(const json_t *object, const char *key, double *number)
{
    *number = json_number_value(json_object_get(object, key));
    return is_number(json_object_get(object, key));
}

/* `count` numbers, or NULL; those that are missing are not numbers where that is allowed. */
static double *numbers_of(const json_t *list, size_t count, bool may_lack)
{
    if (json_array_size(list) != count)
        return NULL;
    double *numbers = g_new(double, count + 1);
    for (size_t i = 0; i < count; i++) {
        const json_t *value = json_array_get(list, i);
        if (!is_number(value) && !(may_lack && json_is_null(value))) {
            g_free(numbers);
            return NULL;
        }
        numbers[i] = is_number(value) ? json_number_value(value) : (double)NAN;
    }
    return numbers;
}

static bool read_frame(const json_t *object, size_t count, struct picture_frame *frame)
{
    *frame = (struct picture_frame){
        .time = record_number(object, "time"),
        .u = numbers_of(json_object_get(object, "u"), 2 * count, false),
        .g = numbers_of(json_object_get(object, "g"), 4 * count, false),
        .value = numbers_of(json_object_get(object, "value"), count, true),
        .cracks = json_object_get(object, "cracks"),
    };
    return isfinite(frame->time) && frame->u != NULL && frame->g != NULL && frame->value != NULL;
}

/* Indices of bodies, or NULL. */
static size_t *bodies_of(const json_t *list, size_t count, size_t body_count)
{
    size_t *bodies = g_new(size_t, count + 1);
    for (size_t i = 0; i < count; i++) {
        const json_int_t body = json_integer_value(json_array_get(list, i));
        if (!json_is_integer(json_array_get(list, i)) || body < 0 || (size_t)body >= body_count) {
            g_free(bodies);
            return NULL;
        }
        bodies[i] = (size_t)body;
    }
    return bodies;
}

static bool read_states(const json_t *object, size_t body_count, struct picture_states *states)
{
    const json_t *const body = json_object_get(object, "body"), *const frames = json_object_get(
                                                                    object, "frames");
    states->count = json_array_size(body);
    states->stride = (size_t)json_integer_value(json_object_get(object, "stride"));
    if (states->count == 0 || states->count > COUNT_MAX || json_array_size(frames) == 0 ||
        json_array_size(frames) > FRAMES_MAX)
        return false;
    states->start = numbers_of(json_object_get(object, "start"), 2 * states->count, false);
    states->half = numbers_of(json_object_get(object, "half"), 2 * body_count, false);
    states->body = bodies_of(body, states->count, body_count);
    states->frames = g_new0(struct picture_frame, json_array_size(frames));
    bool good = states->start != NULL && states->half != NULL && states->body != NULL;
    for (size_t i = 0; good && i < json_array_size(frames); i++) {
        states->frame_count++;
        good = read_frame(json_array_get(frames, i), states->count, &states->frames[i]);
    }
    return good;
}

static bool read_object(struct picture_file *file)
{
    const json_t *const field = json_object_get(file->object, "field"), *const motion =
                                                                            json_object_get(
                                                                                file->object,
                                                                                "motion");
    file->scene = json_object_get(file->object, "scene");
    file->variant = record_text(file->object, "variant");
    file->title = record_text(field, "title");
    file->unit = record_text(field, "unit");
    file->is_signed = json_is_true(json_object_get(field, "signed"));
    file->magnify = record_number(file->object, "magnify");
    file->particles = (size_t)json_integer_value(json_object_get(file->object, "count"));
    file->body_count = json_array_size(json_object_get(file->scene, "bodies"));
    return json_integer_value(json_object_get(file->object, "format")) == FORMAT &&
           file->magnify > 0 && file->magnify < LARGEST && file->body_count <= BODIES_MAX &&
           read_states(json_object_get(file->object, "still"), file->body_count, &file->still) &&
           (!json_is_object(motion) || read_states(motion, file->body_count, &file->motion));
}

enum mpm_status picture_file_read(const char *path, struct picture_file *file,
                                  struct mpm_error *error)
{
    *file = (struct picture_file){.object = NULL};
    TRY(result_file_check(path, error));
    TRY(input_json(path, JSON_REJECT_DUPLICATES, &file->object, error));
    if (read_object(file))
        return MPM_OK;
    picture_file_clear(file);
    return failure_set(error, MPM_BAD_INPUT, "%s: is no picture that a run writes", path);
}

static void clear_states(struct picture_states *states)
{
    for (size_t i = 0; i < states->frame_count; i++) {
        g_free(states->frames[i].u);
        g_free(states->frames[i].g);
        g_free(states->frames[i].value);
    }
    g_free(states->frames);
    g_free(states->start);
    g_free(states->half);
    g_free(states->body);
}

void picture_file_clear(struct picture_file *file)
{
    clear_states(&file->still);
    clear_states(&file->motion);
    json_decref(file->object);
    *file = (struct picture_file){.object = NULL};
}

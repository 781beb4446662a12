/* The file is one JSON object:
 *
 *     {"format": 1, "case": ..., "variant": ..., "scene": {...}, "count": 5655, "magnify": 1,
 *      "field": {"name": "von_mises", "title": ..., "unit": "MPa", "signed": false},
 *      "still": {"stride": 2, "body": [0, 0, ...], "half": [hx, hy, ...], "start": [x, y, ...],
 *                "frames": [{"time": 0.5, "step": 20, "u": [ux, uy, ...],
 *                            "g": [xx, xy, yx, yy, ...], "value": [...],
 *                            "cracks": [[x, y, ...], ...]}]},
 *      "motion": the same with more frames, or null}
 *
 * `half` has two numbers a body, half the sides of the domains drawn; `u` are displacements, `g`
 * their gradients F - 1 in the plane; values that are not finite are null.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/picture_take.h"

#include "mpm_yaml.h"
#include "verification/cases/case_picture.h"
#include "verification/common/output.h"
#include "verification/common/record.h"
#include "verification/common/scene_json.h"
#include "verification/suite/picture_field.h"

#include <glib.h>
#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* One state, or those of a motion, of particles as many as the file may hold. */
struct shot {
    int64_t frames_wanted; /* 0: it is not asked for */
    double end;            /* time of the last frame; infinite: at the end of the simulation */
    size_t stride;
    GArray *kept; /* size_t: ids of the particles drawn */
    json_t *frames;
};
enum { STILL, MOTION, SHOTS };

struct picture_taker {
    const struct catalogue_case *entry;
    const struct case_variant *variant;
    struct case_picture wanted;
    struct mpm_monitor monitor;
    int64_t seen;                            /* simulations made so far */
    const struct mpm_simulation *simulation; /* the one to show, while it lives */
    enum picture_field field;
    json_t *scene;
    struct shot shots[SHOTS];
    size_t count;
    double *start, *half;
    int *body;
    enum mpm_status status;
    struct mpm_error error;
};

/* ------------------------------------------------------------------- numbers */

/* So many digits are more than an eye can see. */
static json_t *rounded(double value, int digits)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE], format[8];
    if (!isfinite(value))
        return json_null();
    g_snprintf(format, sizeof format, "%%.%dg", digits);
    const double near = g_ascii_strtod(g_ascii_formatd(text, sizeof text, format, value), NULL);
    return floor(near) < near || fabs(near) > 1e9 ? json_real(near)
                                                  : json_integer((json_int_t)near);
}

static json_t *rounded_list(const struct shot *shot, const double *values, size_t components,
                            size_t used, int digits)
{
    json_t *list = json_array();
    for (unsigned k = 0; k < shot->kept->len; k++)
        for (size_t c = 0; c < used; c++) {
            const size_t particle = g_array_index(shot->kept, size_t, k);
            json_array_append_new(list, rounded(values[components * particle + c], digits));
        }
    return list;
}

/* --------------------------------------------------------------------- start */

static double number_at(const json_t *array, size_t i)
{
    return json_number_value(json_array_get(array, i));
}

/* Half the sides of the particles' domains at t = 0, of each body. */
static double *half_sizes(const json_t *scene)
{
    const json_t *grid = json_object_get(scene, "grid"), *bodies = json_object_get(scene, "bodies");
    double *half = g_new0(double, 2 * json_array_size(bodies) + 1);
    for (size_t b = 0; b < json_array_size(bodies); b++)
        for (size_t axis = 0; axis < 2; axis++) {
            const json_t *each = json_object_get(json_array_get(bodies, b), "particles_per_cell");
            half[2 * b + axis] = number_at(json_object_get(grid, "cell"), axis) /
                                 record_number(grid, "refine") / number_at(each, axis) / 2;
        }
    return half;
}

/* Of `stride` by `stride` places on the lattice of the body's particles, it has the middle one. */
static bool is_kept(const struct picture_taker *taker, size_t stride, size_t particle)
{
    const json_t *origin = json_object_get(json_object_get(taker->scene, "grid"), "origin");
    for (size_t axis = 0; axis < 2; axis++) {
        const double side = 2 * taker->half[2 * (size_t)taker->body[particle] + axis];
        const double place = (taker->start[2 * particle + axis] - number_at(origin, axis)) / side;
        const double rest = fmod(floor(place), (double)stride);
        if (rest < 0 || (size_t)rest != stride / 2)
            return false;
    }
    return true;
}

static void thin_out(const struct picture_taker *taker, struct shot *shot, size_t most)
{
    enum { STRIDE_MAX = 1000 };
    shot->kept = g_array_new(FALSE, FALSE, sizeof(size_t));
    for (shot->stride = 1; shot->stride < STRIDE_MAX; shot->stride++) {
        g_array_set_size(shot->kept, 0);
        for (size_t p = 0; p < taker->count; p++)
            if (is_kept(taker, shot->stride, p))
                g_array_append_val(shot->kept, p);
        if (shot->kept->len <= most)
            return;
    }
}

static void begin_shots(struct picture_taker *taker, double scene_end)
{
    struct shot *still = &taker->shots[STILL], *motion = &taker->shots[MOTION];
    const double time = taker->wanted.time;
    still->frames_wanted = 1;
    still->end = isnan(time) ? (double)INFINITY : time;
    thin_out(taker, still, PICTURE_PARTICLES);
    motion->frames_wanted = taker->wanted.frames;
    motion->end = isnan(time) ? scene_end : time;
    thin_out(taker, motion, PICTURE_MOTION / (size_t)MAX(motion->frames_wanted, 1));
}

static enum mpm_status begin(struct picture_taker *taker, const struct mpm_simulation *simulation)
{
    const struct mpm_scene *const scene = mpm_simulation_scene(simulation);
    struct mpm_tree_node *root;
    TRY(mpm_scene_tree(scene, &root, &taker->error));
    taker->scene = scene_json_of(root);
    mpm_tree_free(root);
    taker->simulation = simulation;
    taker->count = mpm_simulation_particle_count(simulation);
    taker->field =
        taker->wanted.field == PICTURE_BY_LAW ? picture_field_by_law(scene) : taker->wanted.field;
    taker->start = g_new(double, 2 * taker->count + 1);
    taker->body = g_new(int, taker->count + 1);
    double *bodies = g_new(double, taker->count + 1);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, taker->start);
    mpm_simulation_field(simulation, MPM_FIELD_BODY, bodies);
    for (size_t p = 0; p < taker->count; p++)
        taker->body[p] = (int)bodies[p];
    g_free(bodies);
    taker->half = half_sizes(taker->scene);
    begin_shots(taker, mpm_scene_end_time(scene));
    return MPM_OK;
}

/* -------------------------------------------------------------------- frames */

static json_t *crack_list(const struct mpm_simulation *simulation)
{
    json_t *cracks = json_array();
    for (size_t k = 0; k < mpm_simulation_crack_point_count(simulation); k++) {
        const struct mpm_crack_point point = mpm_simulation_crack_point(simulation, k);
        while (json_array_size(cracks) <= point.crack)
            json_array_append_new(cracks, json_array());
        json_t *crack = json_array_get(cracks, point.crack);
        json_array_append_new(crack, rounded(point.position[0], 5));
        json_array_append_new(crack, rounded(point.position[1], 5));
    }
    return cracks;
}

/* Round-off is not worth its digits. */
static double without_dust(double value)
{
    static const double dust = 1e-12;
    return fabs(value) < dust ? 0 : value;
}

/* A motion's domains are drawn to a tenth of half a side: the power of ten below that. */
static double coarse_step(const struct picture_taker *taker, const struct shot *shot)
{
    const size_t bodies = json_array_size(json_object_get(taker->scene, "bodies"));
    double least = HUGE_VAL;
    for (size_t i = 0; i < 2 * bodies; i++)
        least = fmin(least, taker->half[i] * (double)shot->stride);
    return pow(10, floor(log10(least / 10)));
}

/* Multiples of a step, which are short as text. */
static void round_to(double *values, size_t count, double step)
{
    for (size_t i = 0; i < count; i++)
        values[i] = step * round(values[i] / step);
}

static void take(const struct picture_taker *taker, struct shot *shot, bool coarse)
{
    enum { GRADIENT = 5 };
    const struct mpm_simulation *const simulation = taker->simulation;
    double *place = g_new(double, 2 * taker->count + 1), *values = g_new(double, taker->count + 1);
    double *f = g_new(double, GRADIENT * taker->count + 1);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, place);
    mpm_simulation_field(simulation, MPM_FIELD_DEFORMATION_GRADIENT, f);
    picture_field_values(simulation, taker->field, taker->start, values);
    for (size_t i = 0; i < 2 * taker->count; i++)
        place[i] = without_dust(place[i] - taker->start[i]);
    for (size_t i = 0; i < GRADIENT * taker->count; i++)
        f[i] = without_dust(f[i] - (i % GRADIENT == 0 || i % GRADIENT == 3 ? 1 : 0));
    if (coarse) {
        round_to(place, 2 * taker->count, coarse_step(taker, shot));
        round_to(f, GRADIENT * taker->count, 0.01);
    }
    json_t *frame = json_object();
    json_object_set_new(frame, "time", rounded(mpm_simulation_time(simulation), 6));
    json_object_set_new(frame, "step", json_integer((json_int_t)mpm_simulation_step(simulation)));
    json_object_set_new(frame, "u", rounded_list(shot, place, 2, 2, 5));
    json_object_set_new(frame, "g", rounded_list(shot, f, GRADIENT, 4, 3));
    json_object_set_new(frame, "value", rounded_list(shot, values, 1, 1, coarse ? 3 : 4));
    json_object_set_new(frame, "cracks", crack_list(simulation));
    json_array_append_new(shot->frames, frame);
    g_free(f);
    g_free(values);
    g_free(place);
}

/* At the first step at or after each of its times, and what is owed still at the end. */
static void take_if_due(const struct picture_taker *taker, struct shot *shot, bool at_end)
{
    const int64_t taken = (int64_t)json_array_size(shot->frames);
    if (taken >= shot->frames_wanted)
        return;
    const double due = shot->frames_wanted < 2
                           ? shot->end
                           : shot->end * (double)taken / (double)(shot->frames_wanted - 1);
    if (at_end || mpm_simulation_time(taker->simulation) >= due * (1 - 1e-9))
        take(taker, shot, shot->frames_wanted > 1);
}

static void look(void *context, enum mpm_moment moment, const struct mpm_simulation *simulation)
{
    struct picture_taker *const taker = context;
    if (moment == MPM_AT_START && ++taker->seen == taker->wanted.simulation)
        taker->status = begin(taker, simulation);
    if (simulation != taker->simulation || taker->status != MPM_OK)
        return;
    for (int i = 0; i < SHOTS; i++)
        take_if_due(taker, &taker->shots[i], moment == MPM_AT_END);
    if (moment == MPM_AT_END)
        taker->simulation = NULL;
}

/* --------------------------------------------------------------------- taker */

struct picture_taker *picture_taker_new(const struct catalogue_case *entry,
                                        const struct case_variant *variant)
{
    if (case_picture_variant(entry->file) != variant)
        return NULL;
    struct picture_taker *taker = g_new0(struct picture_taker, 1);
    taker->entry = entry;
    taker->variant = variant;
    taker->wanted = case_picture_of(entry->file);
    taker->monitor = (struct mpm_monitor){look, taker};
    for (int i = 0; i < SHOTS; i++)
        taker->shots[i].frames = json_array();
    return taker;
}

void picture_taker_free(struct picture_taker *taker)
{
    if (taker == NULL)
        return;
    for (int i = 0; i < SHOTS; i++) {
        json_decref(taker->shots[i].frames);
        if (taker->shots[i].kept != NULL)
            g_array_unref(taker->shots[i].kept);
    }
    json_decref(taker->scene);
    g_free(taker->start);
    g_free(taker->half);
    g_free(taker->body);
    g_free(taker);
}

const struct mpm_monitor *picture_taker_monitor(const struct picture_taker *taker)
{
    return taker == NULL ? NULL : &taker->monitor;
}

char *picture_file_name(const char *variant)
{
    return g_strdup_printf("picture-%s.json", variant);
}

/* --------------------------------------------------------------------- write */

/* Displacements that nobody would see, a fiftieth of the body and less, are drawn larger, by 1, 2
 * or 5 times a power of ten; those of several bodies are not, which would run into each other. */
static double magnification(const struct picture_taker *taker)
{
    enum { SEEN = 20, ENOUGH = 50 }; /* parts of the body that show well, and that are enough */
    const struct shot *const still = &taker->shots[STILL];
    const json_t *u = json_object_get(json_array_get(still->frames, 0), "u");
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL}, most = 0;
    if (!isnan(taker->wanted.magnify))
        return taker->wanted.magnify;
    for (unsigned k = 0; k < still->kept->len; k++)
        for (size_t axis = 0; axis < 2; axis++) {
            const double x = taker->start[2 * g_array_index(still->kept, size_t, k) + axis];
            low[axis] = fmin(low[axis], x);
            high[axis] = fmax(high[axis], x);
            most = fmax(most, fabs(number_at(u, 2 * k + axis)));
        }
    const double size = fmax(high[0] - low[0], high[1] - low[1]);
    if (json_array_size(json_object_get(taker->scene, "bodies")) != 1 || !(most > 1e-12 * size) ||
        most > size / ENOUGH)
        return 1;
    const double wanted = size / SEEN / most, ten = pow(10, floor(log10(wanted)));
    return wanted / ten >= 5 ? 5 * ten : wanted / ten >= 2 ? 2 * ten : ten;
}

static json_t *field_record(const struct picture_taker *taker)
{
    const struct picture_field_info *const info = picture_field_describe(taker->field);
    char *unit = picture_field_unit(json_object_get(taker->scene, "units"), info->dimension);
    json_t *object = json_object();
    json_object_set_new(object, "name", json_string(info->name));
    json_object_set_new(object, "title", json_string(info->title));
    json_object_set_new(object, "unit", record_text_of(unit));
    json_object_set_new(object, "signed", json_boolean(info->is_signed));
    g_free(unit);
    return object;
}

static json_t *shot_record(const struct picture_taker *taker, const struct shot *shot)
{
    json_t *object = json_object(), *half = json_array(), *body = json_array();
    for (size_t i = 0; i < 2 * json_array_size(json_object_get(taker->scene, "bodies")); i++)
        json_array_append_new(half, rounded((double)shot->stride * taker->half[i], 6));
    for (unsigned k = 0; k < shot->kept->len; k++)
        json_array_append_new(body,
                              json_integer(taker->body[g_array_index(shot->kept, size_t, k)]));
    json_object_set_new(object, "stride", json_integer((json_int_t)shot->stride));
    json_object_set_new(object, "half", half);
    json_object_set_new(object, "body", body);
    json_object_set_new(object, "start", rounded_list(shot, taker->start, 2, 2, 6));
    json_object_set(object, "frames", shot->frames);
    return object;
}

static json_t *object_of(const struct picture_taker *taker)
{
    const bool moves = taker->shots[MOTION].frames_wanted > 1;
    json_t *object = json_object();
    json_object_set_new(object, "format", json_integer(1));
    json_object_set_new(object, "case", record_text_of(taker->entry->file->name));
    json_object_set_new(object, "variant", record_text_of(taker->variant->name));
    json_object_set_new(object, "count", json_integer((json_int_t)taker->count));
    json_object_set_new(object, "magnify", rounded(magnification(taker), 6));
    json_object_set_new(object, "field", field_record(taker));
    json_object_set(object, "scene", taker->scene);
    json_object_set_new(object, "still", shot_record(taker, &taker->shots[STILL]));
    json_object_set_new(object, "motion",
                        moves ? shot_record(taker, &taker->shots[MOTION]) : json_null());
    return object;
}

enum mpm_status picture_taker_write(struct picture_taker *taker, const char *folder,
                                    struct mpm_error *error)
{
    enum { DIGITS = 8 };
    if (taker->status != MPM_OK)
        return failure_set(error, taker->status, "picture: %s", taker->error.message);
    if (json_array_size(taker->shots[STILL].frames) == 0)
        return failure_set(error, MPM_RUN_FAILED,
                           "no picture: the program made %d simulations, and that of number %d is "
                           "to be shown; allowed: picture: {simulation: N}, or no_picture: WHY",
                           (int)taker->seen, (int)taker->wanted.simulation);
    json_t *object = object_of(taker);
    char *text = json_dumps(object, JSON_COMPACT | JSON_REAL_PRECISION(DIGITS));
    char *name = picture_file_name(taker->variant->name);
    const enum mpm_status status = output_write(folder, name, text, error);
    g_free(name);
    free(text);
    json_decref(object);
    return status;
}

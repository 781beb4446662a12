/* Points: lists of what is measured.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/measuring/points.h"

#include <stdarg.h>
#include <string.h>

static void clear(void *item)
{
    struct bench_point *point = item;
    g_free(point->name);
    g_free(point->against);
    g_free(point->scene);
    json_decref(point->settings);
    g_ptr_array_unref(point->set);
}

GArray *bench_points_new(void)
{
    GArray *points = g_array_new(FALSE, TRUE, sizeof(struct bench_point));
    g_array_set_clear_func(points, clear);
    return points;
}

static struct bench_point *append(GArray *points, char *name)
{
    const struct bench_point point = {
        .name = name,
        .settings = json_object(),
        .set = g_ptr_array_new_with_free_func(g_free),
    };
    g_array_append_val(points, point);
    return &g_array_index(points, struct bench_point, points->len - 1);
}

struct bench_point *bench_points_add(GArray *points, const char *scene,
                                     const struct mpm_simulation_options *options,
                                     const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    struct bench_point *point = append(points, g_strdup_vprintf(format, arguments));
    va_end(arguments);
    point->scene = g_strdup(scene);
    point->simulation = *options;
    return point;
}

struct bench_point *bench_points_add_probe(GArray *points, bench_probe *probe, const void *context,
                                           const char *quantity, const char *unit, const char *name)
{
    struct bench_point *point = append(points, g_strdup(name));
    point->probe = probe;
    point->probe_context = context;
    point->quantity = quantity;
    point->unit = unit;
    return point;
}

void bench_point_set(struct bench_point *point, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_ptr_array_add(point->set, g_strdup_vprintf(format, arguments));
    va_end(arguments);
}

void bench_point_text(struct bench_point *point, const char *key, const char *text)
{
    json_object_set_new(point->settings, key, json_string(text));
}

void bench_point_number(struct bench_point *point, const char *key, double number)
{
    json_object_set_new(point->settings, key, json_real(number));
}

void bench_point_vary(struct bench_point *point, const char *path, const char *value)
{
    const char *last = strrchr(path, '.');
    bench_point_set(point, "%s=%s", path, value);
    bench_point_text(point, last == NULL ? path : last + 1, value);
}

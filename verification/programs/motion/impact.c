/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/motion/impact.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>

enum { AXES = 2, GRADIENT = 5 };

/* ------------------------------------------------------------------- mirror */

struct place {
    double x, y;
    size_t index;
};

static int by_place(const void *a, const void *b)
{
    const struct place *const p = a, *const q = b;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    return (p->y > q->y) - (p->y < q->y);
}

/* Columns of particles, from below: the image of the first is the last. */
static enum mpm_status find_mirrors(struct impact *impact, struct mpm_error *error)
{
    static const double ROUND_OFF = 1e-9;
    struct place *const places = g_new(struct place, impact->count);
    enum mpm_status status = MPM_OK;
    for (size_t p = 0; p < impact->count; p++)
        places[p] = (struct place){impact->position[AXES * p], impact->position[AXES * p + 1], p};
    qsort(places, impact->count, sizeof *places, by_place);
    for (size_t first = 0, end = 0; first < impact->count; first = end) {
        while (end < impact->count && places[end].x == places[first].x)
            end++;
        for (size_t k = first; k < end; k++) {
            const struct place *const image = &places[first + end - 1 - k];
            impact->mirror[places[k].index] = image->index;
            if (fabs(places[k].y + image->y) > ROUND_OFF * impact->cell)
                status = failure_set(error, MPM_BAD_INPUT, "no particle at (%g, %g)", places[k].x,
                                     -places[k].y);
        }
    }
    g_free(places);
    return status;
}

static void look_at_symmetry(struct impact *impact)
{
    for (size_t p = 0; p < impact->count; p++) {
        const double *const own = &impact->position[AXES * p];
        const double *const image = &impact->position[AXES * impact->mirror[p]];
        impact->asymmetry = fmax(impact->asymmetry, hypot(own[0] - image[0], own[1] + image[1]));
    }
}

/* ----------------------------------------------------------------- pictures */

static enum mpm_status read_frames(struct impact *impact, struct mpm_error *error)
{
    bool asked;
    TRY(picture_read(impact->measurement, &impact->picture, &asked, error));
    if (!asked)
        return MPM_OK;
    return measurement_list(impact->measurement, "frames", IMPACT_FRAMES_MAX, impact->frames,
                            &impact->frame_count, error);
}

/* A picture at the first sample at or after each of its times. */
static void draw_frames(struct impact *impact)
{
    const double time = mpm_simulation_time(impact->simulation);
    while (impact->frame < impact->frame_count && impact->frames[impact->frame] <= time) {
        char *const name = g_strdup_printf("frame_%zu", ++impact->frame);
        if (impact->status == MPM_OK)
            impact->status =
                picture_write(impact->measurement, &impact->picture, impact->simulation,
                              impact->field, 0, name, &impact->error);
        g_free(name);
    }
}

/* --------------------------------------------------------------------- all */

static void read_fields(struct impact *impact)
{
    mpm_simulation_field(impact->simulation, MPM_FIELD_POSITION, impact->position);
    mpm_simulation_field(impact->simulation, MPM_FIELD_DEFORMATION_GRADIENT, impact->gradient);
}

static enum mpm_status watch_cracks(struct impact *impact, struct mpm_error *error)
{
    double reach, spacing;
    TRY(measurement_number(impact->measurement, "reach", &reach, error));
    TRY(measurement_number(impact->measurement, "spacing", &spacing, error));
    const size_t points = mpm_simulation_crack_point_count(impact->simulation);
    const size_t cracks =
        points == 0 ? 0 : mpm_simulation_crack_point(impact->simulation, points - 1).crack + 1;
    impact->cracks = g_new0(struct crack_watch, cracks);
    for (; impact->crack_count < cracks; impact->crack_count++)
        TRY(crack_watch_create(impact->simulation, impact->crack_count, reach * impact->cell,
                               spacing * impact->cell, &impact->cracks[impact->crack_count],
                               error));
    return MPM_OK;
}

enum mpm_status impact_open(struct impact *impact, struct measurement *measurement,
                            const struct mpm_simulation *simulation, enum mpm_field field,
                            struct mpm_error *error)
{
    const size_t n = mpm_simulation_particle_count(simulation);
    *impact = (struct impact){
        .measurement = measurement,
        .simulation = simulation,
        .count = n,
        .position = g_new(double, AXES *n),
        .gradient = g_new(double, GRADIENT *n),
        .mirror = g_new(size_t, n),
        .field = field,
    };
    TRY(measurement_number(measurement, "cell", &impact->cell, error));
    read_fields(impact);
    TRY(find_mirrors(impact, error));
    TRY(read_frames(impact, error));
    return watch_cracks(impact, error);
}

void impact_close(struct impact *impact)
{
    for (size_t k = 0; impact->cracks != NULL && k < impact->crack_count; k++)
        crack_watch_free(&impact->cracks[k]);
    g_free(impact->cracks);
    g_free(impact->position);
    g_free(impact->gradient);
    g_free(impact->mirror);
}

void impact_look(struct impact *impact)
{
    read_fields(impact);
    look_at_symmetry(impact);
    for (size_t k = 0; k < impact->crack_count; k++)
        crack_watch_look(&impact->cracks[k], impact->simulation, impact->position,
                         impact->gradient);
    draw_frames(impact);
}

static void report_of_crack(const struct impact *impact, size_t number, const char *what,
                            double value)
{
    char *const name = g_strdup_printf("%s_%zu", what, number);
    measurement_report(impact->measurement, name, value);
    g_free(name);
}

enum mpm_status impact_report(const struct impact *impact, struct mpm_error *error)
{
    measurement_report(impact->measurement, "asymmetry", impact->asymmetry / impact->cell);
    for (size_t k = 0; k < impact->crack_count; k++) {
        const struct crack_watch *const crack = &impact->cracks[k];
        const double kept = 1.0 - (double)crack->crossed / (double)crack->faces.count;
        report_of_crack(impact, k + 1, "opening", crack->widest);
        report_of_crack(impact, k + 1, "overlap", crack->overlap / impact->cell);
        report_of_crack(impact, k + 1, "range", 1.0 + crack->overlap / crack->widest);
        report_of_crack(impact, k + 1, "kept", 100.0 * kept);
        report_of_crack(impact, k + 1, "depth", crack->depth / impact->cell);
    }
    if (impact->status != MPM_OK)
        *error = impact->error;
    return impact->status;
}

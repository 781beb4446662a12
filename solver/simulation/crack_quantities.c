/* What cracks add to the history: one row of the table below is a column for each crack that has
 * for it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_contact.h"
#include "method/cracks/crack_detection.h"
#include "method/cracks/crack_fields.h"
#include "method/cracks/crack_opening.h"
#include "simulation/quantity_rows.h"
#include "simulation/simulation.h"

#include <math.h>
#include <stdio.h>

/* ------------------------------------------------------------------ opening */

static bool is_followed(const struct mpm_scene *scene, size_t crack)
{
    return mpm_crack_is_followed(&scene->cracks[crack]);
}

static struct mpm_crack_gap gap_at(const struct mpm_simulation *simulation, size_t crack,
                                   size_t point)
{
    const struct mpm_state *const state = &simulation->state;
    return mpm_crack_gap_at(state, &state->cracks.chains[crack],
                            mpm_crack_first_point(state, crack), point);
}

static size_t last_of(const struct mpm_simulation *simulation, size_t crack)
{
    return simulation->state.cracks.chains[crack].count - 1;
}

/* That of its mouth, or of the end that it has now. The piece outside of the body does not follow
 * its surfaces, and does not enter the mouth's normal. */
static struct mpm_crack_gap gap_at_end(const struct mpm_simulation *simulation, size_t crack,
                                       int end)
{
    const struct mpm_state *const state = &simulation->state;
    const size_t mouth = state->cracks.openings.mouths[crack][end];
    struct mpm_crack_chain piece = state->cracks.chains[crack];
    size_t first = mpm_crack_first_point(state, crack);
    if (mouth != SIZE_MAX && end == 0) {
        piece.x += mouth - first;
        piece.y += mouth - first;
        piece.count -= mouth - first;
        first = mouth;
    } else if (mouth != SIZE_MAX) {
        piece.count = mouth - first + 1;
    }
    return mpm_crack_gap_at(state, &piece, first, end == 0 ? 0 : piece.count - 1);
}

static double opening_at(const struct mpm_simulation *simulation, size_t crack, int end)
{
    return gap_at_end(simulation, crack, end).opening;
}

static double sliding_at(const struct mpm_simulation *simulation, size_t crack, int end)
{
    return gap_at_end(simulation, crack, end).sliding;
}

static double opening_largest(const struct mpm_simulation *simulation, size_t crack, int end)
{
    (void)end;
    double largest = -HUGE_VAL;
    for (size_t k = 0; k <= last_of(simulation, crack); k++)
        largest = fmax(largest, gap_at(simulation, crack, k).opening);
    return largest;
}

static double sliding_largest(const struct mpm_simulation *simulation, size_t crack, int end)
{
    (void)end;
    double largest = 0.0;
    for (size_t k = 0; k <= last_of(simulation, crack); k++) {
        const double sliding = gap_at(simulation, crack, k).sliding;
        largest = fabs(sliding) > fabs(largest) ? sliding : largest;
    }
    return largest;
}

/* ----------------------------------------------------------------- cohesive */

static bool is_cohesive(const struct mpm_scene *scene, size_t crack)
{
    return scene->cracks[crack].cohesive.law != NULL;
}

/* Over the area. */
static double opening_mean(const struct mpm_simulation *simulation, size_t crack, int end)
{
    (void)end;
    const struct mpm_state *const state = &simulation->state;
    const size_t first = mpm_crack_first_point(state, crack);
    double sum = 0.0, area = 0.0;
    for (size_t k = 0; k <= last_of(simulation, crack); k++) {
        sum += state->cracks.openings.area[first + k] * gap_at(simulation, crack, k).opening;
        area += state->cracks.openings.area[first + k];
    }
    return area > 0.0 ? sum / area : 0.0;
}

/* ------------------------------------------------------------------ contact */

static double nodes_without_contact(const struct mpm_simulation *simulation, size_t crack, int end)
{
    (void)end;
    return (double)mpm_crack_contact_crowded(&simulation->state, crack);
}

/* -------------------------------------------------------------------- table */

static const struct quantity {
    const char *name;
    struct mpm_dimension dimension;
    int end; /* of the chain, 0 or 1, for a value at one of them */
    const char *description;
    bool (*asked)(const struct mpm_scene *scene, size_t crack);
    double (*value)(const struct mpm_simulation *simulation, size_t crack, int end);
} quantities[] = {
    {"opening_first", MPM_DIMENSION_LENGTH, 0,
     "normal opening at its first point, or where it enters a body behind that", is_followed,
     opening_at},
    {"sliding_first", MPM_DIMENSION_LENGTH, 0, "tangential opening there", is_followed, sliding_at},
    {"opening_last", MPM_DIMENSION_LENGTH, 1,
     "normal opening at its last point, or where it leaves a body before that", is_followed,
     opening_at},
    {"sliding_last", MPM_DIMENSION_LENGTH, 1, "tangential opening there", is_followed, sliding_at},
    {"opening_largest", MPM_DIMENSION_LENGTH, 0, "largest normal opening", is_followed,
     opening_largest},
    {"sliding_largest", MPM_DIMENSION_LENGTH, 0,
     "tangential opening, where it is largest in magnitude", is_followed, sliding_largest},
    {"opening_mean", MPM_DIMENSION_LENGTH, 0, "mean of the normal opening over its cohesive area",
     is_cohesive, opening_mean},
    {"nodes_without_contact", MPM_DIMENSION_NONE, 0,
     "nodes beside it in the last step whose velocity fields contact leaves alone",
     mpm_crack_has_contact, nodes_without_contact},
};

static bool has_row(const struct mpm_scene *scene, size_t crack, size_t row)
{
    return quantities[row].asked(scene, crack);
}

static struct mpm_quantity_rows rows_of(const struct mpm_scene *scene)
{
    return (struct mpm_quantity_rows){scene->crack_count, sizeof quantities / sizeof quantities[0],
                                      has_row};
}

size_t mpm_scene_crack_quantity_count(const struct mpm_scene *scene)
{
    const struct mpm_quantity_rows rows = rows_of(scene);
    return mpm_quantity_rows_count(&rows, scene);
}

struct mpm_quantity_info mpm_scene_crack_quantity(const struct mpm_scene *scene, size_t index)
{
    const struct mpm_quantity_rows rows = rows_of(scene);
    const struct mpm_quantity_place place = mpm_quantity_rows_place(&rows, scene, index);
    const struct quantity *const quantity = &quantities[place.row];
    struct mpm_quantity_info info = {
        .dimension = quantity->dimension,
        .description = quantity->description,
    };
    (void)snprintf(info.name, sizeof info.name, "crack_%zu_%s", place.member, quantity->name);
    return info;
}

double mpm_simulation_crack_quantity(const struct mpm_simulation *simulation, size_t index)
{
    const struct mpm_quantity_rows rows = rows_of(simulation->scene);
    const struct mpm_quantity_place place =
        mpm_quantity_rows_place(&rows, simulation->scene, index);
    const struct quantity *const quantity = &quantities[place.row];
    return quantity->value(simulation, place.member, quantity->end);
}

/* Which edges of which particles bear a load: settled when the simulation is created.
 *
 * A load on a face of a body acts on the edges on that side of those particles that have no
 * neighbour of the same body there: whether the lattice site beyond the edge belongs to the body,
 * as created. Faces across the lattice become staircase approximations. The axis r = 0 is no face;
 * a plane of symmetry is none for what flows, since it insulates.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/loads/edge_loads.h"

#include "model/fill.h"
#include "simulation/simulation.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const char *const edge_names[MPM_EDGE_COUNT + 1] = {
    [MPM_EDGE_BOTTOM] = "bottom", [MPM_EDGE_RIGHT] = "right", [MPM_EDGE_TOP] = "top",
    [MPM_EDGE_LEFT] = "left",     [MPM_EDGE_ALL] = "all",
};

/* "loads.tractions.0.value" */
enum { KEY_SIZE = 96 };
static const char *key_of(const struct mpm_edge_load_spec *load, const char *last,
                          char key[KEY_SIZE])
{
    (void)snprintf(key, KEY_SIZE, "%s.%s", load->key, last);
    return key;
}

/* ------------------------------------------------------------------ finding */

struct finder {
    const struct mpm_state *state;
    double half[2];
    uint32_t id;                 /* of the site in hand, or of the first one of the body */
    size_t first, end;           /* loads that are searched */
    size_t count;                /* of edges found */
    struct mpm_edge_site *sites; /* NULL: only counts */
};

/* Of half a particle: an edge as close to a plane lies on it. */
static const double ON_PLANE = 1e-6;

/* `step`: from the particle to the edge, in halves of it. */
static bool is_on_symmetry(const struct finder *finder, const double site[2], const int step[2])
{
    const struct mpm_state *const state = finder->state;
    bool on_plane = false;
    for (size_t k = 0; k < state->symmetries.count; k++) {
        const struct mpm_symmetry *const plane = &state->symmetries.planes[k];
        const double half = finder->half[plane->axis];
        const double edge = site[plane->axis] + step[plane->axis] * half;
        on_plane = on_plane || (step[plane->axis] != 0 &&
                                fabs(edge - mpm_symmetry_place(state, plane)) <= ON_PLANE * half);
    }
    return on_plane;
}

static bool is_face(const struct finder *finder, const struct mpm_edge_load_spec *spec,
                    const double site[2], enum mpm_edge edge)
{
    static const int step[MPM_EDGE_COUNT][2] = {
        [MPM_EDGE_BOTTOM] = {0, -1},
        [MPM_EDGE_RIGHT] = {1, 0},
        [MPM_EDGE_TOP] = {0, 1},
        [MPM_EDGE_LEFT] = {-1, 0},
    };
    const struct mpm_scene *const scene = finder->state->scene;
    const double beyond[2] = {site[0] + 2.0 * step[edge][0] * finder->half[0],
                              site[1] + 2.0 * step[edge][1] * finder->half[1]};
    if (scene->geometry == MPM_AXISYMMETRIC && beyond[0] <= 0.0)
        return false;
    if (spec->flux != MPM_NO_FLUX && is_on_symmetry(finder, site, step[edge]))
        return false;
    return !mpm_body_contains_site(scene, &finder->state->grid, spec->body, beyond);
}

static double initial_area(const struct finder *finder, const double site[2], enum mpm_edge edge)
{
    const struct mpm_shape_domain domain = {
        .position = {site[0], site[1]},
        .half_size = {finder->half[0], finder->half[1]},
        .edge = {finder->half[0], 0.0, 0.0, finder->half[1]},
    };
    const struct mpm_state *const state = finder->state;
    const struct mpm_edge_line line =
        mpm_edge_find(state->family, &state->shape_grid, &domain, edge);
    return mpm_edge_area(&state->shape_grid, &line, state->scene->thickness);
}

static void find_edges(struct finder *finder, size_t load, const double site[2])
{
    const struct mpm_edge_load_spec *const spec = &finder->state->scene->edge_loads[load];
    for (int edge = 0; edge < MPM_EDGE_COUNT; edge++) {
        if ((spec->edge != MPM_EDGE_ALL && (int)spec->edge != edge) ||
            !is_face(finder, spec, site, (enum mpm_edge)edge))
            continue;
        if (finder->sites != NULL)
            finder->sites[finder->count] = (struct mpm_edge_site){
                .id = finder->id,
                .load = (uint32_t)load,
                .edge = (enum mpm_edge)edge,
                .area = initial_area(finder, site, (enum mpm_edge)edge),
            };
        finder->count++;
    }
}

static enum mpm_status visit_site(void *context, size_t body, const double site[2])
{
    struct finder *const finder = context;
    for (size_t load = finder->first; load < finder->end; load++)
        if (finder->state->scene->edge_loads[load].body == body)
            find_edges(finder, load, site);
    finder->id++;
    return MPM_OK;
}

static enum mpm_status count_edges(struct mpm_simulation *simulation, size_t load,
                                   struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    const struct mpm_edge_load_spec *const spec = &scene->edge_loads[load];
    struct finder finder = {.state = &simulation->state, .first = load, .end = load + 1};
    char key[KEY_SIZE];
    mpm_body_half_size(scene, &simulation->state.grid, spec->body, finder.half);
    MPM_TRY(mpm_body_sites(scene, &simulation->state.grid, spec->body, visit_site, &finder, error));
    simulation->state.edge_loads.count += finder.count;
    if (finder.count > 0)
        return MPM_OK;
    return mpm_scene_error(error, scene, spec->line, key_of(spec, "edge", key),
                           "no particle of body '%s' has an edge on its %s that is not on r = 0%s; "
                           "allowed: a side with a face",
                           scene->bodies[spec->body].name, edge_names[spec->edge],
                           spec->flux == MPM_NO_FLUX ? "" : " or on a plane of symmetry");
}

/* ----------------------------------------------------------------- creating */

enum mpm_status mpm_edge_loads_create(struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    struct mpm_state *const state = &simulation->state;
    struct mpm_edge_loads *const loads = &state->edge_loads;
    if (scene->edge_load_count == 0)
        return MPM_OK;
    loads->value = calloc(scene->edge_load_count, sizeof *loads->value);
    if (loads->value == NULL)
        return mpm_error_memory(error, sizeof *loads->value, "the loads");
    for (size_t load = 0; load < scene->edge_load_count; load++) {
        MPM_TRY(mpm_vector_field_create(scene, &scene->edge_loads[load].value, true, state->workers,
                                        &loads->value[load], error));
        MPM_TRY(count_edges(simulation, load, error));
    }
    return MPM_OK;
}

void mpm_edge_loads_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    struct mpm_edge_loads *const loads = &state->edge_loads;
    if (loads->count == 0)
        return;
    loads->sites = MPM_TAKE(arena, struct mpm_edge_site, loads->count);
    loads->edges = MPM_TAKE(arena, struct mpm_loaded_edge, loads->count);
    loads->first = MPM_TAKE(arena, size_t, (size_t)state->strip_count + 1);
}

/* Ids are given out as bodies are filled: in this order. */
enum mpm_status mpm_edge_loads_fill(struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    struct mpm_state *const state = &simulation->state;
    struct finder finder = {
        .state = state, .end = scene->edge_load_count, .sites = state->edge_loads.sites};
    if (state->edge_loads.count == 0)
        return MPM_OK;
    for (size_t body = 0; body < scene->body_count; body++) {
        mpm_body_half_size(scene, &state->grid, body, finder.half);
        MPM_TRY(mpm_body_sites(scene, &state->grid, body, visit_site, &finder, error));
    }
    return MPM_OK;
}

/* Radiation is of absolute temperatures. */
static enum mpm_status check_radiation(const struct mpm_simulation *simulation,
                                       const struct mpm_edge_load_spec *spec, size_t p,
                                       const struct mpm_expression *ambient, const double place[2],
                                       struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    const double around = mpm_expression_value(ambient, 0, place, 0.0);
    const double own = simulation->state.particles.temperature[p];
    char key[KEY_SIZE];
    if (!(around >= 0.0))
        return mpm_scene_error(error, scene, spec->line, key_of(spec, "radiation.ambient", key),
                               "is %g at (%g, %g), time 0; allowed: absolute, at least 0", around,
                               place[0], place[1]);
    if (own >= 0.0)
        return MPM_OK;
    return mpm_scene_error(error, scene, spec->line, key_of(spec, "radiation", key),
                           "body '%s' has a temperature of %g at (%g, %g), time 0; allowed: "
                           "absolute, at least 0",
                           scene->bodies[spec->body].name, own, place[0], place[1]);
}

/* Values at t = 0 must be finite. Particles are still in creation order, as the sites do. */
enum mpm_status mpm_edge_loads_check_start(const struct mpm_simulation *simulation,
                                           struct mpm_error *error)
{
    const struct mpm_state *const state = &simulation->state;
    size_t p = 0;
    for (size_t k = 0; k < state->edge_loads.count; k++) {
        const struct mpm_edge_site *const site = &state->edge_loads.sites[k];
        const struct mpm_edge_load_spec *const spec = &simulation->scene->edge_loads[site->load];
        double place[2];
        char key[KEY_SIZE];
        while (state->particles.id[p] < site->id)
            p++;
        mpm_edge_load_place(state, site, p, place);
        MPM_TRY(mpm_vector_field_check(simulation, &state->edge_loads.value[site->load], place,
                                       spec->line, key_of(spec, "value", key), error));
        if (spec->flux == MPM_FLUX_RADIATES)
            MPM_TRY(check_radiation(simulation, spec, p,
                                    state->edge_loads.value[site->load].component[0], place,
                                    error));
    }
    return MPM_OK;
}

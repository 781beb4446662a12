/* Manufactured motions, of the suite's cases M1, M4 and M3: displacement against the exact one at
 * the end of a run that started as the order of its update requires (mpm_scene_lags). The run time
 * has the body force in it: a third of the time with uGIMP.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/groups/accuracy.h"

#include "verification/common/failure.h"
#include "verification/exact/manufactured/manufactured.h"

#include <math.h>

enum { AXES = 2 };

/* As in scenes/manufactured.yaml. */
#define BAR_SPEED 100.0
static const double YOUNG = 1e7, POISSON = 0.3, DENSITY = 1000.0;
/* Part of a cell that a wave crosses in a step, undeformed; strains here leave it under 0.4. */
static const double COURANT = 0.3;

/* A field, its geometry and amplitude. */
struct motion {
    const char *field;
    enum mpm_geometry geometry;
    double amplitude;
};
static const struct motion AXIS_ALIGNED = {"axis_aligned", MPM_PLANE_STRAIN, 1e-4};
static const struct motion CYLINDER = {"cylinder", MPM_AXISYMMETRIC, 0.05};
static const struct motion VORTEX = {"vortex", MPM_PLANE_STRAIN, 0.2};

static enum mpm_status open_motion(const struct motion *motion,
                                   struct manufactured_problem *problem, struct mpm_error *error)
{
    const struct manufactured_setup setup = {
        .field = motion->field,
        .law = "neo_hookean",
        .geometry = motion->geometry,
        .density = DENSITY,
        .bulk = YOUNG / (3.0 * (1.0 - 2.0 * POISSON)),
        .shear = YOUNG / (2.0 * (1.0 + POISSON)),
    };
    TRY(manufactured_open(&setup, problem, error));
    return manufactured_set(problem, "amplitude", motion->amplitude, error);
}

/* ------------------------------------------------------------------ settings */

static char *scene(const struct bench_context *context)
{
    return bench_scene(context, "manufactured.yaml");
}

static void set_step(GPtrArray *settings, double cell)
{
    /* of plane waves, over those of a bar: sqrt((1 - nu) / ((1 + nu) (1 - 2 nu))) */
    const double faster = sqrt((1.0 - POISSON) / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON)));
    accuracy_set(settings, "time.step=%.17g", COURANT * cell / (BAR_SPEED * faster));
}

/* A body that slides on the edges of the grid; r = 0 needs no condition. */
static void set_box(GPtrArray *settings, unsigned cells, double height, bool has_axis)
{
    const double cell[AXES] = {1.0 / cells, height / cells};
    accuracy_set(settings, "geometry=%s", has_axis ? "axisymmetric" : "plane_strain");
    accuracy_set(settings, "grid.cell=[%.17g,%.17g]", cell[0], cell[1]);
    accuracy_set(settings, "grid.cells=[%u,%u]", cells, cells);
    accuracy_set(settings, "bodies.body.region.rectangle.to=[1,%.17g]", height);
    accuracy_set(settings,
                 "boundary=[{region: {line: {from: [1, 0], to: [1, %.17g]}}, velocity: [0, free]}, "
                 "{region: {line: {from: [0, 0], to: [1, 0]}}, velocity: [free, 0]}, "
                 "{region: {line: {from: [0, %.17g], to: [1, %.17g]}}, velocity: [free, 0]}%s]",
                 height, height, height,
                 has_axis ? ""
                          : ", {region: {line: {from: [0, 0], to: [0, 1]}}, velocity: [0, free]}");
    set_step(settings, fmin(cell[0], cell[1]));
}

static void set_square(GPtrArray *settings, unsigned cells)
{
    set_box(settings, cells, 1.0, false);
}

static void set_cylinder(GPtrArray *settings, unsigned cells)
{
    set_box(settings, cells, 0.75, true);
}

/* A ring within a grid of 3 by 3: nothing happens at its rims. */
static void set_ring(GPtrArray *settings, unsigned cells)
{
    const double cell = 3.0 / cells;
    accuracy_set(settings, "grid.origin=[-1.5,-1.5]");
    accuracy_set(settings, "grid.cell=[%.17g,%.17g]", cell, cell);
    accuracy_set(settings, "grid.cells=[%u,%u]", cells, cells);
    accuracy_set(settings,
                 "bodies.body.region={annulus: {center: [0, 0], inner: 0.75, outer: 1.25}}");
    set_step(settings, cell);
}

/* ---------------------------------------------------------------- the motion */

/* What the callback needs while the simulation lives. */
struct begun {
    struct manufactured_problem problem;
    struct manufactured_load load;
    double *places;
};

static void finish(void *item)
{
    struct begun *const begun = item;
    g_free(begun->places);
    g_free(begun);
}

static enum mpm_status start(const struct begun *begun, struct mpm_simulation *simulation,
                             const struct mpm_scene *scene, struct mpm_error *error)
{
    const struct mpm_simulation_options options = {.threads = 1};
    const struct mpm_lags lags = mpm_scene_lags(scene);
    struct mpm_plan plan;
    TRY(mpm_scene_plan(scene, &options, &plan, error));
    return manufactured_start(&begun->problem, begun->places, &lags, plan.time_step, simulation,
                              error);
}

static void *begin(const struct motion *motion, struct mpm_simulation *simulation,
                   const struct mpm_scene *scene, struct mpm_error *error)
{
    struct begun *const begun = g_new0(struct begun, 1);
    begun->places = g_new(double, AXES *mpm_simulation_particle_count(simulation));
    begun->load = (struct manufactured_load){&begun->problem, begun->places};
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, begun->places);
    const struct mpm_body_force force = {manufactured_load_evaluate, &begun->load};
    enum mpm_status status = open_motion(motion, &begun->problem, error);
    if (status == MPM_OK)
        status = mpm_simulation_set_body_force(simulation, &force, error);
    if (status == MPM_OK)
        status = start(begun, simulation, scene, error);
    if (status == MPM_OK)
        return begun;
    finish(begun);
    return NULL;
}

/* Squares over the mean square of the exact displacement. */
static void look(const struct motion *motion, const struct particle_set *particles, double time,
                 struct accuracy_sum *sum)
{
    struct manufactured_problem problem;
    struct mpm_error error;
    double squares = 0.0, whole = 0.0;
    if (open_motion(motion, &problem, &error) != MPM_OK)
        return;
    for (size_t k = 0; k < particles->count; k++) {
        const double *const place = &particles->start[AXES * k];
        struct manufactured_state state;
        manufactured_evaluate(&problem, place, time, &state);
        for (size_t axis = 0; axis < AXES; axis++) {
            const double moved = particles->position[AXES * k + axis] - place[axis];
            const double off = moved - state.displacement[axis];
            squares += off * off;
            whole += state.displacement[axis] * state.displacement[axis];
        }
    }
    sum->squares += squares / whole;
    sum->count++;
}

#define MOTION(name, of)                                                                           \
    static void *begin_##name(struct mpm_simulation *simulation, const struct mpm_scene *of_scene, \
                              struct mpm_error *error)                                             \
    {                                                                                              \
        return begin(&(of), simulation, of_scene, error);                                          \
    }                                                                                              \
    static void look_##name(const struct particle_set *particles, double time,                     \
                            struct accuracy_sum *sums)                                             \
    {                                                                                              \
        look(&(of), particles, time, sums);                                                        \
    }
MOTION(square, AXIS_ALIGNED)
MOTION(cylinder, CYLINDER)
MOTION(ring, VORTEX)

#define OF(motion)                                                                                 \
    .set = set_##motion, .begin = begin_##motion, .look = look_##motion, .finish = finish,         \
    .scene = scene, .headline = "error_displacement",                                              \
    .headline_words = "error of displacement, relative", .errors = {"error_displacement"},         \
    .interval = (double)INFINITY
#define ERROR_WORDS                                                                                \
    ". The error is that of the displacement at the end, root mean square over all particles, "    \
    "relative to the displacement. Velocity and F start at the times that each order of update "   \
    "carries them at; the body force is evaluated at each particle in each step and is part of "   \
    "the time"

const struct accuracy_problem accuracy_manufactured[ACCURACY_MANUFACTURED] = {
    {
        .name = "M1",
        .title = "M1: waves along the axes of a square, amplitude 1e-4 of its side",
        .description = "A manufactured motion of the unit square, neo-Hookean, plane strain, with "
                       "one wave a side; particles stay in their cells" ERROR_WORDS,
        .cells = {8, 16, 32, 48},
        .end = 0.4 * 2.0 / BAR_SPEED,
        OF(square),
    },
    {
        .name = "M4",
        .title = "M4: waves in a cylinder, amplitude 5 % of its radius",
        .description = "A manufactured motion of a cylinder that slides in its box, neo-Hookean, "
                       "axisymmetric, with strains of 16 % on the axis; particles cross cells on "
                       "the finer grids" ERROR_WORDS,
        .cells = {12, 24, 48},
        .end = 0.4 * 2.0 / BAR_SPEED,
        OF(cylinder),
    },
    {
        .name = "M3",
        .title = "M3: generalized vortex, largest angle 0.2",
        .description = "A manufactured motion of a ring whose circles turn each by an angle of "
                       "its own, with shear up to 1.2; cells count along the grid, three times "
                       "the mean radius" ERROR_WORDS,
        .cells = {24, 48, 96},
        .end = 0.2 * 2.0 / BAR_SPEED,
        OF(ring),
    },
};

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/manufactured_level.h"

#include "verification/programs/follow.h"

#include <glib.h>
#include <math.h>

enum { AXES = 2, GRADIENT = 5, STRESS = 4, LARGEST = GRADIENT, SETTINGS = 3, COLUMNS = 7 };

const char *const manufactured_suffix[MANUFACTURED_QUANTITIES] = {"_u", "_v", "_F", "_stress"};

/* The off-diagonal component of a symmetric tensor counts twice. */
static const double STRESS_MULTIPLE[STRESS] = {1.0, 1.0, 1.0, 2.0};
static const double IDENTITY[GRADIENT] = {1.0, 0.0, 0.0, 1.0, 1.0};

static const struct quantity {
    size_t components;
    const double *multiple;
    enum mpm_field field;
} QUANTITIES[MANUFACTURED_QUANTITIES] = {
    [MANUFACTURED_DISPLACEMENT] = {AXES, NULL, MPM_FIELD_POSITION},
    [MANUFACTURED_VELOCITY] = {AXES, NULL, MPM_FIELD_VELOCITY},
    [MANUFACTURED_DEFORMATION] = {GRADIENT, NULL, MPM_FIELD_DEFORMATION_GRADIENT},
    [MANUFACTURED_STRESS] = {STRESS, STRESS_MULTIPLE, MPM_FIELD_STRESS},
};

/* A run with its scratch memory. */
struct run {
    const struct manufactured_problem *problem;
    const struct manufactured_level *level;
    struct manufactured_outcome *outcome;
    struct mpm_simulation *simulation;
    struct mpm_lags lags;
    double step;
    size_t count;
    double *places;           /* 2 a particle */
    double *mass, *weight;    /* of all; 0 near the edges, which are not measured */
    double *computed, *exact; /* LARGEST a particle each */
    double product,
        square; /* of computed and exact displacement, over particles and sampled times */
};

/* From a place of the initial state to the nearest edge of the domain; the axis of an axisymmetric
 * one counts as an edge. */
static double edge_distance(const struct manufactured_domain *domain, const double place[AXES])
{
    if (domain->region == MANUFACTURED_ANNULUS) {
        const double radius = hypot(place[0], place[1]);
        return fmin(radius - domain->inner, domain->outer - radius);
    }
    const double x = fmin(place[0] - domain->low[0], domain->high[0] - place[0]);
    return fmin(x, fmin(place[1] - domain->low[1], domain->high[1] - place[1]));
}

static void open_run(struct run *run)
{
    const size_t n = mpm_simulation_particle_count(run->simulation);
    run->count = n;
    run->places = g_new(double, AXES *n);
    run->mass = g_new(double, n);
    run->weight = g_new0(double, n);
    run->computed = g_new(double, LARGEST *n);
    run->exact = g_new(double, LARGEST *n);
    mpm_simulation_field(run->simulation, MPM_FIELD_POSITION, run->places);
    mpm_simulation_field(run->simulation, MPM_FIELD_MASS, run->mass);
    for (size_t p = 0; p < n; p++)
        if (edge_distance(&run->problem->domain, &run->places[AXES * p]) >= run->level->margin)
            run->weight[p] = run->mass[p];
}

static void close_run(struct run *run)
{
    g_free(run->places);
    g_free(run->mass);
    g_free(run->weight);
    g_free(run->computed);
    g_free(run->exact);
}

/* ------------------------------------------------------------ exact values */

/* How far the quantity is behind the time of the simulation. */
static double lag_of(const struct run *run, enum manufactured_quantity quantity)
{
    const double steps = quantity == MANUFACTURED_DISPLACEMENT ? run->lags.position
                         : quantity == MANUFACTURED_VELOCITY   ? run->lags.velocity
                                                               : run->lags.deformation;
    return steps * run->step;
}

static void exact_of_particle(const struct run *run, enum manufactured_quantity quantity,
                              size_t particle, double time, double *values)
{
    struct manufactured_state state;
    manufactured_evaluate(run->problem, &run->places[AXES * particle], time, &state);
    const double *const from[MANUFACTURED_QUANTITIES] = {state.displacement, state.velocity,
                                                         state.deformation, state.stress};
    for (size_t c = 0; c < QUANTITIES[quantity].components; c++)
        values[c] = from[quantity][c];
}

/* The exact values of all particles when the simulation's clock shows `time`. */
static void exact_at(const struct run *run, enum manufactured_quantity quantity, double time,
                     double *values)
{
    for (size_t p = 0; p < run->count; p++)
        exact_of_particle(run, quantity, p, time - lag_of(run, quantity),
                          &values[QUANTITIES[quantity].components * p]);
}

/* ----------------------------------------------------------------- the run */

static enum mpm_status start(struct run *run, struct mpm_error *error)
{
    const struct mpm_lags none = {.position = 0.0};
    return manufactured_start(run->problem, run->places, run->level->at_once ? &none : &run->lags,
                              run->step, run->simulation, error);
}

static enum mpm_status advance(struct run *run, struct measurement *m, unsigned steps,
                               bool *finished, struct mpm_error *error)
{
    for (unsigned k = 0; *finished && k < steps; k++)
        TRY(follow_step(m, run->simulation, HUGE_VAL, finished, error));
    if (!*finished)
        measurement_note(m, "that was the run with grid.refine=%u", run->level->refine);
    return MPM_OK;
}

/* Places become displacements since the start, F becomes F - I. The displacement counts from
 * the time of the scheme's first position. */
static void make_comparable(struct run *run, enum manufactured_quantity quantity)
{
    const size_t components = QUANTITIES[quantity].components;
    double first[AXES];
    for (size_t p = 0; p < run->count; p++) {
        double *const computed = &run->computed[components * p];
        double *const exact = &run->exact[components * p];
        if (quantity == MANUFACTURED_DISPLACEMENT)
            exact_of_particle(run, quantity, p, -lag_of(run, quantity), first);
        for (size_t c = 0; c < components; c++)
            if (quantity == MANUFACTURED_DISPLACEMENT) {
                computed[c] -= run->places[AXES * p + c];
                exact[c] -= first[c];
            } else if (quantity == MANUFACTURED_DEFORMATION) {
                computed[c] -= IDENTITY[c];
                exact[c] -= IDENTITY[c];
            }
    }
}

/* Adds to the sums of the amplitude. */
static void project(struct run *run)
{
    for (size_t k = 0; k < AXES * run->count; k++) {
        run->product += run->mass[k / AXES] * run->computed[k] * run->exact[k];
        run->square += run->mass[k / AXES] * run->exact[k] * run->exact[k];
    }
}

/* Columns 0 and 1 the place, 2 and 3 the displacement, then |error| of u, F and stress. */
static void fill_rows(const struct run *run, enum manufactured_quantity quantity, double *rows)
{
    static const size_t column[MANUFACTURED_QUANTITIES] = {4, 0, 5, 6};
    const struct quantity *const q = &QUANTITIES[quantity];
    for (size_t p = 0; column[quantity] > 0 && p < run->count; p++) {
        double *const row = &rows[COLUMNS * p], square = 0.0;
        for (size_t c = 0; c < q->components; c++) {
            const double difference =
                run->computed[q->components * p + c] - run->exact[q->components * p + c];
            square += (q->multiple == NULL ? 1.0 : q->multiple[c]) * difference * difference;
        }
        row[column[quantity]] = sqrt(square);
        for (size_t c = 0; quantity == MANUFACTURED_DISPLACEMENT && c < AXES; c++) {
            row[c] = run->places[AXES * p + c];
            row[AXES + c] = run->computed[AXES * p + c];
        }
    }
}

/* Fills norms[quantity][look]; `rows` of the series, or NULL. */
static void look(struct run *run, unsigned number, struct error_norms *const norms[], double *rows)
{
    const double time = run->step * (double)mpm_simulation_step(run->simulation);
    for (unsigned k = 0; k < MANUFACTURED_QUANTITIES; k++) {
        const enum manufactured_quantity quantity = (enum manufactured_quantity)k;
        const struct quantity *const q = &QUANTITIES[k];
        mpm_simulation_field(run->simulation, q->field, run->computed);
        exact_at(run, quantity, time, run->exact);
        make_comparable(run, quantity);
        if (quantity == MANUFACTURED_DISPLACEMENT)
            project(run);
        if (rows != NULL)
            fill_rows(run, quantity, rows);
        norms[k][number] = error_norms(run->count, q->components, q->multiple, run->weight,
                                       run->computed, run->exact);
    }
}

static enum mpm_status write_fields(struct measurement *m, const struct run *run,
                                    const double *rows, struct mpm_error *error)
{
    return measurement_series(m, run->level->series, "X Y u_x u_y error_u error_F error_stress",
                              COLUMNS, run->count, rows, error);
}

/* From sample to sample, to the end or to where the run breaks. */
static enum mpm_status follow_looks(struct run *run, struct measurement *m,
                                    struct error_norms *const norms[], struct mpm_error *error)
{
    const struct manufactured_level *const level = run->level;
    struct manufactured_outcome *const outcome = run->outcome;
    double *const rows = level->series == NULL ? NULL : g_new0(double, COLUMNS * run->count);
    enum mpm_status status = MPM_OK;
    outcome->finished = true;
    for (unsigned k = 0; status == MPM_OK && outcome->finished && k < level->looks; k++) {
        status = advance(run, m, level->steps / level->looks, &outcome->finished, error);
        if (status == MPM_OK && outcome->finished)
            look(run, k, norms, k + 1 == level->looks ? rows : NULL);
    }
    if (status == MPM_OK && outcome->finished && rows != NULL)
        status = write_fields(m, run, rows, error);
    g_free(rows);
    return status;
}

static enum mpm_status follow(struct run *run, struct measurement *m, struct mpm_error *error)
{
    struct manufactured_outcome *const outcome = run->outcome;
    const unsigned looks = run->level->looks;
    struct error_norms *const all = g_new0(struct error_norms, MANUFACTURED_QUANTITIES * looks);
    struct error_norms *norms[MANUFACTURED_QUANTITIES];
    for (unsigned k = 0; k < MANUFACTURED_QUANTITIES; k++)
        norms[k] = &all[k * looks];
    const enum mpm_status status = follow_looks(run, m, norms, error);
    for (unsigned k = 0; status == MPM_OK && outcome->finished && k < MANUFACTURED_QUANTITIES;
         k++) {
        outcome->norms[k] = error_norms_over_time(looks, norms[k]);
        outcome->amplitude = run->product / run->square;
    }
    g_free(all);
    return status;
}

static enum mpm_status drive(void *context, struct measurement *m, const struct mpm_scene *scene,
                             struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct run *const run = context;
    run->simulation = simulation;
    run->lags = mpm_scene_lags(scene);
    open_run(run);
    struct manufactured_load load = {.problem = run->problem, .places = run->places};
    const struct mpm_body_force force = {.evaluate = manufactured_load_evaluate, .context = &load};
    TRY(mpm_simulation_set_body_force(run->simulation, &force, error));
    TRY(start(run, error));
    TRY(follow(run, m, error));
    follow_count_work(m, run->simulation);
    return MPM_OK;
}

static void forget(struct manufactured_outcome *outcome)
{
    const double nan = (double)NAN;
    *outcome = (struct manufactured_outcome){.amplitude = nan};
    for (unsigned k = 0; k < MANUFACTURED_QUANTITIES; k++)
        outcome->norms[k] = (struct error_norms){nan, nan, nan, nan, nan};
}

enum mpm_status manufactured_level_run(struct measurement *measurement,
                                       const struct manufactured_problem *problem,
                                       const struct manufactured_level *level,
                                       struct manufactured_outcome *outcome,
                                       struct mpm_error *error)
{
    struct run run = {
        .problem = problem, .level = level, .outcome = outcome, .step = level->end / level->steps};
    char *const settings[SETTINGS] = {
        g_strdup_printf("grid.refine=%u", level->refine),
        g_strdup_printf("time.step=%.17g", run.step),
        g_strdup_printf("bodies.0.particles_per_cell=[%u, %u]", level->particles, level->particles),
    };
    forget(outcome);
    const enum mpm_status status =
        follow_scene(measurement, (const char *const *)settings, SETTINGS, drive, &run, error);
    close_run(&run);
    for (size_t k = 0; k < SETTINGS; k++)
        g_free(settings[k]);
    return status;
}

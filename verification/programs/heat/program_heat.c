/* Family H: temperatures of particles against exact fields of conduction (heat_problem.h), and heat
 * against what went in.
 *
 * The scene runs to its end; all particles are held against the exact field at their places then.
 *
 * With `from` and `to`, particles that began between these x alone count.
 *
 * Reports: error_l2, error_worst (% of scale), axis_worst (of particles within a tenth of the
 * length from x = origin), probe (T at the parameter `probe` along the axis), heat_imbalance
 * (|change of heat - what went in| over the sum of their sizes), unchanged (1 if no bit of any
 * temperature has changed since t = 0), beyond (of convection: how far the highest temperature of
 * all steps is beyond that of the environment, % of scale), asymmetry (of radiation: largest
 * difference of a particle and its mirror image across x = origin, % of scale), spread (standard
 * deviation over that at t = 0), of a spot conducted (the diffusivity by which its second moment
 * has grown, over the mean of those given) and, with `cell`, own_conduction (the rest of it, in h^2
 * over the step), finished; orders over levels. Series: profile; with `picture`, temperature.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/error_norms.h"
#include "verification/programs/follow.h"
#include "verification/programs/heat/heat_problem.h"
#include "verification/programs/levels.h"
#include "verification/programs/picture.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { COLUMNS = 6 };

/* Particles, those that count first. */
struct particles {
    size_t count, counting;
    double *first, *value, *wanted, *mass, *start, *position;
};

struct outcome {
    bool finished;
    double error_l2, error_worst, axis_worst, probe, imbalance, spread, conducted, own_conduction;
    double beyond, asymmetry;
    bool unchanged;
};

/* ------------------------------------------------------------------ measuring */

static double quantity(const struct mpm_scene *scene, const struct mpm_simulation *simulation,
                       const char *name)
{
    for (size_t k = 0; k < mpm_scene_transport_quantity_count(scene); k++)
        if (strcmp(mpm_scene_transport_quantity(scene, k).name, name) == 0)
            return mpm_simulation_transport_quantity(simulation, k);
    return (double)NAN;
}

static double imbalance(const struct mpm_scene *scene, const struct mpm_simulation *simulation,
                        double start)
{
    const double change = quantity(scene, simulation, "thermal_energy") - start;
    const double held = quantity(scene, simulation, "boundary_heat");
    const double source = quantity(scene, simulation, "source_heat");
    const double edges = quantity(scene, simulation, "edge_heat");
    return fabs(change - held - source - edges) /
           (fabs(start) + fabs(change) + fabs(held) + fabs(source) + fabs(edges));
}

static double deviation(size_t count, const double *value)
{
    double sum = 0.0, square = 0.0;
    for (size_t p = 0; p < count; p++)
        sum += value[p];
    for (size_t p = 0; p < count; p++)
        square += (value[p] - sum / (double)count) * (value[p] - sum / (double)count);
    return sqrt(square / (double)count);
}

/* Mean of the particles nearest to a place on either side of it, weighted by their distance from
 * it: linear between two columns of a lattice. */
static double probe_at(const struct heat_problem *problem, size_t count, const double *position,
                       const double *value)
{
    double below = -HUGE_VAL, above = HUGE_VAL, sum[2] = {0.0, 0.0};
    size_t n[2] = {0, 0};
    const double slack = 1e-9;
    for (size_t p = 0; p < count; p++) {
        const double place = heat_problem_place(problem, position + HEAT_AXES * p);
        if (place <= problem->probe)
            below = fmax(below, place);
        else
            above = fmin(above, place);
    }
    for (size_t p = 0; p < count; p++) {
        const double place = heat_problem_place(problem, position + HEAT_AXES * p);
        const size_t side = fabs(place - below) < slack ? 0 : 1;
        if (side == 0 || fabs(place - above) < slack) {
            sum[side] += value[p];
            n[side]++;
        }
    }
    const double part = (problem->probe - below) / (above - below);
    return (1.0 - part) * sum[0] / (double)n[0] + part * sum[1] / (double)n[1];
}

struct study {
    const struct heat_problem *problem;
    struct outcome *outcome;
    bool last;
};

static enum mpm_status write_profile(struct measurement *m, const struct particles *particles,
                                     struct mpm_error *error)
{
    double *const rows = g_new(double, COLUMNS * particles->counting);
    for (size_t p = 0; p < particles->counting; p++) {
        double *const row = rows + COLUMNS * p;
        memcpy(row, particles->position + HEAT_AXES * p, HEAT_AXES * sizeof *row);
        row[2] = particles->value[p];
        row[3] = particles->wanted[p];
        memcpy(row + 4, particles->start + HEAT_AXES * p, HEAT_AXES * sizeof *row);
    }
    const enum mpm_status status =
        measurement_series(m, "profile", "x y temperature exact start_x start_y", COLUMNS,
                           particles->counting, rows, error);
    g_free(rows);
    return status;
}

static enum mpm_status write_picture(struct measurement *m, const struct mpm_simulation *simulation,
                                     struct mpm_error *error)
{
    struct picture picture = {.pixel = 0.0};
    bool asked;
    TRY(picture_read(m, &picture, &asked, error));
    return asked ? picture_write(m, &picture, simulation, MPM_FIELD_TEMPERATURE, 0, "temperature",
                                 error)
                 : MPM_OK;
}

/* <r^2> of the excess over the start, of places at t = 0: w^2 (1 + 1)/2 of a spot of width w, and
 * it grows by 2 (k_1 + k_2) t. */
static double second_moment(const struct heat_problem *problem, const struct particles *particles,
                            const double *value)
{
    double sum = 0.0, square = 0.0;
    for (size_t p = 0; p < particles->count; p++) {
        const double *const start = particles->start + HEAT_AXES * p;
        const double x = start[0] - problem->center[0], y = start[1] - problem->center[1];
        const double excess = particles->mass[p] * (value[p] - problem->start);
        sum += excess;
        square += excess * (x * x + y * y);
    }
    return square / sum;
}

static void compare(const struct heat_problem *problem, const struct particles *particles,
                    struct outcome *outcome)
{
    const double percent = 100.0 / problem->scale, *const value = particles->value;
    const struct error_norms norms =
        error_norms(particles->counting, 1, NULL, particles->mass, value, particles->wanted);
    outcome->error_l2 = percent * norms.l2;
    outcome->error_worst = percent * norms.linf;
    for (size_t p = 0; p < particles->counting; p++)
        if (heat_problem_place(problem, particles->position + HEAT_AXES * p) < 0.1)
            outcome->axis_worst =
                fmax(outcome->axis_worst, percent * fabs(value[p] - particles->wanted[p]));
    outcome->probe = probe_at(problem, particles->counting, particles->position, value);
}

static void measure_spot(const struct heat_problem *problem, const struct particles *particles,
                         const struct mpm_simulation *simulation, struct outcome *outcome)
{
    const double time = mpm_simulation_time(simulation);
    const double mean = 0.5 * (problem->diffusivity + problem->second);
    const double seen = (second_moment(problem, particles, particles->value) -
                         second_moment(problem, particles, particles->first)) /
                        (4.0 * time);
    outcome->conducted = seen / mean;
    outcome->own_conduction =
        (seen - mean) * time /
        ((double)mpm_simulation_step(simulation) * problem->cell * problem->cell);
}

static void exchange(double *values, size_t size, size_t one, size_t other)
{
    for (size_t k = 0; k < size; k++) {
        const double kept = values[size * one + k];
        values[size * one + k] = values[size * other + k];
        values[size * other + k] = kept;
    }
}

/* At the end; of all particles, since those that count go to the front. */
static void look_at(const struct heat_problem *problem, const struct mpm_simulation *simulation,
                    struct particles *particles, struct outcome *outcome)
{
    const size_t count = particles->count;
    double *const arrays[] = {particles->first, particles->value, particles->wanted,
                              particles->mass};
    mpm_simulation_field(simulation, MPM_FIELD_TEMPERATURE, particles->value);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, particles->position);
    mpm_simulation_field(simulation, MPM_FIELD_MASS, particles->mass);
    for (size_t p = 0; p < count; p++)
        particles->wanted[p] = heat_problem_exact(
            problem, particles->start + HEAT_AXES * p, particles->position + HEAT_AXES * p,
            mpm_simulation_time(simulation), particles->first[p]);
    outcome->unchanged = memcmp(particles->first, particles->value, count * sizeof(double)) == 0;
    outcome->spread = deviation(count, particles->value) / deviation(count, particles->first);
    particles->counting = problem->to > problem->from ? 0 : count;
    for (size_t p = 0; p < count && problem->to > problem->from; p++) {
        const double x = particles->start[HEAT_AXES * p];
        if (x < problem->from || x > problem->to)
            continue;
        for (size_t k = 0; k < G_N_ELEMENTS(arrays); k++)
            exchange(arrays[k], 1, particles->counting, p);
        exchange(particles->start, HEAT_AXES, particles->counting, p);
        exchange(particles->position, HEAT_AXES, particles->counting, p);
        particles->counting++;
    }
}

static struct particles make_particles(size_t count)
{
    return (struct particles){.count = count,
                              .first = g_new0(double, count),
                              .value = g_new0(double, count),
                              .wanted = g_new0(double, count),
                              .mass = g_new0(double, count),
                              .start = g_new0(double, HEAT_AXES *count),
                              .position = g_new0(double, HEAT_AXES *count)};
}

static void free_particles(struct particles *particles)
{
    g_free(particles->first);
    g_free(particles->value);
    g_free(particles->wanted);
    g_free(particles->mass);
    g_free(particles->start);
    g_free(particles->position);
}

/* The highest temperature of all steps. */
static enum mpm_status follow_highest(struct measurement *m, const struct mpm_scene *scene,
                                      struct mpm_simulation *simulation, double *highest,
                                      bool *alive, struct mpm_error *error)
{
    const double end = mpm_scene_end_time(scene);
    *highest = quantity(scene, simulation, "temperature_max");
    while (*alive && mpm_simulation_time(simulation) < end) {
        TRY(follow_step(m, simulation, end, alive, error));
        *highest = fmax(*highest, quantity(scene, simulation, "temperature_max"));
    }
    return MPM_OK;
}

/* Of scenes with few particles. */
static double asymmetry(const struct heat_problem *problem, const struct particles *particles)
{
    double worst = 0.0;
    for (size_t p = 0; p < particles->count; p++) {
        const double *const one = particles->position + HEAT_AXES * p;
        double nearest = HUGE_VAL, difference = 0.0;
        for (size_t q = 0; q < particles->count; q++) {
            const double *const other = particles->position + HEAT_AXES * q;
            const double away = hypot(one[0] + other[0] - 2.0 * problem->origin, one[1] - other[1]);
            if (away < nearest) {
                nearest = away;
                difference = fabs(particles->value[p] - particles->value[q]);
            }
        }
        worst = fmax(worst, difference);
    }
    return fmax(100.0 / problem->scale * worst, 1e-17); /* of a percentage: none */
}

static enum mpm_status measure_scene(void *context, struct measurement *m,
                                     const struct mpm_scene *scene,
                                     struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct study *const study = context;
    struct outcome *const outcome = study->outcome;
    struct particles particles = make_particles(mpm_simulation_particle_count(simulation));
    const double heat = quantity(scene, simulation, "thermal_energy");
    double highest = 0.0;
    outcome->finished = true;
    mpm_simulation_field(simulation, MPM_FIELD_TEMPERATURE, particles.first);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, particles.start);
    enum mpm_status status =
        study->problem->kind == HEAT_CONVECTION
            ? follow_highest(m, scene, simulation, &highest, &outcome->finished, error)
            : follow_to(m, simulation, mpm_scene_end_time(scene), &outcome->finished, error);
    follow_count_work(m, simulation);
    if (status == MPM_OK) {
        outcome->beyond = 100.0 * ((highest - study->problem->start) / study->problem->scale - 1.0);
        look_at(study->problem, simulation, &particles, outcome);
        compare(study->problem, &particles, outcome);
        outcome->imbalance = imbalance(scene, simulation, heat);
        if (study->problem->kind == HEAT_SPOT)
            measure_spot(study->problem, &particles, simulation, outcome);
        if (study->problem->kind == HEAT_RADIATION)
            outcome->asymmetry = asymmetry(study->problem, &particles);
    }
    if (status == MPM_OK && study->last)
        status = write_profile(m, &particles, error);
    if (status == MPM_OK && study->last)
        status = write_picture(m, simulation, error);
    free_particles(&particles);
    return status;
}

/* ------------------------------------------------------------------ reporting */

static void report(struct measurement *m, const struct heat_problem *problem,
                   const struct outcome *outcome)
{
    const double missing = outcome->finished ? 0.0 : (double)NAN;
    levels_report_value(m, "error_l2", "", missing + outcome->error_l2);
    levels_report_value(m, "error_worst", "", missing + outcome->error_worst);
    levels_report_value(m, "axis_worst", "", missing + outcome->axis_worst);
    if (problem->probe > 0.0)
        levels_report_value(m, "probe", "", missing + outcome->probe);
    if (problem->kind == HEAT_CONVECTION)
        levels_report_value(m, "beyond", "", missing + outcome->beyond);
    if (problem->kind == HEAT_RADIATION)
        levels_report_value(m, "asymmetry", "", missing + outcome->asymmetry);
    if (problem->kind == HEAT_SPOT && problem->diffusivity > 0.0)
        levels_report_value(m, "conducted", "", missing + outcome->conducted);
    if (problem->kind == HEAT_SPOT && problem->cell > 0.0)
        levels_report_value(m, "own_conduction", "", missing + outcome->own_conduction);
    measurement_report(m, "unchanged", outcome->unchanged ? 1.0 : 0.0);
    if (isfinite(outcome->spread))
        measurement_report(m, "spread", outcome->spread);
    measurement_report(m, "finished", outcome->finished ? 1.0 : 0.0);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct heat_problem problem = {.kind = HEAT_KEPT};
    struct levels levels;
    struct outcome outcome = {.finished = false};
    double l2[LEVELS_MAX] = {0.0}, worst[LEVELS_MAX] = {0.0}, probes[LEVELS_MAX] = {0.0};
    double unbalanced = 0.0;
    TRY(heat_problem_read(m, &problem, error));
    TRY(levels_read(m, &levels, error));
    for (size_t k = 0; k < levels_runs(&levels); k++) {
        outcome = (struct outcome){.finished = false};
        struct study study = {&problem, &outcome, k + 1 == levels_runs(&levels)};
        TRY(follow_scene(m, &levels.setting[k], levels.count == 0 ? 0 : 1, measure_scene, &study,
                         error));
        const double missing = outcome.finished ? 0.0 : (double)NAN;
        l2[k] = missing + outcome.error_l2;
        worst[k] = missing + outcome.error_worst;
        probes[k] = missing + outcome.probe;
        unbalanced = fmax(unbalanced, outcome.imbalance);
        measurement_note(m, "level %zu: error %.6g %% (worst %.6g %%), probe %.6f", k + 1, l2[k],
                         worst[k], probes[k]);
    }
    report(m, &problem, &outcome);
    measurement_report(m, "heat_imbalance", unbalanced);
    if (levels.count == 0)
        return MPM_OK;
    TRY(levels_report(m, &levels, "_l2", l2, error));
    return levels_report(m, &levels, "_worst", worst, error);
}

const struct measure_program program_heat = {
    .name = "heat",
    .summary = "temperatures against exact fields of conduction, heat against what went in",
    .run = run,
};

/* Family H: temperatures of particles against exact fields of conduction (heat.h), and heat against
 * what went in.
 *
 * The scene runs to its end; all particles are held against the exact field at their places then.
 * With v one of the fields of heat.h, at the place (x - origin)/length along an axis or from a
 * centre:
 *
 *   driven   T = scale v(frequency)                           NAFEMS T3
 *   held     T = start + scale v                              a surface held at start + scale
 *   flux     T = start + scale v                              scale = q a/k
 *   wave     T = scale sin(p x + q y + phase) exp(-decay t)   manufactured, by the scene's source
 *   product  T = scale cos(p x) cos(q y) exp(-decay t)        manufactured, insulated at whole p, q
 *   ramp     T = scale (phase + p x + q y) exp(-decay t)      manufactured, linear
 *   mode     T = scale v                                      first mode of a sphere
 *   spot     T = start + scale v                              a hot spot, in material coordinates:
 *                                                             of the place at t = 0
 *   passing  T = scale v(speed)                               a rod through a held place
 *   steady   T = start + scale v                              linear in the place
 *   kept     T = that of the particle at t = 0
 *
 * With `table`, points "T k T k ..." of a conductivity, T - start above is the rise of Kirchhoff's
 * theta over that of start, and T follows from it (kirchhoff.h).
 *
 * With `from` and `to`, particles that began between these x alone count.
 *
 * Reports: error_l2, error_worst (% of scale), axis_worst (of particles within a tenth of the
 * length from x = origin), probe (T at the parameter `probe` along the axis), heat_imbalance
 * (|change of heat - what went in| over the sum of their sizes), unchanged (1 if no bit of any
 * temperature has changed since t = 0), spread (standard deviation over that at t = 0), of a spot
 * conducted (the diffusivity by which its second moment has grown, over the mean of those given)
 * and, with `cell`, own_conduction (the rest of it, in h^2 over the step), finished; orders over
 * levels. Series: profile; with `picture`, temperature.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/failure.h"
#include "verification/exact/heat.h"
#include "verification/exact/kirchhoff.h"
#include "verification/measures/error_norms.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"
#include "verification/programs/picture.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { AXES = 2, COLUMNS = 6 };
static const double PI = 3.14159265358979323846;

enum kind { DRIVEN, HELD, FLUX, WAVE, PRODUCT, RAMP, MODE, SPOT, PASSING, STEADY, KEPT, KINDS };
static const char *const kind_names[KINDS] = {"driven",  "held",   "flux", "wave",
                                              "product", "ramp",   "mode", "spot",
                                              "passing", "steady", "kept"};
static const char *const body_names[HEAT_BODIES] = {"slab", "cylinder", "sphere"};

struct problem {
    enum kind kind;
    enum heat_body body;
    double scale, start, length, origin, diffusivity;
    double frequency;                          /* over pi */
    double p, q, phase;                        /* over pi, but for a ramp */
    double decay, probe;                       /* probe over the length */
    double center[AXES], width, second, angle; /* of a spot; diffusivity along its other axis */
    double speed, cell;
    double from, to; /* of places at t = 0 */
    unsigned along;
    struct kirchhoff table; /* without points: none */
};

/* Particles, those that count first. */
struct particles {
    size_t count, counting;
    double *first, *value, *wanted, *mass, *start, *position;
};

struct outcome {
    bool finished;
    double error_l2, error_worst, axis_worst, probe, imbalance, spread, conducted, own_conduction;
    bool unchanged;
};

/* ------------------------------------------------------------------ the problem */

static enum mpm_status optional(const struct measurement *m, const char *name, double *value,
                                struct mpm_error *error)
{
    return measurement_has(m, name) ? measurement_number(m, name, value, error) : MPM_OK;
}

static enum mpm_status read_table(const struct measurement *m, struct kirchhoff *table,
                                  struct mpm_error *error)
{
    const char *text = "";
    if (!measurement_has(m, "table"))
        return MPM_OK;
    TRY(measurement_text(m, "table", &text, error));
    char **const words = g_strsplit(text, " ", -1);
    const size_t count = g_strv_length(words);
    const bool fits = count >= 4 && count % 2 == 0 && count <= (size_t)2 * KIRCHHOFF_POINTS;
    for (size_t k = 0; fits && k < count; k++)
        table->point[k / 2][k % 2] = g_ascii_strtod(words[k], NULL);
    table->count = count / 2;
    g_strfreev(words);
    return fits ? MPM_OK
                : failure_set(error, MPM_BAD_INPUT,
                              "parameter table: got '%s'; allowed: T k T k ..., 2 to %d points",
                              text, (int)KIRCHHOFF_POINTS);
}

static enum mpm_status read_problem(const struct measurement *m, struct problem *problem,
                                    struct mpm_error *error)
{
    size_t kind, body = HEAT_SLAB;
    const struct measurement_parameter needed[] = {{"scale", &problem->scale},
                                                   {"length", &problem->length},
                                                   {"diffusivity", &problem->diffusivity}};
    const struct measurement_parameter others[] = {
        {"start", &problem->start},
        {"origin", &problem->origin},
        {"frequency", &problem->frequency},
        {"p", &problem->p},
        {"q", &problem->q},
        {"phase", &problem->phase},
        {"decay", &problem->decay},
        {"probe", &problem->probe},
        {"center_x", &problem->center[0]},
        {"center_y", &problem->center[1]},
        {"width", &problem->width},
        {"second_diffusivity", &problem->second},
        {"angle", &problem->angle},
        {"speed", &problem->speed},
        {"cell", &problem->cell},
        {"from", &problem->from},
        {"to", &problem->to},
    };
    TRY(measurement_choice(m, "solution", kind_names, KINDS, &kind, error));
    if (measurement_has(m, "body"))
        TRY(measurement_choice(m, "body", body_names, HEAT_BODIES, &body, error));
    if (measurement_has(m, "along"))
        TRY(measurement_count(m, "along", 0, AXES - 1, &problem->along, error));
    TRY(measurement_numbers(m, needed, G_N_ELEMENTS(needed), error));
    for (size_t k = 0; k < G_N_ELEMENTS(others); k++)
        TRY(optional(m, others[k].name, others[k].value, error));
    TRY(read_table(m, &problem->table, error));
    problem->kind = (enum kind)kind;
    problem->body = (enum heat_body)body;
    return MPM_OK;
}

/* x/a or r/a */
static double place_of(const struct problem *problem, const double position[AXES])
{
    if (problem->body == HEAT_SPHERE)
        return hypot(position[0], position[1] - problem->origin) / problem->length;
    return (position[problem->along] - problem->origin) / problem->length;
}

/* Places from the middle of the spot, along its axes. */
static double spot_at(const struct problem *problem, const double start[AXES], double time)
{
    const double degrees = problem->angle / 180.0;
    const double x = start[0] - problem->center[0], y = start[1] - problem->center[1];
    const double c = cos(PI * degrees), s = sin(PI * degrees);
    const double place[AXES] = {c * x + s * y, c * y - s * x};
    const double diffusivity[AXES] = {problem->diffusivity, problem->second};
    return heat_spot(place, problem->width, diffusivity, time);
}

/* With a constant conductivity. */
static double linear(const struct problem *problem, const double start[AXES],
                     const double position[AXES], double time, double at_start)
{
    const double rate = problem->diffusivity / (problem->length * problem->length);
    const double place = place_of(problem, position);
    switch (problem->kind) {
    case DRIVEN:
        return problem->scale * heat_slab_driven(place, rate, PI * problem->frequency, time);
    case HELD:
        return problem->start +
               problem->scale * heat_surface_held(problem->body, place, rate * time);
    case FLUX:
        return problem->start +
               problem->scale * heat_surface_flux(problem->body, place, rate * time);
    case WAVE:
        return problem->scale * exp(-problem->decay * time) *
               sin(PI * (problem->p * position[0] + problem->q * position[1] + problem->phase));
    case PRODUCT:
        return problem->scale *
               heat_product(position, problem->p, problem->q, problem->decay * time);
    case RAMP:
        return problem->scale * exp(-problem->decay * time) *
               (problem->phase + problem->p * position[0] + problem->q * position[1]);
    case MODE:
        return problem->scale * heat_sphere_mode(place, rate * time);
    case SPOT:
        return problem->start + problem->scale * spot_at(problem, start, time);
    case PASSING:
        return problem->scale * heat_passing_rod(position[problem->along] - problem->origin,
                                                 problem->speed, problem->diffusivity);
    case STEADY:
        return problem->start + problem->scale * place;
    case KEPT:
    case KINDS:
    default:
        return at_start;
    }
}

static double exact(const struct problem *problem, const double start[AXES],
                    const double position[AXES], double time, double at_start)
{
    const double value = linear(problem, start, position, time, at_start);
    return problem->table.count == 0
               ? value
               : kirchhoff_temperature(&problem->table, problem->start, value - problem->start);
}

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
static double probe_at(const struct problem *problem, size_t count, const double *position,
                       const double *value)
{
    double below = -HUGE_VAL, above = HUGE_VAL, sum[2] = {0.0, 0.0};
    size_t n[2] = {0, 0};
    const double slack = 1e-9;
    for (size_t p = 0; p < count; p++) {
        const double place = place_of(problem, position + AXES * p);
        if (place <= problem->probe)
            below = fmax(below, place);
        else
            above = fmin(above, place);
    }
    for (size_t p = 0; p < count; p++) {
        const double place = place_of(problem, position + AXES * p);
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
    const struct problem *problem;
    struct outcome *outcome;
    bool last;
};

static enum mpm_status write_profile(struct measurement *m, const struct particles *particles,
                                     struct mpm_error *error)
{
    double *const rows = g_new(double, COLUMNS * particles->counting);
    for (size_t p = 0; p < particles->counting; p++) {
        double *const row = rows + COLUMNS * p;
        memcpy(row, particles->position + AXES * p, AXES * sizeof *row);
        row[2] = particles->value[p];
        row[3] = particles->wanted[p];
        memcpy(row + 4, particles->start + AXES * p, AXES * sizeof *row);
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
static double second_moment(const struct problem *problem, const struct particles *particles,
                            const double *value)
{
    double sum = 0.0, square = 0.0;
    for (size_t p = 0; p < particles->count; p++) {
        const double *const start = particles->start + AXES * p;
        const double x = start[0] - problem->center[0], y = start[1] - problem->center[1];
        const double excess = particles->mass[p] * (value[p] - problem->start);
        sum += excess;
        square += excess * (x * x + y * y);
    }
    return square / sum;
}

static void compare(const struct problem *problem, const struct particles *particles,
                    struct outcome *outcome)
{
    const double percent = 100.0 / problem->scale, *const value = particles->value;
    const struct error_norms norms =
        error_norms(particles->counting, 1, NULL, particles->mass, value, particles->wanted);
    outcome->error_l2 = percent * norms.l2;
    outcome->error_worst = percent * norms.linf;
    for (size_t p = 0; p < particles->counting; p++)
        if (place_of(problem, particles->position + AXES * p) < 0.1)
            outcome->axis_worst =
                fmax(outcome->axis_worst, percent * fabs(value[p] - particles->wanted[p]));
    outcome->probe = probe_at(problem, particles->counting, particles->position, value);
}

static void measure_spot(const struct problem *problem, const struct particles *particles,
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
static void look_at(const struct problem *problem, const struct mpm_simulation *simulation,
                    struct particles *particles, struct outcome *outcome)
{
    const size_t count = particles->count;
    double *const arrays[] = {particles->first, particles->value, particles->wanted,
                              particles->mass};
    mpm_simulation_field(simulation, MPM_FIELD_TEMPERATURE, particles->value);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, particles->position);
    mpm_simulation_field(simulation, MPM_FIELD_MASS, particles->mass);
    for (size_t p = 0; p < count; p++)
        particles->wanted[p] =
            exact(problem, particles->start + AXES * p, particles->position + AXES * p,
                  mpm_simulation_time(simulation), particles->first[p]);
    outcome->unchanged = memcmp(particles->first, particles->value, count * sizeof(double)) == 0;
    outcome->spread = deviation(count, particles->value) / deviation(count, particles->first);
    particles->counting = problem->to > problem->from ? 0 : count;
    for (size_t p = 0; p < count && problem->to > problem->from; p++) {
        const double x = particles->start[AXES * p];
        if (x < problem->from || x > problem->to)
            continue;
        for (size_t k = 0; k < G_N_ELEMENTS(arrays); k++)
            exchange(arrays[k], 1, particles->counting, p);
        exchange(particles->start, AXES, particles->counting, p);
        exchange(particles->position, AXES, particles->counting, p);
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
                              .start = g_new0(double, AXES *count),
                              .position = g_new0(double, AXES *count)};
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

static enum mpm_status measure_scene(void *context, struct measurement *m,
                                     const struct mpm_scene *scene,
                                     struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct study *const study = context;
    struct outcome *const outcome = study->outcome;
    struct particles particles = make_particles(mpm_simulation_particle_count(simulation));
    const double heat = quantity(scene, simulation, "thermal_energy");
    outcome->finished = true;
    mpm_simulation_field(simulation, MPM_FIELD_TEMPERATURE, particles.first);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, particles.start);
    enum mpm_status status =
        follow_to(m, simulation, mpm_scene_end_time(scene), &outcome->finished, error);
    follow_count_work(m, simulation);
    if (status == MPM_OK) {
        look_at(study->problem, simulation, &particles, outcome);
        compare(study->problem, &particles, outcome);
        outcome->imbalance = imbalance(scene, simulation, heat);
        if (study->problem->kind == SPOT)
            measure_spot(study->problem, &particles, simulation, outcome);
    }
    if (status == MPM_OK && study->last)
        status = write_profile(m, &particles, error);
    if (status == MPM_OK && study->last)
        status = write_picture(m, simulation, error);
    free_particles(&particles);
    return status;
}

/* ------------------------------------------------------------------ reporting */

static void report(struct measurement *m, const struct problem *problem,
                   const struct outcome *outcome)
{
    const double missing = outcome->finished ? 0.0 : (double)NAN;
    levels_report_value(m, "error_l2", "", missing + outcome->error_l2);
    levels_report_value(m, "error_worst", "", missing + outcome->error_worst);
    levels_report_value(m, "axis_worst", "", missing + outcome->axis_worst);
    if (problem->probe > 0.0)
        levels_report_value(m, "probe", "", missing + outcome->probe);
    if (problem->kind == SPOT && problem->diffusivity > 0.0)
        levels_report_value(m, "conducted", "", missing + outcome->conducted);
    if (problem->kind == SPOT && problem->cell > 0.0)
        levels_report_value(m, "own_conduction", "", missing + outcome->own_conduction);
    measurement_report(m, "unchanged", outcome->unchanged ? 1.0 : 0.0);
    if (isfinite(outcome->spread))
        measurement_report(m, "spread", outcome->spread);
    measurement_report(m, "finished", outcome->finished ? 1.0 : 0.0);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct problem problem = {.kind = KEPT};
    struct levels levels;
    struct outcome outcome = {.finished = false};
    double l2[LEVELS_MAX] = {0.0}, worst[LEVELS_MAX] = {0.0}, probes[LEVELS_MAX] = {0.0};
    double unbalanced = 0.0;
    TRY(read_problem(m, &problem, error));
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

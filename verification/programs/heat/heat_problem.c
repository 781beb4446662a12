/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/heat/heat_problem.h"

#include "verification/common/failure.h"
#include "verification/exact/heat/heat_edges.h"

#include <glib.h>
#include <math.h>

static const double PI = 3.14159265358979323846;
static const char *const kind_names[HEAT_KINDS] = {
    "driven", "held", "flux", "convection", "radiation", "wave", "product",
    "ramp",   "mode", "spot", "passing",    "steady",    "kept"};
static const char *const body_names[HEAT_BODIES] = {"slab", "cylinder", "sphere"};

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

enum mpm_status heat_problem_read(const struct measurement *m, struct heat_problem *problem,
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
        {"b", &problem->b},
        {"rate", &problem->rate},
        {"material", &problem->material},
        {"from", &problem->from},
        {"to", &problem->to},
    };
    TRY(measurement_choice(m, "solution", kind_names, HEAT_KINDS, &kind, error));
    if (measurement_has(m, "body"))
        TRY(measurement_choice(m, "body", body_names, HEAT_BODIES, &body, error));
    if (measurement_has(m, "along"))
        TRY(measurement_count(m, "along", 0, HEAT_AXES - 1, &problem->along, error));
    TRY(measurement_numbers(m, needed, G_N_ELEMENTS(needed), error));
    for (size_t k = 0; k < G_N_ELEMENTS(others); k++)
        TRY(optional(m, others[k].name, others[k].value, error));
    TRY(read_table(m, &problem->table, error));
    problem->kind = (enum heat_kind)kind;
    problem->body = (enum heat_body)body;
    return MPM_OK;
}

/* x/a or r/a */
double heat_problem_place(const struct heat_problem *problem, const double position[HEAT_AXES])
{
    if (problem->body == HEAT_SPHERE)
        return hypot(position[0], position[1] - problem->origin) / problem->length;
    return (position[problem->along] - problem->origin) / problem->length;
}

/* Places from the middle of the spot, along its axes. */
static double spot_at(const struct heat_problem *problem, const double start[HEAT_AXES],
                      double time)
{
    const double degrees = problem->angle / 180.0;
    const double x = start[0] - problem->center[0], y = start[1] - problem->center[1];
    const double c = cos(PI * degrees), s = sin(PI * degrees);
    const double place[HEAT_AXES] = {c * x + s * y, c * y - s * x};
    const double diffusivity[HEAT_AXES] = {problem->diffusivity, problem->second};
    return heat_spot(place, problem->width, diffusivity, time);
}

/* With a constant conductivity. */
static double linear(const struct heat_problem *problem, const double start[HEAT_AXES],
                     const double position[HEAT_AXES], double time, double at_start)
{
    const double rate = problem->diffusivity / (problem->length * problem->length);
    const double place = heat_problem_place(problem, problem->material != 0.0 ? start : position);
    switch (problem->kind) {
    case HEAT_DRIVEN:
        return problem->scale * heat_slab_driven(place, rate, PI * problem->frequency, time);
    case HEAT_HELD:
        return problem->start +
               problem->scale * heat_surface_held(problem->body, place, rate * time);
    case HEAT_FLUX:
        return problem->start +
               problem->scale * heat_surface_flux(problem->body, place, rate * time);
    case HEAT_CONVECTION:
        return problem->start + problem->scale * heat_surface_convection(problem->body, place,
                                                                         rate * time, problem->b);
    case HEAT_RADIATION:
        return heat_radiated(problem->start, problem->rate, time);
    case HEAT_WAVE:
        return problem->scale * exp(-problem->decay * time) *
               sin(PI * (problem->p * position[0] + problem->q * position[1] + problem->phase));
    case HEAT_PRODUCT:
        return problem->scale *
               heat_product(position, problem->p, problem->q, problem->decay * time);
    case HEAT_RAMP:
        return problem->scale * exp(-problem->decay * time) *
               (problem->phase + problem->p * position[0] + problem->q * position[1]);
    case HEAT_MODE:
        return problem->scale * heat_sphere_mode(place, rate * time);
    case HEAT_SPOT:
        return problem->start + problem->scale * spot_at(problem, start, time);
    case HEAT_PASSING:
        return problem->scale * heat_passing_rod(position[problem->along] - problem->origin,
                                                 problem->speed, problem->diffusivity);
    case HEAT_STEADY:
        return problem->start + problem->scale * place;
    case HEAT_KEPT:
    case HEAT_KINDS:
    default:
        return at_start;
    }
}

double heat_problem_exact(const struct heat_problem *problem, const double start[HEAT_AXES],
                          const double position[HEAT_AXES], double time, double at_start)
{
    const double value = linear(problem, start, position, time, at_start);
    return problem->table.count == 0
               ? value
               : kirchhoff_temperature(&problem->table, problem->start, value - problem->start);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/manufactured/manufactured_field.h"

#include <stdarg.h>
#include <stdio.h>

/* the first comma and blank are passed over */
#define NAME_OF(name) ", " #name
static const char field_names[] = MANUFACTURED_FIELDS(NAME_OF);
#undef NAME_OF
#define NUMBER_OF(name) FIELD_##name,
enum { MANUFACTURED_FIELDS(NUMBER_OF) FIELDS };
#undef NUMBER_OF

static const char *const laws[] = {
    [MANUFACTURED_NEO_HOOKEAN] = "neo_hookean",
    [MANUFACTURED_LINEAR_ELASTIC] = "linear_elastic",
};
enum { LAWS = sizeof laws / sizeof *laws };

enum mpm_status manufactured_refuse(struct mpm_error *error, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    (void)vsnprintf(error->message, sizeof error->message, format, values);
    va_end(values);
    error->status = MPM_BAD_INPUT;
    return MPM_BAD_INPUT;
}

/* ------------------------------------------------------------------- levels */

#ifdef MPM_FAST_V3 /* of the makefile: this build has that level */
static bool runs_v3(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
}
#endif

const struct manufactured_kernels *manufactured_kernels_at(size_t index)
{
    enum { LEVELS = 2 };
    const struct manufactured_kernels *levels[LEVELS] = {&manufactured_kernels_baseline};
#ifdef MPM_FAST_V3 /* of the makefile: this build has that level */
    if (runs_v3()) {
        levels[1] = levels[0];
        levels[0] = &manufactured_kernels_v3;
    }
#endif
    return index < LEVELS ? levels[index] : NULL;
}

void manufactured_evaluate(const struct manufactured_problem *problem, const double place[2],
                           double time, struct manufactured_state *state)
{
    problem->kernels->evaluate(problem, place, time, state);
}

void manufactured_load_evaluate(void *load, double time, size_t count, const uint32_t id[],
                                double *const force[2])
{
    const struct manufactured_load *const given = load;
    given->problem->kernels->load(load, time, count, id, force);
}

/* ------------------------------------------------------------------- tables */

const struct manufactured_field *manufactured_at(size_t index)
{
    return index < FIELDS ? manufactured_kernels_at(0)->fields[index] : NULL;
}

/* The field of that name, or NULL. */
static const struct manufactured_field *find(const char *name)
{
    const struct manufactured_field *field;
    for (size_t k = 0; (field = manufactured_at(k)) != NULL; k++)
        if (strcmp(field->name, name) == 0)
            return field;
    return NULL;
}

const char *manufactured_name(const struct manufactured_field *field)
{
    return field->name;
}

const struct manufactured_parameter *
manufactured_parameter_at(const struct manufactured_field *field, size_t index)
{
    const bool is_one = index < MANUFACTURED_PARAMETERS && field->parameter[index].name != NULL;
    return is_one ? &field->parameter[index] : NULL;
}

/* ------------------------------------------------------------------ problems */

/* sqrt(E / rho0), E = 9 K G / (3 K + G) */
double manufactured_bar_speed(const struct manufactured_problem *problem)
{
    const double k = problem->bulk, g = problem->shear;
    return sqrt(9.0 * k * g / (3.0 * k + g) / problem->density);
}

static void prepare(struct manufactured_problem *problem)
{
    problem->domain = (struct manufactured_domain){0};
    for (int edge = 0; edge < MANUFACTURED_EDGES; edge++)
        problem->edge[edge] = 0;
    problem->field->prepare(problem);
}

static enum mpm_status find_law(const char *name, struct manufactured_problem *problem,
                                struct mpm_error *error)
{
    for (size_t k = 0; k < LAWS; k++)
        if (strcmp(laws[k], name) == 0) {
            problem->law = (enum manufactured_law)k;
            return MPM_OK;
        }
    return manufactured_refuse(error, "law `%s`; allowed: %s, %s", name, laws[0], laws[1]);
}

static enum mpm_status check_modulus(const char *name, double value, struct mpm_error *error)
{
    if (value > 0.0 && isfinite(value))
        return MPM_OK;
    return manufactured_refuse(error, "%s is %g; allowed: above 0", name, value);
}

enum mpm_status manufactured_open(const struct manufactured_setup *setup,
                                  struct manufactured_problem *problem, struct mpm_error *error)
{
    const double values[] = {setup->density, setup->bulk, setup->shear};
    static const char *const names[] = {"density", "bulk modulus", "shear modulus"};
    *problem = (struct manufactured_problem){.field = find(setup->field),
                                             .kernels = manufactured_kernels_at(0),
                                             .geometry = setup->geometry,
                                             .density = setup->density,
                                             .bulk = setup->bulk,
                                             .shear = setup->shear,
                                             .lame = setup->bulk - 2.0 / 3.0 * setup->shear};
    if (problem->field == NULL)
        return manufactured_refuse(error, "field `%s`; allowed: %s", setup->field, field_names + 2);
    for (size_t k = 0; k < sizeof values / sizeof *values; k++)
        if (check_modulus(names[k], values[k], error) != MPM_OK)
            return MPM_BAD_INPUT;
    if (find_law(setup->law, problem, error) != MPM_OK)
        return MPM_BAD_INPUT;
    for (size_t k = 0; k < MANUFACTURED_PARAMETERS; k++)
        problem->parameter[k] = problem->field->parameter[k].value;
    prepare(problem);
    if (problem->geometry == MPM_AXISYMMETRIC && problem->domain.region == MANUFACTURED_ANNULUS)
        return manufactured_refuse(error, "field `%s` fills an annulus; allowed: planar geometries",
                                   setup->field);
    return MPM_OK;
}

enum mpm_status manufactured_set(struct manufactured_problem *problem, const char *name,
                                 double value, struct mpm_error *error)
{
    const struct manufactured_parameter *parameter;
    for (size_t k = 0; (parameter = manufactured_parameter_at(problem->field, k)) != NULL; k++) {
        if (strcmp(parameter->name, name) != 0)
            continue;
        if (!(value >= parameter->low && value <= parameter->high))
            return manufactured_refuse(error, "%s of field `%s` is %g; allowed: %g to %g", name,
                                       problem->field->name, value, parameter->low,
                                       parameter->high);
        problem->parameter[k] = value;
        prepare(problem);
        return MPM_OK;
    }
    char allowed[256] = "";
    size_t used = 0;
    for (size_t k = 0; (parameter = manufactured_parameter_at(problem->field, k)) != NULL; k++)
        used += (size_t)snprintf(allowed + used, sizeof allowed - used, "%s%s", k == 0 ? "" : ", ",
                                 parameter->name);
    return manufactured_refuse(error, "parameter `%s` of field `%s`; allowed: %s", name,
                               problem->field->name, allowed);
}

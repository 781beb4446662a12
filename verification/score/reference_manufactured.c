/* Manufactured solutions as the references of bundles, with the body force that belongs to them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/rows.h"
#include "verification/score/references.h"

#include <glib.h>

static const char *const geometry_names[] = {
    [MPM_PLANE_STRAIN] = "plane_strain",
    [MPM_PLANE_STRESS] = "plane_stress",
    [MPM_AXISYMMETRIC] = "axisymmetric",
};

static enum mpm_status open_field(struct reference_problem *problem,
                                  const struct catalogue_case *entry, struct mpm_error *error)
{
    struct manufactured_problem *field = &problem->manufactured;
    struct manufactured_setup setup = {.field = reference_parameter(entry, "field"),
                                       .law = reference_parameter(entry, "law"),
                                       .density = problem->number[0],
                                       .bulk = problem->number[1],
                                       .shear = problem->number[2]};
    const char *geometry = reference_parameter(entry, "geometry");
    if (setup.field == NULL || setup.law == NULL || geometry == NULL)
        return failure_set(error, MPM_BAD_INPUT,
                           "case %s: bundle: manufactured needs field, law and geometry",
                           entry->file->name);
    for (int g = 0; g < (int)G_N_ELEMENTS(geometry_names); g++)
        if (g_strcmp0(geometry, geometry_names[g]) == 0)
            setup.geometry = (enum mpm_geometry)g;
    TRY(manufactured_open(&setup, field, error));
    const struct manufactured_parameter *own;
    for (size_t i = 0; (own = manufactured_parameter_at(field->field, i)) != NULL; i++) {
        const char *text = reference_parameter(entry, own->name);
        double value;
        if (text != NULL && row_number(text, &value))
            TRY(manufactured_set(field, own->name, value, error));
    }
    return MPM_OK;
}

static void evaluate(const struct reference_problem *problem, const double place[2], double time,
                     double values[SCORE_COLUMNS])
{
    struct manufactured_state state;
    manufactured_evaluate(&problem->manufactured, place, time, &state);
    const double *f = state.deformation;
    for (size_t a = 0; a < 2; a++) {
        values[SCORE_DISPLACEMENT_X + a] = state.displacement[a];
        values[SCORE_VELOCITY_X + a] = state.velocity[a];
        values[SCORE_FORCE_X + a] = state.body_force[a];
    }
    for (size_t c = 0; c < 4; c++)
        values[SCORE_STRESS_XX + c] = state.stress[c];
    values[SCORE_RELATIVE_VOLUME] = (f[0] * f[3] - f[1] * f[2]) * f[4];
}

const struct reference reference_manufactured = {
    "manufactured",
    {"density", "bulk", "shear"},
    {SCORE_DISPLACEMENT_X, SCORE_DISPLACEMENT_Y, SCORE_VELOCITY_X, SCORE_VELOCITY_Y,
     SCORE_STRESS_XX, SCORE_STRESS_YY, SCORE_STRESS_ZZ, SCORE_STRESS_XY, SCORE_RELATIVE_VOLUME,
     SCORE_FORCE_X, SCORE_FORCE_Y},
    open_field,
    evaluate,
};

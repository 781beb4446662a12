/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/statics/static_solution.h"

#include "verification/exact/heat/thermal_disk.h"
#include "verification/exact/homogeneous_load.h"
#include "verification/exact/lame_cylinder.h"
#include "verification/exact/self_weight.h"

#include <math.h>
#include <string.h>

enum { RR = 0, ZZ = 1, TT = 2, YY = 1 };

static enum mpm_status read_numbers(const struct measurement *m, const char *const names[],
                                    size_t count, double numbers[], struct mpm_error *error)
{
    for (size_t k = 0; k < count; k++)
        TRY(measurement_number(m, names[k], &numbers[k], error));
    return MPM_OK;
}

/* ------------------------------------------------------------- homogeneous ones */

enum { STRETCH_X, STRETCH_Y, SIGMA_XX, SIGMA_YY, SIGMA_ZZ };

static struct static_state homogeneous_at(const struct static_solution *s, const double start[2])
{
    const double *const n = s->numbers;
    const double strain[STATIC_AXES] = {n[STRETCH_X] - 1.0, n[STRETCH_Y] - 1.0};
    return (struct static_state){
        .displacement = {strain[0] * (start[0] - s->centre[0]),
                         strain[1] * (start[1] - s->centre[1])},
        .stress = {n[SIGMA_XX], n[SIGMA_YY], n[SIGMA_ZZ]},
        .strain = {strain[0], strain[1]},
    };
}

static enum mpm_status take_homogeneous(bool found, const struct homogeneous_state *state,
                                        double length, struct static_solution *solution,
                                        struct mpm_error *error)
{
    if (!found)
        return failure_set(error, MPM_BAD_INPUT, "%s: no stretch between 0.2 and 5 bears the load",
                           solution->name);
    solution->numbers[STRETCH_X] = state->radial;
    solution->numbers[STRETCH_Y] = state->axial;
    solution->numbers[SIGMA_XX] = state->stress.rr;
    solution->numbers[SIGMA_YY] = state->stress.zz;
    solution->numbers[SIGMA_ZZ] = state->stress.tt;
    solution->stress_scale = fmax(fabs(state->stress.rr), fabs(state->stress.zz));
    solution->strain_scale = fmax(fabs(state->radial - 1.0), fabs(state->axial - 1.0));
    solution->displacement_scale = length * solution->strain_scale;
    solution->at = homogeneous_at;
    return MPM_OK;
}

static enum mpm_status read_end_load(const struct measurement *m, struct static_solution *solution,
                                     struct mpm_error *error)
{
    static const char *const needs[] = {"bulk", "shear", "traction", "power", "length"};
    double n[5];
    struct homogeneous_state state;
    TRY(read_numbers(m, needs, 5, n, error));
    const struct compression_material material = {n[0], n[1]};
    const bool found = homogeneous_end_load(&material, n[2], n[3], &state);
    return take_homogeneous(found, &state, n[4], solution, error);
}

static enum mpm_status read_rim_load(const struct measurement *m, struct static_solution *solution,
                                     struct mpm_error *error)
{
    static const char *const needs[] = {"bulk", "shear", "traction", "length"};
    double n[4];
    struct homogeneous_state state;
    TRY(read_numbers(m, needs, 4, n, error));
    const struct compression_material material = {n[0], n[1]};
    const bool found = homogeneous_rim_load(&material, n[2], &state);
    return take_homogeneous(found, &state, n[3], solution, error);
}

/* The state of a disk under a load on its rim is that of a plane body under it all around: what is
 * along the axis there is out of the plane here. */
static enum mpm_status read_plane(const struct measurement *m, struct static_solution *solution,
                                  struct mpm_error *error)
{
    TRY(read_rim_load(m, solution, error));
    TRY(measurement_number(m, "centre_x", &solution->centre[0], error));
    TRY(measurement_number(m, "centre_y", &solution->centre[1], error));
    double *const n = solution->numbers;
    n[SIGMA_ZZ] = n[SIGMA_YY];
    n[STRETCH_Y] = n[STRETCH_X];
    n[SIGMA_YY] = n[SIGMA_XX];
    return MPM_OK;
}

/* ------------------------------------------------------------------------ Lame */

static struct lame_cylinder lame_of(const struct static_solution *s)
{
    const double *const n = s->numbers;
    return (struct lame_cylinder){n[0], n[1], n[2], n[3], n[4], n[5]};
}

static struct static_state lame_at(const struct static_solution *s, const double start[2])
{
    const struct lame_cylinder cylinder = lame_of(s);
    const struct lame_state here = lame_cylinder_state(&cylinder, start[0]);
    return (struct static_state){
        .displacement = {here.u, 0.0},
        .stress = {[RR] = here.rr, [ZZ] = here.zz, [TT] = here.tt},
        .strain = {(here.rr - cylinder.poisson * (here.tt + here.zz)) / cylinder.young},
    };
}

static enum mpm_status read_lame(const struct measurement *m, struct static_solution *solution,
                                 struct mpm_error *error)
{
    static const char *const needs[] = {"inner",          "outer", "inner_pressure",
                                        "outer_pressure", "young", "poisson"};
    TRY(read_numbers(m, needs, 6, solution->numbers, error));
    const struct lame_cylinder cylinder = lame_of(solution);
    solution->at = lame_at;
    solution->stress_scale = fmax(fabs(cylinder.inner_pressure), fabs(cylinder.outer_pressure));
    solution->displacement_scale = fabs(lame_cylinder_state(&cylinder, cylinder.inner).u);
    solution->strain_scale = solution->displacement_scale / cylinder.inner;
    return MPM_OK;
}

/* ----------------------------------------------------------------- self-weight */

static struct self_weight column_of(const struct static_solution *s)
{
    const double *const n = s->numbers;
    return (struct self_weight){.height = n[0], .weight = n[1], .modulus = n[2], .slope = n[3]};
}

static struct static_state column_at(const struct static_solution *s, const double start[2])
{
    const struct self_weight column = column_of(s);
    return (struct static_state){
        .displacement = {0.0, self_weight_displacement(&column, start[1])},
        .stress = {[YY] = self_weight_stress(&column, start[1])},
        .strain = {0.0, self_weight_stress(&column, start[1]) / column.modulus},
    };
}

static enum mpm_status read_column(const struct measurement *m, struct static_solution *solution,
                                   struct mpm_error *error)
{
    static const char *const needs[] = {"height", "weight", "modulus"};
    TRY(read_numbers(m, needs, 3, solution->numbers, error));
    if (measurement_has(m, "slope")) /* of a weight that grows with the height */
        TRY(measurement_number(m, "slope", &solution->numbers[3], error));
    const struct self_weight column = column_of(solution);
    solution->at = column_at;
    solution->stress_scale = fabs(self_weight_stress(&column, 0.0));
    solution->displacement_scale = fabs(self_weight_displacement(&column, column.height));
    solution->strain_scale = solution->stress_scale / column.modulus;
    return MPM_OK;
}

/* ------------------------------------------------------------------ thermal disk */

static struct thermal_disk disk_of(const struct static_solution *s)
{
    const double *const n = s->numbers;
    return (struct thermal_disk){n[0], n[1], n[2], n[3], n[4], n[5], n[6] != 0.0};
}

/* On a grid of r and z. */
static struct static_state cylinder_at(const struct static_solution *s, const double start[2])
{
    const struct thermal_disk disk = disk_of(s);
    const struct thermal_disk_state here = thermal_disk_state(&disk, start[0]);
    return (struct static_state){
        .displacement = {here.u, 0.0},
        .stress = {[RR] = here.rr, [ZZ] = here.zz, [TT] = here.tt},
        .strain = {here.strain},
    };
}

/* On a grid of x and y, around the centre. */
static struct static_state disk_at(const struct static_solution *s, const double start[2])
{
    enum { SIGMA_OF_X, SIGMA_OF_Y, SIGMA_OF_Z, SIGMA_OF_XY };
    const struct thermal_disk disk = disk_of(s);
    const double x = start[0] - s->centre[0], y = start[1] - s->centre[1], r = hypot(x, y);
    const double c = x / r, d = y / r;
    const struct thermal_disk_state here = thermal_disk_state(&disk, r);
    return (struct static_state){
        .displacement = {here.u * c, here.u * d},
        .stress = {[SIGMA_OF_X] = here.rr * c * c + here.tt * d * d,
                   [SIGMA_OF_Y] = here.rr * d * d + here.tt * c * c,
                   [SIGMA_OF_Z] = here.zz,
                   [SIGMA_OF_XY] = (here.rr - here.tt) * c * d},
        .strain = {here.strain * c * c + here.u / r * d * d,
                   here.strain * d * d + here.u / r * c * c},
    };
}

static enum mpm_status read_thermal(const struct measurement *m, struct static_solution *solution,
                                    struct mpm_error *error)
{
    static const char *const needs[] = {"inner", "outer", "young", "poisson", "expansion", "rise"};
    enum mpm_geometry geometry;
    TRY(read_numbers(m, needs, 6, solution->numbers, error));
    TRY(measurement_geometry(m, &geometry, error));
    solution->numbers[6] = geometry == MPM_PLANE_STRESS ? 1.0 : 0.0;
    const struct thermal_disk disk = disk_of(solution);
    solution->at = geometry == MPM_AXISYMMETRIC ? cylinder_at : disk_at;
    solution->stress_scale = disk.expansion * disk.young * disk.rise;
    solution->strain_scale = disk.expansion * disk.rise;
    solution->displacement_scale = thermal_disk_state(&disk, disk.outer).u;
    return MPM_OK;
}

/* ------------------------------------------------------------------------ table */

enum { END_LOAD, RIM_LOAD, PLANE, LAME, SELF_WEIGHT, THERMAL, SOLUTIONS };

static const char *const names[SOLUTIONS] = {"end_load", "rim_load",    "plane",
                                             "lame",     "self_weight", "thermal"};

static enum mpm_status (*const readers[SOLUTIONS])(const struct measurement *m,
                                                   struct static_solution *solution,
                                                   struct mpm_error *error) = {
    read_end_load, read_rim_load, read_plane, read_lame, read_column, read_thermal};

enum mpm_status static_solution_read(const struct measurement *measurement,
                                     struct static_solution *solution, struct mpm_error *error)
{
    size_t place;
    TRY(measurement_choice(measurement, "solution", names, SOLUTIONS, &place, error));
    *solution = (struct static_solution){.name = names[place]};
    return readers[place](measurement, solution, error);
}

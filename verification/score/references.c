/* Exact solutions as the references of bundles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/references.h"

#include "verification/common/rows.h"
#include "verification/exact/contact/laminate.h"
#include "verification/exact/contact/struck_bars.h"
#include "verification/exact/heat/heat.h"
#include "verification/exact/homogeneous_load.h"
#include "verification/exact/lame_cylinder.h"
#include "verification/exact/plastic/compression.h"
#include "verification/exact/plastic/hill_sphere.h"
#include "verification/exact/self_weight.h"
#include "verification/exact/waves/radial_mode.h"
#include "verification/exact/waves/step_wave.h"
#include "verification/exact/waves/vibrating_bar.h"

#include <glib.h>
#include <math.h>
#include <string.h>

static void vibrating_bar(const struct reference_problem *problem, const double place[2],
                          double time, double values[SCORE_COLUMNS])
{
    const double *n = problem->number;
    const struct vibrating_bar bar = {n[0], n[1], n[2], n[3], VIBRATING_BAR_HELD};
    values[SCORE_DISPLACEMENT_X] = vibrating_bar_displacement(&bar, place[0], time);
    values[SCORE_VELOCITY_X] = vibrating_bar_velocity(&bar, place[0], time);
    /* in references strain Cauchy's stress along the bar is the nominal one */
    values[SCORE_STRESS_XX] = bar.modulus * vibrating_bar_strain(&bar, place[0], time);
}

static void step_wave(const struct reference_problem *problem, const double place[2], double time,
                      double values[SCORE_COLUMNS])
{
    const double *n = problem->number;
    const struct step_wave wave = {n[0], n[1], n[2]};
    const bool behind = place[0] < step_wave_celerity(&wave) * time;
    values[SCORE_VELOCITY_X] = behind ? 0 : -wave.speed;
    values[SCORE_STRESS_XX] = behind ? -step_wave_pressure(&wave) : 0;
}

/* Of an axisymmetric state: r, z and around stand for x, y and z. */
static void set_stress(double values[SCORE_COLUMNS], double rr, double zz, double tt)
{
    values[SCORE_STRESS_XX] = rr;
    values[SCORE_STRESS_YY] = zz;
    values[SCORE_STRESS_ZZ] = tt;
}

static void compression(const struct reference_problem *problem, const double place[2], double time,
                        double values[SCORE_COLUMNS])
{
    const double *n = problem->number, radius = n[0], speed = n[1];
    const struct compression_material material = {n[2], n[3]};
    const double strain = -speed * time / radius, volume = compression_relative_volume(strain);
    const struct compression_stress stress = compression_stress(&material, volume);
    values[SCORE_DISPLACEMENT_X] = strain * place[0];
    values[SCORE_VELOCITY_X] = -speed * place[0] / radius;
    values[SCORE_RELATIVE_VOLUME] = volume;
    set_stress(values, stress.rr, stress.zz, stress.tt);
}

static void lame(const struct reference_problem *problem, const double place[2], double time,
                 double values[SCORE_COLUMNS])
{
    (void)time;
    const double *n = problem->number;
    const struct lame_cylinder cylinder = {n[0], n[1], n[2], n[3], n[4], n[5]};
    const struct lame_state state = lame_cylinder_state(&cylinder, place[0]);
    values[SCORE_DISPLACEMENT_X] = state.u;
    set_stress(values, state.rr, state.zz, state.tt);
}

static void self_weight(const struct reference_problem *problem, const double place[2], double time,
                        double values[SCORE_COLUMNS])
{
    (void)time;
    const double *n = problem->number;
    const struct self_weight column = {.height = n[0], .weight = n[1], .modulus = n[2]};
    values[SCORE_DISPLACEMENT_Y] = self_weight_displacement(&column, place[1]);
    values[SCORE_STRESS_YY] = self_weight_stress(&column, place[1]);
}

/* A hollow sphere on r and z, at rest at the end of each stage: loaded twice, then unloaded. */
static void hill_sphere(const struct reference_problem *problem, const double place[2], double time,
                        double values[SCORE_COLUMNS])
{
    const double *n = problem->number;
    const struct hill_sphere sphere = {n[0], n[1], n[2], n[3], n[4]};
    const double first = n[5], second = n[6], stage = time / n[7];
    const double peak = stage < 0.5 ? 0.0 : stage < 1.5 ? first : second;
    const double pressure = stage < 2.5 ? peak : 0.0;
    const double r = hypot(place[0], place[1]), c = place[0] / r, d = place[1] / r;
    const struct hill_sphere_state state = hill_sphere_state(&sphere, peak, pressure, r);
    values[SCORE_DISPLACEMENT_X] = state.u * c;
    values[SCORE_DISPLACEMENT_Y] = state.u * d;
    set_stress(values, state.rr * c * c + state.tt * d * d, state.rr * d * d + state.tt * c * c,
               state.tt);
    values[SCORE_STRESS_XY] = (state.rr - state.tt) * c * d;
}

/* A body under a traction on its end, its foot held along the axis; at rest. */
static void end_load(const struct reference_problem *problem, const double place[2], double time,
                     double values[SCORE_COLUMNS])
{
    (void)time;
    const double *n = problem->number;
    const struct compression_material material = {n[0], n[1]};
    struct homogeneous_state state;
    /* outside of the range of the stretches: NaN, which no result meets */
    if (!homogeneous_end_load(&material, n[2], n[3], &state))
        state = (struct homogeneous_state){.radial = (double)NAN, .axial = (double)NAN};
    values[SCORE_DISPLACEMENT_X] = (state.radial - 1.0) * place[0];
    values[SCORE_DISPLACEMENT_Y] = (state.axial - 1.0) * place[1];
    values[SCORE_RELATIVE_VOLUME] = state.radial * state.radial * state.axial;
    set_stress(values, state.stress.rr, state.stress.zz, state.stress.tt);
}

/* The first breathing mode; `speed` is the velocity of the rim at t = 0. */
static void radial_mode(const struct reference_problem *problem, const double place[2], double time,
                        double values[SCORE_COLUMNS])
{
    const double *n = problem->number;
    const struct radial_mode_body body = {RADIAL_MODE_CYLINDER, n[0], n[1], n[2], n[3]};
    const double wave = radial_mode_wave_number(&body, 1);
    const double omega = radial_mode_frequency(&body, wave);
    const double velocity = n[4] * radial_mode_displacement(wave, place[0]) /
                            radial_mode_displacement(wave, body.radius);
    values[SCORE_DISPLACEMENT_X] = velocity / omega * sin(omega * time);
    values[SCORE_VELOCITY_X] = velocity * cos(omega * time);
}

/* A block on an incline: gravity comes on as (1 - cos(pi t/T))/2 until T, friction with it. */
static void sliding(const struct reference_problem *problem, const double place[2], double time,
                    double values[SCORE_COLUMNS])
{
    static const double PI = 3.141592653589793238463;
    const double acceleration = problem->number[0], rise = problem->number[1];
    (void)place;
    values[SCORE_VELOCITY_X] =
        acceleration *
        (time < rise ? 0.5 * (time - rise / PI * sin(PI * time / rise)) : time - 0.5 * rise);
}

/* A bar hits another one, whose struck face is at x = 0. */
static void struck_bars(const struct reference_problem *problem, const double place[2], double time,
                        double values[SCORE_COLUMNS])
{
    const double *n = problem->number;
    const struct struck_bars bars = {{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}, n[6], n[7]};
    const bool second = place[0] >= 0.0;
    const struct struck_state state =
        struck_bars_state(&bars, second, second ? place[0] : -place[0] - bars.gap, time);
    values[SCORE_VELOCITY_X] = state.velocity;
    values[SCORE_STRESS_XX] = state.stress;
}

/* Two layers with an interface, pulled at the upper end; at rest. */
static void laminate(const struct reference_problem *problem, const double place[2], double time,
                     double values[SCORE_COLUMNS])
{
    (void)time;
    const double *n = problem->number, traction = n[5];
    const struct laminate layers = {{n[0], n[1]}, {n[2], n[3]}, n[4]};
    values[SCORE_DISPLACEMENT_Y] = laminate_displacement(&layers, traction, place[1]);
    values[SCORE_STRESS_YY] = traction;
}

/* A bar whose one end is at 0, the other driven by a sine. */
static void driven_heat(const struct reference_problem *problem, const double place[2], double time,
                        double values[SCORE_COLUMNS])
{
    static const double PI = 3.141592653589793238463;
    const double *n = problem->number, length = n[1];
    values[SCORE_TEMPERATURE] =
        n[0] * heat_slab_driven(place[0] / length, n[2] / (length * length), PI * n[3], time);
}

/* A cylinder, cold at first, whose rim is held from then on. */
static void held_cylinder(const struct reference_problem *problem, const double place[2],
                          double time, double values[SCORE_COLUMNS])
{
    const double *n = problem->number, radius = n[1];
    values[SCORE_TEMPERATURE] = time > 0.0
                                    ? n[0] * heat_surface_held(HEAT_CYLINDER, place[0] / radius,
                                                               n[2] / (radius * radius) * time)
                                    : 0.0;
}

/* A field with a source, on a unit square or of r and z. */
static void product_heat(const struct reference_problem *problem, const double place[2],
                         double time, double values[SCORE_COLUMNS])
{
    const double *n = problem->number;
    values[SCORE_TEMPERATURE] = n[0] * heat_product(place, n[1], n[2], n[3] * time);
}

static const struct reference references[] = {
    {"vibrating_bar",
     {"length", "modulus", "density", "amplitude"},
     {SCORE_DISPLACEMENT_X, SCORE_VELOCITY_X, SCORE_STRESS_XX},
     NULL,
     vibrating_bar},
    {"step_wave",
     {"modulus", "density", "speed"},
     {SCORE_VELOCITY_X, SCORE_STRESS_XX},
     NULL,
     step_wave},
    {"compression",
     {"radius", "speed", "bulk", "shear"},
     {SCORE_DISPLACEMENT_X, SCORE_VELOCITY_X, SCORE_RELATIVE_VOLUME, SCORE_STRESS_XX,
      SCORE_STRESS_YY, SCORE_STRESS_ZZ},
     NULL,
     compression},
    {"lame",
     {"inner", "outer", "inner_pressure", "outer_pressure", "young", "poisson"},
     {SCORE_DISPLACEMENT_X, SCORE_STRESS_XX, SCORE_STRESS_YY, SCORE_STRESS_ZZ},
     NULL,
     lame},
    {"hill_sphere",
     {"inner", "outer", "young", "poisson", "yield", "first", "second", "stage"},
     {SCORE_DISPLACEMENT_X, SCORE_DISPLACEMENT_Y, SCORE_STRESS_XX, SCORE_STRESS_YY, SCORE_STRESS_ZZ,
      SCORE_STRESS_XY},
     NULL,
     hill_sphere},
    {"self_weight",
     {"height", "weight", "modulus"},
     {SCORE_DISPLACEMENT_Y, SCORE_STRESS_YY},
     NULL,
     self_weight},
    {"end_load",
     {"bulk", "shear", "traction", "power"},
     {SCORE_DISPLACEMENT_X, SCORE_DISPLACEMENT_Y, SCORE_RELATIVE_VOLUME, SCORE_STRESS_XX,
      SCORE_STRESS_YY, SCORE_STRESS_ZZ},
     NULL,
     end_load},
    {"radial_mode",
     {"radius", "young", "poisson", "density", "speed"},
     {SCORE_DISPLACEMENT_X, SCORE_VELOCITY_X},
     NULL,
     radial_mode},
    {"sliding", {"acceleration", "rise"}, {SCORE_VELOCITY_X}, NULL, sliding},
    {"struck_bars",
     {"length_1", "length_2", "modulus_1", "modulus_2", "density_1", "density_2", "speed", "gap"},
     {SCORE_VELOCITY_X, SCORE_STRESS_XX},
     NULL,
     struck_bars},
    {"laminate",
     {"length_1", "length_2", "modulus_1", "modulus_2", "stiffness", "traction"},
     {SCORE_DISPLACEMENT_Y, SCORE_STRESS_YY},
     NULL,
     laminate},
    {"driven_heat",
     {"scale", "length", "diffusivity", "frequency"},
     {SCORE_TEMPERATURE},
     NULL,
     driven_heat},
    {"product_heat", {"scale", "p", "q", "decay"}, {SCORE_TEMPERATURE}, NULL, product_heat},
    {"held_cylinder", {"scale", "length", "diffusivity"}, {SCORE_TEMPERATURE}, NULL, held_cylinder},
};

static const struct reference *find(const char *name)
{
    for (size_t i = 0; i < G_N_ELEMENTS(references); i++)
        if (strcmp(references[i].name, name) == 0)
            return &references[i];
    return strcmp(reference_manufactured.name, name) == 0 ? &reference_manufactured : NULL;
}

bool reference_has(const struct reference *reference, enum score_column column)
{
    for (size_t i = 0; reference->columns[i] != SCORE_TIME; i++)
        if (reference->columns[i] == column)
            return true;
    return false;
}

static const char *value_of(const struct case_parameter *parameters, unsigned count,
                            const char *name)
{
    for (unsigned i = 0; i < count; i++)
        if (strcmp(parameters[i].name, name) == 0)
            return parameters[i].value;
    return NULL;
}

const char *reference_parameter(const struct catalogue_case *entry, const char *name)
{
    const struct case_file *file = entry->file;
    const char *value = value_of(file->bundle->parameters, file->bundle->parameters_count, name);
    return value != NULL ? value : value_of(file->parameters, file->parameters_count, name);
}

enum mpm_status reference_open(const struct catalogue_case *entry,
                               struct reference_problem *problem, struct mpm_error *error)
{
    const char *name = entry->file->bundle->reference;
    *problem = (struct reference_problem){.reference = find(name)};
    if (problem->reference == NULL)
        return failure_set(error, MPM_BAD_INPUT, "case %s: bundle: reference: there is no \"%s\"",
                           entry->file->name, name);
    for (size_t i = 0; i < REFERENCE_NUMBERS && problem->reference->parameters[i] != NULL; i++) {
        const char *wanted = problem->reference->parameters[i];
        const char *text = reference_parameter(entry, wanted);
        if (text == NULL || !row_number(text, &problem->number[i]) || !isfinite(problem->number[i]))
            return failure_set(error, MPM_BAD_INPUT,
                               "case %s: bundle: %s needs the parameter %s, a finite number",
                               entry->file->name, name, wanted);
    }
    return problem->reference->open == NULL ? MPM_OK
                                            : problem->reference->open(problem, entry, error);
}

/* Constitutive laws: a law is one file and one line of the list MPM_MATERIAL_LAWS.
 *
 * A law gives the Kirchhoff stress over the initial density, tau / rho_0 (Notes 18-22): with it a
 * nodal force needs the particle's mass only, not its current volume or density. Most laws are
 * hyperelastic functions of the whole deformation gradient F; a law may also have state variables,
 * and then its stress depends on the path of F.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_MATERIAL_H
#define MPM_MODEL_MATERIAL_H

#include "base/status.h"
#include "base/tensor.h"
#include "model/property.h"
#include "mpm_dimension.h"

#include <stddef.h>

/* -------------------------------------------------------------- parameters */

/* The parameters of all laws, beside the density: name, key of a material in a scene, dimension
 * (MPM_DIMENSION_... without the prefix), range as in io/scene/scene_keys.h, help. The reader of
 * scenes, `mpm schema` and the struct of a material follow from it. A and B are passed on. A law
 * lists those that it has; it has both moduli, the shear modulus or none, and these are not
 * optional. */
#define MPM_LAW_PARAMETERS(ROW, A, B)                                                              \
    ROW(A, B, BULK, bulk, STRESS, ABOVE(0), "bulk modulus, together with shear")                   \
    ROW(A, B, SHEAR, shear, STRESS, ABOVE(0),                                                      \
        "shear modulus, together with bulk if the law has it")                                     \
    ROW(A, B, YIELD_STRESS, yield_stress, STRESS, ABOVE(0),                                        \
        "in tension, in the Kirchhoff stress, before any plastic strain")                          \
    ROW(A, B, HARDENING_MODULUS, hardening_modulus, STRESS, AT_LEAST(0),                           \
        "linear isotropic hardening: yield stress per equivalent plastic strain")                  \
    ROW(A, B, HARDENING_STRAIN, hardening_strain, NONE, ABOVE(0),                                  \
        "p_0 of isotropic hardening by a power, yield_stress (1 + p/p_0)^n")                       \
    ROW(A, B, HARDENING_EXPONENT, hardening_exponent, NONE, ABOVE_TO(0, 1),                        \
        "n of isotropic hardening by a power of plastic strain")                                   \
    ROW(A, B, HARDENING_COEFFICIENT, hardening_coefficient, STRESS, AT_LEAST(0),                   \
        "B of isotropic hardening by B p^n, together with hardening_exponent")                     \
    ROW(A, B, RATE_COEFFICIENT, rate_coefficient, NONE, AT_LEAST(0),                               \
        "C of the strength of rates, 1 + C ln(plastic rate/reference_rate)")                       \
    ROW(A, B, REFERENCE_RATE, reference_rate, RATE, ABOVE(0),                                      \
        "plastic rate up to which there is no strength of rates")                                  \
    ROW(A, B, SOFTENING_EXPONENT, softening_exponent, NONE, ABOVE(0),                              \
        "m of the softening by heat, 1 - T*^m")                                                    \
    ROW(A, B, REFERENCE_TEMPERATURE, reference_temperature, TEMPERATURE, ABOVE(0),                 \
        "absolute temperature up to which there is no softening")                                  \
    ROW(A, B, MELTING_TEMPERATURE, melting_temperature, TEMPERATURE, ABOVE(0),                     \
        "absolute temperature from which there is no strength")                                    \
    ROW(A, B, TAYLOR_QUINNEY, taylor_quinney, NONE, ABOVE_TO(0, 1),                                \
        "part of plastic work that becomes heat")                                                  \
    ROW(A, B, KINEMATIC_MODULUS, kinematic_modulus, STRESS, AT_LEAST(0),                           \
        "linear kinematic hardening: stress per plastic strain in tension")                        \
    ROW(A, B, GAS_CONSTANT, gas_constant, HEAT_CAPACITY, ABOVE(0),                                 \
        "of an ideal gas, per mass: pressure over density and absolute temperature")               \
    ROW(A, B, SOUND_SPEED, sound_speed, VELOCITY, ABOVE(0),                                        \
        "c_0 of a shock's speed, c_0 + s u behind which the material moves by u")                  \
    ROW(A, B, HUGONIOT_SLOPE, hugoniot_slope, NONE, ABOVE(0), "s of a shock's speed, c_0 + s u")   \
    ROW(A, B, GRUNEISEN, gruneisen, NONE, AT_LEAST(0),                                             \
        "gamma_0 of the initial density: pressure per internal energy of a volume")                \
    ROW(A, B, PRESSURE_CUTOFF, pressure_cutoff, STRESS, AT_LEAST(0),                               \
        "largest tension of an equation of state; no limit if missing")                            \
    ROW(A, B, ADIABATIC_INDEX, adiabatic_index, NONE, ABOVE(1), "gamma of a gas")                  \
    ROW(A, B, START_PRESSURE, start_pressure, STRESS, AT_LEAST(0), "of a gas at its density")      \
    ROW(A, B, STIFFENING_PRESSURE, stiffening_pressure, STRESS, AT_LEAST(0),                       \
        "p_inf of a stiffened gas: the tension at which sound has no speed; 0: an ideal gas")      \
    ROW(A, B, SPECIFIC_HEAT, specific_heat, HEAT_CAPACITY, ABOVE(0),                               \
        "at constant volume, for the temperature of an equation of state or of plastic work")      \
    ROW(A, B, START_TEMPERATURE, start_temperature, TEMPERATURE, ABOVE(0),                         \
        "absolute temperature of the undeformed body, together with specific_heat")

#define MPM_PARAMETER_NAME(a, b, name, ...) MPM_PARAMETER_##name,
enum mpm_parameter { MPM_LAW_PARAMETERS(MPM_PARAMETER_NAME, , ) MPM_PARAMETER_COUNT };
#undef MPM_PARAMETER_NAME

struct mpm_law_parameter {
    enum mpm_parameter which;
    bool optional;
    double fallback; /* its value if a scene does not have it, for an optional one; may be
                        infinite: no limit */
};

/* "bulk": the key of a material in a scene. */
const char *mpm_parameter_key(enum mpm_parameter parameter);

/* --------------------------------------------------------------------- laws */

/* A state variable: a number that each particle of the law has. */
struct mpm_law_variable {
    const char *name;
    struct mpm_dimension dimension;
    double start; /* its value at t = 0 */
    const char *description;
};

struct mpm_material_law;

/* A law with its constants; those in a line with "over rho_0" are length^2 / time^2. */
struct mpm_material {
    const struct mpm_material_law *law;
    double density;          /* rho_0 */
    double bulk;             /* K over rho_0; NaN without */
    double shear;            /* G over rho_0; NaN without */
    double lame;             /* lambda = K - 2 G / 3 over rho_0; NaN without both */
    const double *parameter; /* by enum mpm_parameter, in the scene's units; NaN where the law has
                                none */
    const struct mpm_property
        *hardening; /* s over p, in the scene's units; NULL: without a table */
};

/* From one F to the next. */
struct mpm_law_step {
    const double *old_f, *f;  /* [MPM_GRADIENT_SIZE]; the same if there is no step yet */
    double duration;          /* of this part of a time step: 0 if there is no step yet */
    double temperature;       /* at its end; NaN in a scene that conducts none */
    double heat_capacity;     /* per mass; NaN where deformation gives no heat */
    double heat;              /* work of artificial viscosity in it, per mass */
    double start_temperature; /* at its start; NaN as `temperature` */
};

/* Why `update` has no end of a step. */
enum mpm_law_fault {
    MPM_LAW_NO_RETURN, /* no plastic strain leads back to yield */
    MPM_LAW_NO_STATE,  /* the equation of state has none */
    MPM_LAW_COLD,      /* strength at a temperature below zero */
};

struct mpm_material_law {
    const char *name;
    const char *description;
    const struct mpm_law_parameter *parameters;
    size_t parameter_count;
    const struct mpm_law_variable *variables; /* NULL for a law of F alone */
    size_t variable_count;

    /* One of these two: tau / rho_0, and the square of the fastest wave speed (over the directions
     * of the plane, in the deformed body). F has det F > 0.
     * A law of F alone: */
    void (*stress)(const struct mpm_material *material, const double f[MPM_GRADIENT_SIZE],
                   double stress[MPM_SYMMETRIC_SIZE], double *wave_speed_squared);
    /* A law of the path: changes `state`, its state variables, from the start of the step to its
     * end. Without a step (duration 0) it leaves `state` as it is, and finds the stress of the
     * state at hand. False if there is no such end: of one without a way back to yield
     * `stress` is then that of the trial state. */
    bool (*update)(const struct mpm_material *material, const struct mpm_law_step *step,
                   double *state, double stress[MPM_SYMMETRIC_SIZE], double *wave_speed_squared);

    /* State variables at t = 0; NULL: their `start`. */
    void (*start)(const struct mpm_material *material, double *state);

    /* An equation of state: `energy` is all energy per unit mass, heat included, and stays with
     * the particle. Not for scenes with transport.temperature.
     * `least_volume`: J has to be above it, beside other reasons for `update` to fail. */
    bool keeps_heat;
    double (*least_volume)(const struct mpm_material *material);
    /* `update` once more with the heat of `step`, given `old_state` of the step's start and what
     * `update` without that heat has left, where this takes less than `update`; may be NULL. */
    bool (*reheat)(const struct mpm_material *material, const struct mpm_law_step *step,
                   const double *old_state, double *state, double stress[MPM_SYMMETRIC_SIZE],
                   double *wave_speed_squared);

    /* The stress depends on the temperature: only for scenes that have one. */
    bool reads_temperature;

    /* What follows may be NULL. */

    /* What is wrong with parameters that are within their ranges each, or NULL. By enum
     * mpm_parameter; an optional one that is not given has its fallback. */
    const char *(*fault)(const double *parameter);
    /* The same in a scene without transport.temperature: of parameters that only a conducted
     * temperature has a use for. */
    const char *(*fault_without_heat)(const double *parameter);

    /* Of a law with plastic strain: energy per unit mass that it has dissipated since t = 0; and
     * which of its state variables is the equivalent plastic strain. */
    double (*dissipation)(const struct mpm_material *material, const double *state);
    size_t plastic_strain;

    /* What `update` lacks in a step from `state`, in which it has failed; of laws with more than
     * one reason. Others: MPM_LAW_NO_STATE with keeps_heat, else MPM_LAW_NO_RETURN. */
    enum mpm_law_fault (*fault_of)(const struct mpm_material *material,
                                   const struct mpm_law_step *step, const double *state);

    /* Temperature at the end of a step without flow of heat, from step->temperature at its start;
     * of laws that read it. */
    double (*adiabatic)(const struct mpm_material *material, const struct mpm_law_step *step);

    /* Temperature of an equation of state, of materials that have specific_heat. */
    double (*temperature)(const struct mpm_material *material, const double f[MPM_GRADIENT_SIZE],
                          const double *state);

    /* Strain energy per unit mass; may use logarithms. Without it, each particle carries the work
     * of the stress since t = 0 as one more state variable, which takes its place; a caller may
     * then not give it a deformed start. */
    double (*energy)(const struct mpm_material *material, const double f[MPM_GRADIENT_SIZE],
                     const double *state);
    /* For the energy guard, without logarithms and roots: a number that is not below the sum of
     * mass times energy of the particles from `begin` up to `end`, all of that material, but for
     * round-off of stiffness times mass. `f` has the components of F particle by particle. For laws
     * of F alone; without it, the guard sums the energy. */
    double (*energy_bound)(const struct mpm_material *material, double *const f[MPM_GRADIENT_SIZE],
                           const double *mass, size_t begin, size_t end);
    /* The F_zz that makes tau_zz vanish for the plane part of F. For laws of F alone: without it
     * they have no plane stress. */
    double (*thickness_stretch)(const struct mpm_material *material,
                                const double f[MPM_GRADIENT_SIZE]);
    /* Of a law of the path: does model/laws/plane_stress.h find F_zz? */
    bool plane_stress;

    /* Its yield stress may be a table over the equivalent plastic strain instead of parameters. */
    bool hardening_table;
};

/* One line a law: `const struct mpm_material_law mpm_<name>` in <name>.c. */
#define MPM_MATERIAL_LAWS(LAW)                                                                     \
    LAW(neo_hookean)                                                                               \
    LAW(linear_elastic)                                                                            \
    LAW(von_mises)                                                                                 \
    LAW(johnson_cook)                                                                              \
    LAW(von_mises_gruneisen)                                                                       \
    LAW(johnson_cook_gruneisen)                                                                    \
    LAW(ideal_gas)                                                                                 \
    LAW(mie_gruneisen)                                                                             \
    LAW(stiffened_gas)                                                                             \
    LAW(none)

#define MPM_DECLARE_LAW(name) extern const struct mpm_material_law mpm_##name;
MPM_MATERIAL_LAWS(MPM_DECLARE_LAW)
#undef MPM_DECLARE_LAW

/* The law at `index` of the list, or NULL past its end. */
const struct mpm_material_law *mpm_material_law_at(size_t index);
/* The law of that name, or NULL. */
const struct mpm_material_law *mpm_material_law_find(const char *name);
bool mpm_material_law_has_plane_stress(const struct mpm_material_law *law);
/* "neo_hookean, linear_elastic" */
const char *mpm_material_law_names(void);

/* What a law says of that parameter, or NULL if it does not have it. */
const struct mpm_law_parameter *mpm_law_parameter(const struct mpm_material_law *law,
                                                  enum mpm_parameter which);

/* State variables that a particle of the law carries: its own, and the work of the stress if it has
 * no energy. Up to MPM_LAW_STATES (particles.h). */
size_t mpm_law_state_count(const struct mpm_material_law *law);

/* `parameter`: by enum mpm_parameter, in the scene's units; `hardening`: of the yield stress, NULL
 * or no points without a table. Both must outlive the material. density > 0. */
struct mpm_material mpm_material_make(const struct mpm_material_law *law, double density,
                                      const double *parameter,
                                      const struct mpm_property *hardening);

/* The state variables of a particle at t = 0, those of its law alone. */
void mpm_material_start(const struct mpm_material *material, double *state);

/* Has it a temperature of its own, that of its equation of state? */
bool mpm_material_has_temperature(const struct mpm_material_law *law, const double *parameter);

/* In a scene that conducts heat: part of plastic work that heats the temperature that is conducted,
 * 0 of materials without it; and does that temperature soften it? */
double mpm_material_plastic_heating(const struct mpm_material_law *law, const double *parameter);
bool mpm_material_softens(const struct mpm_material_law *law, const double *parameter);

/* The square of the wave speed in the undeformed body, where all state variables have their start
 * values. */
double mpm_material_start_wave(const struct mpm_material *material);

#endif

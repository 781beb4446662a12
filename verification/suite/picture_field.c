/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/picture_field.h"

#include "verification/common/record.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* Where a field comes from: a component of what particles carry, or a function of one. */
enum source {
    SOURCE_COMPONENT,
    SOURCE_LENGTH,       /* of a vector */
    SOURCE_DISPLACEMENT, /* a component of it */
    SOURCE_DISTANCE,
    SOURCE_VON_MISES,
    SOURCE_PRESSURE,
    SOURCE_DETERMINANT,
};

struct entry {
    struct picture_field_info info;
    enum source source;
    enum mpm_field field;
    size_t component;
};

#define STRESS MPM_DIMENSION_STRESS
static const struct entry entries[PICTURE_FIELD_COUNT] = {
    [PICTURE_SPEED] = {{"speed", "speed", MPM_DIMENSION_VELOCITY, false},
                       SOURCE_LENGTH,
                       MPM_FIELD_VELOCITY,
                       0},
    [PICTURE_VELOCITY_X] = {{"velocity_x", "velocity, first component", MPM_DIMENSION_VELOCITY,
                             true},
                            SOURCE_COMPONENT,
                            MPM_FIELD_VELOCITY,
                            0},
    [PICTURE_VELOCITY_Y] = {{"velocity_y", "velocity, second component", MPM_DIMENSION_VELOCITY,
                             true},
                            SOURCE_COMPONENT,
                            MPM_FIELD_VELOCITY,
                            1},
    [PICTURE_DISPLACEMENT] = {{"displacement", "displacement, magnitude", MPM_DIMENSION_LENGTH,
                               false},
                              SOURCE_DISTANCE,
                              MPM_FIELD_POSITION,
                              0},
    [PICTURE_DISPLACEMENT_X] = {{"displacement_x", "displacement, first component",
                                 MPM_DIMENSION_LENGTH, true},
                                SOURCE_DISPLACEMENT,
                                MPM_FIELD_POSITION,
                                0},
    [PICTURE_DISPLACEMENT_Y] = {{"displacement_y", "displacement, second component",
                                 MPM_DIMENSION_LENGTH, true},
                                SOURCE_DISPLACEMENT,
                                MPM_FIELD_POSITION,
                                1},
    [PICTURE_VON_MISES] = {{"von_mises", "von Mises stress", STRESS, false},
                           SOURCE_VON_MISES,
                           MPM_FIELD_STRESS,
                           0},
    [PICTURE_PRESSURE] = {{"pressure", "pressure", STRESS, true},
                          SOURCE_PRESSURE,
                          MPM_FIELD_STRESS,
                          0},
    [PICTURE_STRESS_XX] = {{"stress_xx", "stress σ₁₁", STRESS, true},
                           SOURCE_COMPONENT,
                           MPM_FIELD_STRESS,
                           0},
    [PICTURE_STRESS_YY] = {{"stress_yy", "stress σ₂₂", STRESS, true},
                           SOURCE_COMPONENT,
                           MPM_FIELD_STRESS,
                           1},
    [PICTURE_STRESS_ZZ] = {{"stress_zz", "stress σ₃₃", STRESS, true},
                           SOURCE_COMPONENT,
                           MPM_FIELD_STRESS,
                           2},
    [PICTURE_STRESS_XY] = {{"stress_xy", "stress σ₁₂", STRESS, true},
                           SOURCE_COMPONENT,
                           MPM_FIELD_STRESS,
                           3},
    [PICTURE_VOLUME_RATIO] = {{"volume_ratio", "volume ratio J", MPM_DIMENSION_NONE, false},
                              SOURCE_DETERMINANT,
                              MPM_FIELD_DEFORMATION_GRADIENT,
                              0},
    [PICTURE_TEMPERATURE] = {{"temperature", "temperature", MPM_DIMENSION_TEMPERATURE, false},
                             SOURCE_COMPONENT,
                             MPM_FIELD_TEMPERATURE,
                             0},
    [PICTURE_CONCENTRATION] = {{"concentration", "concentration", MPM_DIMENSION_NONE, false},
                               SOURCE_COMPONENT,
                               MPM_FIELD_CONCENTRATION,
                               0},
    [PICTURE_PLASTIC_STRAIN] = {{"plastic_strain", "equivalent plastic strain", MPM_DIMENSION_NONE,
                                 false},
                                SOURCE_COMPONENT,
                                MPM_FIELD_PLASTIC_STRAIN,
                                0},
    [PICTURE_INTERNAL_ENERGY] = {{"internal_energy", "internal energy per mass",
                                  MPM_DIMENSION_SPECIFIC_ENERGY, false},
                                 SOURCE_COMPONENT,
                                 MPM_FIELD_INTERNAL_ENERGY,
                                 0},
    [PICTURE_STATE_TEMPERATURE] = {{"state_temperature", "temperature", MPM_DIMENSION_TEMPERATURE,
                                    false},
                                   SOURCE_COMPONENT,
                                   MPM_FIELD_STATE_TEMPERATURE,
                                   0},
    [PICTURE_FRINGE] = {{"fringe", "isochromatic fringe", MPM_DIMENSION_NONE, false},
                        SOURCE_COMPONENT,
                        MPM_FIELD_FRINGE,
                        0},
};

const struct picture_field_info *picture_field_describe(enum picture_field field)
{
    return &entries[field].info;
}

enum picture_field picture_field_by_law(const struct mpm_scene *scene)
{
    static const struct {
        enum mpm_field has;
        enum picture_field shown;
    } rules[] = {
        {MPM_FIELD_PLASTIC_STRAIN, PICTURE_PLASTIC_STRAIN},
        {MPM_FIELD_INTERNAL_ENERGY, PICTURE_PRESSURE},
        {MPM_FIELD_CONCENTRATION, PICTURE_CONCENTRATION},
        {MPM_FIELD_TEMPERATURE, PICTURE_TEMPERATURE},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(rules); i++)
        if (mpm_scene_has_field(scene, rules[i].has))
            return rules[i].shown;
    return PICTURE_VON_MISES;
}

static double value_of(const struct entry *entry, const double *one, const double *start)
{
    switch (entry->source) {
    case SOURCE_COMPONENT:
        return one[entry->component];
    case SOURCE_LENGTH:
        return hypot(one[0], one[1]);
    case SOURCE_DISPLACEMENT:
        return one[entry->component] - start[entry->component];
    case SOURCE_DISTANCE:
        return hypot(one[0] - start[0], one[1] - start[1]);
    case SOURCE_VON_MISES: {
        const double a = one[0] - one[1], b = one[1] - one[2], c = one[2] - one[0];
        return sqrt(0.5 * (a * a + b * b + c * c) + 3 * one[3] * one[3]);
    }
    case SOURCE_PRESSURE:
        return -(one[0] + one[1] + one[2]) / 3;
    case SOURCE_DETERMINANT:
        return (one[0] * one[3] - one[1] * one[2]) * one[4];
    }
    return (double)NAN;
}

void picture_field_values(const struct mpm_simulation *simulation, enum picture_field field,
                          const double *start, double *values)
{
    const struct entry *entry = &entries[field];
    const size_t components = mpm_field_describe(entry->field)->components;
    const size_t count = mpm_simulation_particle_count(simulation);
    double *raw = g_new(double, components *count);
    mpm_simulation_field(simulation, entry->field, raw);
    for (size_t p = 0; p < count; p++)
        values[p] = value_of(entry, &raw[components * p], &start[2 * p]);
    g_free(raw);
}

/* ----------------------------------------------------------------------- units */

/* What a name of a unit is in m, kg, s; NaN of one that is not known. */
static double in_si(const char *name)
{
    static const struct {
        const char *name;
        double size;
    } units[] = {{"m", 1},     {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"µm", 1e-6},
                 {"kg", 1},    {"g", 1e-3},  {"mg", 1e-6}, {"t", 1e3},   {"s", 1},
                 {"ms", 1e-3}, {"us", 1e-6}, {"µs", 1e-6}, {"ns", 1e-9}};
    for (size_t i = 0; i < G_N_ELEMENTS(units); i++)
        if (strcmp(name, units[i].name) == 0)
            return units[i].size;
    return (double)NAN;
}

/* The pascal and its multiples, for stresses; NULL: none fits. */
static const char *pascals(const json_t *units)
{
    static const char *const names[] = {"Pa", "kPa", "MPa", "GPa"};
    const double size = in_si(record_text(units, "mass")) / in_si(record_text(units, "length")) /
                        pow(in_si(record_text(units, "time")), 2);
    for (size_t i = 0; i < G_N_ELEMENTS(names); i++)
        if (fabs(size / pow(10, 3.0 * (double)i) - 1) < 1e-9)
            return names[i];
    return NULL;
}

static void append_power(GString *text, int power)
{
    static const char *const digits[] = {"⁰", "¹", "²", "³", "⁴"};
    if (power == 1)
        return;
    g_string_append_printf(text, "%s%s", power < 0 ? "⁻" : "", digits[abs(power)]);
}

char *picture_field_unit(const json_t *units, struct mpm_dimension dimension)
{
    const struct {
        const char *name;
        int power;
    } parts[] = {{record_text(units, "mass"), dimension.mass},
                 {record_text(units, "length"), dimension.length},
                 {record_text(units, "time"), dimension.time},
                 {record_text(units, "temperature"), dimension.temperature}};
    const bool stress = dimension.mass == 1 && dimension.length == -1 && dimension.time == -2 &&
                        dimension.temperature == 0;
    const char *const pascal = stress ? pascals(units) : NULL;
    GString *text = g_string_new(pascal);
    for (size_t i = 0; pascal == NULL && i < G_N_ELEMENTS(parts); i++) {
        if (parts[i].power == 0)
            continue;
        if (*parts[i].name == '\0') { /* a scene that names no units has numbers alone */
            g_string_assign(text, "1");
            break;
        }
        g_string_append_printf(text, "%s%s", text->len > 0 ? " " : "", parts[i].name);
        append_power(text, parts[i].power);
    }
    if (text->len == 0)
        g_string_assign(text, "1");
    return g_string_free(text, FALSE);
}

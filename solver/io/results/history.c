/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/history.h"

#include "io/results/rows.h"
#include "io/units.h"

#include <glib.h>
#include <math.h>
#include <stddef.h>

static const struct column {
    const char *name;
    size_t offset; /* in struct mpm_ledger */
    bool counts;   /* uint64_t instead of double */
    struct mpm_dimension dimension;
    bool (*belongs)(const struct mpm_scene *); /* NULL: to all scenes */
} columns[] = {
#define COLUMN(member, unit, belongs)                                                              \
    {                                                                                              \
#member, offsetof(struct mpm_ledger, member), false, MPM_DIMENSION_##unit, belongs         \
    }
    COLUMN(time, TIME, NULL),
    {"step", offsetof(struct mpm_ledger, step), true, MPM_DIMENSION_NONE, NULL},
    COLUMN(mass, MASS, NULL),
    {"momentum_x", offsetof(struct mpm_ledger, momentum[0]), false, MPM_DIMENSION_MOMENTUM, NULL},
    {"momentum_y", offsetof(struct mpm_ledger, momentum[1]), false, MPM_DIMENSION_MOMENTUM, NULL},
    COLUMN(angular_momentum, ANGULAR_MOMENTUM, NULL),
    COLUMN(kinetic_energy, ENERGY, NULL),
    COLUMN(strain_energy, ENERGY, NULL),
    COLUMN(external_work, ENERGY, NULL),
    COLUMN(total_energy, ENERGY, NULL),
    COLUMN(j_min, NONE, NULL),
    COLUMN(j_max, NONE, NULL),
    COLUMN(damping_dissipation, ENERGY, mpm_scene_is_damped),
    COLUMN(plastic_dissipation, ENERGY, mpm_scene_is_plastic),
    {"parted_pairs", offsetof(struct mpm_ledger, parted_pairs), true, MPM_DIMENSION_NONE,
     mpm_scene_counts_parted},
    {"melted_particles", offsetof(struct mpm_ledger, melted_particles), true, MPM_DIMENSION_NONE,
     mpm_scene_melts},
    COLUMN(viscous_dissipation, ENERGY, mpm_scene_is_viscous),
    COLUMN(cohesive_stored, ENERGY, mpm_scene_is_cohesive),
    COLUMN(cohesive_dissipated, ENERGY, mpm_scene_is_cohesive),
    COLUMN(contact_stored, ENERGY, mpm_scene_has_contact),
    COLUMN(contact_dissipated, ENERGY, mpm_scene_has_contact),
    COLUMN(expansion_work, ENERGY, mpm_scene_couples),
    COLUMN(deformation_heat, ENERGY, mpm_scene_heats),
    COLUMN(thermoelastic_energy, ENERGY, mpm_scene_heats),
    COLUMN(plastic_heat, ENERGY, mpm_scene_has_plastic_heat),
    COLUMN(transfer_loss, ENERGY, mpm_scene_has_energy_balance),
    COLUMN(contact_loss, ENERGY, mpm_scene_has_contact_loss),
};

/* Quantities that features add, one after the other. */
static const struct {
    size_t (*count)(const struct mpm_scene *);
    struct mpm_quantity_info (*describe)(const struct mpm_scene *, size_t index);
    double (*value)(const struct mpm_simulation *, size_t index);
} sources[] = {
    {mpm_scene_crack_quantity_count, mpm_scene_crack_quantity, mpm_simulation_crack_quantity},
    {mpm_scene_contact_quantity_count, mpm_scene_contact_quantity, mpm_simulation_contact_quantity},
    {mpm_scene_transport_quantity_count, mpm_scene_transport_quantity,
     mpm_simulation_transport_quantity},
};

struct mpm_history {
    const struct mpm_scene *scene;
    struct mpm_rows rows;
    const struct column *columns[G_N_ELEMENTS(columns)]; /* of this scene */
    size_t column_count;                                 /* of these */
};

static void append_number(GString *row, double value)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE]; /* a decimal point in every locale */
    g_string_append(row, g_ascii_formatd(text, sizeof text, "%.17g", value));
}

static void append_value(GString *row, const struct column *column, const struct mpm_ledger *ledger)
{
    const char *value = (const char *)ledger + column->offset;
    if (column->counts)
        g_string_append_printf(row, "%" G_GUINT64_FORMAT, *(const uint64_t *)(const void *)value);
    else
        append_number(row, *(const double *)(const void *)value);
}

static void append_head(GString *names, GString *units, const struct mpm_scene *scene,
                        const char *name, struct mpm_dimension dimension)
{
    char unit[MPM_UNIT_SIZE];
    mpm_unit_text(scene, dimension, unit);
    g_string_append_printf(names, "%s%s", names->len == 0 ? "" : ",", name);
    g_string_append_printf(units, "%s%s", units->len == 0 ? "# " : ",", unit);
}

/* The last two are of tips that grow. */
static const struct {
    const char *name;
    struct mpm_dimension dimension;
    bool over_root; /* of length: K is stress times the root of length */
} integral_columns[] = {
    {"j1", MPM_DIMENSION_TOUGHNESS, false}, {"j2", MPM_DIMENSION_TOUGHNESS, false},
    {"k1", MPM_DIMENSION_TOUGHNESS, true},  {"k2", MPM_DIMENSION_TOUGHNESS, true},
    {"grown", MPM_DIMENSION_LENGTH, false}, {"dissipated", MPM_DIMENSION_ENERGY, false},
};

static size_t integral_column_count(const struct mpm_scene *scene, size_t integral)
{
    return G_N_ELEMENTS(integral_columns) -
           (scene->j_integrals[integral].growth.toughness > 0.0 ? 0 : 2);
}

/* "crack_0_contour_1_j1": of cracks.0.j_integral.1 */
static void append_integrals_head(GString *names, GString *units, const struct mpm_scene *scene)
{
    const char *const length = scene->units_length[0] != '\0' ? scene->units_length : "length";
    size_t place = 0;
    for (size_t i = 0; i < scene->j_integral_count; i++) {
        const size_t crack = scene->j_integrals[i].crack;
        place = i > 0 && scene->j_integrals[i - 1].crack == crack ? place + 1 : 0;
        for (size_t k = 0; k < integral_column_count(scene, i); k++) {
            char *const name =
                g_strdup_printf("crack_%zu_contour_%zu_%s", crack, place, integral_columns[k].name);
            append_head(names, units, scene, name, integral_columns[k].dimension);
            if (integral_columns[k].over_root)
                g_string_append_printf(units, " %s^-0.5", length);
            g_free(name);
        }
    }
}

static GString *head_of(const struct mpm_history *history, const struct mpm_scene *scene)
{
    GString *head = g_string_new(NULL), *units = g_string_new(NULL);
    for (size_t i = 0; i < history->column_count; i++) {
        const struct column *const c = history->columns[i];
        append_head(head, units, scene, c->name, c->dimension);
    }
    for (size_t k = 0; k < G_N_ELEMENTS(sources); k++)
        for (size_t i = 0; i < sources[k].count(scene); i++) {
            const struct mpm_quantity_info q = sources[k].describe(scene, i);
            append_head(head, units, scene, q.name, q.dimension);
        }
    append_integrals_head(head, units, scene);
    g_string_append_printf(head, "\n%s\n", units->str);
    g_string_free(units, TRUE);
    return head;
}

static void choose_columns(struct mpm_history *history, const struct mpm_scene *scene)
{
    for (size_t i = 0; i < G_N_ELEMENTS(columns); i++)
        if (columns[i].belongs == NULL || columns[i].belongs(scene))
            history->columns[history->column_count++] = &columns[i];
}

static struct mpm_history *history_of(const struct mpm_scene *scene)
{
    struct mpm_history *const history = g_new0(struct mpm_history, 1);
    history->scene = scene;
    choose_columns(history, scene);
    return history;
}

/* Frees it after a failure. */
static enum mpm_status opened(enum mpm_status status, struct mpm_history **history)
{
    if (status == MPM_OK)
        return MPM_OK;
    mpm_history_free(*history);
    *history = NULL;
    return status;
}

enum mpm_status mpm_history_create(const char *folder, const struct mpm_scene *scene,
                                   struct mpm_history **history, struct mpm_error *error)
{
    *history = history_of(scene);
    GString *const head = head_of(*history, scene);
    const enum mpm_status status =
        mpm_rows_create(folder, MPM_HISTORY_NAME, head, &(*history)->rows, error);
    g_string_free(head, TRUE);
    return opened(status, history);
}

enum mpm_status mpm_history_reopen(const char *folder, const struct mpm_scene *scene,
                                   struct mpm_history **history, struct mpm_error *error)
{
    *history = history_of(scene);
    return opened(mpm_rows_reopen(folder, MPM_HISTORY_NAME, &(*history)->rows, error), history);
}

void mpm_history_visit(struct mpm_history *history, struct mpm_piece_visitor *visitor)
{
    static const char *const names[] = {"history.size", "history.has_row", "history.last_step"};
    mpm_rows_visit(&history->rows, names, visitor);
}

enum mpm_status mpm_history_cut(struct mpm_history *history, struct mpm_error *error)
{
    return mpm_rows_cut(&history->rows, error);
}

enum mpm_status mpm_history_sync(const struct mpm_history *history, struct mpm_error *error)
{
    return mpm_rows_sync(&history->rows, error);
}

void mpm_history_free(struct mpm_history *history)
{
    if (history == NULL)
        return;
    mpm_rows_close(&history->rows);
    g_free(history);
}

/* One without a value, nan: the first such one is the failure. */
static enum mpm_status append_integrals(const struct mpm_history *history, GString *row,
                                        const struct mpm_simulation *simulation,
                                        struct mpm_error *error)
{
    const double none = (double)NAN;
    enum mpm_status status = MPM_OK;
    for (size_t i = 0; i < history->scene->j_integral_count; i++) {
        struct mpm_j_integral found = {.grown = none, .dissipated = none};
        struct mpm_error second = {.status = MPM_OK};
        const enum mpm_status one =
            mpm_simulation_j_integral(simulation, i, &found, status == MPM_OK ? error : &second);
        if (one != MPM_OK)
            found.j[0] = found.j[1] = found.stress_intensity[0] = found.stress_intensity[1] = none;
        status = status == MPM_OK ? one : status;
        const double values[] = {
            found.j[0],  found.j[1],      found.stress_intensity[0], found.stress_intensity[1],
            found.grown, found.dissipated};
        for (size_t k = 0; k < integral_column_count(history->scene, i); k++) {
            g_string_append_c(row, ',');
            append_number(row, values[k]);
        }
    }
    return status;
}

enum mpm_status mpm_history_write(struct mpm_history *history, const struct mpm_ledger *ledger,
                                  const struct mpm_simulation *simulation, struct mpm_error *error)
{
    if (mpm_rows_have(&history->rows, ledger->step))
        return MPM_OK;
    GString *row = g_string_new(NULL);
    for (size_t i = 0; i < history->column_count; i++) {
        if (i > 0)
            g_string_append_c(row, ',');
        append_value(row, history->columns[i], ledger);
    }
    for (size_t k = 0; k < G_N_ELEMENTS(sources) && simulation != NULL; k++)
        for (size_t i = 0; i < sources[k].count(history->scene); i++) {
            g_string_append_c(row, ',');
            append_number(row, sources[k].value(simulation, i));
        }
    const enum mpm_status found = append_integrals(history, row, simulation, error);
    g_string_append_c(row, '\n');
    const enum mpm_status status = mpm_rows_append(&history->rows, row, ledger->step, error);
    g_string_free(row, TRUE);
    return status != MPM_OK ? status : found;
}

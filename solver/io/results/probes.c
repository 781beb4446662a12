/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/probes.h"

#include "io/results/rows.h"
#include "io/units.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { BLOCK = 4096, COMPONENTS_MAX = 5 };

struct mpm_probes {
    const struct mpm_scene *scene;
    struct mpm_rows rows;
};

/* --------------------------------------------------------------------- head */

static const char *component_name(const struct mpm_scene *scene, size_t components, size_t k)
{
    static const char *const names[2][COMPONENTS_MAX + 1][COMPONENTS_MAX] = {
        {[1] = {""},
         [2] = {"_x", "_y"},
         [4] = {"_xx", "_yy", "_zz", "_xy"},
         [5] = {"_xx", "_xy", "_yx", "_yy", "_zz"}},
        {[1] = {""},
         [2] = {"_r", "_z"},
         [4] = {"_rr", "_zz", "_tt", "_rz"},
         [5] = {"_rr", "_rz", "_zr", "_zz", "_tt"}},
    };
    return names[scene->geometry == MPM_AXISYMMETRIC][components][k];
}

/* Of the scene, but for those that only say which particle it is, and where. */
static bool is_written(const struct mpm_scene *scene, enum mpm_field field)
{
    return field != MPM_FIELD_ID && field != MPM_FIELD_BODY && field != MPM_FIELD_POSITION &&
           field != MPM_FIELD_VOLUME && field != MPM_FIELD_MASS &&
           mpm_scene_has_field(scene, field);
}

static void append_unit(GString *units, const struct mpm_scene *scene,
                        struct mpm_dimension dimension)
{
    char unit[MPM_UNIT_SIZE];
    mpm_unit_text(scene, dimension, unit);
    g_string_append_printf(units, ",%s", unit);
}

static GString *head_of(const struct mpm_scene *scene)
{
    static const struct mpm_dimension length = MPM_DIMENSION_LENGTH, mass = MPM_DIMENSION_MASS;
    const char *const *const axes = mpm_scene_coordinates(scene);
    GString *const head = g_string_new("time,step,name,point");
    GString *const units = g_string_new("# ");
    char unit[MPM_UNIT_SIZE];
    mpm_unit_text(scene, (struct mpm_dimension)MPM_DIMENSION_TIME, unit);
    g_string_append_printf(units, "%s,1,,1", unit);
    g_string_append_printf(head, ",%s,%s,weight", axes[0], axes[1]);
    append_unit(units, scene, length);
    append_unit(units, scene, length);
    append_unit(units, scene, mass);
    for (int field = 0; field < MPM_FIELD_COUNT; field++) {
        const struct mpm_field_info *const info = mpm_field_describe((enum mpm_field)field);
        for (size_t k = 0; is_written(scene, (enum mpm_field)field) && k < info->components; k++) {
            g_string_append_printf(head, ",%s%s", info->name,
                                   component_name(scene, info->components, k));
            append_unit(units, scene, info->dimension);
        }
    }
    g_string_append_printf(head, "\n%s\n", units->str);
    g_string_free(units, TRUE);
    return head;
}

/* --------------------------------------------------------------------- file */

/* Without places there is nothing to open. Frees it after a failure. */
static enum mpm_status open_probes(const char *folder, const struct mpm_scene *scene, bool anew,
                                   struct mpm_probes **probes, struct mpm_error *error)
{
    *probes = NULL;
    if (scene->probe_count == 0)
        return MPM_OK;
    struct mpm_probes *const made = g_new0(struct mpm_probes, 1);
    GString *const head = head_of(scene);
    made->scene = scene;
    const enum mpm_status status =
        anew ? mpm_rows_create(folder, MPM_PROBES_NAME, head, &made->rows, error)
             : mpm_rows_reopen(folder, MPM_PROBES_NAME, &made->rows, error);
    g_string_free(head, TRUE);
    if (status == MPM_OK)
        *probes = made;
    else
        mpm_probes_free(made);
    return status;
}

enum mpm_status mpm_probes_create(const char *folder, const struct mpm_scene *scene,
                                  struct mpm_probes **probes, struct mpm_error *error)
{
    return open_probes(folder, scene, true, probes, error);
}

enum mpm_status mpm_probes_reopen(const char *folder, const struct mpm_scene *scene,
                                  struct mpm_probes **probes, struct mpm_error *error)
{
    return open_probes(folder, scene, false, probes, error);
}

void mpm_probes_visit(struct mpm_probes *probes, struct mpm_piece_visitor *visitor)
{
    static const char *const names[] = {"probes.size", "probes.has_row", "probes.last_step"};
    if (probes != NULL)
        mpm_rows_visit(&probes->rows, names, visitor);
}

enum mpm_status mpm_probes_cut(struct mpm_probes *probes, struct mpm_error *error)
{
    return probes == NULL ? MPM_OK : mpm_rows_cut(&probes->rows, error);
}

void mpm_probes_free(struct mpm_probes *probes)
{
    if (probes == NULL)
        return;
    mpm_rows_close(&probes->rows);
    g_free(probes);
}

enum mpm_status mpm_probes_sync(const struct mpm_probes *probes, struct mpm_error *error)
{
    return probes == NULL ? MPM_OK : mpm_rows_sync(&probes->rows, error);
}

/* ------------------------------------------------------------------- values */

/* A particle that counts at a place. */
struct share {
    size_t id;
    double weight;
};

static double hat(double distance, double cell)
{
    return fmax(0.0, 1.0 - fabs(distance) / cell);
}

/* All particles with a weight at the place; rigid ones have no mass. */
static void find_shares(const struct mpm_scene *scene, const struct mpm_simulation *simulation,
                        const double place[2], GArray *shares)
{
    const size_t count = mpm_simulation_particle_count(simulation);
    double position[2 * BLOCK], mass[BLOCK];
    g_array_set_size(shares, 0);
    for (size_t first = 0; first < count; first += BLOCK) {
        const size_t size = MIN(count - first, (size_t)BLOCK);
        mpm_simulation_field_range(simulation, MPM_FIELD_POSITION, first, size, position);
        mpm_simulation_field_range(simulation, MPM_FIELD_MASS, first, size, mass);
        for (size_t i = 0; i < size; i++) {
            const struct share share = {
                .id = first + i,
                .weight = mass[i] * hat(position[2 * i] - place[0], scene->cell[0]) *
                          hat(position[2 * i + 1] - place[1], scene->cell[1]),
            };
            if (share.weight > 0.0)
                g_array_append_val(shares, share);
        }
    }
}

static void append_number(GString *row, double value)
{
    char digits[G_ASCII_DTOSTR_BUF_SIZE];
    g_string_append_c(row, ',');
    g_string_append(row, g_ascii_formatd(digits, sizeof digits, "%.17g", value));
}

/* The weighted mean of a field, all of its components. */
static void append_field(GString *row, const struct mpm_simulation *simulation,
                         enum mpm_field field, const GArray *shares, double weight)
{
    const size_t components = mpm_field_describe(field)->components;
    double sum[COMPONENTS_MAX] = {0.0}, values[COMPONENTS_MAX];
    for (guint i = 0; i < shares->len; i++) {
        const struct share share = g_array_index(shares, struct share, i);
        mpm_simulation_field_range(simulation, field, share.id, 1, values);
        for (size_t k = 0; k < components; k++)
            sum[k] += share.weight * values[k];
    }
    for (size_t k = 0; k < components; k++)
        append_number(row, weight > 0.0 ? sum[k] / weight : (double)NAN);
}

static void append_row(GString *rows, const struct mpm_scene *scene,
                       const struct mpm_simulation *simulation, const struct mpm_probe_spec *probe,
                       int64_t point, GArray *shares)
{
    const double way = probe->points > 1 ? (double)point / (double)(probe->points - 1) : 0.0;
    const double place[2] = {probe->from[0] + way * (probe->to[0] - probe->from[0]),
                             probe->from[1] + way * (probe->to[1] - probe->from[1])};
    char digits[G_ASCII_DTOSTR_BUF_SIZE];
    double weight = 0.0;
    find_shares(scene, simulation, place, shares);
    for (guint i = 0; i < shares->len; i++)
        weight += g_array_index(shares, struct share, i).weight;
    g_string_append(
        rows, g_ascii_formatd(digits, sizeof digits, "%.17g", mpm_simulation_time(simulation)));
    g_string_append_printf(rows, ",%" G_GUINT64_FORMAT ",%s,%" G_GINT64_FORMAT,
                           (guint64)mpm_simulation_step(simulation), probe->name, (gint64)point);
    append_number(rows, place[0]);
    append_number(rows, place[1]);
    append_number(rows, weight);
    for (int field = 0; field < MPM_FIELD_COUNT; field++)
        if (is_written(scene, (enum mpm_field)field))
            append_field(rows, simulation, (enum mpm_field)field, shares, weight);
    g_string_append_c(rows, '\n');
}

enum mpm_status mpm_probes_write(struct mpm_probes *probes, const struct mpm_simulation *simulation,
                                 struct mpm_error *error)
{
    if (probes == NULL)
        return MPM_OK;
    const uint64_t step = mpm_simulation_step(simulation);
    if (mpm_rows_have(&probes->rows, step))
        return MPM_OK;
    GString *const rows = g_string_new(NULL);
    GArray *const shares = g_array_new(FALSE, FALSE, sizeof(struct share));
    for (size_t i = 0; i < probes->scene->probe_count; i++)
        for (int64_t k = 0; k < probes->scene->probes[i].points; k++)
            append_row(rows, probes->scene, simulation, &probes->scene->probes[i], k, shares);
    const enum mpm_status status = mpm_rows_append(&probes->rows, rows, step, error);
    g_array_free(shares, TRUE);
    g_string_free(rows, TRUE);
    return status;
}

/* Results as HDF5 snapshots in the layout of `mpm run`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/readers.h"
#include "verification/suite/failure.h"

#include <hdf5.h>

#include <math.h>

/* Datasets of /mpm/particles and a column of the unit that they must be in. */
static const struct dataset {
    const char *name;
    enum score_column unit;
} datasets[] = {
    {"position", SCORE_X},
    {"initial_position", SCORE_INITIAL_X},
    {"displacement", SCORE_DISPLACEMENT_X},
    {"velocity", SCORE_VELOCITY_X},
    {"stress", SCORE_STRESS_XX},
    {"deformation_gradient", SCORE_RELATIVE_VOLUME},
    {"id", SCORE_ID},
    {"body", SCORE_BODY},
};

/* The attribute `unit`, of any length; NULL if there is none. g_free. */
static char *read_unit(hid_t dataset)
{
    char *unit = NULL;
    if (H5Aexists(dataset, "unit") <= 0)
        return NULL;
    const hid_t attribute = H5Aopen(dataset, "unit", H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);
    if (H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) > 0) {
        char *text = NULL;
        if (H5Aread(attribute, type, &text) >= 0 && text != NULL) {
            unit = g_strdup(text);
            (void)H5free_memory(text);
        }
    } else if (H5Tget_class(type) == H5T_STRING) {
        unit = g_malloc0(H5Tget_size(type) + 1);
        if (H5Aread(attribute, type, unit) < 0)
            *unit = '\0';
    }
    (void)H5Tclose(type);
    (void)H5Aclose(attribute);
    return unit;
}

/* Values and components of an open dataset of one or two dimensions; NULL if it is none. */
static GArray *read_values(hid_t dataset, size_t *rows, size_t *components)
{
    hsize_t size[2] = {0, 1};
    const hid_t space = H5Dget_space(dataset);
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank == 1 || rank == 2)
        (void)H5Sget_simple_extent_dims(space, size, NULL);
    (void)H5Sclose(space);
    *rows = (size_t)size[0];
    *components = (size_t)size[1];
    if (size[0] == 0 || size[1] == 0 || size[1] > 16 || size[0] > G_MAXUINT / size[1])
        return NULL;
    GArray *values = g_array_new(FALSE, FALSE, sizeof(double));
    g_array_set_size(values, (guint)(size[0] * size[1]));
    if (H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values->data) >= 0)
        return values;
    g_array_unref(values);
    return NULL;
}

static enum mpm_status take_dataset(const char *path, const struct score_format *format,
                                    const struct dataset *entry, hid_t dataset,
                                    struct score_table *table, struct mpm_error *error)
{
    size_t rows, components;
    char *unit = read_unit(dataset), *place = g_strdup_printf("%s: %s", path, entry->name);
    GArray *values = read_values(dataset, &rows, &components);
    enum mpm_status status = MPM_OK;
    if (values == NULL)
        status = failure_set(error, MPM_BAD_INPUT,
                             "%s: allowed are numbers, one or more for each particle", place);
    if (status == MPM_OK && unit != NULL)
        status = score_check_unit(format, entry->unit, unit, place, error);
    if (status == MPM_OK && table->rows == 0)
        table->rows = rows;
    if (status == MPM_OK)
        status = score_take_array(path, format, entry->name, components, values, table, error);
    if (values != NULL)
        g_array_unref(values);
    g_free(unit);
    g_free(place);
    return status;
}

static double read_time(hid_t group)
{
    double time = (double)NAN;
    if (H5Aexists(group, "time") > 0) {
        const hid_t attribute = H5Aopen(group, "time", H5P_DEFAULT);
        if (H5Aread(attribute, H5T_NATIVE_DOUBLE, &time) < 0)
            time = (double)NAN;
        (void)H5Aclose(attribute);
    }
    return time;
}

static enum mpm_status read_groups(const char *path, const struct score_format *format, hid_t mpm,
                                   hid_t particles, struct score_table *table,
                                   struct mpm_error *error)
{
    for (size_t i = 0; i < G_N_ELEMENTS(datasets); i++) {
        if (H5Lexists(particles, datasets[i].name, H5P_DEFAULT) <= 0)
            continue;
        const hid_t dataset = H5Dopen2(particles, datasets[i].name, H5P_DEFAULT);
        const enum mpm_status status =
            dataset < 0
                ? failure_set(error, MPM_BAD_INPUT, "%s: %s is no dataset", path, datasets[i].name)
                : take_dataset(path, format, &datasets[i], dataset, table, error);
        (void)H5Dclose(dataset);
        TRY(status);
    }
    const double time = read_time(mpm);
    if (!isfinite(time))
        return failure_set(error, MPM_BAD_INPUT, "%s: /mpm has no attribute time", path);
    return score_take_time(path, time, table, error);
}

enum mpm_status score_read_hdf5(const char *path, const struct score_format *format,
                                struct score_table *table, struct mpm_error *error)
{
    H5E_auto2_t report = NULL;
    void *context = NULL;
    (void)H5Eget_auto2(H5E_DEFAULT, &report, &context);
    (void)H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t mpm = file < 0 ? file : H5Gopen2(file, "/mpm", H5P_DEFAULT);
    const hid_t particles = mpm < 0 ? mpm : H5Gopen2(mpm, "particles", H5P_DEFAULT);
    enum mpm_status status;
    if (particles < 0)
        status = failure_set(error, MPM_BAD_INPUT, "%s: %s", path,
                             file < 0 ? "is no HDF5 file" : "has no group /mpm/particles");
    else
        status = read_groups(path, format, mpm, particles, table, error);
    (void)H5Gclose(particles);
    (void)H5Gclose(mpm);
    (void)H5Fclose(file);
    (void)H5Eset_auto2(H5E_DEFAULT, report, context);
    return status;
}

/* Results as HDF5 snapshots in the layout of `mpm run`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm_file.h"
#include "mpm_hdf5.h"
#include "verification/common/failure.h"
#include "verification/score/readers.h"

#include <errno.h>
#include <fcntl.h>
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
    {"temperature", SCORE_TEMPERATURE},
    {"id", SCORE_ID},
    {"body", SCORE_BODY},
};

enum { TEXT_MAX = 256, COMPONENTS_MAX = 16 };

/* Whether the attribute is one value, and its type; the size that a file declares is that of what
 * is read. H5Tclose *type, also if false. */
static bool is_single(hid_t attribute, hid_t *type)
{
    const hid_t space = H5Aget_space(attribute);
    const bool single = space >= 0 && H5Sget_simple_extent_npoints(space) == 1;
    (void)H5Sclose(space);
    *type = H5Aget_type(attribute);
    return single && *type >= 0;
}

/* A text of an open attribute; NULL if it is none. g_free. */
static char *read_text(hid_t attribute, hid_t type)
{
    char *text = NULL, *own = NULL;
    if (H5Tget_class(type) != H5T_STRING)
        return NULL;
    if (H5Tis_variable_str(type) > 0) {
        if (H5Aread(attribute, type, &text) >= 0 && text != NULL) {
            own = g_strdup(text);
            (void)H5free_memory(text);
        }
    } else if (H5Tget_size(type) <= TEXT_MAX) {
        own = g_malloc0(TEXT_MAX + 1);
        if (H5Aread(attribute, type, own) < 0)
            g_clear_pointer(&own, g_free);
    }
    return own;
}

/* The attribute `unit`; NULL if there is none, or if it is no text: then false. g_free. */
static bool read_unit(hid_t dataset, char **unit)
{
    hid_t type;
    *unit = NULL;
    if (H5Aexists(dataset, "unit") == 0)
        return true;
    const hid_t attribute = H5Aopen(dataset, "unit", H5P_DEFAULT);
    if (attribute < 0)
        return false;
    if (is_single(attribute, &type))
        *unit = read_text(attribute, type);
    (void)H5Tclose(type);
    (void)H5Aclose(attribute);
    return *unit != NULL;
}

/* Whether the file has the values of a dataset of that many bytes; filters may make them fewer. */
static bool is_written(hid_t dataset, hsize_t bytes)
{
    const hid_t settings = H5Dget_create_plist(dataset);
    const bool filtered = settings >= 0 && H5Pget_nfilters(settings) > 0;
    (void)H5Pclose(settings);
    return H5Dget_storage_size(dataset) >= (filtered ? 1 : bytes);
}

/* Values and components of an open dataset of one or two dimensions; NULL if it is none. */
static GArray *read_values(hid_t dataset, size_t *rows, size_t *components)
{
    hsize_t size[2] = {0, 1};
    const hid_t space = H5Dget_space(dataset), type = H5Dget_type(dataset);
    const size_t bytes = H5Tget_size(type);
    (void)H5Tclose(type);
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank == 1 || rank == 2)
        (void)H5Sget_simple_extent_dims(space, size, NULL);
    (void)H5Sclose(space);
    *rows = (size_t)size[0];
    *components = (size_t)size[1];
    if (size[0] == 0 || size[1] == 0 || size[1] > COMPONENTS_MAX || size[0] > SCORE_ROWS_MAX ||
        !is_written(dataset, size[0] * size[1] * bytes))
        return NULL;
    void *room = g_try_malloc_n((size_t)(size[0] * size[1]), sizeof(double));
    g_free(room);
    if (room == NULL)
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
    char *unit, *place = g_strdup_printf("%s: %s", path, entry->name);
    const bool sound = read_unit(dataset, &unit);
    GArray *values = read_values(dataset, &rows, &components);
    enum mpm_status status = MPM_OK;
    if (!sound)
        status = failure_set(error, MPM_BAD_INPUT,
                             "%s: attribute unit: allowed is one text of up "
                             "to %d bytes",
                             place, TEXT_MAX);
    else if (values == NULL)
        status = failure_set(error, MPM_BAD_INPUT,
                             "%s: %zu x %zu values: allowed are numbers that the file holds, 1 to "
                             "%d for each of 1 to %d particles",
                             place, rows, components, COMPONENTS_MAX, SCORE_ROWS_MAX);
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

static double read_time(hid_t group, const char *name)
{
    double time = (double)NAN;
    if (H5Aexists(group, name) > 0) {
        hid_t type;
        const hid_t attribute = H5Aopen(group, name, H5P_DEFAULT);
        const bool single = is_single(attribute, &type);
        const H5T_class_t class = H5Tget_class(type);
        if (!single || (class != H5T_FLOAT && class != H5T_INTEGER) ||
            H5Aread(attribute, H5T_NATIVE_DOUBLE, &time) < 0)
            time = (double)NAN;
        (void)H5Tclose(type);
        (void)H5Aclose(attribute);
    }
    return time;
}

/* The attributes that state other times of positions, velocities and stress, as columns. */
static enum mpm_status read_levels(const char *path, const struct score_format *format, hid_t mpm,
                                   struct score_table *table, struct mpm_error *error)
{
    for (int c = SCORE_POSITION_TIME; c <= SCORE_STRESS_TIME; c++) {
        const char *name = score_column_name((enum score_column)c, format->geometry);
        if (H5Aexists(mpm, name) <= 0)
            continue;
        const double time = read_time(mpm, name);
        if (!isfinite(time))
            return failure_set(error, MPM_BAD_INPUT,
                               "%s: /mpm: attribute %s: allowed is one finite number", path, name);
        double *const values = score_table_add(table, (enum score_column)c);
        for (size_t p = 0; p < table->rows; p++)
            values[p] = time;
    }
    return MPM_OK;
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
    TRY(read_levels(path, format, mpm, table, error));
    const double time = read_time(mpm, "time");
    if (!isfinite(time))
        return failure_set(error, MPM_BAD_INPUT,
                           "%s: /mpm: attribute time: allowed is one finite number", path);
    return score_take_time(path, time, table, error);
}

enum mpm_status score_read_hdf5(const char *path, const struct score_format *format,
                                struct score_table *table, struct mpm_error *error)
{
    struct mpm_hdf5_sink sink = {.file = mpm_file_open(path, O_RDONLY)};
    if (sink.file < 0)
        return mpm_file_unread(path, errno, NULL, error);
    const struct mpm_hdf5_messages messages = mpm_hdf5_silence();
    const hid_t access = mpm_hdf5_sink_access(&sink);
    const hid_t file = H5Fopen("results", H5F_ACC_RDONLY, access);
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
    (void)H5Pclose(access);
    mpm_hdf5_restore(&messages);
    (void)mpm_file_close(sink.file);
    return sink.error_number == 0 ? status : mpm_file_unread(path, sink.error_number, NULL, error);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/plot/snapshot_read.h"

#include "base/status.h"
#include "base/tensor.h"
#include "mpm_file.h"
#include "mpm_hdf5.h"
#include "mpm_words.h"

#include <errno.h>
#include <fcntl.h>
#include <hdf5.h>
#include <math.h>
#include <string.h>

enum { COMPONENTS_MAX = 16, PARTICLES_MAX = 100000000, TEXT_MAX = 4096 };

/* ------------------------------------------------------------------ derived */

/* Of the Cauchy stress xx yy zz xy. */
static double von_mises(const double *s)
{
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
    return sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * s[3] * s[3]);
}

static double pressure(const double *s)
{
    return -(s[0] + s[1] + s[2]) / 3.0;
}

static double speed(const double *v)
{
    return hypot(v[0], v[1]);
}

static double relative_volume(const double *f)
{
    return mpm_determinant(f);
}

const struct mpm_derived_field mpm_derived_fields[] = {
    {"von_mises", "stress", "equivalent stress of von Mises", von_mises},
    {"pressure", "stress", "minus the mean of the three normal stresses", pressure},
    {"speed", "velocity", "magnitude of the velocity", speed},
    {"relative_volume", "deformation_gradient", "det F", relative_volume},
};
const size_t mpm_derived_field_count = G_N_ELEMENTS(mpm_derived_fields);

/* ------------------------------------------------------------------ reading */

struct reading {
    const char *path;
    hid_t mpm, particles;
    struct mpm_error *error;
};

static enum mpm_status refuse(const struct reading *reading, const char *what)
{
    return mpm_error_set(reading->error, MPM_BAD_INPUT,
                         "%s: %s; allowed: a snapshot that 'mpm run' of this version has written",
                         reading->path, what);
}

/* A text of an object, "" where there is none; g_free. */
static char *read_text(hid_t object, const char *name)
{
    char *text = NULL, *own = NULL;
    if (H5Aexists(object, name) <= 0)
        return g_strdup("");
    const hid_t attribute = H5Aopen(object, name, H5P_DEFAULT), type = H5Aget_type(attribute),
                space = H5Aget_space(attribute);
    if (H5Sget_simple_extent_npoints(space) == 1 && H5Tget_class(type) == H5T_STRING &&
        H5Tis_variable_str(type) > 0 && H5Aread(attribute, type, &text) >= 0 && text != NULL) {
        own = g_strndup(text, TEXT_MAX);
        (void)H5free_memory(text);
    }
    (void)H5Sclose(space);
    (void)H5Tclose(type);
    (void)H5Aclose(attribute);
    return own != NULL ? own : g_strdup("");
}

/* `count` numbers of an attribute. */
static bool read_numbers(hid_t object, const char *name, size_t count, double *values)
{
    if (H5Aexists(object, name) <= 0)
        return false;
    const hid_t attribute = H5Aopen(object, name, H5P_DEFAULT), type = H5Aget_type(attribute),
                space = H5Aget_space(attribute);
    const H5T_class_t class = H5Tget_class(type);
    const bool read = H5Sget_simple_extent_npoints(space) == (hssize_t)count &&
                      (class == H5T_FLOAT || class == H5T_INTEGER) &&
                      H5Aread(attribute, H5T_NATIVE_DOUBLE, values) >= 0;
    (void)H5Sclose(space);
    (void)H5Tclose(type);
    (void)H5Aclose(attribute);
    return read;
}

static size_t count_of(hid_t object, const char *name)
{
    if (H5Aexists(object, name) <= 0)
        return 0;
    const hid_t attribute = H5Aopen(object, name, H5P_DEFAULT), space = H5Aget_space(attribute);
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    (void)H5Sclose(space);
    (void)H5Aclose(attribute);
    return count > 0 && count < INT_MAX ? (size_t)count : 0;
}

/* A dataset of rows x components; *rows has to be its number of rows, unless it is 0. g_free. */
static double *read_dataset(hid_t dataset, size_t *rows, size_t *components)
{
    hsize_t size[2] = {0, 1};
    const hid_t space = H5Dget_space(dataset), type = H5Dget_type(dataset);
    const int rank = H5Sget_simple_extent_ndims(space);
    const H5T_class_t class = H5Tget_class(type);
    if (rank == 1 || rank == 2)
        (void)H5Sget_simple_extent_dims(space, size, NULL);
    (void)H5Sclose(space);
    (void)H5Tclose(type);
    const bool sound = (class == H5T_FLOAT || class == H5T_INTEGER) && size[0] > 0 && size[1] > 0 &&
                       size[0] <= PARTICLES_MAX && size[1] <= COMPONENTS_MAX &&
                       (*rows == 0 || size[0] == *rows) && H5Dget_storage_size(dataset) > 0;
    double *const values =
        sound ? g_try_malloc_n((size_t)(size[0] * size[1]), sizeof *values) : NULL;
    if (values == NULL ||
        H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) {
        g_free(values);
        return NULL;
    }
    *rows = (size_t)size[0];
    *components = (size_t)size[1];
    return values;
}

/* Of the particles; with the unit and the names of its components where asked for. NULL: there is
 * none. */
static double *read_field(const struct reading *reading, const char *name, size_t *rows,
                          size_t *components, char **unit, char **names)
{
    if (strchr(name, '/') != NULL || name[0] == '\0' ||
        H5Lexists(reading->particles, name, H5P_DEFAULT) <= 0)
        return NULL;
    const hid_t dataset = H5Dopen2(reading->particles, name, H5P_DEFAULT);
    if (dataset < 0)
        return NULL;
    double *const values = read_dataset(dataset, rows, components);
    if (unit != NULL)
        *unit = read_text(dataset, "unit");
    if (names != NULL)
        *names = read_text(dataset, "components");
    (void)H5Dclose(dataset);
    return values;
}

/* ----------------------------------------------------------------- outlines */

static enum mpm_status make_corners(const struct reading *reading, const double *position,
                                    const double *f, const double *body,
                                    struct mpm_picture *picture)
{
    static const double corner[4][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    const size_t bodies = count_of(reading->mpm, "body_domains") / 2;
    double *const sizes = g_new0(double, 2 * bodies + 1);
    bool sound = bodies > 0 && read_numbers(reading->mpm, "body_domains", 2 * bodies, sizes);
    picture->corners = g_malloc_n(picture->count, sizeof *picture->corners);
    for (size_t p = 0; sound && p < picture->count; p++) {
        if (!(body[p] >= 0.0 && body[p] < (double)bodies)) {
            sound = false;
            break;
        }
        const double *const size = &sizes[2 * (size_t)body[p]];
        for (int k = 0; k < 4; k++) {
            const double x = corner[k][0] * size[0], y = corner[k][1] * size[1];
            picture->corners[p][k][0] = position[2 * p] + f[5 * p] * x + f[5 * p + 1] * y;
            picture->corners[p][k][1] = position[2 * p + 1] + f[5 * p + 2] * x + f[5 * p + 3] * y;
        }
    }
    g_free(sizes);
    return sound ? MPM_OK : refuse(reading, "body_domains does not fit the particles");
}

static enum mpm_status read_outlines(const struct reading *reading, struct mpm_picture *picture)
{
    size_t two = 0, five = 0, one = 0;
    double *const position = read_field(reading, "position", &picture->count, &two, NULL, NULL),
                  *const f = read_field(reading, "deformation_gradient", &picture->count, &five,
                                        NULL, NULL),
                  *const body = read_field(reading, "body", &picture->count, &one, NULL, NULL);
    const bool sound =
        position != NULL && f != NULL && body != NULL && two == 2 && five == 5 && one == 1;
    const enum mpm_status status =
        sound ? make_corners(reading, position, f, body, picture)
              : refuse(reading, "no position, deformation_gradient or body of the particles");
    g_free(position);
    g_free(f);
    g_free(body);
    return status;
}

/* ------------------------------------------------------------------- values */

/* The place of a component in "xx, yy, zz, xy", also as a number; -1: it has none of that name. */
static int component_of(const char *wanted, const char *names, size_t components)
{
    char **const list = g_strsplit(names, ", ", -1);
    int found = -1;
    for (int k = 0; k < (int)components && list[k] != NULL; k++)
        if (strcmp(list[k], wanted) == 0 ||
            (strcmp(list[k], "θθ") == 0 && strcmp(wanted, "tt") == 0))
            found = k;
    g_strfreev(list);
    return found;
}

/* The nearest name, unless it is the one given: such a field the scene does not have. */
static const char *field_hint(const char *field, char hint[MPM_HINT_SIZE])
{
    char **const parts = g_strsplit(field, ".", 2);
    struct mpm_nearest nearest = {.word = parts[0] != NULL ? parts[0] : ""};
    for (size_t k = 0; k < mpm_derived_field_count; k++)
        mpm_nearest_offer(&nearest, mpm_derived_fields[k].name);
    for (int k = 0; k < MPM_FIELD_COUNT; k++)
        mpm_nearest_offer(&nearest, mpm_field_describe((enum mpm_field)k)->name);
    const bool is_known = nearest.best != NULL && strcmp(nearest.best, nearest.word) == 0;
    const char *const said = is_known ? "" : mpm_nearest_hint(&nearest, hint);
    g_strfreev(parts);
    return said;
}

static enum mpm_status refuse_field(const struct reading *reading, const char *field,
                                    const char *names)
{
    char excerpt[64], hint[MPM_HINT_SIZE];
    (void)g_snprintf(excerpt, sizeof excerpt, "%s", field);
    if (names != NULL)
        return mpm_error_set(reading->error, MPM_BAD_INPUT,
                             "--field %s: the field has components; allowed: one of %s, after a "
                             "point",
                             excerpt, names);
    return mpm_error_set(reading->error, MPM_BAD_INPUT,
                         "--field %s: %s has no such field; allowed: those of 'mpm plot --list' "
                         "that the scene has%s",
                         excerpt, reading->path, field_hint(field, hint));
}

static const struct mpm_derived_field *find_derived(const char *name)
{
    for (size_t k = 0; k < mpm_derived_field_count; k++)
        if (strcmp(mpm_derived_fields[k].name, name) == 0)
            return &mpm_derived_fields[k];
    return NULL;
}

static enum mpm_status read_values(const struct reading *reading, const char *field,
                                   struct mpm_picture *picture)
{
    const struct mpm_derived_field *const derived = find_derived(field);
    char **const parts = g_strsplit(derived != NULL ? derived->field : field, ".", 2);
    char *names = NULL;
    size_t components = 0;
    double *const values = read_field(reading, parts[0] != NULL ? parts[0] : "", &picture->count,
                                      &components, &picture->unit, &names);
    int component = 0;
    if (values != NULL && derived == NULL && components > 1)
        component = parts[1] != NULL ? component_of(parts[1], names, components) : -1;
    const bool extra = parts[0] != NULL && parts[1] != NULL && components == 1;
    enum mpm_status status = MPM_OK;
    if (values == NULL || extra)
        status = refuse_field(reading, field, NULL);
    else if (component < 0)
        status = refuse_field(reading, field, names);
    else
        picture->values = g_new(double, picture->count);
    for (size_t p = 0; status == MPM_OK && p < picture->count; p++)
        picture->values[p] = derived != NULL ? derived->value(&values[components * p])
                                             : values[components * p + (size_t)component];
    g_free(values);
    g_free(names);
    g_strfreev(parts);
    return status;
}

static enum mpm_status read_groups(const struct reading *reading, const char *field,
                                   struct mpm_picture *picture)
{
    MPM_TRY(read_outlines(reading, picture));
    MPM_TRY(read_values(reading, field, picture));
    picture->title = read_text(reading->mpm, "title");
    picture->unit_length = read_text(reading->mpm, "units_length");
    picture->unit_time = read_text(reading->mpm, "units_time");
    char *const geometry = read_text(reading->mpm, "geometry");
    picture->axisymmetric = strcmp(geometry, "axisymmetric") == 0;
    g_free(geometry);
    return read_numbers(reading->mpm, "time", 1, &picture->time) && isfinite(picture->time)
               ? MPM_OK
               : refuse(reading, "no time");
}

/* -------------------------------------------------------------------- names */

static bool is_plain(const char *name)
{
    return name[0] != '\0' &&
           strspn(name, G_CSET_A_2_Z G_CSET_a_2_z G_CSET_DIGITS "_") == strlen(name);
}

void mpm_component_names(const char *field, const char *components, GString *names)
{
    char **const list = g_strsplit(components, ", ", -1);
    for (char **component = list; *component != NULL; component++) {
        const char *const name = strcmp(*component, "θθ") == 0 ? "tt" : *component;
        char *const whole = g_strdup_printf("%s.%s\n", field, name);
        if (is_plain(name) && strstr(names->str, whole) == NULL)
            g_string_append(names, whole);
        g_free(whole);
    }
    g_strfreev(list);
}

/* Of H5Literate: a field of numbers, one or several for each particle. */
static herr_t add_names(hid_t particles, const char *name, const H5L_info_t *link, void *data)
{
    hsize_t size[2] = {0, 1};
    (void)link;
    const hid_t dataset = is_plain(name) ? H5Dopen2(particles, name, H5P_DEFAULT) : -1;
    if (dataset < 0)
        return 0;
    const hid_t space = H5Dget_space(dataset), type = H5Dget_type(dataset);
    const int rank = H5Sget_simple_extent_ndims(space);
    const H5T_class_t class = H5Tget_class(type);
    char *const components = read_text(dataset, "components");
    if (rank == 1 || rank == 2)
        (void)H5Sget_simple_extent_dims(space, size, NULL);
    if (size[0] > 0 && size[1] > 1 && (class == H5T_FLOAT || class == H5T_INTEGER))
        mpm_component_names(name, components, data);
    else if (size[0] > 0 && size[1] == 1 && (class == H5T_FLOAT || class == H5T_INTEGER))
        g_string_append_printf(data, "%s\n", name);
    g_free(components);
    (void)H5Tclose(type);
    (void)H5Sclose(space);
    (void)H5Dclose(dataset);
    return 0;
}

static enum mpm_status read_names(const struct reading *reading, void *data)
{
    for (size_t k = 0; k < mpm_derived_field_count; k++)
        if (H5Lexists(reading->particles, mpm_derived_fields[k].field, H5P_DEFAULT) > 0)
            g_string_append_printf(data, "%s\n", mpm_derived_fields[k].name);
    return H5Literate(reading->particles, H5_INDEX_NAME, H5_ITER_INC, NULL, add_names, data) >= 0
               ? MPM_OK
               : refuse(reading, "no fields");
}

/* --------------------------------------------------------------------- file */

struct wanted {
    const char *field;
    struct mpm_picture *picture;
};

static enum mpm_status read_picture(const struct reading *reading, void *data)
{
    const struct wanted *const wanted = data;
    return read_groups(reading, wanted->field, wanted->picture);
}

static enum mpm_status
read_snapshot(const char *path, enum mpm_status (*take)(const struct reading *reading, void *data),
              void *data, struct mpm_error *error)
{
    struct mpm_hdf5_sink sink = {.file = mpm_file_open(path, O_RDONLY)};
    if (sink.file < 0)
        return mpm_file_unread(path, errno, NULL, error);
    const struct mpm_hdf5_messages messages = mpm_hdf5_silence();
    const hid_t access = mpm_hdf5_sink_access(&sink);
    const hid_t file = H5Fopen("snapshot", H5F_ACC_RDONLY, access);
    struct reading reading = {.path = path, .error = error};
    reading.mpm = file < 0 ? -1 : H5Gopen2(file, "/mpm", H5P_DEFAULT);
    reading.particles = reading.mpm < 0 ? -1 : H5Gopen2(reading.mpm, "particles", H5P_DEFAULT);
    enum mpm_status status =
        reading.particles < 0 ? refuse(&reading, "no snapshot") : take(&reading, data);
    (void)H5Gclose(reading.particles);
    (void)H5Gclose(reading.mpm);
    (void)H5Fclose(file);
    (void)H5Pclose(access);
    mpm_hdf5_restore(&messages);
    if (sink.error_number != 0)
        status = mpm_file_unread(path, sink.error_number, NULL, error);
    (void)mpm_file_close(sink.file);
    return status;
}

enum mpm_status mpm_picture_read(const char *path, const char *field, struct mpm_picture *picture,
                                 struct mpm_error *error)
{
    *picture = (struct mpm_picture){.count = 0};
    struct wanted wanted = {field, picture};
    return read_snapshot(path, read_picture, &wanted, error);
}

enum mpm_status mpm_picture_names(const char *path, GString *names, struct mpm_error *error)
{
    return read_snapshot(path, read_names, names, error);
}

void mpm_picture_free(struct mpm_picture *picture)
{
    char *const texts[] = {picture->title, picture->unit, picture->unit_length, picture->unit_time};
    for (size_t k = 0; k < G_N_ELEMENTS(texts); k++)
        g_free(texts[k]);
    g_free(picture->corners);
    g_free(picture->values);
    *picture = (struct mpm_picture){.count = 0};
}

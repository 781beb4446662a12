/* HDF5: snapshots that are scored, and drawn. An input that begins as an HDF5 file does is one; any
 * other is a recipe for a file that HDF5 itself writes, so that what is odd about it reaches the
 * reader.
 *
 * A recipe is a byte for the attribute `time`, then for each dataset SIZE bytes as `enum part` has
 * them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "io/plot/snapshot_read.h"
#include "verification/score/results.h"

#include <hdf5.h>

#include <glib.h>
#include <math.h>
#include <string.h>

enum part { NAME, TYPE, RANK, ROWS, COLUMNS, STORAGE, UNIT, VALUES, SIZE };
enum { TYPES = 12, UNITS = 6, BYTES = 1 << 16 };

static const char *const names[] = {"position", "initial_position",     "displacement", "velocity",
                                    "stress",   "deformation_gradient", "temperature",  "id",
                                    "body"};

/* A type of numbers, or of what no reader takes for numbers; H5Tclose. */
static hid_t make_type(unsigned kind)
{
    const hid_t plain[] = {H5T_IEEE_F64LE, H5T_IEEE_F32BE, H5T_STD_I64LE, H5T_STD_U8BE,
                           H5T_STD_U32LE,  H5T_STD_B16LE,  H5T_C_S1,      H5T_STD_REF_OBJ};
    const hsize_t size = 3;
    hid_t type;
    switch (kind % TYPES) {
    case 8:
        type = H5Tcopy(H5T_C_S1);
        (void)H5Tset_size(type, H5T_VARIABLE);
        return type;
    case 9:
        return H5Tarray_create2(H5T_IEEE_F64LE, 1, &size);
    case 10:
        return H5Tvlen_create(H5T_IEEE_F64LE);
    case 11:
        type = H5Tcreate(H5T_COMPOUND, sizeof(double));
        (void)H5Tinsert(type, "x", 0, H5T_IEEE_F64LE);
        return type;
    default:
        return H5Tcopy(plain[kind % TYPES]);
    }
}

/* Of lengths up to 255, of some that are far beyond any memory, or of none. */
static hsize_t length_of(uint8_t byte)
{
    static const hsize_t large[] = {100000001, 1000000, (hsize_t)1 << 32, (hsize_t)1 << 60};
    return byte >= 252 ? large[byte - 252] : byte;
}

static hid_t make_space(const uint8_t *part)
{
    const hsize_t size[3] = {length_of(part[ROWS]), length_of(part[COLUMNS]), 2};
    const unsigned rank = part[RANK] % 6;
    if (rank == 4)
        return H5Screate(H5S_NULL);
    return rank == 0 || rank == 5 ? H5Screate(H5S_SCALAR) : H5Screate_simple((int)rank, size, NULL);
}

/* The attribute `unit` or `time`, of a text, of several, or of numbers. */
static void add_attribute(hid_t object, const char *name, unsigned kind, hid_t type)
{
    static const char text[512] = "mm";
    static const double number = 0.5;
    const hsize_t count = 2;
    const hid_t space = kind % UNITS == 4 ? H5Screate_simple(1, &count, NULL)
                                          : H5Screate(kind % UNITS == 5 ? H5S_NULL : H5S_SCALAR);
    const hid_t attribute = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    const double numbers[64] = {number, number};
    const char *const texts[2] = {text, text};
    if (H5Tis_variable_str(type) > 0)
        (void)H5Awrite(attribute, type, texts);
    else if (H5Tget_class(type) == H5T_STRING)
        (void)H5Awrite(attribute, type, text);
    else if (H5Tget_class(type) == H5T_FLOAT)
        (void)H5Awrite(attribute, H5T_NATIVE_DOUBLE, numbers);
    (void)H5Aclose(attribute);
    (void)H5Sclose(space);
}

static void add_unit(hid_t dataset, unsigned kind)
{
    const hid_t type = H5Tcopy(kind % UNITS == 3 ? H5T_NATIVE_DOUBLE : H5T_C_S1);
    if (kind % UNITS != 3)
        (void)H5Tset_size(type, kind % UNITS == 1 ? H5T_VARIABLE : kind % UNITS == 2 ? 300 : 3);
    add_attribute(dataset, "unit", kind, type);
    (void)H5Tclose(type);
}

/* Contiguous, in chunks, compressed or compact; with its place in the file taken or not. */
static hid_t make_storage(const uint8_t *part)
{
    const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t chunk[3] = {7, 2, 2};
    const unsigned rank = part[RANK] % 6, storage = part[STORAGE] % 5;
    if (rank >= 1 && rank <= 3 && (storage == 1 || storage == 2))
        (void)H5Pset_chunk(list, (int)rank, chunk);
    if (storage == 2)
        (void)H5Pset_deflate(list, 1);
    if (storage == 3)
        (void)H5Pset_layout(list, H5D_COMPACT);
    return list;
}

static void add_values(hid_t dataset, uint8_t pattern)
{
    static const double kinds[] = {0.0, 1.0, 1e300, (double)NAN};
    const hid_t space = H5Dget_space(dataset), type = H5Dget_type(dataset);
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    const bool numbers = H5Tget_class(type) == H5T_FLOAT || H5Tget_class(type) == H5T_INTEGER;
    if (numbers && count > 0 && count <= BYTES) {
        double *const values = g_new(double, (gsize)count);
        for (hssize_t k = 0; k < count; k++)
            values[k] = kinds[pattern % 4] + (pattern & 4 ? (double)k : 0.0);
        (void)H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
        g_free(values);
    }
    (void)H5Tclose(type);
    (void)H5Sclose(space);
}

static void add_dataset(hid_t group, const uint8_t *part)
{
    const hid_t type = make_type(part[TYPE]), space = make_space(part), list = make_storage(part);
    const char *const name = names[part[NAME] % G_N_ELEMENTS(names)];
    const hid_t dataset = H5Dcreate2(group, name, type, space, H5P_DEFAULT, list, H5P_DEFAULT);
    if (dataset >= 0) {
        if (part[UNIT] % 8 < UNITS)
            add_unit(dataset, part[UNIT]);
        if (part[VALUES] != 0)
            add_values(dataset, part[VALUES]);
        (void)H5Dclose(dataset);
    }
    (void)H5Pclose(list);
    (void)H5Sclose(space);
    (void)H5Tclose(type);
}

static void write_recipe(const char *path, const uint8_t *data, size_t size)
{
    const hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t mpm = H5Gcreate2(file, "mpm", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t particles = H5Gcreate2(mpm, "particles", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    if (size > 0 && data[0] > 0) {
        const hid_t type = make_type(data[0] - 1u);
        add_attribute(mpm, "time", data[0] / TYPES, type);
        (void)H5Tclose(type);
    }
    for (size_t at = 1; at + SIZE <= size; at += SIZE)
        add_dataset(particles, data + at);
    (void)H5Gclose(particles);
    (void)H5Gclose(mpm);
    (void)H5Fclose(file);
}

/* All names, and the picture of each. */
static void draw_fields(const char *path)
{
    struct mpm_error error = {.status = MPM_OK};
    GString *const list = g_string_new(NULL);
    if (fuzz_judge(mpm_picture_names(path, list, &error), &error)) {
        char **const fields = g_strsplit(list->str, "\n", -1);
        for (char **field = fields; *field != NULL; field++) {
            struct mpm_picture picture;
            (void)fuzz_judge(mpm_picture_read(path, *field, &picture, &error), &error);
            mpm_picture_free(&picture);
        }
        g_strfreev(fields);
    }
    g_string_free(list, TRUE);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const uint8_t signature[] = {0x89, 'H', 'D', 'F'};
    const struct score_format format = {MPM_PLANE_STRAIN, {"mm", "g", "ms", "K"}, 0};
    struct mpm_error error = {.status = MPM_OK};
    struct score_table table;
    const char *const path = fuzz_write("results.h5", data, size);
    if (size < sizeof signature || memcmp(data, signature, sizeof signature) != 0)
        write_recipe(path, data, size);
    if (fuzz_judge(results_read(path, &format, &table, &error), &error))
        score_table_close(&table);
    draw_fields(path);
    return 0;
}

int LLVMFuzzerInitialize(int *argument_count, char ***arguments)
{
    (void)argument_count;
    (void)arguments;
    return H5Eset_auto2(H5E_DEFAULT, NULL, NULL) >= 0 ? 0 : -1;
}

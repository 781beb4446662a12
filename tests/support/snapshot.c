/* Reading a snapshot back, with HDF5 alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/snapshot.h"
#include "support/marks.h"

#include <glib.h>

double *test_dataset_read(hid_t file, const char *path, size_t *count)
{
    const hid_t dataset = H5Dopen2(file, path, H5P_DEFAULT);
    ck_assert_msg(dataset >= 0, "no dataset %s", path);
    const hid_t space = H5Dget_space(dataset);
    *count = (size_t)H5Sget_simple_extent_npoints(space);
    double *values = g_new(double, *count);
    ck_assert_int_ge(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), 0);
    H5Sclose(space);
    H5Dclose(dataset);
    return values;
}

char *test_attribute_text(hid_t file, const char *object, const char *name)
{
    const hid_t attribute = H5Aopen_by_name(file, object, name, H5P_DEFAULT, H5P_DEFAULT);
    ck_assert_msg(attribute >= 0, "%s has no attribute %s", object, name);
    const hid_t type = H5Aget_type(attribute);
    char *read = NULL;
    ck_assert_int_ge(H5Aread(attribute, type, &read), 0);
    char *text = g_strdup(read);
    H5free_memory(read);
    H5Tclose(type);
    H5Aclose(attribute);
    return text;
}

static void read_attribute(hid_t file, const char *name, hid_t type, void *value)
{
    const hid_t attribute = H5Aopen_by_name(file, "/mpm", name, H5P_DEFAULT, H5P_DEFAULT);
    ck_assert_msg(attribute >= 0, "/mpm has no attribute %s", name);
    ck_assert_int_ge(H5Aread(attribute, type, value), 0);
    H5Aclose(attribute);
}

struct test_snapshot test_snapshot_read(const char *path)
{
    struct test_snapshot snapshot = {.count = 0};
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    ck_assert_msg(file >= 0, "%s cannot be opened", path);
    read_attribute(file, "time", H5T_NATIVE_DOUBLE, &snapshot.time);
    read_attribute(file, "step", H5T_NATIVE_INT64, &snapshot.step);
    for (int field = 0; field < MPM_FIELD_COUNT; field++) {
        const struct mpm_field_info *info = mpm_field_describe((enum mpm_field)field);
        char *name = g_strdup_printf("/mpm/particles/%s", info->name);
        size_t count = 0;
        if (H5Lexists(file, name, H5P_DEFAULT) > 0) {
            snapshot.fields[field] = test_dataset_read(file, name, &count);
            if (field == 0)
                snapshot.count = count;
            ck_assert_uint_eq(count, snapshot.count * info->components);
        }
        g_free(name);
    }
    H5Fclose(file);
    return snapshot;
}

void test_snapshot_free(struct test_snapshot *snapshot)
{
    for (int field = 0; field < MPM_FIELD_COUNT; field++)
        g_free(snapshot->fields[field]);
    *snapshot = (struct test_snapshot){.count = 0};
}

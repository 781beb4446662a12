/* Snapshots of other solvers, HDF5: what they declare is not believed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"

#include "verification/score/results.h"

#include <glib.h>
#include <hdf5.h>
#include <string.h>

/* An attribute of `count` values of the type, all bytes '1'. */
static void add_attribute(hid_t place, const char *name, hid_t type, hsize_t count)
{
    const hid_t space = H5Screate_simple(1, &count, NULL);
    const hid_t attribute = H5Acreate2(place, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    char *bytes = g_strnfill(count * H5Tget_size(type), '1');
    ck_assert_int_ge(H5Awrite(attribute, type, bytes), 0);
    g_free(bytes);
    (void)H5Aclose(attribute);
    (void)H5Sclose(space);
}

/* What a snapshot declares, in place of two particles at one time with units of one text. */
static const struct declared {
    hsize_t rows, times, units;
    size_t text; /* bytes of a unit */
    bool written, time_as_text;
    const char *message;
} declared[] = {
    {2, 1, 1, 2, true, false, "position: x is in \"11\": allowed is \"mm\""},
    {2, 1, 20000, 2, true, false, "position: attribute unit: allowed is one text"},
    {2, 1, 1, 300, true, false, "position: attribute unit: allowed is one text of up to 256"},
    {2, 4000, 0, 0, true, false, "/mpm: attribute time: allowed is one finite number"},
    {2, 1, 0, 0, true, true, "/mpm: attribute time: allowed is one finite number"},
    {2, 1, 0, 0, false, false, "position: 2 x 2 values: allowed are numbers that the file holds"},
    {2000000000, 1, 0, 0, false, false, "for each of 1 to 100000000 particles"},
};

static void write_declared(const char *path, const struct declared *what)
{
    static const double numbers[4] = {0, 1, 2, 3};
    const hsize_t size[2] = {what->rows, 2}, chunk[2] = {2, 2};
    const hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t mpm = H5Gcreate2(file, "/mpm", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t particles = H5Gcreate2(mpm, "particles", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(2, size, NULL), settings = H5Pcreate(H5P_DATASET_CREATE);
    const hid_t text = H5Tcopy(H5T_C_S1);
    (void)H5Pset_chunk(settings, 2, chunk);
    const hid_t dataset = H5Dcreate2(particles, "position", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT,
                                     settings, H5P_DEFAULT);
    if (what->written)
        (void)H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers);
    if (what->units > 0) {
        (void)H5Tset_size(text, what->text);
        add_attribute(dataset, "unit", text, what->units);
    }
    add_attribute(mpm, "time", what->time_as_text ? text : H5T_NATIVE_DOUBLE, what->times);
    (void)H5Dclose(dataset);
    (void)H5Tclose(text);
    (void)H5Pclose(settings);
    (void)H5Sclose(space);
    (void)H5Gclose(particles);
    (void)H5Gclose(mpm);
    ck_assert_int_ge(H5Fclose(file), 0);
}

START_TEST(what_a_snapshot_declares_is_not_believed)
{
    char *folder = test_folder_create(), *path = test_folder_path(folder, "a.hdf");
    const struct score_format format = {MPM_PLANE_STRAIN, {"mm", "g", "ms", "K"}, 0};
    struct score_table table;
    struct mpm_error error = {.message = "accepted"};
    write_declared(path, &declared[_i]);
    const enum mpm_status status = results_read(path, &format, &table, &error);
    ck_assert_msg(status == MPM_BAD_INPUT && strstr(error.message, declared[_i].message) != NULL,
                  "%s", error.message);
    g_free(path);
    test_folder_remove(folder);
}
END_TEST

Suite *suite_score_snapshots(void)
{
    Suite *suite = suite_create("score_snapshots");
    TCase *snapshots = tcase_create("snapshots");
    tcase_add_loop_test(snapshots, what_a_snapshot_declares_is_not_believed, 0,
                        (int)G_N_ELEMENTS(declared));
    suite_add_tcase(suite, snapshots);
    return suite;
}

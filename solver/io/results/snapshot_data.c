/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/snapshot_data.h"

#include "mpm_hdf5.h"

#include <glib.h>
#include <hdf5.h>

hid_t mpm_snapshot_checked(struct mpm_snapshot *snapshot, hid_t result)
{
    if (result < 0 && snapshot->failure == NULL)
        snapshot->failure = mpm_hdf5_reason();
    return result;
}

hid_t mpm_snapshot_group(struct mpm_snapshot *snapshot, hid_t parent, const char *name)
{
    const hid_t list = mpm_snapshot_checked(snapshot, H5Pcreate(H5P_GROUP_CREATE));
    mpm_snapshot_checked(snapshot, H5Pset_obj_track_times(list, false));
    const hid_t group =
        mpm_snapshot_checked(snapshot, H5Gcreate2(parent, name, H5P_DEFAULT, list, H5P_DEFAULT));
    mpm_snapshot_checked(snapshot, H5Pclose(list));
    return group;
}

void mpm_snapshot_attribute(struct mpm_snapshot *snapshot, hid_t object, const char *name,
                            hid_t file_type, hid_t memory_type, hsize_t size, int rank,
                            const void *data)
{
    const hid_t space = rank == 0
                            ? snapshot->scalar
                            : mpm_snapshot_checked(snapshot, H5Screate_simple(rank, &size, NULL));
    const hid_t attribute = mpm_snapshot_checked(
        snapshot, H5Acreate2(object, name, file_type, space, H5P_DEFAULT, H5P_DEFAULT));
    mpm_snapshot_checked(snapshot, H5Awrite(attribute, memory_type, data));
    mpm_snapshot_checked(snapshot, H5Aclose(attribute));
    if (rank != 0)
        mpm_snapshot_checked(snapshot, H5Sclose(space));
}

void mpm_snapshot_text(struct mpm_snapshot *snapshot, hid_t object, const char *name,
                       const char *text)
{
    mpm_snapshot_attribute(snapshot, object, name, snapshot->text, snapshot->text, 1, 0, &text);
}

void mpm_snapshot_texts(struct mpm_snapshot *snapshot, hid_t object, const char *name,
                        const char *const *texts, size_t count)
{
    if (count > 0)
        mpm_snapshot_attribute(snapshot, object, name, snapshot->text, snapshot->text, count, 1,
                               texts);
}

static hid_t creation_list(struct mpm_snapshot *snapshot, int rank, const hsize_t *size,
                           enum mpm_snapshot_compression compression)
{
    /* one chunk is also one block of writing */
    const hsize_t chunk[2] = {MIN(size[0], MPM_SNAPSHOT_BLOCK), size[1]};
    const hid_t list = mpm_snapshot_checked(snapshot, H5Pcreate(H5P_DATASET_CREATE));
    mpm_snapshot_checked(snapshot, H5Pset_obj_track_times(list, false));
    mpm_snapshot_checked(snapshot, H5Pset_chunk(list, rank, chunk));
    mpm_snapshot_checked(snapshot, H5Pset_shuffle(list));
    if (compression == MPM_DEFLATED)
        mpm_snapshot_checked(snapshot, H5Pset_deflate(list, 1));
    mpm_snapshot_checked(snapshot, H5Pset_fletcher32(list));
    return list;
}

static void block_write(struct mpm_snapshot *snapshot, hid_t dataset, hid_t space, int rank,
                        const hsize_t first[2], const hsize_t size[2])
{
    const hid_t block = mpm_snapshot_checked(snapshot, H5Screate_simple(rank, size, NULL));
    mpm_snapshot_checked(snapshot,
                         H5Sselect_hyperslab(space, H5S_SELECT_SET, first, NULL, size, NULL));
    mpm_snapshot_checked(
        snapshot, H5Dwrite(dataset, H5T_NATIVE_DOUBLE, block, space, H5P_DEFAULT, snapshot->work));
    mpm_snapshot_checked(snapshot, H5Sclose(block));
}

hid_t mpm_snapshot_dataset(struct mpm_snapshot *snapshot, hid_t parent, const char *name,
                           hid_t type, hsize_t rows, hsize_t columns,
                           enum mpm_snapshot_compression compression,
                           const struct mpm_snapshot_source *source)
{
    const hsize_t size[2] = {rows, columns};
    const int rank = columns == 1 ? 1 : 2;
    const hid_t space = mpm_snapshot_checked(snapshot, H5Screate_simple(rank, size, NULL));
    const hid_t list = creation_list(snapshot, rank, size, compression);
    const hid_t dataset = mpm_snapshot_checked(
        snapshot, H5Dcreate2(parent, name, type, space, H5P_DEFAULT, list, H5P_DEFAULT));
    for (hsize_t row = 0; row < rows && snapshot->failure == NULL; row += MPM_SNAPSHOT_BLOCK) {
        const hsize_t first[2] = {row, 0},
                      block[2] = {MIN(rows - row, MPM_SNAPSHOT_BLOCK), columns};
        source->fill(snapshot, source, (size_t)row, (size_t)block[0]);
        block_write(snapshot, dataset, space, rank, first, block);
    }
    mpm_snapshot_checked(snapshot, H5Pclose(list));
    mpm_snapshot_checked(snapshot, H5Sclose(space));
    return dataset;
}

void mpm_snapshot_fill_value(const struct mpm_snapshot *snapshot,
                             const struct mpm_snapshot_source *source, size_t first, size_t count)
{
    (void)first;
    for (size_t i = 0; i < count; i++)
        snapshot->work[i] = source->value;
}

void mpm_snapshot_number(struct mpm_snapshot *snapshot, hid_t parent, const char *name, hid_t type,
                         double value)
{
    const struct mpm_snapshot_source source = {.fill = mpm_snapshot_fill_value, .value = value};
    mpm_snapshot_checked(snapshot, H5Dclose(mpm_snapshot_dataset(snapshot, parent, name, type, 1, 1,
                                                                 MPM_STORED, &source)));
}

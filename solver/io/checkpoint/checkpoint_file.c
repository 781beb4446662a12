/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/checkpoint/checkpoint_file.h"

#include "mpm_file.h"
#include "mpm_hdf5.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <hdf5.h>
#include <string.h>

enum { HEAD_SIZE = 512, BLOCK_SIZE = 1 << 20, SUM_SIZE = 33 };

static const char head_format[] = "touchstone checkpoint\nformat %d\nbytes %lld\nmd5 %s\n";

struct mpm_checkpoint_file {
    char *path;
    struct mpm_hdf5_sink sink;
    hid_t access, file;
};

/* Of a piece in memory, and in a file. */
static hid_t memory_type(enum mpm_piece_type type)
{
    switch (type) {
    case MPM_PIECE_DOUBLE:
        return H5T_NATIVE_DOUBLE;
    case MPM_PIECE_UINT64:
        return H5T_NATIVE_UINT64;
    case MPM_PIECE_INT64:
        return H5T_NATIVE_INT64;
    case MPM_PIECE_UINT32:
        return H5T_NATIVE_UINT32;
    case MPM_PIECE_INT32:
        return H5T_NATIVE_INT32;
    case MPM_PIECE_UINT8:
    case MPM_PIECE_BOOL:
    case MPM_PIECE_TYPE_COUNT:
        break;
    }
    return H5T_NATIVE_UINT8;
}

static hid_t file_type(enum mpm_piece_type type)
{
    switch (type) {
    case MPM_PIECE_DOUBLE:
        return H5T_IEEE_F64LE;
    case MPM_PIECE_UINT64:
        return H5T_STD_U64LE;
    case MPM_PIECE_INT64:
        return H5T_STD_I64LE;
    case MPM_PIECE_UINT32:
        return H5T_STD_U32LE;
    case MPM_PIECE_INT32:
        return H5T_STD_I32LE;
    case MPM_PIECE_UINT8:
    case MPM_PIECE_BOOL:
    case MPM_PIECE_TYPE_COUNT:
        break;
    }
    return H5T_STD_U8LE;
}

/* Returns the MD5 sum of what follows the head, or an errno. */
static int sum_up(int file, off_t size, char sum[SUM_SIZE])
{
    guchar *const block = g_malloc(BLOCK_SIZE);
    GChecksum *const checksum = g_checksum_new(G_CHECKSUM_MD5);
    int failure = 0;
    off_t at = HEAD_SIZE;
    while (at < size && failure == 0) {
        const ssize_t got = mpm_file_read_at(file, block, BLOCK_SIZE, at);
        if (got <= 0)
            failure = got < 0 ? errno : EIO;
        g_checksum_update(checksum, block, MAX(got, 0));
        at += MAX(got, 0);
    }
    (void)g_strlcpy(sum, g_checksum_get_string(checksum), SUM_SIZE);
    g_checksum_free(checksum);
    g_free(block);
    return failure;
}

/* ------------------------------------------------------------------ writing */

struct writer {
    hid_t file;
    char *failure; /* the first one of HDF5, or NULL */
};

static hid_t checked(struct writer *writer, hid_t result)
{
    if (result < 0 && writer->failure == NULL)
        writer->failure = mpm_hdf5_reason();
    return result;
}

static enum mpm_status write_piece(void *context, const struct mpm_piece *piece,
                                   struct mpm_error *error)
{
    struct writer *const writer = context;
    const hsize_t count = piece->count;
    (void)error;
    const hid_t space = checked(writer, H5Screate_simple(1, &count, NULL));
    const hid_t list = checked(writer, H5Pcreate(H5P_DATASET_CREATE));
    checked(writer, H5Pset_obj_track_times(list, false));
    checked(writer, H5Pset_fill_time(list, H5D_FILL_TIME_NEVER));
    const hid_t dataset =
        checked(writer, H5Dcreate2(writer->file, piece->name, file_type(piece->type), space,
                                   H5P_DEFAULT, list, H5P_DEFAULT));
    checked(writer, H5Dwrite(dataset, memory_type(piece->type), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                             piece->data));
    checked(writer, H5Dclose(dataset));
    checked(writer, H5Pclose(list));
    checked(writer, H5Sclose(space));
    return MPM_OK;
}

/* NULL, or why HDF5 failed (g_free). */
static char *write_hdf5(struct mpm_hdf5_sink *sink,
                        void (*visit)(void *context, struct mpm_piece_visitor *visitor),
                        void *context)
{
    struct writer writer = {.failure = NULL};
    struct mpm_piece_visitor visitor = {.take = write_piece, .context = &writer};
    const hid_t access = checked(&writer, mpm_hdf5_sink_access(sink));
    checked(&writer, H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110));
    const hid_t creation = checked(&writer, H5Pcreate(H5P_FILE_CREATE));
    checked(&writer, H5Pset_userblock(creation, HEAD_SIZE));
    checked(&writer, H5Pset_obj_track_times(creation, false));
    writer.file = checked(&writer, H5Fcreate("checkpoint", H5F_ACC_TRUNC, creation, access));
    visit(context, &visitor);
    checked(&writer, H5Fclose(writer.file));
    checked(&writer, H5Pclose(creation));
    checked(&writer, H5Pclose(access));
    return writer.failure;
}

/* 0 or an errno. */
static int write_head(int file)
{
    struct stat facts;
    char head[HEAD_SIZE] = {0}, sum[SUM_SIZE];
    if (mpm_file_facts(file, &facts) != 0)
        return errno;
    const int failure = sum_up(file, facts.st_size, sum);
    (void)g_snprintf(head, sizeof head, head_format, MPM_CHECKPOINT_FORMAT,
                     (long long)facts.st_size, sum);
    if (failure != 0)
        return failure;
    return mpm_file_write_at(file, head, sizeof head, 0) == 0 ? 0 : errno;
}

enum mpm_status mpm_checkpoint_file_write(const char *path,
                                          void (*visit)(void *context,
                                                        struct mpm_piece_visitor *visitor),
                                          void *context, struct mpm_error *error)
{
    struct mpm_hdf5_sink sink = {.file = mpm_file_open(path, O_RDWR | O_CREAT | O_TRUNC)};
    if (sink.file < 0)
        return mpm_file_failed(path, errno, error);
    const struct mpm_hdf5_messages messages = mpm_hdf5_silence();
    char *const failure = write_hdf5(&sink, visit, context);
    mpm_hdf5_restore(&messages);
    int reason = sink.error_number;
    if (reason == 0 && failure == NULL)
        reason = write_head(sink.file);
    if (reason == 0 && mpm_file_sync(sink.file) != 0)
        reason = errno;
    if (mpm_file_close(sink.file) != 0 && reason == 0)
        reason = errno;
    enum mpm_status status = MPM_OK;
    if (reason != 0)
        status = mpm_file_failed(path, reason, error);
    else if (failure != NULL)
        status = mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be written: %s", path,
                               failure);
    if (status != MPM_OK)
        (void)mpm_file_remove(path);
    g_free(failure);
    return status;
}

/* ------------------------------------------------------------------ reading */

/* Is the head that of a file with this length and this sum? */
static enum mpm_status check_head(const char *path, int file, struct mpm_error *error)
{
    struct stat facts;
    char head[HEAD_SIZE + 1] = {0}, wanted[HEAD_SIZE], sum[SUM_SIZE];
    int format = 0;
    static const char start[] = "touchstone checkpoint\nformat ";
    if (mpm_file_facts(file, &facts) != 0)
        return mpm_file_unread(path, errno, NULL, error);
    const ssize_t got = S_ISREG(facts.st_mode) ? mpm_file_read_at(file, head, HEAD_SIZE, 0) : 0;
    if (got < 0)
        return mpm_file_unread(path, errno, NULL, error);
    if (got != HEAD_SIZE || !g_str_has_prefix(head, start))
        return mpm_error_set(error, MPM_BAD_INPUT, "%s: is no checkpoint", path);
    format = (int)g_ascii_strtoll(head + strlen(start), NULL, 10);
    if (format != MPM_CHECKPOINT_FORMAT)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "%s: has format %d; allowed: %d, that of this program", path, format,
                             MPM_CHECKPOINT_FORMAT);
    const int failure = sum_up(file, facts.st_size, sum);
    if (failure != 0)
        return mpm_file_unread(path, failure, NULL, error);
    memset(wanted, 0, sizeof wanted);
    (void)g_snprintf(wanted, sizeof wanted, head_format, MPM_CHECKPOINT_FORMAT,
                     (long long)facts.st_size, sum);
    if (memcmp(head, wanted, HEAD_SIZE) != 0)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "%s: is damaged: its length or its sum is not the one that it states",
                             path);
    return MPM_OK;
}

enum mpm_status mpm_checkpoint_file_open(const char *path, struct mpm_checkpoint_file **file,
                                         struct mpm_error *error)
{
    *file = NULL;
    const int descriptor = mpm_file_open(path, O_RDONLY);
    if (descriptor < 0)
        return mpm_file_unread(path, errno, NULL, error);
    const enum mpm_status status = check_head(path, descriptor, error);
    if (status != MPM_OK) {
        (void)mpm_file_close(descriptor);
        return status;
    }
    struct mpm_checkpoint_file *const opened = g_new0(struct mpm_checkpoint_file, 1);
    *opened = (struct mpm_checkpoint_file){.path = g_strdup(path), .sink = {.file = descriptor}};
    const struct mpm_hdf5_messages messages = mpm_hdf5_silence();
    opened->access = mpm_hdf5_sink_access(&opened->sink);
    opened->file = H5Fopen("checkpoint", H5F_ACC_RDONLY, opened->access);
    mpm_hdf5_restore(&messages);
    const int failure = opened->sink.error_number;
    if (opened->file < 0 || failure != 0) {
        mpm_checkpoint_file_close(opened);
        if (failure != 0)
            return mpm_file_unread(path, failure, NULL, error);
        return mpm_error_set(error, MPM_BAD_INPUT, "%s: is no HDF5 file behind its head", path);
    }
    *file = opened;
    return MPM_OK;
}

void mpm_checkpoint_file_close(struct mpm_checkpoint_file *file)
{
    if (file == NULL)
        return;
    const struct mpm_hdf5_messages messages = mpm_hdf5_silence();
    if (file->file >= 0)
        (void)H5Fclose(file->file);
    if (file->access >= 0)
        (void)H5Pclose(file->access);
    mpm_hdf5_restore(&messages);
    (void)mpm_file_close(file->sink.file);
    g_free(file->path);
    g_free(file);
}

/* Bytes that a bool cannot have. */
static bool has_other_than_bits(const struct mpm_piece *piece)
{
    const unsigned char *const bytes = piece->data;
    bool found = false;
    for (size_t k = 0; piece->type == MPM_PIECE_BOOL && k < piece->count; k++)
        found = found || bytes[k] > 1;
    if (found)
        memset(piece->data, 0, piece->count);
    return found;
}

/* Does the dataset have the piece's kind of numbers, as many of them, and give them? */
static bool read_dataset(hid_t dataset, const struct mpm_piece *piece)
{
    const hid_t space = H5Dget_space(dataset), type = H5Dget_type(dataset);
    const bool fits = H5Sget_simple_extent_ndims(space) == 1 &&
                      H5Sget_simple_extent_npoints(space) == (hssize_t)piece->count &&
                      H5Tequal(type, file_type(piece->type)) > 0;
    const bool read = fits && H5Dread(dataset, memory_type(piece->type), H5S_ALL, H5S_ALL,
                                      H5P_DEFAULT, piece->data) >= 0;
    (void)H5Tclose(type);
    (void)H5Sclose(space);
    return read;
}

enum mpm_status mpm_checkpoint_file_read(void *context, const struct mpm_piece *piece,
                                         struct mpm_error *error)
{
    struct mpm_checkpoint_file *const file = context;
    const struct mpm_hdf5_messages messages = mpm_hdf5_silence();
    const hid_t dataset = H5Dopen2(file->file, piece->name, H5P_DEFAULT);
    const bool read = dataset >= 0 && read_dataset(dataset, piece);
    if (dataset >= 0)
        (void)H5Dclose(dataset);
    mpm_hdf5_restore(&messages);
    if (file->sink.error_number != 0)
        return mpm_file_unread(file->path, file->sink.error_number, NULL, error);
    if (!read || has_other_than_bits(piece))
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "%s: '%s' is missing or not %zu numbers of its "
                             "kind",
                             file->path, piece->name, piece->count);
    return MPM_OK;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm_file.h"
#include "mpm_hdf5.h"

#include <H5FDpublic.h>
#include <errno.h>
#include <glib.h>
#include <hdf5.h>
#include <stdlib.h>
#include <string.h>

#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

struct sink_file {
    H5FD_t base; /* first: HDF5 sees the file through it */
    struct mpm_hdf5_sink *sink;
    haddr_t allocated; /* end of the addresses that HDF5 has given out */
    haddr_t size;      /* end of the bytes written */
};

static struct sink_file *sink_of(H5FD_t *file)
{
    return (struct sink_file *)(void *)file;
}

static const struct sink_file *sink_of_const(const H5FD_t *file)
{
    return (const struct sink_file *)(const void *)file;
}

static void keep_error(struct mpm_hdf5_sink *sink, int error_number)
{
    if (sink->error_number == 0)
        sink->error_number = error_number;
}

static H5FD_t *sink_open(const char *name, unsigned flags, hid_t access, haddr_t maximum)
{
    (void)name, (void)flags, (void)maximum;
    struct mpm_hdf5_sink *const *sink = H5Pget_driver_info(access);
    struct sink_file *file = calloc(1, sizeof *file);
    if (sink == NULL || file == NULL) {
        free(file);
        return NULL;
    }
    struct stat facts;
    file->sink = *sink;
    if (mpm_file_facts(file->sink->file, &facts) == 0)
        file->size = (haddr_t)facts.st_size;
    else
        keep_error(file->sink, errno);
    return &file->base;
}

static herr_t sink_close(H5FD_t *file)
{
    free(sink_of(file));
    return 0;
}

static herr_t sink_query(const H5FD_t *file, unsigned long *flags)
{
    (void)file;
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA;
    return 0;
}

static haddr_t sink_allocated(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return sink_of_const(file)->allocated;
}

static herr_t sink_allocate(H5FD_t *file, H5FD_mem_t type, haddr_t end)
{
    (void)type;
    sink_of(file)->allocated = end;
    return 0;
}

static haddr_t sink_size(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return sink_of_const(file)->size;
}

/* What was never written reads as zeros. */
static herr_t sink_read(H5FD_t *file, H5FD_mem_t type, hid_t transfer, haddr_t address, size_t size,
                        void *buffer)
{
    (void)type, (void)transfer;
    struct mpm_hdf5_sink *sink = sink_of(file)->sink;
    char *bytes = buffer;
    const ssize_t got = mpm_file_read_at(sink->file, bytes, size, (off_t)address);
    if (got < 0)
        keep_error(sink, errno);
    const size_t done = got < 0 ? 0 : (size_t)got;
    memset(bytes + done, 0, size - done);
    return 0;
}

static herr_t sink_write(H5FD_t *file, H5FD_mem_t type, hid_t transfer, haddr_t address,
                         size_t size, const void *buffer)
{
    (void)type, (void)transfer;
    struct sink_file *written = sink_of(file);
    if (written->sink->error_number == 0 &&
        mpm_file_write_at(written->sink->file, buffer, size, (off_t)address) != 0)
        keep_error(written->sink, errno);
    if (address + size > written->size)
        written->size = address + size;
    return 0;
}

/* HDF5 may allocate more than it writes at the end: the file has what is allocated. */
static herr_t sink_truncate(H5FD_t *file, hid_t transfer, hbool_t closing)
{
    (void)transfer, (void)closing;
    struct sink_file *truncated = sink_of(file);
    if (truncated->sink->error_number == 0 &&
        mpm_file_cut(truncated->sink->file, (off_t)truncated->allocated) != 0)
        keep_error(truncated->sink, errno);
    truncated->size = truncated->allocated;
    return 0;
}

static const H5FD_class_t sink_class = {
#if H5_VERSION_GE(1, 13, 0)
    .version = H5FD_CLASS_VERSION,
    .value = (H5FD_class_value_t)H5_VFD_RESERVED,
#endif
    .name = "sink",
    .maxaddr = ((haddr_t)1 << 62),
    .fc_degree = H5F_CLOSE_STRONG,
    .fapl_size = sizeof(struct mpm_hdf5_sink *),
    .open = sink_open,
    .close = sink_close,
    .query = sink_query,
    .get_eoa = sink_allocated,
    .set_eoa = sink_allocate,
    .get_eof = sink_size,
    .read = sink_read,
    .write = sink_write,
    .truncate = sink_truncate,
    .fl_map = H5FD_FLMAP_DICHOTOMY,
};

_Static_assert(sizeof(hid_t) == sizeof(int64_t), "HDF5 1.10 or later");

int64_t mpm_hdf5_sink_access(struct mpm_hdf5_sink *sink)
{
    const hid_t driver = H5FDregister(&sink_class);
    if (driver < 0)
        return -1;
    hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    if (access >= 0 && H5Pset_driver(access, driver, &sink) < 0) {
        (void)H5Pclose(access);
        access = -1;
    }
    (void)H5FDunregister(driver); /* the list holds a reference of its own */
    return access;
}

struct mpm_hdf5_messages mpm_hdf5_silence(void)
{
    struct mpm_hdf5_messages messages;
    (void)H5Eget_auto2(H5E_DEFAULT, &messages.print, &messages.context);
    (void)H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    return messages;
}

void mpm_hdf5_restore(const struct mpm_hdf5_messages *messages)
{
    (void)H5Eset_auto2(H5E_DEFAULT, messages->print, messages->context);
}

static herr_t keep_innermost(unsigned depth, const H5E_error2_t *entry, void *failure)
{
    char **text = failure;
    if (depth == 0)
        *text = g_strdup_printf("%s: %s", entry->func_name, entry->desc);
    return 0;
}

char *mpm_hdf5_reason(void)
{
    char *reason = NULL;
    (void)H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
    return reason != NULL ? reason : g_strdup("HDF5 failed without a reason");
}

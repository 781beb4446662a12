/* An HDF5 file driver for writing one new file to a disk that may be full, and for reading one, by
 * the calls of mpm_file.h; and HDF5's messages.
 *
 * HDF5 1.10 cannot close a file whose blocks it could not write: it keeps the file
 * open and crashes when the program ends. This driver reports to HDF5 that every write
 * went well, keeps the first error of the system and lets the caller read it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_HDF5_H
#define MPM_HDF5_H

#include <stdint.h>

struct mpm_hdf5_sink {
    int file;         /* descriptor of a file, to be written an empty one open for both */
    int error_number; /* errno of the first write or read that failed, or 0 */
};

/* A file access property list (an HDF5 hid_t) that makes H5Fcreate write to `sink`, and H5Fopen
 * read from it, whatever file name it is given; negative on failure. The caller closes the file
 * first and the list after it (the list keeps the driver alive: H5FD_close of 1.10
 * lets go of a driver before it calls it), and then reads error_number: if it is
 * not 0, the file is worthless. *sink must live until then; the descriptor stays the
 * caller's. */
int64_t mpm_hdf5_sink_access(struct mpm_hdf5_sink *sink);

/* HDF5 prints its failures unless it is told not to: until mpm_hdf5_restore. */
struct mpm_hdf5_messages {
    int (*print)(int64_t stack, void *context);
    void *context;
};
struct mpm_hdf5_messages mpm_hdf5_silence(void);
void mpm_hdf5_restore(const struct mpm_hdf5_messages *messages);

/* The innermost reason of the failure at hand; g_free. */
char *mpm_hdf5_reason(void);

#endif

/* An HDF5 file driver for writing one new file to a disk that may be full.
 *
 * HDF5 1.10 cannot close a file whose blocks it could not write: it keeps the file
 * open and crashes when the program ends. This driver reports to HDF5 that every write
 * went well, keeps the first error of the system and lets the caller read it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_HDF5_SINK_H
#define MPM_IO_HDF5_SINK_H

#include <stdint.h>

struct mpm_hdf5_sink {
    int file;         /* descriptor of an empty file, open for reading and writing */
    int error_number; /* errno of the first write that failed, or 0 */
};

/* A file access property list (an HDF5 hid_t) that makes H5Fcreate write to `sink`,
 * whatever file name it is given; negative on failure. The caller closes the file
 * first and the list after it (the list keeps the driver alive: H5FD_close of 1.10
 * lets go of a driver before it calls it), and then reads error_number: if it is
 * not 0, the file is worthless. *sink must live until then; the descriptor stays the
 * caller's. */
int64_t mpm_hdf5_sink_access(struct mpm_hdf5_sink *sink);

#endif

/* The results of a solver: one file or a folder of them, in any of the formats of readers.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_RESULTS_H
#define VERIFICATION_SCORE_RESULTS_H

#include "verification/score/table.h"

/* Reads `path` into a new table (score_table_close): a file .csv, .hdf, .h5, .hdf5, .vtk, .vtu,
 * .vtp, or .pvd, which names others; or a folder, of which all files of the first kind that it has
 * are read, in that order: .pvd, HDF5, VTK, CSV.
 *
 * What follows from other columns is filled in: the initial position from position and
 * displacement, or from the position at time 0 of the point with the same id; the displacement from
 * both positions. Where there is a column `body`, rows of others than the problem's
 * are left out.
 *
 * MPM_BAD_INPUT: a file that cannot be read, no results at all, or of other bodies alone, files
 * whose columns differ, ids that do not tell the points apart where they are needed. */
enum mpm_status results_read(const char *path, const struct score_format *format,
                             struct score_table *table, struct mpm_error *error);

#endif

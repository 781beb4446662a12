/* Readers of one file of results each. All fill an open table with the columns that they know and
 * refuse, with MPM_BAD_INPUT, file and line (or the dataset's or array's name), what they cannot
 * read, numbers that are not finite, and a unit that is not the problem's.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_READERS_H
#define VERIFICATION_SCORE_READERS_H

#include "verification/score/table.h"

/* So many rows are read of one file that declares their number before it gives them: a declared
 * number is believed up to here, and no memory is taken for more. */
enum { SCORE_ROWS_MAX = 100000000 };

/* CSV: a line of names, each with its unit in brackets or without, then a line of numbers for each
 * row. Empty lines, lines that begin with '#' and a byte order mark are passed over. */
enum mpm_status score_read_csv(const char *path, const struct score_format *format,
                               struct score_table *table, struct mpm_error *error);

/* A snapshot of `mpm run`: /mpm/particles/position, velocity, deformation_gradient, stress, id,
 * body, and optionally initial_position and displacement; the time is an attribute of /mpm. */
enum mpm_status score_read_hdf5(const char *path, const struct score_format *format,
                                struct score_table *table, struct mpm_error *error);

/* Legacy VTK, ASCII: POLYDATA or UNSTRUCTURED_GRID with POINTS, POINT_DATA and its SCALARS,
 * VECTORS, TENSORS and FIELD arrays; cells, of version 5 too, and METADATA are passed over; the
 * time from the field data TimeValue or TIME. */
enum mpm_status score_read_vtk(const char *path, const struct score_format *format,
                               struct score_table *table, struct mpm_error *error);

/* VTK's XML files .vtu and .vtp of one piece, arrays ASCII or binary (base64, not compressed, in
 * place); the time from the field data TimeValue or TIME. */
enum mpm_status score_read_vtk_xml(const char *path, const struct score_format *format,
                                   struct score_table *table, struct mpm_error *error);

/* ------------------------------------------------ shared by the readers of VTK */

/* Puts an array of `rows` x `components` values into the columns that its name and number of
 * components are of: position, displacement, initial_position, velocity (2 or 3), stress (4: as
 * the columns; 6: xx yy zz xy yz xz; 9: by rows), deformation_gradient (9), or one of the columns'
 * own names (1). Any other is noted as unread. MPM_BAD_INPUT: the number of components, the number
 * of rows if the table has some already, a value that is not finite. */
enum mpm_status score_take_array(const char *path, const struct score_format *format,
                                 const char *name, size_t components, const GArray *values,
                                 struct score_table *table, struct mpm_error *error);

/* Fills the column of times, or reports that the file has none. */
enum mpm_status score_take_time(const char *path, double time, struct score_table *table,
                                struct mpm_error *error);

#endif

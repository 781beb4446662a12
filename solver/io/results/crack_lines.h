/* Cracks as ParaView shows them: cracks-000000.vtp, ..., one file beside each snapshot, with a line
 * for each crack, and cracks.vtp.series, their list with times.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_CRACK_LINES_H
#define MPM_IO_CRACK_LINES_H

#include "model/scene.h"

#define MPM_CRACKS_PREFIX "cracks-"
#define MPM_CRACKS_SUFFIX ".vtp"
#define MPM_CRACKS_LIST   "cracks.vtp.series"

/* The file for the snapshot of that number: VTK's XML of polygonal data. Nothing in scenes without
 * cracks. */
enum mpm_status mpm_crack_lines_write(const char *folder, size_t number,
                                      const struct mpm_scene *scene,
                                      const struct mpm_simulation *simulation,
                                      struct mpm_error *error);

/* The name of the file of a snapshot; g_free. */
char *mpm_crack_lines_name(size_t number);

#endif

/* The new report in the place of the old one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_OUTPUT_PUBLISH_H
#define VERIFICATION_SUITE_OUTPUT_PUBLISH_H

#include "verification/suite/output_folder.h"

/* Of a folder without mark: *found, the path of a file or folder that a report would replace, or
 * NULL; g_free. */
enum mpm_status output_find_ours(const char *folder, char **found, struct mpm_error *error);

/* Puts what is in report/ in the place of the report before. */
enum mpm_status output_publish(const struct output_folder *output, struct mpm_error *error);

/* Ends a publication that was cut short, if there is one. */
enum mpm_status output_recover(const struct output_folder *output, struct mpm_error *error);

#endif

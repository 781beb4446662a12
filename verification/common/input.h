/* Files that are read: the message names the file and the reason. MPM_BAD_INPUT where the name or
 * what is in the file is wrong, MPM_ENVIRONMENT_FAILED where the system fails.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_INPUT_H
#define VERIFICATION_COMMON_INPUT_H

#include "mpm_file.h"

#include <glib.h>
#include <jansson.h>

/* All of a file, with a zero byte after it (g_free); `length` and `allowed`, words for the message,
 * may be NULL. */
enum mpm_status input_text(const char *path, const char *allowed, char **text, size_t *length,
                           struct mpm_error *error);

/* JSON, with the flags of jansson: "path:line: what is wrong". */
enum mpm_status input_json(const char *path, size_t flags, json_t **json, struct mpm_error *error);

/* What the path is: a fault of the system is not taken for a file that is missing. */
enum mpm_status input_kind(const char *path, enum mpm_path *kind, struct mpm_error *error);

/* Names of what is in a folder, sorted (g_free'd with the array). */
enum mpm_status input_names(const char *folder, GPtrArray **names, struct mpm_error *error);

#endif

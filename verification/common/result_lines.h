/* Files of result lines: one JSON object a line, the first one about the run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_RESULT_LINES_H
#define VERIFICATION_COMMON_RESULT_LINES_H

#include "mpm.h"

#include <jansson.h>

/* What a program writes, and words for messages. */
struct result_format {
    const char *file;    /* name in the output folder */
    const char *command; /* that writes it: "mpm-verify run" */
    const char *noun;    /* of a line: "record of a check" */
    bool (*is_run)(const json_t *object);
    bool (*is_line)(const json_t *object);
};

/* Reads the file of a folder: *run the first object, *lines an array of the others, both the
 * caller's. Anything else in it is MPM_BAD_INPUT with file and line; then both are NULL. */
enum mpm_status result_lines_read(const char *folder, const struct result_format *format,
                                  json_t **run, json_t **lines, struct mpm_error *error);

#endif

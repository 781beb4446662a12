/* Files of result lines: one JSON object a line, the first one about the run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_RESULT_LINES_H
#define VERIFICATION_COMMON_RESULT_LINES_H

#include "mpm.h"
#include "verification/common/record_shape.h"

#include <jansson.h>

/* What a program writes, and words for messages. */
struct result_format {
    const char *file;                                     /* name in the output folder */
    const char *command;                                  /* that writes it: "mpm-verify run" */
    const char *noun;                                     /* of a line: "record of a check" */
    const struct record_field *run;                       /* of the first object */
    const struct record_field *line;                      /* of the others */
    bool (*is_run)(const json_t *object, GString *fault); /* what a table of fields cannot state */
    bool (*is_line)(const json_t *object, GString *fault);
};

/* Reads the file of a folder: *run the first object, *lines an array of the others, both the
 * caller's. Anything else in it is MPM_BAD_INPUT with file, line and what is wrong there; then both
 * are NULL. The file may come from anywhere: a link, JSON that is no object of the format, numbers
 * beyond those of a computer are refused. */
enum mpm_status result_lines_read(const char *folder, const struct result_format *format,
                                  json_t **run, json_t **lines, struct mpm_error *error);

#endif

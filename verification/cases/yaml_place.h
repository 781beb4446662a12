/* Where something stands in a YAML file: only asked once an error is known.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_CASES_YAML_PLACE_H
#define VERIFICATION_CASES_YAML_PLACE_H

#include "mpm.h"

/* Line (from 1) of the value at a dotted path of keys and positions ("checks.3.low"),
 * or of the nearest parent that exists; 0 if the file has no such thing at all. */
unsigned yaml_place_line(const char *file, const char *path);

/* Line of the first scalar `text` at or after (line, column), both from 1; 0 if none.
 * The schema reader points one token early: this finds the token that it means. */
unsigned yaml_place_scalar(const char *file, const char *text, unsigned line, unsigned column);

/* MPM_BAD_INPUT with "file:line: place: message", the line being that of `place`. */
enum mpm_status yaml_refuse(const char *file, struct mpm_error *error, const char *place,
                            const char *format, ...) __attribute__((format(printf, 4, 5)));

#endif

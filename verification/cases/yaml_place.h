/* Where something is in a YAML file: searched only once an error is known.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_CASES_YAML_PLACE_H
#define VERIFICATION_CASES_YAML_PLACE_H

#include "mpm.h"

/* Line (from 1) of the key or entry at a dotted path of keys and positions ("checks.3.low"),
 * or of the nearest parent that exists; 0 if the file cannot be read. */
unsigned yaml_place_line(const char *file, const char *path);

/* MPM_BAD_INPUT with "file:line: place: message", the line being that of `place`. */
enum mpm_status yaml_refuse(const char *file, struct mpm_error *error, const char *place,
                            const char *format, ...) __attribute__((format(printf, 4, 5)));

#endif

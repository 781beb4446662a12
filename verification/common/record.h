/* A record: one JSON object with texts and numbers, a line of a file of results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_RECORD_H
#define VERIFICATION_COMMON_RECORD_H

#include <jansson.h>

/* A text or number of an object; "" or NaN where it is null or missing. */
const char *record_text(const json_t *object, const char *key);
double record_number(const json_t *object, const char *key);

/* A text that may hold any bytes, as JSON; control characters become '?'. */
json_t *record_text_of(const char *text);

#endif

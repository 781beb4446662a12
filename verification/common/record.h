/* A record: one JSON object with texts and numbers, a line of a file of results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_RECORD_H
#define VERIFICATION_COMMON_RECORD_H

#include <jansson.h>
#include <stdbool.h>
#include <stdint.h>

/* A text or number of an object; "" or NaN where it is null or missing. */
const char *record_text(const json_t *object, const char *key);
double record_number(const json_t *object, const char *key);

/* Whether a record may hold the character: all but control characters (newline and tab are
 * allowed), U+FFFE and U+FFFF. */
bool record_shows(uint32_t character);

/* A text that may hold any bytes, as JSON; what is not shown becomes '?'. */
json_t *record_text_of(const char *text);

#endif

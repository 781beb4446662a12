/* The shape of a record: which keys it has, with values of which kind.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_RECORD_SHAPE_H
#define VERIFICATION_COMMON_RECORD_SHAPE_H

#include <glib.h>
#include <jansson.h>
#include <stdbool.h>

enum record_kind {
    RECORD_TEXT,
    RECORD_NAME, /* a text that can be part of a path: name_is_plain() */
    RECORD_NUMBER,
    RECORD_COUNT,   /* a whole number of at least 0 */
    RECORD_TEXTS,   /* a list of texts */
    RECORD_NUMBERS, /* a list, or an object under any keys, of numbers and null */
    RECORD_OBJECT,
    RECORD_LIST, /* of objects */
};

/* Tables of fields end with one without a key. */
struct record_field {
    const char *key;
    enum record_kind kind;
    bool needed;                       /* else it may be missing or null */
    const struct record_field *fields; /* of OBJECT, and of each of a LIST */
};

/* Whether the object has the fields, each of its kind, and neither they nor any other text or key
 * in it has a character that no page and no terminal can show (control characters but newline and
 * tab; U+FFFE and U+FFFF). Else *fault is what is wrong, as "cases.3.title: allowed is a text".
 * Keys without a field are allowed. */
bool record_fits(const json_t *object, const struct record_field *fields, GString *fault);

#endif

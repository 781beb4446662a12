/* YAML files read by a schema: unknown and repeated keys, wrong types and aliases are
 * refused with file and line.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_CASES_YAML_READ_H
#define VERIFICATION_CASES_YAML_READ_H

#include "mpm.h"

#include <cyaml/cyaml.h>

enum { YAML_TEXT_MAX = 4096 };

/* Fields of a schema: a text of at least one character, the same where it may be left out,
 * and a list of at least so many entries. */
#define YAML_TEXT(key, type, member)                                                               \
    CYAML_FIELD_STRING_PTR(key, CYAML_FLAG_POINTER, struct type, member, 1, YAML_TEXT_MAX)
#define YAML_OPTIONAL_TEXT(key, type, member)                                                      \
    CYAML_FIELD_STRING_PTR(key, CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL, struct type, member, 1,  \
                           YAML_TEXT_MAX)
#define YAML_LIST(key, type, member, entry, least)                                                 \
    CYAML_FIELD_SEQUENCE(key, CYAML_FLAG_POINTER | ((least) > 0 ? 0 : CYAML_FLAG_OPTIONAL),        \
                         struct type, member, entry, least, 1000)

/* An entry of a list of texts. */
extern const cyaml_schema_value_t yaml_text_schema;

/* Reads the file into new memory of malloc, as the schema lays it out. *data is NULL on
 * MPM_BAD_INPUT. */
enum mpm_status yaml_read(const char *path, const cyaml_schema_value_t *schema, void **data,
                          struct mpm_error *error);
void yaml_read_free(const cyaml_schema_value_t *schema, void *data);

#endif

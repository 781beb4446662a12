/* Shapes of records.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/record_shape.h"

#include "verification/common/names.h"
#include "verification/common/record.h"

#include <string.h>

/* ----------------------------------------------------------------- characters */

static bool can_be_shown(const char *text)
{
    for (const char *c = text; *c != '\0'; c = g_utf8_next_char(c))
        if (!record_shows(g_utf8_get_char(c)))
            return false;
    return true;
}

static bool all_can_be_shown(const json_t *value)
{
    if (json_is_string(value))
        return can_be_shown(json_string_value(value));
    for (size_t i = 0; i < json_array_size(value); i++)
        if (!all_can_be_shown(json_array_get(value, i)))
            return false;
    for (void *at = json_object_iter((json_t *)(uintptr_t)value); at != NULL;
         at = json_object_iter_next((json_t *)(uintptr_t)value, at))
        if (!can_be_shown(json_object_iter_key(at)) ||
            !all_can_be_shown(json_object_iter_value(at)))
            return false;
    return true;
}

/* ----------------------------------------------------------------------- kinds */

static bool is_number_or_null(const json_t *value)
{
    return json_is_number(value) || json_is_null(value);
}

static bool are_all(const json_t *values, bool (*is)(const json_t *value))
{
    for (size_t i = 0; i < json_array_size(values); i++)
        if (!is(json_array_get(values, i)))
            return false;
    for (void *at = json_object_iter((json_t *)(uintptr_t)values); at != NULL;
         at = json_object_iter_next((json_t *)(uintptr_t)values, at))
        if (!is(json_object_iter_value(at)))
            return false;
    return true;
}

static bool is_text(const json_t *value)
{
    return json_is_string(value);
}

static bool is_of_kind(const json_t *value, enum record_kind kind)
{
    switch (kind) {
    case RECORD_TEXT:
        return json_is_string(value);
    case RECORD_NAME:
        return json_is_string(value) && name_is_plain(json_string_value(value));
    case RECORD_NUMBER:
        return json_is_number(value);
    case RECORD_COUNT:
        return json_is_integer(value) && json_integer_value(value) >= 0;
    case RECORD_TEXTS:
        return json_is_array(value) && are_all(value, is_text);
    case RECORD_NUMBERS:
        return (json_is_array(value) || json_is_object(value)) && are_all(value, is_number_or_null);
    case RECORD_OBJECT:
        return json_is_object(value);
    case RECORD_LIST:
        return json_is_array(value);
    }
    return false;
}

static const char *words_of(enum record_kind kind)
{
    static const char *const words[] = {
        [RECORD_TEXT] = "a text",
        [RECORD_NAME] = "a name of letters, digits, '_' and '-'",
        [RECORD_NUMBER] = "a number",
        [RECORD_COUNT] = "a whole number of at least 0",
        [RECORD_TEXTS] = "a list of texts",
        [RECORD_NUMBERS] = "numbers",
        [RECORD_OBJECT] = "an object",
        [RECORD_LIST] = "a list of objects",
    };
    return words[kind];
}

/* ------------------------------------------------------------------------ shapes */

/* `fault` holds the place of the object, and takes the fault. */
static bool fits(const json_t *object, const struct record_field *fields, GString *fault);

static bool list_fits(const json_t *list, const struct record_field *field, GString *fault)
{
    const size_t place = fault->len;
    for (size_t i = 0; i < json_array_size(list); i++) {
        g_string_append_printf(fault, "%s.%zu", field->key, i);
        const json_t *object = json_array_get(list, i);
        if (!json_is_object(object)) {
            g_string_append(fault, ": allowed is an object");
            return false;
        }
        g_string_append_c(fault, '.');
        if (!fits(object, field->fields, fault))
            return false;
        g_string_truncate(fault, place);
    }
    return true;
}

static bool field_fits(const json_t *object, const struct record_field *field, GString *fault)
{
    const json_t *value = json_object_get(object, field->key);
    const size_t place = fault->len;
    if ((value == NULL || json_is_null(value)) && !field->needed)
        return true;
    if (!is_of_kind(value, field->kind)) {
        g_string_append_printf(fault, "%s: allowed is %s", field->key, words_of(field->kind));
        return false;
    }
    if (field->kind == RECORD_LIST)
        return list_fits(value, field, fault);
    if (field->kind != RECORD_OBJECT || field->fields == NULL)
        return true;
    g_string_append_printf(fault, "%s.", field->key);
    if (!fits(value, field->fields, fault))
        return false;
    g_string_truncate(fault, place);
    return true;
}

static bool fits(const json_t *object, const struct record_field *fields, GString *fault)
{
    for (; fields->key != NULL; fields++)
        if (!field_fits(object, fields, fault))
            return false;
    return true;
}

bool record_fits(const json_t *object, const struct record_field *fields, GString *fault)
{
    g_string_truncate(fault, 0);
    if (!json_is_object(object)) {
        g_string_assign(fault, "allowed is an object");
        return false;
    }
    if (!fits(object, fields, fault))
        return false;
    if (all_can_be_shown(object))
        return true;
    g_string_assign(fault, "a text has a character that cannot be shown");
    return false;
}

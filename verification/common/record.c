/* A record.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/record.h"

#include <glib.h>
#include <math.h>

const char *record_text(const json_t *object, const char *key)
{
    const char *text = json_string_value(json_object_get(object, key));
    return text == NULL ? "" : text;
}

double record_number(const json_t *object, const char *key)
{
    const json_t *number = json_object_get(object, key);
    return json_is_number(number) ? json_number_value(number) : (double)NAN;
}

/* Control characters go, since no escape makes them legal in XML. */
json_t *record_text_of(const char *text)
{
    char *valid = g_utf8_make_valid(text, -1);
    for (char *c = valid; *c != '\0'; c++)
        if (((unsigned char)*c < ' ' && *c != '\n' && *c != '\t') || *c == 0x7f)
            *c = '?';
    json_t *json = json_string(valid);
    g_free(valid);
    return json;
}

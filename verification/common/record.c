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

/* What no page and no terminal can show becomes '?': control characters, of which some are not
 * legal in XML by any escape and others command terminals, and U+FFFE and U+FFFF. record_fits()
 * refuses the same. */
bool record_shows(uint32_t character)
{
    return character == '\n' || character == '\t' ||
           !(g_unichar_iscntrl(character) || character == 0xfffe || character == 0xffff);
}

json_t *record_text_of(const char *text)
{
    char *valid = g_utf8_make_valid(text, -1);
    GString *shown = g_string_new(NULL);
    for (const char *c = valid; *c != '\0'; c = g_utf8_next_char(c)) {
        const gunichar character = g_utf8_get_char(c);
        g_string_append_unichar(shown, record_shows(character) ? character : '?');
    }
    json_t *json = json_string(shown->str);
    g_string_free(shown, TRUE);
    g_free(valid);
    return json;
}

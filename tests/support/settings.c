/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/settings.h"
#include "support/marks.h"

#include <stdarg.h>

void settings_add(struct settings *settings, const char *text)
{
    ck_assert_uint_lt(settings->count, G_N_ELEMENTS(settings->texts) - 1);
    settings->texts[settings->count++] = text;
}

void settings_add_formatted(struct settings *settings, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *const text = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    settings->owned[settings->owned_count++] = text;
    settings_add(settings, text);
}

void settings_clear(struct settings *settings)
{
    for (guint i = 0; i < settings->owned_count; i++)
        g_free(settings->owned[i]);
    *settings = (struct settings){.count = 0};
}

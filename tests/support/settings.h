/* A list of scene settings that grows, for tests that put scenes together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_SETTINGS_H
#define TESTS_SUPPORT_SETTINGS_H

#include <glib.h>

/* Starts from zeros. */
struct settings {
    const char *texts[16];
    char *owned[16];
    guint count, owned_count;
};

/* `text` must outlive the list. */
void settings_add(struct settings *settings, const char *text);
void settings_add_formatted(struct settings *settings, const char *format, ...) G_GNUC_PRINTF(2, 3);
void settings_clear(struct settings *settings);

#endif

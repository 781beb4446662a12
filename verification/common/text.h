/* Small texts that all reports share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_TEXT_H
#define VERIFICATION_COMMON_TEXT_H

#include <glib.h>
#include <stdbool.h>

/* A number with four digits, "none" if it is not finite; the unit "1" is left out. */
char *text_number(double value);
char *text_quantity(double value, const char *unit);

/* "0.05 .. 2 %", or "0.8333 ± 1e-12" where the ends do not differ in four digits. */
char *text_range(double low, double high, const char *unit);

/* Four digits, or as many as tell the number from the ends of a range; with the unit. */
char *text_beside_range(double value, double low, double high, const char *unit);

/* "340 ms", "12.3 s", "2 min 5 s" */
char *text_seconds(double seconds);

/* "1 check", "2 checks" */
char *text_count(size_t count, const char *noun);

/* Appends with every %s escaped for HTML and XML. */
void text_markup(GString *string, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Appends a text so that Markdown takes no character of it as its own. */
void text_markdown(GString *markdown, const char *text);

#endif

/* Small texts that the renderers share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_TEXT_H
#define VERIFICATION_SUITE_TEXT_H

#include "verification/suite/records.h"

#include <glib.h>

/* A number with four digits, "none" if it is not finite; the unit "1" is left out. */
char *text_number(double value);
char *text_quantity(double value, const char *unit);

/* "0.05 .. 2 %", or "0.8333 ± 1e-12" where the ends do not differ in four digits. */
char *text_range(double low, double high, const char *unit);

/* The value of a check: four digits, or as many as tell it from its band where it is red. */
char *text_value(const json_t *check);

/* The band that the check is declared to be in. */
char *text_band(const json_t *check);

/* "340 ms", "12.3 s", "2 min 5 s" */
char *text_seconds(double seconds);

/* "1 check", "2 checks" */
char *text_count(size_t count, const char *noun);

/* The verdict of a run in one line. */
char *text_verdict(const struct record_counts *counts);

/* "R1/interior_sd_j [ugimp]" */
char *text_check_name(const json_t *check);

/* The command that runs a variant again, for the shell, with the kernels of that run: the
 * object of kind "run", or NULL. */
char *text_command(const char *name, const char *variant, bool full, const json_t *run);

/* Appends with every %s escaped for HTML and XML. */
void text_markup(GString *string, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Appends a text so that Markdown takes no character of it as its own. */
void text_markdown(GString *markdown, const char *text);

#endif

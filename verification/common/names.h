/* Names, and shell patterns that select them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_NAMES_H
#define VERIFICATION_COMMON_NAMES_H

#include <stdbool.h>

/* Whether the shell pattern (*, ?, [...]) matches the whole name; whether any does. */
bool glob_matches(const char *glob, const char *name);
bool globs_match(char *const *globs, unsigned count, const char *name);
/* The same for patterns in one text, joined by commas; NULL matches all. */
bool glob_list_matches(const char *globs, const char *name);

/* Whether a text can be the name of a case, a variant, ...: part of file names, links and
 * globs; the rule for messages. */
bool name_is_sound(const char *text);
extern const char name_rule[];

/* Whether a text is of letters, digits, '_' and '-', of any length: part of a file's name. */
bool name_is_plain(const char *text);

/* Whether a text is the name of a figure's script: NAME.gp with a plain name that is no option. */
bool name_is_script(const char *text);

#endif

/* The table and the list behind `mpm schema`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SCHEMA_H
#define MPM_IO_SCHEMA_H

#include <stddef.h>

/* Every key of a scene in lines of up to 80 characters, in two columns under a heading: the key,
 * and beside it type, unit, default and range, then what it means. List entries are written
 * `bodies[].name`. With `filter` not NULL only keys that have it in one of these texts, whatever
 * its case; *count: how many. The caller frees the text; NULL without memory. */
char *mpm_schema_text(const char *filter, size_t *count);

/* JSON Schema (draft 7) of a scene, for editors: the types, ranges, choices, defaults and meanings
 * of keys, which of them are required, and those of one geometry alone. What needs several keys is
 * not in it. The caller frees the text; NULL without memory. */
char *mpm_schema_document(void);

/* The keys as a list for programs, as JSON: {"format": 1, "keys": [...]}, one object for each key,
 * a group before its children. `key`: as in the table. `shape`: one, pair, points, choice, group or
 * list. `value`: number, expression, drive (an expression or `free`), text, name, law, integer or
 * boolean; null for choices, groups and lists. `geometry`: planar or axisymmetric where the key is
 * for such scenes only, else null. `required`. `unit`: "" for none. `default`: YAML text, null
 * where there is none. `low`, `high`: range of the values, of the number of points for points;
 * null: no limit; `low_open`, `high_open`: the end itself is not allowed. `choices`: names, null
 * where any value of the kind is allowed. `help`. The caller frees the text; NULL without memory.
 */
char *mpm_schema_list(void);

#endif

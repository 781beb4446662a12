/* The table and the list behind `mpm schema`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SCHEMA_H
#define MPM_IO_SCHEMA_H

/* Every key of a scene, one line each: key, type, unit, default, range, help, in aligned
 * columns under a heading. List entries are written `bodies[].name`. The caller frees
 * the text; NULL without memory. */
char *mpm_schema_text(void);

/* The same for programs, as JSON: {"format": 1, "keys": [...]}, one object for each key, a group
 * before its children. `key`: as in the table. `shape`: one, pair, points, choice, group or list.
 * `value`: number, expression, drive (an expression or `free`), text, name, law, integer or
 * boolean; null for choices, groups and lists. `geometry`: planar or axisymmetric where the key is
 * for such scenes only, else null. `required`. `unit`: "" for none. `default`: YAML text, null
 * where there is none. `low`, `high`: range of the values, of the number of points for points;
 * null: no limit; `low_open`, `high_open`: the end itself is not allowed. `choices`: names, null
 * where any value of the kind is allowed. `help`. The caller frees the text; NULL without memory.
 */
char *mpm_schema_json(void);

#endif

/* The table behind `mpm schema`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SCHEMA_H
#define MPM_IO_SCHEMA_H

/* Every key of a scene, one line each: key, type, unit, default, range, help, in aligned
 * columns under a heading. List entries are written `bodies[].name`. The caller frees
 * the text; NULL without memory. */
char *mpm_schema_text(void);

#endif

/* A sketch of a scene: bodies by material, conditions, loads, cracks, axis, dimensions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_SKETCH_SVG_H
#define VERIFICATION_REPORT_SKETCH_SVG_H

#include <glib.h>
#include <jansson.h>

/* The sketch (g_free) of a scene with all its defaults, whose parts have numbers; what each is goes
 * to `legend` as a list in HTML. A part that is not understood has neither. */
char *sketch_svg(const json_t *scene, const char *title, GString *legend);

#endif

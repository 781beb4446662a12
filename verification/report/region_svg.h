/* Regions of a scene as outlines.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_REGION_SVG_H
#define VERIFICATION_REPORT_REGION_SVG_H

#include "verification/pages/svg.h"

#include <jansson.h>
#include <stdbool.h>

/* Widens low and high so that all bodies of the scene are between them. */
void region_bounds(const json_t *scene, double low[2], double high[2]);

/* Is r its first coordinate? Then no body is where that is negative. */
bool region_is_radial(const json_t *scene);

/* A clip path "seen": what is to the right of the axis r = 0. */
void region_clip(GString *svg, const struct svg_view *view);

/* The box around a region; false: it has no end or is no region. */
bool region_box(const json_t *region, double low[2], double high[2]);

/* A path along the edges of a region, with those attributes; nothing of `all` and what is no
 * region. */
void region_path(GString *svg, const struct svg_view *view, const json_t *region,
                 const char *attributes);

/* The bodies of a scene at the start as paths of class "before"; thin ones are left out. */
void region_outlines(GString *svg, const struct svg_view *view, const json_t *scene);

#endif

/* Particles as the domains that their deformation gradients make of their first rectangles,
 * coloured by a field, as SVG.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_PICTURE_SVG_H
#define VERIFICATION_REPORT_PICTURE_SVG_H

#include "verification/report/picture_file.h"

#include <glib.h>

/* The last state with axes and a colour bar; g_free. */
char *picture_still_svg(const struct picture_file *file, const char *title,
                        const char *description);

/* Its motion, over and over; a reader who wants less motion sees the last state. g_free; NULL: the
 * run left none. */
char *picture_motion_svg(const struct picture_file *file, const char *title,
                         const char *description);

/* The last state alone, small and without words; g_free. */
char *picture_small_svg(const struct picture_file *file, const char *title);

/* "x / mm" and "y / mm", or "r" and "z"; each g_free. */
void picture_axis_names(const json_t *scene, char *names[2]);

#endif

/* Figures: gnuplot scripts drawn as SVG that follows the reader's light or
 * dark ground.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PAGES_FIGURE_H
#define VERIFICATION_PAGES_FIGURE_H

#include "verification/common/failure.h"

enum figure_state {
    FIGURE_DRAWN,
    FIGURE_WITHOUT_DATA, /* a variant that it needs was not selected, or did not finish */
    FIGURE_FAILED,       /* gnuplot is missing, or the script failed or warned */
};

struct figure_result {
    enum figure_state state;
    char reason[MPM_MESSAGE_SIZE]; /* of anything but DRAWN */
    const char *note;              /* what a reader should know of the script; NULL: nothing */
    int width, height;             /* px, of a picture that is DRAWN */
};

/* Draws the picture <folder>/<output>, an SVG file, dressed, by the gnuplot script at the path
 * `script`; a whole run happens in a temporary folder, by copies of the scripts that
 * figure_script_check() has read, without a shell (mpm_gnuplot_run()). DRAWN or FAILED. */
struct figure_plot {
    const char *script;   /* path */
    const char *style;    /* path, for `load style` */
    const char *axes;     /* commands, for `load axes`; NULL: none */
    const char *settings; /* definitions that the script needs, beside style, axes and output */
    const char *folder, *output, *title, *description;
};
struct figure_result figure_plot(const struct figure_plot *plot);

/* A text between single quotes of gnuplot; g_free. */
char *figure_quoted(const char *text);

/* The SVG as gnuplot wrote it, with black as the text colour, colours for light and dark,
 * a role, a title and a description; g_free. */
char *figure_dress(const char *svg, const char *title, const char *description);

#endif

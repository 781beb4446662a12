/* What the gnuplot script of a figure may do.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PAGES_FIGURE_SCRIPT_H
#define VERIFICATION_PAGES_FIGURE_SCRIPT_H

#include "verification/common/failure.h"

#include <stdbool.h>

/* Reads the whole script, named `name` in messages, before it is run. Allowed are definitions,
 * data blocks, the commands plot, splot, stats, array, if, else, do, `load style`, `load axes`, and
 * set and unset with the options that a figure needs: of them `set output output` alone,
 * `set terminal svg`, and `set table` of a data block. Refused anywhere are backticks, macros (@),
 * the function system and texts that begin with '<', which gnuplot opens as a pipe; these last may
 * be in what is `generated`, where texts are labels. MPM_BAD_INPUT with name and line.
 *
 * A text can be put together while the script runs, which this cannot see: mpm_gnuplot_run() keeps
 * gnuplot from starting programs. */
enum mpm_status figure_script_check(const char *name, const char *text, bool generated,
                                    struct mpm_error *error);

#endif

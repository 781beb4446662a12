/* gnuplot, run so that it can start no other program: for `mpm plot` and the reports.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_GNUPLOT_H
#define MPM_GNUPLOT_H

#include <stdbool.h>

/* Runs the script `script` of `folder` after the commands `settings`. Whether it succeeded; *said
 * are its messages (g_free), NULL if it could not be started; *failure (g_free) is then the reason.
 *
 * The process has `folder` as its home and working folder, no configuration of the user or the
 * machine, no PATH and no SHELL. On Linux (x86_64, aarch64) the system refuses it new processes and
 * sockets, elsewhere a limit of processes does, which does not bind root: so system(), backticks,
 * '!', and files that are pipes fail in gnuplot, whatever a script does. Where the system does not
 * grant this, gnuplot is not run. */
bool mpm_gnuplot_run(const char *folder, const char *settings, const char *script, char **said,
                     char **failure);

#endif

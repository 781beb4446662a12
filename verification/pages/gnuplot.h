/* gnuplot, run so that it can start no other program.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PAGES_GNUPLOT_H
#define VERIFICATION_PAGES_GNUPLOT_H

#include <glib.h>
#include <stdbool.h>

/* Runs the script `script` of `folder` after the commands `settings`. Whether it succeeded; *said
 * are its messages (g_free), NULL with *failure if it could not be started.
 *
 * The process has `folder` as its home and working folder, no configuration of the user or the
 * machine, no PATH and no SHELL. On Linux (x86_64, aarch64) the system refuses it new processes and
 * sockets, elsewhere a limit of processes does, which does not bind root: so system(), backticks,
 * '!', and files that are pipes fail in gnuplot, whatever a script does. Where the system does not
 * grant this, gnuplot is not run. */
bool gnuplot_run(const char *folder, const char *settings, const char *script, char **said,
                 GError **failure);

#endif

/* Signals that ask a run to end: SIGINT, SIGTERM, SIGXCPU.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_CLI_SIGNALS_H
#define MPM_CLI_SIGNALS_H

/* From now on the first one is kept, and a second one ends the process at once; but for SIGXCPU,
 * which the system sends once a second. */
void cli_signals_await(void);

/* The number of the first one, or 0. */
int cli_signals_received(void);

#endif

/* Signals that ask a run to end: SIGINT, SIGTERM, SIGXCPU.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_INTERRUPTION_H
#define VERIFICATION_SUITE_INTERRUPTION_H

#include <signal.h>

enum { INTERRUPTIONS = 3 };
struct interruption {
    struct sigaction before[INTERRUPTIONS]; /* what the process did on them */
};

/* From now on the first of them is noted; a second SIGINT or SIGTERM ends the process at once. */
void interruption_await(struct interruption *interruption);
/* The number of the one that came, or 0. */
int interruption_received(void);
/* Puts back what the process did before. */
void interruption_forget(const struct interruption *interruption);

/* For a child process: the system's own actions. */
void interruption_default(void);

#endif

/* Facts of the machine, for provenance.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_MACHINE_H
#define VERIFICATION_COMMON_MACHINE_H

/* Name of the processor ("unknown" if the system does not report it); g_free. */
char *machine_processor(void);

/* Processors that this process may use, >= 1. */
unsigned machine_processor_count(void);

/* First line of `gnuplot --version`, or "not found"; g_free. */
char *machine_gnuplot(void);

/* Libraries of the solver and of the suite with their versions; g_free. */
char *machine_libraries(void);

#endif

/* Texts of checks and runs, as consoles and reports show them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_RECORDS_CHECK_TEXT_H
#define VERIFICATION_RECORDS_CHECK_TEXT_H

#include "verification/records/records.h"

/* The value of a check: four digits, or as many as tell it from its band where it is red. */
char *text_value(const json_t *check);

/* The band that the check is declared to be in. */
char *text_band(const json_t *check);

/* The verdict of a run in one line. */
char *text_verdict(const struct record_counts *counts);

/* "R1/interior_sd_j [ugimp]" */
char *text_check_name(const json_t *check);

/* The command that runs a variant again, for the shell, with the kernels of that run: the
 * object of kind "run", or NULL. */
char *text_command(const char *name, const char *variant, bool full, const json_t *run);

#endif

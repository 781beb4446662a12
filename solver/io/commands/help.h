/* Help from the tables of commands and options.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_COMMANDS_HELP_H
#define MPM_IO_COMMANDS_HELP_H

#include "mpm_commands.h"

enum { MPM_HELP_WIDTH = 80 };

/* What the reader itself does in each program. */
enum { MPM_HELP_OWN_COUNT = 2 };
struct mpm_help_row {
    const char *name, *operands, *summary;
};
extern const struct mpm_help_row mpm_help_own[MPM_HELP_OWN_COUNT];

/* Commands with their summaries, and the notes. */
void mpm_help_program(const struct mpm_command_line *line);

void mpm_help_own_command(const struct mpm_command_line *line, const struct mpm_help_row *row);

/* Operands, summary, options and description of one command. */
void mpm_help_command(const struct mpm_command_line *line, const struct mpm_command_entry *entry);

#endif

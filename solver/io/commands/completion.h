/* Completion of command lines in shells, from the tables of commands and options.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_COMMANDS_COMPLETION_H
#define MPM_IO_COMMANDS_COMPLETION_H

#include "mpm_commands.h"

/* The shells, as an operand is named: "bash|zsh|fish". */
extern const char mpm_completion_shells[];

/* Prints the script of a shell on line->out; false if it is none of them. */
bool mpm_completion_print(const struct mpm_command_line *line, const char *shell);

#endif

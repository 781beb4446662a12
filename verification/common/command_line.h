/* The command as typed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_COMMAND_LINE_H
#define VERIFICATION_COMMON_COMMAND_LINE_H

/* Quoted for the shell, under the program's own name; g_free. */
char *command_line_typed(const char *program, int argc, char **argv);

#endif

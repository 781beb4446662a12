/* Running a program, with its output and exit status.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_COMMAND_H
#define TESTS_SUPPORT_COMMAND_H

struct test_command {
    int exit_status; /* 128 + signal if a signal ended it */
    char *output;    /* standard output, never NULL */
    char *errors;    /* standard error, never NULL */
};

/* Runs `program` of the build under test (mpm, mpm-verify), or the program at a path
 * with a slash, with the arguments that follow, up to NULL. Standard input is empty. */
struct test_command test_command_run(const char *program, ...) __attribute__((sentinel));
void test_command_free(struct test_command *command);

#endif

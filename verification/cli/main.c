/* mpm-verify: the suite's program.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cli/commands.h"

#include <errno.h>
#include <gsl/gsl_errno.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>

/* A reader that went away and a limit on file sizes are to be seen as errors of the call
 * that writes, not as signals. */
static void ignore_write_signals(void)
{
    const struct sigaction ignore = {.sa_handler = SIG_IGN};
    (void)sigaction(SIGPIPE, &ignore, NULL);
    (void)sigaction(SIGXFSZ, &ignore, NULL);
}

int main(int argc, char **argv)
{
    gsl_set_error_handler_off();
    const struct suite_world world = {stdout, stderr, isatty(STDOUT_FILENO) != 0, programs_all()};
    ignore_write_signals();
    const int status = suite_command(argc, argv, &world);
    if ((fflush(stdout) == 0 && ferror(stdout) == 0) || errno == EPIPE)
        return status;
    (void)fprintf(stderr, "mpm-verify: standard output cannot be written: %s\n", strerror(errno));
    return MPM_ENVIRONMENT_FAILED;
}

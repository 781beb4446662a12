/* mpm-bench: the benchmark program.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/cli/commands.h"

#include "mpm.h"

#include <errno.h>
#include <gsl/gsl_errno.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>

int main(int argc, char **argv)
{
    /* A reader that went away and a limit on file sizes are errors of the call that writes. */
    const struct sigaction ignore = {.sa_handler = SIG_IGN};
    (void)sigaction(SIGPIPE, &ignore, NULL);
    (void)sigaction(SIGXFSZ, &ignore, NULL);
    gsl_set_error_handler_off();
    const struct bench_world world = {stdout, stderr, isatty(STDOUT_FILENO) != 0};
    const int status = bench_command(argc, argv, &world);
    if ((fflush(stdout) == 0 && ferror(stdout) == 0) || errno == EPIPE)
        return status;
    (void)fprintf(stderr, "mpm-bench: standard output cannot be written: %s\n", strerror(errno));
    return MPM_ENVIRONMENT_FAILED;
}

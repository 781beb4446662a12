/* mpm-verify: the suite's program.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/commands.h"

#include <gsl/gsl_errno.h>
#include <unistd.h>

int main(int argc, char **argv)
{
    gsl_set_error_handler_off();
    const struct suite_world world = {stdout, stderr, isatty(STDOUT_FILENO) != 0, programs_all()};
    return suite_command(argc, argv, &world);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/signals.h"

#include <signal.h>
#include <stddef.h>

static const int awaited[] = {SIGINT, SIGTERM, SIGXCPU};
static volatile sig_atomic_t received;

static void receive(int number)
{
    if (received == 0) {
        received = number;
        return;
    }
    if (number == SIGXCPU)
        return;
    (void)signal(number, SIG_DFL);
    (void)raise(number); /* delivered when this function returns */
}

void cli_signals_await(void)
{
    struct sigaction action = {.sa_handler = receive, .sa_flags = SA_RESTART};
    (void)sigemptyset(&action.sa_mask);
    for (size_t k = 0; k < sizeof awaited / sizeof awaited[0]; k++)
        (void)sigaction(awaited[k], &action, NULL);
}

int cli_signals_received(void)
{
    return (int)received;
}

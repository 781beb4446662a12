/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/interruption.h"

#include <stddef.h>

static const int awaited[INTERRUPTIONS] = {SIGINT, SIGTERM, SIGXCPU};
static volatile sig_atomic_t received;

static void receive(int number)
{
    if (received == 0) {
        received = number;
    } else if (number != SIGXCPU) {
        (void)signal(number, SIG_DFL);
        (void)raise(number); /* delivered when this function returns */
    }
}

void interruption_await(struct interruption *interruption)
{
    struct sigaction action = {.sa_handler = receive};
    (void)sigemptyset(&action.sa_mask);
    received = 0;
    for (size_t k = 0; k < INTERRUPTIONS; k++)
        (void)sigaction(awaited[k], &action, &interruption->before[k]);
}

int interruption_received(void)
{
    return (int)received;
}

void interruption_forget(const struct interruption *interruption)
{
    for (size_t k = 0; k < INTERRUPTIONS; k++)
        (void)sigaction(awaited[k], &interruption->before[k], NULL);
}

void interruption_default(void)
{
    for (size_t k = 0; k < INTERRUPTIONS; k++)
        (void)signal(awaited[k], SIG_DFL);
}

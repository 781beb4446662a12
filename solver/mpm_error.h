/* Statuses and messages. Part of the public interface: mpm.h includes it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_ERROR_H
#define MPM_ERROR_H

#include "mpm_api.h"

MPM_API_BEGIN

/* The values are the exit statuses of the command `mpm`. */
enum mpm_status {
    MPM_OK = 0,
    MPM_BAD_INPUT = 2,          /* the scene or an argument is wrong: nothing was written */
    MPM_RUN_FAILED = 3,         /* enum mpm_cause has the causes */
    MPM_ENVIRONMENT_FAILED = 4, /* memory, disk, a file that cannot be written */
    MPM_INTERRUPTED = 128,      /* the caller has ended the run: plus the number of its signal */
};

/* Why a run failed (MPM_RUN_FAILED). The message starts with words of its own for each. */
enum mpm_cause {
    MPM_CAUSE_NONE, /* no failure, or one with another status */
    MPM_CAUSE_ENERGY,
    MPM_CAUSE_WAVES,
    MPM_CAUSE_NOT_FINITE,
    MPM_CAUSE_INVERTED,
    MPM_CAUSE_LEFT_GRID,
    MPM_CAUSE_PASSED_AXIS,
    MPM_CAUSE_OUTRAN_CELL,
    MPM_CAUSE_DOMAIN,
    MPM_CAUSE_LOAD,
    MPM_CAUSE_CONDITION,
    MPM_CAUSE_RIGID,
    MPM_CAUSE_DAMPING,
    MPM_CAUSE_CRACK,
    MPM_CAUSE_J_INTEGRAL,
    MPM_CAUSE_CONTACT,
    MPM_CAUSE_NOT_AT_REST,
    MPM_CAUSE_TEMPERATURE,
    MPM_CAUSE_PLASTIC,
    MPM_CAUSE_STATE,
    MPM_CAUSE_COUNT,
};
/* `name` is the value of "cause" in run.json: "left_grid"; `words` start the message: "left the
 * grid". */
struct mpm_cause_info {
    const char *name, *words, *description;
};
/* The words of a cause. */
const struct mpm_cause_info *mpm_cause_describe(enum mpm_cause cause);

enum { MPM_MESSAGE_SIZE = 1024 };

struct mpm_error {
    enum mpm_status status;
    enum mpm_cause cause;
    int line;                       /* of the file that is at fault; 0 where there is none */
    char message[MPM_MESSAGE_SIZE]; /* one line: what, where, value, what is allowed */
};

MPM_API_END

#endif

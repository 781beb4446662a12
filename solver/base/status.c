/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>

static const struct mpm_cause_info causes[MPM_CAUSE_COUNT] = {
    [MPM_CAUSE_NONE] = {"none", "failed", "no failure of the run"},
    [MPM_CAUSE_ENERGY] = {"energy_grown", "unstable in energy",
                          "total energy far above all that was put in"},
    [MPM_CAUSE_WAVES] = {"waves_grown", "waves too fast",
                         "a wave speed that has taken the time step with it"},
    [MPM_CAUSE_NOT_FINITE] = {"not_finite", "not finite",
                              "a particle's velocity, position or stress, or a sum of them"},
    [MPM_CAUSE_INVERTED] = {"inverted", "inverted", "a particle with det F not above 0"},
    [MPM_CAUSE_LEFT_GRID] = {"left_grid", "left the grid",
                             "a particle, a rigid body, a crack or its surface"},
    [MPM_CAUSE_PASSED_AXIS] = {"passed_axis", "passed the axis", "a particle with r not above 0"},
    [MPM_CAUSE_OUTRAN_CELL] = {"outran_cell", "outran a cell",
                               "a particle that moved more than a cell in one step"},
    [MPM_CAUSE_DOMAIN] = {"domain_too_long", "domain too long",
                          "a particle's domain beyond the ghost rows of the grid"},
    [MPM_CAUSE_LOAD] = {"load_not_finite", "load not finite", "a body force or a traction"},
    [MPM_CAUSE_CONDITION] = {"condition_not_finite", "prescribed value not finite",
                             "of a boundary or a rigid body"},
    [MPM_CAUSE_RIGID] = {"rigid_bodies_disagree", "rigid bodies disagree",
                         "two rigid bodies that give one node different velocities"},
    [MPM_CAUSE_DAMPING] = {"damping_out_of_range", "damping out of range",
                           "a rate of damping that the time step does not allow"},
    [MPM_CAUSE_CRACK] = {"crack", "crack beyond what can be tracked",
                         "a crack that is stretched, grown or near others too far"},
    [MPM_CAUSE_CONTACT] = {"contact", "contact failed",
                           "bodies share more nodes than there is room for"},
    [MPM_CAUSE_J_INTEGRAL] = {"no_j_integral", "J integral without a value",
                              "a contour that left its body or meets another crack"},
    [MPM_CAUSE_NOT_AT_REST] =
        {"not_at_rest", "not at rest",
         "time.end or time.steps reached, or time.rest.patience over, before rest"},
    [MPM_CAUSE_TEMPERATURE] =
        {"temperature_out_of_range", "temperature out of range",
         "a temperature at which a law or heat of deformation has no meaning"},
    [MPM_CAUSE_PLASTIC] = {"no_plastic_return", "no return to yield",
                           "a particle whose stress has no way back to its yield surface"},
    [MPM_CAUSE_STATE] = {"no_state", "beyond the equation of state",
                         "a particle compressed or expanded beyond its equation of state"},
};

const struct mpm_cause_info *mpm_cause_describe(enum mpm_cause cause)
{
    return &causes[cause];
}

/* The text becomes one line. */
__attribute__((format(printf, 4, 0))) static void set(struct mpm_error *error,
                                                      enum mpm_status status, enum mpm_cause cause,
                                                      const char *format, va_list arguments)
{
    if (error == NULL)
        return;
    (void)vsnprintf(error->message, sizeof error->message, format, arguments);
    for (char *c = error->message; *c != '\0'; c++)
        if ((unsigned char)*c < 0x20 || *c == 0x7f)
            *c = '?';
    error->status = status;
    error->cause = cause;
    error->line = 0;
}

enum mpm_status mpm_error_set(struct mpm_error *error, enum mpm_status status, const char *format,
                              ...)
{
    va_list arguments;
    va_start(arguments, format);
    set(error, status, MPM_CAUSE_NONE, format, arguments);
    va_end(arguments);
    return status;
}

enum mpm_status mpm_error_fail(struct mpm_error *error, enum mpm_cause cause, const char *format,
                               ...)
{
    va_list arguments;
    va_start(arguments, format);
    set(error, MPM_RUN_FAILED, cause, format, arguments);
    va_end(arguments);
    return MPM_RUN_FAILED;
}

void mpm_error_locate(struct mpm_error *error, uint64_t step, double time)
{
    if (error == NULL)
        return;
    const struct mpm_error why = *error;
    (void)mpm_error_set(error, why.status, "%s at step %" PRIu64 ", time %g: %s",
                        causes[why.cause].words, step, time, why.message);
    error->cause = why.cause;
}

enum mpm_status mpm_error_memory(struct mpm_error *error, size_t bytes, const char *what)
{
    return mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "out of memory: %zu bytes for %s", bytes,
                         what);
}

/* What a result depends on, as one name: the same inputs give the same name on every machine.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_TASK_KEY_H
#define VERIFICATION_SUITE_TASK_KEY_H

#include "verification/suite/plan.h"

/* SHA-256, in hexadecimal digits, of: the running program's file, its libraries' versions,
 * reference_data, the kernels asked for; case and variant; of a variant that is a method,
 * methods.yaml; and the files of the case's folder with their names, but for what only reports read
 * (README.md, *.gp). keys[i] belongs to plan->jobs[i]; g_strfreev. MPM_ENVIRONMENT_FAILED: a file
 * cannot be read. Cost: reads all these files once. */
enum mpm_status task_keys(const struct catalogue *catalogue, const struct plan *plan,
                          enum mpm_kernels kernels, char ***keys, struct mpm_error *error);

#endif

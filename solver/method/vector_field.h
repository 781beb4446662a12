/* A vector that depends on place and time: two expressions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_VECTOR_FIELD_H
#define MPM_METHOD_VECTOR_FIELD_H

#include "base/status.h"
#include "mpm_expression.h"

struct mpm_vector_field {
    struct mpm_expression *component[2]; /* NULL: free, or no such field */
};

#endif

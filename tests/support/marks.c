/* Whether assertions that hold are marked.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/marks.h"

bool test_marks_wanted = true;

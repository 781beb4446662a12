/* What the band of a check rests on, by name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cases/catalogue.h"

#include <glib.h>
#include <string.h>

static const char *const basis_names[] = {"theory", "round-off", "literature",
                                          "independent calculation", "measured"};

const char *basis_name(enum case_basis basis)
{
    return basis_names[basis];
}

bool basis_find(const char *name, enum case_basis *basis)
{
    for (size_t i = 0; i < G_N_ELEMENTS(basis_names); i++)
        if (strcmp(basis_names[i], name) == 0) {
            *basis = (enum case_basis)i;
            return true;
        }
    return false;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/manufactured.h"
#include "support/marks.h"

#include <string.h>

const char *const test_laws[TEST_LAWS] = {"neo_hookean", "linear_elastic"};

static enum mpm_status open_problem(const char *field, const char *law, enum mpm_geometry geometry,
                                    struct manufactured_problem *problem, struct mpm_error *error)
{
    const struct manufactured_setup setup = {field,        law,       geometry,
                                             TEST_DENSITY, TEST_BULK, TEST_SHEAR};
    return manufactured_open(&setup, problem, error);
}

bool test_problem_at(int index, struct manufactured_problem *problem)
{
    const struct manufactured_field *const field = manufactured_at((size_t)(index % TEST_FIELDS));
    const int law = index / TEST_FIELDS % TEST_LAWS, geometry = index / TEST_FIELDS / TEST_LAWS;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status = open_problem(manufactured_name(field), test_laws[law],
                                                (enum mpm_geometry)geometry, problem, &error);
    ck_assert_msg(status == MPM_OK || strstr(error.message, "fills an annulus") != NULL, "%s",
                  error.message);
    return status == MPM_OK;
}

struct manufactured_problem test_problem(const char *field, const char *law,
                                         enum mpm_geometry geometry)
{
    struct manufactured_problem problem;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status = open_problem(field, law, geometry, &problem, &error);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    return problem;
}

/* One measure of a study: its quantity, how a number is taken from it, and its reference.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_STUDY_MEASURE_H
#define VERIFICATION_PROGRAMS_STUDY_MEASURE_H

#include "mpm_expression.h"
#include "verification/measures/quantities.h"
#include "verification/programs/table_named.h"

/* A formula in the coordinates and time, or a curve over one of them. */
struct study_reference {
    struct mpm_expression *formula; /* NULL: the curve, if there is one */
    struct table_named curve;
    unsigned over; /* 0, 1: of the place; 2: time */
};

/* `text` is a formula, or the path of a file *.csv of two columns: x, y (r, z) or time, rising, and
 * the value. MPM_BAD_INPUT. */
enum mpm_status study_reference_open(const char *text, bool axisymmetric,
                                     struct study_reference *reference, struct mpm_error *error);
void study_reference_close(struct study_reference *reference);
bool study_reference_given(const struct study_reference *reference);
/* NaN where the curve does not reach. */
double study_reference_value(const struct study_reference *reference, const double place[2],
                             double time);

struct study_measure {
    const char *quantity;
    const struct field_quantity *field; /* NULL: a column of history.csv */
    enum take take;
    double at[2]; /* TAKE_AT: a place, or a time */
    struct study_reference reference;
};

/* The particles at t = 0. */
struct study_particles {
    size_t count;
    double *position;
    double *weight; /* volume; 0 of rigid bodies */
};

/* The number, and what the reference is for it: NaN if there is none, or the take is a norm. */
struct study_number {
    double value, reference;
};
struct study_number study_measure_field(const struct study_measure *measure,
                                        const struct study_particles *start,
                                        const struct mpm_simulation *simulation);
/* MPM_BAD_INPUT: history.csv has no such column. */
enum mpm_status study_measure_history(const struct study_measure *measure,
                                      const struct table_named *history,
                                      struct study_number *number, struct mpm_error *error);

#endif

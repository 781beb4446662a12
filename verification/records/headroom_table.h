/* Headroom of every declared check: over its variants, in this run and in those of other builds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_RECORDS_HEADROOM_TABLE_H
#define VERIFICATION_RECORDS_HEADROOM_TABLE_H

#include "verification/common/record.h"
#include "verification/measures/comparison/headroom.h"

#include <glib.h>

/* What is wrong with a check's band or with the reason that is written for it. */
enum headroom_fault {
    HEADROOM_SOUND,
    HEADROOM_UNREASONED, /* flaky or slack, and no reason written */
    HEADROOM_STALE,      /* neither, and a reason is written */
    HEADROOM_MISSING,    /* a build that ran the check has no value of it */
    HEADROOM_OUTSIDE,    /* a build's value is outside the band: no reason is one for that */
    HEADROOM_FAULTS
};

/* "no reason written", ...; "" for a sound one. */
const char *headroom_fault_words(enum headroom_fault fault);

/* A check as declared, with all its variants. Records and names belong to what was gathered from.
 */
struct declared_headroom {
    const json_t *first; /* of its records */
    struct verdict_band band;
    double *least;         /* in each build, this run first; NaN: no value there */
    unsigned nearest;      /* the build of the least of all */
    const json_t *variant; /* and the record; NULL without any value */
    double spread;         /* largest of a variant, over builds */
    const json_t *missing; /* a record without a value, and the build; NULL if none */
    unsigned missing_in;
    enum headroom_fault fault;
};

/* The least over builds; NaN without a value. */
double declared_headroom_least(const struct declared_headroom *declared);

struct headroom_table {
    GArray *checks;       /* struct declared_headroom, in the order of the records */
    const char **names;   /* of the builds: "this run", then those of headroom.json */
    size_t *without;      /* of each build: variants' checks that have no value there */
    size_t *values;       /* and those that have one */
    unsigned build_count; /* at least 1 */
};

/* `builds` is the list of headroom.json, or NULL. A check that a build did not run (it ran a
 * selection) is not missing there; one that it ran and has no finite value of is. Records of one
 * declaration need not follow each other, those of one case do. */
struct headroom_table headroom_table_make(const json_t *checks, const json_t *builds);
void headroom_table_clear(struct headroom_table *table);

/* How many checks have the fault; how many a build (`build_count`: all) judges so. */
size_t headroom_table_faults(const struct headroom_table *table, enum headroom_fault fault);
size_t headroom_table_count(const struct headroom_table *table, unsigned build,
                            enum headroom judged);

/* Of those that all builds together judge so: how many state why they may. */
size_t headroom_table_reasoned(const struct headroom_table *table, enum headroom judged);

#endif

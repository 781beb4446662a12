/* The judge: from what a job left behind to a verdict on one check, and the proof
 * that the check can fail.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_JUDGE_H
#define VERIFICATION_SUITE_JUDGE_H

#include "verification/cases/catalogue.h"

enum job_outcome {
    JOB_RETURNED,  /* code: its exit status */
    JOB_CRASHED,   /* code: the signal */
    JOB_TIMED_OUT, /* killed after its time-out */
    JOB_NOT_RUN,   /* could not be started: rows state why */
};

/* What a job left behind. */
struct job_result {
    enum job_outcome outcome;
    int code;
    double seconds; /* wall clock */
    double timeout;
    char *rows; /* see rows.h */
};

/* The judge's verdict on one check. */
struct check_verdict {
    struct verdict verdict;
    bool has_value; /* a finite value was reported */
    double value;
    uint64_t particle_steps;
    unsigned mutations, mutations_red; /* the proof: tried, and turned red */
};

/* Judges one check by what its job left. */
struct check_verdict judge_check(const struct case_check *check, const struct job_result *result);

/* Judges the check, then proves that it can fail: what the job left is changed in every
 * way of verdict_mutation, and by removing the row, doubling it, cutting the text short, a crash,
 * a non-zero exit and a time-out; each goes through judge_check as the real one does
 * and must turn red. If one does not, the check is an error that names it. */
struct check_verdict judge_check_with_proof(const struct case_check *check,
                                            const struct job_result *result);

#endif

/* What the harnesses share. One harness is one program: libFuzzer calls LLVMFuzzerTestOneInput with
 * inputs that it makes, and a crash, a report of a sanitizer, an input that takes too long or too
 * much memory is a finding.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_FUZZ_FUZZ_H
#define TESTS_FUZZ_FUZZ_H

#include "mpm.h"

/* The names are libFuzzer's. */
/* NOLINTBEGIN(readability-identifier-naming) */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerInitialize(int *argument_count, char ***arguments);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t room, unsigned seed);
size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t room);
/* NOLINTEND(readability-identifier-naming) */

/* A folder of this process, empty and new, in TMPDIR; it goes with the process. */
const char *fuzz_folder(void);

/* Removes all that is in it. */
void fuzz_clear(void);

/* Writes a file into it; returns its path, valid until the next call. */
const char *fuzz_write(const char *name, const void *data, size_t size);

/* Writes several: lines "=== NAME" are followed by the contents of a file each. Only names of
 * `names`, which NULL ends, count; what comes before the first is dropped. What was in the folder
 * before is removed. */
void fuzz_write_all(const uint8_t *data, size_t size, const char *const *names);

/* What holds of every reader: one of the statuses that are allowed, and of a failure a message of
 * one line that has not been cut off. Aborts otherwise. Returns whether the status is MPM_OK. */
bool fuzz_judge(enum mpm_status status, const struct mpm_error *error);

#endif

/* Measuring programs: what a case of the catalogue runs.
 *
 * A measuring program is one file and one line in the table of programs.c. Its
 * `run` is called once for each variant of each case that names it, in a process
 * of its own with a time-out: a crash, a hang or a leak of one variant cannot
 * touch another. It reads its parameters, runs scenes or evaluates functions
 * through mpm.h, and reports numbers by name:
 *
 *     static enum mpm_status run(struct measurement *m, struct mpm_error *error)
 *     {
 *         double speed;
 *         TRY(measurement_number(m, "speed", &speed, error));
 *         struct mpm_scene *scene;
 *         TRY(measurement_scene(m, NULL, 0, &scene, error));
 *         ... advance, measure ...
 *         measurement_report(m, "interior_sd_j", 100 * sd / mean);
 *         measurement_work(m, particles * steps);
 *         return measurement_series(m, "j_over_r", "r/mm J", 2, rows, values, error);
 *     }
 *     const struct measure_program program_compression = {
 *         "compression", "radial compression of a disk against its exact solution", run};
 *
 * A program reports what it found and never judges it: bands live in case.yaml,
 * and a quantity that a case declares but the program did not report is an error
 * of the check. A program fails (anything but MPM_OK) when it cannot measure; a
 * scene that breaks where its breaking is the measurement is a result, not a failure.
 * stdout and stderr of a program go to the log of its variant.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_PROGRAMS_H
#define VERIFICATION_PROGRAMS_PROGRAMS_H

#include "mpm.h"
#include "verification/common/failure.h"

#include <stddef.h>
#include <stdint.h>

struct measurement; /* one run of a program for one variant of a case */

struct measure_program {
    const char *name;    /* as in `program:` of case.yaml */
    const char *summary; /* one line */
    enum mpm_status (*run)(struct measurement *measurement, struct mpm_error *error);
};

/* A table of programs; the suite takes one as an argument, so that tests can bring
 * their own. */
struct program_table {
    const struct measure_program *const *programs;
    size_t count;
};

/* The programs of the catalogue. */
struct program_table programs_all(void);

/* The program of that name, or NULL. */
const struct measure_program *programs_find(struct program_table table, const char *name);

/* ------------------------------------------------ what a program may read */

const char *measurement_case(const struct measurement *measurement);
const char *measurement_variant(const struct measurement *measurement);

/* Threads and kernels that this process should use. */
const struct mpm_simulation_options *measurement_options(const struct measurement *measurement);

/* A folder, which need not be there, that outlives this process: what a program leaves in it is
 * found by the next process with the same inputs, if this one is killed. NULL: there is none. */
const char *measurement_unfinished(const struct measurement *measurement);

/* A parameter as a number or as text: the variant's own, or else the case's. One that
 * is missing or is no finite number is MPM_BAD_INPUT naming case, variant, parameter. */
enum mpm_status measurement_number(const struct measurement *measurement, const char *name,
                                   double *value, struct mpm_error *error);
enum mpm_status measurement_text(const struct measurement *measurement, const char *name,
                                 const char **value, struct mpm_error *error);

/* Several numbers; the first failure ends it. */
struct measurement_parameter {
    const char *name;
    double *value;
};
enum mpm_status measurement_numbers(const struct measurement *measurement,
                                    const struct measurement_parameter *table, size_t count,
                                    struct mpm_error *error);

/* A parameter that is a whole number from `low` to `high`. Any other number is MPM_BAD_INPUT. */
enum mpm_status measurement_count(const struct measurement *measurement, const char *name,
                                  unsigned low, unsigned high, unsigned *value,
                                  struct mpm_error *error);

/* A parameter of 1 to `most` finite numbers parted by blanks, and how many they are. Anything else
 * is MPM_BAD_INPUT. */
enum mpm_status measurement_list(const struct measurement *measurement, const char *name,
                                 size_t most, double *values, size_t *count,
                                 struct mpm_error *error);

/* A parameter that is one of `count` names: its place among them. Any other is MPM_BAD_INPUT. */
enum mpm_status measurement_choice(const struct measurement *measurement, const char *name,
                                   const char *const *names, size_t count, size_t *place,
                                   struct mpm_error *error);

/* The parameter `geometry`: plane_strain, plane_stress or axisymmetric. */
enum mpm_status measurement_geometry(const struct measurement *measurement,
                                     enum mpm_geometry *geometry, struct mpm_error *error);

/* Whether the case or the variant gives that parameter (for optional ones). */
bool measurement_has(const struct measurement *measurement, const char *name);

/* Reads the variant's scene (its parameter `scene` or the case's) with its settings, then
 * `settings` (PATH=VALUE, the last wins). MPM_BAD_INPUT if the case has no scene. The caller frees
 * it. */
enum mpm_status measurement_scene(const struct measurement *measurement,
                                  const char *const *settings, size_t setting_count,
                                  struct mpm_scene **scene, struct mpm_error *error);

/* The same for the scene in `file` of the case's folder: a case of several scenes. */
enum mpm_status measurement_scene_file(const struct measurement *measurement, const char *file,
                                       const char *const *settings, size_t setting_count,
                                       struct mpm_scene **scene, struct mpm_error *error);

/* ----------------------------------------------------- what a program reports */

/* A value, once for each quantity (a second report of the same one makes its checks
 * errors), in the unit of the check. Non-finite values are passed on and turn the
 * check red. */
void measurement_report(struct measurement *measurement, const char *quantity, double value);

/* The quantity could not be determined, with the reason (the run ended before the
 * event, for example): its checks are `inconclusive`, which is red. */
void measurement_inconclusive(struct measurement *measurement, const char *quantity,
                              const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Nothing of this variant can be measured here and that is no fault (for example, an optional
 * tool is not installed), with the reason: all its checks are skipped. */
void measurement_skip(struct measurement *measurement, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Writes data-<variant>-<name>.dat for the case's gnuplot scripts: a comment line
 * `# columns`, then `rows` lines of `column_count` numbers; values[row * column_count
 * + column]. `name` is of letters, digits, '_' and '-'. MPM_ENVIRONMENT_FAILED if it
 * cannot be written, MPM_BAD_INPUT for a bad name. */
enum mpm_status measurement_series(struct measurement *measurement, const char *name,
                                   const char *columns, size_t column_count, size_t rows,
                                   const double *values, struct mpm_error *error);

/* A remark shown on the case's page under the variant. */
void measurement_note(struct measurement *measurement, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Adds to the particle-steps of this variant (shown, never judged). */
void measurement_work(struct measurement *measurement, uint64_t particle_steps);

/* Seconds of processor time, of all threads, that this process has used so far. */
double measurement_processor_seconds(void);

#endif

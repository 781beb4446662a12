/* One scene computed twice, by two sets of kernels side by side, and compared particle
 * by particle after every step.
 *
 * A difference is given as a fraction of its field's scale, the largest component over all
 * particles, and at least:
 *
 *   position, deformation gradient, temperature
 *              no more than that: coordinates, and 1 or nearly; temperatures
 *   stress     K + 4/3 G of the stiffest material: stress is a function of F, and a rounding
 *              error e of F = 1 is e (K + 4/3 G) of stress, however small the strain
 *   velocity   c, the speed of the fastest wave: such a stress accelerates by up to Courant
 *              number * c e in a step, however slow the bodies are
 *
 * Of slow bodies of little strain (c is 200 to 700 times their speed in the catalogue) that is
 * far from the largest value itself: kernel_difference.of_largest states how far.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_KERNEL_PAIR_H
#define TESTS_SUPPORT_KERNEL_PAIR_H

#include "mpm.h"

/* The set that is held against the reference kernels. */
#define KERNEL_PAIR_OTHER MPM_KERNELS_FAST

/* What both may differ by, as a fraction of a field's scale. Sums in another order and the same
 * functions by other formulas differ by a few units in the last place (1e-16) a step; over
 * this many steps, and over whole runs that do not amplify round-off, that stays below. */
static const double KERNEL_PAIR_BOUND = 1e-13;
enum { KERNEL_PAIR_STEPS = 50, KERNEL_PAIR_FIELDS = 5 };

/* MPM_TEST_LONG is set (`make test-kernels`): whole runs and all combinations, printed. */
bool kernel_pair_is_long(void);

extern const enum mpm_field kernel_pair_fields[KERNEL_PAIR_FIELDS];

/* The largest difference found in a field and where it was. */
struct kernel_difference {
    double part;       /* of the scale */
    double of_largest; /* the same over the largest value at that moment */
    uint64_t step;
    size_t particle, component;
    double values[2];
};

/* What one side of a pair computes with. */
struct kernel_side {
    const char *const *settings; /* of the scene, to NULL; NULL: none */
    struct mpm_simulation_options options;
};

struct kernel_pair {
    struct mpm_scene *scene[2];
    struct mpm_simulation *simulation[2];
    struct mpm_error error[2]; /* why they stopped, if they did */
    double *values[2];
    double floors[KERNEL_PAIR_FIELDS]; /* of the scales */
    double time_difference;            /* largest, over the time */
    bool same_bits;                    /* of all fields and of the time, at every comparison */
    struct kernel_difference worst[KERNEL_PAIR_FIELDS];
};

/* Reads the scene and creates both simulations. On failure the pair is empty and the error
 * states why; MPM_BAD_INPUT: also where kernels refuse the scene. */
enum mpm_status kernel_pair_open(const char *path, const struct kernel_side sides[2],
                                 struct kernel_pair *pair, struct mpm_error *error);

/* The same of a scene's text; the test fails, with the message, where there would be an error. */
struct kernel_pair kernel_pair_open_text(const char *text, const struct kernel_side sides[2]);

/* A pair of one set of kernels (KERNEL_PAIR_OTHER): the scene, and the same with a rounding
 * error of the wave speed in the initial velocity of each particle. How far the two get apart
 * is in no code's hands. */
enum mpm_status kernel_pair_open_noisy(const char *path, const char *const *settings,
                                       struct kernel_pair *pair, struct mpm_error *error);

void kernel_pair_close(struct kernel_pair *pair);

/* Takes one step with each and compares. False: the end of the scene or of either run; both
 * ended alike if the steps and messages of `simulation` and `error` are the same. */
bool kernel_pair_step(struct kernel_pair *pair);

/* Same outcome so far: both failed with the same words at the same step, or neither did. */
bool kernel_pair_ended_alike(const struct kernel_pair *pair);

/* The largest difference of all fields, and of the time. */
double kernel_pair_worst(const struct kernel_pair *pair);

/* Takes `steps` steps; the test fails where one does, or where both differ by more than
 * KERNEL_PAIR_BOUND after them. */
void kernel_pair_assert_alike(struct kernel_pair *pair, int steps);

/* The test fails where external works differ by more than velocities within KERNEL_PAIR_BOUND of
 * `wave_speed` make of forces up to `force`, or are too small to tell. */
void kernel_pair_assert_same_work(const struct kernel_pair *pair, double force, double wave_speed);

/* All of it in one line; g_free. */
char *kernel_pair_text(const struct kernel_pair *pair);

#endif

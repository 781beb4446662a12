/* Cohesive laws: the traction between the surfaces of a crack. A law is one file and one line of
 * the list below.
 *
 * Normal and tangential opening count alike: with the effective opening
 *     lambda = sqrt(<delta_n>^2 + delta_s^2),  <x> = x for x > 0, else 0,
 * the traction is T(lambda)/lambda (<delta_n> n + delta_s s), along the opening itself unless
 * surfaces overlap: then contact has the normal part. One function T serves both modes, so that the
 * work of complete failure is the toughness whatever the way there, and one number, the largest
 * lambda so far, is all that a point has to remember. Laws that are not coupled would need two
 * toughnesses and a criterion for both; and a traction that is not along the opening turns the
 * crack.
 *
 * Up to the opening `onset` T = stiffness * lambda, which reaches the strength there; from then on
 * the law's own T falls. Below the largest opening so far T goes straight to the origin, and back.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_COHESIVE_H
#define MPM_MODEL_COHESIVE_H

#include <stdbool.h>

struct mpm_cohesive_law;

/* A law with its constants. */
struct mpm_cohesive {
    const struct mpm_cohesive_law *law; /* NULL: the surfaces are free */
    double strength;                    /* largest traction, M/LT^2 */
    double toughness;                   /* G_c, work per area, M/T^2 */
    double stiffness;                   /* M/(L^2 T^2) */
    double knee_opening, knee_traction; /* of laws that have a knee; else 0 */
    double onset;                       /* strength / stiffness, L */
    double length; /* opening at which nothing is left; exponential: at which it falls by e */
};

struct mpm_cohesive_law {
    const char *name;
    /* The work per area from onset to the knee, from where on the length of T follows from the
     * toughness; NULL: it has no knee, and does so from onset on. With onset set. */
    double (*work_to_knee)(const struct mpm_cohesive *cohesive);
    double (*length)(const struct mpm_cohesive *cohesive);
    /* T at an opening beyond onset, and its integral from onset to there. */
    double (*traction)(const struct mpm_cohesive *cohesive, double opening);
    double (*work)(const struct mpm_cohesive *cohesive, double opening);
};

/* One line a law: `const struct mpm_cohesive_law mpm_cohesive_<name>` in cohesive_<name>.c. */
#define MPM_COHESIVE_LAWS(LAW)                                                                     \
    LAW(MPM_COHESIVE_LINEAR, linear)                                                               \
    LAW(MPM_COHESIVE_TRILINEAR, trilinear)                                                         \
    LAW(MPM_COHESIVE_EXPONENTIAL, exponential)

#define MPM_DECLARE_COHESIVE(kind, name) extern const struct mpm_cohesive_law mpm_cohesive_##name;
MPM_COHESIVE_LAWS(MPM_DECLARE_COHESIVE)
#undef MPM_DECLARE_COHESIVE

#define MPM_NAME_COHESIVE(kind, name) kind,
enum mpm_cohesive_kind { MPM_COHESIVE_LAWS(MPM_NAME_COHESIVE) MPM_COHESIVE_COUNT };
#undef MPM_NAME_COHESIVE

const struct mpm_cohesive_law *mpm_cohesive_law(enum mpm_cohesive_kind kind);

/* Sets onset and length. False if the toughness is not above *least, the work that the other
 * constants ask for alone. */
bool mpm_cohesive_settle(struct mpm_cohesive *cohesive, double *least);

/* T where the largest opening so far is this one, and its integral from 0 to there: the work per
 * area of getting there. */
double mpm_cohesive_envelope(const struct mpm_cohesive *cohesive, double opening);
double mpm_cohesive_work(const struct mpm_cohesive *cohesive, double opening);

/* T/lambda for openings lambda up to `largest`, the largest so far. */
double mpm_cohesive_secant(const struct mpm_cohesive *cohesive, double largest);

#endif

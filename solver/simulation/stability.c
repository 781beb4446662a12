/* Up to which Courant number a method is known to be stable.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/transfers.h"
#include "simulation/interface_limit.h"
#include "simulation/simulation.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What a method has beyond shape functions and order. */
enum feature {
    PLAIN, /* FLIP, velocity form, positions by grid velocities, two terms of the series for dF */
    FLIP_99,
    PIC,
    XPIC_2,
    XPIC_5,
    FMPM_2,
    FMPM_4,
    APIC,
    MOMENTUM,
    MIDPOINT,
    ONE_TERM,
    FEATURE_COUNT
};

/* Case G1 of the suite, which holds its measurements against this table: the least of bar, block
 * and spin in small motion, and at large amplitude, each by bisection to 2 %. */
static const struct row {
    enum mpm_shape shape;
    enum mpm_stress_update order;
    enum feature feature;
    double small, large;
} rows[] = {
    {MPM_CLASSIC, MPM_USL, PLAIN, 0.748, 0.000},
    {MPM_CLASSIC, MPM_MUSL, PLAIN, 1.668, 0.687},
    {MPM_CLASSIC, MPM_USF, PLAIN, 1.668, 0.192},
    {MPM_CLASSIC, MPM_USAVG, PLAIN, 1.668, 1.186},
    {MPM_CLASSIC, MPM_USAVG_ONCE, PLAIN, 1.000, 0.000},
    {MPM_UGIMP, MPM_USL, PLAIN, 0.567, 0.823},
    {MPM_UGIMP, MPM_MUSL, PLAIN, 1.668, 1.173},
    {MPM_UGIMP, MPM_USF, PLAIN, 1.668, 0.480},
    {MPM_UGIMP, MPM_USAVG, PLAIN, 1.668, 1.448},
    {MPM_UGIMP, MPM_USAVG_ONCE, PLAIN, 0.787, 1.121},
    {MPM_CPDI, MPM_USL, PLAIN, 0.761, 0.933},
    {MPM_CPDI, MPM_MUSL, PLAIN, 1.692, 1.186},
    {MPM_CPDI, MPM_USF, PLAIN, 1.692, 0.411},
    {MPM_CPDI, MPM_USAVG, PLAIN, 1.692, 1.023},
    {MPM_CPDI, MPM_USAVG_ONCE, PLAIN, 1.000, 1.223},
    {MPM_BSPLINE2, MPM_USL, PLAIN, 0.834, 0.959},
    {MPM_BSPLINE2, MPM_MUSL, PLAIN, 2.115, 1.497},
    {MPM_BSPLINE2, MPM_USF, PLAIN, 2.115, 0.453},
    {MPM_BSPLINE2, MPM_USAVG, PLAIN, 2.115, 1.891},
    {MPM_BSPLINE2, MPM_USAVG_ONCE, PLAIN, 1.134, 1.321},
    {MPM_BSPLINE3, MPM_USL, PLAIN, 1.047, 1.121},
    {MPM_BSPLINE3, MPM_MUSL, PLAIN, 2.364, 1.574},
    {MPM_BSPLINE3, MPM_USF, PLAIN, 2.364, 0.535},
    {MPM_BSPLINE3, MPM_USAVG, PLAIN, 2.364, 1.574},
    {MPM_BSPLINE3, MPM_USAVG_ONCE, PLAIN, 1.400, 1.497},
    {MPM_UGIMP, MPM_MUSL, PIC, 1.448, 1.716},
    {MPM_UGIMP, MPM_USAVG, PIC, 1.448, 1.692},
    {MPM_CPDI, MPM_USAVG, PIC, 1.448, 1.740},
    {MPM_UGIMP, MPM_MUSL, XPIC_2, 1.547, 1.574},
    {MPM_UGIMP, MPM_USAVG, XPIC_2, 1.547, 1.668},
    {MPM_CPDI, MPM_USAVG, XPIC_2, 1.547, 1.716},
    {MPM_UGIMP, MPM_MUSL, XPIC_5, 1.668, 1.173},
    {MPM_UGIMP, MPM_USAVG, XPIC_5, 1.668, 1.668},
    {MPM_UGIMP, MPM_MUSL, FMPM_2, 1.223, 0.624},
    {MPM_UGIMP, MPM_USAVG, FMPM_2, 1.223, 1.424},
    {MPM_CPDI, MPM_USAVG, FMPM_2, 1.223, 0.811},
    {MPM_UGIMP, MPM_MUSL, FMPM_4, 1.095, 0.285},
    {MPM_UGIMP, MPM_USAVG, FMPM_4, 1.095, 0.480},
    {MPM_UGIMP, MPM_MUSL, APIC, 1.000, 0.712},
    {MPM_UGIMP, MPM_USAVG, APIC, 1.000, 1.059},
    {MPM_CPDI, MPM_USAVG, APIC, 1.000, 1.200},
    {MPM_BSPLINE2, MPM_USAVG, APIC, 1.271, 1.296},
    {MPM_UGIMP, MPM_MUSL, MOMENTUM, 1.574, 0.141},
    {MPM_UGIMP, MPM_USAVG, MOMENTUM, 1.574, 0.178},
    {MPM_UGIMP, MPM_MUSL, MIDPOINT, 1.668, 0.512},
    {MPM_UGIMP, MPM_USAVG, MIDPOINT, 1.668, 1.692},
    {MPM_CPDI, MPM_MUSL, MIDPOINT, 1.692, 0.724},
    {MPM_UGIMP, MPM_MUSL, ONE_TERM, 1.668, 1.200},
    {MPM_UGIMP, MPM_USAVG, ONE_TERM, 1.668, 1.011},
    {MPM_CPDI, MPM_MUSL, ONE_TERM, 1.692, 1.095},
    {MPM_CPDI, MPM_USAVG, ONE_TERM, 1.692, 0.712},
    {MPM_UGIMP, MPM_MUSL, FLIP_99, 1.668, 1.271},
    {MPM_UGIMP, MPM_USAVG, FLIP_99, 1.668, 1.472},
    {MPM_CPDI, MPM_MUSL, FLIP_99, 1.692, 1.223},
    {MPM_CPDI, MPM_USAVG, FLIP_99, 1.692, 1.108},
};
enum { ROWS = sizeof rows / sizeof rows[0] };

/* The features that represent a scene's choices, as bits. */
struct features {
    unsigned bits;
    bool exact; /* the choice itself has been measured, not only its neighbours */
};

static void add(struct features *features, enum feature feature)
{
    features->bits |= 1u << feature;
}

/* What has been measured of transfers: with two orders, `low` and `high`, or one, and then both are
 * the same. Of a transfer without a row here nothing is known. */
static const struct {
    int low, high;
    enum feature at_low, at_high;
} measured_orders[MPM_TRANSFER_COUNT] = {
    [MPM_TRANSFER_PIC] = {1, 1, PIC, PIC},
    [MPM_TRANSFER_XPIC] = {2, 5, XPIC_2, XPIC_5},
    [MPM_TRANSFER_FMPM] = {2, 4, FMPM_2, FMPM_4},
    [MPM_TRANSFER_APIC] = {1, 1, APIC, APIC},
};

/* Orders that have not been measured lie beside these two or between them. */
static void add_order(struct features *features, enum mpm_transfer_kind kind, int order)
{
    const int low = measured_orders[kind].low, high = measured_orders[kind].high;
    if (low > 0 && order <= high && (order < high || low == high))
        add(features, order < low ? PIC : measured_orders[kind].at_low); /* order 1 is PIC */
    if (low > 0 && order > low)
        add(features, measured_orders[kind].at_high);
    features->exact = low > 0 && (order == 1 || order == low || order == high);
}

static void add_fraction(struct features *features, double fraction)
{
    if (fraction < 1.0)
        add(features, FLIP_99);
    if (fraction < 0.99)
        add(features, PIC);
    features->exact = fraction >= 0.99;
}

static struct features features_of(const struct mpm_scene *scene)
{
    struct features features = {.bits = 0, .exact = true};
    if (mpm_transfer_of(scene->transfer)->fraction)
        add_fraction(&features, scene->flip_fraction);
    else
        add_order(&features, scene->transfer, scene->transfer_order);
    if (scene->form == MPM_FORM_MOMENTUM)
        add(&features, MOMENTUM);
    if (scene->position_update == MPM_MIDPOINT)
        add(&features, MIDPOINT);
    if (scene->deformation_terms == 1)
        add(&features, ONE_TERM);
    return features;
}

static void take_less(struct mpm_stability *stability, const struct row *row)
{
    stability->small = fmin(stability->small, row->small);
    stability->large = fmin(stability->large, row->large);
}

/* The row of that method, or NULL. */
static const struct row *find(enum mpm_shape shape, enum mpm_stress_update order,
                              enum feature feature)
{
    for (size_t k = 0; k < ROWS; k++)
        if (rows[k].shape == shape && rows[k].order == order && rows[k].feature == feature)
            return &rows[k];
    return NULL;
}

struct mpm_stability mpm_scene_stability(const struct mpm_scene *scene)
{
    struct mpm_stability found = {.small = HUGE_VAL, .large = HUGE_VAL};
    const struct features features = features_of(scene);
    enum feature only = PLAIN;
    int count = 0;
    for (int f = 0; f < FEATURE_COUNT; f++)
        if (features.bits >> f & 1u) {
            only = (enum feature)f;
            count++;
        }
    const struct row *const row = find(scene->shape, scene->stress_update, only);
    if (row != NULL && count <= 1 && features.exact) {
        take_less(&found, row);
        found.measured = true;
        return found;
    }
    const struct row *const plain = find(scene->shape, scene->stress_update, PLAIN);
    for (size_t k = 0; k < ROWS; k++) {
        const bool has_shape = rows[k].shape == scene->shape && rows[k].feature == PLAIN;
        const bool has_order = rows[k].order == scene->stress_update && rows[k].feature == PLAIN;
        const bool has_both = plain != NULL ? &rows[k] == plain : has_shape || has_order;
        if (has_both || (rows[k].feature != PLAIN && features.bits >> rows[k].feature & 1u))
            take_less(&found, &rows[k]);
    }
    return found;
}

/* The least Courant number tried. A limit of 0 means that it was too large; of those below, nothing
 * is known. */
static const double LEAST_TRIED = 0.1;

/* What is known of the Courant number. */
static void describe_limit(double courant, double limit, char *text, size_t size)
{
    if (limit > 0.0)
        (void)snprintf(text, size, "Courant number %.3g is above the largest one, %.3g, at which",
                       courant, limit);
    else
        (void)snprintf(text, size, "Courant number %.3g: none from %g on has been found at which",
                       courant, LEAST_TRIED);
}

/* Adds what is said of a pair, with a number in it. */
static void add_of_pair(struct mpm_simulation *simulation, size_t pair, const char *before,
                        double number, const char *after)
{
    const size_t length = strlen(simulation->advice);
    (void)snprintf(simulation->advice + length, sizeof simulation->advice - length,
                   "%s%s: %s%.3g%s", length > 0 ? "; " : "",
                   simulation->scene->contact.pairs[pair].key, before, number, after);
}

static void advise_of_interfaces(struct mpm_simulation *simulation)
{
    size_t pair = 0;
    const double kappa = mpm_interface_kappa(simulation, &pair);
    if (kappa > 1.0)
        add_of_pair(simulation, pair, "an interface ", kappa,
                    " times as stiff as an explicit step follows: it is integrated implicitly, and "
                    "dissipates");
    const double ratio = mpm_interface_unevenness(simulation->scene, &pair);
    if (ratio > MPM_UNEVEN_MAX)
        add_of_pair(simulation, pair, "stiffnesses of an interface differ by a factor of ", ratio,
                    ": its energy grows where bodies turn (case C13), but with normal: logistic");
}

static void advise_of_courant(struct mpm_simulation *simulation)
{
    const struct mpm_stability stability = mpm_scene_stability(simulation->scene);
    const double courant = mpm_time_step_courant(simulation);
    const bool is_small = courant > fmax(stability.small, LEAST_TRIED);
    char limit[80];
    if (!is_small && !(courant > fmax(stability.large, LEAST_TRIED)))
        return;
    describe_limit(courant, is_small ? stability.small : stability.large, limit, sizeof limit);
    (void)snprintf(
        simulation->advice, sizeof simulation->advice,
        "%s %s kept %s bounded (case G1): %s; take a smaller time.courant or time.step, or another "
        "method",
        limit, stability.measured ? "this method" : "a method with one of the choices of this one",
        is_small ? "small motions" : "motions at 0.3 of the wave speed",
        is_small ? "the run may become unstable" : "large strains may feed its energy");
}

void mpm_stability_advise(struct mpm_simulation *simulation)
{
    simulation->advice[0] = '\0';
    if (simulation->scene->at_rest)
        return;
    advise_of_courant(simulation);
    advise_of_interfaces(simulation);
}

const char *mpm_simulation_advice(const struct mpm_simulation *simulation)
{
    return simulation->advice;
}

/* D7: a cohesive crack is torn, and what that took is held against toughness times area.
 *
 * One grip of the scene moves at the velocity that the parameter `speed` gives (of what carries the
 * load; with two grips that move apart, of both together), in time by `ramp`: speed t/ramp,
 * from `ramp` on the speed. All that the program knows comes out of the history: the force on the
 * grip is the change of external work over its way. Two figures for the work of the tractions:
 *
 *     balance   external work - kinetic - strain energy - what damping took
 *     force     the integral of the force over the opening (uniform openings only)
 *
 * over toughness times `area`, the area that is torn. Where the opening is uniform (`uniform: 1`),
 * force over area is compared with the law, which is written out here once more.
 *
 * A crack that is not across the pull but `tilt` degrees from it, counter clockwise, opens along
 * the pull by its normal opening over cos(tilt), and slides by tan(tilt) of the normal opening, if
 * both halves move as rigid bodies: its last point reports the latter.
 *
 * With `arm` (a double cantilever beam), the area is not given but what by the ledger has been
 * torn, and the load is compared with linear fracture mechanics of two beams of height `arm` from
 * the displacement `from` on: P^4 = (toughness E' b^2 h^3/12)^3 (8/(E' b h^3 Delta))^2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/fields.h"
#include "verification/programs/follow.h"

#include <math.h>
#include <string.h>

enum { COLUMNS = 5 }; /* displacement, force, opening, law at the opening, work over toughness */

struct law {
    size_t kind; /* place in law_names */
    double strength, toughness, stiffness, knee_opening, knee_traction;
};
static const char *const law_names[] = {"linear", "trilinear", "exponential"};

struct study {
    struct law law;
    double area, speed, ramp, interval, uniform;
    double arm, modulus, from;
    double tilt;    /* radians */
    size_t opening; /* the quantity: mean normal opening of the crack */
    double last[2]; /* normal opening and sliding of its last point, at the end */
    struct mpm_ledger before, now;
    double opening_before, opening_now, displacement_before;
    double force_work, largest_opening;
    double curve;       /* largest difference of force over area and law */
    double load, loads; /* mean ratio to fracture mechanics, and how many */
    struct follow_rows rows;
};

/* ---------------------------------------------------------------------- law */

static double softening(const struct law *law, double opening)
{
    const double onset = law->strength / law->stiffness;
    const double rise = 0.5 * law->strength * onset;
    if (law->kind == 0) {
        const double end = 2.0 * law->toughness / law->strength;
        return fmax(law->strength * (end - opening) / (end - onset), 0.0);
    }
    if (law->kind == 2)
        return law->strength * exp(-(opening - onset) * law->strength / (law->toughness - rise));
    const double first = 0.5 * (law->strength + law->knee_traction) * (law->knee_opening - onset);
    const double end =
        law->knee_opening + 2.0 * (law->toughness - rise - first) / law->knee_traction;
    if (opening < law->knee_opening)
        return law->strength + (law->knee_traction - law->strength) * (opening - onset) /
                                   (law->knee_opening - onset);
    return fmax(law->knee_traction * (end - opening) / (end - law->knee_opening), 0.0);
}

/* With the largest opening so far: straight to the origin from there. */
static double traction(const struct law *law, double opening, double largest)
{
    const double onset = law->strength / law->stiffness;
    if (largest <= onset)
        return law->stiffness * opening;
    return softening(law, largest) * opening / largest;
}

/* ------------------------------------------------------------------ looking */

static double displacement_at(const struct study *study, double time)
{
    if (time < study->ramp)
        return 0.5 * study->speed * time * time / study->ramp;
    return study->speed * (time - 0.5 * study->ramp);
}

static double theory_load(const struct study *study, double displacement)
{
    const double h3 = study->arm * study->arm * study->arm, e = study->modulus;
    return pow(pow(study->law.toughness * e * h3 / 12.0, 3.0) *
                   pow(8.0 / (e * h3 * displacement), 2.0),
               0.25);
}

/* Force and opening are those of the middle between two samples. */
static void look(struct study *study, struct mpm_simulation *simulation)
{
    mpm_simulation_ledger(simulation, &study->now);
    const double displacement = displacement_at(study, study->now.time);
    const double way = displacement - study->displacement_before;
    study->opening_now =
        mpm_simulation_crack_quantity(simulation, study->opening) / cos(study->tilt);
    if (way > 0.0) {
        const double force = (study->now.external_work - study->before.external_work) / way;
        const double opening = 0.5 * (study->opening_now + study->opening_before);
        study->largest_opening = field_larger(study->largest_opening, opening);
        const double law = traction(&study->law, opening, study->largest_opening);
        const double load = theory_load(study, displacement);
        study->force_work += force * (study->opening_now - study->opening_before);
        if (study->uniform > 0.0)
            study->curve = field_larger(study->curve, fabs(force / study->area - law));
        if (study->arm > 0.0 && displacement >= study->from) {
            study->load += force / load;
            study->loads += 1.0;
        }
        const double work = study->now.cohesive_dissipated + study->now.cohesive_stored;
        const double row[COLUMNS] = {displacement, force, opening, study->arm > 0.0 ? load : law,
                                     work / study->law.toughness};
        follow_rows_add(&study->rows, row);
    }
    study->before = study->now;
    study->opening_before = study->opening_now;
    study->displacement_before = displacement;
}

static void report(const struct study *study, struct measurement *m, bool finished)
{
    const struct mpm_ledger *const l = &study->now;
    const double dissipated = l->cohesive_dissipated, work = dissipated + l->cohesive_stored;
    const double balance =
        l->external_work - l->kinetic_energy - l->strain_energy - l->damping_dissipation;
    measurement_report(m, "finished", finished ? 1.0 : 0.0);
    measurement_report(m, "balance_over_law", balance / work);
    if (study->area > 0.0) {
        const double full = study->law.toughness * study->area;
        measurement_report(m, "balance_work", balance / full);
        if (study->uniform > 0.0) {
            measurement_report(m, "force_work", study->force_work / full);
            measurement_report(m, "curve", study->curve / study->law.strength);
        }
    }
    if (study->tilt != 0.0)
        measurement_report(m, "sliding", study->last[1] / (study->last[0] * tan(study->tilt)));
    if (study->arm > 0.0) {
        measurement_report(m, "torn", dissipated / study->law.toughness);
        measurement_report(m, "load_over_theory", study->load / study->loads);
    }
}

/* ------------------------------------------------------------------ running */

/* The place of a quantity of the scene's first crack. */
static enum mpm_status find_quantity(const struct mpm_scene *scene, const char *name, size_t *place,
                                     struct mpm_error *error)
{
    const size_t count = mpm_scene_crack_quantity_count(scene);
    for (*place = 0; *place < count; ++*place)
        if (strcmp(mpm_scene_crack_quantity(scene, *place).name, name) == 0)
            return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT, "the scene's first crack is not cohesive: no %s",
                       name);
}

static enum mpm_status look_at_last(const struct mpm_scene *scene,
                                    const struct mpm_simulation *simulation, double last[2],
                                    struct mpm_error *error)
{
    static const char *const names[] = {"crack_0_opening_last", "crack_0_sliding_last"};
    for (int k = 0; k < 2; k++) {
        size_t place;
        TRY(find_quantity(scene, names[k], &place, error));
        last[k] = mpm_simulation_crack_quantity(simulation, place);
    }
    return MPM_OK;
}

static enum mpm_status follow(void *context, struct measurement *m, const struct mpm_scene *scene,
                              struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    const double end = mpm_scene_end_time(scene);
    bool alive = true;
    TRY(find_quantity(scene, "crack_0_opening_mean", &study->opening, error));
    mpm_simulation_ledger(simulation, &study->before);
    study->rows.columns = COLUMNS;
    for (size_t k = 1; alive && study->now.time < end; k++) {
        TRY(follow_to(m, simulation, fmin(study->interval * (double)k, end), &alive, error));
        if (alive)
            look(study, simulation);
    }
    TRY(look_at_last(scene, simulation, study->last, error));
    report(study, m, alive);
    follow_count_work(m, simulation);
    TRY(follow_rows_check(&study->rows, error));
    return measurement_series(m, "crack", "displacement force opening law work", COLUMNS,
                              study->rows.count, study->rows.values, error);
}

static enum mpm_status read_tilt(const struct measurement *m, double *tilt, struct mpm_error *error)
{
    double degrees = 0.0;
    if (measurement_has(m, "tilt"))
        TRY(measurement_number(m, "tilt", &degrees, error));
    *tilt = degrees * acos(-1.0) / 180.0;
    return MPM_OK;
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct study study = {0};
    const struct measurement_parameter table[] = {
        {"strength", &study.law.strength},
        {"toughness", &study.law.toughness},
        {"stiffness", &study.law.stiffness},
        {"knee_opening", &study.law.knee_opening},
        {"knee_traction", &study.law.knee_traction},
        {"area", &study.area},
        {"speed", &study.speed},
        {"ramp", &study.ramp},
        {"interval", &study.interval},
        {"uniform", &study.uniform},
        {"arm", &study.arm},
        {"modulus", &study.modulus},
        {"from", &study.from},
    };
    TRY(measurement_numbers(m, table, sizeof table / sizeof *table, error));
    TRY(read_tilt(m, &study.tilt, error));
    TRY(measurement_choice(m, "law", law_names, sizeof law_names / sizeof *law_names,
                           &study.law.kind, error));
    const enum mpm_status status = follow_scene(m, NULL, 0, follow, &study, error);
    follow_rows_free(&study.rows);
    return status;
}

const struct measure_program program_cohesive = {
    .name = "cohesive",
    .summary = "a cohesive crack that is torn: the work that it takes",
    .run = run,
};

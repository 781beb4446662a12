/* C14: two bars in one line that adhere to each other; the end of the second is pulled by a
 * traction that grows at a rate q from t = 0.
 *
 * The wave of tension q (t - x/c) arrives at the contact, a length L from the pulled end, at L/c.
 * Bars of one material and adhesion that is strong enough let it pass. It reaches the strength s at
 *     t* = L/c + s/q,
 * where contact ends for good: the second bar's face is free and runs ahead. Until then the first
 * bar has been given the momentum A s^2/(2 q); up to a time t < t*, A q (t - L/c)^2/2.
 *
 * Parameters: length (L), speed (c), rate (q), strength (s), area (A); x points from the first bar
 * to the second. The force of contact is sampled at every step. Reports
 *   strength   % of s A: the largest tension
 *   parts      % of t*, or of the scene's end if that is earlier: time of the last tension of more
 *              than s A/4
 *   impulse    % of the momentum of that time
 * and finished. Draws `force`: time, tension over s A, the exact one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/contact/contact_history.h"
#include "verification/programs/follow.h"

#include <math.h>

enum { TIME, FORCE, EXACT, COLUMNS };

struct parameters {
    double length, speed, rate, strength, area;
};

struct study {
    struct parameters p;
    size_t force; /* quantity of the history: x, on the first bar */
    double largest, last, impulse;
    struct follow_rows rows;
};

static enum mpm_status read_parameters(const struct measurement *m, struct parameters *p,
                                       struct mpm_error *error)
{
    const struct measurement_parameter table[] = {
        {"length", &p->length},     {"speed", &p->speed}, {"rate", &p->rate},
        {"strength", &p->strength}, {"area", &p->area},
    };
    return measurement_numbers(m, table, sizeof table / sizeof *table, error);
}

static double parting_time(const struct parameters *p)
{
    return p->length / p->speed + p->strength / p->rate;
}

static double exact_tension(const struct parameters *p, double time)
{
    return time > parting_time(p) ? 0.0 : p->rate * fmax(time - p->length / p->speed, 0.0);
}

/* Of the step that has been taken, from `before` to now. */
static void add_force(struct study *study, const struct mpm_simulation *simulation, double before)
{
    const struct parameters *const p = &study->p;
    const double now = mpm_simulation_time(simulation), full = p->strength * p->area;
    const double force = mpm_simulation_contact_quantity(simulation, study->force) / full;
    study->impulse += force * full * (now - before);
    study->largest = fmax(study->largest, force);
    if (force > 0.25)
        study->last = now;
    follow_rows_add(
        &study->rows,
        (const double[COLUMNS]){[TIME] = now,
                                [FORCE] = force,
                                [EXACT] = exact_tension(p, 0.5 * (before + now)) / p->strength});
}

static enum mpm_status report(struct measurement *m, const struct study *study, double end,
                              bool finished, struct mpm_error *error)
{
    const struct parameters *const p = &study->p;
    const double until = fmin(end, parting_time(p)), pulled = until - p->length / p->speed;
    TRY(follow_rows_check(&study->rows, error));
    measurement_report(m, "finished", finished ? 1.0 : 0.0);
    measurement_report(m, "strength", 100.0 * study->largest);
    measurement_report(m, "parts", 100.0 * study->last / until);
    measurement_report(m, "impulse",
                       100.0 * study->impulse / (0.5 * p->area * p->rate * pulled * pulled));
    measurement_note(m, "largest tension %.5g of the strength, the last at t = %.5g, exact %.5g",
                     study->largest, study->last, until);
    return measurement_series(m, "force", "time tension_over_strength exact", COLUMNS,
                              study->rows.count, study->rows.values, error);
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study study = {.rows = {.columns = COLUMNS}};
    const double end = mpm_scene_end_time(scene);
    bool alive = true;
    (void)context;
    TRY(read_parameters(m, &study.p, error));
    TRY(contact_history_find(scene, 0, 1, "force_x", &study.force, error));
    enum mpm_status status = MPM_OK;
    while (status == MPM_OK && alive && mpm_simulation_time(simulation) < end) {
        const double before = mpm_simulation_time(simulation);
        status = follow_step(m, simulation, end, &alive, error);
        if (status == MPM_OK && alive)
            add_force(&study, simulation, before);
    }
    follow_count_work(m, simulation);
    if (status == MPM_OK)
        status = report(m, &study, end, alive, error);
    follow_rows_free(&study.rows);
    return status;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    return follow_scene(measurement, NULL, 0, measure, NULL, error);
}

const struct measure_program program_adhesion = {
    .name = "adhesion",
    .summary = "force between two bars that adhere until their strength, against a wave of tension",
    .run = run,
};

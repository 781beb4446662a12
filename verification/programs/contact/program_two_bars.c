/* C2: a bar hits another one, against the exact solution of struck_bars.h.
 *
 * Body 0 hits body 1 along the direction `angle`. The force of contact is sampled at every step;
 * fields half a contact time after contact should begin, and at the end.
 *
 * Parameters: length_1, modulus_1, density_1, the same of 2, speed, gap; angle (degrees), area (of
 * the bars' section), face_x, face_y (a point of the struck face of body 1 at the start), cell.
 * Reports
 *   begins             % of the gap that is gone at the first force
 *   early              cells that are left of the gap then
 *   impulse            % of p area T
 *   pressure           %: mean force from 0.25 T to 0.75 T over p area
 *   duration           %: time from the first to the last force above p area/2, over T
 *   velocity, stress   %: means over what is within 0.35 L1 of the faces at T/2, over v* and -p
 *   restitution        % of e
 *   left_1, left_2     %: root mean square stress at the end less the exact one, over p
 *   error_l1           %: integral of |stress - exact| over both bars at T/2, over p L1
 *   finished
 * and with level_1, ... (levels.h) the orders of error_l1. Series force, profile.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/contact/struck_bars.h"
#include "verification/measures/particle_set.h"
#include "verification/programs/contact/contact_history.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>

enum { AXES = 2, STRESS = 4, FORCE_COLUMNS = 3, PROFILE_COLUMNS = 5 };
static const double NEAR = 0.35; /* of L1: what T/2 has put under the full pressure */

struct parameters {
    struct struck_bars bars;
    double angle, area, face[AXES], cell;
    double along[AXES];
};

/* Body `bar` at some instant: means, and errors against the exact solution. */
struct look {
    double velocity;                   /* mean */
    double near_velocity, near_stress; /* means near the face */
    double rms, l1;                    /* of the stress's error: root mean square, mean */
};

struct study {
    struct parameters p;
    struct particle_set set[STRUCK_BARS];
    size_t force[AXES]; /* quantities of the history */
    double first_force; /* time; NaN before */
    double impulse, middle, middle_time;
    double half_from, half_to; /* first and last time with more than half of the force */
    struct follow_rows forces, profile;
    struct look at_half[STRUCK_BARS], at_end[STRUCK_BARS];
    bool finished, last;
};

static enum mpm_status read_parameters(const struct measurement *m, struct parameters *p,
                                       struct mpm_error *error)
{
    const struct measurement_parameter table[] = {
        {"length_1", &p->bars.length[0]},
        {"length_2", &p->bars.length[1]},
        {"modulus_1", &p->bars.modulus[0]},
        {"modulus_2", &p->bars.modulus[1]},
        {"density_1", &p->bars.density[0]},
        {"density_2", &p->bars.density[1]},
        {"speed", &p->bars.speed},
        {"gap", &p->bars.gap},
        {"angle", &p->angle},
        {"area", &p->area},
        {"face_x", &p->face[0]},
        {"face_y", &p->face[1]},
        {"cell", &p->cell},
    };
    TRY(measurement_numbers(m, table, sizeof table / sizeof *table, error));
    if (!struck_bars_are_solved(&p->bars))
        return failure_set(error, MPM_BAD_INPUT,
                           "the first bar must have the smaller impedance and the earlier echo");
    p->along[0] = cos(p->angle * G_PI / 180.0);
    p->along[1] = sin(p->angle * G_PI / 180.0);
    return MPM_OK;
}

/* -------------------------------------------------------------------- force */

static double force_of(const struct study *study, const struct mpm_simulation *simulation)
{
    double force = 0.0;
    for (int axis = 0; axis < AXES; axis++)
        force -=
            study->p.along[axis] * mpm_simulation_contact_quantity(simulation, study->force[axis]);
    return force;
}

/* Of the step that has been taken, from `before` to now. */
static void add_force(struct study *study, const struct mpm_simulation *simulation, double before)
{
    const struct struck_bars *const bars = &study->p.bars;
    const double now = mpm_simulation_time(simulation), force = force_of(study, simulation);
    const double full = struck_bars_pressure(bars) * study->p.area;
    const double since =
        (0.5 * (before + now) - bars->gap / bars->speed) / struck_bars_duration(bars);
    if (force != 0.0 && isnan(study->first_force))
        study->first_force = before;
    study->impulse += force * (now - before);
    if (since > 0.25 && since < 0.75) {
        study->middle += force * (now - before);
        study->middle_time += now - before;
    }
    if (force > 0.5 * full) {
        study->half_to = now;
        if (isnan(study->half_from))
            study->half_from = before;
    }
    if (study->last)
        follow_rows_add(&study->forces,
                        (const double[FORCE_COLUMNS]){now, force / full,
                                                      since >= 0.0 && since < 1.0 ? 1.0 : 0.0});
}

static enum mpm_status advance(struct study *study, struct measurement *m,
                               struct mpm_simulation *simulation, double end, bool *alive,
                               struct mpm_error *error)
{
    while (*alive && mpm_simulation_time(simulation) < end) {
        const double before = mpm_simulation_time(simulation);
        TRY(follow_step(m, simulation, end, alive, error));
        if (*alive)
            add_force(study, simulation, before);
    }
    return MPM_OK;
}

/* ------------------------------------------------------------------- fields */

/* Along the bars, of a vector, and of a stress on a section across them. */
static double along(const struct parameters *p, const double *vector)
{
    return p->along[0] * vector[0] + p->along[1] * vector[1];
}

static double across(const struct parameters *p, const double *stress)
{
    const double *const d = p->along;
    return d[0] * d[0] * stress[0] + d[1] * d[1] * stress[1] + 2.0 * d[0] * d[1] * stress[3];
}

/* How far from its bar's struck face a particle was at the start. */
static double distance_of(const struct parameters *p, int bar, const double start[AXES])
{
    const double from_face[AXES] = {start[0] - p->face[0], start[1] - p->face[1]};
    const double place = along(p, from_face);
    return bar == 0 ? -place - p->bars.gap : place;
}

/* What a moment is looked at for. */
struct view {
    struct study *study;
    double time;
    bool written; /* to the series */
};

static void add_particle(const struct view *view, const struct particle_set *set, size_t k, int bar,
                         size_t *near, struct look *look)
{
    const struct parameters *const p = &view->study->p;
    const double distance = distance_of(p, bar, &set->start[AXES * k]);
    const struct struck_state exact = struck_bars_state(&p->bars, bar, distance, view->time);
    const double velocity = along(p, &set->all[AXES * set->index[k]]);
    const double stress = across(p, &set->stress[STRESS * k]);
    const double scale = struck_bars_pressure(&p->bars);
    look->velocity += velocity;
    look->l1 += fabs(stress - exact.stress);
    look->rms += (stress - exact.stress) * (stress - exact.stress);
    if (distance < NEAR * p->bars.length[0]) {
        ++*near;
        look->near_velocity += velocity;
        look->near_stress += stress;
    }
    if (view->written)
        follow_rows_add(&view->study->profile,
                        (const double[PROFILE_COLUMNS]){
                            bar == 0 ? -distance : distance, stress / scale, exact.stress / scale,
                            velocity / p->bars.speed, exact.velocity / p->bars.speed});
}

/* Particles of a bar have one mass. */
static void look_at(struct study *study, const struct mpm_simulation *simulation, bool written,
                    struct look looks[STRUCK_BARS])
{
    const struct view view = {study, mpm_simulation_time(simulation), written};
    for (int bar = 0; bar < STRUCK_BARS; bar++) {
        struct particle_set *const set = &study->set[bar];
        struct look look = {.velocity = 0.0};
        size_t near = 0;
        particle_set_read(set, simulation);
        mpm_simulation_field(simulation, MPM_FIELD_VELOCITY, set->all);
        for (size_t k = 0; k < set->count; k++)
            add_particle(&view, set, k, bar, &near, &look);
        const double all = (double)set->count, some = (double)near;
        looks[bar] = (struct look){look.velocity / all, look.near_velocity / some,
                                   look.near_stress / some, sqrt(look.rms / all), look.l1 / all};
    }
}

/* ------------------------------------------------------------------ running */

static enum mpm_status open_bars(struct study *study, const struct mpm_scene *scene,
                                 const struct mpm_simulation *simulation, struct mpm_error *error)
{
    for (size_t bar = 0; bar < STRUCK_BARS; bar++) {
        TRY(particle_set_create(simulation, bar, &study->set[bar], error));
        if (study->set[bar].count == 0)
            return failure_set(error, MPM_BAD_INPUT, "bar %zu has no particles", bar + 1);
    }
    TRY(contact_history_find(scene, 0, 1, "force_x", &study->force[0], error));
    return contact_history_find(scene, 0, 1, "force_y", &study->force[1], error);
}

static enum mpm_status follow_bars(struct study *study, struct measurement *m,
                                   const struct mpm_scene *scene, struct mpm_simulation *simulation,
                                   struct mpm_error *error)
{
    const struct struck_bars *const bars = &study->p.bars;
    const double half = bars->gap / bars->speed + 0.5 * struck_bars_duration(bars);
    bool alive = true;
    TRY(open_bars(study, scene, simulation, error));
    TRY(advance(study, m, simulation, half, &alive, error));
    look_at(study, simulation, study->last, study->at_half);
    TRY(advance(study, m, simulation, mpm_scene_end_time(scene), &alive, error));
    look_at(study, simulation, false, study->at_end);
    study->finished = alive;
    follow_count_work(m, simulation);
    return MPM_OK;
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    study->first_force = study->half_from = study->half_to = (double)NAN;
    study->impulse = study->middle = study->middle_time = 0.0;
    const enum mpm_status status = follow_bars(study, m, scene, simulation, error);
    for (int bar = 0; bar < STRUCK_BARS; bar++)
        particle_set_free(&study->set[bar]);
    return status;
}

/* ---------------------------------------------------------------- reporting */

static double error_of(const struct study *study)
{
    const struct struck_bars *const bars = &study->p.bars;
    const double scale = struck_bars_pressure(bars) * bars->length[0];
    return 100.0 / scale *
           (study->at_half[0].l1 * bars->length[0] + study->at_half[1].l1 * bars->length[1]);
}

static void report(struct measurement *m, const struct study *study)
{
    const struct parameters *const p = &study->p;
    const struct struck_bars *const bars = &p->bars;
    const double pressure = struck_bars_pressure(bars), lasts = struck_bars_duration(bars);
    const double near_velocity =
        0.5 * (study->at_half[0].near_velocity + study->at_half[1].near_velocity);
    const double near_stress =
        0.5 * (study->at_half[0].near_stress + study->at_half[1].near_stress);
    const double restitution =
        (study->at_end[1].velocity - study->at_end[0].velocity) / bars->speed;
    const struct {
        const char *name;
        double value;
    } table[] = {
        {"begins", 100.0 * study->first_force * bars->speed / bars->gap},
        {"early", (bars->gap - study->first_force * bars->speed) / p->cell},
        {"impulse", 100.0 * study->impulse / (pressure * p->area * lasts)},
        {"pressure", 100.0 * study->middle / study->middle_time / (pressure * p->area)},
        {"duration", 100.0 * (study->half_to - study->half_from) / lasts},
        {"velocity", 100.0 * near_velocity / struck_bars_velocity(bars)},
        {"stress", -100.0 * near_stress / pressure},
        {"restitution", 100.0 * restitution / struck_bars_restitution(bars)},
        {"left_1", 100.0 * study->at_end[0].rms / pressure},
        {"left_2", 100.0 * study->at_end[1].rms / pressure},
        {"error_l1", error_of(study)},
    };
    measurement_report(m, "finished", study->finished ? 1.0 : 0.0);
    for (size_t k = 0; k < G_N_ELEMENTS(table); k++)
        if (study->finished)
            measurement_report(m, table[k].name, table[k].value);
        else
            measurement_inconclusive(m, table[k].name, "the run did not reach its end");
}

static enum mpm_status write_series(struct measurement *m, const struct study *study,
                                    struct mpm_error *error)
{
    TRY(follow_rows_check(&study->forces, error));
    TRY(follow_rows_check(&study->profile, error));
    TRY(measurement_series(m, "force", "time force exact", FORCE_COLUMNS, study->forces.count,
                           study->forces.values, error));
    return measurement_series(m, "profile", "place stress exact_stress velocity exact_velocity",
                              PROFILE_COLUMNS, study->profile.count, study->profile.values, error);
}

static enum mpm_status run_levels(struct measurement *m, struct study *study,
                                  struct mpm_error *error)
{
    struct levels levels;
    double errors[LEVELS_MAX] = {0.0};
    TRY(levels_read(m, &levels, error));
    const size_t runs = levels_runs(&levels);
    for (size_t k = 0; k < runs; k++) {
        study->last = k + 1 == runs;
        TRY(follow_scene(m, &levels.setting[k], levels.count == 0 ? 0 : 1, measure, study, error));
        errors[k] = study->finished ? error_of(study) : (double)NAN;
    }
    report(m, study);
    TRY(write_series(m, study, error));
    return levels.count > 0 ? levels_report(m, &levels, "", errors, error) : MPM_OK;
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct study study = {.forces = {.columns = FORCE_COLUMNS},
                          .profile = {.columns = PROFILE_COLUMNS}};
    TRY(read_parameters(m, &study.p, error));
    const enum mpm_status status = run_levels(m, &study, error);
    follow_rows_free(&study.forces);
    follow_rows_free(&study.profile);
    return status;
}

const struct measure_program program_two_bars = {
    .name = "two_bars",
    .summary = "a bar hits another: velocity, stress, contact time, restitution",
    .run = run,
};

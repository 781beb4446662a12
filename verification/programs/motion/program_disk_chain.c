/* D4, C11: a row of disks, the middle one cracked, is hit from the left, CRAMP 3.3: does the wave
 * run through the row as it must, do the crack's faces meet without crossing, how many fringes does
 * a photoelastic disk show?
 *
 * Bodies are in a row along x: first the one that hits, then the disks, from x = 0 on.
 *
 * With `contact_modulus`, E* > 0, for scenes whose bodies have contact and samples at every step:
 * by how much a body's momentum differs from the sum of its neighbours' impulses, over the whole
 * momentum; and the width over which the first two disks touch when their force is largest, over
 * Hertz's for cylinders, 4 sqrt(F R/(2 pi E*)).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/contact/contact_history.h"
#include "verification/programs/follow.h"
#include "verification/programs/motion/impact.h"

#include <glib.h>
#include <math.h>

enum { AXES = 2, STRESS = 4, DISKS = 5, PAIRS = 5, PROBES = 2, FIXED = 5, COLUMNS = FIXED + DISKS };

static const double TWO_PI = 6.28318530717958647692;

/* Contact between a body of the row and the next one. */
struct touch {
    size_t force, area; /* places in the history */
    double impulse;     /* on the next one, along x, so far */
    double strongest, width;
};

/* A particle on the axis of the first disk, and when it begins to move. */
struct probe {
    size_t index;
    double start, arrival; /* its x at t = 0; time, NaN before */
};

struct study {
    struct impact impact;
    double speed, radius, wave_speed, fringe;
    double *mass, *body, *velocity, *stress;
    double mean[DISKS];    /* velocity of a disk along x, now */
    double arrival[DISKS]; /* when it began to move; NaN before */
    struct probe probes[PROBES];
    double order, largest_order; /* of fringes about the middle disk's centre: now, so far */
    double last_order;           /* when the last disk began to move: that of the photographs */
    double contact_modulus;      /* 0: none */
    struct touch touches[PAIRS];
    double time, start[DISKS + 1], total; /* of the last sample; momenta at the start */
    double unexplained;                   /* of momenta by impulses, so far */
    double energy;                        /* at the start */
    struct follow_rows rows;
};

/* ----------------------------------------------------------------- the wave */

/* Part of the speed of impact that counts as motion, of a disk's mean and of a particle. */
static const double DISK_MOVES = 1e-3, PARTICLE_MOVES = 0.02;

/* A body's momentum against the impulses of its neighbours; `momentum` of all bodies, now. */
static void look_at_touches(struct study *study, const struct mpm_simulation *simulation,
                            double time, const double momentum[DISKS + 1])
{
    const bool first = study->rows.count == 0;
    double given = 0.0;
    for (int k = 0; k <= DISKS; k++) {
        double got = given;
        if (first)
            study->start[k] = momentum[k];
        study->total += first ? momentum[k] : 0.0;
        given = 0.0;
        if (k < PAIRS) {
            struct touch *const touch = &study->touches[k];
            const double force = -mpm_simulation_contact_quantity(simulation, touch->force);
            touch->impulse += (time - study->time) * force;
            if (force > touch->strongest) {
                touch->strongest = force;
                touch->width = mpm_simulation_contact_quantity(simulation, touch->area);
            }
            given = touch->impulse;
            got -= given;
        }
        study->unexplained =
            fmax(study->unexplained, fabs(momentum[k] - study->start[k] - got) / study->total);
    }
    study->time = time;
}

static void look_at_disks(struct study *study, const struct mpm_simulation *simulation, double time)
{
    double mass[DISKS + 1] = {0.0}, momentum[DISKS + 1] = {0.0};
    for (size_t p = 0; p < study->impact.count; p++) {
        const int body = (int)study->body[p];
        mass[body] += study->mass[p];
        momentum[body] += study->mass[p] * study->velocity[AXES * p];
    }
    if (study->contact_modulus > 0.0)
        look_at_touches(study, simulation, time, momentum);
    for (int k = 0; k < DISKS; k++) {
        study->mean[k] = momentum[k + 1] / mass[k + 1];
        if (isnan(study->arrival[k]) && study->mean[k] > DISK_MOVES * study->speed)
            study->arrival[k] = time;
    }
}

/* Places on the axis are two rows of particles: the one above it is taken. */
static void place_probes(struct study *study)
{
    for (int k = 0; k < PROBES; k++) {
        const double goal[AXES] = {study->radius * (0.5 + (double)k), 0.25 * study->impact.cell};
        double best = HUGE_VAL;
        for (size_t p = 0; p < study->impact.count; p++) {
            const double *const place = study->impact.position + AXES * p;
            const double distance = hypot(place[0] - goal[0], place[1] - goal[1]);
            if (distance < best) {
                best = distance;
                study->probes[k] =
                    (struct probe){.index = p, .start = place[0], .arrival = (double)NAN};
            }
        }
    }
}

static void look_at_probes(struct study *study, double time)
{
    for (int k = 0; k < PROBES; k++) {
        struct probe *const probe = &study->probes[k];
        if (isnan(probe->arrival) &&
            study->velocity[AXES * probe->index] > PARTICLE_MOVES * study->speed)
            probe->arrival = time;
    }
}

/* Largest k (s1 - s2)/2 pi within two thirds of the middle disk's radius: away from its contacts.
 */
static double fringe_order(const struct study *study)
{
    const double centre = 2.0 * study->radius * (0.5 * DISKS), inner = study->radius * 2.0 / 3.0;
    double largest = 0.0;
    for (size_t p = 0; p < study->impact.count; p++) {
        const double *const place = study->impact.position + AXES * p;
        const double *const s = &study->stress[STRESS * p];
        if (hypot(place[0] - centre, place[1]) < inner)
            largest = fmax(largest, hypot(s[0] - s[1], 2.0 * s[3]));
    }
    return study->fringe * largest / TWO_PI;
}

/* --------------------------------------------------------------------- look */

static void look(void *context, const struct mpm_simulation *simulation,
                 const struct mpm_ledger *ledger)
{
    struct study *const study = context;
    const double cell = study->impact.cell;
    impact_look(&study->impact);
    mpm_simulation_field(simulation, MPM_FIELD_VELOCITY, study->velocity);
    mpm_simulation_field(simulation, MPM_FIELD_STRESS, study->stress);
    look_at_disks(study, simulation, ledger->time);
    look_at_probes(study, ledger->time);
    study->order = fringe_order(study);
    study->largest_order = fmax(study->largest_order, study->order);
    if (isnan(study->last_order) && !isnan(study->arrival[DISKS - 1]))
        study->last_order = study->order;
    if (study->rows.count == 0)
        study->energy = ledger->total_energy;
    const struct crack_gap none = {.widest = 0.0};
    const struct crack_gap *const gap =
        study->impact.crack_count > 0 ? &study->impact.cracks[0].now : &none;
    double row[COLUMNS] = {ledger->time, ledger->total_energy / study->energy, gap->widest / cell,
                           gap->narrowest / cell, study->order};
    for (int k = 0; k < DISKS; k++)
        row[FIXED + k] = study->mean[k] / study->speed;
    follow_rows_add(&study->rows, row);
}

/* ------------------------------------------------------------------- report */

static void report_touches(const struct study *study, struct measurement *m)
{
    const struct touch *const touch = &study->touches[1];
    const double hertz =
        4.0 * sqrt(touch->strongest * 0.5 * study->radius / (G_PI * study->contact_modulus));
    measurement_report(m, "unexplained", study->unexplained);
    measurement_report(m, "width", touch->width / hertz);
    measurement_note(m, "first two disks: largest force %.6g, over a width of %.4g, Hertz's %.4g",
                     touch->strongest, touch->width, hertz);
}

/* The unit of times is the time that a wave takes through a disk. */
static void report_arrivals(const struct study *study, struct measurement *m)
{
    const double crossing = 2.0 * study->radius / study->wave_speed;
    for (int k = 0; k < DISKS; k++) {
        char *const name = g_strdup_printf("arrival_%d", k + 1);
        if (isnan(study->arrival[k]))
            measurement_inconclusive(m, name, "disk %d has not moved", k + 1);
        else
            measurement_report(m, name, study->arrival[k] / crossing);
        g_free(name);
    }
    const struct probe *const near = &study->probes[0], *const far = &study->probes[1];
    measurement_report(m, "front_speed",
                       (far->start - near->start) / (far->arrival - near->arrival) /
                           study->wave_speed);
}

static enum mpm_status report(const struct study *study, struct measurement *m,
                              const struct follow_result *result, struct mpm_error *error)
{
    follow_report(m, result, 0.0); /* angular momentum: asymmetry has it */
    measurement_report(m, "momentum_drift", conservation_momentum_drift(&result->conservation));
    measurement_report(m, "particles", (double)study->impact.count);
    measurement_report(m, "order", study->largest_order);
    if (study->contact_modulus > 0.0)
        report_touches(study, m);
    if (isnan(study->last_order))
        measurement_inconclusive(m, "last_order", "the last disk has not moved");
    else
        measurement_report(m, "last_order", study->last_order);
    report_arrivals(study, m);
    TRY(impact_report(&study->impact, error));
    TRY(follow_rows_check(&study->rows, error));
    return measurement_series(m, "chain",
                              "time total_over_start widest narrowest order v1 v2 v3 v4 v5",
                              COLUMNS, study->rows.count, study->rows.values, error);
}

static enum mpm_status find_touches(struct study *study, const struct mpm_scene *scene,
                                    const struct measurement *m, struct mpm_error *error)
{
    if (!measurement_has(m, "contact_modulus"))
        return MPM_OK;
    TRY(measurement_number(m, "contact_modulus", &study->contact_modulus, error));
    for (size_t k = 0; k < PAIRS && study->contact_modulus > 0.0; k++) {
        struct touch *const touch = &study->touches[k];
        TRY(contact_history_find(scene, k, k + 1, "force_x", &touch->force, error));
        TRY(contact_history_find(scene, k, k + 1, "area", &touch->area, error));
    }
    return MPM_OK;
}

static enum mpm_status open_study(struct study *study, struct measurement *m,
                                  const struct mpm_simulation *simulation, struct mpm_error *error)
{
    const size_t n = mpm_simulation_particle_count(simulation);
    const struct measurement_parameter parameters[] = {{"speed", &study->speed},
                                                       {"radius", &study->radius},
                                                       {"wave_speed", &study->wave_speed},
                                                       {"fringe", &study->fringe}};
    study->mass = g_new(double, n);
    study->body = g_new(double, n);
    study->velocity = g_new(double, AXES *n);
    study->stress = g_new(double, STRESS *n);
    study->rows.columns = COLUMNS;
    study->last_order = (double)NAN;
    for (int k = 0; k < DISKS; k++)
        study->arrival[k] = (double)NAN;
    mpm_simulation_field(simulation, MPM_FIELD_MASS, study->mass);
    mpm_simulation_field(simulation, MPM_FIELD_BODY, study->body);
    TRY(measurement_numbers(m, parameters, G_N_ELEMENTS(parameters), error));
    TRY(impact_open(&study->impact, m, simulation, MPM_FIELD_FRINGE, error));
    place_probes(study);
    return MPM_OK;
}

static void close_study(struct study *study)
{
    impact_close(&study->impact);
    follow_rows_free(&study->rows);
    g_free(study->mass);
    g_free(study->body);
    g_free(study->velocity);
    g_free(study->stress);
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study study = {.speed = 0.0};
    struct follow_result result;
    struct follow follow = {
        .measurement = m, .end = mpm_scene_end_time(scene), .sample = look, .context = &study};
    (void)context;
    TRY(measurement_number(m, "interval", &follow.interval, error));
    enum mpm_status status = open_study(&study, m, simulation, error);
    if (status == MPM_OK)
        status = find_touches(&study, scene, m, error);
    if (status == MPM_OK)
        status = follow_run(&follow, simulation, &result, error);
    if (status == MPM_OK)
        status = report(&study, m, &result, error);
    close_study(&study);
    return status;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    return follow_scene(measurement, NULL, 0, measure, NULL, error);
}

const struct measure_program program_disk_chain = {
    .name = "disk_chain",
    .summary = "a row of disks is hit: arrival of the wave, a crack in the middle, fringes",
    .run = run,
};

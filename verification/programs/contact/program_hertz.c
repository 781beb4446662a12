/* C5: an elastic sphere on a rigid plane, or on a sphere like it, axisymmetric: Hertz's force,
 * radius of contact and impact.
 *
 * Parameters: motion: `press` or `impact`; radius, young, poisson, speed, interval; plane: the
 * height at which the sphere, body 0 of the scene, touches it. The centre is above the plane with
 * sphere: 1 and below it with -1.
 *
 * press: the sphere's centre is held at its height, by a plane of symmetry, and the partner moves
 * towards it with speed s(t), s = (1 - cos(pi t/rise))/2 until `rise`, 1 then. The factors on
 * Hertz's force and radius of contact are those of least squares over all samples with indentations
 * above the parameter `from` (of the radius). aspect: width of particles over their height.
 * impact: the sphere flies with `speed` towards the plane, which rests, or with `mirror: 1` is the
 * one between the sphere and body 1, which flies towards it.
 *
 * With level_1, level_2, ... (levels.h) all of it is done on grids whose cells are halved each
 * time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/contact/hertz.h"
#include "verification/programs/contact/body_motion.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"
#include "verification/programs/picture.h"

#include <glib.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { AXES = 2, ALONG = 1, COLUMNS = 6 };

static const double PI = 3.14159265358979323846;

enum motion { PRESS, IMPACT, MOTIONS };
static const char *const motions[MOTIONS] = {"press", "impact"};

struct parameters {
    struct hertz hertz;
    enum motion motion;
    double plane, side, interval;
    double rise, from, aspect;
    bool mirror;
};

/* Sums for a factor by least squares. */
struct factor {
    double product, square;
};

/* What one run has. */
struct outcome {
    double force, contact; /* factors on Hertz's force and radius of contact */
    double axis;           /* factor on the stress on the axis below the contact */
    double depth, duration, width, restitution;
    double energy; /* largest drift, over that at the start */
    bool finished;
};

struct run {
    struct measurement *measurement;
    struct parameters parameters;
    struct mpm_scene *scene;
    struct mpm_simulation *simulation;
    struct body_motion body, other; /* the second with a mirror only */
    size_t force_index, area_index;
    double indentation, force, contact; /* now */
    double deepest, strongest;
    double first, last; /* times of contact; NaN before */
    struct factor force_factor, contact_factor;
    struct follow_rows rows;
};

/* ------------------------------------------------------------------ looking */

static double pressed(const struct parameters *p, double time)
{
    const double speed = p->hertz.speed;
    if (time >= p->rise)
        return speed * (time - 0.5 * p->rise);
    return 0.5 * speed * (time - p->rise / PI * sin(PI * time / p->rise));
}

/* How much nearer to the plane the centre is than the radius. */
static double find_indentation(struct run *run)
{
    const struct parameters *const p = &run->parameters;
    if (p->motion == PRESS)
        return pressed(p, mpm_simulation_time(run->simulation));
    body_motion_read(&run->body, run->simulation);
    if (!p->mirror)
        return p->hertz.radius - p->side * (run->body.place[ALONG] - p->plane);
    body_motion_read(&run->other, run->simulation);
    return p->hertz.radius - 0.5 * p->side * (run->body.place[ALONG] - run->other.place[ALONG]);
}

static void add_to_factor(struct factor *factor, double found, double exact)
{
    factor->product += found * exact;
    factor->square += exact * exact;
}

static void look(struct run *run)
{
    const struct parameters *const p = &run->parameters;
    const double time = mpm_simulation_time(run->simulation);
    /* per radian */
    const double force =
        2.0 * PI * p->side * mpm_simulation_contact_quantity(run->simulation, run->force_index);
    const double area =
        2.0 * PI * mpm_simulation_contact_quantity(run->simulation, run->area_index);
    run->indentation = find_indentation(run);
    run->force = force;
    run->contact = sqrt(area / PI);
    const double depth = fmax(run->indentation, 0.0);
    const double exact_contact =
        p->motion == PRESS ? hertz_plates_radius(&p->hertz, depth) : hertz_radius(&p->hertz, depth);
    const double exact_force =
        hertz_force(&p->hertz, exact_contact * exact_contact / p->hertz.radius);
    if (run->indentation > p->from * p->hertz.radius) {
        add_to_factor(&run->force_factor, force, exact_force);
        add_to_factor(&run->contact_factor, run->contact, exact_contact);
    }
    run->deepest = fmax(run->deepest, run->indentation);
    run->strongest = fmax(run->strongest, force);
    if (force > 0.0) {
        run->last = time;
        if (isnan(run->first))
            run->first = time;
    }
    const double row[COLUMNS] = {time,         run->indentation, force,
                                 run->contact, exact_force,      exact_contact};
    follow_rows_add(&run->rows, row);
}

/* How long the force is above half of its maximum, from the samples. */
static double find_width(const struct run *run)
{
    double begin = (double)NAN, end = (double)NAN;
    for (size_t k = 1; k < run->rows.count; k++) {
        const double *const row = run->rows.values + COLUMNS * k, *const before = row - COLUMNS;
        const double low = before[2] - 0.5 * run->strongest, high = row[2] - 0.5 * run->strongest;
        if (low * high > 0.0 || low == high)
            continue;
        const double time = before[0] + (row[0] - before[0]) * low / (low - high);
        if (isnan(begin))
            begin = time;
        end = time;
    }
    return end - begin;
}

/* The same of Hertz's impact: F = F_m/2 where delta = 2^(-2/3) delta_m. */
static double exact_width(const struct hertz *hertz)
{
    enum { STEPS = 400, HALVINGS = 40 };
    const double duration = hertz_duration(hertz),
                 level = pow(0.5, 2.0 / 3.0) * hertz_deepest(hertz);
    double low = 0.0, high = 0.5 * duration;
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = 0.5 * (low + high);
        *(hertz_indentation_at(hertz, middle, STEPS) < level ? &low : &high) = middle;
    }
    return duration - 2.0 * low;
}

/* The stress along z of the particles next to the axis, over their depth below the plane, with that
 * of Hertz's pressure on a half-space, as the series `axis`; and the factor between both at depths
 * from half a radius of contact, where steps of the surface are no longer felt, to one and a half.
 */
static enum mpm_status find_axis(struct run *run, bool write, double *factor,
                                 struct mpm_error *error)
{
    enum { AXIS_COLUMNS = 3, STRESS = 4 };
    const struct parameters *const p = &run->parameters;
    struct body_motion *const body = &run->body;
    const size_t n = body->all_count;
    struct follow_rows rows = {.columns = AXIS_COLUMNS};
    struct factor sums = {0};
    double *const stress = g_new(double, STRESS *n);
    body_motion_read(body, run->simulation);
    mpm_simulation_field(run->simulation, MPM_FIELD_STRESS, stress);
    const double a = hertz_plates_radius(&p->hertz, run->indentation);
    const double p0 = hertz_pressure(&p->hertz, a * a / p->hertz.radius);
    const double near = 1.5 * body->extent[0][0];
    for (size_t k = 0; k < body->count; k++) {
        const double *const x = &body->position[AXES * k];
        const double depth = p->side * (x[ALONG] - p->plane) - run->indentation;
        const double exact = -p0 / (1.0 + depth * depth / (a * a));
        const double row[AXIS_COLUMNS] = {depth, stress[STRESS * body->index[k] + ALONG], exact};
        if (x[0] > near)
            continue;
        if (depth >= 0.5 * a && depth <= 1.5 * a)
            add_to_factor(&sums, row[1], exact);
        follow_rows_add(&rows, row);
    }
    *factor = sums.product / sums.square;
    enum mpm_status status = follow_rows_check(&rows, error);
    if (status == MPM_OK && write)
        status = measurement_series(run->measurement, "axis", "depth stress half_space",
                                    AXIS_COLUMNS, rows.count, rows.values, error);
    follow_rows_free(&rows);
    g_free(stress);
    return status;
}

/* ------------------------------------------------------------------ running */

static enum mpm_status open_run(struct run *run, const char *setting, struct mpm_error *error)
{
    const struct measurement *const m = run->measurement;
    const struct parameters *const p = &run->parameters;
    TRY(measurement_scene(m, &setting, setting == NULL ? 0 : 1, &run->scene, error));
    TRY(mpm_simulation_create(run->scene, measurement_options(m), &run->simulation, error));
    TRY(body_motion_open(run->simulation, 0, &run->body, error));
    if (p->mirror)
        TRY(body_motion_open(run->simulation, 1, &run->other, error));
    TRY(contact_quantity_find(run->scene, "0_1", "force_y", &run->force_index, error));
    TRY(contact_quantity_find(run->scene, "0_1", "area", &run->area_index, error));
    run->parameters.hertz.mass = 2.0 * PI * run->body.mass;
    run->first = run->last = (double)NAN;
    run->deepest = run->strongest = -HUGE_VAL;
    run->rows.columns = COLUMNS;
    return MPM_OK;
}

static void close_run(struct run *run)
{
    body_motion_close(&run->body);
    body_motion_close(&run->other);
    follow_rows_free(&run->rows);
    mpm_simulation_free(run->simulation);
    mpm_scene_free(run->scene);
}

/* The moment whose fields are drawn: the largest indentation of an impact, the end of a press. */
static bool is_the_moment(const struct run *run)
{
    const size_t n = run->rows.count;
    if (run->parameters.motion == PRESS)
        return false;
    return n > 1 &&
           run->rows.values[COLUMNS * (n - 1) + 1] < run->rows.values[COLUMNS * (n - 2) + 1];
}

static enum mpm_status draw(const struct run *run, struct mpm_error *error)
{
    struct picture picture;
    bool asked;
    TRY(picture_read(run->measurement, &picture, &asked, error));
    picture.axisymmetric = true;
    picture.aspect = run->parameters.aspect;
    return asked ? picture_write(run->measurement, &picture, run->simulation, MPM_FIELD_STRESS, 1,
                                 "stress", error)
                 : MPM_OK;
}

static void take(const struct run *run, double speed, const struct conservation *energy,
                 struct outcome *outcome)
{
    const struct hertz *const hertz = &run->parameters.hertz;
    outcome->force = run->force_factor.product / run->force_factor.square;
    outcome->contact = run->contact_factor.product / run->contact_factor.square;
    outcome->energy = conservation_energy_drift(energy);
    if (run->parameters.motion == PRESS)
        return;
    outcome->depth = run->deepest / hertz_deepest(hertz);
    outcome->duration = (run->last - run->first) / hertz_duration(hertz);
    outcome->width = find_width(run) / exact_width(hertz);
    outcome->restitution = run->body.velocity[ALONG] / -speed;
}

static enum mpm_status follow(struct run *run, bool last, struct outcome *outcome,
                              struct mpm_error *error)
{
    const double end = mpm_scene_end_time(run->scene), interval = run->parameters.interval;
    const double speed = run->body.velocity[ALONG];
    struct conservation energy = {0};
    bool drawn = !last;
    outcome->finished = true;
    for (size_t k = 0; outcome->finished && (double)k * interval <= end * (1.0 + 1e-12); k++) {
        struct mpm_ledger ledger;
        TRY(follow_to(run->measurement, run->simulation, fmin(interval * (double)k, end),
                      &outcome->finished, error));
        if (!outcome->finished)
            break;
        look(run);
        mpm_simulation_ledger(run->simulation, &ledger);
        if (k == 0)
            conservation_open(&energy, &ledger);
        else
            conservation_add(&energy, &ledger);
        if (!drawn && is_the_moment(run)) {
            TRY(draw(run, error));
            drawn = true;
        }
    }
    if (!drawn)
        TRY(draw(run, error));
    if (run->parameters.motion == PRESS)
        TRY(find_axis(run, last, &outcome->axis, error));
    take(run, speed, &energy, outcome);
    follow_count_work(run->measurement, run->simulation);
    return follow_rows_check(&run->rows, error);
}

static enum mpm_status measure(struct measurement *m, const struct parameters *p,
                               const char *setting, bool last, struct outcome *outcome,
                               struct mpm_error *error)
{
    struct run run = {.measurement = m, .parameters = *p};
    enum mpm_status status = open_run(&run, setting, error);
    if (status == MPM_OK)
        status = follow(&run, last, outcome, error);
    if (status == MPM_OK && last)
        status = measurement_series(m, "contact",
                                    "time indentation force radius hertz_force hertz_radius",
                                    COLUMNS, run.rows.count, run.rows.values, error);
    close_run(&run);
    return status;
}

/* ---------------------------------------------------------------- reporting */

static void report(struct measurement *m, const struct parameters *p, const char *suffix,
                   const struct outcome *outcome)
{
    const struct {
        const char *name;
        double value;
        int only; /* the motion; -1: both */
    } table[] = {
        {"force_ratio", outcome->force, -1},
        {"radius_ratio", outcome->contact, -1},
        {"axis_ratio", outcome->axis, PRESS},
        {"depth_ratio", outcome->depth, IMPACT},
        {"duration_ratio", outcome->duration, IMPACT},
        {"width_ratio", outcome->width, IMPACT},
        {"restitution", outcome->restitution, IMPACT},
        {"energy_drift", 100.0 * outcome->energy, IMPACT},
    };
    for (size_t k = 0; k < sizeof table / sizeof *table; k++)
        if (table[k].only < 0 || table[k].only == (int)p->motion)
            levels_report_value(m, table[k].name, suffix,
                                outcome->finished ? table[k].value : (double)NAN);
}

static enum mpm_status read_parameters(const struct measurement *m, struct parameters *p,
                                       struct mpm_error *error)
{
    size_t motion;
    const struct measurement_parameter table[] = {
        {"radius", &p->hertz.radius}, {"young", &p->hertz.young}, {"poisson", &p->hertz.poisson},
        {"speed", &p->hertz.speed},   {"plane", &p->plane},       {"sphere", &p->side},
        {"interval", &p->interval},   {"from", &p->from},         {"aspect", &p->aspect},
    };
    TRY(measurement_numbers(m, table, sizeof table / sizeof *table, error));
    TRY(measurement_choice(m, "motion", motions, MOTIONS, &motion, error));
    p->motion = (enum motion)motion;
    if (p->motion == PRESS)
        TRY(measurement_number(m, "rise", &p->rise, error));
    double mirror = 0.0;
    if (measurement_has(m, "mirror"))
        TRY(measurement_number(m, "mirror", &mirror, error));
    p->mirror = mirror > 0.0;
    return MPM_OK;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct parameters parameters = {0};
    struct levels levels;
    bool finished = true;
    TRY(read_parameters(measurement, &parameters, error));
    TRY(levels_read(measurement, &levels, error));
    const size_t runs = levels_runs(&levels);
    for (size_t k = 0; k < runs; k++) {
        struct outcome outcome = {0};
        char suffix[24] = "";
        if (levels.count > 0)
            (void)snprintf(suffix, sizeof suffix, "_%zu", k + 1);
        TRY(measure(measurement, &parameters, levels.count > 0 ? levels.setting[k] : NULL,
                    k + 1 == runs, &outcome, error));
        report(measurement, &parameters, suffix, &outcome);
        finished = finished && outcome.finished;
    }
    measurement_report(measurement, "finished", finished ? 1.0 : 0.0);
    return MPM_OK;
}

const struct measure_program program_hertz = {
    .name = "hertz",
    .summary = "an elastic sphere on a rigid plane or on a sphere like it: Hertz's contact",
    .run = run,
};

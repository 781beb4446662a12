/* P3, P4: a thick-walled sphere or tube of perfect plasticity under an inner pressure that goes up
 * and down in stages, each of which ends at rest: its state at the end of each stage against the
 * exact one (hill_sphere.h, plastic_tube.h).
 *
 * Parameters: shell: sphere (on r and z) | tube (along r) | plane_tube (on x and y); inner, outer;
 * young, poisson, yield; times and pressures, the end of each stage and its pressure, which rises
 * up to the stage `peak` (from 1 on) and falls from there on; the scene loads the body with the
 * same.
 *
 * With the number of the stage behind each name, reports
 *   stress_l2_1        root mean square over the mass and all components, % of Y
 *   away_l2_1          the same of particles more than 15 % of the wall away from both faces
 *   displacement_l2_1  the same, % of that of the inner face
 *   front_1            the radius up to which the body has yielded: that of a body from the inner
 *                      face on with the undeformed volume that has yielded, % of the exact one; not
 *                      of stages before it yields
 * and over levels (levels.h), orders with _stress_1, ... behind the name;
 * balance (% of the external work at the peak that total_energy does not have, at the end) and
 * finished. Series: profile, and state_1, ...: r rr tt plastic exact_rr exact_tt.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/plastic/hill_sphere.h"
#include "verification/exact/plastic/plastic_tube.h"
#include "verification/measures/error_norms.h"
#include "verification/measures/particle_set.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>

enum { AXES = 2, STRESS = 4, COLUMNS = 6, STAGES_MAX = 4 };
enum { ELEMENTS = 500, STEPS = 400 }; /* of the tube's reference, which the tests refine */
static const double FACES = 0.15;     /* of the wall: beside them, see away_l2 */

enum shell { SPHERE, TUBE, PLANE_TUBE, SHELLS };
static const char *const shell_names[SHELLS] = {"sphere", "tube", "plane_tube"};

struct problem {
    enum shell shell;
    double inner, outer, young, poisson, yield;
    size_t stages, peak; /* peak: its place, from 0 on */
    double times[STAGES_MAX], pressures[STAGES_MAX];
};

/* The exact state of a stage. */
struct reference {
    const struct problem *problem;
    struct hill_sphere sphere;
    struct plastic_tube_run *tube;
    double peak, pressure;
    double front; /* NaN before it yields */
};

/* In polar coordinates. */
struct polar {
    double rr, tt, out; /* out: of the plane of a tube, or around the axis of a sphere */
    double u;
};

/* Errors of a stage. */
struct stage {
    double stress, away, displacement, front;
};

struct study {
    const struct problem *problem;
    struct stage stage[STAGES_MAX];
    double balance;
    bool last, finished;
};

/* ------------------------------------------------------------------ references */

static struct polar polar_at(const struct reference *reference, double r)
{
    if (reference->problem->shell == SPHERE) {
        const struct hill_sphere_state s =
            hill_sphere_state(&reference->sphere, reference->peak, reference->pressure, r);
        return (struct polar){s.rr, s.tt, s.tt, s.u};
    }
    const struct plastic_tube_state s = plastic_tube_at(reference->tube, r);
    return (struct polar){s.rr, s.tt, s.zz, s.u};
}

/* Displacement and stress xx yy zz xy, or rr zz tt rz, at a place of the grid. */
static void state_at(const struct reference *reference, const double place[AXES],
                     double displacement[AXES], double stress[STRESS])
{
    if (reference->problem->shell == TUBE) {
        const struct polar s = polar_at(reference, place[0]);
        displacement[0] = s.u;
        displacement[1] = 0.0;
        stress[0] = s.rr;
        stress[1] = s.out;
        stress[2] = s.tt;
        stress[3] = 0.0;
        return;
    }
    const double r = hypot(place[0], place[1]), c = place[0] / r, d = place[1] / r;
    const struct polar s = polar_at(reference, r);
    displacement[0] = s.u * c;
    displacement[1] = s.u * d;
    stress[0] = s.rr * c * c + s.tt * d * d;
    stress[1] = s.rr * d * d + s.tt * c * c;
    stress[2] = s.out;
    stress[3] = (s.rr - s.tt) * c * d;
}

/* Brings the reference to a stage. */
static enum mpm_status load_reference(struct reference *reference, size_t stage,
                                      struct mpm_error *error)
{
    const struct problem *const p = reference->problem;
    reference->pressure = p->pressures[stage];
    reference->peak = p->pressures[stage < p->peak ? stage : p->peak];
    if (p->shell == SPHERE)
        reference->front = hill_sphere_front(&reference->sphere, reference->peak);
    else if (plastic_tube_load(reference->tube, reference->pressure))
        reference->front = plastic_tube_front(reference->tube);
    else
        return failure_set(error, MPM_BAD_INPUT, "pressure %g is beyond what the tube bears",
                           reference->pressure);
    if (reference->front <= p->inner)
        reference->front = (double)NAN;
    return MPM_OK;
}

static struct reference open_reference(const struct problem *p)
{
    const struct plastic_tube tube = {p->inner, p->outer, p->young, p->poisson,
                                      p->yield, ELEMENTS, STEPS};
    return (struct reference){
        .problem = p,
        .sphere = {p->inner, p->outer, p->young, p->poisson, p->yield},
        .tube = p->shell == SPHERE ? NULL : plastic_tube_create(&tube),
    };
}

/* ------------------------------------------------------------------- measuring */

/* What is seen of the particles, and what should be. */
struct view {
    struct particle_set set;
    double *mass, *inside; /* inside: 0 near the faces */
    double *plastic;
    double *moved, *exact_moved;
    double *exact_stress;
};

static double radius_of(const struct problem *p, const double place[AXES])
{
    return p->shell == TUBE ? place[0] : hypot(place[0], place[1]);
}

static enum mpm_status open_view(const struct problem *p, const struct mpm_simulation *simulation,
                                 struct view *view, struct mpm_error *error)
{
    TRY(particle_set_create(simulation, 0, &view->set, error));
    const size_t n = view->set.count;
    const double margin = FACES * (p->outer - p->inner);
    view->mass = g_new(double, n);
    view->inside = g_new0(double, n);
    view->plastic = g_new(double, n);
    view->moved = g_new(double, AXES *n);
    view->exact_moved = g_new(double, AXES *n);
    view->exact_stress = g_new(double, STRESS *n);
    mpm_simulation_field(simulation, MPM_FIELD_MASS, view->set.all);
    for (size_t k = 0; k < n; k++) {
        const double r = radius_of(p, view->set.start + AXES * k);
        view->mass[k] = view->set.all[view->set.index[k]];
        if (r > p->inner + margin && r < p->outer - margin)
            view->inside[k] = view->mass[k];
    }
    return MPM_OK;
}

static void close_view(struct view *view)
{
    particle_set_free(&view->set);
    g_free(view->mass);
    g_free(view->inside);
    g_free(view->plastic);
    g_free(view->moved);
    g_free(view->exact_moved);
    g_free(view->exact_stress);
}

static void read_view(struct view *view, const struct reference *reference,
                      const struct mpm_simulation *simulation)
{
    struct particle_set *const set = &view->set;
    particle_set_read(set, simulation);
    mpm_simulation_field(simulation, MPM_FIELD_PLASTIC_STRAIN, set->all);
    for (size_t k = 0; k < set->count; k++) {
        view->plastic[k] = set->all[set->index[k]];
        state_at(reference, &set->start[AXES * k], &view->exact_moved[AXES * k],
                 &view->exact_stress[STRESS * k]);
        for (size_t c = 0; c < AXES; c++)
            view->moved[AXES * k + c] = set->position[AXES * k + c] - set->start[AXES * k + c];
    }
}

/* From the part of the mass that has yielded: c^d = a^d + part (b^d - a^d). */
static double front_of(const struct problem *p, const struct view *view)
{
    const double d = p->shell == SPHERE ? 3.0 : 2.0;
    double yielded = 0.0, all = 0.0;
    for (size_t k = 0; k < view->set.count; k++) {
        all += view->mass[k];
        if (view->plastic[k] > 0.0)
            yielded += view->mass[k];
    }
    const double low = pow(p->inner, d), high = pow(p->outer, d);
    return pow(low + yielded / all * (high - low), 1.0 / d);
}

static struct stage measure_stage(const struct reference *reference, const struct view *view)
{
    static const double shear_twice[STRESS] = {1.0, 1.0, 1.0, 2.0};
    const struct problem *const p = reference->problem;
    const size_t n = view->set.count;
    const double *const stress = view->set.stress;
    const double of_yield = 100.0 / p->yield;
    const double of_face = 100.0 / fabs(polar_at(reference, p->inner).u);
    return (struct stage){
        .stress = of_yield *
                  error_norms(n, STRESS, shear_twice, view->mass, stress, view->exact_stress).l2,
        .away = of_yield *
                error_norms(n, STRESS, shear_twice, view->inside, stress, view->exact_stress).l2,
        .displacement =
            of_face * error_norms(n, AXES, NULL, view->mass, view->moved, view->exact_moved).l2,
        .front = 100.0 * front_of(p, view) / reference->front,
    };
}

static enum mpm_status write_state(struct measurement *m, const struct reference *reference,
                                   const struct view *view, size_t stage, struct mpm_error *error)
{
    const struct problem *const p = reference->problem;
    struct follow_rows rows = {.columns = COLUMNS};
    for (size_t k = 0; k < view->set.count; k++) {
        const double *const place = view->set.start + AXES * k;
        const double *const s = view->set.stress + STRESS * k;
        const double r = radius_of(p, place), c = p->shell == TUBE ? 1.0 : place[0] / r;
        const double d = p->shell == TUBE ? 0.0 : place[1] / r;
        const struct polar exact = polar_at(reference, r);
        const double across = s[0] * d * d + s[1] * c * c - 2.0 * s[3] * c * d;
        const double row[COLUMNS] = {r,
                                     s[0] * c * c + s[1] * d * d + 2.0 * s[3] * c * d,
                                     p->shell == TUBE ? s[2] : across,
                                     view->plastic[k],
                                     exact.rr,
                                     exact.tt};
        follow_rows_add(&rows, row);
    }
    char *const name = g_strdup_printf("state_%zu", stage + 1);
    enum mpm_status status = follow_rows_check(&rows, error);
    if (status == MPM_OK)
        status = measurement_series(m, name, "r rr tt plastic exact_rr exact_tt", COLUMNS,
                                    rows.count, rows.values, error);
    g_free(name);
    follow_rows_free(&rows);
    return status;
}

/* --------------------------------------------------------------------- running */

static enum mpm_status run_stages(struct study *study, struct measurement *m,
                                  struct mpm_simulation *simulation, struct reference *reference,
                                  struct view *view, struct mpm_error *error)
{
    const struct problem *const p = study->problem;
    struct mpm_ledger start, now;
    double work = (double)NAN;
    mpm_simulation_ledger(simulation, &start);
    now = start;
    study->finished = true;
    for (size_t k = 0; k < p->stages && study->finished; k++) {
        TRY(follow_to(m, simulation, p->times[k], &study->finished, error));
        TRY(load_reference(reference, k, error));
        read_view(view, reference, simulation);
        study->stage[k] = measure_stage(reference, view);
        mpm_simulation_ledger(simulation, &now);
        if (k == p->peak)
            work = now.external_work;
        if (study->last && study->finished)
            TRY(write_state(m, reference, view, k, error));
    }
    study->balance = 100.0 * fabs(now.total_energy - start.total_energy - now.external_work) / work;
    follow_count_work(m, simulation);
    return MPM_OK;
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    struct reference reference = open_reference(study->problem);
    struct view view = {0};
    (void)scene;
    enum mpm_status status = open_view(study->problem, simulation, &view, error);
    if (status == MPM_OK)
        status = run_stages(study, m, simulation, &reference, &view, error);
    close_view(&view);
    plastic_tube_free(reference.tube);
    return status;
}

static enum mpm_status read_problem(const struct measurement *m, struct problem *problem,
                                    struct mpm_error *error)
{
    size_t place, count;
    unsigned peak;
    const struct measurement_parameter list[] = {
        {"inner", &problem->inner},     {"outer", &problem->outer}, {"young", &problem->young},
        {"poisson", &problem->poisson}, {"yield", &problem->yield},
    };
    TRY(measurement_choice(m, "shell", shell_names, SHELLS, &place, error));
    problem->shell = (enum shell)place;
    TRY(measurement_numbers(m, list, G_N_ELEMENTS(list), error));
    TRY(measurement_list(m, "times", STAGES_MAX, problem->times, &problem->stages, error));
    TRY(measurement_list(m, "pressures", STAGES_MAX, problem->pressures, &count, error));
    if (count != problem->stages)
        return failure_set(error, MPM_BAD_INPUT, "%zu times and %zu pressures; allowed: as many",
                           problem->stages, count);
    TRY(measurement_count(m, "peak", 1, (unsigned)count, &peak, error));
    problem->peak = peak - 1;
    return MPM_OK;
}

/* ------------------------------------------------------------------- reporting */

static void report_stage(struct measurement *m, const struct stage *stage, size_t place,
                         double missing)
{
    char *const suffix = g_strdup_printf("_%zu", place + 1);
    levels_report_value(m, "stress_l2", suffix, missing + stage->stress);
    levels_report_value(m, "away_l2", suffix, missing + stage->away);
    levels_report_value(m, "displacement_l2", suffix, missing + stage->displacement);
    if (!isnan(stage->front))
        levels_report_value(m, "front", suffix, missing + stage->front);
    g_free(suffix);
}

/* Orders of each error, for each stage. */
static enum mpm_status report_orders(struct measurement *m, const struct levels *levels,
                                     size_t stages, const struct study *runs,
                                     struct mpm_error *error)
{
    static const char *const names[] = {"stress", "away", "displacement"};
    for (size_t k = 0; k < stages; k++)
        for (size_t kind = 0; kind < G_N_ELEMENTS(names); kind++) {
            double errors[LEVELS_MAX] = {0.0};
            for (size_t level = 0; level < levels->count; level++) {
                const struct stage *const s = &runs[level].stage[k];
                const double values[] = {s->stress, s->away, s->displacement};
                errors[level] = (runs[level].finished ? 0.0 : (double)NAN) + values[kind];
            }
            char *const suffix = g_strdup_printf("_%s_%zu", names[kind], k + 1);
            const enum mpm_status status = levels_report(m, levels, suffix, errors, error);
            g_free(suffix);
            TRY(status);
        }
    return MPM_OK;
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct problem problem = {.shell = SPHERE};
    struct levels levels;
    struct study runs[LEVELS_MAX] = {{.finished = false}};
    TRY(read_problem(m, &problem, error));
    TRY(levels_read(m, &levels, error));
    const size_t count = levels_runs(&levels);
    for (size_t k = 0; k < count; k++) {
        runs[k] = (struct study){.problem = &problem, .last = k + 1 == count};
        TRY(follow_scene(m, &levels.setting[k], levels.count > 0 ? 1 : 0, measure, &runs[k],
                         error));
    }
    const struct study *const last = &runs[count - 1];
    const double missing = last->finished ? 0.0 : (double)NAN;
    for (size_t k = 0; k < problem.stages; k++)
        report_stage(m, &last->stage[k], k, missing);
    levels_report_value(m, "balance", "", missing + last->balance);
    measurement_report(m, "finished", last->finished ? 1.0 : 0.0);
    return levels.count > 0 ? report_orders(m, &levels, problem.stages, runs, error) : MPM_OK;
}

const struct measure_program program_pressed_shell = {
    .name = "pressed_shell",
    .summary = "a sphere or tube beyond yield under inner pressure, and what is left of it",
    .run = run,
};

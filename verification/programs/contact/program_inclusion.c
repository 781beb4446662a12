/* C7: an inclusion with an imperfect interface in a matrix, against the exact state of rest
 * (inclusion.h).
 *
 * The scene has a part of a block with the inclusion's centre at the origin, on planes of symmetry
 * or r = 0: body 0 is the inclusion, body 1 the matrix. The nodes of its first two conditions are
 * those on the block's outer sides. They get the exact displacement A x + B x/r^d of their places,
 * at the rate (1 - cos(2 pi t/rise))/rise, so that the exact state of the block is that of a round
 * matrix of any size; these settings come from here. Then the scene runs to rest.
 *
 * Parameters: dimensions: 2 (plane strain) or 3 (axisymmetric); radius; outer, displacement: u at
 * r = outer; bulk_1, shear_1 of the inclusion and bulk_2, shear_2 of the matrix; stiffness (D) of
 * the interface; rise.
 *
 * In each body the exact form of the displacement, with a free factor for each term, is fitted to
 * all particles by least squares: a r inside, A r + B/r^(d-1) around. Reports
 *   jump               % of the exact one: that of both fits at r = R
 *   stress             % of the exact one in the inclusion: mean of the normal components
 *   modulus            % of k_eq: that mean over d u(R)/R of the fit around
 *   modulus_error      the distance of that from 100 %
 *   stored             % of area s^2/(2 D): the history's energy
 *   force              % of the exact resultant on the inclusion: the history's force of contact
 *   inside_error       root mean square of sigma - s 1 in the inclusion, % of s
 *   matrix_error       root mean square error of the stress around, % of that of the exact stress
 *   away_error         the same at r > 3/2 R
 *   displacement_error root mean square error, % of that of the exact displacement
 *   stiff              % of the nodes of the interface that are stiffer than an explicit step
 * allows and finished; with level_1, ... (levels.h) orders of displacement_error,
 * inside_error and matrix_error, with _displacement, ... behind their names.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/contact/inclusion.h"
#include "verification/measures/error_norms.h"
#include "verification/measures/particle_set.h"
#include "verification/programs/contact/contact_history.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"
#include "verification/programs/picture.h"

#include <glib.h>
#include <math.h>

enum { AXES = 2, STRESS = 4, BODIES = 2, COLUMNS = 7, LOADED = 2 };

struct parameters {
    struct inclusion inclusion;
    double rise;
};

/* What one run has. */
struct outcome {
    double inside_fit[2], terms[2]; /* a; A and B/R^d */
    double stress;                  /* mean in the inclusion */
    double inside, matrix, away, displacement;
    double stored, force, stiff;
    bool finished;
};

struct study {
    struct parameters p;
    bool last;
    struct outcome now;
};

static enum mpm_status read_parameters(const struct measurement *m, struct parameters *p,
                                       struct mpm_error *error)
{
    static const char *const names[] = {"2", "3"};
    size_t choice;
    struct inclusion *const c = &p->inclusion;
    const struct measurement_parameter table[] = {
        {"radius", &c->radius},    {"outer", &c->outer},    {"displacement", &c->displacement},
        {"bulk_1", &c->bulk[0]},   {"bulk_2", &c->bulk[1]}, {"shear_1", &c->shear[0]},
        {"shear_2", &c->shear[1]}, {"rise", &p->rise},      {"stiffness", &c->interface},
    };
    TRY(measurement_numbers(m, table, G_N_ELEMENTS(table), error));
    TRY(measurement_choice(m, "dimensions", names, G_N_ELEMENTS(names), &choice, error));
    c->dimensions = choice == 0 ? 2 : 3;
    return MPM_OK;
}

/* ------------------------------------------------------------ the conditions */

/* A and B of the matrix, from the exact displacement at two radii. */
static void exact_terms(const struct inclusion *c, double terms[2])
{
    const double low = 1.25 * c->radius, high = 2.0 * c->radius;
    const double power[2] = {pow(low, c->dimensions), pow(high, c->dimensions)};
    const double ratio[2] = {inclusion_state(c, low).u / low, inclusion_state(c, high).u / high};
    terms[1] = (ratio[0] - ratio[1]) / (1.0 / power[0] - 1.0 / power[1]);
    terms[0] = ratio[0] - terms[1] / power[0];
}

/* The settings that load the outer sides; free each. */
static void make_settings(const struct parameters *p, char *settings[LOADED])
{
    const char *const x = p->inclusion.dimensions == 2 ? "x" : "r";
    const char *const y = p->inclusion.dimensions == 2 ? "y" : "z";
    const char *const root = p->inclusion.dimensions == 2 ? "1" : "sqrt(r*r + z*z)";
    double terms[2];
    exact_terms(&p->inclusion, terms);
    char *const factor =
        g_strdup_printf("(%.17g + %.17g/((%s*%s + %s*%s)*%s))*(t < %.17g ? "
                        "(1 - cos(2*pi*t/%.17g))/%.17g : 0)",
                        terms[0], terms[1], x, x, y, y, root, p->rise, p->rise, p->rise);
    for (int k = 0; k < LOADED; k++)
        settings[k] =
            g_strdup_printf("boundary.%d.velocity=[\"%s*%s\", \"%s*%s\"]", k, x, factor, y, factor);
    g_free(factor);
}

/* --------------------------------------------------------------- the fields */

/* A body's particles and what they should have. */
struct view {
    struct particle_set set;
    double *mass, *radius, *moved, *exact_moved, *exact_stress;
};

static enum mpm_status open_view(const struct mpm_simulation *simulation, size_t body,
                                 struct view *view, struct mpm_error *error)
{
    TRY(particle_set_create(simulation, body, &view->set, error));
    const size_t n = view->set.count;
    view->mass = g_new(double, n);
    view->radius = g_new(double, n);
    view->moved = g_new(double, AXES *n);
    view->exact_moved = g_new(double, AXES *n);
    view->exact_stress = g_new0(double, STRESS *n);
    return MPM_OK;
}

static void close_view(struct view *view)
{
    particle_set_free(&view->set);
    g_free(view->mass);
    g_free(view->radius);
    g_free(view->moved);
    g_free(view->exact_moved);
    g_free(view->exact_stress);
}

/* At particle `k`; the stress along z is no part of a plane state. */
static void set_exact(struct view *view, const struct inclusion *c, size_t k)
{
    const double *const x = view->set.start + AXES * k;
    const double r = view->radius[k], n[AXES] = {x[0] / r, x[1] / r};
    const struct inclusion_state exact = inclusion_state(c, r);
    double *const stress = &view->exact_stress[STRESS * k];
    for (int axis = 0; axis < AXES; axis++) {
        view->exact_moved[AXES * (int)k + axis] = exact.u * n[axis];
        stress[axis] = exact.tt + (exact.rr - exact.tt) * n[axis] * n[axis];
    }
    stress[2] = c->dimensions == 3 ? exact.tt : 0.0;
    stress[3] = (exact.rr - exact.tt) * n[0] * n[1];
}

static void read_view(struct view *view, const struct inclusion *c,
                      const struct mpm_simulation *simulation)
{
    struct particle_set *const set = &view->set;
    particle_set_read(set, simulation);
    mpm_simulation_field(simulation, MPM_FIELD_MASS, set->all);
    for (size_t k = 0; k < set->count; k++) {
        view->mass[k] = set->all[set->index[k]];
        view->radius[k] = hypot(set->start[AXES * k], set->start[AXES * k + 1]);
        for (size_t axis = 0; axis < AXES; axis++)
            view->moved[AXES * k + axis] =
                set->position[AXES * k + axis] - set->start[AXES * k + axis];
        set_exact(view, c, k);
    }
}

static double moved_outwards(const struct view *view, size_t k)
{
    return (view->moved[AXES * k] * view->set.start[AXES * k] +
            view->moved[AXES * k + 1] * view->set.start[AXES * k + 1]) /
           view->radius[k];
}

/* Factors of r and, with two terms, of R^d/r^(d-1) by least squares: both of one size. */
static void fit(const struct view *view, const struct inclusion *c, int terms, double factor[2])
{
    double matrix[2][2] = {{0.0}}, right[2] = {0.0};
    for (size_t k = 0; k < view->set.count; k++) {
        const double r = view->radius[k];
        const double term[2] = {r, r * pow(c->radius / r, c->dimensions)};
        for (int i = 0; i < 2; i++) {
            right[i] += view->mass[k] * term[i] * moved_outwards(view, k);
            for (int j = 0; j < 2; j++)
                matrix[i][j] += view->mass[k] * term[i] * term[j];
        }
    }
    const double whole = matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0];
    factor[0] = right[0] / matrix[0][0];
    factor[1] = 0.0;
    if (terms == 1)
        return;
    factor[0] = (right[0] * matrix[1][1] - right[1] * matrix[0][1]) / whole;
    factor[1] = (matrix[0][0] * right[1] - matrix[1][0] * right[0]) / whole;
}

static double mean_stress(const struct view *view, const struct inclusion *c)
{
    double sum = 0.0, mass = 0.0;
    for (size_t k = 0; k < view->set.count; k++)
        for (int axis = 0; axis < c->dimensions; axis++) {
            sum += view->mass[k] * view->set.stress[STRESS * (int)k + axis];
            mass += view->mass[k];
        }
    return sum / mass;
}

/* Relative, of particles with r >= from. */
static double stress_error(const struct view *view, const struct inclusion *c, double from)
{
    const double multiple[STRESS] = {1.0, 1.0, c->dimensions == 3 ? 1.0 : 0.0, 2.0};
    double *const weight = g_new0(double, view->set.count);
    for (size_t k = 0; k < view->set.count; k++)
        if (view->radius[k] >= from)
            weight[k] = view->mass[k];
    const struct error_norms norms = error_norms(view->set.count, STRESS, multiple, weight,
                                                 view->set.stress, view->exact_stress);
    g_free(weight);
    return error_norms_relative(&norms);
}

/* Of both bodies. */
static double displacement_error(const struct view views[BODIES])
{
    double error = 0.0, exact = 0.0;
    for (int body = 0; body < BODIES; body++)
        for (size_t k = 0; k < AXES * views[body].set.count; k++) {
            const double by = views[body].moved[k] - views[body].exact_moved[k];
            error += views[body].mass[k / AXES] * by * by;
            exact += views[body].mass[k / AXES] * views[body].exact_moved[k] *
                     views[body].exact_moved[k];
        }
    return sqrt(error / exact);
}

/* Displacement and stress along the radius and around it, with the exact ones. */
static enum mpm_status write_radial(struct measurement *m, const struct view views[BODIES],
                                    const struct inclusion *c, struct mpm_error *error)
{
    struct follow_rows rows = {.columns = COLUMNS};
    for (int body = 0; body < BODIES; body++)
        for (size_t k = 0; k < views[body].set.count; k++) {
            const double *const x = views[body].set.start + AXES * k;
            const double *const s = views[body].set.stress + STRESS * k;
            const double r = views[body].radius[k], n[AXES] = {x[0] / r, x[1] / r};
            const struct inclusion_state exact = inclusion_state(c, r);
            const double rr = s[0] * n[0] * n[0] + s[1] * n[1] * n[1] + 2.0 * s[3] * n[0] * n[1];
            const double row[COLUMNS] = {
                r,       moved_outwards(&views[body], k), rr, s[0] + s[1] - rr, exact.u, exact.rr,
                exact.tt};
            follow_rows_add(&rows, row);
        }
    enum mpm_status status = follow_rows_check(&rows, error);
    if (status == MPM_OK)
        status = measurement_series(m, "radial", "r u rr tt exact_u exact_rr exact_tt", COLUMNS,
                                    rows.count, rows.values, error);
    follow_rows_free(&rows);
    return status;
}

/* ------------------------------------------------------------------ running */

static enum mpm_status measure_interface(struct outcome *now, const struct mpm_scene *scene,
                                         const struct mpm_simulation *simulation, int axis,
                                         struct mpm_error *error)
{
    size_t index;
    TRY(contact_history_find(scene, 0, 1, axis == 0 ? "force_x" : "force_y", &index, error));
    now->force = mpm_simulation_contact_quantity(simulation, index);
    now->stored = contact_history_sum(scene, simulation, "stored");
    now->stiff = contact_history_sum(scene, simulation, "stiff_nodes") /
                 contact_history_sum(scene, simulation, "nodes");
    return MPM_OK;
}

static void measure_fields(struct study *study, struct view views[BODIES],
                           const struct mpm_simulation *simulation)
{
    const struct inclusion *const c = &study->p.inclusion;
    struct outcome *const now = &study->now;
    for (int body = 0; body < BODIES; body++)
        read_view(&views[body], c, simulation);
    fit(&views[0], c, 1, now->inside_fit);
    fit(&views[1], c, 2, now->terms);
    now->stress = mean_stress(&views[0], c);
    now->inside = stress_error(&views[0], c, 0.0);
    now->matrix = stress_error(&views[1], c, 0.0);
    now->away = stress_error(&views[1], c, 1.5 * c->radius);
    now->displacement = displacement_error(views);
}

static enum mpm_status draw(struct measurement *m, const struct inclusion *c,
                            const struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct picture picture;
    bool asked;
    TRY(picture_read(m, &picture, &asked, error));
    picture.axisymmetric = c->dimensions == 3;
    picture.aspect = 1.0;
    return asked ? picture_write(m, &picture, simulation, MPM_FIELD_STRESS, 0, "stress", error)
                 : MPM_OK;
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    const struct inclusion *const c = &study->p.inclusion;
    struct view views[BODIES] = {{.mass = NULL}};
    enum mpm_status status = MPM_OK;
    for (size_t body = 0; body < BODIES && status == MPM_OK; body++)
        status = open_view(simulation, body, &views[body], error);
    if (status == MPM_OK)
        status =
            follow_to_rest(m, simulation, mpm_scene_end_time(scene), &study->now.finished, error);
    if (status == MPM_OK) {
        measure_fields(study, views, simulation);
        status =
            measure_interface(&study->now, scene, simulation, c->dimensions == 2 ? 0 : 1, error);
    }
    if (status == MPM_OK && study->last)
        status = write_radial(m, views, c, error);
    if (status == MPM_OK && study->last)
        status = draw(m, c, simulation, error);
    for (int body = 0; body < BODIES; body++)
        close_view(&views[body]);
    return status;
}

/* ---------------------------------------------------------------- reporting */

/* The matrix's displacement at r = R, by its fit. */
static double matrix_at_interface(const struct study *study)
{
    return study->p.inclusion.radius * (study->now.terms[0] + study->now.terms[1]);
}

static double jump_of(const struct study *study)
{
    return matrix_at_interface(study) - study->now.inside_fit[0] * study->p.inclusion.radius;
}

/* Of the quarter of a cylinder of thickness 1, or of half a sphere per radian. */
static double interface_area(const struct inclusion *c)
{
    return c->dimensions == 2 ? 0.5 * G_PI * c->radius : c->radius * c->radius;
}

/* Of its projection along the force of the history. */
static double projected_area(const struct inclusion *c)
{
    return c->dimensions == 2 ? c->radius : 0.5 * c->radius * c->radius;
}

/* What has an order over the levels: errors over the field, and not those of two numbers, which
 * change their sign. */
enum quantity { MOVED, INSIDE, AROUND, QUANTITIES };
static const char *const suffixes[QUANTITIES] = {"_displacement", "_inside", "_matrix"};

static void find_errors(const struct study *study, double errors[QUANTITIES])
{
    const double missing = study->now.finished ? 0.0 : (double)NAN;
    errors[MOVED] = missing + 100.0 * study->now.displacement;
    errors[INSIDE] = missing + 100.0 * study->now.inside;
    errors[AROUND] = missing + 100.0 * study->now.matrix;
}

static void report(struct measurement *m, const struct study *study)
{
    const struct inclusion *const c = &study->p.inclusion;
    const struct outcome *const now = &study->now;
    const double stress = inclusion_state(c, c->radius).rr, jump = jump_of(study);
    const double modulus = now->stress / (c->dimensions * matrix_at_interface(study) / c->radius);
    double errors[QUANTITIES];
    find_errors(study, errors);
    const struct {
        const char *name;
        double value;
    } table[] = {
        {"jump", 100.0 * jump * c->interface / stress},
        {"stress", 100.0 * now->stress / stress},
        {"modulus", 100.0 * modulus / inclusion_effective_modulus(c)},
        {"modulus_error", 100.0 * fabs(modulus / inclusion_effective_modulus(c) - 1.0)},
        {"stored",
         100.0 * now->stored * 2.0 * c->interface / (interface_area(c) * stress * stress)},
        {"force", 100.0 * now->force / (projected_area(c) * stress)},
        {"displacement_error", errors[MOVED]},
        {"inside_error", errors[INSIDE]},
        {"matrix_error", errors[AROUND]},
        {"away_error", 100.0 * now->away},
        {"stiff", 100.0 * now->stiff},
    };
    measurement_report(m, "finished", now->finished ? 1.0 : 0.0);
    for (size_t k = 0; k < G_N_ELEMENTS(table); k++)
        if (now->finished)
            measurement_report(m, table[k].name, table[k].value);
        else
            measurement_inconclusive(m, table[k].name, "the run did not come to its end");
}

static void note_run(struct measurement *m, const struct study *study, size_t number)
{
    const struct inclusion *const c = &study->p.inclusion;
    const double stress = inclusion_state(c, c->radius).rr;
    double errors[QUANTITIES];
    find_errors(study, errors);
    measurement_note(m,
                     "run %zu: jump %.4g %%, stress inside %.4g %%; errors in %% of displacement "
                     "%.4g, stress of particles inside %.4g, around %.4g",
                     number, 100.0 * jump_of(study) * c->interface / stress,
                     100.0 * study->now.stress / stress, errors[MOVED], errors[INSIDE],
                     errors[AROUND]);
}

static enum mpm_status run_level(struct study *study, struct measurement *m, const char *level,
                                 struct mpm_error *error)
{
    char *loads[LOADED];
    make_settings(&study->p, loads);
    const char *const settings[LOADED + 1] = {loads[0], loads[1], level};
    study->now = (struct outcome){.finished = false};
    const enum mpm_status status =
        follow_scene(m, settings, level == NULL ? LOADED : LOADED + 1, measure, study, error);
    for (int k = 0; k < LOADED; k++)
        g_free(loads[k]);
    return status;
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct study study = {.last = false};
    struct levels levels;
    double errors[QUANTITIES][LEVELS_MAX] = {{0.0}};
    TRY(read_parameters(m, &study.p, error));
    TRY(levels_read(m, &levels, error));
    for (size_t k = 0; k < levels_runs(&levels); k++) {
        double found[QUANTITIES];
        study.last = k + 1 == levels_runs(&levels);
        TRY(run_level(&study, m, levels.count > 0 ? levels.setting[k] : NULL, error));
        find_errors(&study, found);
        for (int q = 0; q < QUANTITIES; q++)
            errors[q][k] = found[q];
        note_run(m, &study, k + 1);
    }
    report(m, &study);
    for (int q = 0; levels.count > 0 && q < QUANTITIES; q++)
        TRY(levels_report(m, &levels, suffixes[q], errors[q], error));
    return MPM_OK;
}

const struct measure_program program_inclusion = {
    .name = "inclusion",
    .summary = "an inclusion with an imperfect interface: jump, stress, field around",
    .run = run,
};

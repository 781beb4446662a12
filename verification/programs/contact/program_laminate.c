/* C6: two layers with an imperfect interface under load, against the sum of their compliances
 * (laminate.h).
 *
 * The scene runs to rest. In each layer a linear displacement u + B (x - x_0) is fitted to all
 * particles by least squares, x_0 being a point of the interface: the exact solution is linear.
 * The jump at x_0 is the interface's; B along the normal is the layers'.
 *
 * Parameters: length_1, length_2, modulus_1, modulus_2 and `stiffness` (D), of the component
 * `mode`: normal or shear; angle (degrees) of the normal from the first layer to the second; x, y
 * of x_0; traction on that component; area of the interface; particles belong to the first layer
 * if they start before it.
 * Reports
 *   modulus            % of the exact effective modulus
 *   interface          % of D: traction over jump
 *   stored             % of area t^2/(2 D)
 *   force              % of area t: the history's force of contact along the component
 *   stiff              % of the nodes of the interface that are stiffer than an explicit step
 * finished, and with level_1, ... (levels.h) orders of the error of the modulus. Draws
 * `displacement`: along the component, of each particle, over its place along the normal.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/contact/laminate.h"
#include "verification/programs/contact/contact_history.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>

enum { AXES = 2, STRESS = 4, LAYERS = 2, UNKNOWNS = 3, PLACE_COLUMNS = 3 };

struct parameters {
    struct laminate laminate;
    double angle, origin[AXES], traction, area;
    double normal[AXES], along[AXES]; /* `along`: the component */
};

struct study {
    struct parameters p;
    double fit[LAYERS][AXES][UNKNOWNS]; /* u, du/dx, du/dy of each component */
    double stress_error;                /* root mean square of the component's stress less t */
    double stored, force, stiff;
    struct follow_rows places; /* of the last run: place along the normal, displacement, exact */
    bool finished;
};

static enum mpm_status read_parameters(const struct measurement *m, struct parameters *p,
                                       struct mpm_error *error)
{
    static const char *const modes[] = {"normal", "shear"};
    size_t mode;
    const struct measurement_parameter table[] = {
        {"length_1", &p->laminate.length[0]},
        {"length_2", &p->laminate.length[1]},
        {"modulus_1", &p->laminate.modulus[0]},
        {"modulus_2", &p->laminate.modulus[1]},
        {"stiffness", &p->laminate.interface},
        {"angle", &p->angle},
        {"x", &p->origin[0]},
        {"y", &p->origin[1]},
        {"traction", &p->traction},
        {"area", &p->area},

    };
    TRY(measurement_numbers(m, table, sizeof table / sizeof *table, error));
    TRY(measurement_choice(m, "mode", modes, G_N_ELEMENTS(modes), &mode, error));
    p->normal[0] = cos(p->angle * G_PI / 180.0);
    p->normal[1] = sin(p->angle * G_PI / 180.0);
    p->along[0] = mode == 0 ? p->normal[0] : p->normal[1];
    p->along[1] = mode == 0 ? p->normal[1] : -p->normal[0];
    return MPM_OK;
}

/* --------------------------------------------------------------------- fits */

/* Sums for a line of least squares in two dimensions. */
struct sums {
    double matrix[UNKNOWNS][UNKNOWNS], right[AXES][UNKNOWNS];
};

static void add_to_sums(struct sums *sums, const double place[AXES], const double u[AXES])
{
    const double terms[UNKNOWNS] = {1.0, place[0], place[1]};
    for (int i = 0; i < UNKNOWNS; i++) {
        for (int j = 0; j < UNKNOWNS; j++)
            sums->matrix[i][j] += terms[i] * terms[j];
        for (int axis = 0; axis < AXES; axis++)
            sums->right[axis][i] += terms[i] * u[axis];
    }
}

static double determinant(double m[UNKNOWNS][UNKNOWNS])
{
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/* By Cramer's rule; NaN where all particles are on one line. */
static void solve(struct sums *sums, double fit[AXES][UNKNOWNS])
{
    const double whole = determinant(sums->matrix);
    for (int axis = 0; axis < AXES; axis++)
        for (int k = 0; k < UNKNOWNS; k++) {
            double replaced[UNKNOWNS][UNKNOWNS];
            for (int i = 0; i < UNKNOWNS; i++)
                for (int j = 0; j < UNKNOWNS; j++)
                    replaced[i][j] = j == k ? sums->right[axis][i] : sums->matrix[i][j];
            fit[axis][k] = determinant(replaced) / whole;
        }
}

static double dot(const double a[AXES], const double b[AXES])
{
    return a[0] * b[0] + a[1] * b[1];
}

/* The component's stress on the interface's plane. */
static double traction_of(const struct parameters *p, const double *stress)
{
    const double t[AXES] = {stress[0] * p->normal[0] + stress[3] * p->normal[1],
                            stress[3] * p->normal[0] + stress[1] * p->normal[1]};
    return dot(t, p->along);
}

/* A particle's row of the series; `place` is from the interface's point. */
static void add_place(struct study *study, const double place[AXES], const double u[AXES])
{
    const struct parameters *const p = &study->p;
    const double along_normal = p->laminate.length[0] + dot(place, p->normal);
    follow_rows_add(&study->places,
                    (const double[PLACE_COLUMNS]){
                        along_normal, dot(u, p->along),
                        laminate_displacement(&p->laminate, p->traction, along_normal)});
}

static void measure_fields(struct study *study, const struct mpm_simulation *simulation,
                           const double *start)
{
    const struct parameters *const p = &study->p;
    const size_t count = mpm_simulation_particle_count(simulation);
    struct sums sums[LAYERS] = {{.matrix = {{0.0}}}};
    double square = 0.0;
    double *const position = g_new(double, AXES *count), *const stress =
                                                             g_new(double, STRESS *count);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, position);
    mpm_simulation_field(simulation, MPM_FIELD_STRESS, stress);
    study->places.count = 0;
    for (size_t k = 0; k < count; k++) {
        const double *const now = &position[AXES * k], *const then = &start[AXES * k];
        const double place[AXES] = {then[0] - p->origin[0], then[1] - p->origin[1]};
        const double u[AXES] = {now[0] - then[0], now[1] - then[1]};
        const double error = traction_of(p, &stress[STRESS * k]) - p->traction;
        add_to_sums(&sums[dot(place, p->normal) > 0.0], place, u);
        add_place(study, place, u);
        square += error * error;
    }
    study->stress_error = sqrt(square / (double)count);
    for (int layer = 0; layer < LAYERS; layer++)
        solve(&sums[layer], study->fit[layer]);
    g_free(position);
    g_free(stress);
}

/* ------------------------------------------------------------------ running */

static enum mpm_status measure_interface(struct study *study, const struct mpm_scene *scene,
                                         const struct mpm_simulation *simulation,
                                         struct mpm_error *error)
{
    const struct parameters *const p = &study->p;
    static const char *const names[AXES] = {"force_x", "force_y"};
    study->force = 0.0;
    for (int axis = 0; axis < AXES; axis++) {
        size_t index;
        TRY(contact_history_find(scene, 0, 1, names[axis], &index, error));
        study->force += p->along[axis] * mpm_simulation_contact_quantity(simulation, index);
    }
    study->stored = contact_history_sum(scene, simulation, "stored");
    study->stiff = contact_history_sum(scene, simulation, "stiff_nodes") /
                   contact_history_sum(scene, simulation, "nodes");
    return MPM_OK;
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    double *const start = g_new(double, AXES *mpm_simulation_particle_count(simulation));
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, start);
    enum mpm_status status =
        follow_to_rest(m, simulation, mpm_scene_end_time(scene), &study->finished, error);
    if (status == MPM_OK)
        measure_fields(study, simulation, start);
    if (status == MPM_OK)
        status = measure_interface(study, scene, simulation, error);
    g_free(start);
    return status;
}

/* ---------------------------------------------------------------- reporting */

/* Of the interface, along a direction: the second layer's less the first one's. */
static double jump_along(const struct study *study, const double direction[AXES])
{
    const double jump[AXES] = {study->fit[1][0][0] - study->fit[0][0][0],
                               study->fit[1][1][0] - study->fit[0][1][0]};
    return dot(jump, direction);
}

/* What the layers contribute to the displacement of one end against the other. */
static double layers_of(const struct study *study)
{
    double sum = 0.0;
    for (int layer = 0; layer < LAYERS; layer++) {
        double u[AXES]; /* over the length along the normal */
        for (int axis = 0; axis < AXES; axis++)
            u[axis] = dot(&study->fit[layer][axis][1], study->p.normal);
        sum += study->p.laminate.length[layer] * dot(u, study->p.along);
    }
    return sum;
}

static double modulus_of(const struct study *study)
{
    const struct parameters *const p = &study->p;
    return p->traction * (p->laminate.length[0] + p->laminate.length[1]) /
           (layers_of(study) + jump_along(study, p->along));
}

static void report(struct measurement *m, const struct study *study)
{
    const struct parameters *const p = &study->p;
    const struct laminate *const laminate = &p->laminate;
    const struct laminate bonded = {{laminate->length[0], laminate->length[1]},
                                    {laminate->modulus[0], laminate->modulus[1]},
                                    (double)INFINITY};
    const double length = laminate->length[0] + laminate->length[1];
    const double jump = jump_along(study, p->along);
    const double across[AXES] = {-p->along[1], p->along[0]};
    const struct {
        const char *name;
        double value;
    } table[] = {
        {"modulus", 100.0 * modulus_of(study) / laminate_modulus(laminate)},
        {"interface", 100.0 * p->traction / jump / laminate->interface},
        {"stored", 100.0 * study->stored / (p->area * laminate_stored(laminate, p->traction))},
        {"force", 100.0 * study->force / (p->area * p->traction)},
        {"stiff", 100.0 * study->stiff},
    };
    measurement_report(m, "finished", study->finished ? 1.0 : 0.0);
    measurement_note(
        m, "layers %.5g %%, jump across the component %.3g of that along it, stress %.3g %%",
        100.0 * p->traction * length / layers_of(study) / laminate_modulus(&bonded),
        fabs(jump_along(study, across) / jump), 100.0 * study->stress_error / fabs(p->traction));
    for (size_t k = 0; k < G_N_ELEMENTS(table); k++)
        if (study->finished)
            measurement_report(m, table[k].name, table[k].value);
        else
            measurement_inconclusive(m, table[k].name, "the run did not come to its end");
}

static enum mpm_status run_levels(struct study *study, struct measurement *m,
                                  struct mpm_error *error)
{
    struct levels levels;
    double errors[LEVELS_MAX] = {0.0};
    TRY(levels_read(m, &levels, error));
    for (size_t k = 0; k < levels_runs(&levels); k++) {
        TRY(follow_scene(m, &levels.setting[k], levels.count == 0 ? 0 : 1, measure, study, error));
        errors[k] =
            study->finished
                ? 100.0 * fabs(modulus_of(study) / laminate_modulus(&study->p.laminate) - 1.0)
                : (double)NAN;
        measurement_note(m, "level %zu: error of the modulus %.4g %%", k + 1, errors[k]);
    }
    report(m, study);
    return levels.count > 0 ? levels_report(m, &levels, "", errors, error) : MPM_OK;
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct study study = {.places.columns = PLACE_COLUMNS, .finished = false};
    TRY(read_parameters(m, &study.p, error));
    enum mpm_status status = run_levels(&study, m, error);
    if (status == MPM_OK)
        status = follow_rows_check(&study.places, error);
    if (status == MPM_OK)
        status = measurement_series(m, "displacement", "place displacement exact", PLACE_COLUMNS,
                                    study.places.count, study.places.values, error);
    follow_rows_free(&study.places);
    return status;
}

const struct measure_program program_laminate = {
    .name = "laminate",
    .summary = "two layers with an imperfect interface: stiffness, energy",
    .run = run,
};

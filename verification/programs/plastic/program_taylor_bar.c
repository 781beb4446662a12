/* P7: a cylinder hits a wall and mushrooms (Taylor's bar): its final length and radius.
 *
 * The scene has one body whose rows begin at r = 0 and z = 0, and runs to its end. Parameters:
 * radius, length of the undeformed bar; spacing, of the particles, times the cell: 0.5 for two
 * along each axis.
 *
 * Edges of a particle are those of its undeformed rectangle carried by F. Reports
 *   radius, length     largest r and z of an edge, in the scene's unit
 *   radius_step, length_step   their change from the last but one of the levels (levels.h), %
 *   volume             of the deformed bar, % of the undeformed one
 *   separation         largest distance of two particles that were neighbours, in cells
 *   plastic            largest equivalent plastic strain
 *   parted             pairs of neighbours without a common node at the end
 *   dissipated         plastic_dissipation, % of the kinetic energy at the start
 *   balance            change of total_energy, % of it
 *   reached            the time at which the run ended, % of the scene's end
 * and finished. Series: shape (r z plastic of particles), course (time radius length).
 *
 * With measured_length and measured_diameter, final over initial ones of an experiment, and
 * data_uncertainty, of each, %: a comparison after ASME V&V 20 on the levels, as notes and as the
 * series validation. Its rows are length and diameter, its columns
 *   simulated, measured   final over initial
 *   error        E = S - D, % of the measured one
 *   numerical    of the grids, % of the same (grid_uncertainty)
 *   data         data_uncertainty
 *   validation   root of the sum of their squares
 * It is no quantity, as no band rests on an experiment. A run that broke has none.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/grid_convergence.h"
#include "verification/measures/particle_set.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>

enum { AXES = 2, GRADIENT = 5, COURSE = 3, SHAPE = 3, SAMPLES = 40, VALIDATION = 6 };

/* Each level halves the cells; smooth solutions converge with their square. */
static const double HALVED = 2.0, FORMAL_ORDER = 2.0;

struct size {
    double radius, length;
};

/* What an experiment found, final over initial. */
struct experiment {
    double length, diameter;
    double uncertainty; /* of each, % */
};

struct study {
    struct size undeformed;
    struct experiment experiment; /* length NaN: none */
    double spacing;               /* of particles, in cells */
    double distance;              /* of neighbours at t = 0 */
    size_t row;                   /* particles along r */
    struct particle_set set;
    double *f, *plastic;
    struct size size;
    double separation, volume, strain, dissipated, balance, reached, parted;
    bool finished;
    struct follow_rows course;
};

/* ------------------------------------------------------------------- measuring */

static void look_at(void *context, const struct mpm_simulation *simulation,
                    const struct mpm_ledger *ledger)
{
    struct study *const study = context;
    const double half = 0.5 * study->distance;
    particle_set_read(&study->set, simulation);
    mpm_simulation_field(simulation, MPM_FIELD_DEFORMATION_GRADIENT, study->f);
    study->size = (struct size){0.0, 0.0};
    for (size_t k = 0; k < study->set.count; k++) {
        const double *const f = &study->f[GRADIENT * study->set.index[k]];
        const double *const x = study->set.position + AXES * k;
        study->size.radius = fmax(study->size.radius, x[0] + half * (fabs(f[0]) + fabs(f[1])));
        study->size.length = fmax(study->size.length, x[1] + half * (fabs(f[2]) + fabs(f[3])));
    }
    const double row[COURSE] = {ledger->time, study->size.radius, study->size.length};
    follow_rows_add(&study->course, row);
}

static double distance_of(const double *position, size_t one, size_t other)
{
    return hypot(position[AXES * one] - position[AXES * other],
                 position[AXES * one + 1] - position[AXES * other + 1]);
}

/* In cells; rows of particles follow each other. */
static double separation_of(const struct study *study)
{
    double largest = 0.0;
    for (size_t k = 0; k < study->set.count; k++) {
        if ((k + 1) % study->row != 0)
            largest = fmax(largest, distance_of(study->set.position, k, k + 1));
        if (k + study->row < study->set.count)
            largest = fmax(largest, distance_of(study->set.position, k, k + study->row));
    }
    return largest / study->distance * study->spacing;
}

static void read_end(struct study *study, const struct mpm_simulation *simulation,
                     const struct mpm_ledger *start)
{
    const size_t n = study->set.count;
    struct mpm_ledger now;
    double volume = 0.0;
    mpm_simulation_ledger(simulation, &now);
    mpm_simulation_field(simulation, MPM_FIELD_PLASTIC_STRAIN, study->plastic);
    mpm_simulation_field(simulation, MPM_FIELD_VOLUME, study->set.all);
    study->strain = 0.0;
    for (size_t k = 0; k < n; k++) {
        study->strain = fmax(study->strain, study->plastic[study->set.index[k]]);
        volume += study->set.all[study->set.index[k]];
    }
    const struct size *const size = &study->undeformed;
    const double energy = start->kinetic_energy;
    study->volume = 100.0 * volume / (0.5 * size->radius * size->radius * size->length);
    study->separation = separation_of(study);
    study->parted = (double)now.parted_pairs;
    study->dissipated = 100.0 * now.plastic_dissipation / energy;
    study->balance =
        100.0 * fabs(now.total_energy - start->total_energy - now.external_work) / energy;
}

static enum mpm_status write_shape(struct measurement *m, const struct study *study,
                                   struct mpm_error *error)
{
    const size_t n = study->set.count;
    double *const rows = g_new(double, SHAPE *n);
    for (size_t k = 0; k < n; k++) {
        rows[SHAPE * k] = study->set.position[AXES * k];
        rows[SHAPE * k + 1] = study->set.position[AXES * k + 1];
        rows[SHAPE * k + 2] = study->plastic[study->set.index[k]];
    }
    enum mpm_status status = measurement_series(m, "shape", "r z plastic", SHAPE, n, rows, error);
    g_free(rows);
    if (status == MPM_OK)
        status = follow_rows_check(&study->course, error);
    return status != MPM_OK ? status
                            : measurement_series(m, "course", "time radius length", COURSE,
                                                 study->course.count, study->course.values, error);
}

/* --------------------------------------------------------------------- running */

static void close_study(struct study *study)
{
    particle_set_free(&study->set);
    g_free(study->f);
    g_free(study->plastic);
    follow_rows_free(&study->course);
    study->f = study->plastic = NULL;
    study->set = (struct particle_set){0};
    study->course = (struct follow_rows){.columns = COURSE};
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    const double end = mpm_scene_end_time(scene);
    struct mpm_ledger start;
    struct follow_result result;
    const struct follow follow = {.measurement = m,
                                  .end = end,
                                  .interval = end / SAMPLES,
                                  .sample = look_at,
                                  .context = study};
    TRY(particle_set_create(simulation, 0, &study->set, error));
    const size_t n = study->set.count;
    study->f = g_new(double, GRADIENT *n);
    study->plastic = g_new(double, n);
    study->distance = study->set.start[AXES] - study->set.start[0];
    study->row = (size_t)lround(study->undeformed.radius / study->distance);
    mpm_simulation_ledger(simulation, &start);
    TRY(follow_run(&follow, simulation, &result, error));
    study->finished = result.finished;
    study->reached = 100.0 * mpm_simulation_time(simulation) / end;
    read_end(study, simulation, &start);
    return MPM_OK;
}

static double step_of(double last, double before)
{
    return 100.0 * fabs(last / before - 1.0);
}

static void report(struct measurement *m, const struct study *study, const struct size *before,
                   size_t runs)
{
    const double missing = study->finished ? 0.0 : (double)NAN;
    const struct {
        const char *name;
        double value;
    } table[] = {
        {"radius", study->size.radius},
        {"length", study->size.length},
        {"volume", study->volume},
        {"separation", study->separation},
        {"plastic", study->strain},
        {"parted", study->parted},
        {"dissipated", study->dissipated},
        {"balance", study->balance},
        {"radius_step", step_of(study->size.radius, before->radius)},
        {"length_step", step_of(study->size.length, before->length)},
    };
    for (size_t k = 0; k < G_N_ELEMENTS(table) - (runs > 1 ? 0 : 2); k++)
        levels_report_value(m, table[k].name, "", missing + table[k].value);
    measurement_report(m, "reached", study->reached);
    measurement_report(m, "finished", study->finished ? 1.0 : 0.0);
}

/* One row of the comparison; S of the levels. */
static void compare(struct measurement *m, const char *name, size_t count, const double *simulated,
                    double measured, double uncertainty, double row[VALIDATION])
{
    const double last = simulated[count - 1], error = 100.0 * (last / measured - 1.0);
    const double numerical =
        100.0 * grid_uncertainty(count, simulated, HALVED, FORMAL_ORDER) * last / measured;
    const double validation = hypot(numerical, uncertainty);
    const double values[VALIDATION] = {last, measured, error, numerical, uncertainty, validation};
    for (size_t k = 0; k < VALIDATION; k++)
        row[k] = values[k];
    measurement_note(m,
                     "%s over initial: simulated %.4g, measured %.4g, error %.2f %%, numerical "
                     "uncertainty %.2f %%, of data %.2f %%, of validation %.2f %%: %s",
                     name, last, measured, error, numerical, uncertainty, validation,
                     fabs(error) <= validation ? "within" : "beyond");
}

static enum mpm_status validate(struct measurement *m, const struct study *study, size_t count,
                                const struct size *sizes, struct mpm_error *error)
{
    double lengths[LEVELS_MAX] = {0.0}, diameters[LEVELS_MAX] = {0.0}, rows[2 * VALIDATION];
    const struct experiment *const found = &study->experiment;
    for (size_t k = 0; k < count; k++) {
        lengths[k] = sizes[k].length / study->undeformed.length;
        diameters[k] = sizes[k].radius / study->undeformed.radius;
    }
    compare(m, "length", count, lengths, found->length, found->uncertainty, rows);
    compare(m, "diameter", count, diameters, found->diameter, found->uncertainty,
            rows + VALIDATION);
    return measurement_series(m, "validation", "simulated measured error numerical data validation",
                              VALIDATION, 2, rows, error);
}

static enum mpm_status read_parameters(struct measurement *m, struct study *study,
                                       struct mpm_error *error)
{
    struct experiment *const found = &study->experiment;
    const struct measurement_parameter list[] = {{"radius", &study->undeformed.radius},
                                                 {"length", &study->undeformed.length},
                                                 {"spacing", &study->spacing},
                                                 {"measured_length", &found->length},
                                                 {"measured_diameter", &found->diameter},
                                                 {"data_uncertainty", &found->uncertainty}};
    const bool measured = measurement_has(m, "measured_length");
    found->length = (double)NAN;
    return measurement_numbers(m, list, G_N_ELEMENTS(list) - (measured ? 0 : 3), error);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct levels levels;
    struct study study = {.course = {.columns = COURSE}};
    struct size sizes[LEVELS_MAX + 1] = {{(double)NAN, (double)NAN}};
    TRY(read_parameters(m, &study, error));
    TRY(levels_read(m, &levels, error));
    const size_t runs = levels_runs(&levels);
    enum mpm_status status = MPM_OK;
    for (size_t k = 0; k < runs && status == MPM_OK; k++) {
        close_study(&study);
        status =
            follow_scene(m, &levels.setting[k], levels.count > 0 ? 1 : 0, measure, &study, error);
        if (status == MPM_OK)
            measurement_note(m, "grid %zu: radius %.6g, length %.6g%s", k + 1, study.size.radius,
                             study.size.length, study.finished ? "" : ", when it broke");
        sizes[k + 1] = study.finished ? study.size : sizes[0];
    }
    if (status == MPM_OK) {
        report(m, &study, &sizes[runs - 1], runs);
        status = write_shape(m, &study, error);
    }
    if (status == MPM_OK && study.finished && !isnan(study.experiment.length))
        status = validate(m, &study, runs, sizes + 1, error);
    close_study(&study);
    return status;
}

const struct measure_program program_taylor_bar = {
    .name = "taylor_bar",
    .summary = "a cylinder hits a wall and mushrooms: final length, radius, energy",
    .run = run,
};

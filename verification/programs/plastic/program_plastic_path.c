/* P1, P2: a block whose nodes all have a prescribed velocity, so that it deforms evenly along its
 * axes: its deviatoric stress against exact plasticity.
 *
 *   process  reference
 *   turning  von Mises without hardening, constant rate e' of deviatoric logarithmic strain: with
 *            R = sqrt(2/3) Y the deviator s turns as s' = 2 G (e' - (s : e') s/R^2), so that its
 *            angle psi to e' has R psi' = -2 G |e'| sin psi, and
 *            tan(psi/2) = tan(psi_0/2) exp(-2 G |e'| t/R).
 *            A step of the radial return has tan psi = R sin psi_0/(R cos psi_0 + 2 G |e'| dt).
 *            The block starts at psi_0, strained to the verge of yield.
 *   cyclic   strain along one direction of the deviators, back and forth. With the equivalent
 *            strain e, its plastic part e_p, and p, the sum of |de_p|:
 *            q = 3 G (e - e_p),  |q - H_k e_p| = s(p) where it yields; dissipated: integral of s
 *            dp. Strain and stress are those of the axes that turn with F.
 *
 * The optional parameter `table` has the points "p s p s ..." of s instead of its other parameters.
 * Stresses are Kirchhoff's. Reports: turning: step_error (rad; against the steps, largest over
 * all), angle_error (rad; against the exact angle, at the end) and its orders over levels of the
 * time step; cyclic: stress_error (of q, % of Y), strain_error (of p), dissipation_error (% of it,
 * largest), plastic_strain (p at the end), across (largest |tau_zz|, % of Y), turns (of F); both:
 * balance (% of the dissipation: total_energy less external work), finished. Series: path.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>

enum { GRADIENT = 5, STRESS = 4, COLUMNS = 4, TABLE = 32 };
static const double SAMPLE = 1e-6; /* of the run: less than any step */

enum process { TURNING, CYCLIC, PROCESSES };
static const char *const process_names[PROCESSES] = {"turning", "cyclic"};

struct problem {
    enum process process;
    double shear, yield, modulus, strain, exponent, kinematic; /* of the scene's material */
    double angle, way;                                         /* psi_0; 2 G |e'| t/R of the run */
    double updates;                                            /* of the stress, a step */
    double table[TABLE];                                       /* p, s, p, s, ... */
    size_t points;                                             /* of it */
};

struct study {
    const struct problem *problem;
    size_t count;
    double *f, *stress, *plastic;
    double first[2][3]; /* unit deviators: that of the motion, and one at right angles to it */
    double psi, e_plastic, p; /* the reference's */
    double step_error, angle_error, stress_error, strain_error, dissipation_error, balance, end_p;
    double across, turned; /* |tau_zz|, % of Y; angle, rad */
    double volume, energy_start, step_way;
    bool finished;
    struct follow_rows rows;
};

/* -------------------------------------------------------------------- references */

/* s of the table, and its integral from 0. */
static double read_table(const struct problem *problem, double p, double *integral)
{
    const double *const t = problem->table;
    double s = t[1];
    *integral = 0.0;
    for (size_t k = 0; k < problem->points; k++) {
        const bool last = k + 1 == problem->points;
        const double from = t[2 * k], way = last ? p - from : fmin(p, t[2 * k + 2]) - from;
        const double slope = last ? 0.0 : (t[2 * k + 3] - t[2 * k + 1]) / (t[2 * k + 2] - t[2 * k]);
        if (way < 0.0)
            break;
        s = t[2 * k + 1] + slope * way;
        *integral += 0.5 * (t[2 * k + 1] + s) * way;
    }
    return s;
}

static double hardened(const struct problem *problem, double p)
{
    double unused;
    if (problem->points > 0)
        return read_table(problem, p, &unused);
    const double power =
        problem->strain > 0.0 ? pow(1.0 + p / problem->strain, problem->exponent) : 1.0;
    return problem->yield * power + problem->modulus * p;
}

static double dissipated(const struct problem *problem, double p)
{
    double integral;
    if (problem->points > 0) {
        (void)read_table(problem, p, &integral);
        return integral;
    }
    const double n = problem->exponent + 1.0, scale = problem->strain;
    const double power = scale > 0.0 ? scale / n * (pow(1.0 + p / scale, n) - 1.0) : p;
    return problem->yield * power + 0.5 * problem->modulus * p * p;
}

/* q after the equivalent strain has gone straight to e. By bisection: this need not be fast. */
static double follow_curve(struct study *study, double e)
{
    const struct problem *const problem = study->problem;
    const double stiffness = 3.0 * problem->shear + problem->kinematic;
    const double trial =
        3.0 * problem->shear * (e - study->e_plastic) - problem->kinematic * study->e_plastic;
    double low = 0.0, high = fabs(trial) / stiffness;
    for (int k = 0; k < 200 && fabs(trial) > hardened(problem, study->p); k++) {
        const double middle = 0.5 * (low + high);
        const bool above = fabs(trial) - stiffness * middle > hardened(problem, study->p + middle);
        *(above ? &low : &high) = middle;
    }
    study->e_plastic += copysign(low, trial);
    study->p += low;
    return 3.0 * problem->shear * (e - study->e_plastic);
}

/* ---------------------------------------------------------------------- samples */

static double product(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void look_turning(struct study *study, const double s[3], double time)
{
    const struct problem *const problem = study->problem;
    const double exact = 2.0 * atan(tan(0.5 * problem->angle) * exp(-problem->way * time));
    const double psi = atan2(product(s, study->first[1]), product(s, study->first[0]));
    const double part = study->step_way / problem->updates;
    for (int k = 0; k < (int)problem->updates && time > 0.0; k++)
        study->psi = atan2(sin(study->psi), cos(study->psi) + part);
    study->step_error = fmax(study->step_error, fabs(psi - study->psi));
    study->angle_error = fabs(psi - exact);
    const double row[COLUMNS] = {time, psi, exact, study->psi};
    follow_rows_add(&study->rows, row);
}

/* `shear`: of the stress, in the axes of F; 0 if they are those of the stress. */
static void look_cyclic(struct study *study, const double s[3], double shear,
                        const double strain[3], double dissipation, double time)
{
    const struct problem *const problem = study->problem;
    const double e = sqrt(2.0 / 3.0) * product(strain, study->first[0]);
    const double q = sqrt(1.5) * product(s, study->first[0]);
    const double wanted = follow_curve(study, e);
    const double exact = dissipated(problem, study->p) * study->volume;
    const double wrong = hypot(q - wanted, sqrt(3.0) * shear);
    study->stress_error = fmax(study->stress_error, 100.0 * wrong / problem->yield);
    study->strain_error = fmax(study->strain_error, fabs(study->plastic[0] - study->p));
    if (exact > 0.0)
        study->dissipation_error =
            fmax(study->dissipation_error, 100.0 * fabs(dissipation - exact) / exact);
    study->end_p = study->plastic[0];
    const double row[COLUMNS] = {time, e, q, wanted};
    follow_rows_add(&study->rows, row);
}

/* Turns x and the symmetric t of the plane, xx yy xy, back by the rotation of F; its angle. */
static double turn_back(const double f[GRADIENT], double stretch[2], double t[3])
{
    const double angle = atan2(f[2] - f[1], f[0] + f[3]), c = cos(angle), s = sin(angle);
    const double xx = t[0], yy = t[1], xy = t[2];
    stretch[0] = c * f[0] + s * f[2];
    stretch[1] = c * f[3] - s * f[1];
    t[0] = c * c * xx + 2.0 * c * s * xy + s * s * yy;
    t[1] = s * s * xx - 2.0 * c * s * xy + c * c * yy;
    t[2] = c * s * (yy - xx) + (c * c - s * s) * xy;
    return angle;
}

/* The angle goes on from where it was, by less than half a turn a step. */
static void follow_angle(struct study *study, double angle)
{
    const double turn = 2.0 * G_PI;
    study->turned += remainder(angle - study->turned, turn);
}

/* All particles are the same: of the first one. Axes: x or r, y or z, out of the plane. */
static void look_at(void *context, const struct mpm_simulation *simulation,
                    const struct mpm_ledger *ledger)
{
    struct study *const study = context;
    mpm_simulation_field(simulation, MPM_FIELD_DEFORMATION_GRADIENT, study->f);
    mpm_simulation_field(simulation, MPM_FIELD_STRESS, study->stress);
    mpm_simulation_field(simulation, MPM_FIELD_PLASTIC_STRAIN, study->plastic);
    const double *const f = study->f, *const sigma = study->stress;
    const double j = (f[0] * f[3] - f[1] * f[2]) * f[4];
    double stretch[2], plane[3] = {j * sigma[0], j * sigma[1], j * sigma[3]};
    follow_angle(study, turn_back(f, stretch, plane));
    const double strain[3] = {log(stretch[0]), log(stretch[1]), log(f[4])};
    const double mean = (plane[0] + plane[1] + j * sigma[2]) / 3.0;
    const double s[3] = {plane[0] - mean, plane[1] - mean, j * sigma[2] - mean};
    const double energy = ledger->total_energy - ledger->external_work;
    study->across = fmax(study->across, 100.0 * fabs(j * study->stress[2]) / study->problem->yield);
    if (ledger->step == 0)
        study->energy_start = energy;
    if (ledger->plastic_dissipation > 0.0)
        study->balance = 100.0 * fabs(energy - study->energy_start) / ledger->plastic_dissipation;
    if (study->problem->process == TURNING)
        look_turning(study, s, ledger->time);
    else
        look_cyclic(study, s, plane[2], strain, ledger->plastic_dissipation, ledger->time);
}

/* ------------------------------------------------------------------------- runs */

/* Strains all particles to the verge of yield, at the angle of the problem, with the pressure that
 * leaves nothing out of the plane. */
static enum mpm_status set_start(struct study *study, struct mpm_simulation *simulation,
                                 struct mpm_error *error)
{
    static const size_t place[3] = {0, 3, 4};
    const struct problem *const problem = study->problem;
    const double size = sqrt(2.0 / 3.0) * problem->yield / (2.0 * problem->shear);
    double strain[3];
    for (int i = 0; i < 3; i++)
        strain[i] = size * (cos(problem->angle) * study->first[0][i] +
                            sin(problem->angle) * study->first[1][i]);
    for (size_t p = 0; p < study->count; p++)
        for (int i = 0; i < 3; i++)
            study->f[GRADIENT * p + place[i]] = exp(strain[i] - strain[2]);
    return mpm_simulation_set_start(simulation, NULL, study->f, error);
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    const size_t n = study->count = mpm_simulation_particle_count(simulation);
    const double end = mpm_scene_end_time(scene);
    struct follow_result result;
    double step;
    TRY(measurement_number(m, "volume", &study->volume, error));
    study->f = g_new0(double, GRADIENT *n);
    study->stress = g_new(double, STRESS *n);
    study->plastic = g_new(double, n);
    const struct follow follow = {.measurement = m,
                                  .end = end,
                                  .interval = SAMPLE * end,
                                  .sample = look_at,
                                  .context = study};
    enum mpm_status status = measurement_number(m, "first_step", &step, error);
    study->step_way = study->problem->way * step / (double)(1 << (int)study->step_way);
    if (status == MPM_OK && study->problem->process == TURNING)
        status = set_start(study, simulation, error);
    if (status == MPM_OK)
        status = follow_run(&follow, simulation, &result, error);
    if (status == MPM_OK)
        study->finished = result.finished;
    g_free(study->f);
    g_free(study->stress);
    g_free(study->plastic);
    return status;
}

static enum mpm_status read_points(const struct measurement *m, struct problem *problem,
                                   struct mpm_error *error)
{
    size_t count;
    if (!measurement_has(m, "table"))
        return MPM_OK;
    TRY(measurement_list(m, "table", TABLE, problem->table, &count, error));
    if (count % 2 != 0)
        return failure_set(error, MPM_BAD_INPUT, "table: got %zu numbers; allowed: pairs", count);
    problem->points = count / 2;
    return MPM_OK;
}

static enum mpm_status read_problem(const struct measurement *m, struct problem *problem,
                                    double direction[3], struct mpm_error *error)
{
    size_t place;
    const struct measurement_parameter list[] = {
        {"shear", &problem->shear},       {"yield", &problem->yield},
        {"modulus", &problem->modulus},   {"strain", &problem->strain},
        {"exponent", &problem->exponent}, {"kinematic", &problem->kinematic},
        {"angle", &problem->angle},       {"updates", &problem->updates},
        {"rate_x", &direction[0]},        {"rate_y", &direction[1]},
        {"rate_z", &direction[2]},
    };
    TRY(measurement_choice(m, "process", process_names, PROCESSES, &place, error));
    problem->process = (enum process)place;
    TRY(measurement_numbers(m, list, G_N_ELEMENTS(list), error));
    return read_points(m, problem, error);
}

/* The unit deviator along the rates and one at right angles, and 2 G |e'|/R. */
static void set_directions(struct study *study, struct problem *problem, const double rate[3])
{
    const double mean = (rate[0] + rate[1] + rate[2]) / 3.0;
    const double e[3] = {rate[0] - mean, rate[1] - mean, rate[2] - mean};
    const double size = sqrt(product(e, e));
    for (int i = 0; i < 3; i++)
        study->first[0][i] = e[i] / size;
    for (int i = 0; i < 3; i++)
        study->first[1][i] =
            (study->first[0][(i + 2) % 3] - study->first[0][(i + 1) % 3]) / sqrt(3.0);
    problem->way = 2.0 * problem->shear * size / (sqrt(2.0 / 3.0) * problem->yield);
}

static void report(struct measurement *m, const struct study *study)
{
    const double missing = study->finished ? 0.0 : (double)NAN;
    measurement_report(m, "finished", study->finished ? 1.0 : 0.0);
    levels_report_value(m, "balance", "", missing + study->balance);
    if (study->problem->process == TURNING) {
        levels_report_value(m, "step_error", "", missing + study->step_error);
        levels_report_value(m, "angle_error", "", missing + study->angle_error);
        return;
    }
    levels_report_value(m, "stress_error", "", missing + study->stress_error);
    levels_report_value(m, "strain_error", "", missing + study->strain_error);
    levels_report_value(m, "dissipation_error", "", missing + study->dissipation_error);
    levels_report_value(m, "plastic_strain", "", missing + study->end_p);
    levels_report_value(m, "across", "", missing + study->across);
    levels_report_value(m, "turns", "", missing + study->turned / (2.0 * G_PI));
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct problem problem = {.process = CYCLIC};
    struct levels levels;
    struct study study = {.problem = &problem};
    double direction[3], angles[LEVELS_MAX] = {0.0};
    enum mpm_status status = MPM_OK;
    TRY(read_problem(m, &problem, direction, error));
    TRY(levels_read(m, &levels, error));
    const size_t runs = levels_runs(&levels);
    for (size_t k = 0; k < runs && status == MPM_OK; k++) {
        const bool own = levels.count > 0;
        follow_rows_free(&study.rows);
        study = (struct study){.problem = &problem, .rows = {.columns = COLUMNS}};
        set_directions(&study, &problem, direction);
        study.psi = problem.angle;
        study.step_way = (double)k; /* the level, until the step is known */
        status =
            follow_scene(m, own ? &levels.setting[k] : NULL, own ? 1 : 0, measure, &study, error);
        angles[k] = study.finished ? study.angle_error : (double)NAN;
    }
    if (status == MPM_OK) {
        report(m, &study);
        if (problem.process == TURNING)
            levels_report_orders(m, runs, "", angles);
        status = follow_rows_check(&study.rows, error);
    }
    if (status == MPM_OK)
        status = measurement_series(m, "path", "time a b c", COLUMNS, study.rows.count,
                                    study.rows.values, error);
    follow_rows_free(&study.rows);
    return status;
}

const struct measure_program program_plastic_path = {
    .name = "plastic_path",
    .summary = "a block that deforms evenly beyond yield: stress, plastic strain, dissipation",
    .run = run,
};

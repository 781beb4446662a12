/* P10: a block whose nodes all have a prescribed velocity, so that it deforms evenly: its energy
 * and temperature without flow of heat.
 *
 *   process  reference, at the J or the time of the block
 *   solid    Mie and Grueneisen's isentrope: de = p d(eta)/rho_0, eta = 1 - J, by Runge and Kutta's
 *            rule; T = T_0 exp(gamma_0 eta). Parameters: density, sound_speed, hugoniot_slope,
 *            gruneisen, start_temperature
 *   gas      p J^gamma = p_0, e = p J/((gamma - 1) rho_0). Parameters: density, index,
 *            start_pressure, specific_heat
 *   plastic  Johnson and Cook's strength s along one direction of the deviators: q = 3 G (e - p) =
 *            s(p, dp/dt, T) with the equivalent strain e, rho c dT = chi s dp, by backward Euler
 *            steps of its own, a hundredth of the run's. Parameters: density, shear, yield,
 *            coefficient, exponent, rate, reference_rate, softening, reference_temperature,
 *            melting_temperature, start_temperature, specific_heat, quinney, strain_rate (of e)
 *
 * Reports, the largest over the run: pressure_error (of -stress_xx, % of its largest change; or of
 * q, without the first tenth of the run, in which the first step decides),
 * energy_error (% of the largest change; not of plastic), temperature_error (% of the largest
 * change), heating (the change of T at the end), balance (total_energy less external work, % of the
 * largest change of energy), their orders over levels of the time step, and finished. Series:
 * course.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>

enum { GRADIENT = 5, STRESS = 4, COLUMNS = 7, PARTS = 100 };
static const double SAMPLE = 1e-6; /* of the run: less than any step */

enum process { SOLID, GAS, PLASTIC, PROCESSES };
static const char *const process_names[PROCESSES] = {"solid", "gas", "plastic"};

struct problem {
    enum process process;
    double density, start_temperature, specific_heat;
    double sound_speed, slope, gruneisen;
    double index, start_pressure;
    double shear, yield, coefficient, exponent, rate, reference_rate;
    double softening, reference_temperature, melting_temperature, quinney, strain_rate;
};

/* Pressure (or q), energy per mass, temperature. */
enum quantity { STRESSES, ENERGY, TEMPERATURE, QUANTITIES };
static const char *const quantity_names[QUANTITIES] = {"pressure", "energy", "temperature"};

struct state {
    double value[QUANTITIES];
};

struct study {
    const struct problem *problem;
    size_t count;
    double *f, *stress, *field;
    double time, strain, p, temperature; /* of the plastic reference, so far */
    double error[QUANTITIES], change[QUANTITIES], balance, heating;
    double energy_start;
    double from; /* the time from which stresses are compared */
    struct state start;
    bool finished;
    struct follow_rows rows;
};

/* ------------------------------------------------------------------ references */

static double cold(const struct problem *p, double eta)
{
    const double way = 1.0 - p->slope * eta, square = p->sound_speed * p->sound_speed;
    return eta < 0.0 ? square * eta : square * eta * (1.0 - 0.5 * p->gruneisen * eta) / (way * way);
}

static struct state solid_at(const struct problem *p, double j)
{
    enum { STEPS = 2000 };
    const double eta = 1.0 - j, h = eta / STEPS;
    double e = 0.0;
    for (int k = 0; k < STEPS; k++) {
        const double a = k * h, g = p->gruneisen;
        const double one = cold(p, a) + g * e;
        const double two = cold(p, a + 0.5 * h) + g * (e + 0.5 * h * one);
        const double three = cold(p, a + 0.5 * h) + g * (e + 0.5 * h * two);
        const double four = cold(p, a + h) + g * (e + h * three);
        e += h / 6.0 * (one + 2.0 * two + 2.0 * three + four);
    }
    return (struct state){{p->density * (cold(p, eta) + p->gruneisen * e), e,
                           p->start_temperature * exp(p->gruneisen * eta)}};
}

static struct state gas_at(const struct problem *p, double j)
{
    const double pressure = p->start_pressure * pow(j, -p->index);
    const double energy = pressure * j / ((p->index - 1.0) * p->density);
    return (struct state){{pressure, energy, energy / p->specific_heat}};
}

static double strength(const struct problem *p, double plastic, double rate, double temperature)
{
    const double range = p->melting_temperature - p->reference_temperature;
    const double hot = fmax(0.0, temperature - p->reference_temperature) / range;
    const double of_rate = 1.0 + p->rate * log(fmax(rate / p->reference_rate, 1.0));
    return (p->yield + p->coefficient * pow(plastic, p->exponent)) * of_rate *
           (1.0 - pow(fmin(hot, 1.0), p->softening));
}

/* One step: the change of p for which q is the strength, by halving. */
static double plastic_change(const struct problem *p, double strain, double plastic, double step,
                             double temperature)
{
    double low = 0.0, high = strain - plastic;
    if (!(3.0 * p->shear * high > strength(p, plastic, 0.0, temperature)))
        return 0.0;
    for (int k = 0; k < 100; k++) {
        const double change = 0.5 * (low + high);
        const double q = 3.0 * p->shear * (strain - plastic - change);
        *(q > strength(p, plastic + change, change / step, temperature) ? &low : &high) = change;
    }
    return 0.5 * (low + high);
}

/* Takes the reference from its time to this one. */
static struct state plastic_at(struct study *study, double time)
{
    const struct problem *const p = study->problem;
    const double step = (time - study->time) / PARTS;
    for (int k = 0; k < PARTS && step > 0.0; k++) {
        study->strain += p->strain_rate * step;
        const double change = plastic_change(p, study->strain, study->p, step, study->temperature);
        const double q = 3.0 * p->shear * (study->strain - study->p - change);
        study->p += change;
        study->temperature += p->quinney * q * change / (p->density * p->specific_heat);
    }
    study->time = time;
    return (struct state){{3.0 * p->shear * (study->strain - study->p), 0.0, study->temperature}};
}

/* -------------------------------------------------------------------- sampling */

static double mean_of(const struct study *study, const double *field, size_t stride)
{
    double sum = 0.0;
    for (size_t k = 0; k < study->count; k++)
        sum += field[stride * k];
    return sum / (double)study->count;
}

/* sqrt(3/2) |dev stress| of a motion along the axes, with J = 1 */
static double equivalent(const double *s)
{
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
    return sqrt(0.5 * (a * a + b * b + c * c));
}

static struct state read_state(struct study *study, const struct mpm_simulation *simulation,
                               double *j)
{
    struct state now;
    mpm_simulation_field(simulation, MPM_FIELD_DEFORMATION_GRADIENT, study->f);
    mpm_simulation_field(simulation, MPM_FIELD_STRESS, study->stress);
    const double *const f = study->f;
    *j = (f[0] * f[3] - f[1] * f[2]) * f[4];
    now.value[STRESSES] = study->problem->process == PLASTIC
                              ? equivalent(study->stress)
                              : -mean_of(study, study->stress, STRESS);
    now.value[ENERGY] = 0.0;
    if (study->problem->process != PLASTIC) {
        mpm_simulation_field(simulation, MPM_FIELD_INTERNAL_ENERGY, study->field);
        now.value[ENERGY] = mean_of(study, study->field, 1);
    }
    mpm_simulation_field(simulation, MPM_FIELD_STATE_TEMPERATURE, study->field);
    now.value[TEMPERATURE] = mean_of(study, study->field, 1);
    return now;
}

static struct state exact(struct study *study, double time, double j)
{
    const struct problem *const p = study->problem;
    return p->process == SOLID ? solid_at(p, j)
           : p->process == GAS ? gas_at(p, j)
                               : plastic_at(study, time);
}

static void look_at(void *context, const struct mpm_simulation *simulation,
                    const struct mpm_ledger *ledger)
{
    struct study *const study = context;
    double j;
    const struct state now = read_state(study, simulation, &j);
    const struct state wanted = exact(study, ledger->time, j);
    if (!(ledger->time > 0.0)) {
        study->start = now;
        study->energy_start = ledger->total_energy;
    }
    double row[COLUMNS] = {ledger->time};
    for (int k = 0; k < QUANTITIES; k++) {
        const bool counts = k != STRESSES || ledger->time >= study->from;
        if (counts)
            study->error[k] = fmax(study->error[k], fabs(now.value[k] - wanted.value[k]));
        study->change[k] = fmax(study->change[k], fabs(wanted.value[k] - study->start.value[k]));
        row[1 + k] = now.value[k];
        row[1 + QUANTITIES + k] = wanted.value[k];
    }
    study->heating = now.value[TEMPERATURE] - study->start.value[TEMPERATURE];
    const double change = fabs(ledger->external_work);
    if (change > 0.0)
        study->balance = 100.0 *
                         fabs(ledger->total_energy - study->energy_start - ledger->external_work) /
                         change;
    follow_rows_add(&study->rows, row);
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    const double end = mpm_scene_end_time(scene);
    struct follow_result result;
    const struct follow follow = {.measurement = m,
                                  .end = end,
                                  .interval = SAMPLE * end,
                                  .sample = look_at,
                                  .context = study};
    study->from = study->problem->process == PLASTIC ? 0.1 * end : 0.0;
    study->count = mpm_simulation_particle_count(simulation);
    study->f = g_new(double, GRADIENT * study->count);
    study->stress = g_new(double, STRESS * study->count);
    study->field = g_new(double, study->count);
    const enum mpm_status status = follow_run(&follow, simulation, &result, error);
    study->finished = status == MPM_OK && result.finished;
    g_free(study->f);
    g_free(study->stress);
    g_free(study->field);
    return status;
}

/* --------------------------------------------------------------------- running */

static enum mpm_status read_problem(const struct measurement *m, struct problem *p,
                                    struct mpm_error *error)
{
    const struct measurement_parameter solid[] = {
        {"density", &p->density},
        {"sound_speed", &p->sound_speed},
        {"hugoniot_slope", &p->slope},
        {"gruneisen", &p->gruneisen},
        {"start_temperature", &p->start_temperature},
    };
    const struct measurement_parameter gas[] = {
        {"density", &p->density},
        {"index", &p->index},
        {"start_pressure", &p->start_pressure},
        {"specific_heat", &p->specific_heat},
    };
    const struct measurement_parameter plastic[] = {
        {"density", &p->density},
        {"shear", &p->shear},
        {"yield", &p->yield},
        {"coefficient", &p->coefficient},
        {"exponent", &p->exponent},
        {"rate", &p->rate},
        {"reference_rate", &p->reference_rate},
        {"softening", &p->softening},
        {"reference_temperature", &p->reference_temperature},
        {"melting_temperature", &p->melting_temperature},
        {"start_temperature", &p->start_temperature},
        {"specific_heat", &p->specific_heat},
        {"quinney", &p->quinney},
        {"strain_rate", &p->strain_rate},
    };
    size_t process;
    TRY(measurement_choice(m, "process", process_names, PROCESSES, &process, error));
    p->process = (enum process)process;
    if (p->process == SOLID)
        return measurement_numbers(m, solid, G_N_ELEMENTS(solid), error);
    if (p->process == GAS)
        return measurement_numbers(m, gas, G_N_ELEMENTS(gas), error);
    return measurement_numbers(m, plastic, G_N_ELEMENTS(plastic), error);
}

static bool has(const struct problem *p, int quantity)
{
    return quantity != ENERGY || p->process != PLASTIC;
}

static void report(struct measurement *m, const struct study *study, const double *error)
{
    for (int k = 0; k < QUANTITIES; k++) {
        char name[48];
        (void)g_snprintf(name, sizeof name, "%s_error", quantity_names[k]);
        if (has(study->problem, k))
            levels_report_value(m, name, "", error[k]);
    }
    levels_report_value(m, "heating", "", study->heating);
    levels_report_value(m, "balance", "", study->balance);
    measurement_report(m, "finished", study->finished ? 1.0 : 0.0);
}

static enum mpm_status run_level(struct measurement *m, const struct levels *levels, size_t level,
                                 struct study *study, double error[QUANTITIES],
                                 struct mpm_error *failure)
{
    follow_rows_free(&study->rows);
    *study = (struct study){.problem = study->problem,
                            .temperature = study->problem->start_temperature,
                            .rows = {.columns = COLUMNS}};
    TRY(follow_scene(m, &levels->setting[level], levels->count > 0 ? 1 : 0, measure, study,
                     failure));
    for (int k = 0; k < QUANTITIES; k++)
        error[k] = study->finished ? 100.0 * study->error[k] / study->change[k] : (double)NAN;
    return MPM_OK;
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct problem problem = {.density = 1.0};
    struct study study = {.problem = &problem};
    struct levels levels;
    double errors[QUANTITIES][LEVELS_MAX] = {{0.0}}, last[QUANTITIES] = {0.0};
    TRY(read_problem(m, &problem, error));
    TRY(levels_read(m, &levels, error));
    enum mpm_status status = MPM_OK;
    for (size_t k = 0; k < levels_runs(&levels) && status == MPM_OK; k++) {
        status = run_level(m, &levels, k, &study, last, error);
        for (int q = 0; q < QUANTITIES; q++)
            errors[q][k] = last[q];
    }
    if (status == MPM_OK) {
        report(m, &study, last);
        status = follow_rows_check(&study.rows, error);
    }
    if (status == MPM_OK)
        status = measurement_series(m, "course", "time p e T p_exact e_exact T_exact", COLUMNS,
                                    study.rows.count, study.rows.values, error);
    for (int q = 0; q < QUANTITIES && levels.count > 0 && status == MPM_OK; q++) {
        char suffix[32];
        (void)g_snprintf(suffix, sizeof suffix, "_%s", quantity_names[q]);
        if (has(&problem, q))
            status = levels_report(m, &levels, suffix, errors[q], error);
    }
    follow_rows_free(&study.rows);
    return status;
}

const struct measure_program program_adiabat = {
    .name = "adiabat",
    .summary = "a block deforms evenly without flow of heat: isentropes, heat of plastic work",
    .run = run,
};

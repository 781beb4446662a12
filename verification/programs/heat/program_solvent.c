/* H12: bodies that take up solvent through their edges, and swell.
 *
 * `solution: soak`: the scene comes to rest in a bath, saturated and free of stress. Parameters:
 * swelling, the stretch is exp(swelling) then. Reports: stretch (mean of F_xx, F_yy and F_zz over
 * the particles, over exp(swelling)), stretch_scatter (root mean square of the
 * difference from exp(swelling), % of it), concentration_scatter (% of 1), stress_scatter (root
 * mean square of the in-plane normal stresses, % of the parameter `modulus` times the swelling).
 *
 * `solution: uptake`: a slab that does not swell, its length along x the parameter `length`, with
 * `diffusivity` and `transfer`, b = coefficient length/(saturation diffusivity). Reports:
 * uptake_worst, the largest difference from uptake.h of all samples (% of saturation).
 *
 * Both: filled (solvent over that of saturation), imbalance (|change of solvent - what went in|
 * over the sum of their sizes), finished. Series: uptake (time, solvent over saturation, exact).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/heat/uptake.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { COLUMNS = 3, SAMPLES = 50, GRADIENT = 5, STRESS = 4 };
enum kind { SOAK, UPTAKE, KINDS };
static const char *const kind_names[KINDS] = {"soak", "uptake"};

struct problem {
    enum kind kind;
    double saturation, density;
    double swelling, modulus;             /* soak */
    double length, diffusivity, transfer; /* uptake */
};

struct outcome {
    bool finished;
    double filled, imbalance;
    double stretch, stretch_scatter, concentration_scatter, stress_scatter;
    double uptake_worst;
};

struct study {
    const struct problem *problem;
    struct outcome *outcome;
    struct follow_rows *rows; /* NULL: not of the last level */
};

static enum mpm_status read_problem(const struct measurement *m, struct problem *problem,
                                    struct mpm_error *error)
{
    size_t kind;
    const struct measurement_parameter both[] = {{"saturation", &problem->saturation},
                                                 {"density", &problem->density}};
    const struct measurement_parameter soak[] = {{"swelling", &problem->swelling},
                                                 {"modulus", &problem->modulus}};
    const struct measurement_parameter uptake[] = {{"length", &problem->length},
                                                   {"diffusivity", &problem->diffusivity},
                                                   {"transfer", &problem->transfer}};
    TRY(measurement_choice(m, "solution", kind_names, KINDS, &kind, error));
    TRY(measurement_numbers(m, both, G_N_ELEMENTS(both), error));
    problem->kind = (enum kind)kind;
    return kind == SOAK ? measurement_numbers(m, soak, G_N_ELEMENTS(soak), error)
                        : measurement_numbers(m, uptake, G_N_ELEMENTS(uptake), error);
}

/* ------------------------------------------------------------------ measuring */

static double quantity(const struct mpm_scene *scene, const struct mpm_simulation *simulation,
                       const char *name)
{
    for (size_t k = 0; k < mpm_scene_transport_quantity_count(scene); k++)
        if (strcmp(mpm_scene_transport_quantity(scene, k).name, name) == 0)
            return mpm_simulation_transport_quantity(simulation, k);
    return (double)NAN;
}

/* Solvent over that of saturation. */
static double filled_part(const struct problem *problem, const struct mpm_scene *scene,
                          const struct mpm_simulation *simulation)
{
    struct mpm_ledger ledger;
    mpm_simulation_ledger(simulation, &ledger);
    return quantity(scene, simulation, "solvent_mass") /
           (problem->saturation * ledger.mass / problem->density);
}

static double imbalance(const struct mpm_scene *scene, const struct mpm_simulation *simulation,
                        double start)
{
    const double change = quantity(scene, simulation, "solvent_mass") - start;
    const double held = quantity(scene, simulation, "boundary_solvent");
    const double source = quantity(scene, simulation, "source_solvent");
    const double edges = quantity(scene, simulation, "edge_solvent");
    return fabs(change - held - source - edges) /
           (fabs(start) + fabs(change) + fabs(held) + fabs(source) + fabs(edges));
}

static double exact_uptake(const struct problem *problem, double time)
{
    const double b =
        problem->transfer * problem->length / (problem->saturation * problem->diffusivity);
    return slab_uptake(b, problem->diffusivity * time / (problem->length * problem->length));
}

static void sample(const struct study *study, const struct mpm_scene *scene,
                   const struct mpm_simulation *simulation)
{
    const struct problem *const problem = study->problem;
    const double time = mpm_simulation_time(simulation);
    const double filled = filled_part(problem, scene, simulation);
    const double exact = problem->kind == UPTAKE ? exact_uptake(problem, time) : 1.0;
    const double row[COLUMNS] = {time, filled, exact};
    if (problem->kind == UPTAKE && time > 0.0)
        study->outcome->uptake_worst =
            fmax(study->outcome->uptake_worst, 100.0 * fabs(filled - exact));
    if (study->rows != NULL)
        follow_rows_add(study->rows, row);
}

/* Mean and scatter of what has `of` components a particle, those in the bits of `which`, about
 * `wanted`. */
static double scatter(const struct mpm_simulation *simulation, enum mpm_field field, size_t of,
                      unsigned which, double wanted, double *mean)
{
    const size_t count = mpm_simulation_particle_count(simulation);
    double *const value = g_new(double, of *count);
    double sum = 0.0, square = 0.0, n = 0.0;
    mpm_simulation_field(simulation, field, value);
    for (size_t k = 0; k < of * count; k++)
        if ((which >> k % of & 1U) != 0) {
            sum += value[k];
            square += (value[k] - wanted) * (value[k] - wanted);
            n += 1.0;
        }
    g_free(value);
    *mean = sum / n;
    return sqrt(square / n);
}

static void measure_soaked(const struct problem *problem, const struct mpm_simulation *simulation,
                           struct outcome *outcome)
{
    const double wanted = exp(problem->swelling);
    double mean;
    outcome->stretch_scatter = 100.0 / wanted *
                               scatter(simulation, MPM_FIELD_DEFORMATION_GRADIENT, GRADIENT,
                                       1U | 1U << 3 | 1U << 4, wanted, &mean);
    outcome->stretch = mean / wanted;
    outcome->concentration_scatter =
        100.0 * scatter(simulation, MPM_FIELD_CONCENTRATION, 1, 1U, 1.0, &mean);
    outcome->stress_scatter = 100.0 / (problem->modulus * problem->swelling) *
                              scatter(simulation, MPM_FIELD_STRESS, STRESS, 3U, 0.0, &mean);
}

static enum mpm_status measure_scene(void *context, struct measurement *m,
                                     const struct mpm_scene *scene,
                                     struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct study *const study = context;
    struct outcome *const outcome = study->outcome;
    const double start = quantity(scene, simulation, "solvent_mass");
    const double end = mpm_scene_end_time(scene);
    outcome->finished = true;
    sample(study, scene, simulation);
    for (int k = 1; k <= SAMPLES && outcome->finished && study->problem->kind == UPTAKE; k++) {
        TRY(follow_to(m, simulation, end * k / SAMPLES, &outcome->finished, error));
        sample(study, scene, simulation);
    }
    if (study->problem->kind == SOAK) {
        TRY(follow_to_rest(m, simulation, end, &outcome->finished, error));
        measure_soaked(study->problem, simulation, outcome);
    } else
        follow_count_work(m, simulation);
    outcome->filled = filled_part(study->problem, scene, simulation);
    outcome->imbalance = imbalance(scene, simulation, start);
    return MPM_OK;
}

/* ------------------------------------------------------------------ reporting */

static void report(struct measurement *m, enum kind kind, const struct outcome *outcome)
{
    const double missing = outcome->finished ? 0.0 : (double)NAN;
    measurement_report(m, "finished", outcome->finished ? 1.0 : 0.0);
    measurement_report(m, "filled", missing + outcome->filled);
    measurement_report(m, "imbalance", outcome->imbalance);
    if (kind == UPTAKE) {
        measurement_report(m, "uptake_worst", missing + outcome->uptake_worst);
        return;
    }
    measurement_report(m, "stretch", missing + outcome->stretch);
    measurement_report(m, "stretch_scatter", missing + outcome->stretch_scatter);
    measurement_report(m, "concentration_scatter", missing + outcome->concentration_scatter);
    measurement_report(m, "stress_scatter", missing + outcome->stress_scatter);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct problem problem = {.kind = SOAK};
    struct levels levels = {.count = 0};
    struct outcome outcome = {.finished = false};
    struct follow_rows rows = {.columns = COLUMNS};
    double worst[LEVELS_MAX] = {0.0};
    enum mpm_status status = read_problem(m, &problem, error);
    if (status == MPM_OK)
        status = levels_read(m, &levels, error);
    for (size_t k = 0; status == MPM_OK && k < levels_runs(&levels); k++) {
        const bool last = k + 1 == levels_runs(&levels);
        outcome = (struct outcome){.finished = false};
        struct study study = {&problem, &outcome, last ? &rows : NULL};
        status = follow_scene(m, &levels.setting[k], levels.count == 0 ? 0 : 1, measure_scene,
                              &study, error);
        worst[k] = outcome.uptake_worst;
    }
    if (status == MPM_OK)
        report(m, problem.kind, &outcome);
    if (status == MPM_OK && problem.kind == UPTAKE && levels.count > 0)
        status = levels_report(m, &levels, "_uptake", worst, error);
    if (status == MPM_OK)
        status = follow_rows_check(&rows, error);
    if (status == MPM_OK && problem.kind == UPTAKE)
        status = measurement_series(m, "uptake", "time filled exact", COLUMNS, rows.count,
                                    rows.values, error);
    follow_rows_free(&rows);
    return status;
}

const struct measure_program program_solvent = {
    .name = "solvent",
    .summary = "solvent taken up through edges, against exact values; swelling",
    .run = run,
};

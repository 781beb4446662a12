/* T2: does a load give its stated force? The force that a traction on one face exerts in a step,
 * from the change of momentum, against value times deformed area, edge by edge from F.
 *
 * Two runs of the scene agree until `time`, when the load of one of them begins; the first step
 * after that yields the force by the difference of their momenta. The body is a lattice of sites,
 * `columns` by `rows`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/fields.h"
#include "verification/programs/follow.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { AXES = 2, GRADIENT = 5, EDGES = 4, FRAMES = 2, SITES_MAX = 10000 };

/* Whose area: of the edges that F carries, or of the undeformed ones (uGIMP). */
enum area { CARRIED, UNDEFORMED, AREAS };
static const char *const quantities[AREAS] = {"force_error", "force_error_undeformed"};

static const char *const edge_names[EDGES] = {"bottom", "right", "top", "left"};
static const char *const frame_names[FRAMES] = {"global", "edge"};

struct parameters {
    double time;            /* when loads begin */
    double half[AXES];      /* half the size of a particle at t = 0 */
    double value[AXES];     /* of the load */
    unsigned columns, rows; /* of sites */
    unsigned axisymmetric;  /* 1 or 0 */
};

/* A step of the scene from `time` on, and the state before it. */
struct step {
    double time;
    size_t count;
    double *position, *f;
    double momentum[AXES], time_step;
    bool alive; /* false: the run broke before it or in it */
};

static enum mpm_status read_parameters(const struct measurement *m, struct parameters *p,
                                       struct mpm_error *error)
{
    const struct measurement_parameter table[] = {
        {"time", &p->time},        {"half_x", &p->half[0]},   {"half_y", &p->half[1]},
        {"value_x", &p->value[0]}, {"value_y", &p->value[1]},
    };
    TRY(measurement_numbers(m, table, sizeof table / sizeof *table, error));
    TRY(measurement_count(m, "columns", 1, SITES_MAX, &p->columns, error));
    TRY(measurement_count(m, "rows", 1, SITES_MAX, &p->rows, error));
    return measurement_count(m, "axisymmetric", 0, 1, &p->axisymmetric, error);
}

static void free_step(struct step *step)
{
    g_free(step->position);
    g_free(step->f);
}

static enum mpm_status take_step(void *context, struct measurement *m,
                                 const struct mpm_scene *scene, struct mpm_simulation *simulation,
                                 struct mpm_error *error)
{
    struct step *const step = context;
    (void)scene;
    struct mpm_ledger ledger;
    TRY(follow_to(m, simulation, step->time, &step->alive, error));
    step->count = mpm_simulation_particle_count(simulation);
    step->position = g_new(double, AXES * step->count);
    step->f = g_new(double, GRADIENT * step->count);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, step->position);
    mpm_simulation_field(simulation, MPM_FIELD_DEFORMATION_GRADIENT, step->f);
    if (step->alive)
        TRY(follow_step(m, simulation, HUGE_VAL, &step->alive, error));
    mpm_simulation_ledger(simulation, &ledger);
    memcpy(step->momentum, ledger.momentum, sizeof step->momentum);
    step->time_step = mpm_simulation_time_step(simulation);
    follow_count_work(m, simulation);
    return MPM_OK;
}

static bool is_on_face(const struct parameters *p, size_t id, int edge)
{
    const size_t column = id % p->columns, row = id / p->columns;
    return (edge == 0 && row == 0) || (edge == 1 && column == p->columns - 1) ||
           (edge == 2 && row == p->rows - 1) || (edge == 3 && column == 0);
}

/* F times an undeformed vector */
static void carry(const double *f, double x, double y, double out[AXES])
{
    out[0] = f[0] * x + f[1] * y;
    out[1] = f[2] * x + f[3] * y;
}

/* Adds the force on one particle's edge; returns its size. */
static double add_edge(const struct parameters *p, const struct step *step, size_t id, int edge,
                       bool in_edge, enum area of, double force[AXES])
{
    static const int outward[EDGES][AXES] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    static const double unit[GRADIENT] = {1.0, 0.0, 0.0, 1.0, 1.0};
    const double *const f = &step->f[GRADIENT * id], *const own_f = of == CARRIED ? f : unit;
    const int *const n = outward[edge];
    double along[AXES], own[AXES], away[AXES];
    carry(f, -2.0 * n[1] * p->half[0], 2.0 * n[0] * p->half[1], along);
    carry(own_f, -2.0 * n[1] * p->half[0], 2.0 * n[0] * p->half[1], own);
    carry(own_f, n[0] * p->half[0], n[1] * p->half[1], away);
    const double depth = p->axisymmetric == 1 ? step->position[AXES * id] + away[0] : 1.0;
    const double area = hypot(own[0], own[1]) * depth, length = hypot(along[0], along[1]);
    const double *const v = p->value;
    force[0] += area * (in_edge ? (v[0] * along[1] + v[1] * along[0]) / length : v[0]);
    force[1] += area * (in_edge ? (v[1] * along[1] - v[0] * along[0]) / length : v[1]);
    return area * hypot(v[0], v[1]);
}

/* |force found - force due| over the sum of the sizes of all edges' forces. */
static void compare(const struct parameters *p, const struct step *without, const struct step *with,
                    int edge, int frame, double worst[AREAS])
{
    for (int of = 0; of < AREAS; of++) {
        double due[AXES] = {0.0, 0.0}, size = 0.0;
        for (size_t id = 0; id < with->count; id++)
            if (is_on_face(p, id, edge))
                size += add_edge(p, with, id, edge, frame == 1, (enum area)of, due);
        for (int axis = 0; axis < AXES; axis++) {
            const double found = (with->momentum[axis] - without->momentum[axis]) / with->time_step;
            worst[of] = field_larger(worst[of], fabs(found - due[axis]) / size);
        }
    }
}

/* *alive becomes false if the run with the load breaks. */
static enum mpm_status force_error(struct measurement *m, const struct parameters *p,
                                   const struct step *without, int edge, int frame,
                                   double worst[AREAS], bool *alive, struct mpm_error *error)
{
    struct step with = {.time = p->time, .alive = false};
    char *const load = g_strdup_printf(
        "loads.tractions=[{body: block, edge: %s, frame: %s, value: ['%.17g*(t>=%.17g)', "
        "'%.17g*(t>=%.17g)']}]",
        edge_names[edge], frame_names[frame], p->value[0], p->time, p->value[1], p->time);
    const enum mpm_status status =
        follow_scene(m, (const char *const[]){load}, 1, take_step, &with, error);
    if (status == MPM_OK && with.alive)
        compare(p, without, &with, edge, frame, worst);
    *alive = with.alive;
    g_free(load);
    free_step(&with);
    return status;
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct parameters p;
    double worst[AREAS] = {0.0};
    const char *const load = "loads.tractions=[]";
    TRY(read_parameters(m, &p, error));
    struct step without = {.time = p.time, .alive = false};
    enum mpm_status status = follow_scene(m, &load, 1, take_step, &without, error);
    if (status == MPM_OK && without.count != (size_t)p.columns * p.rows)
        status = failure_set(error, MPM_BAD_INPUT,
                             "parameters \"columns\" and \"rows\" are %u and %u; allowed: those of "
                             "the scene's %zu particles",
                             p.columns, p.rows, without.count);
    bool alive = without.alive;
    for (int k = 0; status == MPM_OK && alive && k < EDGES * FRAMES; k++)
        status = force_error(m, &p, &without, k / FRAMES, k % FRAMES, worst, &alive, error);
    for (int of = 0; status == MPM_OK && of < AREAS; of++)
        if (alive)
            measurement_report(m, quantities[of], worst[of]);
        else
            measurement_inconclusive(m, quantities[of],
                                     "a run ended before the step that yields the force");
    free_step(&without);
    return status;
}

const struct measure_program program_traction_sum = {
    .name = "traction_sum",
    .summary = "the force of a traction against its value times the deformed area",
    .run = run,
};

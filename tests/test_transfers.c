/* What each transfer and form promises: transfers x families x geometries, the orders of the
 * stress update in turn.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm.h"
#include "suites.h"
#include "support/near.h"
#include "support/scenes.h"

#include <float.h>
#include <glib.h>
#include <stdlib.h>
#include <string.h>

static const char *const shapes[] = {"classic", "ugimp", "cpdi", "bspline2", "bspline3"};
static const char *const geometries[] = {"plane_strain", "axisymmetric"};
static const char *const orders[] = {"stress_update: usl", "stress_update: musl",
                                     "stress_update: usf", "stress_update: usavg",
                                     "stress_update: usavg, extrapolate: false"};
static const char *const transfers[] = {
    "{kind: flip}",
    "{kind: flip, fraction: 0.95}",
    "{kind: pic}",
    "{kind: xpic, order: 2}",
    "{kind: xpic, order: 5}",
    "{kind: fmpm, order: 2}",
    "{kind: fmpm, order: 3}",
    "{kind: apic}",
};
enum {
    SHAPES = G_N_ELEMENTS(shapes),
    GEOMETRIES = G_N_ELEMENTS(geometries),
    ORDERS = G_N_ELEMENTS(orders),
    TRANSFERS = G_N_ELEMENTS(transfers),
    COMBINATIONS = SHAPES * GEOMETRIES * TRANSFERS,
    CLASSIC = 0,
    PIC = 2,
    APIC = TRANSFERS - 1,
};

/* Cells are not square, the body's edges are on grid lines and within cells. Wave speed 12, so
 * that a step is near 0.02. */
static const char BLOCK[] =
    "format: 1\n"
    "title: A block\n"
    "geometry: plane_strain\n"
    "grid: {origin: [0, 0], cell: [1, 0.8], cells: [14, 15]}\n"
    "time: {end: 1000, courant: 0.3}\n"
    "materials: [{name: rubber, law: neo_hookean, density: 1, bulk: 80, shear: 48}]\n"
    "bodies:\n"
    "  - {name: block, material: rubber, region: {rectangle: {from: [3, 3.2], to: [8.5, 8]}},\n"
    "     particles_per_cell: [2, 2]}\n";

/* ------------------------------------------------------------------ settings */

struct settings {
    char *texts[8];
    int count;
};

static void add(struct settings *settings, const char *format, ...) G_GNUC_PRINTF(2, 3);
static void add(struct settings *settings, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    settings->texts[settings->count++] = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    settings->texts[settings->count] = NULL;
}

static struct test_run open_block(struct settings *settings, int threads)
{
    struct test_run run = test_run_open(BLOCK, (const char *const *)settings->texts, threads);
    for (int k = 0; k < settings->count; k++)
        g_free(settings->texts[k]);
    *settings = (struct settings){.count = 0};
    return run;
}

static void add_method(struct settings *settings, const char *shape, const char *order,
                       const char *transfer)
{
    add(settings, "method={shape: %s, %s, transfer: %s}", shape, order, transfer);
}

struct combination {
    int shape, transfer;
    bool axisymmetric;
    struct settings settings;
};

static struct combination combination_of(int index)
{
    struct combination c = {
        .shape = index % SHAPES,
        .axisymmetric = index / SHAPES % GEOMETRIES == 1,
        .transfer = index / SHAPES / GEOMETRIES,
    };
    add(&c.settings, "geometry=%s", geometries[index / SHAPES % GEOMETRIES]);
    /* MUSL and USAVG, without it too; classic functions under USL amplify round-off */
    add_method(&c.settings, shapes[c.shape],
               c.shape == CLASSIC ? orders[1 + 2 * (index / SHAPES % 2)]
                                  : orders[(index / SHAPES + index) % ORDERS],
               transfers[c.transfer]);
    return c;
}

/* An affine part keeps the velocity of nodes that hardly have mass, of which classic functions
 * have many, and hands it to nodes of more: edges run away at once. */
static bool runs_away(const struct combination *c)
{
    return c->shape == CLASSIC && c->transfer == APIC;
}

/* All but FLIP and its fractions. */
static bool transfers_from_grid(int transfer)
{
    return transfer >= PIC;
}

static void set_wild_velocity(struct settings *settings, bool axisymmetric)
{
    if (axisymmetric)
        add(settings, "bodies.block.velocity=['0.3*sin(2*r)*cos(z)', '0.4*cos(r+2*z)']");
    else
        add(settings, "bodies.block.velocity=['0.3*sin(2*x)*cos(y)', '0.4*cos(x+2*y)']");
}

static struct mpm_ledger ledger_of(const struct test_run *run)
{
    struct mpm_ledger ledger;
    mpm_simulation_ledger(run->simulation, &ledger);
    return ledger;
}

/* The largest difference of two fields of two runs. */
static double difference(const struct test_run *one, const struct test_run *other,
                         enum mpm_field field)
{
    size_t n;
    double largest = 0.0;
    double *const a = test_run_field(one, field, &n), *const b = test_run_field(other, field, NULL);
    for (size_t k = 0; k < n * mpm_field_describe(field)->components; k++)
        largest = fmax(largest, fabs(a[k] - b[k]));
    free(a);
    free(b);
    return largest;
}

static bool same_bits(const struct test_run *one, const struct test_run *other)
{
    return difference(one, other, MPM_FIELD_POSITION) == 0.0 &&
           difference(one, other, MPM_FIELD_VELOCITY) == 0.0 &&
           difference(one, other, MPM_FIELD_DEFORMATION_GRADIENT) == 0.0;
}

/* ------------------------------------------------------------ every transfer */

START_TEST(a_rigid_translation_is_exact)
{
    enum { STEPS = 40 };
    static const double ROUND_OFF = STEPS * 256 * DBL_EPSILON;
    struct combination c = combination_of(_i);
    const double v[2] = {c.axisymmetric ? 0.0 : 0.7, -0.4};
    add(&c.settings, "bodies.block.velocity=[%g, %g]", v[0], v[1]);
    struct test_run run = open_block(&c.settings, 1);
    size_t n;
    double *const start = test_run_field(&run, MPM_FIELD_POSITION, &n);
    test_run_steps(&run, runs_away(&c) ? 1 : STEPS);
    const double time = mpm_simulation_time(run.simulation);
    double *const x = test_run_field(&run, MPM_FIELD_POSITION, NULL);
    double *const velocity = test_run_field(&run, MPM_FIELD_VELOCITY, NULL);
    double *const f = test_run_field(&run, MPM_FIELD_DEFORMATION_GRADIENT, NULL);
    for (size_t k = 0; k < 2 * n; k++) {
        ck_assert_near(velocity[k], v[k % 2], 10.0 * ROUND_OFF);
        ck_assert_near(x[k], start[k] + v[k % 2] * time, 10.0 * ROUND_OFF);
    }
    for (size_t k = 0; k < 5 * n; k++)
        ck_assert_near(f[k], k % 5 == 1 || k % 5 == 2 ? 0.0 : 1.0, ROUND_OFF);
    free(start);
    free(x);
    free(velocity);
    free(f);
    test_run_close(&run);
}
END_TEST

START_TEST(linear_momentum_is_conserved_to_round_off)
{
    enum { STEPS = 40 };
    struct combination c = combination_of(_i);
    set_wild_velocity(&c.settings, c.axisymmetric);
    struct test_run run = open_block(&c.settings, 1);
    const struct mpm_ledger start = ledger_of(&run);
    test_run_steps(&run, runs_away(&c) ? 4 : STEPS);
    const struct mpm_ledger end = ledger_of(&run);
    /* every step rounds sums of the particles' momenta, each up to 0.4 m */
    const double round_off = STEPS * 64 * DBL_EPSILON * start.mass;
    if (!c.axisymmetric) /* the hoop stress pushes along r */
        ck_assert_near(end.momentum[0], start.momentum[0], round_off);
    ck_assert_near(end.momentum[1], start.momentum[1], round_off);
    test_run_close(&run);
}
END_TEST

/* All nodes are held, at velocities that vary from node to node and grow: then all transfers that
 * take their velocity from the grid take the same, and FLIP takes as much as that grows. */
START_TEST(held_nodes_keep_their_velocity_in_every_order)
{
    enum { STEPS = 12 };
    static const double ROUND_OFF = STEPS * 64 * DBL_EPSILON;
    struct combination c = combination_of(_i), pic = combination_of(_i % (SHAPES * GEOMETRIES));
    struct combination *const both[2] = {&c, &pic};
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings *const settings = &both[k]->settings;
        g_free(settings->texts[--settings->count]);
        add_method(settings, shapes[c.shape], orders[_i % ORDERS],
                   k == 0 ? transfers[c.transfer] : "{kind: pic}");
        add(settings, "bodies.block.velocity=[0.3, 0.2]"); /* so that there is energy at hand */
        add(settings, "boundary=[{region: all, velocity: ['0.3*sin(2*%s)*(1+t)', '-0.2*(1+t)']}]",
            c.axisymmetric ? "r" : "x");
        runs[k] = open_block(settings, 1);
        test_run_steps(&runs[k], STEPS);
    }
    const double apart = difference(&runs[0], &runs[1], MPM_FIELD_VELOCITY);
    if (transfers_from_grid(c.transfer))
        ck_assert_near(apart, 0.0, ROUND_OFF);
    else
        ck_assert(apart > 0.01);
    test_run_close(&runs[0]);
    test_run_close(&runs[1]);
}
END_TEST

/* ----------------------------------------------------------------- PIC, XPIC, FMPM */

START_TEST(order_one_of_xpic_and_fmpm_is_pic)
{
    static const char *const same[] = {"{kind: pic}", "{kind: xpic, order: 1}",
                                       "{kind: fmpm, order: 1}"};
    static const double ALMOST = 1e-9;
    struct test_run runs[3];
    struct settings settings = {.count = 0};
    for (int k = 0; k < 3; k++) {
        add_method(&settings, shapes[_i % SHAPES], orders[_i / SHAPES], same[k]);
        set_wild_velocity(&settings, false);
        runs[k] = open_block(&settings, 1);
        test_run_steps(&runs[k], 20);
    }
    ck_assert(same_bits(&runs[0], &runs[1]));
    ck_assert(same_bits(&runs[0], &runs[2]));
    /* and the end of the scale of FLIP fractions: 20 steps of a share of 1e-9 */
    add_method(&settings, shapes[_i % SHAPES], orders[_i / SHAPES], "{fraction: 1e-9}");
    set_wild_velocity(&settings, false);
    struct test_run flip = open_block(&settings, 1);
    test_run_steps(&flip, 20);
    ck_assert(difference(&runs[0], &flip, MPM_FIELD_VELOCITY) < 20 * ALMOST);
    for (int k = 0; k < 3; k++)
        test_run_close(&runs[k]);
    test_run_close(&flip);
}
END_TEST

/* S S+ is symmetric in the product of the masses, with eigenvalues from 0 to 1: in the first
 * step, which has no forces, 1 - (1 - S S+)^m takes less from each of its modes the higher m. */
START_TEST(xpic_of_higher_order_loses_less_and_tends_to_flip)
{
    static const int higher[] = {1, 2, 3, 5, 10, 30, 100};
    struct settings settings = {.count = 0};
    add_method(&settings, shapes[_i % SHAPES], orders[_i / SHAPES], "{kind: flip}");
    set_wild_velocity(&settings, false);
    struct test_run flip = open_block(&settings, 1);
    const double start = ledger_of(&flip).kinetic_energy;
    test_run_steps(&flip, 1);
    double energy = 0.0, away = HUGE_VAL;
    for (size_t k = 0; k < G_N_ELEMENTS(higher); k++) {
        char *const transfer = g_strdup_printf("{kind: xpic, order: %d}", higher[k]);
        add_method(&settings, shapes[_i % SHAPES], orders[_i / SHAPES], transfer);
        set_wild_velocity(&settings, false);
        struct test_run run = open_block(&settings, 1);
        test_run_steps(&run, 1);
        const double kinetic = ledger_of(&run).kinetic_energy;
        const double distance = difference(&run, &flip, MPM_FIELD_VELOCITY);
        ck_assert(kinetic > energy && kinetic < start);
        ck_assert(distance < away);
        energy = kinetic;
        away = distance;
        g_free(transfer);
        test_run_close(&run);
    }
    test_run_close(&flip);
}
END_TEST

/* The weights of all particles, and what is done with them: an oracle that knows shape functions
 * and nothing of the step. */
struct weights {
    size_t particles, entries[512];
    struct mpm_stencil_entry entry[512][MPM_STENCIL_MAX];
    double mass[512], node_mass[64][64];
};

static struct weights *weights_of(const struct test_run *run, enum mpm_shape shape)
{
    struct weights *const weights = g_new0(struct weights, 1);
    double *const x = test_run_field(run, MPM_FIELD_POSITION, &weights->particles);
    double *const mass = test_run_field(run, MPM_FIELD_MASS, NULL);
    ck_assert_uint_le(weights->particles, 512);
    for (size_t p = 0; p < weights->particles; p++) {
        const struct mpm_shape_query query = {
            .shape = shape,
            .geometry = MPM_PLANE_STRAIN,
            .cell = {1.0, 0.8},
            .cells = {14, 15},
            .position = {x[2 * p], x[2 * p + 1]},
            .half_size = {0.25, 0.2},
            .deformation_gradient = {1.0, 0.0, 0.0, 1.0},
        };
        weights->mass[p] = mass[p];
        weights->entries[p] = mpm_shape_evaluate(&query, weights->entry[p]);
        for (size_t k = 0; k < weights->entries[p]; k++) {
            const struct mpm_stencil_entry *const e = &weights->entry[p][k];
            weights->node_mass[e->row][e->column] += mass[p] * e->s;
        }
    }
    free(x);
    free(mass);
    return weights;
}

/* one component of S+ v_p */
static void to_nodes(const struct weights *weights, const double *v, double node[64][64])
{
    memset(node, 0, 64 * sizeof node[0]);
    for (size_t p = 0; p < weights->particles; p++)
        for (size_t k = 0; k < weights->entries[p]; k++) {
            const struct mpm_stencil_entry *const e = &weights->entry[p][k];
            node[e->row][e->column] +=
                weights->mass[p] * e->s * v[p] / weights->node_mass[e->row][e->column];
        }
}

/* sum S v_i (along = -1) or sum G v_i */
static double at_particle(const struct weights *weights, size_t p, double node[64][64], int along)
{
    double sum = 0.0;
    for (size_t k = 0; k < weights->entries[p]; k++) {
        const struct mpm_stencil_entry *const e = &weights->entry[p][k];
        sum += (along < 0 ? e->s : e->g[along]) * node[e->row][e->column];
    }
    return sum;
}

/* w_n = sum_{j<n} (1 - S+ S)^j S+ v_p: of particle velocities (1 - S S+)^j v_p, one by one. */
static void series(const struct weights *weights, const double *v, int order, double w[64][64])
{
    double rest[512], term[64][64];
    memcpy(rest, v, weights->particles * sizeof *v);
    memset(w, 0, 64 * sizeof w[0]);
    for (int j = 0; j < order; j++) {
        to_nodes(weights, rest, term);
        for (int k = 0; k < 64 * 64; k++)
            w[k / 64][k % 64] += term[k / 64][k % 64];
        for (size_t p = 0; p < weights->particles; p++)
            rest[p] -= at_particle(weights, p, term, -1);
    }
}

/* The first step of USL has no forces, so that both position updates are the same, and updates F
 * last, with dF = 1 + dt grad v. */
START_TEST(xpic_and_fmpm_are_the_series_of_their_papers)
{
    static const enum mpm_shape kinds[] = {MPM_CLASSIC, MPM_UGIMP, MPM_CPDI, MPM_BSPLINE2,
                                           MPM_BSPLINE3};
    static const double ROUND_OFF = 1e-13;
    enum { ORDER = 4 };
    const bool fmpm = _i / SHAPES == 1;
    struct settings settings = {.count = 0};
    add(&settings,
        "method={shape: %s, stress_update: usl, deformation_terms: 1, position_update: %s, "
        "transfer: {kind: %s, order: %d}}",
        shapes[_i % SHAPES], _i % 2 == 0 ? "grid_velocity" : "midpoint", fmpm ? "fmpm" : "xpic",
        ORDER);
    set_wild_velocity(&settings, false);
    struct test_run run = open_block(&settings, 1);
    struct weights *const weights = weights_of(&run, kinds[_i % SHAPES]);
    double *const x0 = test_run_field(&run, MPM_FIELD_POSITION, NULL);
    double *const v0 = test_run_field(&run, MPM_FIELD_VELOCITY, NULL);
    test_run_steps(&run, 1);
    double *const x = test_run_field(&run, MPM_FIELD_POSITION, NULL);
    double *const v = test_run_field(&run, MPM_FIELD_VELOCITY, NULL);
    double *const f = test_run_field(&run, MPM_FIELD_DEFORMATION_GRADIENT, NULL);
    const double dt = mpm_simulation_time_step(run.simulation);
    for (size_t axis = 0; axis < 2; axis++) {
        double start[512], w[64][64], lumped[64][64];
        for (size_t p = 0; p < weights->particles; p++)
            start[p] = v0[2 * p + axis];
        series(weights, start, ORDER, w);
        series(weights, start, 1, lumped);
        for (size_t p = 0; p < weights->particles; p++) {
            const size_t k = 2 * p + axis;
            ck_assert_near(v[k], at_particle(weights, p, w, -1), ROUND_OFF);
            ck_assert_near(x[k], x0[k] + dt * at_particle(weights, p, fmpm ? w : lumped, -1),
                           10.0 * ROUND_OFF);
            for (int along = 0; along < 2; along++)
                ck_assert_near(f[5 * p + 2 * axis + (size_t)along],
                               ((int)axis == along ? 1.0 : 0.0) +
                                   dt * at_particle(weights, p, fmpm ? w : lumped, along),
                               ROUND_OFF);
        }
    }
    free(x0);
    free(v0);
    free(x);
    free(v);
    free(f);
    g_free(weights);
    test_run_close(&run);
}
END_TEST

/* PIC filters what FLIP keeps: whatever the motion, energy goes. */
START_TEST(pic_loses_energy_in_every_step)
{
    enum { STEPS = 30 };
    struct settings settings = {.count = 0};
    add_method(&settings, shapes[_i], "stress_update: usavg", "{kind: pic}");
    set_wild_velocity(&settings, false);
    struct test_run run = open_block(&settings, 1);
    double before = ledger_of(&run).total_energy;
    for (int k = 0; k < STEPS; k++) {
        test_run_steps(&run, 1);
        const double total = ledger_of(&run).total_energy;
        ck_assert(total < before);
        before = total;
    }
    test_run_close(&run);
}
END_TEST

/* -------------------------------------------------------------------- APIC */

/* Strains of some per cent, across cells: forces within keep it as the transfers do. */
START_TEST(apic_keeps_angular_momentum_to_round_off)
{
    enum { STEPS = 80 };
    struct settings settings = {.count = 0};
    add_method(&settings, shapes[1 + _i % (SHAPES - 1)], orders[_i / (SHAPES - 1)], "{kind: apic}");
    add(&settings, "bodies.block.velocity=['1-0.2*(y-5)+sin(y)', '0.2*x+cos(1.2*y)']");
    struct test_run run = open_block(&settings, 1);
    const struct mpm_ledger start = ledger_of(&run);
    test_run_steps(&run, STEPS);
    const struct mpm_ledger end = ledger_of(&run);
    /* sums of m (x v_y - y v_x), each up to 14 m, of which the nodes round each */
    const double round_off = STEPS * 14.0 * 64 * DBL_EPSILON * start.mass;
    ck_assert(fabs(start.angular_momentum) > 1e6 * round_off);
    ck_assert_near(end.angular_momentum, start.angular_momentum, round_off);
    ck_assert(end.strain_energy > 1e-4 * start.kinetic_energy);
    test_run_close(&run);
}
END_TEST

/* In place, a spin goes to the grid and back with all it has, in every family: particles get
 * the velocity and the spin of the nodes. */
START_TEST(apic_takes_back_the_spin_that_it_gave)
{
    static const double SPIN = 1e-9, PATH = 1e-9; /* cells travelled: what D_p changes by */
    struct settings settings = {.count = 0};
    add_method(&settings, shapes[_i], "stress_update: usl", "{kind: apic}");
    add(&settings, "bodies.block.velocity=['-%g*(y-5.6)', '%g*(x-5.75)']", SPIN, SPIN);
    struct test_run run = open_block(&settings, 1);
    const double start = ledger_of(&run).angular_momentum;
    test_run_steps(&run, 3);
    ck_assert_near(ledger_of(&run).angular_momentum, start, PATH * start);
    test_run_close(&run);
}
END_TEST

/* ----------------------------------------------------------------------- forms */

/* Eight cells from the edges of the body below: a particle has the same mass at all its nodes, and
 * nothing that edges do in a step comes there. */
static bool is_inside(const double x[2])
{
    return x[0] > 11.0 && x[0] < 13.0 && x[1] > 9.6 && x[1] < 11.2;
}

START_TEST(both_forms_are_one_where_the_nodes_have_one_mass)
{
    static const enum mpm_field fields[] = {MPM_FIELD_POSITION, MPM_FIELD_VELOCITY,
                                            MPM_FIELD_DEFORMATION_GRADIENT};
    /* and what comes from the edges by the thin ends of cubic splines */
    static const double ROUND_OFF = 1e-12;
    static const char *const kinds[] = {"{kind: flip}", "{kind: pic}", "{fraction: 0.9}"};
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = {.count = 0};
        add(&settings, "method={shape: %s, %s, transfer: %s, position_update: %s, form: %s}",
            shapes[_i % SHAPES], orders[_i / SHAPES], kinds[_i % 3],
            _i % 2 == 0 ? "midpoint" : "grid_velocity", k == 0 ? "velocity" : "momentum");
        set_wild_velocity(&settings, false);
        add(&settings, "grid.cells=[24, 26]");
        add(&settings, "bodies.block.region.rectangle={from: [3, 3.2], to: [21, 17.6]}");
        add(&settings, "loads={body_force: [0.5, '0.3*x']}");
        runs[k] = open_block(&settings, 1);
    }
    size_t n;
    double *const start = test_run_field(&runs[0], MPM_FIELD_POSITION, &n);
    test_run_steps(&runs[0], 1);
    test_run_steps(&runs[1], 1);
    int inside = 0;
    for (size_t f = 0; f < G_N_ELEMENTS(fields); f++) {
        const size_t components = mpm_field_describe(fields[f])->components;
        double *const one = test_run_field(&runs[0], fields[f], NULL);
        double *const other = test_run_field(&runs[1], fields[f], NULL);
        double edge = 0.0;
        for (size_t k = 0; k < n * components; k++)
            if (is_inside(&start[2 * (k / components)])) {
                ck_assert_near(other[k], one[k], ROUND_OFF);
                inside++;
            } else {
                edge = fmax(edge, fabs(other[k] - one[k]));
            }
        ck_assert(edge > 1e-4); /* where the mass has a slope, the momentum has it too */
        free(one);
        free(other);
    }
    ck_assert_int_ge(inside, 9 * 16);
    free(start);
    test_run_close(&runs[0]);
    test_run_close(&runs[1]);
}
END_TEST

START_TEST(usavg_extrapolates_unless_told_otherwise)
{
    static const char *const words[] = {"", ", extrapolate: true", ", extrapolate: false"};
    struct test_run runs[3];
    for (int k = 0; k < 3; k++) {
        struct settings settings = {.count = 0};
        add(&settings, "method={stress_update: usavg%s}", words[k]);
        set_wild_velocity(&settings, false);
        runs[k] = open_block(&settings, 1);
        test_run_steps(&runs[k], 10);
    }
    ck_assert(same_bits(&runs[0], &runs[1]));
    ck_assert(difference(&runs[0], &runs[2], MPM_FIELD_DEFORMATION_GRADIENT) > 1e-6);
    for (int k = 0; k < 3; k++)
        test_run_close(&runs[k]);
}
END_TEST

/* --------------------------------------------------------------------- runs */

/* Enough particles for three workers, in several strips. */
START_TEST(any_number_of_threads_gives_the_same_bits)
{
    static const char *const methods[] = {
        "transfer: {kind: xpic, order: 3}",
        "transfer: {kind: fmpm, order: 3}, shape: cpdi, stress_update: usavg",
        "transfer: {kind: apic}, stress_update: usavg",
        "form: momentum, shape: cpdi, transfer: {fraction: 0.9}",
    };
    struct test_run runs[3];
    for (int k = 0; k < 3; k++) {
        struct settings settings = {.count = 0};
        add(&settings, "method={%s}", methods[_i]);
        add(&settings, "grid.cells=[60, 70]");
        add(&settings, "bodies.block.region.rectangle={from: [3, 3.2], to: [53, 51.2]}");
        add(&settings, "bodies.block.velocity=['sin(y/5)', 'cos(x/4)']");
        add(&settings, "boundary=[{region: {line: {from: [0, 3.2], to: [60, 3.2]}}, "
                       "velocity: [free, '0.1*cos(t)']}]");
        runs[k] = open_block(&settings, k + 1);
        test_run_steps(&runs[k], 6);
    }
    ck_assert(same_bits(&runs[0], &runs[1]));
    ck_assert(same_bits(&runs[0], &runs[2]));
    for (int k = 0; k < 3; k++)
        test_run_close(&runs[k]);
}
END_TEST

/* The last good state has the affine part that the next step would have begun with: repeated
 * from the copy after the last sort, past one. */
START_TEST(after_a_failure_the_affine_part_is_that_of_the_last_good_step)
{
    struct mpm_error error = {.message = ""};
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = {.count = 0};
        add_method(&settings, shapes[_i], "stress_update: musl", "{kind: apic}");
        set_wild_velocity(&settings, false);
        add(&settings, "loads={body_force: ['0*x+sqrt(1-t)', 0]}");
        runs[k] = open_block(&settings, 1);
    }
    while (mpm_simulation_advance(runs[0].simulation, 100.0, &error) == MPM_OK)
        test_run_steps(&runs[1], 1);
    ck_assert_int_eq(error.status, MPM_RUN_FAILED);
    const struct mpm_ledger failed = ledger_of(&runs[0]), good = ledger_of(&runs[1]);
    ck_assert(good.step > (_i == CLASSIC ? 2 : 40));
    ck_assert(same_bits(&runs[0], &runs[1]));
    ck_assert(failed.angular_momentum == good.angular_momentum);
    test_run_close(&runs[0]);
    test_run_close(&runs[1]);
}
END_TEST

START_TEST(what_has_no_fast_kernels_is_refused_with_the_reason)
{
    static const struct {
        const char *setting, *reason;
    } rows[] = {
        {"method.transfer.kind=apic", "there are no fast kernels for method.transfer: apic"},
        {"method.form=momentum", "there are no fast kernels for method.form: momentum"}};
    const struct mpm_simulation_options fast = {.threads = 1, .kernels = MPM_KERNELS_FAST};
    for (size_t k = 0; k < G_N_ELEMENTS(rows); k++) {
        const char *const settings[] = {rows[k].setting, NULL};
        struct test_run run = test_run_open(BLOCK, settings, 1);
        struct mpm_error error = {.message = ""};
        struct mpm_simulation *refused = NULL;
        struct mpm_plan plan;
        ck_assert_str_eq(mpm_simulation_kernels(run.simulation), "reference");
        ck_assert_int_eq(mpm_simulation_create(run.scene, &fast, &refused, &error), MPM_BAD_INPUT);
        ck_assert_ptr_null(refused);
        ck_assert_ptr_nonnull(strstr(error.message, rows[k].reason));
        ck_assert_int_eq(mpm_scene_plan(run.scene, &(struct mpm_simulation_options){.threads = 1},
                                        &plan, &error),
                         MPM_OK);
        ck_assert_str_eq(plan.kernels_reason, rows[k].reason);
        test_run_close(&run);
    }
}
END_TEST

Suite *suite_transfers(void)
{
    Suite *const suite = suite_create("transfers");
    TCase *const all = tcase_create("every transfer");
    tcase_add_loop_test(all, a_rigid_translation_is_exact, 0, COMBINATIONS);
    tcase_add_loop_test(all, linear_momentum_is_conserved_to_round_off, 0, COMBINATIONS);
    tcase_add_loop_test(all, held_nodes_keep_their_velocity_in_every_order, 0, COMBINATIONS);
    suite_add_tcase(suite, all);
    TCase *const filters = tcase_create("filters");
    tcase_add_loop_test(filters, order_one_of_xpic_and_fmpm_is_pic, 0, SHAPES * ORDERS);
    tcase_add_loop_test(filters, xpic_of_higher_order_loses_less_and_tends_to_flip, 0,
                        SHAPES * 2); /* orders without a stress update at the start */
    tcase_add_loop_test(filters, xpic_and_fmpm_are_the_series_of_their_papers, 0, 2 * SHAPES);
    tcase_add_loop_test(filters, pic_loses_energy_in_every_step, 0, SHAPES);
    suite_add_tcase(suite, filters);
    TCase *const affine = tcase_create("affine");
    tcase_add_loop_test(affine, apic_keeps_angular_momentum_to_round_off, 0, (SHAPES - 1) * ORDERS);
    tcase_add_loop_test(affine, apic_takes_back_the_spin_that_it_gave, 0, SHAPES);
    suite_add_tcase(suite, affine);
    TCase *const forms = tcase_create("forms");
    tcase_add_loop_test(forms, both_forms_are_one_where_the_nodes_have_one_mass, 0,
                        SHAPES * ORDERS);
    tcase_add_test(forms, usavg_extrapolates_unless_told_otherwise);
    suite_add_tcase(suite, forms);
    TCase *const runs = tcase_create("runs");
    tcase_add_loop_test(runs, any_number_of_threads_gives_the_same_bits, 0, 4);
    tcase_add_loop_test(runs, after_a_failure_the_affine_part_is_that_of_the_last_good_step, 0,
                        SHAPES);
    tcase_add_test(runs, what_has_no_fast_kernels_is_refused_with_the_reason);
    suite_add_tcase(suite, runs);
    return suite;
}

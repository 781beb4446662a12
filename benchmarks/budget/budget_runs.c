/* The runs that have a budget.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/budget/budget_runs.h"

/* One sort within them, beside the one at the start. */
enum { STEPS = 40 };

#define PLANAR       "block.yaml"
#define AXISYMMETRIC "block_axisymmetric.yaml"

/* Across the grid, through a quarter of the strips, with both tips inside. */
#define CRACK(contact) "cracks=[{points: [[1.6, 2.1], [3.2, 2.9]], " contact "}]"

/* Two bodies that touch along a line across the grid, twenty cells of the 400. */
#define TWO_BODIES                                                                                 \
    "bodies=[{name: lower, material: rubber, region: {rectangle: {from: [0, 0], to: [5, 2.5]}}, "  \
    "velocity: ['0.5*sin(pi*x/5)*cos(pi*y/5)', '-0.5*cos(pi*x/5)*sin(pi*y/5)']}, "                 \
    "{name: upper, material: rubber, region: {rectangle: {from: [0, 2.5], to: [5, 5]}}, "          \
    "velocity: ['0.5*sin(pi*x/5)*cos(pi*y/5)', '-0.5*cos(pi*x/5)*sin(pi*y/5)']}]"
#define CONTACT(law) TWO_BODIES, "contact={fields: bodies, " law "}"

/* What block.yaml takes to conduct heat as well. */
#define UNITS    "units={length: m, mass: kg, time: s, temperature: K}"
#define CAPACITY "materials.rubber.heat_capacity=1"
#define CONDUCTS "materials.rubber.conductivity=0.1"
#define HEAT     "transport={temperature: {start: 'x'}}"

/* Strength, pressure and viscosity of a metal that yields at a tenth of the block's stresses. */
#define METAL                                                                                      \
    "materials=[{name: rubber, density: 1, law: johnson_cook_gruneisen, shear: 30, "               \
    "yield_stress: 0.1, hardening_coefficient: 0.1, hardening_exponent: 0.3, "                     \
    "rate_coefficient: 0.02, reference_rate: 0.001, softening_exponent: 1, "                       \
    "reference_temperature: 300, melting_temperature: 1700, start_temperature: 300, "              \
    "specific_heat: 1, taylor_quinney: 0.9, sound_speed: 7.746, hugoniot_slope: 1.5, "             \
    "gruneisen: 2, viscosity: {linear: 0.2, quadratic: 1.5}}]"

/* Of 1600 particles, but for R1 with its 352. */
const struct budget_run budget_runs[] = {
    {"planar uGIMP MUSL", PLANAR, MPM_KERNELS_AUTO, {NULL}},
    {"planar uGIMP USAVG", PLANAR, MPM_KERNELS_AUTO, {"method.stress_update=usavg"}},
    {"planar classic MUSL", PLANAR, MPM_KERNELS_AUTO, {"method.shape=classic"}},
    {"planar CPDI MUSL", PLANAR, MPM_KERNELS_AUTO, {"method.shape=cpdi"}},
    {"axisymmetric uGIMP MUSL", AXISYMMETRIC, MPM_KERNELS_AUTO, {NULL}},
    {"axisymmetric CPDI MUSL", AXISYMMETRIC, MPM_KERNELS_AUTO, {"method.shape=cpdi"}},
    {"axisymmetric uGIMP MUSL, metal that yields", AXISYMMETRIC, MPM_KERNELS_AUTO, {UNITS, METAL}},
    {"R1 with its ring", "R/R1", MPM_KERNELS_AUTO, {NULL}},
    {"planar uGIMP MUSL, crack", PLANAR, MPM_KERNELS_AUTO, {CRACK("contact: none")}},
    {"planar uGIMP MUSL, crack with friction",
     PLANAR,
     MPM_KERNELS_AUTO,
     {CRACK("contact: friction, friction: 0.3")}},
    {"axisymmetric CPDI USAVG, crack with friction",
     AXISYMMETRIC,
     MPM_KERNELS_AUTO,
     {"method.shape=cpdi", "method.stress_update=usavg",
      CRACK("contact: friction, friction: 0.3")}},
    {"planar uGIMP MUSL, contact with friction",
     PLANAR,
     MPM_KERNELS_AUTO,
     {CONTACT("law: friction, friction: 0.3")}},
    {"planar CPDI USAVG, interface, normals by logistic regression",
     PLANAR,
     MPM_KERNELS_AUTO,
     {"method.shape=cpdi", "method.stress_update=usavg",
      CONTACT("law: interface, tension: 10, shear: 10, normal: logistic")}},
    {"heat alone, planar uGIMP", "heat.yaml", MPM_KERNELS_AUTO, {NULL}},
    {"heat alone, planar CPDI", "heat.yaml", MPM_KERNELS_AUTO, {"method.shape=cpdi"}},
    {"planar uGIMP MUSL with heat", PLANAR, MPM_KERNELS_AUTO, {UNITS, CAPACITY, CONDUCTS, HEAT}},
    {"reference, heat alone, planar uGIMP", "heat.yaml", MPM_KERNELS_REFERENCE, {NULL}},
    {"reference, planar uGIMP MUSL", PLANAR, MPM_KERNELS_REFERENCE, {NULL}},
    {"reference, axisymmetric CPDI USAVG",
     AXISYMMETRIC,
     MPM_KERNELS_REFERENCE,
     {"method.shape=cpdi", "method.stress_update=usavg"}},
};
const size_t budget_runs_count = G_N_ELEMENTS(budget_runs);

enum mpm_status budget_run_count(const struct budget_run *run, const struct budget_places *places,
                                 struct instructions *counted, struct mpm_error *error)
{
    const bool own = g_str_has_suffix(run->scene, ".yaml");
    char *scene = own ? g_build_filename(places->benchmarks, "scenes", run->scene, NULL)
                      : g_build_filename(places->catalogue, run->scene, "scene.yaml", NULL);
    const char *settings[BUDGET_SETTINGS + 2] = {NULL};
    size_t count = 0;
    if (own)
        settings[count++] = "grid.refine=4";
    for (size_t i = 0; run->settings[i] != NULL; i++)
        settings[count++] = run->settings[i];
    const struct instructions_request request = {.program = places->program,
                                                 .scene = scene,
                                                 .settings = settings,
                                                 .simulation = {.kernels = run->kernels},
                                                 .steps = STEPS};
    const enum mpm_status status = instructions_count(&request, counted, error);
    g_free(scene);
    return status;
}

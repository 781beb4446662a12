/* What a scene may use, off and on.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/groups/overhead_features.h"

#include <string.h>

#define PLANAR       "free_block.yaml"
#define AXISYMMETRIC "free_cylinder.yaml"

#define STEPS_ALONE   "plain"
#define START_AND_END "run, start and end written"

/* A run of a few hundred steps of fixed length, slow enough not to leave the grid. */
#define RUN  "time={end: 100, step: 0.003}"
#define SLOW "bodies.block.velocity=['0.1*sin(pi*(y-1)/5)', 0]"

/* A column of particles beside the block, and the block as it is in the scene. */
#define WALL_AND_BLOCK                                                                             \
    "bodies=[{name: block, material: rubber, region: {rectangle: {from: [1, 1], to: [6, 6]}}, "    \
    "velocity: ['0.3 + 0.2*sin(pi*(y-1)/5)', '0.2 + 0.2*cos(pi*(x-1)/5)']}, "                      \
    "{name: wall, rigid: {velocity: [0.3, free]}, particles_per_cell: [1, 1], "                    \
    "region: {rectangle: {from: [6, 1], to: [6.1, 6]}}}]"

#define TWO_LINES                                                                                  \
    "boundary=[{region: {line: {from: [0, 1], to: [7, 1]}}, velocity: [free, 0.2]}, "              \
    "{region: {line: {from: [1, 0], to: [1, 7]}}, velocity: [0.3, free]}]"

/* 10^5 particles: what a crack costs goes with its length. */
#define MANY           "grid.refine=32"
#define ALONG          "[[1, 3.5], [3.5, 3.5]]"
#define ACROSS         "[[2.25, 2.25], [4.4375, 4.78125]]"
#define MANY_PARTICLES "plain, 10^5 particles"
#define ALONG_GRID     "crack along the grid"

/* Two bodies of 10^5 particles each, which touch along a line across the block. */
#define TWICE_AS_MANY "grid.refine=44"
#define LOWER_AND_UPPER                                                                            \
    "bodies=[{name: lower, material: rubber, region: {rectangle: {from: [1, 1], to: [6, 3.5]}}, "  \
    "velocity: ['0.3 + 0.2*sin(pi*(y-1)/5)', '0.2 + 0.2*cos(pi*(x-1)/5)']}, "                      \
    "{name: upper, material: rubber, region: {rectangle: {from: [1, 3.5], to: [6, 6]}}, "          \
    "velocity: ['0.3 + 0.2*sin(pi*(y-1)/5)', '0.2 + 0.2*cos(pi*(x-1)/5)']}]"
#define TWO_BODIES "two bodies as one field, 2 x 10^5 particles"

const struct overhead_feature overhead_features[] = {
    {STEPS_ALONE, NULL, false, PLANAR, {NULL}, "plane strain, uGIMP, MUSL, neo-Hookean, FLIP"},
    {"axisymmetry",
     STEPS_ALONE,
     false,
     AXISYMMETRIC,
     {NULL},
     "shape functions weighted with r, and a hoop term: a fifth to a quarter more"},
    {"USAVG",
     STEPS_ALONE,
     false,
     PLANAR,
     {"method.stress_update=usavg"},
     "one more pass over the particles: a third to a half more"},
    {"plane stress",
     STEPS_ALONE,
     false,
     PLANAR,
     {"geometry=plane_stress"},
     "a thickness stretch is found by iteration in each particle: a fifth to a half more"},
    {"linear elastic",
     STEPS_ALONE,
     false,
     PLANAR,
     {"materials.rubber.law=linear_elastic"},
     "no power of J: no dearer than neo-Hookean"},
    {"FLIP fraction 0.99",
     STEPS_ALONE,
     false,
     PLANAR,
     {"method.transfer.fraction=0.99"},
     "one more term at the nodes and a product for each particle: under 5 %"},
    {"body force",
     STEPS_ALONE,
     false,
     PLANAR,
     {"loads.body_force=[0, -1]"},
     "the same everywhere, so all of it is done at the nodes: under 5 %"},
    {"body force, an expression",
     STEPS_ALONE,
     false,
     PLANAR,
     {"loads.body_force=['0.1*sin(x)', 0]"},
     "an expression evaluated for each particle costs what its functions cost"},
    {"traction on all faces",
     STEPS_ALONE,
     false,
     PLANAR,
     {"loads.tractions=[{body: block, edge: all, frame: edge, value: [-0.01, 0]}]"},
     "a pass over the edges of faces alone: in proportion to their number"},
    {"boundary conditions",
     STEPS_ALONE,
     false,
     PLANAR,
     {TWO_LINES},
     "only nodes on the lines are touched: under 5 %"},
    {"rigid body",
     STEPS_ALONE,
     false,
     PLANAR,
     {WALL_AND_BLOCK},
     "its own particles and the nodes that they reach: in proportion to its size"},
    {"heat",
     STEPS_ALONE,
     false,
     PLANAR,
     {"units={length: m, mass: kg, time: s, temperature: K}", "materials.rubber.heat_capacity=1",
      "materials.rubber.conductivity=0.1", "transport={temperature: {start: 'x'}}"},
     "one number more to spread, to conduct and to update, 38 % more instructions; 20 % is the "
     "aim"},
    {"large empty grid",
     STEPS_ALONE,
     false,
     PLANAR,
     {"grid.cells=[50, 50]", "grid.origin=[-22, -22]"},
     "100 times the cells of the body; passes visit active rows only: under 5 %"},
    {MANY_PARTICLES, NULL, false, PLANAR, {MANY}, "the same scene, for cracks"},
    {ALONG_GRID,
     MANY_PARTICLES,
     false,
     PLANAR,
     {MANY, "cracks=[{points: " ALONG ", contact: none}]"},
     "half of the block's width, by the particles beside it alone: 5 %"},
    {"crack across the grid",
     MANY_PARTICLES,
     false,
     PLANAR,
     {MANY, "cracks=[{points: " ACROSS ", contact: none}]"},
     "two thirds of the block's width, more particles a cell of it than along the grid: under 10 "
     "%"},
    {"crack across, with friction",
     MANY_PARTICLES,
     false,
     PLANAR,
     {MANY, "cracks=[{points: " ACROSS ", contact: friction, friction: 0.3}]"},
     "areas and surfaces of nodes besides: under 15 %"},
    {"J every 32 steps",
     ALONG_GRID,
     false,
     PLANAR,
     {MANY, "cracks=[{points: " ALONG ", contact: none, j_integral: [{contour: 10, propagation: "
            "{toughness: 1e30, longest: 1, every: 32}}]}]"},
     "one pass over the particles, two stencils of those near the tip: under 3 %, so that J every "
     "100 "
     "steps is under 1 %"},
    {TWO_BODIES, NULL, false, PLANAR, {TWICE_AS_MANY, LOWER_AND_UPPER}, "the same, for contact"},
    {"contact without friction",
     TWO_BODIES,
     false,
     PLANAR,
     {TWICE_AS_MANY, LOWER_AND_UPPER, "contact={fields: bodies, law: frictionless}"},
     "the particles beside the line, one in forty, with areas, surfaces and their distance: 5 % is "
     "the aim"},
    {"contact with friction",
     TWO_BODIES,
     false,
     PLANAR,
     {TWICE_AS_MANY, LOWER_AND_UPPER, "contact={fields: bodies, law: friction, friction: 0.3}"},
     "the same exchange of momentum with one more component: no dearer than without"},
    {START_AND_END, NULL, true, PLANAR, {RUN, SLOW, "output={}"}, "steps and files of a whole run"},
    {"ledger every 100 steps",
     START_AND_END,
     true,
     PLANAR,
     {RUN, SLOW, "output={history: 0.3}"},
     "one pass with a logarithm for each particle in 100 steps: under 2 %"},
    {"usual output",
     START_AND_END,
     true,
     PLANAR,
     {RUN, SLOW, "output={history: 0.03, snapshots: 0.3}"},
     "a row every 10 steps and a snapshot every 100: a tenth of the run"},
};
const size_t overhead_feature_count = sizeof overhead_features / sizeof *overhead_features;

size_t overhead_feature_find(const char *name)
{
    size_t i = 0;
    while (strcmp(overhead_features[i].name, name) != 0)
        i++;
    return i;
}

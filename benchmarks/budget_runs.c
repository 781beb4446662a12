/* The runs that have a budget.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/budget_runs.h"

/* One sort within them, beside the one at the start. */
enum { STEPS = 40 };

#define AXISYMMETRIC                                                                               \
    "geometry=axisymmetric", "bodies.0.velocity.0='20*(r - 12)/12'",                               \
        "bodies.0.region.rectangle.from=[0, 4]"

const struct budget_run budget_runs[] = {
    {.name = "planar uGIMP MUSL"},
    {.name = "planar uGIMP USAVG", .settings = {"method.stress_update=usavg"}},
    {.name = "planar classic MUSL", .settings = {"method.shape=classic"}},
    {.name = "planar CPDI MUSL", .settings = {"method.shape=cpdi"}},
    {.name = "axisymmetric uGIMP MUSL", .settings = {AXISYMMETRIC}},
    {.name = "axisymmetric CPDI MUSL", .settings = {AXISYMMETRIC, "method.shape=cpdi"}},
    {.name = "R1 with its ring", .case_folder = "R/R1"},
    {.name = "reference kernels, planar uGIMP MUSL", .kernels = "reference"},
    {.name = "reference kernels, axisymmetric CPDI USAVG",
     .kernels = "reference",
     .settings = {AXISYMMETRIC, "method.shape=cpdi", "method.stress_update=usavg"}},
};
const size_t budget_run_count = G_N_ELEMENTS(budget_runs);

enum mpm_status budget_run_count_cost(const struct budget_run *run,
                                      const struct budget_places *places, struct budget_cost *cost,
                                      struct mpm_error *error)
{
    char *scene =
        run->case_folder != NULL
            ? g_build_filename(places->catalogue, run->case_folder, "scene.yaml", NULL)
            : g_build_filename(places->benchmarks, "scenes", "budget.yaml", NULL);
    const struct instructions_request request = {.program = places->program,
                                                 .scene = scene,
                                                 .settings = run->settings,
                                                 .kernels = run->kernels,
                                                 .steps = STEPS};
    struct instructions counted;
    const enum mpm_status status = instructions_count(&request, &counted, error);
    if (status == MPM_OK)
        *cost = budget_cost_of(&counted);
    g_free(scene);
    return status;
}

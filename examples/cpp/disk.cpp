// The library from C++: a disk that is compressed radially, step by step, with owners that free
// what they hold. Prints relative volume and mean pressure.
//
//     c++ -std=c++11 disk.cpp -o disk $(pkg-config --cflags --libs touchstone)
//
// SPDX-License-Identifier: GPL-3.0-or-later
#include <mpm.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

struct Deleter {
    void operator()(mpm_scene *scene) const
    {
        mpm_scene_free(scene);
    }
    void operator()(mpm_draft *draft) const
    {
        mpm_draft_free(draft);
    }
    void operator()(mpm_simulation *simulation) const
    {
        mpm_simulation_free(simulation);
    }
};
template <typename T> using Owner = std::unique_ptr<T, Deleter>;

void check(mpm_status status, const mpm_error &error)
{
    if (status != MPM_OK)
        throw std::runtime_error(error.message);
}

const std::string text = R"(
format: 1
geometry: axisymmetric
units: {length: mm, mass: g, time: ms}
grid: {cell: [2.5, 2.5], cells: [24, 4]}
time: {end: 0.6, courant: 0.4}
materials:
  - {name: polymer, law: neo_hookean, density: 1.2e-3, bulk: 2254.9, shear: 864.662}
bodies:
  - name: disk
    material: polymer
    region: {rectangle: {from: [0, 0], to: [50, 10]}}
    velocity: ["-8.31*r/50", 0]
  - {name: ring, rigid: {velocity: [-8.31, free]}, region: {rectangle: {from: [50, 0], to: [55, 10]}}}
boundary:
  - {region: {line: {from: [0, 0], to: [60, 0]}}, velocity: [free, 0]}
  - {region: {line: {from: [0, 10], to: [60, 10]}}, velocity: [free, 0]}
)";

Owner<mpm_scene> make_scene(const std::string &shape)
{
    mpm_error error = {};
    mpm_draft *made = nullptr;
    check(mpm_draft_create("disk", text.data(), text.size(), &made, &error), error);
    const Owner<mpm_draft> draft(made);
    check(mpm_draft_set_text(draft.get(), "method.shape", shape.c_str(), &error), error);
    mpm_scene *scene = nullptr;
    check(mpm_draft_build(draft.get(), &scene, &error), error);
    return Owner<mpm_scene>(scene);
}

void run(const mpm_scene &scene)
{
    mpm_error error = {};
    mpm_simulation_options options = {};
    options.threads = 1;
    mpm_simulation *made = nullptr;
    check(mpm_simulation_create(&scene, &options, &made, &error), error);
    const Owner<mpm_simulation> simulation(made);
    const double end = mpm_scene_end_time(&scene);
    while (mpm_simulation_time(made) < end)
        check(mpm_simulation_advance(made, end, &error), error);
    check(mpm_simulation_judge(made, &error), error);

    const std::size_t count = mpm_simulation_particle_count(made);
    std::vector<double> body(count), stress(4 * count);
    mpm_simulation_field(made, MPM_FIELD_BODY, body.data());
    mpm_simulation_field(made, MPM_FIELD_STRESS, stress.data());
    double pressure = 0, number = 0;
    for (std::size_t id = 0; id < count; id++)
        if (body[id] < 0.5) {
            pressure -= (stress[4 * id] + stress[4 * id + 1] + stress[4 * id + 2]) / 3;
            number++;
        }
    mpm_ledger ledger = {};
    mpm_simulation_ledger(made, &ledger);
    std::printf("relative volume %.4f to %.4f, mean pressure %.1f MPa\n", ledger.j_min,
                ledger.j_max, pressure / number);
}

} // namespace

int main(int argc, char **argv)
{
    try {
        const Owner<mpm_scene> scene = make_scene(argc > 1 ? argv[1] : "ugimp");
        run(*scene);
    } catch (const std::exception &failure) {
        std::fprintf(stderr, "disk: %s\n", failure.what());
        return 1;
    }
    return 0;
}

/* The test suites, in the order they run. A new file test_<module>.c exports
 * `Suite *suite_<module>(void)`, includes this header and is one line here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUITES_H
#define TESTS_SUITES_H

#include <check.h>

#define SUITES(SUITE)                                                                              \
    SUITE(support)                                                                                 \
    SUITE(status)                                                                                  \
    SUITE(base)                                                                                    \
    SUITE(workers)                                                                                 \
    SUITE(expression)                                                                              \
    SUITE(material)                                                                                \
    SUITE(particles)                                                                               \
    SUITE(scene)                                                                                   \
    SUITE(properties)                                                                              \
    SUITE(energy)                                                                                  \
    SUITE(guard)                                                                                   \
    SUITE(transfers)                                                                               \
    SUITE(transfer_series)                                                                         \
    SUITE(projection)                                                                              \
    SUITE(law_state)                                                                               \
    SUITE(forms)                                                                                   \
    SUITE(loads)                                                                                   \
    SUITE(user_force)                                                                              \
    SUITE(start)                                                                                   \
    SUITE(energy_balance)                                                                          \
    SUITE(damping)                                                                                 \
    SUITE(grid_drag)                                                                               \
    SUITE(nodal_force)                                                                             \
    SUITE(rest)                                                                                    \
    SUITE(rest_loads)                                                                              \
    SUITE(time_step)                                                                               \
    SUITE(fill)                                                                                    \
    SUITE(edges)                                                                                   \
    SUITE(tractions)                                                                               \
    SUITE(shapes)                                                                                  \
    SUITE(exact)                                                                                   \
    SUITE(fracture)                                                                                \
    SUITE(static_states)                                                                           \
    SUITE(jets)                                                                                    \
    SUITE(manufactured)                                                                            \
    SUITE(activity)                                                                                \
    SUITE(results)                                                                                 \
    SUITE(cli)                                                                                     \
    SUITE(cli_check)                                                                               \
    SUITE(catalogue)                                                                               \
    SUITE(methods)                                                                                 \
    SUITE(comparison)                                                                              \
    SUITE(labels)                                                                                  \
    SUITE(comparison_page)                                                                         \
    SUITE(judge)                                                                                   \
    SUITE(report)                                                                                  \
    SUITE(score_parts)                                                                             \
    SUITE(score_readers)                                                                           \
    SUITE(score_snapshots)                                                                         \
    SUITE(score_numbers)                                                                           \
    SUITE(score)                                                                                   \
    SUITE(docs)                                                                                    \
    SUITE(report_site)                                                                             \
    SUITE(scene_run)                                                                               \
    SUITE(budget)                                                                                  \
    SUITE(scene_limits)                                                                            \
    SUITE(scene_cracks)                                                                            \
    SUITE(crack_line)                                                                              \
    SUITE(j_integral)                                                                              \
    SUITE(crack_growth)                                                                            \
    SUITE(cracks)                                                                                  \
    SUITE(contact_conditions)                                                                      \
    SUITE(crack_detection)                                                                         \
    SUITE(crack_kernels)                                                                           \
    SUITE(fields)                                                                                  \
    SUITE(crack_mouths)                                                                            \
    SUITE(cohesive)                                                                                \
    SUITE(cohesive_laws)                                                                           \
    SUITE(symmetry)                                                                                \
    SUITE(scene_settings)                                                                          \
    SUITE(schema)                                                                                  \
    SUITE(suite)                                                                                   \
    SUITE(bench)                                                                                   \
    SUITE(timing)                                                                                  \
    SUITE(kernels)                                                                                 \
    SUITE(kernel_table)                                                                            \
    SUITE(kernel_bits)                                                                             \
    SUITE(pareto)                                                                                  \
    SUITE(accuracy)                                                                                \
    SUITE(bench_report)                                                                            \
    SUITE(programs)                                                                                \
    SUITE(orders)                                                                                  \
    SUITE(pictures)                                                                                \
    SUITE(measures)                                                                                \
    SUITE(modes)                                                                                   \
    SUITE(dispersion)                                                                              \
    SUITE(damped_motion)                                                                           \
    SUITE(stability)

#define SUITE_DECLARE(name) Suite *suite_##name(void);
SUITES(SUITE_DECLARE)
#undef SUITE_DECLARE

#endif

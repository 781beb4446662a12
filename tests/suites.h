/* The test suites, in the order they run: those that take longest first, so that no processor waits
 * for the last one. A new file test_<module>.c exports `Suite *suite_<module>(void)`, includes this
 * header and is one line here. APART: each test needs a process of its own, with a comment in its
 * file that states why.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUITES_H
#define TESTS_SUITES_H

#include "support/marks.h"

#define SUITES(SUITE, APART)                                                                       \
    SUITE(docs)                                                                                    \
    SUITE(kernels)                                                                                 \
    SUITE(kernel_table)                                                                            \
    SUITE(cli)                                                                                     \
    SUITE(properties)                                                                              \
    SUITE(checkpoint)                                                                              \
    SUITE(checkpoint_file)                                                                         \
    SUITE(interruption)                                                                            \
    SUITE(kernel_bits)                                                                             \
    SUITE(energy_balance)                                                                          \
    SUITE(j_integral)                                                                              \
    SUITE(j_refusals)                                                                              \
    SUITE(damping)                                                                                 \
    SUITE(crack_growth)                                                                            \
    SUITE(grown_surfaces)                                                                          \
    SUITE(crack_ends)                                                                              \
    SUITE(score)                                                                                   \
    SUITE(user_force)                                                                              \
    SUITE(loads)                                                                                   \
    SUITE(cohesive)                                                                                \
    SUITE(contact_conditions)                                                                      \
    SUITE(rest_loads)                                                                              \
    SUITE(tractions)                                                                               \
    SUITE(transfers)                                                                               \
    SUITE(score_numbers)                                                                           \
    SUITE(stability)                                                                               \
    SUITE(law_state)                                                                               \
    SUITE(forms)                                                                                   \
    SUITE(accuracy)                                                                                \
    SUITE(support)                                                                                 \
    SUITE(status)                                                                                  \
    SUITE(base)                                                                                    \
    APART(workers)                                                                                 \
    SUITE(expression)                                                                              \
    SUITE(material)                                                                                \
    SUITE(von_mises)                                                                               \
    SUITE(plane_stress)                                                                            \
    SUITE(johnson_cook)                                                                            \
    SUITE(gruneisen_solid)                                                                         \
    SUITE(equation_of_state)                                                                       \
    SUITE(viscosity)                                                                               \
    SUITE(spall)                                                                                   \
    SUITE(parting)                                                                                 \
    SUITE(particles)                                                                               \
    SUITE(property)                                                                                \
    SUITE(scene)                                                                                   \
    SUITE(energy)                                                                                  \
    SUITE(guard)                                                                                   \
    SUITE(transfer_series)                                                                         \
    SUITE(heat)                                                                                    \
    SUITE(heat_runs)                                                                               \
    SUITE(heat_tables)                                                                             \
    SUITE(scalar_smoothing)                                                                        \
    SUITE(heat_contact)                                                                            \
    SUITE(scalar_exchange)                                                                         \
    SUITE(expansion)                                                                               \
    SUITE(expansion_runs)                                                                          \
    SUITE(heat_fields)                                                                             \
    SUITE(heat_layers)                                                                             \
    SUITE(heat_manufactured)                                                                       \
    SUITE(scene_transport)                                                                         \
    SUITE(projection)                                                                              \
    SUITE(start)                                                                                   \
    SUITE(grid_drag)                                                                               \
    SUITE(nodal_force)                                                                             \
    SUITE(rest)                                                                                    \
    SUITE(time_step)                                                                               \
    SUITE(fill)                                                                                    \
    SUITE(edges)                                                                                   \
    SUITE(shapes)                                                                                  \
    SUITE(exact)                                                                                   \
    SUITE(contact_solutions)                                                                       \
    SUITE(fracture)                                                                                \
    SUITE(interface)                                                                               \
    SUITE(contact_states)                                                                          \
    SUITE(plastic_states)                                                                          \
    SUITE(impact_states)                                                                           \
    SUITE(static_states)                                                                           \
    SUITE(jets)                                                                                    \
    SUITE(manufactured)                                                                            \
    SUITE(activity)                                                                                \
    SUITE(results)                                                                                 \
    SUITE(history)                                                                                 \
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
    SUITE(report_site)                                                                             \
    SUITE(scene_run)                                                                               \
    SUITE(budget)                                                                                  \
    SUITE(scene_limits)                                                                            \
    SUITE(scene_materials)                                                                         \
    SUITE(scene_cracks)                                                                            \
    SUITE(contact_solve)                                                                           \
    SUITE(contact_edges)                                                                           \
    SUITE(cracked_bodies)                                                                          \
    SUITE(contact_points)                                                                          \
    SUITE(rigid_contact)                                                                           \
    SUITE(body_contact)                                                                            \
    SUITE(scene_contact)                                                                           \
    SUITE(crack_line)                                                                              \
    SUITE(cracks)                                                                                  \
    SUITE(crack_detection)                                                                         \
    SUITE(crack_transfers)                                                                         \
    SUITE(crack_kernels)                                                                           \
    SUITE(fields)                                                                                  \
    SUITE(crack_mouths)                                                                            \
    SUITE(cohesive_laws)                                                                           \
    SUITE(symmetry)                                                                                \
    SUITE(scene_settings)                                                                          \
    SUITE(schema)                                                                                  \
    SUITE(suite)                                                                                   \
    SUITE(bench)                                                                                   \
    SUITE(timing)                                                                                  \
    SUITE(pareto)                                                                                  \
    SUITE(bench_report)                                                                            \
    SUITE(programs)                                                                                \
    SUITE(orders)                                                                                  \
    SUITE(pictures)                                                                                \
    SUITE(measures)                                                                                \
    SUITE(modes)                                                                                   \
    SUITE(dispersion)                                                                              \
    SUITE(damped_motion)

#define SUITE_DECLARE(name) Suite *suite_##name(void);
SUITES(SUITE_DECLARE, SUITE_DECLARE)
#undef SUITE_DECLARE

#endif

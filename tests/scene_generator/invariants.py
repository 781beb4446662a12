"""The list of invariants.

SPDX-License-Identifier: GPL-3.0-or-later
"""

from balance import (a_failed_run_leaves_the_step_before, momentum_changes_by_external_forces,
                     no_blow_up_passes_for_a_result, runs_end_as_promised,
                     the_ledger_closes_in_every_step, work_needs_motion)
from contact import (another_crack_beside_changes_nothing, detections_agree,
                     surfaces_do_not_pass_through)
from coupling import (bodies_free_of_stress_stay, gas_in_a_closed_box_stays,
                      heat_between_bodies_is_counted, no_expansion_changes_no_digit,
                      perfect_bonds_make_one_body, perfect_cracks_are_none,
                      solvent_is_heat_by_another_name, substeps_are_steps,
                      substeps_that_nothing_needs_change_nothing)
from energy import energies_are_the_work_of_tractions
from halves import half_is_the_whole
from heat import (a_held_gradient_stays, an_even_source_warms_evenly,
                  heat_alone_is_heat_in_a_body_at_rest, heat_moves_nothing,
                  heat_stored_is_heat_taken_in, one_temperature_stays, prescribed_temperatures_hold,
                  surroundings_warm_what_is_colder, temperatures_have_no_zero,
                  temperatures_stay_between, tensors_in_other_words)
from images import (bodies_in_another_order, cracks_in_another_order,
                    fast_kernels_are_the_reference, fields_in_another_order, mirrored_along_x,
                    mirrored_along_y, moved_by_whole_cells, other_units_change_no_digit,
                    refinement_is_a_finer_grid, thickness_scales_sums_alone,
                    threads_and_instructions_change_no_bit, turned_by_a_right_angle)
from motion import (an_unloaded_body_stays_at_rest, conditions_hold_at_every_node,
                    half_the_step_halves_the_error)
from plastic import elastic_until_yield, perfect_metals_are_one, plastic_work_never_falls
from resume import a_resumed_run_changes_no_bit

# Cheapest first. What a run must fulfil before others are evaluated comes first of all.
ALWAYS = [runs_end_as_promised, no_blow_up_passes_for_a_result, the_ledger_closes_in_every_step,
          momentum_changes_by_external_forces, work_needs_motion, heat_stored_is_heat_taken_in,
          temperatures_stay_between, plastic_work_never_falls]
SOMETIMES = [moved_by_whole_cells, mirrored_along_x, mirrored_along_y, turned_by_a_right_angle,
             bodies_in_another_order, cracks_in_another_order, fields_in_another_order,
             fast_kernels_are_the_reference, other_units_change_no_digit,
             thickness_scales_sums_alone, refinement_is_a_finer_grid,
             a_resumed_run_changes_no_bit, threads_and_instructions_change_no_bit, conditions_hold_at_every_node,
             half_is_the_whole, a_failed_run_leaves_the_step_before, an_unloaded_body_stays_at_rest,
             half_the_step_halves_the_error,
             energies_are_the_work_of_tractions, surfaces_do_not_pass_through,
             another_crack_beside_changes_nothing, detections_agree, temperatures_have_no_zero,
             one_temperature_stays, heat_alone_is_heat_in_a_body_at_rest, an_even_source_warms_evenly,
             a_held_gradient_stays, prescribed_temperatures_hold,
             surroundings_warm_what_is_colder, heat_moves_nothing, tensors_in_other_words,
             solvent_is_heat_by_another_name, no_expansion_changes_no_digit,
             bodies_free_of_stress_stay, gas_in_a_closed_box_stays,
             substeps_that_nothing_needs_change_nothing, substeps_are_steps,
             heat_between_bodies_is_counted, perfect_bonds_make_one_body, perfect_cracks_are_none,
             elastic_until_yield, perfect_metals_are_one]
ALL = {function.__name__: function for function in ALWAYS + SOMETIMES}

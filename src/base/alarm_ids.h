#pragma once
// The ids of all alarms that Kadr can raise; each id has one meaning. The texts (English, Russian) and the advice are in
// controls/alarms.toml. The number and wording that a particular control uses are in [alarms] of the control's file. A test checks that
// this list and alarms.toml agree.

// clang-format off
#define KADR_ALARMS(X)                                                                       \
  /* alarms of reading the program: encoding, punched tape, words */                         \
  X(parity_error) X(bad_encoding) X(line_too_long) X(block_too_long)                         \
  X(unexpected_character) X(control_character) X(look_alike_letter) X(address_unknown)       \
  X(number_missing) X(number_damaged) X(too_many_digits) X(too_few_digits)                   \
  X(too_many_decimals) X(point_not_allowed) X(sign_not_allowed) X(address_twice)             \
  X(too_many_words) X(too_many_codes) X(comment_not_closed) X(comment_character)             \
  X(block_number_missing) X(block_number_position) X(end_of_block_missing)                   \
  X(program_start_missing) X(program_number_damaged) X(skip_position)                        \
  X(mark_letter) X(call_digits) X(expression_syntax) X(bracket_not_closed) X(nesting_too_deep) X(operator_unknown)         \
  X(function_unknown) X(parameter_not_allowed)                     \
  /* alarms of codes and words without a valid meaning */                                    \
  X(code_unknown) X(group_conflict) X(word_unused) X(word_passed_over) X(axis_passed_over) X(word_without_effect) X(word_missing) X(word_not_integer) \
  X(value_out_of_range) X(no_axis_word) X(own_block) X(not_together)                         \
  X(variable_unknown) X(variable_not_set)                              \
  X(division_by_zero) X(not_a_number)                                                        \
  /* motion */                                                                               \
  X(feed_missing) X(feed_limited) X(radius_mismatch) X(radius_too_small) X(center_missing)   \
  X(arc_not_in_plane) X(full_circle_by_radius) X(arc_radius_zero) X(turns_not_whole)         \
  X(no_motion_mode) X(polar_motion) X(plane_wrong) X(rotary_motion)                          \
  X(compensation_active) X(scale_zero)                         \
  X(machine_motion_mode) X(zero_change) X(position_out_of_range)                             \
  /* spindle, tool, offsets */                                                               \
  X(speed_without_direction) X(speed_missing) X(spindle_not_turning) X(spindle_direction)                     \
  X(corrector_unknown) X(corrector_axis) X(not_stated)                                       \
  /* flow */                                                                                 \
  X(subprogram_missing) X(subprogram_end_missing) X(return_without_call) X(call_too_deep)    \
  X(repeat_end_missing) X(repeat_end_alone) X(endless_program) X(label_twice) X(end_missing)\
  /* canned cycles */                                                                        \
  X(cycle_level) X(cycle_repeats) X(cycle_peck) X(cycle_endless) X(cycle_undefined) X(cycle_word_taken) \
  X(stepover_out_of_range) X(cycle_override)                                                 \
  /* probe and machine */                                                                    \
  X(probe_too_close) X(probe_no_contact) X(probe_feed_mode) X(limit_exceeded)                \
  X(interrupted)                                                                             \
  /* custom macros (nct 23) */                                                               \
  X(not_available) X(illegal_address) X(equals_missing) X(increment_not_allowed)             \
  X(terminator_wrong) X(while_without_do) X(do_number) X(end_without_do) X(do_without_end)   \
  X(loops_overlap) X(statement_not_alone) X(block_not_found) X(number_by_variable)           \
  X(root_of_negative) X(tangent_of_right_angle) X(argument_above_one)                        \
  X(argument_not_positive) X(value_limit) X(bits_out_of_range) X(variable_read_only)         \
  X(variable_write_only) X(axis_number_wrong) X(program_alarm) X(message_number)             \
  X(modal_macro_missing) X(program_name_missing)                                             \
  /* alarms of files in the program memory (nct 14.4, 23.2.13) */                            \
  X(program_missing) X(file_missing) X(program_file_exists) X(file_exists) X(file_name)      \
  X(file_outside) X(file_not_open) X(file_already_open) X(file_write) X(file_mode)           \
  X(print_format) X(programs_alike)                                                          \
  /* warnings of words that a control ignores (spec/fanuc 1.1, 3.2, 6.5, 6.6) */             \
  X(text_passed_over) X(engraving_font) X(center_passed_over) X(arc_is_line) X(machine_move_incremental) X(reference_without_axes) \
  /* parameters (nct 24) */                                                                  \
  X(parameter_unknown) X(parameter_not_writable) X(parameter_argument) X(data_block)         \
  /* alarms of spindles, tools and M codes (nct 11 to 13) */                                 \
  X(m_codes_contradict) X(one_spindle) X(spindle_of_other_channel) X(spindle_not_indexable)  \
  X(spindle_not_orientable) X(spindle_loop_open) X(spindle_not_referenced) X(tool_not_found) X(length_of_other_tool) \
  X(magazine_number) X(too_many_m_codes)                                                     \
  /* alarms of geometry, cycles and probes (nct 4, 10, 18, 19, 21) */                        \
  X(thread_definition) X(thread_axes) X(incremental_in_machine) X(plane_illegal)             \
  X(surface_state) X(surface_start) X(smoothing_length) X(cycle_data_missing) \
  X(probe_state) X(probe_torque) X(probe_torque_axis) X(probe_torque_unknown) X(probe_servo_error) \
  X(probe_window) X(contour_block_missing) X(contour_order) X(contour_shape)                 \
  X(outline_missing) X(contour_tool_large) X(contour_not_closed) X(cycle_tool_radius) X(axis_not_named) X(axes_assumed) \
  X(rough_uncompensated)                                                                   \
  /* alarms of turning cycles and of lathes (spec/fanuc-t 12) */                             \
  X(figure_words) X(figure_depth) X(figure_block_missing) X(figure_not_monotone)             \
  X(figure_not_monotone_second) X(figure_first_block) X(figure_unavailable)                  \
  X(figure_corner_last) X(figure_direct_last) X(figure_over_start) X(figure_type_two)        \
  X(pattern_repeats) X(groove_relief) X(groove_end) X(groove_step) X(thread_angle)           \
  X(thread_cut_depth) X(thread_height) X(thread_lead_change) X(turning_axis)                 \
  X(chamfer_in_taper) X(chamfer_not_square) X(turret_number) X(figure_wrong_side)            \
  X(corner_in_thread) X(corner_at_side_change) X(offset_value) X(cycle_block_unavailable)    \
  X(contour_angle_end) X(contour_end_missing) X(feed_without_turns) X(tool_changer_code)     \
  X(compensation_at_end) X(turning_tool_without_shape)                                       \
  /* alarms of zones (nct 22), in-position (nct 4.1.1), channels (nct 14.5) */               \
  X(zone1_positive) X(zone1_negative) X(zone2_positive) X(zone2_negative) X(zone2_inside)    \
  X(zone3_inside) X(zone2_entry) X(zone3_entry)                                              \
  X(zone1_reached_positive) X(zone1_reached_negative) X(zone2_reached_positive)              \
  X(zone2_reached_negative) X(zone2_reached_inside) X(zone3_reached_inside)                  \
  X(position_error) X(channels_wait)                                                         \
  X(channel_list)                                                                            \
  /* coupled axes (nct 20) */                                                                \
  X(gear_not_on) X(coupling_parameter) X(axis_follows)                              \
  /* alarms of cutter compensation (nct 15.5) */                                             \
  X(compensation_no_intersection) X(compensation_buffer) X(compensation_turn)                \
  X(compensation_begins_in_arc) X(compensation_ends_in_arc) X(compensation_needed) X(compensation_plane)           \
  X(compensation_interference) X(contour_cut) X(beside_contour)                              \
  /* transformations (nct 16) */                                                             \
  X(mirror_state)                                                      \
  /* alarms of cutter compensation on other controls (2С42 6.4.7, Mach3 10.7.13) */          \
  X(compensation_entry_short) X(compensation_corner_sharp) X(compensation_gouge)             \
  X(compensation_two_blocks) X(compensation_closing) X(compensation_zero)                    \
  /* alarms of cutter compensation on LinuxCNC (spec/linuxcnc 7.5) */                        \
  X(entry_line_within_tool) X(entry_arc_within_tool) X(arc_within_tool) X(gouge_feed)        \
  X(gouge_rapid) X(gouge_arc) X(gouge_arc_to_line) X(gouge_arc_to_arc) X(arcs_same_center)   \
  X(offset_arc_radii) X(compensated_thread)                                                  \
  /* pocket cycle (spec/correctors 3) */                                                     \
  X(pocket_tool_missing) X(pocket_tool_large) X(pocket_corner) X(pocket_too_long)            \
  X(pocket_above_solid) X(corrector_not_set)                                                 \
  /* alarms of rules in the manual of the 2С42, and of old programs and tapes */             \
  X(reference_again) X(reference_late) X(plane_without_stop) X(return_not_alone)             \
  X(length_beside_radius) X(subprogram_shadowed) X(code_digits) X(program_number_place)      \
  X(tape_reversed)                                                                           \
  /* automatic geometry (nct 17) */                                                          \
  X(chamfer_and_rounding) X(corner_illegal) X(corner_too_large) X(contour_no_intersection)   \
  X(intersection_needs_side) X(angle_meets_not) X(angle_alone)                              \
  /* alarms of contours and area milling (spec/correctors 4) */                              \
  X(rapid_in_stock) X(holder_in_stock) X(shank_in_stock) X(beyond_flutes) X(spindle_stopped) X(spindle_wrong_way) \
  X(fixture) X(machine) X(drill_sideways) X(plunge) X(no_coolant) X(tool_without_shape) \
  X(contour_syntax) X(contour_word_missing) X(contour_unit) X(contour_radius)                \
  X(contour_empty) X(contour_too_large) X(contour_reach) X(contour_open_end)                 \
  X(contour_branch) X(contour_crosses) X(mill_value) X(mill_hole) X(mill_lathe) \
  X(tool_does_not_fit) X(mill_stepover) X(mill_too_long) X(mill_wall) X(mill_rapid) X(mill_uncut)          \
  X(mill_read_back) X(word_has_no_room) X(word_below_format) X(function_has_no_code) X(conversion_too_long) X(conversion_takes_long) X(conversion_unstated) X(result_too_large) X(program_number_zero) \
  /* alarms of the least-time planner and its samples (docs/planner.md) */                   \
  X(plan_unsolved) X(plan_tolerance) X(plan_endless) X(samples_too_long) \
  /* warnings of probable mistakes in a program, and notes */                                \
  X(feed_above_rapid) X(program_begins_again) X(passes_done) X(block_number_vacant)          \
  X(arctangent_divides) X(axis_is_spindle) X(length_no_axis) \
  /* five axes */                                                                            \
  X(no_five_axes) X(frame_axis) X(frames_too_many) X(plane_q) X(plane_points) X(plane_degenerate) X(frame_missing) \
  X(length_missing) X(words_exclude) X(direction_unreachable) X(lead_mode) X(lead_state) X(lead_words) X(lead_angle) \
  X(normal_missing) X(direction_zero) X(axis_whirls) X(axis_kept) X(axis_not_changed) X(gear_too_fast) X(diameter_by_machine) \
  /* alarms of RS274/NGC: named parameters, O words, files */                                \
  X(variable_name_open) X(equal_sign_missing) X(exists_parameter) X(exists_bracket) X(function_bracket) X(power_of_negative) \
  X(o_word_unknown) X(o_word_bracket) X(o_word_rest) X(o_word_arguments) X(comment_not_carried_out) X(tapping_axes_turned) \
  X(loop_runs_again) X(loop_ends_early) X(spline_weight_missing) X(spline_word_ignored) X(spline_too_large) \
  X(rs274_form) X(rs274_codes) X(rs274_words) X(rs274_parameter) X(rs274_expression) X(rs274_motion) X(rs274_arc) \
  X(rs274_compensation) X(rs274_cycle) X(rs274_spindle) X(rs274_data) X(rs274_tool) X(rs274_flow) X(rs274_program) X(rs274_probe) \
  X(rs274_io) X(rs274_abort) \
  /* alarms of Grbl, which checks each line by itself (spec/grbl) */                          \
  X(value_below_zero) X(block_number_large) X(tool_number_large) X(system_number_large) X(length_axis_wrong) X(arc_without_plane_word) \
  X(jog_code) X(jog_target) X(system_line) X(system_line_passed) X(homing_off) X(soft_limits_need_homing) X(step_pulse_short) \
  X(reference_in_cycle) X(reference_missed) X(look_ahead_wrong) X(call_without_program) X(dwell_missing) X(table_kind_unknown) X(pocket_words_wrong) X(machine_code_unknown) X(offset_number_large) \
  /* alarms of 32-bit floats and speeds of Grbl (spec/grbl 1.3, 5.2), of LinuxCNC 2.9, of probes missing in the set-up */  \
  X(single_arc_turns) X(single_arc_path) X(single_arc_refused) X(single_arc_passed) X(speed_beyond_setting) X(percent_passed_over) \
  X(sub_in_sub) X(machine_move_with_offset) X(probe_unstated) \
  /* alarms of block search, end-position switches, gantry axes (nct 13.1, 20.6, 22.1) */    \
  X(search_not_reached) X(search_forgets) X(switch_positive) X(switch_negative) X(gantry_apart) \
  /* alarms of a control with names, types and procedures (spec/sinumerik 18) */             \
  X(name_unknown) X(name_defined_twice) X(label_missing) X(section_missing) X(structure_wrong) X(structure_open) X(structure_deep) \
  X(operand_type) X(comparison_chained) X(conversion_impossible) X(text_not_number) X(index_range) X(arguments_too_many) \
  X(argument_type) X(argument_reference) X(definition_late) X(parameters_without_proc) X(skip_level_wrong) X(passes_wrong) \
  X(arc_two_ways) X(arc_opening_angle) X(arc_through_point) X(arc_turns) X(polar_with_axes) X(polar_radius_negative) \
  X(frame_component) X(edge_missing) X(cycle_reference_plane) X(cycle_first_depth) X(cycle_direction) X(cycle_lead) \
  X(pattern_empty) X(compensation_without_tool) X(initial_values_too_many) X(working_area) X(rotary_position_wrong) \
  /* alarms of conversational blocks (spec/heidenhain 15) */                                \
  X(pole_missing) X(tangent_missing) X(element_missing) X(error_by_program) \
  /* advice of the checklist, which is Kadr's own (docs/checklist.md) */                     \
  X(point_forgotten) X(length_of_other) X(radius_of_other) X(length_not_called) X(feed_too_small) X(feed_too_large) \
  X(feed_per_tooth) X(tap_feed) X(cut_without_spindle) X(direction_of_others) X(coolant_forgotten) X(hole_lost) X(hole_twice) \
  X(levels_swapped) X(approach_short) X(compensation_left_on) X(compensation_ends_in_cut) X(arc_against_neighbours) \
  X(arc_nearly_full) X(rapid_below_zero) X(rapid_sideways_low) X(tool_change_low) X(units_changed) X(work_offset_once) \
  X(lines_unreachable) X(subprogram_uncalled) X(jump_to_nowhere) X(jump_to_two) X(mode_left_on) X(coordinate_far) \
  X(tool_unused) X(speed_beyond_spindle) X(surface_speed_unlimited) X(thread_beyond_rapid) X(beyond_chuck_face) X(tool_not_in_table) X(table_tools_unused) X(offset_row_unused) X(wear_sign)

// clang-format on

#pragma once
// The alarms Kadr can give, one meaning a row. Texts (English, Russian) and hints are data: controls/alarms.toml;
// a control's own number and wording: [alarms] of its file. A test holds the two lists against each other.

// clang-format off
#define KADR_ALARMS(X)                                                                       \
  /* the text: encodings, tape, words */                                                     \
  X(parity_error) X(bad_encoding) X(line_too_long) X(block_too_long)                         \
  X(unexpected_character) X(control_character) X(look_alike_letter) X(address_unknown)       \
  X(number_missing) X(number_damaged) X(too_many_digits) X(too_few_digits)                   \
  X(too_many_decimals) X(point_not_allowed) X(sign_not_allowed) X(address_twice)             \
  X(too_many_words) X(too_many_codes) X(comment_not_closed) X(comment_character)             \
  X(block_number_missing) X(block_number_position) X(end_of_block_missing)                   \
  X(program_start_missing) X(program_number_damaged) X(skip_position)                        \
  X(mark_letter) X(call_digits) X(expression_syntax) X(bracket_not_closed) X(nesting_too_deep) X(operator_unknown)         \
  X(function_unknown) X(parameter_not_allowed)                     \
  /* meaning: codes and words */                                                             \
  X(code_unknown) X(group_conflict) X(word_unused) X(word_missing) X(word_not_integer)       \
  X(value_out_of_range) X(no_axis_word) X(own_block) X(not_together)                         \
  X(variable_unknown) X(variable_not_set)                              \
  X(division_by_zero) X(not_a_number)                                                        \
  /* motion */                                                                               \
  X(feed_missing) X(feed_limited) X(radius_mismatch) X(radius_too_small) X(center_missing)   \
  X(arc_not_in_plane) X(full_circle_by_radius) X(arc_radius_zero) X(turns_not_whole)         \
  X(no_motion_mode) X(polar_motion) X(plane_wrong) X(rotary_motion)                          \
  X(compensation_not_available) X(compensation_active) X(scale_zero)                         \
  X(machine_motion_mode) X(zero_change) X(position_out_of_range)                             \
  /* spindle, tool, offsets */                                                               \
  X(speed_without_direction) X(speed_missing) X(spindle_not_turning) X(spindle_direction)                     \
  X(corrector_unknown) X(corrector_axis)                                                     \
  /* flow */                                                                                 \
  X(subprogram_missing) X(subprogram_end_missing) X(return_without_call) X(call_too_deep)    \
  X(repeat_end_missing) X(repeat_end_alone) X(endless_program) X(label_twice) X(end_missing)\
  /* cycles */                                                                               \
  X(cycle_level) X(cycle_repeats) X(cycle_peck) X(cycle_undefined) X(pocket_not_available)   \
  X(stepover_out_of_range) X(cycle_override)                                                 \
  /* probe and machine */                                                                    \
  X(probe_too_close) X(probe_no_contact) X(probe_feed_mode) X(limit_exceeded)                \
  X(interrupted)
// clang-format on

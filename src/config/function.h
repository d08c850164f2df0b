#pragma once
// What the engine can do. A control's file says which code or address calls which function (design.md 3);
// the phase is its place in the order of execution, which the control's file lists too.

#include <cstdint>
#include <string_view>

namespace kadr {

// clang-format off
#define KADR_PHASES(X)                                                                                   \
  X(message) X(parameter) X(unit) X(feed_mode) X(feed) X(speed_mode) X(speed) X(tool) X(tool_change)     \
  X(range) X(spindle) X(coolant) X(override) X(clamp) X(dwell) X(plane) X(offset_number) X(compensation) \
  X(length) X(zero) X(corner) X(path_mode) X(distance) X(transform) X(retract) X(data) X(positioning) X(motion) \
  X(dwell_after) X(spindle_stop) X(coolant_off) X(machine) X(stop) X(flow) X(none)

// name; phase it runs in unless the row says otherwise; whether it takes the axis words of the block; what calls it, an address or a code;
// what the control must have (config/function_needs.h): in any other the loader refuses the row
#define KADR_FUNCTIONS(X)                                                                                                                \
  /* addresses */                                                                                                                        \
  X(block_number, none, false, word, nothing) X(axis, none, false, word, no_nct) X(center, none, false, word, nothing)                   \
  X(word_of_code, none, false, word, nothing) X(feed_word, feed, false, word, nothing) X(speed_word, speed, false, word, no_nct)         \
  X(tool_word, tool, false, word, no_nct) X(offset_word, offset_number, false, word, no_nct)                                             \
  X(formal_parameter, none, false, word, no_nct) X(code, none, false, word, nothing) X(label, none, false, word, labels)                 \
  X(dwell_word, dwell_after, false, word, no_nct) X(repeat_word, flow, false, word, no_nct) X(call_word, flow, false, word, sections)    \
  X(corrector_word, none, false, word, correctors)                                                                                       \
  /* motion */                                                                                                                           \
  X(rapid, motion, true, code, nothing) X(linear, motion, true, code, nothing) X(arc_cw, motion, true, code, nothing)                    \
  X(arc_ccw, motion, true, code, nothing) X(cycle, motion, true, code, no_nct) X(no_motion, motion, false, code, no_nct)                 \
  X(circular_pocket, motion, true, code, no_nct) X(probe, motion, true, code, no_nct) X(home_through, data, true, code, no_nct)          \
  X(home_axes, data, true, code, no_nct) X(machine_point, motion, true, code, no_nct) X(machine_coordinates, none, false, code, no_nct)  \
  X(approach_reference, motion, true, code, no_nct) X(pole_rapid, motion, true, code, no_nct)                                            \
  X(pocket_define, motion, true, code, correctors) X(pocket_run, motion, true, code, correctors)                                         \
  /* modes */                                                                                                                            \
  X(plane_xy, plane, false, code, no_nct) X(plane_zx, plane, false, code, no_nct) X(plane_yz, plane, false, code, no_nct)                \
  X(absolute, distance, false, code, nothing) X(incremental, distance, false, code, nothing)                                             \
  X(centers_absolute, distance, false, code, no_nct) X(centers_incremental, distance, false, code, no_nct)                               \
  X(inch, unit, false, code, nothing) X(millimetre, unit, false, code, nothing) X(feed_inverse_time, feed_mode, false, code, no_nct)     \
  X(feed_per_minute, feed_mode, false, code, nothing) X(feed_per_revolution, feed_mode, false, code, nothing)                            \
  X(surface_speed, speed_mode, false, code, no_nct) X(spindle_rpm, speed_mode, false, code, no_nct)                                      \
  X(exact_stop_block, path_mode, false, code, nothing) X(exact_stop_mode, path_mode, false, code, nothing)                               \
  X(constant_velocity, path_mode, false, code, no_nct) X(corner_arc, corner, false, code, no_nct)                                        \
  X(corner_line, corner, false, code, no_nct) X(polar_on, transform, false, code, no_nct) X(polar_off, transform, false, code, no_nct)   \
  X(rotation_on, transform, true, code, no_nct) X(rotation_off, transform, false, code, no_nct)                                          \
  X(scale_on, transform, true, code, no_nct) X(scale_off, transform, false, code, no_nct)                                                \
  X(retract_initial, retract, false, code, nothing) X(retract_level, retract, false, code, nothing)                                      \
  X(override_permission, override, false, code, no_nct)                                                                                  \
  /* offsets */                                                                                                                          \
  X(radius_comp_off, compensation, false, code, no_nct) X(radius_comp_left, compensation, false, code, no_nct)                           \
  X(radius_comp_right, compensation, false, code, no_nct) X(compensation_off, compensation, false, code, no_nct)                         \
  X(length_plus, length, false, code, no_nct) X(length_minus, length, false, code, no_nct) X(length_off, length, false, code, no_nct)    \
  X(work_zero, zero, false, code, no_nct) X(fixture, zero, false, code, no_nct) X(zero_shift, data, true, code, no_nct)                  \
  X(temporary_shift, data, true, code, no_nct) X(set_position, data, true, code, no_nct)                                                 \
  X(set_position_reset, data, false, code, no_nct) X(set_position_suspend, data, false, code, no_nct)                                    \
  X(set_position_restore, data, false, code, no_nct) X(set_data, data, true, code, no_nct) X(part_zero, data, true, code, no_nct)        \
  X(corrector_plus, compensation, false, code, correctors) X(corrector_minus, compensation, false, code, correctors)                     \
  X(corrector_cancel, compensation, false, code, correctors)                                                                             \
  /* technology */                                                                                                                       \
  X(dwell, dwell, false, code, nothing) X(spindle_cw, spindle, false, code, no_nct) X(spindle_ccw, spindle, false, code, no_nct)         \
  X(spindle_stop, spindle_stop, false, code, no_nct) X(spindle_orient, spindle, false, code, no_nct)                                     \
  X(spindle_cw_coolant, spindle, false, code, no_nct) X(spindle_ccw_coolant, spindle, false, code, no_nct)                               \
  X(coolant_mist, coolant, false, code, nothing) X(coolant_flood, coolant, false, code, nothing)                                         \
  X(coolant_off, coolant_off, false, code, nothing) X(change_tool, tool_change, false, code, no_nct)                                     \
  X(override_on, override, false, code, no_nct) X(override_off, override, false, code, no_nct)                                           \
  X(machine_function, machine, false, code, nothing)                                                                                     \
  /* flow */                                                                                                                             \
  X(program_stop, stop, false, code, nothing) X(optional_stop, stop, false, code, nothing) X(program_end, flow, false, code, nothing)    \
  X(tape_end, flow, false, code, nothing) X(repeat_program, flow, false, code, no_nct) X(call_subprogram, flow, false, code, labels)     \
  /* nct: addresses */                                                                                                                   \
  X(machine_axis, none, false, word, nct) X(increment_axis, none, false, word, nct) X(argument_only, none, false, word, nct)             \
  X(auxiliary_word, machine, false, word, nct) X(spindle_word, speed, false, word, nct) X(spindle_axis_word, spindle, false, word, nct)  \
  X(tool_call, tool, false, word, nct) X(length_number, length, false, word, nct) X(radius_number, offset_number, false, word, nct)      \
  /* nct: motion and coordinates */                                                                                                      \
  X(thread, motion, true, code, nct) X(dwell_or_turns, dwell, false, code, nct) X(smoothing, path_mode, true, code, nct)                 \
  X(cylinder_mode, data, true, code, nct) X(set_tables, data, true, code, nct) X(set_tables_end, data, false, code, nct)                 \
  X(diameter_switch, data, true, code, nct) X(polar_surface_on, data, false, code, nct) X(polar_surface_off, data, false, code, nct)     \
  X(polar_data_on, transform, false, code, nct) X(polar_data_off, transform, false, code, nct) X(select_plane, plane, false, code, nct)  \
  X(work_area_on, data, true, code, nct) X(work_area_off, data, false, code, nct) X(reference_return, data, true, code, nct)             \
  X(measure, motion, true, code, nct) X(measure_length, motion, true, code, nct) X(radius_side, compensation, false, code, nct)          \
  X(length_comp, length, false, code, nct) X(mirror_on, transform, true, code, nct) X(mirror_off, transform, true, code, nct)            \
  X(scaling_on, transform, true, code, nct) X(scaling_off, transform, false, code, nct) X(plane_rotation_on, transform, true, code, nct) \
  X(plane_rotation_off, transform, false, code, nct) X(transform_off, transform, false, code, nct)                                       \
  X(local_system, data, true, code, nct) X(machine_move, data, true, code, nct) X(work_system, zero, false, code, nct)                   \
  X(work_system_extended, zero, false, code, nct) X(new_system, data, true, code, nct) X(feed_control, path_mode, false, code, nct)      \
  X(css_on, speed_mode, false, code, nct) X(css_off, speed_mode, false, code, nct) X(drilling, positioning, true, code, nct)             \
  X(drilling_off, motion, false, code, nct) X(turning_cycle, motion, true, code, nct) X(turning_simple, motion, true, code, nct)         \
  X(gear_on, data, false, code, nct) X(gear_off, data, false, code, nct) X(vector_hold, corner, false, code, nct)                        \
  X(vector_corner, data, false, code, nct) X(not_available, none, true, code, nothing)                                                   \
  /* nct: macros, programs, M codes */                                                                                                   \
  X(macro_call, flow, true, code, nct) X(macro_modal, flow, true, code, nct) X(macro_modal_off, flow, false, code, nct)                  \
  X(spindle_code, spindle, false, code, nct) X(gear_range, range, false, code, nct) X(exchange_tool, tool_change, false, code, nct)      \
  X(interrupt_on, flow, false, code, nct) X(interrupt_off, flow, false, code, nct) X(call_program, flow, false, code, nct)               \
  X(return_program, flow, false, code, nct) X(subprogram_return, flow, false, code, no_nct) X(subprogram_end, flow, false, code, no_nct) \
  X(repetition_end, flow, false, code, no_nct) X(permanent_subprogram, flow, true, code, no_nct)
// clang-format on

enum class Phase : std::uint8_t {
#define KADR_PHASE_ENUM(name) name,
  KADR_PHASES(KADR_PHASE_ENUM)
#undef KADR_PHASE_ENUM
      count
};

enum class Function : std::uint8_t {
#define KADR_FUNCTION_ENUM(name, ...) name,
  KADR_FUNCTIONS(KADR_FUNCTION_ENUM)
#undef KADR_FUNCTION_ENUM
      count
};

struct FunctionTraits {
  std::string_view name;
  Phase phase;
  bool takes_axes;  // the block's axis words are its own; no modal motion in that block
};

const FunctionTraits& traits_of(Function function);
Function function_named(std::string_view name);  // Function::count if there is none
Phase phase_named(std::string_view name);        // Phase::count if there is none
std::string_view name_of(Phase phase);

}  // namespace kadr

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

// name, phase it runs in unless the row says otherwise, whether it takes the axis words of the block
#define KADR_FUNCTIONS(X)                                                                                \
  /* addresses */                                                                                        \
  X(block_number, none, false)      X(axis, none, false)             X(center, none, false)              \
  X(word_of_code, none, false)      X(feed_word, feed, false)        X(speed_word, speed, false)         \
  X(tool_word, tool, false)         X(offset_word, offset_number, false)                                 \
  X(formal_parameter, none, false)  X(code, none, false)             X(label, none, false)               \
  X(dwell_word, dwell_after, false) X(repeat_word, flow, false)      X(call_word, flow, false)           \
  X(corrector_word, none, false)                                                                         \
  /* motion */                                                                                           \
  X(rapid, motion, true)            X(linear, motion, true)          X(arc_cw, motion, true)             \
  X(arc_ccw, motion, true)          X(cycle, motion, true)           X(no_motion, motion, false)         \
  X(circular_pocket, motion, true)  X(probe, motion, true)           X(home_through, data, true)         \
  X(home_axes, data, true)          X(machine_point, motion, true)   X(machine_coordinates, none, false) \
  X(approach_reference, motion, true) X(pole_rapid, motion, true)    X(pocket_define, motion, true)      \
  X(pocket_run, motion, true)                                                                            \
  /* modes */                                                                                            \
  X(plane_xy, plane, false)         X(plane_zx, plane, false)        X(plane_yz, plane, false)           \
  X(absolute, distance, false)      X(incremental, distance, false)                                      \
  X(centers_absolute, distance, false) X(centers_incremental, distance, false)                           \
  X(inch, unit, false)              X(millimetre, unit, false)                                           \
  X(feed_inverse_time, feed_mode, false) X(feed_per_minute, feed_mode, false)                            \
  X(feed_per_revolution, feed_mode, false)                                                               \
  X(surface_speed, speed_mode, false) X(spindle_rpm, speed_mode, false)                                  \
  X(exact_stop_block, path_mode, false) X(exact_stop_mode, path_mode, false)                             \
  X(constant_velocity, path_mode, false) X(corner_arc, corner, false) X(corner_line, corner, false)      \
  X(polar_on, transform, false)     X(polar_off, transform, false)                                       \
  X(rotation_on, transform, true)   X(rotation_off, transform, false)                                    \
  X(scale_on, transform, true)      X(scale_off, transform, false)                                       \
  X(retract_initial, retract, false) X(retract_level, retract, false)                                    \
  X(override_permission, override, false)                                                                \
  /* offsets */                                                                                          \
  X(radius_comp_off, compensation, false) X(radius_comp_left, compensation, false)                       \
  X(radius_comp_right, compensation, false) X(compensation_off, compensation, false)                     \
  X(length_plus, length, false)     X(length_minus, length, false)   X(length_off, length, false)        \
  X(work_zero, zero, false)         X(fixture, zero, false)          X(zero_shift, data, true)           \
  X(temporary_shift, data, true)    X(set_position, data, true)      X(set_position_reset, data, false)  \
  X(set_position_suspend, data, false) X(set_position_restore, data, false)                              \
  X(set_data, data, true)           X(part_zero, data, true)                                             \
  X(corrector_plus, compensation, false) X(corrector_minus, compensation, false)                         \
  X(corrector_cancel, compensation, false)                                                               \
  /* technology */                                                                                       \
  X(dwell, dwell, false)            X(spindle_cw, spindle, false)    X(spindle_ccw, spindle, false)      \
  X(spindle_stop, spindle_stop, false) X(spindle_orient, spindle, false)                                 \
  X(spindle_cw_coolant, spindle, false) X(spindle_ccw_coolant, spindle, false)                           \
  X(coolant_mist, coolant, false)   X(coolant_flood, coolant, false) X(coolant_off, coolant_off, false)  \
  X(change_tool, tool_change, false) X(override_on, override, false) X(override_off, override, false)    \
  X(machine_function, machine, false)                                                                    \
  /* flow */                                                                                             \
  X(program_stop, stop, false)      X(optional_stop, stop, false)    X(program_end, flow, false)         \
  X(tape_end, flow, false)          X(repeat_program, flow, false)   X(call_subprogram, flow, false)     \
  /* nct: addresses */                                                                                   \
  X(machine_axis, none, false)      X(increment_axis, none, false)   X(argument_only, none, false)       \
  X(auxiliary_word, machine, false) X(spindle_word, speed, false)    X(spindle_axis_word, spindle, false) \
  X(tool_call, tool, false)         X(length_number, length, false)  X(radius_number, offset_number, false) \
  /* nct: motion and coordinates */                                                                      \
  X(thread, motion, true)           X(dwell_or_turns, dwell, false)  X(smoothing, path_mode, true)       \
  X(cylinder_mode, data, true)      X(set_tables, data, true)        X(set_tables_end, data, false)      \
  X(diameter_switch, data, true)    X(polar_surface_on, data, false) X(polar_surface_off, data, false)   \
  X(polar_data_on, transform, false) X(polar_data_off, transform, false) X(select_plane, plane, false)   \
  X(work_area_on, data, true)       X(work_area_off, data, false)    X(reference_return, data, true)     \
  X(measure, motion, true)          X(measure_length, motion, true)  X(radius_side, compensation, false) \
  X(length_comp, length, false)     X(mirror_on, transform, true)    X(mirror_off, transform, true)      \
  X(scaling_on, transform, true)    X(scaling_off, transform, false)                                     \
  X(plane_rotation_on, transform, true) X(plane_rotation_off, transform, false)                          \
  X(transform_off, transform, false) X(local_system, data, true)     X(machine_move, data, true)         \
  X(work_system, zero, false)       X(work_system_extended, zero, false) X(new_system, data, true)       \
  X(feed_control, path_mode, false) X(css_on, speed_mode, false)     X(css_off, speed_mode, false)       \
  X(drilling, positioning, true)    X(drilling_off, motion, false)   X(turning_cycle, motion, true)      \
  X(turning_simple, motion, true)   X(gear_on, data, false)          X(gear_off, data, false)            \
  X(vector_hold, corner, false)     X(vector_corner, data, false)                                        \
  X(not_available, none, true)                                                                           \
  /* nct: macros, programs, M codes */                                                                   \
  X(macro_call, flow, true)         X(macro_modal, flow, true)       X(macro_modal_off, flow, false)     \
  X(spindle_code, spindle, false)   X(gear_range, range, false)      X(exchange_tool, tool_change, false) \
  X(interrupt_on, flow, false)      X(interrupt_off, flow, false)    X(call_program, flow, false)        \
  X(return_program, flow, false)                                                                         \
  X(subprogram_return, flow, false) X(subprogram_end, flow, false)   X(repetition_end, flow, false)     \
  X(permanent_subprogram, flow, true)
// clang-format on

enum class Phase : std::uint8_t {
#define KADR_PHASE_ENUM(name) name,
  KADR_PHASES(KADR_PHASE_ENUM)
#undef KADR_PHASE_ENUM
      count
};

enum class Function : std::uint8_t {
#define KADR_FUNCTION_ENUM(name, phase, axes) name,
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

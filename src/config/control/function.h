#pragma once
// The functions of the engine. A control's file states which code or address calls which function (docs/architecture.md, "A control is a
// file"). The phase of a function is its position in the order of execution, which the control's file lists too.

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kadr {

// clang-format off
#define KADR_PHASES(X)                                                                                   \
  X(message) X(parameter) X(unit) X(feed_mode) X(feed) X(speed_mode) X(speed) X(tool) X(tool_change)     \
  X(range) X(spindle) X(coolant) X(override) X(clamp) X(dwell) X(plane) X(offset_number) X(compensation) \
  X(length) X(zero) X(corner) X(path_mode) X(distance) X(transform) X(retract) X(data) X(positioning) X(motion) \
  X(dwell_after) X(spindle_stop) X(coolant_off) X(machine) X(stop) X(flow) X(none)

// One row per function, with everything that the engine knows about the function except its code.
//   phase:  the phase in which the function is executed, unless its row in the control's file states another one
//   axes:   own: the axis words of the block belong to the function, and the block has no modal motion
//   by:     what calls the function: an address (word) or a code
//   needs:  what the control must have (see Needs); the loader rejects the row on any other control
//   order:  within one phase, a cycle is cancelled before a motion, scaling and rotation before mirroring (nct 16.4); a repetition is
//           started first, then a call is made, then an end is processed
//   facts:  leaves_mode: a motion code in the same block only sets the mode (as G0 in `G0 G91 G28 Z0`) · ends: it ends the
//           program, a subprogram or a repetition · stops: it stops the program · calls: it calls a subprogram after the block's other
//           words have acted · passes_control: it calls or returns at once · plain_motion: G0 to G3 · breaks_contour: if cutter
//           compensation is active, the tool's centre goes to the programmed point first (nct 15.5.2) · steady: it changes nothing if it
//           is in force already
#define KADR_FUNCTIONS(X) \
  /* addresses */ \
  X(block_number,         none,          none, word, nothing,    usual, nothing) \
  X(axis,                 none,          none, word, no_nct,     usual, nothing) \
  X(center,               none,          none, word, nothing,    usual, nothing) \
  X(word_of_code,         none,          none, word, nothing,    usual, nothing) \
  X(feed_word,            feed,          none, word, nothing,    usual, nothing) \
  X(speed_word,           speed,         none, word, no_nct,     usual, nothing) \
  X(tool_word,            tool,          none, word, no_nct,     usual, nothing) \
  X(offset_word,          offset_number, none, word, no_nct,     usual, nothing) \
  X(formal_parameter,     none,          none, word, no_nct,     usual, nothing) \
  X(code,                 none,          none, word, nothing,    usual, nothing) \
  X(label,                none,          none, word, labels,     usual, nothing) \
  X(dwell_word,           dwell_after,   none, word, no_nct,     usual, nothing) \
  X(repeat_word,          flow,          none, word, no_nct,     first, nothing) \
  X(call_word,            flow,          none, word, sections,   call,  calls) \
  X(corrector_word,       none,          none, word, correctors, usual, nothing) \
  /* motion */ \
  X(rapid,                motion,        own,  code, nothing,    usual, plain_motion) \
  X(linear,               motion,        own,  code, nothing,    usual, plain_motion) \
  X(arc_cw,               motion,        own,  code, nothing,    usual, plain_motion) \
  X(arc_ccw,              motion,        own,  code, nothing,    usual, plain_motion) \
  X(cycle,                motion,        own,  code, no_nct,     usual, nothing) \
  X(no_motion,            motion,        none, code, no_nct,     first, nothing) \
  X(circular_pocket,      motion,        own,  code, no_nct,     usual, nothing) \
  X(probe,                motion,        own,  code, no_nct,     usual, nothing) \
  X(home_through,         data,          own,  code, no_nct,     usual, leaves_mode) \
  X(home_axes,            data,          own,  code, no_nct,     usual, leaves_mode) \
  X(machine_point,        motion,        own,  code, no_nct,     usual, leaves_mode) \
  X(machine_coordinates,  none,          none, code, no_nct,     usual, nothing) \
  X(approach_reference,   motion,        own,  code, no_nct,     usual, leaves_mode) \
  X(pole_rapid,           motion,        own,  code, no_nct,     usual, nothing) \
  X(pocket_define,        motion,        own,  code, correctors, usual, nothing) \
  X(pocket_run,           motion,        own,  code, correctors, usual, nothing) \
  /* modes */ \
  X(plane_xy,             plane,         none, code, no_nct,     usual, steady) \
  X(plane_zx,             plane,         none, code, no_nct,     usual, steady) \
  X(plane_yz,             plane,         none, code, no_nct,     usual, steady) \
  X(absolute,             distance,      none, code, nothing,    usual, steady) \
  X(incremental,          distance,      none, code, nothing,    usual, steady) \
  X(centers_absolute,     distance,      none, code, no_nct,     usual, steady) \
  X(centers_incremental,  distance,      none, code, no_nct,     usual, steady) \
  X(inch,                 unit,          none, code, nothing,    usual, nothing) \
  X(millimetre,           unit,          none, code, nothing,    usual, steady) \
  X(feed_inverse_time,    feed_mode,     none, code, no_nct,     usual, nothing) \
  X(feed_per_minute,      feed_mode,     none, code, nothing,    usual, steady) \
  X(feed_per_revolution,  feed_mode,     none, code, nothing,    usual, nothing) \
  X(surface_speed,        speed_mode,    none, code, no_nct,     usual, nothing) \
  X(spindle_rpm,          speed_mode,    none, code, no_nct,     usual, nothing) \
  X(exact_stop_block,     path_mode,     none, code, nothing,    usual, nothing) \
  X(exact_stop_mode,      path_mode,     none, code, nothing,    usual, nothing) \
  X(constant_velocity,    path_mode,     none, code, no_nct,     usual, nothing) \
  X(corner_arc,           corner,        none, code, no_nct,     usual, nothing) \
  X(corner_line,          corner,        none, code, no_nct,     usual, nothing) \
  X(polar_on,             transform,     none, code, no_nct,     usual, nothing) \
  X(polar_off,            transform,     none, code, no_nct,     usual, nothing) \
  X(rotation_on,          transform,     own,  code, no_nct,     usual, nothing) \
  X(rotation_off,         transform,     none, code, no_nct,     usual, nothing) \
  X(scale_on,             transform,     own,  code, no_nct,     usual, nothing) \
  X(scale_off,            transform,     none, code, no_nct,     usual, nothing) \
  X(retract_initial,      retract,       none, code, nothing,    usual, nothing) \
  X(retract_level,        retract,       none, code, nothing,    usual, nothing) \
  X(override_permission,  override,      none, code, no_nct,     usual, nothing) \
  /* offsets */ \
  X(radius_comp_off,      compensation,  none, code, no_nct,     usual, nothing) \
  X(radius_comp_left,     compensation,  none, code, no_nct,     usual, nothing) \
  X(radius_comp_right,    compensation,  none, code, no_nct,     usual, nothing) \
  X(compensation_off,     compensation,  none, code, no_nct,     usual, nothing) \
  X(length_plus,          length,        none, code, no_nct,     usual, nothing) \
  X(length_minus,         length,        none, code, no_nct,     usual, nothing) \
  X(length_off,           length,        none, code, no_nct,     usual, nothing) \
  X(work_zero,            zero,          none, code, no_nct,     usual, nothing) \
  X(fixture,              zero,          none, code, no_nct,     usual, nothing) \
  X(zero_shift,           data,          own,  code, no_nct,     usual, nothing) \
  X(temporary_shift,      data,          own,  code, no_nct,     usual, nothing) \
  X(set_position,         data,          own,  code, no_nct,     usual, nothing) \
  X(set_position_reset,   data,          none, code, no_nct,     usual, nothing) \
  X(set_position_suspend, data,          none, code, no_nct,     usual, nothing) \
  X(set_position_restore, data,          none, code, no_nct,     usual, nothing) \
  X(set_data,             data,          own,  code, no_nct,     usual, nothing) \
  X(part_zero,            data,          own,  code, no_nct,     usual, nothing) \
  X(corrector_plus,       compensation,  none, code, correctors, usual, nothing) \
  X(corrector_minus,      compensation,  none, code, correctors, usual, nothing) \
  X(corrector_cancel,     compensation,  none, code, correctors, usual, nothing) \
  /* technology */ \
  X(dwell,                dwell,         none, code, nothing,    usual, nothing) \
  X(spindle_cw,           spindle,       none, code, no_nct,     usual, nothing) \
  X(spindle_ccw,          spindle,       none, code, no_nct,     usual, nothing) \
  X(spindle_stop,         spindle_stop,  none, code, no_nct,     usual, nothing) \
  X(spindle_orient,       spindle,       none, code, no_nct,     usual, nothing) \
  X(spindle_cw_coolant,   spindle,       none, code, no_nct,     usual, nothing) \
  X(spindle_ccw_coolant,  spindle,       none, code, no_nct,     usual, nothing) \
  X(coolant_mist,         coolant,       none, code, nothing,    usual, nothing) \
  X(coolant_flood,        coolant,       none, code, nothing,    usual, nothing) \
  X(coolant_off,          coolant_off,   none, code, nothing,    usual, nothing) \
  X(change_tool,          tool_change,   none, code, no_nct,     usual, nothing) \
  X(override_on,          override,      none, code, no_nct,     usual, nothing) \
  X(override_off,         override,      none, code, no_nct,     usual, nothing) \
  X(machine_function,     machine,       none, code, nothing,    usual, nothing) \
  /* flow */ \
  X(program_stop,         stop,          none, code, nothing,    usual, stops | breaks_contour) \
  X(optional_stop,        stop,          none, code, nothing,    usual, stops | breaks_contour) \
  X(program_end,          flow,          none, code, nothing,    last,  ends | breaks_contour) \
  X(tape_end,             flow,          none, code, nothing,    last,  ends) \
  X(repeat_program,       flow,          none, code, no_nct,     usual, nothing) \
  X(call_subprogram,      flow,          none, code, labels,     call,  calls) \
  /* nct: addresses */ \
  X(machine_axis,         none,          none, word, nct,        usual, nothing) \
  X(increment_axis,       none,          none, word, nct,        usual, nothing) \
  X(argument_only,        none,          none, word, nct,        usual, nothing) \
  X(auxiliary_word,       machine,       none, word, nct,        usual, nothing) \
  X(spindle_word,         speed,         none, word, nct,        usual, nothing) \
  X(spindle_axis_word,    spindle,       none, word, nct,        usual, nothing) \
  X(tool_call,            tool,          none, word, nct,        usual, nothing) \
  X(length_number,        length,        none, word, nct,        usual, breaks_contour) \
  X(radius_number,        offset_number, none, word, nct,        usual, nothing) \
  /* nct: motion and coordinates */ \
  X(thread,               motion,        own,  code, nct,        usual, nothing) \
  X(dwell_or_turns,       dwell,         none, code, nct,        usual, nothing) \
  X(smoothing,            path_mode,     own,  code, nct,        usual, nothing) \
  X(cylinder_mode,        data,          own,  code, nct,        usual, nothing) \
  X(set_tables,           data,          own,  code, nct,        usual, nothing) \
  X(set_tables_end,       data,          none, code, nct,        usual, nothing) \
  X(diameter_switch,      data,          own,  code, nct,        usual, nothing) \
  X(polar_surface_on,     data,          none, code, nct,        usual, nothing) \
  X(polar_surface_off,    data,          none, code, nct,        usual, nothing) \
  X(polar_data_on,        transform,     none, code, nct,        usual, nothing) \
  X(polar_data_off,       transform,     none, code, nct,        usual, nothing) \
  X(select_plane,         plane,         none, code, nct,        usual, nothing) \
  X(work_area_on,         data,          own,  code, nct,        usual, breaks_contour) \
  X(work_area_off,        data,          none, code, nct,        usual, breaks_contour) \
  X(reference_return,     data,          own,  code, nct,        usual, leaves_mode | breaks_contour) \
  X(measure,              motion,        own,  code, nct,        usual, nothing) \
  X(measure_length,       motion,        own,  code, nct,        usual, nothing) \
  X(radius_side,          compensation,  none, code, nct,        usual, nothing) \
  X(length_comp,          length,        none, code, nct,        usual, breaks_contour) \
  X(mirror_on,            transform,     own,  code, nct,        usual, leaves_mode) \
  X(mirror_off,           transform,     own,  code, nct,        usual, leaves_mode) \
  X(turret_mirror,        transform,     none, code, nct,        usual, breaks_contour) \
  X(second_spindle,       transform,     none, code, nct,        usual, breaks_contour) \
  X(tool_changer_code,    length,        none, code, nct,        usual, nothing) \
  X(scaling_on,           transform,     own,  code, nct,        usual, leaves_mode) \
  X(scaling_off,          transform,     none, code, nct,        first, nothing) \
  X(plane_rotation_on,    transform,     own,  code, nct,        usual, leaves_mode) \
  X(plane_rotation_off,   transform,     none, code, nct,        first, nothing) \
  X(transform_off,        transform,     none, code, nct,        usual, nothing) \
  X(space_rotation,       transform,     own,  code, nct,        usual, breaks_contour) \
  X(tilted_plane,         transform,     own,  code, nct,        usual, breaks_contour) \
  X(space_frame_off,      transform,     none, code, nct,        first, breaks_contour) \
  X(tool_orientation,     motion,        own,  code, nct,        usual, breaks_contour) \
  X(tool_lead,            length,        none, code, nct,        usual, breaks_contour) \
  X(dynamic_zero,         zero,          none, code, nct,        usual, breaks_contour) \
  X(local_system,         data,          own,  code, nct,        usual, leaves_mode | breaks_contour) \
  X(machine_move,         data,          own,  code, nct,        usual, leaves_mode | breaks_contour) \
  X(work_system,          zero,          none, code, nct,        usual, breaks_contour) \
  X(work_system_extended, zero,          none, code, nct,        usual, breaks_contour) \
  X(new_system,           data,          own,  code, nct,        usual, breaks_contour) \
  X(feed_control,         path_mode,     none, code, nct,        usual, nothing) \
  X(css_on,               speed_mode,    none, code, nct,        usual, nothing) \
  X(css_off,              speed_mode,    none, code, nct,        usual, nothing) \
  X(drilling,             positioning,   own,  code, nct,        usual, nothing) \
  X(drilling_off,         motion,        none, code, nct,        first, nothing) \
  X(turning_cycle,        motion,        own,  code, nct,        usual, nothing) \
  X(turning_simple,       motion,        own,  code, nct,        usual, nothing) \
  X(gear_on,              data,          none, code, nct,        usual, nothing) \
  X(gear_off,             data,          none, code, nct,        usual, nothing) \
  X(vector_hold,          corner,        none, code, nct,        usual, nothing) \
  X(vector_corner,        data,          none, code, nct,        usual, nothing) \
  X(not_available,        none,          own,  code, nothing,    usual, nothing) \
  /* functions for macros, calls of programs, and M codes */ \
  X(macro_call,           flow,          own,  code, nct,        usual, passes_control) \
  X(macro_modal,          flow,          own,  code, nct,        usual, nothing) \
  X(macro_modal_off,      flow,          none, code, nct,        usual, nothing) \
  X(spindle_code,         spindle,       none, code, nct,        usual, nothing) \
  X(gear_range,           range,         none, code, nct,        usual, nothing) \
  X(exchange_tool,        tool_change,   none, code, nct,        usual, nothing) \
  X(interrupt_on,         flow,          none, code, nct,        usual, nothing) \
  X(interrupt_off,        flow,          none, code, nct,        usual, nothing) \
  X(call_program,         flow,          none, code, nct,        usual, passes_control) \
  X(return_program,       flow,          none, code, nct,        usual, passes_control) \
  X(subprogram_return,    flow,          none, code, no_nct,     usual, ends) \
  X(subprogram_end,       flow,          none, code, no_nct,     usual, ends) \
  X(repetition_end,       flow,          none, code, no_nct,     usual, ends) \
  X(permanent_subprogram, flow,          own,  code, no_nct,     usual, nothing) \
  /* functions of controls that follow RS274/NGC, with parameters in a file (spec/linuxcnc) */ \
  X(canned_cycle,         motion,        own,  code, rs274,      usual, nothing) \
  X(probe_move,           motion,        own,  code, rs274,      usual, nothing) \
  X(thread_by_spindle,    motion,        own,  code, rs274,      usual, nothing) \
  X(cubic_spline,         motion,        own,  code, rs274,      usual, nothing) \
  X(quadratic_spline,     motion,        own,  code, rs274,      usual, nothing) \
  X(nurbs_point,          motion,        own,  code, rs274,      usual, nothing) \
  X(nurbs_end,            data,          none, code, rs274,      usual, nothing) \
  X(table_data,           data,          own,  code, rs274,      usual, leaves_mode) \
  X(coordinate_shift,     data,          own,  code, rs274,      usual, leaves_mode) \
  X(coordinate_shift_off, data,          none, code, rs274,      usual, nothing) \
  X(table_system,         zero,          none, code, rs274,      usual, nothing) \
  X(reference_move,       data,          own,  code, rs274,      usual, leaves_mode) \
  X(reference_store,      data,          none, code, rs274,      usual, nothing) \
  X(tool_length,          length,        none, code, rs274,      usual, nothing) \
  X(tool_length_by_words, length,        none, code, rs274,      usual, nothing) \
  X(tool_length_off,      length,        none, code, rs274,      usual, nothing) \
  X(tool_side,            compensation,  none, code, rs274,      usual, nothing) \
  X(tool_of_table,        tool,          none, word, rs274,      usual, nothing) \
  X(load_tool,            tool_change,   none, code, rs274,      usual, nothing) \
  X(tool_in_spindle,      tool_change,   none, code, rs274,      usual, nothing) \
  X(digital_output,       message,       none, code, rs274,      usual, nothing) \
  X(analog_output,        message,       none, code, rs274,      usual, nothing) \
  X(wait_for_input,       message,       none, code, rs274,      usual, nothing) \
  X(orient_to,            spindle,       none, code, rs274,      usual, nothing) \
  X(override_switch,      override,      none, code, rs274,      usual, nothing) \
  X(surface_speed_limited, speed_mode,   none, code, rs274,      usual, nothing) \
  X(modes_kept,           spindle,       none, code, rs274,      last,  nothing) \
  X(diameter_mode,        unit,          none, code, rs274,      usual, nothing) \
  X(speed_of_spindle,     speed,         none, word, rs274,      usual, nothing) \
  X(profile_cycle,        motion,        own,  code, rs274,      usual, nothing) \
  X(threading_cycle,      motion,        own,  code, rs274,      usual, nothing) \
  X(call_numbered,        flow,          none, code, rs274,      call,  calls) \
  X(return_numbered,      flow,          none, code, rs274,      usual, ends) \
  /* further functions of controls with custom macros (spec/fanuc, spec/haas) */ \
  X(no_action,            none,          none, code, nothing,    usual, nothing) \
  X(look_ahead,           none,          none, code, nct,        usual, nothing) \
  X(reference_check,      data,          own,  code, nct,        usual, leaves_mode | breaks_contour) \
  X(reference_leave,      motion,        own,  code, nct,        usual, leaves_mode | breaks_contour) \
  X(rigid_tapping,        machine,       none, code, nct,        usual, nothing) \
  X(call_local,           flow,          none, code, nct,        usual, passes_control) \
  X(mirror_axes_on,       transform,     own,  code, nct,        usual, leaves_mode) \
  X(mirror_axes_off,      transform,     own,  code, nct,        usual, leaves_mode) \
  X(circular_bore,        motion,        own,  code, nct,        usual, nothing) \
  X(hole_pattern,         motion,        own,  code, nct,        usual, nothing) \
  X(single_direction,     motion,        own,  code, nct,        usual, leaves_mode | breaks_contour) \
  X(engraved_text,        motion,        own,  code, nct,        usual, nothing) \
  X(jump_by_input,        flow,          none, code, nct,        usual, nothing) \
  /* functions of controls that check each line by itself (spec/grbl) */ \
  X(machine_block,        none,          none, code, lines,      usual, nothing) \
  X(stored_offsets,       data,          own,  code, lines,      usual, nothing) \
  X(stored_move,          data,          own,  code, lines,      usual, nothing) \
  X(stored_position,      data,          none, code, lines,      usual, nothing) \
  X(length_by_word,       length,        own,  code, lines,      usual, nothing) \
  X(length_by_word_off,   length,        own,  code, lines,      usual, nothing)
// clang-format on

/// What a control must have so that the function works. The machine of the NCT (dialect = "nct") has its own axes, spindles, offsets and
/// calls. Functions for this machine do not work on other machines, and vice versa.
enum class Needs : std::uint8_t {
  nothing,
  nct,         // the control has dialect = "nct"
  no_nct,      // the control has any dialect other than "nct", or no dialect
  correctors,  // the control has dialect = "correctors"
  sections,    // the control has the key `section` in [grammar]
  labels,      // the control has the key `label` in [grammar]
  rs274,       // the control has dialect = "linuxcnc"
  lines,       // the control has dialect = "grbl"
};

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

enum class TakesAxes : std::uint8_t { none, own };
enum class FunctionOrder : std::uint8_t { first, call, usual, last };

/// What calls a function: an address (row of [address]), or a code (row of [g] or [m]).
enum class CalledBy : std::uint8_t { word, code };

/// The facts in the rows of KADR_FUNCTIONS, one bit for each fact.
namespace function_fact {
inline constexpr std::uint8_t nothing = 0, leaves_mode = 1, ends = 2, stops = 4, calls = 8, passes_control = 16, plain_motion = 32,
                              breaks_contour = 64, steady = 128;
}  // namespace function_fact

struct FunctionTraits {
  std::string_view name;
  Phase phase;
  TakesAxes axes;
  CalledBy by;
  Needs needs;
  FunctionOrder order;
  std::uint8_t facts;
  bool takes_axes() const { return axes == TakesAxes::own; }
  bool is(std::uint8_t fact) const { return (facts & fact) != 0; }
};

const FunctionTraits& traits_of(Function function);
Function function_named(std::string_view name);  // returns the function with this name; Function::count if no function has it
Phase phase_named(std::string_view name);        // returns the phase with this name; Phase::count if no phase has it
std::string_view name_of(Phase phase);

inline constexpr std::size_t most_groups = 48;  // greatest number of groups of codes, including "no group"

}  // namespace kadr

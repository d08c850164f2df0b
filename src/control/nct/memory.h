#pragma once
// What only the NCT control remembers (spec/nct): parameters as settings, tools, spindles, modal calls, cycles. Values.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "action/action.h"
#include "control/fanuc/drilling/drilling.h"
#include "control/fanuc/five_axis/five_axis_state.h"
#include "control/fanuc/measuring.h"
#include "control/fanuc/tables/settings.h"
#include "control/fanuc/turning/turning.h"
#include "control/macro_b/calls/programs.h"
#include "control/macro_b/statements/endless.h"
#include "control/macro_b/variables/changes.h"
#include "control/nct/axes/coupling.h"
#include "control/nct/axes/drives.h"
#include "control/nct/tools/tools.h"
#include "control/state/state.h"
#include "control/variables/macro_variables.h"

namespace kadr::nct {

/// A modal macro call in force (23.3.2, 23.3.3).
struct ModalCall {
  std::uint16_t reader = 0;
  Position start;
  std::uint32_t times = 1;
  std::uint32_t name = 0;
  bool each_block = false;  // G66.1
  char called_by = 'G';
  std::int32_t called_code = -1;
  Locals arguments;
};

struct SpindleState {
  bool known = false;  // the set-up has it
  int channel = 1;
  double rpm = 0;  // within the limits of the range
  SpindleDir dir = SpindleDir::stop;
  bool loop_closed = false;
  bool referenced = false;  // oriented since the loop was closed
  double angle = 0;         // degrees, while the loop is closed
  int range = 0;            // selected by M11 … M18; 0: none
  int master = 0;           // it is synchronised to; 0: none
};

/// The electronic gearbox (20.1).
struct Gear {
  bool on = false;
  double ratio = 0;  // revolutions of the table for one of the spindle
  double teeth = 0;
};

/// Words of the last block and the like, for #4101 … (23.1.14).
struct ModalWords {
  std::array<double, 3> aux{};
  double d = 0, e = 0, f = 0, h = 0, m = 0, n = 0, o = 0, s = 0, t = 0;
  double extended_zero = 0;
};

enum class DataMode : std::uint8_t { none, parameters, tools };

/// What a plain motion may change already: kept at the start of each block.
struct MotionMemory {
  ModalWords words;
  bool rigid_tap = false;  // M29 (spec/fanuc 10.4)
  Axes through{};          // the intermediate point of the last G28, G30: programmed (spec/fanuc 6.6)
  bool has_through = false;
  bool in_thread = false;               // the motion before was a thread too
  double thread_lead = 0;               // mm
  double surface_angle = 0;             // of the rotary axis in G12.1, unwound
  AxisMask smoothed = 0;                // axes that G5.1 has named; 0: all linear ones
  SideStep side_step = SideStep::none;  // what the next motion in the plane does
  bool compensates = false;             // a motion has been made with compensation since G41, G42
};

/// What a run remembers beside ControlState; an alarm brings it back as one value.
struct Volatile : MotionMemory {
  std::array<SpindleState, most_spindles + 1> spindles;
  int current_spindle = 1;  // referred to last (11.2)
  int main_spindle = 1;
  double surface_speed = 0;  // m/min
  int css_axis = 0;          // control-wide number
  double css_most = 0;       // G92 S, rev/min; 0: none
  DrillingMemory drilling;
  TurningMemory turning;
  Gear gear;
  double tool_radius = 0;      // of D when it was programmed last (15.1)
  std::optional<Vec2> way;     // I J K of G41, G42, G40 in this block
  ContourCheck contour_check;  // as `path` knows it
  FiveAxisState five_axis;
  std::vector<ModalCall> modal_calls;
  std::uint8_t active_modal_calls = 0;  // how many of them act on the blocks being carried out
  DataMode data_mode = DataMode::none;
  std::optional<ProgramPlace> interrupt_program;  // M96
  double parts_done = 0;
};

inline constexpr std::string_view interrupt_signal = "CP_MINT";
inline constexpr std::size_t basic_systems = 6, extended_systems = most_further_systems;  // G54 … G59, G54.1 P1 …
inline constexpr std::size_t all_systems = 1 + basic_systems + extended_systems;
inline constexpr std::size_t dynamic_systems = 8;  // G54.2 P1 … P8: rows of the tables of zeros and rotations behind the others

/// A word that calls a subprogram after its block: T, S, A, B, C, M or an ASCII letter (23.3.6–23.3.8).
struct PendingCall {
  int program = 0;
  char letter = 0;
  std::int32_t code = -1;
  Span where;
};

/// Modal state kept for the end of an interrupt macro (23.4).
struct Interrupted {
  bool active = false;
  Modal modal;
  ModalWords words;
  Transform transform;
};

/// The same of what the codes in force repeat: the data of cycles, the macros of G66.
struct InterruptedCycles {
  DrillingMemory drilling;
  TurningMemory turning;
  std::vector<ModalCall> modal_calls;
  std::uint8_t active_modal_calls = 0;
};

/// All that the NCT remembers and that is a plain value: a snapshot copies it.
struct Memory {
  Settings settings;
  Volatile state;
  ToolManagement tools;
  DataInput data_input;
  Programs programs;
  std::map<int, std::vector<std::pair<double, double>>> ranges;  // of spindles, rev/min
  std::map<int, std::string> spindle_names;
  std::vector<std::pair<std::size_t, Locals>> repeated_arguments;  // by depth of the call
  std::vector<Finishing> finishing;                                // contours that G70.7 is in
  Interrupted interrupted;
  bool signal_rose = false;                           // CP_MINT, since it was looked at last
  std::map<std::string, double> signals;              // of the machine's logic
  Couplings couplings;                                // axes that follow others
  Drives drives;                                      // exchanged, reversed, parked axes
  bool single_block = false;                          // the operator's switch
  std::uint8_t drilling_group = 0, motion_group = 0;  // of G80 and G0
  std::uint8_t stop_group = 0;                        // of G61 … G64
  std::int16_t inhibiting = -1;                       // row of G63
  std::int16_t slowing = -1;                          // row of G62
  // of the block being carried out
  bool was_hidden = false;     // the block stands in a program that is not listed (23.3.9)
  bool moved = false;          // it held a movement command
  bool holds_vector = false;   // G38
  bool uncompensated = false;  // its motions are: G53, G28, G30
  bool stops_reading = false;  // it empties the buffer
  std::vector<PendingCall> pending;
  int spindle_by_p = 0;          // S1500 P2: number of the spindle; 0: none
  bool absolute_block = false;   // its axis words are absolute even with G91 (17.3)
  bool cartesian_block = false;  // its axis words are Cartesian even with G16 (5.4)
  AxisMask rolled = 0;           // rotary axes of the block that roll over, and their way
  Axes travel{};
  AxisMask plane_axes = 0;    // axes whose letter stands in the block, with or without a number
  AxisMask taken_up = 0;      // axes that its motion positions too, where they were programmed last (25h)
  AxisMask by_direction = 0;  // rotary axes that its I J K position, at `directed` (25.14)
  Axes directed{};
  Vec3 normal_before;  // of the surface, where the block's motion begins (25.17)
  // of the machine and its operator
  std::array<std::pair<double, double>, max_axes> axis_limits{};  // end positions, machine coordinates
  double spindle_part = 1;                                        // spindle override / 100
  double singular = 0;                                            // degrees: of the set-up's kinematics
  int axes_in_all = 0;                                            // of all channels
  Axes servo_lag{};                                               // how far the set-up says that each axis stays from the command, mm
  std::array<double, 32> plc_in{}, plc_out{};
  std::array<double, 4> plc_in_word{}, plc_out_word{};
  std::uint32_t control_1 = 0, control_2 = 0;  // #3003, #3004
  double answer = 0;                           // #3107
  double parts_required = 0;
  double cutting_ms = 0, clock_offset_ms = 0;
  bool counts_time = false;               // of tools, since set_time came last
  bool turned = false;                    // the main spindle, then
  double now_ms = 0;                      // virtual time since power-on
  double tool_magazine = 10;              // #8400
  Axes probe_position{}, probe_length{};  // work coordinates; tool length then, as vector on the main axes
  Axes probe_machine{};
  Measurement measurement;                  // of the probe motion under way
  std::string clock;                        // "2014-05-18T15:32:41"
  std::map<double, double> variable_names;  // of SETVN: number of the name, number of the variable (spec/fanuc 5.1)
  // for the state file
  Changes changes;
  bool tables_changed = false;
  std::vector<std::uint32_t> changed_offsets;
  InterruptedCycles interrupted_cycles;
  std::vector<std::pair<std::size_t, int>> spindle_axes;  // axis, spindle that it is made of (11.8)
  Endless endless;
  std::uint64_t parameters_seen = 0;  // version of the parameters that `settings` are of, plus 1
  std::uint64_t without_point = 0;    // letters whose numbers take no decimal point (spec/fanuc 1.3)
};

}  // namespace kadr::nct

#pragma once
// What Fanuc, Haas and NCT remember besides macros: settings derived from parameters, states of spindles, cycles, frames and compensation.
// All are plain values.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "action/action.h"
#include "action/placement.h"
#include "control/fanuc/state/cycle_memory.h"
#include "control/fanuc/state/five_axis_state.h"
#include "control/fanuc/state/settings.h"
#include "control/macro_b/memory.h"
#include "control/state/control_state.h"

namespace kadr::fanuc {

struct SpindleState {
  bool known = false;  // the set-up lists this spindle
  int channel = 1;
  double rpm = 0;  // programmed speed, limited to the selected gear range
  SpindleDir dir = SpindleDir::stop;
  bool loop_closed = false;
  bool referenced = false;  // the spindle has been oriented since its position loop was closed
  double angle = 0;         // degrees; valid while the position loop is closed
  int range = 0;            // gear range selected by M11 … M18; 0: none
  int master = 0;           // number of the spindle to which this one is synchronised; 0: none
};

/// The part of the memory that even a block with nothing but a motion may change. It is saved at the start of each block, so that an alarm
/// can restore it.
struct MotionMemory {
  bool rigid_tap = false;  // M29 is in force (spec/fanuc 10.4)
  Axes through{};          // intermediate point of the last G28, G30, programmed coordinates (spec/fanuc 6.6)
  bool has_through = false;
  bool in_thread = false;               // the previous motion was a thread too
  double thread_lead = 0;               // thread lead, mm; 0: none
  double surface_angle = 0;             // position of the rotary axis in G12.1, degrees, not reduced to 0 … 360
  AxisMask smoothed = 0;                // axes that G5.1 has named for smoothing; 0: all linear axes
  SideStep side_step = SideStep::none;  // role of the next motion in the plane for cutter compensation
  bool compensates = false;             // a motion has been executed with cutter compensation since G41, G42
};

/// The state of cutting that a run keeps in addition to ControlState. An alarm restores this state as one value.
struct UndoableState : MotionMemory {
  std::array<SpindleState, max_spindles + 1> spindles;
  int current_spindle = 1;  // the spindle that a word referred to last (11.2)
  int main_spindle = 1;
  double surface_speed = 0;  // constant surface speed of G96, m/min
  int css_axis = 0;          // axis of the constant surface speed, numbered through all channels
  double max_css_speed = 0;  // highest speed by G92 S, rev/min; 0: no limit
  DrillingMemory drilling;
  TurningMemory turning;
  double tool_radius = 0;                // tool radius of offset D when D was programmed, mm (15.1)
  std::optional<Vec2> way;               // direction vector I J K of G41, G42, G40
  CompensationCheck compensation_check;  // compensation settings that the room `path` has received last
  FiveAxisState five_axis;
};

inline constexpr std::size_t extended_systems = max_further_systems;  // number of work systems of G54.1 P
inline constexpr std::size_t all_systems = 1 + macro_b::basic_systems + extended_systems;
inline constexpr std::size_t dynamic_systems = 8;  // G54.2 P1 … P8: the last rows in the tables of work offsets and rotations

/// Data of canned cycles, saved during an interrupt macro and restored at its end (23.4).
struct InterruptedCycles {
  DrillingMemory drilling;
  TurningMemory turning;
};

/// All memory that is a plain value: a snapshot copies it.
struct Memory {
  Settings settings;
  UndoableState state;
  std::map<int, std::vector<std::pair<double, double>>> ranges;  // gear ranges of each spindle: lowest and highest speed, rev/min
  std::map<int, std::string> spindle_names;
  std::vector<Finishing> finishing;  // contours that G70.7 is executing, the innermost last
  InterruptedCycles interrupted_cycles;
  AxisDrives driven;                                  // machine axis that each programmed axis drives
  AxisMask following = 0;                             // axes that follow another axis
  std::uint8_t drilling_group = 0, motion_group = 0;  // index of the modal group of G80, of G0
  std::int16_t slowing = -1;                          // row of G62 in ControlDef::codes
  std::uint64_t without_point = 0;                    // letters whose numbers may have no decimal point (spec/fanuc 1.3)
  // data of the block being executed
  bool holds_vector = false;     // true: the block has G38, which keeps the compensation vector
  bool uncompensated = false;    // true: the block has G53, G28 or G30; its motions are not compensated
  int spindle_by_p = 0;          // S1500 P2: the number of the spindle; 0: not given
  bool absolute_block = false;   // the block's axis words are absolute even with G91 (17.3)
  bool cartesian_block = false;  // the block's axis words are Cartesian even with G16 (5.4)
  AxisMask rolled = 0;           // rotary axes of the block that roll over (5.6); `travel`: their travels, degrees
  Axes travel{};
  AxisMask plane_axes = 0;    // axes whose letter is in the block, with or without a number
  AxisMask taken_up = 0;      // axes without a word that the block's motion positions too, at their last programmed coordinates (25h)
  AxisMask by_direction = 0;  // rotary axes that the block's I J K position, at `directed` (25.14)
  Axes directed{};
  Vec3 normal_before;  // surface normal at the start of the block's motion (25.17)
  // data of the machine and its operator
  std::array<std::pair<double, double>, max_axes> axis_limits{};  // lowest and highest end position of each axis, machine coordinates
  double spindle_part = 1;                                        // spindle override as a fraction: 1 is 100 %
  double singular = 0;                                            // tolerance of a singular direction, degrees (Setup::kinematics)
  Axes servo_lag{};                                               // following error of each axis as the set-up gives it, mm
  std::vector<std::pair<std::size_t, int>> spindle_axes;          // axis index, number of the spindle converted to it (11.8)
  Axes probe_position{}, probe_length{};                          // work coordinates, and tool length as a vector, at the probe's signal
  Axes probe_machine{};
  Measurement measurement;  // purpose of the probe motion in progress
  // data for the state file: tables that have changed since that file was written
  bool tables_changed = false;
  std::vector<std::uint32_t> changed_offsets;
};

}  // namespace kadr::fanuc

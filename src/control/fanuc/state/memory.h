#pragma once
// What Fanuc, Haas and NCT remember besides macros: parameters as settings, spindles, cycles, frames, compensation. Values.

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
#include "control/state/state.h"

namespace kadr::fanuc {

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

/// What a plain motion may change already: kept at the start of each block.
struct MotionMemory {
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

/// What a run remembers of cutting beside ControlState; an alarm brings it back as one value.
struct Volatile : MotionMemory {
  std::array<SpindleState, most_spindles + 1> spindles;
  int current_spindle = 1;  // referred to last (11.2)
  int main_spindle = 1;
  double surface_speed = 0;  // m/min
  int css_axis = 0;          // control-wide number
  double css_most = 0;       // G92 S, rev/min; 0: none
  DrillingMemory drilling;
  TurningMemory turning;
  double tool_radius = 0;      // of D when it was programmed last (15.1)
  std::optional<Vec2> way;     // I J K of G41, G42, G40 in this block
  ContourCheck contour_check;  // as `path` knows it
  FiveAxisState five_axis;
};

inline constexpr std::size_t extended_systems = most_further_systems;  // G54.1 P1 …
inline constexpr std::size_t all_systems = 1 + macro_b::basic_systems + extended_systems;
inline constexpr std::size_t dynamic_systems = 8;  // G54.2 P1 … P8: rows of the tables of zeros and rotations behind the others

/// Data of cycles, kept for the end of an interrupt macro (23.4).
struct InterruptedCycles {
  DrillingMemory drilling;
  TurningMemory turning;
};

/// All of it that is a plain value: a snapshot copies it.
struct Memory {
  Settings settings;
  Volatile state;
  std::map<int, std::vector<std::pair<double, double>>> ranges;  // of spindles, rev/min
  std::map<int, std::string> spindle_names;
  std::vector<Finishing> finishing;  // contours that G70.7 is in
  InterruptedCycles interrupted_cycles;
  AxisDrives driven;                                  // which axis of the machine each programmed one drives
  AxisMask following = 0;                             // axes that follow others
  std::uint8_t drilling_group = 0, motion_group = 0;  // of G80 and G0
  std::int16_t slowing = -1;                          // row of G62
  std::uint64_t without_point = 0;                    // letters whose numbers take no decimal point (spec/fanuc 1.3)
  // of the block being carried out
  bool holds_vector = false;     // G38
  bool uncompensated = false;    // its motions are: G53, G28, G30
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
  Axes servo_lag{};                                               // how far the set-up says that each axis stays from the command, mm
  std::vector<std::pair<std::size_t, int>> spindle_axes;          // axis, spindle that it is made of (11.8)
  Axes probe_position{}, probe_length{};                          // work coordinates; tool length then, as vector on the main axes
  Axes probe_machine{};
  Measurement measurement;  // of the probe motion under way
  // for the state file
  bool tables_changed = false;
  std::vector<std::uint32_t> changed_offsets;
};

}  // namespace kadr::fanuc

#pragma once
// The memory of Fanuc, Haas and NCT that macros do not need: settings derived from parameters, states of spindles, cycles, frames and
// compensation. All are plain values.

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
  bool known = false;  // true: the set-up lists this spindle
  int channel = 1;
  double rpm = 0;  // programmed speed in rev/min, limited to the selected gear range
  SpindleDir dir = SpindleDir::stop;
  bool loop_closed = false;
  bool referenced = false;  // the spindle has been oriented since its position loop was closed
  double angle = 0;         // spindle angle in degrees; valid while the position loop is closed
  int range = 0;            // gear range selected by M11 … M18; 0: none
  int master = 0;           // number of the spindle with which this spindle is synchronised; 0: none
};

/// The part of the memory that even a block with motions only may change. It is saved at the start of each block, so that an alarm can
/// restore it.
struct MotionMemory {
  bool rigid_tap = false;  // M29 is in force: G84 and G74 tap rigidly (spec/fanuc 10.4)
  Axes through{};          // intermediate point of the last G28 or G30, in programmed coordinates (spec/fanuc 6.6)
  bool has_through = false;
  bool in_thread = false;  // the previous motion was a pass of a thread
  double thread_lead = 0;  // last programmed thread lead, mm; 0: no lead was programmed
  // in polar interpolation (G12.1): position of the rotary axis in degrees, which may be outside 0 … 360
  double surface_angle = 0;
  AxisMask smoothed = 0;                // axes that G5.1 has named for path smoothing; 0 means all linear axes
  SideStep side_step = SideStep::none;  // whether the next motion in the plane starts or ends cutter compensation
  bool compensates = false;             // since G41 or G42, at least one motion has been executed with cutter compensation
};

/// The state of spindles, cycles and compensation that a block may change, apart from the data in ControlState. An alarm restores this
/// state as one value.
struct UndoableState : MotionMemory {
  std::array<SpindleState, max_spindles + 1> spindles;
  int current_spindle = 1;  // number of the spindle to which the last spindle word referred (11.2)
  int main_spindle = 1;
  double surface_speed = 0;  // constant surface speed that G96 has commanded, m/min
  int css_axis = 0;          // number of the axis whose position is the diameter for G96; the count includes the axes of all channels
  double max_css_speed = 0;  // highest spindle speed in rev/min, set by G92 S; 0: no limit
  DrillingMemory drilling;
  TurningMemory turning;
  double tool_radius = 0;                // tool radius in mm of offset D, stored when D was programmed (15.1)
  std::uint8_t nose = 0;                 // number of the imaginary tip of the offset in force, 0 to 9 (spec/fanuc-t 7.1)
  bool machine_may_turn = false;         // a code of the machine may have started a spindle since M3, M4 or M5
  bool second_turret = false;            // G68 is in force: X is mirrored for the second turret (spec/fanuc-t 11.3)
  Axes wear{};                           // the part of the tool's lengths in force that is wear, mm (spec/fanuc-t 4.1)
  std::optional<Vec2> direction_vector;  // direction vector I J K of G41, G42, G40
  CompensationCheck compensation_check;  // settings of compensation that the room `path` received last
  FiveAxisState five_axis;
};

inline constexpr std::size_t extended_systems = max_further_systems;  // number of further work systems that G54.1 P selects
inline constexpr std::size_t all_systems = 1 + macro_b::basic_systems + extended_systems;
// The dynamic offsets that G54.2 P1 … P8 selects have the last eight rows in the tables of work offsets and rotations.
inline constexpr std::size_t dynamic_systems = 8;

/// The data of canned cycles, saved at the start of an interrupt macro and restored at its end (23.4).
struct InterruptedCycles {
  DrillingMemory drilling;
  TurningMemory turning;
};

/// All memory of the class Fanuc that is a plain value, so that a snapshot can copy it.
struct Memory {
  Settings settings;
  UndoableState state;
  // gear ranges of each spindle: lowest and highest speed of each range, rev/min
  std::map<int, std::vector<std::pair<double, double>>> ranges;
  std::map<int, std::string> spindle_names;
  std::vector<Finishing> finishing;  // contours that G70.7 is executing, the innermost contour last
  InterruptedCycles interrupted_cycles;
  AxisDrives driven;       // for each programmed axis, the machine axis that it drives
  AxisMask following = 0;  // axes that follow another axis, their master
  // indices of the modal group of G80 (drilling cycles) and of the modal group of G0 (motions)
  std::uint8_t drilling_group = 0, motion_group = 0;
  std::int16_t slowing = -1;        // index in ControlDef::codes of G62, the automatic feed override at corners
  std::uint64_t without_point = 0;  // letters whose numbers may have no decimal point (spec/fanuc 1.3)
  // data of the block being executed
  bool holds_vector = false;     // the block has G38, which keeps the compensation vector
  bool uncompensated = false;    // the block has G53, G28, G30 or a turning cycle, whose motions are not compensated
  int spindle_by_p = 0;          // number of the spindle, for a block such as S1500 P2; 0 if the block has no P for a spindle
  bool absolute_block = false;   // the block's axis words are absolute even while G91 (incremental) is in force (17.3)
  bool cartesian_block = false;  // the block's axis words are Cartesian even while G16 (polar coordinates) is in force (5.4)
  AxisMask rolled = 0;           // rotary axes of the block that roll over (5.6); `travel` has their travels in degrees
  Axes travel{};
  AxisMask plane_axes = 0;    // axes whose letter is in the block, with or without a number; such a letter selects an axis of the plane
  AxisMask taken_up = 0;      // axes without a word that the block's motion also positions, at their last programmed coordinates (25h)
  AxisMask by_direction = 0;  // rotary axes that I J K of the block position; `directed` has the positions (25.14)
  Axes directed{};
  Vec3 normal_before;  // surface normal at the start of the block's motion (25.17)
  // data about the machine: travel limits, spindle override, following error, probe
  std::array<std::pair<double, double>, max_axes> axis_limits{};
  double spindle_part = 1;  // spindle override as a fraction, so that 1 means 100 %
  double singular = 0;      // tolerance in degrees for a singular direction (Setup::kinematics)
  Axes servo_lag{};         // following error in mm of each axis, as the set-up gives it
  // pairs of an axis index and the number of the spindle converted to this axis (11.8)
  std::vector<std::pair<std::size_t, int>> spindle_axes;
  Axes probe_position{}, probe_length{};  // work coordinates and tool length (as a vector) at the time of the probe's signal, mm
  Axes probe_machine{};
  Measurement measurement;         // purpose of the probe motion in progress
  bool reads_figure = false;       // the motions are those of a figure that a turning cycle reads
  bool standing_reported = false;  // the warning feed_without_turns has been given
  // for the state file: what has changed in the tables since that file was last written
  bool tables_changed = false;
  std::vector<std::uint32_t> changed_offsets;
};

}  // namespace kadr::fanuc

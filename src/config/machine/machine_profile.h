#pragma once
// MachineProfile: the capabilities of a machine, from machines/*.toml: rates, limits, kinematics and bodies. The control does not use them.

#include <cstdint>
#include <map>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/file_access.h"
#include "base/vec.h"
#include "config/control/control_def.h"
#include "config/machine/machine_bodies.h"

namespace kadr {

/// How an axis moves what it carries. If the file does not state this, the letter of the axis decides: X, U along X …, A about X, B about
/// Y, C about Z.
struct AxisJoint {
  bool turns = false;
  Vec3 direction;  // unit vector of the motion, or of the axis of rotation, with all axes at 0
  Vec3 through;    // a point on the axis of rotation, machine coordinates, with all axes at 0 and the spindle's gauge point at the origin
  // If reversed, a positive rotation is left-handed, and a positive linear motion moves the tool, seen from the part, against `direction`.
  bool reversed = false;
  bool rolls_over = false;
};

struct AxisProfile {
  double rapid = 10000;   // rapid rate, mm/min or degrees/min
  double least = -1e300;  // lower end of the axis' travel, machine coordinate, mm or degrees; `most` is the upper end
  double most = 1e300;
  double acceleration = 500;  // mm/s² or degrees/s²; used for samples and times if neither set-up nor parameters state an acceleration
  double jerk = 10000;        // mm/s³ or degrees/s³
  AxisJoint joint{};
};

/// The chains of axes ([kinematics]). Each list contains axis names in order from the bed: an axis carries the next axis, and the last axis
/// carries the tool or the part.
struct AxisChains {
  std::vector<std::string> tool, part;
  Vec3 tool_direction{0, 0, 1};  // unit vector from the tip towards the spindle, with all axes at 0
  bool given() const { return !tool.empty() || !part.empty(); }
};

/// What determines the machine's speed. programmed: the programmed feeds and the rapid rates; if the set-up states accelerations, like
/// `control`. control: what a conventional control achieves with the machine's accelerations (docs/motion.md). optimal: the least-time
/// planner (docs/planner.md).
enum class PlannerMode : std::uint8_t { programmed, control, optimal };

/// The chuck of a lathe ([chuck]). Its face is at `chuck_face` of the set-up. Lengths in mm; diameter 0: the file does not describe it.
struct ChuckProfile {
  double diameter = 0;
  double length = 0;  // from its face to the spindle, with the jaws
};

/// The tailstock of a lathe ([tailstock]): a centre, whose tip is at `tailstock` of the set-up, in a quill. Lengths in mm.
struct TailstockProfile {
  double angle = 60;    // full angle of the centre's point, degrees
  double centre = 0;    // diameter of the centre, where its cone ends; 0: the file does not describe the tailstock
  double diameter = 0;  // of the quill, which begins where the cone ends
  double length = 0;    // of the quill
};

struct MachineProfile {
  std::string id = "generic";
  std::string name_en, name_ru;
  std::map<std::string, AxisProfile> axes;  // axes of the machine by name; an axis that is not listed has the values of AxisProfile{}
  AxisChains chains;
  std::vector<MachineBody> bodies;
  std::map<std::uint32_t, Text> m_codes;  // what the machine's M codes do, by number: M68 "chuck clamp"
  ChuckProfile chuck;
  TailstockProfile tailstock;
  double tool_change_s = 10;
  double spindle_start_s = 0;
  double most_rpm = 0;      // highest spindle speed, rev/min; 0: the file does not state it
  double tolerance = 0.01;  // permitted rounding of corners if the program states no tolerance, mm
  PlannerMode planner = PlannerMode::programmed;
};

/// Loads a machine. `name`: a built-in id, in upper or lower case, or a file that ends with .toml. Returns an error sentence on failure.
tl::expected<MachineProfile, std::string> load_machine(const std::string& name, const FileAccess* door = nullptr);

/// Returns the ids of the built-in machines.
std::vector<std::string> built_in_machines();

}  // namespace kadr

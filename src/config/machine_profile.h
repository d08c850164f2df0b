#pragma once
// machines/*.toml: what a machine can do. Times and limits only; the control does not know it.

#include <cstdint>
#include <map>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/file_door.h"
#include "base/vec.h"
#include "config/machine_bodies.h"

namespace kadr {

/// How an axis moves what it carries; by its letter where the file does not say: X, U along X …, A about X, B about Y, C about Z.
struct AxisJoint {
  bool turns = false;
  Vec3 direction;         // of length 1, as all axes stand at 0: of the motion, or of the line that it turns about
  Vec3 through;           // a point of that line, machine coordinates, as all axes stand at 0; the gauge point of the spindle is {} then
  bool reversed = false;  // a positive motion turns left-handed; moves the tool against `direction`, seen from the part
  bool rolls_over = false;
};

struct AxisProfile {
  double rapid = 10000;   // mm/min or degrees/min
  double least = -1e300;  // machine coordinate, mm or degrees
  double most = 1e300;
  double acceleration = 500;  // mm/s² or degrees/s²; for sampling and time where nobody states one
  double jerk = 10000;        // mm/s³ or degrees/s³
  AxisJoint joint{};
};

/// What carries what, from the bed ([kinematics]): names of axes, each carries the next, the last the tool, the part.
struct AxisChains {
  std::vector<std::string> tool, part;
  Vec3 tool_direction{0, 0, 1};  // from the tip into the spindle, as all axes stand at 0
  bool given() const { return !tool.empty() || !part.empty(); }
};

/// Whose speed counts for the machine: the programmed feeds and rapid rates, as far as the setup states no accelerations; that which the
/// control of old makes with the machine's accelerations (docs/motion.md); or the least time (docs/planner.md).
enum class PlannerMode : std::uint8_t { programmed, control, optimal };

struct MachineProfile {
  std::string id = "generic";
  std::string name_en = "generic three-axis mill";
  std::string name_ru = "обобщённый фрезерный станок";
  std::map<std::string, AxisProfile> axes;  // by name; others: AxisProfile{}
  AxisChains chains;
  std::vector<MachineBody> bodies;
  double tool_change_s = 10;
  double spindle_start_s = 0;
  double most_rpm = 0;      // of the spindle; 0: not said
  double tolerance = 0.01;  // mm: how far a corner may be rounded where the program does not say
  PlannerMode planner = PlannerMode::programmed;
};

/// `name`: built-in id, in small letters or capitals, or a file that ends with .toml.
tl::expected<MachineProfile, std::string> load_machine(const std::string& name, const FileDoor* door = nullptr);

/// Ids of the built-in machines.
std::vector<std::string> built_in_machines();

}  // namespace kadr

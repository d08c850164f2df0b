#pragma once
// machines/*.toml: what a machine can do. Times and limits only; the control does not know it.

#include <map>
#include <string>
#include <tl/expected.hpp>

namespace kadr {

struct AxisProfile {
  double rapid = 10000;   // mm/min or degrees/min
  double least = -1e300;  // machine coordinate, mm or degrees
  double most = 1e300;
};

struct MachineProfile {
  std::string id = "generic";
  std::string name_en = "generic three-axis mill";
  std::string name_ru = "обобщённый фрезерный станок";
  std::map<std::string, AxisProfile> axes;  // by name; others: AxisProfile{}
  double tool_change_s = 10;
  double spindle_start_s = 0;
};

/// `name`: built-in id, or a file that ends with .toml.
tl::expected<MachineProfile, std::string> load_machine(const std::string& name);

}  // namespace kadr

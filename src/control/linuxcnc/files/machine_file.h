#pragma once
// The ini file of a machine: the settings that change how a program runs (spec/linuxcnc 1.1, 1.2, 10.1; Interp::init of the source). Kadr
// reads only the file that the set-up names.

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kadr::linuxcnc {

/// The contents of an ini file: lines [SECTION] and KEY = value. Lines that start with # or ; are skipped. If a key occurs twice, its first
/// value applies.
class Ini {
 public:
  Ini() = default;
  explicit Ini(std::string_view text);

  const std::string* find(const std::string& section, const std::string& key) const;
  /// Returns the value of a key as a number; nullopt if the key is missing or its value is not a number.
  std::optional<double> number(const std::string& section, const std::string& key) const;
  bool is_on(const std::string& section, const std::string& key, bool otherwise) const;

 private:
  std::map<std::pair<std::string, std::string>, std::string> values_;
};

struct MachineFile {
  bool known = false;  // the set-up names an ini file, which has been read
  Ini ini;
  std::string axes;                                   // [TRAJ]COORDINATES: letters of the axes; empty if the file does not give them
  double unit = 1;                                    // [TRAJ]LINEAR_UNITS: length in mm of the unit that tables and limits use
  std::array<std::pair<double, double>, 9> limits{};  // [AXIS_…]MIN_LIMIT and MAX_LIMIT by axis, in mm or degrees; ±1e300: no limit
  int spindles = 1;
  double orient_offset = 0;  // angle that is added to the angle of M19, degrees
  std::optional<double> arc_tolerance_mm, arc_tolerance_inch;
  bool argument_count = false;           // OWORD_NARGS: #<n_args> is the number of arguments of a call
  bool parameters_of_ini = true;         // INI_VARS: `#<_ini[section]name>` reads values of the ini file
  bool keeps_shift = true;               // G92 survives the end of a program, because DISABLE_G92_PERSISTENCE is not set
  bool fanuc_subprograms = true;         // M98 and M99 are available, because DISABLE_FANUC_STYLE_SUB is not set
  bool random_changer = false;           // RANDOM_TOOLCHANGER: T0 is a real tool, not an empty spindle
  bool spindle_turns_in_change = false;  // TOOL_CHANGE_WITH_SPINDLE_ON: the spindle is not stopped for a tool change
  bool keeps_length = false;             // RETAIN_G43: after a tool change the new tool's length is applied
  // for each of the axes A, B, C: true if the axis counts one revolution, and the sign of its word is the direction of rotation
  std::array<bool, 3> wrapped{};
  std::array<bool, 3> indexed{};  // for each of the axes A, B, C: true if the axis is an indexer, which moves only alone and by G0
  std::string startup;            // RS274NGC_STARTUP_CODE: codes that are executed at power-on
  std::string parameter_file;     // PARAMETER_FILE
  std::string tool_table;         // TOOL_TABLE
  std::vector<std::string> subprogram_folders;  // PROGRAM_PREFIX, SUBROUTINE_PATH: folders of subprograms, relative to the program memory
};

/// Returns true if the machine has a rotary axis that is wrapped or an indexer. A word of such an axis gives more than its end position.
inline bool has_rotary_rules(const MachineFile& machine) {
  constexpr std::array<bool, 3> none{};
  return machine.wrapped != none || machine.indexed != none;
}

MachineFile machine_of(Ini ini);

}  // namespace kadr::linuxcnc

#pragma once
// The ini file of a machine: what of it changes how a program runs (spec/linuxcnc 1.1, 1.2, 10.1; Interp::init of the source). Kadr reads
// the file that the set-up names, and no other.

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kadr::linuxcnc {

/// [SECTION], KEY = value; a line that begins with # or ; is none. Of a key that stands twice the first one counts.
class Ini {
 public:
  Ini() = default;
  explicit Ini(std::string_view text);

  const std::string* find(const std::string& section, const std::string& key) const;
  /// The value as a number; nothing: there is none, or it is not one.
  std::optional<double> number(const std::string& section, const std::string& key) const;
  bool is_on(const std::string& section, const std::string& key, bool otherwise) const;

 private:
  std::map<std::pair<std::string, std::string>, std::string> values_;
};

struct MachineFile {
  bool known = false;  // one is named
  Ini ini;
  std::string axes;                                   // [TRAJ]COORDINATES: letters; empty: not said
  double unit = 1;                                    // mm; of lengths in tables, of limits: [TRAJ]LINEAR_UNITS
  std::array<std::pair<double, double>, 9> limits{};  // [AXIS_…]MIN_LIMIT, MAX_LIMIT by axis, mm, degrees; ±1e300: none
  int spindles = 1;
  double orient_offset = 0;  // degrees, M19
  std::optional<double> arc_tolerance_mm, arc_tolerance_inch;
  bool argument_count = false;                  // OWORD_NARGS: #<n_args>
  bool parameters_of_ini = true;                // INI_VARS
  bool keeps_shift = true;                      // not DISABLE_G92_PERSISTENCE
  bool fanuc_subprograms = true;                // not DISABLE_FANUC_STYLE_SUB
  bool random_changer = false;                  // T0 is a tool like others
  bool spindle_turns_in_change = false;         // TOOL_CHANGE_WITH_SPINDLE_ON
  bool keeps_length = false;                    // RETAIN_G43: the tool that comes brings its length
  std::array<bool, 3> wrapped{};                // A B C: one turn, the sign is the direction
  std::array<bool, 3> indexed{};                // A B C: locked but in a G0 of their own
  std::string startup;                          // RS274NGC_STARTUP_CODE
  std::string parameter_file;                   // PARAMETER_FILE
  std::string tool_table;                       // TOOL_TABLE
  std::vector<std::string> subprogram_folders;  // PROGRAM_PREFIX, SUBROUTINE_PATH; in the program memory
};

/// A rotary axis does not simply go to its word.
inline bool has_rotary_rules(const MachineFile& machine) {
  constexpr std::array<bool, 3> none{};
  return machine.wrapped != none || machine.indexed != none;
}

MachineFile machine_of(Ini ini);

}  // namespace kadr::linuxcnc

// Reads the ini file of a machine. Described in machine_file.h.

#include "control/linuxcnc/files/machine_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/ascii.h"
#include "base/units.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {
namespace {

constexpr std::string_view ini_blanks = " \t\r\n";

std::string_view without_blanks(std::string_view text) {
  const std::size_t from = text.find_first_not_of(ini_blanks);
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(ini_blanks) - from + 1);
}

/// Returns the arc tolerance with this key of the ini file; nullopt if the value is outside the limits that LinuxCNC accepts.
std::optional<double> tolerance_in(const Ini& ini, const std::string& key, double least, double most) {
  const auto value = ini.number("RS274NGC", key);
  return value && *value >= least && *value <= most ? value : std::nullopt;
}

/// Returns the length of a unit in mm. The names of units are those of emcTrajLinearUnits in LinuxCNC; any other name means mm.
double unit_of(std::string_view word) {
  std::string small(word);
  for (char& c : small) c = to_lower(c);
  return small == "in" || small == "inch" || small == "imperial" ? mm_per_inch : 1;
}

// limit of an axis for which the ini file gives none (no_limit); a value in the file of at least beyond_limits counts as none
constexpr double no_limit = 1e300, beyond_limits = 1e99;

std::pair<double, double> limits_in(const Ini& ini, char axis, double unit) {
  const std::string section = std::string("AXIS_") + axis;
  const auto in = [&](const char* key, double otherwise) {
    const auto value = ini.number(section, key);
    return value && std::fabs(*value) < beyond_limits ? *value * unit : otherwise;
  };
  return {in("MIN_LIMIT", -no_limit), in("MAX_LIMIT", no_limit)};
}

std::vector<std::string> folders_of(const Ini& ini) {
  constexpr std::size_t max_folders = 10;
  std::vector<std::string> folders;
  if (const std::string* const prefix = ini.find("DISPLAY", "PROGRAM_PREFIX")) folders.push_back(*prefix);
  const std::string* const path = ini.find("RS274NGC", "SUBROUTINE_PATH");
  for (std::size_t at = 0; path != nullptr && at <= path->size() && folders.size() <= max_folders;) {
    const std::size_t end = std::min(path->find(':', at), path->size());
    if (end > at) folders.push_back(path->substr(at, end - at));
    at = end + 1;
  }
  return folders;
}

}  // namespace

Ini::Ini(std::string_view text) {
  std::string section;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = without_blanks(text.substr(at, end - at));
    at = end + 1;
    if (line.empty() || line[0] == '#' || line[0] == ';') continue;
    if (line[0] == '[') {
      section = line.substr(1, line.find(']') - 1);
      continue;
    }
    const std::size_t sign = line.find('=');
    if (sign == std::string_view::npos) continue;
    values_.try_emplace({section, std::string(without_blanks(line.substr(0, sign)))}, without_blanks(line.substr(sign + 1)));
  }
}

const std::string* Ini::find(const std::string& section, const std::string& key) const {
  const auto found = values_.find({section, key});
  return found == values_.end() ? nullptr : &found->second;
}

std::optional<double> Ini::number(const std::string& section, const std::string& key) const {
  const std::string* const text = find(section, key);
  if (text == nullptr) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(text->c_str(), &end);
  if (end == text->c_str() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool Ini::is_on(const std::string& section, const std::string& key, bool otherwise) const {
  const std::string* const text = find(section, key);
  if (text == nullptr) return otherwise;
  std::string word = *text;
  for (char& c : word) c = to_upper(c);
  for (const char* on : {"TRUE", "YES", "1", "ON"})
    if (word == on) return true;
  for (const char* off : {"FALSE", "NO", "0", "OFF"})
    if (word == off) return false;
  return otherwise;
}

MachineFile machine_of(Ini ini) {
  constexpr const char* of_control = "RS274NGC";
  MachineFile machine;
  machine.known = true;
  if (const auto n = ini.number("TRAJ", "SPINDLES")) machine.spindles = static_cast<int>(std::clamp(*n, 1.0, double{max_spindles}));
  machine.orient_offset = ini.number(of_control, "ORIENT_OFFSET").value_or(0);
  machine.arc_tolerance_mm = tolerance_in(ini, "CENTER_ARC_RADIUS_TOLERANCE_MM", 0.001, 0.02 * std::sqrt(2.0));
  machine.arc_tolerance_inch = tolerance_in(ini, "CENTER_ARC_RADIUS_TOLERANCE_INCH", 0.00004, 0.002 * std::sqrt(2.0));
  machine.argument_count = ini.is_on(of_control, "OWORD_NARGS", false);
  machine.parameters_of_ini = ini.is_on(of_control, "INI_VARS", true);
  machine.keeps_shift = ini.number(of_control, "DISABLE_G92_PERSISTENCE").value_or(0) == 0;
  machine.fanuc_subprograms = ini.number(of_control, "DISABLE_FANUC_STYLE_SUB").value_or(0) == 0;
  machine.random_changer = ini.number("EMCIO", "RANDOM_TOOLCHANGER").value_or(0) != 0;
  machine.spindle_turns_in_change = ini.number("EMCIO", "TOOL_CHANGE_WITH_SPINDLE_ON").value_or(0) != 0;
  machine.keeps_length = ini.is_on(of_control, "RETAIN_G43", false);
  constexpr const char* rotary[] = {"AXIS_A", "AXIS_B", "AXIS_C"};
  for (std::size_t i = 0; i < machine.wrapped.size(); ++i) {
    machine.wrapped[i] = ini.number(rotary[i], "WRAPPED_ROTARY").value_or(0) != 0;
    machine.indexed[i] = ini.number(rotary[i], "LOCKING_INDEXER_JOINT").value_or(-1) >= 0;
  }
  const auto text = [&](const char* section, const char* key) {
    const std::string* const found = ini.find(section, key);
    return found == nullptr ? std::string() : *found;
  };
  for (const char c : text("TRAJ", "COORDINATES"))
    if (axis_letters.find(to_upper(c)) != std::string_view::npos) machine.axes += to_upper(c);
  machine.unit = unit_of(text("TRAJ", "LINEAR_UNITS"));
  for (std::size_t a = 0; a < machine.limits.size(); ++a)
    machine.limits[a] = limits_in(ini, axis_letters[a], is_rotary_place(a) ? 1 : machine.unit);
  machine.startup = (machine.unit == 1 ? "" : "G20 ") + text(of_control, "RS274NGC_STARTUP_CODE");
  machine.parameter_file = text(of_control, "PARAMETER_FILE");
  machine.tool_table = text("EMCIO", "TOOL_TABLE");
  machine.subprogram_folders = folders_of(ini);
  machine.ini = std::move(ini);
  return machine;
}

}  // namespace kadr::linuxcnc

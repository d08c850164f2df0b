// Executes `$` lines of a program (spec/grbl 9 to 11; system_execute_line of system.c, settings_store_global_setting of settings.c).

#include <algorithm>
#include <string>
#include <vector>

#include "control/grbl/grbl.h"
#include "control/interpreter.h"
#include "lang/block/line_word_reader.h"

namespace kadr::grbl {
namespace {

tl::unexpected<Alarm> not_understood(Span where, const std::string& line) {
  return fail(alarm(AlarmId::system_line, where, line.substr(0, 30)));
}

/// A line that changes a setting, such as `$130=200`.
struct Assigned {
  int number = 0;
  double value = 0;
};

Result<Assigned> assigned(const std::string& line, Span where) {
  constexpr double most = 255;
  const std::string_view text = std::string_view(line).substr(1);
  const std::size_t size = size_of_number(text);
  if (size == 0) return fail(alarm(AlarmId::number_missing, where, '$'));
  if (size == text.size() || text[size] != '=') return not_understood(where, line);
  const std::string_view value = text.substr(size + 1);
  const std::size_t value_size = size_of_number(value);
  if (value_size == 0) return fail(alarm(AlarmId::number_missing, where, '='));
  const double number = value_of_digits(text.substr(0, size));
  if (value_size != value.size() || number > most) return not_understood(where, line);
  return Assigned{byte_of(number), value_of_digits(value.substr(0, value_size))};
}

/// Returns true for a `$` line that does not affect the program: Grbl answers `ok`, and only shows, stores or restores settings.
bool is_form_of_line(const std::string& line) {
  if (line.size() == 1) return true;
  const bool alone = line.size() == 2;
  switch (line[1]) {
    case '$':
    case 'G':
    case 'C':
    case 'X':
    case '#': return alone;
    case 'I': return alone || line[2] == '=';
    case 'S': return line == "$SLP";
    case 'R': return line.size() == 6 && line.starts_with("$RST=") && std::string_view("$#*").find(line[5]) != std::string_view::npos;
    case 'N': return alone || (size_of_number(std::string_view(line).substr(2)) > 0 && line.find('=') != std::string::npos);
    default: return false;
  }
}

bool is_command(const std::string& line) {
  return line.size() == 1 || std::string_view("$GCX#ISRN").find(line[1]) != std::string_view::npos;
}

}  // namespace

Result<bool> set(Settings& settings, int number, double value, Span where) {
  constexpr int first_travel = 130;
  constexpr std::int32_t least_pulse = 3;  // least length of a step pulse, µs
  if (value < 0) return fail(alarm(AlarmId::value_below_zero, where, '$' + std::to_string(number) + '=', value));
  switch (number) {
    case 0:
      if (byte_of(value) < least_pulse) return fail(alarm(AlarmId::step_pulse_short, where, value));
      return false;
    case 12: settings.arc_tolerance = value; return true;
    case 20:
      if (byte_of(value) != 0 && !settings.homing) return fail(alarm(AlarmId::soft_limits_need_homing, where));
      settings.soft_limits = byte_of(value) != 0;
      return true;
    case 22:
      settings.homing = byte_of(value) != 0;
      settings.soft_limits = settings.soft_limits && settings.homing;
      return true;
    case 30: settings.max_spindle_speed = value; return true;
    case 31: settings.min_spindle_speed = value; return true;
    case first_travel:
    case first_travel + 1:
    case first_travel + 2: settings.travel[static_cast<std::size_t>(number - first_travel)] = value; return true;
    default: return false;
  }
}

/// Executes a `$` line that jogs, homes, or changes a setting that Kadr uses. Any other `$` line has no effect, and a note reports it.
Result<bool> Grbl::statement(Interpreter& m) {
  std::vector<std::uint32_t> place;
  const std::string line = filtered(m.block->text_of(m.block->statement.text), place);
  const Span where = m.block->statement.where;
  if (line.starts_with("$J")) {
    if (!line.starts_with("$J=")) return not_understood(where, line);
    KADR_TRY(jog(m));
    return true;
  }
  if (line.starts_with("$H")) {
    if (!state.settings.homing) return fail(alarm(AlarmId::homing_off, where));
    if (line != "$H") return not_understood(where, line);
    KADR_TRY(m.to_machine(MotionKind::home, Axes{}, (AxisMask{1} << axes) - 1, 0));
    return true;
  }
  if (line == "$X") return true;
  if (is_command(line)) {
    if (!is_form_of_line(line)) return not_understood(where, line);
    m.warn(note(AlarmId::system_line_passed, where, line.substr(0, 30)));
    return true;
  }
  const auto row = assigned(line, where);
  if (!row) return fail(row.error());
  const auto counts = set(state.settings, row->number, row->value, where);
  if (!counts) return fail(counts.error());
  const auto& known = m.def.parameters;
  if (std::none_of(known.begin(), known.end(), [&](const ParameterRow& p) { return p.number == row->number; }))
    return not_understood(where, line);
  if (!*counts) m.warn(note(AlarmId::system_line_passed, where, line.substr(0, 30)));
  return true;
}

}  // namespace kadr::grbl

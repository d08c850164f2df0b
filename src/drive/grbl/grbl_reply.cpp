// Reads the lines that a controller of the Grbl family sends (report.c of Grbl 1.1h). Used by grbl_link, tested by
// tests/drive/grbl_reply_test.cpp.

#include "drive/grbl/grbl_reply.h"

#include <charconv>
#include <cmath>
#include <utility>

namespace kadr::drive {
namespace {

constexpr std::pair<std::string_view, GrblState> state_names[] = {
    {"Idle", GrblState::idle},   {"Run", GrblState::run},   {"Hold", GrblState::hold},   {"Jog", GrblState::jog},
    {"Alarm", GrblState::alarm}, {"Door", GrblState::door}, {"Check", GrblState::check}, {"Home", GrblState::home},
    {"Sleep", GrblState::sleep}, {"Tool", GrblState::tool},
};

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if constexpr (std::is_same_v<Number, double>)
    if (!std::isfinite(value)) return std::nullopt;
  return value;
}

/// Returns the text before the separator, and removes it and the separator from `text`.
std::string_view cut(std::string_view& text, char separator) {
  const std::size_t at = text.find(separator);
  const std::string_view first = text.substr(0, at);
  text = at == std::string_view::npos ? std::string_view() : text.substr(at + 1);
  return first;
}

bool read_state(std::string_view text, GrblReport& report) {
  const std::string_view name = cut(text, ':');
  for (const auto& [known, state] : state_names)
    if (known == name) report.state = state;
  if (report.state == GrblState::unknown) return false;
  if (text.empty()) return true;
  const auto substate = number_in<int>(text);
  report.substate = substate.value_or(0);
  return substate.has_value();
}

bool read_free(std::string_view text, GrblReport& report) {
  const auto blocks = number_in<int>(cut(text, ','));
  const auto bytes = number_in<int>(text);
  if (!blocks || !bytes) return false;
  report.free = GrblFree{*blocks, *bytes};
  return true;
}

bool read_overrides(std::string_view text, GrblReport& report) {
  const auto feed = number_in<int>(cut(text, ','));
  const auto rapid = number_in<int>(cut(text, ','));
  const auto spindle = number_in<int>(text);
  if (!feed || !rapid || !spindle) return false;
  report.overrides = GrblOverrides{*feed, *rapid, *spindle};
  return true;
}

template <class Value>
bool keep(std::optional<Value> value, std::optional<Value>& to) {
  to = value;
  return value.has_value();
}

bool read_field(std::string_view name, std::string_view text, GrblReport& report) {
  if (name == "MPos") return keep(grbl_point(text), report.machine);
  if (name == "WPos") return keep(grbl_point(text), report.work);
  if (name == "WCO") return keep(grbl_point(text), report.offset);
  if (name == "Bf") return read_free(text, report);
  if (name == "Ln") return keep(number_in<std::uint32_t>(text), report.line);
  if (name == "F") return keep(number_in<double>(text), report.feed);
  if (name == "Ov") return read_overrides(text, report);
  if (name == "Pn") report.pins = text;
  if (name != "FS") return true;  // a field of a later version, or one that Kadr does not use
  return keep(number_in<double>(cut(text, ',')), report.feed) && keep(number_in<double>(cut(text, ',')), report.speed);
}

GrblReply report_in(std::string_view line) {
  std::string_view rest = line.substr(1, line.size() - 2);
  GrblReport report;
  bool is_right = read_state(cut(rest, '|'), report);
  while (is_right && !rest.empty()) {
    std::string_view text = cut(rest, '|');
    const std::string_view name = cut(text, ':');
    is_right = read_field(name, text, report);
  }
  if (!is_right || (!report.machine && !report.work)) return GrblUnknown{std::string(line)};
  return report;
}

GrblReply setting_in(std::string_view line) {
  std::string_view text = line.substr(1);
  const auto number = number_in<int>(cut(text, '='));
  const std::string_view value_text = text.substr(0, text.find(' '));  // Grbl 0.9 adds a description in brackets
  const auto value = number_in<double>(value_text);
  if (!number || !value) return GrblUnknown{std::string(line)};
  return GrblSetting{*number, *value};
}

}  // namespace

std::string_view name_of(GrblState state) {
  for (const auto& [name, known] : state_names)
    if (known == state) return name;
  return "?";
}

std::optional<GrblPoint> grbl_point(std::string_view text) {
  GrblPoint point{};
  for (double& value : point) {
    const auto number = number_in<double>(cut(text, ','));
    if (!number) return std::nullopt;
    value = *number;
  }
  return point;
}

GrblReply grbl_reply(std::string_view line) {
  if (line == "ok") return GrblOk{};
  const auto ends_with_number = [&](std::string_view begin) { return number_in<int>(line.substr(begin.size())); };
  for (const std::string_view begin : {std::string_view("error:"), std::string_view("ALARM:")}) {
    if (!line.starts_with(begin)) continue;
    const auto code = ends_with_number(begin);
    if (!code || *code < 0) return GrblUnknown{std::string(line)};
    return begin == "ALARM:" ? GrblReply(GrblAlarm{*code}) : GrblReply(GrblError{*code});
  }
  if (line.size() > 2 && line.front() == '<' && line.back() == '>') return report_in(line);
  if (line.size() > 2 && line.front() == '[' && line.back() == ']') {
    std::string_view text = line.substr(1, line.size() - 2);
    const std::string_view tag = cut(text, ':');
    return GrblBracket{std::string(tag), std::string(text)};
  }
  if (line.starts_with("Grbl") && line.find("['$' ") != std::string_view::npos) {
    const std::size_t begin = line.find(' ') + 1;
    return GrblBanner{std::string(line.substr(begin, line.find(' ', begin) - begin))};
  }
  if (line.starts_with('$')) return setting_in(line);
  if (line.starts_with('>')) return GrblStartup{std::string(line.substr(1))};
  return GrblUnknown{std::string(line)};
}

}  // namespace kadr::drive

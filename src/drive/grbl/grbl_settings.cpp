// Collects what a controller of the Grbl family says of itself. Used by grbl_link and grbl_proof, tested by
// tests/drive/grbl_reply_test.cpp.

#include "drive/grbl/grbl_settings.h"

#include <charconv>

namespace kadr::drive {
namespace {

/// Returns the number in the field `nth`, from 0, of a list with commas; nullopt if it is not a whole number.
std::optional<int> field(std::string_view text, int nth) {
  for (; nth > 0; --nth) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return std::nullopt;
    text.remove_prefix(comma + 1);
  }
  text = text.substr(0, text.find(','));
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0) return std::nullopt;
  return value;
}

}  // namespace

bool GrblSettings::take(const GrblBracket& bracket) {
  const std::string& tag = bracket.tag;
  if (tag == "VER") {
    version = bracket.text;
    return true;
  }
  if (tag == "OPT") {  // the letters of the build's options, planner blocks, receive buffer
    planner_blocks = field(bracket.text, 1);
    buffer_bytes = field(bracket.text, 2);
    return true;
  }
  if (tag == "GC") {
    modes = bracket.text;
    return true;
  }
  if (tag == "TLO") {
    const auto [end, error] = std::from_chars(bracket.text.data(), bracket.text.data() + bracket.text.size(), tool_length);
    return error == std::errc() && end != nullptr;
  }
  if (tag == "PRB" || tag.size() < 3 || tag.front() != 'G') return tag == "PRB";
  const auto point = grbl_point(bracket.text);
  if (point) offsets[tag] = *point;
  return point.has_value();
}

GrblSettings grbl_settings_in(std::string_view text) {
  GrblSettings settings;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    const GrblReply reply = grbl_reply(line);
    if (const auto* const setting = std::get_if<GrblSetting>(&reply)) settings.values[setting->number] = setting->value;
    if (const auto* const bracket = std::get_if<GrblBracket>(&reply)) (void)settings.take(*bracket);
  }
  return settings;
}

}  // namespace kadr::drive

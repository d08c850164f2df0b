#pragma once
// Reads the description of a tool in a comment: "(T1 D8 ENDMILL)", «ФРЕЗА 8», "T01 FREZA D=10 R0.5". The result is a proposal for a
// set-up, which a person must check.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kadr {

/// The type of tool that a comment names; `mill` if the comment names a tool without a more exact type.
enum class ToolWord : std::uint8_t { none, mill, ball, drill, chamfer, taper, tap, reamer };

struct ToolComment {
  std::optional<std::uint32_t> tool;  // T1
  std::optional<double> diameter;     // mm
  std::optional<double> corner;       // corner radius, mm
  std::optional<double> angle;        // full point angle, degrees
  ToolWord kind = ToolWord::none;
  bool unsure = false;  // the comment describes a tool, but none of its sizes is certain
  bool empty() const { return !tool && !diameter && !corner; }
};

/// Returns the properties that the comment gives with certainty. A number that may be something other than a size is omitted.
///   text  UTF-8
///   inch  true: numbers without a unit are in inches; fractions are always in inches
ToolComment read_tool_comment(std::string_view text, bool inch);

/// Returns the comments of a line in UTF-8. They are written in brackets or after a semicolon.
std::vector<std::string> comments_of(std::string_view line);
/// Returns the line without its comments and without blanks at its ends.
std::string without_comments(std::string_view line);

}  // namespace kadr

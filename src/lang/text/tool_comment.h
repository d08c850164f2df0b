#pragma once
// What a comment says of a tool: "(T1 D8 ENDMILL)", «ФРЕЗА 8», "T01 FREZA D=10 R0.5". A proposal for a set-up, to be looked at by a person.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kadr {

/// What kind of tool a comment names; `mill` where it says no more than that.
enum class ToolWord : std::uint8_t { none, mill, ball, drill, chamfer, taper, tap, reamer };

struct ToolComment {
  std::optional<std::uint32_t> tool;  // T1
  std::optional<double> diameter;     // mm
  std::optional<double> corner;       // radius of the corner, mm
  std::optional<double> angle;        // of the whole point, degrees
  ToolWord kind = ToolWord::none;
  bool unsure = false;  // it speaks of a tool, but no size in it is sure
  bool empty() const { return !tool && !diameter && !corner; }
};

/// What it says for certain: a size that may be something else is left out.
///   text  UTF-8
///   inch  figures without a unit are inches; fractions always are
ToolComment read_tool_comment(std::string_view text, bool inch);

/// The comments of a line: between brackets, after a semicolon, UTF-8.
std::vector<std::string> comments_of(std::string_view line);
/// The line without them and without blanks at its ends.
std::string without_comments(std::string_view line);

}  // namespace kadr

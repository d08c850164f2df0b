// ToolProposals: finds tools in the comments of a program. It is used by cli/setup_command and view/proposals, and tested by
// tests/session/tool_proposals_test.cpp.

#include "session/tool_proposals.h"

#include <algorithm>
#include <set>

namespace kadr {
namespace {

constexpr std::uint32_t max_lines = 200'000;

}  // namespace

ProgramLines lines_of(const Control& control) {
  std::set<std::uint32_t> numbers;
  const auto most = static_cast<std::uint32_t>(std::min<std::uint64_t>(control.bytes() + 1, max_lines));
  for (std::uint32_t n = 1; n <= most; ++n) numbers.insert(numbers.end(), n);
  return control.texts_of(numbers, 0);
}

/// The unit comes from the cutting motions, not from the codes in force at the end of the program: M30 of a Fanuc or Haas resets the unit
/// to mm, and G70 is a unit on one control and a canned cycle on another. If the program has no motion, the unit at its end is used.
bool comments_in_inches(const Control& control, const MotionUnits& moved) {
  if (!moved.empty()) return moved.unit() == LengthUnit::inch;
  const FinalState ending = control.ending();
  return std::any_of(ending.modal.begin(), ending.modal.end(), [](const std::string& word) { return word == "G20" || word == "G70"; });
}

ToolProposals::ToolProposals(const ProgramLines& lines, bool inch, bool lathe) {
  for (const auto& [number, text] : lines)
    for (const std::string& comment : comments_of(text)) {
      ToolComment tool_data = read_tool_comment(comment, inch);
      constexpr std::uint32_t offsets = 100;  // T0101 of a lathe is tool 1 with offset 1
      if (lathe && tool_data.tool.value_or(0) >= offsets) tool_data.tool = *tool_data.tool / offsets;
      if (tool_data.diameter || tool_data.unsure) read_.push_back({tool_data, number, comment});
    }
}

template <class Fits>
const ToolProposal* ToolProposals::first_in(std::uint32_t line, const Fits& fits) const {
  const auto from = std::lower_bound(read_.begin(), read_.end(), line, [](const ToolProposal& p, std::uint32_t n) { return p.line < n; });
  for (auto p = from; p != read_.end() && p->line == line; ++p)
    if (fits(p->tool_data)) return &*p;
  return nullptr;
}

template <class Fits>
std::optional<ToolProposal> ToolProposals::find(std::uint32_t tool, std::uint32_t called_at, const Fits& fits) const {
  const auto named =
      std::find_if(read_.begin(), read_.end(), [&](const ToolProposal& p) { return p.tool_data.tool == tool && fits(p.tool_data); });
  if (named != read_.end()) return *named;
  if (called_at == 0) return std::nullopt;
  for (const std::uint32_t line : {called_at, called_at - 1, called_at + 1})
    if (const auto* const on_line =
            first_in(line, [&](const ToolComment& tool_data) { return fits(tool_data) && (!tool_data.tool || *tool_data.tool == tool); }))
      return *on_line;
  return std::nullopt;
}

std::optional<ToolProposal> ToolProposals::of(std::uint32_t tool, std::uint32_t called_at) const {
  return find(tool, called_at, [](const ToolComment& tool_data) { return tool_data.diameter.has_value(); });
}

std::optional<ToolProposal> ToolProposals::unsure(std::uint32_t tool, std::uint32_t called_at) const {
  return find(tool, called_at, [](const ToolComment& tool_data) { return tool_data.unsure; });
}

}  // namespace kadr

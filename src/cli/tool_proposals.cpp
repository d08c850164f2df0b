// Tools by comments. For cli/setup_command and cli/tools_command.

#include "cli/tool_proposals.h"

namespace kadr::cli {

template <class Fits>
std::optional<ToolProposal> ToolProposals::in_line(const std::string& text, std::uint32_t number, const Fits& fits) const {
  for (const std::string& comment : comments_of(text)) {
    const ToolComment said = read_tool_comment(comment, inch_);
    if (said.diameter && fits(said.tool)) return ToolProposal{said, number, comment};
  }
  return std::nullopt;
}

std::optional<ToolProposal> ToolProposals::of(std::uint32_t tool, std::uint32_t called_at) const {
  for (const auto& [number, text] : lines_)
    if (auto found = in_line(text, number, [tool](const auto& named) { return named == tool; })) return found;
  if (called_at == 0) return std::nullopt;
  for (const std::uint32_t number : {called_at, called_at - 1, called_at + 1}) {
    const auto line = lines_.find(number);
    if (line == lines_.end()) continue;
    if (auto found = in_line(line->second, number, [tool](const auto& named) { return !named || *named == tool; })) return found;
  }
  return std::nullopt;
}

}  // namespace kadr::cli

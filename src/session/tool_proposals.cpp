// Tools by comments. For cli/setup_command and view/page_part.

#include "session/tool_proposals.h"

#include <algorithm>
#include <set>

namespace kadr {
namespace {

constexpr std::uint32_t most_lines = 200'000;

}  // namespace

ProgramLines lines_of(const Control& control) {
  std::set<std::uint32_t> numbers;
  const auto most = static_cast<std::uint32_t>(std::min<std::uint64_t>(control.bytes() + 1, most_lines));
  for (std::uint32_t n = 1; n <= most; ++n) numbers.insert(numbers.end(), n);
  return control.texts_of(numbers, 0);
}

bool ends_in_inches(const Control& control) {
  const Ending ending = control.ending();
  return std::any_of(ending.modal.begin(), ending.modal.end(), [](const std::string& word) { return word == "G20" || word == "G70"; });
}

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

}  // namespace kadr

#pragma once
// ToolProposals: what the comments of a program say of its tools. For the templates of kadr setup and for the page; nobody uses them
// unseen.

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "control/control.h"
#include "lang/text/tool_comment.h"

namespace kadr {

/// Texts by line number, from 1.
using ProgramLines = std::map<std::uint32_t, std::string>;

/// Of the program itself, as far as anybody writes comments: what a machine has made has none beyond.
ProgramLines lines_of(const Control& control);

/// Figures of its comments are inches where they say nothing else.
bool ends_in_inches(const Control& control);

struct ToolProposal {
  ToolComment said;
  std::uint32_t line = 0;  // of the comment
  std::string text;
};

class ToolProposals {
 public:
  /// `inch`: figures without a unit are inches.
  ToolProposals(const ProgramLines& lines, bool inch) : lines_(lines), inch_(inch) {}

  /// A comment with a diameter that names the tool, anywhere; else one beside the block that calls it, which names no other tool.
  ///   called_at  that block's line; 0: it is in another file
  std::optional<ToolProposal> of(std::uint32_t tool, std::uint32_t called_at) const;

 private:
  template <class Fits>
  std::optional<ToolProposal> in_line(const std::string& text, std::uint32_t number, const Fits& fits) const;

  const ProgramLines& lines_;
  bool inch_;
};

}  // namespace kadr

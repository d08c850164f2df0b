#pragma once
// ToolProposals: what the comments of a program say of its tools. For the templates of kadr setup and for the page; nobody uses them
// unseen.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "control/control.h"
#include "lang/text/tool_comment.h"
#include "out/text/extents.h"

namespace kadr {

/// Texts by line number, from 1.
using ProgramLines = std::map<std::uint32_t, std::string>;

/// Of the program itself, as far as anybody writes comments: what a machine has made has none beyond.
ProgramLines lines_of(const Control& control);

/// Figures of its comments are inches where they say nothing else. After the run.
///   moved  the motions of that run
bool comments_in_inches(const Control& control, const MotionUnits& moved);

struct ToolProposal {
  ToolComment said;
  std::uint32_t line = 0;  // of the comment
  std::string text;
};

class ToolProposals {
 public:
  /// `inch`: figures without a unit are inches.
  ToolProposals(const ProgramLines& lines, bool inch);

  /// A comment with a diameter that names the tool, anywhere; else one beside the block that calls it, which names no other tool.
  ///   called_at  that block's line; 0: it is in another file
  std::optional<ToolProposal> of(std::uint32_t tool, std::uint32_t called_at) const;
  /// Where of() has none: such a comment that speaks of a tool without a size that is sure.
  std::optional<ToolProposal> unsure(std::uint32_t tool, std::uint32_t called_at) const;

 private:
  template <class Fits>
  const ToolProposal* first_in(std::uint32_t line, const Fits& fits) const;
  template <class Fits>
  std::optional<ToolProposal> find(std::uint32_t tool, std::uint32_t called_at, const Fits& fits) const;

  std::vector<ToolProposal> read_;  // in the order of the lines; those that say anything of a tool's size
};

}  // namespace kadr

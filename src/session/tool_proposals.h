#pragma once
// ToolProposals: tools that the comments of a program describe. Used by the templates of kadr setup and by the page; a person checks them
// before they are used.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "control/control.h"
#include "lang/text/tool_comment.h"
#include "out/text/extents.h"

namespace kadr {

/// Texts by line number, counted from 1.
using ProgramLines = std::map<std::uint32_t, std::string>;

/// Lines of the program itself, up to a number beyond which only machines write programs, without comments.
ProgramLines lines_of(const Control& control);

/// True if figures of its comments are in inches unless they state a unit. Call after the run.
///   moved  the motions of that run
bool comments_in_inches(const Control& control, const MotionUnits& moved);

struct ToolProposal {
  ToolComment said;
  std::uint32_t line = 0;  // of the comment
  std::string text;
};

class ToolProposals {
 public:
  /// `inch`: figures without a unit are in inches.
  ToolProposals(const ProgramLines& lines, bool inch);

  /// The proposal for a tool: from a comment anywhere with a diameter that names the tool; else from one next to the block that calls the
  /// tool, if that comment names no other tool.
  ///   called_at  line of that block; 0: it is in another file
  std::optional<ToolProposal> of(std::uint32_t tool, std::uint32_t called_at) const;
  /// If of() has no proposal: such a comment that describes a tool without a certain size.
  std::optional<ToolProposal> unsure(std::uint32_t tool, std::uint32_t called_at) const;

 private:
  template <class Fits>
  const ToolProposal* first_in(std::uint32_t line, const Fits& fits) const;
  template <class Fits>
  std::optional<ToolProposal> find(std::uint32_t tool, std::uint32_t called_at, const Fits& fits) const;

  std::vector<ToolProposal> read_;  // sorted by line; comments that say something about a tool's size
};

}  // namespace kadr

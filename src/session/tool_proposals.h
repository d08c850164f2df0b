#pragma once
// ToolProposals: finds the tools that the comments of a program describe. It is used by the templates of kadr setup and by the page. A
// person must check the proposals before they are used.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "control/control.h"
#include "lang/text/tool_comment.h"
#include "out/text/extents.h"

namespace kadr {

/// Line number, counted from 1 → text of the line.
using ProgramLines = std::map<std::uint32_t, std::string>;

/// Returns the lines of the main program up to a greatest line number. Longer programs are the output of CAM systems, which write no
/// comments about tools after that line.
ProgramLines lines_of(const Control& control);

/// True if lengths without a unit in the comments of the program are in inches. Call this function after the run.
///   moved  the units of the motions of that run
bool comments_in_inches(const Control& control, const MotionUnits& moved);

struct ToolProposal {
  ToolComment tool_data;
  std::uint32_t line = 0;  // line of the comment
  std::string text;
};

class ToolProposals {
 public:
  /// Reads the comments. `inch`: lengths without a unit are in inches; false: in mm. `lathe`: T0101 in a comment is tool 1.
  ToolProposals(const ProgramLines& lines, bool inch, bool lathe = false);

  /// Returns the proposal for a tool. The first source is a comment anywhere in the program that names the tool and states a diameter. The
  /// second source is a comment next to the block that calls the tool, if that comment names no other tool.
  ///   called_at  line of the block that calls the tool; 0: the block is in another file
  std::optional<ToolProposal> of(std::uint32_t tool, std::uint32_t called_at) const;
  /// Returns the proposal from a comment that describes the tool but does not clearly state its size. Call this function if of() returns no
  /// proposal.
  std::optional<ToolProposal> unsure(std::uint32_t tool, std::uint32_t called_at) const;

 private:
  template <class Fits>
  const ToolProposal* first_in(std::uint32_t line, const Fits& fits) const;
  template <class Fits>
  std::optional<ToolProposal> find(std::uint32_t tool, std::uint32_t called_at, const Fits& fits) const;

  std::vector<ToolProposal> read_;  // comments that state a size of a tool, sorted by line number
};

}  // namespace kadr

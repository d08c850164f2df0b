#pragma once
// Finds the names of tools in a comment (BALL END MILL, SPOT DRILL, ФРЕЗА) and the type of tool that each name means.

#include <cstddef>
#include <vector>

#include "lang/text/tool_figures.h"

namespace kadr {

/// Words next to each other that name a tool.
struct ToolName {
  std::size_t first = 0, last = 0;  // indices of the first and last piece of the name
  ToolWord kind = ToolWord::none;
  bool is_tap_drill = false;
  // Properties of the word that names the tool; the WordHints with the same names explain them (see tool_words.h).
  bool size_after = false, work_too = false, no_bare_size = false, only_called = false;
};

class ToolNames {
 public:
  /// `pieces` must exist longer than the ToolNames. Words about another thing (after FOR, WITH) do not count as names of tools.
  explicit ToolNames(const std::vector<CommentPiece>& pieces);

  const std::vector<ToolName>& all() const { return all_; }
  ToolWord kind() const;
  /// Returns true if a word of the comment has the meaning `what`, and the word is about this tool.
  bool any(WordHints what) const;

 private:
  bool is_of_name(std::size_t i) const;
  std::size_t next_of_name(std::size_t i) const;
  ToolName name_from(std::size_t first) const;
  bool is_none(const ToolName& name) const;

  const std::vector<CommentPiece>& pieces_;
  std::vector<ToolName> all_;
};

}  // namespace kadr

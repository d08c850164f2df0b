#pragma once
// ToolSize: finds the number in a comment that is the size of its tool.

#include <optional>
#include <vector>

#include "lang/text/tool_names.h"

namespace kadr {

class ToolSize {
 public:
  /// The arguments must exist longer than the ToolSize. `inch`: numbers without a unit are inches.
  ToolSize(const std::vector<CommentPiece>& pieces, const ToolNames& names, bool inch);

  /// Returns the diameter in mm; nullopt if the diameter is not certain.
  std::optional<double> diameter() const;
  /// Returns the corner radius in mm of a tool with this diameter in mm; nullopt if the radius is not certain.
  std::optional<double> corner(std::optional<double> diameter) const;

 private:
  using Sizes = std::vector<double>;  // sizes in mm that one rule has found in a comment; if the sizes differ, none of them is used
  bool has(std::size_t i) const { return i < pieces_.size(); }
  bool means(std::size_t i, WordHints what) const { return has(i) && pieces_[i].meaning.is(what); }
  bool is(std::size_t i, FigureIs what) const { return has(i) && pieces_[i].is_figure() && pieces_[i].figure == what; }
  bool names_two_works() const;
  double mm(const CommentPiece& figure) const;
  bool is_measured(const CommentPiece& figure) const;
  bool is_whole(const CommentPiece& figure) const;

  Sizes called() const;
  bool is_called(std::size_t figure) const;
  bool is_offset(std::size_t figure) const;
  bool speaks_of_tool(std::size_t figure) const;
  bool is_of_part(std::size_t figure) const;

  Sizes in_names() const;
  std::optional<std::size_t> before(const ToolName& name) const;
  bool fits_before(std::size_t figure, const ToolName& name, bool strangers) const;
  void add_threads(Sizes& sizes) const;
  void add_named_drills(Sizes& sizes) const;
  bool names_drill(std::size_t at) const;
  std::optional<std::size_t> letter_of_drill(std::size_t at) const;

  Sizes after_names() const;
  std::optional<std::size_t> figure_after(const ToolName& name) const;
  bool fits_after(std::size_t figure, const ToolName& name, bool divided) const;
  Sizes without_name() const;

  bool is_likely(const CommentPiece& figure) const;

  const std::vector<CommentPiece>& pieces_;
  const ToolNames& names_;
  const bool inch_;
  const ToolWord kind_;
  bool has_no_size_ = false;  // true: the tool's name contains no size, or it contains a size that is not the diameter
  bool is_wide_ = false;      // the tool is a face mill or a saw
  bool is_disc_ = false;      // the tool is a slot mill or a key cutter
};

}  // namespace kadr
